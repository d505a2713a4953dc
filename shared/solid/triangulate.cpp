#include "shared/solid/triangulate.h"

#include <algorithm>
#include <numeric>

namespace dobra::solid {
namespace {

using geom::Sign;

/// p is on the segment a-b, ends included, if it is on its line.
bool between(const Space& space, Projection onto, PointId a, PointId b, PointId p) {
  const auto from = space.compare(onto, a, p);
  const auto to = space.compare(onto, p, b);
  return from == std::strong_ordering::equal || to == std::strong_ordering::equal || from == to;
}

/// The closed segments have a point in common that is not a common end.
bool meet(const Space& space, Projection onto, PointId a, PointId b, PointId c, PointId d) {
  const Sign sc = space.orient(onto, a, b, c);
  const Sign sd = space.orient(onto, a, b, d);
  const Sign sa = space.orient(onto, c, d, a);
  const Sign sb = space.orient(onto, c, d, b);
  if (sc * sd == Sign::Negative && sa * sb == Sign::Negative) return true;
  const auto touches = [&](Sign side, PointId from, PointId to, PointId p) {
    return side == Sign::Zero && p != from && p != to && between(space, onto, from, to, p);
  };
  if (touches(sc, a, b, c) || touches(sd, a, b, d) || touches(sa, c, d, a) || touches(sb, c, d, b)) return true;
  return (a == c && b == d) || (a == d && b == c);
}

class Clipper {
 public:
  Clipper(const Space& space, Projection onto) : space_(space), onto_(onto) {}

  /// Joins the holes to the ring, the one farthest to the right first.
  bool bridge(std::span<const std::vector<PointId>> loops) {
    ring_ = loops[0];
    std::vector<std::vector<PointId>> holes(loops.begin() + 1, loops.end());
    for (auto& hole : holes) {
      const auto right = std::max_element(hole.begin(), hole.end(), [&](PointId p, PointId q) { return less(p, q); });
      std::rotate(hole.begin(), right, hole.end());
    }
    std::sort(holes.begin(), holes.end(), [&](const auto& h, const auto& g) { return less(g[0], h[0]); });
    for (std::size_t i = 0; i < holes.size(); ++i) {
      if (!join(holes, i)) return false;
    }
    return true;
  }

  bool clip(std::vector<std::array<PointId, 3>>& triangles) {
    const std::size_t count = ring_.size();
    next_.resize(count);
    previous_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      next_[i] = (i + 1) % count;
      previous_[i] = (i + count - 1) % count;
    }
    std::size_t left = count;
    std::size_t at = 0;
    std::size_t tried = 0;
    while (left > 3) {
      if (is_ear(at)) {
        triangles.push_back({ring_[previous_[at]], ring_[at], ring_[next_[at]]});
        next_[previous_[at]] = next_[at];
        previous_[next_[at]] = previous_[at];
        at = previous_[at];
        --left;
        tried = 0;
      } else {
        at = next_[at];
        if (++tried > left) return false;
      }
    }
    if (turn(at) != Sign::Positive) return false;
    triangles.push_back({ring_[previous_[at]], ring_[at], ring_[next_[at]]});
    return true;
  }

 private:
  [[nodiscard]] bool less(PointId p, PointId q) const {
    return space_.compare(onto_, p, q) == std::strong_ordering::less;
  }
  [[nodiscard]] Sign turn(std::size_t i) const {
    return space_.orient(onto_, ring_[previous_[i]], ring_[i], ring_[next_[i]]);
  }

  [[nodiscard]] bool is_ear(std::size_t i) const {
    if (turn(i) != Sign::Positive) return false;
    const PointId a = ring_[previous_[i]];
    const PointId b = ring_[i];
    const PointId c = ring_[next_[i]];
    for (std::size_t j = next_[next_[i]]; j != previous_[i]; j = next_[j]) {
      const PointId p = ring_[j];
      if (p == a || p == b || p == c) continue;
      if (space_.orient(onto_, a, b, p) != Sign::Negative && space_.orient(onto_, b, c, p) != Sign::Negative &&
          space_.orient(onto_, c, a, p) != Sign::Negative) {
        return false;
      }
    }
    // The rest must not be cut off by a part of the ring that passes through a corner of the ear.
    return in_cone(next_[i], a) && in_cone(previous_[i], c);
  }

  /// The way from ring position i to p leads into the polygon.
  [[nodiscard]] bool in_cone(std::size_t i, PointId p) const {
    return in_cone(ring_[previous_[i]], ring_[i], ring_[next_[i]], p);
  }
  [[nodiscard]] bool in_cone(PointId from, PointId v, PointId to, PointId p) const {
    const bool left_in = space_.orient(onto_, from, v, p) == Sign::Positive;
    const bool left_out = space_.orient(onto_, v, to, p) == Sign::Positive;
    const Sign corner = space_.orient(onto_, from, v, to);
    if (corner == Sign::Positive) return left_in && left_out;
    if (corner == Sign::Negative) return left_in || left_out;
    // Straight on, or back: then all round is inside, except the way itself.
    if (from != to && space_.compare(onto_, from, v) == space_.compare(onto_, v, to)) return left_in;
    return space_.orient(onto_, from, v, p) != Sign::Zero ||
           space_.compare(onto_, v, p) != space_.compare(onto_, v, from);
  }

