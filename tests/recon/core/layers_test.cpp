#include "recon/core/layers.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "recon/core/operations.h"
#include "shared/scene/layout.h"
#include "tests/recon/core/shapes.h"

namespace recon::core {
namespace {

namespace scene = dobra::scene;

Model restored_model() {
  const geom::Polyline top = test::arc(1000.0);
  Model model;
  model.section = test::section_of({top, test::parallel(top, 50.0), test::parallel(top, 55.0)});
  GridParams grid;
  grid.count = 4;
  model = run_grid(model, grid, {}, {}).value();
  model = run_target(model, {}, {}, {}).value();
  return run_restore(model, {}, {}, {}).value();
}

const scene::Layer* find(const scene::Panel& panel, const std::string& key) {
  for (const scene::Layer& layer : panel.layers) {
    if (layer.key == key) return &layer;
  }
  return nullptr;
}

TEST(Layers, REC_j_TheDeformedAndTheRestoredSectionStandSideBySideWithTheirGrids) {
  const scene::Picture picture = picture_of(restored_model());
  ASSERT_EQ(picture.panels.size(), 2u);
  EXPECT_EQ(picture.arrangement, scene::Arrangement::Row);
  EXPECT_EQ(picture.panels[0].title, "Deformed section");
  EXPECT_EQ(picture.panels[1].title, "Restored section");
  for (const scene::Panel& panel : picture.panels) {
    EXPECT_EQ(panel.axes.x_title, "x [m]");
    EXPECT_EQ(panel.axes.y_title, "z [m]");
    EXPECT_NE(find(panel, "pin"), nullptr);
    EXPECT_EQ(panel.vertical_exaggeration, 1.0);
  }
  ASSERT_NE(find(picture.panels[0], "source_grid"), nullptr);
  EXPECT_EQ(std::get<scene::Lines>(find(picture.panels[0], "source_grid")->content).lines.size(), 4u);
  ASSERT_NE(find(picture.panels[1], "target_grid"), nullptr);
}

TEST(Layers, AHorizonHasTheSameColourAndIdInBothPanelsAndADifferentOneFromItsNeighbours) {
  const scene::Picture picture = picture_of(restored_model());
  for (std::size_t h = 0; h < 3; ++h) {
    const std::string key = "horizon_" + std::to_string(h);
    const scene::Layer* before = find(picture.panels[0], key);
    const scene::Layer* after = find(picture.panels[1], key);
    ASSERT_TRUE(before != nullptr && after != nullptr);
    EXPECT_EQ(before->style.line, after->style.line);
    EXPECT_EQ(std::get<scene::Lines>(before->content).ids, std::get<scene::Lines>(after->content).ids);
    EXPECT_NE(before->style.line, horizon_color(HorizonId(h + 1)));
    EXPECT_EQ(before->in_legend, scene::InLegend::Yes);
    EXPECT_EQ(after->in_legend, scene::InLegend::No);
  }
}

TEST(Layers, KeysAreUniqueInEachPanel) {
  for (const scene::Panel& panel : picture_of(restored_model()).panels) {
    std::set<std::string> keys;
    for (const scene::Layer& layer : panel.layers) EXPECT_TRUE(keys.insert(layer.key).second) << layer.key;
  }
}

TEST(Layers, NamesOfNearHorizonsAreMovedApart) {
  const scene::Picture picture = picture_of(restored_model());
  const scene::TextMeasure measure = scene::approximate_text_measure();
  const scene::Layout made = scene::layout(picture, scene::suggested_page(picture, 720.0, measure), {}, measure);
  for (std::size_t k = 0; k < picture.panels.size(); ++k) {
    std::vector<scene::TextMark> names;  // from the top down
    for (const char* const name : {"top", "bed1", "bed2"}) {
      for (const scene::Mark& mark : made.marks) {
        const auto* text = std::get_if<scene::TextMark>(&mark);
        if (text != nullptr && text->text == name && made.panels[k].plot.contains(text->at)) names.push_back(*text);
      }
    }
    ASSERT_EQ(names.size(), 3u);
    for (std::size_t i = 1; i < names.size(); ++i)  // the beds are only 5 m apart
      EXPECT_GE(names[i].at.y - names[i - 1].at.y, names[i].size.height());
  }
}

TEST(Layers, PiecesOfAHorizonAreOneLayerWithOneName) {
  Model model;
  model.section =
      test::section_of({{{{0, 0}, {10, 0}}, false}, {{{0, -2}, {4, -2}}, false}, {{{6, -3}, {10, -3}}, false}});
  model.section.horizons[1].piece_of = model.section.horizons[2].piece_of = "bed";
  const scene::Panel panel = picture_of(model).panels.at(0);
  const scene::Layer* bed = find(panel, "horizon_1");
  ASSERT_NE(bed, nullptr);
  EXPECT_EQ(bed->title, "bed");
  EXPECT_EQ(std::get<scene::Lines>(bed->content).lines.size(), 2u);
  EXPECT_EQ(std::get<scene::Lines>(bed->content).ids, (std::vector<std::uint32_t>{1, 2}));
  EXPECT_EQ(find(panel, "horizon_2"), nullptr);
  const scene::Layer* name = find(panel, "name_1");
  ASSERT_NE(name, nullptr);
  EXPECT_EQ(std::get<scene::Labels>(name->content).labels.at(0).at, (geom::Point{10, -3}));
}

TEST(Layers, NumbersOfTheSheetHaveFiveFiguresAndNoExponent) {
  const scene::Picture picture = picture_of(restored_model());  // about 1570 m long, 80 000 and 8000 m2
  ASSERT_EQ(picture.tables.size(), 2u);
  EXPECT_EQ(picture.tables[0].rows[0][1], "1570.8");
  EXPECT_EQ(picture.tables[0].rows[0][3], "0.00");  // the top keeps its length, without a sign
  for (const scene::TextTable& table : picture.tables) {
    for (const auto& row : table.rows) {
      for (std::size_t i = 1; i < row.size(); ++i) EXPECT_EQ(row[i].find('e'), std::string::npos) << row[i];
    }
  }
  EXPECT_EQ(picture.tables[1].rows[0][1].find('.'), std::string::npos) << picture.tables[1].rows[0][1];
}

TEST(Layers, ALongLowSectionStandsOverItsRestoration) {
  Model model;
  model.section =
      test::section_of({{{{0, 0}, {5000, 90}, {9000, 0}}, false}, {{{0, -80}, {5000, 0}, {9000, -80}}, false}});
  model = run_target(run_grid(model, {}, {}, {}).value(), {}, {}, {}).value();
  EXPECT_EQ(picture_of(model).arrangement, scene::Arrangement::Column);
}

TEST(Layers, BeforeTheTargetThereIsOnePanel) {
  Model model;
  model.section = test::section_of({test::arc()});
  EXPECT_EQ(picture_of(model).panels.size(), 1u);
}

}  // namespace
}  // namespace recon::core
