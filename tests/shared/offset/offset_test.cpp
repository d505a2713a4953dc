#include "shared/offset/offset.h"
#include "shared/offset/verifier/verify.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <numbers>

#include "shared/offset/stepper/stepper.h"
#include "tests/support/offset_oracle.h"

namespace dobra::offset {
namespace {

using namespace verifier;
using geom::Point;
using geom::Polyline;
using std::numbers::pi;
using stepper::run_stepper;
using stepper::Stepper;

std::vector<OffsetCurve> run(const Polyline& base, const std::vector<double>& d, const OffsetOptions& options = {}) {
  auto result = offset(base, d, options);
  if (!result.ok()) {
    ADD_FAILURE() << result.error().message;
    return std::vector<OffsetCurve>(d.size());
  }
  return std::move(result).value();
}

OffsetCurve run(const Polyline& base, double d, const OffsetOptions& options = {}) {
  return run(base, std::vector<double>{d}, options).front();
}

/// Of a piece that has no arcs.
Polyline line_of(const OffsetPiece& piece) {
  for (const OffsetEdge edge : piece.edges) EXPECT_FALSE(edge.is_arc());
  return {piece.points, piece.closed};
}

double total_length(const OffsetCurve& curve) {
  double sum = 0.0;
  for (const auto& piece : curve.pieces) sum += geom::length(line_of(piece));
  return sum;
}

double total_area(const OffsetCurve& curve) {
  double sum = 0.0;
  for (const auto& piece : curve.pieces) sum += std::abs(geom::signed_area(line_of(piece)));
  return sum;
}

std::size_t total_crossings(const OffsetCurve& curve) {
  std::size_t sum = 0;
  for (const auto& piece : curve.pieces) sum += support::crossings(line_of(piece));
  return sum;
}

void expect_clear(const OffsetCurve& curve, const Polyline& base, double relative) {
  EXPECT_EQ(total_crossings(curve), 0U);
  for (const auto& piece : curve.pieces) {
    EXPECT_GE(support::least_distance(line_of(piece), base), curve.distance * (1.0 - relative))
        << "D " << curve.distance;
    EXPECT_EQ(piece.edges.size(), line_of(piece).segment_count());
    for (const OffsetEdge e : piece.edges) EXPECT_LT(e.base_edge(), base.segment_count());
  }
}

OffsetOptions untreated() {
  OffsetOptions options;
  options.treatment = Treatment::Untreated;
  return options;
}

Polyline sampled(double (*y)(double)) {
  Polyline curve;
  for (int i = 0; i <= 128; ++i) curve.points.push_back({4 * pi * i / 128, y(4 * pi * i / 128)});
  return curve;
}
Polyline c7() {
  return sampled([](double x) { return -std::cos(x); });
}

Polyline e9() {
  Polyline curve{{}, true};
  for (int i = 0; i < 128; ++i)
    curve.points.push_back({4 * std::cos(-2 * pi * i / 128), 2 * std::sin(-2 * pi * i / 128)});
  return curve;
}

OffsetOptions inside(const Polyline& contour) {
  OffsetOptions options;
  options.side = geom::signed_area(contour) > 0 ? Side::LeftOfTravel : Side::RightOfTravel;
  return options;
}

TEST(Offset, OFF_a_SegmentLeftToRightIsOffsetBelow) {
  const OffsetCurve below = run({{{0, 0}, {10, 0}}, false}, 1);
  ASSERT_EQ(below.pieces.size(), 1U);
  EXPECT_EQ(below.pieces[0].points, (std::vector<Point>{{0, -1}, {10, -1}}));
  EXPECT_EQ(below.pieces[0].edges, (std::vector<OffsetEdge>{OffsetEdge::line(0)}));
  const OffsetCurve above = run({{{10, 0}, {0, 0}}, false}, 1);
  EXPECT_EQ(above.pieces.at(0).points, (std::vector<Point>{{10, 1}, {0, 1}}));
  OffsetOptions left;
  left.side = Side::LeftOfTravel;
  EXPECT_EQ(run({{{0, 0}, {10, 0}}, false}, 1, left).pieces.at(0).points, (std::vector<Point>{{0, 1}, {10, 1}}));
}

TEST(Offset, OFF_b_CornerIsMitredOutsideAndCutOnTheBisectorInside) {
  const Polyline corner{{{0, 0}, {4, 0}, {4, 4}}, false};
  const OffsetCurve outer = run(corner, 1);
  EXPECT_EQ(outer.pieces.at(0).points, (std::vector<Point>{{0, -1}, {5, -1}, {5, 4}}));
  EXPECT_NEAR(total_length(outer), 10, 1e-12);
  const OffsetCurve inner = run(geom::reversed(corner), 1);
  EXPECT_EQ(inner.pieces.at(0).points, (std::vector<Point>{{3, 4}, {3, 1}, {0, 1}}));
  EXPECT_NEAR(total_length(inner), 6, 1e-12);
}

TEST(Offset, OFF_c_FigureSevenHasNoSpuriousRegions) {
  const Polyline base = c7();
  const auto d = distances({13, 0.2, 1.0}).value();
  const auto raw = run(base, d, untreated());
  const auto curves = run(base, d);
  for (int k = 1; k <= 13; ++k) {
    EXPECT_EQ(total_crossings(raw[k - 1]), k <= 5 ? 0U : 2U) << k;
    EXPECT_EQ(curves[k - 1].pieces.size(), 1U);
    EXPECT_EQ(curves[k - 1].dropped, 0U);
    expect_clear(curves[k - 1], base, 1e-12);
  }
  const std::vector<std::pair<int, double>> lengths{{1, 15.259248}, {5, 15.180771},  {6, 15.146466},
                                                    {8, 14.946349}, {10, 14.612634}, {13, 14.050437}};
  for (const auto& [k, length] : lengths) EXPECT_NEAR(total_length(curves[k - 1]), length, 1e-5) << k;
}

/// Lengths of what is left of the raw mitred chain on the right of an open base, by two rules: parts between crossings
/// kept as a whole by their middles (a common oracle), and the same cut where the distance to the base is
/// D.
struct RawLengths {
  double by_middles = 0;
  double least_distance = std::numeric_limits<double>::infinity();  ///< Of what the first rule keeps.
  double cut_at_distance = 0;
};
RawLengths raw_lengths(const Polyline& base, double d) {
  const std::size_t n = base.points.size();
  std::vector<Point> raw;
  const auto normal = [&](std::size_t i) {
    return geom::normalised(geom::right_of(base.points[i + 1] - base.points[i]));
  };
  for (std::size_t i = 0; i < n; ++i) {
    const geom::Vector a = normal(i == 0 ? 0 : i - 1);
    const geom::Vector b = normal(i + 1 == n ? n - 2 : i);
    raw.push_back(base.points[i] + (d / (1 + geom::dot(a, b))) * (a + b));
  }
  RawLengths sum;
  for (std::size_t i = 0; i + 1 < n; ++i) {
    std::vector<double> cuts{0, 1};
    for (std::size_t j = 0; j + 1 < n; ++j) {
      const geom::Vector u = raw[i + 1] - raw[i];
      const geom::Vector v = raw[j + 1] - raw[j];
      const double det = geom::cross(u, v);
      if (j + 1 == i || j == i || j == i + 1 || det == 0) continue;
      const double t = geom::cross(raw[j] - raw[i], v) / det;
      const double s = geom::cross(raw[j] - raw[i], u) / det;
      if (t > 0 && t < 1 && s > 0 && s < 1) cuts.push_back(t);
    }
    std::sort(cuts.begin(), cuts.end());
    const auto clear = [&](double t) { return geom::distance(base, geom::interpolate(raw[i], raw[i + 1], t)) - d; };
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
      const double span = geom::distance(raw[i], raw[i + 1]);
      const double slack = 1e-9;
      const bool kept = clear(0.5 * (cuts[k] + cuts[k + 1])) >= -slack;
      if (kept) sum.by_middles += (cuts[k + 1] - cuts[k]) * span;
      // Free on one side of a place that halving finds.
      double low = cuts[k];
      double high = cuts[k + 1];
      if (kept) sum.least_distance = std::min({sum.least_distance, clear(low) + d, clear(high) + d});
      const bool free_low = clear(low) >= -slack;
      const bool free_high = clear(high) >= -slack;
      if (free_low && free_high && kept) sum.cut_at_distance += (high - low) * span;
      if (free_low == free_high) continue;
      for (int step = 0; step < 60; ++step)
        ((clear(0.5 * (low + high)) >= -1e-13) == free_low ? low : high) = 0.5 * (low + high);
      sum.cut_at_distance += (free_low ? low - cuts[k] : cuts[k + 1] - high) * span;
    }
  }
  return sum;
}

TEST(Offset, OFF_d_OpenEndsAreTrimmedByDistance) {
  const Polyline base = sampled([](double x) { return std::sin(x); });
  const auto d = distances({13, 0.2, 1.0}).value();
  const auto curves = run(base, d);
  for (const auto& curve : curves) {
    expect_clear(curve, base, 1e-12);
    EXPECT_EQ(curve.pieces.size(), 1U);
  }
  EXPECT_NEAR(total_length(curves[10]), 14.639779, 1e-5);
  // D = 2.4 and 2.6. The two lengths listed come from a rule that keeps or drops raw edges as a
  // whole (parts, between crossings) by the distance of their middles; its first edge starts nearer to the base than D.
  // Ours is cut exactly where it comes within D of the base's end. Both facts:
  const double listed[] = {14.677773, 14.752139};
  const double exact[] = {14.652309197, 14.705187696};
  for (const std::size_t k : {11U, 12U}) {
    const RawLengths lengths = raw_lengths(base, d[k]);
    EXPECT_NEAR(lengths.by_middles, listed[k - 11], 1e-6);  // the listed number, by the listed rule
    EXPECT_LT(lengths.least_distance, d[k] - 1e-3);         // which does come nearer than D
    EXPECT_NEAR(lengths.cut_at_distance, exact[k - 11], 1e-8);
    EXPECT_NEAR(total_length(curves[k]), lengths.cut_at_distance, 1e-9);
    EXPECT_GE(support::least_distance(line_of(curves[k].pieces.at(0)), base), d[k] * (1 - 1e-12));
    EXPECT_NEAR(geom::distance(curves[k].pieces.at(0).points.front(), base.points.front()), d[k], 1e-12);
  }
  // The paper's region rule alone leaves a tail.
  OffsetOptions paper;
  paper.ends = Ends::Paper;
  const auto tails = run(base, d, paper);
  for (std::size_t k = 0; k < 11; ++k) {  // up to there both rules agree
    ASSERT_EQ(tails[k].pieces.size(), 1U);
    EXPECT_NEAR(total_length(tails[k]), total_length(curves[k]), 1e-9) << k + 1;
    expect_clear(tails[k], base, 1e-12);
  }
  // Beyond, a tail survives; the listed distances are those of the middles of its edges.
  const double tail_distances[] = {1.58, 1.62};
  for (const std::size_t k : {11U, 12U}) {
    const Polyline tail = line_of(tails[k].pieces.at(0));
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < tail.segment_count(); ++i) {
      least = std::min(least, geom::distance(base, geom::interpolate(tail.segment(i).from, tail.segment(i).to, 0.5)));
    }
    EXPECT_NEAR(least, tail_distances[k - 11], 0.005);
    EXPECT_LE(support::least_distance(tail, base), least);
  }
}

