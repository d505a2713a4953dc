// What is typed reaches the document by the keys and clicks that a person uses.

#include <QAccessible>
#include <QAction>
#include <QClipboard>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QStatusBar>
#include <QTimer>

#include "shared/gui/messages.h"
#include "tests/shared/gui/window_fixture.h"

namespace dobra::gui {
namespace {

class Keys : public test::WindowFixture {
 protected:
  const scenario::Table& stack() { return window.session().document().steps.at(0).params; }
  std::int64_t count() { return std::get<std::int64_t>(*stack().find("count")); }
  /// Presses the button of that text in the next box that asks.
  void answer(const char* button) {
    auto* timer = new QTimer(&window);
    QObject::connect(timer, &QTimer::timeout, timer, [this, timer, button] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (box == nullptr) return;
      asked = box->text();
      for (QAbstractButton* each : box->buttons()) {
        if (each->text() != button) continue;
        timer->deleteLater();
        timer->stop();
        QTest::mouseClick(each, Qt::LeftButton);
        return;
      }
    });
    timer->start(10);
  }
  QString asked;
};

TEST_F(Keys, EnterInANumberFieldCommitsIt) {
  open_waves();
  write("count", "7");
  EXPECT_EQ(count(), 4);
  press(Qt::Key_Return);
  EXPECT_EQ(count(), 7);
  write("distance", "12.5");
  press(Qt::Key_Enter);
  EXPECT_EQ(*stack().find("distance"), scenario::Value(12.5));
}

TEST_F(Keys, EnterTwiceIsOneEdit) {
  open_waves();
  write("count", "7");
  press(Qt::Key_Return);
  press(Qt::Key_Return);
  press(Qt::Key_Tab);
  window.session().undo();
  EXPECT_EQ(count(), 4);
  EXPECT_FALSE(window.session().history().can_undo());
}

TEST_F(Keys, TabCommitsEveryKindOfEditor) {
  open_waves();
  for (const auto& [key, typed] :
       {std::pair{"count", "6"}, {"tilt", "5"}, {"note", "words"}, {"datum", "0, 0\n9, 1"}}) {
    write(key, typed);
    press(Qt::Key_Tab);
    EXPECT_NE(stack().find(key), nullptr) << key;
  }
  EXPECT_EQ(*stack().find("datum"), scenario::Value(std::vector<geom::Point>{{0, 0}, {9, 1}}));
}

TEST_F(Keys, SaveWritesWhatIsStillBeingTyped) {
  for (const auto& [key, typed, line] : {std::tuple{"count", "7", "count = 7"},
                                         {"note", "words", "note = \"words\""},
                                         {"datum", "0 0\n9 1", "datum = [["}}) {
    open_waves();
    write(key, typed);
    press(Qt::Key_S, Qt::ControlModifier);
    EXPECT_NE(folder.read("waves.toml").find(line), std::string::npos) << folder.read("waves.toml");
    EXPECT_FALSE(window.isWindowModified());
  }
}

TEST_F(Keys, StepsOfTheArrowsAreSavedBeforeTheySettle) {
  open_waves();
  click(editor("count"));
  press(Qt::Key_Up);
  press(Qt::Key_Up);
  press(Qt::Key_S, Qt::ControlModifier);
  EXPECT_NE(folder.read("waves.toml").find("count = 6"), std::string::npos) << folder.read("waves.toml");
}

TEST_F(Keys, RunTakesWhatIsStillBeingTyped) {
  open_waves();
  write("count", "9");
  press(Qt::Key_F5);
  settle();
  EXPECT_DOUBLE_EQ(window.session().outcome()->quantities.at(1).value, 9.0);
}

TEST_F(Keys, QuitAsksAboutWhatIsStillBeingTyped) {
  open_waves();
  write("count", "7");
  answer("Cancel");
  press(Qt::Key_Q, Qt::ControlModifier);
  EXPECT_FALSE(asked.isEmpty());
  EXPECT_TRUE(window.isVisible());
  EXPECT_EQ(count(), 7);
}

TEST_F(Keys, QuitDoesNotAskWhereNothingWasTyped) {
  open_waves();
  click(editor("count"));
  press(Qt::Key_Q, Qt::ControlModifier);
  EXPECT_FALSE(window.isVisible());
}

TEST_F(Keys, WhatIsRefusedIsNeitherSavedNorRunNorForgotten) {
  open_waves();
  const std::string before = folder.read("waves.toml");
  write("count", "many");
  press(Qt::Key_S, Qt::ControlModifier);
  EXPECT_EQ(folder.read("waves.toml"), before);
  EXPECT_TRUE(window.error_bar().message().contains("many")) << window.error_bar().message().toStdString();
  write("note", "words");
  press(Qt::Key_Return);
  settle();
  EXPECT_FALSE(window.form().form()->message_at("count").isEmpty());
  answer("Cancel");
  press(Qt::Key_Q, Qt::ControlModifier);
  EXPECT_FALSE(asked.isEmpty());
  write("count", "8");
  press(Qt::Key_S, Qt::ControlModifier);
  EXPECT_NE(folder.read("waves.toml").find("count = 8"), std::string::npos);
}

/// An error of a run speaks of what the form shows: its titles, no keys, no lines of a file that may have been edited.
TEST_F(Keys, ErrorsAreSaidInTheWordsOfTheForm) {
  open_waves("dobra = 1\nprogram = \"waves\"\n[input]\n[[step]]\noperation = \"stack\"\ncount = 0\n");
  EXPECT_EQ(window.error_bar().message(),
            "step 1 (stack): 'Number of curves' must be at least 1 and at most 40, found 0");
  write("count", "many");
  press(Qt::Key_Return);
  EXPECT_TRUE(window.form().form()->message_at("count").startsWith("'Number of curves' must be"));
}

TEST_F(Keys, AnAddedTableIsNotRedAndDoesNotRunBeforeItsNameIsGiven) {
  open_waves();
  window.select(0);
  const documents::OutcomePtr before = window.session().outcome();
  click(window.form().findChild<QWidget*>("add.bump"));
  settle();
  EXPECT_EQ(window.form().form()->message_at("bump.1.name"), "");
  EXPECT_EQ(window.error_bar().message(), "");
  EXPECT_EQ(window.session().outcome(), before);
  const auto labels = window.statusBar()->findChildren<QLabel*>();
  EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
    return label->text() == "Still to be given: 'Name' of 'Bumps' 1";
  }));
  write("name", "hill");
  press(Qt::Key_Return);
  settle();
  EXPECT_NE(window.session().outcome(), before);
  EXPECT_EQ(window.error_bar().message(), "");
  press(Qt::Key_A, Qt::ControlModifier);
  press(Qt::Key_Delete);
  press(Qt::Key_Return);
  EXPECT_EQ(window.form().form()->message_at("bump.1.name"), "");
}

