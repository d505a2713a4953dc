// Areas by distance against closed forms, and against membership of points that is decided by plain distances: a place
// lies in the area of a line if it lies in the rectangle of a segment, in what fills a corner, or in a cap.

#include "shared/offset/area.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace dobra::offset {
namespace {

using geom::Point;
using geom::Polyline;
using geom::Vector;

using std::numbers::pi;

Polyline open(std::vector<Point> points) { return {std::move(points), false}; }
Polyline ring(std::vector<Point> points) { return {std::move(points), true}; }
Polyline box(double x, double y, double width, double height) {
  return ring({{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}});
}
std::vector<Polyline> holed() { return {box(0, 0, 10, 10), geom::reversed(box(3, 3, 4, 4))}; }

AreaOptions with(Join join, Cap cap = Cap::Round) { return {.join = join, .cap = cap, .arc_tolerance = 1e-4}; }

Area line_area(const Polyline& line, double distance, const AreaOptions& options) {
  auto made = around_line(line, {{distance}}, options);
  EXPECT_TRUE(made.ok()) << (made.ok() ? "" : base::to_string(made.error()));
  return made.ok() ? made->front() : Area{};
}
Area polygon_area(const std::vector<Polyline>& polygon, double distance, const AreaOptions& options) {
  auto made = grown(polygon, {{distance}}, options);
  EXPECT_TRUE(made.ok()) << (made.ok() ? "" : base::to_string(made.error()));
  return made.ok() ? made->front() : Area{};
}

bool holds(const std::vector<Polyline>& rings, Point p) {
  int crossings = 0;
  for (const Polyline& r : rings) crossings += geom::locate(r, p) == geom::Side::Inside ? 1 : 0;
  return crossings % 2 != 0;
}

/// Contours anticlockwise, each followed by clockwise holes that lie in it; what they enclose is `area`.
void expect_sound(const Area& made, double tolerance = 1e-9) {
  double enclosed = 0;
  std::size_t contour = made.rings.size();
  for (std::size_t i = 0; i < made.rings.size(); ++i) {
    const double area = geom::signed_area(made.rings[i]);
    enclosed += area;
    if (area > 0) {
      contour = i;
      continue;
    }
    ASSERT_LT(contour, made.rings.size());
    for (const Point p : made.rings[i].points) EXPECT_NE(geom::locate(made.rings[contour], p), geom::Side::Outside);
  }
  EXPECT_NEAR(enclosed, made.area, tolerance * std::abs(made.area));
}

// --- closed forms

TEST(Area, OneSegmentHasTheAreaOfItsRectangleAndItsCaps) {
  const Polyline line = open({{1, 2}, {7, 10}});  // 10 long
  EXPECT_NEAR(line_area(line, 2, with(Join::Round)).area, 40 + 4 * pi, 1e-9);
  EXPECT_NEAR(line_area(line, 2, with(Join::Round)).length, 20 + 4 * pi, 1e-9);
  for (const Join join : {Join::Round, Join::Mitre, Join::Bisector, Join::Bevel}) {
    EXPECT_NEAR(line_area(line, 2, with(join, Cap::Flat)).area, 40, 1e-9);
    EXPECT_NEAR(line_area(line, 2, with(join, Cap::Square)).area, 56, 1e-9);
    EXPECT_NEAR(line_area(line, 2, with(join)).area, 40 + 4 * pi, 4e-3);
  }
}

TEST(Area, ARightCornerIsFilledAsTheJoinSays) {
  const Polyline line = open({{0, 0}, {10, 0}, {10, 10}});
  const double rectangles = 2 * 20.0 - 1;  // they share a square of side 1 within the corner
  EXPECT_NEAR(line_area(line, 1, with(Join::Mitre, Cap::Flat)).area, rectangles + 1, 1e-9);
  EXPECT_NEAR(line_area(line, 1, with(Join::Mitre, Cap::Square)).area, rectangles + 1 + 4, 1e-9);
  EXPECT_NEAR(line_area(line, 1, with(Join::Bevel, Cap::Flat)).area, rectangles + 0.5, 1e-9);
  EXPECT_NEAR(line_area(line, 1, with(Join::Round, Cap::Flat)).area, rectangles + pi / 4, 1e-3);
  EXPECT_NEAR(line_area(line, 1, with(Join::Round, Cap::Round)).area, rectangles + pi / 4 + pi, 1e-9);
}

TEST(Area, ALongLineHasTheSameAreaInPartsAndAsAWhole) {
  // Its ends are taken by themselves, its middle by the engine.
  std::vector<Point> points;
  for (int i = 0; i <= 120; ++i) points.push_back({0.5 * i, 3 * std::sin(0.2 * i)});
  const Polyline line = open(points);
  const double round = line_area(line, 1, with(Join::Round)).area;
  EXPECT_NEAR(line_area(line, 1, with(Join::Round, Cap::Flat)).area, round - pi, 2e-3);
  EXPECT_NEAR(line_area(line, 1, with(Join::Round, Cap::Square)).area, round - pi + 4, 2e-3);
  EXPECT_NEAR(line_area(line, 1, with(Join::Mitre, Cap::Flat)).area + 4,
              line_area(line, 1, with(Join::Mitre, Cap::Square)).area, 1e-9);
  EXPECT_NEAR(line_area(line, 1, with(Join::Mitre, Cap::Round)).area - pi,
              line_area(line, 1, with(Join::Mitre, Cap::Flat)).area, 2e-3);
}

TEST(Area, OFF_c_APolygonWithAHoleGrowsOutsideAndIntoItsHole) {
  const Area mitred = polygon_area(holed(), 1, with(Join::Mitre));
  EXPECT_EQ(mitred.rings.size(), 2U);
  EXPECT_NEAR(mitred.area, 144 - 4, 1e-12);
  EXPECT_NEAR(mitred.length, 48 + 8, 1e-12);
  EXPECT_NEAR(polygon_area(holed(), 1, with(Join::Round)).area, 140 + pi - 4, 1e-12);
  // At 2 and beyond the hole is gone.
  for (const double d : {2.0, 3.0}) {
    const Area filled = polygon_area(holed(), d, with(Join::Mitre));
    EXPECT_EQ(filled.rings.size(), 1U);
    EXPECT_NEAR(filled.area, (10 + 2 * d) * (10 + 2 * d), 1e-9);
  }
}

TEST(Area, OFF_c_APolygonWithAHoleShrinksFromBothUntilNothingIsLeft) {
  EXPECT_NEAR(polygon_area(holed(), -1, with(Join::Mitre)).area, 64 - 36, 1e-12);
  EXPECT_EQ(polygon_area(holed(), -1, with(Join::Mitre)).rings.size(), 2U);
  EXPECT_NEAR(polygon_area(holed(), -1, with(Join::Round)).area, 64 - 32 - pi, 1e-12);
  // A hole off the middle: beyond half of the narrow side the ring is cut open there.
  const std::vector<Polyline> off{box(0, 0, 10, 10), geom::reversed(box(1, 4, 2, 2))};
  const Area cut = polygon_area(off, -0.75, with(Join::Mitre));
  EXPECT_EQ(cut.rings.size(), 1U);
  EXPECT_NEAR(cut.area, 8.5 * 8.5 - 3.5 * (3.75 - 0.75), 1e-9);
  EXPECT_TRUE(polygon_area(holed(), -2, with(Join::Mitre)).rings.empty());
  EXPECT_EQ(polygon_area(holed(), -2, with(Join::Mitre)).area, 0.0);
}

TEST(Area, ABandRunsOnBothSidesOfEveryRing) {
  const auto band = around_polygon(holed(), {{0.5}}, with(Join::Mitre));
  ASSERT_TRUE(band.ok());
  EXPECT_NEAR(band->front().area, (121 - 81) + (25 - 9), 1e-9);
  expect_sound(band->front());
  EXPECT_EQ(polygons_of(band->front().rings).size(), 2U);
  const auto whole = around_polygon(holed(), {{1.5}}, with(Join::Mitre));
  ASSERT_TRUE(whole.ok());
  EXPECT_NEAR(whole->front().area, 169 - 1, 1e-9);  // the two bands meet
}

TEST(Area, WhatOverlapsIsJoinedAndWhatDoesNotStays) {
  const auto joined_area = [](std::vector<Area> areas) {
    const auto made = joined(areas);
    EXPECT_TRUE(made.ok());
    return made.ok() ? *made : Area{};
  };
  const auto area_of = [](const Polyline& r) { return Area{{r}, geom::signed_area(r), geom::length(r)}; };
  const Area two = joined_area({area_of(box(0, 0, 2, 2)), area_of(box(1, 1, 2, 2))});
  EXPECT_EQ(two.rings.size(), 1U);
  EXPECT_NEAR(two.area, 7, 1e-12);
  const Area apart = joined_area({area_of(box(0, 0, 2, 2)), area_of(box(5, 0, 2, 2))});
  EXPECT_EQ(apart.rings.size(), 2U);
  EXPECT_NEAR(apart.area, 8, 1e-12);
  const Area walls = joined_area({area_of(box(0, 0, 2, 2)), area_of(box(2, 0, 2, 2)), area_of(box(0, 2, 4, 1)),
                                  area_of(box(0, 3, 1, 3)), area_of(box(3, 3, 1, 3)), area_of(box(0, 6, 4, 1))});
  EXPECT_EQ(walls.rings.size(), 2U);  // a frame round a hole
  EXPECT_NEAR(walls.area, 8 + 4 + 6 + 4, 1e-12);
  expect_sound(walls);
  // An island in a hole.
  Area frame{{box(0, 0, 10, 10), geom::reversed(box(1, 1, 8, 8))}, 36, 72};
  const Area island = joined_area({frame, area_of(box(4, 4, 2, 2))});
  EXPECT_EQ(island.rings.size(), 3U);
  EXPECT_NEAR(island.area, 40, 1e-12);
  expect_sound(island);
}

TEST(Area, APolygonThatCrossesItselfIsMendedAndASoundOneIsNot) {
  const auto bow = mended(std::vector<Polyline>{ring({{0, 0}, {4, 4}, {4, 0}, {0, 4}})});
  ASSERT_TRUE(bow.ok());
  EXPECT_EQ(bow->size(), 2U);
  const auto same = mended(holed());
  ASSERT_TRUE(same.ok());
  ASSERT_EQ(same->size(), 1U);
  EXPECT_EQ(same->front(), holed());
  const auto beyond = mended(std::vector<Polyline>{box(0, 0, 4, 4), geom::reversed(box(3, 1, 2, 2))});
  ASSERT_TRUE(beyond.ok());  // the hole reaches out: what it has outside counts, as it is entered once
  double area = 0;
  for (const auto& polygon : *beyond) {
    for (const Polyline& r : polygon) area += geom::signed_area(r);
  }
  EXPECT_NEAR(area, 16 - 2 + 2, 1e-12);
}

TEST(Area, SizesBeyondTheStatedOnesAreRefused) {
  for (const Cap cap : {Cap::Round, Cap::Flat}) {
    EXPECT_FALSE(around_line(open({{0, 0}, {1e160, 0}}), {{1.0}}, with(Join::Round, cap)).ok());
    EXPECT_FALSE(around_line(open({{0, 0}, {1, 0}}), {{1e30}}, with(Join::Round, cap)).ok());
    EXPECT_FALSE(around_line(open({{0, 0}, {0, 0}}), {{1.0}}, with(Join::Round, cap)).ok());
  }
}

// --- random ones against plain distances

Vector unit(Vector v) { return (1 / geom::length(v)) * v; }

/// Whether p lies in the area round a line, its parts blown up by a little.
bool in_line_area(const Polyline& line, double d, const AreaOptions& options, Point p, double more) {
  const std::size_t n = line.points.size();
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const Vector u = unit(line.points[i + 1] - line.points[i]);
    const Vector w = p - line.points[i];
    const double along = geom::dot(w, u);
    const double before = i == 0 && options.cap == Cap::Square ? d : 0;
    const double after = i + 2 == n && options.cap == Cap::Square ? d : 0;
    if (std::abs(geom::cross(u, w)) <= d + more && along >= -before - more &&
        along <= geom::distance(line.points[i], line.points[i + 1]) + after + more) {
      return true;
    }
  }
  if (options.cap == Cap::Round) {
    for (const Point end : {line.points.front(), line.points.back()}) {
      if (geom::distance(end, p) <= d + more) return true;
    }
  }
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const Vector u = unit(line.points[i] - line.points[i - 1]);
    const Vector v = unit(line.points[i + 1] - line.points[i]);
    const Vector w = p - line.points[i];
    if (geom::dot(w, u) < -more || geom::dot(w, v) > more) continue;
    const double outer = geom::cross(u, v) > 0 ? -1 : 1;  // of the left normals
    const Vector first = outer * left_of(u);
    const Vector second = outer * left_of(v);
    const Vector middle = unit(first + second);
    if (geom::dot(w, middle) < -more) continue;
    const double cosine = geom::dot(first, middle);
    const double reach = geom::dot(w, middle);
    if (options.join == Join::Round && geom::length(w) <= d + more) return true;
    if (options.join == Join::Bevel && reach <= d * cosine + more) return true;
    if (options.join != Join::Mitre) continue;
    if (geom::dot(w, first) > d + more || geom::dot(w, second) > d + more) continue;
    if (cosine * options.mitre_limit >= 1 || reach <= d + more) return true;
  }
  return false;
}

