#include "quebra/analysis/deck.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "shared/fem/error/exact_fields.h"
#include "shared/fem/solve.h"
#include "shared/io/file.h"
#include "tests/support/cracked_plates.h"
#include "tests/support/fem_meshes.h"

namespace quebra::analysis {
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
  problem.cases[0].sides = {{"right", fem::traction_of([](Point p) { return fem::error::kirsch_stress(p); })}};
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
    std::printf("[ figures  ] CalculiX, plane strain, %s: differs by %.1e of the greatest displacement\n",
                name_of(type), off);
    EXPECT_LT(off, 1e-6) << name_of(type);
  }
  // Curved sides too, but for T6: CalculiX integrates its wedges by three points in the plane, we a curved T6 by seven.
  EXPECT_LT(difference(quarter_plate(mesh::ElementType::Q8, 6), kirsch(fem::PlaneState::Strain)), 1e-6);
  const double curved = difference(quarter_plate(mesh::ElementType::T6, 6), kirsch(fem::PlaneState::Strain));
  std::printf("[ figures  ] CalculiX, plane strain, T6 with curved sides: %.1e\n", curved);
  EXPECT_LT(curved, 2e-3);
}

TEST(Deck, CalculixFindsTheSameDisplacementsInPlaneStress) {
  if (std::system("command -v ccx > /dev/null") != 0) GTEST_SKIP() << "ccx is not installed (Debian: calculix-ccx)";
  for (const auto type : all_types) {
    for (const double poisson : {0.0, 0.3, 0.5, -0.3}) {
      fem::Problem problem = kirsch(fem::PlaneState::Stress);
      problem.materials.at(0).poisson = poisson;
      const double off = difference(straight_plate(type, 6), problem);
      std::printf("[ figures  ] CalculiX, plane stress, nu = %g, %s: differs by %.1e\n", poisson, name_of(type), off);
      EXPECT_LT(off, 1e-6) << name_of(type) << " " << poisson;
    }
  }
  fem::Problem problem = kirsch(fem::PlaneState::Stress);
  problem.materials.at(0).poisson = -0.6;
  EXPECT_THAT(to_string(*deck_gap(straight_plate(mesh::ElementType::T3, 2), problem)),
              testing::HasSubstr("nu <= -0.5"));
}

TEST(Deck, CalculixDiffersAtRosettesByItsIntegrationOnly) {
  if (std::system("command -v ccx > /dev/null") != 0) GTEST_SKIP() << "ccx is not installed (Debian: calculix-ccx)";
  // Its wedges of 15 nodes have three integration points in the plane, our quarter-point triangles seven.
  for (const bool quarter : {false, true}) {
    CrackedPlate plate{.outline = {{0, -1.5}, {1, -1.5}, {1, 0}, {1, 1.5}, {0, 1.5}, {0, 0}},
                       .cracks = {{{0, 0}, {0.5, 0}}},
                       .rosette = {.radius = 0.5 / 80}};
    plate.quarter = quarter;
    mesh::ElementMesh mesh = cracked_plate(plate);
    name_node(mesh, "anchor", {1, 0});
    name_node(mesh, "guide", {1, -1.5});
    for (const auto state : {fem::PlaneState::Strain, fem::PlaneState::Stress}) {
      fem::Problem problem{.materials = {{0, {.young = 1.0, .poisson = 0.3, .state = state}}},
                           .supports = {{.where = "anchor", .x = 0.0, .y = 0.0}, {.where = "guide", .x = 0.0}}};
      problem.cases[0].sides = {{"side 0", fem::uniform({0, -1})}, {"side 3", fem::uniform({0, 1})}};
      const double off = difference(mesh, problem);
      std::printf("[ figures  ] CalculiX, edge crack, %s quarter points, plane %s: %.1e\n",
                  quarter ? "with" : "without", state == fem::PlaneState::Strain ? "strain" : "stress", off);
      EXPECT_LT(off, quarter ? 1e-4 : 1e-6);
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
  problem.ties = {{"tie",
                   {{mesh.node_sets.at("a")[0], fem::Axis::X, 1.0}, {mesh.node_sets.at("b")[0], fem::Axis::X, -2.0}},
                   0.003}};
  problem.cases[0].sides = {{"right", fem::uniform({1.0, 0.5})}};
  EXPECT_LT(difference(mesh, problem), 1e-6);
}

TEST(Deck, InclinedSupportsAreEquations) {
  if (std::system("command -v ccx > /dev/null") != 0) GTEST_SKIP() << "ccx is not installed (Debian: calculix-ccx)";
  const mesh::ElementMesh mesh = mapped_grid(mesh::ElementType::Q8, 3, 2, [](double x, double y) {
    return Point{2 * x - 0.5 * y, x + y};
  });
  fem::Problem problem = kirsch(fem::PlaneState::Strain);
  problem.supports = {{.where = "bottom", .normal = 0.0}, {.where = "left", .normal = 0.0}};
  problem.cases[0].sides = {{"right", fem::uniform({1.0, 0.5})}};
  EXPECT_LT(difference(mesh, problem), 1e-6);
}

TEST(Deck, WhatTheFormatCannotSayIsRefusedByName) {
  const mesh::ElementMesh mesh = quarter_plate(mesh::ElementType::Q8, 2);
  fem::Problem problem = kirsch(fem::PlaneState::Strain);
  problem.springs = {{"bottom", 0.0, 1.0, fem::SpringKind::Foundation}};
  EXPECT_THAT(to_string(deck_text(mesh, problem).error()),
              testing::HasSubstr("bed along 'bottom': a deck has no words for a bed of springs"));
  EXPECT_TRUE(deck_gap(mesh, problem).has_value());
  problem.springs = {{"right", 1.0, 0.0}};
  problem.ties = fem::equal_displacement(mesh, "right", fem::Axis::X).value();
  EXPECT_THAT(to_string(deck_text(mesh, problem).error()),
              testing::HasSubstr("a deck cannot have springs at every displacement of a tie"));
  problem.springs = {{"right", 0.0, 1.0}};
  EXPECT_FALSE(deck_gap(mesh, problem).has_value());
}

}  // namespace
}  // namespace quebra::analysis
