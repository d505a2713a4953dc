// Figures of triangular_patch.md, parametrise.md, recovered_surface.md, relaxed_chart.md and remesh.md.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "shared/mesh/quality.h"
#include "shared/surf/param/recovered.h"
#include "shared/surf/param/relax.h"
#include "shared/surf/remesh/remesh.h"
#include "tests/figures/figures.h"
#include "tests/support/sheets.h"

namespace dobra::figures {
namespace {

using geom::Point;
using geom::Point3;
using surf::param::Sheet;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

const scene::Axes bare{"", "", scene::AxisScale::None};

/// Charts, which are one unit wide, as large as what is beside them.
std::vector<Point> enlarged(std::vector<Point> points, double by) {
  for (Point& p : points) p = {by * p.x, by * p.y};
  return points;
}

/// From the side to which all three axes point.
Point on_page(Point3 p) {
  return {(p.y - p.x) * std::sqrt(0.5), p.z * std::sqrt(2.0 / 3.0) - (p.x + p.y) * std::sqrt(1.0 / 6.0)};
}

/// Triangles in space, what is farther from the eye first. @param values  one a triangle; none: all pale
scene::Panel space_panel(std::string title, const std::vector<Point3>& points, const Triangles& triangles,
                         const std::vector<double>& values, const scene::Scale& scale, double line,
                         std::vector<scene::Layer> more = {}) {
  const auto depth = [&](std::uint32_t t) {
    double sum = 0.0;
    for (const std::uint32_t v : triangles[t]) sum += points[v].x + points[v].y + points[v].z;
    return sum;
  };
  std::vector<std::uint32_t> order(triangles.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return depth(a) < depth(b); });
  std::vector<Point> places;
  for (const Point3 p : points) places.push_back(on_page(p));
  Triangles sorted;
  std::vector<double> of;
  for (const std::uint32_t t : order) {
    sorted.push_back(triangles[t]);
    of.push_back(values[t]);
  }
  scene::Mesh mesh{.values_at = scene::ValuesAt::Triangles};
  mesh.points = std::move(places);
  mesh.triangles = std::move(sorted);
  mesh.values = std::move(of);
  mesh.scale = scale;
  more.insert(more.begin(), scene::Layer{{}, {}, stroke({55, 71, 79, 140}, line), std::move(mesh), true, InLegend::No});
  return panel(std::move(title), std::move(more), 0.05, bare);
}

std::vector<geom::Polyline> sides(const std::vector<Point>& points, const Triangles& triangles) {
  std::vector<geom::Polyline> all;
  for (const auto& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i], b = t[(i + 1) % 3];
      all.push_back(chain({points[a], points[b]}));
    }
  }
  return all;
}

std::vector<Point> on_page(const std::vector<Point3>& points) {
  std::vector<Point> places;
  for (const Point3 p : points) places.push_back(on_page(p));
  return places;
}

base::Result<scene::Picture> triangular_patch() {
  const auto curve = [](std::vector<Point3> points) { return surf::Curve::bezier(std::move(points)); };
  DOBRA_TRY(const surf::Curve first, curve({{4, 0, 0}, {4, 1.5, 2.4}, {2, 3, -1.6}, {0, 4, 0}}));
  DOBRA_TRY(const surf::Curve second, curve({{0, 4, 0}, {-0.6, 3, 2}, {0, 1, 2.6}, {0, 0, 3}}));
  DOBRA_TRY(const surf::Curve third, curve({{0, 0, 3}, {2, -1, 3.5}, {4, 0, 0}}));
  DOBRA_TRY(const surf::TriangularPatch patch, surf::TriangularPatch::make(first, second, third));
  const auto arc = [](geom::Vector3 from, geom::Vector3 to) {
    return surf::Curve::arc({}, 3.5 * from, 3.5 * to, 0.0, 0.5 * std::numbers::pi);
  };
  const geom::Vector3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  DOBRA_TRY(const surf::Curve equator, arc(x, y));
  DOBRA_TRY(const surf::Curve up, arc(y, z));
  DOBRA_TRY(const surf::Curve down, arc(z, x));
  DOBRA_TRY(const surf::TriangularPatch large, surf::TriangularPatch::make(equator, up, down));
  scene::Picture picture;
  for (const auto& [title, of] :
       {std::pair{"Three curves", patch}, std::pair{"Three quarters of great circles", large}}) {
    const surf::TriangularGrid grid = surf::grid(of, 12);
    std::vector<geom::Polyline> border;
    std::array<std::vector<Point>, 3> side;
    for (int i = 0; i <= 60; ++i) {
      const double t = i / 60.0;
      side[0].push_back(on_page(of.at(1 - t, t, 0)));
      side[1].push_back(on_page(of.at(0, 1 - t, t)));
      side[2].push_back(on_page(of.at(t, 0, 1 - t)));
    }
    for (auto& each : side) border.push_back(chain(std::move(each)));
    picture.panels.push_back(
        panel(title,
              {lines("isolines of the patch", stroke(grey, 0.5), sides(on_page(grid.points), grid.triangles)),
               lines("curves", stroke(blue, 1.6), std::move(border))},
              0.1, bare));
  }
  return picture;
}

