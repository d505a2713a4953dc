#include "shared/mesh/front/advancing_front.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "shared/mesh/front/node_grid.h"

// Notation: a side runs from a to b, the sides before and after it are p-a and b-c; h is the size wanted, l the length
// of a side. Safe: a node that has no other nearer than least_gap * h; the front touches safe nodes only, and puts its
// own nodes at least least_spacing * h from all others. A triangle whose circle is smaller than that holds no node.
//
// 1. Loops of marked sides become the first front. Nodes and walls go into the grid.
// 2. Of the sides with the smallest size, the oldest: close a corner at one of its ends if that is narrow; else put a
//    node over it if there is room; else leave it. Then close the corners that came about.

namespace dobra::mesh::front {

using base::Error;
using base::ErrorCode;
using base::Progress;
using base::Result;
using geom::Point;
using geom::Vector;
using Kernel = delaunay::DelaunayKernel;
using Side = FrontSide;
using SideId = std::uint32_t;

namespace {

constexpr double least_gap = 0.65;
constexpr double corner_cosine = 0.2;   ///< Corners up to 78 degrees are closed.
constexpr double least_alpha = 0.72;    ///< Of a triangle that closes a corner.
constexpr double widest_corner = -0.5;  ///< Corners up to 120 degrees, where there is no room for a node.
constexpr double least_joint = 0.6;     ///< Least alpha of a triangle there.
constexpr double most_radius =
    0.72;  ///< Its circumradius over the size: below least_spacing, so that no node gets inside.
constexpr double empty_radius = 0.62;  ///< A smaller circle has no room for a node that keeps its distance.
constexpr double most_growth = 1.2;    ///< From a side to the node over it; steeper places are left to the gaps.
constexpr double most_shrink = 1.28;
constexpr double shortest_seed = 0.6;  ///< Length of a first side over the size.
constexpr double longest_seed = 1.4;

/// First come first served within a class of sizes, classes in ascending order. Four classes an octave.
class SizeQueue {
 public:
  struct Entry {
    SideId side;
    std::uint32_t stamp;
  };
  void push(double size, Entry entry) {
    // Equal sizes are the same but for rounding: no class may begin at one that users like, as a power of two.
    const auto bits = std::bit_cast<std::uint64_t>(size * (1.0 + 1e-9));
    const auto key = static_cast<std::size_t>(bits >> 50U);
    if (classes_.empty()) first_key_ = key;
    if (key < first_key_) {
      classes_.insert(classes_.begin(), first_key_ - key, {});
      current_ += first_key_ - key;
      first_key_ = key;
    }
    const std::size_t index = key - first_key_;
    if (index >= classes_.size()) classes_.resize(index + 1);
    classes_[index].entries.push_back(entry);
    current_ = std::min(current_, index);
  }
  bool pop(Entry& entry) {
    for (; current_ < classes_.size(); ++current_) {
      Class& c = classes_[current_];
      if (c.head < c.entries.size()) {
        entry = c.entries[c.head++];
        if (c.head > 65536 && 2 * c.head > c.entries.size()) {
          c.entries.erase(c.entries.begin(), c.entries.begin() + static_cast<std::ptrdiff_t>(c.head));
          c.head = 0;
        }
        return true;
      }
      c.entries.clear();
      c.head = 0;
    }
    return false;
  }

 private:
  struct Class {
    std::vector<Entry> entries;
    std::size_t head = 0;
  };
  std::vector<Class> classes_;
  std::size_t first_key_ = 0;
  std::size_t current_ = 0;
};

class Advancer final : public FillEngine {
 public:
  Advancer(Kernel& kernel, const sizing::SizeField& field, const FrontalOptions& options, Front& front);

  Result<void> step(std::size_t count, const Progress& progress) override;
  [[nodiscard]] bool done() const override { return done_; }
  [[nodiscard]] std::vector<geom::Segment> front() const override;

 private:
  [[nodiscard]] Result<void> check_count(const Progress& progress) const;
  static constexpr SideId none = 0xffffffffU;
  struct Found {
    bool any = false;
    std::uint32_t vertex = NodeGrid::none;
  };

  void add_seeds();
  void add_nodes();
  void add_walls();
  void start();
  [[nodiscard]] Point at(Kernel::Vertex v) const { return kernel_.point(v); }
  void enqueue(SideId s);
  void attach(SideId s, Kernel::Half half);
  SideId new_side();
  void release(SideId s);
  [[nodiscard]] bool is_good(Kernel::Vertex a, Kernel::Vertex b, Kernel::Vertex c, double least);
  [[nodiscard]] bool may_close(SideId s, double cosine, double least);
  SideId close(SideId s);
  void close_corners(SideId s);
  [[nodiscard]] Found look(Point q, double clear, double size, Kernel::Vertex a, Kernel::Vertex b,
                           Kernel::Vertex c) const;
  [[nodiscard]] bool fits_corners(SideId s, Point top) const;
  void advance(SideId s);
  Kernel::Vertex add_node(Point q, double size);
  SideId raise(SideId s, Kernel::Vertex v);
  bool join(SideId s, Kernel::Vertex d);