TEST(Offset, OFF_e_FigureEight) {
  const Polyline w{{{0, 0}, {1.5, -1.5}, {3, 0}, {4.5, -1.5}, {6, 0}}, false};
  const auto check = [](const std::vector<OffsetCurve>& curves, const std::vector<double>& lengths) {
    for (std::size_t k = 0; k < lengths.size(); ++k) EXPECT_NEAR(total_length(curves[k]), lengths[k], 1e-6) << k;
  };
  const auto a = distances({5, 0.3, 1.0}).value();
  check(run(w, a), {9.085281, 9.685281, 10.285281, 10.885281, 11.485281});
  check(run(w, distances({6, 0.1, 1.3}).value()), {8.685281, 8.945281, 9.283281, 9.722681, 10.293901, 11.036487});
  const std::vector<double> left{7.885281, 7.285281, 6.685281, 6.085281, 5.485281};
  check(run(geom::reversed(w), a), left);
  OffsetOptions other_side;
  other_side.side = Side::LeftOfTravel;
  check(run(w, a, other_side), left);
}

TEST(Offset, OFF_f_FigureNineA) {
  const Polyline base = e9();
  const auto d = distances({7, 0.18, 1.0}).value();
  const std::vector<double> areas{21.736983, 18.554968, 15.576603, 12.801889, 10.230825, 7.863508, 5.705777};
  const auto raw = run(base, d, untreated());
  const auto curves = run(base, d);
  for (std::size_t k = 0; k < 7; ++k) {
    EXPECT_EQ(total_crossings(raw[k]), k < 5 ? 0U : 2U) << k;
    ASSERT_EQ(curves[k].pieces.size(), 1U);
    EXPECT_TRUE(curves[k].pieces[0].closed);
    EXPECT_LT(geom::signed_area(line_of(curves[k].pieces[0])), 0.0);  // oriented like the base
    EXPECT_NEAR(total_area(curves[k]), areas[k], 1e-6);
    expect_clear(curves[k], base, 1e-12);
  }
}

