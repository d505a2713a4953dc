#include "shared/scene/space/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shared/base/check.h"

namespace dobra::scene::space {

namespace {

using geom::Point3;
using geom::Vector3;

Vector3 turned_about(Vector3 v, Vector3 axis, double angle) {
  const double c = std::cos(angle);
  return c * v + std::sin(angle) * geom::cross(axis, v) + (1.0 - c) * geom::dot(axis, v) * axis;
}

Camera with_axes(Vector3 right, Vector3 up) {
  Camera camera;
  camera.right = right;
  camera.up = up;
  return camera;
}

Camera oblique(double factor) {
  Camera camera;
  camera.projection = Projection::Oblique;
  camera.depth_factor = factor;
  return camera;
}

/// Before the division by w; x and y of the plane.
std::optional<Projected> divided(const Column4& c) {
  if (!(c[3] > least_w)) return std::nullopt;
  return Projected{{c[0] / c[3], c[1] / c[3]}, c[2] / c[3]};
}

}  // namespace

Camera turned(const Turns& turns) {
  const double a = turns.about_vertical.radians();
  const double b = turns.about_horizontal.radians();
  const Vector3 right{std::cos(a), std::sin(a), 0.0};
  const Vector3 away{-std::sin(a), std::cos(a), 0.0};
  return with_axes(right, std::sin(b) * away + std::cos(b) * Vector3{0.0, 0.0, 1.0});
}

Turns isometric() {
  return {base::Angle::from_radians(std::asin(std::sqrt(1.0 / 2.0))),
          base::Angle::from_radians(std::asin(std::sqrt(1.0 / 3.0)))};
}

Turns dimetric(double factor) {
  DOBRA_CHECK(factor > 0.0 && factor <= 1.0);
  return {base::Angle::from_radians(std::asin(factor / std::sqrt(2.0 - factor * factor))),
          base::Angle::from_radians(std::asin(factor / std::numbers::sqrt2))};
}

Camera camera_of(StandardView view) {
  switch (view) {
    case StandardView::Top:
      return with_axes({1.0, 0.0, 0.0}, {0.0, 1.0, 0.0});
    case StandardView::Right:
      return with_axes({0.0, 1.0, 0.0}, {0.0, 0.0, 1.0});
    case StandardView::Isometric:
      return turned(isometric());
    case StandardView::Dimetric:
      return turned(dimetric(0.5));
    case StandardView::Cavalier:
      return oblique(1.0);
    case StandardView::Cabinet:
      return oblique(0.5);
    case StandardView::Perspective: {
      Camera camera = turned({base::Angle::from_degrees(30.0), base::Angle::from_degrees(25.0)});
      camera.projection = Projection::Perspective;
      return camera;
    }
    case StandardView::Front:
      break;
  }
  return {};
}

Camera orbited(const Camera& camera, base::Angle right, base::Angle up) {
  Camera made = camera;
  if (made.projection == Projection::Oblique) made.projection = Projection::Parallel;
  const Vector3 vertical{0.0, 0.0, 1.0};
  // Upside down, the page turns the other way.
  const double side = camera.up.z < 0.0 ? -1.0 : 1.0;
  const double turn = side * right.radians();
  made.right = turned_about(camera.right, vertical, turn);
  made.up = turned_about(camera.up, vertical, turn);
  const double now = std::asin(std::clamp(towards_viewer(made).z, -1.0, 1.0));
  const double wanted = std::clamp(now + up.radians(), -0.5 * std::numbers::pi, 0.5 * std::numbers::pi);
  made.up = turned_about(made.up, made.right, now - wanted);
  // Rounding must not add up over a long drag.
  made.right = geom::normalised(made.right);
  made.up = geom::normalised(made.up - geom::dot(made.up, made.right) * made.right);
  return made;
}

Frame frame_of(const Camera& camera, const geom::Box3& shown, double exaggeration) {
  DOBRA_CHECK(!shown.empty() && exaggeration > 0.0);
  Frame frame;
  frame.camera = camera;
  frame.exaggeration = exaggeration;
  const Point3 target = camera.target.value_or(shown.centre());
  frame.target = {target.x, target.y, exaggeration * target.z};
  const Vector3 away = -towards_viewer(camera);
  Matrix4 projection;
  if (camera.projection == Projection::Oblique) {
    const double angle = camera.depth_angle.radians();
    projection = shear(camera.depth_factor * std::cos(angle), camera.depth_factor * std::sin(angle));
  } else if (camera.projection == Projection::Perspective) {
    Vector3 size = shown.high - shown.low;
    size.z *= exaggeration;
    const double diagonal = geom::length(size) > 0.0 ? geom::length(size) : 1.0;
    frame.distance = camera.distance > 0.0 ? camera.distance : usual_distance * diagonal;
    projection = perspective(frame.distance);
  }
  frame.matrix = projection * along(camera.right, camera.up, away) * translation(Point3{} - frame.target) *
                 scaling(1.0, 1.0, exaggeration);
  return frame;
}

std::optional<Projected> project(const Frame& frame, Point3 world) { return divided(frame.matrix * column(world)); }

geom::Box projected(const Frame& frame, const geom::Box3& box) {
  geom::Box made;
  for (int corner = 0; corner < 8; ++corner) {
    const Point3 at{(corner & 1) != 0 ? box.high.x : box.low.x, (corner & 2) != 0 ? box.high.y : box.low.y,
                    (corner & 4) != 0 ? box.high.z : box.low.z};
    if (const std::optional<Projected> seen = project(frame, at)) made.add(seen->at);
  }
  if (made.empty()) made.add(geom::Point{});  // all of it is behind the eye
  return made;
}

std::optional<Projected> project(const Sheet& sheet, Point3 world) {
  std::optional<Projected> seen = project(sheet.frame, world);
  if (seen) seen->at = sheet.page.to_page(seen->at);
  return seen;
}

namespace {

/// Of the exaggerated world, that it is easier to think in.
struct Sight {
  Point3 on_plane;
  Vector3 along;  ///< Away from the viewer, of any length.
};

Sight sight_at(const Frame& frame, geom::Point plane) {
  const Camera& camera = frame.camera;
  const Vector3 away = -towards_viewer(camera);
  Sight sight{frame.target + plane.x * camera.right + plane.y * camera.up, away};
  if (camera.projection == Projection::Oblique) {
    const double angle = camera.depth_angle.radians();
    sight.along =
        away - camera.depth_factor * std::cos(angle) * camera.right - camera.depth_factor * std::sin(angle) * camera.up;
  } else if (camera.projection == Projection::Perspective) {
    sight.along = sight.on_plane - (frame.target - frame.distance * away);
  }
  return sight;
}

Point3 without(double exaggeration, Point3 p) { return {p.x, p.y, p.z / exaggeration}; }

}  // namespace

Ray ray_at(const Sheet& sheet, geom::Point page, const geom::Box3& shown) {
  const Frame& frame = sheet.frame;
  const Sight sight = sight_at(frame, sheet.page.to_world(page));
  Point3 from = sight.on_plane;
  if (frame.distance > 0.0) {
    from = sight.on_plane - (1.0 - least_w) * sight.along;
  } else {
    const Point3 middle{shown.centre().x, shown.centre().y, frame.exaggeration * shown.centre().z};
    Vector3 size = shown.high - shown.low;
    size.z *= frame.exaggeration;
    from = from - (geom::length(size) + geom::distance(middle, from)) * geom::normalised(sight.along);
  }
  const Point3 a = without(frame.exaggeration, from);
  const Point3 b = without(frame.exaggeration, from + sight.along);
  return {a, geom::normalised(b - a)};
}

Point3 in_plane_of(const Sheet& sheet, geom::Point page, Point3 through) {
  const Frame& frame = sheet.frame;
  const Sight sight = sight_at(frame, sheet.page.to_world(page));
  const Vector3 away = -towards_viewer(frame.camera);
  const Point3 there{through.x, through.y, frame.exaggeration * through.z};
  const double steps = geom::dot(there - sight.on_plane, away) / geom::dot(sight.along, away);
  return without(frame.exaggeration, sight.on_plane + steps * sight.along);
}

}  // namespace dobra::scene::space
