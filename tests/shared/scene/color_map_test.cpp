#include "shared/scene/color_map.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dobra::scene {
namespace {

double lightness(const Color& c) {
  const auto linear = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(c.red / 255.0) + 0.7152 * linear(c.green / 255.0) + 0.0722 * linear(c.blue / 255.0);
}

TEST(ColorMap, ViridisHasItsPublishedEndsAndMiddle) {
  EXPECT_EQ(color_at(ColorMapName::Viridis, 0.0), (Color{0x44, 0x01, 0x54}));
  EXPECT_EQ(color_at(ColorMapName::Viridis, 0.5), (Color{0x21, 0x91, 0x8c}));
  EXPECT_EQ(color_at(ColorMapName::Viridis, 1.0), (Color{0xfd, 0xe7, 0x25}));
}

TEST(ColorMap, CoolWarmHasItsPublishedEndsAndMiddle) {
  EXPECT_EQ(color_at(ColorMapName::CoolWarm, 0.0), (Color{59, 76, 192}));
  EXPECT_EQ(color_at(ColorMapName::CoolWarm, 0.5), (Color{221, 221, 221}));
  EXPECT_EQ(color_at(ColorMapName::CoolWarm, 1.0), (Color{180, 4, 38}));
}

TEST(ColorMap, FractionsOutsideTakeTheEnds) {
  for (const auto map : {ColorMapName::Viridis, ColorMapName::Cividis, ColorMapName::CoolWarm, ColorMapName::Quality}) {
    EXPECT_EQ(color_at(map, -3.0), color_at(map, 0.0));
    EXPECT_EQ(color_at(map, 7.0), color_at(map, 1.0));
  }
}

TEST(ColorMap, SequentialMapsGrowLighterAllTheWay) {
  for (const auto map : {ColorMapName::Viridis, ColorMapName::Cividis}) {
    for (int i = 0; i < 100; ++i) {
      EXPECT_LE(lightness(color_at(map, i / 100.0)), lightness(color_at(map, (i + 1) / 100.0)) + 1e-3) << i;
    }
    EXPECT_GT(lightness(color_at(map, 1.0)) - lightness(color_at(map, 0.0)), 0.5);
  }
}

TEST(ColorMap, QualityGoesFromRedOverYellowToBlueGreen) {
  const Color bad = color_at(ColorMapName::Quality, 0.0);
  const Color middle = color_at(ColorMapName::Quality, 0.5);
  const Color good = color_at(ColorMapName::Quality, 1.0);
  EXPECT_GT(bad.red, 2 * bad.green);
  EXPECT_GT(bad.red, 2 * bad.blue);
  EXPECT_GT(std::min(middle.red, middle.green), middle.blue);
  EXPECT_GT(std::min(good.green, good.blue), 2 * good.red);
}

TEST(ColorMap, NeighbouringFractionsHaveNeighbouringColours) {
  for (const auto map : {ColorMapName::Viridis, ColorMapName::Cividis, ColorMapName::CoolWarm, ColorMapName::Quality}) {
    for (int i = 0; i < 1000; ++i) {
      const Color a = color_at(map, i / 1000.0);
      const Color b = color_at(map, (i + 1) / 1000.0);
      EXPECT_LE(std::abs(a.red - b.red) + std::abs(a.green - b.green) + std::abs(a.blue - b.blue), 6);
    }
  }
}

TEST(ColorMap, AValueOutsideItsScaleTakesTheEndAndNanIsGrey) {
  const Scale scale{"", ColorMapName::Viridis, 2.0, 4.0};
  EXPECT_DOUBLE_EQ(fraction_of(scale, 3.0), 0.5);
  EXPECT_EQ(color_of(scale, 1.0), color_at(ColorMapName::Viridis, 0.0));
  EXPECT_EQ(color_of(scale, 5.0), color_at(ColorMapName::Viridis, 1.0));
  const Color none = color_of(scale, std::nan(""));
  EXPECT_EQ(none.red, none.green);
  EXPECT_EQ(none.red, none.blue);
  EXPECT_DOUBLE_EQ(fraction_of({"", ColorMapName::Viridis, 2.0, 2.0}, 2.0), 0.5);
}

}  // namespace
}  // namespace dobra::scene
