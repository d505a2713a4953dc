// How the picture is looked at, with the mouse and the keys of a person.

#include <QAction>
#include <QClipboard>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QTimer>
#include <cmath>

#include "shared/gui/canvas.h"
#include "shared/gui/documents/edit.h"
#include "shared/gui/draw_bar.h"
#include "shared/gui/view/exaggeration_box.h"
#include "tests/shared/gui/window_fixture.h"

namespace dobra::gui {
namespace {

using geom::Point;

class ViewTest : public test::WindowFixture {
 protected:
  /// Settings are remembered: the next test is to find none.
  void TearDown() override {
    for (const char* name : {"view.panels.as_fits", "view.unit.as_read", "view.legend.usual"}) action(name)->trigger();
    for (const char* name : {"view.linked", "view.grid"}) {
      if (action(name)->isChecked()) action(name)->trigger();
    }
  }
  void open_bumps(const std::string& steps = {}) {
    open_waves(
        "dobra = 1\nprogram = \"waves\"\n[input]\namplitude = 100.0\n"
        "[[input.bump]]\nname = \"A\"\npoints = [[100, 300], [500, 300], [900, 350]]\n"
        "[[input.bump]]\nname = \"B\"\npoints = [[200, 500], [600, 400]]\n" +
        steps);
    take_focus();
  }
  void take_focus() {
    window.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window, 5000));
    window.view().setFocus();
  }
  QAction* action(const char* name) {
    auto* found = window.findChild<QAction*>(name);
    EXPECT_NE(found, nullptr) << name;
    return found;
  }
  void exaggerate(const char* typed) {
    auto* box = window.findChild<view::ExaggerationBox*>("exaggeration");
    click(box->lineEdit());
    press(Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(focus(), typed);
    press(Qt::Key_Return);
    take_focus();
  }
  std::string label(const char* name) { return window.findChild<QLabel*>(name)->text().toStdString(); }
  QPoint pixel(Point at, std::size_t panel = 0) { return window.view().pixel_of(panel, at).toPoint(); }
  void move(QPoint to, Qt::MouseButtons held = {}) {
    QMouseEvent event(QEvent::MouseMove, to, window.view().mapToGlobal(to), Qt::NoButton, held, {});
    QCoreApplication::sendEvent(&window.view(), &event);
  }
  void click_at(Point at, Qt::KeyboardModifiers keys = {}, Qt::MouseButton button = Qt::LeftButton) {
    move(pixel(at));
    QTest::mouseClick(&window.view(), button, keys, pixel(at));
  }
  std::vector<Point> bump(std::size_t i) {
    return std::get<scenario::Points>(*test::bumps_of(window.session().document()).at(i).find("points")).list();
  }
  std::size_t count() { return test::bumps_of(window.session().document()).size(); }
  const canvas::Selection& selection() { return window.canvas().workspace().selection; }
  std::size_t handles() { return window.canvas().tool().overlay(window.canvas().workspace()).handles.size(); }
  bool is_selecting() { return window.canvas().tool().cursor() == canvas::Cursor::Arrow; }
  /// How many times as long a length along z is drawn as one along x.
  double drawn_exaggeration(std::size_t panel = 0) {
    const QPointF zero = window.view().pixel_of(panel, {0, 0});
    return (zero.y() - window.view().pixel_of(panel, {0, 100}).y()) /
           (window.view().pixel_of(panel, {100, 0}).x() - zero.x());
  }
  bool sees(Point at, std::size_t panel = 0) {
    return window.view().plot(panel).contains(window.view().pixel_of(panel, at));
  }
  /// Accepts each question what was drawn with the name that it proposes, or with `names` one after the other.
  void answer(std::vector<std::string> names = {}) {
    auto* timer = new QTimer(&window);
    QObject::connect(timer, &QTimer::timeout, timer, [names = std::move(names)]() mutable {
      auto* question = qobject_cast<NewLine*>(QApplication::activeModalWidget());
      if (question == nullptr) return;
      auto* field = question->findChild<QLineEdit*>("name");
      if (!names.empty()) {
        QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(field, names.front().c_str());
        names.erase(names.begin());
      }
      QTest::keyClick(field, Qt::Key_Return);
      if (question->isVisible()) question->reject();
    });
    timer->start(10);
  }
  /// The menu that a click with the right button opens.
  QMenu* menu_at(Point at) {
    click_at(at, {}, Qt::RightButton);
    return window.view().findChild<QMenu*>("line_menu");
  }
  void choose(QMenu* menu, const char* name) {
    auto* entry = menu->findChild<QAction*>(name);
    ASSERT_NE(entry, nullptr);
    EXPECT_TRUE(entry->isEnabled());
    QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(entry).center());
    QCoreApplication::processEvents();
  }
};

