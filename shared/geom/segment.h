#pragma once
// Straight segments.

#include "shared/geom/box.h"
#include "shared/geom/point.h"

namespace dobra::geom {

struct Segment {
  Point from;
  Point to;

  [[nodiscard]] Vector vector() const { return to - from; }
  [[nodiscard]] double length() const { return distance(from, to); }
  [[nodiscard]] Box box() const {
    Box box;
    box.add(from);
    box.add(to);
    return box;
  }
  friend constexpr bool operator==(const Segment&, const Segment&) = default;
};

/// Fraction in [0, 1] along `segment` of its point nearest to p; 0 for a segment of zero length.
inline double nearest_fraction(const Segment& segment, Point p) {
  const Vector along = segment.vector();
  const double squared = length_squared(along);
  if (squared == 0.0) return 0.0;
  return std::clamp(dot(p - segment.from, along) / squared, 0.0, 1.0);
}

inline double distance(const Segment& segment, Point p) {
  return distance(interpolate(segment.from, segment.to, nearest_fraction(segment, p)), p);
}

}  // namespace dobra::geom
