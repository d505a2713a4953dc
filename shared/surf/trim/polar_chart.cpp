// Round a pole: the surface by polar coordinates of the chart.
#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "shared/surf/measure.h"
#include "shared/surf/trim/open.h"

namespace dobra::surf::trim {

using geom::Box;
using geom::Point;
using geom::Vector;
using geom::Vector3;

namespace {

constexpr double pi = std::numbers::pi;

/// Between the chart and polar coordinates: `a` runs along the side that is the pole, `b` across.
struct Polar {
  bool along_u = true;
  double a_middle = 0.0, a_low = 0.0, a_high = 1.0, b_pole = 0.0;
  double sense_a = 1.0, sense_b = 1.0;
  double per_a = 1.0;   ///< Angle by a.
  double per_b = 1.0;   ///< Radius by b.
  double half = pi;     ///< Half of the angle of the sector.
  double radius = 1.0;  ///< Nothing is asked for beyond.
  bool seam = false;    ///< Beyond either side of the sector the surface goes round.

  [[nodiscard]] Point chart(double a, double b) const { return along_u ? Point{a, b} : Point{b, a}; }
  [[nodiscard]] double a_of(double angle) const {
    if (seam) return a_middle + sense_a * angle / per_a;
    return std::clamp(a_middle + sense_a * std::clamp(angle, -half, half) / per_a, a_low, a_high);
  }
  [[nodiscard]] double b_of(double r) const { return b_pole + sense_b * std::min(r, radius) / per_b; }
  [[nodiscard]] Point back(Point p) const {
    const double r = std::hypot(p.x, p.y);
    return r > 0.0 ? chart(a_of(std::atan2(p.y, p.x)), b_of(r)) : chart(a_middle, b_pole);
  }
  /// The same within the chart of the surface.
  [[nodiscard]] double within(double a) const {
    const double turn = a_high - a_low;
    return std::clamp(seam ? a - std::floor((a - a_low) / turn) * turn : a, a_low, a_high);
  }
  [[nodiscard]] Point held(Point p) const {
    Point at = back(p);
    (along_u ? at.x : at.y) = within(along_u ? at.x : at.y);
    return at;
  }
  [[nodiscard]] Point forward(Point uv) const {
    const double angle = sense_a * per_a * ((along_u ? uv.x : uv.y) - a_middle);
    const double r = sense_b * per_b * ((along_u ? uv.y : uv.x) - b_pole);
    return {r * std::cos(angle), r * std::sin(angle)};
  }
};

/// Derivatives by a and b in their order.
struct AlongAcross {
  Vector3 a, b, aa, ab, bb;
};
AlongAcross along_across(const Polar& polar, const Jet& jet) {
  return polar.along_u ? AlongAcross{jet.u, jet.v, jet.uu, jet.uv, jet.vv}
                       : AlongAcross{jet.v, jet.u, jet.vv, jet.uv, jet.uu};
}

struct PolarShape : Surface::Shape {
  Surface surface;
  Polar polar;
  Vector3 xx, xy, yy;  ///< At the pole.
  PolarShape(const Surface& base, const Polar& map) : surface(base), polar(map) { fit_pole(); }

