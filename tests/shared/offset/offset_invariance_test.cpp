// The same curve whatever the start vertex, the direction, the frame and the unit: of made curves, and of the contours
// of the shared data. Curves are compared as cyclic sequences of points, each within a tolerance; where the frame
// rounds nothing, bit by bit.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "shared/offset/offset.h"
#include "tests/support/corpus.h"
#include "tests/support/offset_oracle.h"
#include "tests/support/random_curves.h"

namespace dobra::offset {
namespace {

using geom::Point;
using geom::Polyline;

struct Case {
  std::string name;
  Polyline base;
  std::vector<double> distances;
};

/// Set down on a grid of about a millionth of its size, so that moving it far away rounds nothing.
Polyline snapped(Polyline base) {
  const double unit = std::exp2(std::ceil(std::log2(base.box().diagonal())) - 20);
  for (Point& p : base.points) p = {std::round(p.x / unit) * unit, std::round(p.y / unit) * unit};
  return geom::without_repeated_points(std::move(base));
}

std::vector<Case> made_cases() {
  std::vector<Case> made;
  const auto add = [&made](std::string name, Polyline base) {
    made.push_back({std::move(name), std::move(base), {0.11, 0.43, 0.87}});
  };
  // Of random_curves.h: stars, closed ones that cross themselves, blobs, walks, spirals.
  for (const std::uint32_t seed : {2U, 19U, 36U, 5U, 22U, 15U, 0U, 17U, 9U}) {
    const Polyline base = support::random_case(seed).base;
    if (base.points.size() <= 150) add("seed " + std::to_string(seed), snapped(base));
  }
  add("dumbbell",
      {{{0, 0}, {4, 0}, {4, 1}, {8, 1}, {8, 0}, {12, 0}, {12, 4}, {8, 4}, {8, 3}, {4, 3}, {4, 4}, {0, 4}}, true});
  add("L", {{{0, 0}, {6, 0}, {6, 2}, {2, 2}, {2, 6}, {0, 6}}, true});
  return made;
}

/// Every contour of the shared data up to 200 points; none where the data are not there.
std::vector<Case> data_cases() {
  std::vector<Case> read;
  const auto folder = test::data_folder();
  if (!folder) return read;
  for (const char* name : {"poly2tri_dude.dat", "poly2tri_tank.dat", "poly2tri_bird.dat", "cdt_kidney.txt",
                           "cdt_island.txt", "cdt_guitar_no_box.txt"}) {
    for (const Polyline& contour : support::read_contours((*folder / "contours" / name).string())) {
      if (contour.points.size() > 200) continue;
      const double size = contour.box().diagonal();
      read.push_back({name, snapped(contour), {0.011 * size, 0.043 * size}});
    }
  }
  return read;
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
  for (std::size_t shift = 0; shift < (closed ? a.size() : 1) && best > 0; ++shift) {
    double worst = 0;
    for (std::size_t i = 0; i < a.size() && worst < best; ++i)
      worst = std::max(worst, geom::distance(a[i], b[(i + shift) % a.size()]));
    best = std::min(best, worst);
  }
  return best;
}

/// True if the pieces are the same but for their order; `map` takes a point of `expected` to one of `got`.
template <class Map>
testing::AssertionResult same(const OffsetCurve& expected, const OffsetCurve& got, double tolerance, bool reversed,
                              Map&& map) {
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
    if (!(least <= tolerance))
      return testing::AssertionFailure() << "a piece of " << points.size() << " points is off by " << least
                                         << ", allowed " << tolerance;
    used[best] = 1;
  }
  return testing::AssertionSuccess();
}
Point identity(Point p) { return p; }

/// One base with its curve: what each check is given.
struct Given {
  const Polyline& base;
  double distance;
  Side side;
  Join join;
  OffsetCurve expected;
  double size;  ///< Of base, distance and curve together, m: tolerances are in it.