  bool join(const std::vector<std::vector<PointId>>& holes, std::size_t i) {
    const PointId m = holes[i][0];
    const std::size_t count = ring_.size();
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto far = [&](std::size_t k) {
      return std::hypot(space_.coordinate(ring_[k], onto_.u) - space_.coordinate(m, onto_.u),
                        space_.coordinate(ring_[k], onto_.v) - space_.coordinate(m, onto_.v));
    };
    std::vector<double> distance(count);
    for (std::size_t k = 0; k < count; ++k) distance[k] = far(k);
    std::sort(order.begin(), order.end(),
              [&](std::size_t k, std::size_t l) { return std::pair(distance[k], k) < std::pair(distance[l], l); });
    for (const std::size_t k : order) {
      if (!sees(holes, i, k)) continue;
      std::vector<PointId> joined(ring_.begin(), ring_.begin() + static_cast<std::ptrdiff_t>(k) + 1);
      if (ring_[k] == m) {  // the hole touches the ring here
        joined.insert(joined.end(), holes[i].begin() + 1, holes[i].end());
        joined.push_back(m);
      } else {
        joined.insert(joined.end(), holes[i].begin(), holes[i].end());
        joined.push_back(m);
        joined.push_back(ring_[k]);
      }
      joined.insert(joined.end(), ring_.begin() + static_cast<std::ptrdiff_t>(k) + 1, ring_.end());
      ring_ = std::move(joined);
      return true;
    }
    return false;
  }

  [[nodiscard]] bool sees(const std::vector<std::vector<PointId>>& holes, std::size_t i, std::size_t k) const {
    const PointId m = holes[i][0];
    const PointId p = ring_[k];
    const std::size_t count = ring_.size();
    const PointId from = ring_[(k + count - 1) % count];
    const PointId to = ring_[(k + 1) % count];
    if (p == m) return in_cone(from, p, to, holes[i][1]) || in_cone(from, p, to, holes[i].back());
    if (!in_cone(from, p, to, m)) return false;
    for (std::size_t j = 0; j < count; ++j) {
      if (meet(space_, onto_, m, p, ring_[j], ring_[(j + 1) % count])) return false;
    }
    for (std::size_t h = i; h < holes.size(); ++h) {
      for (std::size_t j = 0; j < holes[h].size(); ++j) {
        if (meet(space_, onto_, m, p, holes[h][j], holes[h][(j + 1) % holes[h].size()])) return false;
      }
    }
    return true;
  }

  const Space& space_;
  Projection onto_;
  std::vector<PointId> ring_;
  std::vector<std::size_t> next_, previous_;
};

}  // namespace

namespace {

using Edge = std::pair<PointId, PointId>;

/// Two edges of the loops that meet, and not in their ends.
std::optional<std::array<Edge, 2>> edges_that_meet(const Space& space, Projection onto,
                                                   const std::vector<Edge>& edges) {
  struct Side {
    double low, high;
    std::size_t at;
  };
  std::vector<Side> sides(edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const double u = space.coordinate(edges[i].first, onto.u);
    const double w = space.coordinate(edges[i].second, onto.u);
    sides[i] = {std::min(u, w), std::max(u, w), i};
  }
  std::sort(sides.begin(), sides.end(),
            [](const Side& s, const Side& t) { return std::pair(s.low, s.at) < std::pair(t.low, t.at); });
  std::vector<Side> open;
  for (const Side& side : sides) {
    std::erase_if(open, [&](const Side& other) { return other.high < side.low; });
    const auto& [a, b] = edges[side.at];
    for (const Side& other : open) {
      if (meet(space, onto, a, b, edges[other.at].first, edges[other.at].second))
        return std::array{edges[side.at], edges[other.at]};
    }
    open.push_back(side);
  }
  return std::nullopt;
}

void add_edges(std::span<const PointId> loop, std::vector<Edge>& edges) {
  for (std::size_t i = 0; i < loop.size(); ++i) edges.emplace_back(loop[i], loop[(i + 1) % loop.size()]);
}

std::optional<PointId> repeated_corner(std::span<const PointId> loop) {
  std::vector<PointId> sorted(loop.begin(), loop.end());
  std::sort(sorted.begin(), sorted.end());
  const auto found = std::adjacent_find(sorted.begin(), sorted.end());
  return found == sorted.end() ? std::nullopt : std::optional(*found);
}

/// Some corner of the inner loop is within the outer one; loops that share all corners are not.
bool lies_within(const Space& space, Projection onto, std::span<const PointId> inner, std::span<const PointId> outer) {
  for (const PointId p : inner) {
    if (std::find(outer.begin(), outer.end(), p) != outer.end()) continue;
    bool inside = false;
    for (std::size_t i = 0; i < outer.size(); ++i) {
      const PointId a = outer[i];
      const PointId b = outer[(i + 1) % outer.size()];
      const bool above_a = space.compare(onto.v, a, p) == std::strong_ordering::greater;
      const bool above_b = space.compare(onto.v, b, p) == std::strong_ordering::greater;
      if (above_a != above_b && (space.orient(onto, a, b, p) == Sign::Positive) == above_b) inside = !inside;
    }
    return inside;
  }
  return false;
}

}  // namespace

