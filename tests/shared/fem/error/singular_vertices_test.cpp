#include "shared/fem/error/singular_vertices.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/fem_meshes.h"

namespace dobra::fem::error {
namespace {

using namespace test;
using base::Angle;

/// The exponent at a place; 1 if it is not in the list.
double exponent_at(const ElementMesh& mesh, const Problem& problem, Point at) {
  for (const SingularVertex& vertex : singular_vertices(mesh, problem)) {
    if (distance(mesh.point(vertex.node), at) < 1e-9) return vertex.exponent;
  }
  return 1.0;
}

TEST(SingularVertices, AClampedCornerHasWilliamsExponent) {
  // Plane strain, nu = 0.3, 90 degrees: 0.7112 (Sinclair); half a plane: the root of sin^2(pi l) = (k+1)^2 / (4k) is
  // complex, its real part is 1/2, where the left side is greatest.
  const Material strain{.young = 1.0, .poisson = 0.3, .state = PlaneState::Strain};
  EXPECT_NEAR(clamped_corner_exponent(Angle::from_degrees(90.0), strain), 0.7112, 1e-4);
  EXPECT_EQ(clamped_corner_exponent(Angle::from_degrees(30.0), strain), 1.0);
  // Without contraction across (nu = 0, plane stress, kappa = 3) the root lies nearer to 1.
  const Material soft{.young = 1.0, .poisson = 0.0};
  EXPECT_GT(clamped_corner_exponent(Angle::from_degrees(90.0), soft), 0.7112);
}

TEST(SingularVertices, CornersClampsAndRollersAreFoundAndNothingElse) {
  const ElementMesh mesh = l_shape(ElementType::T6, 2);
  Problem problem{.materials = {{0, {.young = 1.0, .poisson = 0.3}}}};
  EXPECT_EQ(singular_vertices(mesh, problem).size(), 1U);
  EXPECT_NEAR(exponent_at(mesh, problem, {0, 0}), 0.5444837, 1e-6);
  problem.supports = {{.where = "top", .x = 0.0, .y = 0.0}};
  EXPECT_EQ(singular_vertices(mesh, problem).size(), 3U);
  EXPECT_NEAR(exponent_at(mesh, problem, {1, 1}), exponent_at(mesh, problem, {-1, 1}), 1e-12);
  EXPECT_LT(exponent_at(mesh, problem, {1, 1}), 0.8);
  // A roller that ends at a right angle is a line of symmetry of a straight face.
  problem.supports = {{.where = "top", .normal = 0.0}};
  EXPECT_EQ(singular_vertices(mesh, problem).size(), 1U);
}

TEST(SingularVertices, ASupportAtOnePointHoldsNoFaceWhateverTheElement) {
  for (const ElementType type : all_types) {
    ElementMesh mesh = l_shape(type, 2);
    name_node(mesh, "corner", {-1, -1});
    name_node(mesh, "far", {-1, 1});
    const Problem problem{.materials = {{0, {.young = 1.0, .poisson = 0.3}}},
                          .supports = {{.where = "corner", .x = 0.0, .y = 0.0}, {.where = "far", .x = 0.0}}};
    EXPECT_EQ(singular_vertices(mesh, problem).size(), 1U) << name_of(type);
  }
}

TEST(SingularVertices, ARollerThatEndsOnAStraightFaceIsACrackTip) {
  ElementMesh mesh = mapped_grid(ElementType::T6, 4, 2, unit_square);
  auto& ahead = mesh.side_sets["ahead"];
  for (const mesh::ElementSide side : mesh.side_sets.at("bottom")) {
    if (mesh.point(side_nodes(mesh, side)[0]).x > 0.49) ahead.push_back(side);
  }
  const Problem problem{.materials = {{0, {.young = 1.0, .poisson = 0.3}}},
                        .supports = {{.where = "ahead", .normal = 0.0}}};
  EXPECT_NEAR(exponent_at(mesh, problem, {0.5, 0}), 0.5, 1e-9);
  EXPECT_EQ(singular_vertices(mesh, problem).size(), 1U);
}

}  // namespace
}  // namespace dobra::fem::error
