// Files as OCCT's tools write them, of kinds that the seeded generator does not make. Each is meshed and has the area
// of a closed form, or is refused with its place.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>

#include "shared/io/faces/import.h"
#include "tests/support/brep_writer.h"
#include "tests/support/meshed_faces.h"

namespace dobra::io::faces {
namespace {

using geom::Point;
using geom::Point3;
using support::ball;
using support::Carrier;
using support::DraftFace;
using support::flat;
using support::line_path;
using support::Path;
using support::tube;

constexpr double whole_turn = 2.0 * std::numbers::pi;

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

void add_ring(DraftFace& draft, const Path& path, bool hole) {
  const std::size_t vertex = draft.add_vertex(path.at(path.from));
  draft.wires.push_back({{draft.add_edge({path, std::nullopt, vertex, vertex}), hole ? '-' : '+'}});
}
/// The whole turn between two values of v; the lower end may be one point.
void add_turn(DraftFace& draft, double from, double to, bool low_point) {
  const Point a{0.0, from}, b{whole_turn, from}, c{whole_turn, to}, d{0.0, to};
  const std::size_t low = draft.add_vertex(a), high = draft.add_vertex(d);
  const std::size_t bottom = draft.add_edge({line_path(a, b), std::nullopt, low, low, low_point});
  const std::size_t seam = draft.add_edge({line_path(b, c), line_path(a, d), low, high});
  const std::size_t top = draft.add_edge({line_path(d, c), std::nullopt, high, high});
  draft.wires.push_back({{bottom, '+'}, {seam, '+'}, {top, '-'}, {seam, '-'}});
}

/// What a file of one face comes to.
struct Come {
  std::vector<surf::mesh::Finding> findings;
  std::size_t faces = 0;
  support::MeshedFaces mesh;
};
Come come_of(const std::string& text, double size) {
  const auto model = brep::parse_brep(text, "written.brep");
  EXPECT_TRUE(model.ok()) << base::to_string(model.error());
  if (!model) return {};
  const auto imported = faces_of_model(*model);
  EXPECT_TRUE(imported.ok()) << base::to_string(imported.error());
  if (!imported) return {};
  Come come{imported->findings, imported->faces.size(), {}};
  if (!imported->faces.empty()) come.mesh = support::mesh_faces(imported->faces, size, 8.0);
  return come;
}

void expect_mesh(const std::string& text, double size, double area, int euler, std::size_t faces = 1) {
  const Come come = come_of(text, size);
  ASSERT_EQ(come.faces, faces) << (come.findings.empty() ? "" : come.findings.back().message);
  ASSERT_FALSE(come.mesh.refused) << base::to_string(*come.mesh.refused);
  EXPECT_NEAR(come.mesh.quality.area, area, 0.01 * area);
  EXPECT_EQ(come.mesh.quality.euler, euler);
  EXPECT_GE(come.mesh.quality.alpha_min, 0.1);
  EXPECT_LT(come.mesh.turned, 60.0);
}

DraftFace plate() {
  DraftFace draft{flat()};
  add_wire(draft, {{0, 0}, {3, 0}, {3, 2}, {0, 2}});
  return draft;
}

TEST(WrittenFiles, AReversedFaceWithAPlacementLooksTheOtherWay) {
  DraftFace draft = plate();
  draft.reversed = true;
  draft.placement = {0, 0, 1, 5, 1, 0, 0, -2, 0, 1, 0, 7};  // x to y, y to z, z to x
  expect_mesh(support::brep_text(draft), 0.3, 6.0, 1);
  const auto model = brep::parse_brep(support::brep_text(draft), "written.brep");
  ASSERT_TRUE(model.ok());
  const auto imported = faces_of_model(*model);
  ASSERT_TRUE(imported.ok());
  EXPECT_TRUE(imported->faces[0].reversed);
}

TEST(WrittenFiles, ALineTurnedRoundAnAxisThatItTouchesIsACone) {
  // From (0, 0, 1) down to (1, 0, 0): slant sqrt(2), area pi r slant.
  const double half = std::sqrt(0.5);
  const Carrier cone{fmt::format("7 0 0 0 0 0 1\n1 0 0 1 {0:.17g} 0 {1:.17g}\n", half, -half), [=](Point p) {
                       return Point3{p.y * half * std::cos(p.x), p.y * half * std::sin(p.x), 1.0 - p.y * half};
                     }};
  DraftFace draft{cone};
  add_turn(draft, 0.0, std::sqrt(2.0), true);
  expect_mesh(support::brep_text(draft), 0.15, std::numbers::pi * std::sqrt(2.0), 1);
}

TEST(WrittenFiles, AQuarterCircleTurnedRoundItsDiameterHasAPole) {
  // The meridian (cos v, 0, sin v) of a sphere of radius 2, from the equator to the pole.
  const Carrier dome{"7 0 0 0 0 0 1\n2 0 0 0 0 -1 0 1 0 0 0 0 1 2\n", ball(2.0).at};
  for (const bool flagged : {false, true}) {
    DraftFace draft{dome};
    const double up = 0.25 * whole_turn;
    const Point a{0.0, 0.0}, b{whole_turn, 0.0}, c{whole_turn, up}, d{0.0, up};
    const std::size_t low = draft.add_vertex(a), high = draft.add_vertex(d);
    const std::size_t bottom = draft.add_edge({line_path(a, b), std::nullopt, low, low});
    const std::size_t seam = draft.add_edge({line_path(b, c), line_path(a, d), low, high});
    draft.wires.push_back({{bottom, '+'}, {seam, '+'}});
    if (flagged) draft.wires[0].push_back({draft.add_edge({line_path(d, c), std::nullopt, high, high, true}), '-'});
    draft.wires[0].push_back({seam, '-'});
    expect_mesh(support::brep_text(draft), 0.3, 4.0 * whole_turn, 1);
  }
}

TEST(WrittenFiles, AnExtrudedSplineHasTheLengthOfItsCurveTimesItsHeight) {
  // The Bezier curve (0, 0), (1, 2), (2, 0) is the parabola y = 2 x - x^2: half of it is as long as the integral of
  // sqrt(1 + 4 t^2) from 0 to 1.
  const double length = std::sqrt(5.0) + 0.5 * std::asinh(2.0);
  const Carrier wall{"6 0 0 1\n7 0 0  2 3 2  0 0 0 1 2 0 2 0 0\n 0 3 1 3\n", [](Point p) {
                       const double u = p.x;
                       return Point3{2.0 * u, 4.0 * u * (1.0 - u), p.y};
                     }};
  DraftFace draft{wall};
  add_wire(draft, {{0, 0}, {1, 0}, {1, 3}, {0, 3}});
  expect_mesh(support::brep_text(draft), 0.2, 3.0 * length, 1);
}

TEST(WrittenFiles, AnOffsetTubeHasItsOwnRadius) {
  const Carrier outer{"11 0.25\n2 0 0 0 0 0 1 1 0 0 0 1 0 0.75\n", tube(1.0).at};
  DraftFace draft{outer};
  add_turn(draft, 0.0, 2.0, false);
  expect_mesh(support::brep_text(draft), 0.2, 2.0 * whole_turn, 0);
}

TEST(WrittenFiles, HolesThatTouchTheSeamAreCutOrNamed) {
  DraftFace draft{tube(1.0)};
  add_turn(draft, 0.0, 4.0, false);
  add_ring(draft, support::arc_path({0.5, 1.0}, 0.5, 0.4, 0.0, whole_turn), true);               // at u = 0
  add_ring(draft, support::arc_path({whole_turn - 0.5, 3.0}, 0.5, 0.4, 0.0, whole_turn), true);  // at the other side
  const Come come = come_of(support::brep_text(draft), 0.2);
  const double area = 4.0 * whole_turn - 2.0 * std::numbers::pi * 0.5 * 0.4;
  if (come.faces == 0) {
    ASSERT_FALSE(come.findings.empty());
    EXPECT_EQ(come.findings.back().code.rfind("face_", 0), 0U);
    EXPECT_EQ(come.findings.back().place.item, "face 1");
  } else if (come.mesh.refused) {
    EXPECT_TRUE(come.mesh.refused->place && come.mesh.refused->place->x) << base::to_string(*come.mesh.refused);
  } else {
    EXPECT_NEAR(come.mesh.quality.area, area, 0.01 * area);
  }
}

TEST(WrittenFiles, APeriodicSplineIsAHole) {
  // Cubic, uniform, through eight control points of a circle of radius 1/2: the file has its knots and points once.
  constexpr int points = 8;
  const auto control = [](int i) {
    const double angle = -whole_turn * (i % points) / points;
    return Point{1.5 + 0.5 * std::cos(angle), 1.0 + 0.5 * std::sin(angle)};
  };
  const auto at = [&](double t) {
    const int i = std::min(static_cast<int>(t), points - 1);
    const double f = t - i, g = 1.0 - f;
    const std::array weight{g * g * g, 3 * f * f * f - 6 * f * f + 4, 3 * g * g * g - 6 * g * g + 4, f * f * f};
    geom::Vector sum{};
    for (int k = 0; k < 4; ++k) sum = sum + weight[k] / 6.0 * (control(i + k) - Point{});
    return Point{} + sum;
  };
  std::string text = fmt::format("7 0 1  3 {} {} ", points, points + 1);
  for (int i = 0; i < points; ++i) text += fmt::format(" {:.17g} {:.17g}", control(i).x, control(i).y);
  text += "\n";
  for (int i = 0; i <= points; ++i) text += fmt::format(" {} 1", i);
  const Path round{text + "\n", 0.0, points, at};
  DraftFace draft = plate();
  const std::size_t vertex = draft.add_vertex(at(0.0));
  draft.wires.push_back({{draft.add_edge({round, std::nullopt, vertex, vertex}), '+'}});  // it runs clockwise
  double hole = 0.0;
  constexpr int chords = 20000;
  for (int i = 0; i < chords; ++i)
    hole -= 0.5 * cross(at(points * i / double{chords}) - Point{}, at(points * (i + 1) / double{chords}) - Point{});
  expect_mesh(support::brep_text(draft), 0.2, 6.0 - hole, 0);
}

TEST(WrittenFiles, ASphereWithASmallHoleIsAllTheRest) {
  DraftFace draft{ball(1.0)};
  add_ring(draft, support::arc_path({1.0, 0.3}, 0.1, 0.1, 0.0, whole_turn), true);
  // The hole in the chart: the integral of cos v over a disc.
  double hole = 0.0;
  constexpr int strips = 20000;
  for (int i = 0; i < strips; ++i) {
    const double v = -0.1 + 0.2 * (i + 0.5) / strips;
    hole += 2.0 * std::sqrt(0.01 - v * v) * std::cos(0.3 + v) * 0.2 / strips;
  }
  expect_mesh(support::brep_text(draft), 0.15, 2.0 * whole_turn - hole, 1);
}

TEST(WrittenFiles, ATrimmedSurfaceManyTurnsAwayIsWhereItIs) {
  const double by = 6.0 * whole_turn;
  const Carrier trimmed{fmt::format("10 {:.17g} {:.17g} -5 5\n", by, by + 3.0) + tube(2.0).text, tube(2.0).at};
  DraftFace draft{trimmed};
  add_wire(draft, {{by + 0.2, 0}, {by + 1.7, 0}, {by + 1.7, 1}, {by + 0.2, 1}});
  expect_mesh(support::brep_text(draft), 0.2, 3.0, 1);
}

TEST(WrittenFiles, APoleNeedsNoDegenerateEdge) {
  DraftFace draft{ball(1.0)};
  const Point a{0.0, 0.5}, b{whole_turn, 0.5}, c{whole_turn, 0.25 * whole_turn}, d{0.0, 0.25 * whole_turn};
  const std::size_t low = draft.add_vertex(a), high = draft.add_vertex(d);
  const std::size_t bottom = draft.add_edge({line_path(a, b), std::nullopt, low, low});
  const std::size_t seam = draft.add_edge({line_path(b, c), line_path(a, d), low, high});
  draft.wires.push_back({{bottom, '+'}, {seam, '+'}, {seam, '-'}});
  expect_mesh(support::brep_text(draft), 0.15, whole_turn * (1.0 - std::sin(0.5)), 1);
}

TEST(WrittenFiles, HeadersOfEachVersionAndLinesOfWindowsAreRead) {
  for (const char* const header :
       {"CASCADE Topology V1, (c) Matra-Datavision", "CASCADE Topology V3, (c) Open Cascade"}) {
    std::string text = support::brep_text(plate());
    replace_all(text, "CASCADE Topology V1, (c) Matra-Datavision", header);
    expect_mesh(text, 0.3, 6.0, 1);
    replace_all(text, "\n", "\r\n");
    expect_mesh(text, 0.3, 6.0, 1);
    replace_all(text, "DBRep_DrawableShape\r\n", "");
    expect_mesh(text, 0.3, 6.0, 1);
  }
}

TEST(WrittenFiles, TwoFacesOfOneFileAreBothMeshed) {
  // A plate and, in a compound with it, itself at another place.
  std::string text = support::brep_text(plate());
  replace_all(text, "Locations 1\n1\n 1 0 0 0 \n 0 1 0 0 \n 0 0 1 0 \n",
              "Locations 2\n1\n 1 0 0 0 \n 0 1 0 0 \n 0 0 1 0 \n1\n 0 0 1 9 \n 1 0 0 0 \n 0 1 0 0 \n");
  const std::size_t table = text.find("TShapes ");
  ASSERT_NE(table, std::string::npos);
  const int shapes = std::stoi(text.substr(table + 8));
  // Shapes are numbered from the last: those before the compound are one farther.
  std::istringstream lines(text.substr(text.find('\n', table) + 1));
  text = text.substr(0, table) + fmt::format("TShapes {}\n", shapes + 1);
  for (std::string line; std::getline(lines, line) && line != "+1 1 ";) {
    if (line.ends_with("*") && line.size() > 1) {
      std::istringstream words(line);
      line.clear();
      for (std::string word; words >> word;) {
        const bool shape = word[0] == '+' || word[0] == '-';
        line += (shape ? fmt::format("{}{}", word[0], std::stoi(word.substr(1)) + 1) : word) + " ";
      }
    }
    text += line + "\n";
  }
  text += "Co\n\n1100000\n+2 1 +2 2 *\n\n+1 0 \n";
  const Come come = come_of(text, 0.3);
  ASSERT_EQ(come.faces, 2U);
  ASSERT_FALSE(come.mesh.refused) << base::to_string(*come.mesh.refused);
  EXPECT_NEAR(come.mesh.quality.area, 12.0, 1e-9);
  EXPECT_EQ(come.mesh.quality.euler, 2);
}

TEST(WrittenFiles, ACurvedFaceWithoutCurvesInItsChartIsMeshed) {
  DraftFace draft{tube(1.5)};
  add_wire(draft, {{0.2, 0}, {2.2, 0}, {2.2, 1}, {0.2, 1}});
  for (DraftFace::Edge& edge : draft.edges) edge.chart = false;
  expect_mesh(support::brep_text(draft), 0.2, 3.0, 1);
}

TEST(WrittenFiles, AWireOfAnotherFaceIsNamed) {
  // Half of the loop is missing: the face is left out with its place.
  DraftFace draft = plate();
  draft.wires[0].resize(2);
  const Come come = come_of(support::brep_text(draft), 0.3);
  EXPECT_EQ(come.faces, 0U);
  ASSERT_FALSE(come.findings.empty());
  EXPECT_EQ(come.findings.back().code, "face_open");
  EXPECT_EQ(come.findings.back().place.item, "face 1");
  EXPECT_TRUE(come.findings.back().place.x.has_value());
}

}  // namespace
}  // namespace dobra::io::faces
