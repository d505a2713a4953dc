#include "shared/fem/error/singular_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "shared/fem/error/estimate.h"
#include "shared/fem/error/exact_fields.h"
#include "shared/fem/error/singular_vertices.h"
#include "shared/fem/solve.h"
#include "tests/support/fem_meshes.h"

namespace dobra::fem::error {
namespace {

using namespace test;
using base::Angle;
using std::numbers::pi;
constexpr Material block{.young = 1.0, .poisson = 0.3, .state = PlaneState::Strain};

using Exact = std::function<Voigt(Point)>;

SingularVertex corner(double exponent, double interior, CornerFace first, CornerFace last) {
  return {.node = NodeId(0),
          .exponent = exponent,
          .out = {1, 0},
          .interior = Angle::from_degrees(interior),
          .first = first,
          .last = last};
}

/// Stress of a mode at a distance of 1 in the direction `degrees`.
Voigt at(const SingularVertex& vertex, const CornerField& mode, double degrees) {
  const double t = degrees * pi / 180;
  return corner_stress(vertex, mode, {std::cos(t), std::sin(t)});
}

TEST(SingularField, ACrackTipHasTheTwoFieldsOfWilliamsAndNoOther) {
  SingularVertex tip = corner(0.5, 360.0, CornerFace::Free, CornerFace::Free);
  tip.out = {-1, 0};
  const auto modes = corner_modes(tip, block);
  ASSERT_EQ(modes.size(), 2U);
  // K_I and K_II as combinations of the two: fitted at two places, right everywhere.
  for (const TipLoad load : {TipLoad::Opening, TipLoad::Sliding}) {
    const Voigt a0 = at(tip, modes[0], 40), b0 = at(tip, modes[1], 40),
                s0 = tip_field({std::cos(40 * pi / 180), std::sin(40 * pi / 180)}, load, block).stress;
    const double det = a0[0] * b0[1] - b0[0] * a0[1];
    const double x = (s0[0] * b0[1] - b0[0] * s0[1]) / det, y = (a0[0] * s0[1] - s0[0] * a0[1]) / det;
    for (const double angle : {-170.0, -90.0, -10.0, 100.0, 175.0}) {
      const Voigt exact = tip_field({std::cos(angle * pi / 180), std::sin(angle * pi / 180)}, load, block).stress;
      const Voigt a = at(tip, modes[0], angle), b = at(tip, modes[1], angle);
      for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(x * a[k] + y * b[k], exact[k], 1e-12) << angle;
    }
  }
}

TEST(SingularField, TheReEntrantCornerHasTheOpeningModeOfSzaboAndBabuska) {
  const SingularVertex vertex =
      corner(corner_exponent(Angle::from_degrees(270)), 270.0, CornerFace::Free, CornerFace::Free);
  const auto modes = corner_modes(vertex, block);
  ASSERT_EQ(modes.size(), 1U);
  const auto exact = [](double degrees) {
    return l_corner_stress({std::cos(degrees * pi / 180), std::sin(degrees * pi / 180)}, Angle::from_degrees(135));
  };
  const double scale = exact(135)[0] / at(vertex, modes[0], 135)[0];
  for (const double angle : {5.0, 70.0, 200.0, 268.0}) {
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(scale * at(vertex, modes[0], angle)[k], exact(angle)[k], 1e-9) << angle;
  }
}

TEST(SingularField, HeldFacesHaveFieldsOfTheirOwn) {
  // A roller ahead of a free face is half a crack: one mode, no traction on the free face, no shear on the roller.
  const SingularVertex half = corner(0.5, 180.0, CornerFace::Roller, CornerFace::Free);
  ASSERT_EQ(corner_modes(half, block).size(), 1U);
  const CornerField opening = corner_modes(half, block)[0];
  EXPECT_NEAR(at(half, opening, 0)[2], 0.0, 1e-12);
  EXPECT_NEAR(at(half, opening, 180)[1], 0.0, 1e-12);
  EXPECT_NEAR(at(half, opening, 180)[2], 0.0, 1e-12);
  // Clamped along x, free along y.
  const SingularVertex clamped =
      corner(clamped_corner_exponent(Angle::from_degrees(90), block), 90.0, CornerFace::Clamped, CornerFace::Free);
  ASSERT_EQ(corner_modes(clamped, block).size(), 1U);
  const Voigt free = at(clamped, corner_modes(clamped, block)[0], 90);
  EXPECT_NEAR(free[0], 0.0, 1e-9);
  EXPECT_NEAR(free[2], 0.0, 1e-9);
  // Not stretched along the clamped face: sigma_x = nu / (1 - nu) sigma_y in plane strain.
  const Voigt held = at(clamped, corner_modes(clamped, block)[0], 0);
  EXPECT_NEAR(held[0], 0.3 / 0.7 * held[1], 1e-9);
  // An exponent that is not of the corner has no field.
  EXPECT_TRUE(corner_modes(corner(0.6, 270.0, CornerFace::Free, CornerFace::Free), block).empty());
}

/// Estimated to true error of the elements that touch `vertex`, and of all.
struct Effectivity {
  double at_vertex = 0.0;
  double all = 0.0;
};

enum class Zones { Yes, No };

Effectivity effectivity(const ElementMesh& mesh, const Problem& problem, const Exact& exact, Point vertex,
                        Zones use = Zones::Yes) {
  const auto solution = solve(mesh, problem).value();
  const auto& u = solution.cases[0].displacements;
  const auto recovered = recover_stress(mesh, problem.materials, u);
  const auto singular = singular_vertices(mesh, problem);
  EXPECT_EQ(singular.size(), 1U);
  std::vector<SingularZone> zones;
  if (use == Zones::Yes) zones = singular_zones(mesh, problem.materials, singular, u, recovered);
  EXPECT_EQ(zones.size(), use == Zones::Yes ? 1U : 0U);
  const auto estimate = estimate_error(mesh, problem.materials, u, recovered, zones);
  const Elasticity d = elasticity(problem.materials.at(0));
  double near_true = 0.0, near_estimate = 0.0, all_true = 0.0;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const ElementGeometry element = geometry_of(mesh, e);
    const auto points = integration_points(element.type, Rule::Curved);
    const auto shapes = shapes_at(element.type, Rule::Curved);
    double sum = 0.0;
    for (std::size_t g = 0; g < points.size(); ++g) {
      const Mapped m = map(element.points(), shapes[g]);
      Voigt difference = exact(m.at);
      const Voigt own = ElementSolution(element, problem.materials.at(0), u).stress(m);
      for (std::size_t k = 0; k < 3; ++k) difference[k] -= own[k];
      sum += m.determinant * points[g].weight * energy_product(d, difference, difference);
    }
    all_true += sum;
    const auto touches = element.points();
    if (std::none_of(touches.begin(), touches.end(), [&](Point p) { return distance(p, vertex) < 1e-12; })) continue;
    near_true += sum;
    near_estimate += estimate.elements[e] * estimate.elements[e];
  }
  return {std::sqrt(near_estimate / near_true), estimate.error / std::sqrt(all_true)};
}

TEST(SingularField, AtTheReEntrantCornerTheErrorOfEveryElementTypeIsSeen) {
  const Exact field = [](Point p) { return l_corner_stress(p, Angle::from_degrees(135)); };
  for (const ElementType type : all_types) {
    for (const double power : {1.0, 3.0}) {  // even cells, cells graded towards the corner
      ElementMesh mesh = l_shape(type, 8, power);
      name_node(mesh, "corner", {0, 0});
      name_node(mesh, "far", {-1, 1});
      Problem problem{.materials = {{0, block}},
                      .supports = {{.where = "corner", .x = 0.0, .y = 0.0}, {.where = "far", .x = 0.0}}};
      problem.cases[0].sides = {{"loaded", traction_of(field)}};
      const Effectivity found = effectivity(mesh, problem, field, {0, 0});
      EXPECT_NEAR(found.at_vertex, 1.0, 0.06) << name_of(type) << power;
      EXPECT_NEAR(found.all, 1.0, 0.19) << name_of(type) << power;
      const Effectivity polynomials = effectivity(mesh, problem, field, {0, 0}, Zones::No);
      EXPECT_GT(std::abs(polynomials.at_vertex - 1.0), std::abs(found.at_vertex - 1.0)) << name_of(type) << power;
      printf(
          "[ figures  ] corner %s, cells to the power %g: effectivity at the corner %.3f, all %.3f; of polynomials "
          "%.3f, %.3f\n",
          name_of(type), power, found.at_vertex, found.all, polynomials.at_vertex, polynomials.all);
    }
  }
}

TEST(SingularField, InARosetteTheErrorIsThatOfItsElementsAndNotOfPolynomials) {
  const Exact field = [](Point p) {
    const Voigt one = tip_field(p, TipLoad::Opening, block).stress, two = tip_field(p, TipLoad::Sliding, block).stress;
    return Voigt{one[0] + 0.4 * two[0] + 0.3, one[1] + 0.4 * two[1], one[2] + 0.4 * two[2]};
  };
  for (const bool quarter : {true, false}) {
    for (const double radius : {0.1, 0.02}) {
      ElementMesh mesh = tip_mesh({.outline = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, 0}},
                                   .tip = {0, 0},
                                   .ahead = {1, 0},
                                   .sectors = 16,
                                   .radius = radius,
                                   .circle_rings = 3,
                                   .quarter = quarter});
      name_node(mesh, "corner", {1, -1});
      name_node(mesh, "far", {1, 1});
      Problem problem{.materials = {{0, block}},
                      .supports = {{.where = "corner", .x = 0.0, .y = 0.0}, {.where = "far", .x = 0.0}}};
      for (const char* side : {"side 0", "side 1", "side 2", "side 3", "side 4"})
        problem.cases[0].sides.push_back({side, traction_of(field)});
      const Effectivity found = effectivity(mesh, problem, field, {0, 0});
      EXPECT_NEAR(found.at_vertex, 1.0, 0.02) << quarter << radius;
      EXPECT_NEAR(found.all, 1.0, 0.04) << quarter << radius;
      const Effectivity polynomials = effectivity(mesh, problem, field, {0, 0}, Zones::No);
      if (quarter) {
        EXPECT_GT(polynomials.at_vertex, 10.0);  // what the loop could not go below
      }
      printf("[ figures  ] tip of radius %g, %s: effectivity at the tip %.3f, all %.3f; of polynomials %.3f, %.3f\n",
             radius, quarter ? "quarter points" : "plain T6", found.at_vertex, found.all, polynomials.at_vertex,
             polynomials.all);
    }
  }
}

TEST(SingularField, ASmoothStressShowsNoFieldAtTheCorner) {
  // Even tension along x past a corner that could be singular, but is loaded as if it were not there.
  const Voigt even{1.0, 0.0, 0.0};
  ElementMesh mesh = l_shape(ElementType::T6, 6);
  mesh.side_sets["all"] = boundary_sides(mesh);
  name_node(mesh, "corner", {-1, -1});
  name_node(mesh, "far", {-1, 1});
  Problem problem{.materials = {{0, block}},
                  .supports = {{.where = "corner", .x = 0.0, .y = 0.0}, {.where = "far", .x = 0.0}}};
  problem.cases[0].sides = {{"all", traction_of([&](Point p) {
                               return Voigt{even[0] + p.x * p.x, p.y, -2.0 * p.x * p.y};
                             })}};
  const auto solution = solve(mesh, problem).value();
  const auto& u = solution.cases[0].displacements;
  EXPECT_TRUE(singular_zones(mesh, problem.materials, singular_vertices(mesh, problem), u,
                             recover_stress(mesh, problem.materials, u))
                  .empty());
}

}  // namespace
}  // namespace dobra::fem::error
