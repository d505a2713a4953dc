#include "shared/fem/solve.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shared/base/angle.h"
#include "shared/fem/error/exact_fields.h"
#include "shared/fem/error/recover.h"
#include "shared/fem/stress.h"
#include "tests/support/fem_meshes.h"

namespace dobra::fem {
namespace {

using namespace test;
using testing::HasSubstr;

constexpr Material plate{.young = 1000.0, .poisson = 0.3, .thickness = 1.0, .state = PlaneState::Stress};
constexpr Material block{.young = 1000.0, .poisson = 0.3, .thickness = 1.0, .state = PlaneState::Strain};

Solution solved(const ElementMesh& mesh, const Problem& problem) {
  auto solution = solve(mesh, problem);
  EXPECT_TRUE(solution.ok()) << (solution ? "" : to_string(solution.error()));
  return std::move(solution).value();
}

/// A square of 4 x 4 cells whose inner nodes are moved at random, mid-sides included.
ElementMesh distorted(ElementType type, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> shift(-0.02, 0.02);
  return mapped_grid(type, 4, 4, [&](double s, double t) {
    const bool inner = s > 0.0 && s < 1.0 && t > 0.0 && t < 1.0;
    const double dx = shift(random);
    return inner ? Point{s + dx, t + shift(random)} : Point{s, t};
  });
}

TEST(Solve, QUE_a_ALinearFieldIsExactOnDistortedElementsOfEveryType) {
  for (const ElementType type : all_types) {
    for (const Material& material : {plate, block}) {
      ElementMesh mesh = distorted(type, 7);
      mesh.node_sets["rim"] = {};
      for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        const Point p = mesh.points[i];
        if (p.x == 0 || p.x == 1 || p.y == 0 || p.y == 1) mesh.node_sets["rim"].push_back(NodeId(i));
      }
      const auto field = [](Point p) {
        return Vector{1e-3 + 2e-3 * p.x - 3e-3 * p.y, -2e-3 + 5e-3 * p.x + 4e-3 * p.y};
      };
      Problem problem{.materials = {{0, material}}, .supports = {{.where = "rim", .field = field}}};
      const Solution solution = solved(mesh, problem);
      for (std::size_t i = 0; i < mesh.points.size(); ++i)
        EXPECT_LT(length(solution.cases[0].displacements[i] - field(mesh.points[i])), 1e-12 * 1e-2) << name_of(type);
      const Voigt exact = stress_of(elasticity(material), Voigt{2e-3, 4e-3, 2e-3});
      for (const Voigt& stress : element_stresses(mesh, problem.materials, solution.cases[0].displacements)) {
        for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(stress[k], exact[k], 1e-12 * 10.0 * exact[1]) << name_of(type);
      }
    }
  }
}

TEST(Solve, TractionsGiveTheSameLinearFieldUpToRounding) {
  for (const ElementType type : all_types) {
    ElementMesh mesh = distorted(type, 3);
    const Voigt stress{3.0, -2.0, 1.5};
    Problem problem{.materials = {{0, plate}},
                    .supports = {{.where = "corner", .x = 0.0, .y = 0.0}, {.where = "other", .y = 0.0}}};
    name_node(mesh, "corner", {0, 0});
    name_node(mesh, "other", {1, 0});
    for (const char* side : {"bottom", "right", "top", "left"})
      problem.cases[0].sides.push_back({side, traction_of([=](Point) { return stress; })});
    const Solution solution = solved(mesh, problem);
    for (const Voigt& found : element_stresses(mesh, problem.materials, solution.cases[0].displacements)) {
      for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(found[k], stress[k], 1e-11) << name_of(type);
    }
    for (const Vector r : solution.cases[0].reactions) EXPECT_LT(length(r), 1e-12);
  }
}

Problem kirsch_problem(const Material& material) {
  Problem problem{.materials = {{0, material}},
                  .supports = {{.where = "bottom", .normal = 0.0}, {.where = "top", .x = 0.0}}};
  problem.cases[0].sides = {{"right", traction_of([](Point p) { return error::kirsch_stress(p); })}};
  return problem;
}

TEST(Solve, TheEnergyOfKirschsPlateHasSevenDigits) {
  const ElementMesh mesh = quarter_plate(ElementType::Q8, 64);
  EXPECT_NEAR(solved(mesh, kirsch_problem(block)).cases[0].energy, 0.00769365372642, 1e-7 * 0.0077);
  EXPECT_NEAR(solved(mesh, kirsch_problem(plate)).cases[0].energy, 0.00844491271144, 1e-7 * 0.0084);
}

/// Rate of the error in energy norm between meshes of n and 2 n cells, in the number of cells a side.
double rate(const std::function<double(int)>& energy, double exact, int n) {
  return std::log2(std::sqrt((exact - energy(n)) / (exact - energy(2 * n))));
}

TEST(Solve, TheErrorOnKirschsPlateFallsAtTheRateOfTheory) {
  constexpr double exact = 0.00844491271144;
  for (const ElementType type : all_types) {
    const auto energy = [&](int n) { return solved(quarter_plate(type, n), kirsch_problem(plate)).cases[0].energy; };
    const double order = mesh::is_quadratic(type) ? 2.0 : 1.0;
    EXPECT_NEAR(rate(energy, exact, mesh::is_quadratic(type) ? 12 : 24), order, 0.12 * order) << name_of(type);
  }
}

Problem l_problem() {
  Problem problem{.materials = {{0, {.young = 1.0, .poisson = 0.3, .state = PlaneState::Strain}}},
                  .supports = {{.where = "origin", .x = 0.0, .y = 0.0}, {.where = "far", .x = 0.0}}};
  const base::Angle bisector = base::Angle::from_degrees(135.0);
  problem.cases[0].sides = {{"loaded", traction_of([=](Point p) { return error::l_corner_stress(p, bisector); })}};
  return problem;
}

ElementMesh l_mesh(ElementType type, int n, double power) {
  ElementMesh mesh = l_shape(type, n, power);
  name_node(mesh, "origin", {0, 0});
  name_node(mesh, "far", {0, 1});
  return mesh;
}

TEST(Solve, TheEnergyOfTheReEntrantCornerIsThePublishedOne) {
  // Graded so that the corner no longer rules the error.
  EXPECT_NEAR(solved(l_mesh(ElementType::Q8, 48, 4.0), l_problem()).cases[0].energy, 4.15454423, 4e-6);
}

TEST(Solve, UniformRefinementOfTheReEntrantCornerFallsAsItsExponentSays) {
  const auto energy = [](int n) { return solved(l_mesh(ElementType::T6, n, 1.0), l_problem()).cases[0].energy; };
  EXPECT_NEAR(rate(energy, 4.15454423, 8), 0.5445, 0.02);
}

TEST(Solve, ALoadCaseIsTheSumOfItsPartsAndCasesShareOneFactorisation) {
  ElementMesh mesh = mapped_grid(ElementType::Q8, 6, 4, unit_square);
  name_node(mesh, "corner", {1, 1});
  const BodyForce weight{.force = [](Point) { return Vector{0.0, -7.0}; }};
  Problem problem{.materials = {{0, plate}}, .supports = {{.where = "left", .x = 0.01, .y = 0.0}}};
  problem.cases = {{.name = "weight", .bodies = {weight}, .settlement = 0.0},
                   {.name = "corner", .points = {{"corner", {3.0, 1.0}}}, .settlement = 0.0},
                   {.name = "pull", .sides = {{"right", linear({1, 0}, {1, 0}, {1, 1}, {2, 0})}}, .settlement = 0.0},
                   {.name = "all",
                    .sides = {{"right", linear({1, 0}, {1, 0}, {1, 1}, {2, 0})}},
                    .points = {{"corner", {3.0, 1.0}}},
                    .bodies = {weight}}};
  const Solution s = solved(mesh, problem);
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    Vector sum{0.01, 0.0};  // the settlement moves everything
    for (std::size_t c = 0; c < 3; ++c) sum = sum + s.cases[c].displacements[i];
    EXPECT_LT(length(sum - s.cases[3].displacements[i]), 1e-13);
  }
  Vector reaction;
  for (const Vector r : s.cases[3].reactions) reaction = reaction + r;
  EXPECT_NEAR(reaction.x, -3.0 - 1.5, 1e-11);
  EXPECT_NEAR(reaction.y, -1.0 + 7.0, 1e-11);
}

