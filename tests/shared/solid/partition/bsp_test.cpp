#include "shared/solid/partition/bsp.h"

#include <gmock/gmock.h>

#include <random>

#include "shared/geom/polyline.h"
#include "tests/shared/solid/shapes.h"

namespace dobra::solid::partition {
namespace {

using geom::Point3;
using shapes::box_solid;

const std::vector<std::pair<double, double>> ell{{0, 0}, {6, 0}, {6, 2}, {2, 2}, {2, 6}, {0, 6}};  // area 20

/// How many of random points, half of them on a coarse lattice, the tree and the locator place differently.
std::size_t differences(const Bsp& tree, const Solid& solid, int count, double low, double high) {
  const PointLocator locator(solid);
  std::mt19937 random(9);
  std::uniform_real_distribution<double> number(low, high);
  std::size_t found = 0;
  for (int i = 0; i < count; ++i) {
    Point3 p{number(random), number(random), number(random)};
    if (i % 2 == 0) p = {std::round(2 * p.x) / 2, std::round(2 * p.y) / 2, std::round(2 * p.z) / 2};
    found += tree.locate(p) == locator.locate(p) ? 0 : 1;
  }
  return found;
}

TEST(Bsp, NothingHasNoInside) {
  const Bsp none = Bsp::of(Solid()).value();
  EXPECT_EQ(none.locate({0, 0, 0}), Location::Outside);
  EXPECT_EQ(none.inner_volume(), 0.0);
  EXPECT_EQ(none.plane_count(), 0U);
}

TEST(Bsp, REP_c_InnerLeavesOfAnLAddUpToItsArea) {
  const Solid solid = shapes::solid(shapes::prism(ell, 0.0, 1.0));
  for (const int few : {1, 8, 1000}) {
    const Bsp tree = Bsp::of(solid, {.few = few}).value();
    EXPECT_DOUBLE_EQ(tree.inner_volume(), 20.0);
  }
}

TEST(Bsp, REP_c_PointsOfAnLLieWhereThePolygonSays) {
  const Bsp tree = Bsp::of(shapes::solid(shapes::prism(ell, -1.0, 1.0))).value();
  geom::Polyline polygon{{}, true};
  for (const auto& [x, y] : ell) polygon.points.push_back({x, y});
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(-1.0, 7.0);
  std::array<int, 3> seen{};
  for (int i = 0; i < 10000; ++i) {
    geom::Point p{number(random), number(random)};
    if (i % 2 == 0) p = {std::round(p.x), std::round(p.y)};
    const geom::Side side = geom::locate(polygon, p);
    const Location expected = side == geom::Side::Inside    ? Location::Inside
                              : side == geom::Side::Outside ? Location::Outside
                                                            : Location::Boundary;
    ASSERT_EQ(tree.locate({p.x, p.y, 0.0}), expected) << p.x << ' ' << p.y;
    ++seen[static_cast<std::size_t>(expected)];
  }
  for (const int count : seen) EXPECT_GT(count, 500);
}

TEST(Bsp, HolesCavitiesAndTurnedSolidsAreExact) {
  const Solid bored = shapes::subtract({box_solid({-3, -3, -3}, {3, 3, 3}), box_solid({-1, -1, -4}, {1, 1, 4})});
  const Solid hollow =
      shapes::subtract({box_solid({-3, -3, -3}, {3, 3, 3}), shapes::solid(shapes::sphere({0, 0, 0}, 2, 8, 12))});
  const Solid gear = shapes::solid(shapes::rotated(shapes::prism(shapes::gear(7, 2, 3), -2, 2), {1, 2, 3}, 0.7));
  const Solid twins = shapes::unite({box_solid({-3, -3, -3}, {0, 0, 0}), box_solid({0, 0, 0}, {3, 3, 3})});
  for (const Solid& solid : {bored, hollow, gear, twins}) {
    const Bsp tree = Bsp::of(solid).value();
    EXPECT_EQ(differences(tree, solid, 2000, -4, 4), 0U);
    EXPECT_NEAR(tree.inner_volume(), volume(solid), 1e-11);
  }
}

TEST(Bsp, UnionIntersectionAndDifferenceAreThoseOfTheSolids) {
  const Solid a = shapes::solid(shapes::prism(ell, 0.0, 3.0));
  const Solid b = shapes::solid(shapes::rotated(shapes::prism(shapes::gear(5, 2, 3), -1, 2), {1, 1, 0}, 0.4));
  const Bsp of_a = Bsp::of(a).value();
  const Bsp of_b = Bsp::of(b).value();
  const auto check = [&](SetOperation operation, const Solid& expected, const Bsp& first, const Bsp& second) {
    const Bsp tree = combine(first, second, operation);
    EXPECT_EQ(differences(tree, expected, 1000, -4, 7), 0U);
    EXPECT_NEAR(tree.inner_volume(), volume(expected), 1e-11);
  };
  check(SetOperation::Union, shapes::unite({a, b}), of_a, of_b);
  check(SetOperation::Intersection, shapes::common({a, b}), of_a, of_b);
  check(SetOperation::Difference, shapes::subtract({a, b}), of_a, of_b);
  check(SetOperation::Difference, shapes::subtract({b, a}), of_b, of_a);
  const Bsp nothing = Bsp::of(Solid()).value();
  EXPECT_NEAR(combine(nothing, of_b, SetOperation::Union).inner_volume(), volume(b), 1e-11);
  EXPECT_EQ(combine(nothing, of_b, SetOperation::Intersection).inner_volume(), 0.0);
  EXPECT_EQ(combine(of_a, of_a, SetOperation::Difference).inner_volume(), 0.0);
}

TEST(Bsp, TreesOfConvexSolidsAreShallow) {
  // Faces' planes alone would stand one below the other.
  const auto depth = [](std::uint32_t rows) {
    return Bsp::of(shapes::solid(shapes::sphere({0, 0, 0}, 1, rows, 2 * rows))).value().depth();
  };
  const std::size_t coarse = depth(8);
  const std::size_t fine = depth(32);  // sixteen times as many faces
  EXPECT_LE(fine, coarse + 24);
  EXPECT_LE(fine, 60U);
}

}  // namespace
}  // namespace dobra::solid::partition
