#include "shared/offset/monotone/envelope.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <random>
#include <string>

#include "shared/offset/general/sections.h"
#include "shared/offset/offset.h"
#include "shared/offset/verifier/verify.h"
#include "tests/support/offset_oracle.h"

#ifndef DOBRA_RANDOM_GRAPHS
#define DOBRA_RANDOM_GRAPHS 1500  // in the suite; 20 000 were run without sanitizers
#endif

namespace dobra::offset::monotone {
namespace {

using std::abs;  // beside that of DoubleDouble

using namespace verifier;
using namespace general;
using geom::Point;
using geom::Polyline;

void rotate(Polyline& graph, double a) {
  for (Point& p : graph.points) p = {p.x * std::cos(a) - p.y * std::sin(a), p.x * std::sin(a) + p.y * std::cos(a)};
}

/// A random graph over an axis of any direction: noise, short steps, steep ones, small integers, which give exact
/// coincidences, dense waves, and rough ones.
Polyline random_graph(std::uint32_t seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> real(0.0, 1.0);
  Polyline graph;
  const std::size_t count = 3 + random() % 40;
  const double steep = std::pow(10.0, -3 * real(random));
  const double wave = 0.5 + 3 * real(random);
  double x = 0.0;
  double y = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto step = static_cast<double>(i);
    switch (seed % 6) {
      case 0:
        graph.points.push_back({0.3 * step, normal(random)});
        break;
      case 1:
        graph.points.push_back({x += 0.01 + std::pow(real(random), 3), normal(random)});
        break;
      case 2:
        graph.points.push_back({step, static_cast<double>(random() % 5)});
        break;
      case 3:
        graph.points.push_back({x += steep * real(random) + 1e-6, normal(random)});
        break;
      case 4:
        graph.points.push_back({0.1 * step, std::sin(wave * 0.1 * step + wave)});
        break;
      default:
        graph.points.push_back({x += 0.05 * real(random) + 1e-9, y += 0.1 * normal(random)});
        break;
    }
  }
  if (random() % 2 == 1) rotate(graph, 2 * std::numbers::pi * real(random));
  return graph;
}

/// From small against the steps to large against the whole graph.
double random_distance(std::uint32_t seed) {
  std::mt19937 random(seed + 7'000'000);
  return std::pow(10.0, std::uniform_real_distribution<double>(-2.0, 1.5)(random));
}

struct Filled {
  const char* name;
  Join join;
  double limit;
  BeyondLimit beyond;
};
constexpr Filled all_joins[] = {
    {"round", Join::Round, 4.0, BeyondLimit::TangentBevel},
    {"bevel", Join::Bevel, 4.0, BeyondLimit::TangentBevel},
    {"mitre", Join::Mitre, 4.0, BeyondLimit::TangentBevel},
    {"chord", Join::Mitre, 1.5, BeyondLimit::ChordBevel},
    {"short", Join::Mitre, 1.1, BeyondLimit::TangentBevel},
    {"bisector", Join::Bisector, bisector_limit, BeyondLimit::TangentBevel},
};
OffsetOptions options_of(const Filled& fill) {
  OffsetOptions options;
  options.join = fill.join;
  options.mitre_limit = fill.limit;
  options.beyond_limit = fill.beyond;
  return options;
}

/// U by definition, in 64-bit mantissas, shares nothing with the engine: the stadia and, as polygons, the mitres.
class Region {
 public:
  Region(const Polyline& base, double distance, const Filled& fill) : d_(distance) {
    for (const Point p : base.points) points_.push_back({p.x, p.y});
    for (std::size_t i = 1; i + 1 < points_.size(); ++i) add_quad(i, fill);
  }

