#include "shared/mesh/element_quality.h"

#include <gtest/gtest.h>

#include <cmath>

#include "shared/mesh/order2.h"

namespace dobra::mesh {
namespace {

TEST(ElementQuality, TheShapeOfAQuadrilateralIsOneForASquareAndFallsWithAspectAndAngle) {
  EXPECT_DOUBLE_EQ(quadrilateral_shape({0, 0}, {2, 0}, {2, 2}, {0, 2}), 1.0);
  EXPECT_DOUBLE_EQ(quadrilateral_shape({1, 0}, {1, 3}, {-2, 3}, {-2, 0}), 1.0) << "turned";
  EXPECT_DOUBLE_EQ(quadrilateral_shape({0, 0}, {3, 0}, {3, 1}, {0, 1}), 2.0 * 3.0 / 10.0);
  const double angle = 0.7;
  EXPECT_NEAR(
      quadrilateral_shape({0, 0}, {1, 0}, {1 + std::cos(angle), std::sin(angle)}, {std::cos(angle), std::sin(angle)}),
      std::sin(angle), 1e-15);
  EXPECT_LT(quadrilateral_shape({0, 0}, {2, 0}, {0.2, 0.2}, {0, 2}), 0.0) << "a re-entrant corner";
  EXPECT_EQ(quadrilateral_shape({0, 0}, {1, 0}, {2, 0}, {1, 1}), 0.0) << "a flat one";
}

TEST(ElementQuality, ABentTriangleIsFoundByItsJacobian) {
  ElementMesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};
  mesh.types = {ElementType::T3, ElementType::T3};
  mesh.first = {0, 3, 6};
  mesh.nodes = {NodeId(0), NodeId(1), NodeId(2), NodeId(1), NodeId(3), NodeId(2)};
  mesh.regions = {0, 0};
  mesh.side_sets["bottom"] = {{ElementId(0), 0}};
  EXPECT_EQ(element_quality_of(mesh).jacobian_min, 1.0);
  EXPECT_FALSE(element_quality_of(mesh).worst_jacobian.valid());
  // The mid-side of the bottom moved up by m: the determinant is 1 - 4 m at its right end, 1 at the left.
  const double m = 0.1;
  const auto bent = to_second_order(mesh, {{"bottom", [m](geom::Point a, geom::Point b) {
                                              return midpoint(a, b) + geom::Vector{0, m};
                                            }}});
  const ElementQuality quality = element_quality_of(bent.mesh);
  EXPECT_NEAR(quality.jacobian_min, 1.0 - 4.0 * m, 1e-12);
  EXPECT_EQ(quality.worst_jacobian, ElementId(0));
  EXPECT_EQ(quality.jacobians[12] + quality.jacobians[11], 1U);
  EXPECT_EQ(quality.jacobians[19], 1U);
}

TEST(ElementQuality, QuarterPointElementsAreCountedAndTheirJacobianIsNoFlaw) {
  ElementMesh mesh;
  mesh.points = {{0, 0}, {1, 0.1}, {-0.1, 1}, {1, 1}};
  mesh.types = {ElementType::T3, ElementType::T3};
  mesh.first = {0, 3, 6};
  mesh.nodes = {NodeId(0), NodeId(1), NodeId(2), NodeId(1), NodeId(3), NodeId(2)};
  mesh.regions = {0, 0};
  ElementMesh second = to_second_order(mesh, {}).mesh;
  EXPECT_FALSE(is_quarter_point(second, ElementId(0)));
  const auto nodes = second.nodes_of(ElementId(0));
  second.points[nodes[3].index()] = geom::interpolate(mesh.points[0], mesh.points[1], 0.25);
  EXPECT_FALSE(is_quarter_point(second, ElementId(0))) << "one side alone";
  second.points[nodes[5].index()] = geom::interpolate(mesh.points[0], mesh.points[2], 0.25);
  EXPECT_TRUE(is_quarter_point(second, ElementId(0)));
  EXPECT_FALSE(is_quarter_point(second, ElementId(1)));
  EXPECT_NEAR(scaled_jacobian_bound(second, ElementId(0)), 0.0, 1e-12);
  const ElementQuality quality = element_quality_of(second);
  EXPECT_EQ(quality.quarter_points, 1U);
  EXPECT_EQ(quality.jacobian_min, 1.0);
  EXPECT_FALSE(quality.worst_jacobian.valid());
  EXPECT_EQ(quality.jacobians[19], 1U);
  EXPECT_EQ(quality.jacobians[0], 0U);
}

}  // namespace
}  // namespace dobra::mesh
