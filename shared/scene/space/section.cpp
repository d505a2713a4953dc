#include "shared/scene/space/section.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace dobra::scene::space {

namespace {

using geom::Point3;
using geom::Vector3;

constexpr double thin = 0.08;           ///< Of the diagonal: the rim has this much room across a thin box.
constexpr double arrow_length = 0.15;   ///< Of the diagonal.
constexpr double seen_from_end = 12.0;  ///< Page: a shorter arrow points at the viewer.
constexpr int halvings = 40;
constexpr double least_turn = 1e-12;  ///< Sine of an angle that is none.

constexpr std::array<Vector3, 3> axes{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};

/// Space as it is seen, and back.
Vector3 exaggerated(Vector3 v, double by) { return {v.x, v.y, v.z * by}; }
Point3 exaggerated(Point3 p, double by) { return {p.x, p.y, p.z * by}; }
/// Normals go the other way, since what they are square to is stretched.
Vector3 seen_normal(Vector3 normal, double by) { return geom::normalised(exaggerated(normal, 1.0 / by)); }

geom::Box3 roomy(geom::Box3 box, double exaggeration) {
  const double least = thin * length(exaggerated(box.high - box.low, exaggeration));
  const auto widen = [](double& low, double& high, double wanted) {
    const double more = std::max(0.5 * (wanted - (high - low)), 0.0);
    low -= more;
    high += more;
  };
  widen(box.low.x, box.high.x, least);
  widen(box.low.y, box.high.y, least);
  widen(box.low.z, box.high.z, least / exaggeration);
  return box;
}

Point3 middle_of(const std::vector<Point3>& closed) {
  Vector3 sum{};
  for (std::size_t i = 0; i + 1 < closed.size(); ++i) sum = sum + (closed[i] - Point3{});
  return closed.size() < 2 ? closed.front() : Point3{} + sum / static_cast<double>(closed.size() - 1);
}

struct Nearest {
  double distance = std::numeric_limits<double>::infinity();
  double part = 0.0;
};

/// Of the way from a to b, as both are seen.
Nearest nearest_on(const Sheet& sheet, Point3 a, Point3 b, geom::Point page) {
  const auto from = project(sheet, a), to = project(sheet, b);
  if (!from || !to) return {};
  const geom::Vector way = to->at - from->at;
  const double squared = dot(way, way);
  const double seen = squared > 0.0 ? std::clamp(dot(page - from->at, way) / squared, 0.0, 1.0) : 0.0;
  const double distance = geom::distance(page, from->at + seen * way);
  if (sheet.frame.distance == 0.0 || !(squared > 0.0)) return {distance, seen};
  double low = 0.0, high = 1.0;  // what is farther away is seen shorter: parts are halved
  for (int i = 0; i < halvings; ++i) {
    const double part = 0.5 * (low + high);
    const auto at = project(sheet, a + part * (b - a));
    (at && dot(at->at - from->at, way) < seen * squared ? low : high) = part;
  }
  return {distance, 0.5 * (low + high)};
}

struct OnRim {
  double distance = std::numeric_limits<double>::infinity();  ///< Page;
  double depth = 0.0;
  Point3 at{};
};

/// Of sides at one place of the page the nearer one. A side that leads away from the viewer goes before those that end
/// there, and is held where it is nearest to the middle: a plane that is seen as a line turns within the page by its
/// ends.
OnRim nearest_on_rim(const Handle& handle, const Sheet& sheet, geom::Point page) {
  constexpr double at_one_place = 0.5;
  OnRim best;
  for (std::size_t i = 0; i + 1 < handle.rim.size(); ++i) {
    const Point3 a = handle.rim[i];
    const Vector3 side = handle.rim[i + 1] - a;
    Nearest found = nearest_on(sheet, a, a + side, page);
    const auto from = project(sheet, a), to = project(sheet, a + side);
    if (from && to && dot(side, side) > 0.0 && geom::distance(from->at, to->at) < seen_from_end) {
      found.part = std::clamp(dot(handle.middle - a, side) / dot(side, side), 0.0, 1.0);
      found.distance -= 0.5 * seen_from_end;
    }
    const Point3 at = a + found.part * side;
    const auto seen = project(sheet, at);
    if (!seen) continue;
    const double nearer = found.distance - best.distance;
    if (nearer < -at_one_place || (nearer <= at_one_place && seen->depth < best.depth))
      best = {found.distance, seen->depth, at};
  }
  return best;
}

/// Where the ray comes nearest to a line, lengths along its unit vector.
double along_line(const Ray& ray, Point3 from, Vector3 unit) {
  const Vector3 w = from - ray.from;
  const double b = dot(unit, ray.along);
  const double sine2 = 1.0 - b * b;
  return sine2 > least_turn ? (b * dot(ray.along, w) - dot(unit, w)) / sine2 : 0.0;
}

/// Turned as `from` is turned onto `to` on the shortest way; nothing: they are opposite. @pre unit vectors
std::optional<Vector3> turned_with(Vector3 v, Vector3 from, Vector3 to) {
  const Vector3 axis = cross(from, to);
  const double cosine = dot(from, to);
  if (length(axis) < least_turn) return cosine > 0.0 ? std::optional(v) : std::nullopt;
  return geom::normalised(cosine * v + cross(axis, v) + (dot(axis, v) / (1.0 + cosine)) * axis);
}

/// The same cut with a normal that points along its axis.
Section along_axis(Section section, Vector3 axis) {
  if (dot(section.normal, axis) < 0.0) {
    section.other_side = !section.other_side;
    section.part = 1.0 - section.part;
  }
  section.normal = axis;
  return section;
}

}  // namespace

