#include "shared/mesh/lips.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "shared/base/disjoint_sets.h"

// 1. The sides of all cracks, on both faces. 2. Corners of elements (element, corner) that share a node of a crack and
// a side that is no crack form the fans. 3. Every fan but the first of a node gets a copy. 4. Sets and tips.

namespace dobra::mesh {

using base::Error;
using base::ErrorCode;
using base::Place;
using base::Result;

namespace {

Error at_node(const ElementMesh& mesh, std::string message, const std::string& crack, NodeId node) {
  Place place;
  place.item = fmt::format("crack '{}'", crack);
  place.x = mesh.point(node).x;
  place.y = mesh.point(node).y;
  return {ErrorCode::CannotMesh, std::move(message), place};
}

/// Sides and corners of elements numbered one after the other: the number of corner (or side) i of element e.
class Numbers {
 public:
  explicit Numbers(const ElementMesh& mesh) : first_(mesh.element_count() + 1, 0) {
    for (std::size_t e = 0; e < mesh.element_count(); ++e) {
      first_[e + 1] = first_[e] + static_cast<std::uint32_t>(corner_count(mesh.types[e]));
    }
  }
  [[nodiscard]] std::uint32_t operator()(ElementSide at) const { return first_[at.element.index()] + at.side; }
  [[nodiscard]] std::size_t count() const { return first_.back(); }

 private:
  std::vector<std::uint32_t> first_;
};

struct Cracks {
  std::vector<std::uint8_t> is_crack;        ///< One a side.
  std::vector<std::uint32_t> edges_at_node;  ///< How many crack edges meet there.
};

Result<Cracks> mark_cracks(const ElementMesh& mesh, std::span<const std::string> names, const Numbers& number,
                           const std::vector<ElementSide>& neighbours) {
  Cracks cracks{std::vector<std::uint8_t>(number.count(), 0), std::vector<std::uint32_t>(mesh.points.size(), 0)};
  for (const std::string& name : names) {
    const auto set = mesh.side_sets.find(name);
    if (set == mesh.side_sets.end()) {
      return Error{ErrorCode::InvalidOption, fmt::format("there is no side set '{}' to open as a crack", name)};
    }
    for (const ElementSide& side : set->second) {
      const auto nodes = side_nodes(mesh, side);
      const ElementSide across = neighbours[number(side)];
      if (!across.element.valid())
        return at_node(mesh, "the crack runs along the boundary: move it inside", name, nodes[0]);
      if (cracks.is_crack[number(side)] != 0) continue;
      cracks.is_crack[number(side)] = cracks.is_crack[number(across)] = 1;
      ++cracks.edges_at_node[nodes[0].index()];
      ++cracks.edges_at_node[nodes[1].index()];
    }
  }
  return cracks;
}

/// Corners by the fans that they are in.
base::DisjointSets fans_of(const ElementMesh& mesh, const Cracks& cracks, const Numbers& number,
                           const std::vector<ElementSide>& neighbours) {
  base::DisjointSets fans(number.count());
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const auto corners = static_cast<std::uint32_t>(corner_count(mesh.types[e]));
    for (std::uint32_t i = 0; i < corners; ++i) {
      const ElementSide side{ElementId(e), i};
      const ElementSide across = neighbours[number(side)];
      if (!across.element.valid() || across < side || cracks.is_crack[number(side)] != 0) continue;
      const auto there = static_cast<std::uint32_t>(corner_count(mesh.types[across.element.index()]));
      fans.join(number(side), number({across.element, (across.side + 1) % there}));
      fans.join(number({ElementId(e), (i + 1) % corners}), number(across));
    }
  }
  return fans;
}

/// Gives every fan beyond the first of a node of a crack a copy of it, and returns the nodes copied, in order.
std::vector<std::pair<NodeId, NodeId>> split_nodes(ElementMesh& mesh, const Cracks& cracks, const Numbers& number,
                                                   base::DisjointSets& fans) {
  std::vector<NodeId> node_of_fan(number.count());
  std::vector<std::uint8_t> taken(mesh.points.size(), 0);
  std::vector<std::pair<NodeId, NodeId>> copies;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    for (std::uint32_t i = 0; i < corner_count(mesh.types[e]); ++i) {
      NodeId& node = mesh.nodes[mesh.first[e] + i];
      if (cracks.edges_at_node[node.index()] == 0) continue;
      NodeId& own = node_of_fan[fans.root(number({ElementId(e), i}))];
      if (!own.valid()) {
        const bool first_fan = std::exchange(taken[node.index()], std::uint8_t{1}) == 0;
        own = first_fan ? node : NodeId(mesh.points.size());
        if (!first_fan) {
          mesh.points.push_back(mesh.point(node));
          copies.emplace_back(node, own);
        }
      }
      node = own;
    }
  }
  return copies;
}

