#include "shared/mesh/face_turns.h"

#include <cmath>

namespace dobra::mesh {

void TurnedAlike::add(const std::vector<geom::Point3>& points, std::span<const std::uint32_t> face) {
  triangles_ += face.size() < 3 ? 0 : face.size() - 2;
  const geom::Vector3 a = points[face[0]] - origin_;
  geom::Vector3 twice;
  for (std::size_t i = 1; i + 1 < face.size(); ++i) {
    const geom::Vector3 b = points[face[i]] - origin_, c = points[face[i + 1]] - origin_;
    twice = twice + cross(b - a, c - a);
    volume_ += dot(a, cross(b, c));
  }
  area_ += 0.5 * geom::length(twice);
}

bool TurnedAlike::stays_before(const TurnedAlike& others, bool closed) const {
  if (triangles_ != others.triangles_) return triangles_ > others.triangles_;
  constexpr double rounding = 1e-9;  // of sums of many areas
  if (std::abs(area_ - others.area_) > rounding * (area_ + others.area_)) return area_ > others.area_;
  return !closed || volume_ >= others.volume_;
}

}  // namespace dobra::mesh
