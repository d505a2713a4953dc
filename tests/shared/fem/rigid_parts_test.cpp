#include "shared/fem/rigid_parts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/fem_meshes.h"

namespace dobra::fem {
namespace {

using namespace test;
using testing::HasSubstr;

constexpr Material steel{.young = 1.0, .poisson = 0.3};

std::string trouble(const ElementMesh& mesh, const Problem& problem) {
  const auto held = check_supported(mesh, problem, constraints_of(mesh, problem));
  return held ? "" : to_string(held.error());
}

/// Two squares side by side with a gap of one cell, of regions 1 and 2; or touching in the corner (1, 1).
ElementMesh two_squares(bool touching) {
  ElementMesh mesh = mapped_grid(
      ElementType::Q4, 6, 4,
      [](double s, double t) {
        return Point{3 * s, 2 * t};
      },
      {.keep = [=](int i,
                   int j) { return touching ? (i < 2 && j < 2) || (i >= 2 && i < 4 && j >= 2) : i < 2 || i >= 4; },
       .region = [](int i, int) { return i < 2 ? 1 : 2; }});
  mesh.region_names = {{1, "frame"}, {2, "block"}};
  return mesh;
}

TEST(RigidParts, AMeshWithoutSupportsCanDoEverything) {
  const ElementMesh mesh = mapped_grid(ElementType::T3, 2, 2, unit_square);
  EXPECT_THAT(trouble(mesh, {.materials = {{0, steel}}}),
              HasSubstr("the part of 8 elements in region 0 is not held: it can move along x, along y and turn"));
}

TEST(RigidParts, WhatIsMissingIsNamed) {
  ElementMesh mesh = mapped_grid(ElementType::T6, 2, 2, unit_square);
  name_node(mesh, "corner", {0, 0});
  name_node(mesh, "other", {1, 0});
  const auto with = [&](std::vector<Support> supports) {
    return trouble(mesh, {.materials = {{0, steel}}, .supports = std::move(supports)});
  };
  EXPECT_THAT(with({{.where = "bottom", .y = 0.0}}), HasSubstr("it can move along x;"));
  EXPECT_THAT(with({{.where = "left", .normal = 0.0}}), HasSubstr("it can move along y;"));
  EXPECT_THAT(with({{.where = "corner", .x = 0.0, .y = 0.0}}), HasSubstr("it can turn about (0, 0)"));
  EXPECT_THAT(with({{.where = "corner", .y = 0.0}}), HasSubstr("it can move along x and turn"));
  EXPECT_EQ(with({{.where = "corner", .x = 0.0, .y = 0.0}, {.where = "other", .y = 0.0}}), "");
  // Two rollers whose lines meet in (1, 0) leave the turn about that point.
  EXPECT_EQ(with({{.where = "corner", .y = 0.0}, {.where = "other", .x = 0.0, .y = 0.0}}), "");
  EXPECT_THAT(with({{.where = "corner", .x = 0.0}, {.where = "other", .y = 0.0}}),
              HasSubstr("it can turn about (1, 0)"));
}

TEST(RigidParts, TheFloatingPartIsNamedByItsRegion) {
  const ElementMesh mesh = two_squares(false);
  const Problem problem{.materials = {{1, steel}, {2, steel}}, .supports = {{.where = "left", .x = 0.0, .y = 0.0}}};
  EXPECT_THAT(trouble(mesh, problem), HasSubstr("the part of 8 elements in region 'block' is not held"));
}

TEST(RigidParts, PartsThatTouchInACornerAreAHinge) {
  const ElementMesh mesh = two_squares(true);
  Problem problem{.materials = {{1, steel}, {2, steel}}, .supports = {{.where = "left", .x = 0.0, .y = 0.0}}};
  EXPECT_THAT(trouble(mesh, problem), HasSubstr("region 'block' is not held: it can turn about (1, 1)"));
  problem.supports.push_back({.where = "top", .y = 0.0});
  EXPECT_EQ(trouble(mesh, problem), "");
}

TEST(RigidParts, TiesAndSpringsHoldToo) {
  const ElementMesh mesh = two_squares(false);
  Problem problem{.materials = {{1, steel}, {2, steel}}, .supports = {{.where = "left", .x = 0.0, .y = 0.0}}};
  for (const double y : {0.0, 2.0}) {
    for (const Axis axis : {Axis::X, Axis::Y})
      problem.ties.push_back({"tie", {{node_at(mesh, {1, y}), axis, 1.0}, {node_at(mesh, {2, y}), axis, -1.0}}});
  }
  EXPECT_EQ(trouble(mesh, problem), "");
  problem.ties.pop_back();
  EXPECT_EQ(trouble(mesh, problem), "");
  problem.ties.pop_back();
  EXPECT_THAT(trouble(mesh, problem), HasSubstr("it can turn about (2, 0)"));
  problem.springs = {{"right", 1e-3, 0.0}};
  EXPECT_EQ(trouble(mesh, problem), "");
}

}  // namespace
}  // namespace dobra::fem
