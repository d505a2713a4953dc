#include "shared/surf/mesh/assemble.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "shared/mesh/lips.h"
#include "shared/surf/mesh/surface_elements.h"

namespace dobra::surf::mesh {

using base::Error;
using base::ErrorCode;
using base::Result;
using geom::Point;
using geom::Point3;
using trim::TrimmedSurface;

namespace {

/// An edge whatever its direction.
Edge undirected(const Edge& edge) { return edge[0] < edge[1] ? edge : Edge{edge[1], edge[0]}; }

class Joiner {
 public:
  Joiner(std::span<const TrimmedSurface> surfaces, const Division& division, std::span<const FaceMesh> faces)
      : surfaces_(surfaces), division_(division), faces_(faces) {}

  Result<SurfaceMesh> run() {
    mesh_.points.resize(division_.nodes);
    for (const ChartInput& input : division_.faces) {
      for (std::size_t i = 0; i < input.node.size(); ++i) mesh_.points[input.node[i]] = input.at[i];
    }
    name_regions();
    for (std::size_t f = 0; f < faces_.size(); ++f) DOBRA_TRY_VOID(add_face(f));
    for (const auto& [name, sides] : division_.cracks_on_seams) {
      for (const auto& [a, b] : sides) {
        if (a != b) mesh_.constraint_sets[name].push_back({NodeId(a), NodeId(b)});
      }
    }
    sort_sets();
    return std::move(mesh_);
  }

 private:
  void name_regions() {
    std::int32_t greatest = 0;
    for (const TrimmedSurface& surface : surfaces_) {
      for (const trim::ChartRegion& region : surface.regions) {
        greatest = std::max(greatest, region.region);
        if (!region.name.empty()) mesh_.region_names.emplace(region.region, region.name);
      }
    }
    std::map<std::string, std::int32_t> tags;
    for (const TrimmedSurface& surface : surfaces_) {
      const bool own = surface.regions.empty() && !surface.name.empty();
      if (own && tags.try_emplace(surface.name, greatest + 1).second) mesh_.region_names[++greatest] = surface.name;
      region_of_face_.push_back(own ? tags.at(surface.name) : -1);
    }
  }

  Result<void> add_face(std::size_t face) {
    const ChartInput& input = division_.faces[face];
    const dobra::mesh::TriangleMesh& chart = faces_[face].chart;
    const bool begins = chart.points.size() >= input.chart.points.size() &&
                        faces_[face].at.size() == chart.points.size() &&
                        std::equal(input.chart.points.begin(), input.chart.points.end(), chart.points.begin());
    if (!begins) {
      return Error{ErrorCode::CannotMesh,
                   fmt::format("the mesh of face {} does not begin with the points of its border", face)};
    }
    std::vector<NodeId> node;
    for (std::size_t i = 0; i < chart.points.size(); ++i) {
      if (i < input.node.size()) {
        node.emplace_back(input.node[i]);
      } else {
        node.emplace_back(mesh_.points.size());
        mesh_.points.push_back(faces_[face].at[i]);
      }
    }
    const bool reversed = surfaces_[face].reversed;
    for (std::size_t t = 0; t < chart.triangles.size(); ++t) {
      Corners corners = chart.triangles[t];
      if (reversed) std::swap(corners[1], corners[2]);
      const Corners own{node[corners[0].index()], node[corners[1].index()], node[corners[2].index()]};
      if (own[0] == own[1] || own[1] == own[2] || own[2] == own[0]) continue;
      mesh_.triangles.push_back(own);
      mesh_.places.push_back({chart.point(corners[0]), chart.point(corners[1]), chart.point(corners[2])});
      mesh_.faces.push_back(static_cast<std::uint32_t>(face));
      mesh_.regions.push_back(region_of_face_[face] >= 0 ? region_of_face_[face] : chart.regions[t]);
    }
    add_sets(chart, node, reversed);
    return {};
  }

  void add_sets(const dobra::mesh::TriangleMesh& chart, const std::vector<NodeId>& node, bool reversed) {
    const auto add = [&](const auto& from, bool turned, auto& to) {
      for (const auto& [name, edges] : from) {
        if (name.empty()) continue;
        for (const Edge& edge : edges) {
          Edge own{node[edge[0].index()], node[edge[1].index()]};
          if (own[0] == own[1]) continue;
          if (turned) std::swap(own[0], own[1]);
          to[name].push_back(own);
        }
      }
    };
    add(chart.boundary_sets, reversed, mesh_.boundary_sets);
    add(chart.constraint_sets, false, mesh_.constraint_sets);
    for (const auto& [name, nodes] : chart.node_sets) {
      std::vector<NodeId>& own = mesh_.node_sets[name];
      for (const NodeId n : nodes) {
        if (std::find(own.begin(), own.end(), node[n.index()]) == own.end()) own.push_back(node[n.index()]);
      }
    }
  }