  void jets(std::span<const Point> uv, std::span<Jet> jets) const override {
    for (std::size_t i = 0; i < uv.size(); ++i) jets[i] = jet(uv[i]);
  }
  [[nodiscard]] Jet jet(Point p) const {
    const double r = std::hypot(p.x, p.y);
    if (r <= 1e-6 * polar.radius) return at_pole(r > 0.0 ? std::atan2(p.y, p.x) : 0.0, r);
    const Jet from = surface.jet(polar.held(p));
    const AlongAcross s = along_across(polar, from);
    const double ka = polar.sense_a / polar.per_a, kb = polar.sense_b / polar.per_b, r2 = r * r;
    const double c = p.x / r, d = p.y / r;
    const double a_x = -ka * d / r, a_y = ka * c / r, b_x = kb * c, b_y = kb * d;
    const double a_xx = 2.0 * ka * c * d / r2, a_xy = ka * (d * d - c * c) / r2;
    const double b_xx = kb * d * d / r, b_xy = -kb * c * d / r, b_yy = kb * c * c / r;
    const auto second = [&](double ap, double bp, double aq, double bq, double a_pq, double b_pq) {
      return ap * aq * s.aa + (ap * bq + aq * bp) * s.ab + bp * bq * s.bb + a_pq * s.a + b_pq * s.b;
    };
    return {from.at,
            a_x * s.a + b_x * s.b,
            a_y * s.a + b_y * s.b,
            second(a_x, b_x, a_x, b_x, a_xx, b_xx),
            second(a_x, b_x, a_y, b_y, a_xy, b_xy),
            second(a_y, b_y, a_y, b_y, -a_xx, b_yy)};
  }
  /// The greatest of a net of places, and half as much again.
  [[nodiscard]] Bend bend(const Box& part) const override {
    constexpr int n = 8;
    Bend most;
    for (int i = 0; i <= n; ++i) {
      for (int k = 0; k <= n; ++k) {
        const Jet j =
            jet({std::lerp(part.low.x, part.high.x, 1.0 * i / n), std::lerp(part.low.y, part.high.y, 1.0 * k / n)});
        most.uu = std::max(most.uu, geom::length(j.uu));
        most.uv = std::max(most.uv, geom::length(j.uv));
        most.vv = std::max(most.vv, geom::length(j.vv));
      }
    }
    return {1.5 * most.uu, 1.5 * most.uv, 1.5 * most.vv};
  }