TEST_F(ViewTest, AnEmptySheetAndDegenerateSectionsStayFiniteAtAnyExaggeration) {
  take_focus();
  const char* documents[] = {
      "[[input.bump]]\nname = \"flat\"\npoints = [[0, 7], [1000, 7]]\n",
      "[[input.bump]]\nname = \"one point\"\npoints = [[3, 7]]\n",
      "[[input.bump]]\nname = \"upright\"\npoints = [[3, 7], [3, 9000]]\n",
      "[[input.bump]]\nname = \"far\"\npoints = [[7e5, 7.4e6], [7e5, 7.4e6]]\n",
  };
  for (std::size_t i = 0; i <= std::size(documents); ++i) {
    if (i > 0) {
      open_waves(std::string("dobra = 1\nprogram = \"waves\"\n[input]\namplitude = 0.0\n") + documents[i - 1]);
    }
    for (const char* typed : {"1000", "0.01", "Fill", "10000", "1"}) {
      exaggerate(typed);
      press(Qt::Key_F);
      turn_wheel(window.view().plot(0).center(), 2);
      for (std::size_t panel = 0; panel < window.view().panel_count(); ++panel) {
        const scene::View seen = window.view().view(panel);
        EXPECT_TRUE(std::isfinite(seen.centre.x) && std::isfinite(seen.centre.y)) << typed;
        EXPECT_TRUE(std::isfinite(seen.world_per_point) && seen.world_per_point > 0.0) << typed;
        EXPECT_TRUE(std::isfinite(window.view().pixel_of(panel, seen.centre).y())) << typed;
      }
      press(Qt::Key_F);
    }
  }
}

TEST_F(ViewTest, AWrongExaggerationIsSaidAndTheOldOneStays) {
  open_bumps();
  exaggerate("5");
  EXPECT_NEAR(drawn_exaggeration(), 5.0, 1e-9);
  exaggerate("much");
  EXPECT_NEAR(drawn_exaggeration(), 5.0, 1e-9);
  EXPECT_NE(label("status.hint").find("0.01 to 10000"), std::string::npos) << label("status.hint");
  EXPECT_EQ(window.findChild<view::ExaggerationBox*>("exaggeration")->currentText(), QString::fromUtf8("VE 5×"));
  exaggerate("1");
  EXPECT_NEAR(drawn_exaggeration(), 1.0, 1e-9);
}

TEST_F(ViewTest, EverythingIsTrueWhileTheViewIsExaggerated) {
  open_bumps();
  exaggerate("5");
  press(Qt::Key_F);
  ASSERT_TRUE(sees({900, 350}) && sees({100, 300}));
  // The dip of the second part of A falls 50 m on 400 m.
  move(pixel({700, 325}));
  EXPECT_EQ(label("status.dip"), "dip 7.1° (A)");
  EXPECT_EQ(label("status.place").substr(0, 5), "x = 7");
  // A dragged vertex stands where it is dropped.
  click_at({300, 300});
  drag(Qt::LeftButton, pixel({500, 300}), pixel({520, 330}));
  settle();
  const double size = window.view().view(0).world_per_point;
  EXPECT_NEAR(bump(0)[1].x, 520.0, size);
  EXPECT_NEAR(bump(0)[1].y, 330.0, size / 5);
  // A typed direction is a true one.
  ASSERT_TRUE(window.actions().trigger("draw.line"));
  QTest::keyClicks(&window.view(), "1");
  QTest::keyClicks(focus(), "00;100");
  press(Qt::Key_Return);
  QTest::keyClicks(&window.view(), "@");
  QTest::keyClicks(focus(), "100<45");
  press(Qt::Key_Return);
  answer({"C"});
  press(Qt::Key_Return);
  settle();
  ASSERT_EQ(count(), 3U);
  EXPECT_NEAR(bump(2)[1].x, 100.0 + 100.0 * std::sqrt(0.5), 1e-9);
  EXPECT_NEAR(bump(2)[1].y, 100.0 + 100.0 * std::sqrt(0.5), 1e-9);
  // Turned by a right angle, a line is as long as before.
  take_focus();
  press(Qt::Key_S);
  click_at({150, 150});
  ASSERT_EQ(selection().size(), 1U);
  ASSERT_TRUE(window.actions().trigger("draw.rotate"));
  click_at({100, 100});
  QTest::keyClicks(&window.view(), "9");
  QTest::keyClicks(focus(), "0");
  press(Qt::Key_Return);
  settle();
  EXPECT_NEAR(bump(2)[1].x, 100.0 - 100.0 * std::sqrt(0.5), 1e-9);
  EXPECT_NEAR(geom::distance(bump(2)[0], bump(2)[1]), 100.0, 1e-9);
}