TEST(Offset, OFF_g_FigureNineB) {
  const auto curves = run(e9(), distances({8, 0.05, 1.25}).value());
  const std::vector<double> areas{24.161759, 22.982743, 21.543500, 19.798396,
                                  17.701311, 15.211667, 12.305410, 8.994150};
  for (std::size_t k = 0; k < 8; ++k) {
    EXPECT_NEAR(total_area(curves[k]), areas[k], 1e-6);
    expect_clear(curves[k], e9(), 1e-12);
  }
}

TEST(Offset, OFF_h_SquareInsetBeyondHalfWidthIsEmpty) {
  const Polyline square{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, true};
  const auto curves = run(square, std::vector<double>{1, 2, 3, 4, 5, 6}, inside(square));
  for (int k = 1; k <= 4; ++k) EXPECT_NEAR(total_area(curves[k - 1]), (10 - 2 * k) * (10 - 2 * k), 1e-9);
  EXPECT_TRUE(curves[4].pieces.empty());
  EXPECT_TRUE(curves[5].pieces.empty());
}

TEST(Offset, OFF_i_LShape) {
  const Polyline l{{{0, 0}, {6, 0}, {6, 2}, {2, 2}, {2, 6}, {0, 6}}, true};
  const auto curves = run(l, std::vector<double>{0.25, 0.5, 0.9}, inside(l));
  const double areas[] = {14.25, 9, 1.64};
  const double lengths[] = {22, 20, 16.8};
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(total_area(curves[k]), areas[k], 1e-9);
    EXPECT_NEAR(total_length(curves[k]), lengths[k], 1e-9);
  }
}

