#include "recon/maps/ruled_map.h"

#include <gtest/gtest.h>

#include <random>

#include "recon/maps/section_map.h"

namespace recon::maps {
namespace {

struct Shape {
  std::size_t lines = 4;
  std::size_t points = 60;
  double roughness = 0.0;  ///< Of every point, m. Lines are 20 m apart.
  double lean = 0.0;       ///< How unevenly the places are spread over a line; differs between lines.
};

/// A stack of lines over 1000 m and an image with beds of other forms.
std::vector<RuledLine> stack(const Shape& shape, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::vector<RuledLine> lines;
  for (std::size_t k = 0; k < shape.lines; ++k) {
    RuledLine line;
    const double lean = shape.lean * unit(random);
    for (std::size_t i = 0; i < shape.points; ++i) {
      const bool end = i == 0 || i + 1 == shape.points;
      const double t =
          (static_cast<double>(i) + (end ? 0.0 : 0.4 * unit(random))) / static_cast<double>(shape.points - 1);
      const double x = 1000.0 * (t + lean * t * (1.0 - t));
      const double depth = 20.0 * static_cast<double>(k);
      line.u.push_back(2.0 * t - 1.0);
      line.from.push_back(
          {x + shape.roughness * unit(random), 40.0 * std::sin(x / 150.0) - depth + shape.roughness * unit(random)});
      line.to.push_back({1100.0 * t + 0.1 * depth, 5.0 * std::sin(x / 90.0) - 1.1 * depth});
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

std::vector<geom::Point> points_in(const std::vector<RuledLine>& lines, double margin, std::size_t count,
                                   unsigned seed) {
  std::mt19937 random(seed);
  geom::Box box;
  for (const RuledLine& line : lines) box.add(geom::box_of(line.from));
  box = box.grown(margin);
  std::uniform_real_distribution<double> x(box.low.x, box.high.x);
  std::uniform_real_distribution<double> y(box.low.y, box.high.y);
  std::vector<geom::Point> points;
  for (std::size_t i = 0; i < count; ++i) points.push_back({x(random), y(random)});
  // The corners of the lines and places between them too: they lie on the sides of strips.
  for (const RuledLine& line : lines) {
    for (std::size_t i = 0; i + 1 < line.from.size(); i += 3) {
      points.push_back(line.from[i]);
      points.push_back(geom::interpolate(line.from[i], line.from[i + 1], 0.37));
    }
  }
  return points;
}

/// The first strip of all that holds p, by looking at every one; beyond the lines there is none.
std::optional<Cell> first_holder(const RuledMap& map, std::size_t bands, geom::Point p) {
  for (std::uint32_t band = 0; band < bands; ++band) {
    for (std::uint32_t strip = 1; !map.is_outer({strip, band}, {}); ++strip) {
      const auto at = map.enter({strip, band});
      bool beyond = false;
      for (std::size_t side = 0; side < RuledMap::sides; ++side)
        beyond = beyond || map.beyond(at, side, p) > map.tolerances().side;
      if (beyond) continue;
      // Above the first line and below the last one, `beyond` knows no limit.
      const double down = map.carry(at, p).name.depth - band;
      if (down >= -1e-9 && down <= 1.0 + 1e-9) return Cell{strip, band};
    }
  }
  return std::nullopt;
}

TEST(RuledMap, TheStripOfAPointIsTheFirstThatHoldsItWhereverTheSearchBegins) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const std::vector<RuledLine> lines = stack({.lean = 0.2}, seed);
    const RuledMap map(lines);
    ASSERT_FALSE(map.folded());
    std::mt19937 random(seed);
    std::uniform_int_distribution<std::uint32_t> strip(1, 100);
    std::uniform_int_distribution<std::uint32_t> band(0, 2);
    for (const geom::Point p : points_in(lines, 0.0, 300, seed)) {
      const auto expected = first_holder(map, lines.size() - 1, p);
      const Spot alone = map.locate(p, {});
      if (expected) {
        EXPECT_EQ(alone.cell, *expected) << p;
      }
      for (int i = 0; i < 4; ++i) EXPECT_EQ(map.locate(p, {strip(random), band(random)}).cell, alone.cell) << p;
    }
  }
}

TEST(RuledMap, WhereStripsAreFoldedOverTheHintDoesNotMatterEither) {
  std::size_t folded = 0;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    const std::vector<RuledLine> lines = stack({.points = 150, .roughness = 3.0, .lean = 0.3}, seed);
    const RuledMap map(lines);
    folded += map.folded() ? 1 : 0;
    std::mt19937 random(seed);
    std::uniform_int_distribution<std::uint32_t> strip(1, 280);
    std::uniform_int_distribution<std::uint32_t> band(0, 2);
    for (const geom::Point p : points_in(lines, 60.0, 400, seed)) {
      const Spot alone = map.locate(p, {});
      const geom::Point image = map.carry(map.enter(alone.cell), p).image;
      for (int i = 0; i < 4; ++i) {
        RuledMap::Hint hint = map.hint({strip(random), band(random)});
        EXPECT_EQ(map.map(p, hint), image) << p << " seed " << seed;
      }
    }
  }
  EXPECT_GT(folded, 8u);
}

TEST(RuledMap, CornersGoToTheirImagesAndAllComeBack) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const std::vector<RuledLine> lines = stack({.lines = 5, .lean = 0.1}, seed);
    const RuledMap map(lines);
    const RuledMap back = map.swapped();
    RuledMap::Hint hint;
    for (const RuledLine& line : lines) {
      for (std::size_t i = 0; i < line.from.size(); ++i)
        EXPECT_LT(geom::distance(map.map(line.from[i], hint), line.to[i]), 1e-9);
    }
    ASSERT_FALSE(map.folded());
    ASSERT_FALSE(back.folded());
    for (const geom::Point p : points_in(lines, 0.0, 500, seed)) {
      if (!first_holder(map, lines.size() - 1, p)) continue;
      RuledMap::Hint there;
      const geom::Point image = map.map(p, hint);
      EXPECT_LT(geom::distance(back.map(image, there), p), 1e-9) << p;
      EXPECT_LT(geom::distance(map.back(image, there), p), 1e-9) << p;
    }
  }
}

