// What a program adds to its window is there wherever the window's own is: menus, bar, keys, palette, panels.

#include "shared/gui/window_part.h"

#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QSettings>
#include <QToolBar>

#include "shared/gui/canvas.h"
#include "tests/shared/gui/window_fixture.h"

namespace dobra::gui {
namespace {

/// A click makes the amplitude what its height is.
class Height final : public canvas::Tool {
 public:
  explicit Height(Session& session) : session_(session) {}
  [[nodiscard]] std::string hint() const override { return "Click a height"; }
  void press(canvas::Workspace&, const canvas::Pointer& pointer) override {
    scenario::Document document = session_.document();
    document.input.set("amplitude", pointer.place().y);
    session_.edit(std::move(document), "Height");
  }
  void move(canvas::Workspace&, const canvas::Pointer&) override {}
  bool key(canvas::Workspace&, canvas::Key key) override {
    if (key != canvas::Key::Escape) return false;
    say(canvas::PutAway{});
    return true;
  }
  [[nodiscard]] canvas::Overlay overlay(const canvas::Workspace&) const override { return {}; }

 private:
  Session& session_;
};

class WindowPartTest : public testing::Test {
 protected:
  WindowPartTest() {
    QSettings(QSettings::IniFormat, QSettings::UserScope, "Dobra", "waves").clear();
    window.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&window, 10000));
    EXPECT_TRUE(window.open(folder.write("waves.toml", test::waves_text())).ok());
    settle();
  }
  void settle() {
    EXPECT_TRUE(QTest::qWaitFor([&] { return !window.session().busy(); }, 30000));
    QCoreApplication::processEvents();
  }
  static WindowPart part() {
    return {.tools = {{.name = "height",
                       .text = "Height",
                       .help = "Sets the amplitude",
                       .icon = [](QPainter& painter) { painter.drawLine(QPointF(12, 2), QPointF(12, 22)); },
                       .key = QKeySequence(Qt::Key_Q),
                       .make = [](const Desk& desk) { return std::make_unique<Height>(desk.session); }}},
            .panels = {
                {.name = "amplitude", .title = "Amplitude", .make = [](const Desk& desk, QWidget* parent) -> QWidget* {
                   auto* made = new QLabel(parent);
                   QObject::connect(&desk.session, &Session::run_finished, made, [made, &session = desk.session] {
                     const scenario::Value* now = session.document().input.find("amplitude");
                     made->setText(now == nullptr ? QString("none") : QString::number(std::get<double>(*now)));
                   });
                   return made;
                 }}}};
  }

  test::TemporaryFolder folder;
  const scenario::Program program = test::fake_program();
  MainWindow window{program, part()};
};

TEST_F(WindowPartTest, AToolIsInMenuAndBarAndWorksByItsKeyAndTheMouse) {
  const std::string before = scenario::document_text(window.session().document());
  QAction* action = window.actions().find("draw.height");
  ASSERT_NE(action, nullptr);
  EXPECT_FALSE(action->icon().isNull());
  EXPECT_TRUE(window.actions().menu("&Draw")->actions().contains(action));
  EXPECT_TRUE(window.findChild<QToolBar*>("draw_bar")->actions().contains(action));
  window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window, 5000));
  window.view().setFocus();
  QTest::keyClick(&window.view(), Qt::Key_Q);
  EXPECT_TRUE(action->isChecked());
  EXPECT_EQ(window.canvas().tool().hint(), "Click a height");
  QTest::mouseClick(&window.view(), Qt::LeftButton, {}, window.view().plot(0).center().toPoint());
  settle();
  EXPECT_NE(scenario::document_text(window.session().document()), before);
  auto* panel = window.findChild<QDockWidget*>("dock.amplitude");
  ASSERT_NE(panel, nullptr);
  // The panel has heard of the run.
  EXPECT_EQ(qobject_cast<QLabel*>(panel->widget())->text(),
            QString::number(std::get<double>(*window.session().document().input.find("amplitude"))));
  QTest::keyClick(&window.view(), Qt::Key_Escape);
  EXPECT_TRUE(window.actions().find("draw.select")->isChecked());
  window.undo();
  EXPECT_EQ(scenario::document_text(window.session().document()), before);
}

TEST_F(WindowPartTest, APanelIsShownAndHiddenLikeTheOthersAndResetWithThem) {
  auto* panel = window.findChild<QDockWidget*>("dock.amplitude");
  QAction* action = window.actions().find("view.panel.amplitude");
  ASSERT_NE(action, nullptr);
  EXPECT_TRUE(window.actions().menu("&View/&Panels")->actions().contains(action));
  EXPECT_FALSE(panel->isHidden());
  action->trigger();
  EXPECT_TRUE(panel->isHidden());
  window.reset_layout();
  EXPECT_FALSE(panel->isHidden());
  EXPECT_TRUE(window.tabifiedDockWidgets(panel).contains(window.findChild<QDockWidget*>("dock.results")));
}

TEST_F(WindowPartTest, AWindowWithoutPartsHasNoneOfThem) {
  const MainWindow plain(program);
  EXPECT_EQ(const_cast<MainWindow&>(plain).actions().find("draw.height"), nullptr);
  EXPECT_EQ(plain.findChild<QDockWidget*>("dock.amplitude"), nullptr);
}

}  // namespace
}  // namespace dobra::gui
