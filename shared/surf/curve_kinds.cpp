// Lines and conics by their own parameters, and curves made of curves: moved, over another range, offset, with other
// ends.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "shared/surf/curve.h"

namespace dobra::surf {

using base::Error;
using base::ErrorCode;
using geom::Point3;
using geom::Vector3;

namespace {

struct StraightShape : Curve::Shape {
  Point3 origin;
  Vector3 along;
  StraightShape(Point3 at, Vector3 way) : origin(at), along(way) {}
  [[nodiscard]] Curve::Jet jet(double t) const override { return {origin + t * along, along, {}}; }
  [[nodiscard]] double bend(double, double) const override { return 0.0; }
};

struct ConicShape : Curve::Shape {
  Curve::Conic kind;
  Point3 centre;
  Vector3 along, across;
  ConicShape(Curve::Conic which, Point3 middle, Vector3 x, Vector3 y)
      : kind(which), centre(middle), along(x), across(y) {}
  [[nodiscard]] Curve::Jet jet(double t) const override {
    if (kind == Curve::Conic::Parabola)
      return {centre + (t * t * along + t * across), 2.0 * t * along + across, 2.0 * along};
    const bool round = kind == Curve::Conic::Ellipse;
    const double c = round ? std::cos(t) : std::cosh(t), s = round ? std::sin(t) : std::sinh(t);
    const Vector3 out = c * along + s * across;
    const double sign = round ? -1.0 : 1.0;
    return {centre + out, sign * s * along + c * across, sign * out};
  }
  [[nodiscard]] double bend(double from, double to) const override {
    const double x = geom::length(along), y = geom::length(across);
    if (kind == Curve::Conic::Parabola) return 2.0 * x;
    if (kind == Curve::Conic::Ellipse) return std::hypot(x, y);
    const double far = std::max(std::abs(from), std::abs(to));
    return std::cosh(far) * x + std::sinh(far) * y;
  }
};

struct MovedCurve : Curve::Shape {
  Curve of;
  Vector3 x, y, z;
  Point3 to;
  double most;  ///< No vector grows by more.
  MovedCurve(const Curve& curve, Vector3 a, Vector3 b, Vector3 c, Point3 origin)
      : of(curve), x(a), y(b), z(c), to(origin), most(std::hypot(geom::length(a), geom::length(b), geom::length(c))) {}
  [[nodiscard]] Vector3 image(Vector3 v) const { return v.x * x + v.y * y + v.z * z; }
  [[nodiscard]] Curve::Jet jet(double t) const override {
    const Curve::Jet jet = of.jet(t);
    return {to + image(jet.at - Point3{}), image(jet.first), image(jet.second)};
  }
  [[nodiscard]] double bend(double from, double end) const override { return most * of.bend(from, end); }
};

/// A closed curve by its parameter modulo its range.
struct RoundCurve : Curve::Shape {
  Curve of;
  double end;  ///< The last parameter: there the derivatives of the left are meant.
  RoundCurve(const Curve& curve, double high) : of(curve), end(high) {}
  [[nodiscard]] double folded(double t) const {
    const double period = of.high() - of.low();
    const double turns = std::floor((t - of.low()) / period);
    const double in = std::clamp(t - turns * period, of.low(), of.high());
    return t == end && in == of.low() ? of.high() : in;
  }
  [[nodiscard]] Curve::Jet jet(double t) const override { return of.jet(folded(t)); }
  [[nodiscard]] double bend(double from, double to) const override {
    const double a = folded(from), b = folded(to);
    if (to - from >= of.high() - of.low()) return of.bend(of.low(), of.high());
    if (a < b) return of.bend(a, b);
    return std::max(a < of.high() ? of.bend(a, of.high()) : 0.0, of.low() < b ? of.bend(of.low(), b) : 0.0);
  }
};

/// Weights of a first derivative by five values at steps of one, at value number [k].
constexpr std::array<std::array<double, 5>, 5> five_values{{{-25.0 / 12.0, 4.0, -3.0, 4.0 / 3.0, -0.25},
                                                            {-0.25, -5.0 / 6.0, 1.5, -0.5, 1.0 / 12.0},
                                                            {1.0 / 12.0, -2.0 / 3.0, 0.0, 2.0 / 3.0, -1.0 / 12.0},
                                                            {-1.0 / 12.0, 0.5, -1.5, 5.0 / 6.0, 0.25},
                                                            {0.25, -4.0 / 3.0, 3.0, -4.0, 25.0 / 12.0}}};

struct OffsetCurveShape : Curve::Shape {
  Curve of;
  double distance;
  Vector3 direction;  ///< Of unit length.
  OffsetCurveShape(const Curve& curve, double by, Vector3 along) : of(curve), distance(by), direction(along) {}

