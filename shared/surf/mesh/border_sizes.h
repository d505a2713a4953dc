#pragma once
// The sizes wanted along the pieces of a border: by its curvature and that of the surface, by what comes near, and no
// faster growing than allowed. Internal to division.h.

#include "shared/surf/mesh/border.h"

namespace dobra::surf::mesh {

/// Between two cuts of an edge: what is divided at once.
struct Piece {
  std::size_t edge = 0;
  double s0 = 0.0, s1 = 1.0;
  std::size_t from = 0, to = 0;  ///< Vertices.
  std::size_t first = 0;         ///< The piece that is divided for it: the same curve of the first edge of the group.
  bool along = true;             ///< In the direction of that one.
  /// One point in space: its edge is, or it leads back to its vertex within the tolerance and is not all of a loop.
  bool point = false;
};

/// Sizes at places along a piece, ends among them.
struct Profile {
  std::vector<double> s, travelled, size;  ///< Travelled from the start of the piece, m.
};

/// Pieces of all edges, edge by edge.
std::vector<Piece> pieces_of(const Border& border);

/// One profile a piece; empty for one that is a point or that another is divided for.
/// @param largest  L, one a face.
std::vector<Profile> sizes_along(const Border& border, const std::vector<Piece>& pieces,
                                 std::span<const trim::TrimmedSurface> surfaces, const SizeOptions& sizes,
                                 const std::vector<double>& largest);

/// How many sides the sizes ask for: the integral of ds / h.
double sides_wanted(const Profile& profile);

/// Parameters of the ends of the sides, s0 and s1 among them: as few sides as the sizes allow, at least `least`.
std::vector<double> even_parameters(const EdgeInSpace& edge, const Profile& profile, std::size_t least);

/// Whether an edge of a loop ends in a tip there. @param s  0 or 1
bool ends_in_tip(const BorderEdge& edge, double s);
/// Takes out of a seam what is nearer to a tip at its end than the wheel round that reaches (tips.h).
void clear_tip(const BorderEdge& edge, const Profile& profile, std::vector<double>& parameters);

}  // namespace dobra::surf::mesh
