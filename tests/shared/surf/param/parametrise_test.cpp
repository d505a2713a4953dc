#include "shared/surf/param/parametrise.h"

#include <gtest/gtest.h>

#include "shared/geom/predicates.h"
#include "tests/support/sheets.h"

namespace dobra::surf::param {
namespace {

using geom::Point;
using test::grid_mesh;

Sheet sheet(const mesh::PolygonMesh& mesh) { return sheet_of(mesh)->sheet; }

TEST(Parametrise, ABorderWithoutCornersGoesToACircleAndTellsWhy) {
  const Sheet dome = sheet(test::half_sphere(8));
  const auto made = parametrise(dome);
  ASSERT_TRUE(made.ok());
  EXPECT_EQ(made->border, BorderShape::Circle);
  EXPECT_NE(made->why_circle.find("0 sharp corners"), std::string::npos) << made->why_circle;
  EXPECT_TRUE(made->flipped.empty());
  EXPECT_TRUE(made->stones.empty());
  const auto asked = parametrise(dome, {.border = BorderShape::Stones});
  ASSERT_FALSE(asked.ok());
  EXPECT_TRUE(asked.error().place.has_value());
}

TEST(Parametrise, FlippedTrianglesAreNamedWhereStraightSidesFlattenThem) {
  // The grid's corner triangle has all three corners on two sides; one whose corners lie on one side is flat in the
  // chart whatever the weights.
  mesh::PolygonMesh ear = grid_mesh(4, 4, [](double u, double v) { return geom::Point3{u, v, 0.1 * u * v}; });
  ear.points.push_back({0.375, -0.02, 0});
  ear.faces.push_back({1, static_cast<std::uint32_t>(ear.points.size() - 1), 2});
  const Sheet eared = sheet(ear);
  const auto stones = parametrise(eared, {.border = BorderShape::Stones});
  ASSERT_TRUE(stones.ok());
  ASSERT_EQ(stones->flipped.size(), 1U);
  EXPECT_EQ(stones->flipped[0], eared.triangles.size() - 1);
  const auto other = parametrise(eared);
  ASSERT_TRUE(other.ok());
  EXPECT_EQ(other->border, BorderShape::Circle);
  EXPECT_TRUE(other->flipped.empty());
  EXPECT_NE(other->why_circle.find("1 triangles are flipped"), std::string::npos) << other->why_circle;
}

TEST(Parametrise, GivenStonesMustBeOnTheBorderInItsOrder) {
  const Sheet square = sheet(grid_mesh(4, 4, [](double u, double v) { return geom::Point3{u, v, 0}; }));
  for (const std::vector<std::uint32_t>& bad :
       {std::vector<std::uint32_t>{0, 12, 24}, {0, 24, 4, 20}, {0, 4}, {0, 4, 99}}) {
    const auto made = parametrise(square, {.given_stones = bad});
    ASSERT_FALSE(made.ok());
    EXPECT_EQ(made.error().code, base::ErrorCode::InvalidOption);
  }
  EXPECT_TRUE(parametrise(square, {.given_stones = {4, 24, 20}}).ok());
}

TEST(Parametrise, StonesOnALineSpanNoPlane) {
  const Sheet square = sheet(grid_mesh(4, 4, [](double u, double v) { return geom::Point3{u, v, 0}; }));
  EXPECT_FALSE(parametrise(square, {.border = BorderShape::Stones, .given_stones = {0, 1, 3}}).ok());
}

void expect_weights_of(const Sheet& mesh, Weights kind) {
  const auto first = mesh.first_half_edges();
  for (std::size_t v = 0; v < first.size(); ++v) {
    if (mesh.twins[first[v]] == no_half_edge) continue;
    double sum = 0.0;
    geom::Vector3 mean;
    for (const Neighbour& n : ring_weights(mesh, first[v], kind)) {
      EXPECT_GT(n.weight, 0.0);
      sum += n.weight;
      mean = mean + n.weight * (mesh.points[n.vertex] - mesh.points[v]);
    }
    EXPECT_NEAR(sum, 1.0, 1e-14);
    EXPECT_LT(geom::length(mean), 1e-13);  // plane sheets: the vertex is that mean of its neighbours
  }
}

TEST(Parametrise, TRI_c_WeightsArePositiveOfSumOneAndReproduceThePlane) {
  const Sheet shaken = sheet(test::shaken_grid(9, 7, 0.5, 5, [](double u, double v) {
    return geom::Point3{3 * u + v, v, u - v};
  }));
  expect_weights_of(shaken, Weights::ShapePreserving);
  expect_weights_of(shaken, Weights::MeanValue);
}

TEST(Parametrise, TRI_c_ARingWhoseFlatAnglesAreTooWideTakesMeanValues) {
  // A tall tip: three steep sides, two of which are narrow.
  const Sheet tip = sheet({{{0, 0, 9}, {1, 0, 0}, {0.9, 0.2, 0}, {0.9, -0.2, 0}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}}});
  double sum = 0.0;
  for (const Neighbour& n : ring_weights(tip, tip.first_half_edges()[0], Weights::ShapePreserving)) {
    EXPECT_GT(n.weight, 0.0);
    sum += n.weight;
  }
  EXPECT_NEAR(sum, 1.0, 1e-14);
}

TEST(Parametrise, TRI_c_APlaneMeshInItsOwnTriangleIsReproduced) {
  const geom::Point3 p{0, 0, 1}, q{4, 1, 0}, r{1, 3, 2};
  const auto made = grid(*TriangularPatch::make(*Curve::line(p, q), *Curve::line(q, r), *Curve::line(r, p)), 12);
  mesh::PolygonMesh plane{made.points, {}};
  std::mt19937_64 random(3);
  for (std::size_t i = 0; i < plane.points.size(); ++i) {
    const auto& c = made.places[i];
    if (std::min({c[0], c[1], c[2]}) < 1e-9) continue;
    const auto part = [&] { return (static_cast<double>(random() >> 11) * 0x1p-53 - 0.5) * 0.05; };
    plane.points[i] = plane.points[i] + part() * (q - p) + part() * (r - p);
  }
  for (const auto& t : made.triangles) plane.faces.push_back({t[0], t[1], t[2]});
  const Sheet mesh = sheet(plane);
  for (const Weights kind : {Weights::ShapePreserving, Weights::MeanValue}) {
    const auto param = parametrise(mesh, {.weights = kind, .border = BorderShape::Stones});
    ASSERT_TRUE(param.ok());
    ASSERT_EQ(param->stones.size(), 3U);
    EXPECT_TRUE(param->flipped.empty());
    // The affine map from the plane is known by its corners: each place must be the same mean of the three stones.
    const Point a = param->uv[param->stones[0]], b = param->uv[param->stones[1]], c = param->uv[param->stones[2]];
    const geom::Point3 pa = mesh.points[param->stones[0]], pb = mesh.points[param->stones[1]],
                       pc = mesh.points[param->stones[2]];
    const geom::Vector3 n = cross(pb - pa, pc - pa);
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      const double of_b = dot(cross(mesh.points[v] - pa, pc - pa), n) / dot(n, n);
      const double of_c = dot(cross(pb - pa, mesh.points[v] - pa), n) / dot(n, n);
      EXPECT_LT(distance(param->uv[v], a + of_b * (b - a) + of_c * (c - a)), 1e-10);
    }
  }
}

