#include "shared/offset/piece_writer.h"

#include <cmath>

namespace dobra::offset {

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
  while (piece_.points.size() > 1 && piece_.points.front() == piece_.points.back()) drop_last();
  Measure of = measure(distance);
  if (of.turns_back) {
    drop_hairs(of.rounding);
    of = measure(distance);
  }
  // Arcs bend away from what is thin: one that does by more than rounding tells that this is not.
  const bool is_sliver = of.sagitta <= of.rounding && std::abs(of.area) <= of.rounding * of.length;
  return is_sliver ? OffsetPiece{} : finish();
}

PieceWriter::Measure PieceWriter::measure(double distance) const {
  Measure of;
  const std::size_t n = piece_.points.size();
  if (n == 0) return of;
  double greatest = distance;
  for (const geom::Point p : piece_.points) {
    greatest = std::max(
        {greatest, std::abs(p.x), std::abs(p.y), std::abs(p.x - base_.origin.x), std::abs(p.y - base_.origin.y)});
  }
  of.rounding = 0x1p-48 * greatest;
  long double area = 0.0L;
  const geom::Point start = piece_.points.front();
  geom::Vector before = start - piece_.points.back();
  for (std::size_t i = 0; i < n; ++i) {
    const geom::Point p = piece_.points[i];
    const geom::Vector side = piece_.points[i + 1 == n ? 0 : i + 1] - p;
    const double squared = geom::dot(side, side);
    if (is_curved(piece_.edges[i])) of.sagitta = std::max(of.sagitta, squared / (8.0 * distance));
    of.length += std::sqrt(squared);
    area += geom::cross(p - start, side);
    of.turns_back |= squared <= of.rounding * of.rounding;
    if (geom::dot(before, side) < 0.0) {
      const double longer = std::max(squared, geom::dot(before, before));
      of.turns_back |= geom::cross(before, side) * geom::cross(before, side) <= of.rounding * of.rounding * longer;
    }
    before = side;
  }
  of.area = static_cast<double>(area);
  return of;
}

/// One pass with a stack, and then what is left where the end meets the start.
void PieceWriter::drop_hairs(double rounding) {
  std::vector<geom::Point> points;
  std::vector<OffsetEdge> edges;
  // From a over the tip to c: lines only, and no farther from each other than rounding. Two arcs there and back are a
  // lens.
  const auto goes_back = [&](geom::Point a, OffsetEdge to, geom::Point tip, OffsetEdge from, geom::Point c) {
    if (is_curved(to) || is_curved(from)) return false;
    const geom::Vector there = tip - a;
    const geom::Vector back = c - tip;
    const double area = geom::cross(there, back);
    const double longer = std::max(geom::dot(there, there), geom::dot(back, back));
    return geom::dot(there, back) < 0.0 && area * area <= rounding * rounding * longer;
  };
  const auto farther = [](geom::Point tip, geom::Point a, geom::Point c) {
    return geom::length_squared(c - tip) > geom::length_squared(a - tip);
  };
  for (std::size_t i = 0; i < piece_.points.size(); ++i) {
    const geom::Point p = piece_.points[i];
    for (std::size_t n = points.size(); n > 1 && goes_back(points[n - 2], edges[n - 2], points[n - 1], edges[n - 1], p);
         --n) {
      // What is left of the longer way keeps its name.
      if (farther(points[n - 1], points[n - 2], p)) edges[n - 2] = edges[n - 1];
      points.pop_back();
      edges.pop_back();
    }
    if (!points.empty() && geom::distance(points.back(), p) <= rounding) {
      edges.back() = piece_.edges[i];
      continue;
    }
    points.push_back(p);
    edges.push_back(piece_.edges[i]);
  }
  for (bool going = true; going && points.size() > 2;) {
    const std::size_t n = points.size();
    going = true;
    if (geom::distance(points.back(), points.front()) <= rounding ||
        goes_back(points[n - 2], edges[n - 2], points[n - 1], edges[n - 1], points[0])) {
      points.pop_back();
      edges.pop_back();
    } else if (goes_back(points[n - 1], edges[n - 1], points[0], edges[0], points[1])) {
      points.erase(points.begin());
      edges.erase(edges.begin());
    } else {
      going = false;
    }
  }
  piece_.points = std::move(points);
  piece_.edges = std::move(edges);
}

OffsetPiece PieceWriter::finish() {
  if (!keeps_arcs_) {
    for (OffsetEdge& edge : piece_.edges) edge = OffsetEdge::line(edge.base_edge());
  }
  return std::move(piece_);
}

}  // namespace dobra::offset
