// The projections of the notes, seen in the marks that vector files draw.
#include <gtest/gtest.h>

#include <cmath>

#include "shared/scene/space/display.h"
#include "shared/scene/space/layout.h"

namespace dobra::scene::space {
namespace {

using geom::Point;
using geom::Point3;

double degrees(double radians) { return radians * 180.0 / 3.14159265358979323846; }

SpacePicture picture_of(const std::vector<std::vector<Point3>>& lines) {
  Layer layer;
  layer.key = "lines";
  layer.content = Lines{lines, {}};
  SpacePicture picture;
  picture.layers = {layer};
  return picture;
}

/// A page on which the plane of the target is seen to scale 1, its target in the middle, and much larger than the
/// lines.
Sheet sheet_of(const Camera& camera, Point3 target = {0.0, 0.0, 0.0}) {
  Camera aimed = camera;
  aimed.target = target;
  const Frame frame = frame_of(aimed, {{-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}}, 1.0);
  const geom::Box plot{{0.0, 0.0}, {2000.0, 2000.0}};
  return {frame, transform_of({{0.0, 0.0}, 1.0}, plot), plot};
}

/// The whole line as drawn, in lengths of the plane of the page, y up.
geom::Segment drawn(const Sheet& sheet, Point3 from, Point3 to) {
  DisplayOptions whole;
  whole.piece = 1e9;
  const std::vector<Mark> marks = marks_of(picture_of({{from, to}}), sheet, whole);
  EXPECT_EQ(marks.size(), 1U);
  const auto& line = std::get<LineMark>(marks.at(0));
  return {sheet.page.to_world(line.from), sheet.page.to_world(line.to)};
}

geom::Vector drawn_axis(const Sheet& sheet, Point3 end) {
  const geom::Segment line = drawn(sheet, {0.0, 0.0, 0.0}, end);
  EXPECT_NEAR(line.from.x, 0.0, 1e-9);
  EXPECT_NEAR(line.from.y, 0.0, 1e-9);
  return line.to - line.from;
}

TEST(Projection, TRF_a_IsometricViewShortensAllAxesAlikeAndTwoOfThemRiseByThirtyDegrees) {
  EXPECT_NEAR(isometric().about_vertical.degrees(), 45.0, 1e-6);
  EXPECT_NEAR(isometric().about_horizontal.degrees(), 35.264390, 1e-6);
  const Sheet sheet = sheet_of(camera_of(StandardView::Isometric));
  const geom::Vector x = drawn_axis(sheet, {1.0, 0.0, 0.0});
  const geom::Vector y = drawn_axis(sheet, {0.0, 1.0, 0.0});
  const geom::Vector z = drawn_axis(sheet, {0.0, 0.0, 1.0});
  for (const geom::Vector& axis : {x, y, z}) EXPECT_NEAR(geom::length(axis), 0.816497, 1e-6);
  EXPECT_NEAR(degrees(std::atan2(-x.y, x.x)), 30.0, 1e-6);
  EXPECT_NEAR(degrees(std::atan2(y.y, y.x)), 30.0, 1e-6);
  EXPECT_NEAR(z.x, 0.0, 1e-9);
  EXPECT_GT(z.y, 0.0);
}

TEST(Projection, TRF_b_DimetricViewShortensDepthToHalfAndTheOthersAlike) {
  EXPECT_NEAR(dimetric(0.5).about_horizontal.degrees(), 20.704811, 1e-6);
  EXPECT_NEAR(dimetric(0.5).about_vertical.degrees(), 22.207654, 1e-6);
  const Sheet sheet = sheet_of(camera_of(StandardView::Dimetric));
  EXPECT_NEAR(geom::length(drawn_axis(sheet, {1.0, 0.0, 0.0})), 0.935414, 1e-6);
  EXPECT_NEAR(geom::length(drawn_axis(sheet, {0.0, 0.0, 1.0})), 0.935414, 1e-6);
  EXPECT_NEAR(geom::length(drawn_axis(sheet, {0.0, 1.0, 0.0})), 0.5, 1e-6);
}

TEST(Projection, TRF_c_CavalierKeepsDepthAndCabinetHalvesIt) {
  for (const auto& [view, factor, angle] :
       {std::tuple{StandardView::Cavalier, 1.0, 45.0}, std::tuple{StandardView::Cabinet, 0.5, 63.434949}}) {
    const Sheet sheet = sheet_of(camera_of(view));
    const geom::Vector depth = drawn_axis(sheet, {0.0, 1.0, 0.0});
    EXPECT_NEAR(geom::length(depth), factor, 1e-9);
    // Between the rays and the page.
    EXPECT_NEAR(degrees(std::atan(1.0 / geom::length(depth))), angle, 1e-6);
    EXPECT_NEAR(depth.x, factor * std::sqrt(0.5), 1e-9);
    EXPECT_NEAR(depth.y, factor * std::sqrt(0.5), 1e-9);
    // What faces the viewer keeps its shape.
    EXPECT_NEAR(drawn_axis(sheet, {1.0, 0.0, 0.0}).x, 1.0, 1e-9);
    EXPECT_NEAR(drawn_axis(sheet, {0.0, 0.0, 1.0}).y, 1.0, 1e-9);
  }
}

TEST(Projection, TRF_d_PerspectiveFromFiveAwayHalvesWhatIsFiveBehindThePage) {
  Camera camera = camera_of(StandardView::Front);
  camera.projection = Projection::Perspective;
  camera.distance = 5.0;
  const Sheet sheet = sheet_of(camera);
  // x of the notes is to the right, y up, z away from the viewer: our x, z and y.
  const geom::Vector at = drawn_axis(sheet, {2.0, 5.0, 3.0});
  EXPECT_NEAR(at.x, 1.0, 1e-12);
  EXPECT_NEAR(at.y, 1.5, 1e-12);
  // All lines away from the viewer end in one point of the page, whose depth is the distance of the eye.
  const geom::Segment line = drawn(sheet, {40.0, 0.0, 70.0}, {40.0, 1e12, 70.0});
  EXPECT_NEAR(line.from.x, 40.0, 1e-9);
  EXPECT_NEAR(line.to.x, 0.0, 1e-6);
  EXPECT_NEAR(line.to.y, 0.0, 1e-6);
  const auto seen = seen_line(sheet, {40.0, 0.0, 70.0}, {40.0, 1e12, 70.0});
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->to.depth, 5.0, 1e-9);
  const Column4 away = sheet.frame.matrix * column(geom::Vector3{0.0, 1.0, 0.0});
  EXPECT_NEAR(away[2] / away[3], 5.0, 1e-12);
}

/// A page whose plot shows a window of the front plane.
Sheet window(double width, double height, double page_width, double page_height) {
  Camera camera;
  camera.target = Point3{};
  const geom::Box plot{{0.0, 0.0}, {page_width, page_height}};
  return {frame_of(camera, {{0.0, -1.0, 0.0}, {width, 1.0, height}}, 1.0),
          transform_of({{0.5 * width, 0.5 * height}, width / page_width}, plot), plot};
}

TEST(Projection, GFX_d_LinesAreCutToTheWindow) {
  const Sheet sheet = window(10.0, 6.0, 500.0, 300.0);
  const auto expect = [&](Point from, Point to, Point cut_from, Point cut_to) {
    const geom::Segment line = drawn(sheet, {from.x, 0.0, from.y}, {to.x, 0.0, to.y});
    EXPECT_NEAR(geom::distance(line.from, cut_from), 0.0, 1e-9);
    EXPECT_NEAR(geom::distance(line.to, cut_to), 0.0, 1e-9);
  };
  expect({-5.0, 3.0}, {15.0, 3.0}, {0.0, 3.0}, {10.0, 3.0});
  expect({-2.0, -2.0}, {12.0, 12.0}, {0.0, 0.0}, {6.0, 6.0});
  EXPECT_TRUE(marks_of(picture_of({{{-1.0, 0.0, -1.0}, {-1.0, 0.0, 9.0}}}), sheet).empty());
}

TEST(Projection, GFX_e_TheWindowFillsTheViewport) {
  const Sheet sheet = window(10.0, 5.0, 200.0, 100.0);
  DisplayOptions whole;
  whole.piece = 1e9;
  const auto marks = marks_of(picture_of({{{0.0, 0.0, 0.0}, {2.5, 0.0, 2.5}}}), sheet, whole);
  ASSERT_EQ(marks.size(), 1U);
  const auto& line = std::get<LineMark>(marks[0]);
  // y of the page is down: the lower left corner of the viewport is (0, 100).
  EXPECT_NEAR(line.from.x, 0.0, 1e-9);
  EXPECT_NEAR(line.from.y, 100.0, 1e-9);
  EXPECT_NEAR(line.to.x, 50.0, 1e-9);
  EXPECT_NEAR(100.0 - line.to.y, 50.0, 1e-9);
  EXPECT_NEAR((line.to.x - line.from.x) / 2.5, 20.0, 1e-9);
  EXPECT_NEAR((line.from.y - line.to.y) / 2.5, 20.0, 1e-9);
}

TEST(Projection, WhatIsBehindTheEyeIsNotDrawn) {
  Camera camera;
  camera.projection = Projection::Perspective;
  camera.distance = 5.0;
  const Sheet sheet = sheet_of(camera);
  EXPECT_TRUE(marks_of(picture_of({{{1.0, -6.0, 1.0}, {2.0, -50.0, 1.0}}}), sheet).empty());
  // A line that passes the eye is drawn up to it, on the side where it is.
  for (const Mark& mark : marks_of(picture_of({{{1.0, 5.0, 0.0}, {1.0, -50.0, 0.0}}}), sheet))
    EXPECT_GT(std::get<LineMark>(mark).to.x, 1000.0);
}

TEST(Projection, ARayGoesThroughThePointThatIsSeenThere) {
  const geom::Box3 shown{{-3.0, -2.0, -1.0}, {3.0, 4.0, 5.0}};
  for (const StandardView view :
       {StandardView::Front, StandardView::Top, StandardView::Right, StandardView::Isometric, StandardView::Dimetric,
        StandardView::Cavalier, StandardView::Cabinet, StandardView::Perspective}) {
    const Frame frame = frame_of(camera_of(view), shown, 3.0);
    const geom::Box plot{{0.0, 0.0}, {400.0, 300.0}};
    const Sheet sheet{frame, transform_of({{0.3, -0.2}, 0.1}, plot), plot};
    const Point3 point{1.5, -0.5, 2.0};
    const auto seen = project(sheet, point);
    ASSERT_TRUE(seen);
    const Ray ray = ray_at(sheet, seen->at, shown);
    const geom::Vector3 off = point - ray.from;
    EXPECT_GT(geom::dot(off, ray.along), 0.0);
    EXPECT_NEAR(geom::length(geom::cross(off, ray.along)), 0.0, 1e-9);
    const Point3 moved = in_plane_of(sheet, seen->at + geom::Vector{10.0, 5.0}, point);
    const auto there = project(sheet, moved);
    ASSERT_TRUE(there);
    EXPECT_NEAR(geom::distance(there->at, seen->at + geom::Vector{10.0, 5.0}), 0.0, 1e-8);
    EXPECT_NEAR(there->depth, seen->depth, 1e-8);
  }
}

TEST(Projection, OrbitingKeepsTheAxesAtRightAnglesAndStopsAtTheTop) {
  Camera camera = camera_of(StandardView::Isometric);
  for (int i = 0; i < 1000; ++i)
    camera = orbited(camera, base::Angle::from_degrees(7.3), base::Angle::from_degrees(i % 2 == 0 ? 1.0 : -0.7));
  EXPECT_NEAR(geom::length(camera.right), 1.0, 1e-12);
  EXPECT_NEAR(geom::length(camera.up), 1.0, 1e-12);
  EXPECT_NEAR(geom::dot(camera.right, camera.up), 0.0, 1e-12);
  EXPECT_NEAR(camera.right.z, 0.0, 1e-9);
  camera = orbited(camera, {}, base::Angle::from_degrees(500.0));
  EXPECT_NEAR(towards_viewer(camera).z, 1.0, 1e-9);
  camera = orbited(camera, {}, base::Angle::from_degrees(-30.0));
  EXPECT_NEAR(towards_viewer(camera).z, std::cos(0.5235987755982988), 1e-9);
}

}  // namespace
}  // namespace dobra::scene::space
