#include "shared/mesh/front/fill_engine.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "shared/mesh/delaunay/planar_domain.h"
#include "shared/mesh/front/triangulate.h"
#include "tests/shared/mesh/mesh_shapes.h"

namespace dobra::mesh::front {
namespace {

using geom::Point;

/// Cells that make_room reckons with, over the triangles of the mesh that comes of it.
double room_over_need(const delaunay::MeshInput& input, double growth) {
  MeshOptions options;
  options.sizes.growth = growth;
  auto domain = build_domain(input, delaunay::Outside::Remove, {});
  const auto field = size_field_of(input, options.sizes);
  const auto mesh = triangulate(input, options);
  EXPECT_TRUE(domain.ok() && field.ok() && mesh.ok());
  std::size_t outside = 0;
  for (delaunay::DelaunayKernel::Cell c = 0; c < domain->kernel.cell_count(); ++c)
    outside += domain->kernel.cell(c).region < 0;
  const std::size_t room = make_room(domain->kernel, *field, options.points);
  return static_cast<double>(room - outside) / static_cast<double>(mesh->triangles.size());
}

TEST(FillEngine, TheRoomReckonedBeforehandIsEnoughAndNotAThirdTooMuch) {
  const auto expect_fits = [](const delaunay::MeshInput& input, double growth) {
    const double room = room_over_need(input, growth);
    EXPECT_GE(room, 1.0);
    EXPECT_LE(room, 1.34);
  };
  expect_fits(test::uniform_plate(4'000), 1.3);
  for (const double triangles : {10'000.0, 40'000.0}) {
    const auto plate = test::graded_plate(triangles);
    expect_fits(plate.input, plate.growth);
  }
  expect_fits(test::quarter_plate(test::graded(1.0, 5.0, 60, 1.08), 300, 10, {}), 1.2);
  // Fine sides on two holes and coarse ones around: sizes fall and rise again along the input's triangles.
  delaunay::MeshInput plate;
  const auto ring = [](Point centre, double radius, int count, double turn) {
    std::vector<Point> points;
    for (int i = 0; i < count; ++i)
      points.push_back(
          {centre.x + radius * std::cos(turn * i / count), centre.y + radius * std::sin(turn * i / count)});
    return points;
  };
  add_chain(plate, ring({0, 0}, 5.0, 40, 2.0 * std::numbers::pi), delaunay::Closure::Closed,
            {"rim", delaunay::EdgeKind::Boundary});
  add_chain(plate, ring({-2, 0}, 0.7, 300, -2.0 * std::numbers::pi), delaunay::Closure::Closed,
            {"left", delaunay::EdgeKind::Boundary});
  add_chain(plate, ring({2, 1}, 0.4, 100, -2.0 * std::numbers::pi), delaunay::Closure::Closed,
            {"right", delaunay::EdgeKind::Boundary});
  expect_fits(plate, 1.1);
  expect_fits(plate, 1.3);
}

}  // namespace
}  // namespace dobra::mesh::front
