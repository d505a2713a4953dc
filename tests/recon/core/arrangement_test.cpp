#include "recon/core/arrangement.h"

#include <gtest/gtest.h>

namespace recon::core {
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

}  // namespace
}  // namespace recon::core
