#include "recon/unfold/methods.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "recon/unfold/bed_order.h"
#include "recon/unfold/stack.h"
#include "shared/base/parallel.h"

namespace recon::unfold {

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
base::Result<maps::Columns> target_on_the_way(const Target& target, double part) {
  const std::vector<geom::Point> from = target.map.source().base_line().points;
  const std::vector<geom::Point> to = target.map.target().base_line().points;
  return maps::Columns::along({bent_between(from, to, nearest_index(from, target.source_pin), part), false});
}

base::Result<maps::SectionMap> column_map(const SourceGrid& source, const Target& target, const MethodParams& params) {
  const maps::ColumnLaw law = params.method == RestoreMethod::Variable   ? maps::ColumnLaw::Area
                              : params.method == RestoreMethod::Flexural ? maps::ColumnLaw::Slip
                                                                         : maps::ColumnLaw::Thickness;
  const double part = params.percent / 100.0;
  if (part == 1.0) {
    if (law == maps::ColumnLaw::Thickness) return maps::SectionMap(target.map);
    DOBRA_TRY(maps::ColumnMap map,
              match_by_length(source.base, target.source_arc, target.line, target.target_arc, {}, law));
    return maps::SectionMap(std::move(map));
  }
  DOBRA_TRY(maps::Columns goal, target_on_the_way(target, part));
  if (law != maps::ColumnLaw::Slip)
    return maps::SectionMap(maps::ColumnMap(target.map.source(), std::move(goal), {}, law));
  // The matched columns cover the source from its first point, so the pin has the same arc length on both.
  return maps::SectionMap(
      maps::ColumnMap::slip(target.map.source(), target.source_arc, std::move(goal), target.source_arc));
}

base::Result<MethodMap> shear_map(const SourceGrid& source, const Target& target, const MethodParams& params) {
  // The pin slides along the direction of shear to the target, unless it is told where to go.
  const geom::Point goal = target.params.target_pin ? target.target_pin : target.source_pin;
  DOBRA_TRY(maps::ShearMap map,
            maps::ShearMap::make(source.base, target.line, params.shear_angle, target.source_pin, goal));
  MethodMap made;
  made.map = maps::SectionMap(params.percent < 100.0 ? map.part(params.percent / 100.0) : std::move(map));
  return made;
}

}  // namespace

std::vector<section::HorizonId> horizons_in_order(const section::Section& section, const SourceGrid& source,
                                                  const Target& target) {
  const maps::Columns& columns = target.map.source();
  const auto beds = base::parallel_map<NamedBed>(section.horizons.size(), [&](std::size_t i) {
    const section::Horizon& horizon = section.horizons[i];
    NamedBed bed{horizon.id, {}};
    maps::ColumnId hint;
    for (const geom::Point p : horizon.line.points) {
      if (horizon.id == source.top) break;  // whatever the grid's simplification has done to it
      bed.names.push_back(columns.locate(p, target.map.tolerances().side, hint).at);
      hint = bed.names.back().column;
    }
    return bed;
  });
  return in_order(beds, columns);
}

std::vector<maps::MappedLine> map_horizons(MethodMap& method, const section::Section& section,
                                           const maps::ColumnMap& grid, const base::Progress& progress) {
  return base::parallel_map<maps::MappedLine>(section.horizons.size(), [&](std::size_t i) {
    if (progress.cancelled()) return maps::MappedLine{};
    const section::Horizon& horizon = section.horizons[i];
    const auto known = std::find_if(method.lines.begin(), method.lines.end(),
                                    [&](const auto& line) { return line.first == horizon.id; });
    maps::MappedLine mapped = known != method.lines.end() ? std::move(known->second) : method.map.forward(horizon.line);
    const bool named = known != method.lines.end() ? !mapped.names.empty() : method.map.columns() != nullptr;
    if (named) return mapped;
    mapped.names.resize(mapped.before.points.size());
    maps::ColumnId hint;
    for (std::size_t k = 0; k < mapped.names.size(); ++k) {
      mapped.names[k] = grid.source().locate(mapped.before.points[k], grid.tolerances().side, hint).at;
      hint = mapped.names[k].column;
    }
    return mapped;
  });
}

base::Result<MethodMap> make_method_map(const section::Section& section, const SourceGrid& source, const Target& target,
                                        const MethodParams& params) {
  const bool along_horizons =
      params.method == RestoreMethod::Flexural && params.beds == SlipBeds::Horizons && section.horizons.size() > 1;
  if (along_horizons || params.method == RestoreMethod::Proportional || params.method == RestoreMethod::LineLength) {
    std::optional<maps::Columns> on_the_way;
    if (along_horizons && params.percent < 100.0) {
      DOBRA_TRY(on_the_way, target_on_the_way(target, params.percent / 100.0));
    }
    DOBRA_TRY(MethodMap made, make_stack_map(section, source, target, params, std::move(on_the_way)));
    if (along_horizons) {
      DOBRA_TRY(made.ends, column_map(source, target, params));
    }
    return made;
  }
  if (params.method == RestoreMethod::Shear) return shear_map(source, target, params);
  DOBRA_TRY(maps::SectionMap map, column_map(source, target, params));
  MethodMap made;
  made.map = std::move(map);
  return made;
}

}  // namespace recon::unfold
