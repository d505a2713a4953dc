// A frame of many points is drawn in parts, between which a person is heard.
#include <gtest/gtest.h>

#include <QMouseEvent>
#include <QTest>
#include <QWheelEvent>
#include <cmath>

#include "shared/gui/view/settings.h"
#include "shared/gui/vtk_widget.h"
#include "shared/scene/fill.h"

namespace dobra::gui {
namespace {

/// A square of 2 n n triangles: each quarter has a value of its own, 0 and 1 below, 2 and 3 above.
scene::Mesh quarters(std::uint32_t n) {
  scene::Mesh mesh;
  mesh.values_at = scene::ValuesAt::Triangles;
  mesh.scale = {"quarter", scene::ColorMapName::Viridis, 0.0, 3.0};
  for (std::uint32_t j = 0; j <= n; ++j) {
    for (std::uint32_t i = 0; i <= n; ++i) mesh.points.push_back({100.0 * i / n, 100.0 * j / n});
  }
  for (std::uint32_t j = 0; j < n; ++j) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t low = j * (n + 1) + i;
      mesh.triangles.edit().push_back({low, low + 1, low + n + 2});
      mesh.triangles.edit().push_back({low, low + n + 2, low + n + 1});
      for (int k = 0; k < 2; ++k) mesh.values.push_back((2 * i >= n ? 1.0 : 0.0) + (2 * j >= n ? 2.0 : 0.0));
    }
  }
  return mesh;
}

constexpr scene::Color line_color{200, 30, 30};

/// The square over a grey one twice as large, under a line along y = 75.
scene::Picture square_of(std::uint32_t n) {
  scene::Panel panel{.key = "square", .title = "Square", .axes = {}, .layers = {}};
  const auto box = [](double low, double high) {
    return geom::Polyline{{{low, low}, {high, low}, {high, high}, {low, high}}, true};
  };
  panel.layers.push_back({"ground",
                          "Ground",
                          {.line_width = 0.0, .fill = scene::Color{150, 150, 150}},
                          scene::Regions{{scene::Region{{box(-50.0, 150.0)}}}, {}}});
  panel.layers.push_back({"mesh", "Mesh", {.line_width = 0.0}, quarters(n)});
  panel.layers.push_back({"line",
                          "Line",
                          {.line = line_color, .line_width = 4.0},
                          scene::Lines{{geom::Polyline{{{0.0, 75.0}, {100.0, 75.0}}, false}}, {}}});
  scene::Picture picture;
  picture.panels.push_back(std::move(panel));
  return picture;
}

class Parts : public testing::Test {
 protected:
  Parts() {
    view.resize(700, 600);
    view.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&view, 10000));
    settle();
  }
  bool settle() {
    return QTest::qWaitFor([&] { return view.is_settled(); }, 60000);
  }
  /// Until a frame of many points is being drawn, and not yet there.
  bool wait_for_parts() {
    const std::size_t before = view.meter().begun();
    return QTest::qWaitFor([&] { return view.meter().begun() > before; }, 60000) && !view.is_settled();
  }
  void turn_wheel(QPointF at, int notches) {
    QWheelEvent wheel(at, view.mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&view, &wheel);
  }
  void drag(QPointF from, QPointF by) {
    QTest::mousePress(&view, Qt::MiddleButton, {}, from.toPoint());
    QMouseEvent move(QEvent::MouseMove, from + by, view.mapToGlobal(from + by), Qt::NoButton, Qt::MiddleButton, {});
    QCoreApplication::sendEvent(&view, &move);
    QTest::mouseRelease(&view, Qt::MiddleButton, {}, (from + by).toPoint());
  }
  /// What is seen at a place of the model.
  scene::Color color_at(geom::Point at) {
    const QImage image = view.grabFramebuffer();
    const QColor color = image.pixelColor((view.pixel_of(0, at) * view.devicePixelRatioF()).toPoint());
    return {static_cast<std::uint8_t>(color.red()), static_cast<std::uint8_t>(color.green()),
            static_cast<std::uint8_t>(color.blue()), 255};
  }
  static void expect_near(const scene::Color& seen, const scene::Color& wanted, const char* where) {
    EXPECT_LE(std::abs(seen.red - wanted.red) + std::abs(seen.green - wanted.green) + std::abs(seen.blue - wanted.blue),
              12)
        << where << ": " << int(seen.red) << " " << int(seen.green) << " " << int(seen.blue) << " for "
        << int(wanted.red) << " " << int(wanted.green) << " " << int(wanted.blue);
  }
  void expect_square() {
    const scene::Scale scale{"quarter", scene::ColorMapName::Viridis, 0.0, 3.0};
    const auto quarter = [&](double value) { return scene::stepped_color(scale, value, 64); };
    expect_near(color_at({20.0, 30.0}), quarter(0.0), "below left");
    expect_near(color_at({80.0, 30.0}), quarter(1.0), "below right");
    expect_near(color_at({20.0, 60.0}), quarter(2.0), "above left");
    expect_near(color_at({80.0, 90.0}), quarter(3.0), "above right");
    expect_near(color_at({120.0, 50.0}), {150, 150, 150}, "beside");
    expect_near(color_at({70.0, 75.0}), line_color, "on the line");
  }
  VtkWidget view;
};

