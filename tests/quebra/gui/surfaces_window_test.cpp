// The window on scenarios of surfaces, with mouse and keys as a person uses them.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QComboBox>
#include <QRegularExpression>
#include <QSlider>
#include <QToolBar>
#include <QToolButton>
#include <cmath>
#include <cstdlib>
#include <set>

#include "quebra/core/surface_marks.h"
#include "quebra/gui/surfaces_shown.h"
#include "shared/gui/mending/error_bar.h"
#include "shared/gui/stage/space_widget.h"
#include "shared/io/file.h"
#include "shared/scenario/entries.h"
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

/// A plate of three strips, meshed; the plane of its chart is that of its places.
const std::string strips =
    "dobra = 1\nprogram = \"quebra\"\n\n[[input.surface]]\nname = \"plate\"\nkind = \"plane\"\nu = [0, 9]\nv = [0, "
    "3]\n\n"
    "[[input.trim]]\nname = \"first\"\nrole = \"cut\"\npoints = [[3, 0], [3, 3]]\n\n"
    "[[input.trim]]\nname = \"second\"\nrole = \"cut\"\npoints = [[6, 0], [6, 3]]\n\n"
    "[[step]]\noperation = \"mesh\"\nsize = 0.5\n";

const std::string patch =
    "dobra = 1\nprogram = \"quebra\"\n\n"
    "[[input.space_curve]]\nname = \"bottom\"\nkind = \"bezier\"\n# a comment\npoints = [[0, 0, 0], [3, 0, 4], [6, 0, "
    "4], [10, 0, 0]]\n\n"
    "[[input.space_curve]]\nname = \"top\"\nkind = \"line\"\npoints = [[0, 10, 0], [10, 10, 0]]\n\n"
    "[[input.space_curve]]\nname = \"left\"\nkind = \"line\"\npoints = [[0, 0, 0], [0, 10, 0]]\n\n"
    "[[input.space_curve]]\nname = \"right\"\nkind = \"line\"\npoints = [[10, 0, 0], [10, 10, 0]]\n\n"
    "[[input.surface]]\nname = \"patch\"\nkind = \"coons\"\ncurves = [\"bottom\", \"top\", \"left\", \"right\"]\n\n"
    "[[step]]\noperation = \"mesh\"\nsize = 1\n";

/// The window with the views of both, and what a person does in space.
class SurfaceWindow : public test::ProgramWindow {
 public:
  SurfaceWindow() : ProgramWindow("quebra/plate_with_hole.toml") { (*this)->resize(1400, 850); }
  /// The bytes of the file.
  std::string saved() { return scenario::saved_text(document()); }
  SpaceWidget& space() { return (*this)->space(); }
  void open_text(const std::string& text) { open_file(write("surfaces.toml", text)); }
  void open_file(const std::filesystem::path& file) {
    open(file);
    settle();
  }
  void settle() {
    come_to_rest();
    const bool settled = QTest::qWaitFor(
        [&] {
          return space().is_ready() && space().is_settled() && (*this)->view().is_ready() &&
                 (*this)->view().is_settled();
        },
        30000);
    EXPECT_TRUE(settled);
    QCoreApplication::processEvents();
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
  const scene::Panel& chart(std::size_t face = 0) {
    return (*this)->session().outcome()->picture->panels[panel(core::chart_key(face))];
  }
  template <class Content>
  static const Content* content(const std::vector<scene::Layer>& layers, const std::string& key) {
    for (const scene::Layer& layer : layers) {
      if (layer.key == key) return std::get_if<Content>(&layer.content);
    }
    return nullptr;
  }
  const scene::space::Layer* layer(const std::string& key) {
    for (const scene::space::Layer& each : space().shown().layers) {
      if (each.key == key) return &each;
    }
    return nullptr;
  }
  double area() {
    double sum = 0.0;
    for (const auto& quantity :
         (*this)->session().program().quantities_of((*this)->session().outcome()->run.states.back())) {
      if (quantity.name == "area") sum = quantity.value;
    }
    return sum;
  }
};

bool contains(const scene::Mesh& mesh, std::size_t t, Point p) {
  const auto& corners = mesh.triangles[t];
  int sides = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point a = mesh.points[corners[k]], b = mesh.points[corners[(k + 1) % 3]];
    sides += geom::cross(b - a, p - a) >= -1e-9 ? 1 : 0;
  }
  return sides == 3;
}

