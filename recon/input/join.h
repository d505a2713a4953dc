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

/// One horizon, the ends of whose pieces are joined if they are nearer than the tolerance, m.
struct JoinWish {
  std::string horizon;
  double tolerance = 0.0;
};

struct JoinedPieces {
  section::Section section;
  std::vector<Join> joins;
  /// The joins; ends that were not joined since a fault still displaces the bed between them, or since the pieces
  /// overlap; horizons that still are in pieces, with their nearest ends.
  std::vector<std::string> remarks;
};

/// The nearest ends first; an end is joined once. A horizon that is whole again has its own name. Ends on opposite
/// walls of a fault are joined only where its cutoffs of the bed coincide (faults/between.h). The section keeps its
/// faces.
/// @error BadSection: a line that crosses itself where it was joined, with the place; those of faults::faults_of.
base::Result<JoinedPieces> join_horizons(section::Section section, const std::vector<JoinWish>& wishes);

/// "in 3 pieces; their nearest ends are 2 m apart, at (200, -50)". @pre two pieces at least.
std::string in_pieces(const std::vector<section::Horizon>& pieces);

/// As join_horizons, with the faces of the section made again.
/// @error BadSection: no such horizon; those of join_horizons and faces_of().
base::Result<JoinedPieces> join_pieces(section::Section section, const JoinParams& params);

}  // namespace recon::input
