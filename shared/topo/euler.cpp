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

std::uint32_t item_of(VertexId v) { return static_cast<std::uint32_t>(2 * v.index() + 1); }
std::uint32_t item_of(EdgeId e) { return static_cast<std::uint32_t>(2 * e.index()); }

geom::Box box_at(Point p) { return {p, p}; }

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
    loop_[h.index()] = l;
    h = next(h);
  } while (h != start);
}

void Subdivision::set_lone(VertexId v, LoopId l) {
  first_[l.index()] = {};
  lone_vertex_[l.index()] = v;
  lone_loop_[v.index()] = l;
  leaving_[v.index()] = {};
  tree_.insert(item_of(v), box_at(point(v)));
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

HalfEdgeId Subdivision::link_edge(const Corner& from, const Corner& to) {
  const HalfEdgeId from_in = from.before.valid() ? previous(from.before) : HalfEdgeId();
  const HalfEdgeId to_in = to.before.valid() ? previous(to.before) : HalfEdgeId();
  const HalfEdgeId out = half_edge(new_edge(from.vertex, to.vertex));
  const HalfEdgeId back = twin(out);
  if (from_in.valid()) {
    link(from_in, out);
    link(back, from.before);
  } else {
    link(back, out);
    leaving_[from.vertex.index()] = out;
  }
  if (to_in.valid()) {
    link(to_in, back);
    link(out, to.before);
  } else {
    link(out, back);
    leaving_[to.vertex.index()] = back;
  }
  return out;
}

void Subdivision::unlink_edge(HalfEdgeId h) {
  for (const HalfEdgeId side : {h, twin(h)}) {
    const HalfEdgeId in = previous(side);
    const HalfEdgeId after = next(twin(side));
    const VertexId v = origin(side);
    if (in == twin(side)) {
      leaving_[v.index()] = {};
    } else {
      if (leaving(v) == side) leaving_[v.index()] = after;
      link(in, after);
    }
  }
}

VertexId Subdivision::mvsf(FaceId f, Point p) {
  DOBRA_CHECK(contains(f));
  const VertexId v = new_vertex(p);
  set_lone(v, new_loop(f));
  ++components_;
  return v;
}

void Subdivision::kvsf(VertexId v) {
  DOBRA_CHECK(contains(v) && lone_loop(v).valid());
  tree_.erase(item_of(v));
  free_loop(lone_loop(v));
  free_vertex(v);
  --components_;
}

HalfEdgeId Subdivision::mev(const Corner& from, Point p) {
  return mekr(from, {mvsf(face(from), p), {}});
}

void Subdivision::kev(HalfEdgeId h) {
  const VertexId end = target(h);
  DOBRA_CHECK(next(h) == twin(h));
  kemr(h);
  kvsf(end);
}

HalfEdgeId Subdivision::mekr(const Corner& from, const Corner& to) {
  LoopId kept = loop_of(from);
  LoopId gone = loop_of(to);
  DOBRA_CHECK(kept != gone && face(kept) == face(gone));
  const HalfEdgeId from_side = first(kept);
  const HalfEdgeId to_side = first(gone);
  const bool from_is_shorter =
      !from_side.valid() || (to_side.valid() && shorter(from_side, to_side) == from_side);
  if (from_is_shorter && to_side.valid()) std::swap(kept, gone);
  const FaceId f = face(kept);
  const bool outer = outer_loop(f) == gone || outer_loop(f) == kept;
  for (const Corner& c : {from, to}) {
    if (c.before.valid()) continue;
    tree_.erase(item_of(c.vertex));
    lone_loop_[c.vertex.index()] = {};
  }
  if (first(gone).valid()) label(first(gone), kept);
  free_loop(gone);
  const HalfEdgeId h = link_edge(from, to);
  loop_[h.index()] = loop_[twin(h).index()] = kept;
  first_[kept.index()] = h;
  lone_vertex_[kept.index()] = {};
  if (outer) outer_[f.index()] = kept;
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
  const bool b_is_new = !b_side.valid() || (a_side.valid() && shorter(b_side, a_side) == b_side);
  const auto give = [&](HalfEdgeId side, VertexId v, LoopId l) {
    if (side.valid()) {
      first_[l.index()] = side;
      if (l == fresh) label(side, l);
    } else {
      set_lone(v, l);
    }
  };
  give(a_side, a, b_is_new ? old : fresh);
  give(b_side, b, b_is_new ? fresh : old);
  if (outer && !runs_round_hole(fresh)) outer_[f.index()] = fresh;
  ++components_;
}

void Subdivision::move_enclosed_loops(FaceId from, FaceId to, LoopId by, LoopId rest) {
  // Few loops: look at each. Many: only at those that have something within the box of the enclosing loop.
  geom::Box box;
  for (const HalfEdgeId h : half_edges(by)) box.add(point(origin(h)));
  std::vector<LoopId> candidates;
  LoopId l = first_loop_[from.index()];
  for (int i = 0; i < 16 && l.valid(); ++i) {
    candidates.push_back(l);
    l = loop_next_[l.index()];
    if (l == first_loop_[from.index()]) l = {};
  }
  if (l.valid()) {
    candidates.clear();
    tree_.visit(box, [&](std::uint32_t item) {
      if (item % 2 == 1) {
        candidates.push_back(lone_loop(VertexId(item / 2)));
      } else {
        candidates.push_back(loop(half_edge(EdgeId(item / 2))));
        candidates.push_back(loop(twin(half_edge(EdgeId(item / 2)))));
      }
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

HalfEdgeId Subdivision::mef(const Corner& from, const Corner& to) {
  const LoopId old = loop_of(from);
  DOBRA_CHECK(from.before.valid() && to.before.valid() && from.vertex != to.vertex && old == loop_of(to));
  const FaceId f = face(old);
  const bool outer = outer_loop(f) == old;
  const HalfEdgeId h = link_edge(from, to);
  const HalfEdgeId small = shorter(h, twin(h));
  const FaceId fresh_face = new_face();
  face_attribute_[fresh_face.index()] = face_attribute_[f.index()];
  const LoopId fresh = new_loop(f);
  label(small, fresh);
  first_[fresh.index()] = small;
  first_[old.index()] = twin(small);
  loop_[twin(small).index()] = old;
  LoopId bound = fresh;  // the outer loop of the new face
  if (!outer && runs_round_hole(fresh)) bound = old;
  detach(bound);
  attach(bound, fresh_face);
  outer_[fresh_face.index()] = bound;
  const LoopId rest = bound == fresh ? old : fresh;
  if (outer) outer_[f.index()] = rest;
  // `small` decides: the other loops of f were outside the component, hence are in the new face if it encloses them.
  if (loop_next_[rest.index()] != rest) {
    detach(rest);  // not to be moved itself
    if (first_loop_[f.index()].valid()) move_enclosed_loops(f, fresh_face, fresh, rest);
    attach(rest, f);
    if (outer) outer_[f.index()] = rest;
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
  const bool relabel_kept = shorter(h, twin(h)) == h;
  const LoopId merged = relabel_kept ? gone_loop : kept_loop;
  label(relabel_kept ? h : twin(h), merged);
  unlink_edge(h);
  free_edge(edge(h));
  first_[merged.index()] = relabel_kept ? gone_rest : kept_rest;
  free_loop(relabel_kept ? kept_loop : gone_loop);
  for (const LoopId l : loops(gone)) {
    detach(l);
    attach(l, kept);
  }
  // Side by side, or a hole closed from inside: the outer loop of the kept face stays; else the other's is taken over.
  if (kept_was_outer) outer_[kept.index()] = gone_was_outer ? merged : gone_outer;
  free_face(gone);
  return kept;
}

VertexId Subdivision::split(EdgeId e, Point p) {
  DOBRA_CHECK(contains(e));
  const HalfEdgeId h = half_edge(e);
  const HalfEdgeId t = twin(h);
  const VertexId end = target(h);
  const VertexId middle = new_vertex(p);
  tree_.erase(item_of(e));
  const HalfEdgeId after = next(h);
  const HalfEdgeId before = previous(t);
  const EdgeId fresh = new_edge(middle, end);
  const HalfEdgeId fh = half_edge(fresh);
  const HalfEdgeId ft = twin(fh);
  edge_attribute_[fresh.index()] = edge_attribute_[e.index()];
  origin_[t.index()] = middle;
  tree_.insert(item_of(e), segment(e).box());
  loop_[fh.index()] = loop(h);
  loop_[ft.index()] = loop(t);
  link(h, fh);
  link(ft, t);
  if (after == t) {
    link(fh, ft);
  } else {
    link(fh, after);
    link(before, ft);
  }
  leaving_[middle.index()] = fh;
  if (leaving(end) == t) leaving_[end.index()] = ft;
  return middle;
}

EdgeId Subdivision::join(VertexId v) {
  DOBRA_CHECK(degree(v) == 2);
  HalfEdgeId a = leaving(v);
  HalfEdgeId b = turned(a);
  if (edge(b) < edge(a)) std::swap(a, b);
  // Now edge(a) stays: x <-a- v -b-> y becomes x - y.
  const HalfEdgeId in = twin(a);
  const HalfEdgeId back = twin(b);
  const VertexId end = target(b);
  DOBRA_CHECK(target(a) != end);
  const HalfEdgeId after = next(b);
  const HalfEdgeId before = previous(back);
  tree_.erase(item_of(edge(a)));
  origin_[a.index()] = end;
  tree_.insert(item_of(edge(a)), segment(edge(a)).box());
  if (after == back) {
    link(in, a);
  } else {
    link(in, after);
    link(before, a);
  }
  if (leaving(end) == back) leaving_[end.index()] = a;
  if (first(loop(b)) == b) first_[loop(b).index()] = in;
  if (first(loop(back)) == back) first_[loop(back).index()] = a;
  free_edge(edge(b));
  free_vertex(v);
  return edge(a);
}

HalfEdgeId Subdivision::connect(VertexId a, VertexId b) {
  const Corner from = corner(a, point(b));
  const Corner to = corner(b, point(a));
  return loop_of(from) == loop_of(to) ? mef(from, to) : mekr(from, to);
}

}  // namespace dobra::topo