  /// How far p is inside U (below 0: outside, as far from the nearest of its parts).
  [[nodiscard]] Real depth(Vec p) const {
    Real most = -std::numeric_limits<Real>::infinity();
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) most = std::max(most, d_ - to_segment(p, i));
    for (const auto& quad : quads_) {
      Real in = std::numeric_limits<Real>::infinity();
      for (std::size_t k = 0; k < quad.size(); ++k) {
        const Vec a = quad[k];
        const Vec along = quad[(k + 1) % quad.size()] - a;
        in = std::min(in, cross(along, p - a) / length(along));
      }
      most = std::max(most, in);
    }
    return most;
  }

  enum class Owner { Chosen, Cap, Chord, None };
  struct Column {
    Vec point;
    Owner owner = Owner::None;
  };
  /// The lowest point of U on the line x = `x` along the axis `forward`.
  [[nodiscard]] Column lowest(Vec forward, Real x) const {
    const Vec up = left_of(forward);
    Real y = std::numeric_limits<Real>::infinity();
    Owner owner = Owner::None;
    const auto lower = [&](Real at, Owner of) {
      if (at < y) {
        y = at;
        owner = of;
      }
    };
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Real off = x - dot(points_[i], forward);
      if (!(abs(off) < d_)) continue;
      const Real at = dot(points_[i], up) - root(Real(d_ * d_ - off * off));
      const Vec to = x * forward + at * up - points_[i];
      const bool first = i == 0 && dot(to, points_[1] - points_[0]) <= 0;
      const bool last = i + 1 == points_.size() && dot(to, points_[i] - points_[i - 1]) >= 0;
      lower(at, first || last ? Owner::Cap : chord_[i] ? Owner::Chord : Owner::Chosen);
    }
    const auto line = [&](Vec a, Vec b) {
      const Real ax = dot(a, forward);
      const Real bx = dot(b, forward);
      if (!(ax <= x && x <= bx && ax < bx)) return;
      lower(dot(a, up) + (dot(b, up) - dot(a, up)) * ((x - ax) / (bx - ax)), Owner::Chosen);
    };
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
      const Vec out = d_ * right_of(unit(points_[i + 1] - points_[i]));
      line(points_[i] + out, points_[i + 1] + out);
    }
    for (const auto& quad : quads_) {
      for (std::size_t k = 1; k + 1 < quad.size(); ++k) line(quad[k], quad[k + 1]);
    }
    return {x * forward + y * up, owner};
  }

 private:
  void add_quad(std::size_t i, const Filled& fill) {
    chord_.resize(points_.size(), false);
    const Vec u = unit(points_[i] - points_[i - 1]);
    const Vec v = unit(points_[i + 1] - points_[i]);
    if (!(cross(u, v) > 0)) return;
    chord_[i] = fill.join == Join::Bevel;
    if (fill.join == Join::Round || fill.join == Join::Bevel) return;
    const Vec p = points_[i];
    const Real t = dot(u, v) > 0 ? cross(u, v) / (1 + dot(u, v)) : (1 - dot(u, v)) / cross(u, v);
    const Vec first = p + d_ * right_of(u);
    const Vec second = p + d_ * right_of(v);
    if (1 + t * t <= fill.limit * fill.limit) {
      quads_.push_back({p, first, first + (d_ * t) * u, second});
    } else if (fill.beyond == BeyondLimit::TangentBevel) {
      const Real q = t / (1 + root(Real(1 + t * t)));
      quads_.push_back({p, first, first + (d_ * q) * u, second - (d_ * q) * v, second});
    } else {
      chord_[i] = true;
    }
  }
  [[nodiscard]] Real to_segment(Vec p, std::size_t i) const {
    const Vec along = points_[i + 1] - points_[i];
    const Real t = std::clamp<Real>(dot(p - points_[i], along) / dot(along, along), 0, 1);
    return length(p - points_[i] - t * along);
  }

  Real d_;
  std::vector<Vec> points_;
  std::vector<std::vector<Vec>> quads_;
  std::vector<bool> chord_;  // for each point: its corner is drawn with a chord
};

Vec exact(Point p) { return {p.x, p.y}; }