/// The nodes of a set among those of a lip, ascending.
std::vector<NodeId> on_lip(const ElementMesh& mesh, const std::vector<NodeId>& set,
                           const std::vector<ElementSide>& lip) {
  std::set<NodeId> found;
  for (const ElementSide& side : lip) {
    for (const NodeId node : side_nodes(mesh, side)) {
      if (std::find(set.begin(), set.end(), node) != set.end()) found.insert(node);
    }
  }
  return {found.begin(), found.end()};
}

/// The lips' own nodes of named points, as sets. @pre the lips are side sets
void name_lips_of_points(ElementMesh& mesh, std::span<const std::string> cracks, const std::set<NodeId>& opened) {
  std::map<std::string, std::vector<NodeId>> own;
  for (const auto& [name, nodes] : mesh.node_sets) {
    if (std::none_of(nodes.begin(), nodes.end(), [&](NodeId node) { return opened.contains(node); })) continue;
    std::vector<std::string> through;
    for (const std::string& crack : cracks) {
      const auto left = mesh.side_sets.find(crack + "_left");
      if (left != mesh.side_sets.end() && !on_lip(mesh, nodes, left->second).empty()) through.push_back(crack);
    }
    for (const std::string& crack : through) {
      const std::string prefix = through.size() > 1 ? name + "_" + crack : name;
      for (const char* const lip : {"_left", "_right"})
        own[prefix + lip] = on_lip(mesh, nodes, mesh.side_sets.at(crack + lip));
    }
  }
  mesh.node_sets.merge(own);  // what the user gave that name keeps it
}

/// @param ahead  the end of the crack, whose node before it is `behind`.
CrackTip make_tip(const ElementMesh& mesh, std::string name, NodeId ahead, NodeId behind) {
  return {std::move(name), ahead, geom::normalised(mesh.point(ahead) - mesh.point(behind))};
}

/// The ends of a chain of sides in order of travel, or of parts of it in any order: {start, next to it}, {end, before
/// it}.
std::array<std::array<NodeId, 2>, 2> ends_of(const ElementMesh& mesh, const std::vector<ElementSide>& left) {
  std::set<NodeId> starts, ends;
  for (const ElementSide& side : left) {
    const auto nodes = side_nodes(mesh, side);
    starts.insert(nodes[0]);
    ends.insert(nodes[1]);
  }
  const auto begins = [&](const ElementSide& side) { return !ends.contains(side_nodes(mesh, side)[0]); };
  const auto stops = [&](const ElementSide& side) { return !starts.contains(side_nodes(mesh, side)[1]); };
  const auto first_of = std::find_if(left.begin(), left.end(), begins);
  const auto last_of = std::find_if(left.rbegin(), left.rend(), stops);
  const auto first = side_nodes(mesh, first_of == left.end() ? left.front() : *first_of);
  const auto last = side_nodes(mesh, last_of == left.rend() ? left.back() : *last_of);
  return {{{first[0], first[1]}, {last[1], last[0]}}};
}

