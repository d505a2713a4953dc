#include "shared/canvas/line_text.h"

#include <gtest/gtest.h>

#include <random>

namespace dobra::canvas {
namespace {

using geom::Point;

TEST(LineText, WhatHoldsNoPointsIsRefusedWithTheLine) {
  for (const char* text : {"", "   \n\n", "hello", "# only a name", "[[]]", "[]", "{\"a\": 1}"}) {
    EXPECT_FALSE(lines_of_text(text).ok()) << text;
  }
  const auto third = lines_of_text("0\t1\n2\t3\nabc\tdef\n");
  ASSERT_FALSE(third.ok());
  EXPECT_NE(third.error().message.find("line 3"), std::string::npos) << third.error().message;
  for (const char* text : {"1\t2\n3", "1 2\n3 x", "x\n1 2", "1\tnan", "inf 0", "1\t2\n1e999\t0", "7"}) {
    EXPECT_FALSE(lines_of_text(text).ok()) << text;
  }
}

TEST(LineText, ColumnsOfASpreadsheetAreReadHoweverTheyAreParted) {
  const std::vector<Point> expected{{0.5, -1.0}, {2.0, -3.25}};
  for (const char* text :
       {"0.5\t-1\n2\t-3.25\n", "0,5\t-1\n2\t-3,25", "0.5;-1\r\n2;-3.25\r\n", "0,5;-1\n2;-3,25", "0.5,-1\n2,-3.25",
        "0.5, -1\n2, -3.25", "  0.5   -1\n 2  -3.25  ", "x\tz\n0.5\t-1\n2\t-3.25\t17\tremark", "x;z\n0.5;-1\n2;-3.25",
        "[[0.5, -1], [2, -3.25]]", "points = [[0.5, -1],\n          [2.0, -3.25]]\n", "0.5\t\u22121\n2\t\u22123.25"}) {
    const auto read = lines_of_text(text);
    ASSERT_TRUE(read.ok()) << text << read.error().message;
    ASSERT_EQ(read->size(), 1U) << text;
    EXPECT_EQ(read->front().line.points, expected) << text;
    EXPECT_FALSE(read->front().line.closed);
  }
}

TEST(LineText, LinesComeBackAsTheyWereToTheLastBit) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> number(-1e6, 1e6);
  std::vector<NamedLine> lines;
  for (const std::size_t count : {1UL, 2UL, 3UL, 1000UL}) {
    NamedLine line{"A & \"B\" #" + std::to_string(count), {{}, count >= 3}};
    for (std::size_t i = 0; i < count; ++i) line.line.points.push_back({number(random) / 3.0, number(random) / 7.0});
    lines.push_back(line);
  }
  const auto read = lines_of_text(text_of_lines(lines));
  ASSERT_TRUE(read.ok()) << read.error().message;
  ASSERT_EQ(read->size(), lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    EXPECT_EQ((*read)[i].name, lines[i].name);
    EXPECT_EQ((*read)[i].line, lines[i].line);
  }
}

TEST(LineText, APlaceTwiceInARowIsOneVertex) {
  const auto read = lines_of_text("0 0\n0 0\n1 1\n1 1\n");
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->front().line.points.size(), 2U);
}

}  // namespace
}  // namespace dobra::canvas
