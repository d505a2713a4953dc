// Lines through surfaces: closed forms, dense samples, touchings, borders.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "shared/surf/intersect.h"
#include "tests/shared/surf/surface_shapes.h"

namespace dobra::surf {
namespace {

using geom::Box;
using geom::Point;
using geom::Point3;
using geom::Vector3;
using namespace test;

double between(std::mt19937& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() % 1000003) / 1000002.0;
}
Vector3 any_way(std::mt19937& random) {
  return {between(random, -1, 1), between(random, -1, 1), between(random, -1, 1)};
}

TEST(IntersectLine, HitsSpheresWhereTheQuadraticSays) {
  std::mt19937 random(31);
  const Frame frame = tilted();
  const Surface ball = *Surface::sphere(frame, 5.0, {{0, -0.5 * pi}, {2 * pi, 0.5 * pi}});
  for (int tries = 0; tries < 500; ++tries) {
    const Point3 from = frame.origin + 9.0 * any_way(random);
    const Vector3 way = 3.0 * any_way(random), off = from - frame.origin;
    const double a = dot(way, way), b = dot(off, way), c = dot(off, off) - 25.0, d = b * b - a * c;
    const auto hits = intersect_line(ball, from, way);
    ASSERT_TRUE(hits.ok()) << hits.error().message;
    ASSERT_EQ(hits->size(), d > 0 ? 2U : 0U) << tries;
    if (d <= 0) continue;
    EXPECT_NEAR((*hits)[0].t, (-b - std::sqrt(d)) / a, 1e-9);
    EXPECT_NEAR((*hits)[1].t, (-b + std::sqrt(d)) / a, 1e-9);
    for (const LineHit& hit : *hits) EXPECT_LE(geom::distance(hit.at, from + hit.t * way), 1e-12 * ball.size());
  }
}

TEST(IntersectLine, TouchesTangentsPolesSeamsAndBorders) {
  const Surface ball = *Surface::sphere({}, 5.0, {{0, -0.5 * pi}, {2 * pi, 0.5 * pi}});
  const auto only = [](const auto& hits) -> LineHit {
    EXPECT_TRUE(hits.ok());
    EXPECT_EQ(hits->size(), 1U);
    return hits->empty() ? LineHit{} : hits->front();
  };
  const double s = std::sqrt(0.5);
  const LineHit touch = only(intersect_line(ball, {5 * s, 5 * s, -3}, {0, 0, 1}));
  EXPECT_TRUE(touch.tangent);
  EXPECT_LE(geom::distance(touch.at, {5 * s, 5 * s, 0}), 1e-9);
  EXPECT_TRUE(intersect_line(ball, {5 * s + 1e-6, 5 * s, -3}, {0, 0, 1})->empty());
  EXPECT_EQ(intersect_line(ball, {5 * s - 1e-6, 5 * s, -3}, {0, 0, 1})->size(), 2U);
  // Through both poles; through the seam.
  const auto poles = intersect_line(ball, {0, 0, -9}, {0, 0, 2});
  ASSERT_TRUE(poles.ok());
  ASSERT_EQ(poles->size(), 2U);
  EXPECT_NEAR((*poles)[0].t, 2.0, 1e-11);
  EXPECT_NEAR((*poles)[1].t, 7.0, 1e-11);
  const auto seam = intersect_line(ball, {9, 0, 0.5}, {-1, 0, 0});
  ASSERT_EQ(seam->size(), 2U);
  // Along a border of a cap, and a ray from it.
  const Surface strip = *Surface::plane({}, {{0, 0}, {2, 3}});
  const LineHit border = only(intersect_line(strip, {2, 1, -1}, {0, 0, 1}));
  EXPECT_EQ(border.uv, (Point{2, 1}));
  EXPECT_NEAR(only(intersect_line(strip, {0, 3, -1}, {0.1, -0.2, 1}, 0.5)).t, 1.0, 1e-14);
  EXPECT_TRUE(intersect_line(strip, {2 + 1e-9, 1, -1}, {0, 0, 1})->empty());
  EXPECT_TRUE(intersect_line(strip, {1, 1, -1}, {0, 0, 1}, 1.5)->empty());
  EXPECT_EQ(only(intersect_line(strip, {0, 1, 2}, {1, 1, -1})).uv, (Point{2, 3}));  // a corner
}

TEST(IntersectLine, AlongASurfaceItIsRefusedWithAPlace) {
  const Surface pipe = *Surface::cylinder({}, 2.0, {{0, 0}, {pi, 5}});
  const auto lies = intersect_line(pipe, {2.0 * std::cos(1.0), 2.0 * std::sin(1.0), -1}, {0, 0, 1});
  ASSERT_FALSE(lies.ok());
  EXPECT_NE(lies.error().message.find("lies in the surface"), std::string::npos);
  ASSERT_TRUE(lies.error().place);
  EXPECT_NEAR(*lies.error().place->x, 2.0 * std::cos(1.0), 1e-2);
  EXPECT_FALSE(intersect_line(pipe, {0, 0, 0}, {}).ok());
  EXPECT_FALSE(intersect_line(pipe, {0, std::nan(""), 0}, {1, 0, 0}).ok());
}

/// A dense net of triangles over the surface is passed as often, but where a hit lies a hair from a triangle's edge.
TEST(IntersectLine, FindsWhatADenseNetFinds) {
  std::mt19937 random(77);
  int found = 0;
  for (const auto& [name, surface] : all_kinds()) {
    constexpr int n = 160;
    std::vector<Point3> net;
    for (int i = 0; i <= n; ++i) {
      for (int j = 0; j <= n; ++j)
        net.push_back(surface.at({std::lerp(surface.chart().low.x, surface.chart().high.x, i / double(n)),
                                  std::lerp(surface.chart().low.y, surface.chart().high.y, j / double(n))}));
    }
    for (int tries = 0; tries < 40; ++tries) {
      const auto inside = [&] {
        return Point{between(random, surface.chart().low.x, surface.chart().high.x),
                     between(random, surface.chart().low.y, surface.chart().high.y)};
      };
      const Point3 from = surface.at(inside()) + 0.05 * surface.size() * any_way(random);
      const Vector3 way = surface.at(inside()) - from;
      const auto hits = intersect_line(surface, from, way);
      ASSERT_TRUE(hits.ok()) << name << hits.error().message;
      found += static_cast<int>(hits->size());
      for (const LineHit& hit : *hits) {
        EXPECT_LE(geom::distance(hit.at, from + hit.t * way), 1e-11 * surface.size()) << name;
        EXPECT_EQ(hit.at, surface.at(hit.uv));
        EXPECT_TRUE(surface.chart().contains(hit.uv));
      }
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          const Point3 a = net[i * (n + 1) + j], b = net[(i + 1) * (n + 1) + j], c = net[(i + 1) * (n + 1) + j + 1],
                       d = net[i * (n + 1) + j + 1];
          for (const auto& [p, q, r] : {std::array{a, b, c}, std::array{a, c, d}}) {
            const auto volume = [&](Point3 x, Point3 y) { return dot(way, cross(x - from, y - from)); };
            const double v1 = volume(p, q), v2 = volume(q, r), v3 = volume(r, p), sum = v1 + v2 + v3;
            if (!((v1 > 0 && v2 > 0 && v3 > 0) || (v1 < 0 && v2 < 0 && v3 < 0))) continue;
            const Point3 at =
                Point3{} + (v2 / sum) * (p - Point3{}) + (v3 / sum) * (q - Point3{}) + (v1 / sum) * (r - Point3{});
            // Nearly along the triangle the true surface may be missed where its chord is not.
            const Vector3 normal = cross(q - p, r - p);
            if (std::abs(dot(normal, way)) < 0.05 * geom::length(normal) * geom::length(way)) continue;
            double nearest = 1e300;
            for (const LineHit& hit : *hits) nearest = std::min(nearest, geom::distance(hit.at, at));
            // A triangle at a border may be passed where the chord leaves the surface.
            const bool at_border = i == 0 || j == 0 || i == n - 1 || j == n - 1;
            if (!at_border) {
              EXPECT_LE(nearest, 0.02 * surface.size()) << name << " " << tries << " " << i << " " << j;
            }
          }
        }
      }
    }
  }
  EXPECT_GT(found, 400);
}

}  // namespace
}  // namespace dobra::surf
