// Documents of several sections: what is read, and that a cut is a section that steps restore.
#include <gtest/gtest.h>

#include "recon/core/operations.h"
#include "recon/core/space_steps.h"
#include "recon/model/model.h"
#include "recon/space/cut.h"
#include "shared/scenario/runner.h"

namespace recon::space {
namespace {

namespace loft = dobra::surf::loft;

PlacedSection placed(const std::string& name, std::vector<geom::Point> corners, bool faulted) {
  PlacedSection made{name, {}, loft::PlanTrace::make(std::move(corners)).value()};
  const auto horizon = [&](std::string line, std::string whole, std::vector<geom::Point> points) {
    section::Horizon h;
    h.id = section::HorizonId(made.section.horizons.size());
    h.name = std::move(line);
    h.piece_of = std::move(whole);
    h.line.points = std::move(points);
    made.section.horizons.push_back(std::move(h));
  };
  if (!faulted) {
    horizon("A", "", {{0.0, 0.0}, {1000.0, 0.0}});
    return made;
  }
  section::SectionLine fault;
  fault.id = section::LineId(0);
  fault.name = "F";
  fault.line.points = {{400.0, 200.0}, {600.0, -200.0}};
  made.section.lines.push_back(fault);
  horizon("A (1)", "A", {{0.0, 0.0}, {500.0, 0.0}});
  horizon("A (2)", "A", {{520.0, -40.0}, {1000.0, -40.0}});
  return made;
}

std::vector<std::string> labels_of(const model::Model& model) {
  dobra::scene::space::SpacePicture picture;
  core::draw_placed_in_space(model, picture);
  std::vector<std::string> texts;
  for (const auto& layer : unrolled(picture)) {
    const auto* content = std::get_if<dobra::scene::space::Labels>(&layer.content);
    if (content == nullptr) continue;
    for (const auto& label : content->labels) texts.push_back(label.text);
  }
  return texts;
}

/// A name of a line that lies under a surface would stand before it.
TEST(Space, UnderSurfacesTheViewNamesSectionsAndNotTheirLines) {
  PlacedSections all;
  for (const double y : {0.0, 300.0})
    all.sections.push_back(placed("S" + std::to_string(static_cast<int>(y)), {{0.0, y}, {1000.0, y}}, false));
  model::Model model;
  model.findings.set(all, {});
  EXPECT_EQ(labels_of(model), (std::vector<std::string>{"A", "A"}));
  model.findings.set(make_surfaces(all, {}).value(), {});
  EXPECT_EQ(labels_of(model), (std::vector<std::string>{"S0", "S300"}));
}

TEST(Space, PiecesOfAFaultedHorizonAreLoftedAndCutAsPieces) {
  PlacedSections all;
  for (const double y : {0.0, 300.0, 700.0})
    all.sections.push_back(placed("S" + std::to_string(static_cast<int>(y)), {{0.0, y}, {1000.0, y}}, true));
  const auto made = make_surfaces(all, {});
  ASSERT_TRUE(made) << to_string(made.error());
  ASSERT_EQ(made->rows.size(), 2U);
  EXPECT_EQ(made->rows[0].name, "A");
  EXPECT_EQ(made->rows[0].pieces, 2U);
  CutParams params;
  params.trace = {0.0, 100.0, 1000.0, 500.0};
  const auto cut = cut_section(*made, params);
  ASSERT_TRUE(cut) << to_string(cut.error());
  ASSERT_EQ(cut->section.horizons.size(), 2U);
  EXPECT_EQ(whole_name(cut->section.horizons[0]), "A");
  EXPECT_EQ(cut->section.horizons[1].name, "A (2)");
  ASSERT_EQ(cut->section.lines.size(), 1U);
  const geom::Point end = cut->section.horizons[0].line.points.back();
  EXPECT_LT(geom::distance(cut->section.lines[0].line, end), 1e-6);
}

TEST(Space, ASectionWithoutTheFaultEndsThePieces) {
  PlacedSections all;
  for (const double y : {0.0, 300.0})
    all.sections.push_back(placed("F" + std::to_string(static_cast<int>(y)), {{0.0, y}, {1000.0, y}}, true));
  for (const double y : {600.0, 900.0})
    all.sections.push_back(placed("N" + std::to_string(static_cast<int>(y)), {{0.0, y}, {1000.0, y}}, false));
  const auto made = make_surfaces(all, {});
  ASSERT_TRUE(made) << to_string(made.error());
  EXPECT_EQ(made->rows[0].pieces, 3U);
}

TEST(Space, NoCommonLineIsAnErrorThatSaysWhatToDo) {
  PlacedSections all;
  all.sections = {placed("a", {{0.0, 0.0}, {1000.0, 0.0}}, false), placed("b", {{0.0, 500.0}, {1000.0, 500.0}}, false)};
  all.sections[1].section.horizons[0].name = "B";
  const auto made = make_surfaces(all, {});
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, base::ErrorCode::BadSection);
}

}  // namespace
}  // namespace recon::space
