#include "shared/mesh/smooth.h"

#include <algorithm>
#include <limits>
#include <numbers>

#include "shared/base/check.h"

namespace dobra::mesh {

using geom::Point;
using geom::Vector;
using Kernel = DelaunayKernel;

namespace {

/// Moves nodes one after the other.
class Smoother {
 public:
  Smoother(Kernel& kernel, const SmoothOptions& options) : kernel_(kernel), options_(options) {}

  bool move(Kernel::Vertex v) {
    gather(v);
    const Point here = kernel_.point(v);
    const double before = least_alpha(here);
    if (before >= options_.enough) return false;
    Vector sum;
    for (std::size_t i = 0; i + 1 < ring_.size(); ++i) sum = sum + (ring_[i] - here);
    const Vector step = sum / static_cast<double>(ring_.size() - 1);
    double fraction = options_.phi;
    for (int attempt = 0; attempt <= options_.halvings; ++attempt, fraction *= 0.5) {
      const Point there = here + fraction * step;
      if (there == here) return false;
      if (least_alpha(there) < before) continue;
      kernel_.move(v, there);
      return true;
    }
    return false;
  }

 private:
  /// The neighbours of v, anticlockwise, the first one once more at the end.
  void gather(Kernel::Vertex v) {
    ring_.clear();
    const Kernel::Half first = kernel_.half_of(v);
    Kernel::Half e = first;
    do {
      ring_.push_back(kernel_.point(kernel_.target(e)));
      e = kernel_.around(e);
    } while (e != first);
    ring_.push_back(ring_.front());
  }

  /// Least alpha of the triangles round a node that stands at `at`.
  [[nodiscard]] double least_alpha(Point at) const {
    double least = 2.0;
    Vector u = ring_[0] - at;
    double uu = geom::length_squared(u);
    for (std::size_t i = 1; i < ring_.size(); ++i) {
      const Vector w = ring_[i] - at;
      const double ww = geom::length_squared(w);
      const double sides = uu + ww + geom::length_squared(ring_[i] - ring_[i - 1]);
      const double value = sides == 0.0 ? 0.0 : geom::cross(u, w) / sides;
      least = std::min(least, value);
      u = w;
      uu = ww;
    }
    return 2.0 * std::numbers::sqrt3 * least;
  }

  Kernel& kernel_;
  const SmoothOptions& options_;
  std::vector<Point> ring_;
};

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

std::size_t smooth(Kernel& kernel, std::span<const std::uint8_t> fixed, const SmoothOptions& options) {
  DOBRA_CHECK(options.phi >= 0.0 && options.phi <= 1.0 && fixed.size() == kernel.vertex_count());
  Smoother smoother(kernel, options);
  std::size_t moves = 0;
  for (int pass = 0; pass < options.passes; ++pass) {
    for (Kernel::Vertex v = 0; v < kernel.vertex_count(); ++v) {
      if (fixed[v] != 0 || kernel.half_of(v) == Kernel::none) continue;
      moves += smoother.move(v) ? 1U : 0U;
    }
  }
  return moves;
}

std::size_t smooth(TriangleMesh& mesh, const SmoothOptions& options) {
  return smooth(mesh, fixed_nodes(mesh), options);
}

std::size_t smooth(TriangleMesh& mesh, std::span<const std::uint8_t> fixed, const SmoothOptions& options) {
  Kernel kernel = kernel_of(mesh);
  const std::size_t moves = smooth(kernel, fixed, options);
  for (std::size_t n = 0; n < mesh.points.size(); ++n) mesh.points[n] = kernel.point(static_cast<Kernel::Vertex>(n));
  return moves;
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

}  // namespace dobra::mesh