void add_chart(scene::Picture& picture, const std::string& title, const dobra::mesh::PolygonMesh& mesh) {
  const auto charted = surf::remesh::chart_mesh(mesh);
  if (!charted) return;
  const Sheet& sheet = charted->opened.sheet;
  const auto& chart = charted->parametrisation;
  std::vector<Point> stones, stones_seen;
  for (const std::uint32_t v : chart.stones) {
    stones.push_back(chart.uv[v]);
    stones_seen.push_back(on_page(sheet.points[v]));
  }
  const std::vector<double> none(sheet.triangles.size(), 1.0);
  picture.panels.push_back(panel(title,
                                 {lines("mesh", stroke(grey, 0.5), sides(on_page(sheet.points), sheet.triangles)),
                                  markers("border stones", dots(red, 5.0), std::move(stones_seen))},
                                 0.1, bare));
  picture.panels.push_back(panel(title + ": its parameter space",
                                 {lines("mesh", stroke(grey, 0.5), sides(enlarged(chart.uv, 1.8), sheet.triangles)),
                                  markers("border stones", dots(red, 5.0), enlarged(std::move(stones), 1.8))},
                                 0.03, bare));
}

base::Result<scene::Picture> parametrise() {
  scene::Picture picture;
  add_chart(picture, "octant of eight parts", surf::test::octant_mesh(8));
  add_chart(picture, "half sphere", surf::test::half_sphere(8));
  return picture;
}

/// Cosine between the normal and the light, one a small triangle: where it jumps the eye sees an edge.
scene::Panel shaded(std::string title, const surf::Surface& surface, const surf::param::DiscreteChart& chart) {
  constexpr std::uint32_t parts = 8;
  std::vector<Point3> points;
  Triangles triangles;
  std::vector<double> light;
  const geom::Vector3 to_light = geom::normalised({0.3, -0.2, 1.0});
  for (const auto& t : chart.sheet().triangles) {
    const Point a = chart.uv()[t[0]], b = chart.uv()[t[1]], c = chart.uv()[t[2]];
    const auto first = static_cast<std::uint32_t>(points.size());
    const auto number = [&](std::uint32_t i, std::uint32_t k) { return first + k * (2 * parts + 3 - k) / 2 + i; };
    const auto place = [&](double i, double k) { return a + (i / parts) * (b - a) + (k / parts) * (c - a); };
    const auto add = [&](std::array<std::uint32_t, 3> corners, Point middle) {
      triangles.push_back(corners);
      const surf::Jet jet = surface.jet(middle);
      light.push_back(dot(geom::normalised(cross(jet.u, jet.v)), to_light));
    };
    constexpr double third = 1.0 / 3.0;
    for (std::uint32_t k = 0; k <= parts; ++k) {
      for (std::uint32_t i = 0; i + k <= parts; ++i) {
        points.push_back(surface.at(geom::interpolate(place(i, k), place(third * parts, third * parts), 1e-9)));
        if (i + k < parts) add({number(i, k), number(i + 1, k), number(i, k + 1)}, place(i + third, k + third));
        if (i + k + 1 < parts)
          add({number(i + 1, k), number(i + 1, k + 1), number(i, k + 1)}, place(i + 2 * third, k + 2 * third));
      }
    }
  }
  scene::Panel made = space_panel(std::move(title), points, triangles, light,
                                  {"cosine of the normal and the light", scene::ColorMapName::Viridis, 0.2, 1.0}, 0.0);
  return made;
}

base::Result<scene::Picture> recovered_surface() {
  const auto mesh = surf::test::shaken_grid(9, 9, 0.5, 3, [](double u, double v) {
    return Point3{4 * u, 4 * v, 0.9 * std::sin(4.0 * u) * std::cos(3.0 * v)};
  });
  DOBRA_TRY(const surf::remesh::Charted charted, surf::remesh::chart_mesh(mesh));
  const auto chart =
      std::make_shared<const surf::param::DiscreteChart>(charted.opened.sheet, charted.parametrisation.uv);
  const surf::param::Recovered recovered(chart);
  scene::Picture picture;
  scene::Mesh patches{.values_at = scene::ValuesAt::Triangles};
  std::vector<double> number;
  for (const std::uint32_t patch : recovered.patches().patch_of) number.push_back(patch * 7 % 12);
  patches.points = enlarged(chart->uv(), 4.0);
  patches.triangles = chart->sheet().triangles;
  patches.values = std::move(number);
  patches.scale = {"patch", scene::ColorMapName::Quality, 0.0, 12.0};
  picture.panels.push_back(panel(
      fmt::format("{} patches in the chart", recovered.patches().patches),
      {scene::Layer{{}, {}, stroke({55, 71, 79, 140}, 0.4), std::move(patches), true, InLegend::No}}, 0.03, bare));
  DOBRA_TRY(const surf::Surface pieces, surf::param::plane_pieces(chart));
  DOBRA_TRY(const surf::Surface smooth, recovered.surface());
  picture.panels.push_back(shaded("barycentric", pieces, *chart));
  picture.panels.push_back(shaded("recovered", smooth, *chart));
  return picture;
}

