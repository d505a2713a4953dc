#pragma once
// A triangle mesh on trimmed surfaces: what every mesher of surfaces gives. Flat arrays indexed by ids, as
// mesh::TriangleMesh, with points in space and each corner's place in the chart of its face.

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "shared/base/finding.h"
#include "shared/geom/point.h"
#include "shared/geom/point3.h"
#include "shared/mesh/triangle_mesh.h"

namespace dobra::surf::mesh {

using dobra::mesh::Corners;
using dobra::mesh::Edge;
using dobra::mesh::NodeId;
using dobra::mesh::TriangleId;

struct SurfaceMesh {
  std::vector<geom::Point3> points;  ///< One a node, m, on the surface.
  /// Anticlockwise where the face is looked at against its normal (that of its surface, or the opposite where the face
  /// is reversed). Side i runs from corner i to corner i + 1.
  std::vector<Corners> triangles;
  /// One a triangle: where its corners lie in the chart of its face. A node on a seam, at a pole or of two faces has
  /// several places.
  std::vector<std::array<geom::Point, 3>> places;
  std::vector<std::uint32_t> faces;   ///< One a triangle: which of the surfaces given.
  std::vector<std::int32_t> regions;  ///< One a triangle.

  std::map<std::string, std::vector<Edge>> boundary_sets;  ///< As those of mesh::TriangleMesh; so below.
  std::map<std::string, std::vector<Edge>> constraint_sets;
  std::map<std::string, std::vector<NodeId>> node_sets;
  std::map<std::int32_t, std::string> region_names;

  [[nodiscard]] geom::Point3 point(NodeId node) const { return points[node.index()]; }
  friend bool operator==(const SurfaceMesh&, const SurfaceMesh&) = default;
};

using Finding = base::Finding;

}  // namespace dobra::surf::mesh