  [[nodiscard]] Side other_side() const {
    return side == Side::RightOfTravel ? Side::LeftOfTravel : Side::RightOfTravel;
  }
};
using Check = std::function<void(const Given&)>;

void each(const std::vector<Case>& cases, const std::vector<Join>& joins, const Check& check) {
  for (const Case& c : cases) {
    for (const double distance : c.distances) {
      for (const Side side : {Side::RightOfTravel, Side::LeftOfTravel}) {
        for (const Join join : joins) {
          SCOPED_TRACE(testing::Message()
                       << c.name << " D " << distance << " side " << int(side) << " join " << int(join));
          const OffsetCurve curve = run(c.base, distance, side, join);
          geom::Box all = c.base.box();
          for (const OffsetPiece& piece : curve.pieces) {
            for (const Point p : piece.points) all.add(p);
          }
          check({c.base, distance, side, join, curve, distance + all.diagonal()});
        }
      }
    }
  }
}
const std::vector<Join> all_joins{Join::Mitre, Join::Bisector, Join::Round, Join::Bevel};

/// A check of made curves with all joins, and one of the contours of the data with mitres and arcs.
#define INVARIANCE_TEST(name, check)                                     \
  TEST(OffsetInvariance, name) { each(made_cases(), all_joins, check); } \
  TEST(OffsetInvarianceOfData, name) {                                   \
    const auto cases = data_cases();                                     \
    if (cases.empty()) GTEST_SKIP() << test::no_data;                    \
    EXPECT_GE(cases.size(), 4U);                                         \
    each(cases, {Join::Mitre, Join::Round}, check);                      \
  }

// Tolerances in the size of base, distance and curve: of one frame; of one in which the base is rounded anew (crossings
// at small angles lose digits then).
constexpr double same_frame = 1e-15;
constexpr double rounded_anew = 1e-12;

void every_start(const Given& given) {
  if (!given.base.closed) return;
  const std::size_t step = given.base.points.size() > 80 ? 7 : 1;  // every one of the shorter ones
  for (std::size_t start = 1; start < given.base.points.size(); start += step) {
    Polyline turned = given.base;
    std::rotate(turned.points.begin(), turned.points.begin() + static_cast<std::ptrdiff_t>(start), turned.points.end());
    ASSERT_TRUE(same(given.expected, run(turned, given.distance, given.side, given.join), same_frame * given.size,
                     false, identity))
        << "start " << start;
  }
}
INVARIANCE_TEST(EveryStartVertexGivesTheSameCurve, every_start)

void other_direction(const Given& given) {
  const OffsetCurve got = run(geom::reversed(given.base), given.distance, given.other_side(), given.join);
  EXPECT_TRUE(same(given.expected, got, same_frame * given.size, true, identity));
}
INVARIANCE_TEST(TheOtherDirectionWithTheOtherSideGivesTheSameCurveBackwards, other_direction)

void turned_by_any_angle(const Given& given) {
  for (int k = 1; k <= 12; ++k) {
    const double angle = 0.517 * k;  // all round
    const auto turned = [&](Point p) {
      return Point{std::cos(angle) * p.x - std::sin(angle) * p.y, std::sin(angle) * p.x + std::cos(angle) * p.y};
    };
    // Exact widths of 2 D do not stay exact; the bases have none at these distances.
    Polyline other = given.base;
    for (Point& p : other.points) p = turned(p);
    EXPECT_TRUE(same(given.expected, run(other, given.distance, given.side, given.join), rounded_anew * given.size,
                     false, turned))
        << "angle " << angle;
  }
}
INVARIANCE_TEST(TurnedInputTurnsTheOutput, turned_by_any_angle)

void turned_by_quarters(const Given& given) {
  const auto quarter = [](Point p) { return Point{-p.y, p.x}; };
  Polyline other = given.base;
  for (Point& p : other.points) p = quarter(p);
  EXPECT_TRUE(same(given.expected, run(other, given.distance, given.side, given.join), same_frame * given.size, false,
                   quarter));
}
INVARIANCE_TEST(InputTurnedByAQuarterTurnsTheOutput, turned_by_quarters)

void mirrored(const Given& given) {
  const auto mirror = [](Point p) { return Point{-p.x, p.y}; };
  Polyline other = given.base;
  for (Point& p : other.points) p = mirror(p);
  EXPECT_TRUE(same(given.expected, run(other, given.distance, given.other_side(), given.join), same_frame * given.size,
                   false, mirror));
  // The left side is the mirror image of the right one, to the last bit.
  const auto upside_down = [](Point p) { return Point{p.x, -p.y}; };
  other = given.base;
  for (Point& p : other.points) p = upside_down(p);
  EXPECT_TRUE(same(given.expected, run(other, given.distance, given.other_side(), given.join), 0, false, upside_down));
}
INVARIANCE_TEST(MirroredInputWithTheOtherSideMirrorsTheOutput, mirrored)

void moved_far_away(const Given& given) {
  // By a million extents, exactly: the points lie on a grid of a millionth of their size.
  const double unit = std::exp2(std::ceil(std::log2(given.base.box().diagonal())) - 20);
  const double far = std::round(1e6 * given.base.box().diagonal() / unit) * unit;
  const auto moved = [far](Point p) { return Point{p.x + far, p.y - 2 * far}; };
  Polyline other = given.base;
  for (Point& p : other.points) p = moved(p);
  EXPECT_TRUE(same(given.expected, run(other, given.distance, given.side, given.join), 5e-16 * far, false, moved));
}
INVARIANCE_TEST(InputMovedByAMillionExtentsMovesTheOutput, moved_far_away)

void scaled(const Given& given) {
  for (const double scale : {1e-6, 1e-3, 1e3, 1e6, 0x1p-20, 0x1p20}) {
    const auto larger = [scale](Point p) { return Point{scale * p.x, scale * p.y}; };
    Polyline other = given.base;
    for (Point& p : other.points) p = larger(p);
    const double tolerance =
        std::abs(std::log2(scale)) == 20 ? 0 : rounded_anew * scale * given.size;  // powers of two round nothing
    EXPECT_TRUE(
        same(given.expected, run(other, scale * given.distance, given.side, given.join), tolerance, false, larger))
        << "scale " << scale;
  }
}
INVARIANCE_TEST(ScaledInputScalesTheOutput, scaled)

/// A block with slits of width 3 cut into it from one side, turned so that their widths are rounded.
Polyline slits(int count, double angle) {
  Polyline base{{{0, 0}, {12, 0}}, true};
  for (int i = 0; i < count; ++i) {
    const double low = 3.0 * (2 * i + 1);
    for (const Point p : {Point{12, low}, {3, low}, {3, low + 3}, {12, low + 3}}) base.points.push_back(p);
  }
  const double top = 3.0 * (2 * count + 1);
  base.points.push_back({12, top});
  base.points.push_back({0, top});
  for (Point& p : base.points)
    p = {p.x * std::cos(angle) - p.y * std::sin(angle), p.x * std::sin(angle) + p.y * std::cos(angle)};
  return base;
}

TEST(OffsetInvariance, WhatIsNoWiderThanRoundingIsGoneFromEveryStartAndInBothDirections) {
  const double distance[] = {1.5};
  for (const int count : {1, 2, 3}) {
    for (int turn = 0; turn < 40; ++turn) {
      const Polyline base = slits(count, 0.157 * turn);
      for (const Join join : {Join::Mitre, Join::Bisector, Join::Round, Join::Bevel}) {
        for (const Side side : {Side::RightOfTravel, Side::LeftOfTravel}) {
          OffsetOptions options;
          options.join = join;
          options.side = side;
          const auto pieces_of = [&](const Polyline& from, Side of) {
            options.side = of;
            const auto curves = offset(from, distance, options);
            EXPECT_TRUE(curves.ok());
            return curves ? curves->front().pieces : std::vector<OffsetPiece>{};
          };
          const auto length_of = [&](const std::vector<OffsetPiece>& pieces, const Polyline& from) {
            double sum = 0.0;
            for (const OffsetPiece& piece : pieces) sum += length(piece, from);
            return sum;
          };
          const auto pieces = pieces_of(base, side);
          const double whole = length_of(pieces, base);
          const std::string said = std::to_string(count) + " slits, turn " + std::to_string(turn) + ", join " +
                                   std::to_string(int(join)) + ", side " + std::to_string(int(side));
          const Polyline back = geom::reversed(base);
          const auto other = pieces_of(back, side == Side::RightOfTravel ? Side::LeftOfTravel : Side::RightOfTravel);
          EXPECT_EQ(other.size(), pieces.size()) << said;
          EXPECT_NEAR(length_of(other, back), whole, 1e-9) << said;
          for (std::size_t start = 1; start < base.points.size(); start += 3) {
            Polyline from = base;
            std::rotate(from.points.begin(), from.points.begin() + static_cast<std::ptrdiff_t>(start),
                        from.points.end());
            const auto same = pieces_of(from, side);
            EXPECT_EQ(same.size(), pieces.size()) << said << ", start " << start;
            EXPECT_NEAR(length_of(same, from), whole, 1e-9) << said << ", start " << start;
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace dobra::offset