TEST(Offset, OFF_j_DumbbellSplitsInTwo) {
  const Polyline bell{
      {{0, 0}, {4, 0}, {4, 1}, {8, 1}, {8, 0}, {12, 0}, {12, 4}, {8, 4}, {8, 3}, {4, 3}, {4, 4}, {0, 4}}, true};
  const auto curves = run(bell, std::vector<double>{0.5, 0.9, 1.2, 1.9, 1.0, 2.0}, inside(bell));
  const std::size_t components[] = {1, 1, 2, 2, 2, 0};  // 1.0: the neck is exactly 2 D wide and counts as closed
  const double areas[] = {23, 10.84, 5.12, 0.08, 8, 0};
  for (int k = 0; k < 6; ++k) {
    EXPECT_EQ(curves[k].pieces.size(), components[k]) << curves[k].distance;
    EXPECT_NEAR(total_area(curves[k]), areas[k], 1e-9);
    expect_clear(curves[k], bell, 1e-12);
  }
  for (const auto& piece : curves[2].pieces) {
    EXPECT_NEAR(geom::signed_area(line_of(piece)), 2.56, 1e-9);
    EXPECT_NEAR(geom::length(line_of(piece)), 6.4, 1e-9);
  }
  for (const auto& piece : curves[3].pieces) EXPECT_NEAR(geom::signed_area(line_of(piece)), 0.04, 1e-9);
}

