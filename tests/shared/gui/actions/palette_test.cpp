// What can be done is found in menus, bars, by keys and in the palette, from one list.

#include "shared/gui/actions/palette.h"

#include <QAction>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>
#include <QTreeWidget>
#include <algorithm>
#include <cctype>
#include <set>

#include "shared/gui/actions/registry.h"
#include "shared/gui/canvas.h"
#include "tests/shared/gui/brazilian.h"
#include "tests/shared/gui/window_fixture.h"

namespace dobra::gui {
namespace {

class PaletteTest : public test::WindowFixture {
 protected:
  void open_palette() {
    window.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window, 5000));
    if (window.focusWidget() == nullptr) window.view().setFocus();
    press(Qt::Key_K, Qt::ControlModifier);
    ASSERT_TRUE(window.palette().isVisible());
  }
  void type_there(const char* words) {
    for (const QChar c : QString::fromUtf8(words)) QTest::keyClick(focus(), c.toLatin1());
  }
  QTreeWidget* list() { return window.palette().findChild<QTreeWidget*>("palette.list"); }
  std::size_t steps() { return window.session().document().steps.size(); }
};

TEST_F(PaletteTest, OpensTypesAndDoesByKeysAlone) {
  open_waves();
  window.view().setFocus();
  open_palette();
  type_there("STACK add");
  ASSERT_FALSE(window.palette().listed().isEmpty());
  EXPECT_EQ(window.palette().listed().front(), "Add 'Stack of waves'");
  EXPECT_EQ(steps(), 1U);
  press(Qt::Key_Return);
  EXPECT_FALSE(window.palette().isVisible());
  EXPECT_TRUE(QTest::qWaitFor([&] { return steps() == 2; }, 5000));
  EXPECT_EQ(window.session().document().steps.back().operation, "stack");
}

TEST_F(PaletteTest, ATitleGoesBeforeWhatIsSaidOfOthers) {
  open_waves();
  open_palette();
  type_there("waves");
  ASSERT_GE(window.palette().listed().size(), 1);
  const auto has_the_word = [](const QString& title) { return title.contains("waves", Qt::CaseInsensitive); };
  bool before = true;
  for (const QString& title : window.palette().listed()) {
    EXPECT_TRUE(before || !has_the_word(title)) << title.toStdString();
    before = has_the_word(title);
  }
  // Words of a title within quotes begin a title's word as any other.
  using actions::Choice;
  const std::vector<Choice> choices{{"Add 'Parallel curves'", {}, {}, "curves that grade the mesh", true, {}},
                                    {"Remesh", {}, {}, {}, true, {}},
                                    {"Add 'Mesh'", {}, {}, {}, true, {}}};
  EXPECT_EQ(actions::found(choices, "mesh"), (std::vector<std::size_t>{2, 1, 0}));
  EXPECT_EQ(actions::found(choices, "add mesh"), (std::vector<std::size_t>{2, 0}));
}

TEST_F(PaletteTest, SaysThatNothingIsFound) {
  open_waves();
  open_palette();
  const auto* nothing = window.palette().findChild<QLabel*>("palette.nothing");
  EXPECT_FALSE(nothing->isVisible());
  type_there("zzqx");
  EXPECT_TRUE(window.palette().listed().isEmpty());
  EXPECT_TRUE(nothing->isVisible());
  press(Qt::Key_Backspace);
  press(Qt::Key_Backspace);
  press(Qt::Key_Backspace);
  press(Qt::Key_Backspace);
  EXPECT_FALSE(nothing->isVisible());
}

TEST_F(PaletteTest, EscapeClosesGivesTheFocusBackAndStopsNoRun) {
  open_waves();
  window.view().setFocus();
  emit window.steps().add_asked("sleep");
  ASSERT_TRUE(type("seconds", "60").ok());
  ASSERT_TRUE(QTest::qWaitFor([&] { return window.steps().state(2) == PartState::Running; }, 5000));
  window.view().setFocus();
  open_palette();
  press(Qt::Key_Escape);
  EXPECT_FALSE(window.palette().isVisible());
  EXPECT_EQ(QApplication::focusWidget(), &window.view());
  EXPECT_TRUE(window.session().busy());
  window.session().cancel();
  settle();
}

