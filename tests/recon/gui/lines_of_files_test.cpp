// What RECON's window says and writes of lines that come from a file, and of documents in feet.

#include <QAbstractButton>
#include <QDialog>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QTimer>
#include <set>

#include "shared/gui/vertices/vertex_panel.h"
#include "shared/scenario/entries.h"
#include "tests/gui/program_window.h"

namespace recon::gui {
namespace {

namespace test = dobra::test;
namespace geom = dobra::geom;
namespace scenario = dobra::scenario;

constexpr const char* columns =
    "formation;x;z\nUpper;0;-100\nUpper;500;-80\nUpper;1000;-100\nLower;0;-300\nLower;1000;-310\n";
constexpr const char* of_file = "dobra = 1\nprogram = \"recon\"\n\n[input]\n\n[[input.lines]]\nfile = \"lines.csv\"\n";
constexpr const char* in_feet =
    "dobra = 1\nprogram = \"recon\"\n\n[input]\nunit = \"ft\"\n\n[[input.horizon]]\nname = \"A\"\n"
    "points = [[0.0, -100.0], [1234.5, -80.0], [3000.0, -100.0]]\n\n[[input.horizon]]\nname = \"B\"\n"
    "points = [[0.0, -901.7], [3000.0, -902.3]]\n";

std::string points_text(test::ProgramWindow& window) {
  std::string text = window.text();
  std::erase_if(text, [](char c) { return c != '.' && (c < '0' || c > '9') && c != ','; });
  return text;
}

/// Digits of the longest number.
std::size_t longest_number(const std::string& text) {
  std::size_t longest = 0;
  std::size_t digits = 0;
  for (const char c : text) {
    digits = c >= '0' && c <= '9' ? digits + 1 : c == '.' ? digits : 0;
    longest = std::max(longest, digits);
  }
  return longest;
}

TEST(LinesOfFiles, ADrawnLineDoesNotTakeTheNameOfALineOfAFile) {
  test::ProgramWindow window("recon/fold.toml");
  window.write("lines.csv", columns);
  window.open(window.write("of_file.toml", of_file));
  const std::string before = window.text();
  window.focus();
  window.press(Qt::Key_L);
  window.click(window.pixel(0, {100.0, -200.0}));
  window.click(window.pixel(0, {800.0, -210.0}));
  std::string refused;
  std::string after_refusal;
  QTimer::singleShot(0, window.focused(), [&] {
    auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    ASSERT_NE(dialog, nullptr);
    auto* name = dialog->findChild<QLineEdit*>("name");
    for (const char c : std::string("Lower")) QTest::keyClick(name, c);
    QTest::keyClick(name, Qt::Key_Return);
    refused = dialog->findChild<QLabel*>("refused")->text().toStdString();
    after_refusal = window.text();
    QTest::keyClick(name, Qt::Key_A, Qt::ControlModifier);
    for (const char c : std::string("Middle")) QTest::keyClick(name, c);
    QTest::keyClick(name, Qt::Key_Return);
  });
  window.press(Qt::Key_Return);
  window.come_to_rest();
  EXPECT_EQ(refused, "another one has this name already; give another name");
  EXPECT_EQ(after_refusal, before);
  EXPECT_NE(window.text().find("Middle"), std::string::npos);
  EXPECT_FALSE(window->session().outcome()->run.error);
}

TEST(LinesOfFiles, WhatIsAskedAboutStaysOnTheSheet) {
  test::ProgramWindow window("recon/fold.toml");
  window.write("lines.csv", columns);
  window.open(window.write("of_file.toml", of_file));
  window.focus();
  window.press(Qt::Key_L);
  const QPointF from = window.pixel(0, {100.0, -200.0});
  const QPointF to = window.pixel(0, {800.0, -200.0});
  const QPointF middle = 0.5 * (from + to);
  const auto colors_there = [&] {
    const QImage seen = window->view().grab().toImage();
    const double ratio = seen.devicePixelRatio();
    std::set<QRgb> colors;
    for (int x = -6; x <= 6; ++x) {
      for (int y = -2; y <= 2; ++y) colors.insert(seen.pixel(((middle + QPointF(x, y)) * ratio).toPoint()));
    }
    return colors.size();
  };
  EXPECT_EQ(colors_there(), 1u);
  window.click(from);
  window.click(to);
  std::size_t while_asked = 0;
  QTimer::singleShot(0, window.focused(), [&] {
    auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    ASSERT_NE(dialog, nullptr);
    while_asked = colors_there();
    QTest::keyClick(dialog, Qt::Key_Escape);
  });
  window.press(Qt::Key_Return);
  window.come_to_rest();
  EXPECT_GT(while_asked, 1u);
  EXPECT_EQ(colors_there(), 1u);
}

TEST(LinesOfFiles, RemarksSpeakOfTheFieldsOfTheForm) {
  test::ProgramWindow window("recon/fold.toml");
  window.write("lines.csv", columns);
  window.open(window.write("of_file.toml", of_file));
  QString all;
  for (const QLabel* label : window->findChild<QDockWidget*>("dock.results")->findChildren<QLabel*>())
    all += label->text();
  EXPECT_TRUE(all.contains("'Columns of names' says another")) << all.toStdString();
  EXPECT_FALSE(all.contains("--")) << all.toStdString();
}

TEST(DocumentInFeet, ADraggedVertexIsWrittenInShortNumbers) {
  test::ProgramWindow window("recon/fold.toml");
  window.open(window.write("feet.toml", in_feet));
  window.focus();
  const geom::Point vertex{0.3048 * 1234.5, 0.3048 * -80.0};
  const QPointF at = window.pixel(0, vertex);
  window.click(window.pixel(0, {0.3048 * 600.0, 0.3048 * -90.28}));
  window.hold(at);
  window.move(at + QPointF(10, -31), Qt::LeftButton);
  window.move(at + QPointF(23, -47), Qt::LeftButton);
  window.let_go(at + QPointF(23, -47));
  window.come_to_rest();
  scenario::Entries horizons = scenario::entries_of(window.document().input, "horizon");
  const geom::Point moved = scenario::points_in(horizons[0])[1];
  EXPECT_GT(moved.x, 1240.0);
  EXPECT_GT(moved.y, -79.0);
  EXPECT_LE(longest_number(points_text(window)), 7u) << window.text();
}

TEST(DocumentInFeet, ADrawnLineIsWrittenInShortNumbersAndASnappedEndIsTheVertex) {
  test::ProgramWindow window("recon/fold.toml");
  window.open(window.write("feet.toml", in_feet));
  window.focus();
  window.press(Qt::Key_L);
  window.click(window.pixel(0, {0.3048 * 0.0, 0.3048 * -901.7}));  // snaps to the first vertex of B
  window.click(window.pixel(0, {0.3048 * 1777.7, 0.3048 * -503.3}));
  QTimer::singleShot(0, window.focused(), [&] {
    auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    ASSERT_NE(dialog, nullptr);
    auto* name = dialog->findChild<QLineEdit*>("name");
    QTest::keyClick(name, 'C');
    QTest::keyClick(name, Qt::Key_Return);
  });
  window.press(Qt::Key_Return);
  window.come_to_rest();
  scenario::Entries horizons = scenario::entries_of(window.document().input, "horizon");
  ASSERT_EQ(horizons.size(), 3u);
  const std::vector<geom::Point> drawn = scenario::points_in(horizons[2]);
  EXPECT_EQ(drawn[0], (geom::Point{0.0, -901.7}));
  EXPECT_LE(longest_number(points_text(window)), 7u) << window.text();
}

TEST(WelcomePage, ImportsFiles) {
  test::ProgramWindow window("recon/fold.toml");
  window->welcome();
  auto* button = window->findChild<QAbstractButton*>("welcome.import");
  ASSERT_NE(button, nullptr);
  QString title;
  QTimer::singleShot(0, button, [&] {
    auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    ASSERT_NE(dialog, nullptr);
    title = dialog->windowTitle();
    QTest::keyClick(dialog, Qt::Key_Escape);
  });
  QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_EQ(title, "Import files");
}

TEST(EmptySheet, HasHeightsAsSectionsDo) {
  test::ProgramWindow window("recon/fold.toml");
  window.focus();
  EXPECT_EQ(window->view().axes(0).y_title, "z [m]");
}

}  // namespace
}  // namespace recon::gui
