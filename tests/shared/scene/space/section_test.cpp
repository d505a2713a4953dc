// The plane of a section, and what a hand does to it.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "shared/scene/space/section.h"

namespace dobra::test {
namespace {

using geom::Box3;
using geom::Point;
using geom::Point3;
using geom::Vector3;
using namespace scene::space;

const Box3 house{{10.0, 20.0, 0.0}, {18.0, 26.0, 5.0}};

/// As a window would show the box.
Sheet sheet_of(const Camera& camera, double exaggeration = 1.0, const Box3& box = house) {
  Sheet sheet;
  sheet.frame = frame_of(camera, box, exaggeration);
  sheet.page = {{0.0, 0.0}, {400.0, 300.0}, 30.0, 30.0};
  sheet.plot = {{0.0, 0.0}, {800.0, 600.0}};
  return sheet;
}

Point page_of(const Sheet& sheet, Point3 at) { return project(sheet, at)->at; }

/// Above 0: on the side that is taken away.
double above(const CutPlane& plane, Point3 p) { return dot(p - plane.through, plane.normal); }

double area(const std::vector<Point3>& closed) {
  Vector3 sum{};
  for (std::size_t i = 0; i + 1 < closed.size(); ++i)
    sum = sum + cross(closed[i] - closed[0], closed[i + 1] - closed[0]);
  return 0.5 * length(sum);
}

TEST(SectionPlane, FramesOfTurnedPlanesHaveThreeToSixSides) {
  const Box3 cube{{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}};
  const auto hexagon = frame_of({{0.5, 0.5, 0.5}, {1.0, 1.0, 1.0}}, cube);
  ASSERT_EQ(hexagon.size(), 7U);
  EXPECT_EQ(hexagon.front(), hexagon.back());
  EXPECT_NEAR(area(hexagon), 0.75 * std::sqrt(3.0), 1e-12);  // six triangles of side sqrt(1/2)
  for (const Point3& p : hexagon) EXPECT_NEAR(p.x + p.y + p.z, 1.5, 1e-12);
  const auto corner = frame_of({{0.25, 0.0, 0.0}, {1.0, 1.0, 1.0}}, cube);
  ASSERT_EQ(corner.size(), 4U);
  EXPECT_NEAR(area(corner), 0.25 * 0.25 * std::sqrt(3.0) / 2.0, 1e-12);
  const auto diagonal = frame_of({{0.0, 0.0, 0.0}, {1.0, -1.0, 0.0}}, cube);  // through corners
  ASSERT_EQ(diagonal.size(), 5U);
  EXPECT_NEAR(area(diagonal), std::sqrt(2.0), 1e-12);
  const auto side = frame_of({{0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}}, cube);
  ASSERT_EQ(side.size(), 5U);
  EXPECT_NEAR(area(side), 1.0, 1e-12);
  const auto beside = frame_of({{2.0, 2.0, 2.0}, {1.0, 1.0, 1.0}}, cube);
  ASSERT_EQ(beside.size(), 2U);
  EXPECT_EQ(beside.front(), (Point3{1.0, 1.0, 1.0}));
}

TEST(SectionPlane, PartsAndPlacesSayTheSame) {
  EXPECT_DOUBLE_EQ(place_of(section_across(CutAxis::Y, 0.5), house), 23.0);
  const Section turned{{0.6, 0.8, 0.0}, 0.25, false};
  EXPECT_DOUBLE_EQ(place_of(turned, house), 22.0 + 0.25 * (31.6 - 22.0));  // (10, 20) to (18, 26)
  EXPECT_NEAR(place_of(placed(turned, house, 30.0), house), 30.0, 1e-12);
  EXPECT_EQ(placed(turned, house, 40.0).part, 1.0);
  EXPECT_EQ(placed(turned, house, -1.0).part, 0.0);
  for (const Section& each : {section_across(CutAxis::X, 0.3), section_across(CutAxis::Z, 0.9, true), turned}) {
    const CutPlane plane = plane_of(each, house);
    EXPECT_NEAR(dot(plane.through - Point3{}, each.normal), place_of(each, house), 1e-12);
    EXPECT_EQ(dot(plane.normal, each.normal) < 0.0, each.other_side);
  }
  EXPECT_EQ(axis_of(section_across(CutAxis::Z)), CutAxis::Z);
  EXPECT_FALSE(axis_of(turned));
  // Nothing to go along: a flat box keeps its part.
  const Box3 flat{{0.0, 0.0, 2.0}, {4.0, 3.0, 2.0}};
  EXPECT_EQ(placed(section_across(CutAxis::Z), flat, 7.0).part, 0.5);
  EXPECT_DOUBLE_EQ(place_of(section_across(CutAxis::Z), flat), 2.0);
}

TEST(SectionHandle, StandsInThePlaneAndPointsToWhatIsTakenAway) {
  for (const bool other : {false, true}) {
    for (const Vector3 normal : {Vector3{1.0, 0.0, 0.0}, Vector3{0.0, 0.6, 0.8}}) {
      const Section section{normal, 0.4, other};
      const CutPlane plane = plane_of(section, house);
      const Handle handle = handle_of(section, house, 3.0);
      ASSERT_GE(handle.rim.size(), 5U);
      for (const Point3& p : handle.rim) EXPECT_NEAR(above(plane, p), 0.0, 1e-9);
      EXPECT_NEAR(above(plane, handle.middle), 0.0, 1e-9);
      EXPECT_GT(above(plane, handle.tip), 0.1);
      EXPECT_EQ(dot(handle.tip - handle.middle, normal) < 0.0, other);
    }
  }
  // A plate has a rim to take hold of too.
  const Box3 flat{{0.0, 0.0, 2.0}, {4.0, 3.0, 2.0}};
  EXPECT_GT(area(handle_of(section_across(CutAxis::X), flat, 1.0).rim), 1.0);
}

TEST(SectionHandle, IsFoundWhereItIsSeenAlone) {
  const Sheet sheet = sheet_of(camera_of(StandardView::Isometric));
  const Handle handle = handle_of(section_across(CutAxis::X), house, 1.0);
  EXPECT_EQ(grip_at(handle, sheet, page_of(sheet, handle.tip), 6.0), Grip::Arrow);
  EXPECT_EQ(grip_at(handle, sheet, page_of(sheet, midpoint(handle.middle, handle.tip)), 6.0), Grip::Arrow);
  EXPECT_EQ(grip_at(handle, sheet, page_of(sheet, midpoint(handle.rim[1], handle.rim[2])), 6.0), Grip::Rim);
  EXPECT_FALSE(grip_at(handle, sheet, {2.0, 2.0}, 6.0));
  const Point3 inside = handle.rim[0] + 0.5 * (handle.middle - handle.rim[0]);
  EXPECT_FALSE(grip_at(handle, sheet, page_of(sheet, inside), 6.0));
}

struct Seen {
  StandardView view;
  double exaggeration;
};

class SectionDragged : public testing::TestWithParam<Seen> {};

TEST_P(SectionDragged, TheArrowGoesAlongItsNormalWithTheHand) {
  const Sheet sheet = sheet_of(camera_of(GetParam().view), GetParam().exaggeration);
  for (const Section& begin : {section_across(CutAxis::X, 0.4), section_across(CutAxis::Z, 0.6, true),
                               Section{geom::normalised(Vector3{2.0, -1.0, 2.0}), 0.5, false}}) {
    const Handle handle = handle_of(begin, house, GetParam().exaggeration);
    const Point3 held = handle.middle + 0.7 * (handle.tip - handle.middle);
    const Point press = page_of(sheet, held);
    if (geom::distance(page_of(sheet, handle.middle), page_of(sheet, handle.tip)) < 12.0)
      continue;  // seen from its end
    SectionDrag drag(begin, house, handle, Grip::Arrow, sheet, press);
    EXPECT_NEAR(place_of(drag.to(sheet, press), house), place_of(begin, house), 1e-9);
    for (const double by : {0.8, -0.5}) {
      const Section now = drag.to(sheet, page_of(sheet, held + by * begin.normal));
      EXPECT_NEAR(place_of(now, house), place_of(begin, house) + by, 1e-7);
      EXPECT_EQ(now.normal, begin.normal);
      EXPECT_EQ(now.other_side, begin.other_side);
    }
    // What the hand does across the arrow moves nothing; far away the plane stops at the end of the box.
    const Point tip = page_of(sheet, handle.tip), middle = page_of(sheet, handle.middle);
    const geom::Vector across{tip.y - middle.y, middle.x - tip.x};
    EXPECT_NEAR(place_of(drag.to(sheet, press + 0.4 * across), house), place_of(begin, house), 1e-7);
    EXPECT_EQ(drag.to(sheet, page_of(sheet, held + 9.0 * begin.normal)).part, 1.0);
  }
}

TEST_P(SectionDragged, TheRimFollowsTheHandOnASphere) {
  const double by = GetParam().exaggeration;
  const Sheet sheet = sheet_of(camera_of(GetParam().view), by);
  const Section begin{geom::normalised(Vector3{3.0, 1.0, 0.5}), 0.5, false};
  const Handle handle = handle_of(begin, house, by);
  const auto arm_of = [&](Point3 p) {
    return Vector3{p.x - handle.middle.x, p.y - handle.middle.y, by * (p.z - handle.middle.z)};
  };
  const Vector3 n{begin.normal.x, begin.normal.y, begin.normal.z / by};
  for (std::size_t i = 0; i + 1 < handle.rim.size(); ++i) {
    const Point3 held = handle.rim[i] + 0.4 * (handle.rim[i + 1] - handle.rim[i]);
    const Vector3 arm = arm_of(held);
    // Tipped by 15 degrees out of the plane, on the half of the sphere where it was.
    const double angle = 15.0 * std::numbers::pi / 180.0;
    const Vector3 tipped = std::cos(angle) * arm + (std::sin(angle) * length(arm) / length(n)) * n;
    const Point3 target{handle.middle.x + tipped.x, handle.middle.y + tipped.y, handle.middle.z + tipped.z / by};
    const Ray ray = ray_at(sheet, page_of(sheet, target), house);
    const Vector3 along{ray.along.x, ray.along.y, by * ray.along.z};
    const Vector3 way{ray.from.x - handle.middle.x, ray.from.y - handle.middle.y, by * (ray.from.z - handle.middle.z)};
    const auto near_half = [&](Vector3 v) { return dot(v, along) < 0.0; };
    const double passes = length(cross(way, along)) / length(along);
    if (passes > 0.9 * length(arm) || near_half(arm) != near_half(tipped)) continue;
    SectionDrag drag(begin, house, handle, Grip::Rim, sheet, page_of(sheet, held));
    const Section same = drag.to(sheet, page_of(sheet, held));
    EXPECT_NEAR(dot(same.normal, begin.normal), 1.0, 1e-9);
    const Section now = drag.to(sheet, page_of(sheet, target));
    if (axis_of(now)) continue;
    const CutPlane plane = plane_of(now, house);
    EXPECT_NEAR(length(now.normal), 1.0, 1e-12);
    EXPECT_NEAR(above(plane, target), 0.0, 1e-6);
    EXPECT_NEAR(above(plane, handle.middle), 0.0, 1e-9);
    // It turned about nothing but the line square to both arms.
    const Vector3 axis = cross(arm, tipped);
    const Vector3 m{now.normal.x, now.normal.y, now.normal.z / by};
    EXPECT_NEAR(dot(m, axis) / (length(m) * length(axis)), dot(n, axis) / (length(n) * length(axis)), 1e-6);
  }
}

INSTANTIATE_TEST_SUITE_P(Views, SectionDragged,
                         testing::Values(Seen{StandardView::Front, 1.0}, Seen{StandardView::Isometric, 1.0},
                                         Seen{StandardView::Isometric, 4.0}, Seen{StandardView::Cavalier, 1.0},
                                         Seen{StandardView::Cabinet, 2.0}, Seen{StandardView::Perspective, 1.0},
                                         Seen{StandardView::Perspective, 3.0}));

TEST(SectionTurned, SeenFromAboveItGoesRoundTheVertical) {
  const Sheet sheet = sheet_of(camera_of(StandardView::Top));
  const Section begin = section_across(CutAxis::X);
  const Handle handle = handle_of(begin, house, 1.0);
  const Point3 end{14.0, 26.0, 2.5};  // of the line as which the plane is seen, 3 north of its middle
  EXPECT_NEAR(geom::distance(handle.middle, {14.0, 23.0, 2.5}), 0.0, 1e-12);
  for (const double degrees : {10.0, 40.0, -30.0, 70.0}) {
    SectionDrag drag(begin, house, handle, Grip::Rim, sheet, page_of(sheet, end) + geom::Vector{1.0, 2.0});
    const double angle = degrees * std::numbers::pi / 180.0;
    const Point3 to{14.0 - 3.0 * std::sin(angle), 23.0 + 3.0 * std::cos(angle), 2.5};
    const Section now = drag.to(sheet, page_of(sheet, to) + geom::Vector{1.0, 2.0});
    EXPECT_NEAR(now.normal.x, std::cos(angle), 1e-6) << degrees;
    EXPECT_NEAR(now.normal.y, std::sin(angle), 1e-6) << degrees;
    EXPECT_NEAR(now.normal.z, 0.0, 1e-6) << degrees;
  }
}

TEST(SectionTurned, SeenFromAboveItsUpperSideTipsIt) {
  const Sheet sheet = sheet_of(camera_of(StandardView::Top));
  const Handle handle = handle_of(section_across(CutAxis::X), house, 1.0);
  SectionDrag drag(section_across(CutAxis::X), house, handle, Grip::Rim, sheet, page_of(sheet, {14.0, 23.0, 5.0}));
  const Section now = drag.to(sheet, page_of(sheet, {15.5, 23.0, 4.5}));  // 3-4-5: 2.5 up has become 1.5 east, 2 up
  EXPECT_NEAR(now.normal.x, 0.8, 1e-9);
  EXPECT_NEAR(now.normal.y, 0.0, 1e-9);
  EXPECT_NEAR(now.normal.z, -0.6, 1e-9);
}

TEST(SectionTurned, NearAnAxisItIsSquareToItAndTakesTheSameSideAway) {
  const Sheet sheet = sheet_of(camera_of(StandardView::Top));
  const Section begin = section_across(CutAxis::X);
  const Handle handle = handle_of(begin, house, 1.0);
  for (const double degrees : {-89.0, 89.5, 1.0, 179.0}) {
    SectionDrag drag(begin, house, handle, Grip::Rim, sheet, page_of(sheet, {14.0, 26.0, 2.5}));
    // From here to there in steps, as a hand goes.
    Section now = begin;
    const double angle = degrees * std::numbers::pi / 180.0;
    for (int i = 1; i <= 20; ++i) {
      const double a = angle * i / 20.0;
      now = drag.to(sheet, page_of(sheet, {14.0 - 3.0 * std::sin(a), 23.0 + 3.0 * std::cos(a), 2.5}));
    }
    ASSERT_TRUE(axis_of(now)) << degrees;
    EXPECT_EQ(*axis_of(now), std::abs(degrees) < 10.0 || std::abs(degrees) > 170.0 ? CutAxis::X : CutAxis::Y);
    EXPECT_GT(now.normal.x + now.normal.y + now.normal.z, 0.0);
    // The side that the normal pointed to has turned with it.
    const Point3 was_ahead{14.0 + 3.5 * std::cos(angle), 23.0 + 2.5 * std::sin(angle), 2.5};
    EXPECT_GT(above(plane_of(now, house), was_ahead), 0.0) << degrees;
  }
}

TEST(SectionMoved, SeenFromItsEndTheArrowGoesUpAndDownThePage) {
  for (const bool from_behind : {false, true}) {
    Camera camera = camera_of(StandardView::Right);  // looks west: the x axis points at the viewer
    if (from_behind) camera.right = -camera.right;
    const Sheet sheet = sheet_of(camera);
    const Section begin = section_across(CutAxis::X);
    const Handle handle = handle_of(begin, house, 1.0);
    const Point press = page_of(sheet, handle.middle);
    EXPECT_EQ(grip_at(handle, sheet, press, 6.0), Grip::Arrow);
    SectionDrag drag(begin, house, handle, Grip::Arrow, sheet, press);
    const double up = place_of(drag.to(sheet, press + geom::Vector{0.0, -30.0}), house);
    EXPECT_NEAR(up, 14.0 + (from_behind ? -1.0 : 1.0), 1e-9);  // 30 of the page are 1 m
    EXPECT_NEAR(place_of(drag.to(sheet, press + geom::Vector{40.0, 0.0}), house), 14.0, 1e-9);
  }
}

}  // namespace
}  // namespace dobra::test
