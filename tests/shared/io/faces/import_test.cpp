#include "shared/io/faces/import.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "shared/io/faces/geometry.h"
#include "shared/surf/trim/area.h"
#include "tests/support/brep_writer.h"

namespace dobra::io::faces {
namespace {

using geom::Point;
using geom::Point3;
using support::ball;
using support::Carrier;
using support::DraftFace;
using support::flat;
using support::tube;

constexpr double pi = std::numbers::pi;

Imported import_of(const DraftFace& draft) {
  const auto model = brep::parse_brep(brep_text(draft), "draft.brep");
  EXPECT_TRUE(model.ok()) << base::to_string(model.error());
  if (!model) return {};
  auto made = faces_of_model(*model);
  EXPECT_TRUE(made.ok()) << base::to_string(made.error());
  return made ? *std::move(made) : Imported{};
}
std::set<std::string> codes_of(const Imported& made) {
  std::set<std::string> codes;
  for (const surf::mesh::Finding& finding : made.findings) codes.insert(finding.code);
  return codes;
}
using Codes = std::set<std::string>;

const std::vector<Point> unit{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
const std::vector<Point> small_hole{{0.4, 0.4}, {0.4, 0.6}, {0.6, 0.6}, {0.6, 0.4}};

double area_of_first(const Imported& made) {
  EXPECT_EQ(made.faces.size(), 1U) << (made.findings.empty() ? "" : made.findings.back().message);
  return made.faces.empty() ? 0.0 : surf::trim::area(made.faces[0]).value;
}

TEST(ImportOfFaces, AMirrorKeepsWhatIsOutside) {
  for (const bool reversed : {false, true}) {
    for (const bool mirrored : {false, true}) {
      DraftFace draft{tube(2.0)};
      add_wire(draft, {{0.2, 0}, {1.2, 0}, {1.2, 1}, {0.2, 1}});
      draft.reversed = reversed;
      if (mirrored) draft.placement[0] = -1.0;
      const Imported made = import_of(draft);
      ASSERT_EQ(made.faces.size(), 1U);
      const surf::trim::TrimmedSurface& face = made.faces[0];
      // The normal that the face looks along is the mirrored one of the face as it was: away from the axis, or to it.
      const surf::Jet jet = face.surface.jet({0.7, 0.5});
      const double out =
          dot(cross(jet.u, jet.v), geom::Vector3{jet.at.x, jet.at.y, 0.0}) * (face.reversed ? -1.0 : 1.0);
      EXPECT_EQ(out > 0.0, !reversed) << reversed << mirrored;
      EXPECT_NEAR(jet.at.x, (mirrored ? -2.0 : 2.0) * std::cos(0.7), 1e-14);
      EXPECT_TRUE(made.findings.empty());
    }
  }
}

TEST(ImportOfFaces, AScaledPlacementScalesAreasAndTolerances) {
  DraftFace draft{ball(1.0)};
  add_wire(draft, {{0.2, 0}, {1.2, 0}, {1.2, 1}, {0.2, 1}});
  for (const std::size_t i : {0U, 5U, 10U}) draft.placement[i] = 1000.0;
  const Imported made = import_of(draft);
  EXPECT_NEAR(area_of_first(made), 1e6 * std::sin(1.0), 1e-2);
  EXPECT_NEAR(made.faces[0].loops[0].edges[0].tolerance, 1e-4, 5e-5);
}

TEST(ImportOfFaces, TheChartOfAPeriodicSurfaceIsThePartThatTheLoopsUse) {
  DraftFace draft{tube(1.0)};
  add_wire(draft, {{6.0, 0}, {7.0, 0}, {7.0, 1}, {6.0, 1}});  // over u = 2 pi
  const Imported made = import_of(draft);
  EXPECT_NEAR(area_of_first(made), 1.0, 1e-9);
  const geom::Box& chart = made.faces[0].surface.chart();
  EXPECT_NEAR(chart.low.x, 5.95, 1e-12);
  EXPECT_NEAR(chart.high.x, 7.05, 1e-12);
}

TEST(ImportOfFaces, AThreadGoesRoundSeveralTimes) {
  DraftFace draft{tube(1.0)};
  const double pitch = 0.1, end = 7.0 * pi;
  add_wire(draft, {{0, 0}, {end, pitch * end}, {end, pitch * end + 0.2}, {0, 0.2}});
  EXPECT_NEAR(area_of_first(import_of(draft)), 0.2 * end, 1e-8);
}

TEST(ImportOfFaces, WithoutLoopsASphereIsWholeAndAPatchHasItsOwnSides) {
  DraftFace sphere{ball(2.0)};
  Imported made = import_of(sphere);
  EXPECT_NEAR(area_of_first(made), 16.0 * pi, 1e-9);
  EXPECT_EQ(codes_of(made), Codes{"natural_bounds"});
  // Two sides are points, the other two are one curve.
  ASSERT_EQ(made.faces[0].loops[0].edges.size(), 4U);
  std::multiset<bool> shared;
  for (const surf::trim::ChartEdge& edge : made.faces[0].loops[0].edges) shared.insert(edge.shared.has_value());
  EXPECT_EQ(shared.count(true), 2U);
  DraftFace patch{
      support::patch_carrier({1, 1, {0, 0, 1, 1}, {0, 0, 1, 1}, 2, 2, {{0, 0, 0}, {0, 2, 0}, {3, 0, 0}, {3, 2, 0}}})};
  made = import_of(patch);
  EXPECT_NEAR(area_of_first(made), 6.0, 1e-12);
  EXPECT_EQ(codes_of(made), Codes{"natural_bounds"});
}

TEST(ImportOfFaces, ASphereWithAHoleOverItsSeamIsCutBesideTheHole) {
  DraftFace draft{ball(1.0)};
  add_wire(draft, {{-0.3, -0.2}, {-0.3, 0.2}, {0.3, 0.2}, {0.3, -0.2}});  // clockwise
  const Imported made = import_of(draft);
  EXPECT_NEAR(area_of_first(made), 4.0 * pi - 0.6 * 2.0 * std::sin(0.2), 1e-8);
  EXPECT_TRUE(codes_of(made).contains("natural_bounds"));
}

TEST(ImportOfFaces, EdgesInsideAreLines) {
  DraftFace draft{flat()};
  add_wire(draft, unit);
  const std::size_t a = draft.add_vertex({0.2, 0.5}), b = draft.add_vertex({0.8, 0.6});
  draft.wires[0].push_back({draft.add_edge({support::line_path({0.2, 0.5}, {0.8, 0.6}), std::nullopt, a, b}), 'i'});
  const Imported made = import_of(draft);
  EXPECT_NEAR(area_of_first(made), 1.0, 1e-12);
  ASSERT_EQ(made.faces[0].lines.size(), 1U);
  EXPECT_EQ(made.faces[0].lines[0].edges[0].start(), (Point{0.2, 0.5}));
  EXPECT_TRUE(made.faces[0].lines[0].edges[0].shared.has_value());
  EXPECT_TRUE(made.findings.empty());
}

/// A bridge from the outer loop to a hole, in one wire: two loops and a line.
TEST(ImportOfFaces, AnEdgeThatIsPassedBothWaysIsALine) {
  DraftFace draft{flat()};
  add_wire(draft, unit);
  add_wire(draft, small_hole);
  const std::size_t bridge = draft.add_edge({support::line_path({0, 0}, {0.4, 0.4}), std::nullopt, 0, 4});
  std::vector<DraftFace::Use> wire{{bridge, '+'}};
  wire.insert(wire.end(), draft.wires[1].begin(), draft.wires[1].end());
  wire.push_back({bridge, '-'});
  wire.insert(wire.end(), draft.wires[0].begin(), draft.wires[0].end());
  draft.wires = {wire};
  const Imported made = import_of(draft);
  EXPECT_NEAR(area_of_first(made), 1.0 - 0.04, 1e-12);
  EXPECT_EQ(made.faces[0].loops.size(), 2U);
  EXPECT_EQ(made.faces[0].lines.size(), 1U);
  EXPECT_TRUE(codes_of(made).contains("edge_twice"));
}

TEST(ImportOfFaces, AnEdgeThatStandsTwiceIsTakenOnce) {
  DraftFace draft{flat()};
  add_wire(draft, unit);
  draft.wires[0].insert(draft.wires[0].begin() + 1, draft.wires[0][1]);
  const Imported made = import_of(draft);
  EXPECT_NEAR(area_of_first(made), 1.0, 1e-12);
  EXPECT_EQ(codes_of(made), Codes{"edge_twice"});
}

TEST(ImportOfFaces, AnEdgeThatRunsAgainstTheOthersIsTurned) {
  DraftFace draft{flat()};
  add_wire(draft, unit);
  draft.wires[0][2].sign = '-';
  const Imported made = import_of(draft);
  EXPECT_NEAR(area_of_first(made), 1.0, 1e-12);
  EXPECT_TRUE(codes_of(made).contains("edge_turned"));
}

TEST(ImportOfFaces, AHoleAPeriodOffComesIntoTheLoop) {
  DraftFace draft{tube(1.0)};
  add_wire(draft, unit);
  std::vector<Point> hole = small_hole;
  for (Point& p : hole) p.x -= 2.0 * pi;
  add_wire(draft, hole);
  EXPECT_NEAR(area_of_first(import_of(draft)), 0.96, 1e-9);
}

TEST(ImportOfFaces, CurvesInSpaceAloneAreProjectedToRoundSurfacesToo) {
  for (const Carrier& carrier : {tube(1.0), ball(1.0)}) {
    DraftFace draft{carrier};
    add_wire(draft, {{2.7, 0.1}, {3.7, 0.2}, {3.6, 0.9}, {2.8, 0.8}});  // over u = pi, where angles jump
    for (DraftFace::Edge& edge : draft.edges) edge.chart = false;
    DraftFace drawn = draft;
    for (DraftFace::Edge& edge : drawn.edges) edge.chart = true;
    const Imported made = import_of(draft);
    const double wanted = area_of_first(import_of(drawn));
    EXPECT_NEAR(area_of_first(made), wanted, 1e-6 * wanted);
    EXPECT_TRUE(codes_of(made).contains("curve_projected"));
  }
}

TEST(ImportOfFaces, FacesOnHalfOfASpindleTorusComeOut) {
  const double major = 0.5, minor = 1.0;
  DraftFace draft{{"5 0 0 0 0 0 1 1 0 0 0 1 0 0.5 1\n", [=](Point p) {
                     const double r = major + minor * std::cos(p.y);
                     return Point3{r * std::cos(p.x), r * std::sin(p.x), minor * std::sin(p.y)};
                   }}};
  add_wire(draft, {{0.5, -1.0}, {1.5, -1.0}, {1.5, 1.5}, {0.5, 1.5}});
  EXPECT_NEAR(area_of_first(import_of(draft)), major * 2.5 + std::sin(1.5) + std::sin(1.0), 1e-8);
}

/// Every kind of surface that holds others, on the same quarter of a tube of radius 2 about z, 0 <= z <= 1.
TEST(ImportOfFaces, KindsOfSurfacesThatAreTheSameTubeHaveTheSameArea) {
  const std::string circle = "2 0 0 0 0 0 1 1 0 0 0 1 0 2\n";
  const auto round = [](Point p) { return Point3{2.0 * std::cos(p.x), 2.0 * std::sin(p.x), p.y}; };
  const std::string inner = "2 0 0 0 0 0 1 1 0 0 0 1 0 1.5\n";
  const std::vector<std::pair<const char*, std::string>> kinds{
      {"cylinder", "2 0 0 0 0 0 1 1 0 0 0 1 0 2\n"},
      {"extrusion", "6 0 0 1\n" + circle},
      {"revolution", "7 0 0 0 0 0 1\n1 2 0 0 0 0 1\n"},
      {"trimmed", "10 0 3 0 2\n2 0 0 0 0 0 1 1 0 0 0 1 0 2\n"},
      {"offset", "11 0.5\n" + inner},
      {"extrusion of a trimmed circle", "6 0 0 1\n8 0 3\n" + circle},
      {"extrusion of an offset circle", "6 0 0 1\n9 0.5\n0 0 1\n2 0 0 0 0 0 1 1 0 0 0 1 0 1.5\n"},
      {"extrusion of an ellipse", "6 0 0 1\n3 0 0 0 0 0 1 1 0 0 0 1 0 2 2\n"}};
  for (const auto& [name, text] : kinds) {
    DraftFace draft{{text, round}};
    add_wire(draft, {{0.1, 0.1}, {1.5, 0.1}, {1.5, 0.9}, {0.1, 0.9}});
    const Imported made = import_of(draft);
    EXPECT_NEAR(area_of_first(made), 2.0 * 1.4 * 0.8, 1e-8) << name;
    EXPECT_TRUE(made.findings.empty()) << name << ": " << (made.findings.empty() ? "" : made.findings[0].message);
  }
}

TEST(ImportOfFaces, KindsOfCurvesHaveThePointsThatTheFormatSays) {
  using Kind = brep::Conic::Kind;
  const brep::Conic conic{Kind::Parabola, {1, 2, 0}, {1, 0, 0}, {0, 1, 0}, 0.5, 0.5};
  EXPECT_LT(distance(to_curve({conic}, -3, 3)->at(2.0), Point3{1 + 4.0 / 2.0, 4.0, 0}), 1e-14);
  const brep::Conic hyperbola{Kind::Hyperbola, {}, {0, 1, 0}, {1, 0, 0}, 2.0, 3.0};
  EXPECT_LT(distance(to_curve({hyperbola}, -3, 3)->at(1.0), Point3{3.0 * std::sinh(1.0), 2.0 * std::cosh(1.0), 0}),
            1e-14);
  const auto line = std::make_shared<const brep::Curve>(brep::Curve{brep::Line{{0, 0, 0}, {1, 0, 0}}});
  EXPECT_LT(distance(to_curve({brep::OffsetCurve{0.5, {0, 0, 1}, line}}, 0, 4)->at(3.0), Point3{3, -0.5, 0}), 1e-14);
  EXPECT_FALSE(to_curve({brep::Conic{Kind::Circle, {}, {1, 0, 0}, {0, 1, 0}, 0.0, 0.0}}, 0, 1).ok());
}

TEST(ImportOfFaces, SurfacesThatCannotBeAreNamedWithTheirFace) {
  const auto round = [](Point p) { return Point3{std::cos(p.x), std::sin(p.x), p.y}; };
  for (const std::string& text : {std::string("2 0 0 0 0 0 1 1 0 0 0 1 0 0\n"),    // no radius
                                  std::string("3 0 0 0 0 0 1 1 0 0 0 1 0 1 0\n"),  // a cone without an angle
                                  std::string("1 0 0 0 0 0 1 0 0 1 0 1 0\n"),      // parallel axes
                                  std::string("6 0 0 0\n2 0 0 0 0 0 1 1 0 0 0 1 0 2\n")}) {
    DraftFace draft{{text, round}};
    add_wire(draft, unit);
    const Imported made = import_of(draft);
    EXPECT_EQ(made.refused, 1U) << text;
    ASSERT_FALSE(made.findings.empty()) << text;
    EXPECT_EQ(made.findings.back().code, "face_surface") << text;
    EXPECT_EQ(made.findings.back().place.item, "face 1");
    EXPECT_GT(made.findings.back().place.line, 0U);
  }
}

TEST(ImportOfFaces, GapsInSpaceOfClosedEdgesAreMeasuredAndKept) {
  DraftFace draft{flat()};
  add_wire(draft, unit);
  draft.edges[1].aside = {0.0, 0.0, 1e-3};
  const Imported made = import_of(draft);
  EXPECT_NEAR(area_of_first(made), 1.0, 1e-12);
  EXPECT_EQ(codes_of(made), Codes{"curves_apart"});
  EXPECT_NEAR(made.faces[0].loops[0].edges[1].tolerance, 1e-3, 1e-9);
}

TEST(ImportOfFaces, FilesOfCurvesAloneAreRefused) {
  const auto model = brep::parse_brep(
      "CASCADE Topology V1\nLocations 0\nCurve2ds 0\nCurves 0\nPolygon3D 0\nPolygonOnTriangulations 0\nSurfaces 0\n"
      "Triangulations 0\n\nTShapes 1\nCo\n\n1100000\n*\n\n+1 0 ",
      "a.brep");
  ASSERT_TRUE(model.ok());
  const auto made = faces_of_model(*model);
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.error().code, base::ErrorCode::BadFormat);
}

}  // namespace
}  // namespace dobra::io::faces
