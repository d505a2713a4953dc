#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "shared/base/text.h"
#include "shared/io/file.h"
#include "shared/io/formats/line_files.h"
#include "shared/io/gis/dxf.h"
#include "shared/io/gis/geojson.h"
#include "shared/io/gis/ogr_file.h"
#include "shared/io/lines/gocad.h"
#include "shared/io/lines/line_kinds.h"
#include "shared/io/lines/move_ascii.h"
#include "shared/io/lines/section_plane.h"
#include "shared/io/lines/wkt.h"
#include "shared/io/scan.h"

namespace dobra::io::formats {

using base::Error;
using base::ErrorCode;
using base::Place;
using base::Result;

namespace {

// --- text

// A field in quotes; the format has no way to write a quote inside.
std::string quoted(std::string text) {
  for (char& c : text) {
    if (c == '"') c = '\'';
    if (c == '\n' || c == '\r') c = ' ';
  }
  const bool plain =
      text.find_first_of(",#") == std::string::npos && (text.empty() || (text.front() != ' ' && text.back() != ' '));
  return plain ? text : '"' + text + '"';
}

Result<std::string> text_of(std::span<const lines::Feature> given, bool map) {
  const std::vector<lines::Feature> features = lines::rings_apart(given);
  const bool named =
      std::any_of(features.begin(), features.end(), [](const lines::Feature& f) { return !f.name.empty(); });
  const bool sorted =
      std::any_of(features.begin(), features.end(), [](const lines::Feature& f) { return !f.kind.empty(); });
  std::string text = map ? "x,y,z" : "x,z";
  text += std::string(named ? ",name" : "") + (sorted ? ",kind" : "") + '\n';
  bool first = true;
  for (std::size_t i = 0; i < features.size(); ++i) {
    const lines::Feature& feature = features[i];
    const std::string tail =
        (named ? ',' + quoted(feature.name) : "") + (sorted ? ',' + quoted(feature.kind) : "") + '\n';
    for (std::size_t part = 0; part < feature.parts.size(); ++part) {
      const std::vector<geom::Point>& points = feature.parts[part].points;
      DOBRA_TRY_VOID(check_finite(points, lines::item_of(i + 1, feature)));
      if (!std::exchange(first, false)) text += '\n';
      for (std::size_t k = 0; k < points.size() + (feature.parts[part].closed ? 1 : 0); ++k) {
        const std::size_t at = k == points.size() ? 0 : k;
        base::append_number(text, points[at].x);
        text += ',';
        base::append_number(text, points[at].y);
        if (map) text += ',', base::append_number(text, feature.heights[part][at]);
        text += tail;
      }
    }
  }
  return text;
}

// --- what a format cannot hold

struct Keeps {
  bool properties;
  bool holes;
  bool points;
};

Keeps keeps(LineFormat format) {
  switch (format) {
    case LineFormat::Text:
      return {false, false, false};
    case LineFormat::Wkt:
      return {false, true, true};
    case LineFormat::Dxf:
      return {false, false, false};
    case LineFormat::MoveAscii:
    case LineFormat::Gocad:
      return {false, false, true};
    case LineFormat::GeoJson:
    case LineFormat::Shapefile:
    case LineFormat::GeoPackage:
      break;
  }
  return {true, true, true};
}

/// A name as it is read back.
std::string name_in(LineFormat format, const lines::Feature& feature) {
  if (format == LineFormat::MoveAscii) return lines::move_name(feature.name);
  if (format == LineFormat::Gocad) return lines::gocad_name(feature.name);
  if (format != LineFormat::Dxf || feature.name.empty()) return feature.name;
  const std::string layer = gis::dxf_layer(feature);
  return feature.name.starts_with(layer + ' ') ? feature.name : layer;  // "TOP 2" is on layer TOP
}

/// The layer of a drawing that the name of its line begins with.
bool layer_is_in_name(const lines::Feature& feature, const lines::PropertyValue& value) {
  const auto* layer = std::get_if<std::string>(&value);
  return layer != nullptr && feature.name.starts_with(*layer);
}

/// Features whose names or kinds are lost: "'A' (horizon)".
std::vector<std::string> unnamed_in(LineFormat format, std::span<const lines::Feature> features) {
  std::vector<std::string> lost;
  for (const lines::Feature& feature : features) {
    const bool kind_kept = format != LineFormat::Wkt && lines::known_kind(gis::dxf_layer(feature)) == feature.kind;
    const std::string kind = feature.kind.empty() || kind_kept ? "" : fmt::format("({})", feature.kind);
    const bool name_lost = format == LineFormat::Wkt && !feature.name.empty();
    if (!name_lost && kind.empty()) continue;
    const std::string name = feature.name.empty() ? "one without a name" : shown(feature.name);
    lost.push_back(kind.empty() ? name : name + ' ' + kind);
  }
  return lost;
}

/// Up to ten of them, and how many there are in all.
std::string up_to_ten(const std::vector<std::string>& all) {
  constexpr std::size_t most = 10;
  if (all.size() <= most) return fmt::format("{}", fmt::join(all, ", "));
  return fmt::format("{}, ... ({} in all)", fmt::join(all.begin(), all.begin() + most, ", "), all.size());
}

void remark_losses(std::span<const lines::Feature> features, LineFormat format, std::vector<std::string>& remarks) {
  const Keeps kept = keeps(format);
  std::size_t properties = 0;
  std::size_t holes = 0;
  std::size_t points = 0;
  std::vector<std::string> renamed;
  for (const lines::Feature& feature : features) {
    if (std::string name = name_in(format, feature); name != feature.name)
      renamed.push_back(fmt::format("{} becomes {}", shown(feature.name), shown(name)));
    for (const auto& [key, value] : feature.properties) {
      const bool own = (format == LineFormat::MoveAscii && (key == "id" || key == "attribute")) ||
                       (format == LineFormat::Gocad && key == "geological_feature") ||
                       (key == "layer" && layer_is_in_name(feature, value));
      properties += own ? 0 : 1;
    }
    for (const geom::Polyline& part : feature.parts) holes += part.closed && geom::signed_area(part) < 0.0 ? 1 : 0;
    points += feature.type == lines::FeatureType::Points ? 1 : 0;
  }
  const char* name = line_formats()[static_cast<std::size_t>(format)].name;
  if (format == LineFormat::Wkt || format == LineFormat::Dxf) {
    if (const auto lost = unnamed_in(format, features); !lost.empty()) {
      remarks.push_back(format == LineFormat::Wkt
                            ? fmt::format("names and kinds are not kept in wkt: {}", up_to_ten(lost))
                            : fmt::format("kinds are not kept in dxf: {}; on reading, --kind 'NAME*=KIND' gives them",
                                          up_to_ten(lost)));
    }
  }
  if (!renamed.empty()) {
    remarks.push_back(fmt::format("{} names hold what {} cannot, {}: {}", renamed.size(), name,
                                  format == LineFormat::Dxf
                                      ? R"(a control character, a blank at an end or one of <>/\":;?*|=,`)"
                                      : "a line break, a tab, a brace or a blank at an end",
                                  up_to_ten(renamed)));
  }
  if (!kept.properties && properties > 0) {
    remarks.push_back(fmt::format("{} properties are not kept in {}", properties, name));
  }
  if (!kept.holes && holes > 0) remarks.push_back(fmt::format("{} holes become closed lines in {}", holes, name));
  if (!kept.points && points > 0) {
    remarks.push_back(fmt::format("{} features of points cannot be read back from {}", points, name));
  }
}

Result<std::string> text_in(LineFormat format, std::span<const lines::Feature> features, bool map,
                            const LineWriteOptions& options) {
  switch (format) {
    case LineFormat::Text:
      return text_of(features, map);
    case LineFormat::Wkt:
      return lines::wkt(features);
    case LineFormat::GeoJson:
      return gis::geojson(features, options.system);
    case LineFormat::Dxf:
      return gis::dxf(features, options.unit);
    case LineFormat::MoveAscii:
      return lines::move_ascii(features);
    case LineFormat::Gocad:
      return lines::gocad(features);
    case LineFormat::Shapefile:
    case LineFormat::GeoPackage:
      break;
  }
  return Error{ErrorCode::InvalidOption, "this format is not text"};
}

bool needs_map(LineFormat format) { return format == LineFormat::MoveAscii || format == LineFormat::Gocad; }

// The features as they are written.
Result<std::vector<lines::Feature>> prepared(const LineWork& work, LineFormat format, const LineWriteOptions& options) {
  const bool map =
      options.coordinates == Coordinates::Map || (options.coordinates == Coordinates::Detect && needs_map(format));
  if (options.coordinates == Coordinates::Section && needs_map(format)) {
    return Error{ErrorCode::InvalidOption, "MOVE and GOCAD files have three coordinates; leave out --to-coordinates"};
  }
  if (map && format == LineFormat::Wkt) {
    return Error{ErrorCode::InvalidOption, "WKT is written with section coordinates only; choose another format"};
  }
  return map ? lines::out_of_plane(work.features, work.trace.value_or(lines::Trace{})) : work.features;
}

}  // namespace

Result<std::string> lines_text(const LineWork& work, const LineWriteOptions& options,
                               std::vector<std::string>& remarks) {
  const LineFormat format = options.format.value_or(work.format);
  DOBRA_TRY(const std::vector<lines::Feature> features, prepared(work, format, options));
  remark_losses(work.features, format, remarks);
  return text_in(format, features, !features.empty() && !features[0].heights.empty(), options);
}

Result<void> write_any_lines(const std::string& path, const LineWork& work, const LineWriteOptions& options,
                             std::vector<std::string>& remarks) {
  LineWriteOptions chosen = options;
  if (!chosen.format) {
    DOBRA_TRY(chosen.format, line_format_of(path));
  }
  const LineFormat format = *chosen.format;
  if (format != LineFormat::Shapefile && format != LineFormat::GeoPackage) {
    auto text = lines_text(work, chosen, remarks);
    if (!text) return base::located(text.error(), Place{.file = path});
    return write_file(path, *text);
  }
  DOBRA_TRY(const std::vector<lines::Feature> features, prepared(work, format, chosen));
  DOBRA_TRY(const std::vector<std::string> told, format == LineFormat::Shapefile
                                                     ? gis::write_shapefile(path, features, chosen.system)
                                                     : gis::write_geopackage(path, features, chosen.system));
  remarks.insert(remarks.end(), told.begin(), told.end());
  return {};
}

}  // namespace dobra::io::formats