  /// Place and first derivative.
  [[nodiscard]] Curve::Jet first(double t) const {
    const Curve::Jet jet = of.jet(t);
    const Vector3 out = cross(jet.first, direction), turn = cross(jet.second, direction);
    const double size = geom::length(out);
    const Vector3 unit = out / size;
    return {jet.at + distance * unit, jet.first + (distance / size) * (turn - dot(turn, unit) * unit), {}};
  }
  [[nodiscard]] Curve::Jet jet(double t) const override {
    Curve::Jet jet = first(t);
    const std::vector<double>& breaks = of.breaks();
    auto next = std::upper_bound(breaks.begin(), breaks.end(), t);
    if (next == breaks.end()) --next;
    if (next == breaks.begin()) ++next;
    const double low = *(next - 1), high = *next, step = 2e-3 * (high - low);
    // The five places lie in the piece; the last of them before its end, where the next piece begins.
    const int before = std::clamp(static_cast<int>(std::floor((t - low) / step)), 0, 2);
    const int after = std::clamp(static_cast<int>(std::floor((high - t) / step - 1e-6)), 0, 2);
    const int left = before < 2 ? before : 4 - after;
    for (int i = 0; i < 5; ++i)
      jet.second = jet.second + five_values[static_cast<std::size_t>(left)][static_cast<std::size_t>(i)] / step *
                                    first(t + (i - left) * step).first;
    return jet;
  }
  [[nodiscard]] double bend(double from, double to) const override {
    constexpr int places = 33;
    double most = 0.0;
    for (int i = 0; i < places; ++i)
      most = std::max(most, geom::length(jet(std::lerp(from, to, (i + 0.5) / places)).second));
    return 1.5 * most;
  }
};

struct ReachingShape : Curve::Shape {
  Curve of;
  double low, high;
  Point3 first, last;
  Vector3 by_low, by_high;
  ReachingShape(const Curve& curve, double from, Point3 at_from, double to, Point3 at_to)
      : of(curve),
        low(from),
        high(to),
        first(at_from),
        last(at_to),
        by_low(at_from - curve.at(from)),
        by_high(at_to - curve.at(to)) {}
  [[nodiscard]] Curve::Jet jet(double t) const override {
    Curve::Jet jet = of.jet(t);
    const double s = (t - low) / (high - low);
    jet.at = t == low ? first : t == high ? last : jet.at + ((1.0 - s) * by_low + s * by_high);
    jet.first = jet.first + (by_high - by_low) / (high - low);
    return jet;
  }
  [[nodiscard]] double bend(double from, double to) const override { return of.bend(from, to); }
};

struct HeldShape : Curve::Shape {
  Curve of;
  geom::Point low, high;
  HeldShape(const Curve& curve, geom::Point from, geom::Point to) : of(curve), low(from), high(to) {}
  [[nodiscard]] Curve::Jet jet(double t) const override {
    Curve::Jet jet = of.jet(t);
    if (jet.at.x < low.x || jet.at.x > high.x)
      jet.at.x = std::clamp(jet.at.x, low.x, high.x), jet.first.x = jet.second.x = 0.0;
    if (jet.at.y < low.y || jet.at.y > high.y)
      jet.at.y = std::clamp(jet.at.y, low.y, high.y), jet.first.y = jet.second.y = 0.0;
    return jet;
  }
  [[nodiscard]] double bend(double from, double to) const override { return of.bend(from, to); }
};

base::Result<void> check_range(double from, double to) {
  if (!std::isfinite(from) || !std::isfinite(to))
    return Error{ErrorCode::NotFinite, "an end of the curve's range is not finite"};
  if (!(from < to))
    return Error{ErrorCode::DegenerateCurve, fmt::format("the curve goes from {} to {}; its range is empty", from, to)};
  return {};
}

}  // namespace

base::Result<Curve> Curve::line(Point3 at, Vector3 along, double from, double to) {
  if (!geom::is_finite(at) || !geom::is_finite(along))
    return Error{ErrorCode::NotFinite, "the line has a number that is not finite"};
  if (along == Vector3{}) return Error{ErrorCode::DegenerateCurve, "the line has no direction"};
  DOBRA_TRY_VOID(check_range(from, to));
  return Curve(std::make_shared<const StraightShape>(at, along), {from, to});
}

base::Result<Curve> Curve::conic(Conic kind, Point3 centre, Vector3 along, Vector3 across, double from, double to) {
  if (!geom::is_finite(centre) || !geom::is_finite(along) || !geom::is_finite(across))
    return Error{ErrorCode::NotFinite, "the conic has a number that is not finite"};
  if (!(geom::length(cross(along, across)) > 1e-12 * geom::length(along) * geom::length(across)))
    return Error{ErrorCode::DegenerateCurve, "the axes of the conic are parallel, or one has no length"};
  DOBRA_TRY_VOID(check_range(from, to));
  return Curve(std::make_shared<const ConicShape>(kind, centre, along, across), {from, to});
}

Curve Curve::moved(Vector3 x, Vector3 y, Vector3 z, Point3 to) const {
  return Curve(std::make_shared<const MovedCurve>(*this, x, y, z, to), breaks_);
}

base::Result<Curve> Curve::over(double from, double to) const {
  DOBRA_TRY_VOID(check_range(from, to));
  std::vector<double> inside;
  const double period = high_ - low_;
  const bool beyond = from < low_ || to > high_;
  double size = 0.0;
  for (int i = 1; i <= 16 && beyond; ++i)
    size = std::max(size, geom::distance(at(low_), at(std::lerp(low_, high_, i / 17.0))));
  const bool round = beyond && (to - from) < 1e6 * period && geom::distance(at(low_), at(high_)) <= 1e-9 * size;
  const auto add = [&](double shift) {
    for (const double each : breaks_) {
      if (each + shift > from && each + shift < to) inside.push_back(each + shift);
    }
  };
  if (round) {
    for (double turn = std::floor((from - low_) / period); low_ + turn * period <= to; turn += 1.0) add(turn * period);
  } else {
    add(0.0);
  }
  inside.push_back(from);
  inside.push_back(to);
  std::sort(inside.begin(), inside.end());
  inside.erase(std::unique(inside.begin(), inside.end()), inside.end());
  if (!round) return Curve(shape_, std::move(inside));
  return Curve(std::make_shared<const RoundCurve>(*this, to), std::move(inside));
}

base::Result<Curve> Curve::offset(double distance, Vector3 direction) const {
  if (!std::isfinite(distance) || !geom::is_finite(direction))
    return Error{ErrorCode::NotFinite, "the offset of the curve is not finite"};
  if (direction == Vector3{}) return Error{ErrorCode::DegenerateCurve, "the offset of the curve has no direction"};
  const Vector3 unit = geom::normalised(direction);
  for (int i = 0; i <= 64; ++i) {
    const double t = std::lerp(low_, high_, i / 64.0);
    const Vector3 along = jet(t).first;
    if (!(geom::length(cross(along, unit)) > 1e-12 * geom::length(along)))
      return Error{ErrorCode::DegenerateCurve,
                   fmt::format("the curve has no tangent across the direction of its offset at {}", t)};
  }
  return Curve(std::make_shared<const OffsetCurveShape>(*this, distance, unit), breaks_);
}

Curve Curve::held(geom::Point low, geom::Point high) const {
  return Curve(std::make_shared<const HeldShape>(*this, low, high), breaks_);
}

Curve Curve::reaching(double from, Point3 at_from, double to, Point3 at_to) const {
  std::vector<double> inside{from};
  for (const double each : breaks_) {
    if (each > from && each < to) inside.push_back(each);
  }
  inside.push_back(to);
  return Curve(std::make_shared<const ReachingShape>(*this, from, at_from, to, at_to), std::move(inside));
}

}  // namespace dobra::surf
