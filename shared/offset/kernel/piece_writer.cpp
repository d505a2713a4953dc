#include "shared/offset/kernel/piece_writer.h"

#include <algorithm>
#include <cmath>

namespace dobra::offset {
inline namespace kernel {

OffsetPiece PieceWriter::finish_open(geom::Point p) {
  const geom::Point q = base_.user(p);
  if (!piece_.points.empty() && piece_.points.back() == q) {
    piece_.edges.pop_back();
  } else {
    piece_.points.push_back(q);
  }
  return piece_.points.size() < 2 ? OffsetPiece{} : finish();
}

OffsetPiece PieceWriter::finish_closed(double distance) {
  piece_.closed = true;
  if (piece_.points.size() > 1 && piece_.points.front() == piece_.points.back()) {
    piece_.points.pop_back();
    piece_.edges.pop_back();
  }
  return is_sliver(distance) ? OffsetPiece{} : finish();
}

/// Arcs bend away from what is thin: one that does by more than rounding tells that this is not.
bool PieceWriter::is_sliver(double distance) const {
  const std::size_t n = piece_.points.size();
  if (n == 0) return true;
  // Of places near the base: a mitre's tip may lie much farther, and what reaches there is no slit.
  const double rounding =
      0x1p-48 * (base_.size + distance + std::max(std::abs(base_.origin.x), std::abs(base_.origin.y)));
  double length = 0.0;
  Real area = 0;
  const geom::Point start = piece_.points.front();
  for (std::size_t i = 0; i < n; ++i) {
    const geom::Point p = piece_.points[i];
    const geom::Vector side = piece_.points[i + 1 == n ? 0 : i + 1] - p;
    const double squared = geom::dot(side, side);
    if (keeps_arcs_ && piece_.edges[i].is_arc() && squared / (8.0 * distance) > rounding) return false;
    length += std::sqrt(squared);
    area += geom::cross(p - start, side);
  }
  return std::abs(static_cast<double>(area)) <= rounding * length;
}

OffsetPiece PieceWriter::finish() {
  if (!keeps_arcs_) {
    for (OffsetEdge& edge : piece_.edges) edge = OffsetEdge::line(edge.base_edge());
  }
  return std::move(piece_);
}

}  // namespace kernel
}  // namespace dobra::offset
