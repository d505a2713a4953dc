#include "recon/kinematics/flow_map.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "shared/offset/offset.h"
#include "tests/recon/kinematics/draws.h"

namespace recon::kinematics {
namespace {

constexpr double pi = std::numbers::pi;

/// z = -1000 (1 - exp(x / 800)) from x = -3000 to 0.
FaultPath listric_fault(int pieces) {
  FaultPath path;
  for (int i = 0; i <= pieces; ++i) {
    const double x = -3000.0 + 3000.0 * i / pieces;
    path.line.points.push_back({x, -1000.0 * (1.0 - std::exp(x / 800.0))});
  }
  return path;
}

FaultPath random_chain(test::Draws& draws, int pieces) {
  FaultPath path = test::fault({{0, 0}});
  for (int i = 0; i < pieces; ++i) {
    const double angle = draws.in(-50, 50) * pi / 180.0;
    const double length = draws.in(100, 500);
    path.line.points.push_back(path.line.points.back() +
                               geom::Vector{length * std::cos(angle), length * std::sin(angle)});
  }
  return path;
}

FlowMap flow_of(const FaultPath& path, const std::vector<double>& speeds, double amount) {
  return {std::make_shared<const FlowDomains>(FlowDomains::make(path, speeds).value()), amount};
}

/// The distance of a point from the chain into the hanging wall (left), by all mitred strips: brute force, and only
/// where no walls have met.
double level_by_brute_force(const FaultPath& path, geom::Point p, geom::Vector& along) {
  double nearest = 1e300;
  double level = 0.0;
  for (std::size_t i = 0; i < path.line.segment_count(); ++i) {
    const geom::Segment s = path.line.segment(i);
    const geom::Vector unit = geom::normalised(s.vector());
    const bool first = i == 0;
    const bool last = i + 1 == path.line.segment_count();
    double part = geom::dot(p - s.from, unit);
    if (!first) part = std::max(part, 0.0);
    if (!last) part = std::min(part, s.length());
    const double distance = geom::distance(p, s.from + part * unit);
    if (distance >= nearest) continue;
    nearest = distance;
    level = geom::cross(unit, p - s.from);
    along = unit;
  }
  return level;
}

TEST(FlowDomains, WallsOfAListricFaultMeetWhereTheyShould) {
  const FlowDomains flow = FlowDomains::make(listric_fault(12), std::vector<double>(12, 1.0)).value();
  ASSERT_EQ(flow.merges().size(), 10U);
  const double levels[] = {2120.273, 2139.000, 2261.004, 2462.843};
  const std::size_t ended[] = {10, 9, 8, 7};
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR(flow.merges()[i].psi, levels[i], 5e-4);
    EXPECT_EQ(flow.merges()[i].ended.index(), ended[i]);
  }
}

TEST(FlowDomains, FlowLinesAreTheBisectorOffsetsBelowAndBeyondTheMerges) {
  for (const int pieces : {5, 50, 500}) {
    const FaultPath path = listric_fault(pieces);
    const FlowDomains flow = FlowDomains::make(path, std::vector<double>(pieces, 1.0)).value();
    for (const double d : {150.0, 1100.0, 2300.0}) {
      dobra::offset::OffsetOptions options;
      options.side = dobra::offset::Side::LeftOfTravel;
      options.join = dobra::offset::Join::Bisector;
      // The fault goes on straight at both ends; the engine's base does not.
      geom::Polyline base = path.line;
      base.points.front() = base.points.front() - 20.0 * base.segment(0).vector();
      base.points.back() = base.points.back() + 20.0 * base.segment(base.segment_count() - 1).vector();
      const auto made = dobra::offset::offset(base, std::vector<double>{d}, options);
      ASSERT_TRUE(made) << to_string(made.error());
      double worst = 0.0;
      std::size_t points = 0;
      const geom::Polyline line = flow.flow_line(d, 20000.0);
      for (const auto& piece : made->front().pieces) {
        for (const geom::Point p : piece.points) {
          worst = std::max(worst, geom::distance(line, p));
          ++points;
        }
      }
      EXPECT_GE(points, 3U);
      EXPECT_LE(worst, 1e-9 * 3200.0) << pieces << " pieces at " << d;
    }
  }
}

TEST(FlowMap, APlanarFaultShifts) {
  const FlowMap map = fault_parallel_flow(test::fault({{0, 0}, {300, 400}}), 50.0).value();
  test::expect_near(BlockMap(map).forward(geom::Point{-700, 900}), {-670, 940}, 1e-12);
}

TEST(FlowMap, AHingeOf30DegreesMakesAKinkWithABackLimbOf30AndAnAxisOf75) {
  const FaultPath path = test::fault({{-5000, 0}, {0, 0}, {2000 * std::cos(pi / 6), 1000}});
  for (const FaultPath& one : {path, test::mirrored(path)}) {
    const double sign = one.line.points[0].x < 0.0 ? 1.0 : -1.0;
    const BlockMap map{fault_parallel_flow(one, 400.0).value()};
    const MovedLine top = map.forward(geom::Polyline{{{sign * -3000, 1000}, {sign * 1500, 1000}}, false});
    ASSERT_EQ(top.after.points.size(), 4U);
    const geom::Vector limb = top.after.points[2] - top.after.points[1];
    EXPECT_NEAR(std::atan2(limb.y, sign * limb.x), pi / 6, 1e-12);
    const geom::Vector axis = top.after.points[1] - geom::Point{0, 0};
    EXPECT_NEAR(std::atan2(axis.y, -sign * axis.x), 75.0 * pi / 180.0, 1e-12);
  }
}

TEST(FlowMap, AreasAreKeptWithTheBreaksAndNotWithoutThem) {
  test::Draws draws(21);
  double chords = 0.0;
  for (int i = 0; i < 200; ++i) {
    const int pieces = 2 + i % 7;
    const FaultPath path = random_chain(draws, pieces);
    std::vector<double> speeds;
    for (int k = 0; k < pieces; ++k) speeds.push_back(i % 2 == 0 ? 1.0 : draws.in(0.8, 1.25));
    const BlockMap map{flow_of(path, speeds, draws.in(-600, 600))};
    const double middle = 0.5 * path.line.points.back().x;
    // High enough to lie in the hanging wall as a whole.
    const geom::Polyline polygon = test::star(draws, {middle, path.line.box().high.y + 500.0}, 450.0);
    const MovedLine moved = map.forward(polygon);
    EXPECT_LE(std::abs(test::area_change(moved)), 1e-12) << i;
    chords = std::max(chords, std::abs(test::area_change_of_given(moved)));
  }
  EXPECT_GT(chords, 1e-3);
}

TEST(FlowMap, BackIsTheInverseForRandomChainsSpeedsAndPoints) {
  test::Draws draws(22);
  double worst = 0.0;
  int tried = 0;
  for (int i = 0; i < 10000; ++i) {
    const int pieces = 2 + i % 8;
    const FaultPath path = random_chain(draws, pieces);
    std::vector<double> speeds;
    for (int k = 0; k < pieces; ++k) speeds.push_back(i % 2 == 0 ? 1.0 : draws.in(0.7, 1.3));
    const FlowDomains domains = FlowDomains::make(path, speeds).value();
    const BlockMap map{FlowMap(std::make_shared<const FlowDomains>(domains), draws.in(-600, 600))};
    const BlockMap back = map.swapped();
    for (int k = 0; k < 4; ++k) {
      geom::Point p = draws.in_box({-300, -900}, {path.line.points.back().x + 300, 3000});
      // Some on the fault, some on walls.
      if (k == 0) p = geom::point_at(path.line, geom::arc_lengths(path.line), draws.in(0, 400));
      if (k == 1) p = domains.walls()[0].point(0.5 * std::min(domains.walls()[0].to, 800.0));
      if (k > 0 && wall_of(path, p) != Wall::Hanging) continue;
      worst = std::max(worst, geom::distance(back.forward(map.forward(p)), p));
      ++tried;
    }
  }
  EXPECT_GT(tried, 25000);
  EXPECT_LE(worst, 1e-9 * 1000.0);
}

TEST(FlowMap, TinyStepsOfTheRawFieldEndAtTheSamePoint) {
  test::Draws draws(23);
  for (int i = 0; i < 20; ++i) {
    const FaultPath path = listric_fault(9);
    geom::Point p = draws.in_box({-3500, 100}, {0, 700});
    const double slip = draws.in(-700, 700);
    const geom::Point end = BlockMap(fault_parallel_flow(path, slip).value()).forward(p);
    const int steps = 20000;
    for (int k = 0; k < steps; ++k) {
      geom::Vector along;
      level_by_brute_force(path, p, along);
      p = p + (slip / steps) * along;
    }
    test::expect_near(p, end, 5.0 * std::abs(slip) / steps);
  }
}

TEST(FlowMap, TheLevelOfAPointIsItsDistanceFromTheFaultAndStays) {
  test::Draws draws(24);
  const FaultPath path = listric_fault(12);
  const BlockMap map{fault_parallel_flow(path, 500.0).value()};
  for (int i = 0; i < 200; ++i) {
    const geom::Point p = draws.in_box({-3500, 50}, {0, 900});
    geom::Vector unused;
    EXPECT_NEAR(level_by_brute_force(path, map.forward(p), unused), level_by_brute_force(path, p, unused), 1e-9);
  }
}

TEST(FlowMap, ARegularArcWhoseWallsAllMeetInItsCentreKeepsAreasRoundIt) {
  FaultPath path = test::fault({});
  for (int i = 0; i <= 16; ++i) {
    const double angle = pi * (1.0 + 0.15) + 0.7 * pi * i / 16;
    path.line.points.push_back({1000 * std::cos(angle), 1000 * std::sin(angle)});
  }
  const FlowDomains domains = FlowDomains::make(path, std::vector<double>(16, 1.0)).value();
  ASSERT_EQ(domains.merges().size(), 14U);
  for (const Merge& merge : domains.merges()) test::expect_near(merge.place, {0, 0}, 1e-6);
  test::Draws draws(25);
  const BlockMap map{fault_parallel_flow(path, 300.0).value()};
  for (int i = 0; i < 50; ++i) {
    const MovedLine moved = map.forward(test::star(draws, draws.in_box({-50, -50}, {50, 50}), 400.0));
    EXPECT_LE(std::abs(test::area_change(moved)), 1e-9);
  }
}

TEST(FlowMap, ManyPointsGoWhereSingleOnesGo) {
  test::Draws draws(26);
  const BlockMap map{fault_parallel_flow(listric_fault(50), 300.0).value()};
  std::vector<geom::Point> points;
  for (int i = 0; i < 20000; ++i) points.push_back({-3200.0 + 0.15 * i, 300.0 + 200.0 * std::sin(0.01 * i)});
  std::vector<geom::Point> images(points.size());
  ASSERT_TRUE(map.forward(points, images));
  for (std::size_t i = 0; i < points.size(); i += 7) test::expect_near(images[i], map.forward(points[i]), 1e-9);
}

TEST(FlowDomains, APathThatTurnsBackIsRefusedWithThePlace) {
  const auto refused = fault_parallel_flow(test::fault({{0, 0}, {100, 0}, {150, 80}, {100, 160}, {0, 160}}), 10.0);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, base::ErrorCode::CannotRestore);
  EXPECT_EQ(refused.error().place->x, 100.0);
  EXPECT_EQ(refused.error().place->y, 160.0);
}

TEST(FlowDomains, TwoSpeedsInOneDirectionAreRefusedWithThePlace) {
  const auto refused = FlowDomains::make(test::fault({{0, 0}, {100, 0}, {250, 0}}), {1.0, 0.8});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().place->x, 100.0);
}

}  // namespace
}  // namespace recon::kinematics
