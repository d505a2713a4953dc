// 1. A pass over the pairs of group code and value finds what OGR would pass over in silence: a missing end, words
// where
//    numbers belong. It also counts what is curved.
// 2. OGR reads the entities from memory.
// 3. Each entity that is a line becomes a Feature; the others are counted for the remarks.

#include "shared/io/gis/dxf.h"

#include <cpl_conv.h>
#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <utility>

#include "shared/io/dxf_pairs.h"
#include "shared/io/file.h"
#include "shared/io/gis/gdal.h"
#include "shared/io/gis/ogr_features.h"
#include "shared/io/lines/line_kinds.h"
#include "shared/io/scan.h"

namespace dobra::io::gis {

using base::Error;
using base::ErrorCode;
using base::Place;
using base::Result;
using geom::Polyline;

namespace {

bool is_curved(std::string_view entity) {
  return entity == "ARC" || entity == "CIRCLE" || entity == "ELLIPSE" || entity == "SPLINE";
}

struct Survey {
  std::size_t curved = 0;  // arcs, circles, splines, bulges
  bool has_header = false;
  lines::StatedConvention stated;
};

// Of $INSUNITS.
void note_unit(std::string_view value, lines::StatedConvention& stated) {
  if (value == "0") return;  // unitless
  const auto has_value = [&](const auto& own) { return fmt::format("{}", own.first) == value; };
  const auto* unit = std::find_if(dxf_units.begin(), dxf_units.end(), has_value);
  if (unit != dxf_units.end()) {
    stated.unit = unit->second;
    return;
  }
  stated.questions.push_back({lines::Question::About::Unit,
                              fmt::format("the drawing gives $INSUNITS = {}, a unit that is not known here; say what "
                                          "one unit is: unit = m, km, ft, in, cm or mm (--unit)",
                                          shown(value))});
}

// Whether the pair says that its entity is not displayed.
bool is_hidden_by(const DxfPairs& pairs, const std::set<std::string>& hidden_layers) {
  return (pairs.code == 8 && hidden_layers.contains(std::string(pairs.value))) ||
         (pairs.code == 60 && pairs.value == "1");
}

// Judges the whole text.
Result<Survey> survey(std::string_view text, const std::string& file) {
  DxfPairs pairs(text, file);
  const std::set<std::string> hidden_layers = hidden_dxf_layers(text);
  Survey found;
  std::size_t bends = 0;  // of the current record, which may turn out to be hidden
  std::string_view section;
  std::string_view entity;
  bool hidden = false;
  bool entities_seen = false;
  bool first = true;
  while (true) {
    DOBRA_TRY_VOID(pairs.next());
    if (pairs.code == 999) continue;  // a comment
    if (first && !pairs.is(0, "SECTION")) return pairs.error("not DXF: a drawing begins with the pair '0 SECTION'");
    first = false;
    if (pairs.is(0, "EOF")) break;
    if (pairs.is(0, "SECTION")) {
      DOBRA_TRY_VOID(pairs.next());
      if (pairs.code != 2) return pairs.error("a SECTION has no name; correct the file");
      section = pairs.value;
      entities_seen = entities_seen || section == "ENTITIES";
      found.has_header = found.has_header || section == "HEADER";
      continue;
    }
    if (section == "HEADER" && pairs.is(9, "$INSUNITS")) {
      DOBRA_TRY_VOID(pairs.next());
      note_unit(pairs.value, found.stated);
      continue;
    }
    if (pairs.code == 0) {
      found.curved += std::exchange(bends, 0);
      hidden = false;
      entity = pairs.value;
      if (entity == "ENDSEC") section = {};
    }
    if (section != "ENTITIES" && section != "BLOCKS") continue;
    if (pairs.code == 0 && is_curved(entity)) ++bends;
    hidden = hidden || is_hidden_by(pairs, hidden_layers);
    if (hidden) bends = 0;
    if (pairs.code < 10 || pairs.code > 59) continue;
    const Result<double> number = finite_number(pairs.value, "a coordinate");
    if (!number)
      return pairs.error(fmt::format("group {}: {}", pairs.code, number.error().message), number.error().code);
    if (pairs.code == 42 && *number != 0.0 && !hidden && (entity == "LWPOLYLINE" || entity == "VERTEX")) ++bends;
  }
  if (!entities_seen) return pairs.error("the drawing has no section ENTITIES; save it again with its lines");
  return found;
}

// The lines of one entity, as the parts of a feature, and what else it holds.
struct Parts {
  lines::Feature lines;
  std::map<std::string, std::size_t> left_out;  // by the name of the geometry
};

void add_parts(const OGRGeometry& geometry, Parts& parts) {
  if (const auto type = wkbFlatten(geometry.getGeometryType()); type == wkbLineString) {
    add_part(*geometry.toLineString(), lines::Heights::Keep, parts.lines);
  } else if (type == wkbMultiLineString || type == wkbGeometryCollection) {
    for (const OGRGeometry* part : *geometry.toGeometryCollection()) add_parts(*part, parts);
  } else {
    ++parts.left_out[geometry.getGeometryName()];
  }
}

// "TOP" for the first on layer TOP, then "TOP 2", ...
std::string name_on(const std::string& layer, std::map<std::string, std::size_t>& used) {
  if (layer.empty()) return {};
  const std::size_t number = ++used[layer];
  return number == 1 ? layer : fmt::format("{} {}", layer, number);
}

bool returns_to_start(const Polyline& line, const std::vector<double>& heights) {
  return line.points.size() > 3 && line.points.front() == line.points.back() && heights.front() == heights.back();
}

bool is_level_zero(const std::vector<double>& heights) {
  return std::all_of(heights.begin(), heights.end(), [](double z) { return z == 0.0; });
}

// OGR draws entities that are invisible, and those on layers that are off or frozen, in a colour without opacity; also
// those of blocks, which take after where they are inserted.
bool is_hidden(const OGRFeature& source) {
  const char* const given = source.GetStyleString();
  const std::string_view style = given == nullptr ? "" : given;
  constexpr std::size_t opaque = 6;  // digits of red, green and blue; two more are the opacity
  const std::size_t digits = style.find("c:#") + 3;
  const std::size_t end = std::min(style.find_first_not_of("0123456789abcdefABCDEF", digits), style.size());
  return digits > 2 && end - digits == opaque + 2 && style.substr(digits + opaque, 2) == "00";
}

class DrawingReader {
 public:
  DrawingReader(const std::string& file, lines::Heights heights, lines::Faulty faulty)
      : file_(file), heights_(heights), faulty_(faulty) {}

