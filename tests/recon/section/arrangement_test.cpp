#include "recon/section/arrangement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace recon::section {
namespace {

using geom::Point;
using geom::Polyline;

LineMeeting meeting(const std::vector<Point>& first, const std::vector<Point>& second) {
  const auto found = meeting_of({first, false}, {second, false});
  EXPECT_TRUE(found) << to_string(found.error());
  return found ? *found : LineMeeting{};
}

TEST(Arrangement, APathHoldsTheLineThroughAllThatCrossesIt) {
  const std::vector<Polyline> lines{{{{0, 0}, {10, 0}}, false},
                                    {{{2, -1}, {2, 1}, {4, 1}, {4, -1}}, false},
                                    {{{5, 0}, {7, 0}}, false},
                                    {{{1, -2}, {9, -2}, {9, 2}, {1, 2}}, true}};
  const auto made = Arrangement::make(lines);
  ASSERT_TRUE(made);
  const topo::Subdivision& sub = made->subdivision();
  const auto path = made->path(0);
  ASSERT_EQ(path.size(), 7u);  // cut at x = 1, 2, 4, 5, 7, 9
  EXPECT_EQ(sub.point(sub.origin(path.front())), (Point{0, 0}));
  EXPECT_EQ(sub.point(sub.target(path.back())), (Point{10, 0}));
  for (std::size_t i = 1; i < path.size(); ++i) EXPECT_EQ(sub.target(path[i - 1]), sub.origin(path[i]));
  EXPECT_EQ(made->lines_on(topo::Structure::edge(path[4])), (std::vector<std::uint32_t>{0, 2}));
  const auto ring = made->path(3);
  double area = 0.0;
  for (const auto h : ring) area += 0.5 * geom::cross(sub.segment(h).from - Point{}, sub.segment(h).to - Point{});
  EXPECT_EQ(area, 32.0);
  const auto reversed = Arrangement::make(std::vector<Polyline>{geom::reversed(lines[3])});
  ASSERT_TRUE(reversed);
  area = 0.0;
  for (const auto h : reversed->path(0)) {
    const geom::Segment s = reversed->subdivision().segment(h);
    area += 0.5 * geom::cross(s.from - Point{}, s.to - Point{});
  }
  EXPECT_EQ(area, -32.0);
}

TEST(Arrangement, ALineThatPassesToTheOtherSideCrosses) {
  const LineMeeting plain = meeting({{0, 0}, {4, 4}}, {{0, 4}, {4, 0}});
  EXPECT_EQ(plain.crossings, 1u);
  EXPECT_EQ(plain.touches, 0u);
  EXPECT_EQ(plain.place, (Point{2, 2}));
  // Through a vertex of the other, and along a piece of it.
  EXPECT_EQ(meeting({{0, 1}, {2, 0}, {4, -1}}, {{0, 0}, {2, 0}, {4, 0}}).crossings, 1u);
  const LineMeeting along = meeting({{0, 1}, {1, 0}, {3, 0}, {4, -1}}, {{-1, 0}, {5, 0}});
  EXPECT_EQ(along.crossings, 1u);
  EXPECT_EQ(along.touches, 0u);
  EXPECT_EQ(along.place, (Point{1, 0}));
  EXPECT_EQ(meeting({{0, 1}, {1, -1}, {2, 1}, {3, -1}}, {{-1, 0}, {5, 0}}).crossings, 3u);
}

TEST(Arrangement, ALineThatComesBackToItsSideOrEndsOnTheOtherTouches) {
  const LineMeeting tip = meeting({{0, 1}, {2, 0}, {4, 1}}, {{0, 0}, {4, 0}});
  EXPECT_EQ(tip.crossings, 0u);
  EXPECT_EQ(tip.touches, 1u);
  EXPECT_EQ(tip.place, (Point{2, 0}));
  EXPECT_EQ(meeting({{0, 1}, {1, 0}, {3, 0}, {4, 1}}, {{-1, 0}, {5, 0}}).crossings, 0u);
  EXPECT_EQ(meeting({{0, 1}, {2, 0}}, {{0, 0}, {4, 0}}).touches, 1u);     // it ends there
  EXPECT_EQ(meeting({{0, -1}, {4, 3}}, {{2, 1}, {5, 1}}).crossings, 0u);  // the other ends there
  EXPECT_EQ(meeting({{2, 0}, {3, 1}}, {{0, 0}, {4, 0}}).touches, 1u);     // it begins there
  const LineMeeting apart = meeting({{0, 1}, {4, 1}}, {{0, 0}, {4, 0}});
  EXPECT_EQ(apart.crossings + apart.touches, 0u);
}

/// Sums of the faces within each of the first rings.
std::vector<double> areas_within(const Arrangement& arrangement, std::size_t count) {
  std::vector<double> areas(count, 0.0);
  const auto holders = arrangement.holders(0, std::vector<std::string>(count, "ring"));
  EXPECT_TRUE(holders) << to_string(holders.error());
  if (!holders) return areas;
  for (const topo::FaceId f : arrangement.subdivision().faces()) {
    for (const std::uint32_t ring : (*holders)[f.index()]) areas[ring] += arrangement.area(f);
  }
  return areas;
}

using Ring = std::vector<Point>;

/// What is left of a ring below the line z = level + dip x, or above it.
Ring clipped(const Ring& ring, double level, double dip, double sign) {
  Ring left;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point p = ring[i];
    const Point q = ring[(i + 1) % ring.size()];
    const double over_p = sign * (p.y - level - dip * p.x);
    const double over_q = sign * (q.y - level - dip * q.x);
    if (over_p <= 0.0) left.push_back(p);
    if ((over_p < 0.0) != (over_q < 0.0)) left.push_back(geom::interpolate(p, q, over_p / (over_p - over_q)));
  }
  return left;
}

