#include "shared/offset/offset.h"

#include <algorithm>
#include <atomic>
#include <mutex>

#include "shared/base/parallel.h"
#include "shared/base/text.h"
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
  if (!(options.arc_tolerance > 0.0 && options.arc_tolerance <= 0.5)) {
    return invalid("the arc tolerance must be above 0 and at most 0.5 of the distance");
  }
  if (options.ends == Ends::Extended && !(options.extension > 0.0 && std::isfinite(options.extension))) {
    return invalid("the extension of the ends must be above 0");
  }
  return {};
}

OffsetCurve untreated(const BaseCurve& base, double distance, const OffsetOptions& options) {
  const RawChain chain = raw_chain(base, distance, options);
  OffsetPiece piece;
  piece.polyline.closed = base.closed;
  for (const Vec p : chain.points) piece.polyline.points.push_back(base.user(p));
  for (const std::uint32_t segment : chain.segment) piece.base_edge.push_back(base.source[segment]);
  OffsetCurve curve;
  curve.distance = distance;
  curve.pieces.push_back(std::move(piece));
  return curve;
}

/// An open base keeps its longest piece.
void keep_longest(OffsetCurve& curve) {
  if (curve.pieces.size() < 2) return;
  std::size_t best = 0;
  for (std::size_t i = 1; i < curve.pieces.size(); ++i) {
    if (geom::length(curve.pieces[i].polyline) > geom::length(curve.pieces[best].polyline)) best = i;
  }
  curve.dropped = curve.pieces.size() - 1;
  OffsetPiece kept = std::move(curve.pieces[best]);
  curve.pieces.clear();
  curve.pieces.push_back(std::move(kept));
}

OffsetCurve treated(const BaseCurve& base, const Clearance& clearance, double distance, const OffsetOptions& options) {
  Trimmer trimmer(base, clearance, distance, options);
  OffsetCurve curve;
  curve.distance = distance;
  for (const Chain& chain : trimmer.run()) {
    OffsetPiece piece = trimmer.output(chain);
    if (!piece.polyline.points.empty()) curve.pieces.push_back(std::move(piece));
  }
  if (!base.closed) keep_longest(curve);
  return curve;
}

}  // namespace

Result<std::vector<OffsetCurve>> offset(const geom::Polyline& curve, std::span<const double> distances,
                                        const OffsetOptions& options, const base::Progress& progress) {
  DOBRA_TRY_VOID(check(options, distances));
  DOBRA_TRY(const BaseCurve base, prepare(curve, options.side));
  const Clearance clearance(base);
  const bool extended = options.ends == Ends::Extended && !base.closed;
  const bool stepped = options.ends == Ends::Paper && !base.closed && options.treatment == Treatment::Treated;
  std::atomic<std::size_t> finished = 0;
  std::mutex report;
  const auto one = [&](std::size_t k) -> Result<OffsetCurve> {
    DOBRA_TRY_VOID(progress.check());
    const double d = distances[k];
    Result<OffsetCurve> result = OffsetCurve{};
    if (stepped) {
      result = run_stepper(curve, d, options);
    } else if (extended) {
      DOBRA_TRY(const BaseCurve longer, prepare(curve, options.side, options.extension * d));
      result = options.treatment == Treatment::Untreated ? untreated(longer, d, options)
                                                         : treated(longer, Clearance(longer), d, options);
    } else {
      result = options.treatment == Treatment::Untreated ? untreated(base, d, options) : treated(base, clearance, d, options);
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
