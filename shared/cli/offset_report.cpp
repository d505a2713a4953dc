#include "shared/cli/offset_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "shared/base/text.h"
#include "shared/cli/pictures.h"
#include "shared/io/dxf.h"
#include "shared/offset/verifier/verify.h"
#include "shared/scene/color_map.h"

namespace dobra::cli {

using base::Error;
using base::ErrorCode;

namespace {

constexpr std::array<const char*, 6> exchange_endings = {".geojson", ".gpkg", ".shp", ".dxf", ".wkt", ".csv"};
constexpr std::array<const char*, 3> picture_endings = {".svg", ".pdf", ".png"};
constexpr std::size_t legend_entries = 12;  ///< More distances than these show only some of them in the legend.

template <class Endings>
bool is_one_of(const std::string& ending, const Endings& endings) {
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

void append_points(std::string& text, const geom::Polyline& line) {
  text += '[';
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    text += i > 0 ? ",[" : "[";
    base::append_number(text, line.points[i].x);
    text += ',';
    base::append_number(text, line.points[i].y);
    text += ']';
  }
  text += ']';
}

void append_curve(std::string& text, const OffsetFamily& family, const DrawnOffset& curve, bool with_name) {
  text += '{';
  if (with_name) {
    const nlohmann::json name = family.name;
    text += "\"curve\":" + name.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + ',';
  }
  text += fmt::format("\"distance\":{},\"length\":{},{}\"dropped\":{},\"dropped_length\":{},\"pieces\":[",
                      base::number_text(curve.distance), base::number_text(curve.length),
                      curve.area ? fmt::format("\"area\":{},", base::number_text(*curve.area)) : "", curve.dropped,
                      base::number_text(curve.dropped_length));
  for (std::size_t i = 0; i < curve.lines.size(); ++i) {
    const geom::Polyline& line = curve.lines[i];
    text += fmt::format("{}{{\"closed\":{},\"points\":", i > 0 ? "," : "", line.closed);
    append_points(text, line);
    text += '}';
  }
  text += "]}";
}

std::size_t point_count(const DrawnOffset& curve) {
  std::size_t count = 0;
  for (const geom::Polyline& line : curve.lines) count += line.points.size();
  return count;
}

/// Numbers of the curve, then what the base had; a property of the base that has the name of one of ours is
/// "source_...".
io::Feature feature_of(const OffsetFamily& family, const DrawnOffset& curve) {
  io::Feature feature;
  feature.type = family.content == OffsetContent::Polygons ? io::FeatureType::Polygons : io::FeatureType::Lines;
  feature.parts = curve.lines;
  feature.name = fmt::format("{} at {}", family.name, base::number_text(curve.distance));
  feature.kind = "offset";
  feature.properties = {{"curve", family.name}, {"distance", curve.distance}, {"length", curve.length}};
  if (curve.area) feature.properties.emplace_back("area", *curve.area);
  if (curve.dropped > 0) feature.properties.emplace_back("dropped", static_cast<std::int64_t>(curve.dropped));
  const io::Feature& source = family.source;
  const auto has = [&](const std::string& key) {
    return std::any_of(feature.properties.begin(), feature.properties.end(),
                       [&](const auto& p) { return p.first == key; });
  };
  const auto add = [&](const std::string& key, const io::PropertyValue& value) {
    feature.properties.emplace_back(has(key) ? "source_" + key : key, value);
  };
  if (!source.kind.empty()) add("source_kind", source.kind);
  for (const auto& [key, value] : source.properties) add(key, value);
  if (source.id && !has("id")) add("id", *source.id);
  return feature;
}

/// Curves of which something remains.
std::vector<io::Feature> features_of(const std::vector<OffsetFamily>& families) {
  std::vector<io::Feature> features;
  for (const OffsetFamily& family : families) {
    for (const DrawnOffset& curve : family.curves) {
      if (!curve.lines.empty()) features.push_back(feature_of(family, curve));
    }
  }
  return features;
}

/// Whether entry `i` of `count` is among those that a legend of limited length shows; the first and the last are.
bool in_legend(std::size_t i, std::size_t count) {
  if (count <= legend_entries) return true;
  const std::size_t step = (count - 1 + legend_entries - 2) / (legend_entries - 1);
  return i == count - 1 || (i % step == 0 && i + step / 2 < count - 1);
}

}  // namespace

DrawnOffset drawn(const offset::OffsetCurve& curve, const geom::Polyline& base, double tolerance) {
  DrawnOffset made;
  made.distance = curve.distance;
  made.dropped = curve.dropped;
  const auto is_closed = [](const offset::OffsetPiece& piece) { return piece.closed; };
  const bool closed =
      curve.pieces.empty() ? base.closed : std::all_of(curve.pieces.begin(), curve.pieces.end(), is_closed);
  if (closed) made.area = 0.0;
  made.dropped_length = curve.dropped_length;
  for (const offset::OffsetPiece& piece : curve.pieces) {
    made.length += offset::length(piece, base);
    if (made.area) *made.area += offset::signed_area(piece, base);
    made.lines.push_back(offset::chords(piece, base, tolerance).polyline);
  }
  if (made.area) made.area = std::abs(*made.area);
  return made;
}

DrawnOffset drawn(const offset::Area& area, double distance) {
  return {.distance = distance, .length = area.length, .area = area.area, .lines = area.rings};
}

base::Result<void> verify_offset(const std::string& name, const geom::Polyline& base,
                                 const offset::OffsetOptions& options, const std::vector<offset::OffsetCurve>& curves,
                                 OffsetVerdict& verdict, const base::Progress& progress) {
  for (const offset::OffsetCurve& curve : curves) {
    DOBRA_TRY(const offset::verifier::Verification found, offset::verifier::verify(base, options, curve, {}, progress));
    ++verdict.curves;
    verdict.coarse += found.coarse ? 1 : 0;
    verdict.dropped += curve.dropped;
    verdict.dropped_length += curve.dropped_length;
    verdict.edges += found.edges;
    verdict.samples += found.samples;
    for (const offset::verifier::Finding& finding : found.findings) {
      verdict.findings.push_back(fmt::format("{}: distance {}: {}", name, dobra::base::number_text(curve.distance),
                                             offset::verifier::to_string(finding)));
    }
  }
  return {};
}

std::string not_judged(const OffsetVerdict& verdict, const offset::OffsetOptions& options) {
  std::vector<std::string> all;
  const auto add = [&](std::size_t count, const char* one, const char* more) {
    if (count > 0) all.push_back(fmt::format("{} {}", count, count == 1 ? one : more));
  };
  add(verdict.dropped, "piece left out", "pieces left out");
  if (verdict.dropped > 0)
    all.back() += fmt::format(" ({:.6g} m), and whether more of those curves is missing", verdict.dropped_length);
  add(verdict.cut_tips, "bisector point cut across", "bisector points cut across");
  add(verdict.skipped, "open line at a distance below 0", "open lines at distances below 0");
  add(verdict.mended, "polygon that crosses or touches itself, but what it was taken as",
      "polygons that cross or touch themselves, but what they were taken as");
  add(verdict.coarse, "curve nearer than 64 roundings of the coordinates, as to touching and missing parts",
      "curves nearer than 64 roundings of the coordinates, as to touching and missing parts");
  if (options.treatment == offset::Treatment::Untreated) {
    all.emplace_back("whether untreated curves keep their distance or cross");
  } else if (options.ends == offset::Ends::Paper) {
    all.emplace_back("whether curves with the paper's ends keep their distance or lack anything");
  }
  if (verdict.joined) all.emplace_back("what was joined of several curves");
  return fmt::format("{}", fmt::join(all, "; "));
}

base::Result<void> check_numbers(const std::vector<OffsetFamily>& families) {
  for (const OffsetFamily& family : families) {
    for (const DrawnOffset& curve : family.curves) {
      if (std::isfinite(curve.length) && std::isfinite(curve.area.value_or(0.0))) continue;
      return Error{ErrorCode::NotFinite,
                   fmt::format("the length or the area of {} at distance {} is beyond what a number can hold; "
                               "use larger units",
                               family.name, base::number_text(curve.distance))};
    }
  }
  return {};
}

std::string offset_json(const std::vector<OffsetFamily>& families) {
  std::string text = "{\"curves\":[";
  std::size_t dropped = 0;
  bool first = true;
  for (const OffsetFamily& family : families) {
    for (const DrawnOffset& curve : family.curves) {
      if (!first) text += ',';
      first = false;
      append_curve(text, family, curve, families.size() > 1);
      dropped += curve.dropped;
    }
  }
  text += fmt::format("],\"dropped\":{}}}\n", dropped);
  return text;
}

std::string offset_table(const std::vector<OffsetFamily>& families) {
  std::size_t width = 0;
  if (families.size() > 1) {
    width = std::string_view("curve").size();
    for (const OffsetFamily& family : families) width = std::max(width, family.name.size());
    width += 2;
  }
  const auto row = [&](const std::string& name, auto... cells) {
    std::string text = fmt::format("{:<{}}", width > 0 ? name : "", width);
    ((text += fmt::format("{:>14}", cells)), ...);
    return text + '\n';
  };
  bool dropped = false;
  for (const OffsetFamily& family : families) {
    for (const DrawnOffset& curve : family.curves) dropped = dropped || curve.dropped > 0;
  }
  const auto with_dropped = [&](std::string line, const std::string& pieces, const std::string& length) {
    if (dropped) line.insert(line.size() - 1, fmt::format("{:>14}{:>14}", pieces, length));
    return line;
  };
  std::string text =
      with_dropped(row("curve", "distance", "pieces", "points", "length", "area"), "left out", "their length");
  for (const OffsetFamily& family : families) {
    for (const DrawnOffset& curve : family.curves) {
      text += with_dropped(
          row(family.name, fmt::format("{:.7g}", curve.distance), curve.lines.size(), point_count(curve),
              fmt::format("{:.7g}", curve.length), curve.area ? fmt::format("{:.7g}", *curve.area) : std::string("-")),
          fmt::format("{}", curve.dropped), fmt::format("{:.7g}", curve.dropped_length));
    }
  }
  return text;
}

scene::Picture offset_picture(const std::vector<OffsetFamily>& families) {
  scene::Panel panel{.key = "offset"};
  const std::size_t count = families.empty() ? 0 : families.front().curves.size();
  for (std::size_t k = 0; k < count; ++k) {
    scene::Lines lines;
    for (const OffsetFamily& family : families) {
      const auto& drawn_lines = family.curves[k].lines;
      lines.lines.insert(lines.lines.end(), drawn_lines.begin(), drawn_lines.end());
    }
    // Viridis without its light yellow end, which is hard to see on white.
    const double fraction = count > 1 ? 0.85 * static_cast<double>(k) / static_cast<double>(count - 1) : 0.4;
    scene::Layer layer{.key = fmt::format("offset_{}", k + 1),
                       .title = fmt::format("D = {:.6g}{}", families.front().curves[k].distance,
                                            lines.lines.empty() ? " (nothing remains)" : ""),
                       .style = {.line = scene::color_at(scene::ColorMapName::Viridis, fraction), .line_width = 1.0},
                       .content = std::move(lines)};
    if (!in_legend(k, count)) layer.in_legend = scene::InLegend::No;
    panel.layers.push_back(std::move(layer));
  }
  scene::Lines bases;
  for (const OffsetFamily& family : families) {
    bases.lines.insert(bases.lines.end(), family.bases.begin(), family.bases.end());
  }
  panel.layers.push_back({.key = "base",
                          .title = families.size() == 1 ? families.front().name : "base curves",
                          .style = {.line = {20, 20, 24}, .line_width = 2.5},
                          .content = std::move(bases)});
  scene::Picture picture;
  picture.panels.push_back(std::move(panel));
  return picture;
}

base::Result<void> check_offset_ending(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  if (is_one_of(ending, exchange_endings) || is_one_of(ending, picture_endings)) return {};
  return Error{ErrorCode::BadUsage,
               fmt::format("--out {}: the name must end in .geojson, .gpkg, .shp, .dxf, .wkt, .csv, .svg, .pdf or .png",
                           file.string())};
}

base::Result<void> write_offset(const std::vector<OffsetFamily>& families, const OffsetOrigin& origin,
                                const std::filesystem::path& file, std::vector<std::string>& remarks) {
  DOBRA_TRY_VOID(check_offset_ending(file));
  const std::string ending = file.extension().string();
  if (is_one_of(ending, picture_endings)) return draw(offset_picture(families), file, Drawer::Cairo);
  io::LineWork work;
  work.features = features_of(families);
  const auto is_polygon = [](const io::Feature& f) { return f.type == io::FeatureType::Polygons; };
  const auto polygons = static_cast<std::size_t>(std::count_if(work.features.begin(), work.features.end(), is_polygon));
  if (ending == ".shp" && polygons > 0 && polygons < work.features.size()) {
    return Error{
        ErrorCode::BadUsage,
        "--out: a Shapefile holds either lines or polygons, and these are both; write a .gpkg, or choose with --curve"};
  }
  const auto& system = origin.system;
  const io::LineWriteOptions options{
      .coordinates = io::Coordinates::Section, .system = system ? &*system : nullptr, .unit = origin.unit};
  DOBRA_TRY_VOID(io::write_any_lines(file.string(), work, options, remarks));
  const bool keeps_system =
      ending == ".gpkg" || ending == ".shp" || (ending == ".geojson" && system && !system->code.empty());
  if (system && !keeps_system)
    remarks.push_back(fmt::format("the reference system ({}) is not kept in {}", system->name, ending));
  const auto is_unit = [&](const auto& known) { return known.second == origin.unit; };
  const bool keeps_unit = ending == ".dxf" && std::any_of(io::dxf_units.begin(), io::dxf_units.end(), is_unit);
  if (origin.unit && !keeps_unit && !system) {
    remarks.push_back(fmt::format("the unit of the file ({} m) is not kept in {}", *origin.unit, ending));
  }
  return {};
}

}  // namespace dobra::cli
