#include "shared/geom/segment_tree.h"

#include <gtest/gtest.h>

#include <random>

namespace dobra::geom {
namespace {

TEST(SegmentTree, TheNearestSegmentIsThatOfASearchThroughAll) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (const std::size_t count : {1U, 2U, 3U, 17U, 300U}) {
    for (const double roughness : {0.0, 0.5, 20.0}) {
      std::vector<Segment> segments;
      Point before{0, 0};
      for (std::size_t i = 1; i <= count; ++i) {
        const double t = static_cast<double>(i);
        const Point p{t + roughness * unit(random), 10.0 * std::sin(t / 20.0) + roughness * unit(random)};
        segments.push_back({before, p});
        before = p;
      }
      const SegmentTree tree(segments);
      const auto even = [](std::size_t i) { return i % 2 == 0; };
      for (int k = 0; k < 200; ++k) {
        const Point p{static_cast<double>(count) * (0.5 + unit(random)), 40.0 * unit(random)};
        SegmentTree::Nearest all;
        SegmentTree::Nearest accepted;
        for (std::size_t i = 0; i < count; ++i) {
          const SegmentTree::Nearest candidate{i, tree.squared_distance(i, p)};
          if (candidate.before(all)) all = candidate;
          if (even(i) && candidate.before(accepted)) accepted = candidate;
        }
        EXPECT_EQ(tree.nearest(p, [](std::size_t) { return true; })->index, all.index);
        EXPECT_EQ(tree.nearest(p, even)->index, accepted.index);
        EXPECT_EQ(tree.nearest_from(count / 4 * 2, p, even).index, accepted.index);
      }
    }
  }
}

}  // namespace
}  // namespace dobra::geom
