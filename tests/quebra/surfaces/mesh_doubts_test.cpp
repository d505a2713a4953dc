// What meshes of surfaces are doubted for, and what they are not.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "quebra/surfaces/mesh_doubts.h"
#include "quebra/surfaces/mesh_surfaces.h"
#include "tests/support/surface_scenarios.h"

namespace quebra::surfaces::mesh_doubts_test {
namespace {

using namespace dobra;
using test::plate;
using test::surfaces_of;
using testing::Contains;
using testing::IsEmpty;
using testing::Not;

std::vector<std::string> doubts(const std::string& text, SurfaceMeshOptions options) {
  const auto made = surfaces_of(text);
  EXPECT_TRUE(made.ok()) << (made ? "" : to_string(made.error()));
  if (!made) return {};
  model::SurfaceSet set{.faces = made->faces, .chart_units = {}, .parts = made->parts};
  for (const ChartUnits& units : made->units) set.chart_units.push_back({units.u, units.v});
  const auto mesh = mesh_surfaces(set, options);
  EXPECT_TRUE(mesh.ok()) << (mesh ? "" : to_string(mesh.error()));
  std::vector<std::string> codes;
  if (!mesh) return codes;
  for (const auto& each : mesh->findings) codes.push_back(each.code);
  return codes;
}

std::string hole(const std::string& name, double x, double radius) {
  return "[[input.trim]]\nname = \"" + name + "\"\nkind = \"ellipse\"\nrole = \"hole\"\ncentre = [" +
         std::to_string(x) + ", 5]\nradii = [" + std::to_string(radius) + ", " + std::to_string(radius) + "]\n";
}

TEST(MeshDoubts, HolesThatTouchAreTold) {
  const SurfaceMeshOptions half{.sizes = {.largest = 0.5}};
  EXPECT_THAT(doubts(plate + hole("a", 3, 1) + hole("b", 5, 1), half), Contains("hangs_on_node"));
  EXPECT_THAT(doubts(plate + hole("a", 3, 1) + hole("b", 5.5, 1), half), Not(Contains("hangs_on_node")));
  EXPECT_THAT(doubts(plate + hole("a", 1, 1), half), Contains("hangs_on_node"));  // the border
}

TEST(MeshDoubts, AnAreaThatMayBeOffIsTold) {
  const surf::trim::TrimmedSurface face{.surface = *surf::Surface::plane({}, {{0, 0}, {2, 1}}), .name = "a"};
  std::vector<surf::mesh::Finding> findings;
  doubt_area(face, {2.0, 1e-3}, findings);
  EXPECT_THAT(findings, IsEmpty());
  doubt_area(face, {2.0, 0.01}, findings);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].code, "area_unsure");
  EXPECT_EQ(findings[0].place.item, "a");
}

TEST(MeshDoubts, AnApexIsOneFan) {
  EXPECT_THAT(doubts("[[input.surface]]\nname = \"c\"\nkind = \"cone\"\nradius = 0\nhalf_angle = 45\nv = [0, 2]\n",
                     {.sizes = {.largest = 0.5}}),
              IsEmpty());
}

TEST(MeshDoubts, ElementsThatTheirBentSidesFoldAreTold) {
  const std::string ring = "[[input.surface]]\nname = \"c\"\nkind = \"torus\"\nradius = 5\nminor_radius = 2\n";
  const std::string thin = "[[input.surface]]\nname = \"c\"\nkind = \"torus\"\nradius = 5\nminor_radius = 0.5\n";
  SurfaceMeshOptions options{.sizes = {.largest = 50, .turn = 90}, .second_order = true};
  EXPECT_THAT(doubts(thin, options), Contains("against_surface"));
  options.sizes.turn = 30;
  EXPECT_THAT(doubts(ring, options), Not(Contains("against_surface")));
  options.sizes.turn = 20;
  EXPECT_THAT(doubts(ring, options), IsEmpty());
  options.quadrilaterals = true;
  EXPECT_THAT(doubts(ring, options), IsEmpty());
  options.sizes.turn = 10;
  EXPECT_THAT(doubts("[[input.surface]]\nname = \"c\"\nkind = \"sphere\"\nradius = 2\n", options), IsEmpty());
}

}  // namespace
}  // namespace quebra::surfaces::mesh_doubts_test