TEST(Parametrise, TRI_c_NoTriangleOfTheOctantIsFlipped) {
  for (const std::uint32_t n : {8U, 16U}) {
    const Sheet octant = sheet(test::octant_mesh(n));
    for (const Weights kind : {Weights::ShapePreserving, Weights::MeanValue}) {
      const auto made = parametrise(octant, {.weights = kind, .border = BorderShape::Stones});
      ASSERT_TRUE(made.ok());
      for (const auto& [a, b, c] : octant.triangles)
        EXPECT_EQ(geom::orient2d(made->uv[a], made->uv[b], made->uv[c]), geom::Sign::Positive);
      EXPECT_TRUE(made->flipped.empty());
    }
  }
}

TEST(Parametrise, TRI_d_TheOctantHasThreeStonesAtItsCornersAndStraightSidesByArcLength) {
  const Sheet octant = sheet(test::octant_mesh(8));
  const auto made = parametrise(octant);
  ASSERT_TRUE(made.ok());
  EXPECT_EQ(made->border, BorderShape::Stones);
  ASSERT_EQ(made->stones.size(), 3U);
  for (const std::uint32_t v : made->stones) {
    const geom::Point3 p = octant.points[v];
    EXPECT_NEAR(std::max({p.x, p.y, p.z}), 1.0, 1e-15);
  }
  // Chords of equal arcs are equal, so nodes divide each side evenly; each is found by the angle of its arc.
  std::array<Point, 3> corner;
  for (const std::uint32_t v : made->stones) {
    const geom::Point3 p = octant.points[v];
    corner[p.x > 0.5 ? 0 : p.y > 0.5 ? 1 : 2] = made->uv[v];
  }
  for (const std::uint32_t v : octant.loops[0]) {
    const geom::Point3 p = octant.points[v];
    const double quarter = std::numbers::pi / 2.0;
    const Point expected = p.z < 1e-12   ? geom::interpolate(corner[0], corner[1], std::atan2(p.y, p.x) / quarter)
                           : p.x < 1e-12 ? geom::interpolate(corner[1], corner[2], std::atan2(p.z, p.y) / quarter)
                                         : geom::interpolate(corner[2], corner[0], std::atan2(p.x, p.z) / quarter);
    EXPECT_LT(distance(made->uv[v], expected), 1e-13);
  }
  // The u axis runs from the first stone to the second.
  EXPECT_NEAR(made->uv[made->stones[0]].y, made->uv[made->stones[1]].y, 1e-15);
  EXPECT_LT(made->uv[made->stones[0]].x, made->uv[made->stones[1]].x);
}

TEST(Parametrise, ManyVerticesMakeTheSameOnEveryCall) {
  const Sheet hill = sheet(test::shaken_grid(60, 60, 0.7, 9, [](double u, double v) {
    return geom::Point3{u, v, 0.4 * std::sin(5 * u) * std::cos(4 * v)};
  }));
  const auto once = parametrise(hill), again = parametrise(hill);
  ASSERT_TRUE(once.ok() && again.ok());
  EXPECT_EQ(once->uv, again->uv);
  EXPECT_TRUE(once->flipped.empty());
  EXPECT_EQ(once->stones.size(), 4U);
}

}  // namespace
}  // namespace dobra::surf::param
