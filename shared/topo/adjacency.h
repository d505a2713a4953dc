#pragma once
// The nine questions which entities of one kind are next to one of another (vertex, edge, face), and measures.
// Results hold each entity once, in order of the walk that finds them. Source: [weiler1985edge] for the nine relations.

#include <vector>

#include "shared/geom/polyline.h"
#include "shared/topo/subdivision.h"

namespace dobra::topo {

std::vector<VertexId> vertices_of_vertex(const Subdivision& s, VertexId v);  ///< VV, anticlockwise.
std::vector<EdgeId> edges_of_vertex(const Subdivision& s, VertexId v);       ///< VE, anticlockwise.
std::vector<FaceId> faces_of_vertex(const Subdivision& s, VertexId v);       ///< VF; the face round an isolated vertex.
std::vector<VertexId> vertices_of_edge(const Subdivision& s, EdgeId e);      ///< EV, always two.
std::vector<EdgeId> edges_of_edge(const Subdivision& s, EdgeId e);           ///< EE, those that share a vertex.
std::vector<FaceId> faces_of_edge(const Subdivision& s, EdgeId e);           ///< EF, one or two.
std::vector<VertexId> vertices_of_face(const Subdivision& s, FaceId f);      ///< FV, of all loops.
std::vector<EdgeId> edges_of_face(const Subdivision& s, FaceId f);           ///< FE, of all loops.
std::vector<FaceId> faces_of_face(const Subdivision& s, FaceId f);           ///< FF, those across an edge.

/// Signed area that the loop runs round, m2: positive anticlockwise; 0 for an isolated vertex.
double signed_area(const Subdivision& s, LoopId l);
/// Area of a face, its holes taken off, m2; of the unbounded face, minus the area of all that it surrounds.
double area(const Subdivision& s, FaceId f);

}  // namespace dobra::topo
