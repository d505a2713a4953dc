#include "shared/solid/partition/convex_cell.h"

#include <algorithm>

namespace dobra::solid::partition {

using geom::Point3;
using geom::Sign;

CutPolygon cut(Space& space, const std::vector<PointId>& corners, PlaneId plane) {
  CutPolygon parts;
  std::vector<Sign> sides;
  for (const PointId p : corners) sides.push_back(space.side(plane, p));
  const auto has = [&](Sign sign) { return std::find(sides.begin(), sides.end(), sign) != sides.end(); };
  if (!has(Sign::Negative)) {
    if (has(Sign::Positive)) parts.above = corners;
    return parts;
  }
  if (!has(Sign::Positive)) {
    parts.below = corners;
    return parts;
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::size_t j = (i + 1) % corners.size();
    if (sides[i] != Sign::Negative) parts.above.push_back(corners[i]);
    if (sides[i] != Sign::Positive) parts.below.push_back(corners[i]);
    if (sides[i] * sides[j] != Sign::Negative) continue;
    const PointId between = space.meet(corners[i], corners[j], plane);
    parts.above.push_back(between);
    parts.below.push_back(between);
  }
  return parts;
}

ConvexCell::ConvexCell(Space& space, const Box<3>& box) {
  std::array<PointId, 8> p;
  for (std::size_t i = 0; i < 8; ++i) {
    p[i] = space.add(Point3{(i & 1U) != 0 ? box.high[0] : box.low[0], (i & 2U) != 0 ? box.high[1] : box.low[1],
                            (i & 4U) != 0 ? box.high[2] : box.low[2]});
  }
  faces_ = {{p[0], p[2], p[3], p[1]}, {p[4], p[5], p[7], p[6]}, {p[0], p[1], p[5], p[4]},
            {p[2], p[6], p[7], p[3]}, {p[0], p[4], p[6], p[2]}, {p[1], p[3], p[7], p[5]}};
}

std::pair<ConvexCell, ConvexCell> ConvexCell::halves(Space& space, PlaneId plane) const {
  std::pair<ConvexCell, ConvexCell> halves;
  auto& [above, below] = halves;
  std::vector<std::pair<PointId, PointId>> rim_above;
  std::vector<std::pair<PointId, PointId>> rim_below;
  const auto add = [&](ConvexCell& to, std::vector<PointId>&& face, std::vector<std::pair<PointId, PointId>>& rim) {
    if (face.empty()) return;
    for (std::size_t i = 0; i < face.size(); ++i) {
      const PointId a = face[i];
      const PointId b = face[(i + 1) % face.size()];
      if (space.side(plane, a) == Sign::Zero && space.side(plane, b) == Sign::Zero) rim.emplace_back(b, a);
    }
    to.faces_.push_back(std::move(face));
  };
  for (const auto& face : faces_) {
    CutPolygon parts = cut(space, face, plane);
    add(above, std::move(parts.above), rim_above);
    add(below, std::move(parts.below), rim_below);
  }
  if (above.empty() || below.empty()) {
    (above.empty() ? below : above).faces_ = faces_;
    return halves;
  }
  above.close(std::move(rim_above));
  below.close(std::move(rim_below));
  return halves;
}

/// The rim's edges follow each other round one face.
void ConvexCell::close(std::vector<std::pair<PointId, PointId>> rim) {
  std::vector<PointId> face{rim.front().first, rim.front().second};
  while (face.back() != face.front()) {
    const auto next = std::find_if(rim.begin(), rim.end(), [&](const auto& edge) { return edge.first == face.back(); });
    DOBRA_CHECK(next != rim.end() && face.size() <= rim.size());
    face.push_back(next->second);
  }
  face.pop_back();
  faces_.push_back(std::move(face));
}

double ConvexCell::volume(const Space& space) const {
  if (faces_.empty()) return 0.0;
  const Point3 origin = space.rounded(faces_[0][0]);
  double six = 0.0;
  for (const auto& face : faces_) {
    const geom::Vector3 a = space.rounded(face[0]) - origin;
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
      six += dot(a, cross(space.rounded(face[i]) - origin, space.rounded(face[i + 1]) - origin));
  }
  return six / 6.0;
}

}  // namespace dobra::solid::partition
