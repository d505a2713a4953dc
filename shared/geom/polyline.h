#pragma once
// Open chains and closed contours of straight segments.

#include <vector>

#include "shared/base/result.h"
#include "shared/geom/box.h"
#include "shared/geom/point.h"
#include "shared/geom/segment.h"

namespace dobra::geom {

/// n points joined in order; a closed one does not repeat its first point.
struct Polyline {
  std::vector<Point> points;
  bool closed = false;

  [[nodiscard]] std::size_t segment_count() const { return points.size() < 2 ? 0 : points.size() - (closed ? 0 : 1); }
  /// @pre i < segment_count()
  [[nodiscard]] Segment segment(std::size_t i) const { return {points[i], points[i + 1 == points.size() ? 0 : i + 1]}; }
  [[nodiscard]] Box box() const { return box_of(points); }
  friend bool operator==(const Polyline&, const Polyline&) = default;
};

/// Sum of the lengths of the segments, m. Compensated, so that the error does not grow with n.
double length(const Polyline& polyline);

/// Signed area of a closed contour, m2: positive when anticlockwise. Zero for an open chain.
double signed_area(const Polyline& polyline);

Polyline reversed(Polyline polyline);

/// Distance travelled from the first point to each point, m; n values (n + 1 for a closed contour: the last is the
/// length).
std::vector<double> arc_lengths(const Polyline& polyline);

/// The point at distance `s` along the polyline; before 0 and after the end the end segments go on straight.
/// @param arc  arc_lengths(polyline).  @pre at least two points.
Point point_at(const Polyline& polyline, const std::vector<double>& arc, double s);

/// Least distance from p to the polyline, m. O(n).
double distance(const Polyline& polyline, Point p);

/// Without consecutive equal points (and, closed, without a repeated first point at the end).
Polyline without_repeated_points(Polyline polyline);

/// Checks that coordinates are finite and that at least two (closed: three) distinct points remain.
/// @error NotFinite, DegenerateCurve with the place.
base::Result<void> validate(const Polyline& polyline);

/// Where p lies against a closed contour, by exact predicates. O(n).
enum class Side { Inside, Outside, Boundary };
Side locate(const Polyline& contour, Point p);

}  // namespace dobra::geom
