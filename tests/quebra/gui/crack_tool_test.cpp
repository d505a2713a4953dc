#include "quebra/gui/crack_tool.h"

#include <cmath>

#include "quebra/core/drawing.h"
#include "shared/scenario/entries.h"
#include "tests/gui/program_window.h"

namespace quebra::gui {
namespace {

namespace test = dobra::test;
namespace geom = dobra::geom;
namespace scenario = dobra::scenario;
using geom::Point;

std::vector<Point> points_of(const scenario::Document& document, const std::string& crack) {
  scenario::Entries entries = scenario::entries_of(document.input, "crack");
  const auto entry = scenario::entry_named(entries, crack);
  return entry == entries.end() ? std::vector<Point>() : scenario::points_in(*entry);
}

constexpr const char* plate =
    "dobra = 1\nprogram = \"quebra\"\n\n[input]\n\n[[input.curve]]\nname = \"plate\"\nkind = \"polygon\"\n"
    "points = [[0.0, 0.0], [8.0, 0.0], [8.0, 6.0], [0.0, 6.0]]\n\n"
    "[[input.curve]]\nname = \"hole\"\nkind = \"circle\"\ncentre = [4.0, 3.0]\nradius = 1.0\n";

TEST(CrackTool, AnEdgeCrackBeginsOnTheBorderAndIsWhatTheCommandMakes) {
  test::ProgramWindow window("quebra/plate_with_hole.toml");
  window.open(window.write("plate.toml", plate));
  const std::string before = window.text();
  const scenario::Document document = window.document();
  window.focus();
  window.press(Qt::Key_F3);  // without snapping: the tool goes to the border by itself
  window.press(Qt::Key_K);
  window.click(window.pixel(0, {0.0, 2.0}) + QPointF(4, 0));
  window.click(window.pixel(0, {1.5, 2.5}));
  EXPECT_EQ(window.text(), before);
  window.press(Qt::Key_Return);
  window.come_to_rest();
  const std::vector<Point> drawn = points_of(window.document(), "crack");
  ASSERT_EQ(drawn.size(), 2u);
  EXPECT_EQ(drawn[0].x, 0.0);
  EXPECT_NEAR(drawn[0].y, 2.0, 0.03);
  EXPECT_NEAR(drawn[1].x, 1.5, 0.03);
  EXPECT_NEAR(drawn[1].y, 2.5, 0.03);
  ASSERT_FALSE(window->session().outcome()->run.error)
      << dobra::base::to_string(*window->session().outcome()->run.error);
  // The command that a script has for it.
  const auto command = window->session().program().drawing.add(document, "crack", "crack", {drawn, false});
  ASSERT_TRUE(command.ok());
  EXPECT_EQ(window.text(), scenario::document_text(*command));
  window->undo();
  EXPECT_EQ(window.text(), before);
  window->session().redo();
  EXPECT_EQ(window.text(), scenario::document_text(*command));
}

/// The picture follows a circle by chords; a crack that began on a chord would begin outside the material.
TEST(CrackTool, AtAHoleItBeginsOnTheCircleItself) {
  test::ProgramWindow window("quebra/plate_with_hole.toml");
  window.open(window.write("plate.toml", plate));
  for (const double angle : {0.3, 1.234, 2.71, 4.0}) {
    const geom::Vector out{std::cos(angle), std::sin(angle)};
    window.focus();
    window.press(Qt::Key_K);
    window.click(window.pixel(0, Point{4.0, 3.0} + 1.02 * out));
    window.click(window.pixel(0, Point{4.0, 3.0} + 1.6 * out));
    window.press(Qt::Key_Return);
    window.come_to_rest();
    ASSERT_FALSE(window->session().outcome()->run.error)
        << angle << ": " << dobra::base::to_string(*window->session().outcome()->run.error);
  }
  for (const char* name : {"crack", "crack_2", "crack_3", "crack_4"}) {
    const std::vector<Point> drawn = points_of(window.document(), name);
    ASSERT_EQ(drawn.size(), 2u) << name;
    EXPECT_NEAR(geom::distance(drawn[0], {4.0, 3.0}), 1.0, 1e-12) << name;
  }
  // Each is an edge crack: the mesh has one tip of it.
  window.open(window.write("meshed.toml", window.text() + "\n[[step]]\noperation = \"mesh\"\nsize = 0.5\n"));
  ASSERT_FALSE(window->session().outcome()->run.error)
      << dobra::base::to_string(*window->session().outcome()->run.error);
  for (const scenario::Quantity& each : window->session().outcome()->quantities) {
    if (each.name != "tips" && each.name != "cracks") continue;
    EXPECT_EQ(each.value, 4.0) << each.name;
  }
}

TEST(CrackTool, BackspaceEscapeAndOnePointLeaveNoCrack) {
  test::ProgramWindow window("quebra/plate_with_hole.toml");
  window.open(window.write("plate.toml", plate));
  const std::string before = window.text();
  window.focus();
  window.press(Qt::Key_K);
  window.click(window.pixel(0, {0.0, 2.0}));
  window.press(Qt::Key_Return);
  EXPECT_TRUE(window->canvas().unfinished());  // it waits for another point
  window.click(window.pixel(0, {1.0, 2.0}));
  window.click(window.pixel(0, {2.0, 4.0}));
  window.press(Qt::Key_Backspace);
  window.press(Qt::Key_Escape);
  EXPECT_FALSE(window->canvas().unfinished());
  EXPECT_EQ(window.text(), before);
  window.click(window.pixel(0, {1.0, 2.0}));
  window.click(window.pixel(0, {1.0, 2.0}));  // the same place
  window.press(Qt::Key_Escape);
  window.press(Qt::Key_Escape);
  EXPECT_EQ(window.text(), before);
  EXPECT_FALSE(window->session().history().can_undo());
}

/// Typed from the border: length and angle are what was typed.
TEST(CrackTool, TakesTypedLengthsAndAngles) {
  test::ProgramWindow window("quebra/plate_with_hole.toml");
  window.open(window.write("plate.toml", plate));
  window.focus();
  window.press(Qt::Key_K);
  window.click(window.pixel(0, {8.0, 2.0}));
  const std::vector<Point> none = points_of(window.document(), "crack");
  EXPECT_TRUE(none.empty());
  window.write_keys("@1.5<180");
  window.press(Qt::Key_Return);
  window.focus();
  window.press(Qt::Key_Return);
  window.come_to_rest();
  const std::vector<Point> drawn = points_of(window.document(), "crack");
  ASSERT_EQ(drawn.size(), 2u);
  EXPECT_EQ(drawn[0].x, 8.0);
  EXPECT_NEAR(drawn[1].x, 6.5, 1e-12);
  EXPECT_NEAR(drawn[1].y, drawn[0].y, 1e-12);
}

/// A document in millimetres has its crack in millimetres, and the specimen's own crack keeps its name.
TEST(CrackTool, InOtherUnitsAndBesideASpecimen) {
  test::ProgramWindow window("quebra/plate_with_hole.toml");
  window.open(window.write("mm.toml",
                           "dobra = 1\nprogram = \"quebra\"\nunit_system = \"mm, N, MPa\"\n\n[input]\nspecimen = "
                           "\"single_edge_notch\"\nwidth = 1000.0\nheight = 3000.0\ncrack_length = 500.0\n"));
  ASSERT_FALSE(window->session().outcome()->run.error)
      << dobra::base::to_string(*window->session().outcome()->run.error);
  window.focus();
  window.press(Qt::Key_K);
  window.click(window.pixel(0, {1000.0, 700.0}) + QPointF(-3, 0));
  window.click(window.pixel(0, {800.0, 700.0}));
  window.press(Qt::Key_Return);
  window.come_to_rest();
  const std::vector<Point> drawn = points_of(window.document(), "crack_2");
  ASSERT_EQ(drawn.size(), 2u) << window.text();
  EXPECT_NEAR(drawn[0].x, 1000.0, 1e-9);
  EXPECT_NEAR(drawn[1].x, 800.0, 15.0);
  ASSERT_FALSE(window->session().outcome()->run.error)
      << dobra::base::to_string(*window->session().outcome()->run.error);
}

}  // namespace
}  // namespace quebra::gui