enum class Tips : std::uint8_t { Directed, Sets };

Result<ElementMesh> open(ElementMesh mesh, std::span<const std::string> names, Tips tips) {
  const Numbers number(mesh);
  const std::vector<ElementSide> neighbours = neighbours_of(mesh);
  DOBRA_TRY(const Cracks cracks, mark_cracks(mesh, names, number, neighbours));
  base::DisjointSets fans = fans_of(mesh, cracks, number, neighbours);
  const auto copies = split_nodes(mesh, cracks, number, fans);

  std::set<NodeId> opened;
  for (const auto& [node, copy] : copies) opened.insert({node, copy});
  for (auto& [name, nodes] : mesh.node_sets) {
    for (const auto& [node, copy] : copies) {
      if (std::find(nodes.begin(), nodes.end(), node) != nodes.end()) nodes.push_back(copy);
    }
  }
  for (const std::string& name : names) {
    const std::vector<ElementSide> left = std::move(mesh.side_sets.extract(name).mapped());
    if (left.empty()) continue;
    std::vector<ElementSide> right;
    for (const ElementSide& side : left) {
      right.push_back(neighbours[number(side)]);
      const auto nodes = side_nodes(mesh, side);
      if (opened.contains(nodes[0]) || opened.contains(nodes[1])) continue;
      return at_node(mesh, "the crack has a single edge between two tips and cannot open: divide it more finely", name,
                     nodes[0]);
    }
    const char* const suffix[] = {"_start", "_end"};
    const auto ends = ends_of(mesh, left);
    for (std::size_t i = 0; i < 2; ++i) {
      if (opened.contains(ends[i][0]) || cracks.edges_at_node[ends[i][0].index()] != 1) continue;
      if (tips == Tips::Directed) mesh.tips.push_back(make_tip(mesh, name + suffix[i], ends[i][0], ends[i][1]));
      mesh.node_sets[name + suffix[i]] = {ends[i][0]};
    }
    mesh.side_sets[name + "_left"] = left;
    mesh.side_sets[name + "_right"] = std::move(right);
  }
  name_lips_of_points(mesh, names, opened);
  return mesh;
}

}  // namespace

Result<ElementMesh> open_lips(ElementMesh mesh, std::span<const std::string> names) {
  DOBRA_TRY_VOID(check(mesh));
  return open(std::move(mesh), names, Tips::Directed);
}

Result<ElementMesh> open_lips_of_sides(ElementMesh mesh, std::span<const std::string> names) {
  return open(std::move(mesh), names, Tips::Sets);
}

void restore_tips(ElementMesh& mesh) {
  mesh.tips.clear();
  for (const auto& [set, left] : mesh.side_sets) {
    if (!set.ends_with("_left") || left.empty()) continue;
    const std::string name = set.substr(0, set.size() - std::string_view("_left").size());
    if (!mesh.side_sets.contains(name + "_right")) continue;
    for (const char* const suffix : {"_start", "_end"}) {
      const auto tip = mesh.node_sets.find(name + suffix);
      if (tip == mesh.node_sets.end() || tip->second.size() != 1) continue;
      // The lips may come in any order from a file: the side that ends or begins at the tip tells the direction.
      for (const ElementSide& side : left) {
        const auto nodes = side_nodes(mesh, side);
        const bool at_start = nodes[0] == tip->second[0];
        if (!at_start && nodes[1] != tip->second[0]) continue;
        const double length = geom::distance(mesh.point(nodes[0]), mesh.point(nodes[1]));
        if (!(length > 0.0) || !std::isfinite(length)) continue;  // A file may hold anything.
        mesh.tips.push_back(make_tip(mesh, tip->first, nodes[at_start ? 0 : 1], nodes[at_start ? 1 : 0]));
        break;
      }
    }
  }
}

}  // namespace dobra::mesh