TEST(Solve, InclinedSupportsHoldAcrossAndLetSlideAlong) {
  // A bar turned by 30 degrees, pulled along its axis, symmetric about its lower side.
  const double c = std::cos(base::Angle::from_degrees(30.0).radians());
  const double s = std::sin(base::Angle::from_degrees(30.0).radians());
  const ElementMesh mesh = mapped_grid(ElementType::T6, 4, 2, [=](double x, double y) {
    return Point{2 * c * x - s * y, 2 * s * x + c * y};
  });
  Problem problem{.materials = {{0, plate}},
                  .supports = {{.where = "bottom", .normal = 0.0}, {.where = "left", .normal = 0.0}}};
  problem.cases[0].sides = {{"right", uniform({10.0 * c, 10.0 * s})}};
  const Solution solution = solved(mesh, problem);
  const Vector end = solution.cases[0].displacements[node_at(mesh, {2 * c, 2 * s}).index()];
  EXPECT_NEAR(end.x, 0.02 * c, 1e-14);
  EXPECT_NEAR(end.y, 0.02 * s, 1e-14);
}

TEST(Solve, TiesMakeASideMoveAsOneAndKeepTheBalance) {
  ElementMesh mesh = mapped_grid(ElementType::Q8, 4, 4, unit_square);
  Problem problem{.materials = {{0, plate}}, .supports = {{.where = "left", .x = 0.0, .y = 0.0}}};
  problem.ties = equal_displacement(mesh, "right", Axis::X).value();
  // A chain of ties, and one that repeats another.
  problem.ties.push_back(problem.ties.front());
  problem.cases[0].sides = {{"right", linear({1, 0}, {0, 0}, {1, 1}, {4, 0})}};
  const Solution s = solved(mesh, problem);
  const auto right = find_nodes(mesh, "right").value();
  for (const NodeId node : right)
    EXPECT_NEAR(s.cases[0].displacements[node.index()].x, s.cases[0].displacements[right[0].index()].x, 1e-15);
  double sum = 0.0;
  for (const Vector r : s.cases[0].reactions) sum += r.x;
  EXPECT_NEAR(sum, -2.0, 1e-11);  // what ties pull here they push there
  EXPECT_NEAR(s.cases[0].energy, 0.5 * 2.0 * s.cases[0].displacements[right[0].index()].x, 1e-13);
}

