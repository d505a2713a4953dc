// 1. Number the physical groups: node sets (points), side sets (curves), regions (surfaces).
// 2. Find the corners: nodes of node sets, and nodes where the edges of the sets do not simply pass through.
// 3. Cut the sets at the corners into chains: each is one curve entity.
// 4. Give every node to the entity of least dimension that it lies on.
// 5. Write the sections; version 2.2 needs steps 1 and 5 only.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <span>
#include <utility>

#include "shared/base/disjoint_sets.h"
#include "shared/base/text.h"
#include "shared/io/file.h"
#include "shared/io/meshes/mesh_sides.h"
#include "shared/io/meshes/msh.h"
#include "shared/io/scan.h"

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

struct SetEdge {
  Edge edge;
  NodeId middle;          // none for first order
  std::size_t group = 0;  // position in Model::curve_names
  std::size_t chain = 0;  // position in Model::chains
};

struct Chain {
  std::size_t group = 0;
  std::vector<std::size_t> edges;  // positions in Model::edges, ascending
};

// What the sections are written from.
struct Model {
  const ElementMesh& mesh;
  std::vector<std::string> point_names;  // node sets
  std::vector<std::string> curve_names;  // side sets
  std::vector<SetEdge> edges;
  std::vector<Chain> chains;
  std::map<std::size_t, std::vector<std::size_t>> corners;          // node -> its node sets, ascending
  std::vector<std::int32_t> regions;                                // ascending, without repetition
  std::vector<std::pair<std::int64_t, std::string>> region_groups;  // physical tag and name, one a region
  Heights heights = {};
};

std::size_t region_index(const Model& model, std::size_t element) {
  const auto at = std::lower_bound(model.regions.begin(), model.regions.end(), model.mesh.regions[element]);
  return static_cast<std::size_t>(at - model.regions.begin());
}

// gmsh's number of an element type, and of the line that is its side.
int gmsh_type(mesh::ElementType type) {
  switch (type) {
    case mesh::ElementType::T3:
      return 2;
    case mesh::ElementType::T6:
      return 9;
    case mesh::ElementType::Q4:
      return 3;
    case mesh::ElementType::Q8:
      return 16;
  }
  return 0;
}
int gmsh_type(const SetEdge& edge) { return edge.middle.valid() ? 8 : 1; }

std::string nodes_text(std::span<const NodeId> nodes) {
  std::string text;
  for (const NodeId node : nodes) text += fmt::format(" {}", node.index() + 1);
  return text + '\n';
}
std::string nodes_text(const SetEdge& edge) {
  const std::array<NodeId, 3> nodes{edge.edge[0], edge.edge[1], edge.middle};
  return nodes_text(std::span(nodes).first(edge.middle.valid() ? 3 : 2));
}

/// A name as it can stand between quotes.
std::string quotable(const std::string& name) {
  std::string result = name.empty() ? "_" : name;
  std::replace(result.begin(), result.end(), '"', '\'');
  std::replace(result.begin(), result.end(), '\r', ' ');
  std::replace(result.begin(), result.end(), '\n', ' ');
  return result;
}

/// The quotable names of one kind of sets, no two alike.
class Names {
 public:
  explicit Names(const std::vector<std::string>& all) {
    for (const std::string& name : all) {
      if (quotable(name) == name) used_.insert(name);
    }
    for (const std::string& name : all) {
      if (quotable(name) == name) continue;
      std::string free = quotable(name);
      for (int i = 2; !used_.insert(free).second; ++i) free = fmt::format("{}_{}", quotable(name), i);
      renamed_.emplace(name, std::move(free));
    }
  }
  [[nodiscard]] std::string of(const std::string& name) const {
    const auto found = renamed_.find(name);
    return found == renamed_.end() ? name : found->second;
  }
  [[nodiscard]] const std::map<std::string, std::string>& renamed() const { return renamed_; }

 private:
  std::set<std::string> used_;
  std::map<std::string, std::string> renamed_;
};

