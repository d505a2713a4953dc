#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "shared/scene/space/pick.h"

namespace dobra::scene::space {
namespace {

using geom::Point3;

/// z = sin(x) cos(y) over [0, 6] x [0, 6], n x n cells.
Surface waves(std::size_t n) {
  std::vector<Point3> points;
  std::vector<geom::Point> chart;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::size_t j = 0; j <= n; ++j) {
    for (std::size_t i = 0; i <= n; ++i) {
      const double x = 6.0 * static_cast<double>(i) / static_cast<double>(n);
      const double y = 6.0 * static_cast<double>(j) / static_cast<double>(n);
      points.push_back({x, y, std::sin(x) * std::cos(y)});
      chart.push_back({10.0 * x, -y});
    }
  }
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = 0; i < n; ++i) {
      const auto at = static_cast<std::uint32_t>(j * (n + 1) + i);
      const auto up = static_cast<std::uint32_t>(at + n + 1);
      triangles.push_back({at, at + 1, up + 1});
      triangles.push_back({at, up + 1, up});
    }
  }
  Surface surface;
  surface.points = std::move(points);
  surface.triangles = std::move(triangles);
  surface.chart = std::move(chart);
  return surface;
}

Layer layer_of(const std::string& key, std::variant<Lines, Markers, Surface, Labels, Curtain> content) {
  Layer layer;
  layer.key = layer.title = key;
  layer.content = std::move(content);
  return layer;
}

Sheet sheet_of(const SpacePicture& picture, StandardView view) {
  const geom::Box3 shown = extent(picture);
  const Frame frame = frame_of(camera_of(view), shown, picture.vertical_exaggeration);
  const geom::Box plot{{0.0, 0.0}, {600.0, 400.0}};
  const geom::Box all = projected(frame, shown);
  return {frame, transform_of(fit(all, 600.0, 400.0), plot), plot};
}

/// All triangles one by one, by areas of the drawn triangle: shares nothing with the tree.
std::optional<std::size_t> nearest_drawn(const Surface& surface, const Sheet& sheet, geom::Point page) {
  std::optional<std::size_t> best;
  double best_depth = 1e300;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    std::array<Projected, 3> c;
    for (std::size_t k = 0; k < 3; ++k) c[k] = *project(sheet, surface.points[surface.triangles[i][k]]);
    const double all = geom::cross(c[1].at - c[0].at, c[2].at - c[0].at);
    const double w0 = geom::cross(c[1].at - page, c[2].at - page) / all;
    const double w1 = geom::cross(c[2].at - page, c[0].at - page) / all;
    const double w2 = 1.0 - w0 - w1;
    if (!(w0 >= 0.0 && w1 >= 0.0 && w2 >= 0.0)) continue;
    const double depth = w0 * c[0].depth + w1 * c[1].depth + w2 * c[2].depth;
    if (depth >= best_depth) continue;
    best_depth = depth;
    best = i;
  }
  return best;
}

TEST(SpacePick, FindsTheTriangleThatIsSeen) {
  SpacePicture picture;
  picture.layers = {layer_of("waves", waves(24))};
  picture.vertical_exaggeration = 2.0;
  const auto& surface = std::get<Surface>(picture.layers[0].content);
  const Picker picker(picture);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> x(0.0, 600.0);
  std::uniform_real_distribution<double> y(0.0, 400.0);
  std::size_t found = 0;
  for (const StandardView view : {StandardView::Front, StandardView::Top, StandardView::Isometric,
                                  StandardView::Cabinet, StandardView::Perspective}) {
    const Sheet sheet = sheet_of(picture, view);
    for (int i = 0; i < 60; ++i) {
      const geom::Point page{x(random), y(random)};
      const auto pick = picker.pick(sheet, page, 5.0);
      const auto expected = nearest_drawn(surface, sheet, page);
      ASSERT_EQ(pick.has_value(), expected.has_value());
      if (!pick) continue;
      ++found;
      EXPECT_EQ(pick->item, *expected);
      EXPECT_EQ(pick->pick.layer, "waves");
      const auto seen = project(sheet, pick->place);
      ASSERT_TRUE(seen);
      EXPECT_NEAR(geom::distance(seen->at, page), 0.0, 1e-6);
      // The chart is linear in x and y here.
      ASSERT_TRUE(pick->chart);
      EXPECT_NEAR(pick->chart->x, 10.0 * pick->place.x, 1e-9);
      EXPECT_NEAR(pick->chart->y, -pick->place.y, 1e-9);
    }
  }
  EXPECT_GT(found, 100U);
}

TEST(SpacePick, AMarkerIsFoundBeforeTheSurfaceThatItLiesOnButNotThroughIt) {
  SpacePicture picture;
  Surface face;
  face.points = {{0, 0, 0}, {4, 0, 0}, {4, 0, 4}, {0, 0, 4}};
  face.triangles = {{0, 1, 2}, {0, 2, 3}};
  face.ids = {5, 5};
  picture.layers = {layer_of("face", face), layer_of("points", Markers{{{1.0, 0.0, 1.0}, {3.0, 2.0, 3.0}}, {11, 12}})};
  const Sheet sheet = sheet_of(picture, StandardView::Front);
  const Picker picker(picture);
  const auto on = picker.pick(sheet, project(sheet, {1.0, 0.0, 1.0})->at, 6.0);
  ASSERT_TRUE(on);
  EXPECT_EQ(on->pick, (scene::Pick{"points", 11}));
  EXPECT_EQ(on->place, (Point3{1.0, 0.0, 1.0}));
  const auto behind = picker.pick(sheet, project(sheet, {3.0, 2.0, 3.0})->at, 6.0);
  ASSERT_TRUE(behind);
  EXPECT_EQ(behind->pick, (scene::Pick{"face", 5}));
}