/// Greatest error of the curve against U; the places come in as a message.
class Judge {
 public:
  Judge(const Polyline& graph, double d, const Filled& fill)
      : graph_(graph), d_(d), fill_(fill), region_(graph, d, fill), base_(prepare(graph, Side::RightOfTravel).value()) {
    forward_ = monotone_direction(base_);
  }
  [[nodiscard]] bool monotone() const { return forward_.has_value(); }
  [[nodiscard]] std::vector<OffsetPiece> curves() const {
    StadiaLeft left = all_stadia(base_);
    return monotone_offset(base_, *forward_, d_, options_of(fill_), left);
  }
  /// What rounding of the coordinates allows, and a part in 1e12 of D.
  [[nodiscard]] double tolerance(Point p) const {
    return 1e-12 * d_ + 1e-15 * std::max({base_.size, std::abs(p.x), std::abs(p.y)});
  }

  void vertices_are_on_the_boundary(const OffsetPiece& piece) const {
    for (const Point p : piece.points) {
      EXPECT_NEAR(static_cast<double>(region_.depth(exact(p))), 0.0, tolerance(p)) << "at " << p;
    }
  }
  /// In the middle of edges, where no chord is drawn.
  void edges_are_on_the_boundary(const OffsetPiece& piece) const {
    for (std::size_t k = 0; k < piece.edges.size(); ++k) {
      const Point a = piece.points[k];
      const Point b = piece.points[k + 1];
      if (!piece.edges[k].is_arc() && is_chord(piece.edges[k], a, b)) continue;
      Vec middle = 0.5L * (exact(a) + exact(b));
      if (piece.edges[k].is_arc()) {
        const Vec c = exact(graph_.points[piece.edges[k].base_edge() + 1]);
        middle = c + d_ * unit((exact(a) - c) + (exact(b) - c));  // less than half a turn
      }
      EXPECT_NEAR(static_cast<double>(region_.depth(middle)), 0.0, std::max(tolerance(a), tolerance(b)))
          << "between " << a << " and " << b;
    }
  }
  void columns_are_covered(const std::vector<OffsetPiece>& pieces, int count) const {
    const Vec f = exact(Point{forward_->x, forward_->y});
    const Real low = dot(exact(graph_.points.front()), f) - d_;
    const Real high = dot(exact(graph_.points.back()), f) + d_;
    for (int k = 0; k < count; ++k) {
      const Region::Column column = region_.lowest(f, low + (high - low) * Real(k + 0.5) / Real(count));
      if (column.owner != Region::Owner::Chosen) continue;
      Real least = std::numeric_limits<Real>::infinity();
      for (const OffsetPiece& piece : pieces) least = std::min(least, distance_to(piece, column.point));
      EXPECT_LE(static_cast<double>(least), 1e3 * tolerance(rounded(column.point))) << "at " << rounded(column.point);
    }
  }
  void goes_forward(const OffsetPiece& piece) const {
    for (std::size_t k = 0; k + 1 < piece.points.size(); ++k) {
      const Point p = piece.points[k];
      EXPECT_GE(geom::dot(piece.points[k + 1] - p, *forward_), -tolerance(p)) << "at " << p;
    }
  }

 private:
  [[nodiscard]] bool is_chord(OffsetEdge edge, Point a, Point b) const {
    const bool may =
        fill_.join == Join::Bevel || (fill_.join == Join::Mitre && fill_.beyond == BeyondLimit::ChordBevel);
    const Point start = graph_.points[edge.base_edge()];
    const geom::Vector n = geom::right_of(geom::normalised(graph_.points[edge.base_edge() + 1] - start));
    return may && std::max(std::abs(geom::dot(a - start, n) - d_), std::abs(geom::dot(b - start, n) - d_)) >
                      1e-14 * (d_ + base_.size);
  }
  [[nodiscard]] Real distance_to(const OffsetPiece& piece, Vec p) const {
    Real least = std::numeric_limits<Real>::infinity();
    for (std::size_t k = 0; k < piece.edges.size(); ++k) {
      const Vec a = exact(piece.points[k]);
      const Vec b = exact(piece.points[k + 1]);
      const Real t = std::clamp<Real>(dot(p - a, b - a) / dot(b - a, b - a), 0, 1);
      least = std::min(least, length(p - a - t * (b - a)));
      if (!piece.edges[k].is_arc()) continue;
      const Vec c = exact(graph_.points[piece.edges[k].base_edge() + 1]);
      if (cross(a - c, p - c) >= 0 && cross(p - c, b - c) >= 0) least = std::min(least, abs(Real(length(p - c) - d_)));
    }
    return least;
  }

