#include "shared/mesh/delaunay/insertion_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "tests/shared/mesh/mesh_shapes.h"

namespace dobra::mesh::delaunay {
namespace {

TEST(InsertionOrder, IsAPermutationAndAlwaysTheSame) {
  const auto points = test::random_points(5000, 1);
  std::vector<std::uint32_t> order = insertion_order(points);
  EXPECT_EQ(order, insertion_order(points));
  std::sort(order.begin(), order.end());
  std::vector<std::uint32_t> all(points.size());
  std::iota(all.begin(), all.end(), 0U);
  EXPECT_EQ(order, all);
}

TEST(InsertionOrder, StepsAreShort) {
  const auto points = test::random_points(10000, 2);
  const auto order = insertion_order(points);
  double travelled = 0.0;
  for (std::size_t i = 1; i < order.size(); ++i) travelled += geom::distance(points[order[i - 1]], points[order[i]]);
  // A random order steps 0.52 on average; a good curve about 1 / sqrt(n) = 0.01.
  EXPECT_LT(travelled / static_cast<double>(order.size()), 0.02);
}

TEST(InsertionOrder, EqualPointsAreAllowed) {
  const std::vector<geom::Point> points(100, geom::Point{2, 3});
  EXPECT_EQ(insertion_order(points).size(), 100U);
}

}  // namespace
}  // namespace dobra::mesh::delaunay