TEST_F(PaletteTest, ArrowsMoveAndGoRound) {
  open_waves();
  open_palette();
  const int count = list()->topLevelItemCount();
  EXPECT_GT(count, 40);
  press(Qt::Key_Up);
  EXPECT_EQ(list()->indexOfTopLevelItem(list()->currentItem()), count - 1);
  press(Qt::Key_Down);
  press(Qt::Key_Down);
  EXPECT_EQ(list()->indexOfTopLevelItem(list()->currentItem()), 1);
  press(Qt::Key_PageDown);
  EXPECT_EQ(list()->indexOfTopLevelItem(list()->currentItem()), 11);
}

TEST_F(PaletteTest, WhatCannotBeDoneIsGreyAndDoesNothing) {
  open_waves();
  open_palette();
  type_there("edit.redo");
  ASSERT_EQ(window.palette().listed(), QStringList{"Redo"});
  EXPECT_EQ(list()->topLevelItem(0)->foreground(0).color(), window.QWidget::palette().color(QPalette::PlaceholderText));
  press(Qt::Key_Return);
  EXPECT_TRUE(window.palette().isVisible());
  EXPECT_FALSE(window.isWindowModified());
  press(Qt::Key_Escape);
  ASSERT_TRUE(type("count", "9").ok());
  window.session().undo();
  open_palette();
  type_there("edit.redo");
  press(Qt::Key_Return);
  QCoreApplication::processEvents();
  EXPECT_TRUE(window.isWindowModified());
}

TEST_F(PaletteTest, GoesToStepsTogglesLayersAndOpensRecentFiles) {
  open_waves();
  ASSERT_TRUE(window.save(folder / "other.toml").ok());
  window.select(1);
  open_palette();
  type_there("go input");
  press(Qt::Key_Return);
  QCoreApplication::processEvents();
  EXPECT_EQ(window.steps().selected(), 0U);
  open_palette();
  type_there("hide after/bed");
  press(Qt::Key_Return);
  QCoreApplication::processEvents();
  scene::Picture shown = window.layers().chosen(*window.session().outcome()->picture);
  EXPECT_FALSE(shown.panels[1].layers[0].visible);
  EXPECT_TRUE(shown.panels[0].layers[0].visible);
  open_palette();
  type_there("show after/bed");
  press(Qt::Key_Return);
  QCoreApplication::processEvents();
  shown = window.layers().chosen(*window.session().outcome()->picture);
  EXPECT_TRUE(shown.panels[1].layers[0].visible);
  open_palette();
  type_there((folder / "waves.toml").c_str());
  ASSERT_EQ(window.palette().listed(), QStringList{"Open waves.toml"});
  press(Qt::Key_Return);
  settle();
  EXPECT_EQ(window.session().document().file.filename(), "waves.toml");
}

TEST_F(PaletteTest, ShowsKeysAndTheMenu) {
  open_waves();
  open_palette();
  type_there("save_picture");
  ASSERT_EQ(list()->topLevelItemCount(), 1);
  EXPECT_EQ(list()->topLevelItem(0)->text(1), "File");
  EXPECT_EQ(list()->topLevelItem(0)->text(2), "Ctrl+E");
}

TEST_F(PaletteTest, FindsTranslatedAndEnglishWordsWithoutAccents) {
  const test::Brazilian language;
  MainWindow theirs(program);
  window.hide();
  theirs.show();
  theirs.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&theirs, 5000));
  theirs.view().setFocus();
  for (const char* typed : {"resultado", "the result"}) {
    press(Qt::Key_K, Qt::ControlModifier);
    ASSERT_TRUE(theirs.palette().isVisible());
    type_there(typed);
    EXPECT_TRUE(theirs.palette().listed().contains("O resultado  ✓")) << typed;
    press(Qt::Key_Escape);
  }
  press(Qt::Key_K, Qt::ControlModifier);
  type_there("retangulo");
  EXPECT_EQ(theirs.palette().listed(), QStringList{QString::fromUtf8("Retângulo")});
}

/// Every action that a menu shows, by itself or below it.
void collect(const QMenu& menu, std::multiset<std::string>& ids) {
  for (const QAction* each : menu.actions()) {
    if (each->isSeparator()) continue;
    if (each->menu() != nullptr && each->objectName().isEmpty())
      collect(*each->menu(), ids);
    else
      ids.insert(each->objectName().toStdString());
  }
}

