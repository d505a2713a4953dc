// Planes and surfaces of revolution of a line or a circle.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "shared/surf/surface.h"

namespace dobra::surf {

using base::Error;
using base::ErrorCode;
using geom::Box;
using geom::Point;
using geom::Vector3;

namespace {

constexpr double pi = std::numbers::pi;

struct PlaneShape : Surface::Shape {
  Frame frame;
  explicit PlaneShape(const Frame& axes) : frame(axes) {}
  void jets(std::span<const Point> uv, std::span<Jet> jets) const override {
    for (std::size_t i = 0; i < uv.size(); ++i)
      jets[i] = {frame.origin + uv[i].x * frame.x + uv[i].y * frame.y, frame.x, frame.y, {}, {}, {}};
  }
  [[nodiscard]] Bend bend(const Box&) const override { return {}; }
};

/// A profile in the plane of axis and radius, by v: distance from the axis and height along it, with derivatives.
struct Profile {
  double r, r1, r2;
  double z, z1, z2;
};

/// origin + r(v) (cos u x + sin u y) + z(v) z.
template <class ProfileAt>
struct TurnedShape : Surface::Shape {
  Frame frame;
  ProfileAt profile;
  double bent;  ///< No second derivative of the profile is longer.
  TurnedShape(const Frame& axes, ProfileAt at, double most) : frame(axes), profile(at), bent(most) {}
  [[nodiscard]] Bend bend(const Box& part) const override {
    const double half = 0.5 * part.height();
    const Profile p = profile(part.centre().y);
    const double slope = std::abs(p.r1) + half * bent;
    return {std::abs(p.r) + half * slope, slope, bent};
  }
  void jets(std::span<const Point> uv, std::span<Jet> jets) const override {
    for (std::size_t i = 0; i < uv.size(); ++i) {
      const double c = std::cos(uv[i].x), s = std::sin(uv[i].x);
      const Vector3 out = c * frame.x + s * frame.y, round = c * frame.y - s * frame.x;
      const Profile p = profile(uv[i].y);
      jets[i] = {frame.origin + p.r * out + p.z * frame.z,
                 p.r * round,
                 p.r1 * out + p.z1 * frame.z,
                 -p.r * out,
                 p.r1 * round,
                 p.r2 * out + p.z2 * frame.z};
    }
  }
};

template <class ProfileAt>
std::shared_ptr<const Surface::Shape> turned(const Frame& frame, ProfileAt profile, double bent) {
  return std::make_shared<const TurnedShape<ProfileAt>>(frame, profile, bent);
}

bool is_finite(const Frame& frame) {
  return geom::is_finite(frame.origin) && geom::is_finite(frame.x) && geom::is_finite(frame.y) &&
         geom::is_finite(frame.z);
}

/// @error NotFinite; InvalidOption: axes that are not of unit length at right angles
base::Result<void> check(const Frame& frame) {
  if (!is_finite(frame)) return Error{ErrorCode::NotFinite, "the frame of the surface has a number that is not finite"};
  constexpr double square = 1e-9;
  const bool unit = std::abs(geom::length(frame.x) - 1.0) < square && std::abs(geom::length(frame.y) - 1.0) < square &&
                    std::abs(geom::length(frame.z) - 1.0) < square;
  if (!unit || std::abs(dot(frame.x, frame.y)) > square || std::abs(dot(frame.y, frame.z)) > square ||
      std::abs(dot(frame.z, frame.x)) > square)
    return Error{ErrorCode::InvalidOption, "the axes of the frame are not of unit length at right angles"};
  return {};
}

base::Result<void> check_turn(const Box& chart) {
  if (chart.high.x - chart.low.x > 2.0 * pi * (1.0 + 1e-12))
    return Error{ErrorCode::InvalidOption,
                 fmt::format("u goes from {} to {} radians; a full turn is the most", chart.low.x, chart.high.x)};
  return {};
}

base::Result<void> check_radius(double radius, const char* called) {
  if (!std::isfinite(radius)) return Error{ErrorCode::NotFinite, fmt::format("{} is not finite", called)};
  if (!(radius > 0.0))
    return Error{ErrorCode::DegenerateCurve, fmt::format("{} is {}; it must be above 0", called, radius)};
  return {};
}

/// Ends that are meant to be a pole or an apex, and miss it by rounding, are taken as it.
double snapped(double v, double to) { return std::abs(v - to) <= 1e-12 * std::max(1.0, std::abs(to)) ? to : v; }

}  // namespace

base::Result<Surface> Surface::plane(const Frame& frame, const Box& chart) {
  if (!is_finite(frame)) return Error{ErrorCode::NotFinite, "the frame of the plane has a number that is not finite"};
  if (geom::length(cross(frame.x, frame.y)) <= 1e-12 * geom::length(frame.x) * geom::length(frame.y))
    return Error{ErrorCode::DegenerateCurve, "the axes of the plane are parallel"};
  return make(std::make_shared<const PlaneShape>(frame), chart);
}

base::Result<Surface> Surface::cylinder(const Frame& frame, double radius, const Box& chart) {
  DOBRA_TRY_VOID(check(frame));
  DOBRA_TRY_VOID(check_radius(radius, "the radius of the cylinder"));
  DOBRA_TRY_VOID(check_turn(chart));
  return make(turned(
                  frame, [radius](double v) { return Profile{radius, 0.0, 0.0, v, 1.0, 0.0}; }, 0.0),
              chart);
}

base::Result<Surface> Surface::cone(const Frame& frame, double radius, double half_angle, const Box& wanted) {
  DOBRA_TRY_VOID(check(frame));
  DOBRA_TRY_VOID(check_turn(wanted));
  if (!std::isfinite(radius) || !std::isfinite(half_angle))
    return Error{ErrorCode::NotFinite, "radius or angle of the cone is not finite"};
  if (!(std::abs(half_angle) > 1e-12 && std::abs(half_angle) < 0.5 * pi - 1e-12))
    return Error{ErrorCode::InvalidOption,
                 fmt::format("the half angle of the cone is {} radians; it must be less than a "
                             "quarter turn, and not 0",
                             half_angle)};
  const double s = std::sin(half_angle), c = std::cos(half_angle), apex = -radius / s;
  Box chart = wanted;
  chart.low.y = snapped(chart.low.y, apex);
  chart.high.y = snapped(chart.high.y, apex);
  if (chart.low.y < apex && apex < chart.high.y)
    return Error{ErrorCode::InvalidOption,
                 fmt::format("the apex of the cone (v = {}) is inside; cut the cone there", apex)};
  return make(turned(
                  frame, [=](double v) { return Profile{(v - apex) * s, s, 0.0, v * c, c, 0.0}; }, 0.0),
              chart);
}

base::Result<Surface> Surface::sphere(const Frame& frame, double radius, const Box& wanted) {
  DOBRA_TRY_VOID(check(frame));
  DOBRA_TRY_VOID(check_radius(radius, "the radius of the sphere"));
  DOBRA_TRY_VOID(check_turn(wanted));
  Box chart = wanted;
  chart.low.y = snapped(chart.low.y, -0.5 * pi);
  chart.high.y = snapped(chart.high.y, 0.5 * pi);
  if (chart.low.y < -0.5 * pi || chart.high.y > 0.5 * pi)
    return Error{ErrorCode::InvalidOption, "latitudes of a sphere lie between a quarter turn below and above"};
  return make(turned(
                  frame,
                  [radius](double v) {
                    const double c = radius * std::cos(v), s = radius * std::sin(v);
                    return Profile{c, -s, -c, s, c, -s};
                  },
                  radius),
              chart);
}

base::Result<Surface> Surface::torus(const Frame& frame, double major, double minor, const Box& chart) {
  DOBRA_TRY_VOID(check(frame));
  DOBRA_TRY_VOID(check_radius(minor, "the minor radius of the torus"));
  DOBRA_TRY_VOID(check_radius(major, "the major radius of the torus"));
  DOBRA_TRY_VOID(check_turn(chart));
  if (minor > major)
    return Error{ErrorCode::InvalidOption,
                 fmt::format("the minor radius of the torus ({}) is above the major one ({}): "
                             "it would cross itself",
                             minor, major)};
  if (chart.high.y - chart.low.y > 2.0 * pi * (1.0 + 1e-12))
    return Error{ErrorCode::InvalidOption, "v of the torus goes round more than once"};
  return make(turned(
                  frame,
                  [major, minor](double v) {
                    const double c = minor * std::cos(v), s = minor * std::sin(v);
                    return Profile{major + c, -s, -c, s, c, -s};
                  },
                  minor),
              chart);
}

}  // namespace dobra::surf
