#include "recon/maps/shear_map.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "recon/core/grid_step.h"
#include "recon/core/restore_step.h"
#include "recon/core/target_step.h"
#include "tests/recon/shapes.h"

namespace recon::maps {
namespace {

using std::numbers::pi;

geom::Polyline wave(double height, double level = 0.0) {
  geom::Polyline line;
  for (int i = 0; i <= 100; ++i) line.points.push_back({20.0 * i, level + height * std::sin(pi * i / 25.0)});
  return line;
}

base::Result<model::Model> sheared(const std::vector<geom::Polyline>& lines, double degrees,
                                   const unfold::TargetParams& goal = {}, double percent = 100.0) {
  model::Model model;
  model.section = test::section_of(lines);
  unfold::GridParams grid;
  grid.uncovered = unfold::Uncovered::Continue;
  DOBRA_TRY(model, core::run_grid(model, grid, {}, {}));
  DOBRA_TRY(model, core::run_target(model, goal, {}, {}));
  unfold::RestoreParams params;
  params.method = unfold::RestoreMethod::Shear;
  params.angle = base::Angle::from_degrees(degrees);
  params.percent = percent;
  return core::run_restore(model, params, {}, {});
}

/// Whether a line from left to right goes on across the direction of shear everywhere: beyond the dip of all its pieces
/// they would all go back, and the section would be mirrored.
bool advances(const geom::Polyline& line, double degrees) {
  const double a = degrees * pi / 180.0;
  for (std::size_t i = 0; i < line.segment_count(); ++i) {
    const geom::Vector v = line.segment(i).vector();
    if (std::cos(a) * v.x - std::sin(a) * v.y <= 0.0) return false;
  }
  return true;
}

bool says(const model::Model& model, const std::string& part) {
  for (const std::string& remark : model.restoration->remarks) {
    if (remark.find(part) != std::string::npos) return true;
  }
  return false;
}

TEST(ShearMap, ATopThatTurnsAgainstTheDirectionIsRefusedWithThePlace) {
  const geom::Polyline overturned{{{0, 0}, {60, 30}, {80, 20}, {50, 5}, {120, 0}}, false};
  const geom::Polyline riser{{{0, 0}, {100, 0}, {100, 40}, {200, 40}}, false};
  const geom::Polyline synform{{{0, 0}, {100, -300}, {200, 0}}, false};
  struct Case {
    geom::Polyline top;
    double degrees;
    geom::Point at;
  };
  for (const Case& one : {Case{wave(200.0), 65.0, {0, 0}}, Case{overturned, 0.0, {80, 20}}, Case{riser, 0.0, {100, 0}},
                          Case{synform, -20.0, {0, 0}}, Case{synform, 20.0, {100, -300}}}) {
    const geom::Polyline below = geom::Polyline{{{0, -400}, {one.top.points.back().x, -400}}, false};
    const auto refused = sheared({one.top, below}, one.degrees);
    ASSERT_FALSE(refused) << one.degrees;
    EXPECT_EQ(refused.error().code, base::ErrorCode::CannotRestore);
    ASSERT_TRUE(refused.error().place && refused.error().place->x);
    EXPECT_EQ(geom::Point(*refused.error().place->x, *refused.error().place->y), one.at) << one.degrees;
  }
}

TEST(ShearMap, AShearBeyondTheDipOfTheWholeTopIsRefusedAndMirrorsNothing) {
  // A monocline of 26.57 degrees: beyond 63.43 degrees all of it runs against the direction.
  const geom::Polyline ramp{{{0, 0}, {1000, 500}, {2000, 1000}}, false};
  const geom::Polyline below{{{0, -300}, {2000, 700}}, false};
  for (const double degrees : {63.5, 70.0, 89.0}) EXPECT_FALSE(sheared({ramp, below}, degrees)) << degrees;
  const auto made = sheared({ramp, below}, 60.0);
  ASSERT_TRUE(made) << to_string(made.error());
  const auto& top = made->restoration->section.horizons[0].line.points;
  const auto& bed = made->restoration->section.horizons[1].line.points;
  EXPECT_LT(top.front().x, top.back().x);
  EXPECT_LT(bed.front().y, top.front().y);
}

TEST(ShearMap, ATargetThatTurnsAgainstTheDirectionIsRefusedToo) {
  unfold::TargetParams goal;
  goal.shape = unfold::TargetShape::Line;
  goal.points = {{0, 0}, {900, 0}, {1000, 800}, {2000, 800}};
  EXPECT_TRUE(sheared({wave(50.0), wave(50.0, -300.0)}, 0.0, goal));
  const auto refused = sheared({wave(50.0), wave(50.0, -300.0)}, 30.0, goal);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("the target turns"), std::string::npos) << refused.error().message;
  EXPECT_EQ(refused.error().place->x, 900.0);
}

TEST(ShearMap, TheAnglesThatTheRefusalNamesAreThoseThatWork) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  int named = 0;
  for (int trial = 0; trial < 40; ++trial) {
    geom::Polyline top;
    double x = 0.0;
    for (int i = 0; i <= 12; ++i) {
      top.points.push_back({x, 120.0 * uniform(random)});
      x += 60.0 + 90.0 * uniform(random);  // here and there overturned
    }
    const geom::Polyline below{{{0, -500}, {x, -500}}, false};
    const auto made = sheared({top, below}, 60.0);
    EXPECT_EQ(made.ok(), advances(top, 60.0));
    if (made) continue;
    const std::string& message = made.error().message;
    const auto from = message.find("angles from ");
    int sound = 0;
    for (int k = -890; k <= 890; ++k) sound += advances(top, 0.1 * k) ? 1 : 0;
    EXPECT_EQ(from != std::string::npos, sound > 3 || (sound > 0 && from != std::string::npos)) << message;
    if (from == std::string::npos) continue;
    ++named;
    double low = 0.0, high = 0.0;
    ASSERT_EQ(std::sscanf(message.c_str() + from, "angles from %lf to %lf", &low, &high), 2);
    EXPECT_NEAR(0.1 * sound, high - low, 0.5);
    for (const double angle : {low, 0.5 * (low + high), high}) {
      EXPECT_TRUE(advances(top, angle));
      EXPECT_TRUE(sheared({top, below}, angle)) << message;
    }
  }
  EXPECT_GE(named, 10);
}