  const Polyline& graph_;
  double d_;
  Filled fill_;
  Region region_;
  BaseCurve base_;
  std::optional<geom::Vector> forward_;
};

TEST(Envelope, OnlyCurvesThatNeverTurnBackAreMonotone) {
  const auto direction = [](const Polyline& curve) {
    return monotone_direction(prepare(curve, Side::RightOfTravel).value());
  };
  EXPECT_TRUE(direction({{{0, 0}, {1, 5}, {2, -5}}, false}));
  EXPECT_TRUE(direction({{{0, 0}, {0, 1}, {-3, 1.5}, {1, 2}}, false}));
  EXPECT_FALSE(direction({{{0, 0}, {1, 0}, {0, 0}}, false}));
  EXPECT_FALSE(direction({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, false}));
  EXPECT_FALSE(direction({{{0, 0}, {1, 0}, {0, 1}, {-1, -1}, {2, -1}}, false}));
  EXPECT_FALSE(direction({{{0, 0}, {4, 0}, {2, 3}}, true}));
}

TEST(Envelope, IsTheLowerBoundaryOfPillsAndMitresOnRandomGraphs) {
  std::size_t judged = 0;
  for (std::uint32_t seed = 0; seed < DOBRA_RANDOM_GRAPHS && !HasFailure(); ++seed) {
    const Polyline graph = random_graph(seed);
    const double d = random_distance(seed);
    for (const Filled& fill : all_joins) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ' ' << fill.name << " d " << d);
      const Judge judge(graph, d, fill);
      if (!judge.monotone()) continue;
      const auto pieces = judge.curves();
      for (const OffsetPiece& piece : pieces) {
        ASSERT_EQ(piece.points.size(), piece.edges.size() + 1);
        judge.vertices_are_on_the_boundary(piece);
        judge.edges_are_on_the_boundary(piece);
        judge.goes_forward(piece);
        Polyline drawn = chords(piece, graph, 1e-2).polyline;
        EXPECT_EQ(support::crossings(drawn), 0U);
      }
      judge.columns_are_covered(pieces, 40);
      ++judged;
    }
  }
  EXPECT_GT(judged, 5U * DOBRA_RANDOM_GRAPHS);
}

/// A graph and a distance that make stadia touch exactly, in many places: few slopes, whole lengths, half distances.
struct Ties {
  Polyline graph{};
  double distance = 1;
};
Ties random_ties(std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto whole = [&](int from, int to) {
    return from + static_cast<int>(random() % static_cast<std::uint32_t>(to - from + 1));
  };
  Ties made;
  Point at{0, 0};
  const auto step = [&](double x, double y) { made.graph.points.push_back(at = at + geom::Vector{x, y}); };
  const int count = whole(4, 40);
  const double width = 0.25 * whole(1, 8);
  const double height = 0.5 * whole(1, 10);
  made.distance = 0.5 * whole(1, 12);
  for (int i = 0; i < count; ++i) {
    switch (seed % 6) {
      case 0:
        i % 2 == 0 ? step(whole(0, 3), 0) : step(0, whole(0, 3));
        break;  // stairs, with repeated places
      case 1:
        step(1, whole(0, 4) - at.y);
        break;
      case 2:
        step(0.5 * whole(1, 3), whole(-2, 2)), step(0.5 * whole(1, 6), 0);
        break;  // plateaus
      case 3:
        step(width, height), step(width, -height);
        break;  // teeth
      case 4:
        step(whole(0, 1) == 0 ? 3 : 4, 4), step(whole(1, 3), 0), step(3, -4);
        break;
      default:
        step(whole(0, 8) == 0 ? 1 : 0.125 * whole(1, 2), whole(-6, 6));
        break;  // sharp
    }
  }
  return made;
}

