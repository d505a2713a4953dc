#include "shared/scene/names.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace dobra::scene {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

double middle(const std::optional<geom::Box>& box) { return box->centre().y; }

TEST(Names, OneAloneStandsBesideItsEnd) {
  const auto right = places_of_names({{{10.0, 5.0}, Anchor::Right, 30.0, 8.0}}, 20.0, -endless, endless);
  ASSERT_TRUE(right[0]);
  EXPECT_EQ(*right[0], (geom::Box{{10.0, 1.0}, {40.0, 9.0}}));
  const auto left = places_of_names({{{10.0, 5.0}, Anchor::Left, 30.0, 8.0}}, 20.0, -endless, endless);
  EXPECT_EQ(*left[0], (geom::Box{{-20.0, 1.0}, {10.0, 9.0}}));
}

TEST(Names, TwoAtOnePlaceMoveByHalfEach) {
  const auto boxes = places_of_names({{{0.0, 0.0}, Anchor::Right, 30.0, 8.0}, {{0.0, 0.0}, Anchor::Right, 30.0, 8.0}},
                                     20.0, -endless, endless);
  EXPECT_NEAR(middle(boxes[0]), -4.0, 0.02);
  EXPECT_NEAR(middle(boxes[1]), 4.0, 0.02);
}

TEST(Names, ANameThatMovedLeavesRoomForItsLeader) {
  std::vector<NamePlace> names(5, {{0.0, 0.0}, Anchor::Right, 30.0, 8.0});
  const auto boxes = places_of_names(names, 20.0, -endless, endless);
  EXPECT_EQ(boxes[0]->low.x, leader_length);
  EXPECT_EQ(boxes[2]->low.x, 0.0);  // the one in the middle stays
}

TEST(Names, RandomOnesNeverOverlapNorMoveFartherThanAllowedAndKeepTheirOrder) {
  std::mt19937 random(7);
  for (int round = 0; round < 200; ++round) {
    std::vector<NamePlace> names;
    const int count = 2 + round % 60;
    for (int i = 0; i < count; ++i) {
      const double y = static_cast<double>(random() % 2000) / 10.0;
      const double x = round % 3 == 0 ? static_cast<double>(random() % 300) : 0.0;
      names.push_back({{x, y}, Anchor::Right, 20.0 + static_cast<double>(random() % 30), 9.0});
    }
    const double reach = round % 2 == 0 ? 12.0 : 40.0;
    const auto boxes = places_of_names(names, reach, 0.0, 200.0);
    std::size_t placed = 0;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (!boxes[i]) continue;
      ++placed;
      EXPECT_GE(boxes[i]->low.y, 0.0);
      EXPECT_LE(boxes[i]->high.y, 200.0 + 1e-6);
      EXPECT_LE(std::abs(middle(boxes[i]) - names[i].end.y), reach + 0.5 * 9.0 + 0.1) << round;
      for (std::size_t k = 0; k < i; ++k) {
        if (!boxes[k]) continue;
        EXPECT_FALSE(boxes[i]->overlaps(*boxes[k])) << round << ": " << i << ", " << k;
        if (names[i].end.x != names[k].end.x || names[i].end.y == names[k].end.y) continue;
        EXPECT_EQ(names[i].end.y < names[k].end.y, middle(boxes[i]) < middle(boxes[k])) << round;
      }
    }
    EXPECT_GE(placed, std::min<std::size_t>(names.size(), 5)) << round;
  }
}

TEST(Names, WhereThereIsNoRoomForAllTheyAreThinnedOutEvenly) {
  std::vector<NamePlace> names;
  for (int i = 0; i < 60; ++i) names.push_back({{0.0, 2.0 * i}, Anchor::Right, 30.0, 10.0});
  const auto boxes = places_of_names(names, 8.0, -endless, endless);
  std::vector<double> kept;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (boxes[i]) kept.push_back(names[i].end.y);
  }
  EXPECT_GE(kept.size(), 8U);  // 120 points of lines hold twelve names
  EXPECT_LE(kept.size(), 14U);
  for (std::size_t i = 1; i < kept.size(); ++i) EXPECT_LE(kept[i] - kept[i - 1], 24.0);
}

}  // namespace
}  // namespace dobra::scene
