#include "shared/render/cairo.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <set>
#include <sstream>
#include <thread>

#include "tests/support/example_picture.h"
#include "tests/support/pixels.h"

namespace dobra::render {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string read(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Every element that opens is closed, in order; attribute values are quoted.
bool well_formed(const std::string& xml) {
  std::vector<std::string> open;
  for (std::size_t at = xml.find('<'); at != std::string::npos; at = xml.find('<', at + 1)) {
    const std::size_t end = xml.find('>', at);
    if (end == std::string::npos) return false;
    const std::string tag = xml.substr(at + 1, end - at - 1);
    if (std::count(tag.begin(), tag.end(), '"') % 2 != 0) return false;
    if (tag.front() == '?' || tag.back() == '/') continue;
    const std::string name =
        tag.substr(tag.front() == '/' ? 1 : 0, tag.find_first_of(" /\n", 1) - (tag.front() == '/' ? 1 : 0));
    if (tag.front() != '/') {
      open.push_back(name);
    } else {
      if (open.empty() || open.back() != name) return false;
      open.pop_back();
    }
  }
  return open.empty();
}

TEST(Cairo, TheSvgIsWellFormedAndHoldsTheTextsAsText) {
  const test::ScratchFolder folder;
  scene::Picture picture = test::example_section();
  picture.title = "Sand & shale <restored>";
  ASSERT_TRUE(write_svg(picture, folder.path() / "a.svg"));
  const std::string svg = read(folder.path() / "a.svg");
  EXPECT_TRUE(well_formed(svg));
  for (const char* text :
       {"sandstone", "source grid", "target grid", "Deformed", "x [m]", "Sand &amp; shale &lt;restored&gt;"}) {
    EXPECT_THAT(svg, HasSubstr(">" + std::string(text) + "</text>"));
  }
  EXPECT_EQ(svg.find("<image"), std::string::npos);
}

TEST(Cairo, TheSamePictureGivesTheSameBytes) {
  const test::ScratchFolder folder;
  for (const char* kind : {".svg", ".pdf", ".png"}) {
    const auto first = folder.path() / (std::string("a") + kind);
    const auto second = folder.path() / (std::string("b") + kind);
    ASSERT_TRUE(write_picture(test::example_mesh(), first));
    ASSERT_TRUE(write_picture(test::example_section(), folder.path() / "other.png"));
    ASSERT_TRUE(write_picture(test::example_mesh(), second));
    EXPECT_TRUE(read(first) == read(second)) << kind;
    EXPECT_GT(read(first).size(), 1000U);
  }
}

TEST(Cairo, ThePdfDoesNotTellTheTimeOfDay) {
  const test::ScratchFolder folder;
  ASSERT_TRUE(write_pdf(test::example_section(), folder.path() / "a.pdf"));
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // dates in a PDF go by seconds
  ASSERT_TRUE(write_pdf(test::example_section(), folder.path() / "b.pdf"));
  const std::string pdf = read(folder.path() / "a.pdf");
  EXPECT_THAT(pdf.substr(0, 5), "%PDF-");
  EXPECT_NE(pdf.find("%%EOF"), std::string::npos);
  EXPECT_TRUE(pdf == read(folder.path() / "b.pdf"));
}

/// A sheet with a table of so many rows.
scene::Picture sheet(std::size_t rows) {
  scene::Picture picture = test::example_section();
  picture.paper = scene::Paper::A4Landscape;
  picture.tables = {{"Beds", {"horizon", "length [m]"}, {}}};
  for (std::size_t i = 0; i < rows; ++i) picture.tables[0].rows.push_back({"bed " + std::to_string(i), "1000.0"});
  return picture;
}

TEST(Cairo, LongTablesGoToFurtherPagesOfThePdfAndAreCutInOtherPictures) {
  const test::ScratchFolder folder;
  for (const int rows : {4, 90, 1500}) {
    const auto further =
        scene::table_pages(sheet(static_cast<std::size_t>(rows)), scene::a4_landscape, cairo_text_measure());
    ASSERT_TRUE(write_pdf(sheet(static_cast<std::size_t>(rows)), folder.path() / "a.pdf"));
    const std::string pdf = read(folder.path() / "a.pdf");
    const std::string count = "/Count " + std::to_string(rows > 4 ? 1 + further.size() : 1);
    EXPECT_GE(further.size(), rows > 1000 ? 4U : 1U);
    EXPECT_NE(pdf.find(count), std::string::npos) << rows << " rows: not " << count;
    EXPECT_NE(pdf.find("841.89"), std::string::npos);
    ASSERT_TRUE(write_svg(sheet(static_cast<std::size_t>(rows)), folder.path() / "a.svg"));
    const std::string svg = read(folder.path() / "a.svg");
    EXPECT_EQ(svg.find(" more rows") != std::string::npos, rows > 4);
    EXPECT_NE(svg.find("bed 2<"), std::string::npos);
  }
}

TEST(Cairo, PatternsAreDrawnOverTheirAreaAndNowhereElse) {
  const test::ScratchFolder folder;
  const auto names = {scene::Pattern::Dots,       scene::Pattern::Bricks,  scene::Pattern::Dashes,
                      scene::Pattern::Hatch,      scene::Pattern::Circles, scene::Pattern::BackHatch,
                      scene::Pattern::CrossHatch, scene::Pattern::Crosses, scene::Pattern::Vees};
  std::set<std::string> seen;
  for (const scene::Pattern pattern : names) {
    scene::Picture picture;
    scene::Panel panel{"p", ""};
    panel.extent = geom::Box{{0.0, 0.0}, {100.0, 100.0}};
    scene::Style style{.line_width = 0.0, .fill = scene::Color{200, 220, 240}};
    style.pattern = pattern;
    panel.layers.push_back(
        {"a", "", style, scene::Regions{{{{{{{10.0, 10.0}, {60.0, 10.0}, {60.0, 90.0}, {10.0, 90.0}}, true}}}}, {}}});
    picture.panels = {panel};
    const scene::PageSize page{300.0, 300.0};
    ASSERT_TRUE(write_png(picture, folder.path() / "a.png", page, 1.0));
    const scene::PanelLayout place = scene::layout(picture, page, {}, cairo_text_measure()).panels[0];
    const test::Pixels pixels = test::read_png(folder.path() / "a.png");
    std::size_t dark = 0;
    std::size_t outside = 0;
    for (double x = 1.0; x < 99.0; x += 0.4) {
      for (double y = 1.0; y < 99.0; y += 0.4) {
        const bool in = x > 11.0 && x < 59.0 && y > 11.0 && y < 89.0;
        const bool out = x < 9.0 || x > 61.0 || y < 9.0 || y > 91.0;
        const geom::Point p = place.transform.to_page({x, y});
        const double red = pixels.at(static_cast<int>(p.x), static_cast<int>(p.y))[0];
        if (in && red < 190.0) ++dark;
        if (out && red < 250.0) ++outside;
      }
    }
    EXPECT_GT(dark, 500U) << static_cast<int>(pattern);
    EXPECT_EQ(outside, 0U) << static_cast<int>(pattern);
    seen.insert(read(folder.path() / "a.png"));
  }
  EXPECT_EQ(seen.size(), names.size());
}

TEST(Cairo, ThePngShowsTheBedsWhereTheyAre) {
  const test::ScratchFolder folder;
  const scene::Picture picture = test::example_section();
  const scene::TextMeasure measure = cairo_text_measure();
  const scene::PageSize page = scene::suggested_page(picture, 600.0, measure);
  ASSERT_TRUE(write_png(picture, folder.path() / "a.png", page, 2.0));
  const test::Pixels pixels = test::read_png(folder.path() / "a.png");
  EXPECT_EQ(pixels.width, static_cast<int>(2.0 * page.width));
  const scene::Layout layout = scene::layout(picture, page, {}, measure);
  // Between the grid lines of the restored section, in the middle of each half bed.
  const scene::Transform& transform = layout.panels[1].transform;
  const double half_cell = 1000.0 / 48.0;
  for (int bed = 0; bed < 3; ++bed) {
    const geom::Point p = transform.to_page({500.0 + half_cell, -100.0 * bed - 25.0});
    const auto color = pixels.at(static_cast<int>(2.0 * p.x), static_cast<int>(2.0 * p.y));
    const scene::Color wanted = *picture.panels[1].layers[static_cast<std::size_t>(bed)].style.fill;
    EXPECT_EQ(color, (std::array<double, 3>{static_cast<double>(wanted.red), static_cast<double>(wanted.green),
                                            static_cast<double>(wanted.blue)}));
  }
  EXPECT_EQ(pixels.at(1, 1), (std::array<double, 3>{255.0, 255.0, 255.0}));
}

TEST(Cairo, NoWhiteShinesBetweenTriangles) {
  const test::ScratchFolder folder;
  scene::Picture picture = test::example_mesh(24);
  picture.panels.erase(picture.panels.begin());
  picture.panels[0].layers.resize(1);
  picture.panels[0].layers[0].style.line_width = 0.0;
  const scene::TextMeasure measure = cairo_text_measure();
  const scene::PageSize page = scene::suggested_page(picture, 400.0, measure);
  ASSERT_TRUE(write_png(picture, folder.path() / "a.png", page, 2.0));
  const test::Pixels pixels = test::read_png(folder.path() / "a.png");
  const scene::Transform transform = scene::layout(picture, page, {}, measure).panels[0].transform;
  // All colours of the map but its bright end are dark in red or blue; white is bright in all.
  int seen = 0;
  for (double x = 1.5; x < 3.95; x += 0.01) {
    for (double y = 1.5; y < 3.95; y += 0.01, ++seen) {
      const geom::Point p = transform.to_page({x, y});
      const auto color = pixels.at(static_cast<int>(2.0 * p.x), static_cast<int>(2.0 * p.y));
      ASSERT_LT(std::min({color[0], color[1], color[2]}), 150.0) << x << ", " << y;
    }
  }
  EXPECT_GT(seen, 10000);
}

TEST(Cairo, LayersAreClippedToTheirPlot) {
  const test::ScratchFolder folder;
  scene::Picture picture = test::example_section();
  picture.panels.pop_back();
  // A small extent inside: the beds go far beyond it on all sides.
  picture.panels[0].extent = geom::Box{{240.0, -100.0}, {260.0, -90.0}};
  picture.panels[0].layers.resize(4);
  const scene::TextMeasure measure = cairo_text_measure();
  const scene::PageSize page{400.0, 300.0};
  ASSERT_TRUE(write_png(picture, folder.path() / "a.png", page, 1.0));
  const test::Pixels pixels = test::read_png(folder.path() / "a.png");
  const geom::Box plot = scene::layout(picture, page, {}, measure).panels[0].plot;
  EXPECT_EQ(pixels.at(static_cast<int>(plot.high.x) + 3, static_cast<int>(plot.centre().y)),
            (std::array<double, 3>{255.0, 255.0, 255.0}));
  const auto inside = pixels.at(static_cast<int>(plot.centre().x) + 30, static_cast<int>(plot.centre().y));
  EXPECT_LT(inside[2], 240.0);
}

TEST(Cairo, AVeryDeepZoomStillShowsTheAreaItIsIn) {
  const test::ScratchFolder folder;
  scene::Picture picture = test::example_section();
  picture.panels.pop_back();
  picture.panels[0].extent = geom::Box{{250.0 + 20.0, 60.0}, {250.0 + 20.0 + 1e-6, 60.0 + 1e-6}};
  picture.panels[0].layers.resize(3);
  ASSERT_TRUE(write_png(picture, folder.path() / "a.png", scene::PageSize{300.0, 300.0}, 1.0));
  const test::Pixels pixels = test::read_png(folder.path() / "a.png");
  const auto color = pixels.at(150, 150);
  EXPECT_EQ(color, (std::array<double, 3>{244.0, 222.0, 170.0}));
}

TEST(Cairo, AFullDeviceIsAnErrorThatNamesIt) {
  for (const auto write : {+[] { return write_svg(test::example_section(), "/dev/full"); },
                           +[] { return write_pdf(test::example_section(), "/dev/full"); },
                           +[] { return write_png(test::example_section(), "/dev/full"); }}) {
    const base::Result<void> result = write();
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, base::ErrorCode::CannotWrite);
    EXPECT_EQ(result.error().place->file, "/dev/full");
    EXPECT_THAT(result.error().message, HasSubstr("No space left"));
  }
}

TEST(Cairo, AFailureLeavesNoFileAndNoRemains) {
  const test::ScratchFolder folder;
  const base::Result<void> missing = write_svg(test::example_section(), folder.path() / "no" / "such" / "folder.svg");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, base::ErrorCode::CannotWrite);
  std::filesystem::create_directory(folder.path() / "taken.png");
  const base::Result<void> taken = write_png(test::example_section(), folder.path() / "taken.png");
  ASSERT_FALSE(taken);
  EXPECT_EQ(taken.error().code, base::ErrorCode::CannotWrite);
  EXPECT_EQ(folder.files(), 1U);
}