TEST(Offset, OFF_k_TrenchNarrowerThanTwoDistancesIsBridged) {
  const Polyline trench{{{10, 0}, {6, 0}, {6, -3}, {4, -3}, {4, 0}, {0, 0}}, false};
  EXPECT_NEAR(total_length(run(trench, 1.5, untreated())), 18, 1e-12);
  const OffsetCurve curve = run(trench, 1.5);
  EXPECT_NEAR(total_length(curve), 10, 1e-12);
  ASSERT_EQ(curve.pieces.size(), 1U);
  for (const Point p : curve.pieces[0].points) EXPECT_EQ(p.y, 1.5);
  EXPECT_EQ(curve.pieces[0].points.front().x, 10);  // with the length: straight, nothing twice
  EXPECT_EQ(curve.pieces[0].points.back().x, 0);
}

TEST(Offset, OFF_l_RegularPolygonGrowsByTheApothem) {
  for (const int n : {3, 4, 7, 60, 1000}) {
    Polyline polygon{{}, true};
    for (int i = 0; i < n; ++i) polygon.points.push_back({3 * std::cos(2 * pi * i / n), 3 * std::sin(2 * pi * i / n)});
    const double a = 3 * std::cos(pi / n);
    for (const double d : {0.1, 1.0, 50.0}) {
      EXPECT_NEAR(total_length(run(polygon, d)) / geom::length(polygon), (a + d) / a, 1e-9 * (a + d) / a);
    }
  }
}

TEST(Offset, OFF_m_MovedTurnedAndScaledInputMovesTheOutput) {
  for (const Polyline& base : {e9(), c7()}) {
    const auto reference = run(base, std::vector<double>{0.3, 1.1});
    for (const double scale : {1e-6, 1.0, 1e6}) {
      for (const double turn : {0.0, 0.7, 2.9}) {
        for (const double shift : {0.0, 1e3}) {
          const auto moved = [&](Point p) {
            return Point{scale * (p.x * std::cos(turn) - p.y * std::sin(turn) + shift),
                         scale * (p.x * std::sin(turn) + p.y * std::cos(turn) - 2 * shift)};
          };
          Polyline other{{}, base.closed};
          for (const Point p : base.points) other.points.push_back(moved(p));
          const auto curves = run(other, std::vector<double>{0.3 * scale, 1.1 * scale});
          for (std::size_t k = 0; k < 2; ++k) {
            ASSERT_EQ(curves[k].pieces.size(), 1U);
            const auto& expected = reference[k].pieces.at(0).points;
            const auto& got = curves[k].pieces.at(0).points;
            ASSERT_EQ(got.size(), expected.size());
            for (std::size_t i = 0; i < got.size(); ++i)
              EXPECT_LT(geom::distance(got[i], moved(expected[i])), 1e-9 * scale);
          }
        }
      }
    }
  }
}

TEST(Offset, StartVertexAndDirectionDoNotMatter) {
  const Polyline base = e9();
  const double area = total_area(run(base, 1.2));
  for (std::size_t start = 0; start < base.points.size(); ++start) {
    Polyline turned = base;
    std::rotate(turned.points.begin(), turned.points.begin() + static_cast<std::ptrdiff_t>(start), turned.points.end());
    EXPECT_NEAR(total_area(run(turned, 1.2)), area, 1e-12);
    EXPECT_NEAR(total_area(run(geom::reversed(turned), 1.2, inside(geom::reversed(turned)))), area, 1e-12);
  }
}