double area_of(const Ring& ring) {
  long double sum = 0.0L;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const geom::Vector p = ring[i] - ring[0];
    const geom::Vector q = ring[(i + 1) % ring.size()] - ring[0];
    sum += static_cast<long double>(p.x) * q.y - static_cast<long double>(p.y) * q.x;
  }
  return static_cast<double>(std::abs(sum) / 2.0L);
}

/// A layer between two lines z = level + dip x, cut by sides x = x0 + lean z and x0 + width + lean z.
struct Layer {
  double top, top_dip, base, base_dip;
  [[nodiscard]] Ring ring(double x0, double width, double lean) const {
    const auto at = [&](double x, double level, double dip) {
      const double z = (level + dip * x) / (1.0 - dip * lean);
      return Point{x + lean * z, z};
    };
    return {at(x0, base, base_dip), at(x0 + width, base, base_dip), at(x0 + width, top, top_dip), at(x0, top, top_dip)};
  }
};

/// Areas of two rings in common.
double common_area(const Arrangement& arrangement, std::uint32_t i, std::uint32_t j, std::size_t count) {
  const auto holders = arrangement.holders(0, std::vector<std::string>(count, "ring"));
  double area = 0.0;
  for (const topo::FaceId f : arrangement.subdivision().faces()) {
    const std::vector<std::uint32_t>& of = (*holders)[f.index()];
    if (std::binary_search(of.begin(), of.end(), i) && std::binary_search(of.begin(), of.end(), j))
      area += arrangement.area(f);
  }
  return area;
}

