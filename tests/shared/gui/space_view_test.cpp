// The view in space of a window, with mouse and keys as a person uses them.
#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QLabel>
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
TEST_F(SpaceView, ManyTrianglesTurnQuickly) {
  const char* wish = std::getenv("DOBRA_SPACE_TRIANGLES");
  const double wanted = wish != nullptr ? std::atof(wish) : 100000.0;
  make(static_cast<std::size_t>(std::sqrt(0.5 * wanted)));
  ASSERT_TRUE(window->actions().trigger("view.space.alone"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return space().is_settled(); }, 60000));
  const QPointF middle = space().plot().center();
  QTest::mousePress(&space(), Qt::LeftButton, {}, middle.toPoint());
  int frames = 0;
  const auto counter = QObject::connect(&space(), &QOpenGLWidget::frameSwapped, [&] { ++frames; });
  const auto begin = std::chrono::steady_clock::now();
  double longest = 0.0;
  const int moves = wish != nullptr ? 60 : 10;
  for (int i = 0; i < moves; ++i) {
    const auto before = std::chrono::steady_clock::now();
    move(space(), Qt::LeftButton, middle + QPointF(6.0 * i, 2.0 * i));
    space().repaint();
    QCoreApplication::processEvents();
    longest = std::max(longest, std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count());
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  QObject::disconnect(counter);
  QTest::mouseRelease(&space(), Qt::LeftButton, {}, middle.toPoint());
  EXPECT_GT(frames, 0);
  if (wish == nullptr) return;
  // What the window's thread is kept from other things until all is drawn again.
  double gap = 0.0;
  auto last = std::chrono::steady_clock::now();
  while (!space().is_settled()) {
    QCoreApplication::processEvents(QEventLoop::AllEvents, 5);
    const auto now = std::chrono::steady_clock::now();
    gap = std::max(gap, std::chrono::duration<double>(now - last).count());
    last = now;
  }
  std::printf(
      "%g triangles at %dx%d: %.1f frames a second while turning, longest %.0f ms; longest gap at rest %.0f ms\n",
      wanted, space().width(), space().height(), frames / seconds, 1000.0 * longest, 1000.0 * gap);
}

}  // namespace
}  // namespace dobra::test
