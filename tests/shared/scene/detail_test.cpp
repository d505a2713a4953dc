#include "shared/scene/detail.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "shared/scene/fill.h"

namespace dobra::scene {
namespace {

using geom::Point;
using geom::Polyline;

const geom::Box everywhere{{-1e9, -1e9}, {1e9, 1e9}};

Polyline rippled(std::size_t count, double height) {
  Polyline line;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = 1000.0 * static_cast<double>(i) / static_cast<double>(count - 1);
    line.points.push_back({x, height + 50.0 * std::sin(x / 100.0) + 0.4 * std::sin(7.0 * x)});
  }
  return line;
}

/// By crossings of a ray, without any part of the code under test.
bool is_inside(const std::vector<Polyline>& contours, Point at) {
  bool odd = false;
  for (const Polyline& contour : contours) {
    for (std::size_t i = 0; i < contour.points.size(); ++i) {
      const Point a = contour.points[i];
      const Point b = contour.points[(i + 1) % contour.points.size()];
      if ((a.y > at.y) != (b.y > at.y) && at.x < a.x + (at.y - a.y) * (b.x - a.x) / (b.y - a.y)) odd = !odd;
    }
  }
  return odd;
}

double nearest(const std::vector<Polyline>& lines, Point at, bool closed) {
  double least = INFINITY;
  for (const Polyline& line : lines) {
    for (std::size_t i = 0; i + (closed ? 0 : 1) < line.points.size(); ++i) {
      const Point a = line.points[i];
      const Point b = line.points[(i + 1) % line.points.size()];
      const double l2 = (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
      const double t =
          l2 > 0.0 ? std::clamp(((at.x - a.x) * (b.x - a.x) + (at.y - a.y) * (b.y - a.y)) / l2, 0.0, 1.0) : 0.0;
      least = std::min(least, std::hypot(at.x - a.x - t * (b.x - a.x), at.y - a.y - t * (b.y - a.y)));
    }
  }
  return least;
}

TEST(Detail, LinesKeepWhatCanBeSeenAndNoMore) {
  const std::vector<Polyline> lines{rippled(20001, 0.0)};
  for (const double detail : {0.01, 0.1, 1.0, 10.0}) {
    const std::vector<Polyline> seen = seen_lines(lines, {detail, everywhere});
    ASSERT_EQ(seen.size(), 1u);
    for (std::size_t i = 0; i < lines[0].points.size(); i += 37)
      ASSERT_LE(nearest(seen, lines[0].points[i], false), detail * 1.0000001) << detail << ' ' << i;
    EXPECT_EQ(seen[0].points.front(), lines[0].points.front());
    EXPECT_EQ(seen[0].points.back(), lines[0].points.back());
  }
  EXPECT_LT(seen_lines(lines, {1.0, everywhere})[0].points.size(), 60u);    // the ripple cannot be seen
  EXPECT_GT(seen_lines(lines, {0.1, everywhere})[0].points.size(), 2000u);  // here it can
}

TEST(Detail, LinesOutsideTheWindowAreLeftOutAndThoseInsideAreWhole) {
  const geom::Box window{{300.0, -100.0}, {400.0, 100.0}};
  // In at the left, out, and in again: two pieces, each with the segment that crosses the border.
  const Polyline comes_back{{{290, 0}, {350, 0}, {350, 500}, {360, 500}, {360, 0}, {410, 0}, {500, 0}}, false};
  const Polyline around{{{0, 200}, {1000, 200}}, false};
  const Polyline ring{{{310, -50}, {390, -50}, {390, 50}, {310, 50}}, true};
  const Polyline larger_ring{{{310, -50}, {390, -50}, {390, 5000}, {310, 5000}}, true};
  const std::vector<Polyline> seen =
      seen_lines({comes_back, around, ring, larger_ring, Polyline{{{320, 0}}, false}}, {0.0, window});
  ASSERT_EQ(seen.size(), 5u);
  EXPECT_EQ(seen[0].points, (std::vector<Point>{{290, 0}, {350, 0}, {350, 500}}));
  EXPECT_EQ(seen[1].points, (std::vector<Point>{{360, 500}, {360, 0}, {410, 0}}));
  EXPECT_EQ(seen[2], ring);
  // A ring that leaves the window is the pieces in it.
  for (const std::size_t i : {3u, 4u}) EXPECT_FALSE(seen[i].closed);
}

TEST(Detail, RegionsFillTheSameUpToWhatCanBeSeen) {
  Polyline band = rippled(4001, 0.0);
  const Polyline below = rippled(4001, -30.0);
  band.points.insert(band.points.end(), below.points.rbegin(), below.points.rend());
  band.closed = true;
  const Polyline hole{{{480, -20}, {520, -20}, {520, 30}, {480, 30}}, true};
  const Region region{{band, hole}};
  std::mt19937 random(3);
  std::uniform_real_distribution<double> x(0.0, 1000.0);
  std::uniform_real_distribution<double> y(-90.0, 60.0);
  const geom::Box part{{400.0, -40.0}, {600.0, 20.0}};
  for (const double detail : {0.01, 0.3, 2.0}) {
    for (const geom::Box& window : {everywhere, part}) {
      const Region seen = seen_region(region, {detail, window});
      int tested = 0;
      int inside = 0;
      for (int k = 0; k < 3000; ++k) {
        const Point at{x(random), y(random)};
        if (!window.contains(at) || nearest(region.contours, at, true) <= 1.01 * detail) continue;
        ++tested;
        inside += is_inside(region.contours, at) ? 1 : 0;
        ASSERT_EQ(is_inside(seen.contours, at), is_inside(region.contours, at)) << detail << ' ' << at.x << ' ' << at.y;
      }
      EXPECT_GT(tested, 100);
      EXPECT_GT(inside, 30);
      for (const Point p : triangles_of(seen)) {
        ASSERT_LE(p.x, window.high.x + 1e-9);
        ASSERT_GE(p.x, window.low.x - 1e-9);
      }
    }
  }
  EXPECT_TRUE(seen_region(region, {0.1, {{2000.0, 0.0}, {2100.0, 50.0}}}).contours.empty());
  EXPECT_LT(seen_region(region, {1.0, everywhere}).contours[0].points.size(), 200u);
}

TEST(Detail, PicturesShareWhatIsEqual) {
  const auto picture = [](double height) {
    Picture made;
    Panel& panel = made.panels.emplace_back();
    panel.key = "section";
    for (const double at : {0.0, height}) {
      Layer layer;
      layer.key = "line_" + std::to_string(panel.layers.size());
      layer.content = Lines{{rippled(100, at)}, {7}};
      panel.layers.push_back(std::move(layer));
    }
    return made;
  };
  const Picture before = picture(10.0);
  Picture after = picture(20.0);
  const auto lines = [](const Picture& p, std::size_t i) {
    return std::get<Lines>(p.panels[0].layers[i].content).lines;
  };
  EXPECT_FALSE(lines(after, 0).is(lines(before, 0)));
  share_with(after, before);
  EXPECT_TRUE(lines(after, 0).is(lines(before, 0)));
  EXPECT_FALSE(lines(after, 1).is(lines(before, 1)));
  EXPECT_EQ(lines(after, 1)[0], rippled(100, 20.0));
  EXPECT_EQ(point_count(after.panels[0].layers[0]), 100u);
}

}  // namespace
}  // namespace dobra::scene
