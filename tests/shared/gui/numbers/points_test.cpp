#include <gtest/gtest.h>

#include "shared/gui/numbers/numbers.h"

namespace dobra::gui::numbers {
namespace {

TEST(PointsOfText, PointsReadWithAnyUsualSeparator) {
  const auto points = points_from_text("0, 1\n2;3\n[4, 5],\n6\t7\r\n\n8 9\n");
  ASSERT_TRUE(points.ok());
  const std::vector<geom::Point> expected{{0, 1}, {2, 3}, {4, 5}, {6, 7}, {8, 9}};
  EXPECT_EQ(*points, expected);
}

TEST(PointsOfText, PointsReadBackToTheSameBits) {
  const std::vector<geom::Point> points{{0.1, 1.0 / 3.0}, {-1e-300, 12345678.901234567}, {0.0, -0.0}};
  EXPECT_EQ(*points_from_text(text_of_points(points)), points);
}

TEST(PointsOfText, BadPointsNameTheLine) {
  const auto word = points_from_text("0, 0\n1, x\n");
  ASSERT_FALSE(word.ok());
  EXPECT_EQ(word.error().message, "line 2: 'x' is not a number");
  const auto three = points_from_text("0, 0, 0\n");
  ASSERT_FALSE(three.ok());
  EXPECT_EQ(three.error().message, "line 1: a point has two numbers, x and y");
  EXPECT_FALSE(points_from_text("1, nan").ok());
  EXPECT_FALSE(points_from_text("1, inf").ok());
}

}  // namespace
}  // namespace dobra::gui::numbers
