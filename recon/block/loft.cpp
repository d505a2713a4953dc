#include "recon/block/loft.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "recon/block/counts.h"
#include "recon/block/unit_map.h"
#include "shared/geom/polyline.h"
#include "shared/solid/measure.h"
#include "shared/solid/mesh_solid.h"
#include "shared/solid/shape/loft.h"

// 1. The sections are put in order along strike. 2. Each gives its lines between units. 3. The library joins them to
// the lines that stand for them in the next section. 4. All units together must bound a solid: what they share is left
// out, and none crosses another.

namespace recon::block {
namespace {

using base::Error;
using base::ErrorCode;
using base::Result;
using dobra::io::lines::Trace;
using dobra::solid::shape::LoftLine;
using dobra::solid::shape::LoftPart;
using dobra::solid::shape::LoftSection;
using dobra::solid::shape::Shape;
using geom::Point;
using geom::Point3;
using topo::HalfEdgeId;
using topo::Subdivision;

/// The middle of a section on the map.
Point middle_of(const LoftedSection& placed) {
  const double x = box_of(placed.section).centre().x;
  return {placed.trace.x + x * placed.trace.east, placed.trace.y + x * placed.trace.north};
}

/// How far a place is along strike as a section is looked at.
double along_strike(const Trace& from, Point p) { return (p.y - from.y) * from.east - (p.x - from.x) * from.north; }

/// The sections from the one behind which all others stand.
std::vector<const LoftedSection*> in_order(std::span<const LoftedSection> sections) {
  std::vector<const LoftedSection*> order;
  for (const LoftedSection& each : sections) order.push_back(&each);
  const Trace direction = sections[0].trace;
  std::stable_sort(order.begin(), order.end(), [&](const LoftedSection* a, const LoftedSection* b) {
    return along_strike(direction, middle_of(*a)) < along_strike(direction, middle_of(*b));
  });
  return order;
}

std::string name_of(const UnitMap& map, topo::FaceId face) {
  const std::size_t unit = map.unit_of[face.index()];
  return unit == UnitMap::nobody ? std::string{} : map.units[unit];
}

/// The lines between units, as they are seen by who looks at the first section.
LoftSection lines_of(const UnitMap& map, const Trace& trace, const Block& block) {
  const double east = trace.east * block.trace.east + trace.north * block.trace.north;
  const double north = trace.north * block.trace.east - trace.east * block.trace.north;
  const double sense = east < 0.0 ? -1.0 : 1.0;
  const bool parallel = north == 0.0;
  LoftSection made{{block.in_block({trace.x, trace.y, 0.0}),
                    parallel ? geom::Vector3{1, 0, 0} : geom::Vector3{sense * east, sense * north, 0.0},
                    {0, 0, 1}},
                   {}};
  const Subdivision& sub = map.arrangement.subdivision();
  for (const topo::EdgeId e : sub.edges()) {
    const HalfEdgeId h = Subdivision::half_edge(e);
    LoftLine line;
    line.left = name_of(map, sub.face(h));
    line.right = name_of(map, sub.face(Subdivision::twin(h)));
    if (line.left == line.right) continue;
    line.name = map.edge_names[e.index()];
    map.arrangement.append(h, line.line.points);
    line.line.closed = sub.origin(h) == sub.target(h);
    if (!line.line.closed) line.line.points.push_back(sub.point(sub.target(h)));
    if (sense < 0.0) {
      for (Point& p : line.line.points) p.x = -p.x;
      std::swap(line.left, line.right);
    }
    made.lines.push_back(std::move(line));
  }
  return made;
}

void append(const Shape& part, Shape& whole) {
  const auto first = static_cast<std::uint32_t>(whole.mesh.points.size());
  whole.mesh.points.insert(whole.mesh.points.end(), part.mesh.points.begin(), part.mesh.points.end());
  for (auto face : part.mesh.faces) {
    for (auto& loop : face) {
      for (std::uint32_t& p : loop) p += first;
    }
    whole.mesh.faces.push_back(std::move(face));
  }
  whole.names.insert(whole.names.end(), part.names.begin(), part.names.end());
}

/// Places of the block are on the map from then on, and what is meant has a name.
Error on_map(Error error, const Block& block, const std::string& item) {
  if (error.place && error.place->x && error.place->y && error.place->z) {
    const Point3 p = block.on_map({*error.place->x, *error.place->y, *error.place->z});
    error.place->x = p.x, error.place->y = p.y, error.place->z = p.z;
  }
  return base::located(std::move(error), {.item = item});
}

/// What is on the left of faults is on their right then, and lines run the other way.
void see_from_behind(section::Section& section) {
  using section::HangingWall;
  for (section::SectionLine& line : section.lines) {
    if (line.hanging_wall == HangingWall::Left || line.hanging_wall == HangingWall::Right)
      line.hanging_wall = line.hanging_wall == HangingWall::Left ? HangingWall::Right : HangingWall::Left;
    for (Point& p : line.line.points) p.x = -p.x;
  }
}

double area_of(const UnitMap& map, std::size_t unit) {
  double area = 0.0;
  for (const topo::FaceId face : map.faces[unit]) area += map.arrangement.area(face);
  return area;
}

}  // namespace

Result<Block> loft(std::span<const LoftedSection> sections) {
  if (sections.size() < 2) return Error{ErrorCode::InvalidOption, "a block is lofted between two sections or more"};
  const std::vector<const LoftedSection*> order = in_order(sections);
  Block block;
  block.section = order[0]->section;
  block.trace = order[0]->trace;
  bool turned = false;
  if (along_strike(block.trace, middle_of(*order.back())) < 0.0) {  // looked at from the other side
    block.trace.east = -block.trace.east;
    block.trace.north = -block.trace.north;
    turned = true;
  }
  block.placed = true;
  if (turned) see_from_behind(block.section);
  std::vector<std::string> names;
  std::vector<UnitMap> maps;
  std::vector<LoftSection> lines;
  for (const LoftedSection* const each : order) {
    const std::string item = fmt::format("section '{}'", each->name);
    names.push_back(item);
    auto map = unit_map(each->section);
    if (!map) return base::located(map.error(), {.item = item});
    for (base::Finding finding : map->findings) {
      finding.message = fmt::format("{}: {}", item, finding.message);
      block.findings.push_back(std::move(finding));
    }
    lines.push_back(lines_of(*map, each->trace, block));
    for (const LoftLine& line : lines.back().lines) {
      for (const Point p : line.line.points) block.length = std::max(block.length, lines.back().frame.in_space(p).y);
    }
    maps.push_back(std::move(*map));
  }
  const std::string all = fmt::format("{}", fmt::join(names, ", "));
  const auto parts = dobra::solid::shape::loft_sections(lines);
  if (!parts) {
    Error error = on_map(parts.error(), block, all);
    // Units that run together at an open end are not those of the other section.
    const auto open = std::find_if(block.findings.begin(), block.findings.end(),
                                   [](const base::Finding& finding) { return finding.code == "open_end"; });
    if (open != block.findings.end()) error.message = fmt::format("{}; {}", error.message, open->message);
    return error;
  }
  Shape whole;
  std::vector<dobra::solid::Solid> solids;
  for (std::size_t u = 0; u < maps[0].units.size(); ++u) {
    BlockUnit unit;
    unit.name = maps[0].units[u];
    for (const LoftPart& part : *parts) {
      if (part.name != unit.name) continue;
      append(part.shape, unit.shape);
      ++unit.parts;
    }
    if (unit.parts == 0) continue;
    unit.area = area_of(maps[0], u);
    auto solid = dobra::solid::shape::solid_of(unit.shape);
    if (!solid) return on_map(solid.error(), block, fmt::format("unit '{}'", unit.name));
    unit.solid = std::move(*solid);
    unit.volume = dobra::solid::volume(unit.solid);
    block.area += unit.area;
    append(unit.shape, whole);
    solids.push_back(unit.solid);
    block.units.push_back(std::move(unit));
  }
  const auto together = dobra::solid::shape::solid_of(whole);
  if (!together) return on_map(together.error(), block, all);
  block.volume = dobra::solid::volume(*together);
  block.counts = count(block.units);
  block.sections = std::make_shared<const dobra::solid::Sections>(solids);
  return block;
}

}  // namespace recon::block
