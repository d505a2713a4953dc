#include "quebra/core/repair.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace quebra::core {
namespace {

using dobra::geom::Arc;
using dobra::geom::Point;
using dobra::geom::Polyline;

Curve polygon(const std::string& name, std::vector<Point> points, Role role = Role::Boundary) { return {name, role, Polyline{std::move(points), true}, {}}; }
Curve line(const std::string& name, std::vector<Point> points) { return {name, Role::Boundary, Polyline{std::move(points), false}, {}}; }

Repaired mended(std::vector<Curve> curves) {
  Sketch sketch;
  sketch.places.resize(curves.size());
  sketch.curves = std::move(curves);
  return repair(std::move(sketch)).value();
}

std::vector<Wrong> kinds(const Repaired& repaired) {
  std::vector<Wrong> result;
  for (const Finding& finding : repaired.findings) result.push_back(finding.wrong);
  return result;
}

/// Area of the material of the domain that the mended sketch makes.
double area_of(const Repaired& repaired) {
  const auto domain = make_domain(repaired.sketch);
  EXPECT_TRUE(domain.ok()) << (domain ? "" : to_string(domain.error()));
  double area = 0.0;
  if (domain) {
    for (const Face& face : domain->faces) area += face.area;
  }
  return area;
}

TEST(Repair, GoodGeometryStaysAsItIs) {
  const auto arc = Arc::from_angles({0, 0}, 1.0, dobra::base::Angle::from_degrees(0), dobra::base::Angle::from_degrees(180)).value();
  const Repaired same = mended({{"arc", Role::Boundary, arc, {}}, line("chord", {{-1, 0}, {1, 0}}), polygon("hole", {{-0.1, 0.2}, {0.1, 0.2}, {0, 0.5}})});
  EXPECT_TRUE(same.findings.empty());
  EXPECT_EQ(same.sketch.curves.size(), 3U);
}

TEST(Repair, RepeatedPointsSpikesAndDoublesGo) {
  const Repaired repaired = mended({polygon("a", {{0, 0}, {0, 0}, {4, 0}, {4, 4}, {4, 4 + 1e-9}, {0, 4}, {0, 2}, {-3, 2}, {0, 2}, {0, 0}}),
                                    polygon("again", {{0, 4}, {4, 4}, {4, 0}, {0, 0}, {0, 2}}), line("dot", {{1, 1}, {1, 1}})});
  EXPECT_EQ(kinds(repaired), (std::vector{Wrong::RepeatedPoint, Wrong::NearlyRepeatedPoint, Wrong::RepeatedPoint, Wrong::Spike, Wrong::RepeatedPoint, Wrong::RepeatedPoint, Wrong::NoExtent, Wrong::CurveTwice}));
  EXPECT_EQ(repaired.findings[3].at, (Point{-3, 2}));
}

TEST(Repair, GapsAreClosedAtTheirPlace) {
  const Repaired repaired = mended({line("a", {{0, 0}, {4, 0}, {4, 4}}), line("b", {{4.001, 4}, {0, 4}, {0, 0.002}})});
  EXPECT_EQ(kinds(repaired), (std::vector{Wrong::Gap, Wrong::Gap}));
  EXPECT_NEAR(area_of(repaired), 16.0, 1e-12);
  const Repaired open = mended({line("c", {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0.001}})});
  EXPECT_NEAR(area_of(open), 16.0, 1e-12);
  EXPECT_TRUE(mended({line("wide", {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 1}})}).findings.empty()) << "a gap that wide is meant, or an error";
}

