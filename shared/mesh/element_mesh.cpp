#include "shared/mesh/element_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "shared/geom/predicates.h"

namespace dobra::mesh {

using base::Error;
using base::ErrorCode;
using base::Place;
using base::Result;
using geom::Point;

namespace {

/// A side as it lies in memory while sides are paired: sorted by its lower node, then its higher one.
struct Side {
  NodeId low, high;
  ElementSide at;
  bool forward;  ///< Runs from low to high.
};

std::vector<Side> sorted_sides(const ElementMesh& mesh) {
  std::vector<Side> sides;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const auto corners = static_cast<std::uint32_t>(corner_count(mesh.types[e]));
    for (std::uint32_t i = 0; i < corners; ++i) {
      const NodeId from = mesh.nodes[mesh.first[e] + i];
      const NodeId to = mesh.nodes[mesh.first[e] + (i + 1) % corners];
      sides.push_back({std::min(from, to), std::max(from, to), {ElementId(e), i}, from < to});
    }
  }
  std::sort(sides.begin(), sides.end(),
            [](const Side& a, const Side& b) { return std::tie(a.low, a.high, a.at) < std::tie(b.low, b.high, b.at); });
  return sides;
}

bool same_ends(const Side& a, const Side& b) { return a.low == b.low && a.high == b.high; }

Error broken(const ElementMesh& mesh, std::string what, std::string item, NodeId at) {
  Place place;
  place.item = std::move(item);
  place.x = mesh.point(at).x;
  place.y = mesh.point(at).y;
  return {ErrorCode::CannotMesh, std::move(what), place};
}

std::string name_of(ElementId element) { return fmt::format("element {}", element.index()); }

Result<void> check_elements(const ElementMesh& mesh) {
  const std::size_t count = mesh.element_count();
  if (mesh.first.size() != count + 1 || mesh.regions.size() != count || mesh.first.back() != mesh.nodes.size()) {
    return Error{ErrorCode::CannotMesh, "the arrays of types, first nodes and regions of the mesh do not fit together"};
  }
  for (std::size_t n = 0; n < mesh.points.size(); ++n) {
    if (!geom::is_finite(mesh.points[n])) {
      return Error{ErrorCode::NotFinite, fmt::format("node {} has a coordinate that is not finite", n)};
    }
  }
  for (std::size_t e = 0; e < count; ++e) {
    const ElementId element(e);
    if (mesh.first[e + 1] - mesh.first[e] != node_count(mesh.types[e])) {
      return Error{ErrorCode::CannotMesh, fmt::format("element {} has the wrong number of nodes for its type", e)};
    }
    for (const NodeId node : mesh.nodes_of(element)) {
      if (node.valid() && node.index() < mesh.points.size()) continue;
      return Error{ErrorCode::CannotMesh, fmt::format("element {} refers to a node that does not exist", e)};
    }
    const auto nodes = mesh.nodes_of(element);
    const std::size_t corners = corner_count(mesh.types[e]);
    for (std::size_t i = 0; i < corners; ++i) {
      const auto corner = [&](std::size_t k) { return mesh.point(nodes[k % corners]); };
      if (geom::orient2d(corner(i), corner(i + 1), corner(i + 2)) == geom::Sign::Positive) continue;
      return broken(mesh, "the corners do not run anticlockwise round a convex element: it is inverted or flat",
                    name_of(element), nodes[i]);
    }
  }
  return {};
}

Result<void> check_sides(const ElementMesh& mesh) {
  const std::vector<Side> sides = sorted_sides(mesh);
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    const Side& a = sides[i];
    const Side& b = sides[i + 1];
    if (!same_ends(a, b)) continue;
    const bool three = i + 2 < sides.size() && same_ends(b, sides[i + 2]);
    if (three || a.forward == b.forward) {
      return broken(mesh, "two elements lie on the same side of one edge", name_of(b.at.element), a.low);
    }
    if (side_nodes(mesh, a.at)[2] != side_nodes(mesh, b.at)[2]) {
      return broken(mesh, "two elements share a side but not its mid-side node", name_of(b.at.element), a.low);
    }
  }
  return {};
}

