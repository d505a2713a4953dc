#include "shared/io/brep/brep.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "shared/io/brep/faces.h"

namespace dobra::io::brep {
namespace {

using geom::Point3;

/// A file of these tables, each with its keyword.
struct Text {
  std::string header = "\nCASCADE Topology V1, (c) Matra-Datavision\n";
  std::string locations = "Locations 0\n";
  std::string chart_curves = "Curve2ds 0\n";
  std::string curves = "Curves 0\n";
  std::string polygons = "Polygon3D 0\nPolygonOnTriangulations 0\n";
  std::string surfaces = "Surfaces 0\n";
  std::string triangulations = "Triangulations 0\n";
  std::string shapes = "TShapes 1\nCo\n\n1100000\n*\n\n+1 0 ";
  [[nodiscard]] std::string all() const {
    return header + locations + chart_curves + curves + polygons + surfaces + triangulations + "\n" + shapes;
  }
};

/// The unit square on a plane, its face looking against the normal of the surface and moved twice.
Text square() {
  Text text;
  text.header = "DBRep_DrawableShape\n" + text.header;
  text.locations =
      "Locations 3\n"
      "1\n 1 0 0 10\n 0 1 0 0\n 0 0 1 0\n"  // along x
      "1\n 0 -1 0 0\n 1 0 0 0\n 0 0 1 0\n"  // a quarter turn about z
      "2  1 1 2 1 0 \n";                    // the first, then the second
  text.chart_curves = "Curve2ds 4\n1 0 0 1 0 \n1 1 0 0 1 \n1 0 1 1 0 \n1 0 0 0 1 \n";
  text.curves = "Curves 4\n1 0 0 0 1 0 0 \n1 1 0 0 0 1 0 \n1 0 1 0 1 0 0 \n1 0 0 0 0 1 0 \n";
  text.surfaces = "Surfaces 1\n1 0 0 0 0 0 1 1 0 -0 -0 1 0 \n";
  const auto vertex = [](int x, int y) { return fmt::format("Ve\n1e-07\n{} {} 0\n0 0\n\n0101101\n*\n", x, y); };
  const auto edge = [](int number, int from, int to) {
    return fmt::format("Ed\n 1e-07 1 1 0\n1  {0} 0 0 1\n2  {0} 1 0 0 1\n0\n\n0101000\n+{1} 0 -{2} 0 *\n", number, from,
                       to);
  };
  // Numbered from the last: vertices 11 10 9 8, edges 7 6 5 4, wire 3, face 2, compound 1.
  text.shapes = "TShapes 11\n" + vertex(0, 0) + vertex(1, 0) + vertex(1, 1) + vertex(0, 1) + edge(1, 11, 10) +
                edge(2, 10, 9) + edge(3, 8, 9) + edge(4, 11, 8) +
                "Wi\n\n0101100\n+7 0 +6 0 -5 0 -4 0 *\n"
                "Fa\n0  1e-07 1 0\n\n0111000\n+3 0 *\n"
                "Co\n\n1100000\n-2 3 *\n\n+1 0 ";
  return text;
}

Model parsed(const Text& text) {
  auto model = parse_brep(text.all(), "a.brep");
  EXPECT_TRUE(model.ok()) << base::to_string(model.error());
  return model ? *std::move(model) : Model{};
}
std::string refusal(const Text& text) {
  const auto model = parse_brep(text.all(), "a.brep");
  return model ? "" : base::to_string(model.error());
}

TEST(Brep, ASquareHasOneFaceWithItsLoopAndItsPlace) {
  const Model model = parsed(square());
  EXPECT_EQ(model.version, 1);
  const auto faces = faces_of(model);
  ASSERT_TRUE(faces.ok()) << base::to_string(faces.error());
  ASSERT_EQ(faces->size(), 1U);
  const TrimmedFace& face = faces->front();
  EXPECT_TRUE(face.reversed);
  EXPECT_EQ(face.place.item, "face 1");
  // First along x, then turned: (0, 0, 0) comes to (0, 10, 0), (1, 0, 0) to (0, 11, 0).
  EXPECT_EQ(face.placement.of(Point3{}), (Point3{0, 10, 0}));
  EXPECT_EQ(face.placement.of(Point3{1, 0, 0}), (Point3{0, 11, 0}));
  ASSERT_EQ(face.loops.size(), 1U);
  // The loop closes in the chart, anticlockwise: its area by the shoelace is 1.
  double area = 0.0;
  Point3 last{};
  for (const LoopEdge& edge : face.loops[0]) {
    ASSERT_TRUE(edge.chart.has_value());
    const Line& line = std::get<Line>(model.chart_curves[edge.chart->curve]->is);
    Point3 from = line.at + edge.chart->from * line.along, to = line.at + edge.chart->to * line.along;
    if (edge.orientation == Orientation::Reversed) std::swap(from, to);
    EXPECT_EQ(from, last);
    area += (from.x * to.y - to.x * from.y) / 2.0;
    last = to;
  }
  EXPECT_EQ(last, Point3{});
  EXPECT_DOUBLE_EQ(area, 1.0);
}

/// A cylinder of radius 2: its seam is one edge that bounds the face on both sides.
Text cylinder(int version) {
  Text text;
  text.header =
      fmt::format("CASCADE Topology V{}, (c) {}\n", version, version == 3 ? "Open Cascade" : "Matra-Datavision");
  text.chart_curves = "Curve2ds 4\n1 6.2831853071795862 0 0 1 \n1 0 0 0 1 \n1 0 5 1 0 \n1 0 0 1 0 \n";
  text.curves = "Curves 3\n1 2 0 0 0 0 1 \n2 0 0 5 0 0 1 1 0 -0 -0 1 0 2\n2 0 0 0 0 0 1 1 0 -0 -0 1 0 2\n";
  text.surfaces = "Surfaces 1\n2 0 0 0 0 0 1 1 0 -0 -0 1 0 2\n";
  const std::string ends = version == 2 ? "0 0 1 1\n" : "";
  const std::string normals = version == 3 ? "1 " : "";
  text.polygons = "Polygon3D 1\n2 1\n0.1\n0 0 0 1 0 0 \n0 1 \nPolygonOnTriangulations 1\n2 1 2 \np 0.1 1 0 1 \n";
  text.triangulations = "Triangulations 1\n3 1 1 " + normals + "0.1\n0 0 0 1 0 0 0 1 0 0 0 1 0 0 1 1 2 3 " +
                        (version == 3 ? "0 0 1 0 0 1 0 0 1 " : "") + "\n";
  const std::string turn = " 0 6.2831853071795862\n";
  text.shapes =
      "TShapes 8\n"
      "Ve\n1e-07\n2 0 5\n0 0\n\n0101101\n*\n"
      "Ve\n1e-07\n2 0 0\n0.5 1 1 0\n1 2 1 1 0\n0 3 1 1 0\n0 0\n\n0101101\n*\n"
      "Ed\n 1e-07 1 1 0\n1  1 0 0 5\n3  1 2CN 1 0 0 5\n" +
      ends +
      "0\n\n0101000\n+7 0 -8 0 *\n"
      "Ed\n 1e-07 1 1 0\n1  2 0" +
      turn + "2  3 1 0" + turn + ends +
      "4  C0 1 0 1 0\n5 1 0\n6  1 1 0\n0\n\n0101100\n+8 0 -8 0 *\n"
      "Ed\n 1e-07 1 1 0\n1  3 0" +
      turn + "2  4 1 0" + turn + ends +
      "7 1 1 1 0\n0\n\n0101100\n+7 0 -7 0 *\n"
      "Wi\n\n0101100\n-6 0 -5 0 +6 0 +4 0 *\n"
      "Fa\n0  1e-07 1 0\n2  1\n0101000\n+3 0 *\n"
      "Sh\n\n0101000\n+2 0 *\n\n+1 0 ";
  return text;
}

TEST(Brep, TheSeamOfACylinderHasACurveOnEachSideInEveryVersion) {
  for (const int version : {1, 2, 3}) {
    const Model model = parsed(cylinder(version));
    EXPECT_EQ(model.version, version);
    EXPECT_EQ(model.triangulations, 1U);
    const auto faces = faces_of(model);
    ASSERT_TRUE(faces.ok()) << version << base::to_string(faces.error());
    const auto& loop = faces->at(0).loops.at(0);
    ASSERT_EQ(loop.size(), 4U);
    EXPECT_EQ(loop[0].edge, loop[2].edge);
    EXPECT_EQ(loop[0].orientation, Orientation::Reversed);
    EXPECT_EQ(loop[0].chart->curve, 1U);  // u = 0
    EXPECT_EQ(loop[2].chart->curve, 0U);  // u = 2 pi
  }
}

TEST(Brep, OrientationsAreComposed) {
  using enum Orientation;
  EXPECT_EQ(Reversed * Reversed, Forward);
  EXPECT_EQ(Forward * Internal, Internal);
  EXPECT_EQ(Reversed * External, External);
  EXPECT_EQ(Internal * Reversed, Internal);
}

TEST(Brep, PlacementsAreUndoneByTheirInverse) {
  const Placement turned{
      {0.0, 2.0, 0.0}, {-2.0, 0.0, 0.0}, {0.0, 0.0, -2.0}, {5.0, -3.0, 1.0}};  // and scaled, mirrored
  const Placement nothing = turned.inverse() * turned;
  for (const Point3 p : {Point3{}, Point3{1, 2, 3}, Point3{-4, 0.5, 7}})
    EXPECT_NEAR(distance(nothing.of(p), p), 0.0, 1e-14);
  Text text = square();
  text.locations = "Locations 2\n1\n 0 -1 0 4\n 1 0 0 0\n 0 0 1 0\n2  1 -1 1 2 0 \n";
  text.shapes.replace(text.shapes.find("-2 3 *"), 6, "+2 2 *");
  const auto faces = faces_of(parsed(text));
  ASSERT_TRUE(faces.ok());
  // Back once and forth twice is once: a quarter turn and 4 along x.
  EXPECT_NEAR(distance(faces->at(0).placement.of(Point3{1, 0, 0}), Point3{4, 1, 0}), 0.0, 1e-14);
}

/// The value at t by de Boor's triangle, in homogeneous coordinates.
Point3 de_boor(const Spline& spline, double t) {
  const std::size_t p = spline.degree;
  std::size_t k = p;
  while (k + 1 < spline.points.size() && spline.knots[k + 1] <= t) ++k;
  std::vector<std::array<double, 4>> d;
  for (std::size_t j = k - p; j <= k; ++j) {
    const double w = spline.weights.empty() ? 1.0 : spline.weights[j];
    d.push_back({spline.points[j].x * w, spline.points[j].y * w, spline.points[j].z * w, w});
  }
  for (std::size_t r = 1; r <= p; ++r) {
    for (std::size_t j = p; j >= r; --j) {
      const double low = spline.knots[j + k - p], high = spline.knots[j + 1 + k - r];
      const double a = (t - low) / (high - low);
      for (std::size_t c = 0; c < 4; ++c) d[j][c] = (1.0 - a) * d[j - 1][c] + a * d[j][c];
    }
  }
  return {d[p][0] / d[p][3], d[p][1] / d[p][3], d[p][2] / d[p][3]};
}

/// The circle as a periodic rational spline of degree 2: the corners of a triangle
/// round it with weight 1/2, between them the points where it touches with weight 1; knots of multiplicity 2.
TEST(Brep, APeriodicCircleIsWrittenOutAsACircle) {
  Text text;
  const double a = std::sqrt(3.0);
  text.curves = fmt::format(
      "Curves 1\n7 1 1  2 6 4  {0} 0.5 0 1  0 2 0 0.5  {1} 0.5 0 1  {2} -1 0 0.5  0 -1 0 1  {3} -1 0 0.5 \n 0 2 1 2 2 "
      "2 3 2\n",
      a / 2.0, -a / 2.0, -a, a);
  const Model model = parsed(text);
  const Spline& spline = std::get<Spline>(model.curves.at(0)->is);
  ASSERT_EQ(spline.knots.size(), spline.points.size() + spline.degree + 1);
  EXPECT_EQ(spline.weights.size(), spline.points.size());
  for (int i = 0; i <= 300; ++i) {
    const Point3 at = de_boor(spline, std::min(i / 100.0, 3.0 - 1e-12));
    EXPECT_NEAR(std::hypot(at.x, at.y), 1.0, 1e-12) << i;
  }
}

/// A cubic with simple periodic knots: what it is after a period, with all derivatives, is what it was.
TEST(Brep, APeriodicSplineGoesOnBeyondItsEnds) {
  Text text;
  text.curves = "Curves 1\n7 0 1  3 5 6  0 0 0  1 0 0  2 1 0  1 3 1  -1 1 0 \n 0 1 1 1 2.5 1 3 1 4 1 5 1\n";
  const Spline spline = std::get<Spline>(parsed(text).curves.at(0)->is);
  ASSERT_EQ(spline.points.size(), 8U);
  ASSERT_EQ(spline.knots.size(), 12U);
  for (std::size_t i = 1; i < spline.knots.size(); ++i) EXPECT_GT(spline.knots[i], spline.knots[i - 1]);
  EXPECT_EQ(spline.knots[3], 0.0);
  EXPECT_EQ(spline.knots[8], 5.0);
  for (std::size_t i = 0; i + 5 < spline.knots.size(); ++i)
    EXPECT_DOUBLE_EQ(spline.knots[i + 5], spline.knots[i] + 5.0);
  for (const double h : {0.0, 1e-3, 2e-3}) {
    const Point3 behind = de_boor(spline, h);
    // The last piece beyond the end is another cubic than the first, of which value, slope and bend are the same.
    const Point3 beyond = de_boor(spline, 5.0 + h);
    EXPECT_NEAR(distance(behind, beyond), 0.0, h == 0.0 ? 1e-15 : 2e-8 * h * 1e3) << h;
  }
}

TEST(Brep, EveryKindOfCurveAndSurfaceIsRead) {
  Text text;
  text.chart_curves =
      "Curve2ds 9\n1 0 0 1 0 \n2 0 0 1 0 0 1 2\n3 0 0 1 0 0 1 3 2\n4 0 0 1 0 0 1 0.5\n5 0 0 1 0 0 1 3 2\n"
      "6 1 2  0 0 1  1 1 2  2 0 1 \n7 0 0  1 2 2  0 0  1 1 \n 0 2 1 2\n8 0 1\n1 0 0 1 0 \n9 0.25\n8 0 1\n1 0 0 1 0 \n";
  text.curves =
      "Curves 9\n1 0 0 0 1 0 0 \n2 0 0 0 0 0 1 1 0 0 0 1 0 2\n3 0 0 0 0 0 1 1 0 0 0 1 0 3 2\n"
      "4 0 0 0 0 0 1 1 0 0 0 1 0 0.5\n5 0 0 0 0 0 1 1 0 0 0 1 0 3 2\n6 0 1  0 0 0  1 1 1 \n"
      "7 1 0  1 2 2  0 0 0 1  1 1 1 2 \n 0 2 1 2\n8 0 1\n1 0 0 0 1 0 0 \n9 0.25\n0 0 1 \n1 0 0 0 1 0 0 \n";
  const std::string frame = " 0 0 0 0 0 1 1 0 0 0 1 0 ";
  text.surfaces = "Surfaces 11\n1" + frame + "\n2" + frame + "2\n3" + frame + "2\n0.5\n4" + frame + "2\n5" + frame +
                  "3 1\n6 0 0 1 \n1 0 0 0 1 0 0 \n7 0 0 0 0 0 1 \n1 1 0 0 0 0 1 \n"
                  "8 0 0 1 1 0 0 0  0 1 0 \n1 0 0  1 1 1 \n"
                  "9 0 1 0 1 1 2 2 3 2 4 0 0 0 1  0 1 0 2  0 2 0 1 \n1 0 0 1  1 1 1 2  1 2 0 1 \n\n0 2\n1 2\n\n0 1\n1 "
                  "1\n2 1\n3 1\n\n"
                  "10 0 1 2 3\n1" +
                  frame + "\n11 0.5\n2" + frame + "2\n";
  const Model model = parsed(text);
  for (std::size_t i = 0; i < 9; ++i) {
    constexpr std::array<std::size_t, 9> kinds{0, 1, 1, 1, 1, 2, 2, 3, 4};
    EXPECT_EQ(model.chart_curves.at(i)->is.index(), kinds[i]) << i;
    EXPECT_EQ(model.curves.at(i)->is.index(), kinds[i]) << i;
  }
  EXPECT_EQ(std::get<Conic>(model.curves[2]->is).b, 2.0);
  EXPECT_EQ(std::get<Spline>(model.chart_curves[5]->is).weights, (std::vector<double>{1.0, 2.0, 1.0}));
  EXPECT_EQ(std::get<OffsetCurve>(model.chart_curves[8]->is).distance, 0.25);
  EXPECT_TRUE(std::holds_alternative<TrimmedCurve>(std::get<OffsetCurve>(model.chart_curves[8]->is).of->is));
  EXPECT_EQ(std::get<Elementary>(model.surfaces[2]->is).other, 0.5);
  const auto& patch = std::get<SplinePatch>(model.surfaces[8]->is);
  EXPECT_EQ(patch.knots_u.size(), 4U);
  EXPECT_EQ(patch.points.size(), 2U * 5U);  // periodic along v, degree 2: three control points, two of them once more
  EXPECT_EQ(patch.points[3], patch.points[0]);
  EXPECT_EQ(patch.points[4], patch.points[1]);
  EXPECT_EQ(patch.points[7], (Point3{1, 2, 0}));
  EXPECT_EQ(patch.knots_v.size(), 4U + 2U + 2U);
  const auto& trimmed = std::get<TrimmedPatch>(model.surfaces[9]->is);
  EXPECT_EQ(trimmed.low, (geom::Point{0.0, 2.0}));
  EXPECT_EQ(trimmed.high, (geom::Point{1.0, 3.0}));
  EXPECT_EQ(std::get<OffsetPatch>(model.surfaces[10]->is).distance, 0.5);
}

TEST(Brep, WhatIsWrongIsToldWithItsPlace) {
  /// What is said of the square with `old` replaced by `now`, `skip` bytes behind whose begin the offending word
  /// stands.
  const auto expect = [](std::string Text::*table, const std::string& old, const std::string& now, std::size_t skip,
                         const std::string& message) {
    Text text = square();
    std::string& where = text.*table;
    const std::size_t at = old.empty() ? 0 : where.find(old);
    ASSERT_NE(at, std::string::npos) << old;
    where.replace(at, old.empty() ? where.size() : old.size(), now);
    const std::string all = text.all();
    const std::size_t word = all.find(now) + skip;
    const auto line = std::count(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(word), '\n') + 1;
    const std::size_t column = word - (all.rfind('\n', word) + 1) + 1;
    EXPECT_EQ(refusal(text), fmt::format("a.brep:{}:{}: {}", line, column, message)) << now;
  };
  expect(&Text::header, "", "ISO-10303-21;\nHEADER;\n", 0,
         "this is no OCCT text file but STEP or XML; save it as text .brep");
  expect(&Text::header, "", "Open CASCADE Topology V4 (c)\n", 0,
         "this is a binary .brep file; save it in OCCT's text format");
  expect(&Text::header, "", "CASCADE Topology V4, (c) Open Cascade\n", 17,
         "version 'V4,' of the format is not known; V1 to V3 are");
  expect(&Text::surfaces, "Surfaces 1", "Surfaces 900000000", 9,
         "the number of surfaces is 900000000, for which the rest of the file is too short");
  expect(&Text::surfaces, "1 0 0 0 0 0 1", "12 0 0 0 0 0 1", 0, "the kind of a surface is 12; it can be 1 to 11");
  expect(&Text::curves, "1 0 0 0 1 0 0", "1 0 0 nan 1 0 0", 6,
         "a point of a line 'nan' is not finite; correct or remove it");
  expect(&Text::shapes, "1  2 0 0 1", "1  7 0 0 1", 3, "there is no curve 7; the file has 4");
  expect(&Text::shapes, "1  2 0 0 1", "1  2 0 1 1", 9, "an edge runs from 1 to 1 of its curve; it must run forward");
  expect(&Text::shapes, "+3 0 *", "+2 0 *", 0, "shape 2 is not among the 9 before this place");
  expect(&Text::shapes, "-5 0 -4 0 *", "*5 0 -4 0 *", 0,
         "'*5' stands where a shape belongs: +, -, i or e and its number");
  expect(&Text::shapes, "-5 0 -4 0 *", "-5 0 -4x 0 *", 5,
         "'-4x' stands where a shape belongs: +, -, i or e and its number");
  expect(&Text::shapes, "+11 0 -10 0", "+11 0 -10 4", 10, "there is no location 4; the file has 3");
  expect(&Text::shapes, "0101000\n+11 0 -10 0", "0101000\n+11 0 +7 0", 14,
         "shape 7 is not among the 4 before this place");
  expect(&Text::shapes, "0101000\n+8 0", "0101000\n+7 0", 11, "a shape of kind Ed cannot be a part of one of kind Ed");
  expect(&Text::locations, "1 0 0 10\n 0 1 0 0\n 0 0 1 0", "0 0 0 10\n 0 1 0 0\n 0 0 1 0", 25,
         "location 1 makes things flat or endless");
  expect(&Text::curves, "", "Curves 1\n7 0 0  1 3 3  0 0 0  1 0 0  2 0 0 \n 0 2 0 1 1 2\n", 49,
         "knot 2 of 3 is 0, not above the one before, 0");
  expect(&Text::curves, "", "Curves 1\n7 0 0  1 3 2  0 0 0  1 0 0  2 0 0 \n 0 2 1 2\n", 51,
         "4 knots, counted as often as they stand, do not fit 3 control points and degree 1");
  expect(&Text::curves, "", "Curves 1\n7 1 0  1 2 2  0 0 0 1  1 0 0 0 \n 0 2 1 2\n", 38,
         "a weight is 0; it must be positive");
  Text deep = square();
  deep.curves = "Curves 1\n";
  for (int i = 0; i < 1000; ++i) deep.curves += "8 0 1\n";
  EXPECT_NE((deep.curves += "1 0 0 0 1 0 0\n", refusal(deep)).find("more than 32 deep"), std::string::npos);
}

TEST(Brep, FilesWithoutFacesAndFacesWithoutSurfacesAreRefused) {
  Text alone = square();
  alone.shapes.replace(alone.shapes.find("-2 3 *"), 6, "+4 0 *");
  auto faces = faces_of(parsed(alone));
  ASSERT_FALSE(faces.ok());
  EXPECT_EQ(base::to_string(faces.error()), "a.brep: the file has no face, only curves or points; save faces with it");
  Text bare = cylinder(1);
  bare.shapes.replace(bare.shapes.find("Fa\n0  1e-07 1 0\n2  1"), 20, "Fa\n0  1e-07 0 0\n2  1");
  faces = faces_of(parsed(bare));
  ASSERT_FALSE(faces.ok());
  EXPECT_NE(base::to_string(faces.error()).find("face 1: this face has no surface, only triangles"), std::string::npos);
}

TEST(Brep, ShapesThatDoubleAtEachLevelAreCountedNotFollowed) {
  Text text;
  std::string shapes = "TShapes 42\nFa\n0  1e-07 1 0\n\n0111000\n*\n";
  text.surfaces = "Surfaces 1\n1 0 0 0 0 0 1 1 0 0 0 1 0 \n";
  for (int i = 41; i >= 1; --i) shapes += fmt::format("Co\n\n1100000\n+{0} 0 +{0} 0 *\n", i + 1);
  text.shapes = shapes + "\n+1 0 ";
  const auto faces = faces_of(parsed(text));
  ASSERT_FALSE(faces.ok());
  EXPECT_EQ(faces.error().code, base::ErrorCode::TooManyElements);
}

/// Cut anywhere, and with any word replaced: refused with a place, or read; never more.
TEST(Brep, DamagedFilesAreRefusedOrRead) {
  for (const int version : {1, 2, 3}) {
    const std::string text = cylinder(version).all();
    for (std::size_t end = 0; end + 1 < text.size(); ++end) {
      const auto model = parse_brep(text.substr(0, end), "a.brep");
      if (end + 6 >= text.size()) continue;  // of the last word only its end is missing
      ASSERT_FALSE(model.ok()) << end;
      ASSERT_TRUE(model.error().place.has_value()) << end;
    }
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t begin = text.find_first_not_of(" \n", at);
      if (begin == std::string::npos) break;
      const std::size_t end = std::min(text.find_first_of(" \n", begin), text.size());
      for (const char* word : {"x", "-1", "0", "2", "999999999", "1e308", "*", "+1"}) {
        std::string damaged = text;
        damaged.replace(begin, end - begin, word);
        const auto model = parse_brep(damaged, "a.brep");
        if (model) {
          (void)faces_of(*model);
          continue;
        }
        ASSERT_GT(model.error().place.value_or(base::Place{}).line, 0U) << damaged.substr(begin, 20);
      }
      at = end;
    }
  }
}

}  // namespace
}  // namespace dobra::io::brep
