#include "shared/io/lines/gocad.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/shared/io/io_examples.h"

namespace dobra::io::lines {
namespace {

using geom::Point;
using testing::ElementsAre;
using testing::HasSubstr;

Features gocad_features(const std::string& text) {
  auto read = parse_gocad(text, "f.pl");
  EXPECT_TRUE(read.ok()) << base::to_string(read.error());
  return read.ok() ? *read : Features{};
}

std::string refusal(const std::string& text) {
  const auto read = parse_gocad(text, "f.pl");
  return read.ok() ? "read" : base::to_string(read.error());
}

const std::string system_up =
    "GOCAD_ORIGINAL_COORDINATE_SYSTEM\nNAME Default\nAXIS_NAME \"X\" \"Y\" \"Z\"\nAXIS_UNIT \"m\" \" m \" "
    "\"m\"\nZPOSITIVE Elevation\nEND_ORIGINAL_COORDINATE_SYSTEM\n";

TEST(Gocad, EverySpellingOfTheHeaderGivesTheName) {
  for (const std::string header :
       {"HEADER {\nname:Top Sand\n}\n", "HEADER{name:Top Sand}\n", "HEADER {name: Top Sand\n}\n",
        "HEADER: {\n*name: Top Sand\n*color: red\n}\n", "header {\nname=Top Sand\n}\n",
        "HEADER\n{\n*line*color:1 0 0 1\nname:Top Sand\n}\n", "HEADER{name:Top Sand *line*color:1 0 0 1}\n"}) {
    for (const std::string first : {"GOCAD PLine 1\n", "GOCAD PLINE 1.0\n", "GOCAD PLine 1 \r\n"}) {
      const Features read =
          gocad_features(first + header + system_up + "ILINE\nVRTX 1 0 5 -1\nVRTX 2 3 5 -2\nSEG 1 2\nEND\n");
      ASSERT_EQ(read.features.size(), 1U) << header;
      EXPECT_EQ(read.features[0].name, "Top Sand") << header;
      EXPECT_EQ(read.features[0].type, FeatureType::Lines);
      EXPECT_THAT(read.features[0].parts[0].points, ElementsAre(Point{0, 5}, Point{3, 5}));
      EXPECT_THAT(read.features[0].heights[0], ElementsAre(-1.0, -2.0));
      EXPECT_TRUE(read.stated.questions.empty());
      EXPECT_EQ(read.features[0].source.line, 1U);
    }
  }
}

TEST(Gocad, DepthsAndUnitsAreStatedAndWhatIsMissingIsAsked) {
  const std::string line = "VRTX 1 0 0 1\nVRTX 2 1 0 2\nSEG 1 2\nEND\n";
  const Features depth = gocad_features(
      "GOCAD PLine 1\nGOCAD_ORIGINAL_COORDINATE_SYSTEM\nAXIS_UNIT km km m\nZPOSITIVE Depth\n"
      "END_ORIGINAL_COORDINATE_SYSTEM\n" +
      line);
  EXPECT_EQ(depth.stated.y_direction, YDirection::Down);
  EXPECT_EQ(depth.stated.unit, 1000.0);
  EXPECT_EQ(depth.stated.height_unit, 1.0);
  const Features silent = gocad_features("GOCAD PLine 1\nHEADER {\nname:a\n}\n" + line);
  ASSERT_EQ(silent.stated.questions.size(), 1U);
  EXPECT_EQ(silent.stated.questions[0].about, Question::About::YDirection);
  EXPECT_THAT(silent.stated.questions[0].text, HasSubstr("--y-axis"));
  const Features odd = gocad_features(
      "GOCAD PLine 1\nGOCAD_ORIGINAL_COORDINATE_SYSTEM\nAXIS_UNIT rod rod rod\nZPOSITIVE "
      "Depth\nEND_ORIGINAL_COORDINATE_SYSTEM\n" +
      line);
  ASSERT_EQ(odd.stated.questions.size(), 1U);
  EXPECT_THAT(odd.stated.questions[0].text, HasSubstr("'rod'"));
}

TEST(Gocad, SegmentsInAnyOrderBecomePathsRingsAndBranches) {
  const std::string vertices = "VRTX 1 0 0 0\nPVRTX 2 1 0 0 7.5\nVRTX 3 2 0 1\nVRTX 4 3 0 0\nATOM 5 1\n";
  const auto read_with = [&](const std::string& segments) {
    return gocad_features("GOCAD PLine 1\n" + system_up + vertices + segments + "END\n");
  };
  const Features path = read_with("SEG 4 3\nSEG 2 1\nSEG 2 3\n");
  ASSERT_EQ(path.features.size(), 1U);
  EXPECT_THAT(path.features[0].parts[0].points, ElementsAre(Point{0, 0}, Point{1, 0}, Point{2, 0}, Point{3, 0}));
  EXPECT_THAT(path.remarks,
              ElementsAre(HasSubstr("1 vertices that no segment uses"), HasSubstr("properties of vertices")));
  const Features ring = read_with("SEG 1 2\nSEG 2 3\nSEG 3 1\n");
  ASSERT_EQ(ring.features.size(), 1U);
  EXPECT_EQ(ring.features[0].type, FeatureType::Polygons);
  EXPECT_EQ(ring.features[0].parts[0].points.size(), 3U);
  const Features star = read_with("SEG 2 1\nSEG 2 3\nSEG 2 4\n");
  ASSERT_EQ(star.features.size(), 1U);
  EXPECT_EQ(star.features[0].parts.size(), 3U);
  EXPECT_THAT(star.remarks.at(0), HasSubstr("branches at 1 vertices"));
  const Features none = read_with("");
  ASSERT_EQ(none.features.size(), 1U);
  EXPECT_EQ(none.features[0].parts[0].points.size(), 5U);
}

TEST(Gocad, GroupsOtherObjectsAndPropertiesAreReadOver) {
  const Features read = gocad_features(
      "GOCAD HomogeneousGroup 1\nHEADER {\nname:g\n}\nTYPE PLine\nBEGIN_MEMBERS\nGOCAD PLine 1\nHEADER "
      "{\nname:f1\n}\n" +
      system_up +
      "GEOLOGICAL_FEATURE Main Fault\nGEOLOGICAL_TYPE fault\nPROPERTIES TWT\nPROPERTY_CLASS_HEADER TWT "
      "{\n*pclip:99\n}\nILINE\nPVRTX 1 0 0 0 9\nPVRTX 2 0 1 0 9\nSEG 1 2\nEND\nEND_MEMBERS\nEND\n"
      "GOCAD TSurf 1\nHEADER {\nname:s\n}\nTFACE\nVRTX 1 0 0 0\nEND\nGOCAD VSet 1\nHEADER {\nname:picks\n}\n" +
      system_up + "VRTX 1 0 0 0\nEND\n");
  ASSERT_EQ(read.features.size(), 2U);
  EXPECT_EQ(read.features[0].kind, "fault");
  EXPECT_EQ(std::get<std::string>(read.features[0].properties.at(0).second), "Main Fault");
  EXPECT_EQ(read.features[1].type, FeatureType::Points);
  EXPECT_THAT(read.remarks.at(0), HasSubstr("1 of type tsurf left out"));
}

TEST(Gocad, WhatIsWrittenReadsBackToTheSameText) {
  Feature bed{.parts = {{{{0.1, 0}, {1e-7, 2.0 / 3.0}}, false}, {{{5, 5}, {6, 5}}, false}},
              .name = "Bed, upper",
              .kind = "horizon",
              .properties = {{"geological_feature", std::string("Sandstone")}},
              .heights = {{-1.25, 1e5}, {0.1, 0.2}}};
  Feature unit{.type = FeatureType::Polygons,
               .parts = {{{{0, 0}, {4, 0}, {4, 0}, {0, 0}}, true}, {{{1, 0}, {1, 0}, {3, 0}}, true}},
               .name = "u",
               .kind = "unit",
               .heights = {{0, 0, 4, 4}, {1, 3, 1}}};
  Feature picks{.type = FeatureType::Points, .parts = {{{{1, 2}, {3, 4}}, false}}, .name = "w", .heights = {{5, 6}}};
  const std::vector<Feature> features{bed, unit, picks};
  const std::string text = *gocad(features);
  const Features read = gocad_features(text);
  ASSERT_EQ(read.features.size(), 4U);  // the hole is a ring of its own
  EXPECT_EQ(read.features[0], bed);
  EXPECT_EQ(*gocad(read.features), text);
}

TEST(Gocad, ANameWithAStarIsKeptWhereItStandsAlone) {
  Feature bed{
      .parts = {{{{0, 0}, {1, 0}}, false}}, .name = "Top *upper: {Sand}\t", .kind = "bed set", .heights = {{0, 0}}};
  const Features read = gocad_features(*gocad(std::vector{bed}));
  EXPECT_EQ(read.features[0].name, "Top *upper:  Sand");
  EXPECT_EQ(read.features[0].name, gocad_name(bed.name));
  EXPECT_EQ(read.features[0].kind, "bed_set");
}

TEST(Gocad, BadInputIsRefusedWithItsPlace) {
  EXPECT_THAT(refusal("VRTX 1 0 0 0\n"), HasSubstr("f.pl:1:1: 'VRTX' stands outside any GOCAD object"));
  EXPECT_THAT(refusal("GOCAD PLine 1\nVRTX 1 0 x 0\nEND\n"), HasSubstr("f.pl:2:10: y 'x' is not a number"));
  EXPECT_THAT(refusal("GOCAD PLine 1\nVRTX 1 0 0\nEND\n"), HasSubstr("f.pl:2:11: z is missing"));
  EXPECT_THAT(refusal("GOCAD PLine 1\nVRTX 1 0 0 nan\nEND\n"), HasSubstr("not finite"));
  EXPECT_THAT(refusal("GOCAD PLine 1\nVRTX 1 0 0 0\nSEG 1 7\nEND\n"), HasSubstr("f.pl:3:7: there is no vertex 7"));
  EXPECT_THAT(refusal("GOCAD PLine 1\nVRTX 1 0 0 0\nVRTX 1 0 0 0\nEND\n"),
              HasSubstr("f.pl:3:6: there are two vertices 1"));
  EXPECT_THAT(refusal("GOCAD PLine 1\nVRTX 1 0 0 0\n"), HasSubstr("ends before END"));
  EXPECT_THAT(refusal("GOCAD PLine 1\nHEADER {\nname:a\n"), HasSubstr("f.pl:2: the braces that begin here"));
  EXPECT_THAT(refusal("GOCAD PLine 1\nGOCAD PLine 1\nEND\n"), HasSubstr("a new object before END"));
  EXPECT_THAT(refusal("GOCAD TSurf 1\nEND\n"), HasSubstr("no PLine and no VSet"));
  EXPECT_THAT(refusal("GOCAD PLine 1\nZPOSITIVE Sideways\nEND\n"), HasSubstr("neither Elevation nor Depth"));
  EXPECT_THAT(refusal("GOCAD PLine 1\nVRTX 1 0 0 0\nVRTX 2 0 0 0\nSEG 1 2\nEND\n"), HasSubstr("f.pl:1: "));
}

}  // namespace
}  // namespace dobra::io::lines
