// The ring of the domain integrals of a tip: as large as what is round the tip allows.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "shared/fem/assemble.h"
#include "shared/fem/error/hot_spots.h"
#include "shared/fem/fracture/crack.h"

namespace dobra::fem::fracture {
namespace {

using geom::Vector;
using mesh::ElementMesh;
using mesh::NodeId;

/// The largest contour stays this far inside what limits it, so that a whole ring of elements is clear of it.
constexpr double room_used = 0.95;
/// Of the distance to a node with a load: beyond, its stresses, as 1 / r, spoil J.
constexpr double share_of_distance = 0.5;
/// How far a node of the lip may stray from the crack's line, as a fraction of its distance.
constexpr double lip_straightness = 1e-6;

/// Of the nodes of lines those inside the material, and those on the lips: all but the boundary and a line of symmetry.
class LineNodes {
 public:
  LineNodes(const ElementMesh& mesh, const TipFrame& frame)
      : mesh_(mesh), frame_(frame), boundary_(mesh.points.size(), 0) {
    const auto neighbours = neighbours_of(mesh);
    std::size_t at = 0;
    for (std::size_t e = 0; e < mesh.element_count(); ++e) {
      for (std::uint32_t i = 0; i < mesh::corner_count(mesh.types[e]); ++i, ++at) {
        if (neighbours[at].element.valid()) continue;
        for (const NodeId node : side_nodes(mesh, {mesh::ElementId(e), i})) {
          if (node.valid()) boundary_[node.index()] = 1;
        }
      }
    }
  }
  [[nodiscard]] bool inside(NodeId node) const { return boundary_[node.index()] == 0; }
  [[nodiscard]] bool on_lip(NodeId node) const {
    const Vector v = frame_.local(mesh_.point(node) - frame_.at);
    return !inside(node) && v.x < 0.0 && std::abs(v.y) <= -lip_straightness * v.x;
  }

 private:
  const ElementMesh& mesh_;
  const TipFrame& frame_;
  std::vector<char> boundary_;
};

/// Nodes of lines that something acts on and the integrals do not take in.
std::vector<NodeId> nodes_of_lines(const ElementMesh& mesh, const Problem& problem, const LoadCase& load,
                                   const TipFrame& frame) {
  const LineNodes lines(mesh, frame);
  std::vector<NodeId> found;
  const auto add = [&](const std::string& where, bool lips) {
    if (!mesh.side_sets.contains(where)) return;
    const auto nodes = find_nodes(mesh, where).value();
    for (const NodeId node : nodes) {
      if (lines.inside(node) || (lips && lines.on_lip(node))) found.push_back(node);
    }
  };
  for (const PointLoad& own : load.points) add(own.where, true);
  for (const Support& own : problem.supports) add(own.where, true);
  for (const Spring& own : problem.springs) add(own.where, true);
  for (const SideLoad& own : load.sides) add(own.where, false);
  return found;
}

/// Radius of the disc that no element with one of these nodes reaches into.
double clear_of(const ElementMesh& mesh, const TipFrame& frame, const std::vector<NodeId>& nodes) {
  std::vector<char> acted(mesh.points.size(), 0);
  for (const NodeId node : nodes) acted[node.index()] = 1;
  double clear = std::numeric_limits<double>::infinity();
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const auto own = mesh.nodes_of(mesh::ElementId(e));
    if (std::none_of(own.begin(), own.end(), [&](NodeId node) { return acted[node.index()] != 0; })) continue;
    for (const NodeId node : own.first(mesh::corner_count(mesh.types[e])))
      clear = std::min(clear, distance(mesh.point(node), frame.at));
  }
  return clear;
}

}  // namespace

NodeActedOn nearest_acted_on(const ElementMesh& mesh, const Problem& problem, const LoadCase& load,
                             const TipFrame& frame) {
  for (const PointLoad& own : load.points) {
    const auto nodes = find_nodes(mesh, own.where).value();
    if (length(own.force) > 0.0 && std::find(nodes.begin(), nodes.end(), frame.tip.node) != nodes.end())
      return {frame.at, 0.0, 0.0, 0.0};
  }
  std::vector<NodeId> nodes = error::single_nodes_acted_on(mesh, problem, load);
  for (const Tie& tie : problem.ties) {
    for (const TieTerm& term : tie.terms) nodes.push_back(term.node);
  }
  const auto of_lines = nodes_of_lines(mesh, problem, load, frame);
  nodes.insert(nodes.end(), of_lines.begin(), of_lines.end());
  std::erase(nodes, frame.tip.node);  // a support there has no reaction but of symmetry
  NodeActedOn nearest;
  for (const NodeId node : nodes) {
    const double own = distance(mesh.point(node), frame.at);
    if (own >= nearest.distance) continue;
    nearest.at = mesh.point(node);
    nearest.distance = own;
  }
  nearest.clear = clear_of(mesh, frame, nodes);
  for (const PointLoad& own : load.points) {
    const auto loaded = find_nodes(mesh, own.where).value();
    for (const NodeId node : loaded) {
      if (length(own.force) > 0.0 && std::find(nodes.begin(), nodes.end(), node) != nodes.end())
        nearest.half_way = std::min(nearest.half_way, share_of_distance * distance(mesh.point(node), frame.at));
    }
  }
  return nearest;
}

base::Result<Contour> contour_of(const TipFrame& frame, std::optional<double> outer) {
  const NodeActedOn& acted = frame.acted;
  if (acted.distance == 0.0)
    return bad_tip(frame, "a force acts on the tip itself, where the stress is then not that of a crack; move it");
  const double least = 2.0 * frame.length;
  const double room = std::min(frame.room, acted.distance);
  const std::string limit = acted.distance < frame.room
                                ? fmt::format("what acts on the node at ({:.6g}, {:.6g})", acted.at.x, acted.at.y)
                                : std::string("a boundary, another material, another tip or a bend of the crack");
  const double wished = std::min({room_used * frame.room, acted.half_way, acted.clear});
  const double radius = outer.value_or(std::max(wished, std::min(least, room_used * room)));
  if (radius > room)
    return bad_tip(
        frame, fmt::format(
                   "the contour of radius {:.4g} m leaves the straight end of the crack, or meets {}: at most {:.4g} m",
                   radius, limit, room));
  if (radius < least)
    return bad_tip(
        frame, fmt::format("no contour fits: the room round the tip is {:.4g} m, as far as {}, and the contour {:.4g} "
                           "m; the tip's elements are {:.4g} m long, and it must reach twice as far: make them smaller",
                           room, limit, radius, frame.length));
  return Contour{std::max(0.4 * radius, frame.length), radius};
}

}  // namespace dobra::fem::fracture
