#pragma once
// The finite-element mesh that goes on to analysis and to files: triangles and quadrilaterals of first or second order
// with their regions, named sets of sides and nodes, and crack tips. Flat arrays indexed by ids.
//
// Nodes of an element stand as Abaqus and gmsh have them: the corners anticlockwise, then (T6, Q8) the mid-side nodes
// of the sides 1-2, 2-3, 3-1 (3-4, 4-1). Side i runs from corner i to corner i + 1, the element on its left. The lips
// of a crack are distinct nodes at the same points that share only its tips: two side sets of boundary sides,
// "NAME_left" and "NAME_right" of the crack's direction of travel (lips.h).

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "shared/base/result.h"
#include "shared/mesh/triangle_mesh.h"

namespace dobra::mesh {

struct ElementTag {
  static constexpr const char* prefix = "e";
};
using ElementId = base::Id<ElementTag>;

enum class ElementType : std::uint8_t { T3, T6, Q4, Q8 };

constexpr std::size_t corner_count(ElementType type) {
  return type == ElementType::T3 || type == ElementType::T6 ? 3 : 4;
}
constexpr bool is_quadratic(ElementType type) { return type == ElementType::T6 || type == ElementType::Q8; }
constexpr std::size_t node_count(ElementType type) { return corner_count(type) * (is_quadratic(type) ? 2 : 1); }

/// Side `side` (0-based) of an element.
struct ElementSide {
  ElementId element;
  std::uint32_t side = 0;
  friend auto operator<=>(const ElementSide&, const ElementSide&) = default;
};

/// An end of a crack inside the material.
struct CrackTip {
  std::string name;  ///< "NAME_start" or "NAME_end"; a node set of this name holds the node too.
  NodeId node;
  geom::Vector direction;  ///< Unit; where the crack points: from the crack out into the material ahead.
  friend bool operator==(const CrackTip&, const CrackTip&) = default;
};

struct ElementMesh {
  std::vector<geom::Point> points;  ///< One a node, m.
  std::vector<ElementType> types;   ///< One an element.
  std::vector<std::uint32_t>
      first;                  ///< Element e has nodes[first[e]] .. nodes[first[e + 1] - 1]; one more than elements.
  std::vector<NodeId> nodes;  ///< Connectivity.
  std::vector<std::int32_t> regions;  ///< One an element: tag of its region (material), >= 0.

  std::map<std::int32_t, std::string> region_names;  ///< Of the tags that have one.
  /// Sides by name. Of a boundary curve or a lip: sides without a neighbour; of an internal line: the sides on the left
  /// of its travel (their neighbours are on its right).
  std::map<std::string, std::vector<ElementSide>> side_sets;
  std::map<std::string, std::vector<NodeId>> node_sets;
  std::vector<CrackTip> tips;

  [[nodiscard]] std::size_t element_count() const { return types.size(); }
  [[nodiscard]] geom::Point point(NodeId node) const { return points[node.index()]; }
  [[nodiscard]] std::span<const NodeId> nodes_of(ElementId element) const {
    return std::span(nodes).subspan(first[element.index()], node_count(types[element.index()]));
  }
  friend bool operator==(const ElementMesh&, const ElementMesh&) = default;
};

/// Appends an element and returns its id. @pre nodes.size() == node_count(type)
ElementId add_element(ElementMesh& mesh, ElementType type, std::span<const NodeId> nodes, std::int32_t region);

/// The nodes of a side in the order of travel: from corner, to corner, and the mid-side node (none for first order).
std::array<NodeId, 3> side_nodes(const ElementMesh& mesh, ElementSide side);

/// neighbours[first_side + i] across side i of an element, in the order of elements and their corners (3 or 4 each);
/// `element` is none on the boundary. @pre check(mesh)  @cost O(n)
std::vector<ElementSide> neighbours_of(const ElementMesh& mesh);

/// Sides without a neighbour, in the order of the elements. @cost O(n)
std::vector<ElementSide> boundary_sides(const ElementMesh& mesh);

/// Area of an element by its corners and mid-sides (exact for parabolic sides), m2; and of all, compensated.
double area(const ElementMesh& mesh, ElementId element);
double area(const ElementMesh& mesh);

/// A T3 for each triangle; boundary and constraint sets become side sets (of an internal edge the side on its left).
/// @pre check(mesh) (mesh_check.h)  @cost O(n log n)
ElementMesh element_mesh_of(const TriangleMesh& mesh);

/// The corners as triangles, a quadrilateral cut along its shorter diagonal; mid-side nodes stay as nodes of no
/// triangle. Side sets become boundary sets, or constraint sets where they have a neighbour. To draw, to hand to
/// OpenMesh.
TriangleMesh triangle_mesh_of(const ElementMesh& mesh);

/// Ids in range, coordinates finite, corners anticlockwise and convex (exact), a side shared by at most two elements,
/// in opposite directions and with the same mid-side node; sets and tips refer to what exists. Jacobians: order2.h.
/// @error CannotMesh or NotFinite naming the first that breaks a rule, with its place.  @cost O(n log n)
base::Result<void> check(const ElementMesh& mesh);

}  // namespace dobra::mesh