  // Adds the lines of one entity.
  Result<void> add(const OGRFeature& source) {
    ++number_;
    const int field = source.GetFieldIndex("Layer");
    std::string layer = field >= 0 ? source.GetFieldAsString(field) : "";
    if (is_hidden(source)) {
      ++hidden_[layer];
      return {};
    }
    const OGRGeometry* geometry = source.GetGeometryRef();
    Parts parts;
    if (geometry != nullptr) add_parts(*geometry, parts);
    for (const auto& [type, count] : parts.left_out) left_out_[type] += count;
    if (layer == "0") layer.clear();
    for (std::size_t i = 0; i < parts.lines.parts.size(); ++i) {
      Polyline& line = parts.lines.parts[i];
      std::vector<double>& heights = parts.lines.heights[i];
      lines::Feature feature;
      feature.type = returns_to_start(line, heights) ? lines::FeatureType::Polygons : lines::FeatureType::Lines;
      feature.kind = lines::known_kind(layer).value_or("");
      if (!layer.empty()) feature.properties.emplace_back("layer", layer);
      feature.name = name_on(layer, used_);
      feature.parts.push_back(std::move(line));
      feature.heights.push_back(std::move(heights));
      DOBRA_TRY_VOID(keep(std::move(feature)));
    }
    return {};
  }

