#include "shared/mesh/delaunay/filtered_predicates.h"

#include <gtest/gtest.h>

#include <random>

namespace dobra::mesh::delaunay {
namespace {

using geom::Point;

/// The same signs as the exact predicates.
void expect_equal(Point a, Point b, Point c, Point d) {
  EXPECT_EQ(filtered_orientation(a, b, c), geom::orient2d(a, b, c)) << a << b << c;
  EXPECT_EQ(filtered_incircle(a, b, c, d), geom::incircle(a, b, c, d)) << a << b << c << d;
}

TEST(FilteredPredicates, AgreeWithTheExactOnesOnGridsAndAnUlpBesideThem) {
  std::mt19937_64 random(1);
  const auto coordinate = [&] {
    double value = static_cast<double>(random() % 8);
    if (random() % 4 == 0) value = std::nextafter(value, random() % 2 == 0 ? 100.0 : -100.0);
    return value;
  };
  for (int k = 0; k < 20'000; ++k) {
    std::array<Point, 4> p{};
    for (Point& q : p) q = {coordinate(), coordinate()};
    expect_equal(p[0], p[1], p[2], p[3]);
  }
}

TEST(FilteredPredicates, AgreeAtTheEndsOfTheRangeOfDoubles) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (const int exponent : {-1070, -700, -540, -350, -180, 0, 180, 350, 510, 1020}) {
    for (int k = 0; k < 300; ++k) {
      std::array<Point, 4> p{};
      for (Point& q : p) {
        const int shift = k % 3 == 0 ? static_cast<int>(random() % 200) - 100 : 0;
        q = {std::ldexp(unit(random), std::min(exponent + shift, 1022)), std::ldexp(unit(random), exponent)};
      }
      expect_equal(p[0], p[1], p[2], p[3]);
    }
  }
}

}  // namespace
}  // namespace dobra::mesh::delaunay
