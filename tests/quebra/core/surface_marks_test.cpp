#include "quebra/core/surface_marks.h"
#include "tests/support/surface_scenarios.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "quebra/core/surface_layers.h"
#include "quebra/core/surface_start.h"
#include "shared/io/file.h"
#include "tests/support/quebra_scenarios.h"

namespace quebra::core {
namespace {

using namespace dobra;
using geom::Point;
using geom::Point3;

constexpr double pi = std::numbers::pi;

const std::string plate = "[[input.surface]]\nname = \"plate\"\nkind = \"plane\"\nu = [0, 10]\nv = [0, 5]\n";
const std::string mesh_step = "[[step]]\noperation = \"mesh\"\nsize = 0.5\n";
const std::string tube = "[[input.surface]]\nname = \"tube\"\nkind = \"cylinder\"\nradius = 2\nv = [0, 6]\n";

double length_of(const std::vector<Point3>& line) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) sum += distance(line[i], line[i + 1]);
  return sum;
}

TEST(SurfaceMarks, LinesOfConstantUAndVRunAcrossAPlate) {
  const auto run = test::run(plate + mesh_step);
  const model::Model& model = test::last(run);
  const auto curves = isocurves(model.surface_meshes.back()->mesh, model.surfaces->faces);
  ASSERT_EQ(curves.size(), 18u);  // each in one piece
  for (const Isocurve& curve : curves) {
    const bool along_u = curve.item < 9;
    const double value = along_u ? 1.0 + curve.item : 0.5 * (1.0 + (curve.item - 9));
    for (const Point3& p : curve.line) EXPECT_NEAR(along_u ? p.x : p.y, value, 1e-12);
    EXPECT_NEAR(length_of(curve.line), along_u ? 5.0 : 10.0, 1e-9);
    ASSERT_EQ(curve.chart.size(), curve.line.size());
    for (std::size_t i = 0; i < curve.line.size(); ++i) EXPECT_NEAR(curve.chart[i].x, curve.line[i].x, 1e-12);
  }
}

TEST(SurfaceMarks, LinesOfConstantUAndVStopAtHoles) {
  const auto run = test::run(
      plate + "[[input.trim]]\nname = \"hole\"\nkind = \"circle\"\nrole = \"hole\"\ncentre = [5, 2.5]\nradius = 1\n" +
      mesh_step);
  const model::Model& model = test::last(run);
  std::map<std::uint32_t, double> lengths;
  for (const Isocurve& curve : isocurves(model.surface_meshes.back()->mesh, model.surfaces->faces))
    lengths[curve.item] += length_of(curve.line);
  EXPECT_NEAR(lengths[4], 3.0, 0.02);      // u = 5, through the middle of the hole
  EXPECT_NEAR(lengths[9 + 4], 8.0, 0.02);  // v = 2.5
  EXPECT_NEAR(lengths[9 + 3], 10.0 - 2.0 * std::sqrt(0.75), 0.05);
  EXPECT_NEAR(lengths[0], 5.0, 1e-9);
}

TEST(SurfaceMarks, LinesGoRoundATubeOverItsSeam) {
  const auto run = test::run(tube + mesh_step);
  const model::Model& model = test::last(run);
  const auto curves = isocurves(model.surface_meshes.back()->mesh, model.surfaces->faces);
  std::map<std::uint32_t, double> lengths;
  for (const Isocurve& curve : curves) {
    lengths[curve.item] += length_of(curve.line);
    for (const Point3& p : curve.line) {
      EXPECT_LE(std::hypot(p.x, p.y), 2.0 + 1e-9);
      EXPECT_GE(std::hypot(p.x, p.y), 1.95);
    }
  }
  ASSERT_EQ(lengths.size(), 18u);
  for (std::uint32_t item = 0; item < 9; ++item) EXPECT_NEAR(lengths[item], 6.0, 0.1) << item;
  for (std::uint32_t item = 9; item < 18; ++item) EXPECT_NEAR(lengths[item], 4.0 * pi, 0.2) << item;
}

