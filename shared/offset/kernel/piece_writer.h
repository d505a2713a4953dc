#pragma once
// Writes a curve of lines and arcs as an OffsetPiece, in the user's coordinates.

#include "shared/offset/kernel/base_curve.h"

namespace dobra::offset {
inline namespace kernel {

class PieceWriter {
 public:
  PieceWriter(const BaseCurve& base, Join join)
      : base_(base), keeps_arcs_(join == Join::Round), lengthened_(!base.closed && base.renumbered) {
    piece_.side = base.mirrored ? Side::LeftOfTravel : Side::RightOfTravel;
  }

  void reserve(std::size_t points) {
    piece_.points.reserve(points);
    piece_.edges.reserve(points);
  }
  /// A point, from which an edge parallel to base segment `segment` leaves.
  void add_line(geom::Point from, std::size_t segment) { add(from, OffsetEdge::line(base_.source[segment])); }
  /// A point, from which an arc about the end of base segment `segment` leaves. Arcs of one corner become one. Where an
  /// end was lengthened (base_curve.cpp) the base does not turn but by rounding, and there is no arc.
  void add_arc(geom::Point from, std::size_t segment) {
    if (lengthened_ && segment + 1 < base_.source.size() && base_.source[segment] == base_.source[segment + 1]) {
      return add_line(from, segment);
    }
    const OffsetEdge edge = OffsetEdge::arc(base_.source[segment]);
    if (piece_.edges.empty() || piece_.edges.back() != edge) add(from, edge);
  }
  /// The pieces of all 16 steps from `first` on: starts(point) sets so many points or returns false, arcs as in
  /// Outline::Starts. False, and nothing is written, where it is not so simple.
  template <class Starts>
  bool add_block(std::uint32_t first, std::uint64_t arcs, std::size_t count, const Starts& starts) {
    const std::size_t size = piece_.points.size();
    if (lengthened_ || size == 0) return false;
    piece_.points.resize(size + count);
    bool failed = !starts(piece_.points.data() + size);
    for (std::size_t k = size; k < size + count; ++k) {
      piece_.points[k] = base_.user(piece_.points[k]);
      failed |= piece_.points[k] == piece_.points[k - 1];
    }
    if (failed) {
      piece_.points.resize(size);
      return false;
    }
    piece_.edges.resize(size + count);
    OffsetEdge* edge = piece_.edges.data() + size;
    for (std::uint32_t step = first; step < first + BaseCurve::block_size; ++step, arcs >>= 4) {
      *edge++ = OffsetEdge::line(base_.source[step]);
      if ((arcs & 1) != 0) *edge++ = OffsetEdge::arc(base_.source[step]);
    }
    return true;
  }
  /// Ends an open curve at p.
  OffsetPiece finish_open(geom::Point p);
  /// Closes the curve, which is at this distance. What is no wider than the rounding of its points is nothing: whether
  /// that leaves an area would depend on where the base starts and which way it runs.
  OffsetPiece finish_closed(double distance);

 private:
  void add(geom::Point p, OffsetEdge edge) {
    const geom::Point q = base_.user(p);
    if (!piece_.points.empty() && piece_.points.back() == q) {
      piece_.edges.back() = edge;
      return;
    }
    piece_.points.push_back(q);
    piece_.edges.push_back(edge);
  }
  [[nodiscard]] bool is_sliver(double distance) const;
  OffsetPiece finish();

  const BaseCurve& base_;
  const bool keeps_arcs_;  // chord bevels are the chords of what is left of their arcs
  const bool lengthened_;  // the base may be
  OffsetPiece piece_;
};

}  // namespace kernel
}  // namespace dobra::offset
