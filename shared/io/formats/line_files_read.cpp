// 1. The format's own reader gives features in the coordinates of the file, and what the file says of them.
// 2. What it leaves open must be answered by an option.
// 3. Units; then the plane of 3D lines; then direction and exaggeration of heights.
// 4. Repairs.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shared/io/file.h"
#include "shared/io/formats/line_files.h"
#include "shared/io/lines/section_plane.h"
#include "shared/io/scan.h"

namespace dobra::io::formats {

using base::Error;
using base::ErrorCode;
using base::Place;
using base::Result;
using geom::Point;

Result<const Format*> line_format_of(const std::string& path) {
  if (const Format* format = format_of(path, Use::ReadLines)) return format;
  return Error{ErrorCode::UnknownFormat,
               fmt::format("the ending of the name tells no format of lines; known are {}",
                           fmt::join(endings_for(Use::ReadLines), " ")),
               Place{.file = path}};
}

namespace {

// --- coordinates

bool has_heights(const lines::Features& raw) {
  return std::any_of(raw.features.begin(), raw.features.end(),
                     [](const lines::Feature& f) { return !f.heights.empty(); });
}

bool is_flat(const lines::Features& raw) {
  for (const lines::Feature& feature : raw.features) {
    for (const std::vector<double>& heights : feature.heights) {
      if (std::any_of(heights.begin(), heights.end(), [](double z) { return z != 0.0; })) return false;
    }
  }
  return true;
}

Error unclear(std::string text, const std::string& file) {
  return {ErrorCode::Unclear, std::move(text), Place{.file = file}};
}

Result<void> check_answers(const lines::Features& raw, const LineOptions& options, const std::string& file) {
  for (const lines::Question& question : raw.stated.questions) {
    const bool answered = question.about == lines::Question::About::YDirection ? options.y_direction.has_value()
                          : question.about == lines::Question::About::Unit
                              ? options.unit || options.unit_wanted == UnitWanted::OfTheFile
                              : options.coordinates != Coordinates::Detect;
    if (!answered) return unclear(question.text, file);
  }
  return {};
}

Result<void> check_options(const LineOptions& options) {
  const auto positive = [](double value) { return std::isfinite(value) && value > 0.0; };
  const auto refuse = [](std::string message) { return Error{ErrorCode::InvalidOption, std::move(message)}; };
  if (options.unit && !positive(*options.unit)) {
    return refuse(fmt::format("the unit is {} m; give a length above 0", *options.unit));
  }
  if (!positive(options.exaggeration)) {
    return refuse(fmt::format("the exaggeration is {}; give a number above 0", options.exaggeration));
  }
  if (!positive(options.plane_tolerance)) {
    return refuse(fmt::format("the tolerance of the plane is {}; give a number above 0", options.plane_tolerance));
  }
  if (!std::isfinite(options.y_reference)) return refuse("the reference of y is not finite; give a number");
  const RepairOptions& repairs = options.repair;
  const bool moves_points = repairs.order != PointOrder::AsGiven || repairs.duplicates || repairs.gaps ||
                            repairs.snap || repairs.slivers || repairs.edges;
  if (!options.text.extra_columns.empty() && moves_points)
    return refuse("extra columns belong to points as they were read; leave out the repairs");
  if (!options.text.extra_columns.empty() && options.text.closing != lines::Closing::KeepOpen)
    return refuse("extra columns belong to open lines; keep them open");
  if (options.fold_axis && !(std::abs(options.fold_axis->plunge.degrees()) < 90.0))
    return refuse("the plunge of the fold axis must lie between -90 and 90 degrees");
  return {};
}

// Whether the file has places on the map, to be laid into a plane.
Result<bool> is_map(const lines::Features& raw, const LineOptions& options, const std::string& file) {
  const auto has = [](const lines::Feature& f) { return !f.heights.empty(); };
  const bool all = std::all_of(raw.features.begin(), raw.features.end(), has);
  if (options.coordinates == Coordinates::Map && !all) {
    return Error{ErrorCode::BadFormat,
                 "map coordinates need a third coordinate at every point, and this file has none "
                 "at some; give coordinates = section (--coordinates section)",
                 Place{.file = file}};
  }
  if (options.coordinates != Coordinates::Detect) return options.coordinates == Coordinates::Map;
  if (!has_heights(raw) || is_flat(raw)) return false;
  if (!all) {
    return unclear(
        "some lines have third coordinates and others have none; say whether x and y are section "
        "coordinates: coordinates = section (--coordinates section)",
        file);
  }
  return true;
}

Result<void> to_metres(lines::Features& raw, double unit, double height_unit, const std::string& file) {
  for (lines::Feature& feature : raw.features) {
    const double y_unit = feature.heights.empty() ? height_unit : unit;
    for (geom::Polyline& part : feature.parts) {
      for (Point& p : part.points) p = {p.x * unit, p.y * y_unit};
    }
    for (std::vector<double>& heights : feature.heights) {
      for (double& z : heights) z *= height_unit;
    }
    for (const geom::Polyline& part : feature.parts) {
      for (const Point p : part.points) {
        if (!geom::is_finite(p))
          return Error{ErrorCode::NotFinite, "a point is not finite in metres; check the unit",
                       Place{.file = file, .line = feature.source.line, .item = feature.source.item}};
      }
    }
  }
  return {};
}

// Down-plunge: every point along the fold axis to the plane across it.
Result<void> lay_along(lines::Features& raw, const lines::FoldAxis& axis, LineWork& work, const std::string& file) {
  work.remarks.push_back(
      fmt::format("{}: projected along the fold axis {:.4g}/{:.4g} onto the profile across it; x runs towards {:.4g} "
                  "degrees",
                  file, axis.trend.degrees(), axis.plunge.degrees(), std::fmod(axis.trend.degrees() + 90.0, 360.0)));
  return lines::project_along(raw.features, axis);
}

Result<void> lay(lines::Features& raw, const LineOptions& options, LineWork& work, const std::string& file) {
  if (options.trace) {
    work.trace = lines::with_misfit(*options.trace, raw.features);
  } else {
    DOBRA_TRY(work.trace, lines::fit_trace(raw.features));
  }
  const lines::Trace& trace = *work.trace;
  const double length = lines::length_along(trace, raw.features);
  const std::string misfit = fmt::format(
      "the points lie up to {:.4g} m off the plane (root mean square {:.4g} m, "
      "length {:.6g} m)",
      trace.largest_misfit, trace.mean_misfit, length);
  if (!(trace.largest_misfit <= options.plane_tolerance * length)) {
    return Error{ErrorCode::BadFormat,
                 fmt::format("the lines do not stand on one vertical plane: {}; give plane_tolerance "
                             "(--plane-tolerance) to lay them into it all the same, or coordinates = section "
                             "(--coordinates section) if x and y are section coordinates",
                             misfit),
                 Place{.file = file}};
  }
  work.remarks.push_back(
      fmt::format("{}: laid into the vertical plane through ({:.10g}, {:.10g}) that runs towards "
                  "{:.4f} degrees; {}",
                  file, trace.x, trace.y,
                  std::fmod(450.0 - std::atan2(trace.north, trace.east) * 180.0 / std::numbers::pi, 360.0), misfit));
  return lines::lay_into_plane(raw.features, trace);
}

// Heights as the file has them become heights above 0, still in its unit; polygons keep their orientation.
Result<void> turn_up(std::vector<lines::Feature>& features, const LineOptions& options, lines::YDirection direction) {
  const bool down = direction == lines::YDirection::Down;
  if (!down && options.exaggeration == 1.0) return {};
  const auto turned = [&](double y) { return (down ? options.y_reference - y : y) / options.exaggeration; };
  for (std::size_t i = 0; i < features.size(); ++i) {
    lines::Feature& feature = features[i];
    const bool map = !feature.heights.empty();
    std::vector<std::size_t> rings;
    if (map) rings = lines::rings_of(feature);
    for (std::size_t k = 0; k < feature.parts.size(); ++k) {
      geom::Polyline& part = feature.parts[k];
      if (!map) rings.push_back(geom::signed_area(part) > 0.0 ? 0 : 1);
      if (map) std::transform(feature.heights[k].begin(), feature.heights[k].end(), feature.heights[k].begin(), turned);
      if (!map) std::for_each(part.points.begin(), part.points.end(), [&](Point& p) { p.y = turned(p.y); });
    }
    // Points that differed may have become one.
    if (auto normal = lines::normalise(feature, rings); !normal) {
      return base::located(base::located(normal.error(), feature.source),
                           Place{.item = lines::item_of(i + 1, feature)});
    }
  }
  return {};
}

Result<LineWork> finish(lines::Features raw, const std::string& file, const Format& format,
                        const LineOptions& options) {
  LineWork work;
  work.format = &format;
  work.system = std::move(raw.stated.system);
  work.remarks = std::move(raw.remarks);
  if (raw.features.empty()) {
    return Error{ErrorCode::BadFormat, "there is no line, polygon or point in the file", Place{.file = file}};
  }
  lines::set_kinds(raw.features, options.kinds, file, work.remarks);
  if (auto checked = check_options(options); !checked) return base::located(checked.error(), Place{.file = file});
  DOBRA_TRY_VOID(check_answers(raw, options, file));
  const auto about_unit = [](const lines::Question& question) {
    return question.about == lines::Question::About::Unit;
  };
  if (options.unit_wanted == UnitWanted::OfTheFile &&
      std::any_of(raw.stated.questions.begin(), raw.stated.questions.end(), about_unit)) {
    work.remarks.push_back(fmt::format("{}: the unit that it states is not known here, and is not kept", file));
  }
  DOBRA_TRY(const bool map, is_map(raw, options, file));
  if (!map && options.fold_axis) {
    return Error{ErrorCode::BadFormat,
                 "lines without heights cannot be projected along a fold axis; give the three columns x, y and height, "
                 "or leave the axis out",
                 Place{.file = file}};
  }
  if (!map && has_heights(raw)) {
    if (!is_flat(raw)) work.remarks.push_back(fmt::format("{}: third coordinates dropped", file));
    raw.remarks = std::move(work.remarks);
    DOBRA_TRY_VOID(lines::drop_heights(raw, options.faulty));
    work.remarks = std::move(raw.remarks);
  }
  work.y_direction = options.y_direction.value_or(raw.stated.y_direction.value_or(lines::YDirection::Up));
  if (!options.y_direction && work.y_direction == lines::YDirection::Down) {
    work.remarks.push_back(fmt::format("{}: its heights are depths, as the file says", file));
  }
  DOBRA_TRY_VOID(turn_up(raw.features, options, work.y_direction));
  work.stated_unit = raw.stated.unit;
  const bool as_it_is = options.unit_wanted == UnitWanted::OfTheFile;
  work.unit = as_it_is ? 1.0 : options.unit.value_or(raw.stated.unit.value_or(options.silent_unit));
  const double height_unit = as_it_is ? 1.0 : options.unit.value_or(raw.stated.height_unit.value_or(work.unit));
  if (work.unit != 1.0 || height_unit != 1.0) DOBRA_TRY_VOID(to_metres(raw, work.unit, height_unit, file));
  if (options.unit && raw.stated.unit && *options.unit != *raw.stated.unit) {
    work.remarks.push_back(fmt::format("{}: the file says that its unit is {} m; it is taken as {} m, as asked for",
                                       file, *raw.stated.unit, *options.unit));
  }
  if (!options.unit && raw.stated.unit && !as_it_is && (work.unit != 1.0 || options.silent_unit != 1.0)) {
    work.remarks.push_back(fmt::format("{}: its unit is {} m, as the file says", file, work.unit));
  }
  if (map) {
    const auto laid =
        options.fold_axis ? lay_along(raw, *options.fold_axis, work, file) : lay(raw, options, work, file);
    if (!laid) return base::located(laid.error(), Place{.file = file});
  }
  work.features = std::move(raw.features);
  auto repaired = repair(work.features, options.repair);
  if (!repaired) return base::located(repaired.error(), Place{.file = file});
  work.repairs = *std::move(repaired);
  if (work.features.empty()) {
    return Error{ErrorCode::BadFormat, "nothing is left after the repair of slivers; give a smaller width",
                 Place{.file = file}};
  }
  return work;
}

Result<const Format*> chosen_format(const std::string& path, const Format* format) {
  if (format != nullptr) return format;
  return line_format_of(path);
}

}  // namespace

Result<LineWork> parse_any_lines(std::string_view text, const std::string& file, const LineOptions& options) {
  DOBRA_TRY(const Format* const format, chosen_format(file, options.format));
  if (format->lines->parse == nullptr)
    return Error{ErrorCode::InvalidOption, "this format is not text", Place{.file = file}};
  DOBRA_TRY(lines::Features raw, format->lines->parse(text, file, options));
  return finish(std::move(raw), file, *format, options);
}

std::vector<std::string> words_between_commas(const std::string& text) {
  std::vector<std::string> words;
  for (std::size_t begin = 0; !text.empty() && begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    words.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

Result<LineWork> read_any_lines(const std::string& path, const LineOptions& options) {
  DOBRA_TRY_VOID(check_readable(path));
  DOBRA_TRY(const Format* const format, chosen_format(path, options.format));
  if (format->lines->read != nullptr) {
    DOBRA_TRY(lines::Features raw, format->lines->read(path, options));
    return finish(std::move(raw), path, *format, options);
  }
  DOBRA_TRY(const std::string text, read_text(path));
  return parse_any_lines(text, path, options);
}

}  // namespace dobra::io::formats
