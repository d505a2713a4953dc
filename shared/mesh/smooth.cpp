#include "shared/mesh/smooth.h"

#include <algorithm>

#include "shared/base/check.h"
#include "shared/mesh/delaunay_kernel.h"
#include "shared/mesh/quality.h"

namespace dobra::mesh {

using geom::Point;

namespace {

/// Least alpha of the star of `node` if it stood at `at`.
double star_alpha(const TriangleMesh& mesh, const NodeStars& stars, std::size_t node, Point at) {
  double least = 2.0;
  for (std::uint32_t k = stars.first[node]; k < stars.first[node + 1]; ++k) {
    const Corners& corner = mesh.corners(stars.triangles[k]);
    std::array<Point, 3> p{};
    for (std::size_t i = 0; i < 3; ++i) p[i] = corner[i].index() == node ? at : mesh.point(corner[i]);
    least = std::min(least, alpha(p[0], p[1], p[2]));
  }
  return least;
}

/// Mean of the neighbours of an inner node; each is a corner of two triangles of its star.
Point mean_of_neighbours(const TriangleMesh& mesh, const NodeStars& stars, std::size_t node) {
  geom::Vector sum;
  const Point here = mesh.points[node];
  for (std::uint32_t k = stars.first[node]; k < stars.first[node + 1]; ++k) {
    for (const NodeId corner : mesh.corners(stars.triangles[k])) sum = sum + 0.5 * (mesh.point(corner) - here);
  }
  return here + sum / static_cast<double>(stars.first[node + 1] - stars.first[node]);
}

bool move_node(TriangleMesh& mesh, const NodeStars& stars, std::size_t node, const SmoothOptions& options) {
  const Point here = mesh.points[node];
  const geom::Vector step = mean_of_neighbours(mesh, stars, node) - here;
  const double before = star_alpha(mesh, stars, node, here);
  double fraction = options.phi;
  for (int attempt = 0; attempt <= options.halvings; ++attempt, fraction *= 0.5) {
    const Point there = here + fraction * step;
    if (there == here) return false;
    if (star_alpha(mesh, stars, node, there) < before) continue;
    mesh.points[node] = there;
    return true;
  }
  return false;
}

}  // namespace

std::size_t smooth(TriangleMesh& mesh, const SmoothOptions& options) {
  return smooth(mesh, fixed_nodes(mesh), options);
}

std::size_t smooth(TriangleMesh& mesh, std::span<const std::uint8_t> fixed, const SmoothOptions& options) {
  DOBRA_CHECK(options.phi >= 0.0 && options.phi <= 1.0 && fixed.size() == mesh.points.size());
  const NodeStars stars = stars_of(mesh);
  std::size_t moves = 0;
  for (int pass = 0; pass < options.passes; ++pass) {
    for (std::size_t node = 0; node < mesh.points.size(); ++node) {
      if (fixed[node] != 0 || stars.first[node] == stars.first[node + 1]) continue;
      moves += move_node(mesh, stars, node, options) ? 1U : 0U;
    }
  }
  return moves;
}

std::size_t flip_to_delaunay(TriangleMesh& mesh) {
  using Kernel = DelaunayKernel;
  std::vector<std::array<Kernel::Vertex, 3>> corners(mesh.triangles.size());
  for (std::size_t t = 0; t < corners.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) corners[t][i] = static_cast<Kernel::Vertex>(mesh.triangles[t][i].index());
  }
  Kernel kernel;
  kernel.take(mesh.points, corners);
  for (std::size_t t = 0; t < corners.size(); ++t) kernel.set_region(static_cast<Kernel::Cell>(t), mesh.regions[t]);
  std::vector<Edge> kept;
  for (const auto* sets : {&mesh.boundary_sets, &mesh.constraint_sets}) {
    for (const auto& [name, edges] : *sets) {
      for (const Edge& edge : edges) kept.push_back({std::min(edge[0], edge[1]), std::max(edge[0], edge[1])});
    }
  }
  std::sort(kept.begin(), kept.end());
  for (Kernel::Cell c = 0; c < kernel.cell_count(); ++c) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const Kernel::Half e = Kernel::half(c, i);
      if (kernel.twin(e) == Kernel::none) continue;
      const NodeId a(kernel.origin(e));
      const NodeId b(kernel.target(e));
      const bool border = kernel.cell(c).region != kernel.cell(Kernel::cell_of(kernel.twin(e))).region;
      if (border || std::binary_search(kept.begin(), kept.end(), Edge{std::min(a, b), std::max(a, b)})) {
        kernel.set_mark(e, Kernel::fixed);
      }
    }
  }
  const std::size_t flips = kernel.legalise_all();
  for (Kernel::Cell c = 0; c < kernel.cell_count(); ++c) {
    for (std::size_t i = 0; i < 3; ++i) mesh.triangles[c][i] = NodeId(kernel.cell(c).vertex[i]);
  }
  return flips;
}

}  // namespace dobra::mesh
