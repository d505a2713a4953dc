#pragma once
// Axis-parallel boxes.

#include <algorithm>
#include <limits>
#include <span>

#include "shared/geom/point.h"

namespace dobra::geom {

/// A closed box; the default-constructed one is empty and absorbs nothing.
struct Box {
  Point low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Point high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  [[nodiscard]] constexpr bool empty() const { return low.x > high.x || low.y > high.y; }
  [[nodiscard]] constexpr double width() const { return empty() ? 0.0 : high.x - low.x; }
  [[nodiscard]] constexpr double height() const { return empty() ? 0.0 : high.y - low.y; }
  [[nodiscard]] constexpr Point centre() const { return midpoint(low, high); }
  /// Length of the diagonal: the size that relative tolerances refer to.
  [[nodiscard]] double diagonal() const { return empty() ? 0.0 : distance(low, high); }
  [[nodiscard]] constexpr bool contains(Point p) const {
    return low.x <= p.x && p.x <= high.x && low.y <= p.y && p.y <= high.y;
  }
  [[nodiscard]] constexpr bool overlaps(const Box& other) const {
    return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y && other.low.y <= high.y;
  }
  constexpr void add(Point p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  constexpr void add(const Box& other) {
    low = {std::min(low.x, other.low.x), std::min(low.y, other.low.y)};
    high = {std::max(high.x, other.high.x), std::max(high.y, other.high.y)};
  }
  /// Grown by `margin` on every side.
  [[nodiscard]] constexpr Box grown(double margin) const {
    return {{low.x - margin, low.y - margin}, {high.x + margin, high.y + margin}};
  }
  friend constexpr bool operator==(const Box&, const Box&) = default;
};

inline Box box_of(std::span<const Point> points) {
  Box box;
  for (const Point p : points) box.add(p);
  return box;
}

}  // namespace dobra::geom