 private:
  [[nodiscard]] Jet at_pole(double angle, double r) const {
    const double a = polar.within(polar.a_of(angle));
    const AlongAcross s = along_across(polar, surface.jet(polar.chart(a, polar.b_pole)));
    const double ka = polar.sense_a / polar.per_a, kb = polar.sense_b / polar.per_b;
    const Vector3 out = kb * s.b, round = ka * kb * s.ab;
    const double c = std::cos(angle), d = std::sin(angle);
    return {surface.at(polar.chart(a, polar.b_of(r))), c * out - d * round, d * out + c * round, xx, xy, yy};
  }
  /// The quadratic form whose bends along rays are nearest to those of the surface.
  void fit_pole() {
    constexpr int n = 9;
    Eigen::Matrix3d left = Eigen::Matrix3d::Zero(), right = Eigen::Matrix3d::Zero();
    for (int i = 0; i < n; ++i) {
      const double angle = polar.half * (2.0 * (i + 0.5) / n - 1.0), c = std::cos(angle), d = std::sin(angle);
      const AlongAcross s = along_across(polar, surface.jet(polar.chart(polar.a_of(angle), polar.b_pole)));
      const Vector3 bend = s.bb / (polar.per_b * polar.per_b);
      const Eigen::Vector3d row(c * c, 2.0 * c * d, d * d);
      left += row * row.transpose();
      right += row * Eigen::RowVector3d(bend.x, bend.y, bend.z);
    }
    const Eigen::Matrix3d form = left.completeOrthogonalDecomposition().solve(right);
    const auto of = [&](int i) { return Vector3{form(i, 0), form(i, 1), form(i, 2)}; };
    xx = of(0), xy = of(1), yy = of(2);
  }
};

struct MappedShape : Curve::Shape {
  Curve curve;
  Polar polar;
  MappedShape(const Curve& base, const Polar& map) : curve(base), polar(map) {}
  [[nodiscard]] Curve::Jet jet(double t) const override {
    const Curve::Jet j = curve.jet(t);
    const auto pick = [&](double u, double v) { return polar.along_u ? std::pair(u, v) : std::pair(v, u); };
    const auto [a, b] = pick(j.at.x, j.at.y);
    const auto [a1, b1] = pick(j.first.x, j.first.y);
    const auto [a2, b2] = pick(j.second.x, j.second.y);
    const double ka = polar.sense_a * polar.per_a, kb = polar.sense_b * polar.per_b;
    const double angle = ka * (a - polar.a_middle), r = kb * (b - polar.b_pole);
    const double w = ka * a1, w1 = ka * a2, r1 = kb * b1, r2 = kb * b2, c = std::cos(angle), d = std::sin(angle);
    return {{r * c, r * d, 0.0},
            {r1 * c - r * w * d, r1 * d + r * w * c, 0.0},
            {r2 * c - 2.0 * r1 * w * d - r * (w1 * d + w * w * c), r2 * d + 2.0 * r1 * w * c + r * (w1 * c - w * w * d),
             0.0}};
  }
  /// The greatest of nine between two breaks, and half as much again.
  [[nodiscard]] double bend(double from, double to) const override {
    double most = 0.0;
    std::vector<double> at{from, to};
    for (const double t : curve.breaks()) {
      if (t > from && t < to) at.push_back(t);
    }
    std::sort(at.begin(), at.end());
    for (std::size_t k = 0; k + 1 < at.size(); ++k) {
      for (int i = 0; i <= 8; ++i)
        most = std::max(most, geom::length(jet(std::lerp(at[k], at[k + 1], i / 8.0)).second));
    }
    return 1.5 * most;
  }
};

/// Directions in which the surface leaves the pole, at equal parts of the side.
std::vector<Vector3> ways_out(const Surface& surface, const Polar& polar, double range_b) {
  constexpr int n = 96;
  std::vector<Vector3> ways;
  for (int i = 0; i <= n; ++i) {
    const double a = std::lerp(polar.a_low, polar.a_high, 1.0 * i / n);
    const Point pole = polar.chart(a, polar.b_pole);
    Vector3 way = polar.sense_b * along_across(polar, surface.jet(pole)).b;
    if (geom::length(way) * range_b < 1e-6 * surface.size()) {
      const double step = 1e-3 * range_b;
      way = (surface.at(polar.chart(a, polar.b_pole + polar.sense_b * step)) - surface.at(pole)) / step;
    }
    ways.push_back(way);
  }
  return ways;
}

}  // namespace

base::Result<PolarChart> polar_chart(const Surface& surface, Side pole, double reach) {
  const Box& chart = surface.chart();
  Polar polar;
  polar.along_u = pole == Side::Bottom || pole == Side::Top;
  polar.a_low = polar.along_u ? chart.low.x : chart.low.y;
  polar.a_high = polar.along_u ? chart.high.x : chart.high.y;
  polar.a_middle = std::midpoint(polar.a_low, polar.a_high);
  const bool at_low = pole == Side::Bottom || pole == Side::Left;
  const double b_low = polar.along_u ? chart.low.y : chart.low.x, b_high = polar.along_u ? chart.high.y : chart.high.x;
  polar.b_pole = at_low ? b_low : b_high;
  // The turn of the new chart is that of the old one.
  polar.sense_b = at_low ? 1.0 : -1.0;
  polar.sense_a = polar.along_u ? -polar.sense_b : polar.sense_b;
  const std::vector<Vector3> ways = ways_out(surface, polar, b_high - b_low);
  double angle = 0.0, speed = 0.0;
  for (std::size_t i = 0; i < ways.size(); ++i) {
    speed += geom::length(ways[i]) / static_cast<double>(ways.size());
    if (i > 0) angle += std::atan2(geom::length(cross(ways[i - 1], ways[i])), dot(ways[i - 1], ways[i]));
  }
  const bool round = polar.along_u ? surface.closed_u() : surface.closed_v();
  constexpr double slender = 0.4 * pi;  // of a cone whose sides are 11.5 degrees from its axis
  const bool closes = round && angle >= slender;
  constexpr double least = 0.05, most = 11.0 / 6.0 * pi;  // apart enough that both sides of a sector do not meet
  polar.seam = round && !closes;
  polar.half = closes ? pi : 0.5 * std::clamp(angle, least, most);
  polar.per_a = 2.0 * polar.half / (polar.a_high - polar.a_low);
  polar.per_b = speed;
  polar.radius = speed * reach * (b_high - b_low);
  const double wide = 1.1 * polar.radius;
  DOBRA_TRY(const Surface made,
            Surface::of(std::make_shared<const PolarShape>(surface, polar), {{-wide, -wide}, {wide, wide}}));
  return PolarChart{made,
                    [polar](Point p) { return polar.back(p); },
                    [polar](Point uv) { return polar.forward(uv); },
                    [polar](const Curve& curve) {
                      return Curve::of(std::make_shared<const MappedShape>(curve, polar), curve.breaks());
                    },
                    2.0 * polar.half,
                    polar.radius,
                    polar.seam};
}

geom::Vector chart_lengths(const Surface& surface) {
  const Box& chart = surface.chart();
  const Point m = chart.centre();
  return {length(surface, {chart.low.x, m.y}, {chart.high.x, m.y}),
          length(surface, {m.x, chart.low.y}, {m.x, chart.high.y})};
}

}  // namespace dobra::surf::trim
