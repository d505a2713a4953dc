#include "recon/unfold/target.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "recon/input/items.h"
#include "recon/unfold/pin_line.h"
#include "shared/base/text.h"
#include "shared/geom/place.h"

namespace recon::unfold {

namespace {

/// Places, as arc lengths, where a line has the given x; a vertical piece counts once, at its start.
std::vector<double> arcs_at_x(const geom::Polyline& line, const std::vector<double>& arc, double x) {
  std::vector<double> places;
  for (std::size_t i = 0; i < line.segment_count(); ++i) {
    const geom::Segment segment = line.segment(i);
    const bool last = i + 1 == line.segment_count();
    const double from = segment.from.x;
    const double to = segment.to.x;
    if (from == x) {
      if (i == 0 || line.points[i - 1].x != x) places.push_back(arc[i]);
    } else if ((from < x && x < to) || (to < x && x < from)) {
      places.push_back(arc[i] + (arc[i + 1] - arc[i]) * (x - from) / (to - from));
    } else if (last && to == x) {
      places.push_back(arc[i + 1]);
    }
  }
  return places;
}

struct Pinned {
  geom::Polyline line;
  double pin = 0.0;  ///< Arc length, m.
};

/// Where no pin is given; a remark where that is not the left end.
base::Result<double> place_of_pin(const section::Section& section, const SourceGrid& source,
                                  std::vector<std::string>& remarks) {
  DOBRA_TRY(const DefaultPin pin, default_pin(section, source));
  const std::vector<double> arc = geom::arc_lengths(source.base);
  const double x = geom::point_at(source.base, arc, pin.arc).x;
  if (!pin.off.empty()) {
    std::string names;
    for (const section::HorizonId id : pin.off)
      names += fmt::format("{}'{}'", names.empty() ? "" : ", ", whole_name(*find_horizon(section, id)));
    remarks.push_back(
        fmt::format("no place of the top has all horizons on its pin line; the pin stands at x = {:.6g}, "
                    "where {} of them are not: {}",
                    x, pin.off.size(), names));
  } else if (pin.arc != (source.side == section::LayerSide::Below ? 0.0 : arc.back())) {
    remarks.push_back(
        fmt::format("the pin stands at x = {:.6g}, the leftmost place of the top where all horizons are", x));
  }
  return pin.arc;
}

base::Result<Pinned> pin_on_top(const section::Section& section, const SourceGrid& source, const TargetParams& params,
                                std::vector<std::string>& remarks) {
  const std::vector<double> arc = geom::arc_lengths(source.base);
  // With the layers above, travel is from right to left.
  const bool left_first = source.side == section::LayerSide::Below;
  if (!params.pin) {
    DOBRA_TRY(const double pin, place_of_pin(section, source, remarks));
    return Pinned{source.base, pin};
  }
  const std::vector<double> places = arcs_at_x(source.base, arc, *params.pin);
  if (places.empty()) {
    const geom::Box box = source.base.box();
    return base::Error{base::ErrorCode::BadValue,
                       fmt::format("the pin x = {:.6g} is not on the top; take one from {:.6g} to {:.6g}", *params.pin,
                                   box.low.x, box.high.x),
                       geom::place_at({*params.pin, box.centre().y}, "pin")};
  }
  if (places.size() > 1) {
    remarks.push_back(
        fmt::format("the top passes x = {:.6g} {} times; the pin stands on the leftmost pass along the line",
                    *params.pin, places.size()));
  }
  return Pinned{source.base, left_first ? places.front() : places.back()};
}

base::Result<Pinned> flat_target(const SourceGrid& source, double source_pin, geom::Point pin,
                                 const TargetParams& params) {
  if (!params.points.empty() || !params.file.empty()) {
    return base::Error{base::ErrorCode::BadValue,
                       "points or a file are given for a flat target; set shape = \"line\" or remove them"};
  }
  geom::Point at = params.target_pin.value_or(geom::Point{pin.x, params.elevation.value_or(pin.y)});
  if (params.elevation && at.y != *params.elevation) {
    return base::Error{base::ErrorCode::BadValue, "elevation and target_pin name different heights; keep one of them"};
  }
  const double direction = source.side == section::LayerSide::Below ? 1.0 : -1.0;
  const double length = geom::length(source.base);
  const geom::Point start{at.x - direction * source_pin, at.y};
  return Pinned{{{start, {start.x + direction * length, at.y}}, false}, source_pin};
}

base::Result<double> pin_on_line(const geom::Polyline& line, geom::Point source_pin, bool left_first,
                                 const TargetParams& params, std::vector<std::string>& remarks) {
  const std::vector<double> arc = geom::arc_lengths(line);
  if (!params.target_pin) {
    const std::vector<double> places = arcs_at_x(line, arc, source_pin.x);
    if (!places.empty()) return left_first ? places.front() : places.back();
    return base::Error{
        base::ErrorCode::BadValue,
        fmt::format("the target has no point at the pin's x = {:.6g}; say where the pin goes with target_pin",
                    source_pin.x),
        place_at(source_pin, "pin")};
  }
  double best = std::numeric_limits<double>::infinity();
  double at = 0.0;
  for (std::size_t i = 0; i < line.segment_count(); ++i) {
    const geom::Segment segment = line.segment(i);
    const double distance = geom::distance(segment, *params.target_pin);
    if (distance >= best) continue;
    best = distance;
    at = arc[i] + (arc[i + 1] - arc[i]) * geom::nearest_fraction(segment, *params.target_pin);
  }
  if (best > 1e-9 * arc.back()) {
    remarks.push_back(
        fmt::format("target_pin lies {:.4g} m beside the target; the nearest point of the target was taken", best));
  }
  return at;
}

/// The straight line that fits a horizon best (least squares of z over x), over its range of x.
geom::Polyline regional_of(const geom::Polyline& line) {
  double sum_x = 0.0, sum_z = 0.0;
  const auto count = static_cast<double>(line.points.size());
  for (const geom::Point p : line.points) {
    sum_x += p.x;
    sum_z += p.y;
  }
  const geom::Point centre{sum_x / count, sum_z / count};
  double xx = 0.0, xz = 0.0;
  for (const geom::Point p : line.points) {
    xx += (p.x - centre.x) * (p.x - centre.x);
    xz += (p.x - centre.x) * (p.y - centre.y);
  }
  const double slope = xx > 0.0 ? xz / xx : 0.0;
  const geom::Box box = line.box();
  return {{{box.low.x, centre.y + slope * (box.low.x - centre.x)},
           {box.high.x, centre.y + slope * (box.high.x - centre.x)}},
          false};
}

base::Result<geom::Polyline> horizon_line(const section::Section& section, const SourceGrid& source,
                                          const TargetParams& params) {
  if (params.horizon.empty() && params.shape == TargetShape::Horizon) {
    return base::Error{base::ErrorCode::MissingKey, "a target of shape \"horizon\" needs horizon = \"...\""};
  }
  const section::Horizon* horizon =
      params.horizon.empty() ? find_horizon(section, source.top) : find_horizon(section, params.horizon);
  if (horizon == nullptr) {
    return base::Error{base::ErrorCode::BadSection,
                       fmt::format("there is no horizon '{}' to be the target{}", params.horizon,
                                   base::did_you_mean(params.horizon, horizon_names(section)))};
  }
  return params.shape == TargetShape::Regional ? regional_of(horizon->line) : horizon->line;
}

base::Result<input::ReadLine> datum_line(const section::Section& section, const TargetParams& params) {
  std::vector<std::string> names;
  for (const section::SectionLine& line : section.lines) {
    if (line.kind != section::LineKind::Datum) continue;
    names.push_back(line.name);
    if (params.datum == line.name) return input::ReadLine{line.line, {}};
  }
  if (params.datum.empty() && names.size() == 1) {
    TargetParams named = params;
    named.datum = names.front();
    return datum_line(section, named);
  }
  return base::Error{
      base::ErrorCode::BadSection,
      params.datum.empty()
          ? fmt::format("the section has {} datums; name one with datum = \"...\"", names.size())
          : fmt::format("there is no datum '{}'{}", params.datum, base::did_you_mean(params.datum, names))};
}

base::Result<input::ReadLine> given_line(const section::Section& section, const SourceGrid& source,
                                         const TargetParams& params, const dobra::scenario::Context& context) {
  if (params.shape == TargetShape::Datum) return datum_line(section, params);
  if (params.shape != TargetShape::Line) {
    DOBRA_TRY(geom::Polyline line, horizon_line(section, source, params));
    return input::ReadLine{std::move(line), {}};
  }
  input::HorizonInput input;
  input.name = "target";
  input.file = params.file;
  input.points = params.points;
  input.feature = params.feature;
  // Points in a step are section coordinates already; a file follows the convention of the section's files.
  return read_line(input, {.convention = params.file.empty() ? section::Convention{} : section.convention}, context);
}

base::Result<Pinned> line_target(const section::Section& section, const SourceGrid& source, geom::Point pin,
                                 const TargetParams& params, const dobra::scenario::Context& context,
                                 std::vector<std::string>& remarks) {
  if (params.elevation) {
    return base::Error{base::ErrorCode::BadValue,
                       "elevation belongs to a flat target; use target_pin with other shapes"};
  }
  auto read = given_line(section, source, params, context);
  if (!read) {
    base::Place place;
    place.item = "target";
    base::Error error = read.error();
    if (error.place) error.place->item = "target";
    return base::located(error, place);
  }
  for (const std::string& remark : read->remarks) remarks.push_back("target: " + remark);
  geom::Polyline line = std::move(read->line);
  if (params.direction == TargetDirection::LeftToRight && line.points.front().x > line.points.back().x) {
    line = geom::reversed(std::move(line));
  }
  const bool left_first = source.side == section::LayerSide::Below;
  if (!left_first) line = geom::reversed(std::move(line));
  DOBRA_TRY(const double at, pin_on_line(line, pin, left_first, params, remarks));
  return Pinned{std::move(line), at};
}

}  // namespace

base::Result<Target> place_target(const section::Section& section, const SourceGrid& source, const TargetParams& params,
                                  const dobra::scenario::Context& context) {
  Target target;
  target.params = params;
  DOBRA_TRY(const Pinned top, pin_on_top(section, source, params, target.remarks));
  const std::vector<double> top_arc = geom::arc_lengths(top.line);
  target.source_pin = geom::point_at(top.line, top_arc, top.pin);
  if (const double askew = askew_at(top.line, top_arc, top.pin); askew > askew_tolerance) {
    target.remarks.push_back(
        fmt::format("the top at the pin {} dips {:.3g} degrees off its dip on both sides, and what the pin holds "
                    "upright below it is tilted by that; mend the line there, or take another pin",
                    target.source_pin, askew * 180.0 / std::numbers::pi));
  }
  const bool flat = params.shape == TargetShape::Flat;
  DOBRA_TRY(const Pinned goal, flat ? flat_target(source, top.pin, target.source_pin, params)
                                    : line_target(section, source, target.source_pin, params, context, target.remarks));
  const std::vector<double> goal_arc = geom::arc_lengths(goal.line);
  if (!flat && input::seems_of_another_unit(goal.line.box(), source.base.box())) {
    return base::Error{
        base::ErrorCode::BadValue,
        fmt::format("the target is {:.6g} m long and the top {:.6g} m: metres and kilometres seem to be mixed; bring "
                    "them to one unit",
                    goal_arc.back(), top_arc.back()),
        place_at(goal.line.points.front(), "target")};
  }
  target.target_pin = geom::point_at(goal.line, goal_arc, goal.pin);
  target.source_arc = top.pin;
  target.line = goal.line;
  target.target_arc = goal.pin;

  const double missing_before = std::max(0.0, top.pin - goal.pin);
  const double missing_after = std::max(0.0, (top_arc.back() - top.pin) - (goal_arc.back() - goal.pin));
  target.extended = missing_before + missing_after;
  if (target.extended > 1e-9 * top_arc.back()) {
    target.remarks.push_back(
        fmt::format("the target is shorter than the top: it was continued straight by {:.6g} m at its start and {:.6g} "
                    "m at its end",
                    missing_before, missing_after));
  }
  auto map = maps::match_by_length(top.line, top.pin, goal.line, goal.pin);
  if (!map) {
    base::Place place;
    place.item = "target";
    return base::located(map.error(), place);
  }
  target.map = std::move(*map);
  return target;
}

base::Result<Target> make_target(const section::Section& section, const SourceGrid& source, const TargetParams& params,
                                 const dobra::scenario::Context& context, const base::Progress& progress) {
  DOBRA_TRY(Target target, place_target(section, source, params, context));
  DOBRA_TRY(target.grid, make_grid(target.map.target().base_line(), target.map.target(), source.options, progress));
  return target;
}

}  // namespace recon::unfold