  Kernel& kernel_;
  const FrontalOptions& options_;
  const double expected_;  ///< Number of triangles in the square of the size field, roughly.
  sizing::SizeSampler sampler_;
  NodeGrid grid_;
  Front& front_;
  std::vector<SideId> free_;
  std::vector<double> size_;        ///< One a vertex.
  std::vector<SideId> side_of_;     ///< One a vertex: a side that starts there, if its `from` still says so.
  std::vector<std::uint8_t> safe_;  ///< One a vertex of the input.
  SizeQueue queue_;
  std::uint16_t generation_ = 0;  ///< Of sides that are made now.
  bool done_ = false;
};

Advancer::Advancer(Kernel& kernel, const sizing::SizeField& field, const FrontalOptions& options, Front& front)
    : kernel_(kernel),
      options_(options),
      expected_(field.estimated_triangles()),
      sampler_(field),
      grid_(field, std::min<std::size_t>(static_cast<std::size_t>(0.6 * expected_), options.max_triangles)),
      front_(front) {
  front_ = {};
  make_room(kernel, field, options);
  add_seeds();
  add_nodes();
  add_walls();
  for (Kernel::Cell c = 0; c < kernel_.cell_count(); ++c) {
    if (kernel_.cell(c).region >= 0) kernel_.set_region(c, replaced_region);
  }
  start();
}

// ---- start ----

void Advancer::add_seeds() {
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

void Advancer::add_nodes() {
  const std::size_t count = kernel_.vertex_count();
  size_.assign(count, 0.0);
  safe_.assign(count, 1);
  std::vector<std::uint8_t> used(count, 0);
  for (Kernel::Cell c = 0; c < kernel_.cell_count(); ++c) {
    if (kernel_.cell(c).region < 0) continue;
    for (const Kernel::Vertex v : kernel_.cell(c).vertex) {
      if (used[v] != 0) continue;
      used[v] = 1;
      size_[v] = sampler_.at(at(v));
      grid_.add(at(v), v, sampler_.leaf());
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
      const double least = least_gap * std::min(size_[a], size_[b]);
      if (geom::length_squared(at(b) - at(a)) >= least * least) continue;
      safe_[a] = safe_[b] = 0;
    }
  }
}

/// Places along the marked sides that nodes keep clear of: a long side has no node near its middle.
void Advancer::add_walls() {
  for (const Side& side : front_.sides) {
    const Point a = at(side.from);
    const Point b = at(front_.to(side));
    const double length = geom::distance(a, b);
    const auto add = [&](Point p) {
      const double size = sampler_.at(p);
      grid_.add(p, NodeGrid::none, sampler_.leaf());
      return size;
    };
    // One in the middle of a side of about the size wanted, more on a longer one.
    double t = 0.5 * size_[side.from];
    if (length < longest_seed * add(geom::midpoint(a, b))) continue;
    while (t < length) t += std::max(0.5 * add(geom::interpolate(a, b, t / length)), 1e-6 * length);
  }
}

void Advancer::start() {
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
      if (ratio > shortest_seed && ratio < longest_seed) enqueue(s);
    }
  }
}

// ---- the linked front ----

void Advancer::enqueue(SideId s) {
  Side& side = front_.sides[s];
  side.generation = generation_;
  queue_.push(size_[side.from], {s, side.stamp});
}

/// The half-edge `half` of a new triangle takes the place of the side `s`.
void Advancer::attach(SideId s, Kernel::Half half) {
  const Side& side = front_.sides[s];
  if (side.paired) {
    front_.sides[side.back].back = half;
    front_.sides[side.back].paired = false;
  } else {
    kernel_.link(half, side.back, side.mark);
  }
}

SideId Advancer::new_side() {
  if (free_.empty()) {
    front_.sides.emplace_back();
    return static_cast<SideId>(front_.sides.size() - 1);
  }
  const SideId s = free_.back();
  free_.pop_back();
  return s;
}

void Advancer::release(SideId s) {
  front_.sides[s].from = Side::free;
  ++front_.sides[s].stamp;
  free_.push_back(s);
}

// ---- corners ----

/// Whether the triangle has at least the alpha `least`, and a circle that holds no node: two such triangles cannot
/// cross.
bool Advancer::is_good(Kernel::Vertex a, Kernel::Vertex b, Kernel::Vertex c, double least) {
  const Vector u = at(b) - at(a);
  const Vector w = at(c) - at(a);
  const double twice = geom::cross(u, w);
  const double uu = geom::length_squared(u);
  const double ww = geom::length_squared(w);
  const double vv = geom::length_squared(at(c) - at(b));
  if (2.0 * std::numbers::sqrt3 * twice < least * (uu + vv + ww)) return false;
  for (const Kernel::Vertex v : {a, b, c}) {
    if (v < safe_.size() && safe_[v] == 0) return false;
  }
  const double size = std::min({size_[a], size_[b], size_[c]});
  const double radius_squared = uu * vv * ww / (4.0 * twice * twice);
  if (radius_squared > most_radius * most_radius * size * size) return false;
  if (radius_squared < empty_radius * empty_radius * size * size) return true;
  const Point centre = at(a) + Vector{(w.y * uu - u.y * ww) / (2.0 * twice), (u.x * ww - w.x * uu) / (2.0 * twice)};
  sampler_.at(centre);
  bool empty = true;
  const double inside = radius_squared * (1.0 - 1e-9);
  grid_.visit_near(centre, std::sqrt(radius_squared), sampler_.leaf(), [&](const NodeGrid::Entry& entry) {
    const bool own = entry.vertex == a || entry.vertex == b || entry.vertex == c || entry.vertex == NodeGrid::none;
    if (!own && geom::length_squared(entry.at - centre) < inside) empty = false;
  });
  return empty;
}

/// Whether the sides s = a-b and b-c may be closed by a triangle.
bool Advancer::may_close(SideId s, double cosine, double least) {
  const Side& side = front_.sides[s];
  const Side& next = front_.sides[side.next];
  const Kernel::Vertex a = side.from;
  const Kernel::Vertex b = next.from;
  const Kernel::Vertex c = front_.to(next);
  const Vector u = at(a) - at(b);
  const Vector w = at(c) - at(b);
  const double dot = geom::dot(u, w);
  if (dot * std::abs(dot) < cosine * std::abs(cosine) * geom::length_squared(u) * geom::length_squared(w)) return false;
  return is_good(a, b, c, least);
}

/// Closes the corner between s and the side after it. @return the side that takes their place; none if the front
/// closed.
SideId Advancer::close(SideId s) {
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
void Advancer::close_corners(SideId s) {
  while (true) {
    const SideId before = front_.sides[s].previous;
    if (may_close(s, corner_cosine, least_alpha)) {
      s = close(s);
    } else if (may_close(before, corner_cosine, least_alpha)) {
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
Advancer::Found Advancer::look(Point q, double clear, double size, Kernel::Vertex a, Kernel::Vertex b,
                               Kernel::Vertex c) const {
  Found found;
  double nearest = clear * clear;
  const double wall = options_.least_wall * options_.least_wall * size * size;
  bool blocked = false;
  grid_.visit_near(q, clear, sampler_.leaf(), [&](const NodeGrid::Entry& entry) {
    const double squared = geom::length_squared(entry.at - q);
    if (squared >= nearest) return;
    if (entry.vertex == NodeGrid::none) {
      blocked = blocked || squared < wall;
      return;
    }
    if (entry.vertex == a || entry.vertex == b || entry.vertex == c) return;
    nearest = squared;
    found.vertex = entry.vertex;
  });
  found.any = blocked || found.vertex != NodeGrid::none;
  if (blocked) found.vertex = NodeGrid::none;
  return found;
}

Kernel::Vertex Advancer::add_node(Point q, double size) {
  const Kernel::Vertex v = kernel_.add_vertex(q);
  size_.push_back(size);
  side_of_.push_back(none);
  grid_.add(q, v, sampler_.leaf());
  return v;
}

/// A triangle over side s with top v: s becomes a-v. @return v-b
SideId Advancer::raise(SideId s, Kernel::Vertex v) {
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
bool Advancer::join(SideId s, Kernel::Vertex d) {
  const SideId t = side_of_[d];
  if (t == none || front_.sides[t].from != d) return false;
  const SideId before = front_.sides[t].previous;
  const Kernel::Vertex a = front_.sides[s].from;
  const Kernel::Vertex b = front_.to(front_.sides[s]);
  const Kernel::Vertex e = front_.to(front_.sides[t]);
  const Kernel::Vertex f = front_.sides[before].from;
  if (e == a || f == b || !is_good(a, b, d, least_joint) || !fits_corners(s, at(d))) return false;
  // Both ends must be seen from d between e and f.
  const Vector right = at(e) - at(d);
  const Vector left = at(f) - at(d);
  const auto within = [&](Vector v) {
    if (geom::cross(right, left) > 0.0) return geom::cross(right, v) > 0.0 && geom::cross(v, left) > 0.0;
    return geom::cross(left, v) < 0.0 || geom::cross(v, right) < 0.0;
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
bool Advancer::fits_corners(SideId s, Point top) const {
  const Side& side = front_.sides[s];
  const Point a = at(side.from);
  const Point b = at(front_.to(side));
  // The angle from one side to the other within a corner that opens from `right` to `left`; a corner of more than 180
  // degrees has room for any triangle.
  const auto clear = [](Vector right, Vector left, Vector from, Vector to) {
    if (geom::cross(right, left) <= 0.0 || geom::dot(from, to) <= 0.0) return true;
    constexpr double sine_squared = 0.2;
    const double cross = geom::cross(from, to);
    return cross > 0.0 && cross * cross > sine_squared * geom::length_squared(from) * geom::length_squared(to);
  };
  const Vector before = at(front_.sides[side.previous].from) - a;
  const Vector after = at(front_.to(front_.sides[side.next])) - b;
  return clear(b - a, before, top - a, before) && clear(after, a - b, after, top - b);
}

void Advancer::advance(SideId s) {
  const Side& side = front_.sides[s];
  const Kernel::Vertex a = side.from;
  const Kernel::Vertex b = front_.to(side);
  const Point from = at(a);
  const Point to = at(b);
  const Vector along = to - from;
  const double squared = geom::length_squared(along);
  const double length = std::sqrt(squared);
  const Point middle = geom::midpoint(from, to);
  // A leg is as long as the size in its middle asks: the mean of those at its ends.
  const double below = 0.5 * (size_[a] + size_[b]);
  double size = below;
  Point top;
  double leg = 0.0;
  for (int round = 0; round < 2; ++round) {
    leg = std::clamp(0.5 * (below + size), 0.72 * length, 1.4 * length);
    top = middle + std::sqrt(leg * leg / squared - 0.25) * geom::left_of(along);
    const double there = sampler_.at(top);
    const bool settled = std::abs(there - size) < 0.06 * size;
    size = there;
    if (settled) break;
  }
  if (size > most_growth * below || below > most_shrink * size) return;
  // A long side has no room for a triangle of the size wanted.
  const double height = std::sqrt(leg * leg - 0.25 * squared);
  if (leg * leg > 2.0 * most_radius * std::max(leg, size) * height) return;
  const Found found = look(top, options_.least_spacing * std::max(leg, size), leg, a, b, b);
  if (!found.any) {
    if (!fits_corners(s, top)) return;
    const SideId n = raise(s, add_node(top, size));
    const SideId before = front_.sides[s].previous;
    if (may_close(before, corner_cosine, least_alpha)) {
      const SideId closed = close(before);
      if (closed != none) enqueue(closed);
    } else {
      enqueue(s);
    }
    if (front_.sides[n].from != Side::free) close_corners(n);
    return;
  }
  if (found.vertex == NodeGrid::none) return;
  // The node in the way may be the other end of a neighbour.
  SideId corner = none;
  if (found.vertex == front_.sides[front_.sides[s].previous].from) corner = front_.sides[s].previous;
  if (found.vertex == front_.to(front_.sides[front_.sides[s].next])) corner = s;
  if (corner == none) {
    join(s, found.vertex);
    return;
  }
  if (!may_close(corner, widest_corner, least_joint)) return;
  const SideId closed = close(corner);
  if (closed != none) close_corners(closed);
}

Result<void> Advancer::check_count(const Progress& progress) const {
  DOBRA_TRY_VOID(progress.check());
  const auto count = static_cast<double>(kernel_.cell_count());
  progress.report(std::min(1.0, count / expected_), fmt::format("{} triangles", kernel_.cell_count()));
  DOBRA_TRY_VOID(check_limit(kernel_.cell_count(), options_));
  // The input may be so crowded that the front gets out of the domain; then it would never end.
  if (count > 4.0 * expected_ + 10'000.0) return front_crossed();
  return {};
}

Result<void> Advancer::step(std::size_t count, const Progress& progress) {
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
    if (may_close(entry.side, corner_cosine, least_alpha) || may_close(side.previous, corner_cosine, least_alpha)) {
      close_corners(entry.side);
      continue;
    }
    advance(entry.side);
  }
  return {};
}

std::vector<geom::Segment> Advancer::front() const {
  std::vector<geom::Segment> sides;
  for (const Side& side : front_.sides) {
    if (side.from != Side::free) sides.push_back({at(side.from), at(front_.to(side))});
  }
  return sides;
}

}  // namespace

Error front_crossed() { return {ErrorCode::SelfIntersection, "sides of the advancing front cross", {}}; }

std::unique_ptr<FillEngine> advancing_front(Kernel& kernel, const sizing::SizeField& field,
                                            const FrontalOptions& options, Front& front) {
  return std::make_unique<Advancer>(kernel, field, options, front);
}

}  // namespace dobra::mesh::front