TEST_F(ViewTest, APerpendicularMeetsItsLineAtARightAngleOfTheModel) {
  open_bumps();
  exaggerate("5");
  press(Qt::Key_F);
  ASSERT_TRUE(window.actions().trigger("draw.line"));
  QTest::keyClicks(&window.view(), "6");
  QTest::keyClicks(focus(), "50;250");
  press(Qt::Key_Return);
  // The foot on the way from (500, 300) to (900, 350).
  const Point along{8.0 / std::sqrt(65.0), 1.0 / std::sqrt(65.0)};
  const double part = (150.0 * along.x - 50.0 * along.y);
  const Point foot{500.0 + part * along.x, 300.0 + part * along.y};
  click_at({foot.x + window.view().view(0).world_per_point, foot.y});
  ASSERT_TRUE(window.canvas().tool().last());
  EXPECT_NEAR(window.canvas().tool().last()->x, foot.x, 1e-6);
  EXPECT_NEAR(window.canvas().tool().last()->y, foot.y, 1e-6);
}

TEST_F(ViewTest, FillExaggeratesAThinSectionUntilItFillsTheCanvas) {
  open_waves(
      "dobra = 1\nprogram = \"waves\"\n[input]\namplitude = 0.0\n"
      "[[input.bump]]\nname = \"A\"\npoints = [[0, 0], [100000, 0], [100000, 1000]]\n");
  take_focus();
  action("view.exaggeration.fill")->trigger();
  for (std::size_t panel = 0; panel < 2; ++panel) {
    EXPECT_GT(drawn_exaggeration(panel), 1.5);
    EXPECT_TRUE(sees({100000, 1000}, panel));
    EXPECT_TRUE(sees({0, 0}, panel));
  }
  const QRectF plot = window.view().plot(0);
  const double across = window.view().pixel_of(0, {100000, 0}).x() - window.view().pixel_of(0, {0, 0}).x();
  EXPECT_GT(across, 0.8 * plot.width());
}

TEST_F(ViewTest, PanelsStandAsIsAskedAndThatIsRemembered) {
  open_bumps();
  const auto beside = [&] { return window.view().plot(0).right() < window.view().plot(1).left(); };
  const auto above = [&] { return window.view().plot(0).bottom() < window.view().plot(1).top(); };
  action("view.panels.row")->trigger();
  EXPECT_TRUE(beside());
  action("view.panels.column")->trigger();
  EXPECT_TRUE(above());
  const MainWindow another(program);
  EXPECT_TRUE(another.findChild<QAction*>("view.panels.column")->isChecked());
  action("view.panels.as_fits")->trigger();
}

TEST_F(ViewTest, WhatADragHasHeldStillIsSeenWholeWhereItsPanelGetsAnotherSize) {
  open_bumps("[[step]]\noperation = \"lift\"\n");
  const auto all_seen = [&] {
    for (std::size_t panel = 0; panel < window.view().panel_count(); ++panel) {
      for (const Point each : {Point{100, 300}, Point{900, 350}, Point{200, 500}, Point{600, 400}}) {
        if (!sees(each, panel)) return false;
      }
    }
    return true;
  };
  press(Qt::Key_1, Qt::ControlModifier);
  settle();
  click_at({500, 300});
  drag(Qt::LeftButton, pixel({500, 300}), pixel({500, 330}));
  settle();
  EXPECT_NEAR(bump(0)[1].y, 330.0, 5.0);
  press(Qt::Key_Z, Qt::ControlModifier);
  settle();
  press(Qt::Key_3, Qt::ControlModifier);
  settle();
  EXPECT_GT(window.view().panel_count(), 2U);
  EXPECT_TRUE(all_seen());
  // What somebody has zoomed to stays looked at.
  press(Qt::Key_1, Qt::ControlModifier);
  settle();
  turn_wheel(pixel({500, 330}), 6);
  const double near = window.view().view(0).world_per_point;
  click_at({500, 300});
  press(Qt::Key_3, Qt::ControlModifier);
  settle();
  EXPECT_DOUBLE_EQ(window.view().view(0).world_per_point, near);
  press(Qt::Key_2, Qt::ControlModifier);
}

