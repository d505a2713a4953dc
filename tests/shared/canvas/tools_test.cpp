#include <gtest/gtest.h>

#include "shared/canvas/entry.h"
#include "shared/canvas/tool.h"

namespace dobra::canvas {
namespace {

using geom::Point;

/// Two beds that end on one fault in a common vertex.
class Tools : public ::testing::Test {
 protected:
  void SetUp() override {
    scene::Picture picture;
    picture.panels.push_back({.key = "section"});
    picture.panels[0].layers.push_back(
        {.key = "horizon_1", .content = scene::Lines{{{{{0, 0}, {40, 0}, {50, 0}}, false}}, {1}}});
    picture.panels[0].layers.push_back(
        {.key = "line_0", .content = scene::Lines{{{{{50, 100}, {50, 0}, {50, -90}}, false}}, {0}}});
    work.show(std::make_shared<const scene::Picture>(std::move(picture)), 0);
  }
  void press(Tool& tool, Point at, Modifier modifier = Modifier::None) {
    tool.press(work, {.at = at, .modifier = modifier, .reach = 2.0});
  }
  void move(Tool& tool, Point at) { tool.move(work, {.at = at, .reach = 2.0}); }
  void release(Tool& tool, Point at) { tool.release(work, {.at = at, .reach = 2.0}); }
  void click(Tool& tool, Point at, Modifier modifier = Modifier::None) {
    press(tool, at, modifier);
    release(tool, at);
  }

