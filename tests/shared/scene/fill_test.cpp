#include "shared/scene/fill.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "tests/support/example_picture.h"

namespace dobra::scene {
namespace {

geom::Polyline contour(std::vector<geom::Point> points) { return {std::move(points), true}; }

double area(const std::vector<geom::Point>& corners) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    const double twice = geom::cross(corners[i + 1] - corners[i], corners[i + 2] - corners[i]);
    EXPECT_GE(twice, 0.0) << "triangle " << i / 3 << " is clockwise";
    sum += 0.5 * twice;
  }
  return sum;
}

double area(const std::vector<ColoredArea>& areas) {
  double sum = 0.0;
  for (const ColoredArea& colored : areas) {
    for (const std::vector<geom::Point>& loop : colored.loops) sum += geom::signed_area(contour(loop));
  }
  return sum;
}

double area(const Mesh& mesh) {
  double sum = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum += 0.5 * std::abs(geom::cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]));
  }
  return sum;
}

const geom::Box everything{{-1e9, -1e9}, {1e9, 1e9}};

TEST(Fill, TrianglesOfARegionHaveItsArea) {
  const auto outer = contour({{0.0, 0.0}, {10.0, 1.0}, {9.0, 8.0}, {4.0, 3.0}, {1.0, 9.0}});
  EXPECT_NEAR(area(triangles_of({{outer}})), std::abs(geom::signed_area(outer)), 1e-12);
}

TEST(Fill, AHoleIsLeftOutWhicheverWayItTurns) {
  const auto outer = contour({{0.0, 0.0}, {10.0, 0.0}, {10.0, 10.0}, {0.0, 10.0}});
  const auto hole = contour({{2.0, 2.0}, {5.0, 3.0}, {3.0, 7.0}});
  const double expected = 100.0 - std::abs(geom::signed_area(hole));
  EXPECT_NEAR(area(triangles_of({{outer, hole}})), expected, 1e-12);
  EXPECT_NEAR(area(triangles_of({{geom::reversed(hole), outer}})), expected, 1e-12);
}

TEST(Fill, ABowTieIsFilledOnBothSidesOfItsCrossing) {
  EXPECT_NEAR(area(triangles_of({{contour({{0.0, 0.0}, {2.0, 2.0}, {2.0, 0.0}, {0.0, 2.0}})}})), 2.0, 1e-12);
}

TEST(Fill, ThePentagramIsEmptyInTheMiddle) {
  std::vector<geom::Point> star;
  for (int i = 0; i < 5; ++i) {
    const double angle = 0.5 * std::numbers::pi + 2.0 * std::numbers::pi * (2 * i % 5) / 5.0;
    star.push_back({std::cos(angle), std::sin(angle)});
  }
  // Five tips of a star of radius 1: half base and height of each follow from the inner radius.
  const double inner = std::cos(0.4 * std::numbers::pi) / std::cos(0.2 * std::numbers::pi);
  const double half = inner * std::sin(0.2 * std::numbers::pi);
  const double tips = 5.0 * half * (1.0 - inner * std::cos(0.2 * std::numbers::pi));
  EXPECT_NEAR(area(triangles_of({{contour(star)}})), tips, 1e-12);
}

/// The top of a bed that ripples, and its base, as one contour.
Region rippled_bed(int points, double wavelength) {
  geom::Polyline bed{{}, true};
  for (int i = 0; i < points; ++i) bed.points.push_back({1.0 * i, std::sin(i / wavelength)});
  for (int i = points; i-- > 0;) bed.points.push_back({1.0 * i, -5.0 + std::sin(0.9 * i / wavelength)});
  return {{bed}};
}

TEST(Fill, ARippledBedTakesTrianglesByItsPointsWhicheverWayItLies) {
  Region bed = rippled_bed(5000, 7.3);
  for (const bool upright : {false, true}) {
    if (upright) {
      for (geom::Point& p : bed.contours[0].points) std::swap(p.x, p.y);
    }
    const std::vector<geom::Point> corners = triangles_of(bed);
    EXPECT_LE(corners.size() / 3, 2 * bed.contours[0].points.size());
    EXPECT_NEAR(area(corners), std::abs(geom::signed_area(bed.contours[0])), 1e-8);
  }
}

