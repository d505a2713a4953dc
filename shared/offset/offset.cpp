#include "shared/offset/offset.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <memory>
#include <mutex>
#include <numeric>
#include <optional>

#include "shared/base/parallel.h"
#include "shared/base/text.h"
#include "shared/geom/intersect.h"
#include "shared/offset/general/sections.h"
#include "shared/offset/kernel/chain_tree.h"
#include "shared/offset/monotone/envelope.h"
#include "shared/offset/stepper/stepper.h"
#include "shared/offset/types/arcs.h"
#include "shared/offset/verifier/verify.h"

namespace dobra::offset {

using base::Error;
using base::ErrorCode;
using base::Result;

namespace {

constexpr int greatest_proportion = 60;  // of a distance to the curve's extent, either way, as a power of two
constexpr int greatest_exponent = 60;    // of the extent: beyond it the engine works on a scaled curve
/// Of coordinates and distances, m: areas must stay in the range of doubles. The reciprocal is the least extent.
constexpr double greatest_size = 1e150;

Result<void> check(const OffsetOptions& options, std::span<const double> distances) {
  const auto invalid = [](std::string message) { return Error{ErrorCode::InvalidOption, std::move(message)}; };
  for (const double d : distances) {
    if (!(d > 0.0) || !std::isfinite(d)) {
      return invalid("an offset distance is " + base::number_text(d) +
                     "; it must be above 0 (choose the other side instead of a negative distance)");
    }
  }
  if (!(options.mitre_limit >= 1.0)) return invalid("the mitre limit must be at least 1");
  if (options.ends == Ends::Extended && !(options.extension > 0.0 && std::isfinite(options.extension))) {
    return invalid("the extension of the ends must be above 0");
  }
  return {};
}

OffsetCurve untreated(const BaseCurve& base, double distance, const OffsetOptions& options) {
  const RawChain chain = raw_chain(base, distance, options, RawArcs::Kept);
  OffsetPiece piece;
  piece.side = options.side;
  piece.closed = base.closed;
  for (const Vec p : chain.points) piece.points.push_back(base.user(p));
  for (std::size_t i = 0; i < chain.segment.size(); ++i) {
    const std::uint32_t segment = base.source[chain.segment[i]];
    piece.edges.push_back(chain.is_arc[i] ? OffsetEdge::arc(segment) : OffsetEdge::line(segment));
  }
  OffsetCurve curve;
  curve.distance = distance;
  curve.pieces.push_back(std::move(piece));
  return curve;
}

double chord_length(const OffsetPiece& piece) {
  double sum = piece.closed ? geom::distance(piece.points.front(), piece.points.back()) : 0.0;
  for (std::size_t i = 1; i < piece.points.size(); ++i) sum += geom::distance(piece.points[i - 1], piece.points[i]);
  return sum;
}

/// Of an open base, what the options want.
void keep_wanted(OffsetCurve& curve, const geom::Polyline& base, Keep keep) {
  if (keep == Keep::AllPieces || curve.pieces.size() < 2) return;
  std::vector<double> lengths;
  for (const OffsetPiece& piece : curve.pieces) lengths.push_back(chord_length(piece));
  // Arcs turn by half a turn at most: they are not 1.6 times as long as their chords.
  const double enough = std::ranges::max(lengths) / 1.6;
  if (std::ranges::count_if(lengths, [&](double l) { return l >= enough; }) > 1) {
    for (std::size_t k = 0; k < lengths.size(); ++k) {
      if (lengths[k] >= enough) lengths[k] = length(curve.pieces[k], base);
    }
  }
  const auto best = std::ranges::max_element(lengths) - lengths.begin();
  curve.dropped = curve.pieces.size() - 1;
  for (const OffsetPiece& piece : curve.pieces) curve.dropped_length += length(piece, base);
  OffsetPiece kept = std::move(curve.pieces[static_cast<std::size_t>(best)]);
  curve.dropped_length -= length(kept, base);
  curve.pieces.clear();
  curve.pieces.push_back(std::move(kept));
}

/// True if the base crosses or touches itself. @cost O(n) where it is smooth
bool meets_itself(const BaseCurve& base) {
  constexpr std::size_t leaf = 16;
  const std::size_t count = base.segment_count();
  for (const double t : base.half_tans) {
    if (std::isinf(t)) return true;
  }
  std::vector<FloatBox> boxes;
  boxes.reserve(count);
  std::vector<ChainTree::Leaf> leaves;
  leaves.reserve(count / leaf + 1);
  for (std::size_t i = 0; i < count; ++i) {
    const geom::Box b = geom::Segment{base.start(i), base.end(i)}.box();
    boxes.emplace_back(flat(b.low), flat(b.high), 0.0);
    const Flat u = flat(base.headings[i]);
    if (i % leaf == 0) leaves.push_back({boxes[i], 0, true, i > 0});
    leaves.back().box.add(boxes[i]);
    leaves.back().directions |= ChainTree::directions_of(u, u);
  }
  bool meets = false;
  ChainTree(leaves).for_each_pair([&](std::size_t a, std::size_t b) {
    if (meets) return;
    for (std::size_t i = leaf * a; i < std::min(leaf * (a + 1), count); ++i) {
      if (!boxes[i].overlaps(leaves[b].box)) continue;
      for (std::size_t j = std::max(i + 2, leaf * b); j < std::min(leaf * (b + 1), count); ++j) {
        if (!boxes[i].overlaps(boxes[j]) || (base.closed && i == 0 && j + 1 == count)) continue;
        meets = meets || geom::intersect({base.start(i), base.end(i)}, {base.start(j), base.end(j)}).kind !=
                             geom::IntersectionKind::None;
      }
    }
  });
  return meets;
}

/// What all distances share.
struct Prepared {
  const geom::Polyline* curve = nullptr;  ///< As given.
  BaseCurve base{};
  std::optional<geom::Vector> forward{};                  ///< See monotone::monotone_direction.
  bool simple = false;                                    ///< Closed, and does not meet itself.
  std::unique_ptr<const general::Clearance> clearance{};  ///< Only where it is needed.
};

/// @param greatest  distance. Where it is far above the size of the base, roundings of doubles add up over nearly
/// straight parts: then the general engine, which decides exactly, takes monotone bases too.
Prepared prepared(const geom::Polyline& curve, BaseCurve base, const OffsetOptions& options, double greatest) {
  Prepared made{.curve = &curve, .base = std::move(base), .forward = {}, .simple = false, .clearance = {}};
  if (options.treatment == Treatment::Untreated) return made;
  if (greatest <= 1e3 * made.base.size) made.forward = monotone::monotone_direction(made.base);
  made.simple = made.base.closed && !meets_itself(made.base);
  return made;
}

/// What the engine finds out at one distance about pieces that are hidden, for greater ones.
struct Hidden {
  std::optional<general::Buried> pieces;  ///< Of a base that is not monotone.
  monotone::StadiaLeft stadia;            ///< Of one that is.
};
/// Null where nobody needs it.
struct Memory {
  const Hidden* known = nullptr;
  Hidden* found = nullptr;
};

OffsetCurve treated(const Prepared& input, double distance, const OffsetOptions& options,
                    const base::Progress& progress, Memory memory) {
  const BaseCurve& base = input.base;
  OffsetCurve curve;
  curve.distance = distance;
  if (!input.clearance) {
    monotone::StadiaLeft left = memory.known ? memory.known->stadia : monotone::all_stadia(base);
    curve.pieces = monotone::monotone_offset(base, *input.forward, distance, options, left);
    if (memory.found) memory.found->stadia = std::move(left);
    keep_wanted(curve, *input.curve, options.keep);
    return curve;
  }
  const bool one_sided = input.simple && input.clearance->tells_sides(distance);
  const general::Outline::Sides sides = one_sided ? general::Outline::Sides::Right : general::Outline::Sides::Both;
  general::Trimmer trimmer(base, *input.clearance, sides, distance, options, progress);
  curve.pieces = memory.known ? trimmer.run(*memory.known->pieces, memory.found ? &*memory.found->pieces : nullptr)
                              : trimmer.run();
  if (input.simple) std::erase_if(curve.pieces, [](const OffsetPiece& piece) { return !piece.closed; });
  if (!base.closed) keep_wanted(curve, *input.curve, options.keep);
  return curve;
}

/// One distance. @pre input is ready for it
OffsetCurve curve_at(const Prepared& input, double distance, const OffsetOptions& options,
                     const base::Progress& progress, Memory memory = {}) {
  return options.treatment == Treatment::Untreated ? untreated(input.base, distance, options)
                                                   : treated(input, distance, options, progress, memory);
}

/// Runs body(k, memory) for all distances, ascending in rounds: what the last of a round finds hidden, those of the
/// later rounds need not look at again.
/// @param width  how many distances a round has, by its number.
template <class Width, class Body>
void ascending(std::span<const double> distances, Hidden known, const Width& width, const Body& body) {
  std::vector<std::size_t> order(distances.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return distances[a] < distances[b]; });
  std::size_t last = 0;
  for (std::size_t round = 0; last < order.size(); ++round) {
    const std::size_t first = last;
    last = std::min(order.size(), first + width(round));
    const bool more = last < order.size();
    std::optional<Hidden> found;
    if (more) found.emplace(known);
    base::parallel_for(last - first, [&](std::size_t i) {
      body(order[first + i], Memory{&known, more && first + i + 1 == last ? &*found : nullptr});
    });
    if (!more) return;
    known = std::move(*found);
  }
}

void add_clearance(Prepared& input, std::span<const double> distances, const OffsetOptions& options) {
  if (options.treatment != Treatment::Treated || input.forward) return;
  auto made = std::make_unique<general::Clearance>(input.base, options);
  constexpr std::size_t several = 4;
  if (!input.simple && distances.size() >= several) {
    const double greatest = std::ranges::max(distances);
    const double free = input.base.closed || made->has_mitres() ? 0 : made->find_escape_rays(distances);
    if (free > 0 && !meets_itself(input.base)) made->part_sides(free);
    if (!made->parts_sides(greatest)) made->find_gaps(std::ranges::min(distances), greatest);
  }
  input.clearance = std::move(made);
}

/// The power of two that is the extent of a curve, or 1 if there is none.
int extent_of(const geom::Polyline& curve) {
  const geom::Box box = curve.box();
  const double half = std::max(0.5 * box.high.x - 0.5 * box.low.x, 0.5 * box.high.y - 0.5 * box.low.y);
  return half > 0 && std::isfinite(half) ? std::ilogb(half) + 1 : 0;
}

/// Coordinates whose squares are no doubles are refused.
Result<void> check_size(const geom::Polyline& curve) {
  for (const geom::Point p : curve.points) {
    if (!geom::is_finite(p) || std::max(std::abs(p.x), std::abs(p.y)) <= greatest_size)
      continue;  // not finite: prepare()
    return Error{ErrorCode::InvalidOption, "a coordinate of the curve is beyond 1e150; use larger units",
                 base::Place{.x = p.x, .y = p.y}};
  }
  const geom::Box box = curve.box();
  const double extent = std::max(box.width(), box.height());
  if (extent > 0 && extent < 1 / greatest_size) {
    return Error{ErrorCode::InvalidOption, "the curve is less than 1e-150 wide; use smaller units",
                 base::Place{.x = box.low.x, .y = box.low.y}};
  }
  return {};
}

/// Beyond it no double of the curve can show the base or the distance, and perturbations (high.h) come near the errors.
Result<void> check_proportion(int extent, std::span<const double> distances) {
  for (const double d : distances) {
    const std::string what = "an offset distance is " + base::number_text(d);
    if (std::abs(std::ilogb(d) - extent) > greatest_proportion) {
      return Error{ErrorCode::InvalidOption, what + ", but the curve is about " +
                                                 base::number_text(std::ldexp(1.0, extent)) +
                                                 " wide; neither may be more than 1e18 times the other"};
    }
    if (d > greatest_size || d < 1 / greatest_size) {
      return Error{ErrorCode::InvalidOption, what + "; it must lie between 1e-150 and 1e150: use other units"};
    }
  }
  return {};
}

/// @pre the numbers are far from the ends of the ranges of float and double
Result<std::vector<OffsetCurve>> offset_near_one(const geom::Polyline& curve, std::span<const double> distances,
                                                 const OffsetOptions& options, const base::Progress& progress) {
  DOBRA_TRY(BaseCurve base, prepare(curve, options.side));
  const bool extended = options.ends == Ends::Extended && !base.closed;
  const bool stepped = options.ends == Ends::Paper && !base.closed && options.treatment == Treatment::Treated;
  Prepared input;
  if (!stepped && !extended) {
    input = prepared(curve, std::move(base), options, distances.empty() ? 0.0 : std::ranges::max(distances));
    add_clearance(input, distances, options);
  }
  std::size_t finished = 0;
  std::mutex report;
  const auto one = [&](std::size_t k, Memory memory) -> Result<OffsetCurve> {
    DOBRA_TRY_VOID(progress.check());
    const double d = distances[k];
    Result<OffsetCurve> result = OffsetCurve{};
    if (stepped) {
      result = stepper::run_stepper(curve, d, options);
    } else if (extended) {
      DOBRA_TRY(BaseCurve longer, prepare(curve, options.side, options.extension * d));
      Prepared own = prepared(curve, std::move(longer), options, d);
      add_clearance(own, {&d, 1}, options);
      result = curve_at(own, d, options, progress);
    } else {
      result = curve_at(input, d, options, progress, memory);
    }
    DOBRA_TRY_VOID(progress.check());
    const std::scoped_lock lock(report);
    progress.report(static_cast<double>(++finished) / static_cast<double>(distances.size()), "offset curves");
    return result;
  };
  std::vector<Result<OffsetCurve>> results(distances.size(), Result<OffsetCurve>(OffsetCurve{}));
  const auto keep = [&](std::size_t k, Memory memory) { results[k] = one(k, memory); };
  if (input.clearance) {
    const double greatest = std::ranges::max(distances);
    ascending(
        distances, {general::Buried(input.base, *input.clearance, greatest), {}},
        [](std::size_t round) { return 1 + round / 3; }, keep);
  } else if (input.forward) {
    // The first hides most.
    ascending(
        distances, {std::nullopt, monotone::all_stadia(input.base)}, [](std::size_t round) { return 1 + round; }, keep);
  } else {
    base::parallel_for(distances.size(), [&](std::size_t k) { keep(k, {}); });
  }
  std::vector<OffsetCurve> curves;
  for (auto& result : results) {
    DOBRA_TRY(OffsetCurve done, std::move(result));
    curves.push_back(std::move(done));
  }
  return curves;
}

/// For debug builds, two independent proofs of a curve: that no edge is too near (clearance), and that the raw outline
/// parts inside and outside at each (winding). Of small bases whose numbers have digits left to judge, for less than a
/// second of a process.
[[maybe_unused]] bool proved(const geom::Polyline& curve, const OffsetOptions& options,
                             const std::vector<OffsetCurve>& made) {
  constexpr std::int64_t greatest = 300;        // points of a base
  static std::atomic<std::int64_t> left{4000};  // of all curves together
  const auto cost = static_cast<std::int64_t>(curve.points.size());
  return cost > greatest || options.join == Join::Bisector ||  // whose tips may be as far as they like
         std::ranges::all_of(made, [&](const OffsetCurve& one) {
           const auto has_digits = [&](double v) {
             return v == 0 || (std::abs(v) < 1e6 * one.distance && std::abs(v) > 1e-6 * one.distance);
           };
           const auto judged =
               std::ranges::all_of(curve.points, [&](geom::Point p) { return has_digits(p.x) && has_digits(p.y); });
           if (!judged || left.fetch_sub(cost) < cost) return true;
           const auto verified = verifier::verify(curve, options, one);
           return verified.ok() && std::ranges::none_of(verified->findings, [](const verifier::Finding& f) {
                    return f.kind == verifier::FindingKind::TooNear || f.kind == verifier::FindingKind::InMitre ||
                           f.kind == verifier::FindingKind::Winding;
                  });
         });
}

}  // namespace

