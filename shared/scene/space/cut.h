#pragma once
// The picture in space as a plane cuts it: what lies before the plane is taken away, and where surfaces are cut there
// is a line. Of the view only; items keep their identities. Page: docs/user/space_view.md.

#include "shared/scene/space/picture.h"

namespace dobra::scene::space {

/// What lies on the side that the normal points to is taken away.
struct CutPlane {
  geom::Point3 through{};
  geom::Vector3 normal{1.0, 0.0, 0.0};  ///< Of any length but 0.
  friend bool operator==(const CutPlane&, const CutPlane&) = default;
};

enum class CutAxis { X, Y, Z };
/// Square to an axis, at `part` of the box from its low end to its high one. @pre the box is not empty
CutPlane plane_across(CutAxis axis, double part, const geom::Box3& box, bool other_side);

/// The sides of the part of a plane that is in the box: a closed line of three to six sides; fewer where the plane
/// touches the box alone, the nearest corner where it does not meet it. @pre the box is not empty
std::vector<geom::Point3> frame_of(const CutPlane& plane, const geom::Box3& box);

/// A picture that shows as much of space as before. Of a surface KEY the line of the cut is a layer KEY.cut, whose
/// items are those of the triangles that are cut. Layers that the plane does not meet share their points.
/// @cost O(points + triangles)
SpacePicture cut(const SpacePicture& picture, const CutPlane& plane);

}  // namespace dobra::scene::space
