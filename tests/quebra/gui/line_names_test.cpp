// What QUEBRA's window calls curves, cracks and their coordinates.

#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QTableView>

#include "shared/gui/labels/status_line.h"
#include "shared/gui/mending/error_bar.h"
#include "tests/gui/program_window.h"
#include "tests/shared/gui/brazilian.h"

namespace quebra::gui {
namespace {

namespace test = dobra::test;

constexpr const char* with_cracks =
    "dobra = 1\nprogram = \"quebra\"\n\n[input]\n\n[[input.curve]]\nname = \"plate\"\nkind = \"polygon\"\n"
    "points = [[0.0, 0.0], [8.0, 0.0], [8.0, 6.0], [0.0, 6.0]]\n\n[[input.crack]]\nname = \"left one\"\n"
    "points = [[0.0, 2.0], [2.0, 2.5]]\n\n[[input.crack]]\nname = \"inner one\"\npoints = [[4.0, 4.0], [6.0, 4.5]]\n";

struct Seen {
  explicit Seen(test::ProgramWindow& window) : window_(window) {
    auto* dock = window->findChild<QDockWidget*>("dock.vertices");
    dock->show();
    dock->raise();
    QCoreApplication::processEvents();
    table = dock->findChild<QTableView*>();
    lines = dock->findChild<QComboBox*>();
  }
  QString header(int column) { return table->model()->headerData(column, Qt::Horizontal).toString(); }
  QString hint() { return window_->findChild<QLabel*>("status.hint")->text(); }

  QTableView* table = nullptr;
  QComboBox* lines = nullptr;

 private:
  test::ProgramWindow& window_;
};

TEST(LineNames, ACrackIsCalledByItsOwnName) {
  test::ProgramWindow window("quebra/plate_with_hole.toml");
  window.open(window.write("cracks.toml", with_cracks));
  window.focus();
  Seen seen(window);
  window.click(window.pixel(0, {5.0, 4.25}));
  EXPECT_TRUE(seen.hint().startsWith("inner one: ")) << seen.hint().toStdString();
  EXPECT_EQ(seen.lines->currentText(), "inner one");
  QStringList all;
  for (int i = 1; i < seen.lines->count(); ++i) all << seen.lines->itemText(i);
  all.sort();
  EXPECT_EQ(all, (QStringList{"inner one", "left one", "plate"})) << all.join("|").toStdString();
}

constexpr const char* twice =
    "dobra = 1\nprogram = \"quebra\"\n\n[input]\n\n[[input.curve]]\nname = \"a\"\nkind = \"polygon\"\n"
    "points = [[0.0, 0.0], [8.0, 0.0], [8.0, 6.0]]\n\n[[input.curve]]\nname = \"b\"\nkind = \"polygon\"\n"
    "points = [[0.0, 0.0], [8.0, 0.0], [8.0, 6.0]]\n";

/// Of the option of the command line, the key and the table only the title of the field is left.
TEST(ErrorsOfTheInput, CallOptionsByTheTitlesOfTheirFields) {
  const auto said = [] {
    test::ProgramWindow window("quebra/plate_with_hole.toml");
    window.open(window.write("twice.toml", twice));
    return window->error_bar().message();
  };
  const QString english = said();
  EXPECT_TRUE(english.contains("'Repair' = \"yes\"")) << english.toStdString();
  EXPECT_FALSE(english.contains("--")) << english.toStdString();
  EXPECT_FALSE(english.contains("[input]")) << english.toStdString();
  const test::Brazilian language;
  const QString brazilian = said();
  EXPECT_TRUE(brazilian.contains("'Reparo' = \"yes\"")) << brazilian.toStdString();
  EXPECT_FALSE(brazilian.contains("--")) << brazilian.toStdString();
  EXPECT_TRUE(brazilian.contains("as curvas 'a' e 'b' são idênticas")) << brazilian.toStdString();
  EXPECT_FALSE(brazilian.contains("leaves")) << brazilian.toStdString();
}

TEST(LineNames, TheSecondCoordinateIsY) {
  test::ProgramWindow window("quebra/plate_with_hole.toml");
  window.open(window.write("cracks.toml", with_cracks));
  window.focus();
  Seen seen(window);
  window.click(window.pixel(0, {5.0, 4.25}));
  EXPECT_EQ(seen.header(1), "x [m]");
  EXPECT_EQ(seen.header(2), "y [m]");
  window.focus();
  window.press(Qt::Key_L);
  EXPECT_EQ(seen.hint(), "Click the first point, or type x,y");
  window.click(window.pixel(0, {1.0, 5.0}));
  EXPECT_TRUE(seen.hint().contains("@dx,dy")) << seen.hint().toStdString();
}

}  // namespace
}  // namespace quebra::gui