TEST(Cairo, AFileIsReplacedAsAWhole) {
  const test::ScratchFolder folder;
  const auto path = folder.path() / "a.svg";
  std::ofstream(path) << "what was there";
  ASSERT_TRUE(write_svg(test::example_section(), path));
  EXPECT_THAT(read(path), StartsWith("<?xml"));
  EXPECT_EQ(folder.files(), 1U);
}

TEST(Cairo, TooLargeAnImageIsAnError) {
  const test::ScratchFolder folder;
  const base::Result<void> result = write_png(test::example_section(), folder.path() / "a.png", {}, 500.0);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, base::ErrorCode::CannotDraw);
  EXPECT_EQ(folder.files(), 0U);
}

TEST(Cairo, AnUnknownExtensionIsAnErrorThatNamesTheKnownOnes) {
  const base::Result<void> result = write_picture(test::example_section(), "picture.bmp");
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, base::ErrorCode::UnknownFormat);
  EXPECT_THAT(result.error().message, HasSubstr(".svg .pdf .png"));
}

TEST(Cairo, AHundredThousandTrianglesMakeAFileOfAFewMegabytes) {
  const test::ScratchFolder folder;
  scene::Picture picture = test::example_mesh(224);
  picture.panels.erase(picture.panels.begin());
  ASSERT_TRUE(write_pdf(picture, folder.path() / "a.pdf"));
  EXPECT_LT(std::filesystem::file_size(folder.path() / "a.pdf"), 4U << 20U);
}

