// What the mouse and the keys do on the picture reaches the document.

#include "shared/gui/canvas.h"

#include <QAction>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>

#include "shared/gui/documents/edit.h"
#include "shared/gui/draw_bar.h"
#include "tests/shared/gui/window_fixture.h"

namespace dobra::gui {
namespace {

using geom::Point;

class CanvasTest : public test::WindowFixture {
 protected:
  void open_bump() {
    open_waves(
        "dobra = 1\nprogram = \"waves\"\n[input]\namplitude = 100.0\n"
        "[[input.bump]]\nname = \"A\"\npoints = [[100, 300], [500, 300], [900, 350]]\n");
    take_focus();
  }
  void take_focus() {
    window.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window, 5000));
    window.view().setFocus();
  }
  std::vector<Point> bump(std::size_t i) {
    return std::get<scenario::Points>(*test::bumps_of(window.session().document()).at(i).find("points")).list();
  }
  std::size_t count() { return test::bumps_of(window.session().document()).size(); }
  QPoint pixel(Point at) { return window.view().pixel_of(0, at).toPoint(); }
  void click(Point at) {
    move(at);
    QTest::mouseClick(&window.view(), Qt::LeftButton, {}, pixel(at));
  }
  void move(Point at) {
    const QPointF to = pixel(at);
    QMouseEvent event(QEvent::MouseMove, to, window.view().mapToGlobal(to), Qt::NoButton, Qt::NoButton, {});
    QCoreApplication::sendEvent(&window.view(), &event);
  }
  void key(Qt::Key key) { QTest::keyClick(&window.view(), key); }
  void take_up(const char* tool) { ASSERT_TRUE(window.actions().trigger(std::string("draw.") + tool)); }
  /// Types a name into the question what was drawn, and presses Enter.
  void answer(const char* name) {
    auto* timer = new QTimer(&window);
    QObject::connect(timer, &QTimer::timeout, timer, [timer, name] {
      auto* question = qobject_cast<NewLine*>(QApplication::activeModalWidget());
      if (question == nullptr) return;
      timer->stop();
      timer->deleteLater();
      auto* field = question->findChild<QLineEdit*>("name");
      QTest::keyClicks(field, name);
      QTest::keyClick(field, Qt::Key_Return);
      if (question->isVisible()) {
        ADD_FAILURE() << question->findChild<QLabel*>("refused")->text().toStdString();
        question->reject();
      }
    });
    timer->start(10);
  }
  /// Presses the button of that text in the next box that asks.
  void choose(const char* button) {
    auto* timer = new QTimer(&window);
    QObject::connect(timer, &QTimer::timeout, timer, [timer, button] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (box == nullptr) return;
      timer->stop();
      timer->deleteLater();
      for (QAbstractButton* each : box->buttons()) {
        if (each->text() == button) return QTest::mouseClick(each, Qt::LeftButton);
      }
      ADD_FAILURE() << "no button " << button;
      box->reject();
    });
    timer->start(10);
  }
  std::string hint() { return label("status.hint"); }
  std::string state() { return label("status.state"); }
  std::string label(const char* name) { return window.findChild<QLabel*>(name)->text().toStdString(); }
  double pixel_size() { return window.view().view(0).world_per_point; }
};

TEST_F(CanvasTest, AVertexIsDraggedAndTheEditIsOneStepOfUndo) {
  open_bump();
  click({300, 300});
  drag(Qt::LeftButton, pixel({500, 300}), pixel({500, 380}));
  settle();
  EXPECT_NEAR(bump(0)[1].x, 500.0, pixel_size());
  EXPECT_NEAR(bump(0)[1].y, 380.0, pixel_size());
  EXPECT_EQ(bump(0)[0], (Point{100, 300}));
  // What is selected is told with its length of now.
  const std::string longer = hint();
  window.session().undo();
  EXPECT_EQ(bump(0)[1], (Point{500, 300}));
  settle();
  EXPECT_NE(hint(), longer);
  EXPECT_FALSE(window.session().history().can_undo());
}

TEST_F(CanvasTest, ThePictureStaysUnderTheCursorWhileAVertexIsDragged) {
  open_bump();
  click({300, 300});
  const QPoint to = pixel({500, 380});
  const QPoint from = pixel({500, 300});
  QTest::mousePress(&window.view(), Qt::LeftButton, {}, from);
  for (const double part : {0.5, 1.0}) {
    const QPointF at = from + part * QPointF(to - from);
    QMouseEvent event(QEvent::MouseMove, at, window.view().mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&window.view(), &event);
    settle();
    EXPECT_EQ(pixel({500, 380}), to);
  }
  QTest::mouseRelease(&window.view(), Qt::LeftButton, {}, to);
  settle();
  EXPECT_EQ(pixel({500, 380}), to);
  EXPECT_NEAR(bump(0)[1].y, 380.0, pixel_size());
}

