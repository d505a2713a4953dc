#include "recon/block/counts.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "shared/solid/space.h"

// 1. Equal places are one vertex; faces with the same vertices are one face between two units. 2. Where an edge has two
// faces that lie in one plane and are called alike between the same units, it goes and they become one. 3. A vertex
// goes that has no edge left, or two in a line.

namespace recon::block {
namespace {

using dobra::solid::PlaneId;
using dobra::solid::PointId;
using dobra::solid::Space;
using Edge = std::pair<PointId, PointId>;

struct Facet {
  std::vector<std::vector<PointId>> loops;
  std::set<std::size_t> units;
  std::string name;
  PlaneId plane;
};

PlaneId plane_of(Space& space, const std::vector<PointId>& loop) {
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
    if (!space.collinear(loop[0], loop[i], loop[i + 1]))
      return space.add({{space.rounded(loop[0]), space.rounded(loop[i]), space.rounded(loop[i + 1])}, {}});
  }
  return {};
}

std::vector<Facet> facets_of(std::span<const BlockUnit> units, Space& space) {
  std::vector<Facet> facets;
  std::map<std::vector<PointId>, std::size_t> known;
  for (std::size_t u = 0; u < units.size(); ++u) {
    const auto& mesh = units[u].shape.mesh;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      Facet facet;
      std::vector<PointId> key;
      for (const auto& loop : mesh.faces[f]) {
        auto& corners = facet.loops.emplace_back();
        for (const std::uint32_t p : loop) corners.push_back(space.add(mesh.points[p]));
        key.insert(key.end(), corners.begin(), corners.end());
      }
      std::sort(key.begin(), key.end());
      const auto [at, is_new] = known.try_emplace(std::move(key), facets.size());
      if (is_new) {
        facet.name = units[u].shape.names[f];
        facet.plane = plane_of(space, facet.loops[0]);
        facets.push_back(std::move(facet));
      }
      facets[at->second].units.insert(u);
    }
  }
  return facets;
}

}  // namespace

BlockCounts count(std::span<const BlockUnit> units) {
  Space space;
  const std::vector<Facet> facets = facets_of(units, space);
  std::map<Edge, std::vector<std::size_t>> edges;  // and the facets at each
  for (std::size_t f = 0; f < facets.size(); ++f) {
    for (const auto& loop : facets[f].loops) {
      for (std::size_t i = 0; i < loop.size(); ++i)
        edges[std::minmax(loop[i], loop[(i + 1) % loop.size()])].push_back(f);
    }
  }
  std::vector<std::size_t> joined(facets.size());
  std::iota(joined.begin(), joined.end(), std::size_t{0});
  const auto root = [&](std::size_t f) {
    while (joined[f] != f) f = joined[f] = joined[joined[f]];
    return f;
  };
  std::map<PointId, std::vector<PointId>> neighbours;  // over edges that stay
  for (const auto& [edge, at] : edges) {
    const auto alike = [&](const Facet& a, const Facet& b) {
      return a.name == b.name && a.units == b.units && a.plane.valid() && b.plane.valid() &&
             space.coplanar(a.plane, b.plane);
    };
    if (at.size() == 2 && alike(facets[at[0]], facets[at[1]])) {
      joined[root(at[0])] = root(at[1]);
    } else {
      neighbours[edge.first].push_back(edge.second);
      neighbours[edge.second].push_back(edge.first);
    }
  }
  BlockCounts counts;
  for (std::size_t f = 0; f < facets.size(); ++f) counts.faces += root(f) == f ? 1 : 0;
  std::size_t ends = 0;
  for (const auto& [vertex, others] : neighbours) {
    if (others.size() == 2 && space.collinear(others[0], vertex, others[1])) continue;
    ++counts.vertices;
    ends += others.size();
  }
  counts.edges = ends / 2;
  return counts;
}

}  // namespace recon::block
