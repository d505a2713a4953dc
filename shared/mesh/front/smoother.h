#pragma once
// The smoothing of smooth.h in a space of its own: the plane, or a surface (space.h).

#include <algorithm>
#include <numbers>
#include <span>
#include <vector>

#include "shared/mesh/front/smooth.h"
#include "shared/mesh/front/space.h"

namespace dobra::mesh::front {

/// Moves nodes one after the other.
template <class Space>
class Smoother {
 public:
  using Kernel = delaunay::DelaunayKernel;
  using Point = typename Space::Point;
  using Vector = typename Space::Vector;
  using Place = typename Space::Place;

  Smoother(Kernel& kernel, Space& space, std::span<const std::uint8_t> fixed, const SmoothOptions& options)
      : kernel_(kernel), space_(space), options_(options), resting_(fixed.begin(), fixed.end()) {
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

  static double squared(Vector a) { return geom::dot(a, a); }

  bool move(Kernel::Vertex v) {
    gather(v);
    frame_ = space_.frame(v);
    Place here = space_.place(v);
    if (is_enough(here.at)) {
      resting_[v] = resting;
      return false;
    }
    Star before = star(here.at);
    const Point given = here.at;
    const auto keeps_least = [&](const Star& after) { return after.least >= before.least; };
    if (options_.equilateral) {
      const auto grows = [&](const Star& after) {
        return after.sum > before.sum && after.least >= std::min(before.least, options_.spared);
      };
      const Point target = best_for_sum(here.at);
      const double least = options_.least_step * options_.least_step * squared(ring_[0] - here.at);
      if (squared(target - here.at) <= least) {
        if (before.least >= options_.rescue) {
          resting_[v] = resting;
          return false;
        }
      } else {
        approach(here, before, target, options_.phi, grows);
      }
    } else {
      approach(here, before, mean_of_neighbours(), options_.phi, keeps_least);
    }
    if (before.least < options_.rescue) {
      // The worst triangle may gain a part of what the others lose.
      const auto gains = [&](const Star& after) {
        return after.least > before.least && 0.5 * (after.least - before.least) >= before.sum - after.sum;
      };
      approach(here, before, equilateral_place(here.at), options_.rescue_step, gains);
    }
    if (here.at == given) return false;
    space_.move(v, here);
    moved_.push_back(v);
    wake_neighbours(v);
    return true;
  }

  /// Moves `here` a fraction of the way to `target` if the star is accepted there; halves the step a few times.
  template <class Accept>
  void approach(Place& here, Star& now, Point target, double fraction, const Accept& accept) const {
    const Vector step = target - here.at;
    for (int attempt = 0; attempt <= options_.halvings; ++attempt, fraction *= 0.5) {
      Place there = space_.moved(here, fraction * step);
      if (there.at == here.at) return;
      Star after = star(there.at);
      if (!accept(after)) continue;
      if constexpr (Space::curved) {
        // Judged in the tangent plane so far.
        if (!space_.ground(there) || !turns_left(there.chart())) continue;
        after = star(there.at);
        if (!accept(after)) continue;
      }
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

  /// Where the sum of the alphas is greatest, nearly: alpha is an area over a sum of squares, and the step is the
  /// gradient of the sum by what the squares bend it. For equilateral triangles it is the mean of their tops.
  [[nodiscard]] Point best_for_sum(Point here) const {
    Vector gradient;
    double bend = 0.0;
    for (std::size_t i = 1; i < ring_.size(); ++i) {
      const Vector base = ring_[i] - ring_[i - 1];
      const Vector u = ring_[i - 1] - here;
      const Vector w = ring_[i] - here;
      const double area = space_.cross(frame_, u, w);
      const double squares = squared(u) + squared(w) + squared(base);
      const double weight = 1.0 / (squares * squares);
      gradient = gradient + weight * (squares * space_.left_of(frame_, base) + 2.0 * area * (u + w));
      bend += 4.0 * weight * area;
    }
    return bend > 0.0 ? here + gradient / bend : here;
  }

  /// The mean of the places where each triangle of the star would be equilateral, bad ones counting more.
  [[nodiscard]] Point equilateral_place(Point here) const {
    Vector sum;
    double weights = 0.0;
    for (std::size_t i = 1; i < ring_.size(); ++i) {
      const Vector base = ring_[i] - ring_[i - 1];
      const Point top =
          geom::midpoint(ring_[i], ring_[i - 1]) + 0.5 * std::numbers::sqrt3 * space_.left_of(frame_, base);
      const double sides = squared(base) + squared(ring_[i - 1] - here) + squared(ring_[i] - here);
      const double weight = 1.0 - 2.0 * std::numbers::sqrt3 * space_.cross(frame_, ring_[i - 1] - here, base) / sides;
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
    chart_ring_.clear();
    const Kernel::Half first = kernel_.half_of(v);
    Kernel::Half e = first;
    do {
      ring_.push_back(space_.at(kernel_.target(e)));
      if constexpr (Space::curved) chart_ring_.push_back(kernel_.point(kernel_.target(e)));
      e = kernel_.around(e);
    } while (e != first);
    ring_.push_back(ring_.front());
    if constexpr (Space::curved) chart_ring_.push_back(chart_ring_.front());
  }

  /// Whether all triangles round a node there turn left in the chart.
  [[nodiscard]] bool turns_left(geom::Point there) const {
    for (std::size_t i = 1; i < chart_ring_.size(); ++i) {
      if (!space_.turns_left(there, chart_ring_[i - 1], chart_ring_[i])) return false;
    }
    return true;
  }

  /// Whether all triangles round a node at `here` have at least the alpha `enough`: most do, so without a division.
  [[nodiscard]] bool is_enough(Point here) const {
    if (options_.enough > 1.0) return false;
    const double least = options_.enough / (2.0 * std::numbers::sqrt3);
    Vector u = ring_[0] - here;
    double uu = squared(u);
    for (std::size_t i = 1; i < ring_.size(); ++i) {
      const Vector w = ring_[i] - here;
      const double ww = squared(w);
      if (!(space_.cross(frame_, u, w) >= least * (uu + ww + squared(w - u)))) return false;
      u = w;
      uu = ww;
    }
    return true;
  }

  /// The star of the ring's node if that stood at `at`.
  [[nodiscard]] Star star(Point at) const {
    Star star;
    Vector u = ring_[0] - at;
    double uu = squared(u);
    for (std::size_t i = 1; i < ring_.size(); ++i) {
      const Vector w = ring_[i] - at;
      const double ww = squared(w);
      const double sides = uu + ww + squared(ring_[i] - ring_[i - 1]);
      const double alpha = sides == 0.0 ? 0.0 : 2.0 * std::numbers::sqrt3 * space_.cross(frame_, u, w) / sides;
      star.least = std::min(star.least, alpha);
      star.sum += alpha;
      u = w;
      uu = ww;
    }
    return star;
  }

  Kernel& kernel_;
  Space& space_;
  const SmoothOptions& options_;
  std::vector<std::uint8_t> resting_;  ///< One a vertex: 0 to be looked at, or why not.
  std::vector<Kernel::Vertex> moved_;
  std::vector<Point> ring_;
  std::vector<geom::Point> chart_ring_;  ///< Only where the chart is not the space.
  typename Space::Frame frame_{};        ///< At the node that is moved.
};

/// As in smooth.h.
template <class Space>
base::Result<void> improve(delaunay::DelaunayKernel& kernel, Space& space, std::span<const std::uint8_t> fixed,
                           const SmoothOptions& options, int rounds, const base::Progress& progress) {
  Smoother<Space> smoother(kernel, space, fixed, options);
  std::vector<delaunay::DelaunayKernel::Vertex> changed;
  for (int round = 0; round < rounds; ++round) {
    DOBRA_TRY_VOID(progress.check());
    progress.report(static_cast<double>(round) / rounds, "smoothing");
    for (int pass = 0; pass < options.passes; ++pass) smoother.sweep();
    changed.clear();
    kernel.legalise_near(smoother.moved(), changed);
    smoother.forget_moved();
    for (const delaunay::DelaunayKernel::Vertex v : changed) smoother.wake(v);
  }
  return {};
}

}  // namespace dobra::mesh::front
