// The window on scenarios of solids, with mouse and keys as a person uses them.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QLabel>
#include <cmath>

#include "quebra/core/solid_layers.h"
#include "shared/gui/stage/section_handle.h"
#include "shared/gui/stage/space_widget.h"
#include "tests/gui/program_window.h"

namespace quebra::gui {
namespace {

namespace test = dobra::test;
namespace geom = dobra::geom;
namespace scene = dobra::scene;
namespace scenario = dobra::scenario;
using dobra::gui::stage::SpaceWidget;
using geom::Point;
using geom::Point3;
using scene::space::StandardView;

/// A block of 4 x 2 x 3 with a bore along y, and a ball that touches nothing.
const std::string bored =
    "dobra = 1\nprogram = \"quebra\"\n\n[input]\nsolids = true\n\n"
    "[[step]]\noperation = \"block\"\npart = \"rock\"\nsize = [4, 2, 3]\n\n"
    "[[step]]\noperation = \"cylinder\"\npart = \"bore\"\nat = [2, -1, 1.5]\naxis = [0, 1, 0]\nradius = 0.5\nheight = "
    "4\n\n"
    "[[step]]\noperation = \"subtract\"\npart = \"bored\"\nof = [\"rock\", \"bore\"]\n";

class SolidWindow : public test::ProgramWindow {
 public:
  SolidWindow() : ProgramWindow("quebra/plate_with_hole.toml") { (*this)->resize(1400, 850); }
  SpaceWidget& space() { return (*this)->space(); }
  void open_text(const std::string& text) {
    open(write("solids.toml", text));
    settle();
  }
  void settle() {
    come_to_rest();
    EXPECT_TRUE(QTest::qWaitFor([&] { return space().is_ready() && space().is_settled(); }, 30000));
    QCoreApplication::processEvents();
  }
  void act(const char* action) {
    ASSERT_TRUE((*this)->actions().trigger(action)) << action;
    settle();
  }
  void click_space(Point3 at) {
    const auto pixel = space().pixel_of(at);
    ASSERT_TRUE(pixel);
    QTest::mouseClick(&space(), Qt::LeftButton, {}, pixel->toPoint());
    QCoreApplication::processEvents();
  }
  void move_space(QPointF at) {
    QMouseEvent event(QEvent::MouseMove, at, space().mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&space(), &event);
  }
  const scene::space::Layer* layer(const std::string& key) {
    for (const scene::space::Layer& each : space().shown().layers) {
      if (each.key == key) return &each;
    }
    return nullptr;
  }
  std::string face_marked() {
    const auto& marked = space().marked();
    const scene::space::Layer* of = marked ? layer(marked->layer) : nullptr;
    return of != nullptr && marked->id < of->names.size() ? of->names[marked->id] : std::string();
  }
  QString words() {
    QString all;
    for (const QLabel* label : (*this)->findChildren<QLabel*>()) all += label->text() + "\n";
    return all;
  }
  double area_of_cap() {
    const scene::space::Layer* cap = layer("solid.cap");
    if (cap == nullptr) return 0.0;
    double area = 0.0;
    const auto& surface = std::get<scene::space::Surface>(cap->content);
    for (const auto& t : surface.triangles) {
      const Point3 a = surface.points[t[0]];
      area += 0.5 * geom::length(geom::cross(surface.points[t[1]] - a, surface.points[t[2]] - a));
    }
    return area;
  }
};

TEST(SolidsWindow, AFaceThatIsClickedSaysItsName) {
  SolidWindow window;
  window.open_text(bored);
  EXPECT_TRUE(window.space().isVisible());
  EXPECT_FALSE(window->view().isVisible());  // there is nothing in the plane
  window.space().look_from(StandardView::Front);
  window.click_space({0.7, 0.0, 0.6});
  EXPECT_EQ(window.face_marked(), "rock_front");
  EXPECT_TRUE(window.words().contains("rock_front")) << window.words().toStdString();
  window.space().look_from(StandardView::Top);
  window.click_space({3.1, 1.1, 3.0});
  EXPECT_EQ(window.face_marked(), "rock_top");
  // All facets of the bore are one face: its rim has no line along it.
  const scene::space::Layer* solid = window.layer(core::solid_layer);
  ASSERT_NE(solid, nullptr);
  const auto bore = std::find(solid->names.begin(), solid->names.end(), "bore_side");
  ASSERT_NE(bore, solid->names.end());
  const auto marked = scene::space::highlight(
      window.space().shown(), {core::solid_layer, static_cast<std::uint32_t>(bore - solid->names.begin())});
  ASSERT_EQ(marked.size(), 1U);
  for (const auto& line : std::get<scene::space::Lines>(marked[0].content).lines)
    EXPECT_EQ(line.front().y, line.back().y);
}

TEST(SolidsWindow, ThePartsOfTheStepsAreLayersAndTheLastIsShown) {
  SolidWindow window;
  window.open_text(bored);
  ASSERT_NE(window.layer("part.rock"), nullptr);
  EXPECT_FALSE(window.layer("part.rock")->visible);
  EXPECT_TRUE(window.layer(core::solid_layer)->visible);
  EXPECT_EQ(window.layer(core::solid_layer)->title, "bored");
  ASSERT_NE(window.layer(core::solid_edges_layer), nullptr);
  // Twelve edges of the block and two rims of 32 or more sides; none along the bore.
  for (const auto& line : std::get<scene::space::Lines>(window.layer(core::solid_edges_layer)->content).lines) {
    const bool inside = std::hypot(line.front().x - 2.0, line.front().z - 1.5) < 0.6;
    EXPECT_TRUE(!inside || line.front().y == line.back().y);
  }
}

/// The section of the bored block across y is 4 x 3 less the bore, wherever the plane stands.
TEST(SolidsWindow, TheSectionFollowsThePlaneInSpaceAndInItsOwnPlane) {
  SolidWindow window;
  window.open_text(bored);
  const std::string before = window.text();
  window.act("view.space.section");
  EXPECT_TRUE(window->view().isVisible());
  ASSERT_EQ(window->view().panel_count(), 1U);
  EXPECT_EQ(window->view().panel_key(0), core::section_panel_key);
  // Across x, in the middle: through the bore along its axis, two strips of 2 x 1.
  EXPECT_NEAR(window.area_of_cap(), 4.0, 1e-9);
  const auto arrow = window.space().section_handle().arrow_pixel();
  ASSERT_TRUE(arrow);
  const QPointF way(40.0, 0.0);
  QTest::mousePress(&window.space(), Qt::LeftButton, {}, arrow->toPoint());
  for (const double part : {0.2, 0.5, 0.8, 1.0}) {
    window.move_space(*arrow + part * way);
    const double x = window.space().section_plane().through.x;
    const double half = std::abs(x - 2.0) < 0.5 ? std::sqrt(0.25 - (x - 2.0) * (x - 2.0)) : 0.0;
    EXPECT_NEAR(window.area_of_cap(), 6.0 - 4.0 * half, 0.02) << x;  // the bore is a prism
    ASSERT_EQ(window->view().panel_count(), 1U);
  }
  QTest::mouseRelease(&window.space(), Qt::LeftButton, {}, (*arrow + way).toPoint());
  window.settle();
  EXPECT_NE(window.space().section()->part, 0.5);
  EXPECT_EQ(window.text(), before);  // of the view alone
  // A line of the section is the face in space.
  window->view().setFocus();
  const QPointF bottom = window.pixel(0, {window->view().view(0).centre.x, 0.0});
  window.click(bottom);
  ASSERT_TRUE(window.space().marked());
  EXPECT_EQ(window.face_marked(), "rock_bottom");
  EXPECT_TRUE(window.words().contains("rock_bottom")) << window.words().toStdString();
  window.act("view.space.section");
  EXPECT_FALSE(window->view().isVisible());
  EXPECT_EQ(window.layer("solid.cap"), nullptr);
}

TEST(SolidsWindow, ShellsAreDrawnApartAndBack) {
  SolidWindow window;
  window.open_text(bored +
                   "\n[[step]]\noperation = \"sphere\"\npart = \"ball\"\nat = [8, 1, 1]\nradius = 1\n"
                   "\n[[step]]\noperation = \"unite\"\npart = \"both\"\nof = [\"bored\", \"ball\"]\n");
  ASSERT_FALSE(window->session().outcome()->run.error);
  const auto width = [&] {
    geom::Box3 box;
    for (const auto& each : window.space().shown().layers) {
      if (each.visible) box.add(scene::space::extent(each));
    }
    return box.high.x - box.low.x;
  };
  EXPECT_NEAR(width(), 9.0, 0.01);
  window.act("view.space.show.exploded");
  EXPECT_GT(width(), 9.5);
  EXPECT_FALSE(window.layer(core::solid_layer)->visible);
  window.act("view.space.show.exploded");
  EXPECT_NEAR(width(), 9.0, 0.01);
  EXPECT_TRUE(window.layer(core::solid_layer)->visible);
}

TEST(SolidsWindow, OnePieceHasNoShellsToDrawApart) {
  SolidWindow window;
  window.open_text(bored);
  EXPECT_EQ(window.layer(core::exploded_layer), nullptr);
  EXPECT_FALSE(window->actions().trigger("view.space.show.exploded"));
}

TEST(SolidsWindow, TheWelcomePageOpensAPillar) {
  SolidWindow window;
  window->welcome();
  auto* card = window->findChild<QAbstractButton*>("welcome.example.solids/pillar.toml");
  ASSERT_NE(card, nullptr);
  QTest::mouseClick(card, Qt::LeftButton);
  window.settle();
  ASSERT_FALSE(window->session().outcome()->run.error);
  EXPECT_TRUE(window.space().isVisible());
  EXPECT_TRUE(window->view().isVisible());  // the section that the steps make
  ASSERT_NE(window.layer(core::solid_layer), nullptr);
  EXPECT_EQ(window.layer(core::solid_layer)->title, "pillar");
}

}  // namespace
}  // namespace quebra::gui
