#include "shared/fem/error/exact_fields.h"

#include <gtest/gtest.h>

namespace dobra::fem::error {
namespace {

using geom::Point;
using geom::Vector;

TEST(ExactFields, KirschHasItsPublishedStresses) {
  EXPECT_NEAR(kirsch_stress({0, 1})[0], 3.0, 1e-15);
  EXPECT_NEAR(kirsch_stress({1, 0})[1], -1.0, 1e-15);
  EXPECT_NEAR(kirsch_stress({5, 0})[0], 0.9024, 1e-15);
  EXPECT_NEAR(kirsch_stress({5, 0})[1], 0.0176, 1e-15);
  EXPECT_NEAR(kirsch_stress({0, 5})[0], 1.0224, 1e-15);
  EXPECT_NEAR(kirsch_stress({0, 5})[1], 0.0576, 1e-15);
}

TEST(ExactFields, CornerExponentsAreThePublishedRoots) {
  const auto degrees = [](double d) { return base::Angle::from_degrees(d); };
  EXPECT_NEAR(corner_exponent(degrees(270)), 0.544483736782464, 1e-14);
  EXPECT_NEAR(corner_exponent(degrees(270), CornerMode::Sliding), 0.908529189846, 1e-12);
  EXPECT_NEAR(corner_exponent(degrees(360)), 0.5, 1e-14);
  EXPECT_NEAR(corner_exponent(degrees(180)), 1.0, 1e-14);
}

/// div sigma by differences.
Vector divergence(const std::function<Voigt(Point)>& stress, Point p) {
  constexpr double h = 1e-5;
  const auto s = [&](double dx, double dy) { return stress({p.x + dx, p.y + dy}); };
  const auto d = [&](std::size_t i, double x, double y) {
    return (s(x * h, y * h)[i] - s(-x * h, -y * h)[i]) / (2 * h);
  };
  return {d(0, 1, 0) + d(2, 0, 1), d(2, 1, 0) + d(1, 0, 1)};
}

TEST(ExactFields, EveryFieldIsInEquilibriumAndItsFacesAreFree) {
  const Material material{.young = 3.0, .poisson = 0.25, .state = PlaneState::Strain};
  for (const TipLoad load : {TipLoad::Opening, TipLoad::Sliding, TipLoad::Force}) {
    const auto stress = [&](Point p) { return tip_field(p, load, material).stress; };
    for (const Point p : {Point{0.3, 0.4}, Point{-0.5, 0.2}, Point{-0.1, -0.7}})
      EXPECT_LT(length(divergence(stress, p)), 1e-8);
    for (const double y : {0.0, -0.0}) {
      EXPECT_NEAR(stress({-2.0, y})[1], 0.0, 1e-15);
      EXPECT_NEAR(stress({-2.0, y})[2], 0.0, 1e-15);
    }
  }
  const auto corner = [](Point p) { return l_corner_stress(p, base::Angle::from_degrees(135.0)); };
  EXPECT_LT(length(divergence(corner, {-0.3, 0.5})), 1e-8);
  EXPECT_NEAR(corner({2.0, 0.0})[1], 0.0, 1e-14);
  EXPECT_NEAR(corner({2.0, 0.0})[2], 0.0, 1e-14);
  EXPECT_NEAR(corner({0.0, -2.0})[0], 0.0, 1e-14);
}

TEST(ExactFields, GradientsAreThoseOfTheDisplacements) {
  const Material material{.young = 3.0, .poisson = 0.25, .state = PlaneState::Stress};
  constexpr double h = 1e-6;
  for (const TipLoad load : {TipLoad::Opening, TipLoad::Sliding}) {
    const Point p{-0.3, 0.4};
    const Gradient g = tip_field(p, load, material).gradient;
    const Vector dx =
        (tip_displacement({p.x + h, p.y}, load, material) - tip_displacement({p.x - h, p.y}, load, material)) / (2 * h);
    const Vector dy =
        (tip_displacement({p.x, p.y + h}, load, material) - tip_displacement({p.x, p.y - h}, load, material)) / (2 * h);
    EXPECT_NEAR(g[0], dx.x, 1e-8);
    EXPECT_NEAR(g[1], dy.x, 1e-8);
    EXPECT_NEAR(g[2], dx.y, 1e-8);
    EXPECT_NEAR(g[3], dy.y, 1e-8);
  }
}

TEST(ExactFields, ModesHaveUnitIntensityAheadOfTheTip) {
  const Material material{.young = 3.0, .poisson = 0.25};
  const double unit = 1.0 / std::sqrt(2.0 * std::numbers::pi * 0.09);
  EXPECT_NEAR(tip_field({0.09, 0}, TipLoad::Opening, material).stress[1], unit, 1e-14);
  EXPECT_NEAR(tip_field({0.09, 0}, TipLoad::Sliding, material).stress[2], unit, 1e-14);
}

TEST(ExactFields, TheLineForceIsBalancedByTheStressesRoundIt) {
  const Material material{.young = 3.0, .poisson = 0.25};
  Vector sum;
  constexpr int n = 3600;
  for (int i = 0; i < n; ++i) {
    const double t = -std::numbers::pi + (i + 0.5) * 2.0 * std::numbers::pi / n;
    const Vector normal{std::cos(t), std::sin(t)};
    const Voigt s = tip_field({0.5 * normal.x, 0.5 * normal.y}, TipLoad::Force, material).stress;
    sum = sum + (0.5 * 2.0 * std::numbers::pi / n) *
                    Vector{s[0] * normal.x + s[2] * normal.y, s[2] * normal.x + s[1] * normal.y};
  }
  EXPECT_NEAR(sum.x, -1.0, 1e-6);
  EXPECT_NEAR(sum.y, 0.0, 1e-9);
}

}  // namespace
}  // namespace dobra::fem::error
