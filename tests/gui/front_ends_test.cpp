// The windows of both programs against the commands that scripts and files have: what is drawn with the mouse, what is
// saved, what is refused.

#include <QComboBox>
#include <QLineEdit>
#include <QTimer>

#include "shared/gui/draw_bar.h"
#include "shared/gui/mending/error_bar.h"
#include "shared/io/file.h"
#include "shared/scenario/entries.h"
#include "shared/scenario/runner.h"
#include "tests/gui/program_window.h"

namespace {

using namespace dobra;
using geom::Point;

std::string report_of(test::ProgramWindow& window) {
  const auto& outcome = *window->session().outcome();
  return scenario::report_json(*outcome.document, window->session().program(), outcome.run);
}

/// Chooses the kind, types the name and presses Enter in the question what was drawn.
void answer(test::ProgramWindow& window, const QString& kind, const char* name) {
  auto* clock = new QTimer(&*window);
  QObject::connect(clock, &QTimer::timeout, clock, [=] {
    auto* question = qobject_cast<gui::NewLine*>(QApplication::activeModalWidget());
    if (question == nullptr) return;
    clock->stop();
    clock->deleteLater();
    auto* kinds = question->findChild<QComboBox*>();
    while (kinds->currentText() != kind && kinds->currentIndex() + 1 < kinds->count())
      QTest::keyClick(kinds, Qt::Key_Down);
    auto* field = question->findChild<QLineEdit*>("name");
    field->selectAll();
    QTest::keyClicks(field, name);
    QTest::keyClick(field, Qt::Key_Return);
    if (question->isVisible()) {
      ADD_FAILURE() << "refused";
      question->reject();
    }
  });
  clock->start(10);
}

TEST(FrontEnds, GUI_b_AHorizonDrawnWithTheMouseIsWhatTheCommandAddsAndUndoRestoresTheDump) {
  test::ProgramWindow window("recon/fold.toml");
  window.open();
  const std::string before = window.text();
  const std::string dump = report_of(window);
  const scenario::Document document = window.document();
  window.focus();
  window.press(Qt::Key_F3);  // where the mouse is, not where lines are
  window.press(Qt::Key_L);
  const std::size_t panel = window.panel("deformed");
  const std::vector<Point> wanted{{0.0, 300.0}, {1500.0, 100.0}, {3000.0, 150.0}, {6000.0, 200.0}};
  for (const Point at : wanted) window.click(window.pixel(panel, at));
  EXPECT_EQ(window.text(), before);
  answer(window, "Horizon", "Drawn");
  window.press(Qt::Key_Return);
  window.come_to_rest();
  scenario::Entries horizons = scenario::entries_of(window.document().input, "horizon");
  ASSERT_EQ(horizons.size(), 6u);
  EXPECT_EQ(scenario::text_in(horizons.back(), "name"), "Drawn");
  const std::vector<Point> drawn = scenario::points_in(horizons.back());
  ASSERT_EQ(drawn.size(), wanted.size());
  const double pixel = window->view().view(panel).world_per_point;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    EXPECT_NEAR(drawn[i].x, wanted[i].x, pixel) << i;
    EXPECT_NEAR(drawn[i].y, wanted[i].y, pixel) << i;
  }
  const auto command =
      window->session().program().drawing.add(document, "horizon", "Drawn", geom::Polyline{drawn, false});
  ASSERT_TRUE(command.ok());
  EXPECT_EQ(window.text(), scenario::document_text(*command));
  // What a run from the text alone finds.
  const auto read = scenario::parse_document(scenario::document_text(*command), window.document().file);
  ASSERT_TRUE(read.ok());
  scenario::Runner runner(window->session().program());
  EXPECT_EQ(report_of(window), scenario::report_json(*read, window->session().program(), runner.run(*read)));

  window.focus();
  window.press(Qt::Key_Z, Qt::ControlModifier);
  window.come_to_rest();
  EXPECT_EQ(window.text(), before);
  EXPECT_EQ(report_of(window), dump);
}