bool is_simple(const Space& space, Projection onto, std::span<const PointId> loop) {
  std::vector<Edge> edges;
  add_edges(loop, edges);
  return !repeated_corner(loop) && !edges_that_meet(space, onto, edges);
}

bool bound_a_face(const Space& space, Projection onto, std::span<const std::vector<PointId>> loops) {
  std::vector<Edge> edges;
  for (const auto& loop : loops) {
    if (repeated_corner(loop)) return false;
    add_edges(loop, edges);
  }
  if (edges_that_meet(space, onto, edges)) return false;
  for (std::size_t i = 1; i < loops.size(); ++i) {
    if (!lies_within(space, onto, loops[i], loops[0])) return false;
    for (std::size_t j = 1; j < loops.size(); ++j) {
      if (i != j && lies_within(space, onto, loops[i], loops[j])) return false;
    }
  }
  return true;
}

bool meets_itself(const Soup& soup, const Facet& facet) {
  if (facet.corner_end - facet.first_corner <= 3) return false;
  std::vector<Edge> edges;
  soup.visit_edges(facet,
                   [&](std::uint32_t i, std::uint32_t j) { edges.emplace_back(soup.corners[i], soup.corners[j]); });
  return edges_that_meet(soup.space, soup.space.projection(facet.plane), edges).has_value();
}

std::optional<geom::Point3> where_edges_meet(const Space& space, Projection onto,
                                             std::span<const std::vector<PointId>> loops) {
  std::vector<Edge> edges;
  for (const auto& loop : loops) {
    if (const auto corner = repeated_corner(loop)) return space.rounded(*corner);
    add_edges(loop, edges);
  }
  const auto found = edges_that_meet(space, onto, edges);
  if (!found) return std::nullopt;
  const auto [first, second] = *found;
  const auto& [a, b] = first;
  const auto& [c, d] = second;
  for (const PointId p : {c, d}) {
    if (space.orient(onto, a, b, p) == Sign::Zero && between(space, onto, a, b, p)) return space.rounded(p);
  }
  for (const PointId p : {a, b}) {
    if (space.orient(onto, c, d, p) == Sign::Zero && between(space, onto, c, d, p)) return space.rounded(p);
  }
  // They cross: the share of a-b before c-d.
  const auto beside = [&, c = c, d = d](PointId p) {
    const auto at = [&](PointId q, int axis) { return space.coordinate(q, axis); };
    return (at(d, onto.u) - at(c, onto.u)) * (at(p, onto.v) - at(c, onto.v)) -
           (at(d, onto.v) - at(c, onto.v)) * (at(p, onto.u) - at(c, onto.u));
  };
  const double from = std::abs(beside(a));
  const double to = std::abs(beside(b));
  const double share = from + to > 0.0 ? from / (from + to) : 0.5;
  return space.rounded(a) + share * (space.rounded(b) - space.rounded(a));
}

bool runs_left(const Space& space, Projection onto, std::span<const PointId> loop) {
  // At its least corner a loop turns the way it runs; a simple loop cannot be straight there.
  const std::size_t count = loop.size();
  std::size_t least = 0;
  for (std::size_t i = 1; i < count; ++i) {
    if (space.compare(onto, loop[i], loop[least]) == std::strong_ordering::less) least = i;
  }
  return space.orient(onto, loop[(least + count - 1) % count], loop[least], loop[(least + 1) % count]) ==
         Sign::Positive;
}

std::optional<std::vector<std::array<PointId, 3>>> triangulate(const Space& space, Projection onto,
                                                               std::span<const std::vector<PointId>> loops) {
  std::vector<std::array<PointId, 3>> triangles;
  Clipper clipper(space, onto);
  if (loops.empty() || loops[0].size() < 3 || !clipper.bridge(loops) || !clipper.clip(triangles)) return std::nullopt;
  return triangles;
}

std::vector<std::vector<PointId>> sorted_loops(const Soup& soup, const Facet& facet, Projection onto) {
  std::vector<std::vector<PointId>> loops;
  std::size_t outer = 0;
  const auto least = [&](const std::vector<PointId>& loop) {
    return *std::min_element(loop.begin(), loop.end(), [&](PointId p, PointId q) {
      return soup.space.compare(onto, p, q) == std::strong_ordering::less;
    });
  };
  for (std::uint32_t l = facet.first_loop; l < facet.loop_end; ++l) {
    loops.emplace_back(soup.corners.begin() + soup.loop_starts[l], soup.corners.begin() + soup.loop_end(facet, l));
  }
  for (std::size_t l = 1; l < loops.size(); ++l) {
    const PointId own = least(loops[l]);
    const PointId best = least(loops[outer]);
    const auto order = soup.space.compare(onto, own, best);
    if (order == std::strong_ordering::less) outer = l;
  }
  std::swap(loops[0], loops[outer]);
  return loops;
}

}  // namespace dobra::solid
