#pragma once
// Writes a curve of lines and arcs as an OffsetPiece: arcs become chords here and nowhere earlier.

#include <cmath>

#include "shared/offset/base_curve.h"

namespace dobra::offset {

/// How an arc of the finished curve is drawn.
enum class ArcStyle { Chords, OneChord };

class PieceWriter {
 public:
  PieceWriter(const BaseCurve& base, double distance, double arc_tolerance, ArcStyle style)
      : base_(base),
        step_(2 * std::acos(1 - arc_tolerance)),
        one_chord_(style == ArcStyle::OneChord ? -2 : std::cos(step_) * distance * distance) {}

  void reserve(std::size_t points) {
    piece_.polyline.points.reserve(points);
    piece_.base_edge.reserve(points);
  }
  /// A vertex, from which an edge parallel to base segment `segment` leaves.
  void add(geom::Point p, std::size_t segment) {
    const geom::Point q = base_.user(p);
    auto& points = piece_.polyline.points;
    if (!points.empty() && points.back() == q) {
      piece_.base_edge.back() = base_.source[segment];
      return;
    }
    points.push_back(q);
    piece_.base_edge.push_back(base_.source[segment]);
  }
  /// The arc about `centre`, anticlockwise from a to b, without its end.
  void add_arc(geom::Point centre, geom::Point a, geom::Point b, std::size_t segment) {
    add(a, segment);
    const geom::Vector from = a - centre;
    const geom::Vector to = b - centre;
    if (geom::dot(from, to) >= one_chord_) return;
    double angle = std::atan2(geom::cross(from, to), geom::dot(from, to));
    if (angle < 0) angle += 2 * std::acos(-1.0);
    const auto parts = std::max<long>(1, std::lround(std::ceil(angle / step_)));
    for (long k = 1; k < parts; ++k) {
      const double t = angle * static_cast<double>(k) / static_cast<double>(parts);
      add(centre + (std::cos(t) * from + std::sin(t) * geom::left_of(from)), segment);
    }
  }
  /// Ends an open curve at p.
  OffsetPiece finish_open(geom::Point p) {
    const geom::Point q = base_.user(p);
    if (!piece_.polyline.points.empty() && piece_.polyline.points.back() == q) {
      piece_.base_edge.pop_back();
    } else {
      piece_.polyline.points.push_back(q);
    }
    while (piece_.base_edge.size() >= piece_.polyline.points.size()) piece_.base_edge.pop_back();
    if (piece_.polyline.points.size() < 2) return {};
    return std::move(piece_);
  }
  OffsetPiece finish_closed() {
    auto& points = piece_.polyline.points;
    piece_.polyline.closed = true;
    if (points.size() > 1 && points.front() == points.back()) {
      points.pop_back();
      piece_.base_edge.pop_back();
    }
    if (points.size() < 3) return {};
    return std::move(piece_);
  }

 private:
  const BaseCurve& base_;
  double step_;
  double one_chord_;  // one chord suffices where the dot product of the two radii is at least this
  OffsetPiece piece_;
};

}  // namespace dobra::offset
