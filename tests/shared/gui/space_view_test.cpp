// The view in space of a window, with mouse and keys as a person uses them.
#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSlider>
#include <QTest>
#include <QWheelEvent>
#include <chrono>
#include <set>

#include "shared/gui/actions/registry.h"
#include "shared/gui/layer_tree.h"
#include "shared/gui/main_window.h"
#include "shared/gui/stage/space_widget.h"
#include "shared/gui/vtk_widget.h"
#include "tests/shared/gui/fake_program.h"
#include "tests/support/space_picture.h"

namespace dobra::test {
namespace {

using gui::stage::ItemAt;
using gui::stage::MarkerDrag;
using gui::stage::SpaceWidget;
using scene::space::StandardView;

/// The waves, with hills in space and the chart of the hills as a panel of the plane.
scenario::Program program_in_space(std::size_t cells) {
  scenario::Program program = fake_program();
  program.results.draw_space = [cells](const scenario::State&, scene::space::SpacePicture& picture) {
    picture = space_picture(cells);
  };
  const auto draw = program.results.draw;
  program.results.draw = [draw, cells](const scenario::State& state, scene::Picture& picture) {
    draw(state, picture);
    const scene::space::Surface surface = hills(std::min<std::size_t>(cells, 12));
    scene::Layer layer;
    layer.key = "top";
    layer.title = "Parameter mesh";
    layer.style.fill = scene::Color{220, 225, 235};
    layer.style.line_width = 0.5;
    scene::Mesh mesh;
    mesh.points = surface.chart;
    mesh.triangles = surface.triangles;
    layer.content = mesh;
    scene::Panel panel;
    panel.key = "chart";
    panel.title = "Parameter space";
    panel.axes = {"u", "v"};
    panel.layers = {layer};
    picture.panels = {panel};
  };
  return program;
}

class SpaceView : public testing::Test {
 protected:
  void make(std::size_t cells = 12, gui::WindowPart part = {}) {
    program = program_in_space(cells);
    window = std::make_unique<gui::MainWindow>(program, std::move(part));
    window->resize(1280, 800);
    window->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get(), 10000));
    ASSERT_TRUE(window->open(folder.write("waves.toml", waves_text())).ok());
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window->session().busy(); }, 30000));
    ASSERT_TRUE(QTest::qWaitFor([&] { return space().is_ready() && space().is_settled(); }, 30000));
    QCoreApplication::processEvents();
  }
  SpaceWidget& space() { return window->space(); }
  void drag(QWidget& widget, Qt::MouseButton button, QPointF from, QPointF to) {
    QTest::mousePress(&widget, button, {}, from.toPoint());
    for (const double t : {0.25, 0.5, 0.75, 1.0}) move(widget, button, from + t * (to - from));
    QTest::mouseRelease(&widget, button, {}, to.toPoint());
    QCoreApplication::processEvents();
  }
  static void move(QWidget& widget, Qt::MouseButton button, QPointF at) {
    QMouseEvent event(QEvent::MouseMove, at, widget.mapToGlobal(at), Qt::NoButton, button, {});
    QCoreApplication::sendEvent(&widget, &event);
  }
  void focus_space() {
    window->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(window.get(), 5000));
    space().setFocus();
    ASSERT_TRUE(QTest::qWaitFor([&] { return space().hasFocus(); }, 5000));
  }
  QString all_words() {
    QString words;
    for (const QLabel* label : window->findChildren<QLabel*>()) words += label->text() + "\n";
    return words;
  }

  TemporaryFolder folder;
  scenario::Program program;
  std::unique_ptr<gui::MainWindow> window;
};

TEST_F(SpaceView, StandsBesideThePlaneWhereTheProgramHasSomethingInSpace) {
  make();
  EXPECT_TRUE(space().isVisible());
  EXPECT_TRUE(window->view().isVisible());
  EXPECT_GT(space().width(), 240);
  ASSERT_TRUE(window->actions().trigger("view.space.alone"));
  EXPECT_FALSE(window->view().isVisible());
  ASSERT_TRUE(window->actions().trigger("view.space.plane"));
  EXPECT_TRUE(window->view().isVisible());
  EXPECT_FALSE(space().isVisible());
  ASSERT_TRUE(window->actions().trigger("view.space.both"));
  EXPECT_TRUE(space().isVisible());
}

