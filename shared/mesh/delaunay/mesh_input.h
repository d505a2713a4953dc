#pragma once
// What is to be meshed: points, and straight edges between them that belong to named sets. The discretisation of curves
// is the caller's: every edge given here is found in the mesh (cut only at points that lie exactly on it).

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "shared/mesh/triangle_mesh.h"

namespace dobra::mesh::delaunay {

enum class EdgeKind : std::uint8_t {
  Boundary,    ///< Between inside and outside. A point is inside if an odd number of them lie between it and infinity.
  Interface,   ///< Internal, between two regions: region and hole seeds do not flow across.
  Constraint,  ///< Internal, of the mesh only: offset bands, lines along which nodes are wanted.
};

/// The name and kind that edges share.
struct InputSet {
  std::string name;
  EdgeKind kind = EdgeKind::Boundary;
};

struct InputEdge {
  Edge nodes;             ///< Indices into MeshInput::points; either direction.
  std::uint32_t set = 0;  ///< Index into MeshInput::sets.
};

/// The triangles round `at`, up to boundary and interface edges, get the tag `region`.
struct RegionSeed {
  geom::Point at;
  std::int32_t region = 0;
};

/// A mesh size asked for at a point: a plastic zone, the sizes that an analysis asks for.
struct SizeRequest {
  geom::Point at;
  double size = 0.0;  ///< m, > 0.
};

struct MeshInput {
  std::vector<geom::Point> points;  ///< m. Equal points become one node. Points of no edge are nodes to be kept inside.
  std::vector<InputSet> sets;
  std::vector<InputEdge> edges;
  std::vector<RegionSeed> regions;
  std::vector<geom::Point> holes;  ///< Seeds of holes whose loops are not told apart by parity.
  std::vector<SizeRequest> sizes;
  std::map<std::string, std::vector<NodeId>> node_sets;  ///< Named input points, found again in the mesh.
};

/// Appends the loop or chain `points` as edges of a new set; points equal to ones already in `input` are shared.
/// Linear in the points that `input` has: for building inputs by hand and in tests, not for millions of points.
enum class Closure { Open, Closed };
void add_chain(MeshInput& input, const std::vector<geom::Point>& points, Closure closure, const InputSet& set);

}  // namespace dobra::mesh::delaunay
