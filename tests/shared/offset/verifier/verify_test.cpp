// The verifier is judged by curves that are wrong on purpose, one of each kind: every check must be seen to fail.

#include "shared/offset/verifier/verify.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "shared/offset/offset.h"

namespace dobra::offset::verifier {
namespace {

using geom::Point;
using geom::Polyline;

OffsetEdge line(std::size_t i) { return OffsetEdge::line(i); }
OffsetEdge arc(std::size_t i) { return OffsetEdge::arc(i); }

OffsetPiece piece(bool closed, std::vector<Point> points, std::vector<OffsetEdge> edges,
                  Side side = Side::RightOfTravel) {
  return {side, closed, std::move(points), std::move(edges)};
}

OffsetOptions with(Join join) {
  OffsetOptions options;
  options.join = join;
  return options;
}

Verification judged(const Polyline& base, const OffsetCurve& curve, const OffsetOptions& options = {}) {
  const auto result = verify(base, options, curve);
  EXPECT_TRUE(result.ok());
  return result.ok() ? *result : Verification{};
}

std::size_t count(const Verification& v, FindingKind kind) {
  return static_cast<std::size_t>(
      std::count_if(v.findings.begin(), v.findings.end(), [&](const Finding& f) { return f.kind == kind; }));
}

testing::AssertionResult clean(const Verification& v) {
  if (v.ok()) return testing::AssertionSuccess();
  auto said = testing::AssertionFailure();
  for (const Finding& f : v.findings) said << to_string(f) << '\n';
  return said;
}

/// Curves written by hand, at distance 1.
const Polyline corner{{{0, 0}, {4, 0}, {4, 4}}, false};  // turns left
OffsetCurve outside() { return {1, {piece(false, {{0, -1}, {5, -1}, {5, 4}}, {line(0), line(1)})}, 0}; }
OffsetCurve inside() {
  return {1, {piece(false, {{0, 1}, {3, 1}, {3, 4}}, {line(0), line(1)}, Side::LeftOfTravel)}, 0};
}
OffsetCurve rounded() { return {1, {piece(false, {{0, -1}, {4, -1}, {5, 0}, {5, 4}}, {line(0), arc(0), line(1)})}, 0}; }
OffsetOptions left() {
  OffsetOptions options;
  options.side = Side::LeftOfTravel;
  return options;
}
const Polyline square{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, true};
OffsetPiece inset(double d) {
  return piece(true, {{d, d}, {10 - d, d}, {10 - d, 10 - d}, {d, 10 - d}}, {line(0), line(1), line(2), line(3)},
               Side::LeftOfTravel);
}

TEST(Verify, RightCurvesHaveNoFindings) {
  EXPECT_TRUE(clean(judged(corner, outside())));
  EXPECT_TRUE(clean(judged(corner, inside(), left())));
  EXPECT_TRUE(clean(judged(corner, rounded(), with(Join::Round))));
  const OffsetCurve bevel{1, {piece(false, {{0, -1}, {4, -1}, {5, 0}, {5, 4}}, {line(0), line(0), line(1)})}, 0};
  EXPECT_TRUE(clean(judged(corner, bevel, with(Join::Bevel))));
  OffsetOptions limited;
  limited.mitre_limit = 1.0;  // cut across at distance D
  const double q = std::tan(std::numbers::pi / 8);
  const OffsetCurve cut{1, {piece(false, {{0, -1}, {4 + q, -1}, {5, -q}, {5, 4}}, {line(0), line(0), line(1)})}, 0};
  EXPECT_TRUE(clean(judged(corner, cut, limited)));
  const OffsetCurve ring{1, {inset(1)}, 0};
  const Verification v = judged(square, ring, left());
  EXPECT_TRUE(clean(v));
  EXPECT_EQ(v.edges, 4U);
  EXPECT_GE(v.samples, 12U);  // it did look for something
  OffsetOptions extended;
  extended.ends = Ends::Extended;
  EXPECT_TRUE(
      clean(judged({{{0, 0}, {10, 0}}, false}, {1, {piece(false, {{-1, -1}, {11, -1}}, {line(0)})}, 0}, extended)));
}

TEST(Verify, EmptyCurvesAreRightOnlyWhereNothingRemains) {
  EXPECT_TRUE(clean(judged(square, {5.5, {}, 0}, left())));
  const Verification v = judged(square, {1, {}, 0}, left());
  EXPECT_GT(count(v, FindingKind::Missing), 10U);
}

TEST(Verify, MovedVertexIsOffItsParallels) {
  OffsetCurve curve = outside();
  curve.pieces[0].points[1].y -= 1e-11;
  const Verification v = judged(corner, curve);
  ASSERT_EQ(count(v, FindingKind::OffParallel), 1U);  // of the first edge only: it slid along the second
  EXPECT_NEAR(v.findings[0].measured, 1e-11, 1e-14);
  EXPECT_NEAR(v.findings[0].allowed, 1e-12, 1e-13);
  curve.pieces[0].points[1].y += 1e-11 - 3e-13;
  EXPECT_TRUE(clean(judged(corner, curve)));
}

TEST(Verify, WrongBaseEdgeIsNamed) {
  OffsetCurve curve = outside();
  curve.pieces[0].edges[1] = line(0);
  EXPECT_EQ(count(judged(corner, curve), FindingKind::OffParallel), 1U);
  OffsetCurve turned = rounded();
  turned.pieces[0].edges[1] = arc(1);  // the end of an open base has no corner
  EXPECT_EQ(count(judged(corner, turned, with(Join::Round)), FindingKind::OffParallel), 1U);
}

TEST(Verify, MitreBeyondItsCornerAndArcWithMitresAreOffTheirRule) {
  OffsetCurve longer = outside();
  longer.pieces[0].points.back().y = 4.5;  // goes on past the end of the base
  EXPECT_EQ(count(judged(corner, longer), FindingKind::OffParallel), 1U);
  EXPECT_EQ(count(judged(corner, rounded(), with(Join::Mitre)), FindingKind::OffParallel), 1U);
  EXPECT_GE(count(judged(corner, outside(), with(Join::Round)), FindingKind::OffParallel), 1U);
}

TEST(Verify, ReversedPieceRunsAgainstItsBase) {
  OffsetCurve curve = outside();
  std::reverse(curve.pieces[0].points.begin(), curve.pieces[0].points.end());
  std::reverse(curve.pieces[0].edges.begin(), curve.pieces[0].edges.end());
  EXPECT_EQ(count(judged(corner, curve), FindingKind::WrongWay), 2U);
}

TEST(Verify, EdgesNearerThanDAreTooNearInTheirMiddlesToo) {
  // The raw parallel inside the corner, not cut on the bisector.
  const OffsetCurve raw{1, {piece(false, {{0, 1}, {4, 1}}, {line(0)}, Side::LeftOfTravel)}, 0};
  EXPECT_EQ(count(judged(corner, raw, left()), FindingKind::TooNear), 1U);
  // A spike that comes near the middle of an edge whose ends are far away.
  const Polyline spike{{{0, 0}, {10, 0}, {10, -8}, {5, -8}, {5, -1.5}, {4.9, -8}, {0, -8}}, false};
  const OffsetCurve below{1, {piece(false, {{0, -1}, {9, -1}}, {line(0)})}, 0};
  EXPECT_EQ(count(judged(spike, below), FindingKind::TooNear), 1U);
  // The same under an arc.
  const Polyline near_arc{{{-4, 0}, {0, 0}, {0, 4}, {9, 4}, {9, -9}, {1, -1}}, false};
  const OffsetCurve bent{1, {piece(false, {{-4, -1}, {0, -1}, {1, 0}, {1, 3}}, {line(0), arc(0), line(1)})}, 0};
  const Verification v = judged(near_arc, bent, with(Join::Round));
  ASSERT_EQ(count(v, FindingKind::TooNear), 1U);
  EXPECT_NEAR(v.findings[0].measured, std::sqrt(2.0) - 1, 1e-15);
}

TEST(Verify, EdgeThroughAnotherCornersMitreIsFound) {
  // The tip of the second corner's mitre reaches down to y = -3 and over the parallel of the first segment, 1 below it.
  const Polyline base{{{-10, 0}, {10, 0}, {10, 20}, {1, 20}, {1.2, 2}, {1.4, 20}}, false};
  const Polyline low{{{-10, -2}, {10, -2}, {10, 20}, {0.4, 20}, {0, 0.2}, {-0.4, 20}}, false};
  OffsetOptions options = with(Join::Bisector);
  options.side = Side::LeftOfTravel;
  // Seen from the left the last corner is an outer one; its mitre reaches far below the base.
  const OffsetCurve curve{1, {piece(false, {{-10, -1}, {9, -1}}, {line(0)}, Side::LeftOfTravel)}, 0};
  EXPECT_EQ(count(judged(low, curve, options), FindingKind::InMitre), 1U);
  EXPECT_EQ(count(judged(low, curve, left()), FindingKind::InMitre), 0U);  // the limit of 4 cuts it off
  EXPECT_EQ(count(judged(base, {1, {piece(false, {{-10, 1}, {9, 1}}, {line(0)}, Side::LeftOfTravel)}, 0}, left()),
                  FindingKind::InMitre),
            0U);
}

TEST(Verify, CrossingsOfLinesAndArcsAreFound) {
  // Untrimmed: the two walls of a narrow trench cross the outer parallels.
  const Polyline trench{{{10, 0}, {6, 0}, {6, -3}, {4, -3}, {4, 0}, {0, 0}}, false};
  const OffsetCurve raw{1.5,
                        {piece(false, {{10, 1.5}, {4.5, 1.5}, {4.5, -1.5}, {5.5, -1.5}, {5.5, 1.5}, {0, 1.5}},
                               {line(0), line(1), line(2), line(3), line(4)})},
                        0};
  const Verification v = judged(trench, raw);
  EXPECT_EQ(count(v, FindingKind::Crossing), 0U);  // they overlap instead
  EXPECT_GE(count(v, FindingKind::Touching), 1U);
  EXPECT_GE(count(v, FindingKind::TooNear), 3U);
  // Two spikes, round: the arcs about their tips cross.
  const Polyline tips{{{0, 5}, {0, 0}, {0.2, 5}, {0.8, 5}, {1, 0}, {1, 5}}, false};
  OffsetOptions options = with(Join::Round);
  const auto result = offset(tips, std::vector<double>{0.3}, options);  // nearer than half their distance: no crossing
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(count(judged(tips, result->front(), options), FindingKind::Crossing), 0U);
  const double n = std::sin(std::atan2(0.2, 5.0));
  const double c = std::cos(std::atan2(0.2, 5.0));
  const OffsetCurve crossed{0.8,
                            {piece(false, {{-0.8, 5}, {-0.8, 0}, {0.8 * c, -0.8 * n}}, {line(0), arc(0)}),
                             piece(false, {{1 - 0.8 * c, -0.8 * n}, {1.8, 0}, {1.8, 5}}, {arc(3), line(4)})},
                            0};
  EXPECT_EQ(count(judged(tips, crossed, options), FindingKind::Crossing), 1U);
}

TEST(Verify, SelfCrossingOfLinesIsFoundExactly) {
  // Closed and crossing itself; the loop that the trimming should have removed is there.
  const Polyline base{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, true};
  OffsetCurve curve{
      1, {piece(true, {{1, 1}, {3, 1}, {3, 3}, {1, 3}}, {line(0), line(1), line(2), line(3)}, Side::LeftOfTravel)}, 0};
  EXPECT_TRUE(clean(judged(base, curve, left())));
  std::swap(curve.pieces[0].points[2], curve.pieces[0].points[3]);
  EXPECT_EQ(count(judged(base, curve, left()), FindingKind::Crossing), 1U);
}

TEST(Verify, SameBoundaryTwiceIsTouching) {
  const OffsetCurve twice{1, {inset(1), inset(1)}, 0};
  EXPECT_GE(count(judged(square, twice, left()), FindingKind::Touching), 4U);
  const OffsetCurve arcs{1, {rounded().pieces[0], piece(false, {{4, -1}, {5, 0}}, {arc(0)})}, 0};
  EXPECT_GE(count(judged(corner, arcs, with(Join::Round)), FindingKind::Touching), 1U);
}

TEST(Verify, SlitExactlyTwoDistancesWideMustBeClosed) {
  const Polyline bell{
      {{0, 0}, {4, 0}, {4, 1}, {8, 1}, {8, 0}, {12, 0}, {12, 4}, {8, 4}, {8, 3}, {4, 3}, {4, 4}, {0, 4}}, true};
  const OffsetCurve open_neck{
      1,
      {piece(true, {{1, 1}, {3, 1}, {3, 2}, {9, 2}, {9, 1}, {11, 1}, {11, 3}, {9, 3}, {9, 2}, {3, 2}, {3, 3}, {1, 3}},
             {line(0), line(1), line(2), line(3), line(4), line(5), line(6), line(7), line(8), line(9), line(10),
              line(11)},
             Side::LeftOfTravel)},
      0};
  EXPECT_GE(count(judged(bell, open_neck, left()), FindingKind::Touching), 1U);
  const OffsetCurve closed_neck{1,
                                {piece(true, {{1, 1}, {3, 1}, {3, 2}, {3, 3}, {1, 3}},
                                       {line(0), line(1), line(9), line(10), line(11)}, Side::LeftOfTravel),
                                 piece(true, {{9, 1}, {11, 1}, {11, 3}, {9, 3}, {9, 2}},
                                       {line(4), line(5), line(6), line(7), line(3)}, Side::LeftOfTravel)},
                                0};
  EXPECT_TRUE(clean(judged(bell, closed_neck, left())));
}

TEST(Verify, OneSideOfAClosedSlitIsFoundAndAnUlpMoreIsRoom) {
  // Both walls of the slit go up, so only one has its parallel in it.
  const double widths[] = {1.0, std::nextafter(1.0, 2.0), std::nextafter(1.0, 0.0)};
  for (const double width : widths) {
    const Polyline walls{{{0, 0}, {0, 8}, {-9, 8}, {-9, -9}, {width, -9}, {width, 8}}, false};
    const OffsetCurve curve{0.5, {piece(false, {{0.5, 0}, {0.5, 8}}, {line(0)})}, 1};
    EXPECT_EQ(count(judged(walls, curve), FindingKind::Touching), width <= 1.0 ? 1U : 0U) << width - 1.0;
  }
  // The same not along an axis, with numbers that are exact: the slit is 5 wide, and an ulp more.
  for (const double more : {0.0, 0x1p-48}) {
    const Polyline slanted{{{0, 0}, {40, 30}, {-90, 90}, {-90, -90}, {3, -4 - more}, {43, 26 - more}}, false};
    const OffsetCurve curve{2.5, {piece(false, {{1.5, -2}, {41.5, 28}}, {line(0)})}, 1};
    EXPECT_EQ(count(judged(slanted, curve), FindingKind::Touching), more > 0 ? 0U : 1U) << more;
  }
}

TEST(Verify, PieceThatStopsShortEndsWhereItShouldGoOn) {
  const OffsetCurve half{1, {piece(false, {{0, -1}, {5, -1}, {5, 2}}, {line(0), line(1)})}, 0};
  const Verification v = judged(corner, half);
  EXPECT_EQ(count(v, FindingKind::OpenEnd), 1U);
  EXPECT_GE(count(v, FindingKind::Missing), 1U);
}

TEST(Verify, MissingPartsAreFoundUnlessPiecesWereDropped) {
  OffsetCurve curve{1, {inset(1)}, 0};
  curve.pieces[0].closed = false;
  curve.pieces[0].edges.pop_back();
  const Verification v = judged(square, curve, left());
  EXPECT_EQ(count(v, FindingKind::Missing), 3U);  // those samples of the last side that are free
  EXPECT_EQ(count(v, FindingKind::OpenEnd), 2U);
  curve.dropped = 1;
  EXPECT_EQ(count(judged(square, curve, left()), FindingKind::Missing), 0U);
  // One of two components.
  const Polyline bell{
      {{0, 0}, {4, 0}, {4, 1}, {8, 1}, {8, 0}, {12, 0}, {12, 4}, {8, 4}, {8, 3}, {4, 3}, {4, 4}, {0, 4}}, true};
  auto both = offset(bell, std::vector<double>{1.2}, left()).value().front();
  EXPECT_TRUE(clean(judged(bell, both, left())));
  both.pieces.pop_back();
  EXPECT_GE(count(judged(bell, both, left()), FindingKind::Missing), 4U);
}

TEST(Verify, MissingArcIsFound) {
  OffsetCurve curve = rounded();
  curve.pieces = {piece(false, {{0, -1}, {4, -1}}, {line(0)}), piece(false, {{5, 0}, {5, 4}}, {line(1)})};
  const Verification v = judged(corner, curve, with(Join::Round));
  EXPECT_EQ(count(v, FindingKind::Missing), 3U);
  EXPECT_EQ(count(v, FindingKind::OpenEnd), 2U);
}

TEST(Verify, WindingTellsAnEdgeInsideAndOneThatPartsNothing) {
  // Inside: the parallel of the first segment, under the second's pill, is inside on both sides.
  const Polyline trench{{{0, 0}, {10, 0}, {10, -1.5}, {0, -1.5}}, false};
  const OffsetCurve curve{1, {piece(false, {{2, -1}, {8, -1}}, {line(0)})}, 0};
  const Verification v = judged(trench, curve);
  EXPECT_EQ(count(v, FindingKind::Winding), 1U);
  EXPECT_GE(count(v, FindingKind::TooNear), 1U);
  for (const Finding& f : v.findings) {
    if (f.kind == FindingKind::Winding) {
      EXPECT_EQ(f.measured, 1);
    }
  }
}

TEST(Verify, MalformedCurvesAreNamed) {
  const auto malformed = [](const OffsetPiece& p) {
    return count(judged(corner, {1, {p}, 0}), FindingKind::Malformed);
  };
  EXPECT_EQ(malformed(piece(false, {{0, -1}, {5, -1}}, {line(0), line(1)})), 1U);
  EXPECT_EQ(malformed(piece(false, {{0, -1}}, {})), 1U);
  EXPECT_EQ(malformed(piece(false, {{0, -1}, {NAN, -1}}, {line(0)})), 1U);
  EXPECT_EQ(malformed(piece(false, {{0, -1}, {0, -1}}, {line(0)})), 1U);
  EXPECT_EQ(malformed(piece(false, {{0, -1}, {4, -1}}, {line(0)}, Side::LeftOfTravel)), 1U);
  EXPECT_EQ(count(judged(corner, {1, {piece(false, {{0, -1}, {4, -1}}, {line(7)})}, 0}), FindingKind::OffParallel), 1U);
}

TEST(Verify, UntreatedCurvesAreJudgedByTheirParallelsOnly) {
  OffsetOptions options = left();
  options.treatment = Treatment::Untreated;
  const Polyline narrow{{{0, 0}, {4, 0}, {4, 1}, {0, 1}}, false};
  auto raw = offset(narrow, std::vector<double>{2.0}, options).value().front();
  EXPECT_TRUE(clean(judged(narrow, raw, options)));
  EXPECT_FALSE(judged(narrow, raw, left()).ok());
  raw.pieces[0].points[1].x += 1e-6;
  EXPECT_EQ(count(judged(narrow, raw, options), FindingKind::OffParallel), 1U);
  // The raw parallel of the middle segment has no length: not malformed there, but in a treated curve.
  const OffsetCurve nothing{
      0.5,
      {piece(false, {{0, 0.5}, {3.5, 0.5}, {3.5, 0.5}, {0, 0.5}}, {line(0), line(1), line(2)}, Side::LeftOfTravel)},
      0};
  EXPECT_TRUE(clean(judged(narrow, nothing, options)));
  EXPECT_EQ(count(judged(narrow, nothing, left()), FindingKind::Malformed), 1U);
}

TEST(Verify, PapersEdgesGoFromCornerToCornerEvenBeyondTheirSegments) {
  const Polyline base{{{0, 0}, {2, -5}, {-12, 0}, {6, -5}, {8, 0}},
                      false};  // the third corner's bisector point lies 28 D away
  for (const Join join : {Join::Mitre, Join::Bisector, Join::Round, Join::Bevel}) {
    OffsetOptions options = with(join);
    options.ends = Ends::Paper;
    const auto made = offset(base, std::vector<double>{1.0}, options);
    ASSERT_TRUE(made.ok());
    EXPECT_TRUE(clean(judged(base, made->front(), options)));
    OffsetCurve moved = made->front();
    moved.pieces[0].points[1].x += 1e-9;
    EXPECT_GT(count(judged(base, moved, options), FindingKind::OffParallel), 0U);
    OffsetCurve renamed = made->front();
    renamed.pieces[0].edges[0] = line(1);
    EXPECT_GT(count(judged(base, renamed, options), FindingKind::OffParallel), 0U);
  }
}

TEST(Verify, FarTipsAreJudgedByTheirOwnRounding) {
  struct Case {
    Polyline base;
    double distance;
  };
  int tips = 0;
  // On a grid of triangles, where rounding turns back corners; and between places whose digits are of very different
  // sizes.
  const double h = std::sqrt(3.0) / 2;
  const Case cases[] = {{{{{6, 2 * h},
                           {0, 0},
                           {4.5, h},
                           {5.5, h},
                           {3, 0},
                           {4, 2 * h},
                           {6.5, 2.598076211353316},
                           {4.5, h},
                           {2.5, 4.3301270189221928},
                           {3, 4 * h},
                           {2, 4 * h},
                           {2, 0},
                           {2, 0},
                           {3, 0}},
                          false},
                         2},
                        {{{{6, 8e-9}, {3, 0.03}, {6, 7e-9}}, true}, 0.75}};
  for (const Case& c : cases) {
    for (const Side side : {Side::RightOfTravel, Side::LeftOfTravel}) {
      OffsetOptions options = with(Join::Mitre);
      options.mitre_limit = 1e18;  // tips as far as they like
      options.side = side;
      const auto made = offset(c.base, std::vector<double>{c.distance}, options);
      ASSERT_TRUE(made.ok());
      EXPECT_TRUE(clean(judged(c.base, made->front(), options)));
      OffsetCurve moved = made->front();
      bool far = false;
      for (OffsetPiece& piece : moved.pieces) {
        for (Point& p : piece.points) {
          if (std::abs(p.x) < 1e6) continue;
          p.x *= 1.001;
          far = true;
        }
      }
      EXPECT_EQ(judged(c.base, moved, options).ok(), !far);
      tips += far;
    }
  }
  EXPECT_EQ(tips, 2);
}

TEST(Verify, BadBasesAndDistancesAreRefused) {
  EXPECT_EQ(verify({{{0, 0}, {NAN, 1}}, false}, {}, {1, {}, 0}).error().code, base::ErrorCode::NotFinite);
  EXPECT_EQ(verify({{{0, 0}, {0, 0}}, false}, {}, {1, {}, 0}).error().code, base::ErrorCode::DegenerateCurve);
  EXPECT_EQ(verify(corner, {}, {0, {}, 0}).error().code, base::ErrorCode::InvalidOption);
}

TEST(Verify, FindingsReadAsASentence) {
  EXPECT_EQ(to_string({FindingKind::TooNear, {1, 2}, 0.5, 1.0, 3, 4}),
            "too near: 0.5 where 1 is allowed, at (1.0, 2.0), piece 3, edge 4");
  EXPECT_EQ(to_string({FindingKind::OpenEnd, {1, 2}, 0, 0, 0, 4}),
            "ends where it should go on, at (1.0, 2.0), piece 0, edge 4");
  EXPECT_EQ(to_string({FindingKind::Missing, {1, 2}, 0.5, 1e-9, 7, 0}),
            "missing: 0.5 where 1e-09 is allowed, at (1.0, 2.0), base segment 7");
}

}  // namespace
}  // namespace dobra::offset::verifier
