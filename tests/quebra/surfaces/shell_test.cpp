// Decks of shells: what they hold, and that CalculiX finds the known deflections of two benchmarks with them.

#include "quebra/surfaces/shell.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <numbers>
#include <set>
#include <sstream>

#include "quebra/surfaces/mesh_surfaces.h"
#include "shared/io/file.h"
#include "tests/support/surface_scenarios.h"

namespace quebra::surfaces {
namespace {

using namespace dobra;
namespace fs = std::filesystem;
using geom::Vector3;
using testing::HasSubstr;

struct Meshed {
  model::SurfaceSet set;
  model::SurfaceMeshed mesh;
};
Meshed meshed(const std::string& text, double size, bool second, bool quads = false) {
  auto made = test::surfaces_of(text);
  EXPECT_TRUE(made.ok()) << (made ? "" : to_string(made.error()));
  Meshed all;
  all.set.faces = std::move(made->faces);
  all.set.chart_units.assign(all.set.faces.size(), {1.0, 1.0});
  auto mesh = mesh_surfaces(
      all.set, {.sizes = {.largest = size, .turn = 10.0}, .quadrilaterals = quads, .second_order = second});
  EXPECT_TRUE(mesh.ok()) << (mesh ? "" : to_string(mesh.error()));
  all.mesh = *std::move(mesh);
  return all;
}

Vector3 total(const Shell& shell) {
  Vector3 sum{};
  for (const auto& [node, force] : shell.forces) sum = sum + force;
  return sum;
}

/// Displacements by node from the .dat of a run of ccx; empty if it failed.
std::vector<Vector3> by_calculix(const std::string& deck, std::size_t nodes) {
  const fs::path folder = fs::temp_directory_path() / ("dobra_shell_" + std::to_string(std::hash<std::string>{}(deck)));
  fs::create_directories(folder);
  EXPECT_TRUE(io::write_file(folder / "deck.inp", deck).ok());
  std::vector<Vector3> u;
  if (std::system(("cd '" + folder.string() + "' && ccx -i deck > ccx.log 2>&1").c_str()) == 0) {
    u.resize(nodes);
    std::ifstream in(folder / "deck.dat");
    for (std::string line; std::getline(in, line);) {
      std::istringstream words(line);
      std::size_t node = 0;
      double x = 0.0, y = 0.0, z = 0.0;
      if (words >> node >> x >> y >> z && node <= nodes) u[node - 1] = {x, y, z};
    }
  }
  fs::remove_all(folder);
  return u;
}

const std::string roof =
    "[[input.surface]]\nname = \"roof\"\nkind = \"cylinder\"\naxis = [0, -1, 0]\nx_axis = [1, 0, 0]\nradius = 25\n"
    "u = [50, 130]\nv = [0, 50]\n"
    "[[input.surface_point]]\nname = \"midside\"\nat = [50, 25]\n"
    "[[input.surface_point]]\nname = \"crown\"\nat = [90, 25]\n";
ShellParams roof_params() {
  ShellParams params;
  params.materials = {{.region = "", .young = 4.32e8, .poisson = 0.0, .thickness = 0.25}};
  params.supports = {{.where = "roof_bottom", .x = 0.0, .z = 0.0},
                     {.where = "roof_top", .x = 0.0, .z = 0.0},
                     {.where = "crown", .y = 0.0}};
  params.loads = {{.where = "", .kind = ShellLoadKind::Area, .z = -90.0}};
  return params;
}

TEST(Shell, ForcesAddUpToWhatTheLoadsSay) {
  for (const bool second : {false, true}) {
    const Meshed plate = meshed(test::plate, 2.0, second);
    ShellParams params;
    params.materials = {{.young = 1.0, .thickness = 0.5}};
    params.supports = {{.where = "plate_left", .x = 0.0}};
    const auto sum = [&](const ShellLoadParams& load) {
      params.loads = {load};
      auto shell = make_shell(plate.mesh.elements, params);
      EXPECT_TRUE(shell.ok()) << (shell ? "" : to_string(shell.error()));
      return total(*shell);
    };
    EXPECT_NEAR(sum({.kind = ShellLoadKind::Area, .x = 3.0}).x, 300.0, 1e-9);
    EXPECT_NEAR(sum({.kind = ShellLoadKind::Body, .z = -2.0}).z, -100.0, 1e-9);
    EXPECT_NEAR(sum({.kind = ShellLoadKind::Pressure, .value = 5.0}).z, -500.0, 1e-9);  // against the normal +z
    EXPECT_NEAR(sum({.where = "plate_top", .kind = ShellLoadKind::Edge, .y = 7.0}).y, 70.0, 1e-9);
  }
  const Meshed half =
      meshed("[[input.surface]]\nname = \"c\"\nkind = \"cylinder\"\nradius = 2\nu = [0, 180]\nv = [0, 3]\n", 0.5, true);
  ShellParams params;
  params.materials = {{.young = 1.0, .thickness = 0.1}};
  params.supports = {{.where = "c_left", .x = 0.0}};
  params.loads = {{.kind = ShellLoadKind::Pressure, .value = 1.0}};
  const auto shell = make_shell(half.mesh.elements, params);
  ASSERT_TRUE(shell.ok());
  // Pressure on half a cylinder: the projected area, 2 r l, against the outward normal.
  EXPECT_NEAR(total(*shell).y, -12.0, 1e-3);
  EXPECT_NEAR(total(*shell).x, 0.0, 1e-3);
}

TEST(Shell, ALoadWithoutANumberIsRefused) {
  const Meshed plate = meshed(test::plate, 3.0, false);
  ShellParams params;
  params.materials = {{.young = 1.0, .thickness = 0.5}};
  params.supports = {{.where = "plate_left", .x = 0.0}};
  for (const ShellLoadKind kind :
       {ShellLoadKind::Area, ShellLoadKind::Body, ShellLoadKind::Edge, ShellLoadKind::Force}) {
    params.loads = {{.where = "plate_top", .kind = kind}};
    EXPECT_THAT(to_string(make_shell(plate.mesh.elements, params).error()), HasSubstr("loads nothing: give x, y or z"));
  }
  params.loads = {{.kind = ShellLoadKind::Pressure, .x = 1.0}};
  EXPECT_THAT(to_string(make_shell(plate.mesh.elements, params).error()), HasSubstr("has no `value`"));
}

TEST(Shell, WhatIsMissingIsNamed) {
  const Meshed plate = meshed(test::plate, 3.0, false);
  ShellParams params;
  params.materials = {{.region = "plte", .young = 1.0, .thickness = 0.5}};
  params.supports = {{.where = "plate_left", .x = 0.0}};
  EXPECT_THAT(to_string(make_shell(plate.mesh.elements, params).error()), HasSubstr("did you mean 'plate'"));
  params.materials = {};
  EXPECT_THAT(to_string(make_shell(plate.mesh.elements, params).error()), HasSubstr("has no `material`"));
  params.materials = {{.young = 1.0, .thickness = 0.5}};
  params.supports[0].where = "left";
  EXPECT_THAT(to_string(make_shell(plate.mesh.elements, params).error()), HasSubstr("no set 'left'"));
  params.supports = {};
  EXPECT_THAT(to_string(make_shell(plate.mesh.elements, params).error()), HasSubstr("support"));
  params.supports = {{.where = "plate_left", .x = 0.0}, {.where = "plate_bottom", .x = 1.0}};
  EXPECT_THAT(to_string(make_shell(plate.mesh.elements, params).error()),
              HasSubstr("different displacements of one node"));
}

bool holds(const std::string& text, const std::string& what) { return text.find(what) != std::string::npos; }

TEST(Shell, DecksHoldSectionsAndElementsOfShells) {
  const Meshed all = meshed(roof, 6.0, true);
  const auto shell = make_shell(all.mesh.elements, roof_params());
  ASSERT_TRUE(shell.ok());
  const std::string inp = shell_inp(all.mesh.elements, *shell, {}).value();
  EXPECT_THAT(inp, testing::AllOf(HasSubstr("TYPE=S6"), HasSubstr("*SHELL SECTION, ELSET=REGION_"), HasSubstr("0.25")));
  const std::string bdf = shell_bdf(all.mesh.elements, *shell, {}).value();
  EXPECT_THAT(bdf, testing::AllOf(HasSubstr("CTRIA6"), HasSubstr("PSHELL*"), HasSubstr("MAT1*"), HasSubstr("SOL 101")));
  // Elements of first order, quadrilaterals, and those of second order.
  const auto kinds = [&](bool second, bool quads) {
    const Meshed own = meshed(roof, 6.0, second, quads);
    const auto made = make_shell(own.mesh.elements, roof_params());
    EXPECT_TRUE(made.ok()) << (made ? "" : to_string(made.error()));
    return std::pair{shell_inp(own.mesh.elements, *made, {}).value(), shell_bdf(own.mesh.elements, *made, {}).value()};
  };
  EXPECT_TRUE(holds(kinds(false, false).first, "TYPE=S3,"));
  EXPECT_TRUE(holds(kinds(false, false).second, "CTRIA3"));
  EXPECT_TRUE(holds(kinds(false, true).first, "TYPE=S4,"));
  EXPECT_TRUE(holds(kinds(false, true).second, "CQUAD4"));
  EXPECT_TRUE(holds(kinds(true, true).first, "TYPE=S8,"));
  EXPECT_TRUE(holds(kinds(true, true).second, "CQUAD8"));
}

TEST(Shell, DecksOfTrianglesOfFirstOrderComeWithARemark) {
  for (const bool second : {false, true}) {
    model::Model model;
    model.surface_meshes.push_back(std::make_shared<const model::SurfaceMeshed>(meshed(roof, 8.0, second).mesh));
    const auto made = add_shell(model, roof_params(), {}, {});
    ASSERT_TRUE(made.ok()) << to_string(made.error());
    EXPECT_EQ(made->remarks.size(), second ? 0U : 1U);
  }
}

TEST(Shell, WhatNothingLoadsIsRemarked) {
  model::Model model;
  model.surface_meshes.push_back(std::make_shared<const model::SurfaceMeshed>(meshed(roof, 8.0, true).mesh));
  ShellParams params = roof_params();
  params.loads.clear();
  const auto told = [&] {
    const auto made = add_shell(model, params, {}, {});
    EXPECT_TRUE(made.ok()) << (made ? "" : to_string(made.error()));
    return made && !made->remarks.empty() && made->remarks[0].find("nothing loads") != std::string::npos;
  };
  EXPECT_TRUE(told());
  params.supports[0].z = 0.01;  // it is lifted
  EXPECT_FALSE(told());
}

/// Of the .inp, for the nodes of a set of sides: the rotations held, as strings of the numbers of the axes.
std::set<std::string> turns_in(const std::string& inp, const Meshed& all, const std::string& set) {
  std::map<std::size_t, std::string> held;
  std::istringstream in(inp.substr(inp.find("*BOUNDARY")));
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line) && line[0] != '*') {
    const char axis = line[line.find(", ") + 2];
    if (axis >= '4') held[std::stoul(line)] += axis;
  }
  std::set<std::string> found;
  for (const auto& side : all.mesh.elements.mesh.side_sets.at(set)) {
    for (const auto node : dobra::mesh::side_nodes(all.mesh.elements.mesh, side)) {
      if (node.valid()) found.insert(held[node.index() + 1]);
    }
  }
  return found;
}