TEST_F(SpaceView, IsNotThereForAProgramOfThePlane) {
  program = fake_program();
  gui::MainWindow plane(program);
  plane.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&plane, 10000));
  ASSERT_TRUE(plane.open(folder.write("waves.toml", waves_text())).ok());
  ASSERT_TRUE(QTest::qWaitFor([&] { return !plane.session().busy(); }, 30000));
  EXPECT_FALSE(plane.space().isVisible());
  EXPECT_FALSE(plane.actions().trigger("view.space.isometric"));
  EXPECT_FALSE(plane.save_space_picture(folder.write("a.svg", "")).ok());
}

TEST_F(SpaceView, IsDrawnAndNotBlank) {
  make();
  space().come_to_rest();
  const QImage image = space().grabFramebuffer();
  std::set<QRgb> colors;
  for (int y = 0; y < image.height(); y += 3) {
    for (int x = 0; x < image.width(); x += 3) colors.insert(image.pixel(x, y));
  }
  EXPECT_GT(colors.size(), 100U);
  const char* wish = std::getenv("DOBRA_SPACE_SCREENSHOT");
  if (wish != nullptr) {
    space().mark(scene::Pick{"top", 40});
    QTest::qWait(500);
    EXPECT_TRUE(window->save_screenshot(wish).ok());
  }
}

/// Of a picture that fills the view, whatever the window becomes.
TEST_F(SpaceView, WhatWasInSightStaysSoInASmallerWindowAndComesBack) {
  make();
  const QPointF middle = space().plot().center();
  drag(space(), Qt::LeftButton, middle, middle + QPointF(30.0, 0.0));  // from here on the view is the user's
  const auto seen_corners = [&] {
    const geom::Box3 box = scene::space::extent(space().shown());
    int seen = 0;
    for (const double x : {box.low.x, box.high.x}) {
      for (const double y : {box.low.y, box.high.y}) {
        for (const double z : {box.low.z, box.high.z})
          seen += space().plot().contains(*space().pixel_of({x, y, z})) ? 1 : 0;
      }
    }
    return seen;
  };
  const auto in_sight = [&] { return space().look().view->world_per_point * space().plot().size(); };
  const double scale = space().look().view->world_per_point;
  const QSizeF seen = in_sight();
  ASSERT_EQ(seen_corners(), 8);
  window->resize(900, 640);
  QTest::qWait(100);
  EXPECT_EQ(seen_corners(), 8);
  EXPECT_GT(space().look().view->world_per_point, scale);
  window->resize(1280, 800);
  QTest::qWait(100);
  EXPECT_EQ(seen_corners(), 8);
  // Panels beside it may have another width by now: as much as before in one direction, and no less in the other.
  EXPECT_NEAR(std::min(in_sight().width() / seen.width(), in_sight().height() / seen.height()), 1.0, 1e-9);
}

