#include "shared/offset/types/arcs.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dobra::offset {
inline namespace types {

using geom::Point;
using geom::Vector;

namespace {

/// The arc of edge `i`.
struct Arc {
  Point centre;
  Vector from;   ///< Radius to its start.
  double angle;  ///< That it turns through, anticlockwise positive.
};

Point end_of(const OffsetPiece& piece, std::size_t i) { return piece.points[i + 1 == piece.points.size() ? 0 : i + 1]; }

Arc arc_of(const OffsetPiece& piece, const geom::Polyline& base, std::size_t i) {
  const Point centre = base.points[(piece.edges[i].base_edge() + 1U) % base.points.size()];
  const Vector from = piece.points[i] - centre;
  const Vector to = end_of(piece, i) - centre;
  const double sense = piece.side == Side::RightOfTravel ? 1.0 : -1.0;
  double angle = std::atan2(sense * geom::cross(from, to), geom::dot(from, to));
  // A tiny arc may turn back by a rounding; a whole U-turn may come out as just less than minus a half.
  if (angle < -0.5 * std::numbers::pi) angle += 2 * std::numbers::pi;
  return {centre, from, sense * angle};
}

}  // namespace

Chords chords(const OffsetPiece& piece, const geom::Polyline& base, double tolerance) {
  const double step = 2 * std::acos(1 - tolerance);
  Chords made;
  made.polyline.closed = piece.closed;
  made.polyline.points.reserve(piece.points.size());
  made.base_edge.reserve(piece.edges.size());
  const auto add = [&](Point p, std::uint32_t base_edge) {
    made.polyline.points.push_back(p);
    made.base_edge.push_back(base_edge);
  };
  for (std::size_t i = 0; i < piece.edges.size(); ++i) {
    const OffsetEdge edge = piece.edges[i];
    add(piece.points[i], edge.base_edge());
    if (!edge.is_arc()) continue;
    const Arc arc = arc_of(piece, base, i);
    const auto parts = std::max(1L, std::lround(std::ceil(std::abs(arc.angle) / step)));
    for (long k = 1; k < parts; ++k) {
      const double t = arc.angle * static_cast<double>(k) / static_cast<double>(parts);
      add(arc.centre + (std::cos(t) * arc.from + std::sin(t) * geom::left_of(arc.from)), edge.base_edge());
    }
  }
  if (!piece.closed && !piece.points.empty()) made.polyline.points.push_back(piece.points.back());
  return made;
}

double length(const OffsetPiece& piece, const geom::Polyline& base) {
  double sum = 0;
  for (std::size_t i = 0; i < piece.edges.size(); ++i) {
    if (piece.edges[i].is_arc()) {
      const Arc arc = arc_of(piece, base, i);
      sum += geom::length(arc.from) * std::abs(arc.angle);
    } else {
      sum += geom::distance(piece.points[i], end_of(piece, i));
    }
  }
  return sum;
}

double signed_area(const OffsetPiece& piece, const geom::Polyline& base) {
  if (!piece.closed) return 0;
  // From the first point, so that far-off coordinates do not cancel.
  double twice = 0;
  for (std::size_t i = 0; i < piece.edges.size(); ++i) {
    twice += geom::cross(piece.points[i] - piece.points[0], end_of(piece, i) - piece.points[0]);
    if (!piece.edges[i].is_arc()) continue;
    const Arc arc = arc_of(piece, base, i);
    twice += geom::length_squared(arc.from) * (arc.angle - std::sin(arc.angle));
  }
  return 0.5 * twice;
}

}  // namespace types
}  // namespace dobra::offset
