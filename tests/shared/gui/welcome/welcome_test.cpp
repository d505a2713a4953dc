// The welcome page and the layout that is remembered, with keys and mouse.

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QDockWidget>
#include <QGuiApplication>
#include <QLabel>
#include <QRegularExpression>
#include <QScreen>
#include <QSettings>
#include <QTimer>
#include <QToolBar>
#include <set>

#include "shared/gui/app.h"
#include "shared/gui/draw_bar.h"
#include "shared/gui/labels/status_line.h"
#include "shared/gui/step_list.h"
#include "shared/gui/welcome/page.h"
#include "shared/io/file.h"
#include "tests/shared/gui/brazilian.h"
#include "tests/shared/gui/window_fixture.h"

namespace dobra::gui {
namespace {

/// A program that is called as the one whose examples it opens.
scenario::Program program_called(const std::string& name) {
  scenario::Program program = test::fake_program();
  program.name = name;
  return program;
}

class WelcomeTest : public testing::Test {
 protected:
  WelcomeTest() {
    QSettings(QSettings::IniFormat, QSettings::UserScope, "Dobra", "recon").clear();
    window.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&window, 10000));
  }
  QWidget* focus() { return QApplication::focusWidget() != nullptr ? QApplication::focusWidget() : &window; }
  welcome::Page& page() { return *window.findChild<welcome::Page*>(); }
  QAbstractButton* button(const QString& name) { return window.findChild<QAbstractButton*>("welcome." + name); }
  void focus_window() {
    window.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window, 5000));
    QCoreApplication::processEvents();
  }

  test::TemporaryFolder folder;
  const scenario::Program program = program_called("recon");
  MainWindow window{
      program,
      {.about = "Restores deformed geological sections.",
       .examples = {{"fold.toml", "Fold train", "Five horizons restored to a datum by constant thickness."},
                    {"gone.toml", "Gone", "Not there."}}}};
};

TEST_F(WelcomeTest, AnExampleIsAnUntitledDocumentWhoseFilesAreFoundFromWhereItIsSaved) {
  window.welcome();
  focus_window();
  EXPECT_FALSE(window.view().isVisible());
  QTest::mouseClick(button("example.fold.toml"), Qt::LeftButton);
  EXPECT_FALSE(page().isVisible());
  EXPECT_TRUE(window.view().isVisible());
  const scenario::Document& document = window.session().document();
  EXPECT_EQ(document.file, "");
  EXPECT_EQ(document.steps.size(),
            scenario::read_document(DOBRA_SOURCE_DIR "/resources/examples/recon/fold.toml")->steps.size());
  EXPECT_FALSE(window.isWindowModified());
  EXPECT_TRUE(window.windowTitle().startsWith("untitled")) << window.windowTitle().toStdString();
  // The copy has all that the example names.
  const std::filesystem::path kept = welcome::examples_folder("recon");
  for (const char* name : {"fold.toml", "fold_middle.geojson", "fold_upper_sandstone.csv", "fold_grey_shale.txt"}) {
    const auto original = std::filesystem::path(DOBRA_SOURCE_DIR "/resources/examples/recon") / name;
    EXPECT_EQ(io::read_bytes(kept / name).value(), io::read_bytes(original).value()) << name;
  }
  EXPECT_FALSE(std::filesystem::exists(kept / "make_fold.py"));
  std::filesystem::create_directory(folder / "deep");
  ASSERT_TRUE(window.save(folder / "deep" / "mine.toml").ok());
  EXPECT_EQ(window.session().document().file, folder / "deep" / "mine.toml");
  EXPECT_EQ(io::read_bytes(kept / "fold.toml").value(),
            io::read_bytes(DOBRA_SOURCE_DIR "/resources/examples/recon/fold.toml").value());
}

TEST_F(WelcomeTest, AnExampleThatIsNotThereIsSaidAndThePageStays) {
  window.welcome();
  focus_window();
  QTest::mouseClick(button("example.gone.toml"), Qt::LeftButton);
  EXPECT_TRUE(page().isVisible());
  EXPECT_FALSE(window.error_bar().message().isEmpty());
  EXPECT_TRUE(window.session().document().steps.empty());
}

TEST_F(WelcomeTest, RecentFilesThatAreGoneAreGreyAndSaidToBeMissing) {
  const auto there = folder.write("here & now.toml", std::string(test::waves_text()).replace(20, 7, "\"recon\""));
  const auto gone = folder.write("gone.toml", std::string(test::waves_text()).replace(20, 7, "\"recon\""));
  ASSERT_TRUE(window.open(gone).ok()) << window.error_bar().message().toStdString();
  ASSERT_TRUE(window.open(there).ok());
  std::filesystem::remove(gone);
  window.begin_new();
  window.welcome();
  focus_window();
  QAbstractButton* missing = button("recent." + QString::fromStdString(gone.string()));
  QAbstractButton* present = button("recent." + QString::fromStdString(there.string()));
  ASSERT_NE(missing, nullptr);
  ASSERT_NE(present, nullptr);
  EXPECT_FALSE(missing->isEnabled());
  EXPECT_TRUE(missing->accessibleDescription().startsWith("Missing from"));
  EXPECT_TRUE(present->isEnabled());
  EXPECT_EQ(present->accessibleName(), "here & now.toml");
  QTest::mouseClick(missing, Qt::LeftButton);
  EXPECT_TRUE(page().isVisible());
  QTest::mouseClick(present, Qt::LeftButton);
  EXPECT_EQ(window.session().document().file, there);
  EXPECT_FALSE(page().isVisible());
}

