// Cracks, regions, specimens, zones, orders and files, all through the table of operations.

#include "quebra/sketch/specimen.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <numbers>

#include "quebra/core/operations.h"
#include "quebra/model/model.h"
#include "shared/io/formats/mesh_file.h"
#include "shared/mesh/order2.h"
#include "shared/scenario/runner.h"
#include "tests/support/corpus.h"

namespace quebra::sketch {
namespace {

using namespace dobra;
namespace fs = std::filesystem;
using geom::Point;

scenario::Run run_text(const std::string& text, const fs::path& folder = {}) {
  auto document = scenario::parse_document("dobra = 1\nprogram = \"quebra\"\n" + text, folder / "test.toml");
  EXPECT_TRUE(document.ok()) << (document ? "" : to_string(document.error()));
  EXPECT_TRUE(scenario::check(*document, core::program()).ok());
  return scenario::Runner(core::program()).run(*document);
}

std::shared_ptr<const model::Model> run(const std::string& text, const fs::path& folder = {}) {
  const auto done = run_text(text, folder);
  EXPECT_TRUE(done.complete()) << to_string(*done.error);
  return std::static_pointer_cast<const model::Model>(done.states.back());
}

const mesh::ElementMesh& last_mesh(const model::Model& model) {
  const auto& mesh = model.meshes.back()->mesh;
  const auto good = mesh::check(mesh);
  EXPECT_TRUE(good.ok()) << (good ? "" : to_string(good.error()));
  return mesh;
}

std::size_t coincident_at(const mesh::ElementMesh& mesh, Point p) {
  return static_cast<std::size_t>(std::count(mesh.points.begin(), mesh.points.end(), p));
}

double length_of(const mesh::ElementMesh& mesh, const std::string& set) {
  double length = 0.0;
  for (const auto& side : mesh.side_sets.at(set)) {
    const auto nodes = side_nodes(mesh, side);
    length += distance(mesh.point(nodes[0]), mesh.point(nodes[1]));
  }
  return length;
}

const std::string square_sketch =
    "[[input.curve]]\nname = \"plate\"\nkind = \"polygon\"\npoints = [[0, 0], [4, 0], [4, 4], [0, 4]]\n";
const std::string mesh_step = "[[step]]\noperation = \"mesh\"\nsize = 0.5\n";

TEST(Specimen, EveryOneMeshesWithBothOrdersAndQuadrilaterals) {
  const std::map<std::string, std::pair<double, std::size_t>> expected = {
      {"plate_with_hole", {100.0 - std::numbers::pi, 0}},
      {"quarter_plate", {25.0 - 0.25 * std::numbers::pi, 0}},
      {"l_shape", {7500.0, 0}},
      {"cook", {1440.0, 0}},
      {"single_edge_notch", {3.0, 1}},
      {"double_edge_notch", {3.0, 2}},
      {"centre_crack", {400.0, 2}},
      {"compact_tension", {3750.0 - 2.0 * std::numbers::pi * 6.25 * 6.25, 1}},
      {"three_point_bend", {4.5, 1}},
      {"pmma_beam", {160.0 - 3.0 * std::numbers::pi / 16.0, 1}},
      {"double_cantilever", {2000.0, 1}},
      {"brazilian_disc", {std::numbers::pi, 2}}};
  for (const std::string& name : specimen_names()) {
    if (name == "none") continue;
    const auto model =
        run("[input]\nspecimen = \"" + name +
            "\"\n[[step]]\noperation = \"mesh\"\n[[step]]\noperation = \"mesh\"\norder = \"2\"\nquads = \"yes\"\n");
    const auto& [area, tips] = expected.at(name);
    const auto& linear = model->meshes.front()->mesh;
    EXPECT_TRUE(mesh::check(linear).ok()) << name;
    EXPECT_NEAR(mesh::area(linear), area, 0.02 * area) << name;
    const auto& curved = last_mesh(*model);
    EXPECT_NEAR(mesh::area(curved), area, 5e-5 * area) << name << ": parabolic sides";
    EXPECT_EQ(curved.tips.size(), tips) << name;
    EXPECT_TRUE(std::count(curved.types.begin(), curved.types.end(), mesh::ElementType::Q8) > 0) << name;
    for (std::size_t e = 0; e < curved.element_count(); ++e)
      ASSERT_GT(mesh::scaled_jacobian_bound(curved, mesh::ElementId(e)), 0.0) << name;
  }
}

TEST(Specimen, SizesThatDoNotFitAreRefused) {
  for (const char* const bad :
       {"specimen = \"plate_with_hole\"\nradius = 6\n", "specimen = \"single_edge_notch\"\ncrack_length = 1\n",
        "specimen = \"centre_crack\"\ncrack_length = 11\n",
        "specimen = \"pmma_beam\"\nposition = 4\ncrack_length = 3\n", "specimen = \"three_point_bend\"\nwidth = 4\n"}) {
    const auto done = run_text(std::string("[input]\n") + bad);
    ASSERT_FALSE(done.complete()) << bad;
    EXPECT_EQ(done.error->code, base::ErrorCode::BadValue) << bad;
    EXPECT_EQ(done.error->place->line, 4U) << bad;
  }
}

TEST(Specimen, AnInclinedCentreCrackHasItsAngleAndItsLength) {
  const auto model = run("[input]\nspecimen = \"centre_crack\"\ncrack_length = 2\nangle = 30\n" + mesh_step);
  const auto& mesh = last_mesh(*model);
  EXPECT_NEAR(length_of(mesh, "crack_left"), 4.0, 1e-12);
  ASSERT_EQ(mesh.tips.size(), 2U);
  EXPECT_NEAR(std::atan2(mesh.tips[1].direction.y, mesh.tips[1].direction.x), std::numbers::pi / 6.0, 1e-9);
}

TEST(Junctions, CracksBranchCrossAndReachTheBoundary) {
  const auto model = run(square_sketch +
                         "[[input.crack]]\nname = \"stem\"\npoints = [[2, 0], [2, 2]]\n[[input.crack]]\nname = "
                         "\"arm\"\npoints = [[2, 2], [3, 3]]\n"
                         "[[input.crack]]\nname = \"other\"\npoints = [[2, 2], [1, 3]]\n[[input.crack]]\nname = "
                         "\"across\"\npoints = [[1.5, 1.1], [2.6, 0.9]]\n" +
                         mesh_step);
  const auto& mesh = last_mesh(*model);
  EXPECT_EQ(coincident_at(mesh, {2, 2}), 3U) << "a branch";
  EXPECT_EQ(coincident_at(mesh, {2, 0}), 2U) << "a mouth";
  std::size_t fourfold = 0;
  for (const Point p : mesh.points) fourfold += coincident_at(mesh, p) == 4 ? 1 : 0;
  EXPECT_EQ(fourfold, 4U) << "one crossing, four nodes";
  EXPECT_EQ(mesh.tips.size(), 4U);
  EXPECT_NEAR(mesh::area(mesh), 16.0, 1e-12);
}

TEST(Junctions, ACrackFromAHoleAndACurvedOneOpen) {
  const auto model = run(square_sketch +
                         "[[input.curve]]\nname = \"hole\"\nkind = \"circle\"\ncentre = [2, 2]\nradius = 0.5\n"
                         "[[input.crack]]\nname = \"a\"\npoints = [[2.5, 2], [3, 2.2]]\n[[input.crack]]\nname = "
                         "\"b\"\nkind = \"spline\"\npoints = [[1.5, 2], [1.2, 2.2], [0.8, 2.1], [0.5, 2.4]]\n"
                         "[[input.crack]]\nname = \"c\"\nkind = \"arc\"\ncentre = [2, 1]\npoints = [[2.4, 1], [2, "
                         "1.4]]\n[[step]]\noperation = \"mesh\"\nsize = 0.3\norder = \"2\"\n");
  const auto& mesh = last_mesh(*model);
  EXPECT_EQ(coincident_at(mesh, {2.5, 2}), 2U);
  EXPECT_EQ(coincident_at(mesh, {1.5, 2}), 2U);
  EXPECT_EQ(mesh.tips.size(), 4U);
  for (const auto& side : mesh.side_sets.at("c_left")) {
    EXPECT_NEAR(distance(mesh.point(side_nodes(mesh, side)[2]), {2, 1}), 0.4, 1e-12)
        << "mid-sides of lips lie on the arc";
  }
}

TEST(Junctions, InternalLinesThatCrossGetANodeAndDivideTheMaterial) {
  const auto model =
      run(square_sketch +
          "[[input.curve]]\nname = \"h\"\npoints = [[0, 1], [4, 1.3]]\nrole = \"internal\"\n[[input.curve]]\nname = "
          "\"v\"\npoints = [[1.1, 0], [1.7, 4]]\nrole = \"internal\"\n"
          "[[input.region]]\nname = \"steel\"\npoint = [3, 3]\n[[input.region]]\nname = \"rock\"\npoint = [0.1, "
          "0.1]\n[[input.region]]\nname = \"steel\"\npoint = [0.1, 3.9]\n" +
          mesh_step);
  EXPECT_EQ(model->domain.faces.size(), 4U);
  const auto& mesh = last_mesh(*model);
  EXPECT_EQ(mesh.region_names, (std::map<std::int32_t, std::string>{{1, "steel"}, {2, "rock"}}));
  std::map<std::int32_t, double> area;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) area[mesh.regions[e]] += mesh::area(mesh, mesh::ElementId(e));
  std::map<std::int32_t, double> faces;
  for (const domain::Face& face : model->domain.faces) faces[face.region] += face.area;
  ASSERT_EQ(area.size(), 3U);
  for (const auto& [region, value] : faces) EXPECT_NEAR(area[region], value, 1e-10);
  EXPECT_NEAR(length_of(mesh, "h"), std::hypot(4.0, 0.3), 1e-12);
}

TEST(Junctions, WhatLiesOutsideIsRefusedWithItsPlace) {
  const auto refused = [&](const std::string& more, base::ErrorCode code, const std::string& says) {
    const auto done = run_text(square_sketch + more);
    ASSERT_FALSE(done.complete()) << more;
    EXPECT_EQ(done.error->code, code) << to_string(*done.error);
    EXPECT_NE(done.error->message.find(says), std::string::npos) << to_string(*done.error);
    EXPECT_TRUE(done.error->place && done.error->place->x) << more;
  };
  refused("[[input.crack]]\nname = \"c\"\npoints = [[3, 3], [5, 3]]\n", base::ErrorCode::OutsideDomain,
          "outside the domain in part");
  refused("[[input.crack]]\nname = \"c\"\npoints = [[0, 1], [0, 3]]\n", base::ErrorCode::SelfIntersection, "overlap");
  refused("[[input.crack]]\nname = \"c\"\npoints = [[1, 1], [3, 3], [3, 1], [1, 3]]\n",
          base::ErrorCode::SelfIntersection, "itself");
  refused("[[input.region]]\nname = \"r\"\npoint = [5, 5]\n", base::ErrorCode::OutsideDomain, "inside the material");
}

TEST(Junctions, NamedPointsAreNodes) {
  const auto model =
      run(square_sketch +
          "[[input.point]]\nname = \"load\"\npoint = [1.3, 4]\n[[input.point]]\nname = \"corner\"\npoint = [4, "
          "0]\n[[input.point]]\nname = \"gauge\"\npoint = [2.1, 1.7]\nsize = 0.02\n" +
          mesh_step);
  const auto& mesh = last_mesh(*model);
  for (const auto& [name, at] :
       std::map<std::string, Point>{{"load", {1.3, 4}}, {"corner", {4, 0}}, {"gauge", {2.1, 1.7}}}) {
    ASSERT_EQ(mesh.node_sets.at(name).size(), 1U);
    EXPECT_EQ(mesh.point(mesh.node_sets.at(name)[0]), at);
  }
  double shortest = 1.0;
  for (const Point p : mesh.points) {
    if (p != Point{2.1, 1.7}) shortest = std::min(shortest, distance(p, {2.1, 1.7}));
  }
  EXPECT_LT(shortest, 0.03);
}

TEST(Zone, QUE_g_TheSizeAskedForIsReachedInTheBand) {
  const auto model = run(square_sketch +
                         "[[input.crack]]\nname = \"crack\"\npoints = [[1, 2], [2.5, 2.3]]\n[[step]]\noperation = "
                         "\"zone\"\ncurves = [\"crack\"]\nsize = 0.05\nwidth = 0.3\n" +
                         mesh_step);
  const auto& mesh = last_mesh(*model);
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const auto nodes = mesh.nodes_of(mesh::ElementId(e));
    const Point a = mesh.point(nodes[0]), b = mesh.point(nodes[1]), c = mesh.point(nodes[2]);
    const Point middle{(a.x + b.x + c.x) / 3.0, (a.y + b.y + c.y) / 3.0};
    if (distance(geom::Segment{{1, 2}, {2.5, 2.3}}, middle) > 0.25) continue;
    sum += distance(a, b) + distance(b, c) + distance(c, a);
    count += 3;
  }
  EXPECT_NEAR(sum / static_cast<double>(count), 0.05, 0.3 * 0.05);
}