TEST(SurfaceMarks, NormalsLookOutOfASphereAndIntoOneThatFacesAgainst) {
  for (const bool against : {false, true}) {
    const auto run = test::run("[[input.surface]]\nname = \"ball\"\nkind = \"sphere\"\nradius = 1\n" +
                               std::string(against ? "facing = \"against\"\n" : "") +
                               "[[step]]\noperation = \"mesh\"\nsize = 0.3\n");
    const auto& mesh = test::last(run).surface_meshes.back()->mesh;
    const auto lines = normals(mesh, 100);
    ASSERT_GE(lines.size(), 90u);
    ASSERT_LE(lines.size(), 100u);
    for (const auto& line : lines) {
      const geom::Vector3 way = line[1] - line[0];
      const double out = dot(way, line[0] - Point3{}) / length(way) / length(line[0] - Point3{});
      EXPECT_NEAR(out, against ? -1.0 : 1.0, 0.02);
      EXPECT_NEAR(length(way), 0.3, 0.1);
    }
  }
  EXPECT_TRUE(normals({}, 100).empty());
}

double area(const scene::space::Surface& surface) {
  double sum = 0.0;
  for (const auto& t : surface.triangles)
    sum +=
        0.5 * length(cross(surface.points[t[1]] - surface.points[t[0]], surface.points[t[2]] - surface.points[t[0]]));
  return sum;
}

TEST(SurfaceMarks, AnAreaIsThatOfItsLoops) {
  const auto run = test::run(
      plate + "[[input.trim]]\nname = \"hole\"\nkind = \"circle\"\nrole = \"hole\"\ncentre = [5, 2.5]\nradius = 1\n");
  const auto& face = test::last(run).surfaces->faces[0];
  const auto shown = area_of(face.surface, face.loops, 7);
  EXPECT_NEAR(area(shown), 50.0 - pi, 0.03);
  ASSERT_EQ(shown.ids.size(), shown.triangles.size());
  EXPECT_EQ(shown.ids[0], 7u);
  for (std::size_t i = 0; i < shown.points.size(); ++i) EXPECT_NEAR(shown.chart[i].x, shown.points[i].x, 1e-9);
  // Bent in space.
  const auto bent =
      test::run("[[input.surface]]\nname = \"half\"\nkind = \"cylinder\"\nradius = 2\nu = [0, 180]\nv = [0, 6]\n");
  const auto& half = test::last(bent).surfaces->faces[0];
  EXPECT_NEAR(area(area_of(half.surface, half.loops, 0)), 12.0 * pi, 0.2);
}

const scene::space::Layer* layer(const scene::space::SpacePicture& picture, const std::string& key) {
  for (const auto& each : picture.layers) {
    if (each.key == key) return &each;
  }
  return nullptr;
}

/// A roof of two slopes that share their ridge.
TEST(SurfaceMarks, ABorderOfTwoSurfacesHasOneNumberInSpaceAndInBothCharts) {
  const auto run = test::run(
      "[[input.surface]]\nname = \"west\"\nkind = \"plane\"\nu = [0, 2]\nv = [0, 3]\norigin = [0, 0, 0]\n"
      "[[input.surface]]\nname = \"east\"\nkind = \"plane\"\nu = [0, 2]\nv = [0, 3]\norigin = [2, 0, 0]\n" +
      mesh_step);
  const model::Model& model = test::last(run);
  scene::space::SpacePicture picture;
  draw_surfaces_in_space(model, picture);
  const auto& borders = std::get<scene::space::Lines>(layer(picture, "boundary")->content);
  std::map<std::uint32_t, std::size_t> uses;
  for (const std::uint32_t id : borders.ids) ++uses[id];
  EXPECT_EQ(borders.ids.size(), 8u);
  EXPECT_EQ(uses.size(), 7u);
  for (std::size_t i = 0; i < borders.lines.size(); ++i) {
    const bool ridge = std::abs(borders.lines[i][0].x - 2.0) < 1e-9 && std::abs(borders.lines[i][50].x - 2.0) < 1e-9;
    EXPECT_EQ(uses[borders.ids[i]], ridge ? 2u : 1u);
  }
  scene::Picture plane;
  draw_surfaces(model, plane);
  ASSERT_EQ(plane.panels.size(), 2u);
  std::set<std::uint32_t> triangles;
  std::size_t common = 0;
  for (const scene::Panel& panel : plane.panels) {
    for (const scene::Layer& each : panel.layers) {
      if (each.key == "mesh") {
        for (const std::uint32_t id : std::get<scene::Mesh>(each.content).ids) EXPECT_TRUE(triangles.insert(id).second);
      }
      if (each.key != "boundary") continue;
      for (const std::uint32_t id : std::get<scene::Lines>(each.content).ids) common += uses[id] == 2 ? 1 : 0;
    }
  }
  EXPECT_EQ(common, 2u);
  EXPECT_EQ(triangles.size(), std::get<scene::space::Surface>(layer(picture, "mesh")->content).triangles.size());
}