TEST(Arrangement, RingsWithSidesCollinearUpToRoundingHoldTheirAreasAndThoseInCommon) {
  std::mt19937_64 random(7);
  const auto uniform = [&](double from, double to) { return std::uniform_real_distribution<>(from, to)(random); };
  for (int run = 0; run < 200; ++run) {
    const double lean = run % 4 == 0 ? 0.1 * std::round(uniform(-20, 20)) : uniform(-2, 2);
    const double width = run % 4 == 0 ? 100.0 * std::round(uniform(1, 90)) : uniform(100, 9000);
    const double x0 = run % 4 == 0 ? 0.0 : uniform(-1e3, 1e3);
    const double dip = run % 2 == 0 ? 0.0 : uniform(-0.01, 0.01);
    const double overlap = (run % 3 == 0 ? -1.0 : 1.0) * std::pow(10.0, uniform(-9, 0));  // below 0: a gap
    std::vector<Layer> layers;
    for (int i = 0; i < 4; ++i) {
      const double level = -300.0 * i;
      const double more = i == 0 ? 0.0 : i == 1 && run % 8 == 0 ? 0.3 : overlap;
      layers.push_back({level + more, dip, level - 300.0, run % 5 == 0 ? dip + uniform(-1e-9, 1e-9) : dip});
    }
    std::shuffle(layers.begin(), layers.end(), random);
    std::vector<Polyline> rings;
    for (const Layer& layer : layers) rings.push_back({layer.ring(x0, width, lean), true});
    const auto made = Arrangement::make(rings);
    ASSERT_TRUE(made);
    const std::vector<double> areas = areas_within(*made, rings.size());
    for (std::uint32_t i = 0; i < rings.size(); ++i) {
      EXPECT_NEAR(areas[i], area_of(rings[i].points), 1e-12 * areas[i]) << "run " << run;
      for (std::uint32_t j = 0; j < i; ++j) {
        const Ring part = clipped(clipped(rings[i].points, layers[j].top, layers[j].top_dip, 1.0), layers[j].base,
                                  layers[j].base_dip, -1.0);
        EXPECT_NEAR(common_area(*made, i, j, rings.size()), area_of(part), 1e-12 * areas[i]) << "run " << run;
      }
    }
  }
}

TEST(Arrangement, AnEdgeBentOntoAnotherLineStaysInItsOwn) {
  // The last ring passes the sides of the others within rounding and bends that of the first onto its own edge.
  const auto layer = [](double base, double top) {
    const double lean = -0.30000000000000004;
    const auto at = [&](double x, double z) { return Point{x + lean * z, z}; };
    return Polyline{{at(0, base), at(300, base), at(300, top), at(0, top)}, true};
  };
  const double overlap = 8.4973617877244721e-06;
  const auto made = Arrangement::make({layer(-300, 0), layer(-900, overlap - 600), layer(-600, overlap - 300)});
  ASSERT_TRUE(made);
  const auto ring = made->path(0);
  const topo::Subdivision& sub = made->subdivision();
  ASSERT_EQ(ring.size(), 6U);
  for (std::size_t i = 0; i < ring.size(); ++i) EXPECT_EQ(sub.target(ring[i]), sub.origin(ring[(i + 1) % 6]));
  EXPECT_EQ(std::count_if(ring.begin(), ring.end(),
                          [&](topo::HalfEdgeId h) { return made->lines_on(topo::Structure::edge(h)).size() == 2; }),
            1);
}

TEST(Arrangement, AClockwiseRingHoldsWhatItSurroundsAndARingWithALoopIsRefusedByName) {
  const Polyline ring{{{0, 0}, {4, 0}, {4, 3}, {0, 3}}, true};
  const auto made = Arrangement::make({ring, geom::reversed(ring)});
  ASSERT_TRUE(made);
  EXPECT_EQ(areas_within(*made, 2), (std::vector<double>{12.0, 12.0}));
  const auto crossed = Arrangement::make({ring, {{{0, 0}, {4, 4}, {4, 0}, {0, 3}}, true}});
  ASSERT_TRUE(crossed);
  const auto refused = crossed->holders(0, {"unit 'Q'", "unit 'R'"});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().place->item, "unit 'R'");
  EXPECT_EQ(refused.error().place->x, 0.0);
}

}  // namespace
}  // namespace recon::section