TEST(SurfacesWindow, ATriangleClickedInSpaceIsMarkedInTheChart) {
  SurfaceWindow window;
  window.open_text(strips);
  EXPECT_TRUE(window.space().isVisible());
  EXPECT_TRUE(window->view().isVisible());
  window.space().look_from(StandardView::Top);
  for (const Point3 at : {Point3{1.21, 1.13, 0.0}, Point3{4.37, 2.2, 0.0}, Point3{8.3, 0.4, 0.0}}) {
    window.click_space(at);
    ASSERT_TRUE(window.space().marked());
    EXPECT_EQ(window.space().marked()->layer, "mesh");
    EXPECT_EQ(window->view().marked(), window.space().marked());
    // The triangle of that number in the chart is where the click was: the plate lies on its chart.
    const auto* mesh = SurfaceWindow::content<scene::Mesh>(window.chart().layers, "mesh");
    ASSERT_NE(mesh, nullptr);
    const auto found = std::find(mesh->ids.begin(), mesh->ids.end(), window.space().marked()->id);
    ASSERT_NE(found, mesh->ids.end());
    const double pixel = window.space().look().view ? 0.0 : 0.02;
    bool near = false;
    for (const double dx : {-pixel, 0.0, pixel}) {
      for (const double dy : {-pixel, 0.0, pixel})
        near = near || contains(*mesh, static_cast<std::size_t>(found - mesh->ids.begin()), {at.x + dx, at.y + dy});
    }
    EXPECT_TRUE(near) << at.x << " " << at.y;
    EXPECT_FALSE(scene::highlight(window.chart(), *window.space().marked()).empty());
  }
}

TEST(SurfacesWindow, ATriangleAndALineClickedInTheChartAreMarkedInSpace) {
  SurfaceWindow window;
  window.open_text(strips);
  const std::size_t panel = window.panel("chart_1");
  window.click(window.pixel(panel, {4.6, 1.6}));
  ASSERT_TRUE(window.space().marked());
  EXPECT_EQ(window.space().marked()->layer, "mesh");
  const auto marked = scene::space::highlight(window.space().shown(), *window.space().marked());
  ASSERT_FALSE(marked.empty());
  geom::Box3 box;
  for (const auto& line : std::get<scene::space::Lines>(marked[0].content).lines) {
    for (const Point3& p : line) box.add(p);
  }
  EXPECT_LT(box.diagonal(), 1.2);
  EXPECT_NEAR(box.centre().x, 4.6, 0.5);
  EXPECT_NEAR(box.centre().y, 1.6, 0.5);
  // The line between two parts.
  window.click(window.pixel(panel, {6.0, 1.1}));
  ASSERT_TRUE(window.space().marked());
  EXPECT_EQ(window.space().marked()->layer, "internal");
  const auto line = scene::space::highlight(window.space().shown(), *window.space().marked());
  ASSERT_FALSE(line.empty());
  for (const Point3& p : std::get<scene::space::Lines>(line[0].content).lines.front()) EXPECT_NEAR(p.x, 6.0, 1e-9);
}

TEST(SurfacesWindow, GUI_b_APartIsChosenByAClickInItsChart) {
  SurfaceWindow window;
  window.open_text(strips);
  const std::string before = window.text();
  EXPECT_NEAR(window.area(), 27.0, 1e-9);
  window.focus();
  window.press(Qt::Key_B);
  window.click(window.pixel(window.panel("chart_1"), {1.2, 1.0}));
  window.settle();
  EXPECT_NEAR(window.area(), 18.0, 1e-9);
  auto entries = scenario::entries_of(window.document().input, "part");
  ASSERT_EQ(entries.size(), 1u);
  const Point at = std::get<Point>(*entries[0].find("at"));
  EXPECT_NEAR(at.x, 1.2, 0.05);
  EXPECT_NEAR(at.y, 1.0, 0.05);
  // The same as typing it.
  auto typed = scenario::parse_document(strips, "surfaces.toml");
  ASSERT_TRUE(typed.ok());
  scenario::Table entry;
  entry.set("fate", std::string("drop"));
  entry.set("at", at);
  scenario::set_entries(typed->input, "part", {entry});
  EXPECT_EQ(window.text(), scenario::document_text(*typed));
  window->undo();
  EXPECT_EQ(window.text(), before);
  EXPECT_EQ(window.saved(), strips);
  window.settle();
  EXPECT_NEAR(window.area(), 27.0, 1e-9);
}

