#include "shared/scene/pattern.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace dobra::scene {
namespace {

using geom::Point;

double total(const std::vector<geom::Segment>& strokes) {
  double length = 0.0;
  for (const geom::Segment& stroke : strokes) length += stroke.length();
  return length;
}

TEST(Pattern, SignsStandOnThePageWhateverBoxIsAsked) {
  for (const Pattern pattern : {Pattern::Dots, Pattern::Bricks, Pattern::Hatch, Pattern::Circles}) {
    const geom::Box box{{10.0, 10.0}, {60.0, 50.0}};
    const geom::Polyline border{{box.low, {60.0, 10.0}, box.high, {10.0, 50.0}}, true};
    const double near = total(parts_inside(pattern_strokes(pattern, box), {border}));
    const double far = total(parts_inside(pattern_strokes(pattern, box.grown(31.0)), {border}));
    EXPECT_GT(near, 20.0);
    EXPECT_NEAR(near, far, 1e-9 * far) << static_cast<int>(pattern);
  }
  EXPECT_TRUE(pattern_strokes(Pattern::None, {{0.0, 0.0}, {9.0, 9.0}}).empty());
  EXPECT_TRUE(pattern_strokes(Pattern::Dots, {}).empty());
}

/// Length inside a ring by sampling each stroke densely; knows nothing of bands and crossings.
double sampled(const std::vector<geom::Segment>& strokes, Point middle, double inner, double outer) {
  constexpr int samples = 2000;
  double length = 0.0;
  for (const geom::Segment& stroke : strokes) {
    int in = 0;
    for (int i = 0; i < samples; ++i) {
      const double d = distance(geom::interpolate(stroke.from, stroke.to, (i + 0.5) / samples), middle);
      in += d > inner && d < outer ? 1 : 0;
    }
    length += stroke.length() * in / samples;
  }
  return length;
}

geom::Polyline circle(Point middle, double radius) {
  geom::Polyline line{{}, true};
  for (int i = 0; i < 720; ++i) {
    const double angle = 3.14159265358979 * i / 360.0;
    line.points.push_back({middle.x + radius * std::cos(angle), middle.y + radius * std::sin(angle)});
  }
  return line;
}

TEST(Pattern, PartsInsideARingAreThoseInsideItsCircles) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-60.0, 60.0);
  std::vector<geom::Segment> strokes;
  for (int i = 0; i < 60; ++i) strokes.push_back({{place(random), place(random)}, {place(random), place(random)}});
  const Point middle{3.0, -2.0};
  const auto parts = parts_inside(strokes, {circle(middle, 40.0), circle(middle, 15.0)});
  const double expected = sampled(strokes, middle, 15.0, 40.0);
  EXPECT_NEAR(total(parts), expected, 2e-3 * expected);
  for (const geom::Segment& part : parts) {
    const double d = distance(geom::interpolate(part.from, part.to, 0.5), middle);
    EXPECT_GT(d, 14.9);
    EXPECT_LT(d, 40.1);
  }
}

TEST(Pattern, StrokesEndAtLevelEdges) {
  const geom::Polyline box{{{0.0, 10.0}, {30.0, 10.0}, {30.0, 26.0}, {0.0, 26.0}}, true};
  const std::vector<geom::Segment> strokes{
      {{5.0, 0.0}, {5.0, 40.0}}, {{8.0, 9.0}, {10.0, 11.0}}, {{1.0, 5.0}, {2.0, 5.0}}};
  const auto parts = parts_inside(strokes, {box});
  EXPECT_NEAR(total(parts), 16.0 + std::sqrt(2.0), 1e-12);
  for (const geom::Segment& part : parts) {
    EXPECT_GE(std::min(part.from.y, part.to.y), 10.0);
    EXPECT_LE(std::max(part.from.y, part.to.y), 26.0);
  }
}

TEST(Pattern, NothingIsInsideALineOrNoContour) {
  const auto strokes = pattern_strokes(Pattern::CrossHatch, {{0.0, 0.0}, {50.0, 50.0}});
  EXPECT_TRUE(parts_inside(strokes, {}).empty());
  EXPECT_TRUE(parts_inside(strokes, {{{{0.0, 25.0}, {50.0, 25.0}}, true}}).empty());
}

}  // namespace
}  // namespace dobra::scene
