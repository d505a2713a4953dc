#pragma once
// Fifteen surfaces on which meshers are compared: Coons's patch of four cubics, six kinds of curvature, three trimmed
// planes and three trimmed surfaces, each with a largest size and a turn.

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "shared/surf/trim/trimmed_surface.h"

namespace dobra::surf::test {

struct StandIn {
  std::string name;
  trim::TrimmedSurface face;
  double largest = 0.0;  ///< m.
  double turn = 0.0;     ///< Degrees.
};

namespace stand_in {

inline constexpr double pi = std::numbers::pi;

inline trim::ChartEdge line(geom::Point from, geom::Point to, const std::string& name = "") {
  return {*Curve::line({from.x, from.y, 0.0}, {to.x, to.y, 0.0}), 0.0, 1.0, name};
}

inline trim::ChartLoop rectangle(const geom::Box& box) {
  const geom::Point a = box.low, b{box.high.x, box.low.y}, c = box.high, d{box.low.x, box.high.y};
  return {{line(a, b, "bottom"), line(b, c, "right"), line(c, d, "top"), line(d, a, "left")}};
}

/// Clockwise, so a hole: an ellipse with its axes along u and v, as four rational curves.
inline trim::ChartLoop ellipse_hole(geom::Point centre, double a, double b) {
  const auto quarter = [&](double cos0, double sin0, double cos1, double sin1) {
    const auto at = [&](double c, double s) { return geom::Point3{centre.x + a * c, centre.y + b * s, 0.0}; };
    return trim::ChartEdge{
        *Curve::bezier({at(cos0, sin0), at(cos0 + cos1, sin0 + sin1), at(cos1, sin1)}, {1.0, std::sqrt(0.5), 1.0}), 0.0,
        1.0, "hole"};
  };
  return {{quarter(1, 0, 0, -1), quarter(0, -1, -1, 0), quarter(-1, 0, 0, 1), quarter(0, 1, 1, 0)}};
}

/// A smooth curve through points of the chart, closed if the last is the first.
inline trim::ChartEdge through(std::vector<geom::Point> points, const std::string& name) {
  // Hermite pieces by central differences, each a cubic Bezier curve of one spline with triple knots.
  std::vector<geom::Point3> control;
  std::vector<double> knots(4, 0.0);
  const std::size_t n = points.size();
  const bool closed = points.front() == points.back();
  const auto tangent = [&](std::size_t i) {
    if (i == 0) return closed ? 0.5 * (points[1] - points[n - 2]) : points[1] - points[0];
    if (i + 1 == n) return closed ? 0.5 * (points[1] - points[n - 2]) : points[n - 1] - points[n - 2];
    return 0.5 * (points[i + 1] - points[i - 1]);
  };
  const auto add = [&](geom::Point p) { control.push_back({p.x, p.y, 0.0}); };
  add(points[0]);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    add(points[i] + (1.0 / 3.0) * tangent(i));
    add(points[i + 1] + (-1.0 / 3.0) * tangent(i + 1));
    add(points[i + 1]);
    for (int k = 0; k < (i + 2 == n ? 4 : 3); ++k) knots.push_back(static_cast<double>(i + 1));
  }
  return {*Curve::nurbs(3, knots, control), 0.0, static_cast<double>(n - 1), name};
}

inline Curve cubic(double z1, double z2, bool along_x, double at) {
  const auto point = [&](double t, double z) {
    return along_x ? geom::Point3{10.0 * t, at, z} : geom::Point3{at, 10.0 * t, z};
  };
  return *Curve::bezier({point(0, 0), point(1.0 / 3.0, z1), point(2.0 / 3.0, z2), point(1, 0)});
}
inline Surface coons() {
  return *Surface::coons(cubic(4, 4, true, 0), cubic(-3, 5, true, 10), cubic(3, -3, false, 0), cubic(-2, 4, false, 10));
}

/// The bicubic patch through 40 x 40 points of a graph.
template <class Height>
Surface through_graph(const geom::Box& box, const Height& height) {
  constexpr std::size_t n = 40;
  std::vector<geom::Point3> points;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      const double x = std::lerp(box.low.x, box.high.x, static_cast<double>(i) / (n - 1));
      const double y = std::lerp(box.low.y, box.high.y, static_cast<double>(j) / (n - 1));
      points.push_back({x, y, height(x, y)});
    }
  }
  return *Surface::through(points, n, n);
}

inline Surface flat() { return *Surface::plane({}, {{0, 0}, {10, 10}}); }

/// The half cylinder with a hole, cut by a cylinder of radius 2 whose axis is radial: exactly y = 5 + 2 cos t, and the
/// angle from the middle asin(2 sin t / 5).
inline trim::ChartLoop drilled() {
  std::vector<geom::Point> points;
  constexpr int n = 96;
  for (int i = 0; i <= n; ++i) {
    const double t = -2.0 * pi * i / n;
    points.push_back({0.5 * pi + std::asin(0.4 * std::sin(t)), 5.0 + 2.0 * std::cos(t)});
  }
  points.back() = points.front();
  return {{through(points, "hole")}};
}

