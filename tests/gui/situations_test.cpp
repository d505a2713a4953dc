// What windows look like: situations in English and light, and in Portuguese and dark, written as pictures into the
// folder `situations` of the build, to be looked at. The tests read off what a program can: that no words are cut off,
// and that the view is drawn. QT_SCALE_FACTOR=2 shows them at 200 %.

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QDropEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPainter>
#include <QScrollArea>
#include <QTabBar>
#include <QTest>
#include <QTimer>
#include <QUrl>
#include <fstream>
#include <set>

#include "shared/gui/actions/palette.h"
#include "shared/gui/canvas.h"
#include "shared/gui/main_window.h"
#include "shared/gui/parameter_form.h"
#include "shared/gui/vtk_widget.h"
#include "tests/gui/examples_folder.h"
#include "tests/shared/gui/brazilian.h"

namespace {

using namespace dobra;

struct Look {
  const char* name;
  bool portuguese;
  bool dark;
  friend void PrintTo(const Look& look, std::ostream* out) { *out << look.name; }
};

class Situations : public testing::TestWithParam<Look> {
 protected:
  Situations() {
    if (GetParam().portuguese) brazilian_.emplace();
  }
  ~Situations() override {
    if (!window_) return;
    window_->session().cancel();
    window_.reset();
  }

  /// A window with the example, at rest; without one where that is empty.
  void open(const std::string& program, const std::string& example = {}) {
    window_ = std::make_unique<gui::MainWindow>(test::program_of(program), test::part_of(program));
    window_->resize(1280, 800);
    window_->show();
    window_->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(window_.get(), 20000));
    act(GetParam().dark ? "theme.dark" : "theme.light");
    if (!example.empty()) {
      ASSERT_TRUE(window_->open(examples_.file(program + example)).ok());
    }
    rest();
  }
  void rest() {
    ASSERT_TRUE(QTest::qWaitFor([this] { return !window_->session().busy(); }, 120000));
    QCoreApplication::processEvents();
  }
  void act(const std::string& action) {
    ASSERT_TRUE(window_->actions().trigger(action)) << action;
    rest();
  }
  void click(geom::Point at) {
    QTest::mouseClick(&window_->view(), Qt::LeftButton, {}, window_->view().pixel_of(0, at).toPoint());
  }
  void point(geom::Point at) {
    const QPointF pixel = window_->view().pixel_of(0, at);
    QMouseEvent move(QEvent::MouseMove, pixel, window_->view().mapToGlobal(pixel), Qt::NoButton, Qt::NoButton, {});
    QCoreApplication::sendEvent(&window_->view(), &move);
  }
  QWidget* focus() { return QApplication::focusWidget() != nullptr ? QApplication::focusWidget() : window_.get(); }
  void raise(const char* panel) {
    auto* dock = window_->findChild<QWidget*>(panel);
    ASSERT_NE(dock, nullptr) << panel;
    dock->show();
    dock->raise();
    QCoreApplication::processEvents();
  }

  /// The window, with the other windows of the program above it.
  void take(const std::string& situation) {
    QCoreApplication::processEvents();
    const std::filesystem::path folder = std::filesystem::path(DOBRA_BIN_DIR).parent_path() / "situations";
    std::filesystem::create_directories(folder);
    const std::string file = (folder / (situation + "_" + GetParam().name + ".png")).string();
    const base::Result<void> saved = window_->save_screenshot(file);
    ASSERT_TRUE(saved.ok()) << situation << ": " << base::to_string(saved.error());
    QImage all(QString::fromStdString(file));
    all.setDevicePixelRatio(window_->devicePixelRatioF());
    QPainter painter(&all);
    judge(*window_, situation);
    for (QWidget* other : QApplication::topLevelWidgets()) {
      if (other == window_.get() || !other->isVisible() || other->windowType() == Qt::ToolTip) continue;
      painter.drawPixmap(other->geometry().topLeft() - window_->geometry().topLeft(), other->grab());
      judge(*other, situation);
    }
    painter.end();
    ASSERT_TRUE(all.save(QString::fromStdString(file)));
  }