TEST(Shell, CalculixIsGivenNoTurnTwiceNorOneAboutTheNormal) {
  const Meshed all =
      meshed("[[input.surface]]\nname = \"c\"\nkind = \"cylinder\"\nradius = 2\nu = [20, 70]\nv = [0, 3]\n", 0.5, true);
  const base::Angle none = base::Angle::from_degrees(0.0);
  ShellParams params;
  params.materials = {{.young = 1.0, .thickness = 0.1}};
  // The plane of symmetry z = 0: turns about x and y are both about the tangent of the edge.
  params.supports = {{.where = "c_bottom", .z = 0.0, .turn_x = none, .turn_y = none},
                     {.where = "c_top", .x = 0.0, .turn_x = none, .turn_y = none, .turn_z = none}};
  auto shell = make_shell(all.mesh.elements, params);
  ASSERT_TRUE(shell.ok()) << to_string(shell.error());
  std::string inp = shell_inp(all.mesh.elements, *shell, {}).value();
  EXPECT_EQ(turns_in(inp, all, "c_bottom"), (std::set<std::string>{"4", "5"}));
  EXPECT_EQ(turns_in(inp, all, "c_top"), (std::set<std::string>{"46", "56"}));  // clamped
  // A turn that is not nought is written as it is asked for.
  params.supports = {{.where = "c_bottom", .z = 0.0, .turn_x = base::Angle::from_degrees(1.0), .turn_y = none}};
  shell = make_shell(all.mesh.elements, params);
  ASSERT_TRUE(shell.ok());
  inp = shell_inp(all.mesh.elements, *shell, {}).value();
  EXPECT_EQ(turns_in(inp, all, "c_bottom"), (std::set<std::string>{"45"}));
}

