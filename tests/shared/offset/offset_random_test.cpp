// Seeded random polylines of many kinds, judged by the verifier and by a brute-force length that shares nothing with
// it. DOBRA_RANDOM_CASES=10000 runs that many; DOBRA_RANDOM_FIRST is the first seed.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>

#include "shared/offset/kernel/base_curve.h"
#include "shared/offset/offset.h"
#include "shared/offset/verifier/verify.h"
#include "tests/support/length_oracle.h"
#include "tests/support/random_curves.h"

namespace dobra::offset {
namespace {

using namespace verifier;
using geom::Point;
using geom::Polyline;
using support::RandomCase;

/// With the new ends where the engine puts them: they are rounded, and what coincides with them is decided by that.
Polyline lengthened(const Polyline& base, double by) {
  const auto prepared = prepare(base, Side::RightOfTravel, by);  // moved to near the origin, which changes no length
  if (prepared.ok()) return {prepared->points, base.closed};
  ADD_FAILURE() << prepared.error().message;
  return base;
}

/// What the lengths say against the curve; nothing where they agree.
std::string judge_length(const RandomCase& c, const OffsetOptions& options, const OffsetCurve& curve) {
  const double distance = curve.distance;
  const Polyline base = options.ends == Ends::Extended ? lengthened(c.base, options.extension * distance)
                                                       : geom::without_repeated_points(c.base);
  const double truth = support::LengthOracle(base, distance, options).length();
  double got = 0;
  double longest = 0;
  for (const OffsetPiece& piece : curve.pieces) {
    got += length(piece, c.base);
    longest = std::max(longest, length(piece, c.base));
  }
  const double slack = 1e-8 * (distance + truth);
  const std::string said = "length " + std::to_string(got) + ", " + std::to_string(truth) + " by brute force";
  if (got > truth + slack) return said;
  const auto lacks = [&](double least) {
    if (curve.dropped == 0 && got < least - slack) return said;
    if (!base.closed && longest * double(curve.dropped + 1) < least - slack)
      return said + ", more than dropped pieces can have";
    return std::string();
  };
  if (lacks(truth).empty()) return {};
  // Closed pieces that are no wider than the rounding of their points are left out: a little farther from the base
  // there are none.
  const geom::Box box = base.box();
  const double greatest =
      std::max({std::abs(box.low.x), std::abs(box.low.y), std::abs(box.high.x), std::abs(box.high.y)}) + distance;
  return lacks(support::LengthOracle(base, distance + 0x1p-46 * greatest, options).length());
}

/// By the number of edges to the right of p; p is not near any.
bool is_inside(const Polyline& contour, Point p) {
  bool inside = false;
  for (std::size_t i = 0; i < contour.segment_count(); ++i) {
    const geom::Segment s = contour.segment(i);
    if ((s.from.y > p.y) == (s.to.y > p.y)) continue;
    inside ^= p.x < s.from.x + (s.to.x - s.from.x) * ((p.y - s.from.y) / (s.to.y - s.from.y));
  }
  return inside;
}

/// Everything that is wrong with one curve of a case.
std::string judge(const RandomCase& c, const OffsetOptions& options, const OffsetCurve& curve) {
  const auto verified = verify(c.base, options, curve);
  if (!verified.ok()) return verified.error().message;
  std::string wrong;
  for (std::size_t i = 0; i < std::min<std::size_t>(3, verified->findings.size()); ++i)
    wrong += to_string(verified->findings[i]) + "; ";
  if (verified->findings.size() > 3) wrong += "and " + std::to_string(verified->findings.size() - 3) + " more; ";
  for (const OffsetPiece& piece : curve.pieces) {
    if (!c.simple) continue;
    if (!piece.closed) wrong += "open piece of a simple contour; ";
    const bool inwards = (options.side == Side::LeftOfTravel) == (geom::signed_area(c.base) > 0);
    if (options.join != Join::Bevel && is_inside(c.base, piece.points.front()) != inwards)
      wrong += "a piece on the wrong side; ";
  }
  // Brute force takes its time. The paper's rule leaves tails that it knows nothing of.
  const bool measured =
      options.ends != Ends::Paper && (curve.distance == c.distance || curve.distance == 2 * c.distance);
  if (measured && options.join != Join::Bevel && c.base.points.size() < 130) wrong += judge_length(c, options, curve);
  return wrong;
}

/// What one distance hides the greater ones leave out, so there are several, in any order; ties at one are ties at the
/// others too. With other ends each has a base, or a subdivision, of its own.
std::vector<double> distances_of(const RandomCase& c, std::uint32_t seed, Ends ends) {
  if (ends != Ends::Trimmed) return {c.distance};
  std::vector<double> distances{0.5 * c.distance, c.distance, 1.5 * c.distance, 2 * c.distance};
  std::rotate(distances.begin(), distances.begin() + seed % 4, distances.end());
  return distances;
}

/// Both sides, all joins and ends of one seed; the kind if something failed.
std::string judge_seed(std::uint32_t seed) {
  const RandomCase c = support::random_case(seed);
  if (!geom::validate(c.base).ok()) return {};
  bool failed = false;
  for (const Side side : {Side::RightOfTravel, Side::LeftOfTravel}) {
    for (const Join join : {Join::Mitre, Join::Bisector, Join::Round, Join::Bevel}) {
      for (const Ends ends : {Ends::Trimmed, Ends::Extended, Ends::Paper}) {
        if (ends != Ends::Trimmed && c.base.closed) continue;
        if (ends == Ends::Paper && join == Join::Bisector) continue;  // no digits are left round tips 1e10 D away
        OffsetOptions options;
        options.side = side;
        options.join = join;
        options.ends = ends;
        const auto curves = offset(c.base, distances_of(c, seed, ends), options);
        if (!curves.ok()) {
          ADD_FAILURE() << "seed " << seed << ": " << curves.error().message;
          return c.kind;
        }
        for (const OffsetCurve& curve : *curves) {
          const std::string wrong = judge(c, options, curve);
          if (wrong.empty()) continue;
          failed = true;
          ADD_FAILURE() << "seed " << seed << " (" << c.kind << ") side " << int(side) << " join " << int(join)
                        << " ends " << int(ends) << " D " << curve.distance << " n " << c.base.points.size() << ": "
                        << wrong;
        }
      }
    }
  }
  return failed ? c.kind : std::string();
}

TEST(OffsetRandom, NoRandomPolylineFails) {
  const char* cases = std::getenv("DOBRA_RANDOM_CASES");
  const char* start = std::getenv("DOBRA_RANDOM_FIRST");
  const std::uint32_t first = start ? static_cast<std::uint32_t>(std::atoi(start)) : 0;
  const std::uint32_t count = cases ? static_cast<std::uint32_t>(std::atoi(cases)) : 100;
  std::map<std::string, std::size_t> failed;
  for (std::uint32_t seed = first; seed < first + count; ++seed) {
    if (const std::string kind = judge_seed(seed); !kind.empty()) ++failed[kind];
  }
  for (const auto& [kind, times] : failed) ADD_FAILURE() << times << " failed of the kind: " << kind;
}

TEST(OffsetRandom, SeedsThatOnceFailedPass) {
  for (const std::uint32_t seed :
       {197U,  299U,  344U,  381U,  469U,  996U,    1163U,   1274U,   2251U,   2286U,   2468U,   2662U,
        3649U, 4210U, 4740U, 5841U, 6896U, 700172U, 700359U, 700427U, 710225U, 740281U, 742039U, 9931544U}) {
    judge_seed(seed);
  }
}

}  // namespace
}  // namespace dobra::offset
