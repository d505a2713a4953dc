#pragma once
// Writes a curve of lines and arcs as an OffsetPiece, in the user's coordinates.

#include "shared/offset/base_curve.h"

namespace dobra::offset {

class PieceWriter {
 public:
  PieceWriter(const BaseCurve& base, Join join) : base_(base), keeps_arcs_(join == Join::Round) {
    piece_.side = base.mirrored ? Side::LeftOfTravel : Side::RightOfTravel;
  }

  void reserve(std::size_t points) {
    piece_.points.reserve(points);
    piece_.edges.reserve(points);
  }
  /// A point, from which an edge parallel to base segment `segment` leaves.
  void add_line(geom::Point from, std::size_t segment) { add(from, OffsetEdge::line(base_.source[segment])); }
  /// A point, from which an arc about the end of base segment `segment` leaves. Arcs of one corner become one. Where an end was
  /// lengthened (base_curve.cpp) the base does not turn but by rounding, and there is no arc.
  void add_arc(geom::Point from, std::size_t segment) {
    if (!base_.closed && segment + 1 < base_.source.size() && base_.source[segment] == base_.source[segment + 1]) {
      return add_line(from, segment);
    }
    const OffsetEdge edge = OffsetEdge::arc(base_.source[segment]);
    if (piece_.edges.empty() || piece_.edges.back() != edge) add(from, edge);
  }
  /// Ends an open curve at p.
  OffsetPiece finish_open(geom::Point p) {
    const geom::Point q = base_.user(p);
    if (!piece_.points.empty() && piece_.points.back() == q) {
      piece_.edges.pop_back();
    } else {
      piece_.points.push_back(q);
    }
    return piece_.points.size() < 2 ? OffsetPiece{} : finish();
  }
  OffsetPiece finish_closed() {
    piece_.closed = true;
    if (piece_.points.size() > 1 && piece_.points.front() == piece_.points.back()) {
      piece_.points.pop_back();
      piece_.edges.pop_back();
    }
    // Two arcs make a lens; two lines make nothing.
    const bool round = !piece_.edges.empty() && keeps_arcs_ && (piece_.edges.front().is_arc() || piece_.edges.back().is_arc());
    return piece_.points.size() < (round ? 2 : 3) ? OffsetPiece{} : finish();
  }

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
  OffsetPiece finish() {
    if (!keeps_arcs_) {
      for (OffsetEdge& edge : piece_.edges) edge = OffsetEdge::line(edge.base_edge());
    }
    return std::move(piece_);
  }

  const BaseCurve& base_;
  bool keeps_arcs_;  // chord bevels are the chords of what is left of their arcs
  OffsetPiece piece_;
};

}  // namespace dobra::offset
