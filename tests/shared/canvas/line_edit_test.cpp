#include "shared/canvas/line_edit.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dobra::canvas {
namespace {

using geom::Point;
using geom::Polyline;

const Polyline bed{{{0, 0}, {10, 0}, {20, 5}, {30, 5}}, false};
const Polyline ring{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, true};

TEST(LineEdit, VerticesComeAndGo) {
  EXPECT_EQ(with_vertex(bed, {0, {4, 0}}).points[1], (Point{4, 0}));
  EXPECT_EQ(with_vertex(ring, {3, {0, 5}}).points.back(), (Point{0, 5}));
  EXPECT_EQ(without_vertices(bed, {1, 2})->points, (std::vector<Point>{{0, 0}, {30, 5}}));
  EXPECT_FALSE(without_vertices(bed, {0, 1, 2}));
  EXPECT_FALSE(without_vertices(ring, {0, 1}));
}

TEST(LineEdit, ALineIsSplitOnceAndPutTogetherAgain) {
  const auto parts = split_at(bed, {1, {15, 2.5}});
  ASSERT_TRUE(parts);
  EXPECT_EQ(parts->first.points.back(), (Point{15, 2.5}));
  EXPECT_EQ(parts->second.points.front(), (Point{15, 2.5}));
  for (const Polyline& other : {parts->second, geom::reversed(parts->second)}) {
    const auto whole = joined(parts->first, other);
    ASSERT_TRUE(whole);
    EXPECT_EQ(whole->points, with_vertex(bed, {1, {15, 2.5}}).points);
  }
  // At a vertex neither part has a segment of no length.
  const auto at_vertex = split_at(bed, {1, {10, 0}});
  ASSERT_TRUE(at_vertex);
  EXPECT_EQ(at_vertex->first.points.size(), 2U);
  EXPECT_EQ(at_vertex->second.points.size(), 3U);
  EXPECT_FALSE(split_at(bed, {0, {0, 0}}));
  EXPECT_FALSE(split_at(bed, {2, {30, 5}}));
}

TEST(LineEdit, ARingIsOpenedWhereItIsSplit) {
  const auto parts = split_at(ring, {3, {0, 5}});
  ASSERT_TRUE(parts);
  EXPECT_FALSE(parts->first.closed);
  EXPECT_EQ(parts->first.points, (std::vector<Point>{{0, 5}, {0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 5}}));
  EXPECT_TRUE(parts->second.points.empty());
  EXPECT_FALSE(joined(ring, bed));
}

TEST(LineEdit, NearestEndsAreJoined) {
  const Polyline before{{{-30, 0}, {-10, 0}}, false};
  EXPECT_EQ(joined(bed, before)->points.front(), (Point{-30, 0}));
  EXPECT_EQ(joined(bed, geom::reversed(before))->points.front(), (Point{-30, 0}));
  EXPECT_EQ(joined(before, bed)->points.back(), (Point{30, 5}));
}

TEST(LineEdit, AnEndGoesStraightOnToTheNearestLine) {
  const std::vector<Polyline> walls{{{{60, -50}, {60, 50}}, false}, {{{40, -50}, {40, 50}}, false}};
  EXPECT_EQ(extended_to(bed, End::Last, walls)->points.back(), (Point{40, 5}));
  EXPECT_FALSE(extended_to(bed, End::First, walls));
  EXPECT_FALSE(extended_to(ring, End::Last, walls));
}

TEST(LineEdit, WhatIsPointedAtBetweenTwoLinesGoes) {
  const std::vector<Polyline> walls{{{{5, -9}, {5, 9}}, false}, {{{25, -9}, {25, 9}}, false}};
  const auto middle = trimmed(bed, walls, {1, {15, 2.5}});
  ASSERT_TRUE(middle);
  ASSERT_EQ(middle->size(), 2U);
  EXPECT_EQ((*middle)[0].points, (std::vector<Point>{{0, 0}, {5, 0}}));
  EXPECT_EQ((*middle)[1].points, (std::vector<Point>{{25, 5}, {30, 5}}));
  const auto end = trimmed(bed, walls, {2, {29, 5}});
  ASSERT_TRUE(end);
  ASSERT_EQ(end->size(), 1U);
  EXPECT_EQ((*end)[0].points.back(), (Point{25, 5}));
  EXPECT_FALSE(trimmed(bed, {}, {0, {1, 0}}));
  // A line that ends on a wall is not cut by it.
  EXPECT_FALSE(trimmed(bed, std::vector<Polyline>{{{{30, -9}, {30, 9}}, false}}, {0, {1, 0}}));
}

TEST(LineEdit, ShapesAreAnticlockwise) {
  EXPECT_EQ(geom::signed_area(rectangle({10, 20}, {0, 0})), 200.0);
  const Polyline circle = regular_polygon({5, 5}, {5, 15}, 64);
  EXPECT_EQ(circle.points.front(), (Point{5, 15}));
  EXPECT_NEAR(geom::signed_area(circle), 0.5 * 64 * 100 * std::sin(2 * M_PI / 64), 1e-9);
}

}  // namespace
}  // namespace dobra::canvas