  /// No words are cut off where they do not say so by an ellipsis.
  static void judge(QWidget& window, const std::string& situation) {
    for (const QTabBar* tabs : window.findChildren<QTabBar*>()) {
      for (int i = 0; tabs->isVisible() && i < tabs->count(); ++i) {
        EXPECT_GE(tabs->tabRect(i).width(), tabs->fontMetrics().horizontalAdvance(tabs->tabText(i)))
            << situation << ": the tab " << tabs->tabText(i).toStdString();
      }
    }
    // What a tool waits for is read whole, or at least under the pointer where the window is narrow.
    for (const QLabel* hint : window.findChildren<QLabel*>("status.hint")) {
      const int needed = hint->fontMetrics().horizontalAdvance(hint->text());
      EXPECT_TRUE(needed <= hint->width() || window.width() < 1280)
          << situation << ": the hint " << hint->text().toStdString() << " has " << hint->width() << " of " << needed;
      EXPECT_EQ(hint->toolTip(), hint->text()) << situation;
    }
    for (QWidget* each : window.findChildren<QWidget*>()) {
      // Panels under tabs that are not raised wait beside the window.
      const QRect place(each->mapTo(&window, QPoint()), each->size());
      if (!each->isVisible() || !place.intersects(window.rect())) continue;
      QString words;
      if (const auto* label = qobject_cast<QLabel*>(each)) words = label->wordWrap() ? QString() : label->text();
      if (const auto* label = qobject_cast<QLabel*>(each); label != nullptr && label->wordWrap()) {
        const int lines = label->heightForWidth(label->width());
        EXPECT_LE(lines, label->height() + 1) << situation << ": " << label->objectName().toStdString()
                                              << " shows a part of " << label->text().toStdString();
      }
      if (const auto* button = qobject_cast<QAbstractButton*>(each)) words = button->text();
      if (const auto* choice = qobject_cast<QComboBox*>(each)) words = choice->currentText();
      if (words.isEmpty() || each->sizePolicy().horizontalPolicy() == QSizePolicy::Ignored) continue;
      const int needed = qobject_cast<QComboBox*>(each) != nullptr
                             ? each->fontMetrics().horizontalAdvance(words) + 20
                             : std::min(each->minimumSizeHint().width(), each->sizeHint().width());
      EXPECT_LE(needed, each->width() + 1) << situation << ": " << each->objectName().toStdString() << " ("
                                           << each->metaObject()->className() << ") shows " << words.toStdString();
      // What scrolls into sight sideways is cut off until somebody scrolls.
      const QRect seen = each->visibleRegion().boundingRect();
      if (!seen.isEmpty()) {
        EXPECT_GE(seen.width() + 1, std::min(needed, each->width()))
            << situation << ": " << each->objectName().toStdString() << " shows a part of " << words.toStdString();
      }
    }
  }

  std::optional<test::Brazilian> brazilian_;
  test::ExamplesFolder examples_;
  std::unique_ptr<gui::MainWindow> window_;
};

TEST_P(Situations, TheBeginning) {
  for (const std::string program : {"recon", "quebra"}) {
    open(program + "/");
    take("01_beginning_" + program);
    act("help.welcome");
    take("01_welcome_" + program);
    window_.reset();
  }
}

TEST_P(Situations, ARestoredSection) {
  open("recon/", "fold.toml");
  take("02_restored");
  act("look.input");
  point({3450, 1150});
  take("02_pointed");
  act("look.result");
}

TEST_P(Situations, BesideTheInputWithFaults) {
  open("recon/", "listric.toml");
  act("look.both");
  take("03_both");
}

TEST_P(Situations, PanelsOfThePrograms) {
  open("recon/", "listric.toml");
  raise("dock.balance");
  take("11_balance");
  window_.reset();
  open("quebra/", "edge_crack.toml");
  raise("dock.cracks");
  take("11_cracks");
}

TEST_P(Situations, AGhostOfTheInput) {
  open("recon/", "fold.toml");
  act("look.both");
  act("view.panels.ghost");
  act("view.exaggeration.2");
  take("04_ghost");
  act("view.panels.as_fits");
  act("view.exaggeration.fill");
}

TEST_P(Situations, ALineBeingDrawn) {
  open("recon/", "fold.toml");
  act("look.input");
  act("draw.line");
  window_->view().setFocus();
  const geom::Point centre = window_->view().view(0).centre;
  click({centre.x - 300, centre.y + 60});
  click({centre.x, centre.y + 90});
  point({centre.x + 250, centre.y + 40});
  for (const char each : std::string("@200;15")) QTest::keyClick(focus(), each);
  take("05_drawing");
}

