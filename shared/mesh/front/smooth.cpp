#include "shared/mesh/front/smooth.h"

#include <algorithm>

#include "shared/base/check.h"
#include "shared/mesh/front/smoother.h"

namespace dobra::mesh::front {

using Kernel = delaunay::DelaunayKernel;

namespace {

/// The kernel of a mesh; sides that must not be flipped are marked.
Kernel kernel_of(const TriangleMesh& mesh) {
  std::vector<std::array<Kernel::Vertex, 3>> corners(mesh.triangles.size());
  for (std::size_t t = 0; t < corners.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) corners[t][i] = static_cast<Kernel::Vertex>(mesh.triangles[t][i].index());
  }
  Kernel kernel;
  kernel.take(mesh.points, corners);
  return kernel;
}

}  // namespace

std::size_t smooth(TriangleMesh& mesh, const SmoothOptions& options) {
  return smooth(mesh, fixed_nodes(mesh), options);
}

std::size_t smooth(TriangleMesh& mesh, std::span<const std::uint8_t> fixed, const SmoothOptions& options) {
  DOBRA_CHECK(options.phi >= 0.0 && options.phi <= 1.0 && fixed.size() == mesh.points.size());
  Kernel kernel = kernel_of(mesh);
  Plane plane(kernel);
  Smoother<Plane> smoother(kernel, plane, fixed, options);
  std::size_t moves = 0;
  for (int pass = 0; pass < options.passes; ++pass) moves += smoother.sweep();
  for (std::size_t n = 0; n < mesh.points.size(); ++n) mesh.points[n] = kernel.point(static_cast<Kernel::Vertex>(n));
  return moves;
}

base::Result<void> improve(Kernel& kernel, std::span<const std::uint8_t> fixed, const SmoothOptions& options,
                           int rounds, const base::Progress& progress) {
  Plane plane(kernel);
  return improve(kernel, plane, fixed, options, rounds, progress);
}

std::size_t flip_to_delaunay(TriangleMesh& mesh) {
  Kernel kernel = kernel_of(mesh);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    kernel.set_region(static_cast<Kernel::Cell>(t), mesh.regions[t]);
  }
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

}  // namespace dobra::mesh::front
