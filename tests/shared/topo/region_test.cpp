#include "shared/topo/region.h"

#include <gtest/gtest.h>

#include <random>

#include "shared/topo/insert.h"

namespace dobra::topo {
namespace {

using geom::Point;
using geom::Polyline;

/// Triangles whose corners are thirds: three and more sides meet at most crossings, but for rounding.
std::vector<Polyline> triangles(std::size_t count) {
  std::mt19937 random(3);
  const auto third = [&] { return static_cast<double>(random() % 40U) / 3.0; };
  std::vector<Polyline> all;
  while (all.size() < count) {
    const Polyline made{{{third(), third()}, {third(), third()}, {third(), third()}}, true};
    if (std::abs(geom::signed_area(made)) > 0.1) all.push_back(made);
  }
  return all;
}

double distance_to(const Polyline& ring, Point p) {
  double least = 1e300;
  for (std::size_t i = 0; i < ring.points.size(); ++i) {
    least = std::min(least, geom::distance({ring.points[i], ring.points[(i + 1) % ring.points.size()]}, p));
  }
  return least;
}

TEST(Region, ManyCurvesThatCrossWithinRoundingStayWhereTheyAre) {
  const std::vector<Polyline> rings = triangles(120);
  Subdivision sub;
  const auto paths = insert(sub, rings);
  ASSERT_TRUE(paths.ok());
  double astray = 0.0;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    for (const HalfEdgeId h : (*paths)[i]) astray = std::max(astray, distance_to(rings[i], sub.point(sub.origin(h))));
  }
  EXPECT_LT(astray, 40 / 3.0 * 1e-12);
}

TEST(Region, WorkStopsSoonAfterItIsCancelled) {
  const base::CancelToken token;
  token.cancel();
  const auto made = region(triangles(3), Inside::Odd, base::Progress(token, {}));
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.error().code, base::ErrorCode::Cancelled);
}

}  // namespace
}  // namespace dobra::topo