  Workspace work;
  const scene::Pick bed{"horizon_1", 1};
  const scene::Pick fault{"line_0", 0};
};

template <class T>
std::vector<T> only(std::vector<Change> changes) {
  std::vector<T> found;
  for (Change& change : changes) {
    if (T* one = std::get_if<T>(&change)) found.push_back(std::move(*one));
  }
  return found;
}

TEST_F(Tools, ALineIsDrawnByClicksAndTypedPlaces) {
  const auto tool = make_draw_tool(Drawing::Line);
  click(*tool, {0, 10});
  EXPECT_EQ(tool->last(), (Point{0, 10}));
  click(*tool, {20, 12});
  click(*tool, {30, 99});
  EXPECT_TRUE(tool->key(work, Key::Backspace));
  click(*tool, {40, 11});
  EXPECT_TRUE(tool->key(work, Key::Enter));
  const auto drawn = only<Drawn>(tool->take());
  ASSERT_EQ(drawn.size(), 1U);
  EXPECT_EQ(drawn[0].line.points, (std::vector<Point>{{0, 10}, {20, 12}, {40, 11}}));
  EXPECT_FALSE(tool->last());
}

TEST_F(Tools, ADoubleClickEndsALineWithoutARepeatedPoint) {
  const auto tool = make_draw_tool(Drawing::Line);
  click(*tool, {0, 10});
  click(*tool, {20, 12});
  tool->double_click(work, {.at = {20, 12}, .reach = 2.0});
  const auto drawn = only<Drawn>(tool->take());
  ASSERT_EQ(drawn.size(), 1U);
  EXPECT_EQ(drawn[0].line.points.size(), 2U);
}

TEST_F(Tools, WhatHasTooFewPointsIsNotDrawn) {
  for (const Drawing drawing : {Drawing::Line, Drawing::Polygon}) {
    const auto tool = make_draw_tool(drawing);
    click(*tool, {0, 10});
    if (drawing == Drawing::Polygon) click(*tool, {10, 10});
    EXPECT_TRUE(tool->key(work, Key::Enter));
    const std::vector<Change> changes = tool->take();
    ASSERT_EQ(changes.size(), 1U);
    EXPECT_TRUE(std::holds_alternative<Told>(changes[0]));
  }
}

TEST_F(Tools, AVertexTakesTheVerticesOfOtherLinesAtItsPlaceAlong) {
  const auto tool = make_select_tool();
  click(*tool, {20, 0.5});
  ASSERT_TRUE(work.selection.contains(bed));
  press(*tool, {50.4, 0.3});
  move(*tool, {53, -4});
  move(*tool, {55, -6});
  auto shown = only<Edited>(tool->take());
  ASSERT_EQ(shown.size(), 2U);
  EXPECT_EQ(shown[1].stage, Stage::During);
  release(*tool, {55, -6});
  const auto done = only<Edited>(tool->take());
  ASSERT_EQ(done.size(), 1U);
  EXPECT_EQ(done[0].stage, Stage::Done);
  ASSERT_EQ(done[0].lines.size(), 2U);
  EXPECT_EQ(done[0].lines[0].becomes[0].points, (std::vector<Point>{{0, 0}, {40, 0}, {55, -6}}));
  EXPECT_EQ(done[0].lines[1].becomes[0].points, (std::vector<Point>{{50, 100}, {55, -6}, {50, -90}}));
}

TEST_F(Tools, AClickOnAVertexMovesNothing) {
  const auto tool = make_select_tool();
  click(*tool, {20, 0});
  press(*tool, {40, 0.5});
  move(*tool, {40.3, 0.6});
  release(*tool, {40.3, 0.6});
  EXPECT_TRUE(tool->take().empty());
  EXPECT_EQ(work.selection.at(bed), (std::set<std::size_t>{1}));
}

TEST_F(Tools, EscapeGivesADragUp) {
  const auto tool = make_select_tool();
  click(*tool, {20, 0});
  press(*tool, {40, 0});
  move(*tool, {40, 20});
  (void)tool->take();
  EXPECT_TRUE(tool->key(work, Key::Escape));
  EXPECT_EQ(only<Dropped>(tool->take()).size(), 1U);
  release(*tool, {40, 20});
  EXPECT_TRUE(tool->take().empty());
}

TEST_F(Tools, DeleteRemovesVerticesFirstAndLinesWithoutAny) {
  const auto tool = make_select_tool();
  click(*tool, {20, 0});
  click(*tool, {40, 0});
  EXPECT_TRUE(tool->key(work, Key::Delete));
  auto edits = only<Edited>(tool->take());
  ASSERT_EQ(edits.size(), 1U);
  EXPECT_EQ(edits[0].lines[0].becomes[0].points.size(), 2U);
  EXPECT_TRUE(tool->key(work, Key::Delete));
  edits = only<Edited>(tool->take());
  ASSERT_EQ(edits.size(), 1U);
  EXPECT_TRUE(edits[0].lines[0].becomes.empty());
}

TEST_F(Tools, ABandToTheRightTakesWhatIsInsideAndToTheLeftWhatItMeets) {
  const auto tool = make_select_tool();
  const auto band = [&](Point from, Point to) {
    press(*tool, from);
    move(*tool, to);
    release(*tool, to);
  };
  band({-10, -10}, {60, 20});
  EXPECT_EQ(work.selection.size(), 1U);
  EXPECT_TRUE(work.selection.contains(bed));
  band({60, 20}, {30, 10});
  EXPECT_EQ(work.selection.size(), 1U);
  EXPECT_TRUE(work.selection.contains(fault));
  band({60, 20}, {-10, -10});
  EXPECT_EQ(work.selection.size(), 2U);
  click(*tool, {20, 0}, Modifier::Toggle);
  EXPECT_FALSE(work.selection.contains(bed));
}

TEST_F(Tools, LinesAreSplitJoinedExtendedAndTrimmedByClicks) {
  auto tool = make_line_tool(LineWork::Split);
  click(*tool, {20, 0});
  auto edits = only<Edited>(tool->take());
  ASSERT_EQ(edits.size(), 1U);
  EXPECT_EQ(edits[0].lines[0].becomes.size(), 2U);
  tool = make_line_tool(LineWork::Join);
  click(*tool, {20, 0});
  click(*tool, {50, 60});
  edits = only<Edited>(tool->take());
  ASSERT_EQ(edits.size(), 1U);
  EXPECT_EQ(edits[0].lines.size(), 2U);
  tool = make_line_tool(LineWork::Trim);
  click(*tool, {50, -60});
  edits = only<Edited>(tool->take());
  ASSERT_EQ(edits.size(), 1U);
  EXPECT_EQ(edits[0].lines[0].becomes[0].points, (std::vector<Point>{{50, 100}, {50, 0}}));
  click(*tool, {500, 500});
  EXPECT_EQ(only<Told>(tool->take()).size(), 1U);
}

TEST_F(Tools, SelectedLinesAreMovedTurnedMirroredAndCopied) {
  work.selection = {{bed, {}}};
  const auto image = [&](Carrying carrying) {
    const auto tool = make_carry_tool(carrying);
    click(*tool, {0, 0});
    click(*tool, {0, 10});
    std::vector<Change> changes = tool->take();
    const auto copies = only<Drawn>(changes);
    EXPECT_EQ(copies.size(), carrying == Carrying::Copy ? 1U : 0U);
    const auto edits = only<Edited>(std::move(changes));
    EXPECT_EQ(edits.size(), carrying == Carrying::Copy ? 0U : 1U);
    return (copies.empty() ? edits[0].lines[0].becomes[0] : copies[0].line).points.back();
  };
  EXPECT_EQ(image(Carrying::Move), (Point{50, 10}));
  EXPECT_EQ(image(Carrying::Copy), (Point{50, 10}));
  EXPECT_EQ(image(Carrying::Rotate), (Point{0, 50}));
  EXPECT_EQ(image(Carrying::Mirror), (Point{-50, 0}));
  const auto turn = make_carry_tool(Carrying::Rotate);
  EXPECT_FALSE(turn->place_of_number(90.0));
  click(*turn, {10, 20});
  EXPECT_EQ(turn->place_of_number(90.0), (Point{10, 21}));
  work.selection.clear();
  const auto tool = make_carry_tool(Carrying::Move);
  click(*tool, {0, 0});
  EXPECT_EQ(only<Told>(tool->take()).size(), 1U);
}

TEST_F(Tools, WhatAStepHasMadeIsNeitherSelectedNorTakenAlong) {
  work.set_editable(std::set<scene::Pick>{bed});
  const auto tool = make_select_tool();
  click(*tool, {50, 60});
  EXPECT_TRUE(work.selection.empty());
  click(*tool, {20, 0});
  press(*tool, {50, 0});
  move(*tool, {55, -6});
  release(*tool, {55, -6});
  const auto edits = only<Edited>(tool->take());
  ASSERT_FALSE(edits.empty());
  EXPECT_EQ(edits.back().lines.size(), 1U);
  const auto split = make_line_tool(LineWork::Split);
  click(*split, {50, 60});
  EXPECT_EQ(only<Told>(split->take()).size(), 1U);
}

TEST_F(Tools, NothingIsSelectedAfterLinesWereDeleted) {
  const auto tool = make_select_tool();
  click(*tool, {20, 0});
  EXPECT_TRUE(tool->key(work, Key::Delete));
  EXPECT_TRUE(work.selection.empty());
  EXPECT_FALSE(tool->key(work, Key::Delete));
}

TEST_F(Tools, APolygonOfTwoPointsWaitsForTheThird) {
  const auto tool = make_draw_tool(Drawing::Polygon);
  click(*tool, {0, 10});
  click(*tool, {10, 10});
  EXPECT_TRUE(tool->key(work, Key::Enter));
  click(*tool, {10, 20});
  EXPECT_TRUE(tool->key(work, Key::Enter));
  const auto drawn = only<Drawn>(tool->take());
  ASSERT_EQ(drawn.size(), 1U);
  EXPECT_EQ(drawn[0].line.points.size(), 3U);
}

TEST_F(Tools, WaysAreMeasured) {
  const auto tool = make_measure_tool();
  click(*tool, {0, 0});
  click(*tool, {30, 0});
  click(*tool, {30, -40});
  const Overlay overlay = tool->overlay(work);
  ASSERT_EQ(overlay.texts.size(), 1U);
  EXPECT_EQ(overlay.texts[0].text, "40 m, dip 90.0°\n70 m in all, area 600 m²");
  EXPECT_EQ(measure_text({0, 0}, {-100, -100}), "141.421 m, dip 45.0°");
}

TEST_F(Tools, DecimalsStandBehindTheMarkOfTheUser) {
  set_decimal_mark(DecimalMark::Comma);
  EXPECT_EQ(measure_text({0, 0}, {-100, -100}), "141,421 m, dip 45,0°");
  EXPECT_EQ(with_decimal_mark("1.5e-06, .5 and 3. A.1"), "1,5e-06, .5 and 3. A.1");
  EXPECT_EQ(parse_entry("12,5", {.last = Point{0, 0}, .towards = geom::Vector{2, 0}}).value(), (Point{12.5, 0}));
  set_decimal_mark(DecimalMark::Point);
  EXPECT_EQ(measure_text({0, 0}, {-100, -100}), "141.421 m, dip 45.0°");
}

TEST_F(Tools, AnotherToolFinishesWhatHasPointsEnough) {
  for (const auto& [drawing, clicks, finished] : {std::tuple{Drawing::Line, 1, false},
                                                  {Drawing::Line, 2, true},
                                                  {Drawing::Polygon, 2, false},
                                                  {Drawing::Polygon, 3, true},
                                                  {Drawing::Rectangle, 1, false}}) {
    const auto tool = make_draw_tool(drawing);
    const Point places[] = {{0, 10}, {20, 12}, {30, 40}};
    for (int i = 0; i < clicks; ++i) click(*tool, places[i]);
    tool->put_down(work);
    EXPECT_EQ(only<Drawn>(tool->take()).size(), finished ? 1U : 0U);
    EXPECT_FALSE(tool->unfinished());
  }
}

TEST_F(Tools, UndoTakesBackWhatIsUnfinishedPieceByPiece) {
  const auto line = make_draw_tool(Drawing::Line);
  EXPECT_FALSE(line->take_back(work));
  click(*line, {0, 10});
  click(*line, {20, 12});
  EXPECT_TRUE(line->take_back(work));
  EXPECT_EQ(line->last(), (Point{0, 10}));
  EXPECT_TRUE(line->take_back(work));
  EXPECT_FALSE(line->take_back(work));
  work.selection = {{bed, {}}};
  const auto carry = make_carry_tool(Carrying::Move);
  click(*carry, {0, 0});
  EXPECT_TRUE(carry->take_back(work));
  EXPECT_FALSE(carry->take_back(work));
  const auto join = make_line_tool(LineWork::Join);
  click(*join, {20, 0});
  EXPECT_TRUE(join->take_back(work));
  EXPECT_FALSE(join->unfinished());
}

TEST_F(Tools, AClickThatMissesSaysWhatWasExpected) {
  for (const LineWork kind :
       {LineWork::InsertVertex, LineWork::Split, LineWork::Join, LineWork::Extend, LineWork::Trim}) {
    const auto tool = make_line_tool(kind);
    click(*tool, {500, 500});
    const auto told = only<Told>(tool->take());
    ASSERT_EQ(told.size(), 1U);
    EXPECT_NE(told[0].message.find(tool->hint()), std::string::npos) << told[0].message;
  }
  const auto join = make_line_tool(LineWork::Join);
  click(*join, {20, 0});
  EXPECT_TRUE(join->take().empty());
  click(*join, {20, 0});
  EXPECT_EQ(only<Told>(join->take()).size(), 1U);
}

TEST_F(Tools, JoiningLinesOfTwoNamesAsksWhichStays) {
  scene::Picture picture;
  picture.panels.push_back({.key = "section"});
  const auto layer = [&](const char* key, const char* title, Point from, Point to, std::uint32_t id) {
    picture.panels[0].layers.push_back({.key = key, .title = title, .content = scene::Lines{{{{from, to}}}, {id}}});
  };
  layer("horizon_0", "Top", {0, 0}, {40, 0}, 0);
  layer("horizon_1", "Base", {60, 0}, {90, 0}, 1);
  layer("horizon_2", "Top", {60, 30}, {90, 30}, 2);
  work.show(std::make_shared<const scene::Picture>(std::move(picture)), 0);
  const auto tool = make_line_tool(LineWork::Join);
  click(*tool, {20, 0});
  click(*tool, {70, 0});
  const auto asked = only<Asked>(tool->take());
  ASSERT_EQ(asked.size(), 1U);
  ASSERT_EQ(asked[0].answers.size(), 2U);
  EXPECT_EQ(asked[0].answers[1].first, "Base");
  const std::vector<scene::LineEdit>& lines = asked[0].answers[1].second.lines;
  EXPECT_EQ(lines[0].pick.layer, "horizon_1");
  EXPECT_EQ(lines[0].becomes[0].points, (std::vector<Point>{{0, 0}, {40, 0}, {60, 0}, {90, 0}}));
  EXPECT_EQ(lines[1].pick.layer, "horizon_0");
  EXPECT_TRUE(lines[1].becomes.empty());
  click(*tool, {20, 0});
  click(*tool, {70, 30});
  EXPECT_EQ(only<Edited>(tool->take()).size(), 1U);
}

TEST_F(Tools, TheSelectionKeepsWhatIsStillThere) {
  work.selection = {{bed, {2}}, {fault, {}}};
  scene::Picture picture;
  picture.panels.push_back({.key = "section"});
  picture.panels[0].layers.push_back({.key = "horizon_1", .content = scene::Lines{{{{{0, 0}, {50, 0}}, false}}, {1}}});
  work.show(std::make_shared<const scene::Picture>(std::move(picture)), 0);
  EXPECT_EQ(work.selection, (Selection{{bed, {}}}));
}

}  // namespace
}  // namespace dobra::canvas
