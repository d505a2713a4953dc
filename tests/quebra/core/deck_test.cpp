#include "quebra/core/deck.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "shared/fem/exact_fields.h"
#include "shared/fem/solve.h"
#include "shared/io/file.h"
#include "tests/support/fem_meshes.h"

namespace quebra::core {
namespace {

namespace fs = std::filesystem;
using namespace dobra;
using namespace dobra::fem::test;

/// The displacements in the .dat file of a run of ccx; empty if ccx failed.
std::vector<geom::Vector> by_calculix(const std::string& deck, std::size_t nodes) {
  const fs::path folder = fs::temp_directory_path() / ("dobra_deck_" + std::to_string(std::hash<std::string>{}(deck)));
  fs::create_directories(folder);
  EXPECT_TRUE(io::write_file(folder / "deck.inp", deck).ok());
  const std::string command = "cd '" + folder.string() + "' && ccx -i deck > ccx.log 2>&1";
  std::vector<geom::Vector> u;
  if (std::system(command.c_str()) == 0) {
    u.resize(nodes);
    std::ifstream in(folder / "deck.dat");
    for (std::string line; std::getline(in, line);) {
      std::istringstream words(line);
      std::size_t node = 0;
      double x = 0.0, y = 0.0;
      if (words >> node >> x >> y && node <= nodes) u[node - 1] = {x, y};  // further nodes hold values of ties
    }
  }
  fs::remove_all(folder);
  return u;
}

/// Greatest difference of displacements over the greatest displacement.
double difference(const mesh::ElementMesh& mesh, const fem::Problem& problem) {
  const auto ours = fem::solve(mesh, problem).value().cases[0].displacements;
  const auto theirs = by_calculix(deck_text(mesh, problem).value(), mesh.points.size());
  if (theirs.empty()) return std::numeric_limits<double>::infinity();
  double off = 0.0, greatest = 0.0;
  for (std::size_t n = 0; n < ours.size(); ++n) {
    off = std::max(off, length(ours[n] - theirs[n]));
    greatest = std::max(greatest, length(ours[n]));
  }
  return off / greatest;
}

fem::Problem kirsch(fem::PlaneState state) {
  fem::Problem problem{.materials = {{0, {.young = 1000.0, .poisson = 0.3, .thickness = 0.5, .state = state}}},
                       .supports = {{.where = "bottom", .y = 0.0}, {.where = "top", .x = 0.0}}};
  problem.cases[0].sides = {{"right", fem::traction_of([](Point p) { return fem::kirsch_stress(p); })}};
  return problem;
}

/// As quarter_plate, the quarter of arc as chords; straight sides everywhere.
mesh::ElementMesh straight_plate(mesh::ElementType type, int n) {
  mesh::ElementMesh plate = quarter_plate(type, n);
  for (std::size_t e = 0; e < plate.element_count(); ++e) {
    for (std::uint32_t i = 0; i < mesh::corner_count(plate.types[e]); ++i) {
      const auto [from, to, middle] = side_nodes(plate, {mesh::ElementId(e), i});
      if (middle.valid()) plate.points[middle.index()] = midpoint(plate.point(from), plate.point(to));
    }
  }
  return plate;
}

TEST(Deck, CalculixFindsTheSameDisplacementsInPlaneStrain) {
  if (std::system("command -v ccx > /dev/null") != 0) GTEST_SKIP() << "ccx is not installed (Debian: calculix-ccx)";
  for (const auto type : all_types) {
    const double off = difference(straight_plate(type, 6), kirsch(fem::PlaneState::Strain));
    std::printf("[ figures  ] CalculiX, plane strain, %s: differs by %.1e of the greatest displacement\n", name_of(type), off);
    EXPECT_LT(off, 1e-6) << name_of(type);
  }
  // Curved sides too, but for T6: CalculiX integrates its wedges by three points in the plane, we a curved T6 by seven.
  EXPECT_LT(difference(quarter_plate(mesh::ElementType::Q8, 6), kirsch(fem::PlaneState::Strain)), 1e-6);
  const double curved = difference(quarter_plate(mesh::ElementType::T6, 6), kirsch(fem::PlaneState::Strain));
  std::printf("[ figures  ] CalculiX, plane strain, T6 with curved sides: %.1e\n", curved);
  EXPECT_LT(curved, 2e-3);
}

TEST(Deck, CalculixFindsTheSameDisplacementsInPlaneStressWhereTheThicknessStaysEven) {
  if (std::system("command -v ccx > /dev/null") != 0) GTEST_SKIP() << "ccx is not installed (Debian: calculix-ccx)";
  for (const auto type : all_types) {
    // Without contraction across, and under a uniform stress with it.
    fem::Problem problem = kirsch(fem::PlaneState::Stress);
    problem.materials.at(0).poisson = 0.0;
    const double without = difference(straight_plate(type, 6), problem);
    const mesh::ElementMesh bar = mapped_grid(type, 4, 2, [](double x, double y) { return Point{2 * x, y + 0.3 * x * y}; });
    problem.materials.at(0).poisson = 0.3;
    problem.supports = {{.where = "left", .x = 0.0}, {.where = "bottom", .y = 0.0}};
    const auto even_stress = fem::traction_of([](Point) { return fem::Voigt{1.0, 0.0, 0.0}; });
    problem.cases[0].sides = {{"right", even_stress}, {"top", even_stress}};
    const double even = difference(bar, problem);
    std::printf("[ figures  ] CalculiX, plane stress, %s: nu = 0 %.1e, even stress %.1e\n", name_of(type), without, even);
    EXPECT_LT(without, 1e-6) << name_of(type);
    EXPECT_LT(even, 1e-6) << name_of(type);
  }
}

TEST(Deck, CalculixsPlaneStressDiffersByTheShearOfAThicknessThatVaries) {
  if (std::system("command -v ccx > /dev/null") != 0) GTEST_SKIP() << "ccx is not installed (Debian: calculix-ccx)";
  for (const auto type : all_types) {
    // What is left in a thin plate is that the thickness is interpolated: less on a finer mesh.
    double thin = 1.0;
    for (const int n : {6, 12}) {
      double thicker = 1.0;
      for (const double thickness : {0.5, 0.02}) {
        fem::Problem problem = kirsch(fem::PlaneState::Stress);
        problem.materials.at(0).thickness = thickness;
        const double off = difference(straight_plate(type, n), problem);
        std::printf("[ figures  ] CalculiX, plane stress, nu = 0.3, %s, %d x %d cells, thickness %g of the hole's radius: %.1e\n", name_of(type), n, n, thickness, off);
        EXPECT_LT(off, thicker) << name_of(type);
        thicker = off;
      }
      EXPECT_LT(thicker, thin) << name_of(type);
      thin = thicker;
    }
  }
}

TEST(Deck, SpringsAndTiesWithValuesAreWritten) {
  if (std::system("command -v ccx > /dev/null") != 0) GTEST_SKIP() << "ccx is not installed (Debian: calculix-ccx)";
  mesh::ElementMesh mesh = mapped_grid(mesh::ElementType::Q8, 3, 2, unit_square);
  name_node(mesh, "a", {1, 0});
  name_node(mesh, "b", {1, 1});
  fem::Problem problem = kirsch(fem::PlaneState::Strain);
  problem.supports = {{.where = "left", .x = 0.0}, {.where = "bottom", .y = 0.0}};
  problem.springs = {{"right", 0.0, 300.0}, {"b", 20.0, 50.0}};
  problem.ties = {{"tie", {{mesh.node_sets.at("a")[0], fem::Axis::X, 1.0}, {mesh.node_sets.at("b")[0], fem::Axis::X, -2.0}}, 0.003}};
  problem.cases[0].sides = {{"right", fem::uniform({1.0, 0.5})}};
  EXPECT_LT(difference(mesh, problem), 1e-6);
}

TEST(Deck, InclinedSupportsAreEquations) {
  if (std::system("command -v ccx > /dev/null") != 0) GTEST_SKIP() << "ccx is not installed (Debian: calculix-ccx)";
  const mesh::ElementMesh mesh =
      mapped_grid(mesh::ElementType::Q8, 3, 2, [](double x, double y) { return Point{2 * x - 0.5 * y, x + y}; });
  fem::Problem problem = kirsch(fem::PlaneState::Strain);
  problem.supports = {{.where = "bottom", .normal = 0.0}, {.where = "left", .normal = 0.0}};
  problem.cases[0].sides = {{"right", fem::uniform({1.0, 0.5})}};
  EXPECT_LT(difference(mesh, problem), 1e-6);
}

TEST(Deck, WhatTheFormatCannotSayIsRefusedByName) {
  const mesh::ElementMesh mesh = quarter_plate(mesh::ElementType::Q8, 2);
  fem::Problem problem = kirsch(fem::PlaneState::Strain);
  problem.springs = {{"bottom", 0.0, 1.0, fem::SpringKind::Foundation}};
  EXPECT_THAT(to_string(deck_text(mesh, problem).error()), testing::HasSubstr("bed along 'bottom': a deck has no words for a bed of springs"));
  EXPECT_TRUE(deck_gap(mesh, problem).has_value());
  problem.springs = {{"right", 1.0, 0.0}};
  problem.ties = fem::equal_displacement(mesh, "right", fem::Axis::X).value();
  EXPECT_THAT(to_string(deck_text(mesh, problem).error()), testing::HasSubstr("a deck cannot have springs at every displacement of a tie"));
  problem.springs = {{"right", 0.0, 1.0}};
  EXPECT_FALSE(deck_gap(mesh, problem).has_value());
}

}  // namespace
}  // namespace quebra::core
