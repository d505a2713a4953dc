#include "shared/io/drawings/svg.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace dobra::io::drawings {
namespace {

using base::ErrorCode;
using geom::Point;

SvgFile parsed(const std::string& body) {
  auto read = parse_svg("<svg xmlns='http://www.w3.org/2000/svg'>" + body + "</svg>", "a.svg");
  EXPECT_TRUE(read.ok()) << (read ? "" : to_string(read.error()));
  return read ? *std::move(read) : SvgFile{};
}
SvgPath path(const std::string& data) {
  const SvgFile file = parsed("<path d=\"" + data + "\"/>");
  return file.paths.empty() ? SvgPath{} : file.paths.front();
}
base::Error error_of(const std::string& body) {
  const auto read = parse_svg("<svg>\n" + body + "</svg>", "a.svg");
  EXPECT_FALSE(read.ok());
  return read ? base::Error{} : read.error();
}
/// Ends of the pieces, y as in the file.
std::vector<Point> ends(const SvgPath& path) {
  std::vector<Point> points{path.pieces.front().from};
  for (const SvgPiece& piece : path.pieces) points.push_back(piece.to);
  for (Point& p : points) p.y = -p.y + 0.0;
  return points;
}
Point on(const SvgPiece& arc, double t) {
  const double angle = arc.start + t * arc.sweep;
  return arc.centre + std::cos(angle) * arc.u + std::sin(angle) * arc.v;
}
void expect_near(Point a, Point b, double tolerance = 1e-12) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
}

TEST(Svg, StraightCommandsAbsoluteAndRelativeGiveTheSamePath) {
  const std::vector<Point> wanted{{1, 2}, {3, 2}, {3, 5}, {0, 5}, {1, 2}};
  EXPECT_EQ(ends(path("M1 2H3V5L0,5Z")), wanted);
  EXPECT_EQ(ends(path("m1 2h2v3l-3 0z")), wanted);
  EXPECT_EQ(ends(path("M 1,2 3,2 3 5 0 5 z")), wanted) << "further pairs of M are lines";
  EXPECT_EQ(ends(path("m1 2 2 0 0 3-3 0z")), wanted) << "a sign separates numbers";
  EXPECT_TRUE(path("M1 2H3V5L0,5Z").closed);
  EXPECT_FALSE(path("M1 2H3V5").closed);
  EXPECT_EQ(ends(path("M.5.25L1.5.25")), (std::vector<Point>{{0.5, 0.25}, {1.5, 0.25}})) << "so does a second point";
}

TEST(Svg, SmoothCommandsContinueTheCurveBefore) {
  const SvgPath cubic = path("M0 0C0 1 1 1 2 0S4 -1 4 0");
  ASSERT_EQ(cubic.pieces.size(), 2U);
  expect_near(cubic.pieces[1].control[0], {3, 1});
  const SvgPath quadratic = path("M0 0Q1 3 3 0T6 0");
  ASSERT_EQ(quadratic.pieces.size(), 2U);
  // Controls of the raised cubic: two thirds of the way to the control point, (5, -3) by reflection.
  expect_near(quadratic.pieces[0].control[0], {2.0 / 3.0, -2.0});
  expect_near(quadratic.pieces[1].control[0], {3.0 + 2.0 * 2.0 / 3.0, 2.0});
  const SvgPath alone = path("M0 0S1 1 2 0");
  expect_near(alone.pieces[0].control[0], {0, 0});
}

