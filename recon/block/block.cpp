#include "recon/block/block.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "recon/block/counts.h"
#include "recon/block/unit_map.h"
#include "shared/solid/dyadic.h"
#include "shared/solid/measure.h"

// 1. The section's faces are given to units. 2. The contours of every unit's parts are its faces across strike, each of
// their segments a face along it. Neighbours have the same segments, so they have the same faces. 3. Lines and points
// of the section are carried along beside: they say how a cut is to be named and drawn.

namespace recon::block {
namespace {

using base::Error;
using base::ErrorCode;
using dobra::solid::Dyadic;
using dobra::solid::shape::Shape;
using geom::Point;
using geom::Point3;
using topo::HalfEdgeId;

/// Contours with the name of the segment that leaves each point.
struct Contour {
  std::vector<Point> points;
  std::vector<std::string> names;
};

Contour contour_of(const UnitMap& map, const std::vector<HalfEdgeId>& loop) {
  Contour contour;
  for (const HalfEdgeId h : loop) {
    map.arrangement.append(h, contour.points);
    contour.names.resize(contour.points.size(), map.edge_names[topo::Structure::edge(h).index()]);
  }
  return contour;
}

/// Twice the area, exactly.
Dyadic twice_area(const std::vector<Point>& points) {
  Dyadic sum;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point p = points[i];
    const Point q = points[(i + 1) % points.size()];
    sum += Dyadic(p.x) * Dyadic(q.y) - Dyadic(p.y) * Dyadic(q.x);
  }
  return sum;
}

/// Adds the faces of one part from y = 0 to y = length.
void add_part(const std::vector<Contour>& contours, double length, Shape& shape) {
  std::vector<std::vector<std::uint32_t>> start;
  std::vector<std::vector<std::uint32_t>> end;
  const auto add_point = [&](Point3 p) {
    shape.mesh.points.push_back(p);
    return static_cast<std::uint32_t>(shape.mesh.points.size() - 1);
  };
  for (const Contour& contour : contours) {
    auto& near = start.emplace_back();
    auto& far = end.emplace_back();
    for (const Point p : contour.points) {
      near.push_back(add_point({p.x, 0.0, p.y}));
      far.push_back(add_point({p.x, length, p.y}));
    }
    for (std::size_t i = 0; i < near.size(); ++i) {
      const std::size_t j = (i + 1) % near.size();
      shape.mesh.faces.push_back({{near[i], far[i], far[j], near[j]}});
      shape.names.push_back(contour.names[i]);
    }
  }
  shape.mesh.faces.push_back(start);
  shape.names.emplace_back("start");
  for (auto& loop : end) std::reverse(loop.begin(), loop.end());
  shape.mesh.faces.push_back(end);
  shape.names.emplace_back("end");
}

/// Parts as one shape, with their area.
Shape extruded(const UnitMap& map, const std::vector<PartLoops>& parts, double length, Dyadic& twice) {
  Shape shape;
  for (const PartLoops& part : parts) {
    std::vector<Contour> contours;
    for (const auto& loop : part) {
      contours.push_back(contour_of(map, loop));
      twice += twice_area(contours.back().points);
    }
    add_part(contours, length, shape);
  }
  return shape;
}

base::Result<dobra::solid::Solid> bounded_by(const Shape& shape, const std::string& unit) {
  auto solid = dobra::solid::shape::solid_of(shape);
  if (!solid) return base::located(solid.error(), {.item = fmt::format("unit '{}'", unit)});
  return solid;
}

Sheet sheet_of(Origin origin, std::size_t index, const geom::Polyline& line, double length) {
  Sheet sheet{origin, index, line.closed, std::vector<std::vector<Point3>>(2)};
  for (const Point p : line.points) {
    sheet.stations[0].push_back({p.x, 0.0, p.y});
    sheet.stations[1].push_back({p.x, length, p.y});
  }
  return sheet;
}

void carry_lines(const section::Section& section, double length, Block& block) {
  const auto add = [&](Origin origin, std::size_t index, const geom::Polyline& line) {
    block.sheets.push_back(sheet_of(origin, index, line, length));
  };
  for (std::size_t i = 0; i < section.horizons.size(); ++i) add(Origin::Horizon, i, section.horizons[i].line);
  for (std::size_t i = 0; i < section.lines.size(); ++i) add(Origin::Line, i, section.lines[i].line);
  for (std::size_t i = 0; i < section.units.size(); ++i) add(Origin::Unit, i, section.units[i].contour);
  if (section.border) add(Origin::Border, 0, *section.border);
  const auto carry = [&](Origin origin, std::size_t index, Point p) {
    block.rails.push_back({origin, index, {p.x, 0.0, p.y}, {p.x, length, p.y}});
  };
  for (std::size_t i = 0; i < section.markers.size(); ++i) {
    for (const Point p : section.markers[i].points) carry(Origin::Marker, i, p);
  }
  for (std::size_t i = 0; i < section.block_names.size(); ++i) carry(Origin::BlockName, i, section.block_names[i].at);
}

}  // namespace

base::Result<Block> extrude(const section::Section& section, const BlockOptions& options) {
  const double length = options.along_strike;
  if (!(length > 0.0) || !std::isfinite(length)) {
    return Error{ErrorCode::InvalidOption, fmt::format("the length along strike is {}; give one above 0 m", length)};
  }
  DOBRA_TRY(UnitMap map, unit_map(section));
  Block block;
  block.section = section;
  block.trace = options.trace.value_or(dobra::io::lines::Trace{});
  block.placed = options.trace.has_value();
  block.length = length;
  block.findings = std::move(map.findings);
  std::vector<dobra::solid::Solid> solids;
  for (std::size_t u = 0; u < map.units.size(); ++u) {
    const std::vector<PartLoops> parts = parts_of(map, u);
    if (parts.empty()) continue;
    BlockUnit unit;
    unit.name = map.units[u];
    unit.parts = parts.size();
    Dyadic twice;
    unit.shape = extruded(map, parts, length, twice);
    unit.area = 0.5 * dobra::solid::rounded(twice);
    DOBRA_TRY(unit.solid, bounded_by(unit.shape, unit.name));
    unit.volume = dobra::solid::volume(unit.solid);
    solids.push_back(unit.solid);
    block.units.push_back(std::move(unit));
  }
  Dyadic twice;
  const Shape whole = extruded(map, parts_of_all(map), length, twice);
  block.area = 0.5 * dobra::solid::rounded(twice);
  DOBRA_TRY(const dobra::solid::Solid all, bounded_by(whole, "whole block"));
  block.volume = dobra::solid::volume(all);
  block.counts = count(block.units);
  carry_lines(section, length, block);
  block.sections = std::make_shared<const dobra::solid::Sections>(solids);
  return block;
}

}  // namespace recon::block