TEST(Repair, AGapAtASplineIsClosedAndOneAtAnArcIsNamed) {
  using dobra::geom::CubicPath;
  const auto bow = [](Point to) { return Smooth::make(CubicPath({{{4, 0}, to, {0, 6}, {-6, 0}}}, {0.0, 1.0})).value(); };
  const Repaired spline = mended({line("a", {{0, 0}, {4, 0}}), {"bow", Role::Boundary, bow({0.001, 4}), {}}, line("b", {{0, 4}, {0, 0}})});
  EXPECT_EQ(kinds(spline), (std::vector{Wrong::Gap}));
  EXPECT_GT(area_of(spline), 8.0);
  const Repaired two = mended({{"bow", Role::Boundary, bow({0.001, 4}), {}}, {"back", Role::Boundary, Smooth::make(CubicPath({{{0, 4}, {4, 0}, {0, -4}, {4, 0}}}, {0.0, 1.0})).value(), {}}});
  EXPECT_EQ(kinds(two), (std::vector{Wrong::Gap}));
  EXPECT_GT(area_of(two), 1.0);
  const auto arc = [](double radius) { return Arc::from_angles({0, 0}, radius, dobra::base::Angle::from_degrees(0), dobra::base::Angle::from_degrees(180)).value(); };
  const Repaired arcs = mended({{"arc", Role::Boundary, arc(1.0), {}}, {"lower", Role::Boundary, Arc::from_angles({0.001, 0}, 1.0, dobra::base::Angle::from_degrees(180), dobra::base::Angle::from_degrees(180)).value(), {}}});
  ASSERT_EQ(kinds(arcs), (std::vector{Wrong::Gap, Wrong::Gap}));
  EXPECT_NE(arcs.findings[0].mend.find("left as it is"), std::string::npos);
}

TEST(Repair, OverlappingOutlinesAreUnitedAndHolesCutOut) {
  const Repaired united = mended({polygon("a", {{0, 0}, {4, 0}, {4, 4}, {0, 4}}), polygon("b", {{2, 2}, {6, 2}, {6, 6}, {2, 6}})});
  EXPECT_EQ(kinds(united), (std::vector{Wrong::Crossing}));
  EXPECT_NEAR(area_of(united), 28.0, 1e-12);
  const Repaired cut = mended({polygon("a", {{0, 0}, {4, 0}, {4, 4}, {0, 4}}), polygon("hole", {{3, 1}, {5, 1}, {5, 2}, {3, 2}}, Role::Hole)});
  EXPECT_NEAR(area_of(cut), 15.0, 1e-12);
  const Repaired holes = mended({polygon("a", {{0, 0}, {9, 0}, {9, 9}, {0, 9}}), polygon("h", {{1, 1}, {3, 1}, {3, 3}, {1, 3}}), polygon("i", {{2, 2}, {4, 2}, {4, 4}, {2, 4}})});
  EXPECT_NEAR(area_of(holes), 81.0 - 7.0, 1e-12);
}

TEST(Repair, ABowTieBecomesTwoLoopsThatTouch) {
  const Repaired repaired = mended({polygon("bow", {{0, 0}, {2, 2}, {2, 0}, {0, 2}})});
  ASSERT_EQ(kinds(repaired), (std::vector{Wrong::Crossing}));
  EXPECT_EQ(repaired.findings[0].at, (Point{1, 1}));
  EXPECT_EQ(repaired.sketch.curves.size(), 2U);
  EXPECT_NEAR(area_of(repaired), 2.0, 1e-12);
}

TEST(Repair, WhatItCannotMendIsNamedAndLeft) {
  const auto circle = Arc::circle({2, 0}, 1.0).value();
  const Repaired repaired = mended({polygon("a", {{-1, -1}, {2, -1}, {2, 2}, {-1, 2}}), {"circle", Role::Boundary, circle, {}}});
  ASSERT_EQ(kinds(repaired), (std::vector{Wrong::Crossing}));
  EXPECT_EQ(repaired.findings[0].curve, "a, circle");
  EXPECT_NE(repaired.findings[0].mend.find("left as it is"), std::string::npos);
  EXPECT_EQ(repaired.sketch.curves.size(), 2U);
}

}  // namespace
}  // namespace quebra::core