TEST(Svg, ArcsTakeEachOfTheFourWays) {
  for (const int large : {0, 1}) {
    for (const int sweep : {0, 1}) {
      const SvgPath arc = path("M0 0A5 5 0 " + std::to_string(large) + std::to_string(sweep) + "6 0");
      ASSERT_EQ(arc.pieces.size(), 1U);
      const SvgPiece& piece = arc.pieces[0];
      expect_near(on(piece, 0.0), {0, 0});
      expect_near(on(piece, 1.0), {6, 0});
      EXPECT_NEAR(std::abs(piece.centre.y), 4.0, 1e-12);
      EXPECT_EQ(std::abs(piece.sweep) > std::numbers::pi, large == 1);
      // Sweep 1 goes clockwise as seen, above the chord from left to right if it is the short way.
      EXPECT_GT(on(piece, 0.5).y * (sweep == 1 ? 1.0 : -1.0), 0.0);
    }
  }
  const SvgPiece small = path("M0 0A1 1 0 0 1 6 0").pieces[0];
  EXPECT_NEAR(geom::length(small.u), 3.0, 1e-12) << "radii that are too small grow";
  EXPECT_EQ(path("M0 0A0 1 0 0 1 6 0").pieces[0].kind, SvgPieceKind::Line);
  const SvgPiece turned = path("M2 0A2 1 90 0 1 2 4").pieces[0];
  expect_near(on(turned, 0.5), {3, -2});
}

TEST(Svg, TransformsOfGroupsAreAppliedFromTheInsideOut) {
  const auto first = [](const std::string& transform) {
    return parsed("<g transform='" + transform + "'><path d='M1 2h1'/></g>").paths[0].pieces[0].from;
  };
  expect_near(first("translate(10 20)"), {11, -22});
  expect_near(first("translate(10) scale(2,3)"), {12, -6});
  expect_near(first("scale(2,3) translate(10,0)"), {22, -6});
  expect_near(first("rotate(90)"), {-2, -1});
  expect_near(first("rotate(90 1 2)"), {1, -2});
  expect_near(first("matrix(1 2 3 4 5 6)"), {12, -16});
  expect_near(first("skewX(45)"), {3, -2});
  expect_near(
      parsed("<g transform='scale(2)'><g transform='translate(1)'><path transform='skewY(45)' d='M1 2h1'/></g></g>")
          .paths[0]
          .pieces[0]
          .from,
      {4, -6});
}

TEST(Svg, ShapesBecomePaths) {
  const SvgFile file = parsed(
      "<rect id='r' x='1' y='2' width='3' height='4'/><circle cx='1' cy='1' r='.5'/><polygon points='0,0 1 0 "
      "1,1'/><line x2='3'/>");
  ASSERT_EQ(file.paths.size(), 4U);
  EXPECT_EQ(file.paths[0].name, "r");
  EXPECT_EQ(ends(file.paths[0]), (std::vector<Point>{{1, 2}, {4, 2}, {4, 6}, {1, 6}, {1, 2}}));
  EXPECT_TRUE(file.paths[1].closed);
  EXPECT_EQ(file.paths[1].pieces.size(), 2U);
  expect_near(on(file.paths[1].pieces[0], 0.5), {1, -1.5});
  EXPECT_TRUE(file.paths[2].closed);
  EXPECT_FALSE(file.paths[3].closed);
}

TEST(Svg, WhatIsOnlyDefinedIsLeftOutAndSaid) {
  const SvgFile file = parsed(
      "<!-- <path d='x'/> --><defs><path d='M0 0h1'/><g><path d='M0 0h1'/></g></defs><path id='a' d='M0 0h1m1 "
      "1h1'/><text>M</text><use href='#a'/>");
  ASSERT_EQ(file.paths.size(), 2U);
  EXPECT_EQ(file.paths[1].name, "a (2)");
  EXPECT_EQ(file.remarks.size(), 3U);
}

TEST(Svg, ErrorsNameTheLineAndWhatToDo) {
  const auto expect = [](const std::string& body, const std::string& part) {
    const base::Error error = error_of(body);
    EXPECT_NE(error.message.find(part), std::string::npos) << error.message;
    EXPECT_EQ(error.place->line, 2U) << body;
  };
  expect("<path d='L1 1'/>", "begins with M");
  expect("<path d='M1 1 2'/>", "a number is due");
  expect("<path d='M1 1A1 1 0 2 0 3 3'/>", "flag");
  expect("<path d='M1 1X'/>", "no path command");
  expect("<path d=M1/>", "quotes");
  expect("<g transform='turn(3)'><path d='M0 0h1'/></g>", "no transform");
  expect("<circle r='1mm'/>", "without a unit");
  expect("<rect width='1' height='1' rx='1'/>", "round corners");
  expect("<path d='M0 0h1'/></g>", "closes nothing");
  expect("<path d='M0 0h1'/><g>", "closes nothing");
  EXPECT_EQ(parse_svg("<svg><path d='M0 0h1e308h1e308'/></svg>", "a").error().code, ErrorCode::NotFinite);
  EXPECT_NE(parse_svg("<svg></svg>", "a").error().message.find("no outline"), std::string::npos);
}

