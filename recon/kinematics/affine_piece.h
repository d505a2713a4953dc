#pragma once
// A piece of the plane in which a map is affine: its formula, and the straight lines at which another one may hold.

#include <vector>

#include "recon/kinematics/fault_path.h"

namespace recon::kinematics {

/// x v.x + y v.y + c for v = point - origin of the piece.
struct LinearForm {
  double x = 0.0, y = 0.0, c = 0.0;
  [[nodiscard]] double operator()(geom::Vector v) const { return x * v.x + y * v.y + c; }
  friend LinearForm operator+(LinearForm a, LinearForm b) { return {a.x + b.x, a.y + b.y, a.c + b.c}; }
  friend LinearForm operator-(LinearForm a, LinearForm b) { return {a.x - b.x, a.y - b.y, a.c - b.c}; }
  friend LinearForm operator*(double f, LinearForm a) { return {f * a.x, f * a.y, f * a.c}; }
  friend LinearForm operator+(LinearForm a, double c) { return {a.x, a.y, a.c + c}; }
  friend bool operator==(const LinearForm&, const LinearForm&) = default;
};

/// A point as an affine function of the given one; both from the origin.
struct LinearPoint {
  LinearForm x{1.0, 0.0, 0.0};
  LinearForm y{0.0, 1.0, 0.0};
  [[nodiscard]] LinearForm along(geom::Vector unit) const { return unit.x * x + unit.y * y; }
  [[nodiscard]] LinearPoint moved(LinearForm by, geom::Vector unit) const { return {x + unit.x * by, y + unit.y * by}; }
  friend bool operator==(const LinearPoint&, const LinearPoint&) = default;
};

struct AffinePiece {
  geom::Point origin;
  LinearPoint image;
  /// The formula holds wherever none of these has changed its sign. Some may change it without any change of formula.
  std::vector<LinearForm> sides;

  [[nodiscard]] geom::Point operator()(geom::Point p) const {
    const geom::Vector v = p - origin;
    return origin + geom::Vector{image.x(v), image.y(v)};
  }
  /// Makes `sides` positive at p. One that p lies on (within the tolerance, m) may not be used for other points.
  /// @return whether there is none such.
  bool orient(geom::Point p, double tolerance) {
    bool clear = true;
    for (LinearForm& side : sides) {
      const double value = side(p - origin);
      if (value < 0.0) side = -1.0 * side;
      if (!(std::abs(value) > tolerance)) clear = false;
    }
    return clear;
  }
  /// After orient(): whether the formula holds at q.
  [[nodiscard]] bool holds(geom::Point q) const {
    for (const LinearForm& side : sides) {
      if (!(side(q - origin) > 0.0)) return false;
    }
    return true;
  }
};

}  // namespace recon::kinematics
