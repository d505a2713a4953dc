#include "recon/core/methods.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "shared/base/text.h"
#include "shared/geom/intersect.h"

namespace recon::core {

const char* method_name(RestoreMethod method) {
  switch (method) {
    case RestoreMethod::Variable:
      return "variable";
    case RestoreMethod::Proportional:
      return "proportional";
    case RestoreMethod::Flexural:
      return "flexural";
    case RestoreMethod::Shear:
      return "shear";
    case RestoreMethod::LineLength:
      return "line_length";
    case RestoreMethod::Constant:
      break;
  }
  return "constant";
}

std::string what_it_keeps(RestoreMethod method) {
  switch (method) {
    case RestoreMethod::Variable:
      return "variable thickness keeps the length of the top and the area between the top and every parallel of it; "
             "thickness and the length of deeper beds change";
    case RestoreMethod::Proportional:
      return "proportional thickness keeps the length of the top and the part that every layer has of the thickness "
             "between "
             "top and base; thickness, and the length of other beds, change";
    case RestoreMethod::Flexural:
      return "flexural slip keeps the length of every bed and the depth of its points below the top, and areas where "
             "beds are parallel; the loose line leans by what the dips sum to";
    case RestoreMethod::Shear:
      return "simple shear keeps areas, and distances along the direction of shear; bed lengths and the thickness "
             "across "
             "the beds change";
    case RestoreMethod::LineLength:
      return "line-length unfolding keeps the length of every horizon and its depth at the pin; the areas between them "
             "change where thickness does";
    case RestoreMethod::Constant:
      break;
  }
  return "constant thickness keeps the length of the top and the depth of every point; area and the length of deeper "
         "beds "
         "change";
}

std::vector<geom::Point> bent_between(const std::vector<geom::Point>& from, const std::vector<geom::Point>& to,
                                      std::size_t fixed, double part) {
  DOBRA_CHECK(from.size() == to.size() && from.size() >= 2 && fixed < from.size());
  const std::size_t count = from.size() - 1;
  const auto wrapped = [](double angle) { return std::remainder(angle, 2.0 * std::numbers::pi); };
  const auto direction = [](const std::vector<geom::Point>& line, std::size_t i) {
    const geom::Vector v = line[i + 1] - line[i];
    return std::atan2(v.y, v.x);
  };
  // How far each segment turns: the least angle at the fixed point, and from there on without jumps.
  std::vector<double> turn(count);
  const std::size_t start = std::min(fixed, count - 1);
  turn[start] = wrapped(direction(to, start) - direction(from, start));
  const auto follow = [&](std::size_t i, std::size_t before) {
    turn[i] = turn[before] + wrapped(direction(to, i) - direction(from, i) - turn[before]);
  };
  for (std::size_t i = start + 1; i < count; ++i) follow(i, i - 1);
  for (std::size_t i = start; i-- > 0;) follow(i, i + 1);
  const auto step = [&](std::size_t i) {
    const double length = (1.0 - part) * geom::distance(from[i], from[i + 1]) + part * geom::distance(to[i], to[i + 1]);
    const double angle = direction(from, i) + part * turn[i];
    return length * geom::Vector{std::cos(angle), std::sin(angle)};
  };
  std::vector<geom::Point> line(count + 1);
  line[fixed] = geom::interpolate(from[fixed], to[fixed], part);
  for (std::size_t i = fixed; i < count; ++i) line[i + 1] = line[i] + step(i);
  for (std::size_t i = fixed; i-- > 0;) line[i] = line[i + 1] + -step(i);
  return line;
}

namespace {

std::size_t nearest_index(const std::vector<geom::Point>& points, geom::Point p) {
  const auto nearer = [&](geom::Point a, geom::Point b) { return geom::distance(a, p) < geom::distance(b, p); };
  return static_cast<std::size_t>(std::min_element(points.begin(), points.end(), nearer) - points.begin());
}

/// The target line on the way: that of the matched columns, each turned by its part.
base::Result<Columns> target_on_the_way(const Target& target, double part) {
  const std::vector<geom::Point> from = target.map.source().base_line().points;
  const std::vector<geom::Point> to = target.map.target().base_line().points;
  return Columns::along({bent_between(from, to, nearest_index(from, target.source_pin), part), false});
}

base::Result<SectionMap> column_map(const SourceGrid& source, const Target& target, const MethodParams& params) {
  const ColumnLaw law = params.method == RestoreMethod::Variable   ? ColumnLaw::Area
                        : params.method == RestoreMethod::Flexural ? ColumnLaw::Slip
                                                                   : ColumnLaw::Thickness;
  const double part = params.percent / 100.0;
  if (part == 1.0) {
    if (law == ColumnLaw::Thickness) return SectionMap(target.map);
    DOBRA_TRY(ColumnMap map, match_by_length(source.base, target.source_arc, target.line, target.target_arc, {}, law));
    return SectionMap(std::move(map));
  }
  DOBRA_TRY(Columns goal, target_on_the_way(target, part));
  if (law != ColumnLaw::Slip) return SectionMap(ColumnMap(target.map.source(), std::move(goal), {}, law));
  // The matched columns cover the source from its first point, so the pin has the same arc length on both.
  return SectionMap(ColumnMap::slip(target.map.source(), target.source_arc, std::move(goal), target.source_arc));
}

/// Where along `line` the pin line (the normal of the top at the pin) meets it; of several places the nearest to the
/// pin.
std::optional<double> pin_on(const geom::Polyline& line, const std::vector<double>& arc, geom::Point pin,
                             geom::Vector normal, double reach) {
  const geom::Segment pin_line{pin + -reach * normal, pin + reach * normal};
  std::optional<double> best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < line.segment_count(); ++i) {
    const geom::Intersection meeting = geom::intersect(line.segment(i), pin_line);
    if (meeting.kind == geom::IntersectionKind::None) continue;
    const double distance = geom::distance(meeting.start.point, pin);
    if (distance >= least) continue;
    least = distance;
    best = arc[i] + geom::distance(line.points[i], meeting.start.point);
  }
  return best;
}

/// One line of a stack: travelling like the base, with the place of the pin on it.
struct StackLine {
  std::string name;
  geom::Polyline line;
  std::vector<double> arc;
  HorizonId id;
  double pin = 0.0;            ///< Arc length, m.
  double depth = 0.0;          ///< Of its pin below that of the base, m.
  std::vector<double> depths;  ///< Flexural: of every vertex below the top.
};

/// The line with a vertex at the pin.
void insert_pin(StackLine& line) {
  const auto after = std::lower_bound(line.arc.begin(), line.arc.end(), line.pin);
  if (after == line.arc.end() || *after == line.pin) {
    if (after == line.arc.end()) line.pin = line.arc.back();
    return;
  }
  const auto i = after - line.arc.begin();
  line.line.points.insert(line.line.points.begin() + i, geom::point_at(line.line, line.arc, line.pin));
  line.arc.insert(line.arc.begin() + i, line.pin);
}

/// Gives the line a vertex wherever it crosses a rung of the top, and every vertex its depth.
void measure_depths(StackLine& line, const ColumnMap& grid) {
  insert_pin(line);
  const MappedLine traced = grid.map(line.line);
  line.line.points.clear();
  line.depths.clear();
  for (std::size_t i = 0; i < traced.before.points.size(); ++i) {
    const geom::Point p = traced.before.points[i];
    if (!line.line.points.empty() && line.line.points.back() == p) continue;
    line.line.points.push_back(p);
    line.depths.push_back(traced.names[i].depth);
  }
  line.arc = geom::arc_lengths(line.line);
  // The vertices that were added have moved the pin's arc length by rounding.
  const auto nearer = [&](double a, double b) { return std::abs(a - line.pin) < std::abs(b - line.pin); };
  line.pin = *std::min_element(line.arc.begin(), line.arc.end(), nearer);
}

/// The pin at an end of the base pins the ends of all lines; elsewhere the pin line must meet them.
enum class PinAt { Start, End, Inside };

PinAt pin_at(const SourceGrid& source, double arc) {
  const double length = geom::length(source.base);
  if (arc <= 1e-9 * length) return PinAt::Start;
  return arc >= (1.0 - 1e-9) * length ? PinAt::End : PinAt::Inside;
}

base::Result<StackLine> stack_line(const Horizon& horizon, const SourceGrid& source, const Target& target) {
  StackLine line;
  line.name = horizon.name;
  line.id = horizon.id;
  line.line = horizon.id == source.top          ? source.base
              : source.side == LayerSide::Above ? geom::reversed(horizon.line)
                                                : horizon.line;
  line.arc = geom::arc_lengths(line.line);
  const Columns& columns = target.map.source();
  const ColumnPoint at = target.map.locate(target.source_pin).at;
  const std::size_t column = std::clamp<std::size_t>(at.column.index(), 1, columns.inner_count());
  geom::Vector normal = geom::right_of(columns.frame(ColumnId(column)).tangent);
  // At a corner the pin line is its rung, as in ColumnMap::slip.
  for (const std::size_t rung : {column - 1, column}) {
    if (geom::distance(columns.foot(rung), target.source_pin) <= target.map.tolerances().tear)
      normal = geom::normalised(columns.rung_vector(rung));
  }
  const PinAt where = pin_at(source, target.source_arc);
  if (horizon.id == source.top) {
    line.pin = target.source_arc;
  } else if (where != PinAt::Inside) {
    line.pin = where == PinAt::Start ? 0.0 : line.arc.back();
  } else {
    const double reach = 4.0 * (source.base.box().diagonal() + line.line.box().diagonal());
    const std::optional<double> pin = pin_on(line.line, line.arc, target.source_pin, normal, reach);
    if (!pin || *pin <= 0.0 || *pin >= line.arc.back()) {
      return base::Error{base::ErrorCode::CannotRestore,
                         fmt::format("the pin line does not meet horizon '{}'; move the pin", horizon.name),
                         place_at(target.source_pin, "pin")};
    }
    line.pin = *pin;
  }
  line.depth = geom::dot(geom::point_at(line.line, line.arc, line.pin) - target.source_pin, normal);
  return line;
}

/// Arc length to the common place u: -1 .. 0 before the pin, 0 .. 1 after it (one of the two where the pin is at an
/// end).
double place_of(const StackLine& line, double arc) {
  if (arc == line.pin) return 0.0;
  return arc < line.pin ? (arc - line.pin) / line.pin : (arc - line.pin) / (line.arc.back() - line.pin);
}
double arc_of(const StackLine& line, double u) {
  return line.pin + u * (u < 0.0 ? line.pin : line.arc.back() - line.pin);
}

/// Places of the corners of a line and, as arc lengths on it, of further ones.
std::vector<double> places_of(const StackLine& line, std::vector<double> further) {
  further.insert(further.end(), line.arc.begin(), line.arc.end());
  further.push_back(line.pin);
  std::vector<double> places;
  for (const double arc : further) {
    if (arc >= 0.0 && arc <= line.arc.back()) places.push_back(place_of(line, arc));
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

class StackBuilder {
 public:
  StackBuilder(const SourceGrid& source, const Target& target, const MethodParams& params)
      : source_(source), target_(target), params_(params) {}

  base::Result<MethodMap> run(std::vector<StackLine> lines) {
    const bool flexural = params_.method == RestoreMethod::Flexural;
    if (flexural && params_.percent < 100.0) {
      DOBRA_TRY(Columns on_the_way, target_on_the_way(target_, params_.percent / 100.0));
      goal_ = ColumnMap::slip(target_.map.source(), target_.source_arc, std::move(on_the_way), target_.source_arc);
    } else {
      DOBRA_TRY(goal_, match_by_length(source_.base, target_.source_arc, target_.line, target_.target_arc, {},
                                       ColumnLaw::Slip));
    }
    if (params_.method == RestoreMethod::Proportional) thickness_ = params_.thickness.value_or(mean_thickness(lines));
    MethodMap made;
    std::vector<RuledLine> ruled;
    for (StackLine& line : lines) {
      const geom::Polyline given = line.line;
      if (flexural) {
        measure_depths(line, target_.map);
        ruled.push_back(laid_line(line));
      } else {
        ruled.push_back(ruled_line(line, line.id == lines.front().id));
      }
      // A simplified base is not the top itself, which then goes through the map.
      const bool is_horizon = line.id != source_.top || source_.params.simplify == 0.0;
      if (params_.method != RestoreMethod::Proportional && is_horizon)
        made.lines.emplace_back(line.id, mapped_line(given, ruled.back()));
    }
    const RuledMap map(ruled);
    if (const auto folded = map.folded()) {
      const std::string message = "the rulings between the horizons cross here, so that the map is not single-valued";
      if (params_.doubt == Doubt::Refuse) {
        return base::Error{base::ErrorCode::CannotRestore, message + "; move the pin, or use another method",
                           place_at(*folded)};
      }
      made.remarks.push_back(
          fmt::format("{} ({:.6g}, {:.6g}); points there go with the nearest bed", message, folded->x, folded->y));
    }
    made.map = SectionMap(map);
    return made;
  }

 private:
  /// Of the layers if their area stays and the top keeps its length.
  static double mean_thickness(const std::vector<StackLine>& lines) {
    const geom::Polyline contour = contour_between(lines.front().line, lines.back().line);
    return std::abs(geom::signed_area(contour)) / lines.front().arc.back();
  }

  /// The line laid out from the pin to both sides, every piece as long as it is and at its depth.
  RuledLine laid_line(const StackLine& line) const {
    const std::size_t count = line.line.points.size();
    const auto pin =
        static_cast<std::size_t>(std::lower_bound(line.arc.begin(), line.arc.end(), line.pin) - line.arc.begin());
    std::vector<std::pair<double, geom::Point>> laid;  // arc length and image
    for (const double travel : {-1.0, 1.0}) {
      std::vector<double> lengths;
      std::vector<double> depths;
      std::vector<double> arcs{line.arc[pin]};
      for (std::size_t i = pin; travel > 0.0 ? i + 1 < count : i > 0; travel > 0.0 ? ++i : --i) {
        const std::size_t next = travel > 0.0 ? i + 1 : i - 1;
        lengths.push_back(std::abs(line.arc[next] - line.arc[i]));
        depths.push_back(line.depths[next]);
        arcs.push_back(line.arc[next]);
      }
      const ColumnMap::LaidLine side = goal_.lay(line.depths[pin], lengths, depths, travel);
      for (std::size_t i = travel > 0.0 ? 0 : 1; i < side.points.size(); ++i)
        laid.emplace_back(arcs[i], side.points[i]);
      for (std::size_t i = 0; i < side.bends.size(); ++i) {
        const auto piece = std::min(static_cast<std::size_t>(side.bends[i]), lengths.size() - 1);
        const double part = side.bends[i] - static_cast<double>(piece);
        laid.emplace_back((1.0 - part) * arcs[piece] + part * arcs[piece + 1], side.bend_points[i]);
      }
    }
    std::stable_sort(laid.begin(), laid.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    RuledLine ruled;
    for (const auto& [arc, image] : laid) {
      const double u = place_of(line, arc);
      if (!ruled.u.empty() && u <= ruled.u.back()) continue;
      ruled.u.push_back(u);
      const auto vertex = std::lower_bound(line.arc.begin(), line.arc.end(), arc);
      const bool given = vertex != line.arc.end() && *vertex == arc;
      ruled.from.push_back(given ? line.line.points[static_cast<std::size_t>(vertex - line.arc.begin())]
                                 : geom::point_at(line.line, line.arc, arc));
      ruled.to.push_back(image);
    }
    return ruled;
  }

  /// As Tracer would give it; the vertices of `given` are found again among those of the ruled line.
  MappedLine mapped_line(const geom::Polyline& given, const RuledLine& ruled) const {
    MappedLine mapped;
    mapped.before.points = ruled.from;
    mapped.after.points = ruled.to;
    std::size_t next = 0;
    for (std::size_t i = 0; i < ruled.from.size() && next < given.points.size(); ++i) {
      if (geom::distance(ruled.from[i], given.points[next]) > goal_.tolerances().tear) continue;
      mapped.given.push_back(i);
      ++next;
    }
    if (source_.side == LayerSide::Above) {  // horizons run from left to right
      const std::size_t last = ruled.from.size() - 1;
      for (geom::Polyline* line : {&mapped.before, &mapped.after}) *line = geom::reversed(std::move(*line));
      std::reverse(mapped.given.begin(), mapped.given.end());
      for (std::size_t& i : mapped.given) i = last - i;
    }
    return mapped;
  }

  RuledLine ruled_line(const StackLine& line, bool is_first) {
    const bool stretched = params_.method == RestoreMethod::Proportional && !is_first;
    const double depth = params_.method == RestoreMethod::Proportional ? (is_first ? 0.0 : thickness_) : line.depth;
    std::vector<double> further;
    for (const double bed : goal_.target_corners(stretched ? 0.0 : depth)) further.push_back(line.pin + bed);
    RuledLine ruled;
    ruled.u = places_of(line, std::move(further));
    for (const double u : ruled.u) {
      ruled.from.push_back(geom::point_at(line.line, line.arc, arc_of(line, u)));
      ruled.to.push_back(stretched ? below_top(u, depth) : goal_.target_point(arc_of(line, u) - line.pin, depth));
    }
    if (params_.percent < 100.0) {
      const auto pin =
          static_cast<std::size_t>(std::lower_bound(ruled.u.begin(), ruled.u.end(), 0.0) - ruled.u.begin());
      ruled.to = bent_between(ruled.from, ruled.to, std::min(pin, ruled.u.size() - 1), params_.percent / 100.0);
    }
    return ruled;
  }

  /// At the same place as u on the top, at a depth along the normal of the target.
  [[nodiscard]] geom::Point below_top(double u, double depth) const {
    const double length = geom::length(source_.base);
    const double pin = target_.source_arc;
    const double bed = u * (u < 0.0 ? pin : length - pin);
    const geom::Point foot = goal_.target_point(bed, 0.0);
    ColumnPoint name = goal_.target().locate(foot, goal_.tolerances().side).at;
    name.depth = depth;
    return goal_.target().point(name);
  }

  const SourceGrid& source_;
  const Target& target_;
  const MethodParams& params_;
  ColumnMap goal_;  ///< Slip: beds of the target by their distance from the pin.
  double thickness_ = 0.0;
};

base::Result<MethodMap> stack_map(const Section& section, const SourceGrid& source, const Target& target,
                                  const MethodParams& params) {
  std::vector<HorizonId> order = horizons_in_order(section, source, target);
  if (order.size() < 2) {
    return base::Error{base::ErrorCode::BadSection,
                       fmt::format("method \"{}\" needs two horizons", method_name(params.method))};
  }
  if (params.method == RestoreMethod::Proportional) {
    const Horizon* base_horizon =
        params.base.empty() ? find_horizon(section, order.back()) : find_horizon(section, params.base);
    if (base_horizon == nullptr || base_horizon->id == source.top) {
      return base::Error{base::ErrorCode::BadSection,
                         base_horizon == nullptr ? fmt::format("there is no horizon '{}' to be the base{}", params.base,
                                                               base::did_you_mean(params.base, horizon_names(section)))
                                                 : "the base must be another horizon than the top"};
    }
    order = {source.top, base_horizon->id};
  }
  std::vector<StackLine> lines;
  for (const HorizonId id : order) {
    DOBRA_TRY(StackLine line, stack_line(*find_horizon(section, id), source, target));
    lines.push_back(std::move(line));
  }
  return StackBuilder(source, target, params).run(std::move(lines));
}

base::Result<MethodMap> shear_map(const SourceGrid& source, const Target& target, const MethodParams& params) {
  MethodMap made;
  auto map = ShearMap::make(source.base, target.line, params.shear_angle, params.doubt, made.remarks);
  if (!map) return base::located(map.error(), base::Place{.item = "shear"});
  made.map = SectionMap(params.percent < 100.0 ? map->part(params.percent / 100.0) : std::move(*map));
  return made;
}

}  // namespace

std::vector<HorizonId> horizons_in_order(const Section& section, const SourceGrid& source, const Target& target) {
  std::vector<std::pair<double, HorizonId>> depths;
  const Columns& columns = target.map.source();
  for (const Horizon& horizon : section.horizons) {
    // The top is exactly at depth 0, whatever the grid's simplification has done to it.
    double sum = 0.0;
    ColumnId hint;
    if (horizon.id != source.top) {
      for (const geom::Point p : horizon.line.points) {
        const Located at = columns.locate(p, target.map.tolerances().side, hint);
        hint = at.at.column;
        sum += at.at.depth;
      }
    }
    depths.emplace_back(sum / static_cast<double>(horizon.line.points.size()), horizon.id);
  }
  std::stable_sort(depths.begin(), depths.end());
  std::vector<HorizonId> order;
  for (const auto& [depth, id] : depths) order.push_back(id);
  return order;
}

MappedLine map_horizon(const MethodMap& method, const Horizon& horizon, const ColumnMap& grid) {
  const auto known = std::find_if(method.lines.begin(), method.lines.end(),
                                  [&](const auto& line) { return line.first == horizon.id; });
  MappedLine mapped = known != method.lines.end() ? known->second : method.map.forward(horizon.line);
  if (method.map.columns() != nullptr) return mapped;
  mapped.names.resize(mapped.before.points.size());
  ColumnId hint;
  for (std::size_t i = 0; i < mapped.names.size(); ++i) {
    mapped.names[i] = grid.source().locate(mapped.before.points[i], grid.tolerances().side, hint).at;
    hint = mapped.names[i].column;
  }
  return mapped;
}

base::Result<MethodMap> make_method_map(const Section& section, const SourceGrid& source, const Target& target,
                                        const MethodParams& params) {
  switch (params.method) {
    case RestoreMethod::Shear:
      return shear_map(source, target, params);
    case RestoreMethod::Proportional:
    case RestoreMethod::LineLength:
      return stack_map(section, source, target, params);
    case RestoreMethod::Flexural:
      if (params.beds == SlipBeds::Horizons && section.horizons.size() > 1)
        return stack_map(section, source, target, params);
      break;
    case RestoreMethod::Constant:
    case RestoreMethod::Variable:
      break;
  }
  DOBRA_TRY(SectionMap map, column_map(source, target, params));
  return MethodMap{std::move(map), {}, {}};
}

}  // namespace recon::core
