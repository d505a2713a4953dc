#include "quebra/surfaces/mesh_doubts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>

namespace quebra::surfaces {

using namespace dobra;

namespace {

base::Place at(geom::Point3 p) { return {.x = p.x, .y = p.y, .z = p.z}; }

/// Where the area is missed by most: at the largest triangle of the face whose area is farthest from its surface's.
/// @param areas  of the surfaces of the faces
base::Place area_lost_at(const model::SurfaceMeshed& meshed, const model::SurfaceSet& set,
                         std::span<const std::size_t> owner, std::span<const double> areas) {
  const surf::mesh::SurfaceMesh& mesh = meshed.mesh;
  std::vector<double> lost(areas.begin(), areas.end()), greatest(areas.size(), 0.0);
  std::vector<geom::Point3> at(areas.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::size_t face = owner[mesh.faces[t]];
    const auto& corners = mesh.triangles[t];
    const geom::Point3 a = mesh.point(corners[0]), b = mesh.point(corners[1]), c = mesh.point(corners[2]);
    const double area = 0.5 * geom::length(cross(b - a, c - a));
    lost[face] -= area;
    if (area > greatest[face]) greatest[face] = area, at[face] = a;
  }
  const auto most =
      std::max_element(lost.begin(), lost.end(), [](double p, double q) { return std::abs(p) < std::abs(q); }) -
      lost.begin();
  base::Place place = set.faces[static_cast<std::size_t>(most)].place;
  const geom::Point3 p = at[static_cast<std::size_t>(most)];
  place.x = p.x, place.y = p.y, place.z = p.z;
  return place;
}

/// Nodes round which the triangles are more than one fan: parts of the mesh hang together there alone.
void doubt_nodes(model::SurfaceMeshed& meshed) {
  const surf::mesh::SurfaceMesh& mesh = meshed.mesh;
  // Corner i of triangle t is number 3 t + i; corners at one node are one where their triangles share a side.
  std::vector<std::size_t> parent(3 * mesh.triangles.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  struct Side {
    mesh::NodeId low, high;
    std::size_t at_low, at_high;
  };
  std::vector<Side> sides;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t next = (i + 1) % 3;
      Side side{mesh.triangles[t][i], mesh.triangles[t][next], 3 * t + i, 3 * t + next};
      if (side.high < side.low) std::swap(side.low, side.high), std::swap(side.at_low, side.at_high);
      sides.push_back(side);
    }
  }
  std::sort(sides.begin(), sides.end(),
            [](const Side& a, const Side& b) { return std::pair(a.low, a.high) < std::pair(b.low, b.high); });
  for (std::size_t k = 1; k < sides.size(); ++k) {
    if (sides[k].low != sides[k - 1].low || sides[k].high != sides[k - 1].high) continue;
    parent[root(sides[k].at_low)] = root(sides[k - 1].at_low);
    parent[root(sides[k].at_high)] = root(sides[k - 1].at_high);
  }
  std::vector<std::size_t> fan(mesh.points.size(), parent.size());
  std::vector<mesh::NodeId> hung;
  for (std::size_t c = 0; c < parent.size(); ++c) {
    const auto node = mesh.triangles[c / 3][c % 3];
    std::size_t& known = fan[node.index()];
    if (known == parent.size()) known = root(c);
    if (known != root(c)) hung.push_back(node);
  }
  std::sort(hung.begin(), hung.end());
  hung.erase(std::unique(hung.begin(), hung.end()), hung.end());
  if (hung.empty()) return;
  meshed.findings.push_back(
      {"hangs_on_node",
       fmt::format("nodes in which parts of the mesh hang together, as holes or surfaces touch there: {}; the first of "
                   "them is here",
                   hung.size()),
       at(mesh.point(hung.front()))});
}

}  // namespace

void doubt_area(const surf::trim::TrimmedSurface& face, const surf::Measured& area,
                std::vector<surf::mesh::Finding>& findings) {
  constexpr double unsure = 1e-3;
  if (area.error <= unsure * std::abs(area.value)) return;
  findings.push_back(
      {"area_unsure",
       fmt::format("the area of the surface, {:.6g} m2, may be off by {:.2g} m2: it bends too closely for "
                   "the places that are looked at",
                   area.value, area.error),
       face.place});
  if (findings.back().place.item.empty()) findings.back().place.item = face.name;
}

void doubt_triangles(model::SurfaceMeshed& meshed, const model::SurfaceSet& set, std::span<const std::size_t> owner,
                     std::span<const double> areas) {
  constexpr double off = 0.01, flat = 0.1;
  const double gap = std::abs(meshed.quality.area - meshed.area_surface);
  if (gap > off * meshed.area_surface) {
    meshed.findings.push_back(
        {"area_off",
         fmt::format("the mesh has an area of {:.6g} m2, its surfaces one of {:.6g} m2: use smaller "
                     "sizes, or look at the borders that were mended",
                     meshed.quality.area, meshed.area_surface),
         area_lost_at(meshed, set, owner, areas)});
  }
  doubt_nodes(meshed);
  if (meshed.quality.triangles == 0 || meshed.quality.alpha_min >= flat) return;
  const auto& corners = meshed.mesh.triangles[meshed.quality.worst.index()];
  meshed.findings.push_back(
      {"flat_triangle",
       fmt::format("a triangle has an alpha of {:.3g}: a corner of its face is sharp, or sides of its border are short",
                   meshed.quality.alpha_min),
       at(meshed.mesh.point(corners[0]))});
}

void doubt_elements(model::SurfaceMeshed& meshed, std::span<const surf::trim::TrimmedSurface> surfaces) {
  const surf::mesh::SurfaceElements& elements = meshed.elements;
  std::vector<std::size_t> against;
  for (std::size_t e = 0; e < elements.mesh.element_count(); ++e) {
    if (!mesh::is_quadratic(elements.mesh.types[e])) continue;
    const auto nodes = elements.mesh.nodes_of(mesh::ElementId(e));
    const std::span places(elements.places.data() + elements.mesh.first[e], nodes.size());
    const std::size_t corners = mesh::corner_count(elements.mesh.types[e]);
    double twice = 0.0;  // of its area in the chart, whose sign says which way it looks
    for (std::size_t i = 0; i < corners; ++i)
      twice += cross(places[i] - places[0], places[(i + 1) % corners] - places[0]);
    const auto point = [&](std::size_t i) { return elements.point(nodes[i]); };
    /// Of the parabola through a corner, a middle and the next corner, at the first.
    const auto way = [&](std::size_t from, std::size_t middle, std::size_t to) {
      return 4.0 * (point(middle) - point(from)) - (point(to) - point(from));
    };
    for (std::size_t i = 0; i < corners; ++i) {
      const std::size_t next = (i + 1) % corners, before = (i + corners - 1) % corners;
      const geom::Vector3 normal = cross(way(i, corners + i, next), way(i, corners + before, before));
      const surf::Jet there = surfaces[elements.faces[e]].surface.jet(places[i]);
      if (twice * dot(normal, cross(there.u, there.v)) < 0.0) {
        against.push_back(e);
        break;
      }
    }
  }
  if (against.empty()) return;
  meshed.findings.push_back(
      {"against_surface",
       fmt::format("elements of second order that look against their surface at a corner: {}; use a smaller turn or "
                   "size; the first of them is here",
                   against.size()),
       at(elements.point(elements.mesh.nodes_of(mesh::ElementId(against.front()))[0]))});
}

}  // namespace quebra::surfaces