TEST_F(ViewTest, LinkedPanelsMoveTogetherAndOthersDoNot) {
  open_bumps();
  const auto centres = [&] { return std::pair(window.view().view(0).centre, window.view().view(1).centre); };
  auto before = centres();
  drag(Qt::MiddleButton, middle_of(0), middle_of(0) + QPointF(30, -12));
  EXPECT_NE(centres().first, before.first);
  EXPECT_EQ(centres().second, before.second);
  action("view.linked")->trigger();
  before = centres();
  drag(Qt::MiddleButton, middle_of(1), middle_of(1) + QPointF(30, -12));
  const geom::Vector first = centres().first - before.first;
  const geom::Vector second = centres().second - before.second;
  EXPECT_GT(geom::length(second), 0.0);
  EXPECT_NEAR(geom::distance(Point{} + first, Point{} + second), 0.0, 1e-9);
  before = centres();
  turn_wheel(middle_of(0) + QPointF(40, 10), 3);
  EXPECT_NE(centres().second, before.second);
  EXPECT_NEAR(geom::length((centres().second - centres().first) - (before.second - before.first)), 0.0, 1e-9);
  action("view.linked")->trigger();
}

TEST_F(ViewTest, AltLeftAndAltRightGoThroughWhatWasSeen) {
  open_bumps();
  press(Qt::Key_Left, Qt::AltModifier);  // nothing was seen before
  press(Qt::Key_F);
  const scene::View all = window.view().view(0);
  turn_wheel(middle_of(0), 1);
  turn_wheel(middle_of(0), 1);
  turn_wheel(middle_of(0), 1);
  const scene::View near = window.view().view(0);
  press(Qt::Key_Left, Qt::AltModifier);
  EXPECT_EQ(window.view().view(0), all);
  press(Qt::Key_Right, Qt::AltModifier);
  EXPECT_EQ(window.view().view(0), near);
  press(Qt::Key_Right, Qt::AltModifier);
  EXPECT_EQ(window.view().view(0), near);
}

TEST_F(ViewTest, TheHandPansAndNothingElse) {
  open_bumps();
  press(Qt::Key_H);
  EXPECT_EQ(window.view().cursor().shape(), Qt::OpenHandCursor);
  EXPECT_NE(label("status.hint").find("Drag to move the view"), std::string::npos);
  const Point centre = window.view().view(0).centre;
  const QPoint from = pixel({500, 300});
  drag(Qt::LeftButton, from, from + QPoint(-40, 25));
  settle();
  EXPECT_NEAR(window.view().pixel_of(0, {500, 300}).x(), from.x() - 40, 1.0);
  EXPECT_NE(window.view().view(0).centre, centre);
  EXPECT_TRUE(selection().empty());
  EXPECT_FALSE(window.session().history().can_undo());
  press(Qt::Key_Escape);
  EXPECT_TRUE(is_selecting());
  EXPECT_EQ(window.view().cursor().shape(), Qt::ArrowCursor);
  EXPECT_TRUE(action("draw.select")->isChecked());
}

TEST_F(ViewTest, SpaceInTheMiddleOfALinePansAndAddsNoPoint) {
  open_bumps();
  ASSERT_TRUE(window.actions().trigger("draw.line"));
  click_at({200, 200});
  const auto last = window.canvas().tool().last();
  ASSERT_TRUE(last);
  QTest::keyPress(&window.view(), Qt::Key_Space);
  const QPoint from = pixel({600, 100});
  drag(Qt::LeftButton, from, from + QPoint(-40, 25));
  QTest::keyRelease(&window.view(), Qt::Key_Space);
  EXPECT_EQ(window.canvas().tool().last(), last);
  EXPECT_EQ(window.view().cursor().shape(), Qt::CrossCursor);
}

