#include "quebra/sketch/cubics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace quebra::sketch {

using dobra::base::Error;
using dobra::base::ErrorCode;
using dobra::base::Result;
using dobra::geom::CubicPath;
using dobra::geom::HermiteCubic;
using dobra::geom::Point;

Result<CubicPath> ellipse_arc(const EllipseArc& arc, Point from, Point to) {
  constexpr int cubics_a_quarter = 40;
  const int count =
      std::max(1, static_cast<int>(std::ceil(std::abs(arc.sweep) / (0.5 * std::numbers::pi) * cubics_a_quarter)));
  std::vector<HermiteCubic> cubics;
  std::vector<double> knots{0.0};
  const double step = arc.sweep / count;
  const auto at = [&](double angle) { return arc.centre + std::cos(angle) * arc.u + std::sin(angle) * arc.v; };
  const auto slope = [&](double angle) { return step * (-std::sin(angle) * arc.u + std::cos(angle) * arc.v); };
  for (int i = 0; i < count; ++i) {
    const double t0 = arc.start + step * i, t1 = arc.start + step * (i + 1);
    cubics.push_back({i == 0 ? from : at(t0), i + 1 == count ? to : at(t1), slope(t0), slope(t1)});
    knots.push_back(static_cast<double>(i + 1) / count);
  }
  return CubicPath(std::move(cubics), std::move(knots));
}

Result<CubicPath> bezier(std::vector<Point> p) {
  if (p.size() == 2) p = {p[0], interpolate(p[0], p[1], 1.0 / 3.0), interpolate(p[0], p[1], 2.0 / 3.0), p[1]};
  if (p.size() == 3) p = {p[0], interpolate(p[0], p[1], 2.0 / 3.0), interpolate(p[2], p[1], 2.0 / 3.0), p[2]};
  if (p.size() % 3 != 1) return Error{ErrorCode::DegenerateCurve, "a Bezier curve needs 2, 3, 4, 7, 10 ... points"};
  std::vector<HermiteCubic> cubics;
  std::vector<double> knots{0.0};
  for (std::size_t i = 0; i + 3 < p.size(); i += 3) {
    cubics.push_back({p[i], p[i + 3], 3.0 * (p[i + 1] - p[i]), 3.0 * (p[i + 3] - p[i + 2])});
    knots.push_back(static_cast<double>(i + 3) / static_cast<double>(p.size() - 1));
  }
  return CubicPath(std::move(cubics), std::move(knots));
}

}  // namespace quebra::sketch
