#include "shared/offset/offset.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <mutex>

#include "shared/base/parallel.h"
#include "shared/base/text.h"
#include "shared/geom/intersect.h"
#include "shared/offset/arcs.h"
#include "shared/offset/chain_tree.h"
#include "shared/offset/envelope.h"
#include "shared/offset/sections.h"
#include "shared/offset/stepper.h"

namespace dobra::offset {

using base::Error;
using base::ErrorCode;
using base::Result;

namespace {

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

/// An open base keeps its longest piece.
void keep_longest(OffsetCurve& curve, const geom::Polyline& base) {
  if (curve.pieces.size() < 2) return;
  const auto best = std::max_element(curve.pieces.begin(), curve.pieces.end(), [&](const auto& a, const auto& b) {
    return length(a, base) < length(b, base);
  });
  curve.dropped = curve.pieces.size() - 1;
  OffsetPiece kept = std::move(*best);
  curve.pieces.clear();
  curve.pieces.push_back(std::move(kept));
}

/// True if a closed base crosses or touches itself. @cost O(n) where it is smooth
bool meets_itself(const BaseCurve& base) {
  const auto item = [&](std::size_t i) {
    const geom::Box box = geom::Segment{base.start(i), base.end(i)}.box();
    const Flat u = flat(base.headings[i]);
    return ChainTree::Item{flat(box.low), flat(box.high), ChainTree::directions_of(u, u), i > 0};
  };
  const std::size_t count = base.segment_count();
  for (const double t : base.half_tans) {
    if (std::isinf(t)) return true;
  }
  bool meets = false;
  ChainTree(count, item, 0.0).for_each_pair([&](std::size_t i, std::size_t j) {
    if (meets || (i == 0 && j + 1 == count)) return;
    meets = geom::intersect({base.start(i), base.end(i)}, {base.start(j), base.end(j)}).kind != geom::IntersectionKind::None;
  });
  return meets;
}

/// What all distances share.
struct Prepared {
  const geom::Polyline* curve = nullptr;  ///< As given.
  BaseCurve base{};
  std::optional<geom::Vector> forward{};  ///< See monotone_direction.
  bool simple = false;                  ///< Closed, and does not meet itself.
  std::unique_ptr<const Clearance> clearance{};  ///< Only where it is needed.
};

Prepared prepared(const geom::Polyline& curve, BaseCurve base, const OffsetOptions& options) {
  Prepared made{.curve = &curve, .base = std::move(base), .forward = {}, .simple = false, .clearance = {}};
  if (options.treatment == Treatment::Untreated) return made;
  made.forward = monotone_direction(made.base);
  made.simple = made.base.closed && !meets_itself(made.base);
  return made;
}

OffsetCurve treated(const Prepared& input, double distance, const OffsetOptions& options) {
  const BaseCurve& base = input.base;
  OffsetCurve curve;
  curve.distance = distance;
  if (input.forward) {
    curve.pieces = monotone_offset(base, *input.forward, distance, options);
    keep_longest(curve, *input.curve);
    return curve;
  }
  const Outline::Sides sides = input.simple ? Outline::Sides::Right : Outline::Sides::Both;
  Trimmer trimmer(base, *input.clearance, sides, distance, options);
  curve.pieces = trimmer.run();
  if (!base.closed) keep_longest(curve, *input.curve);
  return curve;
}

/// One distance. @pre input is ready for it
OffsetCurve curve_at(const Prepared& input, double distance, const OffsetOptions& options) {
  return options.treatment == Treatment::Untreated ? untreated(input.base, distance, options)
                                                   : treated(input, distance, options);
}

void add_clearance(Prepared& input, const OffsetOptions& options) {
  if (options.treatment == Treatment::Treated && !input.forward) {
    input.clearance = std::make_unique<Clearance>(input.base, options);
  }
}

}  // namespace

Result<std::vector<OffsetCurve>> offset(const geom::Polyline& curve, std::span<const double> distances,
                                        const OffsetOptions& options, const base::Progress& progress) {
  DOBRA_TRY_VOID(check(options, distances));
  DOBRA_TRY(BaseCurve base, prepare(curve, options.side));
  const bool extended = options.ends == Ends::Extended && !base.closed;
  const bool stepped = options.ends == Ends::Paper && !base.closed && options.treatment == Treatment::Treated;
  Prepared input;
  if (!stepped && !extended) {
    input = prepared(curve, std::move(base), options);
    add_clearance(input, options);
  }
  std::atomic<std::size_t> finished = 0;
  std::mutex report;
  const auto one = [&](std::size_t k) -> Result<OffsetCurve> {
    DOBRA_TRY_VOID(progress.check());
    const double d = distances[k];
    Result<OffsetCurve> result = OffsetCurve{};
    if (stepped) {
      result = run_stepper(curve, d, options);
    } else if (extended) {
      DOBRA_TRY(BaseCurve longer, prepare(curve, options.side, options.extension * d));
      Prepared own = prepared(curve, std::move(longer), options);
      add_clearance(own, options);
      result = curve_at(own, d, options);
    } else {
      result = curve_at(input, d, options);
    }
    const std::scoped_lock lock(report);
    progress.report(static_cast<double>(++finished) / static_cast<double>(distances.size()), "offset curves");
    return result;
  };
  std::vector<Result<OffsetCurve>> results(distances.size(), Result<OffsetCurve>(OffsetCurve{}));
  base::parallel_for(distances.size(), [&](std::size_t k) { results[k] = one(k); });
  std::vector<OffsetCurve> curves;
  for (auto& result : results) {
    DOBRA_TRY(OffsetCurve done, std::move(result));
    curves.push_back(std::move(done));
  }
  return curves;
}

}  // namespace dobra::offset