TEST(Solve, SpringsAndBedsCarryWhatTheyShould) {
  ElementMesh mesh = mapped_grid(ElementType::Q8, 3, 3, unit_square);
  name_node(mesh, "corner", {0, 0});
  Problem problem{.materials = {{0, plate}}, .supports = {{.where = "corner", .x = 0.0}}};
  problem.springs = {{"bottom", 0.0, 50.0, SpringKind::Foundation}};
  problem.cases[0].sides = {{"top", uniform({0.0, -3.0})}};
  const Solution bed = solved(mesh, problem);
  EXPECT_NEAR(bed.cases[0].displacements[node_at(mesh, {0, 0}).index()].y, -3.0 / 50.0, 1e-12);
  problem.springs = {{"corner", 0.0, 50.0, SpringKind::EachNode}};
  problem.supports.push_back({.where = "right", .x = 0.0});
  const Solution spring = solved(mesh, problem);
  EXPECT_NEAR(spring.cases[0].displacements[node_at(mesh, {0, 0}).index()].y, -3.0 / 50.0, 1e-12);
}

TEST(Solve, TwoMaterialsInSeriesStretchLikeTwoSprings) {
  const ElementMesh mesh =
      mapped_grid(ElementType::T6, 4, 2, unit_square, {.region = [](int i, int) { return i < 2 ? 1 : 2; }});
  Problem problem{.materials = {{1, {.young = 100.0, .poisson = 0.0, .thickness = 2.0}},
                                {2, {.young = 300.0, .poisson = 0.0, .thickness = 0.5}}},
                  .supports = {{.where = "left", .x = 0.0}, {.where = "bottom", .y = 0.0}}};
  problem.cases[0].sides = {{"right", uniform({12.0, 0.0})}};  // 6 N
  const double end = 6.0 * (0.5 / (100.0 * 2.0) + 0.5 / (300.0 * 0.5));
  EXPECT_NEAR(solved(mesh, problem).cases[0].displacements[node_at(mesh, {1, 1}).index()].x, end, 1e-13);
}