TEST(Constraint, BandsGoRoundACrackAndItsTips) {
  const auto model =
      run("[input]\nspecimen = \"centre_crack\"\nwidth = 8\ncrack_length = 1\n[[step]]\noperation = "
          "\"constraints\"\ncurves = [\"crack\"]\ncount = 3\ndistance = 0.3\n" +
          mesh_step);
  ASSERT_EQ(model->constraints.size(), 3U);
  for (const model::Constraint& ring : model->constraints) {
    EXPECT_TRUE(ring.line.closed);
    for (const Point p : ring.line.points)
      EXPECT_NEAR(distance(geom::Segment{{-1, 0}, {1, 0}}, p), ring.distance, 0.05 * ring.distance);
  }
  last_mesh(*model);
  const auto edge =
      run("[input]\nspecimen = \"single_edge_notch\"\n[[step]]\noperation = \"constraints\"\ncurves = "
          "[\"crack\"]\ncount = 2\ndistance = 0.1\n[[step]]\noperation = \"mesh\"\n");
  ASSERT_EQ(edge->constraints.size(), 2U);
  for (const model::Constraint& ring : edge->constraints)
    EXPECT_EQ(ring.feet.size(), 2U) << "it ends on the boundary above and below the mouth";
  last_mesh(*edge);
}

