#pragma once
// Seeded draws, and what every map of a block is asked.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "recon/kinematics/block_map.h"
#include "shared/base/counter_random.h"

namespace recon::test {

/// Uniform numbers that depend on the seed alone.
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : seed_(seed) {}
  double in(double low, double high) {
    const double fraction = (base::philox({count_++, 0, 0, 0}, seed_)[0] + 0.5) * 0x1p-32;
    return low + fraction * (high - low);
  }
  geom::Point in_box(geom::Point low, geom::Point high) { return {in(low.x, high.x), in(low.y, high.y)}; }

 private:
  std::uint64_t seed_;
  std::uint32_t count_ = 0;
};

inline base::Angle degrees(double value) { return base::Angle::from_degrees(value); }

inline kinematics::FaultPath fault(std::vector<geom::Point> points, kinematics::Side side = kinematics::Side::Left) {
  return {{std::move(points), false}, side};
}

/// The mirror image in x, hanging wall and all.
inline kinematics::FaultPath mirrored(kinematics::FaultPath path) {
  for (geom::Point& p : path.line.points) p.x = -p.x;
  path.hanging = path.hanging == kinematics::Side::Left ? kinematics::Side::Right : kinematics::Side::Left;
  return path;
}

/// A star round a place: simple, with sides that cross walls in all directions.
inline geom::Polyline star(Draws& draws, geom::Point centre, double radius) {
  geom::Polyline polygon{{}, true};
  const int corners = 9;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * (i + 0.3 * draws.in(0.0, 1.0)) / corners;
    const double r = radius * draws.in(0.3, 1.0);
    polygon.points.push_back(centre + geom::Vector{r * std::cos(angle), r * std::sin(angle)});
  }
  return polygon;
}

/// (area after - area before) / area before, with all vertices of the image or with those of the given ones alone.
inline double area_change(const kinematics::MovedLine& moved) {
  const double before = geom::signed_area(moved.before);
  return (geom::signed_area(moved.after) - before) / before;
}
inline double area_change_of_given(const kinematics::MovedLine& moved) {
  geom::Polyline chords{{}, true};
  for (const std::size_t i : moved.given) chords.points.push_back(moved.after.points[i]);
  const double before = geom::signed_area(moved.before);
  return (geom::signed_area(chords) - before) / before;
}

inline void expect_near(geom::Point p, geom::Point q, double tolerance) {
  EXPECT_LE(geom::distance(p, q), tolerance) << p << " is not " << q;
}

}  // namespace recon::test
