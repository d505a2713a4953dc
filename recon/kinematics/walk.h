#pragma once
// A line through a map that is affine in pieces: a vertex wherever the formula changes. The piece at the middle of a
// stretch tells how far it holds; what is left on both sides is cut in the same way.

#include <algorithm>
#include <cmath>
#include <vector>

#include "recon/kinematics/affine_piece.h"

namespace recon::kinematics {

/// A line and its image. `before` has a vertex wherever the map changes its formula, so both are true to the map: to
/// rounding, of trishear to the chord tolerance.
struct MovedLine {
  geom::Polyline before, after;
  std::vector<std::size_t> given;  ///< Where the vertices of the given line stand.
};

/// Part of a straight piece, from `from` to `to` of it (0 .. 1), with its formula.
struct Stretch {
  double from = 0.0, to = 1.0;
  geom::Point origin;
  LinearPoint image;
  [[nodiscard]] geom::Point operator()(geom::Point p) const {
    return origin + geom::Vector{image.x(p - origin), image.y(p - origin)};
  }
};

/// The stretches of a -> b, in order, without those shorter than 1e-12 of it.
/// @param piece  piece(p, AffinePiece&) sets the piece that holds at p.
template <class Piece>
void cut_by_pieces(geom::Point a, geom::Point b, double from, double to, Piece& piece, std::vector<Stretch>& cut) {
  constexpr double least = 1e-12;
  if (to - from < least) return;
  const double middle = 0.5 * (from + to);
  AffinePiece here;
  piece(geom::interpolate(a, b, middle), here);
  double low = from;
  double high = to;
  for (const LinearForm& side : here.sides) {
    const double at_a = side(a - here.origin);
    const double at_b = side(b - here.origin);
    if (at_a == at_b) continue;
    const double root = at_a / (at_a - at_b);
    // Of a side through the middle, rounding does not tell on which half the formula holds.
    if (root <= middle + 0.25 * least) low = std::max(low, std::min(root, middle));
    if (root >= middle - 0.25 * least) high = std::min(high, std::max(root, middle));
  }
  cut_by_pieces(a, b, from, low, piece, cut);
  if (high - low >= least) cut.push_back({low, high, here.origin, here.image});
  cut_by_pieces(a, b, high, to, piece, cut);
}

/// @param piece  as above.  @param size  of the map, m: images of a place that differ by more than 1e-9 of it are both
/// kept (the line crosses the fault there).
template <class Piece>
MovedLine walk(const geom::Polyline& line, double size, Piece piece) {
  MovedLine moved;
  moved.before.closed = moved.after.closed = line.closed;
  const auto add = [&](geom::Point p, geom::Point image) {
    moved.before.points.push_back(p);
    moved.after.points.push_back(image);
  };
  std::vector<Stretch> cut;
  const auto image_of = [&](geom::Point p) {
    AffinePiece here;
    piece(p, here);
    return here(p);
  };
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    moved.given.push_back(moved.before.points.size());
    const geom::Point a = line.points[i];
    add(a, image_of(a));
    if (i == line.segment_count()) break;
    const geom::Point b = line.segment(i).to;
    cut.clear();
    cut_by_pieces(a, b, 0.0, 1.0, piece, cut);
    for (std::size_t k = 1; k < cut.size(); ++k) {
      const geom::Point p = geom::interpolate(a, b, cut[k].from);
      const geom::Point behind = cut[k](p);
      const geom::Point ahead = cut[k - 1](p);
      if (geom::distance(ahead, behind) > 1e-9 * size) {
        add(p, ahead);
        add(p, behind);
      } else if (!(cut[k].image == cut[k - 1].image)) {
        add(p, cut[k].to - cut[k].from > cut[k - 1].to - cut[k - 1].from ? behind : ahead);
      }
    }
  }
  return moved;
}

}  // namespace recon::kinematics