TEST(FrontEnds, GUI_b_ACurveDrawnWithTheMouseIsWhatTheCommandAddsAndUndoRestoresTheDump) {
  test::ProgramWindow window("quebra/cracked_plate.toml");
  window.open();
  ASSERT_TRUE(window->look_at("input"));
  window.come_to_rest();
  const std::string before = window.text();
  const std::string dump = report_of(window);
  const scenario::Document document = window.document();
  window.focus();
  window.press(Qt::Key_F3);
  window.press(Qt::Key_P);
  const std::vector<Point> wanted{{3.0, 0.5}, {4.0, 0.5}, {4.0, 1.2}};
  for (const Point at : wanted) window.click(window.pixel(0, at));
  answer(window, "Hole", "notch");
  window.press(Qt::Key_Return);
  window.come_to_rest();
  scenario::Entries curves = scenario::entries_of(window.document().input, "curve");
  ASSERT_EQ(curves.size(), 4u);
  const std::vector<Point> drawn = scenario::points_in(curves.back());
  ASSERT_EQ(drawn.size(), wanted.size());
  const double pixel = window->view().view(0).world_per_point;
  for (std::size_t i = 0; i < drawn.size(); ++i) EXPECT_LE(geom::distance(drawn[i], wanted[i]), 1.5 * pixel) << i;
  const auto command = window->session().program().drawing.add(document, "hole", "notch", geom::Polyline{drawn, true});
  ASSERT_TRUE(command.ok());
  EXPECT_EQ(window.text(), scenario::document_text(*command));
  EXPECT_FALSE(window->session().outcome()->run.error);
  EXPECT_NE(report_of(window), dump);
  window.focus();
  window.press(Qt::Key_Z, Qt::ControlModifier);
  window.come_to_rest();
  EXPECT_EQ(window.text(), before);
  EXPECT_EQ(report_of(window), dump);
}

/// A step that waits for its input has nothing to show: the keys do nothing, and nothing is lost.
TEST(FrontEnds, AStepWithoutAnInputIsNotWatched) {
  for (const auto& [example, operation] :
       {std::pair("quebra/plate_with_hole.toml", "mesh"), std::pair("recon/fold.toml", "offset")}) {
    test::ProgramWindow window(example);
    window.open();
    window->begin_new();
    ASSERT_TRUE(window->actions().trigger(std::string("step.add.") + operation));
    window.come_to_rest();
    const std::string before = window.text();
    window.focus();
    for (const Qt::Key key : {Qt::Key_F6, Qt::Key_F7, Qt::Key_F9}) {
      window.press(key);
      window.come_to_rest();
      EXPECT_FALSE(window->player().watching()) << example;
    }
    EXPECT_FALSE(window->actions().find("run.step")->isEnabled()) << example;
    EXPECT_EQ(window.text(), before);
  }
}

class FrontEndsOf : public testing::TestWithParam<const char*> {};

TEST_P(FrontEndsOf, GUI_d_SavedReopenedAndSavedAgainIsTheSameFile) {
  test::ProgramWindow window(GetParam());
  window.open();
  scenario::Document edited = window.document();
  edited.title += " \"twice\" \\ é";
  window->session().edit(std::move(edited), "title");
  const std::filesystem::path once = window.write("once.toml", "");
  const std::filesystem::path again = window.write("again.toml", "");
  ASSERT_TRUE(window->save(once).ok());
  window.open(once);
  ASSERT_TRUE(window->save(again).ok());
  const std::string first = io::read_text(once).value();
  EXPECT_EQ(first, io::read_text(again).value());
  EXPECT_NE(first.find("twice"), std::string::npos);
  EXPECT_FALSE(window->isWindowModified());
}

INSTANTIATE_TEST_SUITE_P(Examples, FrontEndsOf,
                         testing::Values("recon/chain.toml", "recon/cosine.toml", "recon/fold.toml",
                                         "recon/listric.toml", "recon/thrust.toml", "quebra/cracked_plate.toml",
                                         "quebra/edge_crack.toml", "quebra/plate_with_hole.toml"));

}  // namespace