TEST(SketchFile, AGeoFileGivesRegionsSetsAndSizes) {
  const fs::path folder = fs::temp_directory_path() / "dobra_quebra_geo";
  fs::create_directories(folder);
  std::ofstream(folder / "a.geo")
      << "h = 0.2; "
         "Point(1)={0,0,0,h};Point(2)={2,0,0,h};Point(3)={2,1,0,h/"
         "10};Point(4)={0,1,0,h};Point(5)={1,0,0,h};Point(6)={1,1,0,h};\n"
         "Line(1)={1,5};Line(2)={5,2};Line(3)={2,3};Line(4)={3,6};Line(5)={6,4};Line(6)={4,1};Line(7)={5,6};\n"
         "Curve Loop(1)={1,7,5,6};Curve Loop(2)={2,3,4,-7};Plane Surface(1)={1};Plane Surface(2)={2};\n"
         "Physical Surface(\"soft\")={1};Physical Surface(\"hard\")={2};Physical Curve(\"base\")={1,2};Physical "
         "Point(\"pin\")={1};\n";
  const auto model = run("[input]\nfile = \"a.geo\"\n[[step]]\noperation = \"mesh\"\n", folder);
  const auto& mesh = last_mesh(*model);
  EXPECT_EQ(mesh.region_names, (std::map<std::int32_t, std::string>{{1, "soft"}, {2, "hard"}}));
  EXPECT_NEAR(length_of(mesh, "base"), 2.0, 1e-12);
  EXPECT_EQ(mesh.node_sets.at("pin").size(), 1U);
  EXPECT_NEAR(mesh::area(mesh), 2.0, 1e-12);
  // The mesh as a domain again: the same boundary, regions and interface.
  ASSERT_TRUE(io::formats::write_mesh((folder / "a.msh").string(), mesh, io::meshes::InpElement::PlaneStress).ok());
  const auto again = run("[input]\nfile = \"a.msh\"\n[[step]]\noperation = \"mesh\"\n", folder);
  EXPECT_EQ(again->domain.faces.size(), 2U);
  EXPECT_NEAR(mesh::area(last_mesh(*again)), 2.0, 1e-12);
  fs::remove_all(folder);
}