TEST(Shell, TurnsOfAPlateAndOfAKinkAreThoseThatAreAskedFor) {
  const base::Angle none = base::Angle::from_degrees(0.0);
  const Meshed plate = meshed(test::plate, 3.0, false);
  ShellParams params;
  params.materials = {{.young = 1.0, .thickness = 0.1}};
  params.supports = {{.where = "plate_left", .x = 0.0, .turn_x = none, .turn_y = none},
                     {.where = "plate_right", .x = 0.0, .turn_z = none}};
  auto shell = make_shell(plate.mesh.elements, params);
  ASSERT_TRUE(shell.ok()) << to_string(shell.error());
  const std::string inp = shell_inp(plate.mesh.elements, *shell, {}).value();
  EXPECT_EQ(turns_in(inp, plate, "plate_left"), (std::set<std::string>{"45"}));
  EXPECT_EQ(turns_in(inp, plate, "plate_right"), (std::set<std::string>{""}));  // about the normal
  const Meshed roof = meshed(
      "[[input.surface]]\nname = \"a\"\nkind = \"plane\"\nu = [0, 1]\nv = [0, 2]\n"
      "[[input.surface]]\nname = \"b\"\nkind = \"plane\"\naxis = [1, 0, 0]\nx_axis = [0, 1, 0]\nu = [0, 2]\nv = [0, "
      "1]\n",
      0.5, false);
  params.supports = {{.where = "a_left", .x = 0.0, .turn_x = none, .turn_y = none, .turn_z = none}};
  shell = make_shell(roof.mesh.elements, params);
  ASSERT_TRUE(shell.ok()) << to_string(shell.error());
  EXPECT_EQ(turns_in(shell_inp(roof.mesh.elements, *shell, {}).value(), roof, "a_left"),
            (std::set<std::string>{"456"}));
}

