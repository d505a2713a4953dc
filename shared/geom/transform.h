#pragma once
// Affine maps of the plane as homogeneous 3 x 3 matrices whose last row is (0, 0, 1).

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "shared/base/angle.h"
#include "shared/geom/point.h"
#include "shared/geom/polyline.h"

namespace dobra::geom {

/// x' = xx x + xy y + x0, y' = yx x + yy y + y0.
class Transform {
 public:
  /// The identity.
  constexpr Transform() = default;
  constexpr Transform(double xx, double xy, double x0, double yx, double yy, double y0)
      : xx_(xx), xy_(xy), x0_(x0), yx_(yx), yy_(yy), y0_(y0) {}

  static constexpr Transform translation(Vector by) { return {1, 0, by.x, 0, 1, by.y}; }

  /// Anticlockwise for a positive angle: T(pivot) R T(-pivot). Exact cosines at whole quarter turns.
  static Transform rotation(base::Angle angle, Point pivot = {}) {
    const auto [cosine, sine] = cosine_and_sine(angle.radians());
    return about(pivot, {cosine, -sine, 0, sine, cosine, 0});
  }

  /// Stretched along the axes, away from the pivot; a negative factor mirrors.
  static constexpr Transform scale(double along_x, double along_y, Point pivot = {}) {
    return about(pivot, {along_x, 0, 0, 0, along_y, 0});
  }

  /// `inner` first, then `outer`.
  friend constexpr Transform operator*(const Transform& outer, const Transform& inner) {
    return {outer.xx_ * inner.xx_ + outer.xy_ * inner.yx_,
            outer.xx_ * inner.xy_ + outer.xy_ * inner.yy_,
            outer.xx_ * inner.x0_ + outer.xy_ * inner.y0_ + outer.x0_,
            outer.yx_ * inner.xx_ + outer.yy_ * inner.yx_,
            outer.yx_ * inner.xy_ + outer.yy_ * inner.yy_,
            outer.yx_ * inner.x0_ + outer.yy_ * inner.y0_ + outer.y0_};
  }

  [[nodiscard]] constexpr Point operator()(Point p) const {
    return {xx_ * p.x + xy_ * p.y + x0_, yx_ * p.x + yy_ * p.y + y0_};
  }
  /// A displacement is not translated.
  [[nodiscard]] constexpr Vector operator()(Vector v) const { return {xx_ * v.x + xy_ * v.y, yx_ * v.x + yy_ * v.y}; }
  /// Point by point in the same order; a mirror image is therefore oriented the other way.
  [[nodiscard]] Polyline operator()(Polyline polyline) const {
    for (Point& p : polyline.points) p = (*this)(p);
    return polyline;
  }

  /// Factor of areas; negative if the map mirrors.
  [[nodiscard]] constexpr double determinant() const { return xx_ * yy_ - xy_ * yx_; }

  /// Nothing if the map flattens the plane (determinant zero, or not finite).
  [[nodiscard]] std::optional<Transform> inverse() const {
    const double d = determinant();
    if (d == 0.0 || !std::isfinite(d)) return std::nullopt;
    return Transform{yy_ / d, -xy_ / d, (xy_ * y0_ - yy_ * x0_) / d, -yx_ / d, xx_ / d, (yx_ * x0_ - xx_ * y0_) / d};
  }

  /// Rows of the homogeneous matrix.
  [[nodiscard]] constexpr std::array<std::array<double, 3>, 3> matrix() const {
    return {{{xx_, xy_, x0_}, {yx_, yy_, y0_}, {0.0, 0.0, 1.0}}};
  }
  friend constexpr bool operator==(const Transform&, const Transform&) = default;

 private:
  static constexpr Transform about(Point pivot, const Transform& linear) {
    const Vector to_pivot{pivot.x, pivot.y};
    return translation(to_pivot) * linear * translation(-to_pivot);
  }

  /// The rounded angle of a quarter turn has a cosine of 6e-17; what was meant is 0.
  static std::array<double, 2> cosine_and_sine(double radians) {
    const double quarters = std::round(radians / (0.5 * std::numbers::pi));
    const double off = std::abs(radians - quarters * 0.5 * std::numbers::pi);
    if (off > 4.0 * std::numeric_limits<double>::epsilon() * std::abs(radians))
      return {std::cos(radians), std::sin(radians)};
    constexpr std::array<std::array<double, 2>, 4> exact{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    return exact[static_cast<std::size_t>(std::fmod(std::fmod(quarters, 4.0) + 4.0, 4.0))];
  }

  double xx_ = 1, xy_ = 0, x0_ = 0;
  double yx_ = 0, yy_ = 1, y0_ = 0;
};

}  // namespace dobra::geom
