#pragma once
// How two segments meet. Which of the cases it is is decided exactly; a crossing of interiors is rounded once from the
// exact point; every other point returned is an end point given by the caller, bit for bit.
//
// Page: docs/algorithms/intersect.md. Source: [shewchuk1997predicates] for the arithmetic.

#include <vector>

#include "shared/geom/segment.h"

namespace dobra::geom {

enum class IntersectionKind {
  None,
  Point,    ///< Exactly one common point: a crossing or a touch; `start` tells which.
  Overlap,  ///< A common piece of positive length, from `start` to `end`.
};

/// Where on a segment a point lies; From for a segment of zero length.
enum class At { From, To, Interior };

struct Meeting {
  Point point;
  At on_first = At::Interior;
  At on_second = At::Interior;

  /// True if the interiors cross: then `point` is rounded and lies, in general, beside both segments by less than an
  /// ulp.
  [[nodiscard]] bool proper() const { return on_first == At::Interior && on_second == At::Interior; }
};

struct Intersection {
  IntersectionKind kind = IntersectionKind::None;
  Meeting start;  ///< The point, or the end of the overlap nearer to first.from.
  Meeting end;    ///< The other end of the overlap; of no meaning otherwise.
};

/// Segments of zero length are points. Swapping or turning the segments gives the same points, bit for bit.
/// Each coordinate of a crossing is the double nearest to the exact value (ties to even) where all coordinates are 0 or
/// of size 2^-200 to 2^200; beyond, it is near to it and inside both boxes.
/// @pre finite coordinates.  @cost about 20 ns; a proper crossing about 40 ns more, one in some hundreds 0.6 us.
Intersection intersect(const Segment& first, const Segment& second);

/// The point where two segments cross, rounded as in intersect().
/// @pre their interiors cross in one point.
Point crossing(const Segment& first, const Segment& second);

/// True if p lies on the closed segment, exactly.
bool point_on_segment(Point p, const Segment& segment);

/// True if p comes before q along the segment's line: exact order of the orthogonal projections, ties in lexicographic
/// order. A strict total order on distinct points, so it can be given to std::sort.
bool before_along(const Segment& segment, Point p, Point q);

/// Sorts by before_along and drops repeated points.
void sort_along(const Segment& segment, std::vector<Point>& points);

}  // namespace dobra::geom
