#include "shared/geom/drawn_curve.h"

#include <fmt/format.h>

namespace dobra::geom {

namespace {

base::Result<void> one_a_point(std::size_t count, std::size_t points, bool needed, const char* what) {
  if (count == (needed ? points : 0)) return {};
  return base::Error{base::ErrorCode::InvalidOption,
                     needed ? fmt::format("the curve has {} points and {} {}; give one a point", points, count, what)
                            : fmt::format("{} are given, which this kind of curve does not have; remove them", what)};
}

base::Result<CubicPath> hermite(const DrawnCurve& curve) {
  if (curve.points.size() < 2) {
    return base::Error{base::ErrorCode::DegenerateCurve, "a Hermite curve needs two points or more"};
  }
  std::vector<HermiteCubic> cubics;
  for (std::size_t i = 1; i < curve.points.size(); ++i)
    cubics.push_back({curve.points[i - 1], curve.points[i], curve.tangents[i - 1], curve.tangents[i]});
  std::vector<double> knots;
  for (std::size_t i = 0; i <= cubics.size(); ++i)
    knots.push_back(static_cast<double>(i) / static_cast<double>(cubics.size()));
  return CubicPath(std::move(cubics), std::move(knots));
}

template <class T>
base::Result<Polyline> chain(const base::Result<T>& curve, const DiscretiseOptions& options) {
  if (!curve) return curve.error();
  DOBRA_TRY(const Discretisation pieces, discretise(*curve, options));
  return pieces.polyline();
}

}  // namespace

base::Result<CubicPath> spline_through(std::vector<Point> points) {
  const bool closed = points.size() > 3 && points.front() == points.back();
  if (closed) points.pop_back();
  if (points.size() < 2) {
    return base::Error{base::ErrorCode::DegenerateCurve, "a spline needs two points or more"};
  }
  const SplineEnds ends = closed ? SplineEnds::Closed : SplineEnds::Natural;
  return cubic_spline(points, chord_length_knots(points, ends), ends);
}

base::Result<Polyline> drawn(const DrawnCurve& curve, DrawnAs as, const DiscretiseOptions& options) {
  const std::size_t count = curve.points.size();
  DOBRA_TRY_VOID(one_a_point(curve.tangents.size(), count, as == DrawnAs::Hermite, "tangents"));
  DOBRA_TRY_VOID(one_a_point(curve.weights.size(), count, as == DrawnAs::RationalBezier, "weights"));
  switch (as) {
    case DrawnAs::Line:
      break;
    case DrawnAs::Hermite:
      return chain(hermite(curve), options);
    case DrawnAs::Spline:
      return chain(spline_through(curve.points), options);
    case DrawnAs::Bezier:
      return chain(Bezier::make(curve.points), options);
    case DrawnAs::BSpline:
      return chain(uniform_b_spline(curve.points), options);
    case DrawnAs::RationalBezier:
      return chain(RationalBezier::make(curve.points, curve.weights), options);
  }
  return Polyline{curve.points, false};
}

}  // namespace dobra::geom