/// The sphere's patch (radius 5, longitude 0 to 180 degrees, latitude within 60) where x + z <= 3: what the circle of
/// that plane leaves, from the upper side of the chart to the left one.
inline trim::ChartLoop cut_sphere() {
  const double low = -pi / 3.0, high = pi / 3.0;
  const double radius = std::sqrt(25.0 - 4.5);
  const double first = std::acos((5.0 * std::sin(high) - 1.5) * std::sqrt(2.0) / radius);
  std::vector<geom::Point> cut;
  constexpr int n = 96;
  for (int i = 0; i <= n; ++i) {
    const double t = std::lerp(first, pi, static_cast<double>(i) / n);
    const double along = radius * std::cos(t) / std::sqrt(2.0);
    cut.push_back({std::atan2(radius * std::sin(t), 1.5 - along), std::asin((1.5 + along) / 5.0)});
  }
  cut.front().y = high;
  cut.back().x = 0.0;
  const geom::Point from = cut.front(), to = cut.back();
  return {{line({0, low}, {pi, low}, "bottom"), line({pi, low}, {pi, high}, "right"), line({pi, high}, from, "top"),
           through(cut, "cut"), line(to, {0, low}, "left")}};
}

}  // namespace stand_in

inline std::vector<StandIn> stand_ins() {
  using namespace stand_in;
  const auto whole = [](const Surface& surface) { return trim::TrimmedSurface{surface, {rectangle(surface.chart())}}; };
  const auto holed = [&](const Surface& surface, std::vector<trim::ChartLoop> holes) {
    trim::TrimmedSurface face = whole(surface);
    for (auto& hole : holes) face.loops.push_back(std::move(hole));
    return face;
  };
  const auto round = [](double x, double y, double r) { return ellipse_hole({x, y}, r, r); };
  std::vector<StandIn> all;
  all.push_back({"6a", whole(coons()), 1.0, 10.0});
  all.push_back({"6b", whole(coons()), 0.5, 5.0});
  all.push_back({"6c", whole(coons()), 0.3, 3.0});
  all.push_back({"7a", whole(*Surface::cylinder({}, 5.0, {{0, 0}, {0.5 * pi, 10.0}})), 0.5, 10.0});
  all.push_back({"7b", whole(*Surface::graph("(x^2 - y^2) / 10", {{-10, -10}, {10, 10}})), 1.0, 10.0});
  all.push_back({"7c", whole(*Surface::sphere({}, 5.0, {{0, -pi / 3.0}, {pi, pi / 3.0}})), 0.5, 10.0});
  all.push_back({"7d", whole(*Surface::torus({}, 6.0, 2.0, {{0, -pi}, {1.5 * pi, pi}})), 0.5, 10.0});
  // Its seam is one curve.
  auto& low = all.back().face.loops[0].edges[0];
  auto& high = all.back().face.loops[0].edges[2];
  low.shared = high.shared = trim::SharedCurveId(0);
  high.against = true;
  all.push_back({"7e",
                 whole(through_graph({{-10, -10}, {10, 10}},
                                     [](double x, double y) { return 4.0 * std::exp(-(x * x + y * y) / 8.0); })),
                 1.0, 5.0});
  all.push_back(
      {"7f",
       whole(through_graph({{0, 0}, {10, 10}}, [](double x, double y) { return 1.5 * std::sin(x) * std::cos(y); })),
       0.5, 5.0});
  all.push_back({"8a", holed(flat(), {round(5, 5, 2)}), 0.5, 15.0});
  all.push_back({"8b",
                 holed(flat(), {round(2.5, 2.5, 1), round(7.5, 2.5, 1), round(2.5, 7.5, 1), round(7.5, 7.5, 1),
                                round(5, 5, 1.5)}),
                 0.25, 15.0});
  all.push_back({"8c", holed(flat(), {round(3, 5, 1.5)}), 0.25, 10.0});
  all.back().face.lines.push_back({{line({6, 2}, {8, 8}, "line")}});
  all.push_back({"8d", holed(*Surface::cylinder({}, 5.0, {{0, 0}, {pi, 10.0}}), {drilled()}), 0.5, 10.0});
  all.push_back({"8e", {*Surface::sphere({}, 5.0, {{0, -pi / 3.0}, {pi, pi / 3.0}}), {cut_sphere()}}, 1.0, 5.0});
  all.push_back({"8f", holed(coons(), {ellipse_hole({0.5, 0.5}, 0.3, 0.2)}), 1.0, 10.0});
  return all;
}

}  // namespace dobra::surf::test
