#include "shared/scene/marks.h"

#include <gtest/gtest.h>

namespace dobra::scene {
namespace {

TEST(Marks, DashesGoOnRoundCornersAndStopAtTheWindow) {
  const geom::Polyline line{{{0.0, 0.0}, {4.0, 0.0}, {4.0, 6.0}}, false};
  const auto strokes = strokes_of(line, {3.0, 2.0}, {{-1.0, -1.0}, {10.0, 10.0}});
  double drawn = 0.0;
  for (const auto& stroke : strokes) drawn += stroke.length();
  EXPECT_NEAR(drawn, 6.0, 1e-12);  // of the ten: 0-3 and 5-8
  const auto seen = strokes_of(line, {3.0, 2.0}, {{-1.0, -1.0}, {2.0, 10.0}});
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_EQ(seen[0], (geom::Segment{{0.0, 0.0}, {2.0, 0.0}}));
}

TEST(Marks, ADeepZoomMakesOnlyTheStrokesInSight) {
  const geom::Polyline line{{{-1e9, 0.0}, {1e9, 0.0}}, false};
  EXPECT_LT(strokes_of(line, {3.0, 2.0}, {{0.0, -1.0}, {100.0, 1.0}}).size(), 25U);
}

TEST(Marks, ReadableKeepsTextAndReplacesWhatIsNone) {
  EXPECT_EQ(readable("\u03c3 = 5 \u2212 x"), "\u03c3 = 5 \u2212 x");
  EXPECT_EQ(readable("se\xe7\xe3o"), "se\uFFFD\uFFFDo");
  EXPECT_EQ(readable(std::string("a\0b\x07", 4)),
            "a\uFFFD"
            "b\uFFFD");
  EXPECT_EQ(readable("\xf0\x9f"), "\uFFFD\uFFFD");
}

TEST(Marks, WrappedTextIsNotWiderThanAsked) {
  const TextMeasure measure = approximate_text_measure();
  Font font;
  const auto lines = wrapped("one two three four five six seven", 60.0, font, measure);
  EXPECT_GT(lines.size(), 1U);
  EXPECT_EQ(font.size, 9.0);
  std::string all;
  for (const std::string& line : lines) {
    EXPECT_LE(measure(line, font).width, 60.0);
    all += (all.empty() ? "" : " ") + line;
  }
  EXPECT_EQ(all, "one two three four five six seven");
}

TEST(Marks, AWordWiderThanItsLineIsMadeSmaller) {
  const TextMeasure measure = approximate_text_measure();
  Font font;
  const auto lines = wrapped("incomprehensibilities", 60.0, font, measure);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_LT(font.size, 9.0);
  EXPECT_LE(measure(lines[0], font).width, 60.0);
}

}  // namespace
}  // namespace dobra::scene