/// A quarter of a thick cylinder, radii 1 and 2, under a pressure of 1 inside; plane strain.
struct Cylinder {
  Material material;
  [[nodiscard]] static double radial(double r) { return 1.0 / 3.0 - 4.0 / 3.0 / (r * r); }
  [[nodiscard]] double moved(double r) const {
    const double nu = material.poisson;
    return (1.0 + nu) / material.young * ((1.0 - 2.0 * nu) * r / 3.0 + 4.0 / 3.0 / r);
  }
};
ElementMesh cylinder(ElementType type, int n) {
  return mapped_grid(type, n, n, [](double s, double t) {
    const double angle = 0.5 * std::numbers::pi * t;
    return Point{t == 1.0 ? 0.0 : (1.0 + s) * std::cos(angle), t == 0.0 ? 0.0 : (1.0 + s) * std::sin(angle)};
  });
}
/// Greatest error of the radial stress at the bore (recovered; the pressure is 1), and of the displacement there,
/// relative.
struct BoreErrors {
  double stress = 0.0, moved = 0.0;
};
BoreErrors at_the_bore(ElementType type, int n, double poisson) {
  const Cylinder exact{{.young = 1000.0, .poisson = poisson, .state = PlaneState::Strain}};
  const ElementMesh mesh = cylinder(type, n);
  Problem problem{.materials = {{0, exact.material}},
                  .supports = {{.where = "bottom", .y = 0.0}, {.where = "top", .x = 0.0}}};
  problem.cases[0].sides = {{"left", pressure(1.0)}};
  const Solution solution = solved(mesh, problem);
  const auto stresses = error::nodal_mean(
      mesh, error::recover_stress(mesh, problem.materials, solution.cases[0].displacements).at_element_nodes);
  BoreErrors errors;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const Vector e{mesh.points[i].x, mesh.points[i].y};
    if (std::abs(length(e) - 1.0) > 1e-9) continue;
    const Voigt& s = stresses[i];
    errors.stress = std::max(
        errors.stress, std::abs(s[0] * e.x * e.x + s[1] * e.y * e.y + 2.0 * s[2] * e.x * e.y - Cylinder::radial(1.0)));
    errors.moved =
        std::max(errors.moved, std::abs(dot(solution.cases[0].displacements[i], e) / exact.moved(1.0) - 1.0));
  }
  return errors;
}

TEST(Solve, ABoreUnderPressureIsRightUpToIncompressibility) {
  for (const ElementType type : {ElementType::T6, ElementType::Q8}) {
    for (const double nu : {0.3, 0.45, 0.49, 0.495, 0.4999, 0.49999, 0.4999999}) {
      const auto coarse = at_the_bore(type, 8, nu), fine = at_the_bore(type, 16, nu);
      printf("[ figures  ] bore, %s, nu %.7g: stress off by %.2e and %.2e, displacement by %.1e and %.1e\n",
             name_of(type), nu, coarse.stress, fine.stress, coarse.moved, fine.moved);
      EXPECT_LT(coarse.stress, 0.016) << name_of(type) << nu;
      EXPECT_LT(fine.stress, 0.25 * coarse.stress) << name_of(type) << nu;
      EXPECT_LT(coarse.moved, 1e-3) << name_of(type) << nu;
    }
  }
}

TEST(Solve, MixedElementsHoldALinearFieldAndItsEnergy) {
  const Material rubber{.young = 1000.0, .poisson = 0.4999999, .state = PlaneState::Strain};
  for (const ElementType type : {ElementType::T6, ElementType::Q8}) {
    ElementMesh mesh = distorted(type, 7);
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
      const Point p = mesh.points[i];
      if (p.x == 0 || p.x == 1 || p.y == 0 || p.y == 1) mesh.node_sets["rim"].push_back(NodeId(i));
    }
    const auto field = [](Point p) { return Vector{1e-3 + 2e-3 * p.x - 3e-3 * p.y, 5e-3 * p.x - 2e-3 * p.y}; };
    const Problem problem{.materials = {{0, rubber}}, .supports = {{.where = "rim", .field = field}}};
    const Solution solution = solved(mesh, problem);
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
      EXPECT_LT(length(solution.cases[0].displacements[i] - field(mesh.points[i])), 1e-11) << name_of(type);
    // Twice the energy is that of the strains alone.
    double energy = 0.0;
    for (const double own : element_energies(mesh, problem.materials, solution.cases[0].displacements)) energy += own;
    EXPECT_NEAR(energy, 2.0 * solution.cases[0].energy, 1e-6 * energy) << name_of(type);
    const double mu = shear_modulus(rubber);
    EXPECT_NEAR(energy, mu * (2 * 4e-6 + 2 * 4e-6 + 4e-6), 1e-4 * energy) << name_of(type);
  }
}