struct AllNames {
  Names sides, nodes, regions;
};
AllNames names_of(const ElementMesh& mesh) {
  const auto keys = [](const auto& sets) {
    std::vector<std::string> names;
    for (const auto& [name, members] : sets) names.push_back(name);
    return names;
  };
  std::vector<std::string> regions;
  for (const auto& [tag, name] : mesh.region_names) regions.push_back(name);
  return {Names(keys(mesh.side_sets)), Names(keys(mesh.node_sets)), Names(regions)};
}

ElementMesh renamed(ElementMesh mesh, const AllNames& names) {
  const auto rename = [](auto& sets, const Names& all) {
    auto old = std::exchange(sets, {});
    for (auto& [name, members] : old) sets.emplace(all.of(name), std::move(members));
  };
  rename(mesh.side_sets, names.sides);
  rename(mesh.node_sets, names.nodes);
  for (auto& [tag, name] : mesh.region_names) name = names.regions.of(name);
  return mesh;
}

// Step 1.
Model numbered(const ElementMesh& mesh) {
  Model model{.mesh = mesh,
              .point_names = {},
              .curve_names = {},
              .edges = {},
              .chains = {},
              .corners = {},
              .regions = {},
              .region_groups = {}};
  for (const auto& [name, nodes] : mesh.node_sets) {
    for (const NodeId node : nodes) {
      std::vector<std::size_t>& sets = model.corners[node.index()];
      if (sets.empty() || sets.back() != model.point_names.size()) sets.push_back(model.point_names.size());
    }
    model.point_names.push_back(name);
  }
  for (const auto& [name, sides] : mesh.side_sets) {
    for (const ElementSide& side : sides) {
      const auto [from, to, middle] = side_nodes(mesh, side);
      model.edges.push_back({{from, to}, middle, model.curve_names.size(), 0});
    }
    model.curve_names.push_back(name);
  }
  const std::set<std::int32_t> regions(mesh.regions.begin(), mesh.regions.end());
  model.regions.assign(regions.begin(), regions.end());
  std::int64_t free_tag = std::max<std::int64_t>(0, model.regions.back());
  for (const std::int32_t region : regions) {
    const auto named = mesh.region_names.find(region);
    const bool has_name = named != mesh.region_names.end();
    std::string name = fmt::format("region:{}", region);
    if (has_name) name = region > 0 ? named->second : name + ':' + named->second;
    model.region_groups.emplace_back(region > 0 ? region : ++free_tag, std::move(name));
  }
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
  base::DisjointSets chains(model.edges.size());
  for (const auto& [node, edges] : at_node) {
    const bool passes = edges.size() == 2 && model.edges[edges[0]].group == model.edges[edges[1]].group;
    if (!passes) model.corners.try_emplace(node);
    if (model.corners.contains(node)) continue;
    chains.join(edges[0], edges[1]);
  }
  std::map<std::size_t, std::size_t> chain_of_root;
  for (std::size_t e = 0; e < model.edges.size(); ++e) {
    const auto [at, is_new] = chain_of_root.try_emplace(chains.root(e), model.chains.size());
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
  for (std::size_t e = model.mesh.element_count(); e-- > 0;) {
    for (const NodeId node : model.mesh.nodes_of(ElementId(e))) owner[node.index()] = {2, region_index(model, e)};
  }
  for (std::size_t e = model.edges.size(); e-- > 0;) {
    const Owner chain{1, model.edges[e].chain};
    for (const NodeId node : model.edges[e].edge) owner[node.index()] = chain;
    if (model.edges[e].middle.valid()) owner[model.edges[e].middle.index()] = chain;
  }
  for (const auto& [node, sets] : model.corners) owner[node] = {0, node};
  return owner;
}

std::string z_text(const Model& model, std::size_t node) {
  return model.heights.empty() ? "0" : base::number_text(model.heights[node]);
}

/// The box of an entity's nodes.
class Extent {
 public:
  void add(const Model& model, NodeId node) {
    box_.add(model.mesh.point(node));
    const double z = height(model.heights, node.index());
    low_ = empty_ ? z : std::min(low_, z);
    high_ = empty_ ? z : std::max(high_, z);
    empty_ = false;
  }
  [[nodiscard]] std::string text(const Model& model) const {
    const auto z = [&](double value) { return model.heights.empty() ? std::string("0") : base::number_text(value); };
    return fmt::format("{} {} {} {} {} {}", base::number_text(box_.low.x), base::number_text(box_.low.y), z(low_),
                       base::number_text(box_.high.x), base::number_text(box_.high.y), z(high_));
  }

 private:
  geom::Box box_;
  double low_ = 0.0, high_ = 0.0;
  bool empty_ = true;
};

void write_names(const Model& model, std::string& text) {
  text +=
      fmt::format("$PhysicalNames\n{}\n", model.point_names.size() + model.curve_names.size() + model.regions.size());
  for (std::size_t i = 0; i < model.point_names.size(); ++i)
    text += fmt::format("0 {} \"{}\"\n", i + 1, model.point_names[i]);
  for (std::size_t i = 0; i < model.curve_names.size(); ++i)
    text += fmt::format("1 {} \"{}\"\n", i + 1, model.curve_names[i]);
  for (const auto& [tag, name] : model.region_groups) text += fmt::format("2 {} \"{}\"\n", tag, name);
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
    if (left && right && model.mesh.regions[left->element.index()] == model.mesh.regions[right->element.index()])
      continue;
    if (left) bounds[region_index(model, left->element.index())].push_back(tag);
    if (right) bounds[region_index(model, right->element.index())].push_back(-tag);
  }
  return bounds;
}

