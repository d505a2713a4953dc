#include "shared/mesh/recombine.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

#include "shared/geom/predicates.h"

namespace dobra::mesh {

using geom::Point;

double quad_quality(Point a, Point b, Point c, Point d) {
  const std::array<Point, 4> p{a, b, c, d};
  double worst = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    if (geom::orient2d(p[(i + 3) % 4], p[i], p[(i + 1) % 4]) != geom::Sign::Positive) return 0.0;
    const geom::Vector out = p[(i + 1) % 4] - p[i];
    const geom::Vector back = p[(i + 3) % 4] - p[i];
    worst =
        std::max(worst, std::abs(0.5 * std::numbers::pi - std::atan2(geom::cross(out, back), geom::dot(out, back))));
  }
  return std::max(0.0, 1.0 - 2.0 / std::numbers::pi * worst);
}

namespace {

/// Two triangles that could become one quadrilateral, across side `side` of the first.
struct Pair {
  double quality;
  ElementSide first, second;
};

/// The corners of the quadrilateral: the first triangle's from the end of the common side on, then the second's apex.
std::array<NodeId, 4> corners_of(const ElementMesh& mesh, const Pair& pair) {
  const auto one = mesh.nodes_of(pair.first.element);
  const auto two = mesh.nodes_of(pair.second.element);
  return {one[(pair.first.side + 1) % 3], one[(pair.first.side + 2) % 3], one[pair.first.side],
          two[(pair.second.side + 2) % 3]};
}

std::vector<Pair> pairs_of(const ElementMesh& mesh, double least_quality, const PairQuality& quality) {
  const std::vector<ElementSide> neighbours = neighbours_of(mesh);
  std::vector<std::size_t> first_side(mesh.element_count() + 1, 0);
  for (std::size_t e = 0; e < mesh.element_count(); ++e)
    first_side[e + 1] = first_side[e] + corner_count(mesh.types[e]);
  std::vector<std::uint8_t> kept(first_side.back(), 0);
  for (const auto& [name, sides] : mesh.side_sets) {
    for (const ElementSide& side : sides) kept[first_side[side.element.index()] + side.side] = 1;
  }
  std::vector<Pair> pairs;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    if (mesh.types[e] != ElementType::T3) continue;
    for (std::uint32_t i = 0; i < 3; ++i) {
      const ElementSide across = neighbours[first_side[e] + i];
      if (!across.element.valid() || across.element < ElementId(e) ||
          mesh.types[across.element.index()] != ElementType::T3)
        continue;
      if (mesh.regions[e] != mesh.regions[across.element.index()]) continue;
      if (kept[first_side[e] + i] != 0 || kept[first_side[across.element.index()] + across.side] != 0) continue;
      Pair pair{0.0, {ElementId(e), i}, across};
      const std::optional<double> own = quality(ElementId(e), across.element, corners_of(mesh, pair));
      if (!own) continue;
      pair.quality = *own;
      if (pair.quality >= least_quality) pairs.push_back(pair);
    }
  }
  std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
    return a.quality != b.quality ? a.quality > b.quality : a.first < b.first;
  });
  return pairs;
}

constexpr std::size_t none = static_cast<std::size_t>(-1);

