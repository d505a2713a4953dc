// The pictures of sections, as the operations draw them.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "recon/core/faults_step.h"
#include "recon/core/grid_step.h"
#include "recon/core/operations.h"
#include "recon/core/restore_step.h"
#include "recon/core/target_step.h"
#include "recon/section/palette.h"
#include "shared/scene/layout.h"
#include "tests/recon/faults/sections.h"
#include "tests/recon/shapes.h"

namespace recon::core {
namespace {

namespace scene = dobra::scene;

scene::Picture picture_of(const model::Model& model) {
  return program().picture_of(dobra::scenario::make_state(model));
}

model::Model restored_model(double depth = 50.0) {
  const geom::Polyline top = test::arc(1000.0);
  model::Model model;
  model.section = test::section_of({top, test::parallel(top, depth), test::parallel(top, depth + 5.0)});
  unfold::GridParams grid;
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

TEST(Layers, REC_j_TheDeformedAndTheRestoredSectionStandOnOneSheetWithTheirGrids) {
  const scene::Picture picture = picture_of(restored_model());
  ASSERT_EQ(picture.panels.size(), 2u);
  EXPECT_EQ(picture.paper, scene::Paper::A4Landscape);
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
  const model::Model model = restored_model();
  const scene::Picture picture = picture_of(model);
  for (std::size_t h = 0; h < 3; ++h) {
    const std::string key = "horizon_" + std::to_string(h);
    const scene::Layer* before = find(picture.panels[0], key);
    const scene::Layer* after = find(picture.panels[1], key);
    ASSERT_TRUE(before != nullptr && after != nullptr);
    EXPECT_EQ(before->style.line, after->style.line);
    EXPECT_EQ(std::get<scene::Lines>(before->content).ids, std::get<scene::Lines>(after->content).ids);
    const section::Palette palette(model.section);
    EXPECT_EQ(before->style.line, palette.of(model.section.horizons[h].name).line);
    EXPECT_NE(before->style.line, palette.of(model.section.horizons[(h + 1) % 3].name).line);
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
  model::Model model;
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

TEST(Layers, NamesOfOverturnedBedsStandClearOfTheirLines) {
  const std::vector<geom::Polyline> lines{
      {{{0, 500}, {400, 560}, {700, 850}, {720, 950}, {660, 1000}, {500, 930}, {300, 890}}, false},  // comes back
      {{{0, 250}, {700, 350}, {900, 600}, {960, 900}, {950, 1100}}, false},                          // steep
      {{{0, 150}, {1000, 300}, {1100, 280}}, false}};
  model::Model model;
  model.section = test::section_of({lines[0], lines[1], lines[2]});
  const scene::Panel panel = picture_of(model).panels.at(0);
  const scene::Anchor sides[] = {scene::Anchor::Left, scene::Anchor::Right, scene::Anchor::Right};
  for (std::size_t i = 0; i < 3; ++i) {
    const scene::Layer* name = find(panel, "name_" + std::to_string(i));
    ASSERT_NE(name, nullptr);
    const scene::Label& label = std::get<scene::Labels>(name->content).labels.at(0);
    EXPECT_EQ(label.anchor, sides[i]) << i;
    // No point of the line stands where a word of 150 m by 30 m would, a little aside of the end.
    const double sign = label.anchor == scene::Anchor::Left ? -1.0 : 1.0;
    for (std::size_t k = 1; k < lines[i].points.size(); ++k) {
      for (int part = 0; part < 20; ++part) {
        const geom::Point a = lines[i].points[k - 1], b = lines[i].points[k];
        const geom::Vector off = a + part / 20.0 * (b - a) - label.at;
        EXPECT_FALSE(sign * off.x > 5.0 && sign * off.x < 150.0 && std::abs(off.y) < 15.0) << i << " " << k;
      }
    }
  }
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
  model::Model model;
  model.section =
      test::section_of({{{{0, 0}, {5000, 90}, {9000, 0}}, false}, {{{0, -80}, {5000, 0}, {9000, -80}}, false}});
  model = run_target(run_grid(model, {}, {}, {}).value(), {}, {}, {}).value();
  EXPECT_EQ(picture_of(model).arrangement, scene::Arrangement::Column);
}

TEST(Layers, AThickSectionStandsBesideItsRestoration) {
  EXPECT_EQ(picture_of(restored_model(700.0)).arrangement, scene::Arrangement::Row);
  EXPECT_EQ(picture_of(restored_model()).arrangement, scene::Arrangement::Column);
}

TEST(Layers, BeforeTheTargetThereIsOnePanel) {
  model::Model model;
  model.section = test::section_of({test::arc()});
  EXPECT_EQ(picture_of(model).panels.size(), 1u);
}

/// `count` beds of 10 km, each in three pieces.
section::Section pieces_of_beds(int count) {
  std::vector<geom::Polyline> lines;
  for (int i = 0; i < count; ++i) {
    for (int k = 0; k < 3; ++k) lines.push_back({{{4000.0 * k, -50.0 * i}, {4000.0 * k + 3500.0, -50.0 * i}}, false});
  }
  section::Section section = test::section_of(lines);
  for (std::size_t i = 0; i < section.horizons.size(); ++i)
    section.horizons[i].piece_of = "bed" + std::to_string(i / 3);
  return section;
}

TEST(Layers, ThirtyBedsInPiecesHaveThirtyColours) {
  model::Model model;
  model.section = pieces_of_beds(30);
  std::map<std::array<int, 3>, std::string> colors;
  const scene::Picture picture = picture_of(model);
  for (const scene::Layer& layer : picture.panels[0].layers) {
    if (!layer.key.starts_with("horizon_")) continue;
    const std::array<int, 3> color{layer.style.line.red, layer.style.line.green, layer.style.line.blue};
    EXPECT_TRUE(colors.emplace(color, layer.title).second) << layer.title << " and " << colors.at(color);
  }
  EXPECT_EQ(colors.size(), 30u);
}

TEST(Layers, ALongSectionHasKilometresOnItsAxes) {
  model::Model model;
  model.section = pieces_of_beds(2);
  const scene::Axes axes = picture_of(model).panels[0].axes;
  EXPECT_EQ(axes.x_title, "x [km]");
  EXPECT_EQ(axes.y_title, "z [km]");
  EXPECT_EQ(axes.unit, 1000.0);
}

TEST(Layers, PolygonsHaveTheColourOfTheirUnitAndPiecesShareIt) {
  model::Model model;
  for (const char* const name : {"K2p_1", "J3b", "K2p_2", "T1"}) {
    const double x = 10.0 * static_cast<double>(model.section.units.size());
    model.section.units.push_back(
        {section::UnitId(model.section.units.size()), name, {{{x, 0}, {x + 9, 0}, {x + 9, 5}, {x, 5}}, true}, {}});
  }
  const scene::Panel panel = picture_of(model).panels[0];
  const auto fill = [&](int i) { return find(panel, "unit_" + std::to_string(i))->style.fill; };
  EXPECT_EQ(fill(0), fill(2));
  EXPECT_EQ(find(panel, "unit_0")->legend, "K2p");
  EXPECT_EQ(find(panel, "unit_2")->legend, "K2p");
  EXPECT_NE(fill(0), fill(1));
  EXPECT_NE(fill(0), fill(3));
  EXPECT_NE(fill(1), fill(3));
}

TEST(Layers, PolygonsThatSayTheirUnitAreItsPiecesWhateverTheirNames) {
  model::Model model;
  for (const char* const whole : {"J2", "J1", "J2", ""}) {
    const std::size_t i = model.section.units.size();
    const double x = 10.0 * static_cast<double>(i);
    const geom::Polyline square{{{x, 0}, {x + 9, 0}, {x + 9, 5}, {x, 5}}, true};
    model.section.units.push_back({section::UnitId(i), "feature " + std::to_string(i), square, {}, whole});
  }
  const scene::Panel panel = picture_of(model).panels[0];
  const auto unit = [&](int i) { return find(panel, "unit_" + std::to_string(i)); };
  EXPECT_EQ(unit(0)->style.fill, unit(2)->style.fill);
  EXPECT_EQ(unit(0)->legend, "J2");
  EXPECT_EQ(unit(2)->legend, "J2");
  EXPECT_NE(unit(0)->style.fill, unit(1)->style.fill);
  EXPECT_EQ(unit(3)->legend, "feature 3");
}

TEST(Layers, AnEllipseBeyondMeasureIsCutOffAndTold) {
  model::Model model = restored_model();
  maps::Strain extreme = model.restoration->ledger.strains.at(0);
  extreme.greatest = 414.0;
  extreme.at = {12.5, -3.0};
  const std::size_t notes = picture_of(model).notes.size();
  model.restoration->ledger.strains.push_back(extreme);
  const scene::Picture picture = picture_of(model);
  const auto& ellipses = std::get<scene::Lines>(find(picture.panels[0], "ellipses")->content).lines;
  EXPECT_LT(ellipses.back().box().diagonal(), 0.15 * box_of(model.section).diagonal());
  ASSERT_EQ(picture.notes.size(), notes + 1);
  EXPECT_NE(picture.notes.back().find("414, (12.5, -3)"), std::string::npos) << picture.notes.back();
}

TEST(Layers, AGridThatGoesAstrayDoesNotMakeTheSectionSmall) {
  model::Model model = restored_model();
  const geom::Box section = box_of(model.restoration->section);
  model.source->grid.rungs.push_back({{{500, 0}, {500, -90000}}, false});
  for (const scene::Panel& panel : picture_of(model).panels) {
    ASSERT_TRUE(panel.extent);
    EXPECT_LT(panel.extent->diagonal(), 1.5 * section.diagonal());
  }
  const geom::Box shown = *picture_of(model).panels[1].extent;
  EXPECT_TRUE(shown.contains(section.low) && shown.contains(section.high));
}

TEST(Layers, FaultsAreNamedInTheSectionAndManyShareAnEntryOfTheLegend) {
  for (const std::size_t count : {2u, 9u}) {
    model::Model model;
    model.section = test::section_of({{{{0, 0}, {100, 0}}, false}});
    for (std::size_t i = 0; i < count; ++i) {
      const double x = 10.0 * static_cast<double>(i);
      model.section.lines.push_back(
          {section::LineId(i), section::LineKind::Fault, "F" + std::to_string(i), {{{x, 5}, {x, -50}}, false}, {}});
    }
    const scene::Panel panel = picture_of(model).panels[0];
    EXPECT_EQ(scene::legend_name(*find(panel, "line_1")), count > 3 ? "Faults" : "F1");
    const auto& name = std::get<scene::Labels>(find(panel, "fault_name_1")->content).labels.at(0);
    EXPECT_EQ(name.text, "F1");
    EXPECT_EQ(name.at, (geom::Point{10, 5}));
  }
}

TEST(Layers, TheColumnBesideTheSectionNamesItsUnits) {
  const scene::Picture picture = picture_of(restored_model());
  const scene::Layer* names = find(picture.panels[1], "column_names");
  ASSERT_NE(names, nullptr);
  const auto& labels = std::get<scene::Labels>(names->content).labels;
  ASSERT_EQ(labels.size(), 2u);
  EXPECT_EQ(labels[0].text, "top - bed1");
  EXPECT_GT(labels[0].at.y, labels[1].at.y);
}

TEST(Layers, ATableOfColoursCountsAndLettersStandOverTheEnds) {
  model::Model model = restored_model();
  model.section.colors = std::make_shared<const scene::ColorTable>(
      scene::ColorTable{{{"bed1", scene::Color{10, 20, 30}, scene::Pattern::Dots}}});
  model.section.left_end = "SSW";
  model.section.right_end = "NNE";
  for (const scene::Panel& panel : picture_of(model).panels) {
    EXPECT_EQ(find(panel, "horizon_1")->style.line, (scene::Color{10, 20, 30}));
    EXPECT_EQ(find(panel, "unit_1")->style.fill, (scene::Color{10, 20, 30}));
    EXPECT_EQ(find(panel, "unit_1")->style.pattern, scene::Pattern::Dots);
    EXPECT_EQ(panel.left_end, "SSW");
    EXPECT_EQ(panel.right_end, "NNE");
  }
}

TEST(Layers, TheColumnStandsAsTheBedsLieWhenTheLowestIsTheTop) {
  const geom::Polyline low{{{0.0, 0.0}, {100.0, 0.0}}, false};
  const geom::Polyline middle{{{0.0, 20.0}, {100.0, 20.0}}, false};
  const geom::Polyline high{{{0.0, 50.0}, {100.0, 50.0}}, false};
  model::Model model;
  model.section = test::section_of({low, middle, high});
  unfold::GridParams grid;
  grid.count = 4;
  model = run_target(run_grid(model, grid, {}, {}).value(), {}, {}, {}).value();
  const scene::Picture picture = picture_of(run_restore(model, {}, {}, {}).value());
  const auto& labels = std::get<scene::Labels>(find(picture.panels[1], "column_names")->content).labels;
  ASSERT_EQ(labels.size(), 2u);
  EXPECT_EQ(labels[0].text, "bed2 - bed1");
  EXPECT_EQ(labels[1].text, "bed1 - top");
  EXPECT_GT(labels[0].at.y, labels[1].at.y);
  // The rock below the highest bed has its colour.
  const scene::Layer* unit = find(picture.panels[0], "unit_0");
  EXPECT_EQ(std::get<scene::Regions>(unit->content).regions[0].contours[0].box().high.y, 50.0);
  EXPECT_EQ(unit->style.fill, section::Palette(model.section).of("bed2").fill);
}

TEST(Layers, AreasThatNothingChangesHaveOneColour) {
  // By constant thickness flat beds stay: det F is 1 but for rounding, wherever the section lies.
  for (const double far : {0.0, 7e6, 1e-3}) {
    model::Model model;
    std::vector<geom::Polyline> beds(3);
    for (int i = 0; i <= 37; ++i) {
      for (std::size_t bed = 0; bed < beds.size(); ++bed)
        beds[bed].points.push_back({far + 27.3 * i, -100.7 * static_cast<double>(bed)});
    }
    model.section = test::section_of(beds);
    unfold::GridParams grid;
    grid.count = 4;
    model = run_target(run_grid(model, grid, {}, {}).value(), {}, {}, {}).value();
    const scene::Picture picture = picture_of(run_restore(model, {}, {}, {}).value());
    const auto& mesh = std::get<scene::Mesh>(find(picture.panels[0], "dilatation")->content);
    EXPECT_EQ(mesh.scale.low, 0.0) << far;
    EXPECT_EQ(mesh.scale.high, 0.0) << far;
  }
  const scene::Picture folded = picture_of(restored_model());
  const auto& mesh = std::get<scene::Mesh>(find(folded.panels[0], "dilatation")->content);
  EXPECT_GT(mesh.scale.high, 1e-3);
}

TEST(Layers, ThePinLineOfAShearRunsAlongItsDirection) {
  const geom::Polyline top{{{0, 0}, {600, 60}, {1000, 20}}, false};
  for (const double sign : {1.0, -1.0}) {  // layers below and above the top
    for (const double degrees : {0.0, 20.0, -30.0}) {
      model::Model model;
      geom::Polyline bed = top;
      for (geom::Point& p : bed.points) p.y -= sign * 200.0;
      model.section = test::section_of({top, bed});
      unfold::GridParams grid;
      grid.uncovered = unfold::Uncovered::Continue;
      unfold::TargetParams target;
      target.pin = 300.0;
      unfold::RestoreParams params;
      params.method = unfold::RestoreMethod::Shear;
      params.angle = base::Angle::from_degrees(degrees);
      model = run_grid(model, grid, {}, {}).value();
      model = run_target(model, target, {}, {}).value();
      model = run_restore(model, params, {}, {}).value();
      const scene::Picture picture = picture_of(model);
      for (const scene::Panel& panel : picture.panels) {
        const geom::Polyline line = std::get<scene::Lines>(find(panel, "pin")->content).lines.front();
        const geom::Vector along = line.points.front() - line.points.back();
        const geom::Vector shear{std::sin(params.angle.radians()), std::cos(params.angle.radians())};
        EXPECT_NEAR(geom::cross(geom::normalised(along), shear), 0.0, 1e-9) << sign << ' ' << degrees;
        EXPECT_GT(sign * along.y, 0.0);
        EXPECT_LT(geom::distance(line.segment(0), {300, 30}), 1e-9);
      }
    }
  }
}

TEST(Layers, TheDisplacementDiagramBesideALongSectionIsAsWideAsHalfOfItAndHasItsOwnTicks) {
  // 20 km of section; the fault shows 424 m of it.
  model::Model model;
  model.section = test::faulted({{"A/1", {{-10000, 0}, {500, 0}}},
                                 {"A/2", {{600, -100}, {10000, -100}}},
                                 {"B/1", {{-10000, -300}, {800, -300}}},
                                 {"B/2", {{880, -380}, {10000, -380}}}},
                                {test::item("F", {{400, 100}, {1200, -700}})});
  const auto made = run_faults(model, {}, {}, {});
  ASSERT_TRUE(made) << to_string(made.error());
  const scene::Picture picture = picture_of(*made);
  ASSERT_EQ(picture.panels.size(), 2u);
  const scene::Panel& diagram = picture.panels[1];
  const auto& line = std::get<scene::Lines>(find(diagram, "profile_0")->content).lines[0];
  EXPECT_GE(line.box().width(), 0.5 * 20000.0);
  // Distances and separations are those of the ticks times their unit.
  EXPECT_NEAR(line.points[0].x / diagram.axes.unit, 150 * std::sqrt(2.0), 1e-6);
  EXPECT_NEAR(line.points[0].y / diagram.axes.unit, 100 * std::sqrt(2.0), 1e-6);
  EXPECT_NEAR(line.points[1].y / diagram.axes.unit, 80 * std::sqrt(2.0), 1e-6);
}

}  // namespace
}  // namespace recon::core
