#pragma once
// The geometric layer of the subdivision: curves of any position in, consistent subdivision out. Finds all crossings,
// splits edges there, merges what coincides, and recognises the regions that form. The subdivision stays exact: where
// the rounded crossing lies beside an edge, that edge is bent through it, and a bent piece that would meet something
// else is taken out and inserted again through a queue. So no two edges ever cross or overlap, by exact predicates.
// Page: docs/algorithms/subdivision.md. Source: [cavalcante1991hed]; the queue is ours.

#include <span>
#include <vector>

#include "shared/base/progress.h"
#include "shared/base/result.h"
#include "shared/geom/polyline.h"
#include "shared/topo/subdivision.h"

namespace dobra::topo {

/// What an inserted curve became.
struct Inserted {
  /// From its start to its end, each half-edge starting where the one before ended. Edges that were there already
  /// and those passed twice included.
  std::vector<HalfEdgeId> path;
  std::vector<EdgeId> edges;  ///< Those that are new, ascending.
  std::vector<FaceId> faces;  ///< Those that formed, in order.
};

/// The vertex at p; splits an edge that runs through p exactly, otherwise isolated in its face.
/// @error NotFinite.
base::Result<VertexId> insert(Subdivision& subdivision, geom::Point p);

/// All of it goes in or, on an error, none.
/// @error NotFinite, also for coordinates beyond 3e150; DegenerateCurve for zero length.
/// @cost  O(log n + crossings) for segments that are short against the whole.
base::Result<Inserted> insert(Subdivision& subdivision, const geom::Segment& segment);

/// Repeated points are passed over.
/// @error as above; DegenerateCurve if all points are equal.
base::Result<Inserted> insert(Subdivision& subdivision, const geom::Polyline& curve);

/// Several curves. For each its path, as it is once all of them are in.
/// @error as above; Cancelled.
base::Result<std::vector<std::vector<HalfEdgeId>>> insert(Subdivision& subdivision,
                                                          std::span<const geom::Polyline> curves,
                                                          const base::Progress& progress = {});

/// What happens to a vertex that loses its last edge.
enum class Bare { Remove, Keep };

/// Takes an edge away. Where it divided two faces they merge (attributes: that of the bounded face with the lower id is
/// kept, unless one is the unbounded face, which always stays).
/// @error NotInSubdivision.
base::Result<void> remove(Subdivision& subdivision, EdgeId edge, Bare bare = Bare::Remove);

}  // namespace dobra::topo