TEST_F(WelcomeTest, IsReachedByKeysAlone) {
  window.welcome();
  focus_window();
  std::set<QString> seen;
  for (int i = 0; i < 60 && seen.count("welcome.example.fold.toml") == 0; ++i) {
    ASSERT_NE(QApplication::focusWidget(), nullptr);
    seen.insert(QApplication::focusWidget()->objectName());
    if (seen.count("welcome.example.fold.toml") == 0) QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
  }
  EXPECT_EQ(seen.size(), 3u) << "New, Open, then the first example";
  EXPECT_EQ(seen.count("welcome.new") + seen.count("welcome.open"), 2u);
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
  EXPECT_FALSE(window.session().document().steps.empty());
  // Escape stops a run first.
  ASSERT_TRUE(QTest::qWaitFor([&] { return !window.session().busy(); }, 30000));
  window.welcome();
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
  EXPECT_TRUE(window.view().isVisible());
  EXPECT_FALSE(window.session().document().steps.empty());
  for (const QAbstractButton* each : page().findChildren<QAbstractButton*>()) {
    if (each->parent() == page().widget()) {
      EXPECT_FALSE(each->accessibleName().isEmpty());
    }
  }
}

TEST_F(WelcomeTest, NewAsksAboutWhatIsNotSavedAndDrawingLeavesThePage) {
  ASSERT_TRUE(window.open(folder.write("a.toml", std::string(test::waves_text()).replace(20, 7, "\"recon\""))).ok());
  ASSERT_TRUE(QTest::qWaitFor([&] { return !window.session().busy(); }, 30000));
  emit window.steps().remove_asked(1);
  ASSERT_TRUE(window.session().history().modified());
  focus_window();
  const auto answer = [](const char* name) {
    QTimer::singleShot(200, [name] {
      ASSERT_NE(QApplication::activeModalWidget(), nullptr) << name;
      if (QApplication::activeModalWidget() == nullptr) return;  // no question: what follows fails
      for (QAbstractButton* each : QApplication::activeModalWidget()->findChildren<QAbstractButton*>()) {
        if (each->text().remove('&') == name) return each->click();
      }
    });
  };
  answer("Cancel");
  QTest::keyClick(focus(), Qt::Key_N, Qt::ControlModifier);
  EXPECT_EQ(window.session().document().file, folder / "a.toml");
  focus_window();
  answer("Discard");
  QTest::keyClick(focus(), Qt::Key_N, Qt::ControlModifier);
  EXPECT_EQ(window.session().document().file, "");
  EXPECT_TRUE(window.session().document().input.empty());
  window.welcome();
  focus_window();
  QTest::keyClick(focus(), Qt::Key_L);
  EXPECT_TRUE(window.view().isVisible());
  EXPECT_FALSE(page().isVisible());
}

TEST_F(WelcomeTest, IsInPortugueseToo) {
  const test::Brazilian language;
  MainWindow other(
      program, {.about = "Restores deformed geological sections.",
                .examples = {{"fold.toml", "Fold train", "Five horizons restored to a datum by constant thickness."}}});
  other.welcome();
  auto* found = other.findChild<QAbstractButton*>("welcome.example.fold.toml");
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found->accessibleName(), "Trem de dobras");
}

/// What the programs themselves say of their examples, and that there is none that is not offered.
TEST(Examples, AreAllOfferedAndTranslated) {
  const test::Brazilian language;
  for (const char* name : {"recon", "quebra"}) {
    const std::string source = io::read_text(DOBRA_SOURCE_DIR "/" + std::string(name) + "/gui/window.cpp").value();
    const std::string folder = DOBRA_SOURCE_DIR "/resources/examples/" + std::string(name);
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.path().extension() != ".toml") continue;
      const QRegularExpression row("\\{\"" + QString::fromStdString(entry.path().filename().string()) +
                                   "\",\\s*\"([^\"]+)\",\\s*\"([^\"]+)\"\\}");
      const auto match = row.match(QString::fromStdString(source));
      ASSERT_TRUE(match.hasMatch()) << entry.path();
      for (const QString& words : {match.captured(1), match.captured(2)})
        EXPECT_NE(QCoreApplication::translate("dobra", words.toUtf8().constData()), words) << words.toStdString();
    }
  }
}

