#include "shared/mesh/lips.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "tests/shared/mesh/element_shapes.h"

namespace dobra::mesh {
namespace {

using geom::Point;
using test::add_chain;
using test::triangle_grid;

/// How many nodes lie at each point where there is more than one.
std::map<Point, std::size_t> coincident(const ElementMesh& mesh) {
  std::map<Point, std::size_t> count;
  for (const Point p : mesh.points) ++count[p];
  std::erase_if(count, [](const auto& entry) { return entry.second == 1; });
  return count;
}

ElementMesh opened(const ElementMesh& mesh, const std::vector<std::string>& cracks) {
  auto result = open_lips(mesh, cracks);
  EXPECT_TRUE(result.ok()) << (result ? "" : to_string(result.error()));
  EXPECT_TRUE(check(*result).ok());
  EXPECT_EQ(result->element_count(), mesh.element_count());
  EXPECT_DOUBLE_EQ(area(*result), area(mesh));
  return *std::move(result);
}

/// Every left side faces a right side at the same points, and neither has a neighbour.
void expect_lips(const ElementMesh& mesh, const std::string& crack) {
  const auto& left = mesh.side_sets.at(crack + "_left");
  const auto& right = mesh.side_sets.at(crack + "_right");
  ASSERT_EQ(left.size(), right.size());
  const auto outer = boundary_sides(mesh);
  for (std::size_t i = 0; i < left.size(); ++i) {
    EXPECT_TRUE(std::binary_search(outer.begin(), outer.end(), left[i]));
    EXPECT_TRUE(std::binary_search(outer.begin(), outer.end(), right[i]));
    const auto a = side_nodes(mesh, left[i]);
    const auto b = side_nodes(mesh, right[i]);
    EXPECT_EQ(mesh.point(a[0]), mesh.point(b[1]));
    EXPECT_EQ(mesh.point(a[1]), mesh.point(b[0]));
  }
}

TEST(Lips, ACrackInsideOpensBetweenItsTwoTips) {
  ElementMesh mesh = triangle_grid(6);
  add_chain(mesh, "crack", {{1, 3}, {2, 3}, {3, 3}, {4, 3}});
  const ElementMesh open = opened(mesh, {"crack"});
  EXPECT_EQ(open.points.size(), mesh.points.size() + 2);
  EXPECT_EQ(coincident(open), (std::map<Point, std::size_t>{{{2, 3}, 2}, {{3, 3}, 2}}));
  expect_lips(open, "crack");
  ASSERT_EQ(open.tips.size(), 2U);
  EXPECT_EQ(open.tips[0].name, "crack_start");
  EXPECT_EQ(open.point(open.tips[0].node), (Point{1, 3}));
  EXPECT_EQ(open.tips[0].direction, (geom::Vector{-1, 0}));
  EXPECT_EQ(open.tips[1].direction, (geom::Vector{1, 0}));
  EXPECT_EQ(open.node_sets.at("crack_end"), std::vector{open.tips[1].node});
}

TEST(Lips, ACrackFromTheBoundaryOpensThere) {
  ElementMesh mesh = triangle_grid(4);
  add_chain(mesh, "notch", {{0, 2}, {1, 2}, {2, 2}});
  mesh.node_sets["mouth"] = {NodeId(10)};
  const ElementMesh open = opened(mesh, {"notch"});
  EXPECT_EQ(coincident(open), (std::map<Point, std::size_t>{{{0, 2}, 2}, {{1, 2}, 2}}));
  ASSERT_EQ(open.tips.size(), 1U);
  EXPECT_EQ(open.tips[0].name, "notch_end");
  EXPECT_EQ(open.node_sets.at("mouth").size(), 2U) << "a set that held the mouth holds both lips' nodes";
}

TEST(Lips, ACrackThroughTheWholePlateCutsItInTwo) {
  ElementMesh mesh = triangle_grid(3);
  add_chain(mesh, "cut", {{0, 1}, {1, 1}, {2, 1}, {3, 1}});
  const ElementMesh open = opened(mesh, {"cut"});
  EXPECT_EQ(coincident(open).size(), 4U);
  EXPECT_TRUE(open.tips.empty());
}

TEST(Lips, BranchesAndCrossingsComeApartIntoAsManyFansAsArms) {
  ElementMesh branch = triangle_grid(6);
  add_chain(branch, "stem", {{3, 0}, {3, 1}, {3, 2}, {3, 3}});
  add_chain(branch, "left", {{3, 3}, {2, 3}, {1, 3}});
  add_chain(branch, "right", {{3, 3}, {4, 3}, {5, 3}});
  const ElementMesh three = opened(branch, {"stem", "left", "right"});
  EXPECT_EQ(coincident(three).at({3, 3}), 3U);
  EXPECT_EQ(three.tips.size(), 2U);

  ElementMesh cross = triangle_grid(6);
  add_chain(cross, "h", {{1, 3}, {2, 3}, {3, 3}, {4, 3}, {5, 3}});
  add_chain(cross, "v", {{3, 1}, {3, 2}, {3, 3}, {3, 4}, {3, 5}});
  const ElementMesh four = opened(cross, {"h", "v"});
  EXPECT_EQ(coincident(four).at({3, 3}), 4U);
  EXPECT_EQ(four.tips.size(), 4U);
  for (const char* const name : {"h", "v"}) expect_lips(four, name);
}

TEST(Lips, TwoCracksThatEndInOneBoundaryNodeGiveThreeNodesThere) {
  ElementMesh mesh = triangle_grid(4);
  add_chain(mesh, "a", {{0, 2}, {1, 2}, {2, 2}});
  add_chain(mesh, "b", {{0, 2}, {1, 3}, {2, 4}});
  const ElementMesh open = opened(mesh, {"a", "b"});
  EXPECT_EQ(coincident(open).at({0, 2}), 3U);
  EXPECT_EQ(coincident(open).at({2, 4}), 2U) << "b reaches the top";
}

TEST(Lips, WhatCannotOpenIsNamedWithItsPlace) {
  ElementMesh mesh = triangle_grid(4);
  add_chain(mesh, "short", {{1, 1}, {2, 1}});
  const std::vector<std::string> one{"short"};
  const auto closed = open_lips(mesh, one);
  ASSERT_FALSE(closed.ok());
  EXPECT_NE(closed.error().message.find("single edge"), std::string::npos);
  EXPECT_EQ(closed.error().place->x, 1.0);

  ElementMesh edge = triangle_grid(4);
  add_chain(edge, "rim", {{1, 0}, {2, 0}});
  const std::vector<std::string> rim{"rim"};
  EXPECT_EQ(open_lips(edge, rim).error().code, base::ErrorCode::CannotMesh);
  const std::vector<std::string> unknown{"unknown"};
  EXPECT_EQ(open_lips(mesh, unknown).error().code, base::ErrorCode::InvalidOption);
}

TEST(Lips, TipsAreFoundAgainByTheirNames) {
  ElementMesh mesh = triangle_grid(6);
  add_chain(mesh, "crack", {{1, 3}, {2, 3}, {3, 3}, {4, 4}});
  const ElementMesh open = opened(mesh, {"crack"});
  ElementMesh read = open;
  read.tips.clear();
  restore_tips(read);
  auto wanted = open.tips;
  std::sort(wanted.begin(), wanted.end(), [](const auto& a, const auto& b) { return a.name > b.name; });
  EXPECT_EQ(read.tips, wanted);
}

}  // namespace
}  // namespace dobra::mesh
