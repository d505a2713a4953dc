#include "shared/mesh/front/node_grid.h"

#include <gtest/gtest.h>

#include <set>

#include "shared/mesh/front/triangulate.h"
#include "tests/shared/mesh/mesh_shapes.h"

namespace dobra::mesh::front {
namespace {

using geom::Point;

/// Every node nearer than 0.75 h is visited, wherever sizes are and however fast they change.
void expect_all_near_nodes_visited(const delaunay::MeshInput& input, double growth) {
  const sizing::SizeField field = size_field_of(input, {.growth = growth}).value();
  MeshOptions options;
  options.sizes.growth = growth;
  const TriangleMesh mesh = triangulate(input, options).value();
  NodeGrid grid(field, mesh.points.size());
  for (std::uint32_t n = 0; n < mesh.points.size(); ++n) {
    grid.add(mesh.points[n], n, field.quadtree().leaf_at(mesh.points[n]));
  }
  const geom::Box box = mesh.box();
  std::size_t found = 0;
  for (const Point unit : test::random_points(500, 7)) {
    const Point p{box.low.x + unit.x * box.width(), box.low.y + unit.y * box.height()};
    const double radius = 0.75 * field.size_at(p);
    std::set<std::uint32_t> visited;
    grid.visit_near(p, radius, field.quadtree().leaf_at(p),
                    [&](const NodeGrid::Entry& entry) { visited.insert(entry.vertex); });
    for (std::uint32_t n = 0; n < mesh.points.size(); ++n) {
      if (geom::distance(p, mesh.points[n]) >= radius) continue;
      ++found;
      EXPECT_EQ(visited.count(n), 1U) << p << " " << mesh.points[n];
    }
    EXPECT_LT(visited.size(), 120U);
  }
  EXPECT_GT(found, 100U);
}

TEST(NodeGrid, VisitsEveryNodeNearAPointOfAUniformPlate) { expect_all_near_nodes_visited(test::square(1.0, 30), 1.3); }

TEST(NodeGrid, VisitsEveryNodeNearAPointWhereSizesGrowSlowly) {
  expect_all_near_nodes_visited(test::graded_plate(5'000).input, 1.1);
}

TEST(NodeGrid, VisitsEveryNodeNearAPointWhereSizesGrowFast) {
  expect_all_near_nodes_visited(test::que_d(), 1.3);
  expect_all_near_nodes_visited(test::que_d(), 1.6);
}

}  // namespace
}  // namespace dobra::mesh::front