TEST(Fill, ACombWhoseTeethAreAllOpenAtOnceTakesTrianglesByItsPoints) {
  geom::Polyline comb{{{0.0, -1000.0}}, true};
  for (int i = 0; i < 2000; ++i) {
    comb.points.push_back({1.0 * i, 0.5 * (i % 7)});
    comb.points.push_back({i + 0.5, 900.0 + i % 11});
  }
  comb.points.push_back({2000.0, -1000.0});
  const std::vector<geom::Point> corners = triangles_of({{comb}});
  EXPECT_LE(corners.size() / 3, 2 * comb.points.size());
  EXPECT_NEAR(area(corners), std::abs(geom::signed_area(comb)), 1e-6);
}

bool is_in(geom::Point p, const std::vector<geom::Point>& corners, std::size_t triangle) {
  for (std::size_t k = 0; k < 3; ++k) {
    const geom::Point a = corners[3 * triangle + k];
    if (geom::cross(corners[3 * triangle + (k + 1) % 3] - a, p - a) < 0.0) return false;
  }
  return true;
}

/// Even-odd by counting the edges on the right of a point.
bool is_in(geom::Point p, const Region& region) {
  bool inside = false;
  for (const geom::Polyline& line : region.contours) {
    for (std::size_t i = 0, j = line.points.size() - 1; i < line.points.size(); j = i++) {
      const auto [a, b] = std::pair(line.points[i], line.points[j]);
      if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    }
  }
  return inside;
}

/// Each place is in one triangle if it is inside, and in none if not.
void expect_even_odd(const Region& region, const geom::Box& box, int seed) {
  const std::vector<geom::Point> corners = triangles_of(region);
  std::mt19937 random(static_cast<unsigned>(seed));
  std::uniform_real_distribution<double> x(box.low.x - 0.1, box.high.x + 0.1);
  std::uniform_real_distribution<double> y(box.low.y - 0.1, box.high.y + 0.1);
  for (int i = 0; i < 200; ++i) {
    const geom::Point p{x(random), y(random)};
    int covers = 0;
    for (std::size_t t = 0; t < corners.size() / 3; ++t) covers += is_in(p, corners, t);
    ASSERT_EQ(covers, is_in(p, region) ? 1 : 0) << p << " of case " << seed;
  }
}

TEST(Fill, TangledContoursAreFilledByTheEvenOddRule) {
  for (int seed = 0; seed < 40; ++seed) {
    std::mt19937 random(static_cast<unsigned>(seed));
    std::uniform_real_distribution<double> anywhere(0.0, 1.0);
    Region region;
    for (int c = 0; c < 1 + seed % 3; ++c) {
      geom::Polyline line{{}, true};
      for (int i = 0; i < 3 + seed; ++i) line.points.push_back({(1 + seed % 2) * anywhere(random), anywhere(random)});
      region.contours.push_back(line);
    }
    expect_even_odd(region, {{0.0, 0.0}, {2.0, 1.0}}, seed);
  }
}

/// Corners on a coarse grid lie on each other's edges, edges lie in each other, many are level.
TEST(Fill, ContoursThatTouchAndOverlapAreFilledByTheEvenOddRule) {
  for (int seed = 0; seed < 60; ++seed) {
    std::mt19937 random(static_cast<unsigned>(seed));
    Region region;
    for (int c = 0; c < 1 + seed % 3; ++c) {
      geom::Polyline line{{}, true};
      for (int i = 0; i < 4 + seed / 2; ++i) {
        const double x = static_cast<double>(random() % 6);
        line.points.push_back({x, static_cast<double>(random() % 5)});
      }
      region.contours.push_back(line);
    }
    expect_even_odd(region, {{0.0, 0.0}, {5.0, 4.0}}, seed);
  }
}

TEST(Fill, NothingComesOfDegenerateContours) {
  EXPECT_TRUE(triangles_of({}).empty());
  EXPECT_TRUE(triangles_of({{contour({})}}).empty());
  EXPECT_TRUE(triangles_of({{contour({{1.0, 1.0}, {2.0, 1.0}})}}).empty());
}