TEST(SketchFile, CurvesOfGmshFollowTheirDefinition) {
  const fs::path folder = fs::temp_directory_path() / "dobra_quebra_geo2";
  fs::create_directories(folder);
  std::ofstream(folder / "e.geo")
      << "Point(1)={0,0,0};Point(2)={3,0,0};Point(3)={0,2,0};Point(4)={-3,0,0};Point(5)={0,-2,0};\n"
         "Ellipse(1)={2,1,2,3};Ellipse(2)={3,1,2,4};Ellipse(3)={4,1,2,5};Ellipse(4)={5,1,2,2};Curve "
         "Loop(1)={1:4};Plane Surface(1)={1};\n";
  const auto model =
      run("[input]\nfile = \"e.geo\"\n[[step]]\noperation = \"mesh\"\nsize = 0.4\norder = \"2\"\n", folder);
  EXPECT_NEAR(mesh::area(last_mesh(*model)), 6.0 * std::numbers::pi, 1e-4);
  fs::remove_all(folder);
}

TEST(SketchFile, OutlinesOfSvgKeepTheirCurves) {
  const fs::path folder = fs::temp_directory_path() / "dobra_quebra_svg";
  fs::create_directories(folder);
  std::ofstream(folder / "p.svg") << "<svg><g transform='translate(1,1) scale(2)'><path id='plate' d='M0 "
                                     "0H4V3H0z'/><circle id='hole' cx='2' cy='1.5' r='.5'/></g>\n"
                                     "<path id='lens' d='M7 5Q8 4 8.5 5Q8 6 7 5'/><path id='cut' d='M2 2L2 4'/></svg>";
  const auto model =
      run("[input]\nfile = \"p.svg\"\n[[step]]\noperation = \"mesh\"\nsize = 0.3\norder = \"2\"\n", folder);
  // The area under a quadratic Bezier curve is two thirds of its control triangle: 2 * (2/3) * (1.5 * 1 / 2).
  EXPECT_NEAR(mesh::area(last_mesh(*model)), 48.0 - std::numbers::pi - 1.0, 2e-4);
  EXPECT_EQ(model->domain.loops.size(), 3U);
  EXPECT_EQ(last_mesh(*model).side_sets.count("cut"), 1U);
  EXPECT_EQ(last_mesh(*model).side_sets.count("lens_2"), 1U);
  fs::remove_all(folder);
}