TEST(Messages, NamesKeysByTitlesAndLeavesTheCommandLineOut) {
  const std::vector<scenario::Field> fields = scenario::fields_of<test::WaveInput>();
  EXPECT_EQ(in_words_of_the_form("the key 'height' is missing; it must be a number", fields),
            "'Height' is missing; it must be a number");
  EXPECT_EQ(in_words_of_the_form("set amplitude = 3 (--amplitude 3), or add a [[input.bump]] to [input]", fields),
            "set 'Amplitude' = 3, or add a 'Bumps' to Input");
  EXPECT_EQ(in_words_of_the_form("needs `points` (two)", fields), "needs 'Points' (two)");
  // A horizon may be called as a key is.
  EXPECT_EQ(in_words_of_the_form("horizon 'height' crosses itself", fields), "horizon 'height' crosses itself");
}

TEST_F(Keys, SaveAsksWhereAnotherProgramHasChangedTheFile) {
  open_waves();
  write("count", "7");
  const std::string theirs = std::string(test::waves_text()) + "# theirs\n";
  folder.write("waves.toml", theirs);
  answer("Cancel");
  press(Qt::Key_S, Qt::ControlModifier);
  EXPECT_TRUE(asked.contains("waves.toml")) << asked.toStdString();
  EXPECT_EQ(folder.read("waves.toml"), theirs);
  EXPECT_TRUE(window.isWindowModified());
  click(editor("count"));
  answer("Overwrite");
  press(Qt::Key_S, Qt::ControlModifier);
  EXPECT_NE(folder.read("waves.toml").find("count = 7"), std::string::npos);
  EXPECT_FALSE(window.isWindowModified());
}