TEST(SurfaceMarks, ASeamIsNoBorderInSpaceAndACrackOnItIsACrack) {
  const auto run = test::run(tube +
                             "[[input.trim]]\nname = \"k\"\nkind = \"line\"\nrole = \"crack\"\n"
                             "points = [[0, 2], [0, 5]]\n" +
                             mesh_step);
  const model::Model& model = test::last(run);
  scene::space::SpacePicture picture;
  draw_surfaces_in_space(model, picture);
  double length = 0.0;
  for (const auto& line : std::get<scene::space::Lines>(layer(picture, "boundary")->content).lines)
    length += length_of(line);
  EXPECT_NEAR(length, 2.0 * 4.0 * pi, 0.02);  // both rings
  ASSERT_NE(layer(picture, "cracks"), nullptr);
  for (const auto& line : std::get<scene::space::Lines>(layer(picture, "cracks")->content).lines)
    EXPECT_NEAR(length_of(line), 3.0, 1e-9);
  // The chart has its sides.
  const scene::Panel chart = chart_of(model, 0);
  std::size_t sides = 0;
  for (const scene::Layer& each : chart.layers) {
    if (each.key == "boundary") sides = std::get<scene::Lines>(each.content).lines.size();
  }
  EXPECT_EQ(sides, 6u);  // bottom, top, and both sides of the seam below and above the crack
}

TEST(SurfaceMarks, BeforeThereIsAMeshTheSurfacesThemselvesAreShown) {
  const auto run = test::run(plate);
  scene::space::SpacePicture picture;
  draw_surfaces_in_space(test::last(run), picture);
  EXPECT_EQ(layer(picture, "mesh"), nullptr);
  ASSERT_NE(layer(picture, faces_layer), nullptr);
  EXPECT_NEAR(area(std::get<scene::space::Surface>(layer(picture, faces_layer)->content)), 50.0, 1e-6);
}

TEST(SurfaceStart, ABoundaryModelBecomesADocumentWhoseMeshIsOfItsSize) {
  const auto file = std::filesystem::path(DOBRA_SOURCE_DIR) / "tests/shared/io/brep/data/sphere_whole.brep";
  const auto document = document_of_brep(file);
  ASSERT_TRUE(document.ok());
  scenario::Runner runner(program());
  const auto run = runner.run(*document);
  ASSERT_TRUE(run.complete()) << to_string(*run.error);
  const auto& quality = test::last(run).surface_meshes.back()->quality;
  EXPECT_GT(quality.triangles, 200u);
  EXPECT_LT(quality.triangles, 20000u);
  EXPECT_FALSE(document_of_brep("there_is_no_such.brep").ok());
}

TEST(SurfaceStart, AFaceThatIsRoughEverywhereTurnsByMoreWhereNothingIsAsked) {
  const auto waves = [](const std::string& formula) {
    const auto made = test::surfaces_of("[[input.surface]]\nname = \"g\"\nkind = \"graph\"\nformula = \"" + formula +
                                        "\"\nu = [0, 10]\nv = [0, 10]\n");
    EXPECT_TRUE(made.ok()) << (made ? "" : to_string(made.error()));
    return made->faces;
  };
  // The third bends by 20 radians a metre: sides of 0.009 m over 100 m2 are a million triangles and more.
  EXPECT_EQ(usual_turn(waves("0.0"), 0.5), 10.0);
  EXPECT_EQ(usual_turn(waves("0.5 * sin(x)"), 0.5), 10.0);
  EXPECT_GT(usual_turn(waves("0.05 * sin(20 * x) * sin(20 * y)"), 0.5), 10.0);
  EXPECT_EQ(usual_turn(waves("0.5 * sin(40 * x) * sin(40 * y)"), 0.5), 40.0);
}

}  // namespace
}  // namespace quebra::core
