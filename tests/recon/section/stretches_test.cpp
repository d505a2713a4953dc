#include "recon/section/stretches.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "recon/section/arrangement.h"
#include "shared/geom/intersect.h"
#include "shared/topo/adjacency.h"
#include "shared/topo/insert.h"

namespace recon::section {
namespace {

using geom::Point;
using geom::Polyline;
using geom::Segment;

/// Beds of one shape one under the other: waves steep enough to overturn, thin and thick, some of them noisy; and
/// faults across them, some of which end on the way.
std::vector<Polyline> beds_and_faults(std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto draw = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  const double lean = draw(0.0, 2.5);  // above 1 the limbs overturn
  const double noise = seed % 3 == 0 ? draw(0.0, 0.3) : 0.0;
  const int points = static_cast<int>(draw(20, 700));
  const int beds = static_cast<int>(draw(2, 9));
  std::vector<Polyline> lines;
  double depth = 0.0;
  for (int k = 0; k < beds; ++k, depth += draw(0.02, 3.0)) {
    Polyline line;
    for (int i = 0; i <= points; ++i) {
      const double s = 25.0 * i / points;
      line.points.push_back(
          {s + lean * std::sin(s) + draw(-noise, noise), 2.0 * std::sin(s) - depth + draw(-noise, noise)});
    }
    lines.push_back(std::move(line));
  }
  for (int k = 0; k < static_cast<int>(seed % 4); ++k) {
    const Point from{draw(0.0, 25.0), draw(0.0, 4.0)};
    const Point to{draw(0.0, 25.0), draw(-depth - 4.0, 0.0)};
    Polyline line;
    const int pieces = static_cast<int>(draw(1, 60));
    for (int i = 0; i <= pieces; ++i)
      line.points.push_back(geom::interpolate(from, to, static_cast<double>(i) / pieces));
    lines.push_back(std::move(line));
  }
  if (seed % 5 == 0) lines.push_back({{{1.0, -depth - 1.0}, {24.0, -depth - 1.0}, {24.0, 3.0}, {1.0, 3.0}}, true});
  return lines;
}

Segment chord(const Polyline& line, Stretch stretch) {
  const auto at = [&](std::uint32_t i) { return line.points[i == line.points.size() ? 0 : i]; };
  return {at(stretch.first), at(stretch.last)};
}

TEST(Stretches, FollowEachOtherAndCrossNothing) {
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    const std::vector<Polyline> lines = beds_and_faults(seed);
    Stretches stretches;
    stretches.add(lines);
    std::vector<Segment> free;
    std::vector<Segment> all;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      std::uint32_t next = 0;
      for (const Stretch stretch : stretches.of(i)) {
        ASSERT_EQ(stretch.first, next);
        ASSERT_GT(stretch.last, stretch.first);
        next = stretch.last;
        all.push_back(chord(lines[i], stretch));
        if (!stretch.is_segment()) free.push_back(all.back());
      }
      ASSERT_EQ(next, lines[i].segment_count());
    }
    for (const Segment& stretch : free) {
      int meetings = 0;  // with itself, and with those that it follows and that follow it
      for (const Segment& other : all) {
        const geom::Intersection meet = geom::intersect(stretch, other);
        if (meet.kind == geom::IntersectionKind::None || stretch == other) continue;
        ASSERT_EQ(meet.kind, geom::IntersectionKind::Point) << "seed " << seed;
        ASSERT_FALSE(meet.start.proper()) << "seed " << seed;
        ++meetings;
      }
      ASSERT_LE(meetings, 2) << "seed " << seed;
    }
  }
}

TEST(Stretches, SideBySideLinesHaveFewAndALineAloneOne) {
  std::vector<Polyline> lines(20);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    for (int i = 0; i <= 4000; ++i)
      lines[k].points.push_back({0.01 * i, std::sin(0.01 * i) - 0.05 * static_cast<double>(k)});
  }
  Stretches stretches;
  stretches.add(std::span(lines).first(1));
  EXPECT_EQ(stretches.of(0).size(), 1u);
  stretches.add(std::span(lines).subspan(1));
  for (std::size_t k = 0; k < lines.size(); ++k) EXPECT_LT(stretches.of(k).size(), 200u);
  stretches.cut_all();
  EXPECT_EQ(stretches.of(7).size(), 4000u);
}

TEST(Stretches, ALineThatTurnsBackOrCrossesItselfIsCutThere) {
  const std::vector<Polyline> lines{{{{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, -2}, {9, -2}}, false},
                                    {{{20, 0}, {24, 0}, {22, 0}, {30, 0}}, false},
                                    {{{40, 0}, {44, 0}, {44, 0}, {50, 0}}, false}};
  Stretches stretches;
  stretches.add(lines);
  for (std::size_t i = 0; i < lines.size(); ++i) EXPECT_EQ(stretches.of(i).size(), lines[i].segment_count());
}