Result<void> check_sets(const ElementMesh& mesh) {
  for (const auto& [name, sides] : mesh.side_sets) {
    for (const ElementSide& side : sides) {
      if (side.element.valid() && side.element.index() < mesh.element_count() &&
          side.side < corner_count(mesh.types[side.element.index()])) {
        continue;
      }
      return Error{ErrorCode::CannotMesh, fmt::format("side set '{}' refers to a side that does not exist", name)};
    }
  }
  for (const auto& [name, nodes] : mesh.node_sets) {
    for (const NodeId node : nodes) {
      if (node.valid() && node.index() < mesh.points.size()) continue;
      return Error{ErrorCode::CannotMesh, fmt::format("node set '{}' refers to a node that does not exist", name)};
    }
  }
  for (const CrackTip& tip : mesh.tips) {
    if (tip.node.valid() && tip.node.index() < mesh.points.size()) continue;
    return Error{ErrorCode::CannotMesh, fmt::format("crack tip '{}' refers to a node that does not exist", tip.name)};
  }
  return {};
}

}  // namespace

ElementId add_element(ElementMesh& mesh, ElementType type, std::span<const NodeId> nodes, std::int32_t region) {
  if (mesh.first.empty()) mesh.first.push_back(0);
  mesh.types.push_back(type);
  mesh.nodes.insert(mesh.nodes.end(), nodes.begin(), nodes.end());
  mesh.first.push_back(static_cast<std::uint32_t>(mesh.nodes.size()));
  mesh.regions.push_back(region);
  return ElementId(mesh.types.size() - 1);
}

std::array<NodeId, 3> side_nodes(const ElementMesh& mesh, ElementSide side) {
  const ElementType type = mesh.types[side.element.index()];
  const auto nodes = mesh.nodes_of(side.element);
  const std::size_t corners = corner_count(type);
  return {nodes[side.side], nodes[(side.side + 1) % corners],
          is_quadratic(type) ? nodes[corners + side.side] : NodeId()};
}

std::vector<ElementSide> neighbours_of(const ElementMesh& mesh) {
  std::vector<std::size_t> first_side(mesh.element_count() + 1, 0);
  for (std::size_t e = 0; e < mesh.element_count(); ++e)
    first_side[e + 1] = first_side[e] + corner_count(mesh.types[e]);
  std::vector<ElementSide> neighbours(first_side.back());
  const std::vector<Side> sides = sorted_sides(mesh);
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    const Side& a = sides[i];
    const Side& b = sides[i + 1];
    if (!same_ends(a, b)) continue;
    neighbours[first_side[a.at.element.index()] + a.at.side] = b.at;
    neighbours[first_side[b.at.element.index()] + b.at.side] = a.at;
  }
  return neighbours;
}

std::vector<ElementSide> boundary_sides(const ElementMesh& mesh) {
  const std::vector<ElementSide> neighbours = neighbours_of(mesh);
  std::vector<ElementSide> sides;
  std::size_t at = 0;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    for (std::uint32_t i = 0; i < corner_count(mesh.types[e]); ++i, ++at) {
      if (!neighbours[at].element.valid()) sides.push_back({ElementId(e), i});
    }
  }
  return sides;
}

// By Green's theorem side by side, from the first corner so that nothing cancels: a parabolic side through the mid-side
// node m encloses, beyond its chord, 2/3 of the parallelogram that the chord and the rise of m span.
double area(const ElementMesh& mesh, ElementId element) {
  const ElementType type = mesh.types[element.index()];
  const auto nodes = mesh.nodes_of(element);
  const std::size_t corners = corner_count(type);
  const Point origin = mesh.point(nodes[0]);
  double sum = 0.0;
  for (std::size_t i = 0; i < corners; ++i) {
    const Point from = mesh.point(nodes[i]);
    const Point to = mesh.point(nodes[(i + 1) % corners]);
    sum += 0.5 * geom::cross(from - origin, to - origin);
    if (is_quadratic(type)) sum += 2.0 / 3.0 * geom::cross(mesh.point(nodes[corners + i]) - from, to - from);
  }
  return sum;
}

double area(const ElementMesh& mesh) {
  double total = 0.0;
  double rest = 0.0;  // Neumaier's: what rounding took from the total
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const double value = area(mesh, ElementId(e));
    const double next = total + value;
    rest += std::abs(total) >= std::abs(value) ? (total - next) + value : (value - next) + total;
    total = next;
  }
  return total + rest;
}

