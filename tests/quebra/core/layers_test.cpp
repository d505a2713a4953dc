#include "quebra/core/layers.h"

#include <gtest/gtest.h>

namespace quebra::core {
namespace {

namespace scene = dobra::scene;

TEST(Layers, BarsOfTheHistogramAreAsHighAsTheirShareOfTheElements) {
  model::Meshed meshed;
  meshed.name = "Mesh 1";
  meshed.quality.histogram[12] = 1;
  meshed.quality.histogram[19] = 3;
  meshed.quality.alpha_mean = 0.9;
  const scene::Picture picture = histogram_picture(meshed);
  ASSERT_EQ(picture.panels.size(), 1U);
  const scene::Panel& panel = picture.panels[0];
  ASSERT_EQ(panel.layers.size(), 4U) << "two bars, mean and least";
  for (const auto& [layer, left, share] : {std::tuple{0U, 0.6, 0.25}, std::tuple{1U, 0.95, 0.75}}) {
    const auto box = std::get<scene::Regions>(panel.layers[layer].content).regions[0].contours.at(0).box();
    EXPECT_NEAR(box.low.x, left, 1e-15);
    EXPECT_NEAR(box.width(), 0.05, 1e-15);
    EXPECT_EQ(box.high.y, share);
  }
  EXPECT_EQ(std::get<scene::Lines>(panel.layers[2].content).lines[0].points[0].x, 0.9);
  EXPECT_NEAR(panel.extent->high.y, 1.05 * 0.75, 1e-15);
}

}  // namespace
}  // namespace quebra::core
