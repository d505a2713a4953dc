// The list of vertices: rows of spreadsheets, the table as a model, and what is typed and pasted with real keys.

#include <gtest/gtest.h>

#include <QClipboard>
#include <QComboBox>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QTableView>
#include <QToolButton>
#include <cmath>
#include <random>

#include "shared/gui/canvas.h"
#include "shared/gui/vertices/rows.h"
#include "shared/gui/vertices/vertex_panel.h"
#include "shared/scene/decimal_mark.h"
#include "tests/shared/gui/window_fixture.h"

namespace dobra::gui::vertices {
namespace {

using geom::Point;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr qint64 most_milliseconds = 500;
#else
constexpr qint64 most_milliseconds = 50;
#endif

std::string row_error(const char* rows) {
  const auto points = points_of_rows(rows);
  return points ? "read " + std::to_string(points->size()) : points.error().message;
}

TEST(VertexRows, WhatIsNoRowOfTwoNumbersIsRefusedWithItsPlace) {
  EXPECT_EQ(row_error(""), "there are no rows of two numbers to paste");
  EXPECT_EQ(row_error("x\tz\n"), "there are no rows of two numbers to paste");
  EXPECT_EQ(row_error("1\t2\n3\n"), "row 2 has 1 numbers; copy two columns, x and z");
  EXPECT_EQ(row_error("1\t2\t3\n"), "row 1 has 3 numbers; copy two columns, x and z");
  EXPECT_EQ(row_error("1\t2\n3\tdeep\n"), "row 2: 'deep' is not a number");
  EXPECT_EQ(row_error("1\t2\n3\t\n"), "row 2: '' is not a number");
  EXPECT_EQ(row_error("1\tnan\n"), "row 1: 'nan' is not a number");
  EXPECT_EQ(row_error("1\t1e999\n"), "row 1: '1e999' is not a number");
  EXPECT_EQ(row_error("1,5,2,5\n"), "row 1 has 4 numbers; copy two columns, x and z");
  EXPECT_EQ(row_error("1.234,5\t2\n"), "row 1: '1.234,5' is not a number");
}

TEST(VertexRows, TabsSemicolonsBlanksAndBothDecimalMarksAreRead) {
  const std::vector<Point> wanted{{1.5, -2.25}, {1e3, 0.0}};
  for (const char* rows :
       {"1.5\t-2.25\n1000\t0\n", "1,5\t-2,25\r\n1000\t0\r\n", "1,5;-2,25\n1e3;0", "1.5 -2.25\n1000 0",
        "1.5, -2.25\n1000, 0\n", "1.5,-2.25\n1000,0", "x\tz\n\n1,5\t-2,25\n\n1000\t0\n", "  1.5\t -2.25 \r1000\t0\r"}) {
    const auto points = points_of_rows(rows);
    ASSERT_TRUE(points) << rows << ": " << points.error().message;
    EXPECT_EQ(*points, wanted) << rows;
  }
}

TEST(VertexRows, CopiedRowsReadBackToTheSameBitsInBothLanguages) {
  std::mt19937_64 random(7);
  std::vector<Point> points;
  for (int i = 0; i < 2000; ++i) {
    points.push_back({std::ldexp(static_cast<double>(random()), static_cast<int>(random() % 60) - 80),
                      -std::ldexp(static_cast<double>(random()), static_cast<int>(random() % 60) - 80)});
  }
  for (const scene::DecimalMark mark : {scene::DecimalMark::Comma, scene::DecimalMark::Point}) {
    scene::set_decimal_mark(mark);
    const QString rows = rows_of_points(points);
    EXPECT_EQ(rows.contains(','), mark == scene::DecimalMark::Comma);
    const auto read = points_of_rows(rows);
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(*read, points);
  }
}

TEST(VertexModel, TwoHundredThousandRowsOpenInLessThanAFrame) {
  geom::Polyline line;
  for (int i = 0; i < 200000; ++i) line.points.push_back({0.5 * i, std::sin(0.01 * i)});
  VertexModel model;
  QTableView view;
  view.verticalHeader()->hide();
  view.setModel(&model);
  view.resize(300, 400);
  view.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&view, 5000));
  std::vector<TableLine> lines{{{"a", 0}, "a", line, true}};
  QElapsedTimer clock;
  clock.start();
  model.show(std::move(lines));
  view.repaint();
  const qint64 opened = clock.elapsed();
  ::testing::Test::RecordProperty("milliseconds", static_cast<int>(opened));
  EXPECT_EQ(model.rowCount(), 200000);
  EXPECT_EQ(model.data(model.index(123456, VertexModel::X), Qt::DisplayRole).toString(), "61728");
  EXPECT_LT(opened, most_milliseconds);
}

