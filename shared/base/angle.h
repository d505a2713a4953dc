#pragma once
// Angles carry their unit in the constructor: radians in memory, degrees only in files and forms.

#include <compare>
#include <numbers>

namespace dobra::base {

class Angle {
 public:
  constexpr Angle() = default;
  static constexpr Angle from_radians(double value) { return Angle(value); }
  static constexpr Angle from_degrees(double value) { return Angle(value * std::numbers::pi / 180.0); }
  [[nodiscard]] constexpr double radians() const { return radians_; }
  [[nodiscard]] constexpr double degrees() const { return radians_ * 180.0 / std::numbers::pi; }

  friend constexpr auto operator<=>(Angle, Angle) = default;
  friend constexpr Angle operator+(Angle a, Angle b) { return Angle(a.radians_ + b.radians_); }
  friend constexpr Angle operator-(Angle a, Angle b) { return Angle(a.radians_ - b.radians_); }
  friend constexpr Angle operator-(Angle a) { return Angle(-a.radians_); }
  friend constexpr Angle operator*(double f, Angle a) { return Angle(f * a.radians_); }

 private:
  constexpr explicit Angle(double radians) : radians_(radians) {}
  double radians_ = 0.0;
};

}  // namespace dobra::base
