#pragma once
// Ends of open curves that should be one point: found, and moved. What make_domain joins in silence (below rounding)
// and what repair joins and reports is the same, with another tolerance.

#include <string>
#include <vector>

#include "quebra/sketch/curve.h"

namespace quebra::sketch {

struct End {
  std::size_t curve = 0;
  bool last = false;  ///< The end of the curve, not its start.
  dobra::geom::Point at;
};

/// Of all open curves, start before end, in the order of the curves.
std::vector<End> open_ends(const std::vector<Curve>& curves);

/// Two ends no more than a tolerance apart, as positions in a list of ends, a < b.
struct NearEnds {
  double gap = 0.0;
  std::size_t a = 0;
  std::size_t b = 0;
};
/// Nearest first.  @cost O(n log n + pairs near in x)
std::vector<NearEnds> near_ends(const std::vector<End>& ends, double tolerance);

/// "a gap of 0.4 m between (0, 0) of 'a' and (0, 0.4) of 'b'"
std::string gap_text(const std::vector<Curve>& curves, const End& a, const End& b);

/// Moves an end of a curve to a point near it. @return false, and nothing is moved, where no arc about its centre, or
/// no smooth curve, would end there.
bool move_end(Curve& curve, bool last, dobra::geom::Point to);

/// Makes ends that lie within `tolerance` of each other the same point: that of an arc, or else the first of them in
/// the order of the curves.
void join_ends(std::vector<Curve>& curves, double tolerance);

}  // namespace quebra::sketch