TEST(RuledMap, OutsideTheStackRulingsGoOnAndTheEndsAreMovedAlong) {
  // A parallelogram of two lines to a rectangle twice as high.
  const RuledMap map({{{0, 1}, {{0, 0}, {10, 0}}, {{0, 0}, {10, 0}}},
                      {{0, 0.5, 1}, {{1, -2}, {6, -2}, {11, -2}}, {{0, -4}, {5, -4}, {10, -4}}},
                      {{0, 1}, {{2, -4}, {12, -4}}, {{0, -8}, {10, -8}}}});
  for (const geom::Point p : {geom::Point{4, 3}, {-7, 1}, {30, -1}, {5, -9}, {40, -3}, {-20, -3.5}, {4, -3}}) {
    const geom::Point expected{p.x + 0.5 * p.y, 2.0 * p.y};
    EXPECT_LT(geom::distance(SectionMap(map).forward(p).at, expected), 1e-9) << p;
  }
  EXPECT_TRUE(map.is_outer(map.locate({-7, -3}, {}).cell, {}));
  EXPECT_TRUE(map.is_outer(map.locate({30, -1}, {}).cell, {}));
}

TEST(RuledMap, BedsThatMeetArePassedOver) {
  // The second line joins the first from x = 5 on: a band without thickness there.
  const std::vector<RuledLine> lines = {
      {{0, 0.5, 1}, {{0, 0}, {5, 0}, {10, 0}}, {{0, 0}, {5, 0}, {10, 0}}},
      {{0, 0.5, 1}, {{0, -2}, {5, 0}, {10, 0}}, {{0, -2}, {5, 0}, {10, 0}}},
      {{0, 0.5, 1}, {{0, -4}, {5, -4}, {10, -4}}, {{0, -4}, {5, -5}, {10, -4}}},
  };
  const RuledMap map(lines);
  EXPECT_FALSE(map.folded());
  for (const Cell hint : {Cell{}, Cell{1, 0}, Cell{2, 0}, Cell{1, 1}, Cell{2, 1}}) {
    for (const double x : {0.5, 4.999, 5.0, 5.001, 7.5, 9.9}) {
      RuledMap::Hint near = map.hint(hint);
      EXPECT_LT(geom::distance(map.map({x, 0.0}, near), {x, 0.0}), 1e-9) << x;
    }
    RuledMap::Hint near = map.hint(hint);
    EXPECT_LT(geom::distance(map.map({7.5, -2}, near), {7.5, -2.25}), 1e-9);
  }
}

TEST(RuledMap, ABatchGivesTheImagesOfItsPointsAlone) {
  const std::vector<RuledLine> lines = stack({.points = 200, .roughness = 2.0, .lean = 0.3}, 4);
  const SectionMap map{RuledMap(lines)};
  const std::vector<geom::Point> points = points_in(lines, 100.0, 5000, 8);
  std::vector<geom::Point> images(points.size());
  ASSERT_TRUE(map.forward(points, images));
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(images[i], map.forward(points[i]).at);
}

}  // namespace
}  // namespace recon::maps