TEST(VertexModel, RowsOfSeveralLinesFollowEachOther) {
  VertexModel model;
  model.show({{{"a", 0}, "a", {{{0, 0}, {1, 1}}, false}, true},
              {{"b", 0}, "b", {{{5, 5}}, false}, false},
              {{"b", 1}, "c", {{{7, 7}, {8, 8}, {9, 9}}, true}, true}});
  ASSERT_EQ(model.rowCount(), 6);
  ASSERT_EQ(model.columnCount(), 4);
  for (int row = 0; row < 6; ++row) EXPECT_EQ(model.row_of(model.at(row)), row);
  EXPECT_EQ(model.at(2), (VertexRow{1, 0}));
  EXPECT_EQ(model.at(5), (VertexRow{2, 2}));
  EXPECT_EQ(model.data(model.index(5, VertexModel::Line), Qt::DisplayRole).toString(), "c");
  EXPECT_TRUE(model.flags(model.index(0, VertexModel::X)) & Qt::ItemIsEditable);
  EXPECT_FALSE(model.flags(model.index(0, VertexModel::Number)) & Qt::ItemIsEditable);
  EXPECT_FALSE(model.flags(model.index(2, VertexModel::X)) & Qt::ItemIsEditable);
}

class VertexPanelTest : public test::WindowFixture {
 protected:
  void open_bumps() {
    open_waves(
        "dobra = 1\nprogram = \"waves\"\n[input]\namplitude = 100.0\n"
        "[[input.bump]]\nname = \"A\"\npoints = [[100, 300], [500, 300], [900, 350]]\n"
        "[[input.bump]]\nname = \"B\"\npoints = [[500, 300], [500, 500]]\n");
    auto* dock = window.findChild<QDockWidget*>("dock.vertices");
    dock->raise();
    window.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window, 5000));
    ASSERT_TRUE(QTest::qWaitFor([&] { return panel().isVisible(); }, 5000));
  }
  VertexPanel& panel() { return window.vertices(); }
  QTableView& table() { return panel().table(); }
  std::vector<Point> bump(std::size_t i) {
    return std::get<scenario::Points>(*test::bumps_of(window.session().document()).at(i).find("points")).list();
  }
  void choose(const char* title) {
    auto* lines = panel().findChild<QComboBox*>("vertices.line");
    const int index = lines->findText(title, Qt::MatchStartsWith);
    ASSERT_GE(index, 0) << title;
    lines->setCurrentIndex(index);
    emit lines->activated(index);
    QCoreApplication::processEvents();
  }
  void click_cell(int row, int column) {
    QTest::mouseClick(table().viewport(), Qt::LeftButton, {},
                      table().visualRect(panel().model().index(row, column)).center());
  }
  void type_cell(int row, int column, const char* typed) {
    click_cell(row, column);
    QTest::keyClick(&table(), Qt::Key_F2);
    auto* line = table().findChild<QLineEdit*>();
    ASSERT_NE(line, nullptr);
    line->selectAll();
    QTest::keyClicks(line, typed);
    QTest::keyClick(line, Qt::Key_Return);
    settle();
  }
  std::string hint() { return window.findChild<QLabel*>("status.hint")->text().toStdString(); }
};

TEST_F(VertexPanelTest, WhatIsNoNumberChangesNothingAndSaysSo) {
  open_bumps();
  choose("A");
  const std::string before = text();
  for (const char* typed : {"deep", "", "1,2,3", "nan", "1e999"}) {
    type_cell(0, VertexModel::X, typed);
    EXPECT_EQ(text(), before) << typed;
  }
  EXPECT_NE(hint().find("not a number"), std::string::npos) << hint();
  EXPECT_FALSE(window.session().history().can_undo());
}

TEST_F(VertexPanelTest, ATypedCellIsOneStepOfUndoAndVerticesThereGoAlong) {
  open_bumps();
  choose("A");
  ASSERT_EQ(panel().model().rowCount(), 3);
  type_cell(1, VertexModel::Z, "320,5");
  EXPECT_EQ(bump(0)[1], (Point{500, 320.5}));
  EXPECT_EQ(bump(1)[0], (Point{500, 320.5}));
  EXPECT_TRUE(QTest::qWaitFor([&] { return panel().model().point(1) == Point{500, 320.5}; }, 5000));
  QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier);
  settle();
  EXPECT_EQ(bump(0)[1], (Point{500, 300}));
  EXPECT_EQ(bump(1)[0], (Point{500, 300}));
  EXPECT_TRUE(QTest::qWaitFor([&] { return panel().model().point(1) == Point{500, 300}; }, 5000));
}

