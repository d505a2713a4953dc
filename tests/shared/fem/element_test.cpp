#include "shared/fem/element.h"

#include <gtest/gtest.h>

#include "shared/fem/material.h"
#include "tests/support/fem_meshes.h"

namespace dobra::fem {
namespace {

using namespace test;

TEST(Element, ShapeFunctionsAddUpToOneAndTheirDerivativesToNothing) {
  for (const ElementType type : all_types) {
    const Shape s = shape_at(type, 0.21, 0.37);
    double n = 0.0, x = 0.0, y = 0.0;
    for (std::size_t i = 0; i < most_nodes; ++i) {
      n += s.n[i];
      x += s.d_xi[i];
      y += s.d_eta[i];
    }
    EXPECT_NEAR(n, 1.0, 1e-15);
    EXPECT_NEAR(x, 0.0, 1e-15);
    EXPECT_NEAR(y, 0.0, 1e-15);
  }
}

TEST(Element, DerivativesAreThoseOfTheValues) {
  constexpr double h = 1e-6;
  for (const ElementType type : all_types) {
    const Shape s = shape_at(type, 0.21, 0.37);
    for (std::size_t i = 0; i < mesh::node_count(type); ++i) {
      EXPECT_NEAR(s.d_xi[i], (shape_at(type, 0.21 + h, 0.37).n[i] - shape_at(type, 0.21 - h, 0.37).n[i]) / (2 * h),
                  1e-9);
      EXPECT_NEAR(s.d_eta[i], (shape_at(type, 0.21, 0.37 + h).n[i] - shape_at(type, 0.21, 0.37 - h).n[i]) / (2 * h),
                  1e-9);
    }
  }
}

/// The integral of x^a y^b over the reference element.
double monomial(ElementType type, int a, int b) {
  if (mesh::corner_count(type) == 3) return std::tgamma(a + 1) * std::tgamma(b + 1) / std::tgamma(a + b + 3);
  return a % 2 != 0 || b % 2 != 0 ? 0.0 : 4.0 / (a + 1) / (b + 1);
}

TEST(Element, RulesIntegrateTheirDegree) {
  struct Case {
    ElementType type;
    Rule rule;
    int degree;
  };
  for (const auto& [type, rule, degree] :
       {Case{ElementType::T3, Rule::Straight, 1}, Case{ElementType::T6, Rule::Straight, 2},
        Case{ElementType::T6, Rule::Curved, 5}, Case{ElementType::Q4, Rule::Straight, 3},
        Case{ElementType::Q8, Rule::Straight, 5}, Case{ElementType::Q8, Rule::Sample, 3}}) {
    for (int a = 0; a <= degree; ++a) {
      for (int b = 0; a + b <= degree; ++b) {
        double sum = 0.0;
        for (const auto& p : integration_points(type, rule)) sum += p.weight * std::pow(p.xi, a) * std::pow(p.eta, b);
        EXPECT_NEAR(sum, monomial(type, a, b), 1e-15) << name_of(type) << ' ' << a << ' ' << b;
      }
    }
  }
}

TEST(Element, SidePointsIntegrateDegreeNine) {
  for (int a = 0; a <= 9; ++a) {
    double sum = 0.0;
    for (const auto& p : side_points()) sum += p.weight * std::pow(p.xi, a);
    EXPECT_NEAR(sum, a % 2 == 0 ? 2.0 / (a + 1) : 0.0, 1e-15);
  }
}

TEST(Element, QuarterPointsMakeTheSquareRootOfTheDistance) {
  // Along every ray from corner 0: r grows with the square of the parameter, so a linear field of the parameter is
  // sqrt(r).
  const std::vector<Point> nodes{{0, 0}, {1, 0}, {0.3, 0.9}, {0.25, 0}, {0.65, 0.45}, {0.075, 0.225}};
  for (const double eta : {0.0, 0.3, 0.8}) {
    const auto at = [&](double t) { return map(nodes, shape_at(ElementType::T6, t * (1 - eta), t * eta)).at; };
    const double far = distance(at(1.0), {0, 0});
    for (const double t : {0.1, 0.25, 0.5, 0.9}) EXPECT_NEAR(distance(at(t), {0, 0}), far * t * t, 1e-15);
  }
}

TEST(Material, StrainIsTheInverseOfStress) {
  for (const PlaneState state : {PlaneState::Stress, PlaneState::Strain}) {
    const Elasticity d = elasticity({.young = 7.0, .poisson = 0.4999, .state = state});
    const Voigt strain{1.0, -0.3, 0.2};
    const Voigt back = strain_of(d, stress_of(d, strain));
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(back[i], strain[i], 1e-11);
  }
}

TEST(Material, PrincipalStressesOfPureShearStandAt45Degrees) {
  const Principal p = principal({0.0, 0.0, 2.0});
  EXPECT_DOUBLE_EQ(p.greatest, 2.0);
  EXPECT_DOUBLE_EQ(p.least, -2.0);
  EXPECT_DOUBLE_EQ(p.angle, 0.25 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(von_mises({0.0, 0.0, 2.0}, {.young = 1.0}), 2.0 * std::sqrt(3.0));
}

}  // namespace
}  // namespace dobra::fem
