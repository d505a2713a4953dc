// The nearest point of a surface against closed forms and dense samples.

#include "shared/surf/closest.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "shared/surf/cells.h"
#include "shared/surf/measure.h"
#include "tests/shared/surf/surface_shapes.h"

namespace dobra::surf {
namespace {

using geom::Box;
using geom::Point;
using geom::Point3;
using geom::Vector3;
using namespace test;

TEST(Hull, HoldsTheSurfaceOverItsCellAndIsTightOverSmallOnes) {
  Chance chance{std::mt19937(6)};
  for (const auto& [name, surface] : all_kinds()) {
    for (int tries = 0; tries < 60; ++tries) {
      const Box parts = smooth_parts(surface)[0];
      const double small = std::pow(2.0, -chance.number(0, 12));
      const Point a = chance.of(parts);
      const Box cell{
          {std::max(parts.low.x, a.x - small * parts.width()), std::max(parts.low.y, a.y - small * parts.height())},
          {std::min(parts.high.x, a.x + small * parts.width()), std::min(parts.high.y, a.y + small * parts.height())}};
      const Hull hull = hull_of(surface, cell);
      const Bend bend = surface.bend(cell);
      const double slack = 1e-13 * surface.size();  // rounding of second differences
      for (int k = 0; k < 60; ++k) {
        const Point uv =
            k < 4 ? Point{k % 2 ? cell.low.x : cell.high.x, k / 2 ? cell.low.y : cell.high.y} : chance.of(cell);
        const double s = (uv.x - cell.centre().x) / (0.5 * cell.width()),
                     t = (uv.y - cell.centre().y) / (0.5 * cell.height());
        const Jet jet = surface.jet(uv);
        EXPECT_LE(geom::distance(jet.at, hull.centre + s * hull.along_u + t * hull.along_v), hull.rest)
            << name << cell.low << cell.high;
        EXPECT_LE(geom::length(jet.uu), bend.uu + slack / (cell.width() * cell.width())) << name << uv;
        EXPECT_LE(geom::length(jet.uv), bend.uv + slack / (cell.width() * cell.height())) << name << uv;
        EXPECT_LE(geom::length(jet.vv), bend.vv + slack / (cell.height() * cell.height())) << name << uv;
      }
    }
    // Over a small cell the bound is near what is there, so that halving gets somewhere.
    const Point m = surface.chart().centre();
    const double du = 1e-5 * surface.chart().width(), dv = 1e-5 * surface.chart().height();
    const Bend bend = surface.bend({{m.x, m.y}, {m.x + du, m.y + dv}});
    const Jet jet = surface.jet(m);
    EXPECT_LE(bend.uu, 4.0 * geom::length(jet.uu) + 8.0 * geom::length(jet.u) / surface.chart().width()) << name;
    EXPECT_LE(bend.vv, 4.0 * geom::length(jet.vv) + 8.0 * geom::length(jet.v) / surface.chart().height()) << name;
  }
}

TEST(Closest, OfAllIsNeverFartherThanADenseSample) {
  Chance chance{std::mt19937(2)};
  for (const auto& [name, surface] : all_kinds()) {
    std::vector<Point3> sample;
    for (int i = 0; i <= 120; ++i) {
      for (int j = 0; j <= 120; ++j)
        sample.push_back(surface.at({std::lerp(surface.chart().low.x, surface.chart().high.x, i / 120.0),
                                     std::lerp(surface.chart().low.y, surface.chart().high.y, j / 120.0)}));
    }
    for (int tries = 0; tries < 25; ++tries) {
      const double far = std::pow(10.0, chance.number(-4, 0)) * surface.size();
      const Point3 point = surface.at(chance.of(surface.chart())) +
                           Vector3{chance.number(-far, far), chance.number(-far, far), chance.number(-far, far)};
      double least = 1e300;
      for (const Point3& each : sample) least = std::min(least, geom::distance(each, point));
      const Foot foot = closest_of_all(surface, point);
      EXPECT_LE(foot.distance, least + 1e-9 * surface.size()) << name;
      EXPECT_GE(foot.distance, least - 0.02 * surface.size()) << name;
      EXPECT_TRUE(surface.chart().contains(foot.uv));
      EXPECT_EQ(foot.at, surface.at(foot.uv));
    }
  }
}

TEST(Closest, IsTheClosedFormOnQuadricsFromAnyNeighbour) {
  Chance chance{std::mt19937(4)};
  const Frame frame = tilted();
  const Surface ball = *Surface::sphere(frame, 5.0, {{0, -0.5 * pi}, {2 * pi, 0.5 * pi}});
  const Surface pipe = *Surface::cylinder(frame, 2.0, {{-pi, -3}, {pi, 7}});
  const Surface ring = *Surface::torus(frame, 6.0, 2.0, {{0, 0}, {2 * pi, 2 * pi}});
  for (int tries = 0; tries < 400; ++tries) {
    const Vector3 away{chance.number(-9, 9), chance.number(-9, 9), chance.number(-9, 9)};
    const Point3 point = frame.origin + away;
    EXPECT_NEAR(closest(ball, point, chance.of(ball.chart())).distance, std::abs(geom::length(away) - 5.0), 1e-11);
    const double along = dot(away, frame.z), out = geom::length(away - along * frame.z);
    const double beyond = std::max({0.0, along - 7.0, -3.0 - along});
    EXPECT_NEAR(closest(pipe, point, chance.of(pipe.chart())).distance, std::hypot(out - 2.0, beyond), 1e-11);
    EXPECT_NEAR(closest(ring, point, chance.of(ring.chart())).distance, std::abs(std::hypot(out - 6.0, along) - 2.0),
                1e-11);
  }
}

TEST(Closest, FromTheFarthestPlacePoleSeamAndOppositeLine) {
  const Surface ball = *Surface::sphere({}, 5.0, {{0, -0.5 * pi}, {2 * pi, 0.5 * pi}});
  for (const Point3 point :
       {Point3{0, 0, 9}, Point3{9, 0, 0}, Point3{0, 7, 0}, Point3{-1, 0, -1e-9}, Point3{1, 1, 1}}) {
    const Vector3 way = geom::normalised(point - Point3{});
    const double u = std::atan2(-way.y, -way.x), v = std::asin(-way.z);
    for (const Point near : {Point{u < 0 ? u + 2 * pi : u, v}, Point{1.0, 0.5 * pi}, Point{4.0, -0.5 * pi},
                             Point{0, 0.1}, Point{2 * pi, -0.1}})
      EXPECT_NEAR(closest(ball, point, near).distance, std::abs(geom::length(point - Point3{}) - 5.0), 1e-11) << near;
  }
  const Surface cone = *Surface::cone({}, 0.0, 0.5, {{0, 0}, {2 * pi, 4}});
  // On the other side of the apex, over the apex, inside.
  EXPECT_NEAR(closest(cone, {-1, 0, 2}, {0.0, 0.0}).distance, std::abs(-1 * -std::cos(0.5) - 2 * std::sin(0.5)), 1e-12);
  EXPECT_NEAR(closest(cone, {0.1, 0, -3}, {3.0, 2.0}).distance, std::hypot(0.1, 3.0), 1e-12);
}

TEST(Closest, StaysOnTheSheetOfTheNeighbour) {
  // A strip that turns back over itself at a hundredth of its length.
  const Surface fold =
      *Surface::extruded(*Curve::nurbs(3, {0, 0, 0, 0, 1, 2, 3, 3, 3, 3},
                                       {{0, 0, 0}, {5, 0, 0}, {12, 0, 0}, {12, 0, 0.1}, {5, 0, 0.1}, {0, 0, 0.1}}),
                         {0, 4, 0});
  Point at{0.4, 0.5};
  double last = 0.0;
  for (double x = 2.0; x < 9.0; x += 0.01) {  // nearer to the other sheet all along
    const Foot foot = closest(fold, {x, 2.0, 0.06}, at);
    ASSERT_LT(foot.uv.x, 1.6) << x;
    EXPECT_NEAR(foot.at.x, x, 0.01);
    EXPECT_GE(foot.distance, 0.05);
    EXPECT_GT(foot.uv.x, last);
    last = foot.uv.x;
    at = foot.uv;
  }
  EXPECT_NEAR(closest_of_all(fold, {5.0, 2.0, 0.06}).distance, 0.04, 1e-3);
}

TEST(Closest, StretchedChartsAndCorners) {
  const auto roof = [](double stretch) {  // two planes that meet at the line x = 5, z = 3
    return *Surface::nurbs(1, {0, 0, stretch, 2 * stretch, 2 * stretch}, 1, {0, 0, 1, 1},
                           {{0, 0, 0}, {0, 8, 0}, {5, 0, 3}, {5, 8, 3}, {10, 0, 0}, {10, 8, 0}});
  };
  Chance chance{std::mt19937(9)};
  for (const double stretch : {1.0, 1000.0, 1e-6}) {
    const Surface surface = roof(stretch);
    EXPECT_EQ(smooth_parts(surface).size(), 2U);
    for (int tries = 0; tries < 100; ++tries) {
      // Over the ridge the nearest place is on it, from either side.
      const Point3 above{5.0 + chance.number(-0.5, 0.5), chance.number(0, 8), 3.0 + chance.number(1.0, 4.0)};
      const Foot ridge = closest(surface, above, chance.of(surface.chart()));
      EXPECT_NEAR(ridge.distance, std::hypot(above.x - 5.0, above.z - 3.0), 1e-11) << stretch;
      const Point3 left{chance.number(1, 3), chance.number(0, 8), 2.0};
      EXPECT_NEAR(closest(surface, left, {1.9 * stretch, 0.5}).distance,
                  std::abs(-3 * left.x + 5 * left.z) / std::sqrt(34.0), 1e-11);
    }
    EXPECT_NEAR(closest(surface, {-3, -4, 0}, {stretch, 0.2}).distance, 5.0, 1e-12);
  }
}

TEST(Closest, IsAPlaceFromWhichItOnlyGetsFarther) {
  Chance chance{std::mt19937(14)};
  for (const auto& [name, surface] : all_kinds()) {
    for (int tries = 0; tries < 40; ++tries) {
      const double far = 0.3 * surface.size();
      const Point near = chance.of(surface.chart());
      const Point3 point =
          surface.at(near) + Vector3{chance.number(-far, far), chance.number(-far, far), chance.number(-far, far)};
      const Foot foot = closest(surface, point, near);
      EXPECT_LE(foot.distance, geom::distance(point, surface.at(near))) << name;
      const Jet jet = surface.jet(foot.uv);  // what leads there is perpendicular
      const Vector3 r = point - foot.at;
      const Box& box = surface.chart();
      if (surface.breaks().u.size() == 2 && foot.uv.x > box.low.x && foot.uv.x < box.high.x && foot.uv.y > box.low.y &&
          foot.uv.y < box.high.y) {
        EXPECT_LE(std::abs(dot(r, jet.u)), 1e-11 * surface.size() * geom::length(jet.u)) << name;
        EXPECT_LE(std::abs(dot(r, jet.v)), 1e-11 * surface.size() * geom::length(jet.v)) << name;
      }
      for (int k = 0; k < 16; ++k) {
        const double angle = 2 * pi * k / 16;
        for (const double hop : {1e-3, 1e-5}) {
          const Point other{std::clamp(foot.uv.x + hop * surface.chart().width() * std::cos(angle),
                                       surface.chart().low.x, surface.chart().high.x),
                            std::clamp(foot.uv.y + hop * surface.chart().height() * std::sin(angle),
                                       surface.chart().low.y, surface.chart().high.y)};
          EXPECT_GE(geom::distance(surface.at(other), point), foot.distance - 1e-12 * surface.size()) << name << near;
        }
      }
    }
  }
}

}  // namespace
}  // namespace dobra::surf