TEST_F(CanvasTest, EscapeInTheMiddleOfADragChangesNothing) {
  open_bump();
  click({300, 300});
  QTest::mousePress(&window.view(), Qt::LeftButton, {}, pixel({500, 300}));
  move({520, 360});
  move({530, 380});
  key(Qt::Key_Escape);
  QTest::mouseRelease(&window.view(), Qt::LeftButton, {}, pixel({530, 380}));
  settle();
  EXPECT_EQ(bump(0)[1], (Point{500, 300}));
  EXPECT_FALSE(window.session().history().modified());
}

TEST_F(CanvasTest, ALineIsDrawnWithClicksSnapsAndATypedPlace) {
  open_bump();
  take_up("line");
  click({102, 298});  // drawn to the vertex (100, 300)
  move({300, 200});
  QTest::keyClicks(&window.view(), "@");
  QTest::keyClicks(focus(), "50,-25");
  QTest::keyClick(focus(), Qt::Key_Return);
  answer("B");
  QTest::keyClick(&window.view(), Qt::Key_Return);
  settle();
  ASSERT_EQ(count(), 2U);
  EXPECT_EQ(bump(1), (std::vector<Point>{{100, 300}, {150, 275}}));
}

TEST_F(CanvasTest, AWrongPlaceIsSaidAndTheFieldStays) {
  open_bump();
  take_up("line");
  QTest::keyClicks(&window.view(), "1");
  auto* entry = qobject_cast<QLineEdit*>(focus());
  ASSERT_NE(entry, nullptr);
  QTest::keyClicks(entry, "2,x");
  QTest::keyClick(entry, Qt::Key_Return);
  EXPECT_TRUE(entry->isVisible());
  EXPECT_EQ(entry->text(), "12,x");
  QTest::keyClick(entry, Qt::Key_Escape);
  EXPECT_FALSE(entry->isVisible());
}

TEST_F(CanvasTest, DeleteRemovesTheSelectedLine) {
  open_bump();
  click({300, 300});
  key(Qt::Key_Delete);
  settle();
  EXPECT_EQ(count(), 0U);
  window.session().undo();
  EXPECT_EQ(count(), 1U);
}

TEST_F(CanvasTest, WhatTheProgramHasDrawnIsNotEdited) {
  open_bump();
  click({0, 0});
  const std::string before = text();
  key(Qt::Key_Delete);
  settle();
  EXPECT_EQ(text(), before);
}

TEST_F(CanvasTest, EveryToolHasAnActionWithAKeyAndAnIcon) {
  std::set<QString> keys;
  int tools = 0;
  for (const QAction* action : window.draw_bar().actions()) {
    if (action->isSeparator() || action->objectName() == "draw.snap") continue;
    ++tools;
    EXPECT_FALSE(action->icon().isNull()) << action->text().toStdString();
    EXPECT_TRUE(keys.insert(action->shortcut().toString()).second) << action->text().toStdString();
  }
  EXPECT_EQ(tools, 18);
}

TEST_F(CanvasTest, TheFirstLineIsDrawnInAnEmptyWindow) {
  take_focus();
  take_up("line");
  QTest::keyClicks(&window.view(), "1");
  QTest::keyClicks(focus(), "0;20");
  QTest::keyClick(focus(), Qt::Key_Return);
  QTest::keyClicks(&window.view(), "@");
  QTest::keyClicks(focus(), "100<0");
  QTest::keyClick(focus(), Qt::Key_Return);
  answer("First");
  QTest::keyClick(&window.view(), Qt::Key_Return);
  settle();
  ASSERT_EQ(count(), 1U);
  EXPECT_EQ(bump(0), (std::vector<Point>{{10, 20}, {110, 20}}));
}

TEST_F(CanvasTest, AnotherToolFinishesTheLineThatIsDrawn) {
  open_bump();
  take_up("line");
  click({200, 200});
  click({400, 250});
  answer("B");
  press(Qt::Key_S);
  settle();
  ASSERT_EQ(count(), 2U);
  EXPECT_EQ(bump(1).size(), 2U);
  EXPECT_EQ(window.canvas().tool().cursor(), canvas::Cursor::Arrow);
  take_up("line");
  click({200, 200});
  press(Qt::Key_S);
  settle();
  EXPECT_EQ(count(), 2U);
}