Section section_across(CutAxis axis, double part, bool other_side) {
  return {axes[static_cast<std::size_t>(axis)], part, other_side};
}

std::optional<CutAxis> axis_of(const Section& section) {
  for (const CutAxis axis : {CutAxis::X, CutAxis::Y, CutAxis::Z}) {
    const Vector3& unit = axes[static_cast<std::size_t>(axis)];
    if (section.normal == unit || section.normal == -unit) return axis;
  }
  return std::nullopt;
}

Reach reach_along(const Vector3& normal, const geom::Box3& box) {
  Reach reach;
  const auto add = [&](double n, double low, double high) {
    reach.from += n * (n < 0.0 ? high : low);
    reach.to += n * (n < 0.0 ? low : high);
  };
  add(normal.x, box.low.x, box.high.x);
  add(normal.y, box.low.y, box.high.y);
  add(normal.z, box.low.z, box.high.z);
  return reach;
}

double place_of(const Section& section, const geom::Box3& box) {
  const Reach reach = reach_along(section.normal, box);
  return reach.from + section.part * (reach.to - reach.from);
}

Section placed(Section section, const geom::Box3& box, double place) {
  const Reach reach = reach_along(section.normal, box);
  if (reach.to > reach.from) section.part = std::clamp((place - reach.from) / (reach.to - reach.from), 0.0, 1.0);
  return section;
}

CutPlane plane_of(const Section& section, const geom::Box3& box) {
  const Vector3 normal = section.other_side ? -section.normal : section.normal;
  if (const auto axis = axis_of(section); axis && section.normal == axes[static_cast<std::size_t>(*axis)])
    return plane_across(*axis, section.part, box, section.other_side);
  const double off = place_of(section, box) - dot(box.centre() - Point3{}, section.normal);
  return {box.centre() + off * section.normal, normal};
}

Handle handle_of(const Section& section, const geom::Box3& box, double exaggeration) {
  Handle handle;
  handle.exaggeration = exaggeration;
  const CutPlane plane = plane_of(section, box);
  handle.rim = frame_of(plane, roomy(box, exaggeration));
  handle.middle = middle_of(handle.rim);
  const double size = length(exaggerated(box.high - box.low, exaggeration));
  const double stretch = length(exaggerated(plane.normal, exaggeration));
  handle.tip = handle.middle + (arrow_length * size / stretch) * plane.normal;
  return handle;
}

