// A picture in space cut by a plane.
#include <gtest/gtest.h>

#include "shared/scene/space/cut.h"
#include "shared/scene/space/pick.h"
#include "tests/support/space_picture.h"

namespace dobra::test {
namespace {

using geom::Point3;
using namespace scene::space;

const Layer* layer(const SpacePicture& picture, const std::string& key) {
  for (const Layer& each : picture.layers) {
    if (each.key == key) return &each;
  }
  return nullptr;
}

double area(const Surface& surface) {
  double sum = 0.0;
  for (const auto& t : surface.triangles)
    sum +=
        0.5 * length(cross(surface.points[t[1]] - surface.points[t[0]], surface.points[t[2]] - surface.points[t[0]]));
  return sum;
}

SpacePicture square_with_line() {
  SpacePicture picture;
  picture.layers.push_back(colored_square({10, 20, 30}));
  Layer lines;
  lines.key = "lines";
  Lines content;
  content.lines = {{{-3.0, 0.0, 0.0}, {3.0, 0.0, 0.0}, {3.0, 0.0, 1.0}, {-3.0, 0.0, 1.0}},
                   {{2.0, 0.0, 0.0}, {4.0, 0.0, 0.0}}};
  content.ids = {7, 9};
  lines.content = content;
  picture.layers.push_back(lines);
  Layer markers;
  markers.key = "markers";
  markers.content = Markers{{{-1.0, 0.0, 0.0}, {0.25, 0.0, 0.0}, {2.0, 0.0, 0.0}}, {}};
  picture.layers.push_back(markers);
  return picture;
}

TEST(CutPicture, AreaOfASquareIsThePartBelowThePlane) {
  const SpacePicture picture = square_with_line();
  for (const double at : {-0.9, -0.25, 0.0, 0.25, 0.7}) {
    const SpacePicture left = cut(picture, {{at, 0.0, 0.0}, {1.0, 0.0, 0.0}});
    EXPECT_NEAR(area(std::get<Surface>(layer(left, "square")->content)), 2.0 * (at + 1.0), 1e-12) << at;
    const SpacePicture other = cut(picture, {{at, 0.0, 0.0}, {-3.0, 0.0, 0.0}});
    EXPECT_NEAR(area(std::get<Surface>(layer(other, "square")->content)), 2.0 * (1.0 - at), 1e-12) << at;
    double length = 0.0;
    for (const auto& line : std::get<Lines>(layer(left, "square.cut")->content).lines) {
      length += distance(line.front(), line.back());
      EXPECT_NEAR(line.front().x, at, 1e-12);
    }
    EXPECT_NEAR(length, 2.0, 1e-12) << at;
  }
}

TEST(CutPicture, LinesEndAtThePlaneAndPointsBeforeItGo) {
  const SpacePicture left = cut(square_with_line(), {{0.5, 0.0, 0.0}, {1.0, 0.0, 0.0}});
  const auto& lines = std::get<Lines>(layer(left, "lines")->content);
  ASSERT_EQ(lines.lines.size(), 2U);  // out of the first line and back into it; the second has gone
  EXPECT_EQ(lines.lines[0], (std::vector<Point3>{{-3.0, 0.0, 0.0}, {0.5, 0.0, 0.0}}));
  EXPECT_EQ(lines.lines[1], (std::vector<Point3>{{0.5, 0.0, 1.0}, {-3.0, 0.0, 1.0}}));
  EXPECT_EQ(lines.ids, (std::vector<std::uint32_t>{7, 7}));
  const auto& markers = std::get<Markers>(layer(left, "markers")->content);
  EXPECT_EQ(markers.points, (std::vector<Point3>{{-1.0, 0.0, 0.0}, {0.25, 0.0, 0.0}}));
  EXPECT_EQ(markers.ids, (std::vector<std::uint32_t>{0, 1}));
}

TEST(CutPicture, ItemsKeepTheirIdentitiesValuesAndCharts) {
  SpacePicture picture;
  Layer hilly;
  hilly.key = "top";
  hilly.content = hills(6);
  picture.layers.push_back(hilly);
  const auto& whole = std::get<Surface>(picture.layers[0].content);
  const SpacePicture left = cut(picture, {{1234.0, 0.0, 0.0}, {1.0, 0.3, 0.2}});
  const auto& part = std::get<Surface>(layer(left, "top")->content);
  ASSERT_EQ(part.ids.size(), part.triangles.size());
  ASSERT_EQ(part.chart.size(), part.points.size());
  ASSERT_EQ(part.values.size(), part.points.size());
  EXPECT_LT(part.triangles.size(), whole.triangles.size() + 12);
  EXPECT_GT(area(part), 0.1 * area(whole));
  EXPECT_LT(area(part), 0.9 * area(whole));
  for (std::size_t t = 0; t < part.triangles.size(); ++t) {
    const auto& of = whole.triangles[part.ids[t]];
    const Point3 a = whole.points[of[0]], b = whole.points[of[1]], c = whole.points[of[2]];
    for (const std::uint32_t corner : part.triangles[t]) {
      const Point3 p = part.points[corner];
      // In the plane of its triangle, with the chart and value that belong there: both are linear in x and y.
      EXPECT_NEAR(dot(cross(b - a, c - a), p - a) / length(cross(b - a, c - a)), 0.0, 1e-9);
      EXPECT_NEAR(part.chart[corner].x, p.x / 4000.0, 1e-12);
      EXPECT_NEAR(part.chart[corner].y, p.y / 3000.0, 1e-12);
      EXPECT_NEAR(part.values[corner], p.z, 1e-9);
      EXPECT_LE((p.x - 1234.0) + 0.3 * p.y + 0.2 * p.z, 1e-9);
    }
  }
  EXPECT_EQ(extent(left), extent(picture));  // as much of space is looked at as before
}

TEST(CutPicture, WhatThePlaneDoesNotMeetIsAsItWas) {
  const SpacePicture picture = square_with_line();
  const SpacePicture left = cut(picture, {{9.0, 0.0, 0.0}, {1.0, 0.0, 0.0}});
  ASSERT_EQ(left.layers.size(), picture.layers.size());
  EXPECT_EQ(std::get<Surface>(left.layers[0].content), std::get<Surface>(picture.layers[0].content));
  EXPECT_EQ(std::get<Lines>(left.layers[1].content), std::get<Lines>(picture.layers[1].content));
  EXPECT_EQ(std::get<Markers>(left.layers[2].content), std::get<Markers>(picture.layers[2].content));
  EXPECT_EQ(layer(left, "square.cut"), nullptr);
  const SpacePicture none = cut(picture, {{-9.0, 0.0, 0.0}, {1.0, 0.0, 0.0}});
  EXPECT_TRUE(std::get<Surface>(layer(none, "square")->content).triangles.empty());
  EXPECT_TRUE(std::get<Lines>(layer(none, "lines")->content).lines.empty());
}

TEST(CutPicture, ASideInThePlaneIsCutOnceAndACornerThereNotAtAll) {
  SpacePicture picture;
  picture.layers.push_back(colored_square({1, 2, 3}));  // of two triangles that share the diagonal
  const SpacePicture diagonal = cut(picture, {{0.0, 0.0, 0.0}, {1.0, 0.0, -1.0}});
  EXPECT_NEAR(area(std::get<Surface>(layer(diagonal, "square")->content)), 2.0, 1e-12);
  EXPECT_TRUE(std::get<Lines>(layer(diagonal, "square.cut")->content).lines.empty());
  const SpacePicture corner = cut(picture, {{1.0, 0.0, 1.0}, {1.0, 0.0, 1.0}});
  EXPECT_NEAR(area(std::get<Surface>(layer(corner, "square")->content)), 4.0, 1e-12);
}

TEST(CutPicture, PlanesAcrossAnAxisGoFromEndToEnd) {
  const geom::Box3 box{{1.0, 2.0, 3.0}, {5.0, 10.0, 4.0}};
  EXPECT_DOUBLE_EQ(plane_across(CutAxis::X, 0.25, box, false).through.x, 2.0);
  EXPECT_DOUBLE_EQ(plane_across(CutAxis::Y, 0.25, box, false).through.y, 4.0);
  EXPECT_DOUBLE_EQ(plane_across(CutAxis::Z, 1.0, box, true).through.z, 4.0);
  EXPECT_DOUBLE_EQ(plane_across(CutAxis::Z, 1.0, box, true).normal.z, -1.0);
  for (const CutAxis axis : {CutAxis::X, CutAxis::Y, CutAxis::Z}) {
    const CutPlane plane = plane_across(axis, 0.4, box, false);
    const auto frame = frame_of(plane, box);
    ASSERT_EQ(frame.size(), 5U);
    EXPECT_EQ(frame.front(), frame.back());
    for (const Point3& p : frame) EXPECT_NEAR(dot(p - plane.through, plane.normal), 0.0, 1e-12);
  }
}

}  // namespace
}  // namespace dobra::test
