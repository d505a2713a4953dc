#include "shared/scene/ground.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dobra::scene {
namespace {

const Ground dark{{30, 33, 36}};

/// Of WCAG 2, written once more.
double contrast_of(const Color& a, const Color& b) {
  const auto luminance = [](const Color& c) {
    double sum = 0.0;
    const double weights[] = {0.2126, 0.7152, 0.0722};
    const int parts[] = {c.red, c.green, c.blue};
    for (int i = 0; i < 3; ++i) {
      const double v = parts[i] / 255.0;
      sum += weights[i] * (v > 0.04045 ? std::pow((v + 0.055) / 1.055, 2.4) : v / 12.92);
    }
    return sum + 0.05;
  };
  return std::max(luminance(a), luminance(b)) / std::min(luminance(a), luminance(b));
}

TEST(Ground, OnPaperNothingChanges) {
  for (int v = 0; v < 256; v += 15) {
    const Color color{static_cast<std::uint8_t>(v), 100, 20, 200};
    EXPECT_EQ(line_on(color, Ground{}), color);
    EXPECT_EQ(words_on(color, Ground{}), color);
  }
  EXPECT_FALSE(is_dark(Ground{}));
  EXPECT_TRUE(is_dark(dark));
}

TEST(Ground, EveryWordAndLineOfADarkGroundIsReadable) {
  // Words stand on the ground at an opacity of 230 of 255 over whatever lies below, white at worst.
  const Color over_white{52, 55, 58};
  for (int r = 0; r < 256; r += 17) {
    for (int g = 0; g < 256; g += 17) {
      for (int b = 0; b < 256; b += 17) {
        const Color color{static_cast<std::uint8_t>(r), static_cast<std::uint8_t>(g), static_cast<std::uint8_t>(b)};
        const Color words = words_on(color, dark);
        EXPECT_GE(contrast_of(words, dark.paper), 4.5) << r << ' ' << g << ' ' << b;
        EXPECT_GE(contrast_of(words, over_white), 4.5) << r << ' ' << g << ' ' << b;
        const bool faint = std::max({r, g, b}) - std::min({r, g, b}) < 24 && contrast_of(color, {255, 255, 255}) < 1.6;
        if (!faint) {
          EXPECT_GE(contrast_of(line_on(color, dark), dark.paper), 4.5) << r << ' ' << g << ' ' << b;
        }
      }
    }
  }
}

TEST(Ground, BlackBecomesLightBrightColoursStayAndHuesAreKept) {
  const Color from_black = line_on({0, 0, 0}, dark);
  EXPECT_GT(from_black.red, 200);
  const Color yellow{250, 220, 40};
  EXPECT_EQ(line_on(yellow, dark), yellow);
  const Color blue = line_on({20, 60, 130, 99}, dark);
  EXPECT_GT(blue.blue, blue.green);
  EXPECT_GT(blue.green, blue.red);
  EXPECT_EQ(blue.alpha, 99);
}

TEST(Ground, FaintLinesStayFaint) {
  const double kept = contrast_of(line_on({220, 220, 222}, dark), dark.paper);
  EXPECT_GT(kept, 1.1);
  EXPECT_LT(kept, 2.5);
}

TEST(Ground, AFillThatPaperHardlyShowsIsHardlyShownOnTheDarkAndSoIsItsSwatch) {
  const Layer domain{"domain", "domain", Style{{90, 90, 90}, 0.0, Dash::Solid, Color{236, 238, 240}}, Regions{}};
  const Color fill = *style_on(domain, dark).fill;
  EXPECT_GT(contrast_of(fill, dark.paper), 1.05);
  EXPECT_LT(contrast_of(fill, dark.paper), 1.6);
  EXPECT_EQ(*std::get<BoxMark>(on_ground(BoxMark{{}, Color{236, 238, 240}}, dark)).fill, fill);
  EXPECT_EQ(style_on(domain, Ground{}), domain.style);
}

TEST(Ground, FillsAndTheirOutlinesStayAndWhatIsBehindWordsTurnsDark) {
  Layer bed{"bed", "bed", Style{{90, 60, 10}, 1.0, Dash::Solid, Color{240, 220, 150}}, Regions{}};
  EXPECT_EQ(style_on(bed, dark), bed.style);
  Layer line{"top", "top", Style{{10, 10, 10}}, Lines{}};
  EXPECT_NE(style_on(line, dark), line.style);
  const Mark behind = on_ground(BoxMark{{}, Color{255, 255, 255, 190}}, dark);
  EXPECT_EQ(std::get<BoxMark>(behind).fill->red, 30);
  const Mark swatch = on_ground(BoxMark{{}, Color{240, 220, 150}}, dark);
  EXPECT_EQ(*std::get<BoxMark>(swatch).fill, *bed.style.fill);
  const Mark frame = on_ground(BoxMark{{}, std::nullopt, Color{60, 60, 60}, 1.0}, dark);
  EXPECT_GE(contrast_of(std::get<BoxMark>(frame).line, dark.paper), 4.5);
}

}  // namespace
}  // namespace dobra::scene
