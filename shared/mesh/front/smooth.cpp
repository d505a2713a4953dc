#include "shared/mesh/front/smooth.h"

#include <algorithm>
#include <limits>
#include <numbers>

#include "shared/base/check.h"

namespace dobra::mesh::front {

using geom::Point;
using geom::Vector;
using Kernel = delaunay::DelaunayKernel;

namespace {

/// Moves nodes one after the other.
class Smoother {
 public:
  Smoother(Kernel& kernel, std::span<const std::uint8_t> fixed, const SmoothOptions& options)
      : kernel_(kernel), options_(options), resting_(fixed.begin(), fixed.end()) {
    for (Kernel::Vertex v = 0; v < resting_.size(); ++v) {
      if (kernel.half_of(v) == Kernel::none) resting_[v] = fixed_node;
    }
  }

  std::size_t sweep() {
    std::size_t moves = 0;
    for (Kernel::Vertex v = 0; v < resting_.size(); ++v) {
      if (resting_[v] == 0 && move(v)) ++moves;
    }
    return moves;
  }
  /// The nodes that were moved since `forget_moved`, some several times.
  [[nodiscard]] std::span<const Kernel::Vertex> moved() const { return moved_; }
  void forget_moved() { moved_.clear(); }
  /// Something round v has changed.
  void wake(Kernel::Vertex v) {
    if (resting_[v] == resting) resting_[v] = 0;
  }

 private:
  static constexpr std::uint8_t fixed_node = 1;
  static constexpr std::uint8_t resting = 2;  ///< Good enough, and nothing round it has moved since.

  /// Of the triangles round a node.
  struct Star {
    double least = 2.0;  ///< Alpha.
    double sum = 0.0;
  };

  bool move(Kernel::Vertex v) {
    gather(v);
    Point here = kernel_.point(v);
    if (is_enough(here)) {
      resting_[v] = resting;
      return false;
    }
    Star before = star(here);
    const Point given = here;
    const auto keeps_least = [&](const Star& after) { return after.least >= before.least; };
    approach(here, before, mean_of_neighbours(), options_.phi, keeps_least);
    if (before.least < options_.rescue) {
      // The worst triangle may gain a part of what the others lose.
      const auto gains = [&](const Star& after) {
        return after.least > before.least && 0.5 * (after.least - before.least) >= before.sum - after.sum;
      };
      approach(here, before, equilateral_place(here), options_.rescue_step, gains);
    }
    if (here == given) return false;
    kernel_.move(v, here);
    moved_.push_back(v);
    wake_neighbours(v);
    return true;
  }

  /// Moves `here` a fraction of the way to `target` if the star is accepted there; halves the step a few times.
  template <class Accept>
  void approach(Point& here, Star& now, Point target, double fraction, const Accept& accept) const {
    const Vector step = target - here;
    for (int attempt = 0; attempt <= options_.halvings; ++attempt, fraction *= 0.5) {
      const Point there = here + fraction * step;
      if (there == here) return;
      const Star after = star(there);
      if (!accept(after)) continue;
      here = there;
      now = after;
      return;
    }
  }

  [[nodiscard]] Point mean_of_neighbours() const {
    Vector sum;
    for (std::size_t i = 0; i + 1 < ring_.size(); ++i) sum = sum + (ring_[i] - ring_[0]);
    return ring_[0] + sum / static_cast<double>(ring_.size() - 1);
  }

  /// The mean of the places where each triangle of the star would be equilateral, bad ones counting more.
  [[nodiscard]] Point equilateral_place(Point here) const {
    Vector sum;
    double weights = 0.0;
    for (std::size_t i = 1; i < ring_.size(); ++i) {
      const Vector base = ring_[i] - ring_[i - 1];
      const Point top = geom::midpoint(ring_[i], ring_[i - 1]) + 0.5 * std::numbers::sqrt3 * geom::left_of(base);
      const double sides = geom::length_squared(base) + geom::length_squared(ring_[i - 1] - here) +
                           geom::length_squared(ring_[i] - here);
      const double weight = 1.0 - 2.0 * std::numbers::sqrt3 * geom::cross(ring_[i - 1] - here, base) / sides;
      sum = sum + weight * (top - here);
      weights += weight;
    }
    return weights > 0.0 ? here + sum / weights : here;
  }

  void wake_neighbours(Kernel::Vertex v) {
    const Kernel::Half first = kernel_.half_of(v);
    Kernel::Half e = first;
    do {
      wake(kernel_.target(e));
      e = kernel_.around(e);
    } while (e != first);
  }

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

  /// Whether all triangles round a node at `here` have at least the alpha `enough`: most do, so without a division.
  [[nodiscard]] bool is_enough(Point here) const {
    const double least = options_.enough / (2.0 * std::numbers::sqrt3);
    Vector u = ring_[0] - here;
    double uu = geom::length_squared(u);
    for (std::size_t i = 1; i < ring_.size(); ++i) {
      const Vector w = ring_[i] - here;
      const double ww = geom::length_squared(w);
      if (!(geom::cross(u, w) >= least * (uu + ww + geom::length_squared(w - u)))) return false;
      u = w;
      uu = ww;
    }
    return true;
  }

  /// The star of the ring's node if that stood at `at`.
  [[nodiscard]] Star star(Point at) const {
    Star star;
    Vector u = ring_[0] - at;
    double uu = geom::length_squared(u);
    for (std::size_t i = 1; i < ring_.size(); ++i) {
      const Vector w = ring_[i] - at;
      const double ww = geom::length_squared(w);
      const double sides = uu + ww + geom::length_squared(ring_[i] - ring_[i - 1]);
      const double alpha = sides == 0.0 ? 0.0 : 2.0 * std::numbers::sqrt3 * geom::cross(u, w) / sides;
      star.least = std::min(star.least, alpha);
      star.sum += alpha;
      u = w;
      uu = ww;
    }
    return star;
  }

  Kernel& kernel_;
  const SmoothOptions& options_;
  std::vector<std::uint8_t> resting_;  ///< One a vertex: 0 to be looked at, or why not.
  std::vector<Kernel::Vertex> moved_;
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

std::size_t smooth(TriangleMesh& mesh, const SmoothOptions& options) {
  return smooth(mesh, fixed_nodes(mesh), options);
}

std::size_t smooth(TriangleMesh& mesh, std::span<const std::uint8_t> fixed, const SmoothOptions& options) {
  DOBRA_CHECK(options.phi >= 0.0 && options.phi <= 1.0 && fixed.size() == mesh.points.size());
  Kernel kernel = kernel_of(mesh);
  Smoother smoother(kernel, fixed, options);
  std::size_t moves = 0;
  for (int pass = 0; pass < options.passes; ++pass) moves += smoother.sweep();
  for (std::size_t n = 0; n < mesh.points.size(); ++n) mesh.points[n] = kernel.point(static_cast<Kernel::Vertex>(n));
  return moves;
}

base::Result<void> improve(Kernel& kernel, std::span<const std::uint8_t> fixed, const SmoothOptions& options,
                           int rounds, const base::Progress& progress) {
  Smoother smoother(kernel, fixed, options);
  std::vector<Kernel::Vertex> changed;
  for (int round = 0; round < rounds; ++round) {
    DOBRA_TRY_VOID(progress.check());
    progress.report(static_cast<double>(round) / rounds, "smoothing");
    for (int pass = 0; pass < options.passes; ++pass) smoother.sweep();
    changed.clear();
    kernel.legalise_near(smoother.moved(), changed);
    smoother.forget_moved();
    for (const Kernel::Vertex v : changed) smoother.wake(v);
  }
  return {};
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