TEST(SketchFile, EveryGeometryOfTheCorpusMeshesAtThreeSizesWithBothEngines) {
  const auto data = dobra::test::data_folder();
  if (!data) GTEST_SKIP() << dobra::test::no_data;
  const fs::path folder = *data / "contours";
  const auto expect_valid = [](const mesh::ElementMesh& made, double area, double tolerance) {
    const auto valid = mesh::check(made);
    EXPECT_TRUE(valid) << (valid ? "" : to_string(valid.error()));
    EXPECT_NEAR(mesh::area(made), area, tolerance);
  };
  const double two_holes = 25.0 - 2.0 * std::numbers::pi * (5.0 / 64) * (5.0 / 64);
  for (const std::string engine : {"front", "delaunay"}) {
    std::size_t before = 0;
    for (const std::string size : {"1", "0.3", "0.1"}) {
      SCOPED_TRACE(engine + " " + size);
      const std::string step = "[[step]]\noperation = \"mesh\"\nengine = \"" + engine + "\"\nsize = " + size;
      const auto holes = run("[input]\nfile = \"xfem_two_holes_moes1999.geo\"\n" + step + "\norder = \"2\"\n", folder);
      expect_valid(last_mesh(*holes), two_holes, 1e-5);
      const auto beam = run("[input]\nfile = \"xfem_pmma_3holes.geo\"\n" + step + "\n", folder);
      EXPECT_EQ(beam->domain.faces.size(), 3U);
      EXPECT_EQ(beam->domain.region_names, (std::map<std::int32_t, std::string>{{1, "physical_42"}}));
      expect_valid(last_mesh(*beam), mesh::area(last_mesh(*beam)), 0.0);
      EXPECT_GT(last_mesh(*beam).element_count(), before);
      before = last_mesh(*beam).element_count();
      for (const auto& [name, sides] : last_mesh(*beam).side_sets) EXPECT_FALSE(sides.empty()) << name;
    }
  }
}

TEST(SketchFile, LinesThatCloseBoundTheDomainAndOthersDivideIt) {
  const fs::path folder = fs::temp_directory_path() / "dobra_quebra_curves";
  fs::create_directories(folder);
  std::ofstream(folder / "a.wkt")
      << "LINESTRING (0 0, 2 0)\nLINESTRING (2 0, 2 2, 0 2)\nLINESTRING (0 2, 0 0)\nLINESTRING (2 0, 0 2)\nLINESTRING "
         "(0.2 0.2, 0.6 0.3)\nPOLYGON ((1.5 1.2, 1.7 1.2, 1.7 1.4, 1.5 1.2))\n";
  const auto model = run("[input]\nfile = \"a.wkt\"\n[[step]]\noperation = \"mesh\"\nsize = 0.3\n", folder);
  EXPECT_EQ(model->domain.faces.size(), 2U);
  EXPECT_NEAR(mesh::area(last_mesh(*model)), 4.0 - 0.02, 1e-12) << "the triangle is a hole";
  fs::remove_all(folder);
}

}  // namespace
}  // namespace quebra::sketch
