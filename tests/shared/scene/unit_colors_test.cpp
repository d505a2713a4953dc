#include "shared/scene/unit_colors.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

namespace dobra::scene {
namespace {

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

// How colours look in full protanopia and deuteranopia (Machado, Oliveira and Fernandes 2009), in linear light.
constexpr Matrix protan{
    {{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}};
constexpr Matrix deutan{
    {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}};
constexpr Matrix normal{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

Triple lab(Color color, const Matrix& vision) {
  const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  const Triple rgb{linear(color.red / 255.0), linear(color.green / 255.0), linear(color.blue / 255.0)};
  Triple seen{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) seen[i] += vision[i][k] * rgb[k];
    seen[i] = std::min(1.0, std::max(0.0, seen[i]));
  }
  const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0; };
  const double x = f((0.4124 * seen[0] + 0.3576 * seen[1] + 0.1805 * seen[2]) / 0.95047);
  const double y = f(0.2126 * seen[0] + 0.7152 * seen[1] + 0.0722 * seen[2]);
  const double z = f((0.0193 * seen[0] + 0.1192 * seen[1] + 0.9505 * seen[2]) / 1.08883);
  return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

double apart(Color a, Color b, const Matrix& vision) {
  const Triple p = lab(a, vision);
  const Triple q = lab(b, vision);
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

TEST(UnitColors, TheFirstTwelveAreToldApartByAllEyes) {
  for (std::size_t i = 0; i < 12; ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      for (const Matrix& vision : {normal, protan, deutan}) {
        EXPECT_GE(apart(unit_style(i).fill, unit_style(k).fill, vision), 11.0) << i << ", " << k;
        EXPECT_GE(apart(unit_style(i).line, unit_style(k).line, vision), 7.0) << i << ", " << k;
      }
    }
  }
}

TEST(UnitColors, ThirtySixFillsDifferAndTwoHundredAndSixteenStyles) {
  std::set<std::array<int, 4>> styles;
  for (std::size_t i = 0; i < 216; ++i) {
    const UnitStyle style = unit_style(i);
    styles.insert({style.fill.red, style.fill.green, style.fill.blue, static_cast<int>(style.pattern)});
    EXPECT_EQ(style.pattern == Pattern::None, i < 36) << i;
    for (std::size_t k = 0; i < 36 && k < i; ++k) EXPECT_GE(apart(style.fill, unit_style(k).fill, normal), 12.0);
    EXPECT_GE(apart(style.line, {255, 255, 255}, normal), 40.0) << "lines are seen on white";
  }
  EXPECT_EQ(styles.size(), 216U);
}

TEST(UnitColors, PiecesBelongToTheirUnit) {
  const auto wholes = [](std::vector<std::string> names) { return whole_names(names); };
  using Names = std::vector<std::string>;
  EXPECT_EQ(wholes({"K2p_1", "J3", "K2p_2", "K1_1"}), (Names{"K2p", "J3", "K2p", "K1_1"}));
  EXPECT_EQ(wholes({"K2p", "K2p (2)", "J3"}), (Names{"K2p", "K2p", "J3"}));
  EXPECT_EQ(wholes({"K2p (1)", "K2p (2)"}), (Names{"K2p", "K2p"}));
  EXPECT_EQ(wholes({"K1-2", "K1-3", "top1", "top2", "_1", "_2"}), (Names{"K1-2", "K1-3", "top1", "top2", "_1", "_2"}));
}

TEST(UnitColors, NumbersBehindAGeneralWordAreNames) {
  using Names = std::vector<std::string>;
  const Names units{"unit_1", "unit_2", "basement"};
  EXPECT_EQ(whole_names(units), units);
  const Names only{"K2p_1", "K2p_2"};  // all would be one
  EXPECT_EQ(whole_names(only), only);
}

TEST(UnitColors, NumbersDependOnTheNamesAlone) {
  const std::vector<std::string> names{"K2p", "J3", "K2p", "C1"};
  EXPECT_EQ(numbers_of(names), (std::vector<std::size_t>{2, 1, 2, 0}));
}

TEST(UnitColors, ColoursAreReadInAllTheirSpellings) {
  EXPECT_EQ(color_of_text("#d2b48c"), (Color{210, 180, 140}));
  EXPECT_EQ(color_of_text("#FA0"), (Color{255, 170, 0}));
  EXPECT_EQ(color_of_text("210, 180,140"), (Color{210, 180, 140}));
  EXPECT_EQ(color_of_text("Tan"), (Color{210, 180, 140}));
  for (const char* bad : {"", "#12", "#12345g", "1,2", "1,2,3,4", "1,2,300", "-1,2,3", "no colour", "#"})
    EXPECT_FALSE(color_of_text(bad)) << bad;
}

TEST(UnitColors, RocksHaveTheirSigns) {
  EXPECT_EQ(pattern_of_lithology("Fine sandstone"), Pattern::Dots);
  EXPECT_EQ(pattern_of_lithology("sandy limestone"), Pattern::Bricks);
  EXPECT_EQ(pattern_of_lithology("basalt"), Pattern::Vees);  // and no salt
  EXPECT_EQ(pattern_of_lithology("salt"), Pattern::CrossHatch);
  EXPECT_EQ(pattern_of_lithology("Folhelho negro"), Pattern::Dashes);
  EXPECT_EQ(pattern_of_lithology(""), Pattern::None);
  for (const std::string& name : pattern_names()) EXPECT_TRUE(pattern_of_text(name)) << name;
  EXPECT_FALSE(pattern_of_text("stripes"));
}

Picture picture_of_units() {
  Picture picture;
  Panel panel{"p", "P"};
  const Style filled{.fill = Color{1, 2, 3, 110}};
  const Regions triangle{{{{{{{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}, true}}}}, {}};
  panel.layers.push_back({"u0", "K2p_1", filled, triangle});
  panel.layers.back().legend = "K2p";
  panel.layers.push_back({"u1", "top - base", filled, triangle});
  panel.layers.push_back({"l", "top", Style{}, Lines{}});
  panel.layers.push_back({"n", "top", Style{}, Labels{}});
  panel.layers.push_back({"f", "F1", Style{}, Lines{}});
  picture.panels = {panel};
  return picture;
}

TEST(UnitColors, ATableColoursPiecesBedsAndTheRockBelowThem) {
  Picture picture = picture_of_units();
  paint(picture, {{{"k2P", Color{9, 8, 7}, std::nullopt, "Cretaceous", "limestone"},
                   {"top", Color{250, 240, 10}, Pattern::Hatch}}});
  const std::vector<Layer>& layers = picture.panels[0].layers;
  EXPECT_EQ(layers[0].style.fill, (Color{9, 8, 7, 110}));  // as translucent as before
  EXPECT_EQ(layers[0].style.pattern, Pattern::Bricks);
  EXPECT_EQ(legend_name(layers[0]), "K2p (Cretaceous, limestone)");
  EXPECT_EQ(layers[1].style.fill, (Color{250, 240, 10, 110}));
  EXPECT_EQ(layers[1].style.pattern, Pattern::Hatch);
  EXPECT_EQ(layers[2].style.line, (Color{250, 240, 10}));
  EXPECT_LT(layers[3].style.line.red, 150);  // a name in yellow could not be read
  EXPECT_EQ(layers[4].style.line, Color{});
}

TEST(UnitColors, NamesThatOnlyOneOfTableAndSectionHasAreTold) {
  const std::vector<std::string> names{"K2p_1", "K2p_2", "J3", "J3 - C1"};
  const auto remarks = remarks_on({{{"K2p", Color{}}, {"J2", Color{}}, {"Trias", Color{}}}}, names);
  ASSERT_EQ(remarks.size(), 2U);
  EXPECT_NE(remarks[0].find("'J2'; did you mean 'J3'?, 'Trias'"), std::string::npos) << remarks[0];
  EXPECT_NE(remarks[1].find("'J3', 'J3 - C1'"), std::string::npos) << remarks[1];
  EXPECT_EQ(remarks[1].find("K2p"), std::string::npos);
  EXPECT_TRUE(remarks_on({{{"K2p", Color{}}, {"J3", Color{}}}}, names).empty());
}

}  // namespace
}  // namespace dobra::scene