TEST(Offset, BadInputIsRefusedWithAPlace) {
  const std::vector<double> d{1.0};
  EXPECT_EQ(offset({{{0, 0}, {1, NAN}}, false}, d).error().code, base::ErrorCode::NotFinite);
  const auto point = offset({{{2, 3}, {2, 3}}, false}, d);
  EXPECT_EQ(point.error().code, base::ErrorCode::DegenerateCurve);
  EXPECT_EQ(point.error().place->y, 3.0);
  EXPECT_EQ(offset({{}, false}, d).error().code, base::ErrorCode::DegenerateCurve);
  EXPECT_EQ(offset({{{0, 0}, {1, 0}}, true}, d).error().code, base::ErrorCode::DegenerateCurve);
  for (const double bad : {0.0, -1.0, std::nan(""), double(INFINITY)}) {
    EXPECT_EQ(offset({{{0, 0}, {1, 0}}, false}, std::vector<double>{bad}).error().code, base::ErrorCode::InvalidOption);
  }
  OffsetOptions options;
  options.mitre_limit = 0.5;
  EXPECT_EQ(offset({{{0, 0}, {1, 0}}, false}, d, options).error().code, base::ErrorCode::InvalidOption);
  const base::CancelToken token;
  token.cancel();
  EXPECT_EQ(offset(e9(), d, {}, base::Progress(token, {})).error().code, base::ErrorCode::Cancelled);
}

TEST(Offset, JoinsHaveTheirClosedForms) {
  const Polyline corner{{{-4, 0}, {0, 0}, {0, 4}}, false};
  OffsetOptions options;
  options.join = Join::Bevel;
  EXPECT_NEAR(total_length(run(corner, 1, options)), 8 + std::sqrt(2.0), 1e-12);
  options.join = Join::Round;
  const OffsetCurve round = run(corner, 1, options);
  EXPECT_EQ(round.pieces.at(0).points, (std::vector<Point>{{-4, -1}, {0, -1}, {1, 0}, {1, 4}}));
  EXPECT_EQ(round.pieces.at(0).edges,
            (std::vector<OffsetEdge>{OffsetEdge::line(0), OffsetEdge::arc(0), OffsetEdge::line(1)}));
  EXPECT_NEAR(length(round.pieces.at(0), corner), 8 + pi / 2, 1e-14);
  EXPECT_NEAR(geom::length(chords(round.pieces.at(0), corner, 1e-7).polyline), 8 + pi / 2, 1e-6);
  const Polyline spike{{{-4, 0}, {0, 0}, {-4, 0.1}}, false};  // turns by nearly 180 degrees
  const double t = std::tan(0.5 * (pi - std::atan2(0.1, 4.0)));
  options.join = Join::Bisector;
  EXPECT_NEAR(total_length(run(spike, 1, options)), 4 + std::hypot(4, 0.1) + 2 * t, 1e-6);
  options.join = Join::Mitre;
  expect_clear(run(spike, 1, options), spike, 1e-12);  // cut across at distance D
  options.beyond_limit = BeyondLimit::ChordBevel;
  const double half = 0.5 * (pi - std::atan2(0.1, 4.0));
  EXPECT_NEAR(total_length(run(spike, 1, options)), 4 + std::hypot(4, 0.1) + 2 * std::sin(half), 1e-9);
}

TEST(Offset, ExtendedEndsReachFurther) {
  OffsetOptions options;
  options.ends = Ends::Extended;
  const OffsetCurve curve = run({{{0, 0}, {10, 0}}, false}, 2, options);
  EXPECT_NEAR(total_length(curve), 14, 1e-12);
  for (const OffsetEdge e : curve.pieces.at(0).edges) EXPECT_EQ(e.base_edge(), 0U);
}

TEST(Offset, RepeatedPointsAndFarOriginsChangeNothing) {
  const Polyline base{{{0, 0}, {0, 0}, {4, 0}, {4, 0}, {4, 0}, {4, 4}, {4, 4}}, false};
  const OffsetCurve curve = run(base, 1);
  EXPECT_EQ(curve.pieces.at(0).points, (std::vector<Point>{{0, -1}, {5, -1}, {5, 4}}));
  EXPECT_EQ(curve.pieces.at(0).edges, (std::vector<OffsetEdge>{OffsetEdge::line(1), OffsetEdge::line(4)}));
}

