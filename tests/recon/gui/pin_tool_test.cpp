#include "recon/gui/pin_tool.h"

#include <QLabel>
#include <cmath>

#include "shared/gui/documents/edit.h"
#include "shared/gui/labels/status_line.h"
#include "tests/gui/program_window.h"

namespace recon::gui {
namespace {

namespace test = dobra::test;
namespace geom = dobra::geom;
namespace scenario = dobra::scenario;

double pin_of(const scenario::Document& document, std::size_t step) {
  const scenario::Value* pin = document.steps[step - 1].params.find("pin");
  return pin == nullptr ? std::nan("") : std::get<double>(*pin);
}

std::string report(test::ProgramWindow& window) {
  const auto& outcome = *window->session().outcome();
  return scenario::report_json(*outcome.document, window->session().program(), outcome.run);
}

/// What the mouse has told so far, as the status bar shows it.
QString hint(test::ProgramWindow& window) {
  QString all;
  for (const QLabel* each : window->findChild<dobra::gui::labels::StatusLine*>()->findChildren<QLabel*>())
    all += each->text() + "\n";
  return all;
}

TEST(PinTool, AGestureDoesWhatTypingDoesAndUndoRestoresTheBytes) {
  test::ProgramWindow window("recon/fold.toml");
  window.open();
  const std::string before = window.text();
  const std::string before_report = report(window);
  window.focus();
  window.press(Qt::Key_N);
  const std::size_t deformed = window.panel("deformed");
  const QPointF from = window.pixel(deformed, {1000.0, -600.0});
  const QPointF to = window.pixel(deformed, {2500.0, -600.0});
  window.hold(from);
  EXPECT_EQ(window.text(), before);
  window.move(0.5 * (from + to), Qt::LeftButton);
  window.move(to, Qt::LeftButton);
  // While it lasts it is looked at, and the document stays.
  ASSERT_TRUE(QTest::qWaitFor([&] { return !window->session().busy(); }, 60000));
  EXPECT_NE(report(window), before_report);
  EXPECT_EQ(window.text(), before);
  window.let_go(to);
  window.come_to_rest();
  const double pin = pin_of(window.document(), 2);
  EXPECT_NEAR(pin, 2500.0, 15.0);  // a pixel is some 10 m
  const std::string after = window.text();
  const std::string after_report = report(window);
  EXPECT_EQ(window->session().history().undo_text(), "Move the pin");

  window->undo();
  window.come_to_rest();
  EXPECT_EQ(window.text(), before);
  EXPECT_EQ(report(window), before_report);
  EXPECT_FALSE(window->session().history().can_undo());

  // The same number in the form.
  window->select(2);
  ASSERT_TRUE(window->form().form()->type("pin", QString::number(pin, 'g', 17).toUtf8().constData()).ok());
  window.come_to_rest();
  EXPECT_EQ(window.text(), after);
  EXPECT_EQ(report(window), after_report);
}

TEST(PinTool, EscapeAmidTheGestureLeavesTheDocumentAndShowsItAgain) {
  test::ProgramWindow window("recon/fold.toml");
  window.open();
  const std::string before = window.text();
  const std::string before_report = report(window);
  window.focus();
  window.press(Qt::Key_N);
  const QPointF from = window.pixel(0, {1000.0, -600.0});
  window.hold(from);
  window.move(from + QPointF(80, 0), Qt::LeftButton);
  window.come_to_rest();
  EXPECT_NE(report(window), before_report);
  window.press(Qt::Key_Escape);
  window.move(from + QPointF(120, 0), Qt::LeftButton);
  window.let_go(from + QPointF(120, 0));
  window.come_to_rest();
  EXPECT_EQ(window.text(), before);
  EXPECT_EQ(report(window), before_report);
  EXPECT_FALSE(window->session().history().can_undo());
}

TEST(PinTool, StaysAtTheEndOfTheTop) {
  test::ProgramWindow window("recon/fold.toml");
  window.open();
  window.focus();
  window.press(Qt::Key_N);
  const QRectF plot = window->view().plot(0);
  const QPointF from = window.pixel(0, {1000.0, -600.0});
  const QPointF edge(plot.left() + 2.0, from.y());
  window.hold(from);
  window.move(edge, Qt::LeftButton);
  window.let_go(edge);
  window.come_to_rest();
  // The file of the top begins at x = 0.
  EXPECT_EQ(pin_of(window.document(), 2), 0.0);
  EXPECT_FALSE(window->session().outcome()->run.error);
}

/// A chain has two pins: the one of the section that is pointed at is dragged, and the other stays.
TEST(PinTool, OfAChainTheSectionThatIsPointedAtGivesTheStep) {
  test::ProgramWindow window("recon/chain.toml");
  window.open();
  std::vector<std::size_t> targets;
  for (std::size_t step = 1; step <= window.document().steps.size(); ++step) {
    if (window.document().steps[step - 1].operation == "target") targets.push_back(step);
  }
  ASSERT_EQ(targets.size(), 2u);
  for (const auto& [look, step] : {std::pair("input", targets[0]), std::pair("result", targets[1])}) {
    const std::string before = window.text();
    ASSERT_TRUE(window->look_at(look));
    window.come_to_rest();
    window.focus();
    window.press(Qt::Key_N);
    const std::size_t other = step == targets[0] ? targets[1] : targets[0];
    const scenario::Document unchanged = window.document();
    const QPointF from = window->view().plot(0).center();
    window.hold(from);
    window.move(from + QPointF(25, 0), Qt::LeftButton);
    window.let_go(from + QPointF(25, 0));
    window.come_to_rest();
    EXPECT_TRUE(std::isfinite(pin_of(window.document(), step))) << look;
    EXPECT_EQ(scenario::document_text(dobra::gui::documents::with_table(
                  window.document(), step, dobra::gui::documents::table_of(unchanged, step))),
              before)
        << look;
    EXPECT_EQ(dobra::gui::documents::table_of(window.document(), other).entries().size(),
              dobra::gui::documents::table_of(unchanged, other).entries().size());
  }
}

/// What is made by the restoration has no pin of its own; nothing changes, and the status bar says where to press.
TEST(PinTool, OnTheRestoredSectionOrWithoutATargetItSaysWhatIsMissing) {
  {
    test::ProgramWindow window("recon/fold.toml");
    window.open();
    const std::string before = window.text();
    window.focus();
    window.press(Qt::Key_N);
    const QRectF plot = window->view().plot(window.panel("restored"));
    window.click(plot.center());
    window.come_to_rest();
    EXPECT_EQ(window.text(), before);
    EXPECT_TRUE(hint(window).contains("The pin stands on the section that is restored")) << hint(window).toStdString();
  }
  test::ProgramWindow window("recon/listric.toml");
  window.open();
  const std::string before = window.text();
  window.focus();
  window.press(Qt::Key_N);
  window.click(window->view().plot(0).center());
  EXPECT_EQ(window.text(), before);
  EXPECT_TRUE(hint(window).contains("no step 'Target'")) << hint(window).toStdString();
}

/// Undo amid the gesture: what was pressed for is over.
TEST(PinTool, UndoAmidTheGestureEndsItAndUndoesNothingElse) {
  test::ProgramWindow window("recon/fold.toml");
  window.open();
  window.focus();
  window.press(Qt::Key_N);
  const QPointF from = window.pixel(0, {1000.0, -600.0});
  window.hold(from);
  window.let_go(from);
  window.come_to_rest();
  const std::string once = window.text();
  window.hold(from + QPointF(60, 0));
  window.move(from + QPointF(90, 0), Qt::LeftButton);
  EXPECT_TRUE(window->undo());
  window.move(from + QPointF(95, 0), Qt::LeftButton);
  window.let_go(from + QPointF(95, 0));
  window.come_to_rest();
  EXPECT_EQ(window.text(), once);
}

}  // namespace
}  // namespace recon::gui