TEST_F(SpaceView, TheLeftButtonTurnsTheMiddleOneMovesTheWheelComesNearer) {
  make();
  const auto before = space().look();
  const QPointF middle = space().plot().center();
  drag(space(), Qt::LeftButton, middle, middle + QPointF(80.0, 0.0));
  const auto turned = space().look();
  EXPECT_NE(turned.camera, before.camera);
  EXPECT_FALSE(space().marked());  // a drag is no click
  drag(space(), Qt::MiddleButton, middle, middle + QPointF(40.0, 25.0));
  EXPECT_EQ(space().look().camera, turned.camera);
  const scene::View panned = *space().look().view;
  // What was under the cursor stays there under the wheel.
  const geom::Point3 there = space().picture().layers.size() > 1 ? geom::Point3{3000.0, 800.0, 900.0} : geom::Point3{};
  const QPointF at = *space().pixel_of(there);
  QWheelEvent wheel(at, space().mapToGlobal(at), {}, {0, 360}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
  QCoreApplication::sendEvent(&space(), &wheel);
  EXPECT_NEAR(space().look().view->world_per_point, panned.world_per_point / std::pow(1.2, 3.0), 1e-9);
  EXPECT_NEAR(space().pixel_of(there)->x(), at.x(), 0.01);
  EXPECT_NEAR(space().pixel_of(there)->y(), at.y(), 0.01);
}

TEST_F(SpaceView, SpaceHeldMakesTheLeftButtonMove) {
  make();
  focus_space();
  const auto before = space().look().camera;
  const QPointF middle = space().plot().center();
  const QPointF mark = *space().pixel_of({2000.0, 1500.0, 0.0});
  QTest::keyPress(&space(), Qt::Key_Space);
  drag(space(), Qt::LeftButton, middle, middle + QPointF(30.0, 12.0));
  QTest::keyRelease(&space(), Qt::Key_Space);
  EXPECT_EQ(space().look().camera, before);
  EXPECT_NEAR(space().pixel_of({2000.0, 1500.0, 0.0})->x(), mark.x() + 30.0, 1.0);
  EXPECT_NEAR(space().pixel_of({2000.0, 1500.0, 0.0})->y(), mark.y() + 12.0, 1.0);
}

TEST_F(SpaceView, KeysLookFromTheUsualSides) {
  make();
  focus_space();
  const std::vector<StandardView> views{StandardView::Front,     StandardView::Top,        StandardView::Right,
                                        StandardView::Isometric, StandardView::Dimetric,   StandardView::Cavalier,
                                        StandardView::Cabinet,   StandardView::Perspective};
  for (std::size_t i = 0; i < views.size(); ++i) {
    QTest::keyClick(&space(), static_cast<Qt::Key>(Qt::Key_1 + static_cast<int>(i)));
    EXPECT_EQ(space().look().camera, scene::space::camera_of(views[i]));
    EXPECT_FALSE(space().look().view);
  }
  QTest::keyClick(&space(), Qt::Key_Left);
  EXPECT_NE(space().look().camera, scene::space::camera_of(StandardView::Perspective));
  const auto turned = space().look().camera;
  QTest::keyClick(&space(), Qt::Key_Plus);
  QTest::keyClick(&space(), Qt::Key_Left, Qt::ShiftModifier);
  EXPECT_EQ(space().look().camera, turned);
  EXPECT_TRUE(space().look().view);
  QTest::keyClick(&space(), Qt::Key_F);
  EXPECT_FALSE(space().look().view);
}

TEST_F(SpaceView, GUI_b_AClickTellsTheItemItsPlaceAndItsChart) {
  std::vector<ItemAt> items;
  gui::WindowPart part;
  part.space.clicked = [&items](const gui::Desk&, const ItemAt& item) { items.push_back(item); };
  make(12, part);
  // From above, where u and v of a place can be read off its x and y.
  space().look_from(StandardView::Top);
  const QPointF at = *space().pixel_of({1200.0, 600.0, 0.0});
  QTest::mouseClick(&space(), Qt::LeftButton, {}, at.toPoint());
  ASSERT_EQ(items.size(), 1U);
  EXPECT_EQ(items[0].pick.layer, "top");
  ASSERT_TRUE(items[0].place && items[0].chart);
  EXPECT_NEAR(items[0].place->x, 1200.0, 15.0);
  EXPECT_NEAR(items[0].chart->x, items[0].place->x / 4000.0, 1e-9);
  EXPECT_NEAR(items[0].chart->y, items[0].place->y / 3000.0, 1e-9);
  // 12 x 12 cells of two triangles: column 3, row 2.
  EXPECT_EQ(items[0].pick.id / 2, 2U * 12U + 3U);
  EXPECT_EQ(space().marked(), items[0].pick);
  EXPECT_EQ(window->view().marked(), items[0].pick);
  EXPECT_TRUE(all_words().contains("Top of the sand, item " + QString::number(items[0].pick.id)));
}

TEST_F(SpaceView, GUI_b_AClickInTheChartMarksTheSameTriangleInSpace) {
  std::vector<ItemAt> items;
  gui::WindowPart part;
  part.space.clicked = [&items](const gui::Desk&, const ItemAt& item) { items.push_back(item); };
  make(12, part);
  ASSERT_TRUE(QTest::qWaitFor([&] { return window->view().is_ready() && window->view().is_settled(); }, 10000));
  const QPointF at = window->view().pixel_of(0, {3.6 / 12.0, 2.2 / 12.0});
  QTest::mouseClick(&window->view(), Qt::LeftButton, {}, at.toPoint());
  ASSERT_TRUE(space().marked());
  EXPECT_EQ(space().marked()->layer, "top");
  EXPECT_EQ(space().marked()->id, 2U * (2U * 12U + 3U));  // below the diagonal of its cell
  ASSERT_EQ(items.size(), 1U);
  EXPECT_EQ(items[0].panel, "chart");
  EXPECT_NEAR(items[0].chart->x, 3.6 / 12.0, 0.01);
}

TEST_F(SpaceView, AClickBesideThePictureMarksNothing) {
  make();
  space().mark(scene::Pick{"top", 3});
  QTest::mouseClick(&space(), Qt::LeftButton, {}, (space().plot().topLeft() + QPointF(6.0, 6.0)).toPoint());
  EXPECT_FALSE(space().marked());
  EXPECT_FALSE(window->view().marked());
}

TEST_F(SpaceView, GUI_b_AMarkerIsDraggedInThePlaneOfTheScreen) {
  struct Step {
    MarkerDrag phase;
    ItemAt marker;
    geom::Point3 to;
  };
  std::vector<Step> steps;
  gui::WindowPart part;
  part.space.draggable = {"heads"};
  part.space.dragged = [&steps](const gui::Desk&, MarkerDrag phase, const ItemAt& marker, const geom::Point3& to) {
    steps.push_back({phase, marker, to});
  };
  make(12, part);
  space().look_from(StandardView::Front);
  const geom::Point3 head{500.0, 500.0, 700.0};
  const QPointF from = *space().pixel_of(head);
  const QPointF to = *space().pixel_of({900.0, 500.0, 400.0});
  const auto camera = space().look().camera;
  drag(space(), Qt::LeftButton, from, to);
  ASSERT_GE(steps.size(), 3U);
  EXPECT_EQ(steps.front().phase, MarkerDrag::Begins);
  EXPECT_EQ(steps.back().phase, MarkerDrag::Ends);
  EXPECT_EQ(steps.back().marker.pick, (scene::Pick{"heads", 5}));
  const double pixel = space().look().view ? space().look().view->world_per_point : 10.0;
  EXPECT_NEAR(steps.back().to.x, 900.0, 2.0 * pixel);
  EXPECT_NEAR(steps.back().to.y, 500.0, 1e-6);
  EXPECT_NEAR(steps.back().to.z, 400.0, 2.0 * pixel);
  EXPECT_EQ(space().look().camera, camera);  // it was not turned
  // Escape in the middle of a drag gives the place back.
  focus_space();
  QTest::mousePress(&space(), Qt::LeftButton, {}, from.toPoint());
  move(space(), Qt::LeftButton, to);
  QTest::keyClick(&space(), Qt::Key_Escape);
  QTest::mouseRelease(&space(), Qt::LeftButton, {}, to.toPoint());
  EXPECT_EQ(steps.back().phase, MarkerDrag::IsTakenBack);
  EXPECT_EQ(steps.back().to, head);
}

/// With the section plane in the middle, square to x.
class SectionInSpace : public SpaceView {
 protected:
  void make_section(StandardView view) {
    make();
    ASSERT_TRUE(window->actions().trigger("view.space.section"));
    space().look_from(view);
    slider = window->findChild<QSlider*>("section.place");
    number = window->findChild<QLineEdit*>("section.number");
    axis = window->findChild<QComboBox*>("section.axis");
    ASSERT_TRUE(slider != nullptr && number != nullptr && axis != nullptr);
    ASSERT_TRUE(slider->isVisible() && number->isVisible());
    ASSERT_TRUE(space().section_handle().isVisible());
  }
  /// The line along which the hills are cut.
  std::vector<geom::Point3> cut_points() {
    std::vector<geom::Point3> points;
    for (const scene::space::Layer& layer : space().shown().layers) {
      if (layer.key != "top.cut") continue;
      for (const auto& line : std::get<scene::space::Lines>(layer.content).lines)
        points.insert(points.end(), line.begin(), line.end());
    }
    return points;
  }
  /// Reads the field as a person would.
  double typed() { return number->text().replace(',', '.').toDouble(); }

  QSlider* slider = nullptr;
  QLineEdit* number = nullptr;
  QComboBox* axis = nullptr;
};

TEST_F(SectionInSpace, GUI_b_TheArrowMovesItAlongItsNormalAndTheCutFollows) {
  make_section(StandardView::Isometric);
  const auto camera = space().look().camera;
  const QPointF from = *space().section_handle().arrow_pixel();
  // How far a kilometre along x goes on the screen, from the middle of the picture.
  const QPointF kilometre = *space().pixel_of({3000.0, 1500.0, 0.0}) - *space().pixel_of({2000.0, 1500.0, 0.0});
  EXPECT_EQ(slider->value(), 500);
  QTest::mousePress(&space(), Qt::LeftButton, {}, from.toPoint());
  for (const double part : {0.2, 0.4, 0.6, 0.8}) {
    move(space(), Qt::LeftButton, from + part * kilometre);
    const auto line = cut_points();
    ASSERT_FALSE(line.empty());
    const double pixel = 1000.0 / std::hypot(kilometre.x(), kilometre.y());
    for (const geom::Point3& p : line) {
      EXPECT_NEAR(p.x, 2000.0 + 1000.0 * part, 2.0 * pixel);  // presses are on whole pixels
      EXPECT_NEAR(p.x, line.front().x, 1e-6);
    }
    EXPECT_NEAR(slider->value(), line.front().x / 4.0, 0.51);
    EXPECT_NEAR(typed(), line.front().x, 5.0);
  }
  QTest::mouseRelease(&space(), Qt::LeftButton, {}, (from + 0.8 * kilometre).toPoint());
  EXPECT_NEAR(cut_points().front().x, 2800.0, 20.0);
  EXPECT_EQ(space().look().camera, camera);
  EXPECT_FALSE(space().marked());
  EXPECT_FALSE(window->session().history().can_undo());
  EXPECT_EQ(axis->count(), 3);
}

TEST_F(SectionInSpace, GUI_b_TheRimTurnsItAndTheBarSaysSo) {
  make_section(StandardView::Top);
  // Seen from above the plane is a line; its northern end goes round the middle.
  std::vector<QPointF> sides = space().section_handle().rim_pixels();
  ASSERT_EQ(sides.size(), 4U);
  std::sort(sides.begin(), sides.end(), [](QPointF a, QPointF b) { return a.y() < b.y(); });
  const QPointF end = sides.front(), middle = 0.5 * (sides.front() + sides.back());
  const double radius = middle.y() - end.y();
  EXPECT_GT(radius, 40.0);  // pixels, of which half of one is lost in a press
  const double angle = 30.0 * std::acos(-1.0) / 180.0;
  drag(space(), Qt::LeftButton, end, middle + radius * QPointF(-std::sin(angle), -std::cos(angle)));
  ASSERT_TRUE(space().section());
  const geom::Vector3 normal = space().section()->normal;
  EXPECT_NEAR(normal.x, std::cos(angle), 0.04);
  EXPECT_NEAR(normal.y, std::sin(angle), 0.04);
  EXPECT_NEAR(normal.z, 0.0, 0.04);
  const auto along = [&] {
    double sum = 0.0;
    for (const geom::Point3& p : cut_points()) sum += normal.x * p.x + normal.y * p.y + normal.z * p.z;
    return sum / static_cast<double>(cut_points().size());
  };
  for (const geom::Point3& p : cut_points())
    EXPECT_NEAR(normal.x * p.x + normal.y * p.y + normal.z * p.z, along(), 1e-6);
  // The middle stays.
  const QPointF seen = *space().pixel_of(cut_points()[cut_points().size() / 2]) - middle;
  EXPECT_NEAR(seen.x() * std::cos(angle) - seen.y() * std::sin(angle), 0.0, 3.0);
  ASSERT_EQ(axis->count(), 4);
  EXPECT_EQ(axis->currentIndex(), 3);
  EXPECT_TRUE(axis->currentText().contains("0.8") || axis->currentText().contains("0,8"))
      << axis->currentText().toStdString();
  const char* wish = std::getenv("DOBRA_SECTION_SCREENSHOT");
  if (wish != nullptr) {
    space().look_from(StandardView::Isometric);
    QTest::qWait(500);
    EXPECT_TRUE(window->save_screenshot(wish).ok());
  }
  // The slider moves it along its normal; an axis makes it square again.
  const double before = along();
  slider->setFocus();
  QTest::keyClick(slider, Qt::Key_PageUp);
  EXPECT_EQ(space().section()->normal, normal);
  EXPECT_GT(along(), before + 50.0);
  axis->setFocus();
  QTest::keyClick(axis, Qt::Key_Home);
  EXPECT_EQ(space().section()->normal, (geom::Vector3{1.0, 0.0, 0.0}));
  EXPECT_EQ(axis->count(), 3);
}

TEST_F(SectionInSpace, EscapeTakesADragBack) {
  make_section(StandardView::Isometric);
  focus_space();
  const auto before = space().section();
  const QPointF from = *space().section_handle().arrow_pixel();
  QTest::mousePress(&space(), Qt::LeftButton, {}, from.toPoint());
  move(space(), Qt::LeftButton, from + QPointF(40.0, 25.0));
  EXPECT_NE(space().section(), before);
  EXPECT_NE(slider->value(), 500);
  QTest::keyClick(&space(), Qt::Key_Escape);
  EXPECT_EQ(space().section(), before);
  EXPECT_EQ(slider->value(), 500);
  move(space(), Qt::LeftButton, from + QPointF(60.0, 35.0));
  QTest::mouseRelease(&space(), Qt::LeftButton, {}, from.toPoint());
  EXPECT_EQ(space().section(), before);
}

TEST_F(SectionInSpace, APlaceIsTypedAndARefusedOneSaysWhatThereIs) {
  make_section(StandardView::Isometric);
  const auto type = [&](const QString& what) {
    number->setFocus();
    number->selectAll();
    QTest::keyClicks(number, what);
    QTest::keyClick(number, Qt::Key_Return);
  };
  type("1250");
  ASSERT_FALSE(cut_points().empty());
  for (const geom::Point3& p : cut_points()) EXPECT_NEAR(p.x, 1250.0, 1e-6);
  EXPECT_NEAR(slider->value(), 1250.0 / 4.0, 0.51);
  for (const char* wrong : {"99999", "-800", "east", ""}) {
    type(wrong);
    EXPECT_NEAR(typed(), 1250.0, 1.0) << wrong;
    EXPECT_NEAR(cut_points().front().x, 1250.0, 1e-6) << wrong;
    EXPECT_TRUE(all_words().contains("The section plane stands from 0 to 4000")) << wrong;
  }
  // Escape gives back what it was.
  QTest::keyClicks(number, "77");
  QTest::keyClick(number, Qt::Key_Escape);
  EXPECT_NEAR(typed(), 1250.0, 1.0);
}

TEST_F(SectionInSpace, ItsHandleHasACursorAndWords) {
  make_section(StandardView::Isometric);
  const auto over = [&](QPointF at) {
    QMouseEvent event(QEvent::MouseMove, at, space().mapToGlobal(at), Qt::NoButton, Qt::NoButton, {});
    QCoreApplication::sendEvent(&space(), &event);
    return space().cursor().shape();
  };
  EXPECT_TRUE(all_words().contains("its rim to turn it"));  // said as it is switched on
  const Qt::CursorShape arrow = over(*space().section_handle().arrow_pixel());
  EXPECT_TRUE(arrow == Qt::SizeBDiagCursor || arrow == Qt::SizeFDiagCursor || arrow == Qt::SizeHorCursor);
  EXPECT_TRUE(all_words().contains("moves along its normal"));
  EXPECT_EQ(over(space().section_handle().rim_pixels().front()), Qt::OpenHandCursor);
  EXPECT_TRUE(all_words().contains("turns about its middle"));
  EXPECT_EQ(over(space().plot().topLeft() + QPointF(5.0, 5.0)), Qt::ArrowCursor);
  EXPECT_FALSE(all_words().contains("turns about its middle"));
  // Without a section there is nothing to take hold of.
  const QPointF there = *space().section_handle().arrow_pixel();
  ASSERT_TRUE(window->actions().trigger("view.space.section"));
  EXPECT_FALSE(space().section_handle().isVisible());
  EXPECT_EQ(over(there), Qt::ArrowCursor);
  const auto camera = space().look().camera;
  drag(space(), Qt::LeftButton, there, there + QPointF(30.0, 0.0));
  EXPECT_NE(space().look().camera, camera);
}

TEST_F(SectionInSpace, AClickOnItsHandleTellsWhatLiesThere) {
  make_section(StandardView::Isometric);
  const auto section = space().section();
  for (const QPointF& at : space().section_handle().rim_pixels()) {
    const auto there = space().pick_at(at);
    QTest::mouseClick(&space(), Qt::LeftButton, {}, at.toPoint());
    EXPECT_EQ(space().marked().has_value(), there.has_value());
  }
  EXPECT_EQ(space().section(), section);
}

TEST_F(SectionInSpace, SwitchedOffDuringADragItIsGone) {
  make_section(StandardView::Isometric);
  const QPointF from = *space().section_handle().arrow_pixel();
  QTest::mousePress(&space(), Qt::LeftButton, {}, from.toPoint());
  move(space(), Qt::LeftButton, from + QPointF(30.0, 20.0));
  ASSERT_TRUE(window->actions().trigger("view.space.section"));
  move(space(), Qt::LeftButton, from + QPointF(50.0, 40.0));
  QTest::mouseRelease(&space(), Qt::LeftButton, {}, from.toPoint());
  EXPECT_FALSE(space().section());
}

TEST_F(SpaceView, ALayerOfTheListIsHiddenAndNoLongerFound) {
  make();
  space().look_from(StandardView::Top);
  const QPointF at = *space().pixel_of({1200.0, 600.0, 0.0});
  ASSERT_TRUE(space().pick_at(at));
  EXPECT_TRUE(window->layers().set_layer_visible("space/top", false));
  EXPECT_FALSE(space().pick_at(at));
  const auto& layers = space().picture().layers;
  const auto top = std::find_if(layers.begin(), layers.end(), [](const auto& layer) { return layer.key == "top"; });
  ASSERT_NE(top, layers.end());
  EXPECT_FALSE(top->visible);
}

TEST_F(SpaceView, HasNamesForThoseWhoDoNotSeeIt) {
  make();
  EXPECT_FALSE(space().accessibleName().isEmpty());
  EXPECT_FALSE(space().accessibleDescription().isEmpty());
  EXPECT_EQ(space().focusPolicy(), Qt::StrongFocus);
}

TEST_F(SpaceView, ItsPictureIsWrittenAsItIsLookedAt) {
  make();
  space().look_from(StandardView::Top);
  const auto top = folder.write("top.svg", "");
  ASSERT_TRUE(window->save_space_picture(top).ok());
  space().look_from(StandardView::Front);
  const auto front = folder.write("front.svg", "");
  ASSERT_TRUE(window->save_space_picture(front).ok());
  const auto text = [](const std::filesystem::path& file) {
    std::ifstream in(file);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  EXPECT_NE(text(top).find("y [m]</text>"), std::string::npos);
  EXPECT_EQ(text(front).find("y [m]</text>"), std::string::npos);
}

/// DOBRA_SPACE_TRIANGLES=1000000 turns so many and says how many frames a second there were.
TEST(SpaceWidgetAlone, ManyTrianglesTurnQuickly) {
  const char* wish = std::getenv("DOBRA_SPACE_TRIANGLES");
  const double wanted = wish != nullptr ? std::atof(wish) : 100000.0;
  SpaceWidget space;
  space.resize(1280, 800);
  space.set_picture(space_picture(static_cast<std::size_t>(std::sqrt(0.5 * wanted))), SpaceWidget::Looking::AtAll);
  space.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&space, 10000));
  ASSERT_TRUE(QTest::qWaitFor([&] { return space.is_ready() && space.is_settled(); }, 90000));
  const auto move = [&](QPointF at) {
    QMouseEvent event(QEvent::MouseMove, at, space.mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&space, &event);
  };
  using Clock = std::chrono::steady_clock;
  const auto seconds_since = [](Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
  };
  const QPointF middle = space.plot().center();
  QTest::mousePress(&space, Qt::LeftButton, {}, middle.toPoint());
  int frames = 0;
  const auto counter = QObject::connect(&space, &QOpenGLWidget::frameSwapped, [&] { ++frames; });
  const auto begin = Clock::now();
  double longest = 0.0;
  const auto before = space.look().camera;
  for (int i = 0; i < (wish != nullptr ? 60 : 10); ++i) {
    const auto one = Clock::now();
    move(middle + QPointF(6.0 * i, 2.0 * i));
    space.repaint();
    QCoreApplication::processEvents();
    longest = std::max(longest, seconds_since(one));
  }
  const double seconds = seconds_since(begin);
  QObject::disconnect(counter);
  QTest::mouseRelease(&space, Qt::LeftButton, {}, middle.toPoint());
  EXPECT_GT(frames, 0);
  EXPECT_NE(space.look().camera, before);
  // What the window's thread is kept from other things until all is drawn again.
  double gap = 0.0;
  for (auto last = Clock::now(); !space.is_settled(); last = Clock::now()) {
    QCoreApplication::processEvents(QEventLoop::AllEvents, 5);
    gap = std::max(gap, seconds_since(last));
  }
  if (wish == nullptr) return;
  std::printf(
      "%g triangles at %dx%d: %.1f frames a second while turning, longest %.0f ms; longest gap at rest %.0f ms\n",
      wanted, space.width(), space.height(), frames / seconds, 1000.0 * longest, 1000.0 * gap);
}

TEST(SpaceWidgetAlone, AClickOnManyTrianglesIsAnsweredOnceTheyCanBeFound) {
  SpaceWidget space;
  space.resize(500, 400);
  space.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&space, 10000));
  std::vector<std::optional<scene::space::SpacePick>> answers;
  QObject::connect(&space, &SpaceWidget::clicked, [&](const auto& pick) { answers.push_back(pick); });
  space.set_picture(space_picture(160), SpaceWidget::Looking::AtAll);
  space.look_from(StandardView::Top);
  QTest::mouseClick(&space, Qt::LeftButton, {}, space.pixel_of({1200.0, 600.0, 0.0})->toPoint());
  ASSERT_TRUE(QTest::qWaitFor([&] { return !answers.empty(); }, 20000));
  ASSERT_TRUE(answers.front());
  EXPECT_EQ(answers.front()->pick.layer, "top");
  EXPECT_NEAR(answers.front()->place.x, 1200.0, 30.0);
}

}  // namespace
}  // namespace dobra::test
