#include "shared/surf/mesh/free_borders.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

namespace dobra::surf::mesh {
namespace {

using geom::Point;
using geom::Point3;

constexpr double full = 2.0 * std::numbers::pi;

/// Rows of nodes on a surface that closes in u, its seam the nodes 0 of each row, those of the seam moved along v by
/// turns. The sides of the seam are the sets "seam_low" and "seam_high"; bottom and top are borders, or collapse where
/// they do.
SurfaceMesh closed_mesh(const Surface& surface, std::size_t around, std::size_t rows, double jolt) {
  const geom::Box chart = surface.chart();
  const double step = (chart.high.y - chart.low.y) / static_cast<double>(rows);
  SurfaceMesh mesh;
  std::map<std::pair<std::size_t, std::size_t>, NodeId> number;
  const auto place = [&](std::size_t i, std::size_t j) {
    const bool seam = i % around == 0 && j > 0 && j < rows;
    const double shift = seam ? (j % 2 == 0 ? jolt : -jolt) * step : 0.0;
    return Point{chart.low.x + (chart.high.x - chart.low.x) * static_cast<double>(i) / static_cast<double>(around),
                 chart.low.y + step * static_cast<double>(j) + shift};
  };
  const auto node = [&](std::size_t i, std::size_t j) {
    const bool pole = (j == 0 && surface.collapsed(Side::Bottom)) || (j == rows && surface.collapsed(Side::Top));
    const auto [at, added] = number.try_emplace({pole ? 0 : i % around, j}, NodeId(mesh.points.size()));
    if (added) mesh.points.push_back(surface.at(place(i, j)));
    return at->second;
  };
  const auto add = [&](std::array<std::pair<std::size_t, std::size_t>, 3> corners) {
    Corners nodes;
    std::array<Point, 3> places;
    for (std::size_t k = 0; k < 3; ++k) {
      nodes[k] = node(corners[k].first, corners[k].second);
      places[k] = place(corners[k].first, corners[k].second);
    }
    if (nodes[0] == nodes[1] || nodes[1] == nodes[2] || nodes[2] == nodes[0]) return;
    mesh.triangles.push_back(nodes);
    mesh.places.push_back(places);
    mesh.faces.push_back(0);
    mesh.regions.push_back(0);
  };
  for (std::size_t j = 0; j < rows; ++j) {
    for (std::size_t i = 0; i < around; ++i) {
      add({{{i, j}, {i + 1, j}, {i + 1, j + 1}}});
      add({{{i, j}, {i + 1, j + 1}, {i, j + 1}}});
      if (j == 0 && !surface.collapsed(Side::Bottom))
        mesh.boundary_sets["bottom"].push_back({node(i, 0), node(i + 1, 0)});
      if (j + 1 == rows && !surface.collapsed(Side::Top))
        mesh.boundary_sets["top"].push_back({node(i + 1, rows), node(i, rows)});
    }
    mesh.boundary_sets["seam_high"].push_back({node(around, j), node(around, j + 1)});
    mesh.boundary_sets["seam_low"].push_back({node(0, j + 1), node(0, j)});
  }
  return mesh;
}

double least_alpha(const SurfaceMesh& mesh) {
  double least = 1.0;
  for (const Corners& c : mesh.triangles) {
    const std::array<double, 3> side{distance(mesh.point(c[0]), mesh.point(c[1])),
                                     distance(mesh.point(c[1]), mesh.point(c[2])),
                                     distance(mesh.point(c[2]), mesh.point(c[0]))};
    const double half = 0.5 * (side[0] + side[1] + side[2]);
    const double heron = half * (half - side[0]) * (half - side[1]) * (half - side[2]);
    least = std::min(least, 4.0 * std::numbers::sqrt3 * std::sqrt(std::max(0.0, heron)) /
                                (side[0] * side[0] + side[1] * side[1] + side[2] * side[2]));
  }
  return least;
}

/// Vertices less edges plus triangles; each directed side once.
long euler(const SurfaceMesh& mesh) {
  std::map<std::pair<NodeId, NodeId>, int> sides;
  std::set<NodeId> nodes;
  for (const Corners& c : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(++sides[std::pair(c[i], c[(i + 1) % 3])], 1);
      nodes.insert(c[i]);
    }
  }
  std::size_t edges = 0;
  for (const auto& [side, count] : sides)
    if (side.first < side.second || !sides.contains({side.second, side.first})) ++edges;
  return static_cast<long>(nodes.size()) - static_cast<long>(edges) + static_cast<long>(mesh.triangles.size());
}

TEST(FreeBorders, TheSeamOfACylinderIsGone) {
  const Surface cylinder = *Surface::cylinder({}, 1.0, {{0.0, 0.0}, {full, 2.0}});
  SurfaceMesh mesh = closed_mesh(cylinder, 24, 8, 0.42);
  const double before = least_alpha(mesh);
  const auto count = mesh.triangles.size();
  ASSERT_LT(before, 0.65);
  const auto changes = free_borders(mesh, {&cylinder, 1}, {"seam_low", "seam_high"});
  ASSERT_TRUE(changes);
  EXPECT_GT(*changes, 0U);
  EXPECT_GT(least_alpha(mesh), 0.75);
  EXPECT_EQ(mesh.triangles.size(), count);
  EXPECT_EQ(euler(mesh), 0);
  EXPECT_FALSE(mesh.boundary_sets.contains("seam_low") || mesh.boundary_sets.contains("seam_high"));
  for (const Point3 p : mesh.points) EXPECT_NEAR(std::hypot(p.x, p.y), 1.0, 1e-12);
  // Outwards everywhere, and each corner's place is the place of its node.
  for (std::size_t t = 0; t < count; ++t) {
    const Corners& c = mesh.triangles[t];
    const Point3 a = mesh.point(c[0]);
    const auto area = cross(mesh.point(c[1]) - a, mesh.point(c[2]) - a);
    EXPECT_GT(area.x * a.x + area.y * a.y, 0.0);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_LT(distance(cylinder.at(mesh.places[t][i]), mesh.point(c[i])), 1e-12);
  }
}

TEST(FreeBorders, BordersThatAreMeantStay) {
  const Surface cylinder = *Surface::cylinder({}, 1.0, {{0.0, 0.0}, {full, 2.0}});
  SurfaceMesh mesh = closed_mesh(cylinder, 24, 8, 0.42);
  const SurfaceMesh given = mesh;
  ASSERT_TRUE(free_borders(mesh, {&cylinder, 1}, {"seam_low", "seam_high"}));
  EXPECT_EQ(mesh.boundary_sets.at("bottom"), given.boundary_sets.at("bottom"));
  for (const Edge& edge : mesh.boundary_sets.at("bottom"))
    for (const NodeId node : edge) EXPECT_EQ(mesh.point(node).z, 0.0);
  // The seam is wanted when nobody says that it is artificial.
  SurfaceMesh kept = given;
  const auto changes = free_borders(kept, {&cylinder, 1}, {});
  ASSERT_TRUE(changes);
  EXPECT_EQ(*changes, 0U);
  EXPECT_EQ(kept, given);
}

TEST(FreeBorders, ANamedNodeOnTheSeamStays) {
  const Surface cylinder = *Surface::cylinder({}, 1.0, {{0.0, 0.0}, {full, 2.0}});
  SurfaceMesh mesh = closed_mesh(cylinder, 24, 8, 0.42);
  const NodeId named = mesh.boundary_sets.at("seam_high")[3][0];
  mesh.node_sets["here"] = {named};
  const Point3 where = mesh.point(named);
  ASSERT_TRUE(free_borders(mesh, {&cylinder, 1}, {"seam_low", "seam_high"}));
  EXPECT_EQ(mesh.point(named), where);
}

TEST(FreeBorders, PolesAndSeamOfASphereAreInnerNodes) {
  const double half = 0.5 * std::numbers::pi;
  const Surface sphere = *Surface::sphere({}, 2.0, {{0.0, -half}, {full, half}});
  SurfaceMesh mesh = closed_mesh(sphere, 12, 7, 0.3);
  const double before = least_alpha(mesh);
  ASSERT_TRUE(free_borders(mesh, {&sphere, 1}, {"seam_low", "seam_high"}, {.rounds = 12, .rings = 12}));
  EXPECT_GT(least_alpha(mesh), before);
  EXPECT_EQ(euler(mesh), 2);
  for (const Point3 p : mesh.points) EXPECT_NEAR(std::hypot(p.x, p.y, p.z), 2.0, 1e-12);
  for (const Corners& c : mesh.triangles) {
    const Point3 a = mesh.point(c[0]);
    const auto area = cross(mesh.point(c[1]) - a, mesh.point(c[2]) - a);
    EXPECT_GT(area.x * a.x + area.y * a.y + area.z * a.z, 0.0);
  }
}

}  // namespace
}  // namespace dobra::surf::mesh
