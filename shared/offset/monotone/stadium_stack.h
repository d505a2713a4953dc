#pragma once
// First step of the monotone engine (envelope.h): the lower envelope of the stadia of a monotone base, by one pass with
// a stack. The stack is the output: points, and for each the edge that leaves it. Corners that are to be mitred stand
// on it by their tips while their arcs are whole, and are noted where they are cut.

#include "shared/offset/kernel/base_curve.h"
#include "shared/offset/kernel/site.h"

namespace dobra::offset::monotone {

/// How outer corners are filled.
class JoinRule {
 public:
  explicit JoinRule(const OffsetOptions& options);
  [[nodiscard]] bool only_arcs() const { return mitre_below_ < 0; }
  [[nodiscard]] double mitre_below() const {
    return mitre_below_;
  }  ///< Greatest half tangent of a mitre; below 0 if none is.
  [[nodiscard]] CornerKind of(double half_tan) const { return half_tan <= mitre_below_ ? CornerKind::Mitre : beyond_; }

 private:
  double mitre_below_ = -1.0;
  CornerKind beyond_ = CornerKind::Arc;
};

/// Edges on the stack: as OffsetEdge says, and with this bit added to the segment the edges that leave a mitred corner:
/// (tip, line of i + bit), or for a tangent bevel (its start, arc of i - 1 + bit), (its end, line of i + bit).
inline constexpr std::uint32_t mitred = 1U << 30;
/// The segment that the arc about the first point of the base stands for, as its last does for the arc about the last
/// point.
inline constexpr std::uint32_t start_cap = (1U << 31) - 1;

struct Stacked {
  std::vector<geom::Point> points;
  std::vector<OffsetEdge> edges;   ///< As many as points.
  geom::Point tip;                 ///< Where the last edge ends.
  bool repeats = false;            ///< Some consecutive points may be equal.
  std::vector<std::uint64_t> cut;  ///< Bit i: corner i is to be mitred, but its arc is not wholly on the envelope.
};

/// What of the stadia may be on their envelope: for each block of the base the bits of its lines, and of its corners'
/// arcs (as BaseCurve::SiteBlock::sites). What is not on it at one distance is not at any greater one: of a point at a
/// distance D' from the base the way to its foot is free, and at D of it there would be a point of the curve at D.
using StadiaLeft = std::vector<std::uint32_t>;
StadiaLeft all_stadia(const BaseCurve& base);

/// @param left  what a smaller distance has left (all_stadia, if there is none); on return what this one leaves.
/// @pre base open, fewer than `mitred` segments, monotone in direction `forward`.
/// @cost O(n): 3 ns a segment where nothing is hidden, else some 30 ns.
Stacked stack_stadia(const BaseCurve& base, geom::Vector forward, double distance, const JoinRule& joins,
                     StadiaLeft& left);

/// What is nearer than this to touching counts as touching, and what touches as hidden: a little above what rounding
/// does to the places compared, so that exact coincidences leave no edges that only rounding made.
inline double touching(const BaseCurve& base, double distance) { return 2e-15 * (base.size + distance); }

// Places at corner i of a base, between segments i - 1 and i.
inline geom::Point foot_before(const BaseCurve& base, std::size_t i, double d) {
  return base.points[i] + d * geom::right_of(base.headings[i - 1]);
}
inline geom::Point foot_after(const BaseCurve& base, std::size_t i, double d) {
  return base.points[i] + d * geom::right_of(base.headings[i]);
}
/// The meeting point of the two lines, given the half tangent, negative at an inner corner.
inline geom::Point tip_at(const BaseCurve& base, std::size_t i, double d, double half_tan) {
  const geom::Vector u = base.headings[i - 1];
  return base.points[i] + d * geom::Vector{u.y + half_tan * u.x, half_tan * u.y - u.x};
}
/// Start and end of a tangent bevel.
inline geom::Point bevel_start(const BaseCurve& base, std::size_t i, double d, double quarter) {
  return tip_at(base, i, d, quarter);
}
inline geom::Point bevel_end(const BaseCurve& base, std::size_t i, double d, double quarter) {
  const geom::Vector u = base.headings[i];
  return base.points[i] + d * geom::Vector{u.y - quarter * u.x, -quarter * u.y - u.x};
}
inline double quarter_of(double half_tan) { return half_tan / (1 + std::sqrt(1 + half_tan * half_tan)); }

}  // namespace dobra::offset::monotone
