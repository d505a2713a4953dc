#pragma once
// What is asked for and what is given back: the options of offset.h and its curves of lines and arcs. arcs.h measures
// these and draws them with chords.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "shared/geom/polyline.h"

namespace dobra::offset {
inline namespace types {

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

/// One simple curve of lines and arcs, oriented like the base. See arcs.h.
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

}  // namespace types
}  // namespace dobra::offset
