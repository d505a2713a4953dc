// The Euler operators. Where a loop falls apart or two become one, the walk that relabels half-edges goes round the
// shorter of the two cycles, both being walked in step to learn which it is.

#include <algorithm>

#include "shared/base/check.h"
#include "shared/geom/predicates.h"
#include "shared/topo/subdivision.h"

namespace dobra::topo {

using geom::Point;
using geom::Sign;

namespace {

/// True if the segment crosses the upward ray from p; ends count half-open in x, so that chains are counted right.
bool crosses_ray(const geom::Segment& s, Point p) {
  if ((s.from.x <= p.x) == (s.to.x <= p.x)) return false;
  const Sign side = geom::orient2d(s.from, s.to, p);
  return s.from.x < s.to.x ? side == Sign::Negative : side == Sign::Positive;
}

}  // namespace

HalfEdgeId Subdivision::shorter(HalfEdgeId a, HalfEdgeId b) const {
  HalfEdgeId p = a;
  HalfEdgeId q = b;
  while (true) {
    p = next(p);
    if (p == a) return a;
    q = next(q);
    if (q == b) return b;
  }
}

void Subdivision::label(HalfEdgeId start, LoopId l) {
  HalfEdgeId h = start;
  do {
    half_edges_[h.index()].loop = l;
    h = next(h);
  } while (h != start);
}

/// At its least point every way out of a loop turns within a half-plane, so that the far west lies in the sector of
/// the face exactly where the next way out is not above the last way in.
bool Subdivision::runs_round_hole(LoopId l) const {
  const HalfEdgeId start = first(l);
  if (!start.valid()) return true;
  Point least = point(origin(start));
  for (HalfEdgeId h = next(start); h != start; h = next(h)) least = std::min(least, point(origin(h)));
  HalfEdgeId h = start;
  do {
    if (point(origin(h)) == least) {
      const HalfEdgeId in = previous(h);
      if (in == twin(h) || geom::orient2d(least, point(origin(in)), point(target(h))) == Sign::Positive) return true;
    }
    h = next(h);
  } while (h != start);
  return false;
}

bool Subdivision::encloses(LoopId l, Point p) const {
  const HalfEdgeId start = first(l);
  bool odd = false;
  HalfEdgeId h = start;
  do {
    if (crosses_ray(segment(h), p)) odd = !odd;
    h = next(h);
  } while (h != start);
  return odd;
}

HalfEdgeId Subdivision::link_edge(const Corner& from, const Corner& to, Room room) {
  const HalfEdgeId from_in = from.before.valid() ? previous(from.before) : HalfEdgeId();
  const HalfEdgeId to_in = to.before.valid() ? previous(to.before) : HalfEdgeId();
  const HalfEdgeId out = half_edge(new_edge(from.vertex, to.vertex, room));
  const HalfEdgeId back = twin(out);
  if (from_in.valid()) {
    link(from_in, out);
    link(back, from.before);
  } else {
    link(back, out);
    vertices_[from.vertex.index()].leaving = out;
  }
  if (to_in.valid()) {
    link(to_in, back);
    link(out, to.before);
  } else {
    link(out, back);
    vertices_[to.vertex.index()].leaving = back;
  }
  return out;
}

void Subdivision::unlink_edge(HalfEdgeId h) {
  for (const HalfEdgeId side : {h, twin(h)}) {
    const HalfEdgeId in = previous(side);
    const HalfEdgeId after = next(twin(side));
    const VertexId v = origin(side);
    if (in == twin(side)) {
      vertices_[v.index()].leaving = {};
    } else {
      if (leaving(v) == side) vertices_[v.index()].leaving = after;
      link(in, after);
    }
  }
}

VertexId Subdivision::mvsf(FaceId f, Point p) {
  DOBRA_CHECK(contains(f));
  tighten(p, {});
  const VertexId v = new_vertex(p);
  set_lone(v, new_loop(f));
  ++components_;
  return v;
}

void Subdivision::kvsf(VertexId v) {
  DOBRA_CHECK(contains(v) && lone_loop(v).valid());
  free_loop(lone_loop(v));
  end_lone(v);
  free_vertex(v);
  --components_;
}

HalfEdgeId Subdivision::mev(const Corner& from, Point p, Room room) {
  const LoopId l = loop(from);
  if (room == Room::Unknown) tighten(p, {});
  const VertexId v = new_vertex(p);
  if (!from.before.valid()) end_lone(from.vertex);
  const HalfEdgeId h = link_edge(from, {v, {}}, room);
  half_edges_[h.index()].loop = half_edges_[twin(h).index()].loop = l;
  loops_[l.index()].first = h;
  loops_[l.index()].lone_vertex = {};
  return h;
}

void Subdivision::kev(HalfEdgeId h) {
  const VertexId end = target(h);
  DOBRA_CHECK(next(h) == twin(h));
  kemr(h);
  kvsf(end);
}

HalfEdgeId Subdivision::mekr(const Corner& from, const Corner& to, Room room) {
  LoopId kept = loop(from);
  LoopId gone = loop(to);
  DOBRA_CHECK(kept != gone && face(kept) == face(gone));
  const HalfEdgeId from_side = first(kept);
  const HalfEdgeId to_side = first(gone);
  const bool from_is_shorter = !from_side.valid() || (to_side.valid() && shorter(from_side, to_side) == from_side);
  if (from_is_shorter && to_side.valid()) std::swap(kept, gone);
  const FaceId f = face(kept);
  const bool outer = outer_loop(f) == gone || outer_loop(f) == kept;
  for (const Corner& c : {from, to}) {
    if (c.before.valid()) continue;
    end_lone(c.vertex);
  }
  if (first(gone).valid()) label(first(gone), kept);
  free_loop(gone);
  const HalfEdgeId h = link_edge(from, to, room);
  half_edges_[h.index()].loop = half_edges_[twin(h).index()].loop = kept;
  loops_[kept.index()].first = h;
  loops_[kept.index()].lone_vertex = {};
  if (outer) faces_[f.index()].outer = kept;
  --components_;
  return h;
}

void Subdivision::kemr(HalfEdgeId h) {
  const LoopId old = loop(h);
  DOBRA_CHECK(old == loop(twin(h)));
  const FaceId f = face(old);
  const bool outer = outer_loop(f) == old;
  const VertexId a = origin(h);
  const VertexId b = target(h);
  const HalfEdgeId a_side = previous(h) == twin(h) ? HalfEdgeId() : next(twin(h));
  const HalfEdgeId b_side = next(h) == twin(h) ? HalfEdgeId() : next(h);
  unlink_edge(h);
  free_edge(edge(h));
  const LoopId fresh = new_loop(f);
  const bool b_is_new = !b_side.valid() || (a_side.valid() && shorter(a_side, b_side) != a_side);  // as mekr chose
  const auto give = [&](HalfEdgeId side, VertexId v, LoopId l) {
    if (side.valid()) {
      loops_[l.index()].first = side;
      if (l == fresh) label(side, l);
    } else {
      set_lone(v, l);
    }
  };
  give(a_side, a, b_is_new ? old : fresh);
  give(b_side, b, b_is_new ? fresh : old);
  if (outer && !runs_round_hole(fresh)) faces_[f.index()].outer = fresh;
  ++components_;
}

void Subdivision::move_enclosed_loops(FaceId from, FaceId to, LoopId by, LoopId rest) {
  // Few loops: look at each. Many: only at those that have something within the box of the enclosing loop.
  geom::Box box;
  for (const HalfEdgeId h : half_edges(by)) box.add(point(origin(h)));
  std::vector<LoopId> candidates;
  LoopId l = faces_[from.index()].first;
  for (int i = 0; i < 16 && l.valid(); ++i) {
    candidates.push_back(l);
    l = loops_[l.index()].next;
    if (l == faces_[from.index()].first) l = {};
  }
  if (l.valid()) {
    candidates.clear();
    const auto offer = [&](LoopId c) {  // neighbours in the tree are mostly of one loop
      if (face(c) == from && (candidates.empty() || candidates.back() != c)) candidates.push_back(c);
    };
    lone_tree_.visit(box, [&](std::uint32_t v, const geom::Segment&) { offer(lone_loop(VertexId(v))); });
    edge_tree_.visit(box, [&](std::uint32_t e, const geom::Segment&) {
      offer(loop(half_edge(EdgeId(e))));
      offer(loop(twin(half_edge(EdgeId(e)))));
    });
    std::sort(candidates.begin(), candidates.end());
    candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
  }
  for (const LoopId c : candidates) {
    if (face(c) != from || c == by || c == rest || c == outer_loop(from)) continue;
    const Point p = first(c).valid() ? point(origin(first(c))) : point(lone_vertex(c));
    if (!box.contains(p) || !encloses(by, p)) continue;
    detach(c);
    attach(c, to);
  }
}

HalfEdgeId Subdivision::mef(const Corner& from, const Corner& to, Room room) {
  const LoopId old = loop(from);
  DOBRA_CHECK(from.before.valid() && to.before.valid() && from.vertex != to.vertex && old == loop(to));
  const FaceId f = face(old);
  const bool outer = outer_loop(f) == old;
  const HalfEdgeId h = link_edge(from, to, room);
  const HalfEdgeId small = shorter(h, twin(h));
  const FaceId fresh_face = new_face();
  face_attribute_.copy(f.index(), fresh_face.index(), faces_.size());
  const LoopId fresh = new_loop(f);
  label(small, fresh);
  loops_[fresh.index()].first = small;
  loops_[old.index()].first = twin(small);
  half_edges_[twin(small).index()].loop = old;
  LoopId bound = fresh;  // the outer loop of the new face
  if (!outer && runs_round_hole(fresh)) bound = old;
  detach(bound);
  attach(bound, fresh_face);
  faces_[fresh_face.index()].outer = bound;
  const LoopId rest = bound == fresh ? old : fresh;
  if (outer) faces_[f.index()].outer = rest;
  // `small` decides: the other loops of f were outside the component, hence are in the new face if it encloses them.
  if (loops_[rest.index()].next != rest) {
    detach(rest);  // not to be moved itself
    if (faces_[f.index()].first.valid()) move_enclosed_loops(f, fresh_face, fresh, rest);
    attach(rest, f);
    if (outer) faces_[f.index()].outer = rest;
  }
  return h;
}

FaceId Subdivision::kef(HalfEdgeId h) {
  FaceId kept = face(h);
  FaceId gone = face(twin(h));
  DOBRA_CHECK(kept != gone);
  if (gone == unbounded()) {
    std::swap(kept, gone);
    h = twin(h);
  }
  const LoopId kept_loop = loop(h);
  const LoopId gone_loop = loop(twin(h));
  const bool kept_was_outer = outer_loop(kept) == kept_loop;
  const bool gone_was_outer = outer_loop(gone) == gone_loop;
  const LoopId gone_outer = outer_loop(gone);
  const HalfEdgeId kept_rest = next(h);
  const HalfEdgeId gone_rest = next(twin(h));
  const bool relabel_kept = shorter(half_edge(edge(h)), twin(half_edge(edge(h)))) == h;  // as mef chose
  const LoopId merged = relabel_kept ? gone_loop : kept_loop;
  label(relabel_kept ? h : twin(h), merged);
  unlink_edge(h);
  free_edge(edge(h));
  loops_[merged.index()].first = relabel_kept ? gone_rest : kept_rest;
  free_loop(relabel_kept ? kept_loop : gone_loop);
  for (const LoopId l : loops(gone)) {
    detach(l);
    attach(l, kept);
  }
  // Side by side, or a hole closed from inside: the outer loop of the kept face stays; else the other's is taken over.
  if (kept_was_outer) faces_[kept.index()].outer = gone_was_outer ? merged : gone_outer;
  free_face(gone);
  return kept;
}

VertexId Subdivision::split(EdgeId e, Point p, Room room) {
  DOBRA_CHECK(contains(e));
  const HalfEdgeId h = half_edge(e);
  const HalfEdgeId t = twin(h);
  const VertexId end = target(h);
  if (room == Room::Unknown) tighten(p, e);
  const VertexId middle = new_vertex(p);
  const HalfEdgeId after = next(h);
  const HalfEdgeId before = previous(t);
  const EdgeId fresh = new_edge(middle, end, Room::Clear);
  if (room_[e.index()] != 0) --room_[e.index()];  // rounding of p may have bent it
  room_[fresh.index()] = room_[e.index()];
  const HalfEdgeId fh = half_edge(fresh);
  const HalfEdgeId ft = twin(fh);
  edge_attribute_.copy(e.index(), fresh.index(), edge_live_.size());
  half_edges_[t.index()].origin = middle;
  move_edge(e);
  half_edges_[fh.index()].loop = loop(h);
  half_edges_[ft.index()].loop = loop(t);
  link(h, fh);
  link(ft, t);
  if (after == t) {
    link(fh, ft);
  } else {
    link(fh, after);
    link(before, ft);
  }
  vertices_[middle.index()].leaving = fh;
  if (leaving(end) == t) vertices_[end.index()].leaving = ft;
  return middle;
}

EdgeId Subdivision::join(VertexId v, EdgeId kept) {
  DOBRA_CHECK(degree(v) == 2);
  HalfEdgeId a = leaving(v);
  HalfEdgeId b = turned(a);
  if (kept.valid() ? edge(b) == kept : edge(b) < edge(a)) std::swap(a, b);
  DOBRA_CHECK(!kept.valid() || edge(a) == kept);
  // Now edge(a) stays: x <-a- v -b-> y becomes x - y.
  const HalfEdgeId in = twin(a);
  const HalfEdgeId back = twin(b);
  const VertexId end = target(b);
  DOBRA_CHECK(target(a) != end);
  const HalfEdgeId after = next(b);
  const HalfEdgeId before = previous(back);
  half_edges_[a.index()].origin = end;
  move_edge(edge(a));
  room_[edge(a).index()] = 0;
  if (after == back) {
    link(in, a);
  } else {
    link(in, after);
    link(before, a);
  }
  if (leaving(end) == back) vertices_[end.index()].leaving = a;
  if (first(loop(b)) == b) loops_[loop(b).index()].first = in;
  if (first(loop(back)) == back) loops_[loop(back).index()].first = a;
  free_edge(edge(b));
  free_vertex(v);
  return edge(a);
}

HalfEdgeId Subdivision::connect(const Corner& from, const Corner& to, Room room) {
  return loop(from) == loop(to) ? mef(from, to, room) : mekr(from, to, room);
}

}  // namespace dobra::topo
