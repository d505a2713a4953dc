// 1. Number the physical groups: node sets (points), boundary and constraint sets (curves), regions (surfaces).
// 2. Find the corners: nodes of node sets, and nodes where the edges of the sets do not simply pass through.
// 3. Cut the sets at the corners into chains: each is one curve entity.
// 4. Give every node to the entity of least dimension that it lies on.
// 5. Write the sections.

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "shared/base/text.h"
#include "shared/io/file.h"
#include "shared/io/mesh_sides.h"
#include "shared/io/msh.h"
#include "shared/io/scan.h"

namespace dobra::io {

using base::Error;
using base::ErrorCode;
using base::Result;
using mesh::Edge;
using mesh::NodeId;
using mesh::TriangleMesh;

namespace {

struct SetEdge {
  Edge edge;
  std::size_t group = 0;  // position in Model::curve_names
  std::size_t chain = 0;  // position in Model::chains
};

struct Chain {
  std::size_t group = 0;
  std::vector<std::size_t> edges;  // positions in Model::edges, ascending
};

// What the sections are written from.
struct Model {
  const TriangleMesh& mesh;
  std::vector<std::string> point_names;  // node sets
  std::vector<std::string> curve_names;  // boundary sets, then constraint sets
  std::vector<SetEdge> edges;
  std::vector<Chain> chains;
  std::map<std::size_t, std::vector<std::size_t>> corners;  // node -> its node sets, ascending
  std::vector<std::int32_t> regions;                        // ascending, without repetition
};

std::size_t region_index(const Model& model, mesh::TriangleId triangle) {
  const auto at = std::lower_bound(model.regions.begin(), model.regions.end(), region_of(model.mesh, triangle));
  return static_cast<std::size_t>(at - model.regions.begin());
}

Result<void> check_names(const TriangleMesh& mesh) {
  const auto check = [](const std::string& name) -> Result<void> {
    if (name.find_first_of("\"\r\n") == std::string::npos && !name.empty()) return {};
    return Error{ErrorCode::InvalidOption,
                 fmt::format("set name {} cannot stand in a .msh; use one without quotes and line ends", shown(name))};
  };
  for (const auto& [name, edges] : mesh.boundary_sets) DOBRA_TRY_VOID(check(name));
  for (const auto& [name, edges] : mesh.constraint_sets) DOBRA_TRY_VOID(check(name));
  for (const auto& [name, nodes] : mesh.node_sets) DOBRA_TRY_VOID(check(name));
  return {};
}

// Step 1.
Model numbered(const TriangleMesh& mesh) {
  Model model{
      .mesh = mesh, .point_names = {}, .curve_names = {}, .edges = {}, .chains = {}, .corners = {}, .regions = {}};
  for (const auto& [name, nodes] : mesh.node_sets) {
    for (const NodeId node : nodes) {
      std::vector<std::size_t>& sets = model.corners[node.index()];
      if (sets.empty() || sets.back() != model.point_names.size()) sets.push_back(model.point_names.size());
    }
    model.point_names.push_back(name);
  }
  const auto add = [&](const std::string& name, const std::vector<Edge>& edges) {
    for (const Edge& edge : edges) model.edges.push_back({edge, model.curve_names.size(), 0});
    model.curve_names.push_back(name);
  };
  for (const auto& [name, edges] : mesh.boundary_sets) add(name, edges);
  for (const auto& [name, edges] : mesh.constraint_sets) add("constraint:" + name, edges);
  std::set<std::int32_t> regions;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) regions.insert(region_of(mesh, mesh::TriangleId(t)));
  model.regions.assign(regions.begin(), regions.end());
  return model;
}

// Edges of the sets round each node.
std::map<std::size_t, std::vector<std::size_t>> edges_at_nodes(const Model& model) {
  std::map<std::size_t, std::vector<std::size_t>> at_node;
  for (std::size_t e = 0; e < model.edges.size(); ++e) {
    for (const NodeId node : model.edges[e].edge) at_node[node.index()].push_back(e);
  }
  return at_node;
}

// Steps 2 and 3.
void cut_into_chains(Model& model) {
  const auto at_node = edges_at_nodes(model);
  std::vector<std::size_t> parent(model.edges.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t e) {
    while (parent[e] != e) e = parent[e] = parent[parent[e]];
    return e;
  };
  for (const auto& [node, edges] : at_node) {
    const bool passes = edges.size() == 2 && model.edges[edges[0]].group == model.edges[edges[1]].group;
    if (!passes) model.corners.try_emplace(node);
    if (model.corners.contains(node)) continue;
    const auto [low, high] = std::minmax({root(edges[0]), root(edges[1])});
    parent[high] = low;
  }
  std::map<std::size_t, std::size_t> chain_of_root;
  for (std::size_t e = 0; e < model.edges.size(); ++e) {
    const auto [at, is_new] = chain_of_root.try_emplace(root(e), model.chains.size());
    if (is_new) model.chains.push_back({.group = model.edges[e].group, .edges = {}});
    model.chains[at->second].edges.push_back(e);
    model.edges[e].chain = at->second;
  }
}

struct Owner {
  int dimension = 2;
  std::size_t entity = 0;  // node for 0, chain for 1, region for 2
  friend auto operator<=>(const Owner&, const Owner&) = default;
};

// Step 4.
std::vector<Owner> owners(const Model& model) {
  std::vector<Owner> owner(model.mesh.points.size());
  for (std::size_t t = model.mesh.triangles.size(); t-- > 0;) {
    for (const NodeId node : model.mesh.triangles[t])
      owner[node.index()] = {2, region_index(model, mesh::TriangleId(t))};
  }
  for (std::size_t e = model.edges.size(); e-- > 0;) {
    for (const NodeId node : model.edges[e].edge) owner[node.index()] = {1, model.edges[e].chain};
  }
  for (const auto& [node, sets] : model.corners) owner[node] = {0, node};
  return owner;
}

std::string box_text(const geom::Box& box) {
  return fmt::format("{} {} 0 {} {} 0", base::number_text(box.low.x), base::number_text(box.low.y),
                     base::number_text(box.high.x), base::number_text(box.high.y));
}

void write_names(const Model& model, std::string& text) {
  text +=
      fmt::format("$PhysicalNames\n{}\n", model.point_names.size() + model.curve_names.size() + model.regions.size());
  for (std::size_t i = 0; i < model.point_names.size(); ++i)
    text += fmt::format("0 {} \"{}\"\n", i + 1, model.point_names[i]);
  for (std::size_t i = 0; i < model.curve_names.size(); ++i)
    text += fmt::format("1 {} \"{}\"\n", i + 1, model.curve_names[i]);
  for (std::size_t i = 0; i < model.regions.size(); ++i)
    text += fmt::format("2 {} \"region:{}\"\n", i + 1, model.regions[i]);
  text += "$EndPhysicalNames\n";
}

// " 2 begin -end" of a chain between corners, " 0" of a closed one.
std::string ends_text(const Model& model, const Chain& chain) {
  std::vector<std::size_t> begins;
  std::vector<std::size_t> ends;
  for (const std::size_t e : chain.edges) {
    const Edge& edge = model.edges[e].edge;
    if (model.corners.contains(edge[0].index())) begins.push_back(edge[0].index());
    if (model.corners.contains(edge[1].index())) ends.push_back(edge[1].index());
  }
  // The edges of a set may disagree in direction; then both corners are on one list.
  if (begins.size() == 2 && ends.empty()) ends.push_back(begins.back());
  if (ends.size() == 2 && begins.empty()) begins.push_back(ends.back());
  if (begins.empty() || ends.empty()) return " 0";
  return fmt::format(" 2 {} -{}", begins[0] + 1, ends[0] + 1);
}

// For each region the curves that bound it: +chain where it lies on the left, -chain on the right.
std::vector<std::vector<std::int64_t>> bounding_curves(const Model& model) {
  const MeshSides sides(model.mesh);
  std::vector<std::vector<std::int64_t>> bounds(model.regions.size());
  for (std::size_t c = 0; c < model.chains.size(); ++c) {
    const Edge edge = model.edges[model.chains[c].edges[0]].edge;
    const auto left = sides.left_of(edge);
    const auto right = sides.left_of({edge[1], edge[0]});
    const auto tag = static_cast<std::int64_t>(c + 1);
    if (left && right && region_of(model.mesh, left->triangle) == region_of(model.mesh, right->triangle)) continue;
    if (left) bounds[region_index(model, left->triangle)].push_back(tag);
    if (right) bounds[region_index(model, right->triangle)].push_back(-tag);
  }
  return bounds;
}

void write_entities(const Model& model, std::string& text) {
  text += fmt::format("$Entities\n{} {} {} 0\n", model.corners.size(), model.chains.size(), model.regions.size());
  for (const auto& [node, sets] : model.corners) {
    const geom::Point p = model.mesh.points[node];
    text += fmt::format("{} {} {} 0 {}", node + 1, base::number_text(p.x), base::number_text(p.y), sets.size());
    for (const std::size_t set : sets) text += fmt::format(" {}", set + 1);
    text += '\n';
  }
  for (std::size_t c = 0; c < model.chains.size(); ++c) {
    geom::Box box;
    for (const std::size_t e : model.chains[c].edges) {
      for (const NodeId node : model.edges[e].edge) box.add(model.mesh.point(node));
    }
    text += fmt::format("{} {} 1 {}{}\n", c + 1, box_text(box), model.chains[c].group + 1,
                        ends_text(model, model.chains[c]));
  }
  std::vector<geom::Box> boxes(model.regions.size());
  for (std::size_t t = 0; t < model.mesh.triangles.size(); ++t) {
    for (const NodeId node : model.mesh.triangles[t])
      boxes[region_index(model, mesh::TriangleId(t))].add(model.mesh.point(node));
  }
  const auto bounds = bounding_curves(model);
  for (std::size_t r = 0; r < model.regions.size(); ++r) {
    text += fmt::format("{} {} 1 {} {}", r + 1, box_text(boxes[r]), r + 1, bounds[r].size());
    for (const std::int64_t curve : bounds[r]) text += fmt::format(" {}", curve);
    text += '\n';
  }
  text += "$EndEntities\n";
}

void write_nodes(const Model& model, std::string& text) {
  std::map<Owner, std::vector<std::size_t>> blocks;
  const std::vector<Owner> owner = owners(model);
  for (std::size_t n = 0; n < owner.size(); ++n) blocks[owner[n]].push_back(n);
  text += fmt::format("$Nodes\n{} {} 1 {}\n", blocks.size(), owner.size(), owner.size());
  for (const auto& [entity, nodes] : blocks) {
    text += fmt::format("{} {} 0 {}\n", entity.dimension, entity.entity + 1, nodes.size());
    for (const std::size_t n : nodes) text += fmt::format("{}\n", n + 1);
    for (const std::size_t n : nodes) {
      const geom::Point p = model.mesh.points[n];
      text += base::number_text(p.x) + ' ' + base::number_text(p.y) + " 0\n";
    }
  }
  text += "$EndNodes\n";
}

void write_elements(const Model& model, std::string& text) {
  const std::size_t triangles = model.mesh.triangles.size();
  const auto is_named = [](const auto& corner) { return !corner.second.empty(); };
  const auto points = static_cast<std::size_t>(std::count_if(model.corners.begin(), model.corners.end(), is_named));
  const std::size_t total = triangles + model.edges.size() + points;
  text += fmt::format("$Elements\n{} {} 1 {}\n", points + model.chains.size() + model.regions.size(), total, total);
  std::size_t tag = triangles + model.edges.size();
  for (const auto& corner : model.corners) {
    if (is_named(corner)) text += fmt::format("0 {} 15 1\n{} {}\n", corner.first + 1, ++tag, corner.first + 1);
  }
  for (std::size_t c = 0; c < model.chains.size(); ++c) {
    text += fmt::format("1 {} 1 {}\n", c + 1, model.chains[c].edges.size());
    for (const std::size_t e : model.chains[c].edges) {
      const Edge& edge = model.edges[e].edge;
      text += fmt::format("{} {} {}\n", triangles + e + 1, edge[0].index() + 1, edge[1].index() + 1);
    }
  }
  std::vector<std::vector<std::size_t>> members(model.regions.size());
  for (std::size_t t = 0; t < triangles; ++t) members[region_index(model, mesh::TriangleId(t))].push_back(t);
  for (std::size_t r = 0; r < members.size(); ++r) {
    text += fmt::format("2 {} 2 {}\n", r + 1, members[r].size());
    for (const std::size_t t : members[r]) {
      const mesh::Corners& corners = model.mesh.triangles[t];
      text +=
          fmt::format("{} {} {} {}\n", t + 1, corners[0].index() + 1, corners[1].index() + 1, corners[2].index() + 1);
    }
  }
  text += "$EndElements\n";
}

}  // namespace

Result<std::string> msh_text(const TriangleMesh& mesh) {
  if (mesh.triangles.empty())
    return Error{ErrorCode::CannotMesh, "the mesh has no triangles; there is nothing to write"};
  DOBRA_TRY_VOID(check_finite(mesh.points, "the mesh"));
  DOBRA_TRY_VOID(check_names(mesh));
  Model model = numbered(mesh);
  cut_into_chains(model);
  std::string text = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
  write_names(model, text);
  write_entities(model, text);
  write_nodes(model, text);
  write_elements(model, text);
  return text;
}

Result<void> write_msh(const std::string& path, const TriangleMesh& mesh) {
  DOBRA_TRY(const std::string text, msh_text(mesh));
  return write_file(path, text);
}

}  // namespace dobra::io