TEST(SurfacesWindow, GUI_b_APartIsChosenByAClickInSpaceAndTakenInAgain) {
  SurfaceWindow window;
  window.open_text(strips);
  window.space().look_from(StandardView::Top);
  window.click_space({7.3, 1.4, 0.0});  // with Select in hand it is only marked
  window.settle();
  EXPECT_EQ(window.saved(), strips);
  ASSERT_TRUE(window->actions().trigger("draw.part"));
  window.click_space({7.3, 1.4, 0.0});
  window.settle();
  EXPECT_NEAR(window.area(), 18.0, 1e-9);
  ASSERT_NE(window.layer(core::left_out_layer), nullptr);  // it stays in sight
  EXPECT_NE(SurfaceWindow::content<scene::Regions>(window.chart().layers, core::left_out_layer), nullptr);
  window.click_space({8.0, 2.0, 0.0});
  window.settle();
  EXPECT_NEAR(window.area(), 27.0, 1e-9);
  EXPECT_EQ(window.saved(), strips);
  EXPECT_EQ(window.layer(core::left_out_layer), nullptr);
}

/// Numbers of the document and of the pictures are millimetres, those of the model metres.
TEST(SurfacesWindow, GUI_b_PartsAndPointsAreInTheUnitsOfTheDocument) {
  SurfaceWindow window;
  std::string text = strips;
  text.replace(text.find("\n\n"), 1, "\nunit_system = \"mm, N, MPa\"\n");
  window.open_text(text);
  ASSERT_TRUE(window->actions().trigger("draw.part"));
  window.click(window.pixel(window.panel("chart_1"), {4.4, 2.0}));
  window.settle();
  EXPECT_NEAR(window.area(), 18.0, 1e-9);  // mm2
  const auto entries = scenario::entries_of(window.document().input, "part");
  ASSERT_EQ(entries.size(), 1u);
  EXPECT_NEAR(std::get<Point>(*entries[0].find("at")).x, 4.4, 0.05);
  std::string bent = patch;
  bent.replace(bent.find("\n\n"), 1, "\nunit_system = \"mm, N, MPa\"\n");
  window.open_text(bent);
  ASSERT_TRUE(window->actions().trigger("draw.select"));
  ASSERT_TRUE(window->actions().trigger("view.space.show.controls"));
  window.space().look_from(StandardView::Front);
  QCoreApplication::processEvents();
  const QPointF from = *window.space().pixel_of({3.0, 0.0, 4.0});
  const QPointF to = *window.space().pixel_of({3.0, 0.0, 6.0});
  QTest::mousePress(&window.space(), Qt::LeftButton, {}, from.toPoint());
  window.move_space(0.5 * (from + to));
  window.move_space(to);
  QTest::mouseRelease(&window.space(), Qt::LeftButton, {}, to.toPoint());
  window.settle();
  const auto moved = scenario::entries_of(window.document().input, "space_curve");
  const auto points = std::get<std::vector<Point3>>(*moved.at(0).find("points"));
  EXPECT_NEAR(points[1].z, 6.0, 0.1);
  EXPECT_EQ(points[1].x, 3.0);
}

TEST(SurfacesWindow, TheOnlyPartStaysAndTheWindowSaysWhy) {
  SurfaceWindow window;
  window.open_text(patch);
  ASSERT_TRUE(window->actions().trigger("draw.part"));
  window.space().look_from(StandardView::Top);
  window.click_space({5.0, 9.0, 0.1});
  window.settle();
  EXPECT_EQ(window.saved(), patch);
  QString words;
  for (const QLabel* label : window->findChildren<QLabel*>()) words += label->text() + "\n";
  EXPECT_TRUE(words.contains("the only part")) << words.toStdString();
}

