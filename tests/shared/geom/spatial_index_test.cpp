#include "shared/geom/spatial_index.h"

#include <gtest/gtest.h>

#include <random>

#include "shared/geom/segment.h"

namespace dobra::geom {
namespace {

std::vector<Segment> random_segments(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> place(0.0, 100.0);
  std::uniform_real_distribution<double> reach(-5.0, 5.0);
  std::vector<Segment> segments;
  for (std::size_t i = 0; i < count; ++i) {
    // Rounded to whole numbers now and then, so that boxes touch and are of no width.
    Point from{place(random), place(random)};
    Vector along{reach(random), reach(random)};
    if (i % 3 == 0) {
      from = {std::round(from.x), std::round(from.y)};
      along = {std::round(along.x), 0.0};
    }
    segments.push_back({from, from + along});
  }
  return segments;
}

std::vector<Box> boxes_of(const std::vector<Segment>& segments) {
  std::vector<Box> boxes;
  for (const Segment& segment : segments) boxes.push_back(segment.box());
  return boxes;
}

// Sizes round the fan-out and its powers, where levels begin and end.
class SpatialIndexSizes : public ::testing::TestWithParam<std::size_t> {};

TEST_P(SpatialIndexSizes, OverlapsAgreeWithTryingAll) {
  const auto boxes = boxes_of(random_segments(GetParam(), 1));
  const SpatialIndex index(boxes);
  for (const Segment& segment : random_segments(100, 2)) {
    const Box query = segment.box();
    std::vector<std::size_t> expected;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (boxes[i].overlaps(query)) expected.push_back(i);
    }
    ASSERT_EQ(index.overlapping(query), expected);
  }
}

TEST_P(SpatialIndexSizes, NearestAgreesWithTryingAll) {
  const auto segments = random_segments(GetParam(), 3);
  const SpatialIndex index(boxes_of(segments));
  for (const Segment& segment : random_segments(100, 4)) {
    const Point p = segment.from;
    std::optional<SpatialIndex::Nearest> expected;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      const double away = distance(segments[i], p);
      if (!expected || away < expected->distance) expected = {i, away};
    }
    const auto found = index.nearest(p, [&](std::size_t i) { return distance(segments[i], p); });
    ASSERT_EQ(found.has_value(), expected.has_value());
    if (!found) continue;
    ASSERT_EQ(found->distance, expected->distance);
    ASSERT_EQ(found->item, expected->item);
  }
}

TEST_P(SpatialIndexSizes, PairsAgreeWithTryingAll) {
  const auto boxes = boxes_of(random_segments(GetParam(), 5));
  std::vector<std::pair<std::size_t, std::size_t>> expected;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = i + 1; j < boxes.size(); ++j) {
      if (boxes[i].overlaps(boxes[j])) expected.emplace_back(i, j);
    }
  }
  EXPECT_EQ(SpatialIndex(boxes).overlapping_pairs(), expected);
}

INSTANTIATE_TEST_SUITE_P(Sizes, SpatialIndexSizes, ::testing::Values(0, 1, 2, 7, 8, 9, 63, 64, 65, 500, 1500));

TEST(SpatialIndex, EqualBoxesAreAllFound) {
  const std::vector<Box> boxes(100, Box{{1, 1}, {2, 2}});
  const SpatialIndex index(boxes);
  EXPECT_EQ(index.overlapping({{2, 2}, {3, 3}}).size(), 100U);
  EXPECT_EQ(index.overlapping_pairs().size(), 100U * 99U / 2U);
  EXPECT_EQ(index.nearest({0, 0}, [](std::size_t) { return 1.0; })->item, 0U);
}

TEST(SpatialIndex, EmptyBoxesAreNeverFound) {
  const std::vector<Box> boxes{Box{}, {{0, 0}, {1, 1}}, Box{}};
  const SpatialIndex index(boxes);
  EXPECT_EQ(index.size(), 3U);
  EXPECT_EQ(index.overlapping({{-9, -9}, {9, 9}}), (std::vector<std::size_t>{1}));
  EXPECT_TRUE(index.overlapping_pairs().empty());
  EXPECT_EQ(index.box(), boxes[1]);
  EXPECT_TRUE(SpatialIndex().box().empty());
}

TEST(SpatialIndex, VisitorCanStop) {
  const std::vector<Box> boxes(50, Box{{0, 0}, {1, 1}});
  int calls = 0;
  SpatialIndex(boxes).for_each_overlapping(boxes[0], [&](std::size_t) {
    ++calls;
    return calls == 3 ? Visit::Stop : Visit::Continue;
  });
  EXPECT_EQ(calls, 3);
}

TEST(SpatialIndex, NearestBeyondTheLimitIsNothing) {
  const std::vector<Box> boxes{{{3, 4}, {3, 4}}};
  const SpatialIndex index(boxes);
  const auto away = [](std::size_t) { return 5.0; };
  EXPECT_FALSE(index.nearest({0, 0}, away, 4.9).has_value());
  EXPECT_TRUE(index.nearest({0, 0}, away, 5.0).has_value());
}

TEST(SpatialIndex, FewDistancesAreAskedFor) {
  const auto segments = random_segments(20000, 6);
  const SpatialIndex index(boxes_of(segments));
  std::size_t calls = 0;
  for (int i = 0; i < 100; ++i) {
    const Point p{static_cast<double>(i), static_cast<double>((37 * i) % 100)};
    (void)index.nearest(p, [&](std::size_t item) {
      ++calls;
      return distance(segments[item], p);
    });
  }
  EXPECT_LT(calls, 100U * 100U);  // of 20000 a query
}

}  // namespace
}  // namespace dobra::geom