TEST(AreaRandom, LinesWithEveryJoinAndCapHoldThePlacesThatTheyShould) {
  for (unsigned seed = 1; seed <= 24; ++seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> from(-1, 1);
    std::vector<Point> points{{0, 0}};
    const int n = 2 + static_cast<int>(random() % 14);
    for (int i = 0; i < n; ++i) points.push_back(points.back() + Vector{1 + 2 * from(random), 2 * from(random)});
    const Polyline line = open(points);
    const double d = 0.2 + 0.6 * std::abs(from(random));
    for (const Join join : {Join::Round, Join::Mitre, Join::Bevel}) {
      for (const Cap cap : {Cap::Round, Cap::Flat, Cap::Square}) {
        const AreaOptions options = with(join, cap);
        const Area made = line_area(line, d, options);
        expect_sound(made, 1e-3);
        const geom::Box range = line.box().grown(5 * d);
        int judged = 0;
        for (int k = 0; k < 150; ++k) {
          const Point p{range.low.x + range.width() * std::abs(from(random)),
                        range.low.y + range.height() * std::abs(from(random))};
          const bool in = in_line_area(line, d, options, p, -2e-3 * d);
          if (in != in_line_area(line, d, options, p, 2e-3 * d)) continue;  // too near to tell
          // Where an arc is cut the engine's bevel is the chord of what is left of it: between that of all of it and
          // the arc.
          if (join == Join::Bevel && !in && in_line_area(line, d, with(Join::Round, cap), p, 0)) continue;
          ++judged;
          ASSERT_EQ(holds(made.rings, p), in) << "seed " << seed << " join " << static_cast<int>(join) << " cap "
                                              << static_cast<int>(cap) << " at " << p.x << ' ' << p.y << " d " << d;
        }
        EXPECT_GT(judged, 120);
      }
    }
  }
}

