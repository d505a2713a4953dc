#include "shared/fem/error/recover.h"

#include <gtest/gtest.h>

#include "shared/fem/error/estimate.h"
#include "shared/fem/error/exact_fields.h"
#include "shared/fem/error/new_sizes.h"
#include "shared/fem/solve.h"
#include "tests/support/fem_meshes.h"

namespace dobra::fem::error {
namespace {

using namespace test;

constexpr Material plate{.young = 1000.0, .poisson = 0.3};

TEST(Recover, APolynomialOfTheBasisIsFoundExactlyWhateverTheWeights) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (const Basis basis : {Basis::Linear, Basis::Quadratic, Basis::Bilinear, Basis::Serendipity}) {
    std::vector<Point> points;
    std::vector<double> weights;
    for (int i = 0; i < 12; ++i) {
      const double x = unit(random);
      points.push_back({3 + 0.01 * x, -2 + 0.01 * unit(random)});
      weights.push_back(1.5 + unit(random));
    }
    const auto value = [&](Point p) {
      const double x = 100 * (p.x - 3), y = 100 * (p.y + 2);
      double sum = 1 - 2 * x + 3 * y;
      if (basis == Basis::Quadratic || basis == Basis::Serendipity) sum += x * x - y * y;
      if (basis != Basis::Linear) sum += 4 * x * y;
      if (basis == Basis::Serendipity) sum += 2 * x * x * y - x * y * y;
      return sum;
    };
    const PatchFit fit(basis, {3, -2}, 0.01, points, weights);
    ASSERT_TRUE(fit.determined());
    const auto w = fit.weights_at({3.004, -2.003});
    double sum = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) sum += w[i] * value(points[i]);
    EXPECT_NEAR(sum, value({3.004, -2.003}), 1e-10);
  }
}

TEST(Recover, PointsOnALineDetermineNothing) {
  std::vector<Point> line;
  for (int i = 0; i < 8; ++i) line.push_back({0.1 * i, 0.2 * i});
  EXPECT_FALSE(PatchFit(Basis::Linear, {0, 0}, 1.0, line).determined());
  EXPECT_FALSE(PatchFit(Basis::Linear, {0, 0}, 1.0, std::span(line).first(2)).determined());
}

/// Displacements of a field at the nodes.
std::vector<Vector> nodal(const ElementMesh& mesh, const std::function<Vector(Point)>& field) {
  std::vector<Vector> u;
  for (const Point p : mesh.points) u.push_back(field(p));
  return u;
}

TEST(Recover, StressesOfTheElementsOwnOrderAreExactUpToTheBoundary) {
  // Quadratic displacements on T6 and Q8: linear stresses, which the patches reproduce.
  for (const ElementType type : {ElementType::T6, ElementType::Q8}) {
    const ElementMesh mesh = mapped_grid(type, 4, 3, [](double s, double t) { return Point{2 * s + 0.3 * t, t}; });
    const auto u = nodal(mesh, [](Point p) { return Vector{p.x * p.x - p.x * p.y, 2 * p.y * p.y + p.x * p.y}; });
    const RecoveredStress recovered = recover_stress(mesh, {{0, plate}}, u);
    EXPECT_EQ(recovered.degraded, 0U);
    for (std::size_t k = 0; k < mesh.nodes.size(); ++k) {
      const Point p = mesh.point(mesh.nodes[k]);
      const Voigt exact = stress_of(elasticity(plate), Voigt{2 * p.x - p.y, 4 * p.y + p.x, -p.x + p.y});
      for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(recovered.at_element_nodes[k][i], exact[i], 1e-8) << name_of(type);
    }
  }
}

TEST(Recover, PatchesDoNotCrossMaterials) {
  const ElementMesh mesh =
      mapped_grid(ElementType::T6, 6, 4, unit_square, {.region = [](int i, int) { return i < 3 ? 0 : 1; }});
  Problem problem{.materials = {{0, plate}, {1, {.young = 10.0, .poisson = 0.0}}},
                  .supports = {{.where = "left", .x = 0.0},
                               {.where = "right", .x = 0.1},
                               {.where = "bottom", .y = 0.0},
                               {.where = "top", .y = 0.0}}};
  const auto u = solve(mesh, problem).value().cases[0].displacements;
  const RecoveredStress recovered = recover_stress(mesh, problem.materials, u);
  const ErrorEstimate estimate = estimate_error(mesh, problem.materials, u, recovered);
  EXPECT_LT(estimate.eta, 1e-10);  // constant on each side, with a jump of sigma_y between
  const auto jump = recovered.at_element_nodes;
  double least = 1e300, greatest = -1e300;
  for (const Voigt& s : jump) {
    least = std::min(least, s[1]);
    greatest = std::max(greatest, s[1]);
  }
  EXPECT_GT(greatest - least, 0.1 * std::abs(greatest));
}