TEST_F(Keys, SaveDoesNotAskWhereTheFileIsAsItWasLeft) {
  open_waves();
  for (const char* count : {"7", "8"}) {
    write("count", count);
    press(Qt::Key_S, Qt::ControlModifier);
    EXPECT_FALSE(window.isWindowModified());
  }
  folder.write("waves.toml", folder.read("waves.toml"));  // touched, not changed
  write("count", "9");
  press(Qt::Key_S, Qt::ControlModifier);
  EXPECT_NE(folder.read("waves.toml").find("count = 9"), std::string::npos);
}

TEST_F(Keys, SaveWritesAFileThatIsGoneWithoutAsking) {
  open_waves();
  std::filesystem::remove(folder / "waves.toml");
  write("count", "7");
  press(Qt::Key_S, Qt::ControlModifier);
  EXPECT_NE(folder.read("waves.toml").find("count = 7"), std::string::npos);
}

/// What a window leaves that is killed: the journal as it was.
class Lost : public Keys {
 protected:
  void lose_an_edit() {
    open_waves();
    write("count", "7");
    press(Qt::Key_Return);
    window.session().wait_for_journal();
    const std::string left = folder.read("waves.toml.unsaved");
    ASSERT_NE(left.find("count = 7"), std::string::npos) << left;
    window.session().forget_unsaved();
    ASSERT_TRUE(window.open(folder / "waves.toml").ok());
    window.session().wait_for_journal();
    folder.write("waves.toml.unsaved", left);
    settle();
    ASSERT_EQ(count(), 4);
  }
};

TEST_F(Lost, ChangesAreOfferedAndTakenUp) {
  lose_an_edit();
  answer("Recover");
  window.offer_recovery();
  settle();
  EXPECT_EQ(count(), 7);
  EXPECT_TRUE(window.isWindowModified());
  click(&window.view());
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(count(), 4);
}

TEST_F(Lost, ChangesThatAreDiscardedAreGone) {
  lose_an_edit();
  answer("Discard");
  window.offer_recovery();
  window.session().wait_for_journal();
  EXPECT_EQ(count(), 4);
  EXPECT_FALSE(std::filesystem::exists(folder / "waves.toml.unsaved"));
  asked.clear();
  window.offer_recovery();
  EXPECT_TRUE(asked.isEmpty());
}

TEST_F(Keys, NoJournalStaysWhereNothingIsUnsaved) {
  open_waves();
  const auto journal = [&] {
    window.session().wait_for_journal();
    return std::filesystem::exists(folder / "waves.toml.unsaved");
  };
  write("count", "7");
  press(Qt::Key_Return);
  EXPECT_TRUE(journal());
  press(Qt::Key_S, Qt::ControlModifier);
  EXPECT_FALSE(journal());
  write("count", "8");
  press(Qt::Key_Return);
  EXPECT_TRUE(journal());
  window.session().undo();
  EXPECT_FALSE(journal());
  write("count", "9");
  answer("Discard");
  press(Qt::Key_Q, Qt::ControlModifier);
  EXPECT_FALSE(journal());
}

TEST_F(Keys, RecentFilesAreInTheMenuAndOpen) {
  open_waves();
  ASSERT_TRUE(window.save(folder / "second.toml").ok());
  ASSERT_NE(window.actions().find("file.recent"), nullptr);
  QMenu* recent = window.actions().find("file.recent")->menu();
  ASSERT_NE(recent, nullptr);
  emit recent->aboutToShow();
  ASSERT_GE(recent->actions().size(), 2);
  EXPECT_TRUE(recent->actions().at(0)->text().endsWith("second.toml"));
  recent->actions().at(1)->trigger();
  settle();
  EXPECT_EQ(window.session().document().file.filename(), "waves.toml");
}