  /// Boundary sets keep what has one triangle; each side once.
  void sort_sets() {
    std::map<Edge, int> count;
    for (const Corners& c : mesh_.triangles) {
      for (std::size_t i = 0; i < 3; ++i) ++count[undirected({c[i], c[(i + 1) % 3]})];
    }
    auto boundary = std::exchange(mesh_.boundary_sets, {});
    for (auto& [name, edges] : boundary) {
      for (const Edge& edge : edges) {
        auto& sets = count[undirected(edge)] == 1 ? mesh_.boundary_sets : mesh_.constraint_sets;
        sets[name].push_back(edge);
      }
    }
    for (auto* sets : {&mesh_.boundary_sets, &mesh_.constraint_sets}) {
      for (auto& [name, edges] : *sets) {
        std::set<Edge> seen;
        std::erase_if(edges, [&](const Edge& edge) { return !seen.insert(undirected(edge)).second; });
      }
    }
  }

  std::span<const TrimmedSurface> surfaces_;
  const Division& division_;
  std::span<const FaceMesh> faces_;
  SurfaceMesh mesh_;
  std::vector<std::int32_t> region_of_face_;  ///< -1: as its mesh says.
};

/// The mesh with its cracks opened, by the rule for meshes of the plane.
Result<SurfaceMesh> opened(SurfaceMesh mesh, const std::vector<std::string>& cracks) {
  DOBRA_TRY(const dobra::mesh::ElementMesh open, dobra::mesh::open_lips_of_sides(elements_of(mesh).mesh, cracks));
  mesh.points.resize(open.points.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto nodes = open.nodes_of(dobra::mesh::ElementId(t));
    for (std::size_t i = 0; i < 3; ++i) {
      mesh.points[nodes[i].index()] = mesh.point(mesh.triangles[t][i]);
      mesh.triangles[t][i] = nodes[i];
    }
  }
  const auto outer = dobra::mesh::boundary_sides(open);
  mesh.boundary_sets.clear();
  mesh.constraint_sets.clear();
  for (const auto& [name, sides] : open.side_sets) {
    for (const dobra::mesh::ElementSide& side : sides) {
      const auto nodes = dobra::mesh::side_nodes(open, side);
      auto& sets = std::binary_search(outer.begin(), outer.end(), side) ? mesh.boundary_sets : mesh.constraint_sets;
      sets[name].push_back({nodes[0], nodes[1]});
    }
  }
  mesh.node_sets = open.node_sets;
  return mesh;
}

}  // namespace

Result<SurfaceMesh> join(std::span<const TrimmedSurface> surfaces, const Division& division,
                         std::span<const FaceMesh> faces) {
  DOBRA_CHECK(surfaces.size() == division.faces.size() && faces.size() == division.faces.size());
  return Joiner(surfaces, division, faces).run();
}

Result<SurfaceMesh> assemble(std::span<const TrimmedSurface> surfaces, const Division& division,
                             std::span<const FaceMesh> faces) {
  DOBRA_TRY(SurfaceMesh mesh, join(surfaces, division, faces));
  DOBRA_TRY_VOID(check(mesh));
  if (division.cracks.empty()) return mesh;
  return opened(std::move(mesh), division.cracks);
}

dobra::mesh::PolygonMesh to_polygon_mesh(const SurfaceMesh& mesh) {
  dobra::mesh::PolygonMesh polygons;
  polygons.points = mesh.points;
  for (const Corners& c : mesh.triangles) {
    polygons.faces.push_back({static_cast<std::uint32_t>(c[0].index()), static_cast<std::uint32_t>(c[1].index()),
                              static_cast<std::uint32_t>(c[2].index())});
  }
  return polygons;
}

Result<dobra::mesh::OpenMeshTriangles> to_openmesh(const SurfaceMesh& mesh) {
  return dobra::mesh::to_openmesh(mesh.points, mesh.triangles, mesh.regions);
}

}  // namespace dobra::surf::mesh
