#include "shared/io/lines/wkt.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/shared/io/io_examples.h"

namespace dobra::io::lines {
namespace {

using base::ErrorCode;
using geom::Polyline;
using test::place_text;
using testing::ElementsAre;
using testing::HasSubstr;

std::vector<Feature> read(std::string_view text) {
  const auto features = parse_wkt(text, "f");
  EXPECT_TRUE(features.ok()) << (features.ok() ? "" : base::to_string(features.error()));
  return features.ok() ? features->features : std::vector<Feature>{};
}

TEST(Wkt, EveryTypeIsRead) {
  const auto features = read(
      "POINT(1 2)\nmultipoint ((1 2), (3 4)); MULTIPOINT(1 2,3 4)\nLineString (0 0, 1.5 -2e3)\n"
      "MULTILINESTRING ((0 0, 1 1), (2 2, 3 3, 4\n 5))\nPOLYGON EMPTY");
  ASSERT_EQ(features.size(), 6U);
  EXPECT_EQ(features[0].parts[0].points, (std::vector<geom::Point>{{1, 2}}));
  EXPECT_EQ(features[1], features[2]);
  EXPECT_EQ(features[1].type, FeatureType::Points);
  EXPECT_EQ(features[3].parts, (std::vector<Polyline>{{{{0, 0}, {1.5, -2000}}, false}}));
  EXPECT_EQ(features[4].parts.size(), 2U);
  EXPECT_EQ(features[4].parts[1].points[2], (geom::Point{4, 5}));
  EXPECT_EQ(features[5].type, FeatureType::Polygons);
  EXPECT_TRUE(features[5].parts.empty());
}

TEST(Wkt, ContoursComeOutAnticlockwiseAndHolesClockwise) {
  const auto features =
      read("MULTIPOLYGON (((0 0, 0 9, 9 9, 9 0, 0 0), (1 1, 2 1, 2 2, 1 1)), ((20 0, 21 0, 20 1, 20 0)))");
  ASSERT_EQ(features.size(), 1U);
  ASSERT_EQ(features[0].parts.size(), 3U);
  EXPECT_EQ(geom::signed_area(features[0].parts[0]), 81.0);
  EXPECT_EQ(geom::signed_area(features[0].parts[1]), -0.5);
  EXPECT_EQ(features[0].parts[1].points.size(), 3U);
  EXPECT_THAT(polygons_of(features[0]), ElementsAre(std::pair{0U, 2U}, std::pair{2U, 3U}));
}

TEST(Wkt, ThirdCoordinatesAreDroppedAndSaid) {
  const auto features = parse_wkt("LINESTRING Z (0 0 5, 1 1 6, 1 1 7)", "f");
  ASSERT_TRUE(features.ok());
  EXPECT_EQ(features->features[0].parts[0].points.size(), 2U);
  EXPECT_THAT(features->remarks, ElementsAre(HasSubstr("coordinates of 3 points"), HasSubstr("1 repeated")));
}

TEST(Wkt, BadTextIsRefusedWithItsPlace) {
  const std::tuple<const char*, ErrorCode, const char*, const char*> cases[] = {
      {"", ErrorCode::EmptyFile, "f:0:0", "empty"},
      {"LINESTRNG (0 0, 1 1)", ErrorCode::BadFormat, "f:1:1", "did you mean 'LINESTRING'?"},
      {"POINT (1 2)\nLINESTRING (0 0, 1 a)", ErrorCode::BadFormat, "f:2:20", "y 'a' is not a number"},
      {"LINESTRING (0 0, 1)", ErrorCode::BadFormat, "f:1:19", "y is missing"},
      {"LINESTRING (0 0, 1 nan)", ErrorCode::NotFinite, "f:1:20", "not finite"},
      {"LINESTRING (0 0, 1 1", ErrorCode::BadFormat, "f:1:21", "is missing"},
      {"LINESTRING 0 0", ErrorCode::BadFormat, "f:1:12", "'(' is needed here, but found '0 0'"},
      {"LINESTRING (0 0, 0 0)", ErrorCode::DegenerateCurve, "f:1:1", "at least 2 distinct points"},
      {"POLYGON ((0 0, 1 0, 2 0, 0 0))", ErrorCode::DegenerateCurve, "f:1:1", "no area"},
      {"1 2", ErrorCode::BadFormat, "f:1:1", "a geometry such as LINESTRING"},
  };
  for (const auto& [text, code, place, says] : cases) {
    const auto features = parse_wkt(text, "f");
    ASSERT_FALSE(features.ok()) << text;
    EXPECT_EQ(features.error().code, code) << text;
    EXPECT_EQ(place_text(features.error()), place) << text;
    EXPECT_THAT(features.error().message, HasSubstr(says)) << text;
  }
}

TEST(Wkt, WriteReadWriteGivesTheSameBytes) {
  const auto features = read(
      "POINT (0.1 0.30000000000000004)\nMULTIPOINT (1 2, 3 4)\nLINESTRING (0 0, 1e300 -5e-324)\nMULTILINESTRING ((0 0, "
      "1 1), (2 2, 3 3))\n"
      "POLYGON ((0 0, 9 0, 9 9, 0 0), (5 1, 6 2, 6 1, 5 1))\nMULTIPOLYGON (((0 0, 1 0, 0 1, 0 0)), ((5 0, 6 0, 5 1, 5 "
      "0)))\nLINESTRING EMPTY");
  const test::TemporaryFolder folder;
  ASSERT_TRUE(write_wkt(folder.file("a.wkt"), features).ok());
  const auto again = read_wkt(folder.file("a.wkt"));
  ASSERT_TRUE(again.ok());
  EXPECT_EQ(again->features, features);
  EXPECT_EQ(*wkt(again->features), *wkt(features));
  EXPECT_EQ(
      wkt(std::vector<Feature>{{.type = FeatureType::Lines, .parts = {{{{0, 0}, {NAN, 1}}, false}}}}).error().code,
      ErrorCode::NotFinite);
}

}  // namespace
}  // namespace dobra::io::lines
