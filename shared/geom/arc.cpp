#include "shared/geom/arc.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "shared/geom/predicates.h"

namespace dobra::geom {
namespace {

using base::Angle;
using base::Error;
using base::ErrorCode;
using base::Place;

constexpr double full_turn = 2.0 * std::numbers::pi;

Error error_at(ErrorCode code, std::string message, Point p) {
  Place place;
  place.x = p.x;
  place.y = p.y;
  return Error{code, std::move(message), place};
}

double angle_of(Vector v) { return std::atan2(v.y, v.x); }

/// Signed turn from one direction to another; a full turn if they are equal.
double turn(double from, double to, Orientation orientation) {
  const double difference = orientation == Orientation::Anticlockwise ? to - from : from - to;
  double positive = std::fmod(difference, full_turn);
  if (positive <= 0.0) positive += full_turn;
  return orientation == Orientation::Anticlockwise ? positive : -positive;
}

}  // namespace

base::Result<Arc> Arc::from_angles(Point centre, double radius, Angle start, Angle sweep) {
  if (!is_finite(centre) || !std::isfinite(radius) || !std::isfinite(start.radians()) ||
      !std::isfinite(sweep.radians())) {
    return Error{ErrorCode::NotFinite, "an arc needs finite numbers; correct its centre, radius or angles"};
  }
  if (!(radius > 0.0)) {
    return error_at(ErrorCode::DegenerateCurve, fmt::format("an arc needs a positive radius and has {}", radius),
                    centre);
  }
  const double swept = std::abs(sweep.radians());
  if (swept == 0.0) return error_at(ErrorCode::DegenerateCurve, "an arc needs a sweep other than zero", centre);
  if (swept > full_turn) {
    return error_at(ErrorCode::InvalidOption,
                    fmt::format("an arc sweeps at most 360 degrees and is asked for {:.10g}", sweep.degrees()), centre);
  }
  Arc arc;
  arc.centre_ = centre;
  arc.radius_ = radius;
  arc.start_ = start;
  arc.sweep_ = sweep;
  const auto end = [&](double angle) { return centre + radius * Vector{std::cos(angle), std::sin(angle)}; };
  arc.from_ = end(start.radians());
  arc.to_ = swept == full_turn ? arc.from_ : end(start.radians() + sweep.radians());
  return arc;
}

base::Result<Arc> Arc::from_ends(Point centre, Point from, Point to, Orientation orientation, double tolerance) {
  if (!is_finite(centre) || !is_finite(from) || !is_finite(to)) {
    return Error{ErrorCode::NotFinite, "an arc needs finite numbers; correct its centre or end points"};
  }
  const double from_distance = distance(centre, from);
  const double to_distance = distance(centre, to);
  const double radius = 0.5 * (from_distance + to_distance);
  if (from_distance == 0.0 || to_distance == 0.0) {
    return error_at(ErrorCode::DegenerateCurve, "an end of the arc is its centre; move one of them", centre);
  }
  if (std::abs(from_distance - to_distance) > tolerance * radius) {
    return error_at(ErrorCode::DegenerateCurve,
                    fmt::format("the ends of the arc are {:.10g} and {:.10g} away from its centre; make them equal",
                                from_distance, to_distance),
                    centre);
  }
  Arc arc;
  arc.centre_ = centre;
  arc.radius_ = radius;
  arc.start_ = Angle::from_radians(angle_of(from - centre));
  const double end = from == to ? arc.start_.radians() : angle_of(to - centre);
  arc.sweep_ = Angle::from_radians(turn(arc.start_.radians(), end, orientation));
  arc.from_ = from;
  arc.to_ = to;
  return arc;
}

base::Result<Arc> Arc::through(Point from, Point through, Point to) {
  if (!is_finite(from) || !is_finite(through) || !is_finite(to)) {
    return Error{ErrorCode::NotFinite, "an arc needs finite numbers; correct its three points"};
  }
  const Sign side = orient2d(from, through, to);
  if (side == Sign::Zero) {
    return error_at(ErrorCode::DegenerateCurve, "the three points of the arc lie on a line; move the middle one",
                    through);
  }
  // Circumcentre as seen from `through`, so that large coordinates do not cancel.
  const Vector u = from - through;
  const Vector v = to - through;
  const double doubled = 2.0 * cross(u, v);
  const Vector centre{(v.y * length_squared(u) - u.y * length_squared(v)) / doubled,
                      (u.x * length_squared(v) - v.x * length_squared(u)) / doubled};
  if (doubled == 0.0 || !std::isfinite(centre.x) || !std::isfinite(centre.y)) {
    return error_at(ErrorCode::DegenerateCurve,
                    "the three points of the arc are too nearly on a line; move the middle one", through);
  }
  // The ends lie on the circle by construction; what differs is rounding, so any difference is accepted.
  return from_ends(through + centre, from, to,
                   side == Sign::Positive ? Orientation::Anticlockwise : Orientation::Clockwise,
                   std::numeric_limits<double>::infinity());
}

base::Result<Arc> Arc::circle(Point centre, double radius, Orientation orientation) {
  const double sweep = orientation == Orientation::Anticlockwise ? full_turn : -full_turn;
  return from_angles(centre, radius, Angle{}, Angle::from_radians(sweep));
}

Point Arc::point(double t) const {
  if (t == 0.0) return from_;
  if (t == 1.0) return to_;
  const double angle = angle_at(t);
  return centre_ + radius_ * Vector{std::cos(angle), std::sin(angle)};
}

Vector Arc::tangent(double t) const {
  const double angle = angle_at(t);
  return radius_ * sweep_.radians() * Vector{-std::sin(angle), std::cos(angle)};
}

double Arc::length(double t0, double t1) const { return radius_ * std::abs(sweep_.radians() * (t1 - t0)); }

Box Arc::box() const {
  Box box;
  box.add(from_);
  box.add(to_);
  const double low = std::min(angle_at(0.0), angle_at(1.0));
  const double high = std::max(angle_at(0.0), angle_at(1.0));
  constexpr double quarter = 0.5 * std::numbers::pi;
  for (double k = std::ceil(low / quarter); k * quarter <= high; k += 1.0) {
    const auto axis = static_cast<int>(std::fmod(std::fmod(k, 4.0) + 4.0, 4.0));
    const Vector reach = axis % 2 == 0 ? Vector{radius_, 0.0} : Vector{0.0, radius_};
    box.add(axis < 2 ? centre_ + reach : centre_ - reach);
  }
  return box;
}

Arc Arc::reversed() const {
  Arc arc = *this;
  arc.start_ = start_ + sweep_;
  arc.sweep_ = -sweep_;
  std::swap(arc.from_, arc.to_);
  return arc;
}

}  // namespace dobra::geom
