#include "shared/io/meshes/mesh_sides.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "shared/base/check.h"
#include "shared/geom/predicates.h"
#include "shared/io/scan.h"
#include "shared/mesh/lips.h"

namespace dobra::io::meshes {

using base::Error;
using base::ErrorCode;
using base::Result;
using mesh::Edge;
using mesh::ElementId;
using mesh::ElementMesh;
using mesh::ElementSide;
using mesh::NodeId;

namespace {

std::uint64_t key_of(NodeId from, NodeId to) {
  return (static_cast<std::uint64_t>(from.index()) << 32U) | static_cast<std::uint64_t>(to.index());
}

std::vector<ElementId> turn_anticlockwise(ElementMesh& mesh) {
  std::vector<ElementId> turned;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const auto corners = static_cast<std::ptrdiff_t>(mesh::corner_count(mesh.types[e]));
    const auto node = mesh.nodes.begin() + mesh.first[e];
    bool clockwise = false;
    for (std::ptrdiff_t i = 0; i < corners; ++i) {
      const auto turn =
          geom::orient2d(mesh.point(node[i]), mesh.point(node[(i + 1) % corners]), mesh.point(node[(i + 2) % corners]));
      if (turn == geom::Sign::Zero) continue;
      clockwise = turn == geom::Sign::Negative;
      if (!clockwise) break;
    }
    if (!clockwise) continue;
    turned.emplace_back(e);
    std::reverse(node + 1, node + corners);
    if (mesh::is_quadratic(mesh.types[e])) std::reverse(node + corners, node + 2 * corners);
  }
  return turned;
}

}  // namespace

MeshSides::MeshSides(const ElementMesh& mesh) {
  sides_.reserve(mesh.nodes.size());
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    for (std::uint32_t i = 0; i < mesh::corner_count(mesh.types[e]); ++i) {
      const ElementSide side{ElementId(e), i};
      const auto nodes = side_nodes(mesh, side);
      sides_.emplace_back(key_of(nodes[0], nodes[1]), side);
    }
  }
  std::sort(sides_.begin(), sides_.end());
}

std::optional<ElementSide> MeshSides::left_of(const Edge& edge) const {
  const std::uint64_t key = key_of(edge[0], edge[1]);
  const auto found = std::lower_bound(sides_.begin(), sides_.end(), std::pair{key, ElementSide{ElementId(0), 0}});
  if (found == sides_.end() || found->first != key) return std::nullopt;
  return found->second;
}

Result<void> check_writable(const ElementMesh& mesh, Heights heights) {
  if (mesh.element_count() == 0)
    return Error{ErrorCode::CannotMesh, "the mesh has no elements; there is nothing to write"};
  DOBRA_TRY_VOID(check_finite(mesh.points, "the mesh"));
  DOBRA_CHECK(heights.empty() || heights.size() == mesh.points.size());
  for (std::size_t n = 0; n < heights.size(); ++n) {
    if (std::isfinite(heights[n])) continue;
    return Error{ErrorCode::NotFinite, fmt::format("node {} of the mesh has no finite height", n + 1)};
  }
  const auto wrong = [](const std::string& what, const std::string& name) {
    return Error{ErrorCode::InvalidOption,
                 fmt::format("{} {} refers to what does not exist in the mesh", what, shown(name))};
  };
  for (const auto& [name, sides] : mesh.side_sets) {
    for (const ElementSide& side : sides) {
      if (!side.element.valid() || side.element.index() >= mesh.element_count() ||
          side.side >= mesh::corner_count(mesh.types[side.element.index()])) {
        return wrong("side set", name);
      }
    }
  }
  for (const auto& [name, nodes] : mesh.node_sets) {
    for (const NodeId node : nodes) {
      if (!node.valid() || node.index() >= mesh.points.size()) return wrong("node set", name);
    }
  }
  return {};
}

Finished finish(ElementMesh& mesh, const EdgeSets& sets, Heights heights) {
  Finished done;
  if (heights.empty()) done.turned = turn_anticlockwise(mesh);
  const MeshSides sides(mesh);
  for (const auto& [name, edges] : sets) {
    auto& set = mesh.side_sets[name];
    for (const Edge& edge : edges) {
      auto side = sides.left_of(edge);
      if (!side) side = sides.left_of({edge[1], edge[0]});
      if (side) {
        set.push_back(*side);
      } else {
        ++done.lost;
      }
    }
  }
  mesh::restore_tips(mesh);
  return done;
}

Result<void> check_names(const ElementMesh& mesh, std::string_view forbidden, std::string_view where,
                         std::string_view advice) {
  const auto check = [&](const std::string& name) -> Result<void> {
    if (name.find_first_of(forbidden) == std::string::npos) return {};
    return Error{ErrorCode::InvalidOption,
                 fmt::format("name {} cannot stand in {}; use {}", shown(name), where, advice)};
  };
  for (const auto& [name, sides] : mesh.side_sets) DOBRA_TRY_VOID(check(name));
  for (const auto& [name, nodes] : mesh.node_sets) DOBRA_TRY_VOID(check(name));
  for (const auto& [tag, name] : mesh.region_names) DOBRA_TRY_VOID(check(name));
  return {};
}

}  // namespace dobra::io::meshes