/// Closed, with corners of all kinds and a neck that closes.
Polyline made_of_eighths() {
  return {
      {{0, 0}, {6, 0.125}, {6.5, 4}, {3.25, 1.25}, {3.125, 3}, {5, 5.5}, {-1, 5}, {2.75, 3}, {2.5, 1.25}, {-0.5, 4.5}},
      true};
}

TEST(Offset, CurvesAtTheEndsOfTheRangeOfSizesAreThoseNearOne) {
  for (const Join join : {Join::Mitre, Join::Bisector, Join::Round, Join::Bevel}) {
    for (const Side side : {Side::RightOfTravel, Side::LeftOfTravel}) {
      for (const bool closed : {true, false}) {
        OffsetOptions options;
        options.join = join;
        options.side = side;
        Polyline base = made_of_eighths();
        base.closed = closed;
        const auto near_one = run(base, {0.25, 0.75}, options);
        for (const int exponent : {-490, -400, -130, -61, 61, 130, 400, 480}) {
          Polyline far = base;
          for (Point& p : far.points) p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
          const auto curves = run(far, {std::ldexp(0.25, exponent), std::ldexp(0.75, exponent)}, options);
          for (std::size_t k = 0; k < 2; ++k) {
            EXPECT_EQ(curves[k].distance, std::ldexp(near_one[k].distance, exponent));
            ASSERT_EQ(curves[k].pieces.size(), near_one[k].pieces.size()) << exponent;
            for (std::size_t i = 0; i < curves[k].pieces.size(); ++i) {
              std::vector<Point> expected = near_one[k].pieces[i].points;
              for (Point& p : expected) p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
              EXPECT_EQ(curves[k].pieces[i].points, expected) << exponent;
              EXPECT_EQ(curves[k].pieces[i].edges, near_one[k].pieces[i].edges) << exponent;
            }
          }
        }
      }
    }
  }
}

TEST(Offset, WhatIsFarBelowTheSizeMovesNothing) {
  for (const Join join : {Join::Mitre, Join::Round}) {
    OffsetOptions options;
    options.join = join;
    const Polyline base = made_of_eighths();
    Polyline moved = base;
    moved.points[0] = {3e-40, -2e-200};
    moved.points.insert(moved.points.begin() + 1,
                        Point{1e-310, 7e-45});  // nearer than the grid: one with the point before
    const auto expected = run(base, 0.5, options);
    const auto got = run(moved, 0.5, options);
    ASSERT_EQ(got.pieces.size(), expected.pieces.size());
    for (std::size_t i = 0; i < got.pieces.size(); ++i) EXPECT_EQ(got.pieces[i].points, expected.pieces[i].points);
  }
}

TEST(Offset, ADistanceOutOfProportionToTheCurveIsRefused) {
  const Polyline base = made_of_eighths();
  for (const double d : {1e-20, 1e20, 1e-300, 1e300}) {
    const auto result = offset(base, std::vector<double>{1.0, d});
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, base::ErrorCode::InvalidOption);
    EXPECT_NE(result.error().message.find("1e18 times"), std::string::npos) << result.error().message;
  }
  for (const double d : {1e-15, 1e15}) EXPECT_TRUE(offset(base, std::vector<double>{d}).ok());
}

TEST(Offset, AnExtensionThatRoundingSwallowsIsNone) {
  const Polyline base{{{-1, 0.3}, {0, 0}, {1e-17, 1e-17}, {0, 3e-17}, {1, -0.7}}, false};
  OffsetOptions extended;
  extended.ends = Ends::Extended;
  const auto with = run(base, 1e-17, extended);
  const auto without = run(base, 1e-17);
  ASSERT_EQ(with.pieces.size(), 1U);
  EXPECT_EQ(with.pieces[0].points, without.pieces[0].points);
}

