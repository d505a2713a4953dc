#pragma once
// Axis-parallel boxes of space.

#include <algorithm>
#include <limits>

#include "shared/geom/point3.h"

namespace dobra::geom {

/// A closed box; the default-constructed one is empty and absorbs nothing.
struct Box3 {
  static constexpr double far = std::numeric_limits<double>::infinity();
  Point3 low{far, far, far};
  Point3 high{-far, -far, -far};

  [[nodiscard]] constexpr bool empty() const { return low.x > high.x || low.y > high.y || low.z > high.z; }
  [[nodiscard]] constexpr Point3 centre() const { return low + 0.5 * (high - low); }
  /// Length of the diagonal: the size that relative tolerances refer to.
  [[nodiscard]] double diagonal() const { return empty() ? 0.0 : distance(low, high); }
  [[nodiscard]] constexpr bool contains(Point3 p) const {
    return low.x <= p.x && p.x <= high.x && low.y <= p.y && p.y <= high.y && low.z <= p.z && p.z <= high.z;
  }
  constexpr void add(Point3 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  constexpr void add(const Box3& other) {
    low = {std::min(low.x, other.low.x), std::min(low.y, other.low.y), std::min(low.z, other.low.z)};
    high = {std::max(high.x, other.high.x), std::max(high.y, other.high.y), std::max(high.z, other.high.z)};
  }
  friend constexpr bool operator==(const Box3&, const Box3&) = default;
};

}  // namespace dobra::geom