TEST_F(VertexPanelTest, RowsAndHandlesAreSelectedTogether) {
  open_bumps();
  choose("A");
  click_cell(2, VertexModel::X);
  const canvas::Selection& selection = window.canvas().workspace().selection;
  ASSERT_EQ(selection.size(), 1U);
  EXPECT_EQ(selection.begin()->second, (std::set<std::size_t>{2}));
  // And back: a vertex that is clicked on the canvas is the row that is marked.
  const QPoint vertex = window.view().pixel_of(0, {100, 300}).toPoint();
  QTest::mouseClick(&window.view(), Qt::LeftButton, {}, vertex);
  QCoreApplication::processEvents();
  const QModelIndexList rows = table().selectionModel()->selectedRows();
  ASSERT_EQ(rows.size(), 1);
  EXPECT_EQ(rows.front().row(), 0);
}

TEST_F(VertexPanelTest, InsertDeleteAndPasteAreOneStepOfUndoEach) {
  open_bumps();
  choose("A");
  click_cell(0, VertexModel::X);
  QTest::keyClick(&table(), Qt::Key_Insert);
  settle();
  ASSERT_EQ(bump(0).size(), 4U);
  EXPECT_EQ(bump(0)[1], (Point{300, 300}));
  click_cell(1, VertexModel::X);
  QTest::keyClick(&table(), Qt::Key_Delete);
  settle();
  EXPECT_EQ(bump(0), (std::vector<Point>{{100, 300}, {500, 300}, {900, 350}}));
  QApplication::clipboard()->setText("450,5\t310\n910\t360,25\n950\t370\n");
  click_cell(1, VertexModel::X);
  QTest::keyClick(&table(), Qt::Key_V, Qt::ControlModifier);
  settle();
  EXPECT_EQ(bump(0), (std::vector<Point>{{100, 300}, {450.5, 310}, {910, 360.25}, {950, 370}}));
  for (int i = 0; i < 3; ++i) window.session().undo();
  EXPECT_EQ(bump(0), (std::vector<Point>{{100, 300}, {500, 300}, {900, 350}}));
  EXPECT_FALSE(window.session().history().can_undo());
}

TEST_F(VertexPanelTest, ALineKeepsTwoVerticesAndABadPasteChangesNothing) {
  open_bumps();
  choose("B");
  const std::string before = text();
  table().selectAll();
  QTest::keyClick(&table(), Qt::Key_Delete);
  EXPECT_EQ(text(), before);
  EXPECT_FALSE(hint().empty());
  QApplication::clipboard()->setText("1\t2\n3\tdeep\n");
  click_cell(0, VertexModel::X);
  QTest::keyClick(&table(), Qt::Key_V, Qt::ControlModifier);
  EXPECT_EQ(text(), before);
  EXPECT_NE(hint().find("row 2"), std::string::npos) << hint();
}

TEST_F(VertexPanelTest, CopiedRowsAreThoseSelected) {
  open_bumps();
  choose("A");
  click_cell(2, VertexModel::X);
  QTest::keyClick(&table(), Qt::Key_C, Qt::ControlModifier);
  EXPECT_EQ(QApplication::clipboard()->text().toStdString(), "900\t350\n");
}

TEST_F(VertexPanelTest, LinesOfAStepAreReadOnlyAndTheReasonIsSaid) {
  open_waves(test::waves_text());
  window.findChild<QDockWidget*>("dock.vertices")->raise();
  ASSERT_TRUE(QTest::qWaitFor([&] { return panel().isVisible(); }, 5000));
  auto* lines = panel().findChild<QComboBox*>("vertices.line");
  bool found = false;
  for (int i = 1; i < lines->count() && !found; ++i) {
    lines->setCurrentIndex(i);
    emit lines->activated(i);
    found = panel().findChild<QLabel*>("vertices.reason")->isVisible();
  }
  ASSERT_TRUE(found) << "no line of a step";
  EXPECT_GT(panel().model().rowCount(), 0);
  EXPECT_FALSE(panel().model().flags(panel().model().index(0, VertexModel::X)) & Qt::ItemIsEditable);
  EXPECT_FALSE(panel().findChild<QToolButton*>("vertices.paste")->isEnabled());
}

}  // namespace
}  // namespace dobra::gui::vertices
