#include "shared/gui/main_window.h"

#include <gtest/gtest.h>

#include <QMimeData>
#include <set>

#include "tests/shared/gui/window_fixture.h"

namespace dobra::gui {
namespace {

class MainWindowTest : public test::WindowFixture {};

TEST_F(MainWindowTest, OpenRunsTheDocumentAndShowsItsPicture) {
  open_waves();
  EXPECT_EQ(window.view().panel_count(), 2u);
  EXPECT_EQ(window.windowTitle(), QString::fromUtf8("waves.toml[*] — WAVES"));
  EXPECT_FALSE(window.isWindowModified());
  EXPECT_EQ(window.steps().state(0), PartState::Done);
  EXPECT_EQ(window.steps().state(1), PartState::Done);
  EXPECT_EQ(window.steps().selected(), 1u);
  EXPECT_EQ(window.layers().topLevelItemCount(), 2);
}

TEST_F(MainWindowTest, GUI_b_UndoOfAFormEditRestoresTheVeryDocumentAndItsResult) {
  open_waves();
  const std::string before = text();
  ASSERT_TRUE(type("count", "7").ok());
  settle();
  EXPECT_TRUE(window.isWindowModified());
  EXPECT_DOUBLE_EQ(window.session().outcome()->quantities.at(1).value, 7.0);
  const std::string after = text();
  EXPECT_NE(after, before);
  window.session().undo();
  settle();
  EXPECT_EQ(text(), before);
  EXPECT_DOUBLE_EQ(window.session().outcome()->quantities.at(1).value, 4.0);
  EXPECT_FALSE(window.isWindowModified());
  window.session().redo();
  settle();
  EXPECT_EQ(text(), after);
  EXPECT_DOUBLE_EQ(window.session().outcome()->quantities.at(1).value, 7.0);
}

TEST_F(MainWindowTest, GUI_b_TypingInTheFormDoesWhatAssignmentDoes) {
  open_waves();
  ASSERT_TRUE(type("distance", "12.5").ok());
  const auto assigned =
      scenario::with_value(*scenario::read_document(folder / "waves.toml"), program, "steps.1.distance=12.5");
  ASSERT_TRUE(assigned.ok());
  EXPECT_EQ(text(), scenario::document_text(*assigned));
}

TEST_F(MainWindowTest, GUI_d_SaveReopenSaveGivesTheSameBytes) {
  open_waves();
  ASSERT_TRUE(type("count", "6").ok());
  ASSERT_TRUE(type("tilt", "12.5").ok());
  ASSERT_TRUE(type("datum", "0, 0; 10, 0.1").ok());
  ASSERT_TRUE(window.save(folder / "first.toml").ok());
  EXPECT_FALSE(window.isWindowModified());
  ASSERT_TRUE(window.open(folder / "first.toml").ok());
  settle();
  ASSERT_TRUE(window.save(folder / "second.toml").ok());
  EXPECT_EQ(folder.read("first.toml"), folder.read("second.toml"));
  EXPECT_NE(folder.read("first.toml").find("count = 6"), std::string::npos);
}

TEST_F(MainWindowTest, GUI_c_BadFilesAreSaidInTheErrorBarAndChangeNothing) {
  open_waves();
  const std::string before = text();
  EXPECT_FALSE(window.open(folder / "missing.toml").ok());
  EXPECT_TRUE(window.error_bar().message().contains("missing.toml")) << window.error_bar().message().toStdString();
  const std::vector<std::pair<std::string, std::string>> bad{
      {"empty.toml", ""},
      {"binary.toml", std::string("\x7f"
                                  "ELF\x02\x00\x01\xff\xfe",
                                  9)},
      {"words.toml", "hello, world\n"},
      {"other.toml", "dobra = 1\nprogram = \"recon\"\n[input]\n"}};
  for (const auto& [name, bytes] : bad) {
    EXPECT_FALSE(window.open(folder.write(name, bytes)).ok()) << name;
    EXPECT_TRUE(window.error_bar().message().contains(QString::fromStdString(name))) << name;
  }
  EXPECT_FALSE(window.open(folder / "").ok());
  EXPECT_EQ(text(), before);
}

TEST_F(MainWindowTest, GUI_c_BadParameterInTheFileIsSaidAndMarkedInTheForm) {
  open_waves("dobra = 1\nprogram = \"waves\"\n\n[input]\n\n[[step]]\noperation = \"stack\"\ndistance = -1.0\n");
  EXPECT_TRUE(window.error_bar().message().contains("'Distance from one curve to the next'"))
      << window.error_bar().message().toStdString();
  EXPECT_EQ(window.steps().state(1), PartState::Failed);
  EXPECT_FALSE(window.form().form()->message_at("distance").isEmpty());
  ASSERT_TRUE(type("distance", "20").ok());
  settle();
  EXPECT_EQ(window.error_bar().message(), "");
  EXPECT_EQ(window.steps().state(1), PartState::Done);
}

TEST_F(MainWindowTest, GUI_c_FailedStepNamesItsItemAndShowZoomsToThePlace) {
  open_waves();
  emit window.steps().add_asked("break");
  settle();
  EXPECT_TRUE(window.error_bar().message().contains("wave 1")) << window.error_bar().message().toStdString();
  EXPECT_EQ(window.steps().state(2), PartState::Failed);
  window.select(0);
  const double far = window.view().view(0).world_per_point;
  emit window.error_bar().show_asked();
  EXPECT_EQ(window.steps().selected(), 2u);
  EXPECT_LT(window.view().view(0).world_per_point, far / 3.0);
  EXPECT_NEAR(window.view().view(0).centre.x, 500.0, 1e-9);
  EXPECT_NEAR(window.view().view(0).centre.y, -50.0, 1e-9);
}

TEST_F(MainWindowTest, AnInputThatIsRefusedIsDrawn) {
  open_waves();
  window.select(0);
  ASSERT_TRUE(type("amplitude", "-5").ok());
  settle();
  EXPECT_FALSE(window.error_bar().message().isEmpty());
  EXPECT_EQ(window.view().panel_count(), 1u);
}

TEST_F(MainWindowTest, AnInputThatDrawsNothingLeavesNoOldPicture) {
  open_waves();
  window.select(0);
  ASSERT_TRUE(type("amplitude", "-2000").ok());
  settle();
  EXPECT_EQ(window.view().panel_count(), 1u);  // an empty sheet
  EXPECT_EQ(window.layers().topLevelItemCount(), 0);
  ASSERT_TRUE(type("amplitude", "50").ok());
  settle();
  EXPECT_EQ(window.view().panel_count(), 2u);
}

TEST_F(MainWindowTest, StepsAreAddedMovedAndRemoved) {
  open_waves();
  emit window.steps().add_asked("sleep");
  ASSERT_EQ(window.session().document().steps.size(), 2u);
  EXPECT_EQ(window.steps().selected(), 2u);
  emit window.steps().exchange_asked(1, 1);
  EXPECT_EQ(window.session().document().steps[0].operation, "sleep");
  EXPECT_EQ(window.steps().selected(), 1u);
  emit window.steps().remove_asked(1);
  ASSERT_EQ(window.session().document().steps.size(), 1u);
  EXPECT_EQ(window.session().document().steps[0].operation, "stack");
  settle();
  EXPECT_EQ(window.steps().state(1), PartState::Done);
}

TEST_F(MainWindowTest, LongRunLeavesTheWindowAliveAndCanBeCancelled) {
  open_waves();
  emit window.steps().add_asked("sleep");
  ASSERT_TRUE(type("seconds", "60").ok());
  ASSERT_TRUE(QTest::qWaitFor([&] { return window.steps().state(2) == PartState::Running; }, 5000));
  QTest::qWait(300);
  EXPECT_TRUE(window.session().busy());
  window.session().cancel();
  settle();
  EXPECT_EQ(window.error_bar().message(), "");
  EXPECT_EQ(window.steps().state(1), PartState::Done);
  EXPECT_EQ(window.steps().state(2), PartState::Pending);
}

TEST_F(MainWindowTest, MiddleDragPansThePanelUnderIt) {
  open_waves();
  const scene::View before = window.view().view(0);
  const scene::View other = window.view().view(1);
  const QPointF from = QPointF(middle_of(0).toPoint());
  const auto under = window.view().spot_at(from);
  ASSERT_TRUE(under);
  drag(Qt::MiddleButton, from, from + QPointF(40, 10));
  const QPointF moved = window.view().pixel_of(0, under->at);
  EXPECT_NEAR(moved.x(), from.x() + 40, 1e-6);
  EXPECT_NEAR(moved.y(), from.y() + 10, 1e-6);
  EXPECT_EQ(window.view().view(0).world_per_point, before.world_per_point);
  EXPECT_EQ(window.view().view(1), other);
}

TEST_F(MainWindowTest, LeftDragDoesNotPan) {
  open_waves();
  const scene::View before = window.view().view(0);
  drag(Qt::LeftButton, middle_of(0), middle_of(0) + QPointF(40, 10));
  EXPECT_EQ(window.view().view(0), before);
}

TEST_F(MainWindowTest, WheelZoomsAtTheCursorAndKeepsOneScale) {
  open_waves();
  const double scale = window.view().view(0).world_per_point;
  const QPointF cursor = QPointF(middle_of(0).toPoint()) + QPointF(60, -20);
  const auto under = window.view().spot_at(cursor);
  ASSERT_TRUE(under);
  turn_wheel(cursor, 3);
  EXPECT_NEAR(window.view().view(0).world_per_point, scale / std::pow(1.2, 3), 1e-9 * scale);
  EXPECT_EQ(window.view().view(1).world_per_point, window.view().view(0).world_per_point);
  const QPointF still = window.view().pixel_of(0, under->at);
  EXPECT_NEAR(still.x(), cursor.x(), 1e-6);
  EXPECT_NEAR(still.y(), cursor.y(), 1e-6);
  turn_wheel(cursor, -3);
  EXPECT_NEAR(window.view().view(0).world_per_point, scale, 1e-9 * scale);
}

TEST_F(MainWindowTest, ViewStaysThroughARunAndFitShowsAllAgain) {
  open_waves();
  const scene::View all = window.view().view(0);
  turn_wheel(middle_of(0) + QPointF(30, 0), 4);
  const scene::View near = window.view().view(0);
  ASSERT_TRUE(type("count", "9").ok());
  settle();
  EXPECT_EQ(window.view().view(0), near);
  window.session().undo();
  settle();
  QTest::mouseDClick(&window.view(), Qt::MiddleButton, {}, middle_of(0).toPoint());
  EXPECT_EQ(window.view().view(0), all);
}

TEST_F(MainWindowTest, HidingALayerMovesNothingAndOutlivesARun) {
  open_waves();
  const scene::View before = window.view().view(0);
  ASSERT_TRUE(window.layers().set_layer_visible("stack", false));
  EXPECT_EQ(window.view().view(0).centre, before.centre);
  ASSERT_TRUE(type("filled", "false").ok());
  settle();
  const scene::Picture shown = window.layers().chosen(*window.session().outcome()->picture);
  EXPECT_FALSE(shown.panels[0].layers[0].visible);
}

TEST_F(MainWindowTest, ClickTellsTheItemAndMoveTheCoordinates) {
  open_waves();
  QStringList picks;
  QStringList places;
  QObject::connect(&window.view(), &VtkWidget::picked, [&](const QString& said) { picks << said; });
  QObject::connect(&window.view(), &VtkWidget::cursor_moved, [&](const QString& said) { places << said; });
  const QPointF on_third = window.view().pixel_of(0, {500.0, -150.0});
  QTest::mouseClick(&window.view(), Qt::LeftButton, {}, on_third.toPoint());
  ASSERT_FALSE(picks.isEmpty());
  EXPECT_EQ(picks.last(), "offset curves, item 2");
  QMouseEvent move(QEvent::MouseMove, on_third, window.view().mapToGlobal(on_third), Qt::NoButton, Qt::NoButton, {});
  QCoreApplication::sendEvent(&window.view(), &move);
  ASSERT_FALSE(places.isEmpty());
  EXPECT_TRUE(places.last().startsWith("x = 500")) << places.last().toStdString();
}

TEST_F(MainWindowTest, GUI_a_ScreenshotShowsThePicture) {
  open_waves();
  ASSERT_TRUE(window.save_screenshot(folder / "shot.png").ok());
  const QImage shot(QString::fromStdString((folder / "shot.png").string()));
  ASSERT_FALSE(shot.isNull());
  const QPoint corner = window.view().mapTo(&window, QPoint(0, 0));
  std::set<QRgb> colors;
  for (int y = 0; y < window.view().height(); y += 2) {
    for (int x = 0; x < window.view().width(); x += 2) colors.insert(shot.pixel(corner + QPoint(x, y)));
  }
  EXPECT_GT(colors.size(), 10u);
  // The bed's own colour, just below the top of the wave at x = 500.
  const QPoint bed = corner + window.view().pixel_of(0, {500.0, -25.0}).toPoint();
  EXPECT_EQ(QColor(shot.pixel(bed)), QColor(236, 214, 160));
}

TEST_F(MainWindowTest, PictureIsSavedInEachFormatAndOthersAreRefused) {
  EXPECT_FALSE(window.save_picture(folder / "nothing.svg").ok());
  open_waves();
  for (const char* name : {"a.svg", "a.pdf", "a.png"}) {
    EXPECT_TRUE(window.save_picture(folder / name).ok()) << name;
    EXPECT_GT(folder.read(name).size(), 500u) << name;
  }
  EXPECT_FALSE(window.save_picture(folder / "a.bmp").ok());
}

TEST_F(MainWindowTest, DroppedScenarioIsOpened) {
  const std::filesystem::path file = folder.write("dropped.toml", test::waves_text());
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(QString::fromStdString(file.string()))});
  QDragEnterEvent enter({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, {});
  QCoreApplication::sendEvent(&window, &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent drop({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, {});
  QCoreApplication::sendEvent(&window, &drop);
  settle();
  EXPECT_EQ(window.session().document().file, file);
}

TEST_F(MainWindowTest, DocumentThatCannotBeWrittenStaysModified) {
  open_waves();
  ASSERT_TRUE(type("count", "5").ok());
  EXPECT_FALSE(window.save(folder / "no/such/folder/a.toml").ok());
  EXPECT_TRUE(window.isWindowModified());
  EXPECT_FALSE(window.error_bar().message().isEmpty());
  window.session().undo();
}

}  // namespace
}  // namespace dobra::gui