namespace {

/// Sides of triangles by their directed ends; of all sides those between nodes of named edges.
class SideTable {
 public:
  explicit SideTable(const TriangleMesh& mesh) {
    std::vector<bool> named(mesh.points.size(), false);
    for (const auto* sets : {&mesh.boundary_sets, &mesh.constraint_sets}) {
      for (const auto& [name, edges] : *sets) {
        for (const Edge& edge : edges) named[edge[0].index()] = named[edge[1].index()] = true;
      }
    }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        const Edge edge{mesh.triangles[t][i], mesh.triangles[t][(i + 1) % 3]};
        if (named[edge[0].index()] && named[edge[1].index()]) sides_.push_back({edge, {ElementId(t), i}});
      }
    }
    std::sort(sides_.begin(), sides_.end());
  }
  /// The side that runs from edge[0] to edge[1]; none if no triangle has it.
  [[nodiscard]] ElementSide find(const Edge& edge) const {
    const auto at = std::lower_bound(sides_.begin(), sides_.end(), std::pair{edge, ElementSide{ElementId(0), 0}});
    return at != sides_.end() && at->first == edge ? at->second : ElementSide{};
  }

 private:
  std::vector<std::pair<Edge, ElementSide>> sides_;
};

}  // namespace

ElementMesh element_mesh_of(const TriangleMesh& mesh) {
  ElementMesh result;
  result.points = mesh.points;
  const std::size_t count = mesh.triangles.size();
  result.types.assign(count, ElementType::T3);
  result.first.reserve(count + 1);
  result.nodes.reserve(3 * count);
  result.first.push_back(0);
  for (const Corners& corners : mesh.triangles) {
    result.nodes.insert(result.nodes.end(), corners.begin(), corners.end());
    result.first.push_back(static_cast<std::uint32_t>(result.nodes.size()));
  }
  result.regions = mesh.regions;
  result.regions.resize(count, 0);
  result.node_sets = mesh.node_sets;
  const SideTable table(mesh);
  for (const auto* sets : {&mesh.boundary_sets, &mesh.constraint_sets}) {
    for (const auto& [name, edges] : *sets) {
      auto& sides = result.side_sets[name];
      for (const Edge& edge : edges) {
        ElementSide side = table.find(edge);
        // An internal line may run along the boundary with the domain on its right only.
        if (!side.element.valid()) side = table.find({edge[1], edge[0]});
        if (side.element.valid()) sides.push_back(side);
      }
    }
  }
  return result;
}

TriangleMesh triangle_mesh_of(const ElementMesh& mesh) {
  TriangleMesh result;
  result.points = mesh.points;
  result.node_sets = mesh.node_sets;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const auto n = mesh.nodes_of(ElementId(e));
    if (corner_count(mesh.types[e]) == 3) {
      result.triangles.push_back({n[0], n[1], n[2]});
    } else {
      const bool first = geom::length_squared(mesh.point(n[2]) - mesh.point(n[0])) <=
                         geom::length_squared(mesh.point(n[3]) - mesh.point(n[1]));
      result.triangles.push_back(first ? Corners{n[0], n[1], n[2]} : Corners{n[0], n[1], n[3]});
      result.triangles.push_back(first ? Corners{n[0], n[2], n[3]} : Corners{n[1], n[2], n[3]});
      result.regions.push_back(mesh.regions[e]);
    }
    result.regions.push_back(mesh.regions[e]);
  }
  const std::vector<ElementSide> outer = boundary_sides(mesh);
  for (const auto& [name, sides] : mesh.side_sets) {
    const bool boundary = std::all_of(sides.begin(), sides.end(), [&](const ElementSide& side) {
      return std::binary_search(outer.begin(), outer.end(), side);
    });
    auto& edges = boundary ? result.boundary_sets[name] : result.constraint_sets[name];
    for (const ElementSide& side : sides) {
      const auto nodes = side_nodes(mesh, side);
      edges.push_back({nodes[0], nodes[1]});
    }
  }
  return result;
}

Result<void> check(const ElementMesh& mesh) {
  DOBRA_TRY_VOID(check_elements(mesh));
  DOBRA_TRY_VOID(check_sides(mesh));
  return check_sets(mesh);
}

}  // namespace dobra::mesh