TEST(SurfacesWindow, GUI_b_AControlPointIsDraggedAndTheMeshFollows) {
  SurfaceWindow window;
  window.open_text(patch);
  ASSERT_TRUE(window->actions().trigger("view.space.show.controls"));
  window.space().look_from(StandardView::Front);
  QCoreApplication::processEvents();
  const double area = window.area();
  const QPointF from = *window.space().pixel_of({3.0, 0.0, 4.0});
  const QPointF to = from + QPointF(0.0, -40.0);
  QTest::mousePress(&window.space(), Qt::LeftButton, {}, from.toPoint());
  window.move_space(from + QPointF(0.0, -12.0));
  window.move_space(from + QPointF(0.0, -25.0));
  window.move_space(to);
  EXPECT_TRUE(window.space().drags());
  EXPECT_EQ(window.saved(), patch);  // while it lasts the document is what it was
  window.come_to_rest();
  EXPECT_GT(window.area(), area + 0.5);  // the mesh is that of where the point is now
  EXPECT_TRUE(window.space().drags());
  EXPECT_EQ(window.saved(), patch);
  QTest::mouseRelease(&window.space(), Qt::LeftButton, {}, to.toPoint());
  window.settle();
  const auto points =
      std::get<std::vector<Point3>>(*scenario::entries_of(window.document().input, "space_curve")[0].find("points"));
  EXPECT_EQ(points[1].x, 3.0);
  EXPECT_EQ(points[1].y, 0.0);  // away from the viewer it has not moved, not by rounding either
  EXPECT_GT(points[1].z, 4.5);
  EXPECT_EQ(points[0], (Point3{0.0, 0.0, 0.0}));
  EXPECT_EQ(points[2], (Point3{6.0, 0.0, 4.0}));
  EXPECT_GT(window.area(), area + 0.5);
  EXPECT_EQ(window->session().history().undo_text(), "Move point 2 of 'bottom'");
  window->undo();
  EXPECT_EQ(window.saved(), patch);
  window.settle();
  EXPECT_NEAR(window.area(), area, 1e-9);
}

TEST(SurfacesWindow, EscapeTakesADragBack) {
  SurfaceWindow window;
  window.open_text(patch);
  ASSERT_TRUE(window->actions().trigger("view.space.show.controls"));
  window.space().look_from(StandardView::Front);
  window.space().setFocus();
  const double area = window.area();
  const QPointF from = *window.space().pixel_of({6.0, 0.0, 4.0});
  QTest::mousePress(&window.space(), Qt::LeftButton, {}, from.toPoint());
  window.move_space(from + QPointF(0.0, 20.0));
  window.move_space(from + QPointF(0.0, 50.0));
  window.come_to_rest();
  EXPECT_NE(window.area(), area);
  QTest::keyClick(&window.space(), Qt::Key_Escape);
  window.settle();
  EXPECT_NEAR(window.area(), area, 1e-12);
  EXPECT_EQ(window.saved(), patch);
  EXPECT_FALSE(window->session().history().can_undo());
}

/// A point goes to where the plane that cuts the surface does not meet it any more, and on.
TEST(SurfacesWindow, ADragThroughAnImpossiblePlaceGoesOn) {
  const std::string cut = patch + "\n[[input.trim]]\nname = \"level\"\nkind = \"plane\"\nrole = \"cut\"\n" +
                          "at = [0, 0, 2.5]\nnormal = [0, 0, 1]\n";
  SurfaceWindow window;
  window.open_text(cut);
  ASSERT_FALSE(window->session().outcome()->run.error);
  ASSERT_TRUE(window->actions().trigger("view.space.show.controls"));
  window.space().look_from(StandardView::Front);
  QCoreApplication::processEvents();
  const QPointF from = *window.space().pixel_of({3.0, 0.0, 4.0});
  const QPointF below = *window.space().pixel_of({3.0, 0.0, -2.0});
  QTest::mousePress(&window.space(), Qt::LeftButton, {}, from.toPoint());
  window.move_space(from + QPointF(10.0, 0.0));
  window.move_space(below);
  window.come_to_rest();
  EXPECT_TRUE(window->session().outcome()->run.error);
  EXPECT_TRUE(window.space().drags());
  EXPECT_FALSE(window.space().picture().layers.empty());  // what was there last stays in sight
  window.move_space(from + QPointF(12.0, -9.0));
  QTest::mouseRelease(&window.space(), Qt::LeftButton, {}, (from + QPointF(12.0, -9.0)).toPoint());
  window.settle();
  EXPECT_FALSE(window->session().outcome()->run.error);
  ASSERT_TRUE(window->session().history().can_undo());
  window->undo();
  EXPECT_EQ(window.saved(), cut);
}