/// A curtain round a corner, stretched fourfold by the view: its second leg goes north at x = 103.
TEST(SpacePick, OnACurtainItTellsTheItemOfTheSectionAndThePlaceInTrueHeights) {
  scene::Layer horizon;
  horizon.key = "horizon";
  horizon.content = scene::Lines{{{{{0.0, -10.0}, {9.0, -10.0}}, false}}, {42}};
  scene::Layer unit;
  unit.key = "unit";
  unit.style.fill = Color{10, 20, 30};
  unit.content = Regions{{{{{{{0.0, -9.0}, {9.0, -9.0}, {9.0, 0.0}, {0.0, 0.0}}, true}}}}, {7}};
  Curtain curtain{{{100.0, 200.0}, {103.0, 200.0}, {103.0, 206.0}}, 0.0, {}};
  curtain.section.layers = {horizon, unit};
  SpacePicture picture;
  picture.layers = {layer_of("section", curtain)};
  picture.vertical_exaggeration = 4.0;
  const Picker picker(picture);
  for (const StandardView view : {StandardView::Right, StandardView::Isometric, StandardView::Cavalier,
                                  StandardView::Cabinet, StandardView::Perspective}) {
    const Sheet sheet = sheet_of(picture, view);
    const Point3 in_unit{103.0, 203.0, -4.5};
    const auto area = picker.pick(sheet, project(sheet, in_unit)->at, 1.0);
    ASSERT_TRUE(area) << static_cast<int>(view);
    EXPECT_EQ(area->pick, (scene::Pick{"section/unit", 7}));
    EXPECT_NEAR(geom::distance(area->place, in_unit), 0.0, 1e-9);
    const Point3 on_horizon{103.0, 204.0, -10.0};
    const auto line = picker.pick(sheet, project(sheet, on_horizon)->at, 1.0);
    ASSERT_TRUE(line) << static_cast<int>(view);
    EXPECT_EQ(line->pick, (scene::Pick{"section/horizon", 42}));
    EXPECT_NEAR(geom::distance(line->place, on_horizon), 0.0, 1e-9);
  }
}

TEST(SpacePick, AHiddenLayerIsNotFound) {
  SpacePicture picture;
  picture.layers = {layer_of("waves", waves(4))};
  const Sheet sheet = sheet_of(picture, StandardView::Top);
  Picker picker(picture);
  EXPECT_TRUE(picker.pick(sheet, {300.0, 200.0}, 5.0));
  picker.set_visible("waves", false);
  EXPECT_FALSE(picker.pick(sheet, {300.0, 200.0}, 5.0));
}

TEST(SpacePick, ThePlaceOnALineOfAPerspectiveIsWhereItIsSeen) {
  SpacePicture picture;
  picture.layers = {layer_of("line", Lines{{{{0.0, 0.0, 0.0}, {0.5, 30.0, 0.3}}}, {3}})};
  const Sheet sheet = sheet_of(picture, StandardView::Perspective);
  const Picker picker(picture);
  const Point3 point{0.1, 6.0, 0.06};
  const auto pick = picker.pick(sheet, project(sheet, point)->at, 4.0);
  ASSERT_TRUE(pick);
  EXPECT_EQ(pick->pick, (scene::Pick{"line", 3}));
  EXPECT_NEAR(geom::distance(pick->place, point), 0.0, 1e-9);
}

TEST(SpacePick, NothingIsFoundBesideThePicture) {
  SpacePicture picture;
  picture.layers = {layer_of("waves", waves(4))};
  const Sheet sheet = sheet_of(picture, StandardView::Isometric);
  EXPECT_FALSE(Picker(picture).pick(sheet, {1.0, 1.0}, 4.0));
  EXPECT_FALSE(Picker(SpacePicture{}).pick(sheet, {300.0, 200.0}, 4.0));
}

TEST(SpacePick, AThinnedSurfaceHasFewTrianglesAndLiesWhereTheOtherDoes) {
  const Surface fine = waves(60);
  const Surface coarse = thinned(fine, 900);
  EXPECT_LE(coarse.triangles.size(), 900U);
  EXPECT_GT(coarse.triangles.size(), 150U);
  for (const Point3& p : coarse.points) EXPECT_NEAR(p.z, std::sin(p.x) * std::cos(p.y), 0.1);
  geom::Box3 box;
  for (const auto& t : coarse.triangles) {
    for (const std::uint32_t point : t) box.add(coarse.points[point]);
  }
  EXPECT_LT(box.low.x, 0.3);
  EXPECT_GT(box.high.y, 5.7);
  EXPECT_EQ(thinned(fine, 100000), fine);
}

TEST(SpacePick, WhatIsMarkedIsTheItemThatWasPicked) {
  SpacePicture picture;
  picture.layers = {layer_of("waves", waves(4)), layer_of("line", Lines{{{{0, 0, 0}, {1, 1, 1}}}, {8}})};
  const auto triangle = highlight(picture, {"waves", 3});
  ASSERT_EQ(triangle.size(), 1U);
  EXPECT_EQ(std::get<Lines>(triangle[0].content).lines.size(), 3U);
  std::get<Surface>(picture.layers[0].content).ids = std::vector<std::uint32_t>(32, 6);  // one sub-domain
  EXPECT_EQ(std::get<Lines>(highlight(picture, {"waves", 6})[0].content).lines.size(), 16U);
  EXPECT_EQ(highlight(picture, {"line", 8}).size(), 1U);
  EXPECT_TRUE(highlight(picture, {"line", 9}).empty());
  EXPECT_TRUE(highlight(picture, {"no such layer", 0}).empty());
}

}  // namespace
}  // namespace dobra::scene::space
