// The same curve whatever the start vertex, the direction, the frame and the unit. Curves are compared as cyclic sequences
// of points, each against its tolerance.

#include <gtest/gtest.h>

#include <cmath>

#include "shared/offset/offset.h"
#include "tests/support/random_curves.h"

namespace dobra::offset {
namespace {

using geom::Point;
using geom::Polyline;

/// A point set down on a grid, so that moving it far away rounds nothing.
Point snapped(Point p) { return {std::round(p.x * 0x1p20) / 0x1p20, std::round(p.y * 0x1p20) / 0x1p20}; }

std::vector<Polyline> bases() {
  std::vector<Polyline> made;
  // Of random_curves.h: stars, closed ones that cross themselves, blobs, walks, spirals.
  for (const std::uint32_t seed : {2U, 19U, 36U, 5U, 22U, 15U, 0U, 17U, 9U}) {
    Polyline base = support::random_case(seed).base;
    if (base.points.size() > 150) continue;
    for (Point& p : base.points) p = snapped(p);
    made.push_back(base);
  }
  made.push_back({{{0, 0}, {4, 0}, {4, 1}, {8, 1}, {8, 0}, {12, 0}, {12, 4}, {8, 4}, {8, 3}, {4, 3}, {4, 4}, {0, 4}}, true});
  made.push_back({{{0, 0}, {6, 0}, {6, 2}, {2, 2}, {2, 6}, {0, 6}}, true});
  return made;
}

OffsetCurve run(const Polyline& base, double distance, Side side, Join join) {
  OffsetOptions options;
  options.side = side;
  options.join = join;
  auto result = offset(base, std::vector<double>{distance}, options);
  if (result.ok()) return std::move(result).value().front();
  ADD_FAILURE() << result.error().message;
  return {};
}

/// Greatest distance of the points of two pieces, matched at the best start; infinite if they are not as many.
double apart(const std::vector<Point>& a, const std::vector<Point>& b, bool closed) {
  double best = std::numeric_limits<double>::infinity();
  if (a.size() != b.size()) return best;
  for (std::size_t shift = 0; shift < (closed ? a.size() : 1); ++shift) {
    double worst = 0;
    for (std::size_t i = 0; i < a.size() && worst < best; ++i) worst = std::max(worst, geom::distance(a[i], b[(i + shift) % a.size()]));
    best = std::min(best, worst);
  }
  return best;
}

/// True if the pieces are the same but for their order; `map` takes a point of `expected` to one of `got`.
template <class Map>
testing::AssertionResult same(const OffsetCurve& expected, const OffsetCurve& got, double tolerance, bool reversed, Map&& map) {
  if (expected.pieces.size() != got.pieces.size() || expected.dropped != got.dropped) {
    return testing::AssertionFailure() << got.pieces.size() << " pieces, not " << expected.pieces.size();
  }
  std::vector<char> used(got.pieces.size(), 0);
  for (const OffsetPiece& piece : expected.pieces) {
    std::vector<Point> points;
    for (const Point p : piece.points) points.push_back(map(p));
    if (reversed) std::reverse(points.begin(), points.end());
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < got.pieces.size(); ++k) {
      if (used[k] || got.pieces[k].closed != piece.closed) continue;
      const double d = apart(points, got.pieces[k].points, piece.closed);
      if (d < least) best = k;
      least = std::min(least, d);
    }
    if (!(least <= tolerance)) return testing::AssertionFailure() << "a piece of " << points.size() << " points is off by " << least;
    used[best] = 1;
  }
  return testing::AssertionSuccess();
}
Point identity(Point p) { return p; }

template <class Visit>
void each_case(Visit&& visit) {
  const auto all = bases();
  for (std::size_t k = 0; k < all.size(); ++k) {
    for (const double distance : {0.11, 0.43, 0.87}) {
      for (const Side side : {Side::RightOfTravel, Side::LeftOfTravel}) {
        for (const Join join : {Join::Mitre, Join::Round}) {
          SCOPED_TRACE(testing::Message() << "base " << k << " D " << distance << " side " << int(side) << " join " << int(join));
          visit(all[k], distance, side, join, run(all[k], distance, side, join));
        }
      }
    }
  }
}

/// Of the places of one curve computed twice in one frame: crossings at small angles lose digits.
constexpr double same_frame = 1e-11;

TEST(OffsetInvariance, EveryStartVertexGivesTheSameCurve) {
  each_case([](const Polyline& base, double d, Side side, Join join, const OffsetCurve& expected) {
    if (!base.closed) return;
    for (std::size_t start = 1; start < base.points.size(); ++start) {
      Polyline turned = base;
      std::rotate(turned.points.begin(), turned.points.begin() + static_cast<std::ptrdiff_t>(start), turned.points.end());
      ASSERT_TRUE(same(expected, run(turned, d, side, join), same_frame, false, identity)) << "start " << start;
    }
  });
}

TEST(OffsetInvariance, TheOtherDirectionWithTheOtherSideGivesTheSameCurveBackwards) {
  each_case([](const Polyline& base, double d, Side side, Join join, const OffsetCurve& expected) {
    const Side other = side == Side::RightOfTravel ? Side::LeftOfTravel : Side::RightOfTravel;
    EXPECT_TRUE(same(expected, run(geom::reversed(base), d, other, join), same_frame, true, identity));
  });
}

TEST(OffsetInvariance, TurnedInputTurnsTheOutput) {
  each_case([](const Polyline& base, double d, Side side, Join join, const OffsetCurve& expected) {
    for (const double angle : {0.5, 1.0, 2.0, 3.0}) {
      const auto turned = [&](Point p) {
        return Point{std::cos(angle) * p.x - std::sin(angle) * p.y, std::sin(angle) * p.x + std::cos(angle) * p.y};
      };
      // Exact widths of 2 D do not stay exact; the bases have none at these distances.
      Polyline other = base;
      for (Point& p : other.points) p = turned(p);
      EXPECT_TRUE(same(expected, run(other, d, side, join), 1e-10, false, turned)) << "angle " << angle;
    }
  });
}

TEST(OffsetInvariance, MirroredInputWithTheOtherSideMirrorsTheOutput) {
  each_case([](const Polyline& base, double d, Side side, Join join, const OffsetCurve& expected) {
    const auto mirrored = [](Point p) { return Point{-p.x, p.y}; };
    Polyline other = base;
    for (Point& p : other.points) p = mirrored(p);
    const Side opposite = side == Side::RightOfTravel ? Side::LeftOfTravel : Side::RightOfTravel;
    EXPECT_TRUE(same(expected, run(other, d, opposite, join), same_frame, false, mirrored));
  });
}

TEST(OffsetInvariance, InputMovedByAMillionExtentsMovesTheOutput) {
  each_case([](const Polyline& base, double d, Side side, Join join, const OffsetCurve& expected) {
    // Exact: the points lie on a grid of 2^-20 and extents are below 2^7.
    const double far = std::round(1e6 * base.box().diagonal());
    const auto moved = [far](Point p) { return Point{p.x + far, p.y - 2 * far}; };
    Polyline other = base;
    for (Point& p : other.points) p = moved(p);
    EXPECT_TRUE(same(expected, run(other, d, side, join), 1e-15 * far, false, moved));  // coordinates are rounded there
  });
}

TEST(OffsetInvariance, ScaledInputScalesTheOutput) {
  each_case([](const Polyline& base, double d, Side side, Join join, const OffsetCurve& expected) {
    for (const double scale : {1e-6, 1e-3, 1e3, 1e6}) {
      const auto scaled = [scale](Point p) { return Point{scale * p.x, scale * p.y}; };
      Polyline other = base;
      for (Point& p : other.points) p = scaled(p);
      EXPECT_TRUE(same(expected, run(other, scale * d, side, join), 1e-10 * scale, false, scaled)) << "scale " << scale;
    }
  });
}

}  // namespace
}  // namespace dobra::offset
