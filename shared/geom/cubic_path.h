#pragma once
// Smooth curves through or near given points, as chains of cubics: interpolating splines (natural or closed) and
// uniform cubic B-splines. Page: docs/algorithms/curves.md. Source: [farin2002curves].

#include <span>
#include <vector>

#include "shared/geom/bezier.h"

namespace dobra::geom {

/// Cubics end to end, travelled from parameter 0 to 1; the knots say which part of that each takes.
class CubicPath {
 public:
  /// @pre one more knot than cubics, strictly increasing; each cubic's tangents are derivatives by its own parameter
  /// 0..1.
  CubicPath(std::vector<HermiteCubic> cubics, std::vector<double> knots);

  [[nodiscard]] std::span<const HermiteCubic> cubics() const { return cubics_; }
  [[nodiscard]] std::span<const double> knots() const { return knots_; }
  [[nodiscard]] Point point(double t) const;
  [[nodiscard]] Vector tangent(double t) const;
  [[nodiscard]] double length(double t0, double t1) const;

 private:
  /// Which cubic, and where on it from 0 to 1.
  struct At {
    std::size_t cubic;
    double u;
  };
  [[nodiscard]] At at(double t) const;
  [[nodiscard]] double span(std::size_t cubic) const { return knots_[cubic + 1] - knots_[cubic]; }

  std::vector<HermiteCubic> cubics_;
  std::vector<double> knots_;
};

enum class SplineEnds {
  Natural,  ///< No curvature at the first and the last point.
  Closed,   ///< Goes on from the last point to the first with the same curvature; that point is not repeated.
};

/// Knots 0, 1, 2, ...: one for each point, and one more to come back to the first if closed.
std::vector<double> uniform_knots(std::size_t points, SplineEnds ends);
/// Knots as far apart as the points: the curve bends least between near ones.
std::vector<double> chord_length_knots(std::span<const Point> points, SplineEnds ends);

/// Derivatives by the knots' parameter at the points of the C2 cubic spline through them.
/// @pre     two or more points (closed: three), knots as uniform_knots gives.  @cost O(n)
std::vector<Vector> spline_derivatives(std::span<const Point> points, std::span<const double> knots, SplineEnds ends);

/// The C2 cubic spline through `points`.
/// @param knots  strictly increasing; as many as points, and one more if closed.
/// @error DegenerateCurve for too few points; InvalidOption for knots that do not fit (equal neighbours have no
///        chord-length knots); NotFinite.
base::Result<CubicPath> cubic_spline(std::span<const Point> points, std::span<const double> knots, SplineEnds ends);

/// The uniform cubic B-spline of a control polygon: n - 3 cubics, near the polygon and within its hull. A vertex moves
/// four cubics at most.
/// @error DegenerateCurve for fewer than four vertices; NotFinite.
base::Result<CubicPath> uniform_b_spline(std::span<const Point> vertices);

}  // namespace dobra::geom
