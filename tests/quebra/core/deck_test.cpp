#include "quebra/core/deck.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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
      if (words >> node >> x >> y) u.at(node - 1) = {x, y};
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

TEST(Deck, CalculixFindsTheSameDisplacementsInPlaneStrain) {
  if (std::system("command -v ccx > /dev/null") != 0) GTEST_SKIP() << "ccx is not installed (Debian: calculix-ccx)";
  const mesh::ElementMesh mesh = quarter_plate(mesh::ElementType::Q8, 6);
  EXPECT_LT(difference(mesh, kirsch(fem::PlaneState::Strain)), 1e-6);
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

TEST(Deck, WhatTheFormatCannotSayIsRefused) {
  const mesh::ElementMesh mesh = quarter_plate(mesh::ElementType::Q8, 2);
  fem::Problem problem = kirsch(fem::PlaneState::Strain);
  problem.springs = {{"bottom", 0.0, 1.0}};
  EXPECT_THAT(to_string(deck_text(mesh, problem).error()), testing::HasSubstr("springs are not written"));
  problem.springs.clear();
  problem.supports.push_back({.where = "right", .normal = 0.1});
  EXPECT_THAT(to_string(deck_text(mesh, problem).error()), testing::HasSubstr("support of 'right'"));
}

}  // namespace
}  // namespace quebra::core
