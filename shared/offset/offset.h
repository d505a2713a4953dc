#pragma once
// Curves parallel to open chains and closed contours of straight segments.
//
// What is computed. Let U be all points nearer than D to the base, plus the corners that the joins add on the chosen
// side. The treated curve is the part of U's boundary that belongs to the chosen side, so it keeps the distance from
// the WHOLE base (both sides and the ends of an open one), and has no spurious region. A base that crosses itself is
// treated by the same rule. What only just touches itself counts as closed (as if D were a little greater).
// Page: docs/algorithms/offset.md. Source: [carvalho2005offset]; validity by sections as in [held2001voronoi].

#include <cstdint>
#include <span>
#include <vector>

#include "shared/base/progress.h"
#include "shared/base/result.h"
#include "shared/geom/polyline.h"

namespace dobra::offset {

/// Which side of travel the curve lies on. With y up, a base drawn from left to right has its right side below.
enum class Side { RightOfTravel, LeftOfTravel };

enum class Treatment {
  Treated,    ///< Spurious regions removed.
  Untreated,  ///< Raw normals and bisectors, one edge a base segment (figures 3 and 7a of the paper).
};

/// What fills the gap on the outer side of a corner. On the inner side curves meet on the bisector in every case.
enum class Join {
  Mitre,     ///< The bisector point up to `mitre_limit`, beyond it what `beyond_limit` says.
  Bisector,  ///< The paper's: the bisector point up to `bisector_limit`, beyond it as Mitre with TangentBevel.
  Round,     ///< An arc about the corner.
  Bevel,     ///< The chord of that arc; comes nearer to the corner than D.
};

/// With Join::Bisector: greatest distance of a bisector point from its corner, in D. Farther tips lose digits (a tip L
/// D away is known to about L^2 units in the last place of the turn), and lines to them cross each other in squared
/// number.
inline constexpr double bisector_limit = 1e3;

enum class BeyondLimit {
  TangentBevel,  ///< Cut across at distance D from the corner: the curve keeps its distance everywhere.
  ChordBevel,    ///< As Join::Bevel.
};

/// What fills an exact U-turn, which has no bisector point, with Join::Mitre and Join::Bisector.
enum class UTurn {
  TangentBevel,  ///< Cut across at distance D from the corner.
  ChordBevel,    ///< As Join::Bevel.
};

/// What of an open base is kept.
enum class Keep { LongestPiece, AllPieces };

enum class Ends {
  Paper,     ///< Only closed regions are removed, edge by edge; tails nearer than D to the base may stay at open ends.
  Trimmed,   ///< What is nearer than D to any part of the base is removed.
  Extended,  ///< The base is first lengthened by `extension` D at both ends along its tangents; then as Trimmed.
};

struct OffsetOptions {
  Side side = Side::RightOfTravel;
  Treatment treatment = Treatment::Treated;
  Join join = Join::Mitre;
  double mitre_limit = 4.0;  ///< Greatest distance of a mitre from its corner, in D; at least 1.
  BeyondLimit beyond_limit = BeyondLimit::TangentBevel;
  UTurn u_turn = UTurn::TangentBevel;
  Ends ends = Ends::Trimmed;
  double extension = 1.0;  ///< For Ends::Extended, in D; above 0.
  Keep keep = Keep::LongestPiece;

  /// Greatest distance of a bisector point from its corner, in D.
  [[nodiscard]] double tip_limit() const { return join == Join::Bisector ? bisector_limit : mitre_limit; }
  /// What fills a corner beyond it.
  [[nodiscard]] BeyondLimit beyond_tip_limit() const {
    return join == Join::Bisector ? BeyondLimit::TangentBevel : beyond_limit;
  }
};

/// An edge of a piece: straight, parallel to a base segment (or the bevel at its end); or an arc about the segment's
/// end.
class OffsetEdge {
 public:
  OffsetEdge() = default;
  static constexpr OffsetEdge line(std::size_t base_edge) {
    return OffsetEdge(2 * static_cast<std::uint32_t>(base_edge));
  }
  static constexpr OffsetEdge arc(std::size_t base_edge) {
    return OffsetEdge(2 * static_cast<std::uint32_t>(base_edge) + 1);
  }
  /// Index of the segment in the curve given.
  [[nodiscard]] constexpr std::uint32_t base_edge() const { return code_ / 2; }
  [[nodiscard]] constexpr bool is_arc() const { return code_ % 2 != 0; }
  friend constexpr bool operator==(OffsetEdge, OffsetEdge) = default;

 private:
  explicit constexpr OffsetEdge(std::uint32_t code) : code_(code) {}
  std::uint32_t code_ = 0;
};

/// One simple curve of lines and arcs, oriented like the base. arcs.h draws it with chords and measures it.
struct OffsetPiece {
  Side side = Side::RightOfTravel;  ///< Arcs turn to the left on the right side, to the right on the left side.
  bool closed = false;
  std::vector<geom::Point> points;
  std::vector<OffsetEdge> edges;  ///< From each point to the next; as many as points if closed, else one fewer.
};

struct OffsetCurve {
  double distance = 0.0;
  /// Open base: at most one, the longest, unless all are kept. Closed: all, in order of the first base segment in each;
  /// those round holes between arms of the base have the opposite orientation. A closed base that crosses itself may
  /// give open ones. None where the whole curve is nearer to the base than D.
  std::vector<OffsetPiece> pieces;
  std::size_t dropped = 0;      ///< Further pieces of an open base, left out.
  double dropped_length = 0.0;  ///< Of these, m.
};

/// True if the curve crosses, touches or runs along itself.
/// @error NotFinite, DegenerateCurve.  @cost O(n) where it is smooth
base::Result<bool> meets_itself(const geom::Polyline& curve);

/// Curves parallel to `curve`.
/// @param curve      segments, m; repeated points are passed over.
/// @param distances  m, each above 0 and measured from `curve`, in any order.
/// @return           one result a distance, in the same order; the same bytes for any number of threads.
/// @error            NotFinite, DegenerateCurve with the place; InvalidOption; Cancelled.
/// @cost             about O((n + s) log n) a distance, s = sections that remain after a cull by clearance.
base::Result<std::vector<OffsetCurve>> offset(const geom::Polyline& curve, std::span<const double> distances,
                                              const OffsetOptions& options = {}, const base::Progress& progress = {});

}  // namespace dobra::offset
