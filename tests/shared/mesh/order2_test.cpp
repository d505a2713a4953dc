#include "shared/mesh/order2.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "shared/mesh/lips.h"
#include "shared/mesh/recombine.h"
#include "tests/shared/mesh/element_shapes.h"

namespace dobra::mesh {
namespace {

using geom::Point;
using test::add_chain;
using test::triangle_grid;

Point on_unit_circle(Point from, Point to) {
  const geom::Vector middle = geom::normalised(geom::midpoint(from, to) - Point{0, 0});
  return Point{0, 0} + middle;
}

/// A disc of n triangles round the origin, its rim in the set "rim".
ElementMesh disc(std::size_t n) {
  ElementMesh mesh;
  mesh.points.push_back({0, 0});
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    mesh.points.push_back({std::cos(angle), std::sin(angle)});
  }
  for (std::size_t i = 0; i < n; ++i) {
    add_element(mesh, ElementType::T3, std::vector{NodeId(0), NodeId(1 + i), NodeId(1 + (i + 1) % n)}, 0);
    mesh.side_sets["rim"].push_back({ElementId(i), 1});
  }
  return mesh;
}

TEST(Order2, StraightElementsKeepTheirAreaAndShareMidSideNodes) {
  const ElementMesh grid = triangle_grid(3);
  const SecondOrder second = to_second_order(grid);
  ASSERT_TRUE(check(second.mesh).ok());
  EXPECT_EQ(second.mesh.points.size(), 16U + 33U) << "nodes and edges";
  EXPECT_NEAR(area(second.mesh), 9.0, 1e-14);
  for (std::size_t e = 0; e < second.mesh.element_count(); ++e) {
    EXPECT_NEAR(scaled_jacobian_bound(second.mesh, ElementId(e)), 1.0, 1e-14);
  }
}

TEST(Order2, MidSidesOnTheCircleGiveItsAreaWithTheFourthPowerOfTheSize) {
  double before = 0.0;
  for (const std::size_t n : {6U, 12U, 24U}) {
    const SecondOrder second = to_second_order(disc(n), {{"rim", on_unit_circle}});
    ASSERT_TRUE(check(second.mesh).ok());
    EXPECT_EQ(second.curved, n);
    EXPECT_TRUE(second.straightened.empty());
    const double error = std::abs(area(second.mesh) - std::numbers::pi);
    if (before > 0.0) {
      EXPECT_NEAR(std::log2(before / error), 4.0, 0.1);
    }
    before = error;
  }
}

TEST(Order2, ACurveThatWouldInvertAnElementIsStraightenedAndTold) {
  // A flat triangle whose longest side bends past its apex.
  ElementMesh mesh;
  mesh.points = {{-1, 0}, {1, 0}, {0, 0.2}};
  add_element(mesh, ElementType::T3, std::vector{NodeId(0), NodeId(1), NodeId(2)}, 0);
  mesh.side_sets["base"] = {{ElementId(0), 0}};
  const auto bent = [](double rise) {
    return [rise](Point a, Point b) { return geom::midpoint(a, b) + geom::Vector{0, rise}; };
  };
  const SecondOrder good = to_second_order(mesh, {{"base", bent(0.04)}});
  EXPECT_EQ(good.curved, 1U);
  EXPECT_GT(scaled_jacobian_bound(good.mesh, ElementId(0)), 0.0);
  const SecondOrder bad = to_second_order(mesh, {{"base", bent(0.15)}});
  EXPECT_EQ(bad.straightened, (std::vector{ElementSide{ElementId(0), 0}}));
  EXPECT_DOUBLE_EQ(scaled_jacobian_bound(bad.mesh, ElementId(0)), 1.0);
}

TEST(Order2, TheBoundOfTheJacobianIsBelowItsSamples) {
  ElementMesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {1.1, 1}, {0, 0.9}, {0.5, 0.08}, {1.02, 0.5}, {0.55, 1.0}, {-0.05, 0.45}};
  std::vector<NodeId> nodes;
  for (std::size_t i = 0; i < 8; ++i) nodes.emplace_back(i);
  add_element(mesh, ElementType::Q8, nodes, 0);
  const double bound = scaled_jacobian_bound(mesh, ElementId(0));
  EXPECT_GT(bound, 0.3);
  EXPECT_LT(bound, 1.0);
  mesh.points[4] = {0.5, 0.95};
  EXPECT_LT(scaled_jacobian_bound(mesh, ElementId(0)), 0.0);
}

TEST(Order2, LipsGetMidSideNodesOfTheirOwn) {
  ElementMesh mesh = triangle_grid(6);
  add_chain(mesh, "crack", {{1, 3}, {2, 3}, {3, 3}});
  const std::vector<std::string> names{"crack"};
  const SecondOrder second = to_second_order(open_lips(mesh, names).value());
  ASSERT_TRUE(check(second.mesh).ok());
  for (std::size_t i = 0; i < 2; ++i) {
    const auto left = side_nodes(second.mesh, second.mesh.side_sets.at("crack_left")[i]);
    const auto right = side_nodes(second.mesh, second.mesh.side_sets.at("crack_right")[i]);
    EXPECT_NE(left[2], right[2]);
    EXPECT_EQ(second.mesh.point(left[2]), second.mesh.point(right[2]));
  }
}

TEST(Recombine, ARightAngledGridBecomesItsSquares) {
  ElementMesh mesh = triangle_grid(4);
  add_chain(mesh, "line", {{0, 2}, {1, 2}, {2, 2}});
  const ElementMesh quads = recombine(mesh);
  ASSERT_TRUE(check(quads).ok());
  EXPECT_EQ(quads.element_count(), 16U);
  for (const ElementType type : quads.types) EXPECT_EQ(type, ElementType::Q4);
  EXPECT_NEAR(area(quads), 16.0, 1e-14);
  const auto nodes = side_nodes(quads, quads.side_sets.at("line")[1]);
  EXPECT_EQ(quads.point(nodes[0]), (Point{1, 2}));
  EXPECT_EQ(quads.point(nodes[1]), (Point{2, 2}));
  EXPECT_NEAR(area(to_second_order(quads).mesh), 16.0, 1e-13);
}

TEST(Recombine, SidesOfSetsAndBordersOfRegionsStay) {
  ElementMesh mesh = triangle_grid(4);
  add_chain(mesh, "diagonal", {{0, 0}, {1, 1}, {2, 2}, {3, 3}, {4, 4}});
  const ElementMesh quads = recombine(mesh);
  ASSERT_TRUE(check(quads).ok());
  ASSERT_EQ(quads.side_sets.at("diagonal").size(), 4U);
  EXPECT_EQ(quads.point(side_nodes(quads, quads.side_sets.at("diagonal")[3])[1]), (Point{4, 4}));
  ElementMesh two = triangle_grid(1);
  two.regions[1] = 5;
  EXPECT_EQ(recombine(two).element_count(), 2U);
}

TEST(Recombine, QualityIsOneForARectangleAndNoneForADart) {
  EXPECT_DOUBLE_EQ(quad_quality({0, 0}, {3, 0}, {3, 1}, {0, 1}), 1.0);
  EXPECT_DOUBLE_EQ(quad_quality({0, 0}, {1, 0}, {1.5, std::sqrt(0.75)}, {0.5, std::sqrt(0.75)}), 2.0 / 3.0);
  EXPECT_EQ(quad_quality({0, 0}, {1, 0}, {0.1, 0.1}, {0, 1}), 0.0);
}

}  // namespace
}  // namespace dobra::mesh
