#include "shared/scene/space/display.h"

#include <gtest/gtest.h>

#include <cmath>

#include "shared/scene/color_map.h"
#include "shared/scene/space/layout.h"
#include "shared/scene/space/shade.h"

namespace dobra::scene::space {
namespace {

using geom::Point;
using geom::Point3;

/// A square that faces the viewer of the front view, at a depth.
Layer square(const std::string& key, double depth, const Color& color) {
  Surface surface;
  surface.points = {{-1.0, depth, -1.0}, {1.0, depth, -1.0}, {1.0, depth, 1.0}, {-1.0, depth, 1.0}};
  surface.triangles = {{0, 1, 2}, {0, 2, 3}};
  Layer layer;
  layer.key = layer.title = key;
  layer.style.fill = color;
  layer.style.line_width = 0.0;
  layer.content = surface;
  return layer;
}

Sheet front_sheet() {
  const geom::Box plot{{0.0, 0.0}, {100.0, 100.0}};
  return {frame_of({}, {{-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}}, 1.0), transform_of({{0.0, 0.0}, 0.04}, plot), plot};
}

SpacePicture with(std::vector<Layer> layers) {
  SpacePicture picture;
  picture.layers = std::move(layers);
  picture.light.ambient = 1.0;
  return picture;
}

TEST(Display, TheNearestIsDrawnLastWhateverTheOrderOfTheLayers) {
  const Layer near = square("near", -0.5, {255, 0, 0});
  const Layer far = square("far", 0.5, {0, 0, 255});
  for (const SpacePicture& picture : {with({near, far}), with({far, near})}) {
    const auto marks = marks_of(picture, front_sheet());
    ASSERT_EQ(marks.size(), 4U);
    EXPECT_EQ(std::get<TriangleMark>(marks.front()).fill, (Color{0, 0, 255}));
    EXPECT_EQ(std::get<TriangleMark>(marks.back()).fill, (Color{255, 0, 0}));
  }
}

TEST(Display, ALineBehindASurfaceIsDrawnBeforeItAndOneOnItAfterIt) {
  Layer line;
  line.key = "line";
  line.content = Lines{{{{-1.0, 0.9, 0.0}, {1.0, 0.9, 0.0}}}, {}};
  const Layer face = square("face", 0.0, {0, 255, 0});
  const auto behind = marks_of(with({face, line}), front_sheet());
  EXPECT_TRUE(std::holds_alternative<LineMark>(behind.front()));
  EXPECT_TRUE(std::holds_alternative<TriangleMark>(behind.back()));
  line.content = Lines{{{{-1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}}}, {}};
  const auto on = marks_of(with({line, face}), front_sheet());
  EXPECT_TRUE(std::holds_alternative<TriangleMark>(on.front()));
  EXPECT_TRUE(std::holds_alternative<LineMark>(on.back()));
}

TEST(Display, AHiddenLayerIsNotDrawn) {
  Layer face = square("face", 0.0, {0, 255, 0});
  face.visible = false;
  EXPECT_TRUE(marks_of(with({face}), front_sheet()).empty());
}

TEST(Display, EachEdgeIsDrawnOnce) {
  Layer face = square("face", 0.0, {0, 255, 0});
  face.style.line_width = 1.0;
  std::size_t lines = 0;
  for (const Mark& mark : marks_of(with({face}), front_sheet())) lines += std::holds_alternative<LineMark>(mark);
  EXPECT_EQ(lines, 5U);
}

TEST(Display, TrianglesKeepTheirAreaWhereBandsOfColourCutThem) {
  Layer face = square("face", 0.0, {});
  auto& surface = std::get<Surface>(face.content);
  surface.values_at = ValuesAt::Points;
  surface.values = {0.0, 1.0, 1.0, 0.0};
  surface.scale.low = 0.0;
  surface.scale.high = 1.0;
  double area = 0.0;
  Color leftmost;
  double left = 1e9;
  for (const Mark& mark : marks_of(with({face}), front_sheet())) {
    const auto& t = std::get<TriangleMark>(mark);
    area += 0.5 * std::abs(geom::cross(t.corners[1] - t.corners[0], t.corners[2] - t.corners[0]));
    const double middle = (t.corners[0].x + t.corners[1].x + t.corners[2].x) / 3.0;
    if (middle < left) {
      left = middle;
      leftmost = t.fill;
    }
  }
  EXPECT_NEAR(area, 50.0 * 50.0, 1e-6);
  EXPECT_EQ(leftmost, color_at(ColorMapName::Viridis, 0.5 / 64.0));
}

TEST(Display, WhatLeavesThePlotIsCutAway) {
  Layer face = square("face", 0.0, {0, 255, 0});
  Sheet sheet = front_sheet();
  sheet.page = transform_of({{1.0, 1.0}, 0.04}, sheet.plot);  // a corner of the square in the middle
  double area = 0.0;
  for (const Mark& mark : marks_of(with({face}), sheet)) {
    const auto& t = std::get<TriangleMark>(mark);
    area += 0.5 * std::abs(geom::cross(t.corners[1] - t.corners[0], t.corners[2] - t.corners[0]));
    for (const Point& corner : t.corners) EXPECT_TRUE(sheet.plot.grown(1e-9).contains(corner));
  }
  EXPECT_NEAR(area, 50.0 * 50.0, 1e-6);
}

TEST(Display, AFaceThatTurnsAwayFromTheLightIsDarker) {
  const Frame frame = frame_of({}, {{-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}}, 1.0);
  Light light;
  light.from = {0.0, 0.0, 1.0};
  light.ambient = 0.4;
  const std::array<Point3, 3> facing{Point3{0, 0, 0}, Point3{1, 0, 0}, Point3{0, 0, 1}};
  const std::array<Point3, 3> slanted{Point3{0, 0, 0}, Point3{0, 0, 1}, Point3{1, std::sqrt(3.0), 0}};
  EXPECT_EQ(shaded({200, 100, 50}, normal_to_viewer(frame, facing), light), (Color{200, 100, 50}));
  // cos 60 degrees is 1/2: 0.4 + 0.6 / 2.
  EXPECT_EQ(shaded({200, 100, 50}, normal_to_viewer(frame, slanted), light), (Color{140, 70, 35}));
}

TEST(Display, ArrowsOnASurfaceDoNotMakeWhatIsShownLarger) {
  SpacePicture picture = with({square("body", 0.0, {200, 0, 0})});
  Layer arrows;
  arrows.key = "arrows";
  arrows.content = Lines{{{{0.0, 0.0, 0.0}, {0.0, -7.0, 0.0}}}};
  arrows.in_extent = InExtent::No;
  picture.layers.push_back(arrows);
  const geom::Box3 body{{-1.0, 0.0, -1.0}, {1.0, 0.0, 1.0}};
  const geom::Box3 both{{-1.0, -7.0, -1.0}, {1.0, 0.0, 1.0}};
  EXPECT_EQ(extent(picture), body);
  EXPECT_EQ(reach(picture), both);
  picture.layers.back().visible = false;
  EXPECT_EQ(extent(picture), body);
  EXPECT_EQ(reach(picture), body);
  picture.layers.back().visible = true;
  picture.layers.front().visible = false;  // arrows alone stand where the body does
  EXPECT_EQ(extent(picture), body);
  picture.layers.erase(picture.layers.begin());
  EXPECT_EQ(extent(picture), (geom::Box3{{0.0, -7.0, 0.0}, {0.0, 0.0, 0.0}}));
  picture.layers.front().in_extent = InExtent::Yes;  // they count unless somebody says otherwise
  EXPECT_EQ(extent(picture), (geom::Box3{{0.0, -7.0, 0.0}, {0.0, 0.0, 0.0}}));
}

TEST(Display, ExaggerationStretchesHeightsOfTheViewAlone) {
  SpacePicture picture = with({square("face", 0.0, {0, 255, 0})});
  picture.vertical_exaggeration = 3.0;
  const geom::Box3 shown = extent(picture);
  EXPECT_EQ(shown.high.z, 1.0);
  const Frame frame = frame_of({}, shown, 3.0);
  const geom::Box seen = projected(frame, shown);
  EXPECT_NEAR(seen.height() / seen.width(), 3.0, 1e-12);
}

TEST(Display, ACurtainHangsItsSectionOnItsTrace) {
  scene::Layer horizon;
  horizon.key = "horizon";
  horizon.content = scene::Lines{{{{{0.0, -10.0}, {9.0, -20.0}}, false}}, {42}};
  scene::Layer unit;
  unit.key = "unit";
  unit.style.fill = Color{10, 20, 30};
  unit.style.line_width = 0.0;
  unit.content = Regions{{{{{{{0.0, -5.0}, {9.0, -5.0}, {9.0, 0.0}, {0.0, 0.0}}, true}}}}, {7}};
  Curtain curtain{{{100.0, 200.0}, {103.0, 200.0}, {103.0, 206.0}}, 0.0, {}};
  curtain.section.layers = {horizon, unit};
  Layer layer;
  layer.key = "section";
  layer.content = curtain;
  const std::vector<Layer> layers = unrolled(layer);
  ASSERT_EQ(layers.size(), 2U);
  EXPECT_EQ(layers[0].key, "section/horizon");
  const auto& line = std::get<Lines>(layers[0].content);
  EXPECT_EQ(line.ids, std::vector<std::uint32_t>{42});
  ASSERT_EQ(line.lines[0].size(), 3U);  // it bends with the trace
  EXPECT_NEAR(geom::distance(line.lines[0][1], {103.0, 200.0, -10.0 - 10.0 / 3.0}), 0.0, 1e-12);
  EXPECT_NEAR(geom::distance(line.lines[0][2], {103.0, 206.0, -20.0}), 0.0, 1e-12);
  const auto& faces = std::get<Surface>(layers[1].content);
  double area = 0.0;
  for (std::size_t i = 0; i < faces.triangles.size(); ++i) {
    const auto& t = faces.triangles[i];
    area += 0.5 *
            geom::length(geom::cross(faces.points[t[1]] - faces.points[t[0]], faces.points[t[2]] - faces.points[t[0]]));
    EXPECT_EQ(faces.ids[i], 7U);
    // On one of the two planes.
    const auto on = [&](auto plane) {
      return plane(faces.points[t[0]]) && plane(faces.points[t[1]]) && plane(faces.points[t[2]]);
    };
    EXPECT_TRUE(on([](Point3 p) { return std::abs(p.y - 200.0) < 1e-9; }) ||
                on([](Point3 p) { return std::abs(p.x - 103.0) < 1e-9; }));
  }
  EXPECT_NEAR(area, 45.0, 1e-9);
}

TEST(Display, AnAreaWithAnOutlineIsOneLayerToTheUser) {
  scene::Layer unit;
  unit.key = "unit";
  unit.title = "Unit";
  unit.style.fill = Color{10, 20, 30};
  unit.content = Regions{{{{{{{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}}, true}}}}, {7}};
  Curtain curtain{{{0.0, 0.0}, {5.0, 0.0}}, 0.0, {}};
  curtain.section.layers = {unit};
  SpacePicture picture;
  picture.layers.push_back({.key = "section", .content = curtain});
  EXPECT_EQ(unrolled(picture).size(), 2U);
  const Picture plane = described(picture);
  ASSERT_EQ(plane.panels.front().layers.size(), 1U);
  EXPECT_EQ(plane.panels.front().layers.front().key, "section/unit");
}

TEST(Display, ACurtainWithoutATraceShowsNothing) {
  Layer layer;
  layer.key = "section";
  layer.content = Curtain{{{1.0, 1.0}, {1.0, 1.0}}, 0.0, {}};
  EXPECT_TRUE(unrolled(layer).empty());
}

TEST(Display, TextsOfALayoutAreOnThePageAndApart) {
  SpacePicture picture = with({square("face", 0.0, {0, 255, 0})});
  picture.title = "A square in space";
  picture.layers[0].style.fill = Color{0, 200, 0};
  for (const StandardView view : {StandardView::Front, StandardView::Top, StandardView::Isometric,
                                  StandardView::Cavalier, StandardView::Perspective}) {
    const Look look{camera_of(view), std::nullopt};
    const geom::Box3 shown{{0.0, 0.0, 0.0}, {12000.0, 7000.0, 3000.0}};
    const TextMeasure measure = approximate_text_measure();
    const PageSize page = suggested_page(picture, shown, look, measure);
    const SpaceLayout made = layout(picture, shown, look, page, measure);
    std::vector<geom::Box> texts;
    for (const Mark& mark : made.page.marks) {
      if (std::holds_alternative<TextMark>(mark)) texts.push_back(box_of(mark));
    }
    EXPECT_GE(texts.size(), 7U);
    for (std::size_t i = 0; i < texts.size(); ++i) {
      EXPECT_GE(texts[i].low.x, 0.0);
      EXPECT_LE(texts[i].high.x, made.page.page.width);
      EXPECT_LE(texts[i].high.y, made.page.page.height);
      for (std::size_t k = 0; k < i; ++k) EXPECT_FALSE(texts[i].overlaps(texts[k]));
    }
  }
}

}  // namespace
}  // namespace dobra::scene::space
