#pragma once
// The advancing front of advancing_front.h in a space of its own: the plane, or a surface (space.h).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "shared/mesh/front/advancing_front.h"
#include "shared/mesh/front/front_rules.h"
#include "shared/mesh/front/node_grid.h"
#include "shared/mesh/front/size_queue.h"

// Notation: a side runs from a to b, the sides before and after it are p-a and b-c; h is the size wanted, l the length
// of a side. Safe: a node that has no other nearer than least_gap * h; the front touches safe nodes only, and puts its
// own nodes at least least_spacing * h from all others. A triangle whose circle is smaller than that holds no node.
//
// 1. Loops of marked sides become the first front. Nodes and walls go into the grid.
// 2. Of the sides with the smallest size, the oldest: close a corner at one of its ends if that is narrow; else put a
//    node over it if there is room; else leave it. Then close the corners that came about.

namespace dobra::mesh::front {

template <class Space>
class Advancer final : public FillEngine {
 public:
  using Kernel = delaunay::DelaunayKernel;
  using Side = FrontSide;
  using SideId = std::uint32_t;
  using Point = typename Space::Point;
  using Vector = typename Space::Vector;
  using Place = typename Space::Place;
  using Grid = Buckets<Space>;

  Advancer(Kernel& kernel, Space& space, const sizing::SizeField& field, const FrontalOptions& options, Front& front);

  base::Result<void> step(std::size_t count, const base::Progress& progress) override;
  [[nodiscard]] bool done() const override { return done_; }
  [[nodiscard]] std::vector<geom::Segment> front() const override;

 private:
  [[nodiscard]] base::Result<void> check_count(const base::Progress& progress) const;
  static constexpr SideId none = 0xffffffffU;
  struct Found {
    bool any = false;
    std::uint32_t vertex = Grid::none;
  };

  static double squared(Vector a) { return geom::dot(a, a); }
  void add_seeds();
  void add_nodes();
  void add_walls();
  void start();
  bool halve_corner(SideId s);
  [[nodiscard]] Point at(Kernel::Vertex v) const { return space_.at(v); }
  void enqueue(SideId s);
  void attach(SideId s, Kernel::Half half);
  SideId new_side();
  void release(SideId s);
  [[nodiscard]] bool is_good(Kernel::Vertex a, Kernel::Vertex b, Kernel::Vertex c, double least);
  [[nodiscard]] bool may_close(SideId s, double cosine, double least);
  SideId close(SideId s);
  void close_corners(SideId s);
  [[nodiscard]] Found look(const Place& q, double clear, double size, Kernel::Vertex a, Kernel::Vertex b,
                           Kernel::Vertex c) const;
  [[nodiscard]] bool fits_corners(SideId s, const Place& top) const;
  void advance(SideId s);
  void put(SideId s, const Place& top, double size);
  Kernel::Vertex add_node(const Place& q, double size);
  SideId raise(SideId s, Kernel::Vertex v);
  bool join(SideId s, Kernel::Vertex d);