TEST_F(ViewTest, ABoxIsZoomedToAndAClickIsTwiceAsNear) {
  open_bumps();
  for (const char* typed : {"1", "5"}) {
    exaggerate(typed);
    press(Qt::Key_F);
    press(Qt::Key_Z);
    const double before = window.view().view(0).world_per_point;
    drag(Qt::LeftButton, pixel({400, 280}), pixel({600, 320}));
    EXPECT_LT(window.view().view(0).world_per_point, 0.5 * before);
    EXPECT_TRUE(sees({401, 281}) && sees({599, 319}));
    EXPECT_FALSE(sees({900, 350}) && sees({100, 300}));
    const double near = window.view().view(0).world_per_point;
    const QPoint at = pixel({500, 300});
    QTest::mouseClick(&window.view(), Qt::LeftButton, {}, at);
    EXPECT_NEAR(window.view().view(0).world_per_point, near / 2, 1e-6 * near);
    EXPECT_NEAR(geom::distance(window.view().spot_at(at)->at, {500, 300}), 0.0, near);
    QTest::mouseClick(&window.view(), Qt::LeftButton, Qt::ShiftModifier, at);
    EXPECT_NEAR(window.view().view(0).world_per_point, near, 1e-6 * near);
    EXPECT_TRUE(selection().empty());
    press(Qt::Key_S);
    EXPECT_TRUE(is_selecting());
  }
}

TEST_F(ViewTest, ABoxWithoutWidthAndOneLeftByEscapeDoNoHarm) {
  open_bumps();
  press(Qt::Key_Z);
  const scene::View before = window.view().view(0);
  QTest::mousePress(&window.view(), Qt::LeftButton, {}, pixel({400, 280}));
  move(pixel({600, 400}), Qt::LeftButton);
  press(Qt::Key_Escape);
  QTest::mouseRelease(&window.view(), Qt::LeftButton, {}, pixel({600, 400}));
  EXPECT_EQ(window.view().view(0), before);
  EXPECT_FALSE(is_selecting());
  drag(Qt::LeftButton, pixel({400, 280}), pixel({400, 380}));
  const scene::View after = window.view().view(0);
  EXPECT_TRUE(std::isfinite(after.world_per_point) && after.world_per_point > 0.0);
  EXPECT_TRUE(sees({400, 281}) && sees({400, 379}));
  press(Qt::Key_Escape);
  EXPECT_TRUE(is_selecting());
}

TEST_F(ViewTest, TheSelectionIsZoomedTo) {
  open_bumps();
  press(Qt::Key_F, Qt::ShiftModifier);
  EXPECT_NE(label("status.hint").find("Nothing is selected"), std::string::npos);
  click_at({300, 475});
  ASSERT_EQ(selection().size(), 1U);
  press(Qt::Key_F, Qt::ShiftModifier);
  EXPECT_TRUE(sees({200, 500}) && sees({600, 400}));
  EXPECT_FALSE(sees({900, 350}));
  click_at({200, 500});  // a vertex: no box at all
  const double scale = window.view().view(0).world_per_point;
  press(Qt::Key_F, Qt::ShiftModifier);
  EXPECT_EQ(window.view().view(0).world_per_point, scale);
  EXPECT_NEAR(geom::distance(window.view().view(0).centre, {200, 500}), 0.0, 1e-9);
}

TEST_F(ViewTest, WhatIsSelectedIsToldWithItsLength) {
  open_bumps();
  click_at({300, 475});
  EXPECT_EQ(label("status.hint"), "B: 412.311 m, 2 vertices");
  click_at({300, 300}, Qt::ShiftModifier);
  EXPECT_EQ(label("status.hint"), "2 lines: 1215.42 m, 5 vertices");
  move(pixel({500, 150}, 1));  // nobody loses a selection by passing over another panel
  EXPECT_EQ(selection().size(), 2U);
}

