#pragma once
// Names of the entities of a planar subdivision: subdivision -> face -> loop -> half-edge -> edge -> vertex.

#include "shared/base/id.h"

namespace dobra::topo {

struct VertexTag {
  static constexpr const char* prefix = "v";
};
struct EdgeTag {
  static constexpr const char* prefix = "e";
};
struct HalfEdgeTag {
  static constexpr const char* prefix = "h";
};
struct LoopTag {
  static constexpr const char* prefix = "l";
};
struct FaceTag {
  static constexpr const char* prefix = "f";
};

using VertexId = base::Id<VertexTag>;
using EdgeId = base::Id<EdgeTag>;
/// Half-edges 2i and 2i+1 are the two sides of edge i.
using HalfEdgeId = base::Id<HalfEdgeTag>;
using LoopId = base::Id<LoopTag>;
using FaceId = base::Id<FaceTag>;

}  // namespace dobra::topo
