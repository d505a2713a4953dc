// Storage of the subdivision: slots, links and lists. The Euler operators are in euler.cpp.

#include "shared/topo/subdivision.h"

#include <limits>

#include "shared/base/check.h"

namespace dobra::topo {

using geom::Point;

namespace {

/// -0.0 and 0.0 are the same place.
Point canonical(Point p) { return {p.x + 0.0, p.y + 0.0}; }

double greatest(Point p) { return std::max(std::abs(p.x), std::abs(p.y)); }

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

}  // namespace

Subdivision::Subdivision() { new_face(); }

double Subdivision::margin(Point with) const {
  const double reach = std::max(reach_, greatest(with));
  return reach > 0x1p-200 && reach < 0x1p200 ? 0x1p-43 * reach : std::numeric_limits<double>::infinity();
}

/// Takes all edges that p is near to off the list of those that may be bent unseen.
void Subdivision::tighten(Point p, EdgeId except) {
  const double near = std::min(margin(p), std::numeric_limits<double>::max());
  edge_tree_.visit(geom::Box{p, p}.grown(near), [&](std::uint32_t item, const geom::Segment& s) {
    if (EdgeId(item) != except && room_[item] != 0 && !(geom::distance(s, p) > 1.5 * near)) room_[item] = 0;
  });
}

VertexId Subdivision::new_vertex(Point p) {
  const VertexId v = take_slot(free_vertices_, vertices_.size(), [&] { vertices_.emplace_back(); });
  vertices_[v.index()] = {canonical(p), {}, {}, true};
  DOBRA_CHECK(at_.find(point(v), place_of()) == PointTable::none);  // two vertices never share a place
  at_.insert(static_cast<std::uint32_t>(v.index()), place_of());
  reach_ = std::max(reach_, greatest(p));
  return v;
}

EdgeId Subdivision::new_edge(VertexId from, VertexId to, Room room) {
  const EdgeId e = take_slot(free_edges_, edge_live_.size(), [&] {
    half_edges_.resize(half_edges_.size() + 2);
    edge_live_.push_back(0);
    room_.push_back(0);
    mark_.push_back(0);
  });
  edge_live_[e.index()] = 1;
  room_[e.index()] = room == Room::Clear ? full_room : std::uint8_t{0};
  const HalfEdgeId h = half_edge(e);
  half_edges_[h.index()].origin = from;
  half_edges_[twin(h).index()].origin = to;
  edge_tree_.insert(static_cast<std::uint32_t>(e.index()), segment(e));
  return e;
}

LoopId Subdivision::new_loop(FaceId f) {
  const LoopId l = take_slot(free_loops_, loops_.size(), [&] { loops_.emplace_back(); });
  loops_[l.index()] = {};
  loops_[l.index()].live = true;
  attach(l, f);
  return l;
}

FaceId Subdivision::new_face() {
  const FaceId f = take_slot(free_faces_, faces_.size(), [&] { faces_.emplace_back(); });
  faces_[f.index()] = {{}, {}, true};
  return f;
}

void Subdivision::free_vertex(VertexId v) {
  at_.erase(point(v), place_of());
  vertices_[v.index()].live = false;
  vertex_attribute_.reset(v.index());
  free_vertices_.push_back(v);
}

void Subdivision::free_edge(EdgeId e) {
  edge_tree_.erase(static_cast<std::uint32_t>(e.index()));
  edge_live_[e.index()] = 0;
  edge_attribute_.reset(e.index());
  free_edges_.push_back(e);
}

void Subdivision::free_loop(LoopId l) {
  detach(l);
  loops_[l.index()].live = false;
  free_loops_.push_back(l);
}

void Subdivision::free_face(FaceId f) {
  DOBRA_CHECK(!faces_[f.index()].first.valid());
  faces_[f.index()].live = false;
  face_attribute_.reset(f.index());
  free_faces_.push_back(f);
}

void Subdivision::attach(LoopId l, FaceId f) {
  Loop& loop = loops_[l.index()];
  loop.face = f;
  LoopId& head = faces_[f.index()].first;
  if (!head.valid()) {
    head = l;
    loop.next = loop.previous = l;
    return;
  }
  const LoopId last = loops_[head.index()].previous;
  loops_[last.index()].next = l;
  loop.previous = last;
  loop.next = head;
  loops_[head.index()].previous = l;
}

void Subdivision::detach(LoopId l) {
  Face& face = faces_[loops_[l.index()].face.index()];
  const LoopId after = loops_[l.index()].next;
  const LoopId before = loops_[l.index()].previous;
  loops_[before.index()].next = after;
  loops_[after.index()].previous = before;
  if (face.first == l) face.first = after == l ? LoopId() : after;
  if (face.outer == l) face.outer = {};
}

void Subdivision::link(HalfEdgeId a, HalfEdgeId b) {
  half_edges_[a.index()].next = b;
  half_edges_[b.index()].previous = a;
}

/// The edge has got another end.
void Subdivision::move_edge(EdgeId e) {
  edge_tree_.erase(static_cast<std::uint32_t>(e.index()));
  edge_tree_.insert(static_cast<std::uint32_t>(e.index()), segment(e));
}

void Subdivision::set_lone(VertexId v, LoopId l) {
  loops_[l.index()].first = {};
  loops_[l.index()].lone_vertex = v;
  vertices_[v.index()].lone_loop = l;
  vertices_[v.index()].leaving = {};
  lone_tree_.insert(static_cast<std::uint32_t>(v.index()), {point(v), point(v)});
}

/// v is about to get its first edge.
void Subdivision::end_lone(VertexId v) {
  lone_tree_.erase(static_cast<std::uint32_t>(v.index()));
  vertices_[v.index()].lone_loop = {};
}

}  // namespace dobra::topo
