#include "shared/mesh/element_mesh.h"

#include <gtest/gtest.h>

#include <limits>

namespace dobra::mesh {
namespace {

std::vector<NodeId> ids(std::initializer_list<std::size_t> numbers) {
  std::vector<NodeId> nodes;
  for (const std::size_t n : numbers) nodes.emplace_back(n);
  return nodes;
}

/// A unit square of a Q4 and, on its right, two T3.
ElementMesh mixed() {
  ElementMesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0}, {2, 1}};
  add_element(mesh, ElementType::Q4, ids({0, 1, 2, 3}), 0);
  add_element(mesh, ElementType::T3, ids({1, 4, 2}), 1);
  add_element(mesh, ElementType::T3, ids({4, 5, 2}), 1);
  return mesh;
}

TEST(ElementMesh, SidesPairUpAcrossTypes) {
  const ElementMesh mesh = mixed();
  ASSERT_TRUE(check(mesh));
  const auto neighbours = neighbours_of(mesh);
  ASSERT_EQ(neighbours.size(), 10U);
  EXPECT_EQ(neighbours[1], (ElementSide{ElementId(1), 2}));
  EXPECT_EQ(neighbours[4 + 2], (ElementSide{ElementId(0), 1}));
  EXPECT_EQ(neighbours[4 + 1], (ElementSide{ElementId(2), 2}));
  EXPECT_EQ(boundary_sides(mesh).size(), 6U);
  EXPECT_DOUBLE_EQ(area(mesh), 2.0);
}

TEST(ElementMesh, AreaOfParabolicSidesIsExact) {
  ElementMesh mesh;
  // The hypotenuse bulges by 0.1 sqrt(2): a parabola adds 2/3 of chord times rise.
  mesh.points = {{0, 0}, {1, 0}, {0, 1}, {0.5, 0}, {0.6, 0.6}, {0, 0.5}};
  add_element(mesh, ElementType::T6, ids({0, 1, 2, 3, 4, 5}), 0);
  ASSERT_TRUE(check(mesh));
  EXPECT_NEAR(area(mesh), 0.5 + 2.0 / 3.0 * 0.2, 1e-15);
  EXPECT_EQ(side_nodes(mesh, {ElementId(0), 1}), (std::array{NodeId(1), NodeId(2), NodeId(4)}));
}

TEST(ElementMesh, CheckNamesWhatIsWrong) {
  ElementMesh clockwise = mixed();
  std::swap(clockwise.nodes[4], clockwise.nodes[5]);
  EXPECT_NE(check(clockwise).error().message.find("anticlockwise"), std::string::npos);

  ElementMesh arrow = mixed();
  arrow.points[2] = {0.2, 0.2};
  EXPECT_FALSE(check(arrow)) << "a quadrilateral that is not convex";

  ElementMesh doubled = mixed();
  add_element(doubled, ElementType::T3, ids({4, 5, 2}), 1);
  EXPECT_NE(check(doubled).error().message.find("same side"), std::string::npos);

  ElementMesh stray = mixed();
  stray.side_sets["edge"] = {{ElementId(1), 3}};
  EXPECT_NE(check(stray).error().message.find("'edge'"), std::string::npos);

  ElementMesh missing = mixed();
  missing.nodes[0] = NodeId(77);
  EXPECT_FALSE(check(missing));

  ElementMesh infinite = mixed();
  infinite.points[0].x = std::numeric_limits<double>::infinity();
  EXPECT_EQ(check(infinite).error().code, base::ErrorCode::NotFinite);
}

TEST(ElementMesh, NeighboursShareMidSideNodes) {
  ElementMesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0}, {1, 0.5}, {0.5, 0.5}, {0.5, 1}, {0, 0.5}, {0.5, 0.5}};
  add_element(mesh, ElementType::T6, ids({0, 1, 2, 4, 5, 6}), 0);
  add_element(mesh, ElementType::T6, ids({0, 2, 3, 6, 7, 8}), 0);
  EXPECT_TRUE(check(mesh));
  mesh.nodes[9] = NodeId(9);
  EXPECT_NE(check(mesh).error().message.find("mid-side"), std::string::npos);
}

}  // namespace
}  // namespace dobra::mesh