TEST(Offset, ManyDistancesAtOnceGiveTheCurvesOfEachAlone) {
  Polyline base;  // a spiral whose arms meet at the greater distances
  for (int i = 0; i < 600; ++i) {
    const double t = 4 + 0.04 * i;
    const double r = 0.6 * t + 0.4 * std::sin(5 * t);
    base.points.push_back({r * std::cos(t), r * std::sin(t)});
  }
  const std::vector<double> distances{0.1, 0.4, 0.7, 1.0, 1.3, 1.6, 2.0, 2.4};
  for (const Join join : {Join::Round, Join::Mitre}) {
    for (const Side side : {Side::RightOfTravel, Side::LeftOfTravel}) {
      OffsetOptions options;
      options.join = join;
      options.side = side;
      const auto together = run(base, distances, options);
      for (std::size_t k = 0; k < distances.size(); ++k) {
        const auto alone = run(base, distances[k], options);
        ASSERT_EQ(together[k].pieces.size(), alone.pieces.size()) << distances[k];
        for (std::size_t i = 0; i < alone.pieces.size(); ++i) {
          const OffsetPiece& a = together[k].pieces[i];
          const OffsetPiece& b = alone.pieces[i];
          ASSERT_EQ(a.edges, b.edges) << distances[k];
          for (std::size_t p = 0; p < a.points.size(); ++p) EXPECT_LT(geom::distance(a.points[p], b.points[p]), 1e-12);
        }
      }
    }
  }
}

TEST(Stepper, AgreesWithTheEngineOnOpenAndClosedCurves) {
  for (const Polyline& base : {c7(), e9(), sampled([](double x) { return std::sin(x); })}) {
    for (const double d : {0.2, 0.9, 1.2, 1.3, 2.0}) {
      if (base.closed && d > 1.9) continue;
      const auto stepped = run_stepper(base, d, {});
      ASSERT_TRUE(stepped.ok()) << stepped.error().message;
      const OffsetCurve curve = run(base, d);
      EXPECT_EQ(stepped->pieces.size(), 1U);
      EXPECT_NEAR(total_length(*stepped), total_length(curve), 1e-9) << d;
      EXPECT_EQ(total_crossings(*stepped), 0U);
    }
  }
}

TEST(Stepper, FigureFiveInsertsUntilARegionClosesAndDeletesIt) {
  auto stepper = Stepper::start(c7(), 2.0, {}).value();
  std::size_t regions = 0;
  while (!stepper.done()) {
    const auto step = stepper.step();
    ASSERT_TRUE(step.ok());
    regions += step->deleted.empty() ? 0 : 1;
    EXPECT_EQ(stepper.subdivision().face_count(), 1U);  // no region stays
  }
  EXPECT_EQ(regions, 2U);
}

TEST(Stepper, SplitsADumbbellInTwo) {
  const Polyline bell{
      {{0, 0}, {4, 0}, {4, 1}, {8, 1}, {8, 0}, {12, 0}, {12, 4}, {8, 4}, {8, 3}, {4, 3}, {4, 4}, {0, 4}}, true};
  const auto stepped = run_stepper(bell, 1.2, inside(bell));
  ASSERT_TRUE(stepped.ok());
  EXPECT_EQ(stepped->pieces.size(), 2U);
  EXPECT_NEAR(total_area(*stepped), 5.12, 1e-9);
}

TEST(Offset, BisectorPointsAreWhereTheyShouldUpToTheLimitAndCutAcrossBeyond) {
  OffsetOptions options;
  options.join = Join::Bisector;
  // Back by an angle whose half has the sine 1 / far: the bisector point is D far away, on the axis.
  for (const double far : {2.0, 30.0, 999.0, 1001.0, 1e5, 1e9, 1e12}) {
    const double slope = 1 / std::sqrt(far * far - 1);
    const geom::Polyline base{{{-10, -10 * slope}, {0, 0}, {-10, 10 * slope}}, false};
    const auto made = offset(base, {{0.5}}, options);
    ASSERT_TRUE(made.ok());
    double reach = 0;
    for (const geom::Point p : made->front().pieces.at(0).points) reach = std::max(reach, p.x);
    EXPECT_NEAR(reach, far < bisector_limit ? 0.5 * far : 0.5, 1e-10 * far) << far;
    const auto judged = verify(base, options, made->front());
    ASSERT_TRUE(judged.ok());
    EXPECT_TRUE(judged->ok()) << far << ' ' << (judged->ok() ? "" : to_string(judged->findings[0]));
  }
}

}  // namespace
}  // namespace dobra::offset
