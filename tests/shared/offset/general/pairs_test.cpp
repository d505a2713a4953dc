// Whatever crosses must be paired, but where the place lies in U: judged by looking at all pieces of the raw outline
// that survive, two by two. And what is kept from smaller distances must not change the curves.

#include "shared/offset/general/pairs.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "shared/offset/offset.h"
#include "tests/support/random_curves.h"

namespace dobra::offset::general {
namespace {

/// A piece as a chain of chords that lie on it.
struct Drawn {
  std::uint32_t piece;
  Site site;
  std::vector<Flat> points;
  FloatBox box;
};

Drawn drawn(const Outline& outline, Site site, std::uint32_t piece, Flat a, Flat b) {
  Drawn made{piece, site, {a}, {}};
  if (site.kind == SiteKind::Arc || site.kind == SiteKind::SecondArc) {
    const Flat c = outline.centre(site);
    const double turn = std::atan2(cross(a - c, b - c), dot(a - c, b - c));
    for (int k = 1; k < 24; ++k) {
      const double t = turn * k / 24;
      made.points.push_back(c + std::cos(t) * (a - c) + std::sin(t) * left_of(a - c));
    }
  }
  made.points.push_back(b);
  for (const Flat p : made.points) made.box.add(FloatBox(p, p, 0));
  return made;
}

/// Where chords cross, and not only just.
std::vector<Flat> crossings(const Drawn& p, const Drawn& q, double slack) {
  std::vector<Flat> found;
  if (!p.box.overlaps(q.box)) return found;
  for (std::size_t i = 0; i + 1 < p.points.size(); ++i) {
    for (std::size_t j = 0; j + 1 < q.points.size(); ++j) {
      const Flat u = p.points[i + 1] - p.points[i];
      const Flat v = q.points[j + 1] - q.points[j];
      const double a = cross(u, q.points[j] - p.points[i]) / length(u);
      const double b = cross(u, q.points[j + 1] - p.points[i]) / length(u);
      const double c = cross(v, p.points[i] - q.points[j]) / length(v);
      const double d = cross(v, p.points[i + 1] - q.points[j]) / length(v);
      if (std::min(a, b) < -slack && std::max(a, b) > slack && std::min(c, d) < -slack && std::max(c, d) > slack)
        found.push_back(p.points[i] + (c / (c - d)) * u);
    }
  }
  return found;
}

/// True if a step's set holds a place of two pieces deep inside; not those whose arcs the pieces are: chords lie in
/// them.
bool in_a_set(const Outline& outline, Flat at, const Drawn& p, const Drawn& q) {
  const auto is_own = [&](std::uint32_t step, Site s) {
    return (s.kind == SiteKind::Arc || s.kind == SiteKind::SecondArc) &&
           (step == s.step || step == outline.after(s.step));
  };
  for (std::uint32_t step = 0; step < outline.base().segment_count(); ++step) {
    if (is_own(step, p.site) || is_own(step, q.site)) continue;
    if (outline.deep_inside(at, step, 1e-13 * outline.distance())) return true;
  }
  return false;
}

/// True if every place of a piece lies in U, as far as sampling tells: then it need not be paired.
bool is_buried(const Outline& outline, const Drawn& p) {
  const auto n = static_cast<std::uint32_t>(outline.base().segment_count());
  const auto in_a_set = [&](Flat at) {
    for (std::uint32_t step = 0; step < n; ++step) {
      if (outline.deep_inside(at, step, 1e-13 * outline.distance())) return true;
    }
    return false;
  };
  for (std::size_t i = 0; i + 1 < p.points.size(); ++i) {
    for (int k = 0; k <= 50; ++k) {
      if (!in_a_set(p.points[i] + (0.02 * k) * (p.points[i + 1] - p.points[i]))) return false;
    }
  }
  return true;
}

/// Left pieces that are not overcut, in whole.
std::vector<Drawn> other_side(const Outline& outline) {
  std::vector<Drawn> made;
  const auto n = static_cast<std::uint32_t>(outline.base().segment_count());
  for (std::uint32_t step = n; step < 2 * n; ++step) {
    const Flat a = outline.start_of({step, SiteKind::Line});
    const Flat b = outline.end_of({step, SiteKind::Line});
    if (dot(b - a, outline.along<double>(step)) > 1e-9) made.push_back(drawn(outline, {step, SiteKind::Line}, 0, a, b));
    if (outline.junction(step).kind != CornerKind::Arc || outline.is_cap(step)) continue;
    for (const SiteKind kind : {SiteKind::Arc, SiteKind::SecondArc}) {
      if (kind == SiteKind::SecondArc && !outline.splits_arc(step)) continue;
      made.push_back(drawn(outline, {step, kind}, 0, outline.start_of({step, kind}), outline.end_of({step, kind})));
    }
  }
  return made;
}

/// Counts the crossings that are there and those that no pair holds.
void compare(const geom::Polyline& curve, double distance, const OffsetOptions& options, std::size_t& there,
             std::size_t& missed) {
  const auto base = prepare(curve, options.side);
  ASSERT_TRUE(base.ok());
  Clearance clearance(*base, options);
  clearance.find_gaps(distance, distance);
  const Outline outline(*base, clearance.corners(), Outline::Sides::Both, distance);
  const Buried known(*base, clearance);
  const base::Progress progress;
  WitnessSearch witnesses(outline, clearance);
  Candidates chain = candidates(outline, clearance, witnesses, known, nullptr, progress);
  const auto wanted = static_cast<std::uint32_t>(chain.pieces.size());
  const Pairing::Pairs pairs = Pairing(outline, clearance, chain, witnesses, progress).run(known, nullptr);
  const std::set<std::pair<std::uint32_t, std::uint32_t>> paired(pairs.begin(), pairs.end());
  std::set<std::pair<std::uint32_t, std::uint32_t>> sites;  // piece of the curve, site of the other side
  for (const auto& [i, j] : pairs) {
    if (j >= wanted) sites.emplace(i, packed(chain.pieces[j].site()));
  }
  std::vector<Drawn> own;
  for (std::uint32_t k = 0; k < wanted; ++k) {
    const Piece& p = chain.pieces[k];
    own.push_back(drawn(outline, p.site(), k, chain.start(outline, p), chain.end(outline, p)));
  }
  const double slack = 1e-3 * distance;
  const std::vector<Drawn> others = other_side(outline);
  for (const Drawn& p : own) {
    for (const Drawn& q : own) {
      if (q.piece <= p.piece || (q.piece == p.piece + 1 && chain.pieces[q.piece].linked())) continue;
      const bool is_paired = paired.contains({p.piece, q.piece});
      for (const Flat at : crossings(p, q, slack)) {
        ++there;
        if (!is_paired && !in_a_set(outline, at, p, q)) ++missed;
      }
    }
    for (const Drawn& q : others) {
      const std::vector<Flat> places = crossings(p, q, slack);
      if (places.empty() || is_buried(outline, q)) continue;
      const bool is_paired = sites.contains({p.piece, packed(q.site)});
      for (const Flat at : places) {
        ++there;
        if (!is_paired && !in_a_set(outline, at, p, q)) ++missed;
      }
    }
  }
}

TEST(Pairs, EveryCrossingOfSurvivingPiecesIsPaired) {
  std::size_t there = 0;
  std::size_t missed = 0;
  for (std::uint32_t seed = 0; seed < 4 * support::random_kinds; ++seed) {
    const support::RandomCase c = support::random_case(seed);
    if (!geom::validate(c.base).ok() || c.kind == "near U-turns") continue;
    for (const Join join : {Join::Round, Join::Mitre}) {
      for (const double factor : {0.5, 1.0, 3.0}) {
        OffsetOptions options;
        options.join = join;
        options.side = seed % 2 != 0 ? Side::LeftOfTravel : Side::RightOfTravel;
        const std::size_t before = missed;
        compare(c.base, factor * c.distance, options, there, missed);
        EXPECT_EQ(missed, before) << "seed " << seed << " (" << c.kind << ") join " << int(join) << " D "
                                  << factor * c.distance;
      }
    }
  }
  EXPECT_GT(there, 1000U);
  RecordProperty("crossings", static_cast<int>(there));
}

TEST(Pairs, WhatIsTakenOffTheEndsOfLinesLiesInU) {
  std::size_t shortened = 0;
  for (std::uint32_t seed = 0; seed < 4 * support::random_kinds; ++seed) {
    const support::RandomCase c = support::random_case(seed);
    if (!geom::validate(c.base).ok() || c.kind == "near U-turns") continue;
    const OffsetOptions options{.join = Join::Mitre};
    const auto base = prepare(c.base, options.side);
    ASSERT_TRUE(base.ok());
    const Clearance clearance(*base, options);
    const Outline outline(*base, clearance.corners(), Outline::Sides::Both, 2 * c.distance);
    WitnessSearch witnesses(outline, clearance);
    const Candidates chain = candidates(outline, clearance, witnesses, Buried(*base, clearance), nullptr, {});
    for (const Piece& piece : chain.pieces) {
      if (piece.site().kind != SiteKind::Line) continue;
      const Flat a = chain.start(outline, piece);
      const Flat b = chain.end(outline, piece);
      Flat from = a;
      Flat to = b;
      const bool left = witnesses.shorten(from, to);
      const auto check = [&](Flat p, Flat q) {
        if (!(length(q - p) > 0)) return;
        ++shortened;
        EXPECT_TRUE(is_buried(outline, drawn(outline, piece.site(), 0, p, q))) << "seed " << seed;
      };
      check(a, left ? from : b);
      if (left) check(to, b);
    }
  }
  EXPECT_GT(shortened, 100U);
}

/// Part of a rough ring or spiral, which does not meet itself.
geom::Polyline rough_bow(std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(0, 1);
  geom::Polyline made;
  const double turn = 3 + 6 * any(random);  // up to one and a half
  const double outwards = 0.3 + 2 * any(random);
  const double rough = 0.6 * any(random);
  for (double t = 0; t < turn; t += 0.02 + 0.1 * any(random)) {
    const double r = 5 + outwards * t + rough * (any(random) - 0.5);
    made.points.push_back({r * std::cos(t), r * std::sin(t)});
  }
  return made;
}

/// Four distances together find out first whether the two sides can meet; one alone tries them against each other.
TEST(Pairs, SidesOfAnOpenBaseAreLeftApartOnlyWhereThatChangesNoCurve) {
  std::size_t parted = 0;
  std::size_t not_parted = 0;
  std::size_t dropped = 0;
  for (std::uint32_t seed = 0; seed < 400; ++seed) {
    const geom::Polyline bow = rough_bow(seed);
    const double d = 0.2 + 0.03 * (seed % 60);
    const std::vector<double> distances{d, 1.3 * d, 1.7 * d, 2 * d};
    for (const Side side : {Side::RightOfTravel, Side::LeftOfTravel}) {
      const OffsetOptions options{.side = side, .join = Join::Round};
      const auto base = prepare(bow, side);
      ASSERT_TRUE(base.ok());
      (Clearance(*base, options).find_escape_rays(distances) > 0 ? parted : not_parted) += 1;
      const auto together = offset(bow, distances, options);
      ASSERT_TRUE(together.ok());
      for (std::size_t k = 0; k < distances.size(); ++k) {
        const auto alone = offset(bow, std::vector<double>{distances[k]}, options);
        ASSERT_TRUE(alone.ok());
        ASSERT_EQ((*together)[k].pieces.size(), alone->front().pieces.size())
            << "seed " << seed << " D " << distances[k];
        EXPECT_EQ((*together)[k].pieces.front().edges, alone->front().pieces.front().edges)
            << "seed " << seed << " D " << distances[k];
        EXPECT_EQ((*together)[k].dropped, alone->front().dropped) << "seed " << seed << " D " << distances[k];
        dropped += alone->front().dropped;
      }
    }
  }
  EXPECT_GT(parted, 100U);
  EXPECT_GT(not_parted, 50U);
  EXPECT_GT(dropped, 50U);
}

TEST(Pairs, DistancesTogetherGiveTheCurvesThatEachGivesAlone) {
  for (std::uint32_t seed = 0; seed < 4 * support::random_kinds; ++seed) {
    const support::RandomCase c = support::random_case(seed);
    if (!geom::validate(c.base).ok() || c.kind == "near U-turns") continue;
    std::vector<double> distances;
    for (int k = 1; k <= 8; ++k) distances.push_back(0.3 * k * c.distance);
    for (const Join join : {Join::Round, Join::Mitre}) {
      OffsetOptions options;
      options.join = join;
      const auto together = offset(c.base, distances, options);
      ASSERT_TRUE(together.ok());
      for (std::size_t k = 0; k < distances.size(); ++k) {
        const auto alone = offset(c.base, std::vector<double>{distances[k]}, options);
        ASSERT_TRUE(alone.ok());
        const auto& pieces = alone->front().pieces;
        ASSERT_EQ((*together)[k].pieces.size(), pieces.size()) << "seed " << seed << " D " << distances[k];
        for (std::size_t i = 0; i < pieces.size(); ++i) {
          EXPECT_EQ((*together)[k].pieces[i].edges, pieces[i].edges) << "seed " << seed << " D " << distances[k];
          EXPECT_NEAR(length((*together)[k].pieces[i], c.base), length(pieces[i], c.base), 1e-9 * distances[k]);
        }
      }
    }
  }
}

}  // namespace
}  // namespace dobra::offset::general