TEST(Recover, PatchesDoNotCrossTheLipsOfACrack) {
  TipMesh options{.outline = {{0, -1}, {2, -1}, {2, 1}, {0, 1}}, .tip = {1, 0}, .ahead = {1, 0}, .radius = 0.1};
  options.outline.push_back({0, 0});  // the mouth
  const ElementMesh mesh = tip_mesh(options);
  // Zero below the crack, stressed above, away from the tip: nothing of it may leak through the lips.
  const auto u = nodal(mesh, [](Point) { return Vector{}; });
  std::vector<Vector> upper = u;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const auto nodes = mesh.nodes_of(mesh::ElementId(e));
    const Point middle =
        geom::midpoint(mesh.point(nodes[0]), geom::midpoint(mesh.point(nodes[1]), mesh.point(nodes[2])));
    if (middle.y < 0.0) continue;
    for (const NodeId node : nodes) upper[node.index()] = Vector{0.01 * mesh.point(node).x, 0.0};
  }
  const RecoveredStress recovered = recover_stress(mesh, {{0, plate}}, upper);
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const auto nodes = mesh.nodes_of(mesh::ElementId(e));
    for (std::size_t a = 0; a < 6; ++a) {
      const Point p = mesh.point(nodes[a]);
      if (p.x > 0.5) continue;  // well behind the tip
      const Point middle =
          geom::midpoint(mesh.point(nodes[0]), geom::midpoint(mesh.point(nodes[1]), mesh.point(nodes[2])));
      const double exact = middle.y > 0.0 ? 1000.0 * 0.01 / (1.0 - 0.09) : 0.0;
      EXPECT_NEAR(recovered.at_element_nodes[mesh.first[e] + a][0], exact, 1e-9) << p;
    }
  }
}

TEST(Estimate, TheEffectivityOnKirschsPlateIsNearOne) {
  constexpr double exact = 0.00844491271144;
  for (const ElementType type : all_types) {
    const ElementMesh mesh = quarter_plate(type, mesh::is_quadratic(type) ? 12 : 24);
    Problem problem{.materials = {{0, plate}}, .supports = {{.where = "bottom", .y = 0.0}, {.where = "top", .x = 0.0}}};
    problem.cases[0].sides = {{"right", traction_of([](Point p) { return kirsch_stress(p); })}};
    const auto result = solve(mesh, problem).value().cases[0];
    const auto estimate = estimate_error(mesh, problem.materials, result.displacements,
                                         recover_stress(mesh, problem.materials, result.displacements));
    EXPECT_NEAR(estimate.norm * estimate.norm, 2.0 * result.energy, 1e-12);
    const double effectivity = estimate.error / true_error(exact, result.energy);
    EXPECT_GT(effectivity, 0.9) << name_of(type);
    EXPECT_LT(effectivity, 1.1) << name_of(type);
  }
}

TEST(NewSizes, EvenErrorsAtTheTargetKeepTheMeshWithBothRules) {
  const ElementMesh mesh = mapped_grid(ElementType::T6, 5, 5, unit_square);
  ErrorEstimate estimate{std::vector<double>(50, 1.0), std::sqrt(50.0), 0.0, 0.0};
  estimate.norm = std::sqrt(50.0) * std::sqrt(1 / (0.05 * 0.05) - 1);
  for (const SizeRule rule : {SizeRule::EqualError, SizeRule::Optimal}) {
    const auto sizes = new_sizes(mesh, estimate, {}, {.target = 0.05, .rule = rule}).value();
    for (std::size_t e = 0; e < 50; ++e) EXPECT_NEAR(sizes[e] / element_size(mesh, e), 1.0, 1e-9);
  }
}

TEST(NewSizes, TheOptimalRuleIsTheClosedFormWhereNothingIsSingular) {
  const ElementMesh mesh = mapped_grid(ElementType::T3, 5, 5, unit_square);
  ErrorEstimate estimate;
  for (int i = 0; i < 50; ++i) estimate.elements.push_back(1.0 + 0.02 * i);
  double sum = 0.0, error = 0.0;
  for (const double e : estimate.elements) {
    sum += std::pow(e, 2.0 / 2.0);
    error += e * e;
  }
  estimate.error = std::sqrt(error);
  estimate.norm = 100.0;
  const double allowed = 0.08 * std::hypot(estimate.norm, estimate.error);
  const auto sizes = new_sizes(mesh, estimate, {}, {.target = 0.08, .rule = SizeRule::Optimal}).value();
  for (std::size_t e = 0; e < 50; ++e) {
    const double expected = allowed / std::sqrt(estimate.elements[e]) / std::sqrt(sum);
    EXPECT_NEAR(sizes[e] / element_size(mesh, e), expected, 1e-9);
  }
}

TEST(NewSizes, SingularVerticesAskForSmallerElementsAndClampsHold) {
  const ElementMesh mesh = mapped_grid(ElementType::T6, 4, 4, unit_square);
  ErrorEstimate estimate{std::vector<double>(32, 0.02), 0.02 * std::sqrt(32.0), 1.0, 0.0};
  const NodeId corner = node_at(mesh, {0, 0});
  NewSizeOptions options{.target = 0.05, .rule = SizeRule::EqualError};
  const auto plain = new_sizes(mesh, estimate, {}, options).value();
  const auto aware = new_sizes(mesh, estimate, {{corner, 0.5}}, options).value();
  EXPECT_LT(aware[0], plain[0]);
  EXPECT_EQ(aware[31], plain[31]);
  options.min_size = 0.2;
  const auto clamped = new_sizes(mesh, estimate, {}, options).value();
  EXPECT_GE(*std::min_element(clamped.begin(), clamped.end()), 0.2);
  EXPECT_FALSE(new_sizes(mesh, estimate, {}, {.target = 0.0}).ok());
}

}  // namespace
}  // namespace dobra::fem::error