/// Which pair each triangle is taken in: first the best pairs, then more of them along alternating paths.
class Matching {
 public:
  Matching(const std::vector<Pair>& pairs, std::size_t elements)
      : pairs_(pairs), pair_of_(elements, none), first_(elements + 1, 0) {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const std::size_t one = pairs[i].first.element.index(), two = pairs[i].second.element.index();
      if (pair_of_[one] == none && pair_of_[two] == none) pair_of_[one] = pair_of_[two] = i;
      ++first_[one + 1];
      ++first_[two + 1];
    }
    for (std::size_t e = 0; e < elements; ++e) first_[e + 1] += first_[e];
    pairs_at_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      pairs_at_[next[pairs[i].first.element.index()]++] = i;
      pairs_at_[next[pairs[i].second.element.index()]++] = i;
    }
  }

  std::vector<std::size_t> run() {
    reached_.assign(pair_of_.size(), none);
    from_.resize(pair_of_.size());
    for (std::size_t e = 0; e < pair_of_.size(); ++e) {
      if (pair_of_[e] == none && first_[e] < first_[e + 1]) extend(e);
    }
    return std::move(pair_of_);
  }

 private:
  [[nodiscard]] std::size_t partner(std::size_t pair, std::size_t element) const {
    const std::size_t one = pairs_[pair].first.element.index();
    return one == element ? pairs_[pair].second.element.index() : one;
  }

  /// The shortest way from a free triangle to another, over pairs by turns not taken and taken: all of them change.
  /// Ways that pass a triangle twice, which a blossom would need, are not sought, nor is far away.
  void extend(std::size_t free) {
    constexpr std::size_t most = 1000;  // triangles
    std::vector<std::size_t> open{free};
    reached_[free] = free;
    for (std::size_t k = 0; k < open.size() && k < most; ++k) {
      const std::size_t e = open[k];
      for (std::size_t i = first_[e]; i < first_[e + 1]; ++i) {
        const std::size_t pair = pairs_at_[i];
        const std::size_t other = partner(pair, e);
        if (reached_[other] == free) continue;
        if (pair_of_[other] == none) return change(free, e, pair);
        const std::size_t beyond = partner(pair_of_[other], other);
        if (reached_[beyond] == free) continue;
        reached_[other] = reached_[beyond] = free;
        from_[beyond] = {e, pair};
        open.push_back(beyond);
      }
    }
  }

  /// Takes `pair` of triangle e and, back to `free`, what was not taken.
  void change(std::size_t free, std::size_t e, std::size_t pair) {
    for (;;) {
      pair_of_[partner(pair, e)] = pair_of_[e] = pair;
      if (e == free) return;
      std::tie(e, pair) = from_[e];
    }
  }

  const std::vector<Pair>& pairs_;
  std::vector<std::size_t> pair_of_;
  std::vector<std::size_t> first_, pairs_at_;              ///< Of each triangle the pairs it may be in, the best first.
  std::vector<std::size_t> reached_;                       ///< From which free triangle last.
  std::vector<std::pair<std::size_t, std::size_t>> from_;  ///< The triangle before, and the pair with its neighbour.
};

}  // namespace

ElementMesh recombine(const ElementMesh& mesh, const RecombineOptions& options) {
  const auto quality = [&](ElementId, ElementId, const std::array<NodeId, 4>& c) {
    return quad_quality(mesh.point(c[0]), mesh.point(c[1]), mesh.point(c[2]), mesh.point(c[3]));
  };
  return recombine(mesh, options, quality).mesh;
}

Recombined recombine(const ElementMesh& mesh, const RecombineOptions& options, const PairQuality& quality) {
  const std::vector<Pair> pairs = pairs_of(mesh, options.least_quality, quality);
  const std::vector<std::size_t> pair_of = Matching(pairs, mesh.element_count()).run();
  Recombined recombined;
  ElementMesh& result = recombined.mesh;
  result.points = mesh.points;
  result.region_names = mesh.region_names;
  result.node_sets = mesh.node_sets;
  result.tips = mesh.tips;
  result.first.push_back(0);
  // Where each old side is now: a side of a pair's first triangle after the common one is side 0, the next is side 1,
  // ...
  std::vector<ElementId> new_element(mesh.element_count());
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const ElementId element(e);
    if (pair_of[e] == none) {
      new_element[e] = add_element(result, mesh.types[e], mesh.nodes_of(element), mesh.regions[e]);
      recombined.made_of.push_back({element, ElementId()});
    } else if (const Pair& pair = pairs[pair_of[e]]; pair.first.element == element) {
      new_element[e] = add_element(result, ElementType::Q4, corners_of(mesh, pair), mesh.regions[e]);
      new_element[pair.second.element.index()] = new_element[e];
      recombined.made_of.push_back({element, pair.second.element});
    }
  }
  for (const auto& [name, sides] : mesh.side_sets) {
    auto& moved = result.side_sets[name];
    for (const ElementSide& side : sides) {
      const std::size_t e = side.element.index();
      std::uint32_t number = side.side;
      if (pair_of[e] != none) {
        const Pair& pair = pairs[pair_of[e]];
        const bool first = pair.first.element == side.element;
        number = (side.side + 3 - (first ? pair.first.side : pair.second.side)) % 3 - 1 + (first ? 0 : 2);
      }
      moved.push_back({new_element[e], number});
    }
  }
  return recombined;
}

}  // namespace dobra::mesh
