// Nothing that a look at all boxes finds may be missed; what is reported beyond it may only be near.

#include "shared/offset/kernel/box_tree_search.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace dobra::offset {
namespace {

/// Boxes along a walk of the given step, far from the origin for good measure.
std::vector<FloatBox> boxes_of(std::size_t count, double step, double origin) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::vector<FloatBox> boxes;
  Flat p{origin, -origin};
  for (std::size_t i = 0; i < count; ++i) {
    FloatBox box(p, p, 0);
    for (int k = 0; k < 4; ++k) box.add(FloatBox(p, p = p + step * Flat{normal(random), normal(random)}, 0));
    box.add(FloatBox(p, p, 0));
    boxes.push_back(box);
  }
  return boxes;
}

double gap(const FloatBox& box, Flat q) {
  const double x = std::max({box.low_x - q.x, 0.0, q.x - box.high_x});
  const double y = std::max({box.low_y - q.y, 0.0, q.y - box.high_y});
  return std::hypot(x, y);
}

constexpr std::size_t counts[] = {1, 3, 4, 5, 16, 17, 63, 64, 65, 300};

TEST(BoxTree, FindsAllWithinReachAndLittleBeyond) {
  std::mt19937 random(8);
  for (const std::size_t count : counts) {
    for (const double scale : {1e-15, 1.0, 1e15}) {
      for (const double origin : {0.0, 1e3}) {
        const std::vector<FloatBox> boxes = boxes_of(count, scale, origin * scale);
        const BoxTree tree(boxes);
        std::uniform_real_distribution<double> place(-20 * scale, 20 * scale);
        for (int k = 0; k < 20; ++k) {
          const Flat q{origin * scale + place(random), -origin * scale + place(random)};
          const double reach = 0.5 * k * scale;
          std::set<std::size_t> seen;
          tree.any_within(q, reach, [&](std::size_t i) {
            EXPECT_TRUE(seen.insert(i).second);
            return false;
          });
          for (std::size_t i = 0; i < count; ++i) {
            EXPECT_TRUE(gap(boxes[i], q) > reach || seen.contains(i)) << count << " " << scale << " " << i;
            EXPECT_TRUE(!seen.contains(i) || gap(boxes[i], q) <= reach + 1e-5 * (reach + scale + 2 * origin * scale));
          }
        }
      }
    }
  }
}

TEST(BoxTree, StopsAtTheFirstThatIsWanted) {
  const BoxTree tree(boxes_of(300, 1.0, 0.0));
  int calls = 0;
  EXPECT_TRUE(tree.any_within({0, 0}, 1e6, [&](std::size_t) { return ++calls == 5; }));
  EXPECT_EQ(calls, 5);
}

TEST(BoxTree, FindsAllThatHoldFromTheTopAndFromAnItem) {
  for (const std::size_t count : counts) {
    const std::vector<FloatBox> boxes = boxes_of(count, 1.0, 0.0);
    const BoxTree tree(boxes);
    for (std::size_t item = 0; item < count; item += 7) {
      const auto holds = [&](const FloatBox& box) { return box.overlaps(boxes[item]); };
      std::set<std::size_t> seen, others;
      tree.any_held(holds, [&](std::size_t i) { return !seen.insert(i).second; });
      tree.any_held_from(item, holds, [&](std::size_t i) { return !others.insert(i).second; });
      for (std::size_t i = 0; i < count; ++i) {
        EXPECT_EQ(seen.contains(i), holds(boxes[i]));
        EXPECT_EQ(others.contains(i), holds(boxes[i]) && i / BoxTree::width != item / BoxTree::width)
            << count << " " << item << " " << i;
      }
    }
  }
}

TEST(BoxTree, FindsAllThatHoldAPlaceWhenGrown) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> place(-30, 30);
  for (const std::size_t count : counts) {
    const std::vector<FloatBox> boxes = boxes_of(count, 1.0, 0.0);
    std::vector<FloatBox> by = boxes_of(count, 0.3, 1e-3);
    for (std::size_t i = 0; i < count; i += 3) by[i] = {};  // nothing there
    const BoxTree tree(boxes);
    const BoxTree growth(by);
    for (int k = 0; k < 40; ++k) {
      const Flat q{place(random), place(random)};
      const double d = 0.1 * k;
      std::set<std::size_t> seen;
      tree.any_held(growth, q, d, [&](std::size_t i) { return !seen.insert(i).second; });
      for (std::size_t i = 0; i < count; ++i) {
        const auto& [p, w] = std::pair(boxes[i], by[i]);
        const bool inside = w.low_x <= w.high_x && q.x >= p.low_x + d * w.low_x && q.x <= p.high_x + d * w.high_x &&
                            q.y >= p.low_y + d * w.low_y && q.y <= p.high_y + d * w.high_y;
        EXPECT_TRUE(!inside || seen.contains(i)) << count << " " << i;
        EXPECT_FALSE(i % 3 == 0 && seen.contains(i));
      }
    }
  }
}

TEST(BoxTree, HoldsAllPlacesWhereItGrowsBeyondTheRangeOfFloats) {
  const BoxTree tree(boxes_of(20, 1.0, 0.0));
  std::vector<FloatBox> by = boxes_of(20, 0.3, 2.0);
  by[7] = {};
  const BoxTree growth(by);
  for (const double d : {1e38, 1e60}) {
    for (const Flat q : {Flat{0, 0}, Flat{-1e37, 3}, Flat{2, 1e50}}) {
      std::set<std::size_t> seen;
      tree.any_held(growth, q, d, [&](std::size_t i) { return !seen.insert(i).second; });
      EXPECT_EQ(seen.size(), 19U);
      EXPECT_FALSE(seen.contains(7));
    }
  }
}

}  // namespace
}  // namespace dobra::offset
