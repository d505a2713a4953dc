#include "shared/offset/clearance.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dobra::offset {
namespace {

using geom::Point;
using geom::Polyline;

/// Open; its arms come as near to each other as 2 units, and it bends back at its outer end.
Polyline spiral(std::size_t n) {
  Polyline made;
  for (std::size_t i = 0; i < n; ++i) {
    const double t = 4 + 30 * double(i) / double(n - 1);
    const double r = 0.6 * t + 0.4 * std::sin(5 * t);
    made.points.push_back({r * std::cos(t), r * std::sin(t)});
  }
  made.points.push_back(made.points.back() + geom::Vector{1.5, 0});
  made.points.push_back(made.points.back() + geom::Vector{0, -9});
  return made;
}

double least_gap(const BaseCurve& base, std::size_t block, std::size_t other) {
  double least = 1e300;
  const auto last = [&](std::size_t b) { return std::min(base.segment_count(), (b + 1) * Block::size); };
  for (std::size_t i = block * Block::size; i < last(block); ++i) {
    for (std::size_t j = other * Block::size; j < last(other); ++j) {
      const Polyline a{{base.start(i), base.end(i)}};
      const Polyline b{{base.start(j), base.end(j)}};
      for (const Point p : a.points) least = std::min(least, geom::distance(b, p));
      for (const Point p : b.points) least = std::min(least, geom::distance(a, p));
    }
  }
  return least;
}

TEST(Clearance, BlocksAreAloneExactlyWhereNoOtherButTheirNeighboursIsWithinTwoDistances) {
  const auto base = prepare(spiral(700), Side::RightOfTravel);
  ASSERT_TRUE(base.ok());
  OffsetOptions options;
  options.join = Join::Round;
  Clearance clearance(*base, options);
  EXPECT_FALSE(clearance.is_alone(3, 1e-9));  // nobody asked for gaps
  clearance.find_gaps(0.05, 2.0);
  const std::size_t blocks = clearance.blocks().size();
  std::size_t alone = 0;
  std::size_t near = 0;
  for (std::size_t b = 0; b < blocks; ++b) {
    double gap = 1e300;
    for (std::size_t other = 0; other < blocks; ++other) {
      if (other + 1 < b || other > b + 1) gap = std::min(gap, least_gap(*base, b, other));
    }
    for (const double d : {0.05, 0.4, 0.9, 1.1, 1.3, 1.7, 2.0}) {
      EXPECT_EQ(clearance.is_alone(b, d), 2 * d < gap * (1 - 1e-5)) << "block " << b << " D " << d << " gap " << gap;
      (clearance.is_alone(b, d) ? alone : near) += 1;
    }
  }
  EXPECT_GT(alone, 20U);
  EXPECT_GT(near, 20U);
}

TEST(Clearance, NoBlockThatBendsByMoreThanAQuarterTurnNearItselfIsHarmless) {
  // Blocks are straight but for a hairpin in the third one.
  Polyline curve;
  for (int i = 0; i < 40; ++i) curve.points.push_back({double(i), 0.0});
  for (int i = 0; i < 40; ++i) curve.points.push_back({39.0 - i, 1.0 + i});
  const auto base = prepare(curve, Side::RightOfTravel);
  ASSERT_TRUE(base.ok());
  OffsetOptions options;
  options.join = Join::Round;
  Clearance clearance(*base, options);
  clearance.find_gaps(0.25, 1.0);
  EXPECT_TRUE(clearance.is_harmless(0, 1.0));
  EXPECT_FALSE(clearance.is_harmless(2, 0.25));
  EXPECT_TRUE(clearance.is_harmless(4, 1.0));
}

}  // namespace
}  // namespace dobra::offset
