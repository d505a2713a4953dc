#pragma once
// How space is looked at, and where its points come to stand on the page: parallel, oblique and perspective projection
// onto the plane through the target that faces the viewer, which is then shown as any plane is (view.h).
// Source: [foley1990graphics].

#include <optional>

#include "shared/base/angle.h"
#include "shared/geom/box3.h"
#include "shared/scene/space/matrix.h"
#include "shared/scene/view.h"

namespace dobra::scene::space {

enum class Projection { Parallel, Oblique, Perspective };

struct Camera {
  geom::Vector3 right{1.0, 0.0, 0.0};  ///< Unit vectors of the world, at right angles.
  geom::Vector3 up{0.0, 0.0, 1.0};
  Projection projection = Projection::Parallel;
  double depth_factor = 0.5;  ///< Oblique: drawn length of what goes away from the viewer, over its length.
  base::Angle depth_angle = base::Angle::from_degrees(45.0);  ///< Oblique: where that goes on the page, from the right.
  /// Perspective: from the eye to the target, m; 0: usual_distance times the diagonal of what is looked at.
  double distance = 0.0;
  std::optional<geom::Point3> target = std::nullopt;  ///< What it turns about; by default the middle.
  friend bool operator==(const Camera&, const Camera&) = default;
};

inline constexpr double usual_distance = 2.5;

/// From the target to the viewer.
inline geom::Vector3 towards_viewer(const Camera& camera) { return geom::cross(camera.right, camera.up); }

/// Front looks north, Top down, Right west. Isometric, Dimetric and Perspective look down from the right of the front.
enum class StandardView { Front, Top, Right, Isometric, Dimetric, Cavalier, Cabinet, Perspective };

Camera camera_of(StandardView view);

/// The front view turned about the vertical axis, then tipped over the horizontal one of the page.
struct Turns {
  base::Angle about_vertical;
  base::Angle about_horizontal;
};
Camera turned(const Turns& turns);
/// All three axes are shortened alike.
Turns isometric();
/// x and z are shortened alike, y to `factor` of its length. @pre 0 < factor <= 1
Turns dimetric(double factor);

/// As if the viewer went round the target: by `right` about the vertical, then by `up` about the horizontal of the
/// page, not farther than over the top or under the bottom. The projection becomes parallel where it was oblique.
Camera orbited(const Camera& camera, base::Angle right, base::Angle up);

/// How a picture comes onto the plane of the page: world to (right, up, away, w), before the division by w.
struct Frame {
  Camera camera{};
  geom::Point3 target{};  ///< Exaggerated, as `matrix` sees it.
  double exaggeration = 1.0;
  double distance = 0.0;  ///< Of the eye; 0: none, rays are parallel.
  Matrix4 matrix{};
};

/// @param shown  what there is to see, not exaggerated. @pre it is not empty, exaggeration > 0
Frame frame_of(const Camera& camera, const geom::Box3& shown, double exaggeration);

/// What is nearer to the eye than this part of its distance is cut off.
inline constexpr double least_w = 0.02;

/// A point on the plane of the page, world lengths; depth grows away from the viewer and keeps order along a ray.
struct Projected {
  geom::Point at;
  double depth = 0.0;
};
/// Nothing behind the eye or beside it.
std::optional<Projected> project(const Frame& frame, geom::Point3 world);
/// The box of the corners of `box` on the plane. @pre not empty
geom::Box projected(const Frame& frame, const geom::Box3& box);

/// A frame on a page.
struct Sheet {
  Frame frame{};
  Transform page{};  ///< Plane to page.
  geom::Box plot{};  ///< Page; nothing is drawn outside.
};

/// Page coordinates and depth. Nothing behind the eye.
std::optional<Projected> project(const Sheet& sheet, geom::Point3 world);

/// The points from + t * along, t >= 0, are seen at one point of the page; nearer ones first. World, unit vector.
struct Ray {
  geom::Point3 from;
  geom::Vector3 along;
};
/// @param shown  the rays of parallel projections begin before this. @pre not empty
Ray ray_at(const Sheet& sheet, geom::Point page, const geom::Box3& shown);

/// The world point that is seen at `page` in the plane through `through` that faces the viewer.
geom::Point3 in_plane_of(const Sheet& sheet, geom::Point page, geom::Point3 through);

}  // namespace dobra::scene::space
