#include "shared/canvas/snap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace dobra::canvas {
namespace {

using geom::Point;

SnapIndex index_of(std::vector<geom::Polyline> lines, std::vector<Point> markers = {}, double exaggeration = 1.0) {
  scene::Picture picture;
  picture.panels.push_back({.key = "section", .vertical_exaggeration = exaggeration});
  picture.panels[0].layers.push_back({.key = "lines", .content = scene::Lines{std::move(lines), {}}});
  picture.panels[0].layers.push_back({.key = "markers", .content = scene::Markers{std::move(markers), {}}});
  return {std::make_shared<const scene::Picture>(std::move(picture)), 0};
}

TEST(Snap, AVertexWinsOverANearerCrossingAndThatOverTheLine) {
  const SnapIndex index = index_of({{{{0, 0}, {100, 0}}, false}, {{{96, -50}, {96, 50}}, false}});
  auto found = index.at({97, 1}, {.reach = 5.0});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, SnapKind::Vertex);
  EXPECT_EQ(found->at, (Point{100, 0}));
  EXPECT_EQ(found->segment, 1U);
  found = index.at({93, 1}, {.reach = 5.0});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, SnapKind::Intersection);
  EXPECT_EQ(found->at, (Point{96, 0}));
  found = index.at({50, 1}, {.reach = 5.0});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, SnapKind::OnLine);
  EXPECT_EQ(found->at, (Point{50, 0}));
  EXPECT_FALSE(index.at({50, 6}, {.reach = 5.0}));
}

TEST(Snap, NeighbouringSegmentsMeetInAVertexAndNotInACrossing) {
  const SnapIndex index = index_of({{{{0, 0}, {10, 0}, {20, 5}}, false}});
  SnapWish wish{.reach = 3.0, .kinds = {SnapKind::Intersection}};
  EXPECT_FALSE(index.at({10, 0}, wish));
}

TEST(Snap, AnEndThatTouchesAnotherLineIsACrossingOfBoth) {
  const SnapIndex index = index_of({{{{0, 0}, {10, 0}}, false}, {{{5, 0}, {5, 9}}, false}});
  const auto found = index.at({5.5, 0.5}, {.reach = 2.0, .kinds = {SnapKind::Intersection}});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->at, (Point{5, 0}));
}

TEST(Snap, ReachIsACircleOnThePageWhateverTheExaggeration) {
  const SnapIndex index = index_of({}, {{0, 0}}, 10.0);
  SnapWish wish{.reach = 5.0, .exaggeration = 10.0};
  EXPECT_TRUE(index.at({4.9, 0}, wish));
  EXPECT_TRUE(index.at({0, 0.49}, wish));
  EXPECT_FALSE(index.at({0, 0.51}, wish));
}

TEST(Snap, TheFootOfAPerpendicularIsFoundOnTheLine) {
  const SnapIndex index = index_of({{{{0, 0}, {100, 100}}, false}});
  const auto found = index.at({51, 50}, {.reach = 4.0, .from = Point{100, 0}});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, SnapKind::Perpendicular);
  EXPECT_NEAR(found->at.x, 50.0, 1e-12);
  EXPECT_NEAR(found->at.y, 50.0, 1e-12);
}

TEST(Snap, AWayThatStartsOnALineLeavesItAtARightAngle) {
  const SnapIndex index = index_of({{{{0, 0}, {100, 50}}, false}});
  const auto found = index.at({29, 65}, {.reach = 4.0, .from = Point{50, 25}});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, SnapKind::Perpendicular);
  const geom::Vector way = found->at - Point{50, 25};
  EXPECT_NEAR(dot(way, {100, 50}), 0.0, 1e-9);
}

TEST(Snap, AnglesAreTrueAngles) {
  const SnapIndex index = index_of({}, {}, 5.0);
  SnapWish wish{.reach = 3.0, .exaggeration = 5.0, .kinds = {SnapKind::Angle}, .from = Point{0, 0}};
  const auto found = index.at({100.2, 100.0}, wish);
  ASSERT_TRUE(found);
  EXPECT_NEAR(std::atan2(found->at.y, found->at.x), std::atan(1.0), 1e-12);
  EXPECT_EQ(index.at({0.1, 80.0}, wish)->at.x, 0.0);
  // However far: with angles on, every way has one.
  const auto far = index.at({100, 70}, wish);
  ASSERT_TRUE(far);
  EXPECT_NEAR(std::atan2(far->at.y, far->at.x), M_PI / 6.0, 1e-12);
}

TEST(Snap, GridNodesComeBehindLines) {
  const SnapIndex index = index_of({{{{0, 1}, {100, 1}}, false}});
  SnapWish wish{.reach = 2.0, .grid = 10.0};
  wish.kinds.insert(SnapKind::Grid);
  EXPECT_EQ(index.at({20.5, 0.2}, wish)->kind, SnapKind::OnLine);
  EXPECT_EQ(index.at({20.5, -10.2}, wish)->at, (Point{20, -10}));
}

TEST(Snap, WhatIsHiddenOrMovesIsNotLookedAt) {
  scene::Picture picture;
  picture.panels.push_back({.key = "section"});
  picture.panels[0].layers.push_back(
      {.key = "hidden", .content = scene::Lines{{{{{0, 0}, {9, 0}}, false}}, {}}, .visible = false});
  picture.panels[0].layers.push_back({.key = "moves", .content = scene::Lines{{{{{0, 5}, {9, 5}}, false}}, {7}}});
  const SnapIndex index(std::make_shared<const scene::Picture>(std::move(picture)), 0);
  EXPECT_FALSE(index.at({0, 0}, {.reach = 1.0}));
  const auto found = index.at({0, 5}, {.reach = 1.0});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->on, (scene::Pick{"moves", 7}));
  EXPECT_FALSE(index.at({0, 5}, {.reach = 1.0, .without = {{"moves", 7}}}));
}

TEST(Snap, TheNearestVertexIsThatOfAllTried) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(0.0, 1000.0);
  std::vector<geom::Polyline> lines(40);
  std::vector<Point> all;
  for (geom::Polyline& line : lines) {
    for (int i = 0; i < 50; ++i) all.push_back(line.points.emplace_back(Point{place(random), place(random)}));
  }
  const SnapIndex index = index_of(lines);
  for (int k = 0; k < 200; ++k) {
    const Point cursor{place(random), place(random)};
    Point best = all.front();
    for (const Point p : all) {
      if (std::hypot(p.x - cursor.x, 3.0 * (p.y - cursor.y)) < std::hypot(best.x - cursor.x, 3.0 * (best.y - cursor.y)))
        best = p;
    }
    const auto found = index.at(cursor, {.reach = 2000.0, .exaggeration = 3.0, .kinds = {SnapKind::Vertex}});
    ASSERT_TRUE(found);
    EXPECT_EQ(found->at, best);
  }
}

}  // namespace
}  // namespace dobra::canvas