TEST(Fill, AreasOfAMeshHaveItsAreaWhateverItsValues) {
  const Mesh flat = test::plate_mesh(12, ValuesAt::None);
  const double expected = area(flat);
  EXPECT_NEAR(area(areas_of(flat, Color{1, 2, 3}, everything)), expected, 1e-9);
  EXPECT_NEAR(area(areas_of(test::plate_mesh(12, ValuesAt::Triangles), {}, everything)), expected, 1e-9);
  EXPECT_NEAR(area(areas_of(test::plate_mesh(12, ValuesAt::Points), {}, everything)), expected, 1e-9);
}

TEST(Fill, TrianglesOfOneColourJoinIntoOneLoop) {
  const std::vector<ColoredArea> areas = areas_of(test::plate_mesh(12, ValuesAt::None), Color{1, 2, 3}, everything);
  ASSERT_EQ(areas.size(), 1U);
  ASSERT_EQ(areas[0].loops.size(), 1U);
  EXPECT_EQ(areas[0].loops[0].size(), 48U);
}

TEST(Fill, BandsEndWhereTheValueDoes) {
  Mesh mesh;
  mesh.points = {{0.0, 0.0}, {4.0, 0.0}, {0.0, 1.0}};
  mesh.triangles = {{0, 1, 2}};
  mesh.values_at = ValuesAt::Points;
  mesh.values = {0.0, 1.0, 0.0};
  const std::vector<ColoredArea> areas = areas_of(mesh, {}, everything, 4);
  ASSERT_EQ(areas.size(), 4U);
  for (std::size_t k = 0; k < 4; ++k) {
    for (const geom::Point& p : areas[k].loops.at(0)) {
      EXPECT_GE(p.x, static_cast<double>(k) - 1e-12);
      EXPECT_LE(p.x, static_cast<double>(k) + 1.0 + 1e-12);
    }
  }
}

TEST(Fill, ValuesBeyondTheScaleTakeTheEndColourUpToWhereTheyBegin) {
  Mesh mesh;
  mesh.points = {{0.0, 0.0}, {4.0, 0.0}, {0.0, 1.0}};
  mesh.triangles = {{0, 1, 2}};
  mesh.values_at = ValuesAt::Points;
  mesh.values = {-1.0, 3.0, -1.0};
  const std::vector<ColoredArea> areas = areas_of(mesh, {}, everything, 2);
  ASSERT_EQ(areas.size(), 2U);
  geom::Box low = geom::box_of(areas[0].loops.at(0));
  EXPECT_NEAR(low.high.x, 1.5, 1e-12);  // value 0.5, the middle of the scale
  EXPECT_NEAR(area(areas), 2.0, 1e-12);
}

TEST(Fill, ChainsHoldEveryEdgeOnce) {
  const Mesh mesh = test::plate_mesh(9, ValuesAt::None);
  std::set<std::pair<std::uint32_t, std::uint32_t>> wanted;
  for (const auto& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) wanted.insert(std::minmax(t[k], t[(k + 1) % 3]));
  }
  std::multiset<std::pair<std::uint32_t, std::uint32_t>> found;
  const auto chains = edge_chains(mesh);
  for (const auto& chain : chains) {
    for (std::size_t i = 1; i < chain.size(); ++i) found.insert(std::minmax(chain[i - 1], chain[i]));
  }
  EXPECT_EQ(found.size(), wanted.size());
  EXPECT_TRUE(std::equal(wanted.begin(), wanted.end(), found.begin(), found.end()));
  EXPECT_LT(chains.size(), wanted.size() / 4);
}

TEST(Fill, EdgesOfTinyTrianglesAreThinnedAndThenLeftOut) {
  Style style;
  style.line_width = 0.5;
  EXPECT_DOUBLE_EQ(edge_width(1.0, style, 20.0), 0.5);
  EXPECT_LT(edge_width(1.0, style, 2.0), 0.5);
  EXPECT_GT(edge_width(1.0, style, 2.0), 0.0);
  EXPECT_EQ(edge_width(1.0, style, 0.1), 0.0);
}

}  // namespace
}  // namespace dobra::scene
