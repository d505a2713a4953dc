#include "shared/geom/predicates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "tests/shared/geom/exact.h"

namespace dobra::geom {
namespace {

using namespace testing;

TEST(Predicates, LeftTurnIsPositive) {
  EXPECT_EQ(orient2d({0, 0}, {1, 0}, {0, 1}), Sign::Positive);
  EXPECT_EQ(orient2d({0, 0}, {0, 1}, {1, 0}), Sign::Negative);
  EXPECT_EQ(orient2d({0, 0}, {1, 1}, {3, 3}), Sign::Zero);
  EXPECT_EQ(orient2d({2, 2}, {2, 2}, {7, 1}), Sign::Zero);
}

TEST(Predicates, InsideTheCircleOfAnticlockwisePointsIsPositive) {
  EXPECT_EQ(incircle({1, 0}, {0, 1}, {-1, 0}, {0, 0}), Sign::Positive);
  EXPECT_EQ(incircle({1, 0}, {0, 1}, {-1, 0}, {0, -2}), Sign::Negative);
  EXPECT_EQ(incircle({1, 0}, {0, 1}, {-1, 0}, {0, -1}), Sign::Zero);
  EXPECT_EQ(incircle({-1, 0}, {0, 1}, {1, 0}, {0, 0}), Sign::Negative);
}

TEST(Predicates, CrossAndDotOfDisplacementsHaveTheirClosedForms) {
  EXPECT_EQ(cross_sign({5, 5}, {6, 5}, {0, 0}, {0, 3}), Sign::Positive);
  EXPECT_EQ(cross_sign({5, 5}, {6, 6}, {1, 0}, {3, 2}), Sign::Zero);
  EXPECT_EQ(dot_sign({0, 0}, {1, 0}, {0, 0}, {1, 9}), Sign::Positive);
  EXPECT_EQ(dot_sign({0, 0}, {1, 0}, {2, 0}, {2, 9}), Sign::Zero);
  EXPECT_EQ(dot_sign({0, 0}, {1, 1}, {2, 0}, {2, -9}), Sign::Negative);
}

// Kettner et al., Classroom examples of robustness problems (2008): p moves over a grid of neighbouring doubles.
TEST(Predicates, GridOfNeighbouringDoublesRoundALineIsDecidedExactly) {
  struct Case {
    Point p, q, r;
  };
  const std::array<Case, 4> cases{Case{{0.5, 0.5}, {12, 12}, {24, 24}},
                                  Case{{0.50000000000002531, 0.5000000000000171},
                                       {17.300000000000001, 17.300000000000001},
                                       {24.00000000000005, 24.0000000000000517765}},
                                  Case{{0.5, 0.5}, {8.8000000000000007, 8.8000000000000007}, {12.1, 12.1}},
                                  Case{{0.1, 0.1}, {1e5 + 0.1, 1e5 + 0.1}, {1e-3 / 3, 1e-3 / 3}}};
  int zeros = 0;
  for (const auto& [p, q, r] : cases) {
    for (int i = 0; i < 48; ++i) {
      for (int j = 0; j < 48; ++j) {
        const Point moved{moved_by_ulps(p.x, i), moved_by_ulps(p.y, j)};
        const Sign sign = orient2d(moved, q, r);
        ASSERT_EQ(sign, exact_orient2d(moved, q, r)) << i << ' ' << j;
        zeros += sign == Sign::Zero;
      }
    }
  }
  EXPECT_GT(zeros, 48);  // the grid really holds degenerate points
}

TEST(Predicates, GridOfNeighbouringDoublesRoundACircleIsDecidedExactly) {
  struct Case {
    Point a, b, c, d;
  };
  const std::array<Case, 3> cases{Case{{13, 0}, {0, 13}, {-5, 12}, {12, -5}},
                                  Case{{1.5e3 + 0.65, 7}, {1.5e3, 7.65}, {1.5e3 - 0.25, 7.6}, {1.5e3 + 0.6, 6.75}},
                                  Case{{0.1, 0.2}, {0.1, 0.7}, {-0.4, 0.7}, {-0.4, 0.2}}};
  int zeros = 0;
  for (const auto& [a, b, c, d] : cases) {
    for (int i = -12; i <= 12; ++i) {
      for (int j = -12; j <= 12; ++j) {
        const Point moved{moved_by_ulps(d.x, i), moved_by_ulps(d.y, j)};
        const Sign sign = incircle(a, b, c, moved);
        ASSERT_EQ(sign, exact_incircle(a, b, c, moved)) << a << ' ' << i << ' ' << j;
        zeros += sign == Sign::Zero;
      }
    }
  }
  EXPECT_GT(zeros, 0);
}

TEST(Predicates, PointsOfOneCircleRoundedToDoublesAreDecidedExactly) {
  // As a hole's sides give them: far from the origin and near it, wide apart and in a short arc.
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::array<int, 3> signs{};
  for (int i = 0; i < 600; ++i) {
    const Point centre{i % 3 == 0 ? 0.0 : 1e3 * unit(random), i % 3 == 0 ? 0.0 : unit(random)};
    const double radius = 0.1 + 10.0 * unit(random);
    const double arc = i % 2 == 0 ? 6.0 : 1e-3;
    std::array<Point, 4> p{};
    for (std::size_t k = 0; k < 4; ++k) {
      const double angle = arc * (static_cast<double>(k) + unit(random)) / 4.0;
      p[k] = {centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)};
    }
    const Sign sign = incircle(p[0], p[1], p[2], p[3]);
    ASSERT_EQ(sign, exact_incircle(p[0], p[1], p[2], p[3])) << i;
    ++signs[sign == Sign::Negative ? 0 : sign == Sign::Zero ? 1 : 2];
  }
  EXPECT_GT(signs[0], 200);
  EXPECT_GT(signs[2], 200);
}

class PredicatesExponents : public ::testing::TestWithParam<std::pair<int, int>> {};

TEST_P(PredicatesExponents, AgreeWithRationals) {
  const auto [least, greatest] = GetParam();
  std::mt19937_64 random(20260101);
  for (int i = 0; i < 400; ++i) {
    const Point a = random_point(random, least, greatest);
    const Point b = random_point(random, least, greatest);
    const Point c = random_point(random, least, greatest);
    // The fourth is on or next to the third's line or circle.
    const Point d = i % 2 == 0 ? random_point(random, least, greatest)
                               : Point{moved_by_ulps(a.x, i % 3), moved_by_ulps(a.y, i % 5 - 2)};
    const Point e{0.5 * a.x + 0.5 * b.x, 0.5 * a.y + 0.5 * b.y};
    ASSERT_EQ(orient2d(a, b, c), exact_orient2d(a, b, c));
    ASSERT_EQ(orient2d(a, b, e), exact_orient2d(a, b, e));
    ASSERT_EQ(cross_sign(a, b, c, d), sign_of(exact_cross(a, b, c, d)));
    ASSERT_EQ(dot_sign(a, b, c, d), sign_of(exact_dot(a, b, c, d)));
    ASSERT_EQ(incircle(a, b, c, d), exact_incircle(a, b, c, d));
    ASSERT_EQ(incircle(a, b, e, d), exact_incircle(a, b, e, d));
  }
}

// The last three leave the range of expansions: 2^-1074 is the least subnormal, 2^1023 the greatest power of two.
INSTANTIATE_TEST_SUITE_P(Ranges, PredicatesExponents,
                         ::testing::Values(std::pair{0, 0}, std::pair{-60, 60}, std::pair{-199, 198},
                                           std::pair{-1074, -1000}, std::pair{-1074, 1023}, std::pair{900, 1023}));

TEST(Predicates, ExactlyCollinearAndCocircularPointsAtTheEndsOfTheRangeAreZero) {
  for (const int exponent : {-1070, -600, -199, 190, 600, 1010}) {
    const double u = std::ldexp(1.0, exponent);
    EXPECT_EQ(orient2d({u, 2 * u}, {3 * u, 5 * u}, {5 * u, 8 * u}), Sign::Zero) << exponent;
    EXPECT_EQ(orient2d({u, 2 * u}, {3 * u, 5 * u}, {5 * u, 9 * u}), Sign::Positive) << exponent;
    EXPECT_EQ(incircle({5 * u, 0}, {3 * u, 4 * u}, {-4 * u, 3 * u}, {-3 * u, -4 * u}), Sign::Zero) << exponent;
    EXPECT_EQ(incircle({5 * u, 0}, {3 * u, 4 * u}, {-4 * u, 3 * u}, {-3 * u, -3 * u}), Sign::Positive) << exponent;
  }
}

TEST(Predicates, SwappingTwoPointsChangesTheSign) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 300; ++i) {
    // Small integers over three: many degenerate cases, none of them exact in binary.
    const auto point = [&] {
      const Point p = integer_point(random, 6);
      return Point{p.x / 3.0, p.y / 3.0};
    };
    const std::array<Point, 4> p{point(), point(), point(), point()};
    std::array<std::size_t, 4> order{0, 1, 2, 3};
    const Sign circle = incircle(p[0], p[1], p[2], p[3]);
    const Sign turn = orient2d(p[0], p[1], p[2]);
    do {
      int inversions = 0;
      for (std::size_t j = 0; j < 4; ++j) {
        for (std::size_t k = j + 1; k < 4; ++k) inversions += order[j] > order[k];
      }
      const Sign parity = inversions % 2 == 0 ? Sign::Positive : Sign::Negative;
      ASSERT_EQ(incircle(p[order[0]], p[order[1]], p[order[2]], p[order[3]]), parity * circle);
      if (order[3] == 3) {
        ASSERT_EQ(orient2d(p[order[0]], p[order[1]], p[order[2]]), parity * turn);
      }
    } while (std::next_permutation(order.begin(), order.end()));
  }
}

}  // namespace
}  // namespace dobra::geom