TEST(ShearMap, AnOverturnedTopIsShearedAtAnAngleThatItsLimbsLeave) {
  // Both limbs dip to the left: 30 degrees up to the right and 20 degrees beyond the vertical.
  const geom::Polyline top{{{0, 0}, {100, 200}, {70, 320}, {300, 700}}, false};
  EXPECT_FALSE(sheared({top, wave(0.0, -400.0)}, 0.0));
  const auto made = sheared({top, wave(0.0, -400.0)}, -45.0);
  ASSERT_TRUE(made) << to_string(made.error());
  for (const geom::Point p : made->restoration->section.horizons[0].line.points) EXPECT_NEAR(p.y, 0.0, 1e-9);
}

TEST(ShearMap, APinOnTheTargetMovesTheSectionAlongTheDatum) {
  const std::vector<geom::Polyline> lines{wave(30.0), wave(30.0, -300.0)};
  for (const double degrees : {0.0, 25.0, -40.0}) {
    unfold::TargetParams plain;
    plain.elevation = 100.0;
    unfold::TargetParams moved;
    moved.target_pin = {100.0 * std::tan(degrees * pi / 180.0) + 500.0, 100.0};  // 500 m from where the pin slides to
    const auto here = sheared(lines, degrees, plain);
    const auto there = sheared(lines, degrees, moved);
    ASSERT_TRUE(here && there);
    EXPECT_NEAR(there->restoration->section.horizons[0].line.points.front().x, moved.target_pin->x, 1e-9);
    for (std::size_t h = 0; h < 2; ++h) {
      const auto from = test::given_images(here->restoration->lines[h]);
      const auto to = test::given_images(there->restoration->lines[h]);
      for (std::size_t i = 0; i < from.size(); ++i)
        EXPECT_NEAR(geom::distance(from[i] + geom::Vector{500.0, 0.0}, to[i]), 0.0, 1e-8);
    }
    // Beds that dip along the datum are the same bed farther along; forward and back is the same.
    const SectionMap& map = there->restoration->map;
    for (const geom::Point p : lines[1].points)
      EXPECT_NEAR(geom::distance(map.inverse(map.forward(p).at), p), 0.0, 1e-9);
    for (const geom::Point p : lines[1].points)
      EXPECT_NEAR(geom::distance(map.swapped().forward(map.forward(p).at).at, p), 0.0, 1e-9);
  }
}

TEST(ShearMap, APinOnABentTargetTakesTheTopOntoThatTarget) {
  unfold::TargetParams goal;
  goal.shape = unfold::TargetShape::Line;
  goal.points = {{-1000, 300}, {500, 0}, {1200, 150}, {5000, -200}};
  goal.target_pin = {1200.0, 150.0};
  goal.pin = 500.0;
  const auto made = sheared({wave(30.0), wave(30.0, -300.0)}, 0.0, goal);
  ASSERT_TRUE(made) << to_string(made.error());
  const geom::Polyline target{goal.points, false};
  const auto& top = made->restoration->section.horizons[0].line.points;
  EXPECT_NEAR(top.front().x, 700.0, 1e-9);
  EXPECT_NEAR(top.back().x, 2700.0, 1e-9);
  for (const geom::Point p : top) {
    double nearest = 1e9;
    for (std::size_t i = 0; i < 3; ++i) nearest = std::min(nearest, geom::distance(target.segment(i), p));
    EXPECT_NEAR(nearest, 0.0, 1e-9);
  }
  // Half way: half of the move.
  const auto half = sheared({wave(30.0), wave(30.0, -300.0)}, 0.0, goal, 50.0);
  ASSERT_TRUE(half);
  EXPECT_NEAR(half->restoration->section.horizons[0].line.points.front().x, 350.0, 1e-9);
}

TEST(ShearMap, RemarksAreThoseOfAShear) {
  for (const double degrees : {0.0, 20.0, -35.0}) {
    const auto made = sheared({wave(30.0), wave(30.0, -5.0)}, degrees);
    ASSERT_TRUE(made);
    EXPECT_FALSE(says(*made, "medial axis")) << degrees;
    EXPECT_FALSE(says(*made, "of horizon 'top' lie beyond")) << degrees;
    EXPECT_EQ(says(*made, "of horizon 'bed1' lie beyond"), degrees != 0.0);
    EXPECT_EQ(says(*made, "along the direction of shear"), true);
  }
}

}  // namespace
}  // namespace recon::maps