TEST(Solve, ElementsOfFirstOrderAreRefusedWhereTheyLock) {
  for (const ElementType type : all_types) {
    const ElementMesh mesh = mapped_grid(type, 2, 2, unit_square);
    const auto solution = [&](double nu, PlaneState state) {
      return solve(mesh, {.materials = {{0, {.young = 1.0, .poisson = nu, .state = state}}},
                          .supports = {{.where = "left", .x = 0.0, .y = 0.0}}});
    };
    EXPECT_TRUE(solution(0.45, PlaneState::Strain).ok());
    EXPECT_TRUE(solution(0.5, PlaneState::Stress).ok());
    const auto near = solution(0.4999999, PlaneState::Strain);
    EXPECT_EQ(near.ok(), mesh::is_quadratic(type)) << name_of(type);
    const std::string said = near ? "" : to_string(near.error());
    EXPECT_EQ(
        said.find("elements of first order lock in plane strain with Poisson's ratio 0.4999999") != std::string::npos,
        !mesh::is_quadratic(type))
        << said;
  }
}

TEST(Solve, BadInputIsNamedWithItsPlace) {
  const ElementMesh mesh = mapped_grid(ElementType::T3, 2, 2, unit_square, {.region = [](int, int j) { return j; }});
  const Problem good{.materials = {{0, plate}, {1, plate}}, .supports = {{.where = "left", .x = 0.0, .y = 0.0}}};
  const auto message = [&](Problem problem) {
    const auto solution = solve(mesh, problem);
    EXPECT_FALSE(solution.ok());
    return solution ? std::string() : to_string(solution.error());
  };
  Problem problem = good;
  problem.materials.erase(1);
  EXPECT_THAT(message(problem), HasSubstr("region 1 has no material; give it one (at 0, 0.5)"));
  problem = good;
  problem.materials[1].thickness = -1.0;
  EXPECT_THAT(message(problem), HasSubstr("region 1: the thickness is -1.0; it must be positive"));
  problem.materials[1] = {.young = 0.0, .poisson = 0.3};
  EXPECT_THAT(message(problem), HasSubstr("Young's modulus is 0.0"));
  problem.materials[1] = {.young = 1.0, .poisson = 0.5, .state = PlaneState::Strain};
  EXPECT_THAT(message(problem), HasSubstr("Poisson's ratio is 0.5"));
  problem = good;
  problem.cases[0].sides = {{"rigt", uniform({1, 0})}};
  EXPECT_THAT(message(problem), HasSubstr("the mesh has no curve 'rigt'; did you mean 'right'?"));
  problem = good;
  problem.springs = {{"left", -1.0, 0.0}};
  EXPECT_THAT(message(problem), HasSubstr("left: the stiffness of a spring must not be negative"));
  problem = good;
  problem.supports.push_back({.where = "bottom", .x = 0.1});
  EXPECT_THAT(message(problem), HasSubstr("support of 'bottom': prescribes a displacement that another"));
}

TEST(Solve, CooksMembraneHasItsReferenceValues) {
  ElementMesh mesh = cook(ElementType::Q8, 48);
  Problem problem{.materials = {{0, {.young = 1.0, .poisson = 1.0 / 3.0}}},
                  .supports = {{.where = "left", .x = 0.0, .y = 0.0}}};
  problem.cases[0].sides = {{"right", uniform({0.0, 1.0 / 16.0})}};
  const Solution solution = solved(mesh, problem);
  EXPECT_NEAR(solution.cases[0].displacements[node_at(mesh, {48, 52}).index()].y, 23.967, 0.005);
  EXPECT_NEAR(solution.cases[0].energy, 12.021, 0.003);
}

}  // namespace
}  // namespace dobra::fem
