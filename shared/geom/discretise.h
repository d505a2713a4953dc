#pragma once
// The one discretiser of curves: equal parametric steps no longer than max_length on average, then
// every segment is bisected until it is short enough AND turns by no more than max_angle.
//
// Page: docs/algorithms/discretise.md. Source: [miranda2009surface].

#include <concepts>
#include <functional>
#include <limits>
#include <vector>

#include "shared/base/angle.h"
#include "shared/base/result.h"
#include "shared/geom/point.h"
#include "shared/geom/point3.h"
#include "shared/geom/polyline.h"

namespace dobra::geom {

struct DiscretiseOptions {
  base::Angle max_angle = base::Angle::from_degrees(10.0);  ///< theta_max: greatest turn of the tangent over a segment.
  /// D_max: greatest length of the curve over a segment, m.
  double max_length = std::numeric_limits<double>::infinity();
  /// Greatest length over a segment from t0 to t1 where that varies along the curve, such as the least of a size field
  /// there; empty: max_length alone. It only bisects: step i goes by max_length.
  std::function<double(double t0, double t1)> max_length_over = {};
  double slack = 1e-9;         ///< Relative excess over both limits that is taken for rounding.
  std::size_t max_depth = 32;  ///< Bisections of one initial segment; a corner would need them without end.
};

/// A curve over [0, 1] as functions; `tangent` is the derivative of `point`, `length(t0, t1)` that of the piece, m.
struct CurveFunctions {
  std::function<Point(double)> point;
  std::function<Vector(double)> tangent;
  std::function<double(double, double)> length;
};

/// The same of a curve in space.
struct SpaceCurveFunctions {
  std::function<Point3(double)> point;
  std::function<Vector3(double)> tangent;
  std::function<double(double, double)> length;
};

/// What can be discretised without writing functions for it: Arc and every other parametric curve of this module.
template <class T>
concept Curve = requires(const T& curve, double t) {
  { curve.point(t) } -> std::convertible_to<Point>;
  { curve.tangent(t) } -> std::convertible_to<Vector>;
  { curve.length(t, t) } -> std::convertible_to<double>;
};

/// Refers to `curve`, which must live as long as the result is used.
template <Curve T>
CurveFunctions functions_of(const T& curve) {
  return {[&curve](double t) -> Point { return curve.point(t); },
          [&curve](double t) -> Vector { return curve.tangent(t); },
          [&curve](double t0, double t1) -> double { return curve.length(t0, t1); }};
}

struct Discretisation {
  std::vector<double> parameters;  ///< Ascending, from 0 to 1.
  std::vector<Point> points;       ///< points[i] = point(parameters[i]).

  /// The chain of points; a closed contour if the last point repeats the first.
  [[nodiscard]] Polyline polyline() const;
};

/// Turn of the tangent from t0 to t1 by way of the middle, so that neither a full circle nor an S counts as straight.
/// Where the tangent vanishes, the chord of the half stands for it.
base::Angle tangent_turn(const CurveFunctions& curve, double t0, double t1);
base::Angle tangent_turn(const SpaceCurveFunctions& curve, double t0, double t1);

/// @error InvalidOption if a limit is not positive; DegenerateCurve for a curve of no length or (with the place)
///        with a corner; NotFinite.
/// @cost  O(n) evaluations for n segments.
base::Result<Discretisation> discretise(const CurveFunctions& curve, const DiscretiseOptions& options = {});

/// The parameters alone, of a curve in space.
base::Result<std::vector<double>> discretise(const SpaceCurveFunctions& curve, const DiscretiseOptions& options = {});

template <Curve T>
base::Result<Discretisation> discretise(const T& curve, const DiscretiseOptions& options = {}) {
  return discretise(functions_of(curve), options);
}

}  // namespace dobra::geom
