#include "quebra/domain/faces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "quebra/sketch/enclosed.h"
#include "shared/topo/insert.h"
#include "shared/topo/locate.h"

namespace quebra::domain {
namespace {

using dobra::base::Error;
using dobra::base::ErrorCode;
using dobra::base::Place;
using dobra::base::Result;
using dobra::geom::Arc;
using dobra::geom::Box;
using dobra::geom::Point;
using dobra::geom::Polyline;
using dobra::geom::Segment;
using dobra::topo::FaceId;
using dobra::topo::Subdivision;

/// The area of least extent that holds p; null if none does.
const sketch::Area* smallest_round(std::span<const sketch::Area> areas, Point p) {
  const sketch::Area* best = nullptr;
  double least = 0.0;
  for (const sketch::Area& area : areas) {
    bool inside = false;
    double extent = 0.0;
    for (const Polyline& ring : area.outline) {
      if (!ring.box().contains(p)) continue;
      if (locate(ring, p) == dobra::geom::Side::Inside) inside = !inside;
      extent = std::max(extent, std::abs(signed_area(ring)));
    }
    if (!inside || (best != nullptr && extent >= least)) continue;
    best = &area;
    least = extent;
  }
  return best;
}

Error bad_name(ErrorCode code, const sketch::RegionName& name, const char* what) {
  Place place;
  place.item = fmt::format("region '{}'", name.name);
  place.x = name.at.x;
  place.y = name.at.y;
  return {code, what, place};
}

}  // namespace

Polyline chords(const Domain& domain, std::size_t curve) {
  sketch::Trace along = trace(domain.curves[curve]);
  if (along.line.closed) {
    along.line.points.push_back(along.line.points.front());
    along.line.closed = false;
  }
  std::vector<std::pair<double, Point>> nodes;
  for (std::size_t i = 0; i < along.line.points.size(); ++i) nodes.emplace_back(along.s[i], along.line.points[i]);
  for (const Junction& junction : domain.junctions) {
    if (junction.curve == curve) nodes.emplace_back(junction.s, junction.at);
  }
  std::stable_sort(nodes.begin(), nodes.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  Polyline line;
  for (const auto& [s, p] : nodes) line.points.push_back(p);
  return without_repeated_points(std::move(line));
}

std::vector<Segment> sides_of(const Subdivision& subdivision, FaceId face) {
  std::vector<Segment> sides;
  for (const auto loop : subdivision.loops(face)) {
    for (const auto half : subdivision.half_edges(loop)) sides.push_back(subdivision.segment(half));
  }
  return sides;
}

namespace {

/// Marks round holes in whose box there is nothing else, no region's point either.
std::vector<std::uint8_t> lone_holes(const Domain& domain, std::span<const sketch::RegionName> names) {
  constexpr double rounding = 1e-9;
  std::vector<Point> points;
  for (const sketch::RegionName& name : names) points.push_back(name.at);
  for (const sketch::NamedPoint& named : domain.points) points.push_back(named.at);
  const std::vector<std::uint8_t> lone = lone_circles(domain.curves, points, rounding * domain.box().diagonal());
  std::vector<std::uint8_t> holes(lone.size(), 0);
  for (const Domain::Loop& loop : domain.loops) {
    if (loop.sides.size() == 1 && loop.depth % 2 == 1) holes[loop.sides.front().curve] = lone[loop.sides.front().curve];
  }
  return holes;
}

/// The octagon round a circle, within its box.
Polyline octagon_round(const Arc& circle) {
  const double reach = circle.radius() / std::cos(std::numbers::pi / 8.0);
  Polyline octagon{{}, true};
  for (int i = 0; i < 8; ++i) {
    const double angle = (i + 0.5) * std::numbers::pi / 4.0;
    octagon.points.push_back(circle.centre() + reach * dobra::geom::Vector{std::cos(angle), std::sin(angle)});
  }
  return octagon;
}

}  // namespace

Result<void> find_faces(Domain& domain, const Inside& inside, std::span<const sketch::RegionName> names,
                        std::span<const sketch::Area> areas) {
  Subdivision subdivision;
  // Round holes that nothing is near to may as well be octagons, but for the area between.
  const std::vector<std::uint8_t> lone = lone_holes(domain, names);
  std::vector<std::pair<dobra::topo::HalfEdgeId, double>> between;
  for (std::size_t c = 0; c < domain.curves.size(); ++c) {
    if (domain.curves[c].role == sketch::Role::Crack) continue;
    const Polyline line = lone[c] != 0 ? octagon_round(std::get<Arc>(domain.curves[c].shape)) : chords(domain, c);
    const auto inserted = insert(subdivision, line);
    if (!inserted) return inserted.error();
    if (lone[c] == 0) continue;
    between.emplace_back(inserted->path.front(),
                         signed_area(line) - std::abs(signed_area(trace(domain.curves[c]).line)));
  }
  std::map<FaceId, Face> faces;
  for (const FaceId id : subdivision.faces()) {
    if (id == Subdivision::unbounded()) continue;
    const auto sides = sides_of(subdivision, id);
    const Point p = sketch::inner_point(sides);
    if (inside(p)) faces[id] = {0, p, sketch::area_of(sides)};
  }
  for (const auto& [half, area] : between) {
    for (const auto side : {half, Subdivision::twin(half)}) {
      if (const auto face = faces.find(subdivision.face(side)); face != faces.end()) face->second.area += area;
    }
  }
  std::map<std::string, std::int32_t> tags;
  std::int32_t next = 0;
  for (const sketch::RegionName& name : names) {
    const auto where = locate(subdivision, name.at);
    const auto face = where.where == dobra::topo::Where::Face ? faces.find(where.face) : faces.end();
    if (face == faces.end()) {
      return bad_name(ErrorCode::OutsideDomain, name,
                      "the point of the region does not lie inside the material; move it");
    }
    const auto [tag, is_new] = tags.try_emplace(name.name, next + 1);
    if (is_new) domain.region_names[++next] = name.name;
    if (face->second.region != 0 && face->second.region != tag->second) {
      return bad_name(ErrorCode::BadValue, name,
                      "another region has its point in the same part of the material; divide them by an internal line");
    }
    face->second.region = tag->second;
  }
  std::map<const sketch::Area*, std::vector<Face*>> within;
  for (auto& [id, face] : faces) {
    if (const sketch::Area* const area = face.region == 0 ? smallest_round(areas, face.inside) : nullptr)
      within[area].push_back(&face);
  }
  for (const sketch::Area& area : areas) {  // tags in the order of the areas
    const auto found = area.name.empty() ? within.end() : within.find(&area);
    if (found == within.end()) continue;
    const auto [tag, is_new] = tags.try_emplace(area.name, next + 1);
    if (is_new) domain.region_names[++next] = area.name;
    for (Face* const face : found->second) face->region = tag->second;
  }
  for (auto& [id, face] : faces) {
    if (face.region == 0) face.region = ++next;
    domain.faces.push_back(face);
  }
  return {};
}

}  // namespace quebra::domain
