#include "quebra/gui/crack_panel.h"

#include <QLabel>
#include <QLocale>

#include "tests/gui/program_window.h"

namespace quebra::gui {
namespace {

namespace test = dobra::test;

double number_in(const QString& cell) { return QLocale().toDouble(cell); }

TEST(CrackPanel, ShowsLengthDirectionAndTheFactorsOfTheTips) {
  test::ProgramWindow window("quebra/edge_crack.toml");
  window.open();
  QTreeWidget* rows = window.rows("cracks");
  ASSERT_NE(rows, nullptr);
  ASSERT_EQ(rows->topLevelItemCount(), 1);
  const QTreeWidgetItem* crack = rows->topLevelItem(0);
  EXPECT_EQ(crack->text(0), "crack");
  EXPECT_NEAR(number_in(crack->text(1)), 0.5, 1e-12);
  EXPECT_NEAR(number_in(crack->text(2)), 0.0, 1e-9);
  ASSERT_EQ(crack->childCount(), 1);
  EXPECT_EQ(crack->child(0)->text(0), "crack_end");
  // The handbook's K_I of this strip, to half a percent as the example itself asks for.
  EXPECT_NEAR(number_in(crack->child(0)->text(3)), 3.5425, 0.005 * 3.5425);
  EXPECT_NEAR(number_in(crack->child(0)->text(4)), 0.0, 0.05);
}

TEST(CrackPanel, TheRowOfACrackSelectsItAndTheOtherWayRound) {
  test::ProgramWindow window("quebra/cracked_plate.toml");
  window.open();
  ASSERT_TRUE(window->look_at("input"));
  window.come_to_rest();
  QTreeWidget* rows = window.rows("cracks");
  ASSERT_EQ(rows->topLevelItemCount(), 3);
  window.click_row(*rows, *rows->topLevelItem(2));
  const auto& work = window->canvas().workspace();
  ASSERT_EQ(work.selection.size(), 1u);
  const dobra::geom::Polyline* line = work.line(work.selection.begin()->first);
  ASSERT_NE(line, nullptr);
  EXPECT_EQ(line->points.back(), (dobra::geom::Point{3.0, 2.3}));  // "lower"
  window.focus();
  window.press(Qt::Key_S);
  window.click(window.pixel(0, {1.0, 2.55}));  // half-way along "stem"
  ASSERT_EQ(rows->selectedItems().size(), 1);
  EXPECT_EQ(rows->selectedItems().front()->text(0), "stem");
}

TEST(CrackPanel, WhereThePictureHidesTheCracksItSaysWhatToDo) {
  test::ProgramWindow window("quebra/edge_crack.toml");
  window.open();
  QTreeWidget* rows = window.rows("cracks");
  QString told;
  QObject::connect(&window->canvas(), &dobra::gui::Canvas::told, &*window, [&](const QString& what) { told = what; });
  window->layers().set_layer_visible("cracks", false);
  window.click_row(*rows, *rows->topLevelItem(0));
  EXPECT_TRUE(window->canvas().workspace().selection.empty());
  EXPECT_TRUE(told.contains("does not show the crack")) << told.toStdString();
  window->layers().set_layer_visible("cracks", true);
  rows->clearSelection();
  window.click_row(*rows, *rows->topLevelItem(0)->child(0));  // the row of a tip is its crack's
  EXPECT_EQ(window->canvas().workspace().selection.size(), 1u);
}

TEST(CrackPanel, SaysHowToDrawTheFirst) {
  test::ProgramWindow window("quebra/plate_with_hole.toml");
  window.open();
  QTreeWidget* rows = window.rows("cracks");
  EXPECT_FALSE(rows->isVisible());
  EXPECT_TRUE(window->findChild<QLabel*>("cracks.none")->isVisible());
}

}  // namespace
}  // namespace quebra::gui