TEST(SurfacesWindow, ColoursAndHelpingLinesAreSwitched) {
  SurfaceWindow window;
  window.open_text(patch);
  const auto surface = [&] { return std::get<scene::space::Surface>(window.layer("mesh")->content); };
  EXPECT_EQ(surface().values_at, scene::ValuesAt::Triangles);
  ASSERT_TRUE(window->actions().trigger("view.space.colors"));
  EXPECT_EQ(surface().values_at, scene::ValuesAt::None);
  ASSERT_TRUE(window->actions().trigger("view.space.colors"));
  EXPECT_EQ(surface().values_at, scene::ValuesAt::Triangles);
  for (const char* name : {"normals", "isocurves", "controls"}) {
    ASSERT_NE(window.layer(name), nullptr) << name;
    EXPECT_FALSE(window.layer(name)->visible) << name;
    ASSERT_TRUE(window->actions().trigger(std::string("view.space.show.") + name));
    EXPECT_TRUE(window.layer(name)->visible) << name;
    EXPECT_TRUE(window->actions().find(std::string("view.space.show.") + name)->isChecked()) << name;
  }
  // What is switched on stays so when the document is run again.
  window->session().run();
  window.settle();
  EXPECT_TRUE(window.layer("normals")->visible);
  ASSERT_TRUE(window->actions().trigger("view.space.show.normals"));
  EXPECT_FALSE(window.layer("normals")->visible);
  // The bar over the picture has a button for each.
  const auto* bar = window->findChild<QToolBar*>("space_bar");
  ASSERT_NE(bar, nullptr);
  EXPECT_TRUE(bar->isVisible());
  EXPECT_GE(bar->actions().size(), 5);
}

TEST(SurfacesWindow, GUI_b_ACrackDrawnInTheChartIsATrimAndTheMeshOpensIt) {
  SurfaceWindow window;
  window.open_text(strips);
  const std::string before = window.saved();
  const std::size_t chart = window.panel(core::chart_key(0));
  window.focus();
  window.press(Qt::Key_F3);  // without snapping
  window.press(Qt::Key_K);
  window.click(window.pixel(chart, {0.8, 1.0}));
  window.click(window.pixel(chart, {2.2, 2.0}));
  EXPECT_EQ(window.saved(), before);
  window.press(Qt::Key_Return);
  window.settle();
  auto entries = scenario::entries_of(window.document().input, "trim");
  ASSERT_EQ(entries.size(), 3U);
  EXPECT_EQ(scenario::text_in(entries[2], "name"), "crack");
  EXPECT_EQ(scenario::text_in(entries[2], "role"), "crack");
  const auto points = scenario::points_in(entries[2]);
  ASSERT_EQ(points.size(), 2U);
  const std::vector<Point> wanted{{0.8, 1.0}, {2.2, 2.0}};
  for (std::size_t i = 0; i < 2; ++i) EXPECT_LT(geom::distance(points[i], wanted[i]), 0.05);
  EXPECT_EQ(scenario::entries_of(window.document().input, "crack").size(), 0U);
  ASSERT_FALSE(window->session().outcome()->run.error);
  EXPECT_NEAR(window.area(), 27.0, 1e-9);
  // Its line is seen in the chart and in space.
  const auto* in_chart = SurfaceWindow::content<scene::Lines>(window.chart().layers, "cracks");
  const scene::space::Layer* in_space = window.layer("cracks");
  ASSERT_TRUE(in_chart != nullptr && in_space != nullptr);
  EXPECT_EQ(in_chart->lines.size(), std::get<scene::space::Lines>(in_space->content).lines.size());
  // A second one has a name of its own; one step of undo takes one crack back.
  window.click(window.pixel(chart, {7.0, 1.0}));
  window.click(window.pixel(chart, {8.0, 1.5}));
  window.press(Qt::Key_Return);
  window.settle();
  entries = scenario::entries_of(window.document().input, "trim");
  ASSERT_EQ(entries.size(), 4U);
  EXPECT_EQ(scenario::text_in(entries[3], "name"), "crack_2");
  window->undo();
  window->undo();
  EXPECT_EQ(window.saved(), before);
}

TEST(SurfacesWindow, ACrackFromBesideTheChartBeginsOnItsSide) {
  SurfaceWindow window;
  window.open_text(strips);
  const std::size_t chart = window.panel(core::chart_key(0));
  window.focus();
  window.press(Qt::Key_F3);
  window.press(Qt::Key_K);
  window.click(window.pixel(chart, {0.0, 1.5}) - QPointF(5.0, 0.0));
  window.click(window.pixel(chart, {1.5, 1.5}));
  window.press(Qt::Key_Return);
  window.settle();
  const auto entries = scenario::entries_of(window.document().input, "trim");
  ASSERT_EQ(entries.size(), 3U);
  EXPECT_EQ(scenario::points_in(entries[2]).front().x, 0.0);
  ASSERT_FALSE(window->session().outcome()->run.error);
}