TEST_F(Keys, AStepIsCopiedAsTextAndPastedBehindTheSelectedOne) {
  open_waves();
  click(window.steps().findChild<QListWidget*>()->viewport());
  window.steps().setFocus();
  window.select(1);
  press(Qt::Key_C, Qt::ControlModifier);
  EXPECT_EQ(QApplication::clipboard()->text(),
            "[[step]]\noperation = \"stack\"\nname = \"grid\"\ncount = 4\ndistance = 50.0\n");
  emit window.steps().add_asked("lift");
  window.select(1);
  window.steps().setFocus();
  press(Qt::Key_V, Qt::ControlModifier);
  ASSERT_EQ(window.session().document().steps.size(), 3U);
  EXPECT_EQ(window.session().document().steps[1].operation, "stack");
  EXPECT_EQ(window.session().document().steps[2].operation, "lift");
  EXPECT_EQ(window.steps().selected(), 2U);
  window.session().undo();
  EXPECT_EQ(window.session().document().steps.size(), 2U);
}

TEST_F(Keys, PastedTextThatIsNoStepIsRefusedAndChangesNothing) {
  open_waves();
  const std::string before = text();
  QApplication::clipboard()->setText("[[step]]\noperation = \"stack\"\ncount = \"many\"\n");
  click(window.steps().findChild<QListWidget*>()->viewport());
  window.steps().setFocus();
  press(Qt::Key_V, Qt::ControlModifier);
  EXPECT_EQ(text(), before);
  EXPECT_FALSE(window.session().history().can_undo());
  EXPECT_TRUE(window.error_bar().message().contains("clipboard:3")) << window.error_bar().message().toStdString();
}

/// In a field the keys copy and paste its own text.
TEST_F(Keys, CopyAndPasteInAFieldAreTheFields) {
  open_waves();
  write("note", "words");
  press(Qt::Key_A, Qt::ControlModifier);
  press(Qt::Key_C, Qt::ControlModifier);
  EXPECT_EQ(QApplication::clipboard()->text(), "words");
  press(Qt::Key_End);
  press(Qt::Key_V, Qt::ControlModifier);
  press(Qt::Key_Return);
  EXPECT_EQ(*stack().find("note"), scenario::Value("wordswords"));
  EXPECT_EQ(window.session().document().steps.size(), 1U);
}

TEST_F(Keys, TheCommandThatDoesWhatTheWindowShowsIsCopied) {
  EXPECT_FALSE(window.actions().find("edit.copy_command")->isEnabled());
  open_waves();
  write("count", "7");
  ASSERT_TRUE(window.actions().trigger("edit.copy_command"));
  EXPECT_EQ(QApplication::clipboard()->text().toStdString(), "waves run " + (folder / "waves.toml").string() +
                                                                 " --out " + (folder / "waves_results").string() +
                                                                 " --set steps.1.count=7\n");
}

std::string described(const QWidget* widget) {
  std::string path;
  for (; widget != nullptr; widget = widget->parentWidget())
    path += std::string(widget->metaObject()->className()) + "(" + widget->objectName().toStdString() + ") ";
  return path;
}

TEST_F(Keys, EveryControlThatTakesTheFocusHasAName) {
  open_waves();
  for (const std::size_t part : {0u, 1u}) {
    window.select(part);
    if (part == 0) {
      click(window.form().findChild<QWidget*>("add.bump"));
      write("name", "hill");
      press(Qt::Key_Return);
    }
    QCoreApplication::processEvents();
    int controls = 0;
    for (QWidget* widget : window.findChildren<QWidget*>()) {
      if (!widget->isVisible() || widget->focusPolicy() == Qt::NoFocus || widget->focusProxy() != nullptr) continue;
      QAccessibleInterface* heard = QAccessible::queryAccessibleInterface(widget);
      ASSERT_NE(heard, nullptr);
      const QString name = heard->text(QAccessible::Name);
      EXPECT_TRUE(std::any_of(name.begin(), name.end(), [](QChar c) { return c.isLetter(); })) << described(widget);
      ++controls;
    }
    EXPECT_GT(controls, 15);
  }
}

