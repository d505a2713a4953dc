#pragma once
// Plane profiles moved through space: extruded, drawn to a point, swept along a path, turned about the z axis. All give
// faces with names, of which from_loops() makes a solid. Page: docs/algorithms/sweeps.md. Sources:
// [requicha1980representations] (sweeps), [mantyla1988solid] (local operators).

#include <string>
#include <vector>

#include "shared/geom/polyline.h"
#include "shared/solid/mesh_solid.h"

namespace dobra::solid::shape {

/// Closed contours in the plane z = 0, either way round, without repeated points.
struct Profile {
  geom::Polyline outline;
  std::vector<geom::Polyline> holes;
};

/// Faces, and what each is called.
struct Shape {
  FaceLoops mesh;
  std::vector<std::string> names;
};

/// The solid that a shape bounds.
/// @param prefix  stands before the name of each face with an underscore; none if empty.
/// @error those of from_loops()
base::Result<Solid> solid_of(const Shape& shape, const std::string& prefix = "");

enum class SideNames : std::uint8_t {
  Each,  ///< side_1, side_2, ... in the order of the outline's segments as given; hole_1 for all of a hole.
  One    ///< side, hole.
};

// Faces are called bottom, top and side_1 ..., or start, end and side_1 ...
// @error DegenerateCurve: less than three corners, a corner twice in a row, or no area; NotFinite.

/// From z = 0 along a vector.  @error and InvalidOption if the vector lies in the plane z = 0
base::Result<Shape> extrude(const Profile& profile, geom::Vector3 along, SideNames names = SideNames::Each);
/// From z = 0 to a point.  @error and InvalidOption if the point lies in that plane, or the profile has holes
base::Result<Shape> draw_to_point(const Profile& profile, geom::Point3 apex, SideNames names = SideNames::Each);
/// Along straight legs, square to the first; corners are mitred. The profile's y axis points up as far as it can.
/// @error and InvalidOption with the number of the point and its place where the path folds: it turns back, a leg is
///        too short for the profile between its two mitres, or it has no length.
base::Result<Shape> sweep(const Profile& profile, const std::vector<geom::Point3>& path,
                          SideNames names = SideNames::Each);

struct RevolveOptions {
  double angle = 360.0;  ///< Degrees, anticlockwise from the half-plane of the x axis; above 0, at most 360.
  int segments = 64;     ///< Over the angle; at least 3 for a whole turn, else 1.
};
/// A contour of (radius, z) turned about the z axis; sides on the axis make no faces. Surfaces are called side_1 ... by
/// the contour's segments, the ends of a part of a turn start and end.
/// @error and InvalidOption: a negative radius (with its point), angle or segments out of range
base::Result<Shape> revolve(const geom::Polyline& contour, const RevolveOptions& options = {},
                            SideNames names = SideNames::Each);

}  // namespace dobra::solid::shape
