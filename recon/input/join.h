#pragma once
// Pieces of one horizon made one line again, where faults have been taken back. Page: docs/algorithms/repair.md

#include <optional>
#include <string>
#include <vector>

#include "recon/section/section.h"
#include "shared/base/result.h"
#include "shared/scenario/field.h"

namespace recon::input {

/// Parameters of the step `join`.
struct JoinParams {
  std::optional<double> tolerance;
  std::vector<std::string> horizon;
  template <class D>
  static void describe(D& d) {
    d.field("tolerance", &JoinParams::tolerance,
            {.title = "Tolerance",
             .help = "Ends of pieces of one horizon that are nearer than this are joined; by default 0.005 of the "
                     "section's diagonal.",
             .unit = "m",
             .above = 0.0});
    d.field("horizon", &JoinParams::horizon,
            {.title = "Horizons", .help = "Whose pieces are joined; by default all.", .names = "horizon"});
  }
};

struct Join {
  std::string horizon;  ///< Of the pieces together.
  geom::Point at;       ///< The end of the one piece ...
  double gap = 0.0;     ///< ... and how far from it the other one began, m.
};

struct JoinedPieces {
  section::Section section;
  std::vector<Join> joins;
  std::vector<std::string> remarks;  ///< The joins, and horizons that still are in pieces, with their nearest ends.
};

/// The nearest ends first; an end is joined once. A horizon that is whole again has its own name.
/// @error BadSection: no such horizon; a line that crosses itself where it was joined, with the place; those of
///        faces_of().
base::Result<JoinedPieces> join_pieces(section::Section section, const JoinParams& params);

}  // namespace recon::input