TEST(SurfacesWindow, OtherLinesAreRefusedBesideSurfacesAndTheDocumentStays) {
  SurfaceWindow window;
  window.open_text(strips);
  const auto refused = window->session().program().drawing.add(window.document(), "hole", "hole",
                                                               {{{1.0, 1.0}, {2.0, 1.0}, {1.5, 2.0}}, true});
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().message.find("trims"), std::string::npos);
}

TEST(SurfacesWindow, TheWelcomePageOpensAShellWithACrack) {
  SurfaceWindow window;
  window->welcome();
  auto* card = window->findChild<QAbstractButton*>("welcome.example.surfaces/cracked_shell.toml");
  ASSERT_NE(card, nullptr);
  QTest::mouseClick(card, Qt::LeftButton);
  window.settle();
  EXPECT_TRUE(window.document().file.empty());  // a copy
  ASSERT_FALSE(window->session().outcome()->run.error);
  EXPECT_TRUE(window.space().isVisible());
  EXPECT_NE(window.layer("cracks"), nullptr);
}

TEST(SurfacesWindow, ASectionCutsTheViewAndNotTheDocument) {
  SurfaceWindow window;
  window.open_text(patch);
  const auto count = [&] { return std::get<scene::space::Surface>(window.layer("mesh")->content).triangles.size(); };
  const std::size_t all = count();
  ASSERT_TRUE(window->actions().trigger("view.space.section"));
  auto* place = window->findChild<QSlider*>("section.place");
  ASSERT_NE(place, nullptr);
  ASSERT_TRUE(place->isVisible());
  const std::size_t half = count();
  EXPECT_GT(half, all / 3);
  EXPECT_LT(half, 2 * all / 3);
  place->setFocus();
  for (int i = 0; i < 4; ++i) QTest::keyClick(place, Qt::Key_PageDown);
  EXPECT_LT(count(), half);
  const double x = 10.0 * place->value() / 1000.0;
  for (const Point3& p : std::get<scene::space::Lines>(window.layer("mesh.cut")->content).lines.front())
    EXPECT_NEAR(p.x, x, 1e-9);
  // What has been taken away is not found by a click.
  window.space().look_from(StandardView::Top);
  window.click_space({9.0, 5.0, 0.0});
  EXPECT_FALSE(window.space().marked());
  window.click_space({1.0, 5.0, 0.0});
  ASSERT_TRUE(window.space().marked());
  EXPECT_EQ(window->view().marked(), window.space().marked());
  QTest::mouseClick(window->findChild<QToolButton*>("section.side"), Qt::LeftButton);
  window.click_space({9.0, 5.0, 0.0});
  EXPECT_TRUE(window.space().marked());
  EXPECT_EQ(window.saved(), patch);
  EXPECT_FALSE(window->session().history().can_undo());
  ASSERT_TRUE(window->actions().trigger("view.space.section"));
  EXPECT_EQ(count(), all);
  EXPECT_FALSE(place->isVisible());
}

TEST(SurfacesWindow, ABoundaryModelOpensAsADocumentThatMeshesIt) {
  SurfaceWindow window;
  const auto source = std::filesystem::path(DOBRA_SOURCE_DIR) / "tests/shared/io/brep/data/cut_cylinder.brep";
  const auto text = dobra::io::read_text(source);
  ASSERT_TRUE(text.ok());
  const std::filesystem::path file = window.write("part.brep", *text);
  window.open_file(file);
  ASSERT_FALSE(window->session().outcome()->run.error)
      << dobra::base::to_string(*window->session().outcome()->run.error);
  EXPECT_GT(window.area(), 0.0);
  EXPECT_TRUE(window.space().isVisible());
  EXPECT_NE(window.layer("mesh"), nullptr);
  EXPECT_TRUE(window.document().file.empty());  // it is to be saved as a scenario, not over the model
  // Parts of a file's faces cannot be chosen; the window says so.
  ASSERT_TRUE(window->actions().trigger("draw.part"));
  const std::string before = window.text();
  const auto& mesh = std::get<scene::space::Surface>(window.layer("mesh")->content);
  for (std::size_t t = 0; t < mesh.triangles.size(); t += mesh.triangles.size() / 4) {
    const auto& c = mesh.triangles[t];
    window.click_space(mesh.points[c[0]] + (1.0 / 3.0) * ((mesh.points[c[1]] - mesh.points[c[0]]) +
                                                          (mesh.points[c[2]] - mesh.points[c[0]])));
  }
  EXPECT_EQ(window.text(), before);
  QString words;
  for (const QLabel* label : window->findChildren<QLabel*>()) words += label->text() + "\n";
  EXPECT_TRUE(words.contains("faces of a file") || words.contains("click inside")) << words.toStdString();
}

