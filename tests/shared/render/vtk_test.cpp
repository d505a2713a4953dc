#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "shared/render/cairo.h"
#include "shared/render/vtk_offscreen.h"
#include "shared/render/vtk_scene.h"
#include "tests/support/example_picture.h"
#include "tests/support/pixels.h"

namespace dobra::render {
namespace {

/// Draws without any display, as the command line may have to.
class VtkOffscreen : public testing::Test {
 protected:
  VtkOffscreen() {
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
  }
  test::ScratchFolder folder_;
};

double largest_difference(const test::Pixels& a, const test::Pixels& b, int columns, int rows, double& mean) {
  const auto x = test::coarse(a, columns, rows);
  const auto y = test::coarse(b, columns, rows);
  double largest = 0.0;
  mean = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      largest = std::max(largest, std::abs(x[i][k] - y[i][k]));
      mean += std::abs(x[i][k] - y[i][k]) / static_cast<double>(3 * x.size());
    }
  }
  return largest;
}

TEST_F(VtkOffscreen, DrawsThePictureThatCairoDraws) {
  for (const scene::Picture& picture : {test::example_section(), test::example_mesh()}) {
    scene::PageSize page = scene::suggested_page(picture, 720.0, cairo_text_measure());
    page.height += 10.0;  // VTK's text is a little larger or smaller; both must fit
    ASSERT_TRUE(write_png(picture, folder_.path() / "cairo.png", page, 2.0));
    const base::Result<void> drawn = write_png_vtk(picture, folder_.path() / "vtk.png", page, 2.0);
    ASSERT_TRUE(drawn) << base::to_string(drawn.error());
    const test::Pixels a = test::read_png(folder_.path() / "cairo.png");
    const test::Pixels b = test::read_png(folder_.path() / "vtk.png");
    ASSERT_EQ(a.width, b.width);
    ASSERT_EQ(a.height, b.height);
    double mean = 0.0;
    EXPECT_LT(largest_difference(a, b, 30, 20, mean), 40.0);
    EXPECT_LT(mean, 3.0);
  }
}

TEST_F(VtkOffscreen, ThePlotHoldsTheColoursOfItsLayersAtTheirPlace) {
  const scene::Picture picture = test::example_section();
  ASSERT_TRUE(write_png_vtk(picture, folder_.path() / "a.png", std::nullopt, 2.0));
  const scene::TextMeasure measure = vtk_text_measure(2.0);
  const scene::Layout layout =
      scene::layout(picture, scene::suggested_page(picture, scene::usual_width(picture), measure), {}, measure);
  const test::Pixels pixels = test::read_png(folder_.path() / "a.png");
  for (int bed = 0; bed < 3; ++bed) {
    const geom::Point p = layout.panels[1].transform.to_page({500.0 + 1000.0 / 48.0, -100.0 * bed - 25.0});
    const auto color = pixels.at(static_cast<int>(2.0 * p.x), static_cast<int>(2.0 * p.y));
    const scene::Color wanted = *picture.panels[1].layers[static_cast<std::size_t>(bed)].style.fill;
    EXPECT_NEAR(color[0], wanted.red, 1.0);
    EXPECT_NEAR(color[1], wanted.green, 1.0);
    EXPECT_NEAR(color[2], wanted.blue, 1.0);
  }
  EXPECT_EQ(pixels.at(2, 2), (std::array<double, 3>{255.0, 255.0, 255.0}));
}

TEST_F(VtkOffscreen, HiddenLayersAreNotDrawn) {
  scene::Picture picture = test::example_section();
  for (scene::Panel& panel : picture.panels) {
    panel.extent = scene::extent(panel);
    for (scene::Layer& layer : panel.layers) layer.visible = false;
  }
  ASSERT_TRUE(write_png_vtk(picture, folder_.path() / "a.png", scene::PageSize{400.0, 400.0}, 1.0));
  const test::Pixels pixels = test::read_png(folder_.path() / "a.png");
  for (const std::uint32_t pixel : pixels.rgb) {
    const auto red = pixel >> 16U;
    const auto blue = pixel & 255U;
    ASSERT_LT(std::abs(static_cast<int>(red) - static_cast<int>(blue)), 8) << "only black, white and grey are left";
  }
}

