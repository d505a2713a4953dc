#include "shared/mesh/sizing/size_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "shared/mesh/front/triangulate.h"
#include "tests/shared/mesh/mesh_shapes.h"

namespace dobra::mesh::sizing {
namespace {

TEST(SizeField, IsTheEdgeLengthEverywhereInAUniformSquare) {
  const SizeField field = front::size_field_of(test::square(1.0, 5)).value();
  for (const geom::Point p : test::random_points(100, 3)) EXPECT_NEAR(field.size_at(p), 0.2, 1e-12);
}

TEST(SizeField, AtTheMiddleOfEachEdgeIsNoLargerThanTheEdge) {
  const delaunay::MeshInput input = test::que_e();
  const SizeField field = front::size_field_of(input).value();
  for (const delaunay::InputEdge& edge : input.edges) {
    const geom::Point a = input.points[edge.nodes[0].index()];
    const geom::Point b = input.points[edge.nodes[1].index()];
    EXPECT_LE(field.size_at(geom::midpoint(a, b)), geom::distance(a, b) * (1.0 + 1e-12));
    EXPECT_GT(field.size_at(geom::midpoint(a, b)), 0.3 * geom::distance(a, b));
  }
}

TEST(SizeField, CornersOfALeafDifferByNoMoreThanTheGrowthAllows) {
  for (const double growth : {1.1, 1.3, 2.0}) {
    const SizeField field = front::size_field_of(test::que_d(), {.growth = growth}).value();
    const Quadtree& tree = field.quadtree();
    for (const QuadCellId leaf : tree.leaves()) {
      const auto size = field.corner_sizes(leaf);
      const double bound = (growth - 1.0) * tree.side(leaf) * (1.0 + 1e-9);
      EXPECT_LE(std::abs(size[0] - size[1]), bound);
      EXPECT_LE(std::abs(size[0] - size[2]), bound);
      EXPECT_LE(std::abs(size[3] - size[1]), bound);
      EXPECT_LE(std::abs(size[3] - size[2]), bound);
    }
  }
}

TEST(SizeField, ARequestIsMetWhereItIsMadeAndForgottenFarAway) {
  delaunay::MeshInput input = test::square(10.0, 10);
  input.sizes.push_back({{5, 5}, 0.05});
  const SizeField field = front::size_field_of(input).value();
  EXPECT_LE(field.size_at({5, 5}), 0.05 * (1.0 + 1e-12));
  EXPECT_NEAR(field.size_at({0.5, 0.5}), 1.0, 1e-12);
}

TEST(SizeField, TheSamplerReadsTheSameSizesInAnyOrder) {
  const SizeField field = front::size_field_of(test::que_e()).value();
  SizeSampler sampler(field);
  for (const geom::Point unit : test::random_points(1000, 5)) {
    const geom::Point p{6.0 * unit.x - 0.5, 6.0 * unit.y - 0.5};
    EXPECT_NEAR(sampler.at(p), field.size_at(p), 1e-14);
    const geom::Point near{p.x + 1e-3, p.y};
    EXPECT_NEAR(sampler.at(near), field.size_at(near), 1e-12);
  }
}

TEST(SizeField, AUniformPlateNeedsCellsAlongItsBoundaryOnly) {
  const std::size_t small = front::size_field_of(test::square(1.0, 100)).value().quadtree().cell_count();
  const std::size_t large = front::size_field_of(test::square(1.0, 400)).value().quadtree().cell_count();
  EXPECT_LT(large, 5 * small);
}

TEST(SizeField, SmallerGrowthMeansMoreTriangles) {
  const double gentle = front::size_field_of(test::que_d(), {.growth = 1.1}).value().estimated_triangles();
  const double steep = front::size_field_of(test::que_d(), {.growth = 1.5}).value().estimated_triangles();
  EXPECT_GT(gentle, steep);
}

TEST(SizeField, AFunctionIsFollowedToATenthAndWhereItConcerns) {
  SizeFieldOptions options{.growth = 1.5};
  const auto wanted = [](geom::Point p) { return 0.01 + 0.2 * std::hypot(p.x - 0.4, p.y - 0.7); };
  options.function.at = wanted;
  const SizeField field = front::size_field_of(test::square(1.0, 2), options).value();
  for (const geom::Point p : test::random_points(1000, 7)) EXPECT_NEAR(field.size_at(p), wanted(p), 0.15 * wanted(p));
  options.function.concerns = [](const geom::Box& box) { return box.high.x > 0.8; };
  EXPECT_LT(front::size_field_of(test::square(1.0, 2), options).value().quadtree().cell_count(),
            field.quadtree().cell_count() / 2);
}

TEST(SizeField, TheEstimateCountsWhatIsInside) {
  const SizeField field = front::size_field_of(test::square(1.0, 40)).value();
  const double all = field.estimated_triangles([](geom::Point) { return true; });
  EXPECT_NEAR(all, field.estimated_triangles(), 1e-9 * all);
  EXPECT_NEAR(field.estimated_triangles([](geom::Point p) { return p.x < 0.25; }), 0.25 * all, 0.03 * all);
}

TEST(SizeField, RefusesImpossibleOptions) {
  const auto code = [](const SizeFieldOptions& options, std::vector<delaunay::SizeRequest> requests = {}) {
    delaunay::MeshInput input = test::square(1.0, 2);
    input.sizes = std::move(requests);
    return front::size_field_of(input, options).error().code;
  };
  EXPECT_EQ(code({.growth = 1.0}), base::ErrorCode::InvalidOption);
  EXPECT_EQ(code({.growth = std::numeric_limits<double>::quiet_NaN()}), base::ErrorCode::InvalidOption);
  EXPECT_EQ(code({.max_size = -1.0}), base::ErrorCode::InvalidOption);
  EXPECT_EQ(code({}, {{{0.5, 0.5}, 0.0}}), base::ErrorCode::InvalidOption);
}

}  // namespace
}  // namespace dobra::mesh::sizing
