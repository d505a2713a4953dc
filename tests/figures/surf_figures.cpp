// Figures of surfaces.md and surface_search.md.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "shared/surf/intersect.h"
#include "shared/surf/measure.h"
#include "tests/figures/figures.h"

namespace dobra::figures {
namespace {

using geom::Point;
using geom::Point3;

/// Isometric, seen from the side to which all three axes point.
Point seen(Point3 p) {
  return {(p.y - p.x) * std::sqrt(0.5), p.z * std::sqrt(2.0 / 3.0) - (p.x + p.y) * std::sqrt(1.0 / 6.0)};
}

/// The chart in cells, coloured by Gaussian curvature, what is farther from the eye first.
scene::Panel curvature_panel(std::string title, const surf::Surface& surface, int across, int up) {
  scene::Mesh mesh{.values_at = scene::ValuesAt::Triangles};
  std::vector<Point> points;
  std::vector<Point3> places;
  for (int i = 0; i <= across; ++i) {
    for (int j = 0; j <= up; ++j) {
      const geom::Box& chart = surface.chart();
      places.push_back(surface.at({std::lerp(chart.low.x, chart.high.x, 1.0 * i / across),
                                   std::lerp(chart.low.y, chart.high.y, 1.0 * j / up)}));
      points.push_back(seen(places.back()));
    }
  }
  struct Triangle {
    std::array<std::uint32_t, 3> corners;
    double value, depth;
  };
  std::vector<Triangle> triangles;
  for (int i = 0; i < across; ++i) {
    for (int j = 0; j < up; ++j) {
      const geom::Box& chart = surface.chart();
      const Point middle{std::lerp(chart.low.x, chart.high.x, (i + 0.5) / across),
                         std::lerp(chart.low.y, chart.high.y, (j + 0.5) / up)};
      const double bent = surf::curvature(surface.jet(middle)).value_or(surf::Curvature{}).gaussian();
      const auto a = static_cast<std::uint32_t>(i * (up + 1) + j), b = a + static_cast<std::uint32_t>(up + 1);
      for (const auto& corners : {std::array{a, b, b + 1}, std::array{a, b + 1, a + 1}}) {
        double depth = 0.0;
        for (const std::uint32_t k : corners) depth += places[k].x + places[k].y + places[k].z;
        triangles.push_back({corners, bent, depth});
      }
    }
  }
  std::stable_sort(triangles.begin(), triangles.end(),
                   [](const Triangle& a, const Triangle& b) { return a.depth < b.depth; });
  std::vector<std::array<std::uint32_t, 3>> corners;
  std::vector<double> values;
  double most = 0.0;
  for (const Triangle& each : triangles) {
    corners.push_back(each.corners);
    values.push_back(each.value);
    most = std::max(most, std::abs(each.value));
  }
  mesh.points = std::move(points);
  mesh.triangles = std::move(corners);
  mesh.values = std::move(values);
  mesh.scale = {"Gaussian curvature [1/m2]", scene::ColorMapName::CoolWarm, -most, most};
  scene::Layer layer{{}, {}, stroke({55, 71, 79, 60}, 0.3), std::move(mesh), true, InLegend::No};
  return panel(std::move(title), {std::move(layer)}, 0.5, {"", "", scene::AxisScale::Diagram});
}

base::Result<surf::Curve> border(Point3 from, Point3 to, double z1, double z2) {
  const geom::Vector3 way = to - from;
  return surf::Curve::bezier({from, from + (1.0 / 3.0) * way + geom::Vector3{0, 0, z1},
                              from + (2.0 / 3.0) * way + geom::Vector3{0, 0, z2}, to});
}

base::Result<scene::Picture> surfaces() {
  const Point3 a{0, 0, 0}, b{10, 0, 0}, c{10, 10, 0}, d{0, 10, 0};
  DOBRA_TRY(const surf::Curve bottom, border(a, b, 4, 4));
  DOBRA_TRY(const surf::Curve top, border(d, c, -3, 5));
  DOBRA_TRY(const surf::Curve left, border(a, d, 3, -3));
  DOBRA_TRY(const surf::Curve right, border(b, c, -2, 4));
  DOBRA_TRY(const surf::Surface coons, surf::Surface::coons(bottom, top, left, right));
  constexpr double pi = std::numbers::pi;
  DOBRA_TRY(const surf::Surface torus, surf::Surface::torus({}, 6.0, 2.0, {{0.5 * pi, -pi}, {2.0 * pi, pi}}));
  scene::Picture picture;
  picture.panels.push_back(curvature_panel("Coons patch of four cubic Bezier curves", coons, 24, 24));
  picture.panels.push_back(curvature_panel("torus, three quarters of a turn", torus, 42, 20));
  return picture;
}

geom::Polyline in_chart(const surf::SharedCurve& curve) {
  std::vector<Point> points;
  for (const surf::SharedPoint& p : curve.points) points.push_back(p.first);
  return chain(std::move(points));
}

base::Result<scene::Picture> surface_search() {
  DOBRA_TRY(const surf::Surface humps, surf::Surface::graph("sin(x) * cos(y)", {{0.3, 0.3}, {11.0, 7.0}}));
  std::vector<geom::Polyline> levels, crossing;
  std::vector<Point> touches, crosses;
  for (const double z : {-1.0, -0.95, -0.75, -0.5, -0.25, 0.0, 0.25, 0.5, 0.75, 0.95, 1.0}) {
    DOBRA_TRY(const surf::SharedSet cut, surf::intersect_plane(humps, {0, 0, z}, {0, 0, 1}));
    for (const surf::SharedCurve& curve : cut.curves) (z == 0.0 ? crossing : levels).push_back(in_chart(curve));
    for (const surf::SharedContact& contact : cut.contacts)
      (contact.kind == surf::SharedContact::Kind::Touch ? touches : crosses).push_back(contact.point.first);
  }
  constexpr double pi = std::numbers::pi;
  const surf::Frame up{{0, 0, -4}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
      across{{-4, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}};
  DOBRA_TRY(const surf::Surface wide, surf::Surface::cylinder(up, 2.0, {{-0.5 * pi, 0}, {1.5 * pi, 8}}));
  scene::Picture picture;
  picture.panels.push_back(
      panel("z = sin x cos y, cut by planes",
            {lines("levels", stroke(blue, 0.9), levels), lines("level 0", stroke(orange, 1.2), crossing),
             markers("the plane touches", dots(red, 5.0), touches), markers("curves cross", dots(green, 5.0), crosses)},
            0.3, {"u = x [m]", "v = y [m]"}));
  std::vector<scene::Layer> pipes;
  for (const auto& [radius, color] : {std::pair{1.0, blue}, std::pair{1.6, green}, std::pair{2.0, orange}}) {
    DOBRA_TRY(const surf::Surface other, surf::Surface::cylinder(across, radius, {{0, 0}, {2.0 * pi, 8}}));
    DOBRA_TRY(const surf::SharedSet common, surf::intersect_surfaces(wide, other));
    std::vector<geom::Polyline> curves;
    for (const surf::SharedCurve& curve : common.curves) curves.push_back(in_chart(curve));
    pipes.push_back(lines(fmt::format("radius {:.1f} m", radius), stroke(color, 1.2), std::move(curves)));
  }
  picture.panels.push_back(
      panel("A pipe of radius 2 m and others across it", std::move(pipes), 0.3, {"u [rad]", "v [m]"}));
  return picture;
}

}  // namespace

std::vector<Figure> surf_figures() {
  return {{"surfaces", surfaces, 760.0}, {"surface_search", surface_search, 760.0}};
}

}  // namespace dobra::figures
