#include "shared/geom/discretise.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "shared/geom/place.h"

namespace dobra::geom {
namespace {

using base::Angle;
using base::Error;
using base::ErrorCode;

/// Beyond this many initial segments the limits, not the curve, are wrong.
constexpr double greatest_count = 1e8;

double angle_between(Vector a, Vector b) { return std::atan2(std::abs(cross(a, b)), dot(a, b)); }
double angle_between(Vector3 a, Vector3 b) { return std::atan2(length(cross(a, b)), dot(a, b)); }

double greatest_coordinate(Point p) { return std::max(std::abs(p.x), std::abs(p.y)); }
double greatest_coordinate(Point3 p) { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}); }

base::Place place_of(Point p) { return place_at(p); }
base::Place place_of(Point3 p) { return {.x = p.x, .y = p.y, .z = p.z}; }

template <class T>
bool vanishes(T v) {
  return v == T{};
}

base::Result<void> check_options(const DiscretiseOptions& options) {
  if (!(options.max_angle.radians() > 0.0)) {
    return Error{ErrorCode::InvalidOption,
                 fmt::format("the greatest angle must be positive and is {} degrees", options.max_angle.degrees())};
  }
  if (!(options.max_length > 0.0)) {
    return Error{ErrorCode::InvalidOption,
                 fmt::format("the greatest length must be positive and is {}", options.max_length)};
  }
  if (!(options.slack >= 0.0)) {
    return Error{ErrorCode::InvalidOption, fmt::format("the slack must not be negative and is {}", options.slack)};
  }
  return {};
}

/// Step 1 of the page: n = length / max_length, rounded up.
template <class Functions>
base::Result<std::size_t> initial_count(const Functions& curve, const DiscretiseOptions& options) {
  const double length = curve.length(0.0, 1.0);
  if (!std::isfinite(length)) return Error{ErrorCode::NotFinite, "the length of the curve is not a finite number"};
  if (!(length > 0.0))
    return Error{ErrorCode::DegenerateCurve, "the curve has no length; remove it or move its points"};
  const double count = std::ceil(length / options.max_length * (1.0 - options.slack));
  if (count > greatest_count) {
    return Error{ErrorCode::InvalidOption,
                 fmt::format("a greatest length of {} cuts a curve of length {} into more than {:g} segments; raise it",
                             options.max_length, length, greatest_count)};
  }
  return std::max<std::size_t>(1, static_cast<std::size_t>(count));
}

/// What turns one way by no more than max_angle is no longer than chord / cos(max_angle / 2). A piece that is longer
/// winds about, though its tangents at both ends and in the middle agree: two full turns of a spiral do.
template <class Functions>
bool winds_about(const Functions& curve, double t0, double t1, const DiscretiseOptions& options) {
  const double half = 0.5 * options.max_angle.radians();
  if (half >= 0.5 * std::numbers::pi) return false;
  const auto from = curve.point(t0);
  const auto to = curve.point(t1);
  const double size = std::max(greatest_coordinate(from), greatest_coordinate(to));
  const double rounding = 8.0 * std::numeric_limits<double>::epsilon() * size;
  return curve.length(t0, t1) > (1.0 + options.slack) * distance(from, to) / std::cos(half) + rounding;
}

template <class Functions>
Angle turn_over(const Functions& curve, double t0, double t1) {
  const double middle = 0.5 * (t0 + t1);
  const auto first_chord = curve.point(middle) - curve.point(t0);
  const auto second_chord = curve.point(t1) - curve.point(middle);
  const auto tangent = [&](double t, auto instead) {
    const auto own = curve.tangent(t);
    return vanishes(own) ? instead : own;
  };
  const auto start = tangent(t0, first_chord);
  const auto end = tangent(t1, second_chord);
  const auto at_middle = tangent(middle, second_chord);
  return Angle::from_radians(angle_between(start, at_middle) + angle_between(at_middle, end));
}

template <class Functions>
bool fine_enough(const Functions& curve, double t0, double t1, const DiscretiseOptions& options) {
  const double excess = 1.0 + options.slack;
  const double length = curve.length(t0, t1);
  if (options.max_length_over && !(length <= excess * options.max_length_over(t0, t1))) return false;
  return length <= excess * options.max_length && turn_over(curve, t0, t1) <= excess * options.max_angle &&
         !winds_about(curve, t0, t1, options);
}

/// Steps ii to v for one initial segment: appends the parameters after t0, up to t1.
template <class Functions>
base::Result<void> bisect(const Functions& curve, double t0, double t1, const DiscretiseOptions& options,
                          std::vector<double>& parameters) {
  struct Piece {
    double from, to;
    std::size_t depth;
  };
  std::vector<Piece> open{{t0, t1, 0}};
  while (!open.empty()) {
    const Piece piece = open.back();
    open.pop_back();
    if (fine_enough(curve, piece.from, piece.to, options)) {
      parameters.push_back(piece.to);
      continue;
    }
    const double middle = 0.5 * (piece.from + piece.to);
    if (piece.depth == options.max_depth || middle == piece.from || middle == piece.to) {
      return Error{
          ErrorCode::DegenerateCurve,
          fmt::format("after {} bisections a piece of the curve of length {:.3g} still turns by {:.3g} degrees; "
                      "split the curve at its corner",
                      piece.depth, curve.length(piece.from, piece.to),
                      turn_over(curve, piece.from, piece.to).degrees()),
          place_of(curve.point(middle))};
    }
    open.push_back({middle, piece.to, piece.depth + 1});
    open.push_back({piece.from, middle, piece.depth + 1});
  }
  return {};
}

/// The method, for curves of the plane and of space.
template <class Functions>
base::Result<std::vector<double>> parameters_of(const Functions& curve, const DiscretiseOptions& options) {
  DOBRA_TRY_VOID(check_options(options));
  DOBRA_TRY(const std::size_t count, initial_count(curve, options));
  std::vector<double> parameters{0.0};
  for (std::size_t i = 0; i < count; ++i) {
    // i / n rather than sums of 1 / n, so that the last parameter is exactly 1.
    const double t0 = static_cast<double>(i) / static_cast<double>(count);
    const double t1 = static_cast<double>(i + 1) / static_cast<double>(count);
    DOBRA_TRY_VOID(bisect(curve, t0, t1, options, parameters));
  }
  for (const double t : parameters) {
    if (is_finite(curve.point(t))) continue;
    return Error{ErrorCode::NotFinite, fmt::format("the curve has no finite point at parameter {:.10g}", t)};
  }
  return parameters;
}

}  // namespace

Polyline Discretisation::polyline() const {
  Polyline line{points, points.size() > 3 && points.front() == points.back()};
  if (line.closed) line.points.pop_back();
  return line;
}

Angle tangent_turn(const CurveFunctions& curve, double t0, double t1) { return turn_over(curve, t0, t1); }
Angle tangent_turn(const SpaceCurveFunctions& curve, double t0, double t1) { return turn_over(curve, t0, t1); }

base::Result<Discretisation> discretise(const CurveFunctions& curve, const DiscretiseOptions& options) {
  Discretisation result;
  DOBRA_TRY(result.parameters, parameters_of(curve, options));
  result.points.reserve(result.parameters.size());
  for (const double t : result.parameters) result.points.push_back(curve.point(t));
  return result;
}

base::Result<std::vector<double>> discretise(const SpaceCurveFunctions& curve, const DiscretiseOptions& options) {
  return parameters_of(curve, options);
}

}  // namespace dobra::geom
