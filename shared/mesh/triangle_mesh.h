#pragma once
// Triangle meshes of plane domains as values: flat arrays indexed by ids, with named sets of edges and nodes, and the
// adjacency that can be derived from them. Made by triangulate.h and delaunay.h, read by fem, io and scene.
// Elements of second order are in element_mesh.h.

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "shared/base/id.h"
#include "shared/geom/box.h"
#include "shared/geom/point.h"

namespace dobra::mesh {

struct NodeTag {
  static constexpr const char* prefix = "n";
};
struct TriangleTag {
  static constexpr const char* prefix = "t";
};
using NodeId = base::Id<NodeTag>;
using TriangleId = base::Id<TriangleTag>;

/// A directed edge, from the first node to the second.
using Edge = std::array<NodeId, 2>;
/// The three nodes of a triangle, anticlockwise.
using Corners = std::array<NodeId, 3>;

struct TriangleMesh {
  std::vector<geom::Point> points;    ///< One a node, m.
  std::vector<Corners> triangles;     ///< Anticlockwise; side i runs from corner i to corner i + 1.
  std::vector<std::int32_t> regions;  ///< One a triangle: tag of the region (material) it belongs to; 0 by default.

  /// Boundary edges by name, the domain on their left. Every boundary edge is in one of them after `triangulate`.
  std::map<std::string, std::vector<Edge>> boundary_sets;
  /// Edges of internal constraints by name, directed as they were given.
  std::map<std::string, std::vector<Edge>> constraint_sets;
  /// Nodes by name.
  std::map<std::string, std::vector<NodeId>> node_sets;

  [[nodiscard]] geom::Point point(NodeId node) const { return points[node.index()]; }
  [[nodiscard]] const Corners& corners(TriangleId triangle) const { return triangles[triangle.index()]; }
  [[nodiscard]] geom::Box box() const { return geom::box_of(points); }
  friend bool operator==(const TriangleMesh&, const TriangleMesh&) = default;
};

/// Signed area of a triangle, m2: positive when anticlockwise.
double area(const TriangleMesh& mesh, TriangleId triangle);
/// Sum of the areas, m2, compensated so that the error does not grow with the number of triangles.
double area(const TriangleMesh& mesh);

/// neighbours[t][i] is the triangle across side i of t; none on the boundary. O(n).
/// @pre every directed side belongs to one triangle (mesh_check.h finds out).
std::vector<std::array<TriangleId, 3>> neighbours_of(const TriangleMesh& mesh);

/// The triangles round each node: those of node n are triangles[first[n]] .. triangles[first[n + 1] - 1], ascending.
struct NodeStars {
  std::vector<std::uint32_t> first;
  std::vector<TriangleId> triangles;
};
NodeStars stars_of(const TriangleMesh& mesh);

/// Sides without a neighbour, directed with the domain on their left, in the order of the triangles.
std::vector<Edge> boundary_edges(const TriangleMesh& mesh);

/// Every edge once, lower node first, ascending.
std::vector<Edge> all_edges(const TriangleMesh& mesh);

/// One flag a node: true for nodes that must not move: on the boundary or in any set.
std::vector<std::uint8_t> fixed_nodes(const TriangleMesh& mesh);

}  // namespace dobra::mesh