Result<bool> meets_itself(const geom::Polyline& curve) {
  DOBRA_TRY(const BaseCurve base, prepare(curve, Side::RightOfTravel));
  return meets_itself(base);
}

Result<std::vector<OffsetCurve>> offset(const geom::Polyline& curve, std::span<const double> distances,
                                        const OffsetOptions& options, const base::Progress& progress) {
  DOBRA_TRY_VOID(check(options, distances));
  DOBRA_TRY_VOID(check_size(curve));
  const int extent = extent_of(curve);
  DOBRA_TRY_VOID(check_proportion(extent, distances));
  if (std::abs(extent) <= greatest_exponent) {
    auto curves = offset_near_one(curve, distances, options, progress);
    assert(!curves.ok() || proved(curve, options, *curves));
    return curves;
  }
  const auto scale = [](geom::Point& p, int by) { p = {std::ldexp(p.x, by), std::ldexp(p.y, by)}; };
  geom::Polyline scaled = curve;
  std::vector<double> scaled_distances(distances.begin(), distances.end());
  for (geom::Point& p : scaled.points) scale(p, -extent);
  for (double& d : scaled_distances) d = std::ldexp(d, -extent);
  auto curves = offset_near_one(scaled, scaled_distances, options, progress);
  if (!curves.ok()) {
    Error error = curves.error();
    if (error.place) {
      for (std::optional<double>* x : {&error.place->x, &error.place->y}) {
        if (*x) *x = std::ldexp(**x, extent);
      }
    }
    return error;
  }
  for (std::size_t k = 0; k < distances.size(); ++k) {
    (*curves)[k].distance = distances[k];
    for (OffsetPiece& piece : (*curves)[k].pieces) {
      for (geom::Point& p : piece.points) scale(p, extent);
    }
  }
  return curves;
}

}  // namespace dobra::offset
