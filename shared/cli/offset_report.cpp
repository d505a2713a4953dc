#include "shared/cli/offset_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "shared/base/text.h"
#include "shared/cli/pictures.h"
#include "shared/io/file.h"
#include "shared/io/formats/line_files.h"
#include "shared/operations/offset_layers.h"

namespace dobra::cli {

using base::Error;
using base::ErrorCode;
using io::formats::format_of;
using io::formats::SystemKept;
using io::formats::Use;
using operations::DrawnOffset;
using operations::OffsetFamily;
using operations::OffsetOrigin;
using operations::OffsetStage;
using operations::point_count;

namespace {

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

/// Of the formats that hold lines and polygons together.
std::vector<std::string> endings_of_both() {
  std::vector<std::string> endings;
  for (const io::formats::Format& format : io::formats::all_formats()) {
    if (is_for(format, Use::WritePlaneLines) && !format.lines->one_type)
      endings.insert(endings.end(), format.endings.begin(), format.endings.end());
  }
  return endings;
}

Error unknown_ending(const std::filesystem::path& file) {
  return {ErrorCode::BadUsage,
          fmt::format("--out {}: the name must end in {}; or, for a picture, in {}", file.string(),
                      fmt::join(io::formats::endings_for(Use::WritePlaneLines), " "), picture_endings())};
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
  if (format_of(file.string(), Use::WritePlaneLines) != nullptr) return OffsetFile::Lines;
  if (check_ending(file, Drawer::Cairo)) return OffsetFile::Picture;
  return unknown_ending(file);
}

base::Result<void> write_offset(const std::vector<OffsetFamily>& families, const OffsetOrigin& origin,
                                const std::filesystem::path& file, std::vector<std::string>& remarks) {
  const io::formats::Format* const format = format_of(file.string(), Use::WritePlaneLines);
  if (format == nullptr) return unknown_ending(file);
  const io::formats::LineRow& row = *format->lines;
  io::formats::LineWork work;
  work.features = features_of(families);
  const auto is_polygon = [](const io::lines::Feature& f) { return f.type == io::lines::FeatureType::Polygons; };
  const auto polygons = static_cast<std::size_t>(std::count_if(work.features.begin(), work.features.end(), is_polygon));
  if (row.one_type && polygons > 0 && polygons < work.features.size()) {
    return Error{ErrorCode::BadUsage,
                 fmt::format("--out: a {} holds either lines or polygons, and these are both; write one of {}, or "
                             "choose with --curve",
                             format->title, fmt::join(endings_of_both(), " "))};
  }
  const auto& system = origin.system;
  const io::formats::LineWriteOptions options{.format = format,
                                              .coordinates = io::formats::Coordinates::Section,
                                              .system = system ? &*system : nullptr,
                                              .unit = origin.unit};
  DOBRA_TRY_VOID(io::formats::write_any_lines(file.string(), work, options, remarks));
  const std::string ending = io::ending_of(file.string());
  const bool keeps_system =
      row.system == SystemKept::Yes || (row.system == SystemKept::IfCoded && system && !system->code.empty());
  if (system && !keeps_system)
    remarks.push_back(fmt::format("the reference system ({}) is not kept in {}", system->name, ending));
  const bool keeps_unit = origin.unit && row.keeps_unit != nullptr && row.keeps_unit(*origin.unit);
  if (origin.unit && !keeps_unit && !system) {
    remarks.push_back(fmt::format("the unit of the file ({} m) is not kept in {}", *origin.unit, ending));
  }
  return {};
}

}  // namespace dobra::cli