TEST_F(VtkOffscreen, LargeCoordinatesKeepTheirShape) {
  scene::Picture picture = test::example_mesh(8);
  picture.panels.resize(1);
  scene::Picture far = picture;
  for (scene::Layer& layer : far.panels[0].layers) {
    if (auto* mesh = std::get_if<scene::Mesh>(&layer.content)) {
      for (geom::Point& p : mesh->points.edit()) p = p + geom::Vector{700000.0, 7456000.0};
    }
    if (auto* lines = std::get_if<scene::Lines>(&layer.content)) {
      for (geom::Polyline& line : lines->lines.edit()) {
        for (geom::Point& p : line.points) p = p + geom::Vector{700000.0, 7456000.0};
      }
    }
  }
  picture.panels[0].axes = far.panels[0].axes = {"", ""};
  const scene::PageSize page{500.0, 500.0};
  ASSERT_TRUE(write_png(far, folder_.path() / "cairo.png", page, 1.0));
  ASSERT_TRUE(write_png_vtk(far, folder_.path() / "vtk.png", page, 1.0));
  double mean = 0.0;
  const auto a = test::read_png(folder_.path() / "cairo.png");
  const auto b = test::read_png(folder_.path() / "vtk.png");
  EXPECT_LT(largest_difference(a, b, 12, 12, mean), 45.0);
}

TEST_F(VtkOffscreen, TooLargeAnImageIsAnError) {
  const base::Result<void> result = write_png_vtk(test::example_section(), folder_.path() / "a.png", {}, 100.0);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, base::ErrorCode::CannotDraw);
  EXPECT_EQ(folder_.files(), 0U);
}

TEST_F(VtkOffscreen, AFullDeviceIsAnErrorThatNamesIt) {
  const base::Result<void> result =
      write_png_vtk(test::example_section(), "/dev/full", scene::PageSize{200.0, 200.0}, 1.0);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, base::ErrorCode::CannotWrite);
  EXPECT_EQ(result.error().place->file, "/dev/full");
}

TEST_F(VtkOffscreen, TextIsMeasuredNearlyAsByCairo) {
  const scene::TextMeasure vtk = vtk_text_measure(4.0);
  const scene::TextMeasure cairo = cairo_text_measure();
  for (const char* text : {"x [m]", "\u22121000", "a rather long title of a layer"}) {
    const scene::TextSize a = vtk(text, {9.0, scene::Weight::Regular});
    const scene::TextSize b = cairo(text, {9.0, scene::Weight::Regular});
    EXPECT_NEAR(a.width, b.width, 0.06 * b.width + 1.0) << text;
    EXPECT_NEAR(a.height(), b.height(), 0.05 * b.height());
  }
}

TEST_F(VtkOffscreen, AnImageLooksAsCairoDrawsIt) {
  scene::Picture picture;
  scene::Layer layer;
  layer.key = "backdrop";
  auto pixels = std::make_shared<scene::Pixels>();
  pixels->width = pixels->height = 16;
  for (std::uint8_t y = 0; y < 16; ++y) {
    for (std::uint8_t x = 0; x < 16; ++x) {
      for (const int channel : {16 * x, 16 * y, 128, 255}) pixels->rgba.push_back(static_cast<std::uint8_t>(channel));
    }
  }
  layer.content = scene::Image{pixels, {{100.0, 0.0}, {300.0, 200.0}}, 0.8};
  scene::Panel panel;
  panel.layers = {layer};
  panel.axes = {"", ""};
  panel.extent = geom::Box{{0.0, -100.0}, {400.0, 300.0}};
  picture.panels = {panel};
  const scene::PageSize page{400.0, 400.0};
  ASSERT_TRUE(write_png(picture, folder_.path() / "cairo.png", page, 1.0));
  ASSERT_TRUE(write_png_vtk(picture, folder_.path() / "vtk.png", page, 1.0));
  double mean = 0.0;
  const auto a = test::read_png(folder_.path() / "cairo.png");
  const auto b = test::read_png(folder_.path() / "vtk.png");
  EXPECT_LT(largest_difference(a, b, 12, 12, mean), 20.0);
}

