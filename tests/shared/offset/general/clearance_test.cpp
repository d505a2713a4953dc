#include "shared/offset/general/clearance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace dobra::offset::general {
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

TEST(Clearance, BlocksAreAloneWhereNoOtherButTheirNeighboursIsWithinTwoDistances) {
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
      EXPECT_TRUE(clearance.is_alone(b, d) ? 2 * d < gap : 2 * d >= gap * (1 - 2e-3))
          << "block " << b << " D " << d << " gap " << gap;
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

/// Arcs of more than a right angle, and exact ways back, included.
TEST(Clearance, BoxesHoldTheOutlineOfTheirSegmentsOnBothSides) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> coordinate(0, 10);
  Polyline zigzag;
  for (int k = 0; k < 70; ++k) zigzag.points.push_back({coordinate(random), coordinate(random)});
  zigzag.points.insert(zigzag.points.begin() + 30, zigzag.points[28]);
  for (const bool closed : {false, true}) {
    zigzag.closed = closed;
    const auto base = prepare(zigzag, Side::RightOfTravel);
    ASSERT_TRUE(base.ok());
    for (const Join join : {Join::Round, Join::Mitre}) {
      const OffsetOptions options{.join = join};
      const Clearance clearance(*base, options);
      for (const double d : {0.1, 3.0}) {
        const Outline outline(*base, clearance.corners(), Outline::Sides::Both, d);
        const auto held = [&](std::uint32_t step, Flat p) {
          const std::uint32_t segment = outline.segment(step);
          const bool on_left = step >= base->segment_count();
          const FloatBox place(p, p, 0);
          EXPECT_TRUE(clearance.blocks()[segment / Block::size].box(on_left, d, 1e-9).overlaps(place))
              << "step " << step;
          if (!on_left) return;
          const auto leaf = segment / static_cast<std::uint32_t>(Clearance::leaf_size);
          EXPECT_TRUE(clearance.left_box(leaf, d, 1e-9).overlaps(place)) << "step " << step;
        };
        for (std::uint32_t step = 0; step < outline.step_count(); ++step) {
          held(step, outline.start_of({step, SiteKind::Line}));
          held(step, outline.end_of({step, SiteKind::Line}));
          if (outline.corner(step) != CornerKind::Arc || outline.is_cap(step)) continue;
          const Flat from = right_of(outline.along<double>(step));
          const Flat to = right_of(outline.along<double>(outline.after(step)));
          const double turn =
              std::isinf(outline.half_tan(step)) ? std::acos(-1.0) : 2 * std::atan(outline.half_tan(step));
          EXPECT_NEAR(std::cos(turn), dot(from, to), 1e-9);
          for (int k = 0; k <= 32; ++k) {
            const double t = turn * k / 32;
            held(step, outline.centre({step, SiteKind::Arc}) + d * (std::cos(t) * from + std::sin(t) * left_of(from)));
          }
        }
      }
    }
  }
}

TEST(Clearance, FindsAMitreExactlyWhereOneHoldsAPlaceThatNoSegmentIsNear) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> coordinate(0, 10);
  Polyline zigzag;
  for (int k = 0; k < 60; ++k) zigzag.points.push_back({coordinate(random), coordinate(random)});
  const auto base = prepare(zigzag, Side::RightOfTravel);
  ASSERT_TRUE(base.ok());
  const OffsetOptions options{.join = Join::Mitre};
  const Clearance clearance(*base, options);
  std::size_t held = 0;
  std::size_t free = 0;
  std::uniform_real_distribution<double> around(-20, 20);
  for (const double d : {0.1, 0.5, 3.0}) {
    const Outline outline(*base, clearance.corners(), Outline::Sides::Both, d);
    for (int k = 0; k < 20000; ++k) {
      const Flat q{around(random), around(random)};
      if (clearance.find_nearer(q, d) != Clearance::none) continue;
      bool inside = false;
      for (std::uint32_t i = 0; i + 1 < base->segment_count(); ++i) {
        const CornerKind kind = clearance.corners()[i + 1];
        if (kind != CornerKind::Mitre && kind != CornerKind::Tangent) continue;
        const Flat u = flat(base->headings[i]);
        const Flat v = flat(base->headings[i + 1]);
        const Flat to = q - flat(base->points[i + 1]);
        const bool cut = kind == CornerKind::Tangent && dot(to, unit(right_of(u) + right_of(v))) >= d;
        const double h = dot(to, right_of(u));  // behind the segment is not in the convex set of its step
        inside |= dot(to, u) >= 0 && dot(to, v) <= 0 && h > 0 && h < d && dot(to, right_of(v)) < d && !cut;
      }
      EXPECT_EQ(clearance.find_mitre(q, outline, d) != Clearance::none, inside) << q.x << " " << q.y << " D " << d;
      (inside ? held : free) += 1;
    }
  }
  EXPECT_GT(held, 500U);
  EXPECT_GT(free, 500U);
}

}  // namespace
}  // namespace dobra::offset::general