void write_entities(const Model& model, std::string& text) {
  text += fmt::format("$Entities\n{} {} {} 0\n", model.corners.size(), model.chains.size(), model.regions.size());
  for (const auto& [node, sets] : model.corners) {
    const geom::Point p = model.mesh.points[node];
    text += fmt::format("{} {} {} {} {}", node + 1, base::number_text(p.x), base::number_text(p.y), z_text(model, node),
                        sets.size());
    for (const std::size_t set : sets) text += fmt::format(" {}", set + 1);
    text += '\n';
  }
  for (std::size_t c = 0; c < model.chains.size(); ++c) {
    Extent box;
    for (const std::size_t e : model.chains[c].edges) {
      for (const NodeId node : model.edges[e].edge) box.add(model, node);
    }
    text += fmt::format("{} {} 1 {}{}\n", c + 1, box.text(model), model.chains[c].group + 1,
                        ends_text(model, model.chains[c]));
  }
  std::vector<Extent> boxes(model.regions.size());
  for (std::size_t e = 0; e < model.mesh.element_count(); ++e) {
    for (const NodeId node : model.mesh.nodes_of(ElementId(e))) boxes[region_index(model, e)].add(model, node);
  }
  const auto bounds = bounding_curves(model);
  for (std::size_t r = 0; r < model.regions.size(); ++r) {
    text += fmt::format("{} {} 1 {} {}", r + 1, boxes[r].text(model), model.region_groups[r].first, bounds[r].size());
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
      text += base::number_text(p.x) + ' ' + base::number_text(p.y) + ' ' + z_text(model, n) + '\n';
    }
  }
  text += "$EndNodes\n";
}