TEST(Svg, WhatIsNotDisplayedIsNotThereAndSaid) {
  const std::string shown = "<path id='a' d='M0 0h9v9z'/>";
  const std::string hole = "<circle id='h' cx='5' cy='5' r='1'";
  const std::pair<std::string, std::string> hidden[] = {
      {hole + " display='none'/>", "h"},
      {hole + " style='fill:red; display : none'/>", "h"},
      {hole + " style='display:none!important;fill:red'/>", "h"},
      {hole + " visibility='hidden'/>", "h"},
      {hole + " visibility='collapse'/>", "h"},
      {"<g id='layer1' inkscape:label='Sketch' style='display:none'><g><g display='inline'>" + hole + "/></g></g></g>",
       "Sketch"},
      {"<g visibility='hidden'><g>" + hole + "/></g></g>", "<g>"},
      {"<style>/* .x */ .st0{fill:none;} .st1, .b{stroke:#000;display:none}</style>" + hole + " class='st0 st1'/>",
       "h"},
      {"<style><![CDATA[#h{visibility:hidden}]]></style>" + hole + " visibility='visible'/>", "h"},
      {"<style>circle{display:none} @media print{path{display:none}}</style>" + hole + "/>", "h"},
  };
  for (const auto& [body, by] : hidden) {
    const SvgFile file = parsed(shown + body);
    ASSERT_EQ(file.paths.size(), 1U) << body;
    EXPECT_EQ(file.paths[0].name, "a");
    ASSERT_FALSE(file.remarks.empty()) << body;
    EXPECT_EQ(file.remarks.back(), "a.svg: 1 outline that is not displayed left out (hidden: " + by + ")") << body;
  }
}

TEST(Svg, WhatIsDisplayedAllTheSameIsThere) {
  const std::string hole = "<circle id='h' cx='5' cy='5' r='1'";
  for (const std::string& body : std::vector<std::string>{
           hole + " display='inline'/>", hole + " style='display:block;visibility:visible'/>",
           "<g visibility='hidden'>" + hole + " visibility='visible'/></g>",
           "<g style='visibility:hidden'><g visibility='inherit'>" + hole + " style='visibility:visible'/></g></g>",
           "<style>circle{display:none} .c{display:inline}</style>" + hole + " class='c'/>",
           "<style>.c{display:none}</style>" + hole + " class='c' style='display:inline'/>",
           "<style>g circle{display:none}</style>" + hole + "/>", hole + " opacity='0' style='fill:none'/>"}) {
    EXPECT_EQ(parsed(body).paths.size(), 1U) << body;
  }
  // What is wrong in what is not displayed is no fault; and a file of nothing else holds nothing.
  EXPECT_EQ(parsed(hole + "/><g display='none'><path d='x'/><rect rx='1'/></g>").paths.size(), 1U);
  EXPECT_NE(error_of("<g display='none'>" + hole + "/></g>").message.find("no outline of the file is displayed"),
            std::string::npos);
}

TEST(Svg, DeepFilesAndDeclaredEntitiesAreRefused) {
  std::string deep;
  for (int i = 0; i < 100'000; ++i) deep += "<g>";
  deep += "<path d='M0 0h1'/>";
  for (int i = 0; i < 100'000; ++i) deep += "</g>";
  EXPECT_NE(error_of(deep).message.find("nested too deeply"), std::string::npos);
  const auto bomb = parse_svg("<!DOCTYPE svg [<!ENTITY a 'M0 0'><!ENTITY b '&a;&a;'>]><svg><path d='&b;'/></svg>", "a");
  ASSERT_FALSE(bomb.ok());
  EXPECT_NE(bomb.error().message.find("begins with M"), std::string::npos) << bomb.error().message;
}

}  // namespace
}  // namespace dobra::io::drawings
