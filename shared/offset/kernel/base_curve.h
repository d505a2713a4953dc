#pragma once
// The base as the engine sees it: moved to a near origin without rounding, without repeated points, with directions and
// corners measured once. It is mirrored if the left side is wanted, so that the engine knows only the right side.

#include <cstdint>
#include <vector>

#include "shared/base/result.h"
#include "shared/geom/polyline.h"
#include "shared/offset/kernel/numbers.h"
#include "shared/offset/types/curve.h"

namespace dobra::offset {
inline namespace kernel {

enum class Turn : std::uint8_t {
  Straight,
  Outer,  ///< Left turn: the right side has a gap to fill. An exact U-turn counts as one.
  Inner,  ///< Right turn: the right side overlaps.
};

/// What the parallels of two segments do at the corner between them.
enum class CornerKind : std::uint8_t {
  Straight,
  Meet,     ///< Inner; the two lines meet on the bisector.
  Apart,    ///< Inner; one of the two segments is too short for that.
  Mitre,    ///< Outer: a quad up to the bisector point.
  Tangent,  ///< Outer: the same cut across at distance D.
  Arc,      ///< Outer.
};

struct BaseCurve {
  bool closed = false;
  std::vector<geom::Point> points;
  std::vector<std::uint32_t> source;  ///< For each segment its index in the user's curve.
  // For each segment, rounded to doubles.
  std::vector<geom::Vector> headings;  ///< Unit directions.
  std::vector<double> spans;           ///< Lengths.
  // For each point (ends of an open curve: Straight, 0).
  std::vector<Turn> turn;         ///< Exact.
  std::vector<double> half_tans;  ///< tan(angle / 2) of the turn, >= 0; infinity for a U-turn.
  struct SiteBlock {
    double regular_below;   ///< Below this distance the inner corners leave a length of each of the block's parallels.
    double greatest_outer;  ///< Half tangent of the sharpest outer corner at the start of one of the block's segments,
                            ///< or 0.
    std::uint32_t sites;    ///< Bit k: there is a segment first + k; bit 16 + k: its start is an outer corner.
  };
  static constexpr std::size_t block_size = 16;
  static constexpr std::uint32_t line_bit(std::size_t i) { return std::uint32_t{1} << (i % block_size); }
  static constexpr std::uint32_t corner_bit(std::size_t i) { return line_bit(i) << block_size; }
  std::vector<SiteBlock> blocks;  ///< Open curves: of so many segments each.
  double least_outer = 0;         ///< Least half tangent of an outer corner; infinity if there is none.
  double size = 0;                ///< Greatest coordinate.
  geom::Point origin;             ///< In the user's coordinates.
  bool mirrored = false;
  bool renumbered = false;  ///< source[i] is not i for some i.

  [[nodiscard]] std::size_t segment_count() const { return headings.size(); }
  [[nodiscard]] geom::Point start(std::size_t i) const { return points[i]; }
  [[nodiscard]] geom::Point end(std::size_t i) const { return points[end_index(i)]; }
  /// The point where segment i ends, as an index.
  [[nodiscard]] std::size_t end_index(std::size_t i) const { return i + 1 == points.size() ? 0 : i + 1; }
  /// True if a segment comes before (after) it.
  [[nodiscard]] bool has_before(std::size_t i) const { return closed || i > 0; }
  [[nodiscard]] bool has_after(std::size_t i) const { return closed || i + 1 < segment_count(); }
  [[nodiscard]] std::size_t before(std::size_t i) const { return i == 0 ? segment_count() - 1 : i - 1; }
  [[nodiscard]] std::size_t after(std::size_t i) const { return i + 1 == segment_count() ? 0 : i + 1; }

  // The same with 64-bit mantissas, for the few places where topology is decided; computed anew at every call.
  [[nodiscard]] Vec point(std::size_t i) const { return {points[i].x, points[i].y}; }
  [[nodiscard]] Vec from(std::size_t i) const { return point(i); }
  [[nodiscard]] Vec to(std::size_t i) const { return point(end_index(i)); }
  [[nodiscard]] Vec along(std::size_t i) const { return unit(to(i) - from(i)); }
  [[nodiscard]] Vec normal(std::size_t i) const { return right_of(along(i)); }  ///< Unit, to the right.
  [[nodiscard]] Real span(std::size_t i) const { return length(to(i) - from(i)); }
  /// T is Real or High; its relative error is that of T times (1 + half_tan) in Real, none in High.
  template <class T>
  [[nodiscard]] T half_tan_as(std::size_t corner) const;

  /// Back in the user's coordinates, rounded once.
  [[nodiscard]] geom::Point user(Vec p) const {
    return {static_cast<double>(p.x + origin.x), static_cast<double>((mirrored ? -p.y : p.y) + origin.y)};
  }
  [[nodiscard]] geom::Point user(geom::Point p) const { return {p.x + origin.x, (mirrored ? -p.y : p.y) + origin.y}; }
};

/// @param extension  each end of an open curve is lengthened by this, m; 0 for none.
/// @error NotFinite, DegenerateCurve with the place.
base::Result<BaseCurve> prepare(const geom::Polyline& curve, Side side, double extension = 0.0);

/// Untreated chain: one edge a base segment, cut on the bisectors; corners by `options`. Points and, for each edge, the
/// base segment (index in `base`).
struct RawChain {
  std::vector<Vec> points;
  std::vector<std::uint32_t> segment;
  std::vector<char> is_arc;
};
enum class RawArcs { Kept, Chords };
RawChain raw_chain(const BaseCurve& base, Real distance, const OffsetOptions& options, RawArcs arcs);

/// How a corner on the outer side is filled: Mitre, Tangent or Arc.
CornerKind outer_corner(const BaseCurve& base, std::size_t corner, const OffsetOptions& options);
/// tan(angle / 4) of a turn, from tan(angle / 2).
template <class T>
T quarter_tan(const T& half_tan) {
  if (std::isinf(static_cast<double>(half_tan))) return T(1);
  return half_tan / (1 + root(T(1 + half_tan * half_tan)));
}

}  // namespace kernel
}  // namespace dobra::offset