TEST(Shell, CalculixFindsTheDeflectionOfTheRoofOfScordelisAndLo) {
  if (std::system("command -v ccx > /dev/null") != 0) GTEST_SKIP() << "ccx is not installed (Debian: calculix-ccx)";
  const Meshed all = meshed(roof, 2.5, true);
  const auto shell = make_shell(all.mesh.elements, roof_params());
  ASSERT_TRUE(shell.ok()) << to_string(shell.error());
  EXPECT_NEAR(total(*shell).z, -90.0 * 25 * (80 * std::numbers::pi / 180) * 50, 10.0);
  const auto u = by_calculix(shell_inp(all.mesh.elements, *shell, {}).value(), all.mesh.elements.mesh.points.size());
  ASSERT_FALSE(u.empty());
  const double sunk = -u[all.mesh.elements.mesh.node_sets.at("midside")[0].index()].z;
  std::printf("[ figures  ] Scordelis-Lo, %zu S6: %.4f (0.3024)\n", all.mesh.elements.mesh.element_count(), sunk);
  EXPECT_NEAR(sunk, 0.3024, 0.03 * 0.3024);
}

TEST(Shell, CalculixFindsTheDeflectionOfThePinchedCylinder) {
  if (std::system("command -v ccx > /dev/null") != 0) GTEST_SKIP() << "ccx is not installed (Debian: calculix-ccx)";
  const Meshed all = meshed(
      "[[input.surface]]\nname = \"c\"\nkind = \"cylinder\"\nradius = 300\nu = [0, 90]\nv = [0, 300]\n"
      "[[input.surface_point]]\nname = \"pinch\"\nat = [0, 0]\n",
      15.0, true);
  const base::Angle none = base::Angle::from_degrees(0.0);
  ShellParams params;
  params.materials = {{.young = 3e6, .poisson = 0.3, .thickness = 3.0}};
  params.supports = {{.where = "c_bottom", .z = 0.0, .turn_x = none, .turn_y = none},
                     {.where = "c_left", .y = 0.0, .turn_x = none, .turn_z = none},
                     {.where = "c_right", .x = 0.0, .turn_y = none, .turn_z = none},
                     {.where = "c_top", .x = 0.0, .y = 0.0}};
  params.loads = {{.where = "pinch", .kind = ShellLoadKind::Force, .x = -0.25}};
  const auto shell = make_shell(all.mesh.elements, params);
  ASSERT_TRUE(shell.ok()) << to_string(shell.error());
  const auto u = by_calculix(shell_inp(all.mesh.elements, *shell, {}).value(), all.mesh.elements.mesh.points.size());
  ASSERT_FALSE(u.empty());
  const double moved = -u[all.mesh.elements.mesh.node_sets.at("pinch")[0].index()].x;
  std::printf("[ figures  ] pinched cylinder, %zu S6: %.4e (1.8248e-5)\n", all.mesh.elements.mesh.element_count(),
              moved);
  EXPECT_NEAR(moved, 1.8248e-5, 0.05 * 1.8248e-5);
}

}  // namespace
}  // namespace quebra::surfaces
