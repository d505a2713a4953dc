#pragma once
// The planar subdivision of arcs, and loops of parts of it. Of use inside this folder.

#include "shared/surf/trim/arcs.h"
#include "shared/surf/trim/recognise.h"
#include "shared/topo/subdivision.h"

namespace dobra::surf::trim {

/// What a half-edge is a chord of.
struct Chord {
  std::size_t arc = 0;
  bool forward = true;  ///< Runs as the arc does.
  bool first = false;   ///< Of the arc's chords, in its direction.
};

struct Faces {
  topo::Subdivision subdivision;
  std::vector<Chord> chords;  ///< One a half-edge.
  double sag = 0.0;           ///< No line is further from its chords, by parts of the chart, about.
};

/// @error CannotMesh with the place, where chords, however short, meet otherwise than their arcs.
base::Result<Faces> faces_of(const Surface& surface, const Arcs& arcs, double chord);

/// Which part of the chart is meant, by face: a number, or -1 for none of them.
using Parts = std::vector<int>;  // one a face id

/// Chords round what has a number, each loop with it on the left and `first` at its beginning.
std::vector<std::vector<topo::HalfEdgeId>> loops_round(const Faces& faces, const Parts& parts, int number);

/// Twice the area within a loop of chords; positive if anticlockwise.
double turned_area(const Faces& faces, const std::vector<topo::HalfEdgeId>& loop);

}  // namespace dobra::surf::trim