std::optional<Grip> grip_at(const Handle& handle, const Sheet& sheet, geom::Point page, double tolerance) {
  if (nearest_on(sheet, handle.middle, handle.tip, page).distance <= tolerance) return Grip::Arrow;
  if (nearest_on_rim(handle, sheet, page).distance <= tolerance) return Grip::Rim;
  return std::nullopt;
}

SectionDrag::SectionDrag(const Section& begin, const geom::Box3& box, const Handle& handle, Grip grip,
                         const Sheet& sheet, geom::Point page)
    : begin_(begin), box_(box), handle_(handle), grip_(grip), pressed_(page) {
  if (grip == Grip::Arrow) return;
  const Point3 held = nearest_on_rim(handle, sheet, page).at;
  arm_ = arm_now_ = exaggerated(held - handle.middle, handle.exaggeration);
  if (const auto seen = project(sheet, held)) off_ = seen->at - page;
}

Section SectionDrag::to(const Sheet& sheet, geom::Point page) {
  return grip_ == Grip::Arrow ? moved(sheet, page) : turned(sheet, page);
}

Section SectionDrag::moved(const Sheet& sheet, geom::Point page) const {
  const auto from = project(sheet, handle_.middle), to = project(sheet, handle_.tip);
  if (!from || !to) return begin_;
  const geom::Vector way = to->at - from->at;
  double by = 0.0;
  if (geom::length(way) >= seen_from_end) {
    // What is nearest to the hand on the line of the arrow on the page; the ray there meets the arrow's line.
    const auto along = [&](geom::Point hand) {
      const geom::Point on_line = from->at + (dot(hand - from->at, way) / dot(way, way)) * way;
      return along_line(ray_at(sheet, on_line, box_), handle_.middle, begin_.normal);
    };
    by = along(page) - along(pressed_);
  } else {
    const Camera& camera = sheet.frame.camera;
    const Vector3 ray = ray_to_viewer(camera);
    const Vector3 to_viewer = ray.x * camera.right + ray.y * camera.up + ray.z * towards_viewer(camera);
    const Vector3 seen = exaggerated(begin_.normal, handle_.exaggeration);
    const double side = dot(seen, to_viewer) < 0.0 ? -1.0 : 1.0;
    by = side * (pressed_.y - page.y) / sheet.page.points_per_x / geom::length(seen);
  }
  return placed(begin_, box_, place_of(begin_, box_) + by);
}

Section SectionDrag::turned(const Sheet& sheet, geom::Point page) {
  const double radius = geom::length(arm_);
  if (!(radius > 0.0)) return begin_;
  const double by = handle_.exaggeration;
  const Ray ray = ray_at(sheet, page + off_, box_);
  const Point3 middle = exaggerated(handle_.middle, by);
  const Vector3 along = geom::normalised(exaggerated(ray.along, by));
  const Vector3 w = exaggerated(ray.from, by) - middle;
  const Vector3 across = w - dot(w, along) * along;  // from the middle to where the ray passes it
  const double half2 = radius * radius - dot(across, across);
  Vector3 arm;
  if (half2 > 0.0) {  // the ray meets the sphere twice: where the hand came from
    const Vector3 near = (across - std::sqrt(half2) * along) / radius,
                  far = (across + std::sqrt(half2) * along) / radius;
    arm = dot(near, arm_now_) >= dot(far, arm_now_) ? near : far;
  } else {
    arm = geom::normalised(across);
  }
  const auto normal = turned_with(seen_normal(begin_.normal, by), arm_ / radius, arm);
  arm_now_ = radius * arm;
  if (!normal) return begin_;
  Section section = begin_;
  section.normal = geom::normalised(exaggerated(*normal, by));
  for (const Vector3& axis : axes) {
    const double cosine = dot(*normal, axis);
    if (std::abs(cosine) < std::cos(square_within * std::numbers::pi / 180.0)) continue;
    section.normal = std::copysign(1.0, cosine) * axis;
    return along_axis(placed(section, box_, dot(handle_.middle - Point3{}, section.normal)), axis);
  }
  return placed(section, box_, dot(handle_.middle - Point3{}, section.normal));
}

}  // namespace dobra::scene::space