double alpha_of(const std::vector<Point3>& points, const std::array<std::uint32_t, 3>& t) {
  const geom::Vector3 a = points[t[1]] - points[t[0]], b = points[t[2]] - points[t[0]], c = points[t[2]] - points[t[1]];
  return 2.0 * std::sqrt(3.0) * geom::length(cross(a, b)) / (dot(a, a) + dot(b, b) + dot(c, c));
}

void add_alpha(scene::Picture& picture, const std::string& title, const std::vector<Point3>& points,
               const Triangles& triangles) {
  std::vector<double> alpha;
  for (const auto& t : triangles) alpha.push_back(alpha_of(points, t));
  picture.panels.push_back(
      space_panel(title, points, triangles, alpha, {"quality alpha", scene::ColorMapName::Quality, 0.5, 1.0}, 0.3));
}

/// A closed long body, cut open: its chart on a circle, and with its border set free.
base::Result<scene::Picture> relaxed_chart() {
  dobra::mesh::PolygonMesh body = surf::test::sphere_mesh(9);
  for (Point3& p : body.points) p.z *= 2.0;
  DOBRA_TRY(const surf::remesh::Charted charted, surf::remesh::chart_mesh(body));
  const Sheet& sheet = charted.opened.sheet;
  std::vector<Point> uv = charted.parametrisation.uv;
  scene::Picture picture;
  picture.panels.push_back(panel(
      "A closed body", {lines("mesh", stroke(grey, 0.5), sides(on_page(sheet.points), sheet.triangles))}, 0.1, bare));
  picture.panels.push_back(panel("Cut open, on a circle",
                                 {lines("mesh", stroke(grey, 0.5), sides(enlarged(uv, 4.0), sheet.triangles))}, 0.1,
                                 bare));
  DOBRA_TRY_VOID(surf::param::relax(sheet, uv));
  picture.panels.push_back(
      panel("Its border set free", {lines("mesh", stroke(grey, 0.5), sides(uv, sheet.triangles))}, 0.1, bare));
  return picture;
}

base::Result<scene::Picture> remesh() {
  const auto holes = surf::test::grid_mesh(
      30, 30,
      [](double u, double v) {
        return Point3{3 * u, 3 * v, 0.4 * std::cos(2.5 * u + 2 * v)};
      },
      [](std::uint32_t i, std::uint32_t j) {
        return (i >= 6 && i < 10 && j >= 8 && j < 13) || (i >= 18 && i < 24 && j >= 16 && j < 20);
      });
  const auto fold = surf::test::shaken_grid(40, 10, 0.0, 1, [](double u, double v) {
    const double x = 4 * u, k = std::floor(x), part = x - k;
    return Point3{2 * v, x, static_cast<int>(k) % 2 == 0 ? 0.4 * part : 0.4 - 0.4 * part};
  });
  scene::Picture picture;
  dobra::mesh::PolygonMesh body = surf::test::torus_mesh(40, 18);
  for (Point3& p : body.points) p = {0.6 * p.x, 0.6 * p.y, p.z + 0.4 * p.x};
  for (const auto& [name, mesh, size] :
       {std::tuple{"with holes", holes, 0.12}, std::tuple{"folded", fold, 0.16}, std::tuple{"closed", body, 0.2}}) {
    DOBRA_TRY(const surf::param::SheetMade before, surf::param::sheet_of(mesh));
    DOBRA_TRY(const surf::remesh::Remeshed made, surf::remesh::remesh(mesh, {.size = size}));
    add_alpha(picture, fmt::format("{}: as it came", name), before.sheet.points, before.sheet.triangles);
    Triangles triangles;
    for (const auto& c : made.mesh.triangles) {
      triangles.push_back({static_cast<std::uint32_t>(c[0].index()), static_cast<std::uint32_t>(c[1].index()),
                           static_cast<std::uint32_t>(c[2].index())});
    }
    add_alpha(picture, fmt::format("{}: meshed anew", name), made.mesh.points, triangles);
  }
  return picture;
}

}  // namespace

std::vector<Figure> param_figures() {
  return {{"triangular_patch", triangular_patch, 760.0},
          {"parametrise", parametrise, 760.0},
          {"recovered_surface", recovered_surface, 900.0, true},
          {"relaxed_chart", relaxed_chart, 900.0},
          {"remesh", remesh, 1100.0, true}};
}

}  // namespace dobra::figures