/// The part to keep lies on a line.
const std::string refused =
    "dobra = 1\nprogram = \"quebra\"\n\n[[input.surface]]\nname = \"tube\"\nkind = \"cylinder\"\nradius = 2\nu = [30, "
    "150]\nv = [0, 6]\n\n[[input.trim]]\nname = \"first\"\nrole = \"cut\"\npoints = [[60, 0], [60, 6]]\n\n"
    "[[input.part]]\nfate = \"keep\"\nat = [60, 3]\n";

TEST(SurfacesWindow, ARefusedInputIsDrawnAsFarAsItCanBeWithItsPlace) {
  SurfaceWindow window;
  window.open_text(refused);
  const auto& outcome = *window->session().outcome();
  ASSERT_TRUE(outcome.run.error);
  ASSERT_TRUE(outcome.run.error->place && outcome.run.error->place->u);
  // The surface and its lines, in space and in the chart.
  EXPECT_TRUE(window.space().isVisible());
  ASSERT_NE(window.layer("faces"), nullptr);
  ASSERT_NE(window.layer("internal"), nullptr);
  EXPECT_NE(SurfaceWindow::content<scene::Lines>(window.chart().layers, "internal"), nullptr);
  // The place: 60 degrees round the axis, 3 along it.
  ASSERT_TRUE(window.space().place());
  EXPECT_NEAR(window.space().place()->x, 1.0, 1e-9);
  EXPECT_NEAR(window.space().place()->y, std::sqrt(3.0), 1e-9);
  EXPECT_NEAR(window.space().place()->z, 3.0, 1e-9);
  const QString said = window->error_bar().message();
  EXPECT_TRUE(said.contains("(at 1, 1.73205")) << said.toStdString();
  EXPECT_TRUE(said.contains(", 3) (u = 60, v = 3)")) << said.toStdString();
  // Show goes to the place in the chart, which is drawn as long as in space.
  emit window->error_bar().show_asked();
  const Point centre = window->view().view(0).centre;
  EXPECT_NEAR(centre.x, 2.0 * 30.0 * std::acos(-1.0) / 180.0, 1e-6);
  EXPECT_NEAR(centre.y, 3.0, 1e-6);
  // What is mended is shown as ever, without the place.
  std::string mended = refused;
  mended.replace(mended.find("at = [60, 3]"), 12, "at = [80, 3]");
  window.open_text(mended);
  EXPECT_FALSE(window->session().outcome()->run.error);
  EXPECT_FALSE(window.space().place());
}

TEST(SurfacesWindow, AChartSaysUAndVAsTheyAreWritten) {
  SurfaceWindow window;
  std::string text = refused;
  text.replace(text.find("at = [60, 3]"), 12, "at = [80, 3]");
  window.open_text(text);
  const scene::Axes& axes = window.chart().axes;
  ASSERT_TRUE(axes.x_reading && axes.y_reading);
  EXPECT_EQ(axes.x_reading->title, "u [\u00b0]");
  EXPECT_EQ(axes.y_reading->title, "v [m]");
  const double degree = 2.0 * std::acos(-1.0) / 180.0;  // of a circle of radius 2, m
  EXPECT_NEAR(axes.x_reading->of(0.0), 30.0, 1e-9);
  EXPECT_NEAR(axes.x_reading->of(60.0 * degree), 90.0, 1e-6);
  EXPECT_NEAR(axes.y_reading->of(1.5), 1.5, 1e-9);
  // The same of millimetres.
  text.replace(text.find("\n\n"), 1, "\nunit_system = \"mm, N, MPa\"\n");
  window.open_text(text);
  const scene::Axes& mm = window.chart().axes;
  EXPECT_EQ(mm.y_reading->title, "v [mm]");
  EXPECT_NEAR(mm.x_reading->of(60.0 * degree), 90.0, 1e-6);
  EXPECT_NEAR(mm.y_reading->of(1.5), 1.5, 1e-9);
  // And under the cursor.
  const QPointF pixel = window.pixel(0, {60.0 * degree, 3.0});
  window.move(pixel);
  QString words;
  for (const QLabel* label : window->findChildren<QLabel*>()) words += label->text() + "\n";
  EXPECT_TRUE(words.contains(QRegularExpression("u = (89|90)[.0-9]* \u00b0   v = (2.9|3.0)[0-9]* mm")))
      << words.toStdString();
}

