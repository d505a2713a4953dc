// The sheet of a section: a page of one format, on which the section is the main thing.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>
#include <set>

#include "shared/scene/layout.h"

namespace dobra::scene {
namespace {

const TextMeasure measure = approximate_text_measure();
constexpr double points_per_metre = 72.0 / 0.0254;

/// Before and after, `length` by `height` m, with beds and their names, units and two tables.
Picture section(double length, double height, int beds, std::size_t rows) {
  Picture picture;
  picture.title = "A section";
  picture.paper = Paper::A4Landscape;
  picture.arrangement = length > 2.0 * height ? Arrangement::Column : Arrangement::Row;
  for (const char* const key : {"before", "after"}) {
    Panel panel{key, key};
    panel.left_end = "WSW";
    panel.right_end = "ENE";
    for (int i = 0; i < beds; ++i) {
      const double z = -height * i / beds;
      const std::string name = "bed " + std::to_string(i);
      panel.layers.push_back(
          {"line" + name, name, Style{}, Lines{{{{{0.0, z}, {length, z - height / beds}}, false}}, {}}});
      panel.layers.push_back(
          {"name" + name, name, Style{}, Labels{{{{length, z - height / beds}, name, Anchor::Right}}}});
      panel.layers.push_back({"unit" + name, "unit " + std::to_string(i), Style{.fill = Color{200, 200, 200}},
                              Regions{{{{{{{0.0, z}, {length, z}, {length, z - 1.0}}, true}}}}, {}}});
    }
    picture.panels.push_back(std::move(panel));
  }
  for (const char* const title : {"Beds", "Units"}) {
    TextTable table{title, {"name", "before [m]", "after [m]", "change [%]"}, {}};
    for (std::size_t i = 0; i < rows; ++i)
      table.rows.push_back({std::string(title) + std::to_string(i), "12345.6", "12345.6", "0.00"});
    picture.tables.push_back(std::move(table));
  }
  picture.notes = {"Flexural slip keeps bed lengths and areas.", "Verdict: balanced."};
  return picture;
}

Layout sheet(const Picture& picture, double width = a4_landscape.width) {
  return layout(picture, suggested_page(picture, width, measure), {}, measure);
}

std::vector<const TextMark*> texts_of(const Layout& made) {
  std::vector<const TextMark*> texts;
  for (const Mark& mark : made.marks) {
    if (const auto* text = std::get_if<TextMark>(&mark)) texts.push_back(text);
  }
  return texts;
}

std::size_t count(const Layout& made, const std::string& wanted) {
  std::size_t found = 0;
  for (const TextMark* text : texts_of(made)) found += text->text == wanted ? 1 : 0;
  return found;
}

void expect_no_text_on_another(const Layout& made, const std::string& what) {
  const auto texts = texts_of(made);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const geom::Box box = box_of(Mark{*texts[i]}).grown(-0.01);
    EXPECT_GE(box.low.x, 0.0) << what << texts[i]->text;
    EXPECT_GE(box.low.y, 0.0) << what << texts[i]->text;
    EXPECT_LE(box.high.x, made.page.width) << what << texts[i]->text;
    EXPECT_LE(box.high.y, made.page.height) << what << texts[i]->text;
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_FALSE(box.overlaps(box_of(Mark{*texts[k]}).grown(-0.01)))
          << what << ": '" << texts[i]->text << "' and '" << texts[k]->text << "'";
  }
}

/// The part of the page's width or height, whichever is more, that the plots take.
double share(const Layout& made) {
  const bool row = made.panels[0].plot.low.x < made.panels[1].plot.low.x - 1.0;
  double width = 0.0;
  double height = 0.0;
  for (const PanelLayout& panel : made.panels) {
    width = row ? width + panel.plot.width() : std::max(width, panel.plot.width());
    height = row ? std::max(height, panel.plot.height()) : height + panel.plot.height();
  }
  return std::max(width / made.page.width, height / made.page.height);
}

TEST(Sheet, TheSectionIsTheMainThingHoweverManyRowsAndEntries) {
  for (const auto& [length, height] : {std::pair(1000.0, 800.0), {5000.0, 1500.0}, {90000.0, 6000.0}, {6.0, 4.0}}) {
    for (const int beds : {3, 30, 120}) {
      for (const std::size_t rows : {3U, 60U, 700U}) {
        const Picture picture = section(length, height, beds, rows);
        const Layout made = sheet(picture);
        const std::string what =
            std::to_string(length) + " m, " + std::to_string(beds) + " beds, " + std::to_string(rows) + " rows";
        EXPECT_DOUBLE_EQ(made.page.width, a4_landscape.width) << what;
        EXPECT_LE(made.page.height, a4_landscape.height) << what;
        EXPECT_GE(share(made), 0.36) << what;
        expect_no_text_on_another(made, what);
      }
    }
  }
}

TEST(Sheet, TheScaleIsRoundAndStated) {
  for (const double length : {3.7, 1000.0, 4321.0, 123456.0}) {
    const Layout made = sheet(section(length, 0.3 * length, 4, 4));
    const double n = points_per_metre / made.panels[0].transform.points_per_x;
    const double decade = std::pow(10.0, std::floor(std::log10(n) + 1e-9));
    double nearest = 1.0;
    for (const double factor : {1.0, 1.25, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 7.5, 10.0})
      nearest = std::min(nearest, std::abs(n / decade / factor - 1.0));
    EXPECT_LT(nearest, 1e-9) << n;
    std::string digits;
    for (const TextMark* text : texts_of(made)) {
      const std::size_t at = text->text.find("1:");
      if (at == std::string::npos) continue;
      for (const char c : text->text.substr(at + 2)) digits += c >= '0' && c <= '9' ? std::string(1, c) : "";
    }
    EXPECT_NEAR(std::stod(digits), n, 1e-6 * n) << length;
  }
}

TEST(Sheet, RoundRatiosAreNotLargerThanWhatFits) {
  for (double scale = 1e-6; scale < 1e5; scale *= 1.07) {
    const double n = round_ratio(scale);
    EXPECT_GE(n * (1.0 + 1e-8), points_per_metre / scale);
    EXPECT_LE(n, 1.34 * points_per_metre / scale);
  }
}

TEST(Sheet, PiecesOfOneUnitHaveOneEntryInTheLegend) {
  Picture picture = section(5000.0, 1500.0, 3, 2);
  for (Panel& panel : picture.panels) {
    for (Layer& layer : panel.layers) {
      if (std::holds_alternative<Regions>(layer.content)) layer.legend = "K2p";
    }
  }
  const Layout made = sheet(picture);
  EXPECT_EQ(count(made, "K2p"), 1U);
  EXPECT_EQ(count(made, "unit 0"), 0U);
}

TEST(Sheet, ALongLegendIsCutAndSaysHowManyAreLeftOut) {
  const Layout made = sheet(section(5000.0, 1500.0, 300, 2));
  std::size_t left_out = 0;
  std::set<std::string> units;
  for (const TextMark* text : texts_of(made)) {
    if (text->text.starts_with("... ")) left_out = std::stoul(text->text.substr(4));
    if (text->text.starts_with("unit ")) units.insert(text->text);
  }
  EXPECT_GT(units.size(), 20U);
  EXPECT_GT(left_out, 0U);
  EXPECT_LT(left_out, 600U);
}

TEST(Sheet, TablesThatDoNotFitGoToFurtherPagesWholeAndOnce) {
  for (const std::size_t rows : {3U, 60U, 700U}) {
    const Picture picture = section(5000.0, 1500.0, 6, rows);
    LayoutOptions options;
    options.long_tables = LongTables::NextPages;
    const Layout first = layout(picture, a4_landscape, {}, measure, options);
    EXPECT_EQ(first.tables_on_next_pages, rows > 10);
    EXPECT_EQ(count(first, "Units0"), rows > 10 ? 0U : 1U);
    if (!first.tables_on_next_pages) continue;
    std::set<std::string> seen;
    std::size_t shown = 0;
    for (const Layout& page : table_pages(picture, a4_landscape, measure, options)) {
      EXPECT_EQ(page.page.height, a4_landscape.height);
      expect_no_text_on_another(page, "page of tables");
      for (const TextMark* text : texts_of(page)) {
        const bool row = text->text.size() > 4 && std::isdigit(static_cast<unsigned char>(text->text.back())) != 0 &&
                         (text->text.starts_with("Beds") || text->text.starts_with("Units"));
        if (row) seen.insert(text->text);
        shown += row ? 1 : 0;
      }
    }
    EXPECT_EQ(seen.size(), 2 * rows);
    EXPECT_EQ(shown, 2 * rows);
  }
}

TEST(Sheet, LettersStandOverTheEndsOfTheSection) {
  const Layout made = sheet(section(5000.0, 1500.0, 4, 2));
  std::size_t over = 0;
  for (const TextMark* text : texts_of(made)) {
    for (const PanelLayout& panel : made.panels) {
      const geom::Box box = box_of(Mark{*text});
      if (text->text == "WSW") over += std::abs(box.low.x - panel.plot.low.x) < 1.0 && box.high.y < panel.plot.low.y;
      if (text->text == "ENE") over += std::abs(box.high.x - panel.plot.high.x) < 1.0 && box.high.y < panel.plot.low.y;
    }
  }
  EXPECT_GE(over, 4U);
  Picture unknown = section(5000.0, 1500.0, 4, 2);
  for (Panel& panel : unknown.panels) panel.left_end = panel.right_end = "";
  EXPECT_EQ(count(sheet(unknown), "WSW"), 0U);
}

TEST(Sheet, KilometresStandOnTheAxesAndTheScaleBarOfALongSection) {
  Picture picture = section(90000.0, 9000.0, 4, 2);
  for (Panel& panel : picture.panels) {
    panel.axes = {"x [km]", "z [km]"};
    panel.axes.unit = 1000.0;
  }
  const Layout made = sheet(picture);
  EXPECT_GE(count(made, "20"), 2U);
  EXPECT_EQ(count(made, "20000"), 0U);
  for (const TextMark* text : texts_of(made)) {
    if (text->text != "20" || text->at.y < made.panels[0].plot.high.y || text->at.y > made.panels[1].plot.low.y)
      continue;
    EXPECT_NEAR(text->at.x, made.panels[0].transform.to_page({20000.0, 0.0}).x, 1e-6);
  }
  const auto has = [&](const std::string& part) {
    for (const TextMark* text : texts_of(made)) {
      if (text->text.find(part) != std::string::npos) return true;
    }
    return false;
  };
  EXPECT_TRUE(has(" km   1:"));
}

TEST(Sheet, MovedNamesHaveALineToTheirEnd) {
  const Layout made = sheet(section(5000.0, 40.0, 6, 2));  // the beds end within a few points
  const double end = made.panels[0].transform.to_page({5000.0, 0.0}).x;
  std::size_t leaders = 0;
  for (const Mark& mark : made.marks) {
    const auto* line = std::get_if<LineMark>(&mark);
    if (line == nullptr || line->width != 0.5) continue;
    EXPECT_NEAR(line->from.x, end, 1e-6);
    ++leaders;
  }
  EXPECT_GE(leaders, 4U);
}

TEST(Sheet, ALegendOfSixtyEntriesIsSetSmallAndHoldsAllInASixthOfThePage) {
  Picture picture = section(6000.0, 2000.0, 60, 3);
  for (Panel& panel : picture.panels) {
    for (Layer& layer : panel.layers) {
      if (!std::holds_alternative<Regions>(layer.content)) layer.in_legend = InLegend::No;
      layer.legend = "Formation " + layer.title.substr(layer.title.rfind(' ') + 1);
    }
  }
  const Layout made = sheet(picture);
  double top = made.page.height;
  double bottom = 0.0;
  std::size_t entries = 0;
  for (const TextMark* text : texts_of(made)) {
    EXPECT_FALSE(text->text.starts_with("... ")) << text->text;
    if (!text->text.starts_with("Formation ")) continue;
    ++entries;
    top = std::min(top, box_of(Mark{*text}).low.y);
    bottom = std::max(bottom, box_of(Mark{*text}).high.y);
  }
  EXPECT_EQ(entries, 60U);
  EXPECT_LT(bottom - top, made.page.height / 5.0);
  expect_no_text_on_another(made, "sixty entries");
}

TEST(Sheet, PanelsStandOverEachOtherWhereThatMakesThemClearlyLarger) {
  const auto plots_of = [](double length, double height, Arrangement asked) {
    Picture picture = section(length, height, 6, 3);
    picture.arrangement = asked;
    picture.tables.clear();
    return sheet(picture).panels;
  };
  const auto beside = [](const std::vector<PanelLayout>& panels) {
    return panels[0].plot.low.y == panels[1].plot.low.y && panels[0].plot.high.x < panels[1].plot.low.x;
  };
  for (const Arrangement asked : {Arrangement::Row, Arrangement::Column}) {
    EXPECT_FALSE(beside(plots_of(6000.0, 1500.0, asked)));  // long and low
    EXPECT_TRUE(beside(plots_of(1000.0, 1500.0, asked)));   // high
  }
  // Where it makes little difference, as asked.
  bool as_asked = false;
  for (double height = 1500.0; height < 6000.0; height *= 1.05) {
    const bool row = beside(plots_of(6000.0, height, Arrangement::Row));
    const bool column = !beside(plots_of(6000.0, height, Arrangement::Column));
    EXPECT_TRUE(row || column) << height;
    as_asked = as_asked || (row && column);
  }
  EXPECT_TRUE(as_asked);
}

}  // namespace
}  // namespace dobra::scene
