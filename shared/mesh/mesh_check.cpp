#include "shared/mesh/mesh_check.h"

#include <fmt/format.h>

#include <algorithm>

#include "shared/base/disjoint_sets.h"
#include "shared/geom/predicates.h"

namespace dobra::mesh {

using base::Error;
using base::ErrorCode;
using base::Place;
using base::Result;

namespace {

Error broken(std::string what, std::string item, geom::Point at) {
  Place place;
  place.item = std::move(item);
  place.x = at.x;
  place.y = at.y;
  return Error{ErrorCode::CannotMesh, std::move(what), place};
}

std::string name_of(std::size_t triangle) { return fmt::format("triangle {}", triangle); }

Result<void> check_triangles(const TriangleMesh& mesh) {
  if (mesh.regions.size() != mesh.triangles.size()) {
    return Error{ErrorCode::CannotMesh, fmt::format("the mesh has {} triangles but {} region tags: give one a triangle",
                                                    mesh.triangles.size(), mesh.regions.size())};
  }
  for (std::size_t n = 0; n < mesh.points.size(); ++n) {
    if (!geom::is_finite(mesh.points[n])) {
      return Error{ErrorCode::NotFinite, fmt::format("node {} has a coordinate that is not finite", n)};
    }
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Corners& corner = mesh.triangles[t];
    for (const NodeId node : corner) {
      if (node.valid() && node.index() < mesh.points.size()) continue;
      return Error{ErrorCode::CannotMesh, fmt::format("triangle {} refers to a node that does not exist", t)};
    }
    if (geom::orient2d(mesh.point(corner[0]), mesh.point(corner[1]), mesh.point(corner[2])) != geom::Sign::Positive) {
      return broken("the corners do not run anticlockwise: the element is inverted or flat", name_of(t),
                    mesh.point(corner[0]));
    }
  }
  return {};
}

std::vector<Edge> directed_sides(const TriangleMesh& mesh) {
  std::vector<Edge> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (const Corners& corner : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) sides.push_back({corner[i], corner[(i + 1) % 3]});
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

Result<void> check_sides(const TriangleMesh& mesh) {
  const std::vector<Edge> sides = directed_sides(mesh);
  const auto twice = std::adjacent_find(sides.begin(), sides.end());
  if (twice != sides.end()) {
    return broken("two triangles lie on the same side of one edge",
                  fmt::format("edge {}-{}", (*twice)[0].index(), (*twice)[1].index()), mesh.point((*twice)[0]));
  }
  for (const auto* sets : {&mesh.boundary_sets, &mesh.constraint_sets}) {
    for (const auto& [name, edges] : *sets) {
      for (const Edge& edge : edges) {
        if (std::binary_search(sides.begin(), sides.end(), edge) ||
            std::binary_search(sides.begin(), sides.end(), Edge{edge[1], edge[0]}))
          continue;
        return broken("an edge of the set is no edge of the mesh", fmt::format("edge set '{}'", name),
                      mesh.point(edge[0]));
      }
    }
  }
  return {};
}

}  // namespace

// Corner 3t + i stands for the corner i of triangle t. Corners joined across a side form the umbrellas; the two
// boundary sides that bound an umbrella follow each other on a boundary loop.
TopologyCounts topology_of(const TriangleMesh& mesh) {
  const auto neighbours = neighbours_of(mesh);
  const std::size_t count = mesh.triangles.size();
  base::DisjointSets component(count);
  base::DisjointSets umbrella(3 * count);
  std::size_t inner = 0;
  std::size_t boundary = 0;
  for (std::size_t t = 0; t < count; ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const TriangleId other = neighbours[t][i];
      if (!other.valid()) ++boundary;
      if (!other.valid() || other.index() < t) continue;
      ++inner;
      component.join(t, other.index());
      for (const std::size_t end : {i, (i + 1) % 3}) {
        const Corners& across = mesh.corners(other);
        const auto at =
            static_cast<std::size_t>(std::find(across.begin(), across.end(), mesh.triangles[t][end]) - across.begin());
        umbrella.join(3 * t + end, 3 * other.index() + at);
      }
    }
  }
  base::DisjointSets loop(3 * count);
  std::size_t loops = boundary;
  for (std::size_t t = 0; t < count; ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (neighbours[t][i].valid()) continue;
      const std::size_t from = loop.root(umbrella.root(3 * t + i));
      const std::size_t to = loop.root(umbrella.root(3 * t + (i + 1) % 3));
      // A side joins two umbrellas that were apart, or closes a loop.
      if (from != to) --loops;
      loop.join(from, to);
    }
  }
  std::vector<std::uint8_t> used(mesh.points.size(), 0);
  for (const Corners& corner : mesh.triangles) {
    for (const NodeId node : corner) used[node.index()] = 1;
  }
  TopologyCounts counts;
  counts.umbrellas = umbrella.set_count();
  counts.edges = inner + boundary;
  counts.triangles = count;
  counts.boundary_edges = boundary;
  counts.components = component.set_count();
  counts.loops = loops;
  counts.unused_nodes = static_cast<std::size_t>(std::count(used.begin(), used.end(), 0));
  return counts;
}

Result<void> check(const TriangleMesh& mesh) {
  DOBRA_TRY_VOID(check_triangles(mesh));
  DOBRA_TRY_VOID(check_sides(mesh));
  const TopologyCounts counts = topology_of(mesh);
  if (!counts.euler_holds()) {
    return Error{ErrorCode::CannotMesh,
                 fmt::format("Euler's relation fails: {} nodes, {} edges, {} triangles, {} loops, {} components",
                             counts.umbrellas, counts.edges, counts.triangles, counts.loops, counts.components)};
  }
  return {};
}

}  // namespace dobra::mesh