/// Nine faces, four charts side by side: that of a face that is clicked comes into the place of the last.
TEST(SurfacesWindow, TheChartOfAFaceThatIsClickedComesIntoSight) {
  SurfaceWindow window;
  window.open_file(std::filesystem::path(DOBRA_SOURCE_DIR) / "tests/shared/io/brep/data/box_fillet.brep");
  ASSERT_FALSE(window->session().outcome()->run.error);
  const auto keys = [&] {
    std::vector<std::string> all;
    for (std::size_t i = 0; i < window->view().panel_count(); ++i) all.push_back(window->view().panel_key(i));
    return all;
  };
  const std::vector<std::string> before = keys();
  ASSERT_EQ(before.size(), 4u);
  const model::Model* model = model_with_surfaces(window->session());
  const auto& mesh = model->surface_meshes.back()->mesh;
  std::set<std::string> seen(before.begin(), before.end());
  for (const StandardView side : {StandardView::Isometric, StandardView::Front}) {
    window.space().look_from(side);
    for (std::size_t t = 0; t < mesh.triangles.size(); t += mesh.triangles.size() / 6) {
      const Point3 a = mesh.point(mesh.triangles[t][0]), b = mesh.point(mesh.triangles[t][1]),
                   c = mesh.point(mesh.triangles[t][2]);
      window.click_space(a + (1.0 / 3.0) * ((b - a) + (c - a)));
      if (!window.space().marked() || window.space().marked()->layer != "mesh") continue;
      const std::string key = core::chart_key(mesh.faces[window.space().marked()->id]);
      const std::vector<std::string> now = keys();
      EXPECT_EQ(now.size(), 4u);
      EXPECT_NE(std::find(now.begin(), now.end(), key), now.end()) << key;
      EXPECT_EQ(window->view().marked(), window.space().marked());
      seen.insert(key);
    }
  }
  EXPECT_GT(seen.size(), 4u);
}

TEST(SurfacesWindow, AFileThatIsNoBoundaryModelIsRefusedWithItsPlace) {
  SurfaceWindow window;
  const std::filesystem::path file = window.write("wrong.brep", "this is no boundary model\n");
  const auto opened = window->open(file);
  ASSERT_FALSE(opened.ok());
  EXPECT_NE(to_string(opened.error()).find("wrong.brep"), std::string::npos);
}

/// All stand-ins open with their mesh in space and in charts. DOBRA_ALL_SURFACES: every example, else the quick ones.
TEST(SurfacesWindow, ExamplesOpenInBothViews) {
  std::vector<std::string> files{"8a.toml"};
  if (std::getenv("DOBRA_ALL_SURFACES") != nullptr) {
    files.clear();
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(DOBRA_SOURCE_DIR) / "resources/examples/surfaces"))
      files.push_back(entry.path().filename().string());
  }
  SurfaceWindow window;
  for (const std::string& file : files) {
    window.open_file(std::filesystem::path(DOBRA_SOURCE_DIR) / "resources/examples/surfaces" / file);
    ASSERT_FALSE(window->session().outcome()->run.error) << file;
    ASSERT_NE(window.layer("mesh"), nullptr) << file;
    const auto& mesh = std::get<scene::space::Surface>(window.layer("mesh")->content);
    const auto* flat = SurfaceWindow::content<scene::Mesh>(window.chart().layers, "mesh");
    ASSERT_NE(flat, nullptr) << file;
    EXPECT_GT(mesh.triangles.size(), 100u) << file;
    EXPECT_LE(flat->triangles.size(), mesh.triangles.size()) << file;
    if (std::getenv("DOBRA_SPACE_SCREENSHOT") != nullptr) {
      EXPECT_TRUE(
          window->save_screenshot(std::string(std::getenv("DOBRA_SPACE_SCREENSHOT")) + "_" + file + ".png").ok());
    }
  }
}

}  // namespace
}  // namespace quebra::gui
