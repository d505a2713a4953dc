// Storage and traversal of the subdivision; the Euler operators are in euler.cpp.

#include "shared/topo/subdivision.h"

#include <bit>

#include "shared/base/check.h"
#include "shared/geom/predicates.h"

namespace dobra::topo {

using geom::Point;
using geom::Sign;

namespace {

/// -0.0 and 0.0 are the same place.
Point canonical(Point p) { return {p.x + 0.0, p.y + 0.0}; }

template <class Id>
std::vector<Id> live(const std::vector<char>& flags) {
  std::vector<Id> ids;
  for (std::size_t i = 0; i < flags.size(); ++i) {
    if (flags[i]) ids.push_back(Id(i));
  }
  return ids;
}

/// Takes a freed slot or makes one at the end by calling `extend`.
template <class Id, class Extend>
Id take_slot(std::vector<Id>& freed, std::size_t size, const Extend& extend) {
  if (freed.empty()) {
    extend();
    return Id(size);
  }
  const Id id = freed.back();
  freed.pop_back();
  return id;
}

/// True if the way from v to r lies strictly between v->p and v->q, anticlockwise from p to q. Exact.
bool within(Point v, Point p, Point q, Point r) {
  const Sign opening = geom::orient2d(v, p, q);
  if (opening == Sign::Positive) {
    return geom::orient2d(v, p, r) == Sign::Positive && geom::orient2d(v, r, q) == Sign::Positive;
  }
  if (opening == Sign::Negative) {
    return !(geom::orient2d(v, q, r) != Sign::Negative && geom::orient2d(v, r, p) != Sign::Negative);
  }
  return geom::orient2d(v, p, r) == Sign::Positive;  // p and q are opposite
}

}  // namespace

std::size_t Subdivision::PointHash::operator()(const Point& p) const noexcept {
  std::uint64_t h = std::bit_cast<std::uint64_t>(p.x) * 0x9e3779b97f4a7c15ULL;
  h ^= std::rotl(std::bit_cast<std::uint64_t>(p.y) * 0xc2b2ae3d27d4eb4fULL, 31);
  h ^= h >> 29;
  return h * 0xbf58476d1ce4e5b9ULL;
}

Subdivision::Subdivision() { new_face(); }

std::vector<VertexId> Subdivision::vertices() const { return live<VertexId>(vertex_live_); }
std::vector<EdgeId> Subdivision::edges() const { return live<EdgeId>(edge_live_); }
std::vector<LoopId> Subdivision::loops() const { return live<LoopId>(loop_live_); }
std::vector<FaceId> Subdivision::faces() const { return live<FaceId>(face_live_); }

std::vector<HalfEdgeId> Subdivision::round(VertexId v) const {
  std::vector<HalfEdgeId> all;
  const HalfEdgeId start = leaving(v);
  if (!start.valid()) return all;
  HalfEdgeId h = start;
  do {
    all.push_back(h);
    h = turned(h);
  } while (h != start);
  return all;
}

std::vector<HalfEdgeId> Subdivision::half_edges(LoopId l) const {
  std::vector<HalfEdgeId> all;
  const HalfEdgeId start = first(l);
  if (!start.valid()) return all;
  HalfEdgeId h = start;
  do {
    all.push_back(h);
    h = next(h);
  } while (h != start);
  return all;
}

std::vector<LoopId> Subdivision::loops(FaceId f) const {
  std::vector<LoopId> all;
  const LoopId start = first_loop_[f.index()];
  if (!start.valid()) return all;
  LoopId l = start;
  do {
    all.push_back(l);
    l = loop_next_[l.index()];
  } while (l != start);
  return all;
}

std::optional<VertexId> Subdivision::vertex_at(Point p) const {
  const auto found = at_.find(canonical(p));
  if (found == at_.end()) return std::nullopt;
  return found->second;
}

HalfEdgeId Subdivision::between(VertexId a, VertexId b) const {
  const HalfEdgeId start = leaving(a);
  if (!start.valid()) return {};
  HalfEdgeId h = start;
  do {
    if (target(h) == b) return h;
    h = turned(h);
  } while (h != start);
  return {};
}

Corner Subdivision::corner(VertexId v, Point p) const {
  const HalfEdgeId start = leaving(v);
  if (!start.valid()) return {v, {}};
  HalfEdgeId h = start;
  do {
    const HalfEdgeId after = turned(h);
    if (after == h || within(point(v), point(target(h)), point(target(after)), p)) return {v, h};
    h = after;
  } while (h != start);
  DOBRA_CHECK(!"an edge already runs that way");
  return {};
}

FaceId Subdivision::face(const Corner& c) const { return face(loop_of(c)); }

LoopId Subdivision::loop_of(const Corner& c) const {
  return c.before.valid() ? loop(c.before) : lone_loop(c.vertex);
}

VertexId Subdivision::new_vertex(Point p) {
  const VertexId v = take_slot(free_vertices_, point_.size(), [&] {
    point_.emplace_back();
    leaving_.emplace_back();
    lone_loop_.emplace_back();
    vertex_attribute_.emplace_back();
    vertex_live_.push_back(0);
  });
  const std::size_t i = v.index();
  point_[i] = canonical(p);
  leaving_[i] = {};
  lone_loop_[i] = {};
  vertex_live_[i] = 1;
  const bool fresh = at_.emplace(point_[i], v).second;
  DOBRA_CHECK(fresh);  // two vertices never share a place
  return v;
}

EdgeId Subdivision::new_edge(VertexId from, VertexId to) {
  const EdgeId e = take_slot(free_edges_, edge_live_.size(), [&] {
    for (int side = 0; side < 2; ++side) {
      next_.emplace_back();
      previous_.emplace_back();
      origin_.emplace_back();
      loop_.emplace_back();
    }
    edge_attribute_.emplace_back();
    edge_live_.push_back(0);
  });
  edge_live_[e.index()] = 1;
  const HalfEdgeId h = half_edge(e);
  origin_[h.index()] = from;
  origin_[twin(h).index()] = to;
  tree_.insert(static_cast<std::uint32_t>(2 * e.index()), segment(e).box());
  return e;
}

LoopId Subdivision::new_loop(FaceId f) {
  const LoopId l = take_slot(free_loops_, loop_face_.size(), [&] {
    first_.emplace_back();
    lone_vertex_.emplace_back();
    loop_face_.emplace_back();
    loop_next_.emplace_back();
    loop_previous_.emplace_back();
    loop_live_.push_back(0);
  });
  first_[l.index()] = {};
  lone_vertex_[l.index()] = {};
  loop_live_[l.index()] = 1;
  attach(l, f);
  return l;
}

FaceId Subdivision::new_face() {
  const FaceId f = take_slot(free_faces_, first_loop_.size(), [&] {
    outer_.emplace_back();
    first_loop_.emplace_back();
    face_attribute_.emplace_back();
    face_live_.push_back(0);
  });
  outer_[f.index()] = {};
  first_loop_[f.index()] = {};
  face_live_[f.index()] = 1;
  return f;
}

void Subdivision::free_vertex(VertexId v) {
  at_.erase(point(v));
  vertex_live_[v.index()] = 0;
  vertex_attribute_[v.index()].reset();
  free_vertices_.push_back(v);
}

void Subdivision::free_edge(EdgeId e) {
  tree_.erase(static_cast<std::uint32_t>(2 * e.index()));
  edge_live_[e.index()] = 0;
  edge_attribute_[e.index()].reset();
  free_edges_.push_back(e);
}

void Subdivision::free_loop(LoopId l) {
  detach(l);
  loop_live_[l.index()] = 0;
  free_loops_.push_back(l);
}

void Subdivision::free_face(FaceId f) {
  DOBRA_CHECK(!first_loop_[f.index()].valid());
  face_live_[f.index()] = 0;
  face_attribute_[f.index()].reset();
  free_faces_.push_back(f);
}

void Subdivision::attach(LoopId l, FaceId f) {
  loop_face_[l.index()] = f;
  LoopId& head = first_loop_[f.index()];
  if (!head.valid()) {
    head = l;
    loop_next_[l.index()] = loop_previous_[l.index()] = l;
    return;
  }
  const LoopId last = loop_previous_[head.index()];
  loop_next_[last.index()] = l;
  loop_previous_[l.index()] = last;
  loop_next_[l.index()] = head;
  loop_previous_[head.index()] = l;
}

void Subdivision::detach(LoopId l) {
  const FaceId f = face(l);
  const LoopId after = loop_next_[l.index()];
  const LoopId before = loop_previous_[l.index()];
  loop_next_[before.index()] = after;
  loop_previous_[after.index()] = before;
  if (first_loop_[f.index()] == l) first_loop_[f.index()] = after == l ? LoopId() : after;
  if (outer_[f.index()] == l) outer_[f.index()] = {};
}

}  // namespace dobra::topo