TEST_F(ViewTest, AllAreSelectedAndInvertedOnThePictureAndNotWhileTextIsTyped) {
  open_bumps();
  press(Qt::Key_A, Qt::ControlModifier);
  const std::size_t all = selection().size();
  EXPECT_GE(all, 2U);
  press(Qt::Key_I, Qt::ControlModifier);
  EXPECT_TRUE(selection().empty());
  click_at({300, 475});
  press(Qt::Key_I, Qt::ControlModifier);
  EXPECT_EQ(selection().size(), all - 1);
  EXPECT_FALSE(selection().contains({"bump_1", 1}));
  press(Qt::Key_Escape);
  ASSERT_TRUE(selection().empty());
  click(editor("amplitude"));
  press(Qt::Key_A, Qt::ControlModifier);
  press(Qt::Key_C, Qt::ControlModifier);
  EXPECT_TRUE(selection().empty());
  EXPECT_EQ(QApplication::clipboard()->text().left(3), "100");
}

TEST_F(ViewTest, LinesGoThroughTheClipboardToAnotherWindow) {
  open_bumps();
  QApplication::clipboard()->clear();
  press(Qt::Key_C, Qt::ControlModifier);
  EXPECT_NE(label("status.hint").find("Nothing is selected"), std::string::npos);
  click_at({300, 300});
  click_at({300, 475}, Qt::ShiftModifier);
  press(Qt::Key_C, Qt::ControlModifier);
  EXPECT_EQ(QApplication::clipboard()->text(), "# A\n100\t300\n500\t300\n900\t350\n\n# B\n200\t500\n600\t400\n");
  MainWindow another(program);
  another.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&another, 10000));
  another.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&another, 5000));
  another.view().setFocus();
  answer();
  QTest::keyClick(&another.view(), Qt::Key_V, Qt::ControlModifier);
  const std::vector<scenario::Table> bumps = test::bumps_of(another.session().document());
  ASSERT_EQ(bumps.size(), 2U);
  EXPECT_EQ(*bumps[0].find("name"), scenario::Value("A"));
  EXPECT_EQ(std::get<scenario::Points>(*bumps[1].find("points")).list(), (std::vector<Point>{{200, 500}, {600, 400}}));
}

TEST_F(ViewTest, CutIsOneStepOfUndoAndPasteAsksTheName) {
  open_bumps();
  click_at({300, 300});
  press(Qt::Key_X, Qt::ControlModifier);
  settle();
  ASSERT_EQ(count(), 1U);
  answer({"again"});
  press(Qt::Key_V, Qt::ControlModifier);
  settle();
  ASSERT_EQ(count(), 2U);
  EXPECT_EQ(bump(1), (std::vector<Point>{{100, 300}, {500, 300}, {900, 350}}));
  EXPECT_EQ(*test::bumps_of(window.session().document())[1].find("name"), scenario::Value("again"));
  window.session().undo();
  EXPECT_EQ(count(), 1U);
  window.session().undo();
  EXPECT_EQ(count(), 2U);
  EXPECT_EQ(bump(0).size(), 3U);
  EXPECT_FALSE(window.session().history().can_undo());
}

TEST_F(ViewTest, WhatCannotBePastedIsSaidAndWhatASpreadsheetHoldsIsDrawn) {
  open_bumps();
  const std::string before = text();
  for (const auto& [held, said] : {std::pair("dear all", "holds no points"),
                                   {"1\t2\nx\ty", "line 2"},
                                   {"", "holds no points"},
                                   {"5\t5", "cannot be drawn"}}) {
    QApplication::clipboard()->setText(held);
    press(Qt::Key_V, Qt::ControlModifier);
    EXPECT_EQ(text(), before) << held;
    EXPECT_NE(label("status.hint").find(said), std::string::npos) << held << ": " << label("status.hint");
  }
  QApplication::clipboard()->setText("x\tz\r\n0,5\t10\r\n100\t20\r\n");
  answer({"C"});
  press(Qt::Key_V, Qt::ControlModifier);
  settle();
  ASSERT_EQ(count(), 3U);
  EXPECT_EQ(bump(2), (std::vector<Point>{{0.5, 10}, {100, 20}}));
}

