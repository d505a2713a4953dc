#pragma once
// The walls of a fault as functions x(z), and what lies between two of them: exact on their straight pieces.
// Page: docs/algorithms/jigsaw.md

#include <vector>

#include "shared/geom/polyline.h"

namespace recon {
namespace geom = dobra::geom;
}  // namespace recon

namespace recon::jigsaw {

/// A stretch of a wall that only climbs (or only falls) along its line: points with z that does not fall. A level piece
/// is a jump of x.
struct Branch {
  bool climbs = true;
  std::vector<geom::Point> points;
};
/// The stretches of a line between the places where it turns up or down. Turns of less than `rounding` metres are none.
std::vector<Branch> branches_of(const geom::Polyline& line, double rounding);
/// What of a branch lies between two heights; without points if nothing does.
Branch clipped(const Branch& branch, double low, double high);

/// Two walls between two heights, straight in between.
struct WallPiece {
  double low = 0.0, high = 0.0;              ///< z
  double left_low = 0.0, left_high = 0.0;    ///< x of the wall on the left of travel ...
  double right_low = 0.0, right_high = 0.0;  ///< ... and of that on the right.
};

/// Two walls of a fault over their common z.
struct WallPair {
  double sign = 1.0;  ///< 1: the block on the left of travel lies to the left in x; -1: to the right.
  std::vector<WallPiece> pieces;

  [[nodiscard]] double height() const;
};

/// How much walls count at a depth: 1 / (1 + (lean * depth)^2)^2.
struct Trust {
  double datum = 0.0;  ///< z from which depths are counted.
  double lean = 0.0;   ///< 1/m; 0: everywhere alike.
};
/// Integrals over z of the trust, m, and of the trust times x(right) - x(left), m2, and times its square, m3.
struct Distance {
  double height = 0.0, moment = 0.0, squared = 0.0;
  Distance& operator+=(const Distance& more);
};
Distance distance_of(const WallPair& pair, const Trust& trust);

/// @pre both climb, or neither.
WallPair pair_of(const Branch& left, const Branch& right);

/// Areas between the walls, those that gape and those that overlap apart, each with the place where it is widest.
struct Opening {
  double gap = 0.0, overlap = 0.0;  ///< m2
  double widest_gap = 0.0, widest_overlap = 0.0;
  geom::Point gap_at, overlap_at;
  Opening& operator+=(const Opening& more);
};
Opening opening_of(const WallPair& pair);
/// The line in the middle between both walls, upwards.
std::vector<geom::Point> mean_of(const WallPair& pair);

}  // namespace recon::jigsaw
