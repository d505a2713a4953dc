#include "shared/fem/problem.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "shared/base/text.h"
#include "shared/fem/mixed.h"

namespace dobra::fem {
namespace {

using base::Error;
using base::ErrorCode;
using base::Place;
using mesh::ElementMesh;

Error unknown(const ElementMesh& mesh, const std::string& where, const char* kind, bool node_sets) {
  std::vector<std::string> names;
  for (const auto& [name, sides] : mesh.side_sets) names.push_back(name);
  if (node_sets) {
    for (const auto& [name, nodes] : mesh.node_sets) names.push_back(name);
  }
  return {ErrorCode::InvalidOption,
          fmt::format("the mesh has no {} '{}'{}", kind, where, base::did_you_mean(where, names)),
          Place{.item = where}};
}

base::Result<void> check_materials(const ElementMesh& mesh, const Problem& problem) {
  for (const auto& [region, material] : problem.materials) {
    const auto named = mesh.region_names.find(region);
    const std::string name =
        named != mesh.region_names.end() ? fmt::format("region '{}'", named->second) : fmt::format("region {}", region);
    DOBRA_TRY_VOID(check(material, name));
  }
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    if (const auto found = problem.materials.find(mesh.regions[e]); found != problem.materials.end()) {
      if (mesh::is_quadratic(mesh.types[e]) || !nearly_incompressible(found->second)) continue;
      const geom::Point at = mesh.points[mesh.nodes[mesh.first[e]].index()];
      return Error{
          ErrorCode::InvalidOption,
          fmt::format("elements of first order lock in plane strain with Poisson's ratio {}, and their stresses "
                      "mean nothing: mesh with order = \"2\" (above {})",
                      base::number_text(found->second.poisson), mixed_above),
          Place{.item = "materials", .x = at.x, .y = at.y}};
    }
    const auto named = mesh.region_names.find(mesh.regions[e]);
    const geom::Point at = mesh.points[mesh.nodes[mesh.first[e]].index()];
    return Error{ErrorCode::InvalidOption,
                 fmt::format("region {}{} has no material; give it one", mesh.regions[e],
                             named != mesh.region_names.end() ? " ('" + named->second + "')" : std::string()),
                 Place{.item = "materials", .x = at.x, .y = at.y}};
  }
  return {};
}

}  // namespace

base::Result<std::vector<mesh::ElementSide>> find_sides(const ElementMesh& mesh, const std::string& where) {
  const auto found = mesh.side_sets.find(where);
  if (found == mesh.side_sets.end()) return unknown(mesh, where, "curve", false);
  return found->second;
}

base::Result<std::vector<mesh::NodeId>> find_nodes(const ElementMesh& mesh, const std::string& where) {
  std::set<mesh::NodeId> nodes;
  if (const auto set = mesh.node_sets.find(where); set != mesh.node_sets.end()) {
    nodes.insert(set->second.begin(), set->second.end());
  } else if (const auto sides = mesh.side_sets.find(where); sides != mesh.side_sets.end()) {
    for (const auto& side : sides->second) {
      for (const mesh::NodeId node : side_nodes(mesh, side)) {
        if (node.valid()) nodes.insert(node);
      }
    }
  } else {
    return unknown(mesh, where, "curve or point", true);
  }
  return std::vector<mesh::NodeId>(nodes.begin(), nodes.end());
}

base::Result<Shares> find_shares(const ElementMesh& mesh, const std::string& where) {
  DOBRA_TRY(auto nodes, find_nodes(mesh, where));
  const double each = mesh.node_sets.contains(where) ? 1.0 / static_cast<double>(nodes.size()) : 1.0;
  return Shares{std::move(nodes), each};
}

base::Result<std::vector<Tie>> equal_displacement(const ElementMesh& mesh, const std::string& where, Axis axis) {
  DOBRA_TRY(const auto nodes, find_nodes(mesh, where));
  std::vector<Tie> ties;
  for (std::size_t i = 1; i < nodes.size(); ++i)
    ties.push_back({"equal displacements of '" + where + "'", {{nodes[i], axis, 1.0}, {nodes[0], axis, -1.0}}, 0.0});
  return ties;
}

Traction uniform(geom::Vector traction) {
  return [traction](geom::Point, geom::Vector) { return traction; };
}

Traction pressure(double pressure) {
  return [pressure](geom::Point, geom::Vector normal) { return -pressure * normal; };
}

Traction linear(geom::Point from, geom::Vector start, geom::Point to, geom::Vector end) {
  return [=](geom::Point at, geom::Vector) {
    const double t = dot(at - from, to - from) / length_squared(to - from);
    return start + t * (end - start);
  };
}

Traction traction_of(std::function<Voigt(geom::Point)> stress) {
  return [stress = std::move(stress)](geom::Point at, geom::Vector n) {
    const Voigt s = stress(at);
    return geom::Vector{s[0] * n.x + s[2] * n.y, s[2] * n.x + s[1] * n.y};
  };
}

base::Result<void> check(const ElementMesh& mesh, const Problem& problem) {
  DOBRA_TRY_VOID(check_materials(mesh, problem));
  for (const Support& support : problem.supports) {
    DOBRA_TRY_VOID(find_nodes(mesh, support.where));
    if (support.normal) DOBRA_TRY_VOID(find_sides(mesh, support.where));
  }
  for (const Spring& spring : problem.springs) {
    DOBRA_TRY_VOID(find_nodes(mesh, spring.where));
    if (spring.kind == SpringKind::Foundation) DOBRA_TRY_VOID(find_sides(mesh, spring.where));
    if (!(spring.x >= 0.0 && spring.y >= 0.0 && std::isfinite(spring.x + spring.y)))
      return Error{ErrorCode::InvalidOption, "the stiffness of a spring must not be negative",
                   Place{.item = spring.where}};
  }
  for (const LoadCase& load : problem.cases) {
    for (const SideLoad& side : load.sides) DOBRA_TRY_VOID(find_sides(mesh, side.where));
    for (const PointLoad& point : load.points) DOBRA_TRY_VOID(find_nodes(mesh, point.where));
  }
  return {};
}

}  // namespace dobra::fem
