#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <ctime>

#include "tests/bench/mesh_peers.h"

namespace bench {

Peer cgal_mesh_2(const dobra::mesh::delaunay::MeshInput& input) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Structure = CGAL::Triangulation_data_structure_2<CGAL::Delaunay_mesh_vertex_base_2<Kernel>,
                                                         CGAL::Delaunay_mesh_face_base_2<Kernel>>;
  using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure>;
  using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Triangulation>;
  const std::clock_t start = std::clock();
  Triangulation triangulation;
  std::vector<Triangulation::Vertex_handle> vertices;
  for (const auto p : input.points) vertices.push_back(triangulation.insert({p.x, p.y}));
  double length = 0.0;
  for (const auto& edge : input.edges) {
    const auto a = edge.nodes[0].index();
    const auto b = edge.nodes[1].index();
    triangulation.insert_constraint(vertices[a], vertices[b]);
    length += dobra::geom::distance(input.points[a], input.points[b]) / static_cast<double>(input.edges.size());
  }
  constexpr double least_sine_squared = 0.125;
  CGAL::refine_Delaunay_mesh_2(triangulation, Criteria(least_sine_squared, 1.5 * length));
  Peer peer;
  peer.seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  for (auto face = triangulation.finite_faces_begin(); face != triangulation.finite_faces_end(); ++face) {
    if (face->is_in_domain()) peer.triangles += 1.0;
  }
  return peer;
}

}  // namespace bench