/// Everything drawn, segment by segment.
topo::Subdivision whole(const std::vector<Polyline>& lines) {
  topo::Subdivision sub;
  for (const Polyline& line : lines) EXPECT_TRUE(topo::insert(sub, line));
  return sub;
}

TEST(Stretches, AnArrangementHasTheFacesAndMeetingsOfOneWithEverySegment) {
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    const std::vector<Polyline> lines = beds_and_faults(seed);
    const topo::Subdivision expected = whole(lines);
    const auto late = lines.begin() + static_cast<std::ptrdiff_t>(lines.size() / 2);
    for (const bool in_two : {false, true}) {
      auto made = Arrangement::make({lines.begin(), in_two ? late : lines.end()});
      ASSERT_TRUE(made);
      ASSERT_TRUE(!in_two || made->add({late, lines.end()}));
      const topo::Subdivision& sub = made->subdivision();
      EXPECT_EQ(sub.face_count(), expected.face_count()) << "seed " << seed;
      EXPECT_EQ(sub.component_count(), expected.component_count()) << "seed " << seed;
      EXPECT_LE(sub.edge_count(), expected.edge_count());
      std::vector<double> areas;
      std::vector<double> expected_areas;
      for (const topo::FaceId f : sub.faces()) areas.push_back(made->area(f));
      for (const topo::FaceId f : expected.faces()) expected_areas.push_back(topo::area(expected, f));
      std::sort(areas.begin(), areas.end());
      std::sort(expected_areas.begin(), expected_areas.end());
      ASSERT_EQ(areas.size(), expected_areas.size());
      for (std::size_t i = 0; i < areas.size(); ++i) EXPECT_NEAR(areas[i], expected_areas[i], 1e-11) << "seed " << seed;
      for (const topo::VertexId v : expected.vertices()) {
        if (expected.degree(v) < 3) continue;
        const auto here = sub.vertex_at(expected.point(v));
        ASSERT_TRUE(here) << "seed " << seed;
        EXPECT_EQ(sub.degree(*here), expected.degree(v));
      }
    }
  }
}

TEST(Stretches, TheCourseOfALineIsTheLine) {
  for (std::uint32_t seed = 1; seed < 40; seed += 3) {  // without noise: the lines do not meet themselves
    const std::vector<Polyline> lines = beds_and_faults(seed);
    const auto made = Arrangement::make(lines);
    ASSERT_TRUE(made);
    for (std::uint32_t i = 0; i < lines.size(); ++i) {
      std::vector<Point> course;
      for (const topo::HalfEdgeId h : made->path(i)) made->append(h, course);
      std::vector<Point> backwards;
      const auto path = made->path(i);
      for (auto h = path.rbegin(); h != path.rend(); ++h) made->append(topo::Structure::twin(*h), backwards);
      const std::vector<Point>& line = lines[i].points;
      std::size_t found = 0;  // the vertices of the line in their order, and crossings between them
      for (const Point p : course) found += found < line.size() && p == line[found] ? 1 : 0;
      EXPECT_EQ(found + (lines[i].closed ? 0 : 1), line.size()) << "seed " << seed << " line " << i;
      found = line.size();
      if (lines[i].closed) continue;
      for (const Point p : backwards) found -= found > 0 && p == line[found - 1] ? 1 : 0;
      EXPECT_EQ(found, 1u) << "seed " << seed << " line " << i;
    }
  }
}

TEST(Stretches, LinesThatAreOneButForRoundingAreDrawnSegmentBySegment) {
  std::mt19937 random(7);
  std::vector<Polyline> lines(3);
  for (int i = 0; i <= 3000; ++i) {
    const double x = 3.7 * i;
    for (std::size_t k = 0; k < 2; ++k) {
      double z = 1000.0 * std::sin(0.001 * x);
      for (auto step = random() % 3; step > 0; --step) z = std::nextafter(z, 1e9);
      lines[k].points.push_back({x, z});
    }
    lines[2].points.push_back({x, 1000.0 * std::sin(0.001 * x) - 500.0});
  }
  const auto made = Arrangement::make(lines);
  ASSERT_TRUE(made);
  const topo::Subdivision expected = whole(lines);
  EXPECT_EQ(made->subdivision().face_count(), expected.face_count());
  EXPECT_EQ(made->subdivision().component_count(), expected.component_count());
}

}  // namespace
}  // namespace recon::section