constexpr std::uint32_t many = 300;  ///< 180 000 triangles
constexpr std::uint32_t few = 40;

TEST_F(Parts, MakeTheFrameThatOneWouldMake) {
  view.set_picture(square_of(few), Looking::AtAll);
  ASSERT_TRUE(settle());
  expect_square();
  EXPECT_EQ(view.meter().begun(), 0U);
  view.meter().take_longest_frame();
  view.set_picture(square_of(many), Looking::AtAll);
  ASSERT_TRUE(settle());
  EXPECT_EQ(view.meter().begun(), 1U);
  expect_square();
  const frames::Meter::FullFrame frame = view.meter().take_longest_frame();
  EXPECT_LT(frame.deaf, 0.6 * frame.milliseconds);
}

TEST_F(Parts, GiveWayToTheWheel) {
  view.set_picture(square_of(many), Looking::AtAll);
  ASSERT_TRUE(wait_for_parts());
  const std::size_t full = view.meter().full_frames();
  const double before = view.view(0).world_per_point;
  turn_wheel({350.0, 300.0}, 2);
  EXPECT_LT(view.view(0).world_per_point, 0.8 * before);
  EXPECT_EQ(view.meter().full_frames(), full);  // the one that was begun is nobody's any more
  ASSERT_TRUE(settle());
  EXPECT_EQ(view.meter().begun(), 2U);
  EXPECT_EQ(view.meter().full_frames(), full + 1);
  expect_square();
}

TEST_F(Parts, WhatWasHeldMovesOnWhileTheFrameIsNotDone) {
  view.set_picture(square_of(many), Looking::AtAll);
  ASSERT_TRUE(settle());
  drag({350.0, 300.0}, {40.0, 0.0});
  ASSERT_TRUE(wait_for_parts());
  expect_square();
  drag({350.0, 300.0}, {0.0, -30.0});
  QCoreApplication::processEvents();
  EXPECT_FALSE(view.is_settled());
  expect_square();  // the last frame, moved twice
  ASSERT_TRUE(settle());
  expect_square();
}

TEST_F(Parts, AnotherPictureTakesTheirPlace) {
  view.set_picture(square_of(many), Looking::AtAll);
  ASSERT_TRUE(wait_for_parts());
  view.set_picture(square_of(few), Looking::AtAll);
  ASSERT_TRUE(settle());
  expect_square();
  EXPECT_EQ(view.meter().begun(), 1U);
  // A stream of them is not put off for ever: what comes too quickly for parts is drawn all the same.
  std::uint32_t n = many;
  std::size_t replaced = 0;
  const std::size_t full = view.meter().full_frames();
  for (; replaced < 20 && view.meter().full_frames() == full; ++replaced) {
    view.set_picture(square_of(n++), Looking::AtAll);
    const std::size_t begun = view.meter().begun();
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return view.meter().begun() > begun || view.meter().full_frames() > full; }, 60000));
  }
  EXPECT_LT(replaced, 10U);
}

TEST_F(Parts, ALayerThatIsHiddenMeanwhileIsNotDrawn) {
  view.set_picture(square_of(many), Looking::AtAll);
  ASSERT_TRUE(wait_for_parts());
  view.set_layer_visible("square", "mesh", false);
  ASSERT_TRUE(settle());
  expect_near(color_at({20.0, 30.0}), {150, 150, 150}, "without the mesh");
  view.set_layer_visible("square", "mesh", true);
  view.resize(640, 560);
  ASSERT_TRUE(settle());
  expect_square();
}

TEST_F(Parts, WhatIsDrawnIsNotDrawnAgainForWhatLiesOverIt) {
  view.set_picture(square_of(many), Looking::AtAll);
  ASSERT_TRUE(settle());
  const std::size_t full = view.meter().full_frames();
  for (int i = 0; i < 5; ++i) {
    view.update();
    QTest::qWait(10);
  }
  EXPECT_EQ(view.meter().full_frames(), full);
  EXPECT_EQ(view.meter().begun(), 1U);
}

TEST_F(Parts, APictureIsLaidOutOnce) {
  view.set_picture(square_of(few), Looking::AtAll);
  ASSERT_TRUE(settle());
  const std::size_t before = view.arrangements();
  view.set_picture(square_of(few), Looking::WhereItDid);
  EXPECT_EQ(view.arrangements(), before + 1);
  gui::view::Settings settings;
  settings.exaggeration = std::nullopt;  // what fills the canvas follows from where the plots are
  view.set_settings(settings);
  const std::size_t filled = view.arrangements();
  EXPECT_LE(filled, before + 3);
  view.set_picture(square_of(few), Looking::WhereItDid);
  EXPECT_EQ(view.arrangements(), filled + 1);
}

}  // namespace
}  // namespace dobra::gui