std::string faults(const Polyline& graph, const OffsetOptions& options, const OffsetCurve& curve) {
  std::string found;
  const auto verified = verify(graph, options, curve);
  for (const Finding& finding : verified.value().findings) found += to_string(finding) + "; ";
  return found;
}

TEST(Envelope, LeavesNoEdgesThatOnlyRoundingMadeWherePillsTouch) {
  std::size_t judged = 0;
  for (std::uint32_t seed = 0; seed < DOBRA_RANDOM_GRAPHS / 6 && !HasFailure(); ++seed) {
    const Ties ties = random_ties(seed);
    const auto base = prepare(ties.graph, Side::RightOfTravel);
    if (!base.ok() || !monotone_direction(*base)) continue;
    for (const Filled& fill : all_joins) {
      OffsetOptions options = options_of(fill);
      options.side = seed % 4 < 2 ? Side::RightOfTravel : Side::LeftOfTravel;
      SCOPED_TRACE(testing::Message() << "seed " << seed << ' ' << fill.name << " D " << ties.distance);
      const auto curve = offset(ties.graph, std::vector<double>{ties.distance}, options).value().front();
      for (const OffsetPiece& piece : curve.pieces) {
        for (std::size_t k = 0; k < piece.edges.size(); ++k) {
          EXPECT_GT(geom::distance(piece.points[k], piece.points[k + 1]), 1e-6 * ties.distance)
              << "at " << piece.points[k];
        }
      }
      EXPECT_EQ(faults(ties.graph, options, curve), "");
      ++judged;
    }
  }
  EXPECT_GT(judged, DOBRA_RANDOM_GRAPHS / 2U);
}

TEST(Envelope, BasesThatAreLengthenedGoStraightOn) {
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    const Polyline graph = random_graph(seed);
    if (!geom::validate(graph).ok()) continue;
    OffsetOptions options;
    options.join = Join::Round;
    options.ends = Ends::Extended;
    const auto curve = offset(graph, std::vector<double>{0.3}, options).value().front();
    EXPECT_EQ(faults(graph, options, curve), "") << "seed " << seed;
  }
}

/// A mitre too flat to be seen stands lowest in its stretch of the curve: those beside it are still looked at.
TEST(Envelope, MitresBesideOnesWithoutWidthAreKept) {
  // The corner at 27.8 is of rounding only.
  const Polyline graph{{{15, 8.8817841970012523e-16},
                        {25, 0},
                        {23.6, 4.8000000000000007},
                        {28.6, 4.8000000000000007},
                        {32.200000000000003, 9.6000000000000014},
                        {28, 24},
                        {26.599999999999998, 28.800000000000004},
                        {27.799999999999997, 30.400000000000006},
                        {31.4, 35.2},
                        {32.6, 36.800000000000004},
                        {31.2, 41.6},
                        {27, 56}},
                       false};
  OffsetOptions options;
  options.side = Side::LeftOfTravel;
  const auto curve = offset(graph, std::vector<double>{4.5}, options).value().front();
  EXPECT_EQ(faults(graph, options, curve), "");
}