TEST_P(Situations, ALineAndItsVertices) {
  open("recon/", "fold.toml");
  act("look.input");
  act("edit.select_all");
  raise("dock.vertices");
  take("06_vertices");
}

TEST_P(Situations, AWrongNumber) {
  open("recon/", "listric.toml");
  window_->select(1);
  auto* number = window_->form().findChild<QLineEdit*>();
  ASSERT_NE(number, nullptr);
  for (QLineEdit* each : window_->form().findChildren<QLineEdit*>()) {
    if (each->isVisible() && !each->isReadOnly()) number = each;
  }
  number->setFocus();
  number->selectAll();
  QTest::keyClicks(number, "12q");
  QTest::keyClick(number, Qt::Key_Return);
  rest();
  take("07_wrong");
}

TEST_P(Situations, ThePalette) {
  open("recon/", "fold.toml");
  window_->view().setFocus();
  QTest::keyClick(&window_->view(), Qt::Key_K, Qt::ControlModifier);
  ASSERT_TRUE(window_->palette().isVisible());
  QTest::keyClicks(focus(), "li");
  take("08_palette");
  QTest::keyClick(focus(), Qt::Key_Escape);
}

TEST_P(Situations, AFileBeingImported) {
  open("recon/", "fold.toml");
  QTimer look;
  bool seen = false;
  QObject::connect(&look, &QTimer::timeout, &look, [&] {
    QWidget* dialog = QApplication::activeModalWidget();
    if (dialog == nullptr || seen) return;
    seen = true;
    QTest::qWait(500);  // judged after a pause
    take("09_import");
    QTest::keyClick(dialog, Qt::Key_Escape);
  });
  look.start(50);
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(QString::fromStdString(examples_.file("recon/listric.csv").string()))});
  QDragEnterEvent enter({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, {});
  QCoreApplication::sendEvent(window_.get(), &enter);
  QDropEvent drop({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, {});
  QCoreApplication::sendEvent(window_.get(), &drop);
  ASSERT_TRUE(QTest::qWaitFor([&] { return seen && QApplication::activeModalWidget() == nullptr; }, 20000));
  rest();
}

TEST_P(Situations, AMeshAnalysed) {
  open("quebra/", "cracked_plate.toml");
  take("10_analysed");
}

TEST_P(Situations, ASurfaceAndItsChart) {
  open("quebra/", "../surfaces/6.toml");
  act("view.space.show.isocurves");
  act("view.space.show.controls");
  take("12_surface");
  window_.reset();
  open("quebra/", "../surfaces/cracked_shell.toml");
  act("view.space.show.normals");
  act("view.space.section");
  take("12_surface_section");
  window_->resize(1000, 700);
  rest();
  take("12_surface_small");
}

TEST_P(Situations, ARefusedSurface) {
  open("quebra/");
  const std::filesystem::path file = examples_.file("quebra/plate_with_hole.toml").parent_path() / "refused.toml";
  std::ofstream(file)
      << "dobra = 1\nprogram = \"quebra\"\n\n[[input.surface]]\nname = \"tube\"\nkind = "
         "\"cylinder\"\nradius = 2\nu = [30, 150]\nv = [0, 6]\n\n[[input.trim]]\nname = \"first\"\nrole = "
         "\"cut\"\npoints = [[60, 0], [60, 6]]\n\n[[input.part]]\nfate = \"keep\"\nat = [60, 3]\n";
  ASSERT_TRUE(window_->open(file).ok());
  rest();
  QTest::qWait(300);
  take("13_refused");
}

TEST_P(Situations, ASolidAndItsSection) {
  open("quebra/", "../solids/pillar.toml");
  take("14_pillar");
  act("view.space.section");
  take("14_pillar_section");
  act("view.space.section");
  act("view.space.show.exploded");
  act("view.space.alone");
  take("14_pillar_apart");
}

INSTANTIATE_TEST_SUITE_P(Looks, Situations,
                         testing::Values(Look{"en_light", false, false}, Look{"pt_dark", true, true}),
                         [](const auto& look) { return std::string(look.param.name); });

}  // namespace