TEST_F(Keys, SpaceAndTheLeftButtonPan) {
  open_waves();
  click(&window.view());
  const scene::View before = window.view().view(0);
  const QPointF from = QPointF(middle_of(0).toPoint());
  const auto under = window.view().spot_at(from);
  QTest::keyPress(focus(), Qt::Key_Space);
  drag(Qt::LeftButton, from, from + QPointF(40, 10));
  QTest::keyRelease(focus(), Qt::Key_Space);
  const QPointF moved = window.view().pixel_of(0, under->at);
  EXPECT_NEAR(moved.x(), from.x() + 40, 1e-6);
  EXPECT_NEAR(moved.y(), from.y() + 10, 1e-6);
  const scene::View panned = window.view().view(0);
  EXPECT_NE(panned, before);
  drag(Qt::LeftButton, from, from + QPointF(40, 10));  // without Space
  EXPECT_EQ(window.view().view(0), panned);
}

TEST_F(Keys, TheCanvasIsReachedAndMovedByKeys) {
  open_waves();
  click(editor("count"));
  for (int i = 0; i < 60 && !window.view().hasFocus(); ++i) press(Qt::Key_Tab);
  ASSERT_TRUE(window.view().hasFocus());
  const scene::View all = window.view().view(0);
  press(Qt::Key_Right);
  EXPECT_GT(window.view().view(0).centre.x, all.centre.x);
  press(Qt::Key_Up);
  EXPECT_GT(window.view().view(0).centre.y, all.centre.y);
  press(Qt::Key_Plus);
  EXPECT_LT(window.view().view(0).world_per_point, all.world_per_point);
  press(Qt::Key_Home);
  EXPECT_EQ(window.view().view(0), all);
}

TEST_F(Keys, ALayerIsHiddenByKeys) {
  open_waves();
  click(&window.view());
  for (int i = 0; i < 60 && !window.layers().hasFocus(); ++i) press(Qt::Key_Tab);
  ASSERT_TRUE(window.layers().hasFocus());
  window.layers().setCurrentItem(window.layers().topLevelItem(0));
  press(Qt::Key_Down);
  press(Qt::Key_Space);
  EXPECT_EQ(window.layers().topLevelItem(0)->child(0)->checkState(0), Qt::Unchecked);
}

TEST_F(Keys, AddingAStepKeepsWhatIsStillBeingTyped) {
  open_waves();
  write("count", "7");
  emit window.steps().add_asked("sleep");
  EXPECT_EQ(count(), 7);
  EXPECT_EQ(window.session().document().steps.size(), 2u);
}

TEST_F(Keys, AnEditElsewhereKeepsWhatIsHalfTyped) {
  open_waves();
  write("datum", "0, 0\n");
  click(editor("note"));  // leaves the list of points, which is told
  QTest::keyClicks(focus(), "wor");
  scenario::Document other = window.session().document();
  other.steps[0].params.set("distance", 60.0);
  window.session().edit(std::move(other), "elsewhere");
  QTest::keyClicks(focus(), "ds");
  press(Qt::Key_Return);
  EXPECT_EQ(*stack().find("note"), scenario::Value(std::string("words")));
}

/// The ending that the dialog or the window adds makes another file of what was typed: nothing there is lost unasked.
TEST_F(Keys, SavingUnderATypedNameReplacesNothingUnasked) {
  QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
  for (const char* typed : {"other", "other.v2"}) {
    open_waves();
    const std::filesystem::path there = folder.write(std::string(typed) + ".toml", "not to be lost");
    int asked = 0;
    QTimer person;
    QObject::connect(&person, &QTimer::timeout, [&] {
      if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
        ++asked;
        QTest::mouseClick(box->button(QMessageBox::No), Qt::LeftButton);
      } else if (auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget())) {
        if (asked > 0) return dialog->reject();
        auto* name = dialog->findChild<QLineEdit*>("fileNameEdit");
        name->setText(QString::fromStdString((folder / typed).string()));
        // Not from within this timer, which would be silent until the box that comes up is answered.
        QMetaObject::invokeMethod(
            name, [name] { QTest::keyClick(name, Qt::Key_Return); }, Qt::QueuedConnection);
      }
    });
    person.start(50);
    window.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window, 5000));
    press(Qt::Key_S, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_EQ(asked, 1) << typed;
    EXPECT_EQ(folder.read(there.filename().string()), "not to be lost");
  }
}

}  // namespace
}  // namespace dobra::gui