std::vector<Polyline> random_holed(std::mt19937_64& random) {
  std::uniform_real_distribution<double> from(0, 1);
  const auto star = [&](Point centre, double least, double most, int n) {
    std::vector<Point> points;
    for (int i = 0; i < n; ++i) {
      const double r = least + (most - least) * from(random);
      points.push_back(centre + Vector{r * std::cos(2 * pi * i / n), r * std::sin(2 * pi * i / n)});
    }
    return ring(points);
  };
  std::vector<Polyline> polygon{star({0, 0}, 6, 10, 24)};
  for (const Point centre : {Point{-2.6, -1}, {2.4, 1.2}, {0, 4}}) {
    if (random() % 3 != 0) polygon.push_back(geom::reversed(star(centre, 0.4, 1.2, 9)));
  }
  return polygon;
}

TEST(AreaRandom, OFF_c_PolygonsWithHolesHoldWhatIsWithinOrFartherThanTheDistance) {
  for (unsigned seed = 1; seed <= 30; ++seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> from(-14, 14);
    const std::vector<Polyline> polygon = random_holed(random);
    const double d = 0.05 + 0.1 * static_cast<double>(seed % 20);
    for (const double signed_d : {d, -d}) {
      const Area made = polygon_area(polygon, signed_d, with(Join::Round));
      expect_sound(made, 1e-3);
      for (int k = 0; k < 200; ++k) {
        const Point p{from(random), from(random)};
        double least = 1e300;
        for (const Polyline& r : polygon) least = std::min(least, geom::distance(r, p));
        if (std::abs(least - d) < 2e-3 * d) continue;
        const bool in = holds(polygon, p);
        ASSERT_EQ(holds(made.rings, p), signed_d > 0 ? in || least < d : in && least > d)
            << "seed " << seed << " d " << signed_d << " at " << p.x << ' ' << p.y;
      }
    }
  }
}

TEST(AreaRandom, WhatSeveralAreasCoverTogetherIsInOneOfThem) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> from(-14, 14);
    std::vector<Area> areas{polygon_area(random_holed(random), 0.4, with(Join::Round))};
    for (int i = 0; i < 6; ++i) {
      const Polyline line =
          open({{from(random), from(random)}, {from(random), from(random)}, {from(random), from(random)}});
      areas.push_back(line_area(line, 0.6, with(Join::Round)));
    }
    const auto all = joined(areas);
    ASSERT_TRUE(all.ok());
    expect_sound(*all);
    for (int k = 0; k < 400; ++k) {
      const Point p{from(random), from(random)};
      const bool in = std::any_of(areas.begin(), areas.end(), [&](const Area& a) { return holds(a.rings, p); });
      ASSERT_EQ(holds(all->rings, p), in) << "seed " << seed << " at " << p.x << ' ' << p.y;
    }
  }
}

}  // namespace
}  // namespace dobra::offset
