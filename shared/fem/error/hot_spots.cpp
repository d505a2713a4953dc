#include "shared/fem/error/hot_spots.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "shared/fem/stress.h"

namespace dobra::fem::error {
namespace {

using mesh::ElementMesh;
using mesh::NodeId;

/// Peaks below this share of the greatest are left alone.
constexpr double share_of_greatest = 0.8;

/// One must descend by this share of the height to get from a peak to a higher place: less is a bump on a slope, as
/// there are some on the way to a crack tip.
constexpr double least_prominence = 0.1;

/// Nodes where the stress is infinite.
std::vector<char> infinite_at(const ElementMesh& mesh, const Problem& problem,
                              std::span<const SingularVertex> singular) {
  std::vector<char> infinite(mesh.points.size(), 0);
  for (const SingularVertex& vertex : singular) {
    if (vertex.exponent < 1.0) infinite[vertex.node.index()] = 1;
  }
  for (const LoadCase& load : problem.cases) {
    for (const NodeId node : single_nodes_acted_on(mesh, problem, load)) infinite[node.index()] = 1;
  }
  return infinite;
}

/// How far one must descend from each node to get to a higher one; only of the tops of hills, 0 elsewhere. A top that
/// is no higher than an infinite hill is as far from its own top is a bump on the slope of that one, and has 0 too.
class Hills {
 public:
  Hills(const ElementMesh& mesh, std::vector<double> heights)
      : points_(mesh.points),
        heights_(std::move(heights)),
        hill_(heights_.size(), none),
        prominence_(heights_.size(), 0.0),
        on_slope_(heights_.size(), 0),
        members_(heights_.size()) {
    std::vector<std::vector<std::size_t>> neighbours(heights_.size());
    std::vector<std::size_t> order;
    for (std::size_t e = 0; e < mesh.element_count(); ++e) {
      const auto corners = mesh.nodes_of(mesh::ElementId(e)).first(mesh::corner_count(mesh.types[e]));
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::size_t a = corners[i].index(), b = corners[(i + 1) % corners.size()].index();
        neighbours[a].push_back(b);
        neighbours[b].push_back(a);
      }
    }
    for (std::size_t n = 0; n < heights_.size(); ++n) {
      if (!neighbours[n].empty()) order.push_back(n);
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return heights_[a] > heights_[b]; });
    // The water falls: islands come up, and join.
    for (const std::size_t n : order) {
      hill_[n] = n;
      members_[n] = {n};
      if (std::isinf(heights_[n])) infinite_[n] = 0.0;
      const bool is_top = std::ranges::none_of(neighbours[n], [&](std::size_t other) { return hill_[other] != none; });
      on_slope_[n] = is_top && lies_on_slope(n) ? 1 : 0;
      for (const std::size_t other : neighbours[n]) {
        if (hill_[other] == none) continue;
        const std::size_t a = top(n), b = top(other);
        if (a == b) continue;
        const auto [lower, higher] = heights_[a] < heights_[b] || a == n ? std::pair{a, b} : std::pair{b, a};
        prominence_[lower] = heights_[lower] - heights_[n];
        join(lower, higher);
        hill_[lower] = higher;
      }
    }
    for (const std::size_t n : order) {
      if (hill_[n] == n) prominence_[n] = heights_[n];
    }
  }
  [[nodiscard]] double prominence(std::size_t node) const { return on_slope_[node] != 0 ? 0.0 : prominence_[node]; }

 private:
  static constexpr std::size_t none = ~std::size_t{0};
  std::size_t top(std::size_t n) {
    while (hill_[n] != n) n = hill_[n] = hill_[hill_[n]];
    return n;
  }
  /// Whether an infinite hill, as far as it is above water, reaches as far as this node is.
  [[nodiscard]] bool lies_on_slope(std::size_t n) const {
    return std::ranges::any_of(infinite_, [&](const auto& own) {
      return own.first != n && distance(points_[own.first], points_[n]) <= own.second;
    });
  }
  void join(std::size_t lower, std::size_t higher) {
    for (auto& [node, reach] : infinite_) {
      const std::size_t own = top(node);
      if (own != lower && own != higher) continue;
      for (const std::size_t member : members_[own == lower ? higher : lower])
        reach = std::max(reach, distance(points_[node], points_[member]));
    }
    if (members_[lower].size() > members_[higher].size()) std::swap(members_[lower], members_[higher]);
    members_[higher].insert(members_[higher].end(), members_[lower].begin(), members_[lower].end());
    members_[lower] = {};
  }
  const std::vector<geom::Point>& points_;
  std::vector<double> heights_;
  std::vector<std::size_t> hill_;
  std::vector<double> prominence_;
  std::vector<char> on_slope_;
  std::vector<std::vector<std::size_t>> members_;  ///< Of each hill above water, by its top.
  std::map<std::size_t, double> infinite_;         ///< Hills without end that are above water, with how far they reach.
};

}  // namespace

std::vector<NodeId> single_nodes_acted_on(const ElementMesh& mesh, const Problem& problem, const LoadCase& load) {
  std::vector<NodeId> nodes;
  const auto add = [&](const std::string& where) {
    const auto found = mesh.node_sets.find(where);
    if (found == mesh.node_sets.end() || mesh.side_sets.contains(where)) return;
    nodes.insert(nodes.end(), found->second.begin(), found->second.end());
  };
  for (const PointLoad& own : load.points) {
    if (length(own.force) > 0.0) add(own.where);
  }
  for (const Support& support : problem.supports) add(support.where);
  for (const Spring& spring : problem.springs) add(spring.where);
  return nodes;
}

std::vector<HotSpot> hot_spots(const ElementMesh& mesh, const Problem& problem, std::span<const geom::Vector> u,
                               const RecoveredStress& recovered, const ErrorEstimate& estimate,
                               std::span<const SingularVertex> singular, std::span<const Disc> left_out) {
  const std::size_t count = mesh.points.size();
  std::vector<double> stress(count, 0.0), error(count, 0.0), energy(count, 0.0);
  const std::vector<double> energies = element_energies(mesh, problem.materials, u);
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const auto corners = mesh.nodes_of(mesh::ElementId(e)).first(mesh::corner_count(mesh.types[e]));
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::size_t n = corners[i].index();
      stress[n] = std::max(
          stress[n], von_mises(recovered.at_element_nodes[mesh.first[e] + i], problem.materials.at(mesh.regions[e])));
      error[n] += estimate.elements[e] * estimate.elements[e];
      energy[n] += energies[e];
    }
  }
  const std::vector<char> infinite = infinite_at(mesh, problem, singular);
  std::vector<double> heights = stress;
  for (std::size_t n = 0; n < count; ++n) {
    if (infinite[n] != 0) heights[n] = std::numeric_limits<double>::infinity();
  }
  const Hills hills(mesh, heights);
  std::vector<HotSpot> spots;
  double greatest = 0.0;
  for (std::size_t n = 0; n < count; ++n) {
    if (infinite[n] != 0 || std::ranges::any_of(left_out, [&](const Disc& disc) { return disc.holds(mesh.points[n]); }))
      continue;
    if (!(hills.prominence(n) > least_prominence * stress[n])) continue;
    spots.push_back({NodeId(n), stress[n], std::sqrt(error[n] / (energy[n] + error[n]))});
    greatest = std::max(greatest, stress[n]);
  }
  std::erase_if(spots, [&](const HotSpot& spot) { return spot.stress < share_of_greatest * greatest; });
  std::stable_sort(spots.begin(), spots.end(), [](const HotSpot& a, const HotSpot& b) { return a.stress > b.stress; });
  return spots;
}

}  // namespace dobra::fem::error