TEST_F(ViewTest, PlacesGoToTheGridButFirstToWhatIsThere) {
  open_bumps();
  for (const char* typed : {"1", "5"}) {
    exaggerate(typed);
    press(Qt::Key_F);
    press(Qt::Key_F4);
    press(Qt::Key_F4, Qt::ShiftModifier);
    const geom::Vector step = window.view().tick_step(0);
    ASSERT_GT(step.x, 0.0);
    ASSERT_GT(step.y, 0.0);
    ASSERT_TRUE(window.actions().trigger("draw.line"));
    const Point node{std::round(650 / step.x) * step.x, std::round(210 / step.y) * step.y};
    const QPoint near = pixel(node) + QPoint(4, -3);
    move(near);
    QTest::mouseClick(&window.view(), Qt::LeftButton, {}, near);
    EXPECT_EQ(window.canvas().tool().last(), node);
    const QPoint on_vertex = pixel({500, 300}) + QPoint(3, 3);
    move(on_vertex);
    QTest::mouseClick(&window.view(), Qt::LeftButton, {}, on_vertex);
    EXPECT_EQ(window.canvas().tool().last(), (Point{500, 300}));
    press(Qt::Key_Escape);
    press(Qt::Key_F4);
    press(Qt::Key_F4, Qt::ShiftModifier);
    move(near);
    QTest::mouseClick(&window.view(), Qt::LeftButton, {}, near);
    EXPECT_NE(window.canvas().tool().last(), node);
    press(Qt::Key_Escape);
    press(Qt::Key_S);
  }
}

TEST_F(ViewTest, FeetAreShownAndTypedAndMetresAreWritten) {
  open_bumps();
  action("view.unit.ft")->trigger();
  move(pixel({304.8, 100}));
  EXPECT_EQ(label("status.place").substr(0, 7), "x = 100");
  EXPECT_TRUE(label("status.place").ends_with(" ft")) << label("status.place");
  ASSERT_TRUE(window.actions().trigger("draw.line"));
  QTest::keyClicks(&window.view(), "1");
  QTest::keyClicks(focus(), "000;0");
  press(Qt::Key_Return);
  QTest::keyClicks(&window.view(), "@");
  QTest::keyClicks(focus(), "100<90");
  press(Qt::Key_Return);
  answer({"C"});
  press(Qt::Key_Return);
  settle();
  ASSERT_EQ(count(), 3U);
  EXPECT_NEAR(bump(2)[0].x, 304.8, 1e-9);
  EXPECT_NEAR(bump(2)[1].y, 30.48, 1e-9);
  take_focus();
  press(Qt::Key_S);
  click_at({300, 475});
  EXPECT_EQ(label("status.hint"), "B: 1352.72 ft, 2 vertices");
  action("view.unit.as_read")->trigger();
  move(pixel({304.8, 100}));
  EXPECT_TRUE(label("status.place").ends_with(" m")) << label("status.place");
}

TEST_F(ViewTest, TheInputIsAGhostUnderTheResultAndEditedThere) {
  open_bumps("[[step]]\noperation = \"lift\"\nby = 100.0\n");
  action("view.panels.ghost")->trigger();
  ASSERT_EQ(window.view().panel_count(), 2U);
  for (const char* typed : {"1", "5"}) {
    exaggerate(typed);
    press(Qt::Key_F);
    window.session().edit(documents::with_step(window.session().document(), 0, "lift"), "another");
    window.session().undo();
    settle();
    // The result is no line that could be selected; the ghost below it is.
    click_at({300, 400});
    EXPECT_TRUE(selection().empty());
    click_at({300, 300});
    ASSERT_EQ(selection().size(), 1U) << typed;
    EXPECT_EQ(selection().begin()->first.layer, "ghost.bump_0");
    drag(Qt::LeftButton, pixel({500, 300}), pixel({500, 260}));
    settle();
    EXPECT_NEAR(bump(0)[1].y, 260.0, window.view().view(0).world_per_point);
    window.session().undo();
    settle();
    EXPECT_EQ(bump(0)[1], (Point{500, 300}));
    press(Qt::Key_Escape);
  }
  action("view.panels.as_fits")->trigger();
  EXPECT_EQ(window.view().panel_count(), 2U);
  click_at({300, 300});
  EXPECT_TRUE(selection().empty());
}

