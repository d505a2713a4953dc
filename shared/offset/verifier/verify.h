#pragma once
// Judges offset curves, whoever made them: proves that a result keeps the rule of offset.h, or names each place where
// it does not. Shares no code with the engine: places in 64-bit mantissas, a box tree of its own, exact predicates from
// geom, and exact sums where two parallels may have no room between them.
//
//  a  vertices    Each lies on the parallels (or bevels, or arcs) of both its edges, at D within `vertex_tolerance` D.
//     edges       None comes nearer to the base than D, nor into a mitre of another corner; proved for the whole edge.
//  b  crossings   No two edges meet, but for neighbours at their common vertex.
//  c  missing     Points of the raw parallels that nothing hides are on the curve. Open pieces end only where they may.
//  d  winding     Of the raw outline (all parallels, corners, caps): above 0 just behind every edge, 0 just beyond it.
//  e  base edges  Each edge is parallel to the base segment that it names, or an arc or bevel at its end.
//
// What rounding the coordinates to doubles moves is allowed on top of each tolerance. Page: docs/algorithms/offset.md.

#include <string>
#include <vector>

#include "shared/base/progress.h"
#include "shared/base/result.h"
#include "shared/offset/types/curve.h"

namespace dobra::offset::verifier {

struct VerifyOptions {
  double vertex_tolerance = 1e-12;  ///< Of distances, in D.
  /// In D: what is hidden or free by less than this is not asked for by the search for missing parts.
  double ambiguity = 1e-9;
  int samples = 5;  ///< Points asked of each raw parallel; three of each arc and bevel.
};

enum class FindingKind {
  Malformed,    ///< Not a curve: not finite, repeated points, edges that do not fit the points.
  OffParallel,  ///< A vertex is not at D from what its edge names (or the edge names the wrong base segment).
  WrongWay,     ///< An edge runs against its base segment.
  TooNear,      ///< An edge comes nearer to the base than D.
  InMitre,      ///< An edge runs through the mitre of another corner.
  Crossing,     ///< Two edges cross.
  Touching,     ///< Two edges touch, or one runs, where the base leaves no room: in a slit exactly 2 D wide, for one.
  OpenEnd,      ///< A piece ends where the curve goes on.
  Missing,      ///< A free point of a raw parallel is not on the curve.
  Winding,      ///< The raw outline does not part inside and outside at an edge.
};

struct Finding {
  FindingKind kind = FindingKind::Malformed;
  geom::Point place;
  double measured = 0;  ///< m; for Winding a count; for Malformed and OpenEnd of no meaning.
  double allowed = 0;
  std::size_t piece = 0;  ///< Of the curve; for Missing the base segment.
  std::size_t edge = 0;   ///< Of that piece; for Missing of no meaning.
};

struct Verification {
  std::vector<Finding> findings;
  std::size_t edges = 0;    ///< Judged.
  std::size_t samples = 0;  ///< Free points of raw parallels that were looked for and had to be there.
  /// D is below 64 roundings of the coordinates: neither touching nor what is missing was asked for. Ends are looked
  /// for within 8 roundings, which must be far less than the 2 D between two sides of the base; and the engine leaves
  /// out closed pieces up to 64 roundings wide, as those round a part of the base by itself are, being 2 D wide.
  bool coarse = false;
  [[nodiscard]] bool ok() const { return findings.empty(); }
};

/// Judges `curve`, one result of offset(base, ..., options).
/// The tip of a mitre that pokes through a thin part of a contour that does not meet itself is on the wrong side: not
/// asked for. Not all rules hold everywhere: Untreated is judged by (e) and its vertices only, Ends::Paper by (b) and
/// whether its vertices lie on the raw edges that it names, which go from corner to corner; where pieces were dropped,
/// nothing is asked to be there (c).
/// @error those of the base: NotFinite, DegenerateCurve; InvalidOption if the distance is not above 0; Cancelled.
/// @cost  O((n + m) log n) for n base and m result points, where what is within D of a place is not crowded.
base::Result<Verification> verify(const geom::Polyline& base, const OffsetOptions& options, const OffsetCurve& curve,
                                  const VerifyOptions& verify_options = {}, const base::Progress& progress = {});

const char* name_of(FindingKind kind);

/// "too near: 0.99 where 1 is allowed, at (x, y)".
std::string to_string(const Finding& finding);

}  // namespace dobra::offset::verifier
