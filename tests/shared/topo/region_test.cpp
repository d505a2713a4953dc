#include "shared/topo/region.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "shared/topo/insert.h"

namespace dobra::topo {
namespace {

using geom::Point;
using geom::Polyline;

/// Slanted rectangles along five lines: their long sides lie on each other, but for rounding, as those of polygons that
/// grow on both sides of a crossing do.
std::vector<Polyline> rectangles(std::size_t count) {
  std::mt19937 random(3);
  const auto real = [&] { return static_cast<double>(random()) / 4294967296.0; };
  std::vector<Polyline> all;
  while (all.size() < count) {
    const double angle = 0.3 + 0.7 * static_cast<double>(random() % 5U);
    const geom::Vector u{std::cos(angle), std::sin(angle)};
    const geom::Vector w{-0.1 * u.y, 0.1 * u.x};
    const Point from = Point{7.0, 5.0} + (10.0 * real() - 5.0) * u;
    const Point to = from + (0.5 + real()) * u;
    all.push_back({{from + -1.0 * w, to + -1.0 * w, to + w, from + w}, true});
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
  const std::vector<Polyline> rings = rectangles(600);
  Subdivision sub;
  const auto paths = insert(sub, rings);
  ASSERT_TRUE(paths.ok());
  double astray = 0.0;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    for (const HalfEdgeId h : (*paths)[i]) astray = std::max(astray, distance_to(rings[i], sub.point(sub.origin(h))));
  }
  EXPECT_LT(astray, 12 * 1e-12);
}

TEST(Region, WorkStopsSoonAfterItIsCancelled) {
  const base::CancelToken token;
  token.cancel();
  const auto made = region(rectangles(3), Inside::Odd, base::Progress(token, {}));
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.error().code, base::ErrorCode::Cancelled);
}

}  // namespace
}  // namespace dobra::topo
