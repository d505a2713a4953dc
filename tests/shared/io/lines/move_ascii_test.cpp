#include "shared/io/lines/move_ascii.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/shared/io/io_examples.h"

namespace dobra::io::lines {
namespace {

using geom::Point;
using testing::ElementsAre;
using testing::HasSubstr;

Features move_features(const std::string& text) {
  auto read = parse_move_ascii(text, "f.asc");
  EXPECT_TRUE(read.ok()) << base::to_string(read.error());
  return read.ok() ? *read : Features{};
}

TEST(MoveAscii, BlankLinesAndNewNamesBeginNewLines) {
  const Features read = move_features(
      "x\ty\tz\tname\tid\tattribute\r\n0\t1\t-5\tTop Sand\t7\thorizon\r\n1\t1\t-6\tTop Sand\t7\thorizon\r\n\r\n"
      "2\t1\t-7\tTop Sand\t7\thorizon\n3\t1\t-8\tTop Sand\t7\thorizon\n"
      "0\t1\t0\tF1\tA3\tmain\n0\t1\t-9\tF1\tA3\tmain\n\n4\t4\t4\tWell\t9\n");
  ASSERT_EQ(read.features.size(), 4U);
  EXPECT_EQ(read.features[0].name, "Top Sand");
  EXPECT_EQ(read.features[0].kind, "horizon");
  EXPECT_EQ(read.features[0].source.line, 2U);
  EXPECT_EQ(std::get<std::int64_t>(read.features[0].properties.at(0).second), 7);
  EXPECT_THAT(read.features[1].parts[0].points, ElementsAre(Point{2, 1}, Point{3, 1}));
  EXPECT_THAT(read.features[1].heights[0], ElementsAre(-7.0, -8.0));
  EXPECT_EQ(read.features[2].kind, "");
  EXPECT_EQ(std::get<std::string>(read.features[2].properties.at(1).second), "main");
  // Straight down: the same place on the map twice.
  EXPECT_EQ(read.features[2].parts[0].points.size(), 2U);
  EXPECT_EQ(read.features[3].type, FeatureType::Points);
  EXPECT_TRUE(read.remarks.empty());
}

TEST(MoveAscii, RepeatedPointsAndChangingAttributesAreSaid) {
  const Features read = move_features("0 0 0 a 1 x\n0 0 0 a 1 y\n1 0 0 a 1 x\n");
  EXPECT_THAT(read.remarks, ElementsAre(HasSubstr("1 repeated points dropped"), HasSubstr("attributes of 1 lines")));
}

TEST(MoveAscii, WhatIsWrittenReadsBackToTheSameText) {
  const std::vector<Feature> features{
      {.parts = {{{{0.1, 1e22}, {2.0 / 3.0, 0}}, false}, {{{5, 5}, {5, 5}}, false}},
       .name = "Bed\tA",
       .kind = "horizon",
       .heights = {{-1.25, 1e-5}, {0, 1}}},
      {.type = FeatureType::Polygons,
       .parts = {{{{0, 0}, {4, 0}, {4, 0}}, true}},
       .kind = "unit",
       .heights = {{0, 0, 4}}},
      {.type = FeatureType::Points, .parts = {{{{1, 2}, {3, 4}}, false}}, .name = "w", .heights = {{5, 6}}}};
  const std::string text = *move_ascii(features);
  const Features read = move_features(text);
  ASSERT_EQ(read.features.size(), 5U);
  EXPECT_EQ(read.features[2].type, FeatureType::Polygons);
  EXPECT_EQ(*move_ascii(read.features), text);
}

TEST(MoveAscii, BadInputIsRefusedWithItsPlace) {
  const auto refusal = [](const std::string& text) {
    const auto read = parse_move_ascii(text, "f.asc");
    return read.ok() ? "read" : base::to_string(read.error());
  };
  EXPECT_THAT(refusal("0\t0\t0\n1\tx\t0\n"), HasSubstr("f.asc:2:3: y 'x' is not a number"));
  EXPECT_THAT(refusal("0\t0\t0\n1\t0\n"), HasSubstr("f.asc:2:4: z is missing"));
  EXPECT_THAT(refusal("0\t0\tnan\n1\t0\t0\n"), HasSubstr("not finite"));
  EXPECT_THAT(refusal("x y z\n"), HasSubstr("holds no points"));
  EXPECT_THAT(refusal("0 0 0\n0 0 0\n"), HasSubstr("f.asc:1: a line needs at least 2 distinct points"));
  EXPECT_THAT(refusal(""), HasSubstr("empty"));
}

}  // namespace
}  // namespace dobra::io::lines
