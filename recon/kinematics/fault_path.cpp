#include "recon/kinematics/fault_path.h"

#include <algorithm>
#include <limits>

#include "shared/geom/predicates.h"

namespace recon::kinematics {

namespace {

/// What of a path is nearest to a point.
struct Foot {
  std::size_t segment = 0;
  double part = 0.0;  ///< 0 .. 1 of the segment; of the first and the last one also beyond the path's ends.
  double distance = std::numeric_limits<double>::infinity();
};

Foot foot_on_segment(const geom::Polyline& line, std::size_t i, geom::Point p) {
  const geom::Segment segment = line.segment(i);
  const geom::Vector along = segment.to - segment.from;
  double part = geom::dot(p - segment.from, along) / geom::length_squared(along);
  if (i != 0) part = std::max(part, 0.0);
  if (i + 1 != line.segment_count()) part = std::min(part, 1.0);
  return {i, part, geom::distance(geom::interpolate(segment.from, segment.to, part), p)};
}

Foot foot_of(const geom::Polyline& line, geom::Point p) {
  Foot best;
  for (std::size_t i = 0; i < line.segment_count(); ++i) {
    const Foot foot = foot_on_segment(line, i, p);
    if (foot.distance < best.distance) best = foot;
  }
  return best;
}

/// Side of a line round one of its vertices, where the vertex is what is nearest.
geom::Sign side_at_vertex(geom::Point before, geom::Point vertex, geom::Point behind, geom::Point p) {
  if (p == vertex) return geom::Sign::Zero;
  const geom::Sign first = geom::orient2d(before, vertex, p);
  const geom::Sign second = geom::orient2d(vertex, behind, p);
  const bool left_turn = geom::orient2d(before, vertex, behind) == geom::Sign::Positive;
  return left_turn ? std::min(first, second) : std::max(first, second);
}

geom::Sign side_of(const geom::Polyline& line, const Foot& foot, geom::Point p) {
  const geom::Segment segment = line.segment(foot.segment);
  if (foot.segment != 0 && foot.part <= 0.0) {
    return side_at_vertex(line.points[foot.segment - 1], segment.from, segment.to, p);
  }
  if (foot.segment + 1 != line.segment_count() && foot.part >= 1.0) {
    return side_at_vertex(segment.from, segment.to, line.points[foot.segment + 2], p);
  }
  return geom::orient2d(segment.from, segment.to, p);
}

Wall wall_on(const FaultPath& path, geom::Sign side) {
  const bool left = side == geom::Sign::Positive;
  return left == (path.hanging == Side::Left) ? Wall::Hanging : Wall::Foot;
}

}  // namespace

OnPath nearest(const FaultPath& path, geom::Point p) {
  const Foot foot = foot_of(path.line, p);
  double arc = 0.0;
  for (std::size_t i = 0; i < foot.segment; ++i) {
    arc += geom::distance(path.line.points[i], path.line.points[i + 1]);
  }
  const geom::Segment segment = path.line.segment(foot.segment);
  arc += foot.part * geom::distance(segment.from, segment.to);
  const geom::Sign side = side_of(path.line, foot, p);
  if (side == geom::Sign::Zero) return {arc, 0.0};
  return {arc, wall_on(path, side) == Wall::Hanging ? foot.distance : -foot.distance};
}

geom::Point point_at(const FaultPath& path, double arc) {
  return geom::point_at(path.line, geom::arc_lengths(path.line), arc);
}

std::optional<Wall> wall_of(const FaultPath& path, geom::Point p) {
  const geom::Sign side = side_of(path.line, foot_of(path.line, p), p);
  if (side == geom::Sign::Zero) return std::nullopt;
  return wall_on(path, side);
}

FaultPath straightened(FaultPath path) {
  constexpr double rounding = 1e-12;  // of the path's length
  const double least = rounding * geom::length(path.line);
  std::vector<geom::Point> kept{path.line.points.front()};
  for (std::size_t i = 1; i + 1 < path.line.points.size(); ++i) {
    const geom::Point p = path.line.points[i];
    if (geom::distance(geom::Segment{kept.back(), path.line.points[i + 1]}, p) > least) kept.push_back(p);
  }
  kept.push_back(path.line.points.back());
  path.line.points = std::move(kept);
  return path;
}

}  // namespace recon::kinematics