/// Two areas, one with a hole, and their legend.
scene::Picture with_patterns(scene::Pattern pattern) {
  scene::Panel panel{"p", ""};
  panel.extent = geom::Box{{0.0, 0.0}, {100.0, 60.0}};
  scene::Style style{.line_width = 0.0, .fill = scene::Color{200, 220, 240}};
  style.pattern = pattern;
  const geom::Polyline rim{{{10.0, 5.0}, {95.0, 10.0}, {80.0, 55.0}, {15.0, 50.0}}, true};
  const geom::Polyline hole{{{40.0, 20.0}, {60.0, 20.0}, {60.0, 40.0}, {40.0, 40.0}}, true};
  panel.layers.push_back({"a", "unit", style, scene::Regions{{{{rim, hole}}}, {}}});
  scene::Picture picture;
  picture.panels = {panel};
  return picture;
}

TEST_F(VtkOffscreen, PatternsAreThoseOfCairoAndInTheirAreaOnly) {
  const scene::PageSize page{360.0, 300.0};
  const scene::Transform transform =
      scene::layout(with_patterns(scene::Pattern::Dots), page, {}, vtk_text_measure(3.0)).panels[0].transform;
  const auto plain = with_patterns(scene::Pattern::None);
  ASSERT_TRUE(write_png_vtk(plain, folder_.path() / "plain.png", page, 3.0));
  const test::Pixels none = test::read_png(folder_.path() / "plain.png");
  for (const auto pattern : {scene::Pattern::Dots, scene::Pattern::Bricks, scene::Pattern::CrossHatch}) {
    const scene::Picture picture = with_patterns(pattern);
    ASSERT_TRUE(write_png(picture, folder_.path() / "cairo.png", page, 3.0));
    ASSERT_TRUE(write_png_vtk(picture, folder_.path() / "vtk.png", page, 3.0));
    const test::Pixels a = test::read_png(folder_.path() / "cairo.png");
    const test::Pixels b = test::read_png(folder_.path() / "vtk.png");
    const auto darkness = [&](const test::Pixels& pixels, geom::Point low, geom::Point high) {
      double sum = 0.0;
      std::size_t count = 0;
      for (double x = low.x; x < high.x; x += 0.2) {
        for (double y = low.y; y < high.y; y += 0.2, ++count) {
          const geom::Point p = transform.to_page({x, y});
          sum += 220.0 - pixels.at(static_cast<int>(3.0 * p.x), static_cast<int>(3.0 * p.y))[1];
        }
      }
      return sum / static_cast<double>(count);
    };
    const double by_cairo = darkness(a, {18.0, 12.0}, {38.0, 48.0});
    EXPECT_GT(by_cairo, 2.0);
    EXPECT_NEAR(darkness(b, {18.0, 12.0}, {38.0, 48.0}), by_cairo, 0.35 * by_cairo) << static_cast<int>(pattern);
    EXPECT_LT(darkness(b, {41.0, 21.0}, {59.0, 39.0}), -30.0) << "the hole, pattern " << static_cast<int>(pattern);
    const scene::Layout own = scene::layout(picture, page, {}, vtk_text_measure(3.0));
    for (const scene::Mark& mark : own.marks) {
      const auto* swatch = std::get_if<scene::BoxMark>(&mark);
      if (swatch == nullptr || swatch->pattern == scene::Pattern::None) continue;
      double darker = 0.0;
      for (double x = 3.0 * swatch->box.low.x + 1.0; x < 3.0 * swatch->box.high.x - 1.0; x += 1.0) {
        for (double y = 3.0 * swatch->box.low.y + 1.0; y < 3.0 * swatch->box.high.y - 1.0; y += 1.0) {
          const int column = static_cast<int>(x), line = static_cast<int>(y);
          darker += none.at(column, line)[1] - b.at(column, line)[1];
        }
      }
      EXPECT_GT(darker, 500.0) << "the legend, pattern " << static_cast<int>(pattern);
    }
  }
}

}  // namespace
}  // namespace dobra::render
