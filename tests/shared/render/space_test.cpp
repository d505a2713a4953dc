#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>

#include "shared/render/space_file.h"
#include "tests/support/pixels.h"
#include "tests/support/space_picture.h"

namespace dobra::render {
namespace {

namespace fs = std::filesystem;
using scene::space::StandardView;

fs::path file(const std::string& name) {
  const fs::path folder = fs::temp_directory_path() / "dobra_space_test";
  fs::create_directories(folder);
  return folder / name;
}

std::string text_of(const fs::path& path) {
  std::ifstream in(path);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

/// How unlike two pictures are, in parts of the page.
double difference(const fs::path& a, const fs::path& b) {
  const auto one = test::coarse(test::read_png(a), 24, 24);
  const auto other = test::coarse(test::read_png(b), 24, 24);
  double sum = 0.0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) sum += std::abs(one[i][k] - other[i][k]);
  }
  return sum / (3.0 * static_cast<double>(one.size()));
}

TEST(SpaceFile, BothDrawersDrawTheSamePicture) {
  const scene::space::SpacePicture picture = test::space_picture(24);
  for (const StandardView view : {StandardView::Isometric, StandardView::Cavalier, StandardView::Perspective}) {
    SpaceFileOptions options;
    options.pixels_per_point = 1.0;
    options.page = scene::PageSize{500.0, 450.0};
    options.camera = scene::space::camera_of(view);
    ASSERT_TRUE(write_picture(picture, file("cairo.png"), options));
    ASSERT_TRUE(write_png_vtk(picture, file("vtk.png"), options));
    EXPECT_LT(difference(file("cairo.png"), file("vtk.png")), 3.0);
    options.camera = scene::space::camera_of(StandardView::Top);
    ASSERT_TRUE(write_png_vtk(picture, file("top.png"), options));
    EXPECT_GT(difference(file("cairo.png"), file("top.png")), 6.0);
  }
}

TEST(SpaceFile, ASquareStandsWhereTheDisplayListSays) {
  scene::space::SpacePicture picture;
  picture.layers = {test::colored_square({220, 0, 0})};
  picture.axes.box = scene::space::AxesBox::Hidden;
  picture.light.ambient = 1.0;
  SpaceFileOptions options;
  options.pixels_per_point = 1.0;
  options.page = scene::PageSize{300.0, 300.0};
  for (const bool vtk : {false, true}) {
    const fs::path path = file("square.png");
    if (vtk) {
      ASSERT_TRUE(write_png_vtk(picture, path, options));
    } else {
      ASSERT_TRUE(write_picture(picture, path, options));
    }
    const test::Pixels pixels = test::read_png(path);
    const auto middle = pixels.at(pixels.width / 2, pixels.height / 2);
    EXPECT_GT(middle[0], 200.0);
    EXPECT_LT(middle[1], 20.0);
    EXPECT_GT(pixels.at(14, 14)[1], 200.0);
  }
}

/// Draws with both, one after the other, and looks at what came out.
void see_both(const scene::space::SpacePicture& picture, const std::function<void(const test::Pixels&)>& look) {
  SpaceFileOptions options;
  options.pixels_per_point = 1.0;
  options.page = scene::PageSize{300.0, 300.0};
  ASSERT_TRUE(write_picture(picture, file("seen.png"), options));
  look(test::read_png(file("seen.png")));
  ASSERT_TRUE(write_png_vtk(picture, file("seen.png"), options));
  look(test::read_png(file("seen.png")));
}

TEST(SpaceFile, AFaceThatTheLightDoesNotReachHasAThirdOfItsColour) {
  scene::space::SpacePicture picture;
  picture.layers = {test::colored_square({240, 0, 0})};
  picture.axes.box = scene::space::AxesBox::Hidden;
  picture.light.ambient = 1.0 / 3.0;
  for (const auto& [from, red] :
       {std::pair{geom::Vector3{0.0, 0.0, 1.0}, 240.0}, {geom::Vector3{1.0, 0.0, 0.0}, 80.0}}) {
    picture.light.from = from;
    see_both(picture, [&, red = red](const test::Pixels& pixels) {
      EXPECT_NEAR(pixels.at(pixels.width / 2, pixels.height / 2)[0], red, 8.0);
    });
  }
}

TEST(SpaceFile, ACurtainHangsWhereItsTraceIs) {
  scene::Layer unit;
  unit.key = "unit";
  unit.style.fill = scene::Color{0, 200, 0};
  unit.style.line_width = 0.0;
  unit.content = scene::Regions{{{{{{{0.0, 0.0}, {4.0, 0.0}, {4.0, 4.0}, {0.0, 4.0}}, true}}}}, {}};
  scene::space::Curtain curtain{{{10.0, 5.0}, {14.0, 5.0}}, 0.0, {}};
  curtain.section.layers = {unit};
  scene::space::Layer layer;
  layer.key = "section";
  layer.content = curtain;
  scene::space::SpacePicture picture;
  picture.layers = {layer};
  picture.axes.box = scene::space::AxesBox::Hidden;
  picture.light.ambient = 1.0;
  see_both(picture, [](const test::Pixels& pixels) {
    const auto middle = pixels.at(pixels.width / 2, pixels.height / 2);
    EXPECT_GT(middle[1], 180.0);
    EXPECT_LT(middle[0], 30.0);
  });
  picture.layers.front().visible = false;
  picture.extent = geom::Box3{{10.0, 5.0, 0.0}, {14.0, 5.0, 4.0}};
  see_both(picture,
           [](const test::Pixels& pixels) { EXPECT_GT(pixels.at(pixels.width / 2, pixels.height / 2)[0], 200.0); });
}

TEST(SpaceFile, ALabelStandsAtItsPlace) {
  scene::space::SpacePicture picture;
  picture.layers = {test::colored_square({250, 250, 250})};
  picture.layers.front().in_legend = scene::InLegend::No;  // the plot is in the middle of the page
  picture.axes.box = scene::space::AxesBox::Hidden;
  picture.light.ambient = 1.0;
  picture.extent = scene::space::extent(picture);
  // Dark pixels in the middle of the page.
  std::size_t dark = 0;
  const auto count = [&dark](const test::Pixels& pixels) {
    dark = 0;
    for (int y = pixels.height / 2 - 30; y < pixels.height / 2 + 30; ++y) {
      for (int x = pixels.width / 2 - 30; x < pixels.width / 2 + 30; ++x) dark += pixels.at(x, y)[0] < 120.0 ? 1 : 0;
    }
  };
  see_both(picture, [&](const test::Pixels& pixels) {
    count(pixels);
    EXPECT_EQ(dark, 0U);
  });
  scene::space::Layer words;
  words.key = "words";
  words.in_legend = scene::InLegend::No;
  words.style.line = {0, 0, 0};
  words.content = scene::space::Labels{{{scene::space::extent(picture).centre(), "MMMM", scene::Anchor::Centre}}};
  picture.layers.push_back(words);
  see_both(picture, [&](const test::Pixels& pixels) {
    count(pixels);
    EXPECT_GT(dark, 20U);
  });
}

TEST(SpaceFile, ADarkGroundIsDarkAndItsWordsAreLight) {
  SpaceFileOptions options;
  options.pixels_per_point = 1.0;
  options.ground.paper = {30, 32, 36};
  ASSERT_TRUE(write_picture(test::space_picture(8), file("dark.png"), options));
  ASSERT_TRUE(write_png_vtk(test::space_picture(8), file("dark_vtk.png"), options));
  for (const char* name : {"dark.png", "dark_vtk.png"}) {
    const test::Pixels pixels = test::read_png(file(name));
    EXPECT_NEAR(pixels.at(1, 1)[0], 30.0, 1.0);
    std::size_t light = 0;
    for (const std::uint32_t rgb : pixels.rgb) light += (rgb >> 16U & 255U) > 180 && (rgb & 255U) > 180;
    EXPECT_GT(light, 300U);
  }
}

TEST(SpaceFile, TheSamePictureGivesTheSameBytesAndTextStaysText) {
  const auto picture = test::space_picture(8);
  ASSERT_TRUE(write_picture(picture, file("a.svg")));
  ASSERT_TRUE(write_picture(picture, file("b.svg")));
  const std::string svg = text_of(file("a.svg"));
  EXPECT_EQ(svg, text_of(file("b.svg")));
  EXPECT_NE(svg.find("x [m]</text>"), std::string::npos);
  EXPECT_NE(svg.find("Top of the sand</text>"), std::string::npos);
  ASSERT_TRUE(write_picture(picture, file("a.pdf")));
  EXPECT_EQ(text_of(file("a.pdf")).substr(0, 5), "%PDF-");
}

TEST(SpaceFile, AnUnknownEndingIsRefused) {
  const auto refused = write_picture(test::space_picture(2), file("a.bmp"));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, base::ErrorCode::UnknownFormat);
}

TEST(SpaceFile, APictureOfNothingIsDrawn) {
  ASSERT_TRUE(write_picture(scene::space::SpacePicture{}, file("nothing.svg")));
  ASSERT_TRUE(write_png_vtk(scene::space::SpacePicture{}, file("nothing.png")));
}

/// DOBRA_SPACE_TRIANGLES=1000000 draws so many and says how long it took.
TEST(SpaceFile, ManyTrianglesAreDrawn) {
  const char* wish = std::getenv("DOBRA_SPACE_TRIANGLES");
  const double wanted = wish != nullptr ? std::atof(wish) : 20000.0;
  const auto picture = test::space_picture(static_cast<std::size_t>(std::sqrt(0.5 * wanted)));
  const auto begin = std::chrono::steady_clock::now();
  ASSERT_TRUE(write_png_vtk(picture, file("many.png")));
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  RecordProperty("seconds", std::to_string(took.count()));
  if (wish != nullptr) std::printf("%g triangles drawn off-screen in %.2f s\n", wanted, took.count());
}

}  // namespace
}  // namespace dobra::render
