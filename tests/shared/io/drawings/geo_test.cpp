#include "shared/io/drawings/geo.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "tests/shared/io/io_examples.h"
#include "tests/support/corpus.h"

namespace dobra::io::drawings {
namespace {

using base::ErrorCode;
using test::place_text;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

GeoFile parse(const std::string& text) {
  auto file = parse_geo(text, "f");
  EXPECT_TRUE(file.ok()) << (file ? "" : to_string(file.error()));
  return file ? *std::move(file) : GeoFile{};
}

const std::string square =
    "Point(1) = {0, 0, 0, 0.5};\nPoint(2) = {1, 0, 0};\nPoint(3) = {1, 1, 0};\nPoint(4) = {0, 1, 0};\n"
    "Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};\n";

/// The x of point 9, set to an expression.
double value_of(const std::string& expression) {
  return parse(square + "a = 3; b[] = {4, 5, 6:8};\nPoint(9) = {" + expression + ", 0, 0};\n").points.at(9).at.x;
}

TEST(Geo, ExpressionsHaveTheRanksOfC) {
  EXPECT_EQ(value_of("1 + 2 * 3"), 7.0);
  EXPECT_EQ(value_of("(1 + 2) * 3"), 9.0);
  EXPECT_EQ(value_of("-2 ^ 2"), -4.0);
  EXPECT_EQ(value_of("2 ^ 3 ^ 2"), 512.0);
  EXPECT_EQ(value_of("2 ^ -1"), 0.5);
  EXPECT_EQ(value_of("7 % 4 - 10 / 4"), 0.5);
  EXPECT_EQ(value_of("a > 2 && !(a == 4) ? 10 : 20"), 10.0);
  EXPECT_EQ(value_of("a < 2 || a != 3 ? 10 : 20"), 20.0);
  EXPECT_DOUBLE_EQ(value_of("2 * Sin(Pi / 6) + Sqrt[16]"), 5.0);
  EXPECT_DOUBLE_EQ(value_of("Atan2(1, 1) * 4"), 3.141592653589793);
  EXPECT_EQ(value_of("b[0] + b(4) + #b[]"), 17.0);
  EXPECT_EQ(value_of("1e-3 * 1000 + .5"), 1.5);
}

TEST(Geo, PointsCurvesLoopsAndGroupsAreRead) {
  const GeoFile file =
      parse(square +
            "Curve Loop(7) = {1, 2, 3, 4}; Plane Surface(8) = {7};\nPhysical Surface(\"plate\", 12) = {8};\n"
            "Physical Line(3) = {-1, 2};\nPhysical Point(\"pin\") = {1};\nCharacteristic Length {2, 3} = 0.25;\n"
            "Transfinite Line {1} = 5 Using Progression 2;\nPoint(5) = {0.5, 0.5, 0};\nPoint{5} In "
            "Surface{8};\nMesh.Algorithm = 6;\n");
  EXPECT_EQ(file.points.at(1).size, 0.5);
  EXPECT_EQ(file.points.at(3).size, 0.25);
  EXPECT_THAT(file.curves.at(3).points, ElementsAre(3, 4));
  EXPECT_EQ(file.curves.at(1).segments, 4);
  EXPECT_DOUBLE_EQ(file.curves.at(1).ratio, 8.0);
  ASSERT_EQ(file.surfaces.at(8).size(), 1U);
  EXPECT_THAT(file.surfaces.at(8)[0], ElementsAre(1, 2, 3, 4));
  ASSERT_EQ(file.groups.size(), 3U);
  EXPECT_EQ(file.groups[0].name, "plate");
  EXPECT_EQ(file.groups[0].tag, 12);
  EXPECT_THAT(file.groups[1].entities, ElementsAre(1, 2));
  EXPECT_EQ(file.groups[2].tag, 13);
  EXPECT_THAT(file.embedded, ElementsAre(std::array<std::int64_t, 2>{0, 5}));
  EXPECT_THAT(file.remarks, ElementsAre(HasSubstr("'Mesh.Algorithm' left out")));
}

TEST(Geo, ForAndIfAreCarriedOut) {
  const GeoFile file = parse(square +
                             "n = 0;\nFor i In {1:3}\n  For (1:2)\n    n += 1;\n    If (i == 2)\n      Point(newp) = "
                             "{i, n, 0};\n    ElseIf (i == 3)\n"
                             "      Point(100 + n) = {9, 9, 0};\n    Else\n      m[] += n;\n    EndIf\n  "
                             "EndFor\nEndFor\nPoint(50) = {n, #m[], 0};\n");
  EXPECT_EQ(file.points.at(50).at, (geom::Point{6, 2}));
  EXPECT_EQ(file.points.at(5).at, (geom::Point{2, 3}));
  EXPECT_EQ(file.points.at(6).at, (geom::Point{2, 4}));
  EXPECT_TRUE(file.points.contains(105) && file.points.contains(106));
}

TEST(Geo, MacrosAreCarriedOutWhereTheyAreCalled) {
  // A hole, as gmsh's tutorial makes its holes: with the variables that stand when it is called.
  const std::string hole =
      "Function Hole\n  c = newp; Point(c) = {x, y, 0};\n  p = newp; Point(p) = {x + r, y, 0};\n"
      "  q = newp; Point(q) = {x - r, y, 0};\n  l = newl; Circle(l) = {p, c, q}; m = newl; Circle(m) = {q, c, p};\n"
      "  holes[t] = newll; Curve Loop(holes[t]) = {l, m};\n  If (r > 0.2)\n    big += 1;\n  EndIf\nReturn\n";
  const GeoFile file = parse(
      square + "big = 0;\n" + hole +
      "r = 0.1;\nFor t In {0:2}\n  x = 0.2 + 0.3 * t; y = 0.5;\n  r += 0.07;\n  Call Hole;\n"
      "EndFor\nCurve Loop(50) = {1, 2, 3, 4};\nPlane Surface(20) = {50, holes[]};\nPoint(100) = {big, #holes[], 0};\n");
  EXPECT_EQ(file.points.at(100).at, (geom::Point{2, 3}));
  ASSERT_EQ(file.surfaces.at(20).size(), 4U);
  EXPECT_DOUBLE_EQ(file.points.at(5).at.x, 0.2);
  EXPECT_DOUBLE_EQ(file.points.at(11).at.x, 0.8);
  // Macro is the newer word, macros call macros, and what is only defined does nothing.
  const GeoFile nested = parse(square +
                               "Macro \"in\"\n n += 1;\nReturn\nMacro out\n Call in; Call in; n *= 10;\nReturn\n"
                               "Macro never\n n = -1;\nReturn\nn = 1;\nCall out;\nPoint(60) = {n, 0, 0};\n");
  EXPECT_EQ(nested.points.at(60).at.x, 30.0);
  for (const auto& [text, says] : std::vector<std::pair<std::string, std::string>>{
           {"Call hole;\n", "there is no macro 'hole'"},
           {"Function hole\nReturn\nCall hoel;\n", "did you mean 'hole'?"},
           {"Function a\n x = 1;\n", "this Function has no Return"},
           {"Return\n", "no Function or Macro"},
           {"Macro a\n Call a;\nReturn\nCall a;\n", "too deeply"},
           {"Macro a\n EndFor\nReturn\nFor i In {1:1}\n Call a;\nEndFor\n", "began outside it"},
           {"l[-1] = 2;\n", "whole one from 0 on"},
           {"l[1e12] = 2;\n", "whole one from 0 on"}}) {
    const auto read = parse_geo(square + text, "f");
    ASSERT_FALSE(read.ok()) << text;
    EXPECT_THAT(read.error().message, HasSubstr(says)) << text;
  }
}

TEST(Geo, WhatIsWrongOrNotSupportedIsNamedWithLineAndColumn) {
  const std::tuple<std::string, std::string, std::string> cases[] = {
      {"Point(1) = {0, 0, 0}\nPoint(2) = {1, 0, 0};\n", "f:2:1", "';' is due here"},
      {"Point(1) = {0, 0, 1};\n", "f:1:6", "outside the plane"},
      {"Point(1) = {0, a, 0};\n", "f:1:16", "there is no variable 'a'"},
      {"h = 1;\nPoint(1) = {0, 1 / 0, 0};\n", "f:2:21", "no finite value"},
      {square + "Line(5) = {1, 9};\n", "f:6:1", "there is no point 9"},
      {square + "Circle(5) = {1, 2};\n", "f:6:1", "2 points do not make this curve"},
      {square + "Plane Surface(1) = {3};\n", "f:6:14", "there is no loop 3"},
      {square + "Physical Surface(1) = {3};\n", "f:6:10", "surface 3, which does not exist"},
      {square + "Extrude {0, 0, 1} { Line{1}; }\n", "f:6:1", "'Extrude' is not supported"},
      {square + "SetFactory(\"OpenCASCADE\");\n", "f:6:1", "OpenCASCADE"},
      {square + "For i In {1:3}\n", "f:7:1", "no EndFor"},
      {square + "If (1)\n", "f:7:1", "no EndIf"},
      {square + "EndFor\n", "f:6:1", "has no For"},
      {square + "/* no end", "f:6:1", "comment has no end"},
      {square + "Physical Line(\"a) = {1};\n", "f:6:15", "no closing quote"},
      {square + "x = 3z;\n", "f:6:6", "run into a word"},
      {square + "$\n", "f:6:1", "no meaning"},
      {square + "For i In {1:1000000}\nFor j In {1:1000000}\nEndFor\nEndFor\n", "f:7:20", "too long"},
      {"a = 1;\n", "f:2:1", "no curve"},
  };
  for (const auto& [text, place, says] : cases) {
    const auto read = parse_geo(text, "f");
    ASSERT_FALSE(read.ok()) << text;
    EXPECT_EQ(read.error().code, ErrorCode::BadFormat) << text;
    EXPECT_EQ(place_text(read.error()), place) << text;
    EXPECT_THAT(read.error().message, HasSubstr(says)) << text;
  }
  EXPECT_FALSE(parse_geo(std::string(100000, '('), "f").ok());
  EXPECT_FALSE(parse_geo("a = " + std::string(100000, '-') + "1;", "f").ok());
}

TEST(Geo, EveryGeometryOfTheCorpusIsRead) {
  const auto data = test::data_folder();
  if (!data) GTEST_SKIP() << test::no_data;
  const auto beam = read_geo(data->string() + "/contours/xfem_pmma_3holes.geo");
  ASSERT_TRUE(beam.ok()) << to_string(beam.error());
  EXPECT_EQ(beam->points.size(), 26U);
  EXPECT_EQ(beam->surfaces.size(), 3U);
  EXPECT_EQ(beam->points.at(25).size, 0.1 / 16);
  const auto holes = read_geo(data->string() + "/contours/xfem_two_holes_moes1999.geo");
  ASSERT_TRUE(holes.ok()) << to_string(holes.error());
  EXPECT_EQ(holes->surfaces.at(16).size(), 3U);
  EXPECT_THAT(holes->remarks, IsEmpty());
}

}  // namespace
}  // namespace dobra::io::drawings
