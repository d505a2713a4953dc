#include "shared/render/vtk_scene.h"

#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkWeakPointer.h>

#include <map>
#include <utility>

#include "tests/support/example_picture.h"

namespace dobra::render {
namespace {

/// The scene's bookkeeping needs a window but no OpenGL: nothing is rendered here.
class VtkSceneInWindow : public testing::Test {
 protected:
  VtkSceneInWindow() : scene_(*window_) {
    window_->SetReadyForRendering(false);
    scene_.resize(1800, 1200, 2.0);
    scene_.set_picture(test::example_section());
  }
  vtkNew<vtkGenericOpenGLRenderWindow> window_;
  VtkScene scene_;
};

std::size_t texts(const VtkScene& scene, const std::string& text) {
  std::size_t found = 0;
  for (const scene::Mark& mark : scene.layout().marks) {
    const auto* one = std::get_if<scene::TextMark>(&mark);
    found += one != nullptr && one->text == text ? 1 : 0;
  }
  return found;
}

TEST_F(VtkSceneInWindow, ThePageIsTheWindowInDeviceIndependentPixels) {
  EXPECT_DOUBLE_EQ(scene_.layout().page.width, 900.0);
  EXPECT_DOUBLE_EQ(scene_.layout().page.height, 600.0);
}

TEST_F(VtkSceneInWindow, PanelsFitAtOneScaleUntilAViewIsSet) {
  const std::vector<scene::View> fitted = scene_.views();
  ASSERT_EQ(fitted.size(), 2U);
  EXPECT_EQ(fitted[0].world_per_point, fitted[1].world_per_point);
  const scene::View wanted = scene::zoom_at(fitted[0], {250.0, 100.0}, 3.0);
  scene_.set_views({wanted, std::nullopt});
  EXPECT_EQ(scene_.views()[0], wanted);
  scene_.set_views({std::nullopt, std::nullopt});
  EXPECT_EQ(scene_.views(), fitted);
}

TEST_F(VtkSceneInWindow, ANewPictureKeepsTheViewsIfAsked) {
  const scene::View wanted{{100.0, -20.0}, 0.25};
  scene_.set_views({wanted, std::nullopt});
  scene_.set_picture(test::example_section(), KeepViews::Yes);
  EXPECT_EQ(scene_.views()[0], wanted);
  scene_.set_picture(test::example_section());
  EXPECT_NE(scene_.views()[0], wanted);
}

void show_horizons(VtkScene& scene, bool visible) {
  for (const scene::Panel& panel : scene::Picture(scene.picture()).panels)
    scene.set_layer_visible(panel.key, "horizons", visible);
}

TEST_F(VtkSceneInWindow, HidingALayerInAllPanelsTakesItFromTheLegend) {
  EXPECT_EQ(texts(scene_, "horizons"), 1U);
  show_horizons(scene_, false);
  EXPECT_EQ(texts(scene_, "horizons"), 0U);
  EXPECT_FALSE(scene_.picture().panels[1].layers[4].visible);
  show_horizons(scene_, true);
  EXPECT_EQ(texts(scene_, "horizons"), 1U);
}

/// What draws each layer of the first panel.
std::map<std::string, std::vector<const vtkActor*>> drawn(const VtkScene& scene) {
  std::map<std::string, std::vector<const vtkActor*>> actors;
  for (const scene::Layer& layer : scene.picture().panels[0].layers) actors[layer.key] = scene.actors_of(0, layer.key);
  return actors;
}

TEST_F(VtkSceneInWindow, VisibilityAndOverlayRebuildNoLayer) {
  const auto before = drawn(scene_);
  scene_.set_layer_visible(scene_.picture().panels[0].key, "horizons", false);
  scene::Layer mark;
  mark.key = "mark";
  mark.content = scene::Markers{{{100.0, 50.0}}, {}};
  scene_.set_overlay(0, {mark, mark});
  scene_.set_overlay(0, {});
  EXPECT_EQ(drawn(scene_), before);
}

TEST_F(VtkSceneInWindow, ANewPictureRebuildsTheLayersThatChanged) {
  const auto before = drawn(scene_);
  scene::Picture next = test::example_section();
  scene::Layer& changed = next.panels[0].layers[4];
  ASSERT_EQ(changed.key, "horizons");
  std::get<scene::Lines>(changed.content).lines.edit()[0].points[0].y += 1.0;
  scene_.set_picture(next, KeepViews::Yes);
  for (const auto& [key, actors] : drawn(scene_)) {
    ASSERT_FALSE(actors.empty() && key == "horizons");
    EXPECT_EQ(actors == before.at(key), key != "horizons" || actors.empty()) << key;
  }
}

TEST_F(VtkSceneInWindow, ALayerOfAnotherColourIsRebuilt) {
  const auto before = drawn(scene_);
  scene::Picture next = test::example_section();
  next.panels[0].layers[4].style.line = {1, 2, 3};
  scene_.set_picture(next);
  EXPECT_NE(drawn(scene_).at("horizons"), before.at("horizons"));
}

/// One line of many points, and one of few; `height` of the first.
scene::Picture long_line(double height) {
  scene::Picture picture;
  scene::Panel& panel = picture.panels.emplace_back();
  panel.key = "section";
  geom::Polyline line;
  for (int i = 0; i < 100000; ++i) line.points.push_back({0.01 * i, height + (i % 2)});
  for (const auto& [key, content] :
       {std::pair{"long", line}, {"short", geom::Polyline{{{0, 0}, {1000, 100}}, false}}}) {
    scene::Layer layer;
    layer.key = key;
    layer.content = scene::Lines{{content}, {}};
    panel.layers.push_back(std::move(layer));
  }
  return picture;
}

class VtkSceneAtItsBench : public VtkSceneInWindow {
 protected:
  VtkSceneAtItsBench() {
    scene_.make_later([this](VtkScene::Work work) { bench_.push_back(std::move(work)); });
  }
  bool seen(const char* layer) {
    const std::vector<const vtkActor*> actors = scene_.actors_of(0, layer);
    EXPECT_EQ(actors.size(), 1U);
    return const_cast<vtkActor*>(actors.front())->GetVisibility() != 0;
  }
  std::int64_t points(const char* layer) {
    auto* mapper = const_cast<vtkActor*>(scene_.actors_of(0, layer).front())->GetMapper();
    return static_cast<vtkPolyDataMapper*>(mapper)->GetInput()->GetNumberOfPoints();
  }
  /// As a thread of its own would do it.
  void work() {
    for (VtkScene::Work& one : std::exchange(bench_, {})) one()();
    scene_.arrive();
  }
  std::vector<VtkScene::Work> bench_;
};

TEST_F(VtkSceneAtItsBench, ManyPointsAreDrawnLaterAndFewAtOnce) {
  scene_.set_picture(long_line(50.0));
  EXPECT_TRUE(scene_.is_waiting());
  EXPECT_EQ(bench_.size(), 1U);
  EXPECT_EQ(points("long"), 0);
  EXPECT_EQ(points("short"), 2);
  work();
  EXPECT_FALSE(scene_.is_waiting());
  EXPECT_TRUE(seen("long"));
  EXPECT_GT(points("long"), 1000);
}

TEST_F(VtkSceneAtItsBench, WhatWasThereIsShownUntilTheNewIsMade) {
  scene_.set_picture(long_line(50.0));
  work();
  const vtkWeakPointer<vtkActor> first(const_cast<vtkActor*>(scene_.actors_of(0, "long").front()));
  scene_.set_picture(long_line(60.0), KeepViews::Yes);
  EXPECT_FALSE(seen("long"));
  ASSERT_NE(first.GetPointer(), nullptr);
  EXPECT_NE(first->GetVisibility(), 0);  // still drawn
  // A third one before the second is made: the first is still what is shown, and the second is never made.
  scene_.set_picture(long_line(70.0), KeepViews::Yes);
  ASSERT_NE(first.GetPointer(), nullptr);
  EXPECT_NE(first->GetVisibility(), 0);
  scene_.set_layer_visible("section", "long", false);
  EXPECT_EQ(first.GetPointer(), nullptr);  // what is hidden is not kept for what it was
  scene_.set_layer_visible("section", "long", true);
  work();
  EXPECT_TRUE(seen("long"));
  EXPECT_FALSE(scene_.is_waiting());
}

TEST_F(VtkSceneAtItsBench, OnlyTheLastOfManyViewsIsWorkedFor) {
  scene_.set_picture(long_line(50.0));
  work();
  const std::int64_t whole = points("long");
  for (const double nearer : {2.0, 8.0, 64.0, 4096.0}) scene_.set_views({scene::View{{500.0, 50.0}, 1.0 / nearer}});
  EXPECT_GT(points("long"), 0);  // as it was, coarse, until then
  int made = 0;
  for (VtkScene::Work& one : std::exchange(bench_, {})) {
    const auto show = one();
    show();
    made += points("long") != whole ? 1 : 0;
  }
  EXPECT_EQ(made, 1);
  scene_.arrive();
  EXPECT_FALSE(scene_.is_waiting());
  // From so near few of the points can be seen, and all of those are there: 900 page units, 4096 to a metre, and as
  // much again on both sides.
  EXPECT_NEAR(static_cast<double>(points("long")), 100.0 * 3.0 * 900.0 / 4096.0, 25.0);
}

TEST_F(VtkSceneInWindow, ThePanelUnderAPagePointIsFound) {
  for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(scene_.panel_at(scene_.layout().panels[i].plot.centre()), i);
  EXPECT_EQ(scene_.panel_at({1.0, 1.0}), std::nullopt);
}

TEST_F(VtkSceneInWindow, ReleasingTwiceDoesNoHarm) {
  scene_.release();
  scene_.release();
}

}  // namespace
}  // namespace dobra::render