TEST_F(PaletteTest, MenusAndBarsShowTheRegistryAndNothingElse) {
  open_waves();
  std::multiset<std::string> in_menus;
  for (const QAction* top : window.menuBar()->actions()) collect(*top->menu(), in_menus);
  std::multiset<std::string> registered;
  for (const actions::Registry::Entry& entry : window.actions().all()) {
    EXPECT_EQ(entry.made->objectName().toStdString(), entry.action.id);
    if (!entry.action.menu.empty()) registered.insert(entry.action.id);
  }
  EXPECT_EQ(in_menus, registered);
  EXPECT_GT(in_menus.size(), 35U);
  for (const char* id : {"file.open", "draw.line", "look.result", "edit.undo", "view.panel.steps", "run.cancel"})
    EXPECT_TRUE(in_menus.contains(id)) << id;
  std::size_t on_bars = 0;
  for (const QToolBar* bar : window.findChildren<QToolBar*>()) {
    for (QAction* each : bar->actions()) {
      if (each->isSeparator()) continue;
      ++on_bars;
      EXPECT_EQ(window.actions().find(each->objectName().toStdString()), each);
      EXPECT_FALSE(each->icon().isNull()) << each->objectName().toStdString();
    }
  }
  EXPECT_GT(on_bars, 25U);
}

TEST_F(PaletteTest, NoKeyDoesTwoThings) {
  std::set<QString> keys;
  for (const QAction* each : window.findChildren<QAction*>()) {
    if (each->shortcutContext() != Qt::WindowShortcut) continue;
    for (const QKeySequence& key : each->shortcuts())
      EXPECT_TRUE(keys.insert(key.toString()).second) << key.toString().toStdString();
  }
  EXPECT_GT(keys.size(), 25U);
}

TEST_F(PaletteTest, TheListOfKeysIsThatOfTheActions) {
  QStringList listed;
  QTimer::singleShot(200, &window, [&] {
    auto* keys = QApplication::activeModalWidget()->findChild<QTreeWidget*>("keys");
    for (int i = 0; keys != nullptr && i < keys->topLevelItemCount(); ++i)
      listed << keys->topLevelItem(i)->text(0) + "|" + keys->topLevelItem(i)->text(1);
    QTest::keyClick(QApplication::activeModalWidget(), Qt::Key_Escape);
  });
  ASSERT_TRUE(window.actions().trigger("help.keys"));
  EXPECT_TRUE(listed.contains("Redo|Ctrl+Shift+Z, Ctrl+Y")) << listed.join('\n').toStdString();
  EXPECT_TRUE(listed.contains("Line|L"));
  EXPECT_TRUE(listed.contains("Find an action|Ctrl+K"));
}

TEST_F(PaletteTest, ButtonsOfTheListOfStepsAreTheActions) {
  open_waves();
  window.select(1);
  QCoreApplication::processEvents();
  for (const auto& [name, enabled] : {std::pair{"remove", true}, {"up", false}, {"down", false}}) {
    auto* button = window.findChild<QToolButton*>(QString("button.") + name);
    ASSERT_NE(button, nullptr);
    EXPECT_EQ(button->isEnabled(), enabled) << name;
    EXPECT_EQ(button->defaultAction(), window.actions().find(std::string("step.") + name));
  }
  click(window.findChild<QWidget*>("button.remove"));
  EXPECT_EQ(steps(), 0U);
  window.session().undo();
  ASSERT_EQ(steps(), 1U);
  window.select(1);
  window.steps().setFocus();
  press(Qt::Key_Delete);
  EXPECT_EQ(steps(), 0U);
}

TEST_F(PaletteTest, EveryActionIsTranslated) {
  const test::Brazilian language;
  for (const actions::Registry::Entry& entry : window.actions().all()) {
    if (entry.action.id.starts_with("step.add.")) continue;    // words of the small program
    if (entry.action.id.starts_with("view.panel.")) continue;  // titles of panels are translated where they are made
    for (const std::string& words : {entry.action.text, entry.action.help})
      EXPECT_TRUE(!std::ranges::any_of(words, [](unsigned char c) { return std::isalpha(c) != 0; }) ||
                  actions::shown(words).toStdString() != words)
          << entry.action.id << ": " << words;
  }
}

}  // namespace
}  // namespace dobra::gui