class LayoutTest : public testing::Test {
 protected:
  LayoutTest() { forget(); }
  ~LayoutTest() override { forget(); }
  static QSettings kept() { return {QSettings::IniFormat, QSettings::UserScope, "Dobra", "waves"}; }
  static void forget() { kept().remove("layout"); }
  static void open(MainWindow& window) {
    window.restore_layout();
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window, 10000));
    QTest::qWait(50);
  }
  static QDockWidget& panel(MainWindow& window, const char* name) { return *window.findChild<QDockWidget*>(name); }
  const scenario::Program program = test::fake_program();
};

TEST_F(LayoutTest, AWindowThatIsLargerThanTheScreenHasItsTitleOnIt) {
  const QRect room = QGuiApplication::primaryScreen()->availableGeometry();
  {
    MainWindow window(program);
    window.setMinimumSize(room.width() + 200, room.height() + 300);
    open(window);
    EXPECT_GE(window.frameGeometry().top(), room.top());
    EXPECT_GE(window.frameGeometry().left(), room.left());
    ASSERT_TRUE(window.close());
  }
  MainWindow window(program);  // what was kept of that one
  open(window);
  EXPECT_TRUE(room.contains(window.frameGeometry()));
}

TEST_F(LayoutTest, APlaceThatIsNotThereTakesNoRoomInTheStatusBar) {
  MainWindow window(program);
  open(window);
  auto* place = window.findChild<QLabel*>("status.place");
  auto* hint = window.findChild<QLabel*>("status.hint");
  EXPECT_FALSE(place->isVisible());
  const int before = hint->width();
  window.findChild<labels::StatusLine*>()->show_place("x = 1   z = 2 m");
  QCoreApplication::processEvents();
  EXPECT_TRUE(place->isVisible());
  EXPECT_LT(hint->width(), before);
  window.findChild<labels::StatusLine*>()->show_place({});
  QCoreApplication::processEvents();
  EXPECT_EQ(hint->width(), before);
}

TEST_F(LayoutTest, IsFoundAgainAfterARestartAndResetGivesTheFirstOne) {
  QRect first_layers;
  {
    MainWindow window(program);
    open(window);
    first_layers = panel(window, "dock.layers").geometry();
    window.addDockWidget(Qt::BottomDockWidgetArea, &panel(window, "dock.layers"));
    panel(window, "dock.results").close();
    window.findChild<QToolBar*>("draw_bar")->hide();
    window.resize(1100, 700);
    QTest::qWait(50);
    ASSERT_TRUE(window.close());
  }
  MainWindow window(program);
  open(window);
  EXPECT_EQ(window.size(), QSize(1100, 700));
  EXPECT_EQ(window.dockWidgetArea(&panel(window, "dock.layers")), Qt::BottomDockWidgetArea);
  EXPECT_TRUE(panel(window, "dock.results").isHidden());
  EXPECT_TRUE(window.findChild<QToolBar*>("draw_bar")->isHidden());
  ASSERT_TRUE(window.actions().trigger("view.reset_layout"));
  QTest::qWait(100);
  EXPECT_EQ(window.size(), QSize(1280, 800));
  EXPECT_EQ(window.dockWidgetArea(&panel(window, "dock.layers")), Qt::RightDockWidgetArea);
  EXPECT_EQ(panel(window, "dock.layers").geometry(), first_layers);
  EXPECT_FALSE(panel(window, "dock.results").isHidden());
  EXPECT_TRUE(window.findChild<QToolBar*>("draw_bar")->isVisible());
}

TEST_F(LayoutTest, OfALargerScreenIsBroughtOntoThisOne) {
  {
    MainWindow window(program);
    open(window);
    window.setGeometry(2600, 1900, 2400, 1500);
    QTest::qWait(50);
    ASSERT_TRUE(window.close());
  }
  MainWindow window(program);
  open(window);
  EXPECT_TRUE(window.screen()->availableGeometry().contains(window.geometry()))
      << window.x() << ' ' << window.y() << ' ' << window.width() << ' ' << window.height();
}

TEST_F(LayoutTest, ThatCannotBeReadIsTheFirstOne) {
  kept().setValue("layout/geometry", QByteArray("\x01\x02nonsense"));
  kept().setValue("layout/state", QByteArray(300, '\xff'));
  MainWindow window(program);
  open(window);
  EXPECT_EQ(window.size(), QSize(1280, 800));
  EXPECT_EQ(window.dockWidgetArea(&panel(window, "dock.layers")), Qt::RightDockWidgetArea);
  EXPECT_TRUE(panel(window, "dock.steps").isVisible());
}

TEST_F(LayoutTest, OfAWindowThatDidNotAskForItIsNotKept) {
  MainWindow window(program);
  window.show();
  ASSERT_TRUE(window.close());
  EXPECT_FALSE(kept().contains("layout/state"));
}

}  // namespace
}  // namespace dobra::gui