TEST_F(ViewTest, TheLineUnderTheCursorIsKnownAndForgotten) {
  open_bumps();
  move(pixel({300, 300}));
  ASSERT_TRUE(window.canvas().hovered());
  EXPECT_EQ(window.canvas().hovered()->on->layer, "bump_0");
  EXPECT_EQ(label("status.dip"), "dip 0.0° (A)");
  move(pixel({300, 220}));
  EXPECT_FALSE(window.canvas().hovered());
  EXPECT_EQ(label("status.dip"), "");
  move(pixel({300, 300}));
  QEvent leave(QEvent::Leave);
  QCoreApplication::sendEvent(&window.view(), &leave);
  EXPECT_FALSE(window.canvas().hovered());
}

TEST_F(ViewTest, AMenuOfALineDoesWhatItSaysThere) {
  open_bumps();
  EXPECT_EQ(menu_at({300, 200}), nullptr);
  QMenu* menu = menu_at({300, 300});
  ASSERT_NE(menu, nullptr);
  EXPECT_EQ(selection().size(), 1U);
  choose(menu, "line.insert_vertex");
  settle();
  ASSERT_EQ(bump(0).size(), 4U);
  EXPECT_NEAR(bump(0)[1].x, 300.0, window.view().view(0).world_per_point);
  menu = menu_at({300, 475});
  choose(menu, "line.copy");
  EXPECT_TRUE(QApplication::clipboard()->text().startsWith("# B\n"));
  menu = menu_at({300, 475});
  choose(menu, "line.zoom");
  EXPECT_FALSE(sees({900, 350}));
  press(Qt::Key_F);
  menu = menu_at({300, 475});
  answer({"renamed"});
  choose(menu, "line.rename");
  settle();
  EXPECT_EQ(*test::bumps_of(window.session().document())[1].find("name"), scenario::Value("renamed"));
  menu = menu_at({300, 475});
  choose(menu, "line.delete");
  settle();
  EXPECT_EQ(count(), 1U);
  menu = menu_at({200, 300});
  choose(menu, "line.hide");
  menu = menu_at({200, 300});
  EXPECT_EQ(menu, nullptr);
}

TEST_F(ViewTest, WhatAStepHasMadeCannotBeRenamedOrDeletedInItsMenu) {
  open_bumps("[[step]]\noperation = \"lift\"\nby = 100.0\n");
  QMenu* menu = menu_at({300, 400});
  ASSERT_NE(menu, nullptr);
  for (const char* name : {"line.rename", "line.kind", "line.delete", "line.split", "line.insert_vertex"})
    EXPECT_FALSE(menu->findChild<QAction*>(name)->isEnabled()) << name;
  for (const char* name : {"line.copy", "line.zoom", "line.hide"})
    EXPECT_TRUE(menu->findChild<QAction*>(name)->isEnabled()) << name;
  menu->close();
}

TEST_F(ViewTest, ASavedPictureIsExaggeratedAsTheOneThatIsSeen) {
  open_bumps();
  ASSERT_TRUE(window.save_picture(folder / "true.svg").ok());
  EXPECT_EQ(folder.read("true.svg").find("vertical exaggeration"), std::string::npos);
  scene::Picture picture = *window.session().outcome()->picture;
  exaggerate("5");
  window.view().make_alike(picture);
  EXPECT_EQ(picture.panels[0].vertical_exaggeration, 5.0);
  ASSERT_TRUE(window.save_picture(folder / "high.svg").ok());
  EXPECT_NE(folder.read("high.svg"), folder.read("true.svg"));
}

TEST_F(ViewTest, ASavedPictureShowsThePartThatIsSeen) {
  open_bumps();
  const auto words = [&](const char* name) {
    std::set<std::string> found;
    EXPECT_TRUE(window.save_picture(folder / name).ok());
    const std::string svg = folder.read(name);
    for (std::size_t at = svg.find(">"); at != std::string::npos; at = svg.find(">", at + 1))
      found.insert(svg.substr(at + 1, svg.find("<", at) - at - 1));
    return found;
  };
  const std::set<std::string> all = words("all.svg");
  EXPECT_TRUE(all.contains("1000"));
  EXPECT_FALSE(all.contains("430"));
  window.view().look_at(0, {{410.0, -20.0}, {490.0, 60.0}});
  const std::set<std::string> part = words("part.svg");
  EXPECT_FALSE(part.contains("1000"));
  EXPECT_TRUE(part.contains("440"));
  window.view().fit();
  EXPECT_EQ(words("again.svg"), all);
}

}  // namespace
}  // namespace dobra::gui
