#pragma once
// In which vertex, edge or face a point lies; exact. The face is found from the first edge above the point.

#include "shared/geom/point.h"
#include "shared/topo/ids.h"

namespace dobra::topo {

class Subdivision;

enum class Where { Vertex, Edge, Face };

/// Only the id that `where` names is set.
struct Location {
  Where where = Where::Face;
  VertexId vertex;
  EdgeId edge;
  FaceId face;
};

/// @cost O(log n) for edges that are spread out; up to the number of edges straight above the point.
Location locate(const Subdivision& subdivision, geom::Point p);

}  // namespace dobra::topo
