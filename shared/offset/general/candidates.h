#pragma once
// First half of the general engine: candidate pieces, those of the raw outline on the right side that may be on the
// curve. One pass with a stack. A piece, or a part of one, is removed only on proof that it lies in U (witness.h). All
// proofs keep a margin well above rounding, so nothing valid or merely touching is removed. What is left although it is
// not valid is found by the second half (sections.h). Where line follows line there is nothing to prove. A piece that
// cuts the one before it is likely to be free and is not asked for; every other piece is.

#include <vector>

#include "shared/base/progress.h"
#include "shared/offset/general/witness.h"

namespace dobra::offset::general {

/// Where a piece is cut, and by the site of which other.
struct Trim {
  Flat at;
  std::uint32_t other;  ///< Packed.
};

/// Pieces in the order of the walk.
struct Candidates {
  std::vector<Piece> pieces;
  std::vector<Trim> trims;
  /// @param ends  the outline, or Outline::Ends.
  template <class Ends>
  [[nodiscard]] Flat start(Ends& ends, const Piece& p) const {
    return p.trim_a != Piece::none ? trims[p.trim_a].at : ends.start_of(p.site());
  }
  template <class Ends>
  [[nodiscard]] Flat end(Ends& ends, const Piece& p) const {
    return p.trim_b != Piece::none ? trims[p.trim_b].at : ends.end_of(p.site());
  }
};

/// @param cover  of the same outline; remembers.
/// @param known  what need not be looked at again.
/// @param found  gets what is found to lie in U; may be null.
/// @return       nothing if progress was cancelled.
/// @cost         O(n) on smooth bases, some 15 ns a segment; a clearance query a segment and 0.1 to 1 us on rough ones.
Candidates candidates(const Outline& outline, const Clearance& clearance, WitnessSearch& witnesses, const Buried& known,
                      Buried* found, const base::Progress& progress);

/// Removes a line that is cut from both sides beyond its middle: every point of it is nearer than D to one neighbour or
/// the other.
/// @param size  what is left of it.
bool is_overcut(const Outline& outline, std::uint32_t step, double size, double margin);

}  // namespace dobra::offset::general