TEST(Cairo, TextThatIsNoUtf8DoesNotSpoilThePicture) {
  const test::ScratchFolder folder;
  scene::Picture picture = test::example_section();
  picture.panels[0].title = "se\xe7\xe3o";
  picture.panels[0].layers[0].title = "arenito \xff";
  EXPECT_TRUE(write_pdf(picture, folder.path() / "a.pdf"));
  ASSERT_TRUE(write_svg(picture, folder.path() / "a.svg"));
  EXPECT_THAT(read(folder.path() / "a.svg"), HasSubstr("se\uFFFD\uFFFDo"));
}

TEST(Cairo, AnImageLiesOverItsBoxTheRightWayUp) {
  const test::ScratchFolder folder;
  scene::Picture picture;
  scene::Layer layer;
  layer.key = "backdrop";
  auto pixels = std::make_shared<scene::Pixels>();
  *pixels = {2, 2, {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 0, 0, 0, 0}};  // red green / blue nothing
  layer.content = scene::Image{pixels, {{100.0, 0.0}, {300.0, 200.0}}, 1.0};
  scene::Panel panel;
  panel.layers = {layer};
  panel.axes = {"", ""};
  panel.extent = geom::Box{{0.0, -100.0}, {400.0, 300.0}};
  picture.panels = {panel};
  ASSERT_TRUE(write_png(picture, folder.path() / "a.png", scene::PageSize{400.0, 400.0}, 1.0));
  const scene::Layout layout = scene::layout(picture, {400.0, 400.0}, {}, cairo_text_measure());
  const test::Pixels seen = test::read_png(folder.path() / "a.png");
  const auto at = [&](double x, double y) {
    const geom::Point p = layout.panels[0].transform.to_page({x, y});
    return seen.at(static_cast<int>(p.x), static_cast<int>(p.y));
  };
  EXPECT_EQ(at(110, 190), (std::array<double, 3>{255, 0, 0}));
  EXPECT_EQ(at(290, 190), (std::array<double, 3>{0, 255, 0}));
  EXPECT_EQ(at(110, 10), (std::array<double, 3>{0, 0, 255}));
  EXPECT_EQ(at(290, 10), (std::array<double, 3>{255, 255, 255}));
  EXPECT_EQ(at(350, 100), (std::array<double, 3>{255, 255, 255}));
  ASSERT_TRUE(write_svg(picture, folder.path() / "a.svg"));
  EXPECT_NE(read(folder.path() / "a.svg").find("<image"), std::string::npos);
}

}  // namespace
}  // namespace dobra::render
