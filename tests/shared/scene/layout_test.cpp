#include "shared/scene/layout.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/support/example_picture.h"

namespace dobra::scene {
namespace {

const TextMeasure text_measure = approximate_text_measure();

Layout laid_out(const Picture& picture, double width = 720.0) {
  return layout(picture, suggested_page(picture, width, text_measure), {}, text_measure);
}

std::vector<const TextMark*> texts_of(const Layout& made) {
  std::vector<const TextMark*> texts;
  for (const Mark& mark : made.marks) {
    if (const auto* text = std::get_if<TextMark>(&mark)) texts.push_back(text);
  }
  return texts;
}

std::size_t count(const Layout& made, const std::string& text) {
  std::size_t found = 0;
  for (const TextMark* mark : texts_of(made)) found += mark->text == text ? 1 : 0;
  return found;
}

bool apart(const geom::Box& a, const geom::Box& b) {
  constexpr double touch = 0.01;
  return !a.grown(-touch).overlaps(b.grown(-touch));
}

/// No text overlaps another or leaves the page; none outside a plot reaches into one.
void expect_tidy(const Layout& made, const std::string& what) {
  const std::vector<const TextMark*> texts = texts_of(made);
  const geom::Box page{{0.0, 0.0}, {made.page.width, made.page.height}};
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const geom::Box box = box_of(Mark{*texts[i]});
    EXPECT_TRUE(page.contains(box.low) && page.contains(box.high)) << what << ": '" << texts[i]->text << "' is cut off";
    for (std::size_t k = i + 1; k < texts.size(); ++k) {
      EXPECT_TRUE(apart(box, box_of(Mark{*texts[k]})))
          << what << ": '" << texts[i]->text << "' and '" << texts[k]->text << "'";
    }
    for (const PanelLayout& panel : made.panels) {
      const bool inside = panel.plot.contains(box.low) && panel.plot.contains(box.high);
      EXPECT_TRUE(inside || apart(box, panel.plot)) << what << ": '" << texts[i]->text << "' reaches into a plot";
    }
  }
  for (std::size_t i = 0; i < made.panels.size(); ++i) {
    for (std::size_t k = i + 1; k < made.panels.size(); ++k) {
      EXPECT_TRUE(apart(made.panels[i].plot, made.panels[k].plot)) << what;
    }
  }
}

/// A picture with everything that is awkward: long texts, tall and flat panels, exaggeration, large coordinates.
Picture awkward(Arrangement arrangement) {
  Picture picture = test::example_section(arrangement);
  picture.title =
      "A picture whose title is so long that it can never stand in one line, not even of the widest page of all";
  picture.panels[0].title = "The section as it was measured in the field in the year of the great flood";
  picture.panels[0].axes.y_title = "height above the mean level of the sea [m]";
  picture.panels[1].vertical_exaggeration = 3.0;
  picture.panels[1].layers[0].title = "Thickly bedded sandstone with lenses of conglomerate and of shale, weathered";
  Panel tall{"tall", "Tall", {}, {}, 1.0, geom::Box{{7456000.0, 1.0}, {7456010.0, 900.0}}};
  tall.layers.push_back({"t", "tall thing", Style{}, Lines{{{{{7456001.0, 2.0}, {7456009.0, 800.0}}, false}}, {}}});
  picture.panels.push_back(tall);
  return picture;
}

TEST(Layout, NoTextIsCutOffOrOverlapsAnother) {
  for (const double width : {300.0, 480.0, 720.0, 1400.0}) {
    const std::string at = " at " + std::to_string(width);
    for (const Arrangement arrangement : {Arrangement::Row, Arrangement::Column}) {
      expect_tidy(laid_out(test::example_section(arrangement), width), "section" + at);
      expect_tidy(laid_out(awkward(arrangement), width), "awkward" + at);
    }
    expect_tidy(laid_out(test::example_mesh(), width), "mesh" + at);
  }
}

TEST(Layout, NoTextOverlapsOnAPageOfAnySize) {
  for (const PageSize page : {PageSize{200.0, 150.0}, {300.0, 900.0}, {1600.0, 400.0}, {1920.0, 1080.0}}) {
    for (const Plots plots : {Plots::ToContent, Plots::FillPage}) {
      // A window smaller than a plot and its labels cannot show all; files grow.
      if (plots == Plots::FillPage && (page.width < 300.0 || page.height < 400.0)) continue;
      const Picture picture = test::example_mesh();
      expect_tidy(layout(picture, page, {}, text_measure, {plots}), "mesh");
      const Picture section = test::example_section(Arrangement::Row);
      if (plots == Plots::ToContent || page.width >= 600.0)
        expect_tidy(layout(section, page, {}, text_measure, {plots}), "section");
    }
  }
}

TEST(Layout, AllPanelsHaveOneScale) {
  for (const Arrangement arrangement : {Arrangement::Row, Arrangement::Column}) {
    for (const Plots plots : {Plots::ToContent, Plots::FillPage}) {
      const Layout made = layout(test::example_section(arrangement), {900.0, 700.0}, {}, text_measure, {plots});
      ASSERT_EQ(made.panels.size(), 2U);
      EXPECT_EQ(made.panels[0].transform.points_per_x, made.panels[1].transform.points_per_x);
      EXPECT_EQ(made.panels[0].transform.points_per_x, made.panels[0].transform.points_per_y);
    }
  }
}

TEST(Layout, ExaggerationStretchesOneAxisAndIsStated) {
  Picture picture = test::example_section();
  EXPECT_EQ(count(laid_out(picture), "x [m] (vertical exaggeration 2\u00d7)"), 0U);
  picture.panels[1].vertical_exaggeration = 2.0;
  const Layout made = laid_out(picture);
  EXPECT_DOUBLE_EQ(made.panels[1].transform.points_per_y, 2.0 * made.panels[1].transform.points_per_x);
  EXPECT_EQ(made.panels[0].transform.points_per_x, made.panels[1].transform.points_per_x);
  EXPECT_EQ(count(made, "x [m] (vertical exaggeration 2\u00d7)"), 1U);
}

TEST(Layout, EveryPlotShowsItsWholePanel) {
  for (const Arrangement arrangement : {Arrangement::Row, Arrangement::Column}) {
    const Picture picture = awkward(arrangement);
    const Layout made = laid_out(picture);
    for (std::size_t i = 0; i < picture.panels.size(); ++i) {
      const geom::Box shown = made.panels[i].transform.to_world(made.panels[i].plot).grown(1e-6);
      const geom::Box all = extent(picture.panels[i]);
      EXPECT_TRUE(shown.contains(all.low) && shown.contains(all.high)) << i;
    }
  }
}

TEST(Layout, TicksStandOnTheFrameAtTheirValue) {
  const Layout made = laid_out(test::example_section());
  const PanelLayout& panel = made.panels[0];
  const double x = panel.transform.to_page({500.0, 0.0}).x;
  bool found = false;
  for (const TextMark* text : texts_of(made)) {
    if (text->text != "500" || text->at.y > made.panels[1].plot.low.y) continue;
    found = true;
    EXPECT_NEAR(text->at.x, x, 1e-9);
    EXPECT_GT(box_of(Mark{*text}).low.y, panel.plot.high.y);
  }
  EXPECT_TRUE(found);
  for (const Mark& mark : made.marks) {
    const auto* line = std::get_if<LineMark>(&mark);
    // Tick lines are short, horizontal or vertical, and begin or end on a frame.
    if (line == nullptr || line->width != 0.75 || geom::distance(line->from, line->to) > 4.1) continue;
    bool on_frame = false;
    for (const PanelLayout& p : made.panels) {
      on_frame = on_frame || line->from.y == p.plot.high.y || line->to.x == p.plot.low.x;
    }
    EXPECT_TRUE(on_frame) << line->from;
  }
}

TEST(Layout, TheLegendNamesEveryLayerOnce) {
  const Layout made = laid_out(test::example_section());
  for (const char* title :
       {"sandstone", "shale", "limestone", "source grid", "target grid", "horizons", "datum", "pin point"}) {
    EXPECT_EQ(count(made, title), 1U) << title;
  }
  EXPECT_EQ(count(made, "names"), 0U);  // labels need no entry
}

TEST(Layout, HiddenAndUnlistedLayersAreNotInTheLegend) {
  Picture picture = test::example_section();
  for (Panel& panel : picture.panels) {
    panel.layers[0].visible = false;
    panel.layers[1].in_legend = InLegend::No;
  }
  const Layout made = laid_out(picture);
  EXPECT_EQ(count(made, "sandstone"), 0U);
  EXPECT_EQ(count(made, "shale"), 0U);
  EXPECT_EQ(count(made, "limestone"), 1U);
}

TEST(Layout, AColourBarStandsBesideThePlotsForEveryDifferentScale) {
  Picture picture = test::example_mesh();
  const auto bars = [](const Layout& made) {
    std::vector<geom::Box> boxes;
    for (const Mark& mark : made.marks) {
      const auto* bar = std::get_if<GradientMark>(&mark);
      if (bar != nullptr && bar->direction == GradientMark::Direction::Up) boxes.push_back(bar->box);
    }
    return boxes;
  };
  const Layout made = laid_out(picture);
  ASSERT_EQ(bars(made).size(), 2U);
  for (const geom::Box& bar : bars(made)) {
    for (const PanelLayout& panel : made.panels) EXPECT_TRUE(apart(bar, panel.plot));
  }
  EXPECT_EQ(count(made, "quality \u03b1"), 1U);
  picture.panels[1] = picture.panels[0];
  EXPECT_EQ(bars(laid_out(picture)).size(), 1U);
}

TEST(Layout, TheSuggestedPageIsFilled) {
  for (const Picture& picture :
       {test::example_section(), test::example_section(Arrangement::Row), test::example_mesh()}) {
    const PageSize page = suggested_page(picture, 720.0, text_measure);
    EXPECT_LE(page.width, 720.0);
    EXPECT_LE(page.height, 1.4 * 720.0 + 1.0);
    const Layout made = layout(picture, page, {}, text_measure);
    EXPECT_EQ(made.page.width, page.width);
    EXPECT_EQ(made.page.height, page.height);
    geom::Box used;
    for (const Mark& mark : made.marks) used.add(box_of(mark));
    EXPECT_GT(used.width() * used.height(), 0.85 * page.width * page.height);
  }
}

TEST(Layout, AViewIsShownAsAskedAndTheTicksFollow) {
  const Picture picture = test::example_section();
  const std::vector<std::optional<View>> views{View{{250.0, 0.0}, 0.01}, std::nullopt};
  const Layout made = layout(picture, {900.0, 700.0}, views, text_measure, {Plots::FillPage});
  EXPECT_EQ(made.panels[0].view, *views[0]);
  EXPECT_EQ(made.panels[0].transform.to_page({250.0, 0.0}), made.panels[0].plot.centre());
  EXPECT_EQ(count(made, "250.0"), 1U);  // the step is below a metre now
  expect_tidy(made, "view");
}

TEST(Layout, InAWindowALongLegendLeavesThePageToThePlots) {
  Picture picture;
  Panel panel;
  panel.extent = geom::Box{{0.0, 0.0}, {100.0, 80.0}};
  for (int i = 0; i < 100; ++i) {
    Layer line;
    line.key = line.title = "horizon " + std::to_string(i);
    line.content = Lines{{{{{0.0, 0.8 * i}, {100.0, 0.8 * i}}, false}}, {}};
    panel.layers.push_back(line);
  }
  picture.panels.push_back(panel);
  const Layout made = layout(picture, {660.0, 640.0}, {}, text_measure, {Plots::FillPage});
  EXPECT_GT(made.panels[0].plot.height(), 0.7 * 640.0);
  EXPECT_EQ(count(made, "horizon 0"), 1U);
  EXPECT_EQ(count(made, "horizon 99"), 0U);
  const auto says_more = [](const Mark& mark) {
    const auto* text = std::get_if<TextMark>(&mark);
    return text != nullptr && text->text.starts_with("... ") && text->text.ends_with(" more");
  };
  EXPECT_EQ(std::count_if(made.marks.begin(), made.marks.end(), says_more), 1);
}

TEST(Layout, InAWindowLongThinPanelsAreStackedAndTallOnesStandBesideEachOther) {
  for (const Arrangement arrangement : {Arrangement::Row, Arrangement::Column, Arrangement::Grid}) {
    const auto plots = [&](geom::Point size) {
      Panel panel;
      panel.extent = geom::Box{{0.0, 0.0}, size};
      const Picture picture{"", {panel, panel}, arrangement};
      const Layout made = layout(picture, {660.0, 640.0}, {}, text_measure, {Plots::FillPage});
      return std::pair(made.panels[0].plot, made.panels[1].plot);
    };
    const auto [upper, lower] = plots({6400.0, 600.0});
    EXPECT_GT(lower.low.y, upper.high.y);
    EXPECT_GT(upper.width(), 0.8 * 660.0);
    const auto [left, right] = plots({600.0, 6400.0});
    EXPECT_GT(right.low.x, left.high.x);
  }
}

TEST(Layout, PlotsDoNotJumpWhileTheViewPans) {
  const Picture picture = test::example_section();
  std::vector<std::optional<View>> views{View{{250.0, 0.0}, 0.5}, View{{250.0, 0.0}, 0.5}};
  const geom::Box plot = layout(picture, {900.0, 700.0}, views, text_measure, {Plots::FillPage}).panels[0].plot;
  for (int i = 0; i < 20; ++i) {
    views[0] = pan(*views[0], {7.0, -3.0});
    EXPECT_EQ(layout(picture, {900.0, 700.0}, views, text_measure, {Plots::FillPage}).panels[0].plot, plot) << i;
  }
}

TEST(Layout, PicturesWithoutContentAreLaidOutToo) {
  const Picture none;
  EXPECT_TRUE(laid_out(none).panels.empty());
  Picture blank{"", {Panel{"a", "Blank"}}, Arrangement::Row};
  expect_tidy(laid_out(blank), "blank");
  blank.panels[0].layers.push_back({"m", "one point", Style{}, Markers{{{1e6, -1e6}}, {}}});
  expect_tidy(laid_out(blank), "point");
}

TEST(Layout, LabelsThatHaveNoRoomAreLeftOut) {
  Picture picture{"", {Panel{"a", "Labels"}}, Arrangement::Row};
  Labels labels;
  for (int i = 0; i < 2000; ++i) labels.labels.push_back({{i % 50 * 1.0, i / 50 * 1.0}, "label " + std::to_string(i)});
  picture.panels[0].layers.push_back({"l", "labels", Style{}, labels});
  const Layout made = laid_out(picture);
  expect_tidy(made, "labels");
  EXPECT_GT(texts_of(made).size(), 100U);
  EXPECT_LT(texts_of(made).size(), 2000U);
}

TEST(Layout, ExtentIsThatOfTheVisibleLayersOrAsGiven) {
  Panel panel = test::example_section().panels[1];
  EXPECT_EQ(extent(panel), (geom::Box{{0.0, -300.0}, {1000.0, 0.0}}));
  for (Layer& layer : panel.layers) layer.visible = false;
  EXPECT_TRUE(extent(panel).empty());
  panel.extent = geom::Box{{1.0, 2.0}, {3.0, 4.0}};
  EXPECT_EQ(extent(panel), *panel.extent);
}

TEST(Layout, NamesBesideTheEndsOfLinesHaveRoomAndStandBelowEachOther) {
  for (const char* const name : {"A", "a horizon with a long name"}) {
    Picture picture{"", {Panel{"a", "Names"}}, Arrangement::Row};
    Panel& panel = picture.panels[0];
    for (int i = 5; i-- > 0;) {  // the last layer, the highest line, chooses first
      const double z = -0.5 * i;
      const std::string text = name + std::to_string(i);
      panel.layers.push_back({"line" + text, text, Style{}, Lines{{{{{0.0, z}, {1000.0, z}}, false}}, {}}});
      panel.layers.push_back({"name" + text, text, Style{}, Labels{{{{1000.0, z}, text, Anchor::Right}}}});
    }
    // On a page, and in a window whose view is the whole panel.
    for (const Layout& made :
         {laid_out(picture), layout(picture, {900.0, 700.0}, {}, text_measure, {Plots::FillPage})}) {
      expect_tidy(made, name);
      std::vector<double> heights;
      const double end = made.panels[0].transform.to_page({1000.0, 0.0}).x;
      for (int i = 0; i < 5; ++i) {
        for (const TextMark* text : texts_of(made)) {
          if (text->text != name + std::to_string(i) || text->at.x < end) continue;
          EXPECT_GE(text->at.x - 0.5 * text->size.width, end);
          EXPECT_LE(text->at.x + 0.5 * text->size.width, made.panels[0].plot.high.x);
          heights.push_back(text->at.y);
        }
      }
      ASSERT_EQ(heights.size(), 5u) << name;
      EXPECT_TRUE(std::is_sorted(heights.begin(), heights.end())) << name;
    }
  }
}

/// Panels with a mesh, each with colours of its own.
Picture sheet(std::size_t count, double width, double height) {
  Picture picture{"", {}, Arrangement::Grid};
  for (std::size_t i = 0; i < count; ++i) {
    Panel panel{"p" + std::to_string(i), "load: Displacement along x, displacements \u00d7 5000; eta 1.2 %", {}, {}};
    Mesh mesh{
        {{0, 0}, {width, 0}, {width, height}, {0, height}}, {{0, 1, 2}, {0, 2, 3}}, ValuesAt::Points, {0, 1, 2, 3}, {}};
    mesh.scale = {
        .title = "field " + std::to_string(i) + " [Pa]", .low = 0.0, .high = 2.0, .least = 0.0, .greatest = 3.0};
    panel.layers.push_back({"mesh", "", Style{}, mesh, true, InLegend::No});
    panel.layers.push_back({"edge", "Boundary", Style{}, Lines{{{mesh.points, true}}, {}}});
    picture.panels.push_back(panel);
  }
  return picture;
}

TEST(Layout, AGridMakesThePanelsAsLargeAsThePageAllows) {
  for (const std::size_t count : {2U, 3U, 4U, 6U}) {
    for (const auto& [width, height] :
         {std::pair{10.0, 4.0}, std::pair{1.0, 3.0}, std::pair{5.0, 5.0}, std::pair{100.0, 1.0}}) {
      Picture picture = sheet(count, width, height);
      const Layout made = laid_out(picture);
      expect_tidy(made, std::to_string(count) + " panels of " + std::to_string(width / height));
      for (const Arrangement other : {Arrangement::Row, Arrangement::Column}) {
        picture.arrangement = other;
        const Layout fixed = laid_out(picture);
        if (fixed.page.height > 1.4 * 720.0 + 1.0 || fixed.page.width > 720.5) continue;  // it does not fit
        EXPECT_GE(made.panels[0].transform.points_per_x, 0.97 * fixed.panels[0].transform.points_per_x)
            << count << ' ' << width / height;
      }
    }
  }
}

TEST(Layout, ThreeWidePanelsAreStacked) {
  const Layout made = laid_out(sheet(3, 10.0, 4.0));
  EXPECT_GT(made.panels[0].plot.width(), 300.0);
  EXPECT_LT(made.panels[0].plot.high.y, made.panels[1].plot.low.y);
  EXPECT_LT(made.panels[1].plot.high.y, made.panels[2].plot.low.y);
}

TEST(Layout, ABarOfOnePanelStandsBesideThatPanel) {
  for (const std::size_t count : {2U, 3U, 4U}) {
    for (const Plots plots : {Plots::ToContent, Plots::FillPage}) {
      const Picture picture = sheet(count, 10.0, 4.0);
      const Layout made =
          plots == Plots::ToContent ? laid_out(picture) : layout(picture, {1600.0, 1000.0}, {}, text_measure, {plots});
      std::size_t i = 0;
      for (const Mark& mark : made.marks) {
        const auto* bar = std::get_if<GradientMark>(&mark);
        if (bar == nullptr) continue;
        ASSERT_LT(i, made.panels.size());
        const geom::Box& plot = made.panels[i++].plot;
        EXPECT_GT(bar->box.low.x, plot.high.x);
        EXPECT_LT(bar->box.low.x, plot.high.x + 120.0);
        EXPECT_NEAR(bar->box.low.y, plot.low.y, 1.0);
      }
      EXPECT_EQ(i, count);
    }
  }
}

/// A bar with its numbers is some 110 points wide, the numbers of an axis 50: a row of the page has room for one plot
/// with them from 230 points on, and rows of 180 are high enough.
TEST(Layout, BarsOfThreePanelsStayInAWindowThatHasRoomForThemInFewerColumns) {
  for (const double width : {260.0, 320.0, 390.0, 460.0, 560.0, 700.0, 900.0}) {
    for (const double height : {640.0, 800.0, 1100.0}) {
      for (const auto& [wide, high] : {std::pair{1.0, 3.0}, std::pair{5.0, 5.0}, std::pair{10.0, 4.0}}) {
        const Layout made = layout(sheet(3, wide, high), {width, height}, {}, text_measure, {Plots::FillPage});
        const auto bars = std::count_if(made.marks.begin(), made.marks.end(),
                                        [](const Mark& mark) { return std::holds_alternative<GradientMark>(mark); });
        EXPECT_EQ(bars, 3) << width << " x " << height << ", panels of " << wide << " x " << high;
        expect_tidy(made, std::to_string(width) + " x " + std::to_string(height));
      }
    }
  }
}

/// Two rows of titles, plots and axes want some 300 points: in a low window three plots stand in one row.
TEST(Layout, ThreePanelsStandInOneRowWhereTheWindowIsTooLowForTwo) {
  Picture picture = sheet(3, 24.0, 16.0);
  for (const double width : {390.0, 480.0, 640.0}) {
    const Layout made = layout(picture, {width, 240.0}, {}, text_measure, {Plots::FillPage});
    for (const PanelLayout& panel : made.panels) {
      EXPECT_EQ(panel.plot.low.y, made.panels.front().plot.low.y) << width;
      EXPECT_LT(panel.plot.high.y + 25.0, 240.0) << width;  // numbers and name of the axis
      EXPECT_LE(panel.plot.high.x, width);
    }
  }
}

/// Nothing that is drawn can stand beside a plot where the window is narrower than a bar.
TEST(Layout, BarsGoWhereTheWindowIsTooNarrowForAPlotBesideThem) {
  const Layout made = layout(sheet(3, 5.0, 5.0), {120.0, 900.0}, {}, text_measure, {Plots::FillPage});
  EXPECT_TRUE(std::none_of(made.marks.begin(), made.marks.end(),
                           [](const Mark& mark) { return std::holds_alternative<GradientMark>(mark); }));
}

TEST(Layout, PanelsOfAGridStayWhereTheyAreWhileAViewMoves) {
  const Picture picture = sheet(3, 10.0, 4.0);
  const Layout whole = layout(picture, {1200.0, 800.0}, {}, text_measure, {Plots::FillPage});
  std::vector<std::optional<View>> views;
  for (const PanelLayout& panel : whole.panels) views.emplace_back(zoom_at(panel.view, {1.0, 1.0}, 37.0));
  const Layout near = layout(picture, {1200.0, 800.0}, views, text_measure, {Plots::FillPage});
  for (std::size_t i = 0; i < 3; ++i) EXPECT_LT(distance(near.panels[i].plot.low, whole.panels[i].plot.low), 60.0) << i;
}

TEST(Layout, ADiagramHasNoScaleBar) {
  Picture picture{"", {Panel{"a", "Bars", {"alpha", "share", AxisScale::Diagram}}}};
  picture.panels[0].layers.push_back({"l", "mean", Style{}, Lines{{{{{0, 0}, {1, 1}}, false}}, {}}});
  const auto texts = [&] { return texts_of(laid_out(picture)).size(); };
  const std::size_t without = texts();
  picture.panels[0].axes.scale = AxisScale::Linear;
  EXPECT_EQ(texts(), without + 1);
}

}  // namespace
}  // namespace dobra::scene
