#include "shared/render/vtk_scene.h"

#include <gtest/gtest.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>

#include <map>

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
  std::get<scene::Lines>(changed.content).lines[0].points[0].y += 1.0;
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
