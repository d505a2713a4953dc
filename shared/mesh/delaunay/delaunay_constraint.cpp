// Insertion of constraint edges into the kernel.
//
// 1. From `a`, find the triangle that the segment to `b` enters, or the vertex that it meets first.
// 2. Collect the triangles it crosses up to the next vertex on it (`b` or one exactly on the segment): the cavity. Its
//    border left of the segment and its border right of it are two chains.
// 3. Fill each side: over a base, choose the vertex of the chain whose circle with the base is empty, and recurse on
// the
//    two parts (Anglada). As many triangles come out as went in, so that cells are used again.
// A side that hangs into the cavity stands twice in a chain, once in each direction; the two are joined to each other.

#include <algorithm>

#include "shared/base/check.h"
#include "shared/mesh/delaunay/delaunay_kernel.h"
#include "shared/mesh/delaunay/filtered_predicates.h"

namespace dobra::mesh::delaunay {

using geom::Point;
using geom::Sign;

/// One border of the cavity, travelled so that the cavity is on its right: vertex[0] and vertex.back() are the ends of
/// the segment. outer[i] is the half-edge outside, or none where the side hangs into the cavity; partner[i] is then the
/// other passage of the side. inner[i] is the half-edge inside: before the filling the old one, after it the new one.
struct DelaunayKernel::Chain {
  std::vector<Vertex> vertex;
  std::vector<Half> outer;
  std::vector<Half> inner;
  std::vector<Mark> mark;
  std::vector<std::uint32_t> partner;
};

namespace {

/// True if v, known to lie on the line a-b, lies on b's side of a. Exact.
bool ahead(Point a, Point b, Point v) {
  if (a.x != b.x) return (v.x > a.x) == (b.x > a.x) && v.x != a.x;
  return (v.y > a.y) == (b.y > a.y) && v.y != a.y;
}

}  // namespace

void DelaunayKernel::mark_side(Half e, Mark mark) {
  // Parity counts boundary edges: a second one on the same side cancels the first.
  const Mark old = this->mark(e);
  const auto toggled = static_cast<Mark>((old ^ mark) & parity);
  set_mark(e, static_cast<Mark>(((old | mark) & ~parity) | toggled));
}

std::optional<DelaunayKernel::Crossing> DelaunayKernel::insert_constraint(Vertex a, Vertex b, Mark mark,
                                                                          std::vector<Vertex>& chain) {
  chain.assign(1, a);
  while (a != b) {
    const Half first = half_of_[a];
    Half e = first;
    Half along = none;
    Half crossed = none;
    do {
      const Vertex right = target(e);
      const Vertex left = apex(e);
      if (right == b) {
        along = e;
      } else if (right != at_infinity) {
        const Sign sign = filtered_orientation(points_[a], points_[b], points_[right]);
        if (sign == Sign::Zero && ahead(points_[a], points_[b], points_[right])) along = e;
        if (sign == Sign::Negative && left != at_infinity &&
            filtered_orientation(points_[a], points_[b], points_[left]) == Sign::Positive)
          crossed = next(e);
      }
      e = around(e);
    } while (e != first && along == none);
    Vertex end = b;
    if (along != none) {
      end = target(along);
    } else {
      DOBRA_CHECK(crossed != none);
      if (const auto crossing = cut_cavity(crossed, a, b, end)) return crossing;
      along = find(a, end);
      DOBRA_CHECK(along != none);
    }
    mark_side(along, static_cast<Mark>(mark | fixed));
    chain.push_back(end);
    a = end;
  }
  return std::nullopt;
}

std::optional<DelaunayKernel::Crossing> DelaunayKernel::cut_cavity(Half first_crossed, Vertex a, Vertex b,
                                                                   Vertex& end) {
  std::vector<Cell> cavity;
  Chain left;
  Chain right;
  const auto add = [this](Chain& chain, Half inner, Vertex vertex) {
    chain.inner.push_back(inner);
    chain.outer.push_back(twin(inner));
    chain.mark.push_back(this->mark(inner));
    chain.partner.push_back(none);
    chain.vertex.push_back(vertex);
  };
  left.vertex.push_back(a);
  right.vertex.push_back(a);
  add(left, next(first_crossed), target(first_crossed));
  add(right, previous(first_crossed), origin(first_crossed));
  Half crossed = first_crossed;
  while (true) {
    if (this->mark(crossed) != 0) return Crossing{origin(crossed), target(crossed)};
    cavity.push_back(cell_of(crossed));
    const Half g = twin(crossed);
    const Vertex w = apex(g);
    DOBRA_CHECK(w != at_infinity);
    const Sign sign = w == b ? Sign::Zero : filtered_orientation(points_[a], points_[b], points_[w]);
    if (sign != Sign::Negative) add(left, previous(g), w);
    if (sign != Sign::Positive) add(right, next(g), w);
    if (sign == Sign::Zero) {
      cavity.push_back(cell_of(g));
      end = w;
      break;
    }
    crossed = sign == Sign::Positive ? next(g) : previous(g);
  }
  // The right border is travelled from the end, so that the cavity is on its right too.
  std::reverse(right.vertex.begin(), right.vertex.end());
  std::reverse(right.outer.begin(), right.outer.end());
  std::reverse(right.inner.begin(), right.inner.end());
  std::reverse(right.mark.begin(), right.mark.end());

  std::vector<Cell> sorted = cavity;
  std::sort(sorted.begin(), sorted.end());
  for (Chain* chain : {&left, &right}) {
    for (std::uint32_t i = 0; i < chain->outer.size(); ++i) {
      if (!std::binary_search(sorted.begin(), sorted.end(), cell_of(chain->outer[i]))) continue;
      const auto other = std::find(chain->inner.begin(), chain->inner.end(), chain->outer[i]);
      DOBRA_CHECK(other != chain->inner.end());
      chain->partner[i] = static_cast<std::uint32_t>(other - chain->inner.begin());
    }
    std::fill(chain->inner.begin(), chain->inner.end(), none);
  }
  std::size_t used = 0;
  const Half left_base = fill(left, cavity, used);
  const Half right_base = fill(right, cavity, used);
  DOBRA_CHECK(used == cavity.size());
  link(left_base, right_base, 0);
  return std::nullopt;
}

/// Fills one side of the cavity with cells from `spare`; returns the half-edge along the segment.
DelaunayKernel::Half DelaunayKernel::fill(Chain& chain, std::span<const Cell> spare, std::size_t& used) {
  const Half base = half(spare[used], 0);
  const auto at = [&](std::size_t i) { return points_[chain.vertex[i]]; };
  // The vertex over the base i-j; of several passages of a vertex, the one whose wedge holds the base.
  const auto choose = [&](std::size_t i, std::size_t j) {
    std::size_t best = 0;
    for (std::size_t k = i + 1; k < j; ++k) {
      if (best != 0 && filtered_incircle(at(i), at(j), at(best), at(k)) != Sign::Positive) continue;
      if (filtered_orientation(at(i), at(j), at(k)) == Sign::Positive) best = k;
    }
    DOBRA_CHECK(best != 0);
    for (std::size_t k = best + 1; k < j; ++k) {
      if (chain.vertex[k] != chain.vertex[best]) continue;
      if (filtered_orientation(at(i), at(best), at(best + 1)) != Sign::Positive) break;
      best = k;
    }
    return best;
  };
  struct Task {
    std::size_t i;
    std::size_t j;
    Half across;  ///< The half-edge from vertex j to vertex i of the triangle made before, which this part adjoins.
  };
  std::vector<Task> tasks{{0, chain.vertex.size() - 1, none}};
  while (!tasks.empty()) {
    const Task task = tasks.back();
    tasks.pop_back();
    if (task.j == task.i + 1) {
      const std::size_t i = task.i;
      chain.inner[i] = task.across;
      if (chain.partner[i] == none) {
        link(task.across, chain.outer[i], chain.mark[i]);
      } else if (chain.inner[chain.partner[i]] != none) {
        link(task.across, chain.inner[chain.partner[i]], chain.mark[i]);
      }
      continue;
    }
    const std::size_t k = choose(task.i, task.j);
    const Cell c = spare[used++];
    set_vertex(half(c, 0), chain.vertex[task.i]);
    set_vertex(half(c, 1), chain.vertex[task.j]);
    set_vertex(half(c, 2), chain.vertex[k]);
    if (task.across != none) link(half(c, 0), task.across, 0);
    tasks.push_back({task.i, k, half(c, 2)});
    tasks.push_back({k, task.j, half(c, 1)});
  }
  return base;
}

}  // namespace dobra::mesh::delaunay