/// Rough at all scales, as by midpoint displacement: most mitres are hidden by others.
Polyline rough_graph(std::uint32_t seed, std::size_t halvings) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const double falls = std::exp2(-0.2 - 0.1 * static_cast<double>(seed % 9));
  std::vector<double> y(2, 0.0);
  double size = 6;
  for (std::size_t k = 0; k < halvings; ++k, size *= falls) {
    std::vector<double> finer;
    for (std::size_t i = 0; i + 1 < y.size(); ++i) {
      finer.push_back(y[i]);
      finer.push_back(0.5 * (y[i] + y[i + 1]) + size * normal(random));
    }
    finer.push_back(y.back());
    y = std::move(finer);
  }
  Polyline graph;
  for (std::size_t i = 0; i < y.size(); ++i) {
    graph.points.push_back({100.0 * static_cast<double>(i) / static_cast<double>(y.size() - 1), y[i]});
  }
  return graph;
}

TEST(Envelope, OfRoughGraphsLeavesOutOnlyMitresThatOthersHide) {
  for (std::uint32_t seed = 0; seed < 9; ++seed) {
    const Polyline graph = rough_graph(seed, 8);
    for (const Filled& fill : all_joins) {
      if (fill.join == Join::Round || fill.join == Join::Bevel) continue;
      const OffsetOptions options = options_of(fill);
      const std::vector<double> distances{0.1, 0.7, 4.0, 150.0};
      const auto curves = offset(graph, distances, options);
      ASSERT_TRUE(curves.ok());
      for (const OffsetCurve& curve : *curves) {
        const auto verified = verify(graph, options, curve);
        ASSERT_TRUE(verified.ok());
        for (const auto& finding : verified->findings) {
          ADD_FAILURE() << "seed " << seed << ", " << fill.name << ", D " << curve.distance << ": "
                        << to_string(finding);
        }
      }
    }
  }
}

/// Long steep flanks, and clusters of short steps: pockets that greater distances jump over.
Polyline jagged_graph(std::uint32_t seed) {
  std::mt19937 random(seed);
  const std::size_t count = 3 + random() % 120;
  std::normal_distribution<double> normal;
  Polyline graph;
  Point p{0, 0};
  for (std::size_t i = 0; i < count; ++i) {
    graph.points.push_back(p);
    const bool far = random() % 4 == 0;
    const double rise = normal(random);
    p = seed % 2 == 0 ? p + geom::Vector{far ? 2.0 : 0.01, (far ? 5.0 : 0.02) * rise}
                      : p + geom::Vector{random() % 9 == 0 ? 1.001 : 0.001, far ? 10 * rise : 0.0};
  }
  if (seed % 3 == 0) rotate(graph, 0.01 * (seed % 600));
  return graph;
}

/// What smaller distances have hidden is left out at greater ones (StadiaLeft): that changes nothing.
TEST(Envelope, DistancesTogetherGiveTheCurvesThatEachGivesAlone) {
  for (std::uint32_t seed = 0; seed < 800; ++seed) {
    const Polyline graph = seed % 4 == 0 ? random_graph(seed) : jagged_graph(seed);
    std::vector<double> distances;
    for (int k = 1; k <= 9; ++k) distances.push_back(0.02 * (1 + seed % 50) * k);
    for (const Join join : {Join::Round, Join::Mitre}) {
      OffsetOptions options;
      options.join = join;
      options.side = seed % 5 < 2 ? Side::LeftOfTravel : Side::RightOfTravel;
      const auto together = offset(graph, distances, options).value();
      for (std::size_t k = 0; k < distances.size(); ++k) {
        const OffsetCurve alone = offset(graph, {&distances[k], 1}, options).value().front();
        ASSERT_EQ(together[k].pieces.size(), alone.pieces.size()) << "seed " << seed << " D " << distances[k];
        for (std::size_t i = 0; i < alone.pieces.size(); ++i) {
          EXPECT_EQ(together[k].pieces[i].edges, alone.pieces[i].edges) << "seed " << seed << " D " << distances[k];
          EXPECT_NEAR(length(together[k].pieces[i], graph), length(alone.pieces[i], graph), 1e-9 * (1 + distances[k]));
        }
      }
    }
  }
}

}  // namespace
}  // namespace dobra::offset::monotone