  Result<lines::Features> finish(const Survey& found, const GdalMessages& messages) {
    const auto say = [&](const std::string& remark) { features_.remarks.push_back(file_ + ": " + remark); };
    for (const auto& [type, count] : left_out_)
      say(fmt::format("{} of type {} left out: only lines are read", count, type));
    for (const auto& [layer, count] : hidden_)
      say(fmt::format("{} not displayed left out, of layer {}", count, shown(layer)));
    if (found.curved > 0) say(fmt::format("{} {}", found.curved, read_as_chords));
    for (const std::string& warning : messages.warnings) say(warning);
    features_.stated = found.stated;
    const bool flat = std::all_of(features_.features.begin(), features_.features.end(), [](const lines::Feature& f) {
      return f.heights.empty() || is_level_zero(f.heights[0]);
    });
    if (flat) DOBRA_TRY_VOID(lines::drop_heights(features_, faulty_));
    return std::move(features_);
  }

 private:
  Result<void> keep(lines::Feature feature) {
    const std::string item = feature.name.empty() ? fmt::format("entity {}", number_)
                                                  : fmt::format("entity {} {}", number_, shown(feature.name));
    feature.source = Place{.file = file_, .item = item};
    const bool has_heights = !is_level_zero(feature.heights[0]);
    if (heights_ == lines::Heights::Drop) feature.heights.clear();
    const Result<std::size_t> repeated =
        faulty_ == lines::Faulty::Refuse
            ? lines::normalise(feature, {0})
            : lines::normalise_sound(feature, {0}, fmt::format("{}: {}", file_, item), features_.remarks);
    if (!repeated) return base::located(repeated.error(), feature.source);
    const auto say = [&](const std::string& what) {
      features_.remarks.push_back(fmt::format("{}: {}: {} dropped", file_, item, what));
    };
    if (has_heights && heights_ == lines::Heights::Drop) say("third coordinates");
    if (*repeated > 0) say(fmt::format("{} repeated {}", *repeated, *repeated == 1 ? "point" : "points"));
    if (!feature.parts.empty()) features_.features.push_back(std::move(feature));
    return {};
  }

  std::string file_;
  lines::Heights heights_;
  lines::Faulty faulty_;
  std::size_t number_ = 0;
  std::map<std::string, std::size_t> used_;
  std::map<std::string, std::size_t> left_out_;
  std::map<std::string, std::size_t> hidden_;  // by layer
  lines::Features features_;
};

}  // namespace

Result<lines::Features> parse_dxf(std::string_view text, const std::string& file, lines::Heights heights,
                                  lines::Faulty faulty) {
  DOBRA_TRY_VOID(check_text(text, file));
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  DOBRA_TRY(const Survey found, survey(text, file));
  static std::once_flag registered;
  std::call_once(registered, [] { RegisterOGRDXF(); });
  const GdalMessages messages;
  // OGR looks at the encoding set below only where there is a header, so a drawing without one gets an empty one.
  std::string with_header;
  if (!found.has_header) {
    with_header = "0\nSECTION\n2\nHEADER\n0\nENDSEC\n";
    with_header += text;
    text = with_header;
  }
  const GdalMemoryFile memory(text, ".dxf");
  // The text is UTF-8 here, whatever code page its header names; of this thread, and set back at the end.
  const CPLConfigOptionSetter encoding("DXF_ENCODING", CPL_ENC_UTF8, false);
  const char* const drivers[] = {"DXF", nullptr};
  const auto not_read = [&] {
    return Error{ErrorCode::BadFormat,
                 fmt::format("the drawing cannot be read{}; save it again as DXF R12",
                             messages.failure ? " (" + *messages.failure + ")" : std::string{}),
                 Place{.file = file}};
  };
  const GDALDatasetUniquePtr data(
      GDALDataset::Open(memory.name(), GDAL_OF_VECTOR | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR, drivers));
  if (!data || messages.failure) return not_read();
  DrawingReader reader(file, heights, faulty);
  for (OGRLayer* layer : data->GetLayers()) {
    layer->ResetReading();
    while (const OGRFeatureUniquePtr source{layer->GetNextFeature()}) DOBRA_TRY_VOID(reader.add(*source));
  }
  if (messages.failure) return not_read();
  return reader.finish(found, messages);
}

Result<lines::Features> read_dxf(const std::string& path, lines::Heights heights) {
  DOBRA_TRY(const std::string text, read_text(path));
  return parse_dxf(text, path, heights);
}

}  // namespace dobra::io::gis
