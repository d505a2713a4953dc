#pragma once
// A convex polyhedron with exact corners that planes cut in two.

#include <utility>
#include <vector>

#include "shared/solid/partition/orthtree.h"
#include "shared/solid/space.h"

namespace dobra::solid::partition {

/// A convex polygon of a plane, anticlockwise seen from above it.
struct ConvexPolygon {
  PlaneId plane;
  std::vector<PointId> corners;
};

/// What of a convex polygon is above a plane, and what below; neither if all of it lies in the plane.
struct CutPolygon {
  std::vector<PointId> above, below;
};
CutPolygon cut(Space& space, const std::vector<PointId>& corners, PlaneId plane);

class ConvexCell {
 public:
  /// Nothing.
  ConvexCell() = default;
  /// @pre the box has a volume
  ConvexCell(Space& space, const Box<3>& box);

  [[nodiscard]] bool empty() const { return faces_.empty(); }
  /// The parts above and below; one of them is empty where the plane does not cut.  @cost O(corners)
  [[nodiscard]] std::pair<ConvexCell, ConvexCell> halves(Space& space, PlaneId plane) const;
  /// By the nearest doubles of its corners.
  [[nodiscard]] double volume(const Space& space) const;

 private:
  void close(std::vector<std::pair<PointId, PointId>> rim);

  std::vector<std::vector<PointId>> faces_;  // anticlockwise seen from outside
};

}  // namespace dobra::solid::partition
