#include "shared/cli/offset_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "shared/base/text.h"
#include "shared/io/gis/dxf.h"
#include "shared/operations/offset_layers.h"

namespace dobra::cli {

using base::Error;
using base::ErrorCode;
using operations::DrawnOffset;
using operations::OffsetFamily;
using operations::OffsetOrigin;
using operations::OffsetStage;
using operations::point_count;

namespace {

constexpr std::array<const char*, 6> exchange_endings = {".geojson", ".gpkg", ".shp", ".dxf", ".wkt", ".csv"};
constexpr std::array<const char*, 3> picture_endings = {".svg", ".pdf", ".png"};

template <class Endings>
bool is_one_of(const std::string& ending, const Endings& endings) {
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

std::string json_text(const nlohmann::json& text) {
  return text.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
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
    text += "\"curve\":" + json_text(family.name) + ',';
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

}  // namespace

std::string offset_json(const std::vector<OffsetFamily>& families, const std::optional<OffsetStage>& stage) {
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
  text += fmt::format("],\"dropped\":{}", dropped);
  if (stage) {
    text += fmt::format(",\"stage\":{{\"steps\":{},\"curve\":{},\"distance\":{},\"regions\":{},\"deleted\":{}}}",
                        stage->steps, json_text(stage->curve), base::number_text(stage->distance), stage->regions,
                        stage->deleted.size());
  }
  return text + "}\n";
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

scene::Picture offset_picture(const std::vector<OffsetFamily>& families, const std::optional<OffsetStage>& stage) {
  const operations::OffsetNaming naming;
  scene::Panel panel{.key = "offset"};
  panel.layers = offset_layers(families, naming, stage ? operations::Nothing::LeftOut : operations::Nothing::Told);
  panel.layers.push_back(base_layer(families, naming));
  if (stage) {
    for (scene::Layer& layer : stage_layers(*stage, naming)) panel.layers.push_back(std::move(layer));
  }
  scene::Picture picture;
  picture.panels.push_back(std::move(panel));
  return picture;
}

base::Result<OffsetFile> offset_file(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  if (is_one_of(ending, exchange_endings)) return OffsetFile::Lines;
  if (is_one_of(ending, picture_endings)) return OffsetFile::Picture;
  return Error{ErrorCode::BadUsage,
               fmt::format("--out {}: the name must end in .geojson, .gpkg, .shp, .dxf, .wkt, .csv, .svg, .pdf or .png",
                           file.string())};
}

base::Result<void> write_offset(const std::vector<OffsetFamily>& families, const OffsetOrigin& origin,
                                const std::filesystem::path& file, std::vector<std::string>& remarks) {
  const std::string ending = file.extension().string();
  io::formats::LineWork work;
  work.features = features_of(families);
  const auto is_polygon = [](const io::lines::Feature& f) { return f.type == io::lines::FeatureType::Polygons; };
  const auto polygons = static_cast<std::size_t>(std::count_if(work.features.begin(), work.features.end(), is_polygon));
  if (ending == ".shp" && polygons > 0 && polygons < work.features.size()) {
    return Error{
        ErrorCode::BadUsage,
        "--out: a Shapefile holds either lines or polygons, and these are both; write a .gpkg, or choose with --curve"};
  }
  const auto& system = origin.system;
  const io::formats::LineWriteOptions options{
      .coordinates = io::formats::Coordinates::Section, .system = system ? &*system : nullptr, .unit = origin.unit};
  DOBRA_TRY_VOID(io::formats::write_any_lines(file.string(), work, options, remarks));
  const bool keeps_system =
      ending == ".gpkg" || ending == ".shp" || (ending == ".geojson" && system && !system->code.empty());
  if (system && !keeps_system)
    remarks.push_back(fmt::format("the reference system ({}) is not kept in {}", system->name, ending));
  const auto is_unit = [&](const auto& known) { return known.second == origin.unit; };
  const bool keeps_unit =
      ending == ".dxf" && std::any_of(io::gis::dxf_units.begin(), io::gis::dxf_units.end(), is_unit);
  if (origin.unit && !keeps_unit && !system) {
    remarks.push_back(fmt::format("the unit of the file ({} m) is not kept in {}", *origin.unit, ending));
  }
  return {};
}

}  // namespace dobra::cli
