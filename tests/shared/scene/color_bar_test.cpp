// What colour bars say of their ends, and labels that find their own place.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shared/scene/color_map.h"
#include "shared/scene/furniture.h"
#include "shared/scene/layout.h"

namespace dobra::scene {
namespace {

const TextMeasure label_measure = approximate_text_measure();

Furniture bar_of(const Scale& scale) {
  double title_height = 0.0;
  return color_bar(scale, 200.0, {}, label_measure, title_height);
}

std::vector<std::string> texts_of(const std::vector<Mark>& marks) {
  std::vector<std::string> texts;
  for (const Mark& mark : marks) {
    if (const auto* text = std::get_if<TextMark>(&mark)) texts.push_back(text->text);
  }
  return texts;
}

bool says(const std::vector<Mark>& marks, const std::string& text) {
  const auto texts = texts_of(marks);
  return std::find(texts.begin(), texts.end(), text) != texts.end();
}

std::size_t arrows(const Furniture& bar) {
  return static_cast<std::size_t>(std::count_if(
      bar.marks.begin(), bar.marks.end(), [](const Mark& mark) { return std::holds_alternative<TriangleMark>(mark); }));
}

TEST(ColorBar, AnEndThatValuesPassIsAnArrowAndSaysByHowMuch) {
  const Furniture cut = bar_of({.title = "s [Pa]", .low = 0.0, .high = 2.15, .least = 0.0, .greatest = 3.62});
  EXPECT_EQ(arrows(cut), 1U);
  EXPECT_TRUE(says(cut.marks, "> 2.15, max 3.62"));
  EXPECT_TRUE(says(cut.marks, "min 0"));
  const Furniture both = bar_of({.title = "s [Pa]", .low = -1e6, .high = 1e6, .least = -4.5e6, .greatest = 3e7});
  EXPECT_EQ(arrows(both), 2U);
  EXPECT_TRUE(says(both.marks, "> 1e6, max 3e7"));
  EXPECT_TRUE(says(both.marks, "< \u22121e6, min \u22124.5e6"));
}

TEST(ColorBar, ABarOfAllValuesHasNoArrowAndNamesItsEnds) {
  const Furniture whole = bar_of({.title = "s [Pa]", .low = -5.0, .high = 5.0, .least = -2.7, .greatest = 5.0});
  EXPECT_EQ(arrows(whole), 0U);
  EXPECT_TRUE(says(whole.marks, "max 5"));
  EXPECT_TRUE(says(whole.marks, "min \u22122.7"));
  const Furniture plain = bar_of({.title = "alpha", .low = 0.5, .high = 1.0});
  for (const std::string& text : texts_of(plain.marks)) EXPECT_EQ(text.find("max"), std::string::npos);
}

TEST(ColorBar, NumbersOfManyZerosAreShort) {
  for (const auto& [low, high] : {std::pair{0.0, 4.2e6}, std::pair{-1e-4, 1e-4}, std::pair{0.0, 3e11}}) {
    for (const std::string& text : texts_of(bar_of({.title = "", .low = low, .high = high}).marks))
      EXPECT_LE(text.size(), 9U) << text;
  }
}

TEST(ColorBar, NoTextsOverlapWhateverTheRange) {
  for (const double greatest : {1.0, 1.01, 1.5, 100.0, 0.99, 0.2}) {
    for (const double least : {0.0, -0.01, -3.0, 0.01, 0.19}) {
      const Furniture bar = bar_of(
          {.title = "stress of this and that [Pa]", .low = 0.0, .high = 1.0, .least = least, .greatest = greatest});
      std::vector<geom::Box> boxes;
      for (const Mark& mark : bar.marks) {
        if (!std::holds_alternative<TextMark>(mark)) continue;
        const geom::Box box = box_of(mark).grown(-0.01);
        for (const geom::Box& other : boxes) EXPECT_FALSE(other.overlaps(box)) << least << " to " << greatest;
        boxes.push_back(box);
      }
    }
  }
}

TEST(ColorBar, ALogarithmicScaleSaysTheNumbersThemselves) {
  const Furniture bar = bar_of(
      {.title = "size [m]", .low = -2.0, .high = 0.0, .ticks = AxisScale::Log10, .least = -2.0, .greatest = 0.0});
  EXPECT_TRUE(says(bar.marks, "max 1"));
  EXPECT_TRUE(says(bar.marks, "min 0.01"));
  EXPECT_TRUE(says(bar.marks, "0.1"));
}

geom::Polyline ring(geom::Point centre, double radius) {
  geom::Polyline line{{}, true};
  for (int i = 0; i < 90; ++i) {
    const double a = 2.0 * std::numbers::pi * i / 90;
    line.points.push_back({centre.x + radius * std::cos(a), centre.y + radius * std::sin(a)});
  }
  return line;
}

/// Whether a segment passes through the inside of a box, by looking at a thousand of its points.
bool passes(const geom::Segment& s, const geom::Box& box) {
  for (int i = 0; i <= 1000; ++i) {
    const geom::Point p = geom::interpolate(s.from, s.to, i / 1000.0);
    if (p.x > box.low.x && p.x < box.high.x && p.y > box.low.y && p.y < box.high.y) return true;
  }
  return false;
}

TEST(Callouts, HideNoHoleNoMarkerAndNoOtherLabel) {
  // Extremes at the edges of holes, at a corner, and two at nearly one place.
  const std::vector<std::array<geom::Point, 2>> places{
      {{{2.8, 2}, {8, 2.8}}}, {{{0, 0}, {10, 4}}}, {{{5, 2}, {5.01, 2}}}, {{{1.2, 2}, {2, 1.2}}}};
  for (const auto& [one, other] : places) {
    Panel panel{.key = "a"};
    const Lines edges{{{{{0, 0}, {10, 0}, {10, 4}, {0, 4}}, true},
                       ring({2, 2}, 0.8),
                       ring({8, 2}, 0.8),
                       {{{5, 1.4}, {5, 2.6}}, false}},
                      {}};
    panel.layers.push_back({"boundary", "Boundary", {}, edges});
    panel.layers.push_back({"extremes", "Extremes", {.marker_size = 6.0}, Markers{{one, other}, {}}});
    panel.layers.push_back({"values",
                            "",
                            {},
                            Labels{{{one, "max", Anchor::Callout, 39.44}, {other, "min", Anchor::Callout, -0.0142}}},
                            true,
                            InLegend::No});
    const Picture picture{"", {panel}};
    const Layout made = layout(picture, suggested_page(picture, 720.0, label_measure), {}, label_measure);
    std::vector<geom::Box> labels;
    for (const Mark& mark : made.marks) {
      const auto* text = std::get_if<TextMark>(&mark);
      if (text != nullptr && (text->text.starts_with("max ") || text->text.starts_with("min ")))
        labels.push_back(box_of(mark));
    }
    ASSERT_EQ(labels.size(), 2U);
    EXPECT_FALSE(labels[0].overlaps(labels[1]));
    const Transform& transform = made.panels[0].transform;
    for (const geom::Box& label : labels) {
      for (const geom::Polyline& line : edges.lines) {
        for (std::size_t i = 0; i < line.segment_count(); ++i)
          EXPECT_FALSE(passes({transform.to_page(line.segment(i).from), transform.to_page(line.segment(i).to)}, label));
      }
      for (const geom::Point p : {one, other}) EXPECT_FALSE(label.grown(2.9).contains(transform.to_page(p)));
      EXPECT_TRUE(made.panels[0].plot.contains(label.low) && made.panels[0].plot.contains(label.high));
    }
  }
}

Mesh field(std::vector<double> values) {
  Mesh mesh;
  mesh.values_at = ValuesAt::Triangles;
  mesh.values = std::move(values);
  mesh.scale = {.low = -1.0, .high = 1.0, .least = -1.0, .greatest = 1.0};
  return mesh;
}

TEST(ColorBar, AFieldThatIsConstantToRoundingHasOneColourAndOneNumber) {
  // Numbers near 100 whose last digits differ, and differences of such numbers.
  Mesh near = field({100.0, 100.0 + 1e-11, 100.0 - 3e-11});
  ASSERT_TRUE(settle_constant(near, 100.0));
  EXPECT_NEAR(near.scale.low, 100.0, 1e-9);
  Mesh noise = field({1e-9, -2e-9, 5e-10});
  ASSERT_TRUE(settle_constant(noise, 100.0));
  for (const Mesh& mesh : {near, noise}) {
    EXPECT_EQ(mesh.scale.low, mesh.scale.high);
    for (const double value : mesh.values) EXPECT_EQ(color_of(mesh.scale, value), color_at(mesh.scale.map, 0.5));
    const Furniture bar = bar_of(mesh.scale);
    EXPECT_EQ(texts_of(bar.marks), std::vector<std::string>{mesh.scale.low == 0.0 ? "0" : "100"});
    for (const Mark& mark : bar.marks) EXPECT_FALSE(std::holds_alternative<GradientMark>(mark));
  }
}

TEST(ColorBar, AFieldThatVariesIsLeftAsItIs) {
  for (const double size : {100.0, 1.0, 1e-9}) {  // the same numbers are rounding of large ones and all of small ones
    Mesh mesh = field({size * 1e-6, -size * 2e-6, 0.0});
    EXPECT_FALSE(settle_constant(mesh, size));
    EXPECT_EQ(mesh.values, field({size * 1e-6, -size * 2e-6, 0.0}).values);
    EXPECT_EQ(mesh.scale.high, 1.0);
  }
  Mesh none = field({});
  EXPECT_FALSE(settle_constant(none, 1.0));
  Mesh unknown = field({1.0, std::nan("")});
  EXPECT_FALSE(settle_constant(unknown, 1e-3));
}

}  // namespace
}  // namespace dobra::scene
