#include "shared/scene/view.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace dobra::scene {
namespace {

double real(int value, double scale) { return scale * (value % 1000) / 1000.0; }

const geom::Box plot{{30.0, 20.0}, {430.0, 320.0}};

TEST(View, FitShowsAllOfTheBoxAndTouchesItInOneDirection) {
  const View view = fit({{0.0, 0.0}, {800.0, 100.0}}, plot.width(), plot.height());
  EXPECT_DOUBLE_EQ(view.world_per_point, 2.0);
  EXPECT_EQ(view.centre, (geom::Point{400.0, 50.0}));
  const View tall = fit({{0.0, 0.0}, {8.0, 300.0}}, plot.width(), plot.height(), 2.0);
  EXPECT_DOUBLE_EQ(tall.world_per_point, 2.0);
}

TEST(View, PageYPointsDown) {
  const Transform transform = transform_of({{0.0, 0.0}, 1.0}, plot);
  EXPECT_EQ(transform.to_page({0.0, 0.0}), plot.centre());
  EXPECT_DOUBLE_EQ(transform.to_page({0.0, 10.0}).y, plot.centre().y - 10.0);
}

TEST(View, ComfortableBoxesAlwaysHaveWidthAndHeight) {
  for (const geom::Box& box : {geom::Box{}, geom::Box{{3.0, 4.0}, {3.0, 4.0}}, geom::Box{{3.0, 4.0}, {3.0, 9.0}},
                               geom::Box{{3.0, 4.0}, {8.0, 4.0}}}) {
    EXPECT_GT(comfortable(box).width(), 0.0);
    EXPECT_GT(comfortable(box).height(), 0.0);
    if (!box.empty()) {
      EXPECT_TRUE(comfortable(box).contains(box.centre()));
    }
  }
}

RC_GTEST_PROP(View, ZoomKeepsTheWorldPointUnderTheCursor, (int x, int y, int cx, int cy, unsigned f)) {
  const View view{{real(x, 1e4), real(y, 1e4)}, 0.7};
  const double stretch = 1.0 + (f % 3);
  const geom::Point cursor{plot.low.x + std::abs(real(cx, 400.0)), plot.low.y + std::abs(real(cy, 300.0))};
  const Transform before = transform_of(view, plot, stretch);
  const geom::Point world = before.to_world(cursor);
  const View nearer = zoom_at(view, world, 0.1 + (f % 100) / 10.0);
  const geom::Point after = transform_of(nearer, plot, stretch).to_page(world);
  RC_ASSERT(geom::distance(after, cursor) < 1e-6);
}

RC_GTEST_PROP(View, ZoomInAndOutIsTheIdentity, (int x, int y, unsigned f)) {
  const View view{{real(x, 1e3), real(y, 1e3)}, 2.0};
  const double factor = 1.0 + (f % 50) / 10.0;
  const View back = zoom_at(zoom_at(view, {10.0, 20.0}, factor), {10.0, 20.0}, 1.0 / factor);
  RC_ASSERT(geom::distance(back.centre, view.centre) < 1e-9);
  RC_ASSERT(std::abs(back.world_per_point - view.world_per_point) < 1e-12);
}

RC_GTEST_PROP(View, PanMovesTheContentWithTheCursor, (int x, int y, int dx, int dy)) {
  const View view{{real(x, 1e3), real(y, 1e3)}, 0.5};
  const double stretch = 3.0;
  const geom::Vector by{real(dx, 200.0), real(dy, 200.0)};
  const geom::Point world{1.0, 2.0};
  const geom::Point before = transform_of(view, plot, stretch).to_page(world);
  const geom::Point after = transform_of(pan(view, by, stretch), plot, stretch).to_page(world);
  RC_ASSERT(geom::length((after - before) - by) < 1e-9);
}

RC_GTEST_PROP(View, ToPageAndBackIsTheIdentity, (int x, int y)) {
  const Transform transform = transform_of({{3.0, -7.0}, 0.02}, plot, 2.5);
  const geom::Point world{real(x, 50.0), real(y, 50.0)};
  RC_ASSERT(geom::distance(transform.to_world(transform.to_page(world)), world) < 1e-10);
}

}  // namespace
}  // namespace dobra::scene
