#pragma once
// Where surfaces meet lines, planes and each other. Page: docs/algorithms/surface_search.md.

#include "shared/surf/surface.h"

namespace dobra::surf {

/// A point that a surface and a line share.
struct LineHit {
  double t = 0.0;  ///< Of the line: from + t * way.
  geom::Point uv;
  geom::Point3 at;
  bool tangent = false;  ///< The line touches the surface there and does not pass through it.
};

/// All points that a surface shares with a line through `from`, by t; each to 1e-12 of the size. A point on a border of
/// the chart has that border's parameter exactly; on a seam, it is told once, and so is a pole.
/// @param from_t, to_t  the part of the line that is asked for, ends included.
/// @error NotFinite; DegenerateCurve: no way; InvalidOption: the line lies in the surface, or so near to it that
///        no points can be told apart, with a place of it.
base::Result<std::vector<LineHit>> intersect_line(const Surface& surface, geom::Point3 from, geom::Vector3 way,
                                                  double from_t = -1e300, double to_t = 1e300);

/// A point that two surfaces share, with its place in both charts.
struct SharedPoint {
  geom::Point first, second;
  geom::Point3 at;
};

/// A curve that two surfaces share, as a chain of points of both (to 1e-12 of their size). From point to point it turns
/// by 12 degrees at most, and goes on by 0.03 of the size of the smaller surface. Where it passes a seam or a corner of
/// a surface, two points stand at the same place in space.
struct SharedCurve {
  std::vector<SharedPoint> points;
  bool closed = false;  ///< In space; the last point is then at the place of the first.
};

/// Where two surfaces have one tangent plane.
struct SharedContact {
  /// Touch: they have nothing else in common around it. Crossing: two curves cross there. Along: they touch along a
  /// curve, of which this is a point, or share more.
  enum class Kind { Touch, Crossing, Along };
  Kind kind = Kind::Touch;
  SharedPoint point;
};

struct SharedSet {
  std::vector<SharedCurve> curves;
  std::vector<SharedContact> contacts;
};

/// All that two surfaces share. Curves end on borders of a chart, with that border's parameter exactly, or are closed.
/// @error InvalidOption: they share more than curves (coincide over an area), or touch along so much that no curves can
///        be told apart, with a place.
base::Result<SharedSet> intersect_surfaces(const Surface& first, const Surface& second);

/// The same with a plane; `second` is in m along two axes of it at right angles, from the point of the plane.
/// @error NotFinite; DegenerateCurve: no normal; as intersect_surfaces.
base::Result<SharedSet> intersect_plane(const Surface& surface, geom::Point3 on_plane, geom::Vector3 normal);

}  // namespace dobra::surf