void write_elements(const Model& model, std::string& text) {
  const mesh::ElementMesh& mesh = model.mesh;
  const auto is_named = [](const auto& corner) { return !corner.second.empty(); };
  const auto points = static_cast<std::size_t>(std::count_if(model.corners.begin(), model.corners.end(), is_named));
  // Blocks of one entity and one type.
  std::map<std::pair<std::size_t, int>, std::vector<std::size_t>> blocks;
  for (std::size_t e = 0; e < mesh.element_count(); ++e)
    blocks[{region_index(model, e), gmsh_type(mesh.types[e])}].push_back(e);
  const std::size_t total = mesh.element_count() + model.edges.size() + points;
  text += fmt::format("$Elements\n{} {} 1 {}\n", points + model.chains.size() + blocks.size(), total, total);
  std::size_t tag = mesh.element_count() + model.edges.size();
  for (const auto& corner : model.corners) {
    if (is_named(corner)) text += fmt::format("0 {} 15 1\n{} {}\n", corner.first + 1, ++tag, corner.first + 1);
  }
  for (std::size_t c = 0; c < model.chains.size(); ++c) {
    const auto& edges = model.chains[c].edges;
    text += fmt::format("1 {} {} {}\n", c + 1, gmsh_type(model.edges[edges[0]]), edges.size());
    for (const std::size_t e : edges)
      text += fmt::format("{}", mesh.element_count() + e + 1) + nodes_text(model.edges[e]);
  }
  for (const auto& [block, elements] : blocks) {
    text += fmt::format("2 {} {} {}\n", block.first + 1, block.second, elements.size());
    for (const std::size_t e : elements) text += fmt::format("{}", e + 1) + nodes_text(mesh.nodes_of(ElementId(e)));
  }
  text += "$EndElements\n";
}

// Version 2.2: elements carry their physical group themselves.
void write_version_22(const Model& model, std::string& text) {
  const mesh::ElementMesh& mesh = model.mesh;
  text += fmt::format("$Nodes\n{}\n", mesh.points.size());
  for (std::size_t n = 0; n < mesh.points.size(); ++n) {
    text += fmt::format("{} {} {} {}\n", n + 1, base::number_text(mesh.points[n].x),
                        base::number_text(mesh.points[n].y), z_text(model, n));
  }
  std::size_t points = 0;
  for (const auto& [name, nodes] : mesh.node_sets) points += nodes.size();
  text += fmt::format("$EndNodes\n$Elements\n{}\n", mesh.element_count() + model.edges.size() + points);
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const std::size_t region = region_index(model, e);
    text +=
        fmt::format("{} {} 2 {} {}", e + 1, gmsh_type(mesh.types[e]), model.region_groups[region].first, region + 1) +
        nodes_text(mesh.nodes_of(ElementId(e)));
  }
  std::size_t tag = mesh.element_count();
  for (const SetEdge& edge : model.edges) {
    text += fmt::format("{} {} 2 {} {}", ++tag, gmsh_type(edge), edge.group + 1, edge.group + 1) + nodes_text(edge);
  }
  for (std::size_t i = 0; i < model.point_names.size(); ++i) {
    for (const NodeId node : mesh.node_sets.at(model.point_names[i])) {
      text += fmt::format("{} 15 2 {} {} {}\n", ++tag, i + 1, node.index() + 1, node.index() + 1);
    }
  }
  text += "$EndElements\n";
}

}  // namespace

std::map<std::string, std::string> msh_renamings(const ElementMesh& mesh) {
  AllNames names = names_of(mesh);
  std::map<std::string, std::string> all = names.sides.renamed();
  all.insert(names.nodes.renamed().begin(), names.nodes.renamed().end());
  all.insert(names.regions.renamed().begin(), names.regions.renamed().end());
  return all;
}

Result<std::string> msh_text(const ElementMesh& mesh, MshVersion version, Heights heights) {
  DOBRA_TRY_VOID(check_writable(mesh, heights));
  const AllNames names = names_of(mesh);
  if (!names.sides.renamed().empty() || !names.nodes.renamed().empty() || !names.regions.renamed().empty()) {
    return msh_text(renamed(mesh, names), version, heights);
  }
  Model model = numbered(mesh);
  model.heights = heights;
  std::string text = fmt::format("$MeshFormat\n{} 0 8\n$EndMeshFormat\n", version == MshVersion::V22 ? "2.2" : "4.1");
  write_names(model, text);
  if (version == MshVersion::V22) {
    write_version_22(model, text);
    return text;
  }
  cut_into_chains(model);
  write_entities(model, text);
  write_nodes(model, text);
  write_elements(model, text);
  return text;
}

Result<void> write_msh(const std::string& path, const ElementMesh& mesh, MshVersion version) {
  return write_text(path, msh_text(mesh, version));
}

}  // namespace dobra::io::meshes