  Kernel& kernel_;
  Space& space_;
  const FrontalOptions& options_;
  const double expected_;  ///< Number of triangles in the square of the size field, roughly.
  sizing::SizeSampler sampler_;
  Grid grid_;
  Front& front_;
  std::vector<SideId> free_;
  std::vector<double> size_;        ///< One a vertex.
  std::vector<SideId> side_of_;     ///< One a vertex: a side that starts there, if its `from` still says so.
  std::vector<std::uint8_t> safe_;  ///< One a vertex of the input.
  SizeQueue queue_;
  std::uint16_t generation_ = 0;  ///< Of sides that are made now.
  bool done_ = false;
};

template <class Space>
Advancer<Space>::Advancer(Kernel& kernel, Space& space, const sizing::SizeField& field, const FrontalOptions& options,
                          Front& front)
    : kernel_(kernel),
      space_(space),
      options_(options),
      expected_(space.estimated_triangles(field)),
      sampler_(field),
      grid_(field, space, std::min<std::size_t>(static_cast<std::size_t>(0.6 * expected_), options.max_triangles)),
      front_(front) {
  front_ = {};
  space.make_room(field, options);
  add_seeds();
  add_nodes();
  add_walls();
  for (Kernel::Cell c = 0; c < kernel_.cell_count(); ++c) {
    if (kernel_.cell(c).region >= 0) kernel_.set_region(c, replaced_region);
  }
  start();
}

// ---- start ----

template <class Space>
void Advancer<Space>::add_seeds() {
  const auto cells = static_cast<Kernel::Cell>(kernel_.cell_count());
  std::vector<SideId> seed_of(4 * static_cast<std::size_t>(cells), none);
  std::vector<Kernel::Half> halves;
  for (Kernel::Cell c = 0; c < cells; ++c) {
    if (kernel_.cell(c).region < 0) continue;
    for (std::uint32_t i = 0; i < 3; ++i) {
      const Kernel::Half e = Kernel::half(c, i);
      if (kernel_.mark(e) == 0) continue;
      seed_of[e] = static_cast<SideId>(halves.size());
      halves.push_back(e);
    }
  }
  front_.sides.resize(halves.size());
  for (SideId s = 0; s < halves.size(); ++s) {
    const Kernel::Half e = halves[s];
    Kernel::Half n = Kernel::next(e);
    while (kernel_.mark(n) == 0) n = Kernel::next(kernel_.twin(n));
    Side& side = front_.sides[s];
    side.from = kernel_.origin(e);
    side.next = seed_of[n];
    front_.sides[side.next].previous = s;
    side.region = kernel_.cell(Kernel::cell_of(e)).region;
    side.mark = kernel_.mark(e);
    const Kernel::Half f = kernel_.twin(e);
    side.paired = kernel_.cell(Kernel::cell_of(f)).region >= 0;
    side.back = side.paired ? seed_of[f] : f;
  }
}

template <class Space>
void Advancer<Space>::add_nodes() {
  const std::size_t count = kernel_.vertex_count();
  size_.assign(count, 0.0);
  safe_.assign(count, 1);
  std::vector<std::uint8_t> used(count, 0);
  for (Kernel::Cell c = 0; c < kernel_.cell_count(); ++c) {
    if (kernel_.cell(c).region < 0) continue;
    for (const Kernel::Vertex v : kernel_.cell(c).vertex) {
      if (used[v] != 0) continue;
      used[v] = 1;
      size_[v] = sampler_.at(kernel_.point(v));
      grid_.add(space_.place(v), v, sampler_.leaf());
    }
  }
  for (const Side& side : front_.sides) used[side.from] = 0;
  for (Kernel::Vertex v = 0; v < count; ++v) {
    if (used[v] != 0) front_.loose.push_back(v);
  }
  // The nearest node that a node can see is joined to it.
  for (Kernel::Cell c = 0; c < kernel_.cell_count(); ++c) {
    if (kernel_.cell(c).region < 0) continue;
    for (std::uint32_t i = 0; i < 3; ++i) {
      const Kernel::Vertex a = kernel_.cell(c).vertex[i];
      const Kernel::Vertex b = kernel_.cell(c).vertex[(i + 1) % 3];
      const double least = rules::least_gap * std::min(size_[a], size_[b]);
      if (squared(at(b) - at(a)) >= least * least) continue;
      safe_[a] = safe_[b] = 0;
    }
  }
}

/// Places along the marked sides that nodes keep clear of: a long side has no node near its middle.
template <class Space>
void Advancer<Space>::add_walls() {
  for (const Side& side : front_.sides) {
    const Kernel::Vertex a = side.from;
    const Kernel::Vertex b = front_.to(side);
    const double length = geom::distance(at(a), at(b));
    const auto add = [&](double along) {
      const Place p = space_.between(a, b, along);
      const double size = sampler_.at(p.chart());
      grid_.add(p, Grid::none, sampler_.leaf());
      return size;
    };
    // One in the middle of a side of about the size wanted, more on a longer one.
    double t = 0.5 * size_[side.from];
    if (length < rules::longest_seed * add(0.5)) continue;
    while (t < length) t += std::max(0.5 * add(t / length), 1e-6 * length);
  }
}

template <class Space>
void Advancer<Space>::start() {
  side_of_.assign(kernel_.vertex_count(), none);
  for (SideId s = 0; s < front_.sides.size(); ++s) side_of_[front_.sides[s].from] = s;
  std::vector<std::uint8_t> seen(front_.sides.size(), 0);
  for (SideId first = 0; first < seen.size(); ++first) {
    for (SideId s = first; seen[s] == 0; s = front_.sides[s].next) {
      seen[s] = 1;
      const Kernel::Vertex a = front_.sides[s].from;
      const Kernel::Vertex b = front_.to(front_.sides[s]);
      if (safe_[a] == 0 || safe_[b] == 0) continue;
      const double ratio = 2.0 * geom::distance(at(a), at(b)) / (size_[a] + size_[b]);
      if (ratio > rules::shortest_seed && ratio < rules::longest_seed) enqueue(s);
    }
  }
  if constexpr (Space::curved) {
    const auto given = static_cast<SideId>(front_.sides.size());
    const auto is_seed = [&](SideId s) { return front_.sides[s].from != Side::free && front_.sides[s].mark != 0; };
    for (SideId s = 0; s < given; ++s) {
      if (!is_seed(s) || !is_seed(front_.sides[s].next)) continue;
      const Kernel::Vertex a = front_.sides[s].from;
      const Kernel::Vertex b = front_.to(front_.sides[s]);
      const Kernel::Vertex c = front_.to(front_.sides[front_.sides[s].next]);
      if (a != c && safe_[a] != 0 && safe_[b] != 0 && safe_[c] != 0) halve_corner(s);
    }
  }
}

/// A right angle of the border between s and the side after it gets two triangles instead of one: they are better, and
/// leave the sides beside them room for two more each.
template <class Space>
bool Advancer<Space>::halve_corner(SideId s) {
  const Kernel::Vertex a = front_.sides[s].from;
  const Kernel::Vertex b = front_.to(front_.sides[s]);
  const Kernel::Vertex c = front_.to(front_.sides[front_.sides[s].next]);
  const Vector u = at(a) - at(b);
  const Vector w = at(c) - at(b);
  const double left = std::sqrt(squared(u)), right = std::sqrt(squared(w));
  const double cosine = geom::dot(u, w) / (left * right);
  if (std::abs(cosine) > rules::right_corner || std::max(left, right) > rules::even_corner * std::min(left, right))
    return false;
  if (space_.cross(space_.frame(b), w, u) <= 0.0) return false;
  const double leg = 0.5 * (left + right);
  Place top = space_.moved(space_.place(b), leg * geom::normalised(u / left + w / right));
  if (!space_.ground(top) || !space_.turns_left(kernel_.point(a), kernel_.point(b), top.chart()) ||
      !space_.turns_left(kernel_.point(b), kernel_.point(c), top.chart()))
    return false;
  const double size = sampler_.at(top.chart());
  if (look(top, options_.least_spacing * size, leg, a, b, c).any) return false;
  const SideId n = raise(s, add_node(top, size));
  if (close(n) == none) return true;
  enqueue(s);
  enqueue(n);
  return true;
}

// ---- the linked front ----

template <class Space>
void Advancer<Space>::enqueue(SideId s) {
  Side& side = front_.sides[s];
  side.generation = generation_;
  queue_.push(size_[side.from], {s, side.stamp});
}

/// The half-edge `half` of a new triangle takes the place of the side `s`.
template <class Space>
void Advancer<Space>::attach(SideId s, Kernel::Half half) {
  const Side& side = front_.sides[s];
  if (side.paired) {
    front_.sides[side.back].back = half;
    front_.sides[side.back].paired = false;
  } else {
    kernel_.link(half, side.back, side.mark);
  }
}

template <class Space>
std::uint32_t Advancer<Space>::new_side() {
  if (free_.empty()) {
    front_.sides.emplace_back();
    return static_cast<SideId>(front_.sides.size() - 1);
  }
  const SideId s = free_.back();
  free_.pop_back();
  return s;
}

template <class Space>
void Advancer<Space>::release(SideId s) {
  front_.sides[s].from = Side::free;
  ++front_.sides[s].stamp;
  free_.push_back(s);
}

// ---- corners ----

/// Whether the triangle has at least the alpha `least`, and a circle that holds no node: two such triangles cannot
/// cross.
template <class Space>
bool Advancer<Space>::is_good(Kernel::Vertex a, Kernel::Vertex b, Kernel::Vertex c, double least) {
  const Vector u = at(b) - at(a);
  const Vector w = at(c) - at(a);
  const auto frame = space_.frame(a, b, c);
  const double twice = space_.cross(frame, u, w);
  const double uu = squared(u);
  const double ww = squared(w);
  const double vv = squared(at(c) - at(b));
  if (2.0 * std::numbers::sqrt3 * twice < least * (uu + vv + ww)) return false;
  if (!space_.turns_left(kernel_.point(a), kernel_.point(b), kernel_.point(c))) return false;
  for (const Kernel::Vertex v : {a, b, c}) {
    if (v < safe_.size() && safe_[v] == 0) return false;
  }
  const double size = std::min({size_[a], size_[b], size_[c]});
  const double radius_squared = uu * vv * ww / (4.0 * twice * twice);
  if (radius_squared > rules::most_radius * rules::most_radius * size * size) return false;
  if (radius_squared < rules::empty_radius * rules::empty_radius * size * size) return true;
  const Place centre = space_.in_plane(a, b, c, space_.to_centre(frame, u, w, uu, ww, twice));
  sampler_.at(centre.chart());
  bool empty = true;
  const double inside = radius_squared * (1.0 - 1e-9);
  grid_.visit_near(centre.chart(), std::sqrt(radius_squared), sampler_.leaf(), [&](const typename Grid::Entry& entry) {
    const bool own = entry.vertex == a || entry.vertex == b || entry.vertex == c || entry.vertex == Grid::none;
    if (own || squared(entry.at - centre.at) >= inside) return;
    if (space_.same_sheet(centre, entry.vertex, std::sqrt(radius_squared))) empty = false;
  });
  return empty;
}

/// Whether the sides s = a-b and b-c may be closed by a triangle.
template <class Space>
bool Advancer<Space>::may_close(SideId s, double cosine, double least) {
  const Side& side = front_.sides[s];
  const Side& next = front_.sides[side.next];
  const Kernel::Vertex a = side.from;
  const Kernel::Vertex b = next.from;
  const Kernel::Vertex c = front_.to(next);
  const Vector u = at(a) - at(b);
  const Vector w = at(c) - at(b);
  const double dot = geom::dot(u, w);
  if (dot * std::abs(dot) < cosine * std::abs(cosine) * squared(u) * squared(w)) return false;
  return is_good(a, b, c, least);
}

/// Closes the corner between s and the side after it. @return the side that takes their place; none if the front
/// closed.
template <class Space>
std::uint32_t Advancer<Space>::close(SideId s) {
  std::vector<Side>& sides = front_.sides;
  const SideId n = sides[s].next;
  const SideId after = sides[n].next;
  const Kernel::Cell cell = kernel_.add_triangle(sides[s].from, sides[n].from, sides[after].from, sides[s].region);
  attach(s, Kernel::half(cell, 0));
  attach(n, Kernel::half(cell, 1));
  if (sides[after].next == s) {
    attach(after, Kernel::half(cell, 2));
    release(s);
    release(n);
    release(after);
    return none;
  }
  sides[s].next = after;
  sides[after].previous = s;
  sides[s].back = Kernel::half(cell, 2);
  sides[s].mark = 0;
  sides[s].paired = false;
  ++sides[s].stamp;
  side_of_[sides[s].from] = s;
  release(n);
  return s;
}

/// Closes the narrow corners at both ends of s, and what comes of it.
template <class Space>
void Advancer<Space>::close_corners(SideId s) {
  while (true) {
    const SideId before = front_.sides[s].previous;
    if (may_close(s, rules::corner_cosine, rules::least_alpha)) {
      s = close(s);
    } else if (may_close(before, rules::corner_cosine, rules::least_alpha)) {
      s = close(before);
    } else {
      enqueue(s);
      return;
    }
    if (s == none) return;
  }
}

// ---- nodes ----

/// The nearest node to q within `clear`, or a wall; a, b and c are not counted. Unsafe nodes count as walls.
template <class Space>
typename Advancer<Space>::Found Advancer<Space>::look(const Place& q, double clear, double size, Kernel::Vertex a,
                                                      Kernel::Vertex b, Kernel::Vertex c) const {
  Found found;
  double nearest = clear * clear;
  const double wall = options_.least_wall * options_.least_wall * size * size;
  bool blocked = false;
  grid_.visit_near(q.chart(), clear, sampler_.leaf(), [&](const typename Grid::Entry& entry) {
    const double apart = squared(entry.at - q.at);
    if (apart >= nearest) return;
    if (entry.vertex == Grid::none) {
      blocked = blocked || apart < wall;
      return;
    }
    if (entry.vertex == a || entry.vertex == b || entry.vertex == c) return;
    if (!space_.same_sheet(q, entry.vertex, clear)) return;
    nearest = apart;
    found.vertex = entry.vertex;
  });
  found.any = blocked || found.vertex != Grid::none;
  if (blocked) found.vertex = Grid::none;
  return found;
}

template <class Space>
delaunay::DelaunayKernel::Vertex Advancer<Space>::add_node(const Place& q, double size) {
  const Kernel::Vertex v = space_.add(q);
  size_.push_back(size);
  side_of_.push_back(none);
  grid_.add(q, v, sampler_.leaf());
  return v;
}

/// A triangle over side s with top v: s becomes a-v. @return v-b
template <class Space>
std::uint32_t Advancer<Space>::raise(SideId s, Kernel::Vertex v) {
  const SideId n = new_side();
  std::vector<Side>& sides = front_.sides;
  const SideId after = sides[s].next;
  side_of_[sides[s].from] = s;
  const Kernel::Cell cell = kernel_.add_triangle(sides[s].from, sides[after].from, v, sides[s].region);
  attach(s, Kernel::half(cell, 0));
  sides[s].back = Kernel::half(cell, 2);
  sides[s].next = n;
  sides[s].mark = 0;
  sides[s].paired = false;
  ++sides[s].stamp;
  const std::uint32_t stamp = sides[n].stamp + 1;
  sides[n] = {v, after, s, stamp, Kernel::half(cell, 1), sides[s].region, 0, false, 0};
  sides[after].previous = n;
  side_of_[v] = n;
  return n;
}

/// A triangle from side s = a-b to node d elsewhere on the front: s becomes a-d, and d-b is new. One loop of sides
/// becomes two, or two become one.
template <class Space>
bool Advancer<Space>::join(SideId s, Kernel::Vertex d) {
  const SideId t = side_of_[d];
  if (t == none || front_.sides[t].from != d) return false;
  const SideId before = front_.sides[t].previous;
  const Kernel::Vertex a = front_.sides[s].from;
  const Kernel::Vertex b = front_.to(front_.sides[s]);
  const Kernel::Vertex e = front_.to(front_.sides[t]);
  const Kernel::Vertex f = front_.sides[before].from;
  if (e == a || f == b || !is_good(a, b, d, rules::least_joint) || !fits_corners(s, space_.place(d))) return false;
  // Both ends must be seen from d between e and f.
  const Vector right = at(e) - at(d);
  const Vector left = at(f) - at(d);
  const auto frame = space_.frame(d);
  const auto cross = [&](Vector u, Vector w) { return space_.cross(frame, u, w); };
  const auto within = [&](Vector v) {
    if (cross(right, left) > 0.0) return cross(right, v) > 0.0 && cross(v, left) > 0.0;
    return cross(left, v) < 0.0 || cross(v, right) < 0.0;
  };
  if (!within(at(a) - at(d)) || !within(at(b) - at(d))) return false;
  const SideId n = raise(s, d);
  front_.sides[s].next = t;
  front_.sides[t].previous = s;
  front_.sides[before].next = n;
  front_.sides[n].previous = before;
  const std::uint32_t stamp = front_.sides[n].stamp;
  close_corners(s);
  if (front_.sides[n].stamp == stamp) close_corners(n);
  return true;
}

/// Whether the sides from `top` to the ends of s stay clear of the sides before and after s.
template <class Space>
bool Advancer<Space>::fits_corners(SideId s, const Place& place) const {
  const Side& side = front_.sides[s];
  const Point a = at(side.from);
  const Point b = at(front_.to(side));
  const Point top = place.at;
  const auto frame = space_.frame(side.from, front_.to(side));
  // The angle from one side to the other within a corner that opens from `right` to `left`; a corner of more than 180
  // degrees has room for any triangle.
  const auto clear = [&](Vector right, Vector left, Vector from, Vector to) {
    if (space_.cross(frame, right, left) <= 0.0 || geom::dot(from, to) <= 0.0) return true;
    constexpr double sine_squared = 0.2;
    const double cross = space_.cross(frame, from, to);
    return cross > 0.0 && cross * cross > sine_squared * squared(from) * squared(to);
  };
  const Vector before = at(front_.sides[side.previous].from) - a;
  const Vector after = at(front_.to(front_.sides[side.next])) - b;
  return clear(b - a, before, top - a, before) && clear(after, a - b, after, top - b);
}

template <class Space>
void Advancer<Space>::advance(SideId s) {
  const Side& side = front_.sides[s];
  const Kernel::Vertex a = side.from;
  const Kernel::Vertex b = front_.to(side);
  const Point from = at(a);
  const Point to = at(b);
  const Vector along = to - from;
  const double length_squared = squared(along);
  const double length = std::sqrt(length_squared);
  const Vector inward = space_.left_of(space_.frame(a, b), along);
  // A leg is as long as the size in its middle asks: the mean of those at its ends.
  const double below = 0.5 * (size_[a] + size_[b]);
  double size = below;
  Place top;
  double leg = 0.0;
  for (int round = 0; round < 2; ++round) {
    leg = std::clamp(0.5 * (below + size), 0.72 * length, 1.4 * length);
    top = space_.beside(a, b, std::sqrt(leg * leg / length_squared - 0.25) * inward);
    const double there = sampler_.at(top.chart());
    const bool settled = std::abs(there - size) < 0.06 * size;
    size = there;
    if (settled) break;
  }
  if (size > rules::most_growth * below || below > rules::most_shrink * size) return;
  // A long side has no room for a triangle of the size wanted.
  const double height = std::sqrt(leg * leg - 0.25 * length_squared);
  if (leg * leg > 2.0 * rules::most_radius * std::max(leg, size) * height) return;
  if (!space_.settle(a, b, height, top)) return;
  if (Space::curved) sampler_.at(top.chart());  // its leaf
  const Found found = look(top, options_.least_spacing * std::max(leg, size), leg, a, b, b);
  if (!found.any) {
    put(s, top, size);
    return;
  }
  if (found.vertex == Grid::none) return;
  // The node in the way may be the other end of a neighbour.
  SideId corner = none;
  if (found.vertex == front_.sides[front_.sides[s].previous].from) corner = front_.sides[s].previous;
  if (found.vertex == front_.to(front_.sides[front_.sides[s].next])) corner = s;
  if (corner == none) {
    join(s, found.vertex);
    return;
  }
  if (may_close(corner, rules::widest_corner, rules::least_joint)) {
    const SideId closed = close(corner);
    if (closed != none) close_corners(closed);
    return;
  }
  if constexpr (Space::curved) {
    // All sides of a ring may be too short for the size wanted: then the row grows less.
    if (leg <= length) return;
    const double low = 0.5 * std::numbers::sqrt3 * length;
    Place over = space_.beside(a, b, low / length * inward);
    if (!space_.settle(a, b, low, over)) return;
    size = sampler_.at(over.chart());
    if (!look(over, options_.least_spacing * length, length, a, b, b).any) put(s, over, size);
  }
}

/// A new node over s, unless it does not fit.
template <class Space>
void Advancer<Space>::put(SideId s, const Place& top, double size) {
  const Kernel::Vertex a = front_.sides[s].from, b = front_.to(front_.sides[s]);
  if (!fits_corners(s, top) || !space_.turns_left(kernel_.point(a), kernel_.point(b), top.chart())) return;
  const SideId n = raise(s, add_node(top, size));
  const SideId before = front_.sides[s].previous;
  if (may_close(before, rules::corner_cosine, rules::least_alpha)) {
    const SideId closed = close(before);
    if (closed != none) enqueue(closed);
  } else {
    enqueue(s);
  }
  if (front_.sides[n].from != Side::free) close_corners(n);
}

template <class Space>
base::Result<void> Advancer<Space>::check_count(const base::Progress& progress) const {
  DOBRA_TRY_VOID(progress.check());
  const auto count = static_cast<double>(kernel_.cell_count());
  progress.report(std::min(1.0, count / expected_), fmt::format("{} triangles", kernel_.cell_count()));
  DOBRA_TRY_VOID(check_limit(kernel_.cell_count(), options_));
  // The input may be so crowded that the front gets out of the domain; then it would never end.
  if (count > 4.0 * expected_ + 10'000.0) return front_crossed();
  return {};
}

template <class Space>
base::Result<void> Advancer<Space>::step(std::size_t count, const base::Progress& progress) {
  DOBRA_TRY_VOID(check_count(progress));
  SizeQueue::Entry entry{};
  for (; count > 0; --count) {
    if (!queue_.pop(entry)) {
      done_ = true;
      return {};
    }
    const Side& side = front_.sides[entry.side];
    if (side.stamp != entry.stamp || side.from == Side::free) continue;
    front_.generation = side.generation;
    generation_ = static_cast<std::uint16_t>(std::min(side.generation + 1, 0xffff));
    if (may_close(entry.side, rules::corner_cosine, rules::least_alpha) ||
        may_close(side.previous, rules::corner_cosine, rules::least_alpha)) {
      close_corners(entry.side);
      continue;
    }
    advance(entry.side);
  }
  return {};
}

template <class Space>
std::vector<geom::Segment> Advancer<Space>::front() const {
  std::vector<geom::Segment> sides;
  for (const Side& side : front_.sides) {
    if (side.from != Side::free) sides.push_back({kernel_.point(side.from), kernel_.point(front_.to(side))});
  }
  return sides;
}

}  // namespace dobra::mesh::front