TEST_F(CanvasTest, UndoWhileALineIsDrawnTakesItsLastPointAndThenTheDocuments) {
  open_bump();
  click({300, 300});
  key(Qt::Key_Delete);
  settle();
  ASSERT_EQ(count(), 0U);
  take_up("line");
  click({200, 200});
  click({400, 250});
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_NEAR(window.canvas().tool().last()->x, 200.0, pixel_size());
  EXPECT_EQ(count(), 0U);
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_FALSE(window.canvas().tool().last());
  EXPECT_EQ(count(), 0U);
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(count(), 1U);
}

TEST_F(CanvasTest, UndoTakesAPointBackWhereTheDocumentHasNothingToUndo) {
  take_focus();
  take_up("line");
  click({200, -200});
  ASSERT_TRUE(window.canvas().unfinished());
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_FALSE(window.canvas().unfinished());
}

TEST_F(CanvasTest, TheHintStaysWhileRunsComeToTheirEnds) {
  open_bump();
  take_up("split");
  const std::string waits = hint();
  EXPECT_NE(waits.find("split"), std::string::npos) << waits;
  window.session().run();
  settle();
  EXPECT_EQ(hint(), waits);
  EXPECT_NE(state().find("Done in"), std::string::npos) << state();
}

TEST_F(CanvasTest, AClickThatMissesSaysWhatWasExpectedUntilTheNextOne) {
  open_bump();
  for (const char* tool : {"insert_vertex", "split", "join", "extend", "trim"}) {
    take_up(tool);
    const std::string waits = hint();
    click({500, 120});
    EXPECT_EQ(hint(), "There is no line here. " + waits) << tool;
    key(Qt::Key_Escape);
    EXPECT_EQ(hint(), waits) << tool;
  }
  take_up("extend");
  click({850, 343});
  EXPECT_NE(hint().find("meets no other line"), std::string::npos) << hint();
  take_up("move");
  click({500, 120});
  EXPECT_NE(hint().find("Nothing is selected"), std::string::npos) << hint();
}

TEST_F(CanvasTest, JoiningTwoLinesAsksForTheNameThatStays) {
  open_waves(
      "dobra = 1\nprogram = \"waves\"\n[input]\namplitude = 100.0\n"
      "[[input.bump]]\nname = \"A\"\npoints = [[100, 300], [400, 300]]\n"
      "[[input.bump]]\nname = \"B\"\npoints = [[500, 300], [900, 350]]\n");
  take_focus();
  const std::string before = text();
  for (const char* stays : {"Cancel", "B"}) {
    take_up("join");
    choose(stays);
    click({300, 300});
    click({700, 325});
    settle();
    if (stays == std::string("Cancel")) {
      EXPECT_EQ(text(), before);
    }
  }
  ASSERT_EQ(count(), 1U);
  EXPECT_EQ(bump(0).size(), 4U);
  EXPECT_EQ(*test::bumps_of(window.session().document())[0].find("name"), scenario::Value("B"));
}

TEST_F(CanvasTest, TheInputIsShownAndEditedWhereNoPanelOfTheResultShowsIt) {
  open_bump();
  window.session().edit(documents::with_step(window.session().document(), 0, "lift"), "lift");
  settle();
  click({300, 400});
  EXPECT_TRUE(window.canvas().workspace().selection.empty());
  press(Qt::Key_1, Qt::ControlModifier);
  ASSERT_EQ(window.view().panel_count(), 2U);
  click({300, 300});
  drag(Qt::LeftButton, pixel({500, 300}), pixel({500, 380}));
  settle();
  EXPECT_NEAR(bump(0)[1].y, 380.0, pixel_size());
  press(Qt::Key_3, Qt::ControlModifier);
  EXPECT_EQ(window.view().panel_count(), 4U);
  click({200, 340});
  EXPECT_FALSE(window.canvas().workspace().selection.empty());
  const MainWindow another(program);
  EXPECT_TRUE(another.findChild<QAction*>("look.both")->isChecked());
  press(Qt::Key_2, Qt::ControlModifier);
  EXPECT_EQ(window.view().panel_count(), 2U);
}

TEST_F(CanvasTest, ADocumentWithNothingInItSaysHowToBeginAndNothingIsRed) {
  take_focus();
  take_up("line");
  click({200, -200});
  click({400, -250});
  answer("First");
  key(Qt::Key_Return);
  settle();
  ASSERT_EQ(count(), 1U);
  take_focus();
  press(Qt::Key_Z, Qt::ControlModifier);
  settle();
  ASSERT_EQ(count(), 0U);
  press(Qt::Key_F5);
  settle();
  EXPECT_EQ(window.error_bar().message(), QString());
  EXPECT_EQ(window.layers().topLevelItemCount(), 0);
  const auto labels = window.view().findChildren<QLabel*>();
  EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [](const QLabel* each) {
    return each->isVisible() && each->text().contains("draw the first line");
  }));
}

}  // namespace
}  // namespace dobra::gui
