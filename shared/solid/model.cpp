#include "shared/solid/model.h"

#include <fmt/format.h>

#include <algorithm>

#include "shared/base/check.h"
#include "shared/solid/mesh_solid.h"

namespace dobra::solid {
namespace {

base::Error missing(const char* what) {
  return {base::ErrorCode::NotInSubdivision, fmt::format("the model has no such {}", what)};
}
base::Error refused(const char* why) { return {base::ErrorCode::InvalidOption, why}; }

}  // namespace

// ---- records -------------------------------------------------------------------------------------------------------

template <class Records, class Id>
Id Model::take(Records& records, std::vector<Id>& spare) {
  if (spare.empty()) {
    records.emplace_back();
    return Id(records.size() - 1);
  }
  const Id id = spare.back();
  spare.pop_back();
  return id;
}

HalfEdgeId Model::take_edge(VertexId from, VertexId to) {
  HalfEdgeId h;
  if (spare_edges_.empty()) {
    h = HalfEdgeId(half_edges_.size());
    half_edges_.resize(half_edges_.size() + 2);
  } else {
    h = spare_edges_.back();
    spare_edges_.pop_back();
  }
  half_edges_[h.index()] = {h, h, from, {}, true};
  half_edges_[twin(h).index()] = {twin(h), twin(h), to, {}, true};
  ++counts_.edges;
  return h;
}

/// The edge comes back with the same half-edge first.
void Model::free_edge(HalfEdgeId h) {
  half_edges_[h.index()] = {};
  half_edges_[twin(h).index()] = {};
  spare_edges_.push_back(h);
  --counts_.edges;
}

LoopId Model::take_loop(FaceId f) {
  const LoopId l = take(loops_, spare_loops_);
  loops_[l.index()] = {{}, {}, f, true};
  faces_[f.index()].loops.push_back(l);
  return l;
}

void Model::free_loop(LoopId l) {
  detach(l);
  loops_[l.index()] = {};
  spare_loops_.push_back(l);
}

void Model::detach(LoopId l) {
  auto& own = faces_[face(l).index()].loops;
  own.erase(std::find(own.begin(), own.end(), l));
}

FaceId Model::take_face(ShellId s) {
  const FaceId f = take(faces_, spare_faces_);
  faces_[f.index()] = {{}, s, true};
  ++counts_.faces;
  return f;
}

void Model::free_face(FaceId f) {
  faces_[f.index()] = {};
  spare_faces_.push_back(f);
  --counts_.faces;
}

void Model::link(HalfEdgeId a, HalfEdgeId b) {
  half_edges_[a.index()].next = b;
  half_edges_[b.index()].previous = a;
}

/// The cycle of `from` is the loop.
void Model::settle(LoopId l, HalfEdgeId from) {
  loops_[l.index()].first = from;
  loops_[l.index()].lone = {};
  HalfEdgeId h = from;
  do {
    half_edges_[h.index()].loop = l;
    h = next(h);
  } while (h != from);
}

void Model::settle(LoopId l, VertexId lone) {
  loops_[l.index()].first = {};
  loops_[l.index()].lone = lone;
  vertices_[lone.index()].lone = l;
}

/// Links a new edge into both corners.
HalfEdgeId Model::join(Corner from, Corner to) {
  const HalfEdgeId h = take_edge(from.vertex, to.vertex);
  const HalfEdgeId back = twin(h);
  const HalfEdgeId p = from.before.valid() ? previous(from.before) : HalfEdgeId();
  const HalfEdgeId q = to.before.valid() ? previous(to.before) : HalfEdgeId();
  if (from == to) {  // an edge from a corner to itself
    if (p.valid()) {
      link(p, h);
      link(h, from.before);
    }
    vertices_[from.vertex.index()].lone = {};
    return h;
  }
  link(h, to.before.valid() ? to.before : back);
  link(back, from.before.valid() ? from.before : h);
  if (p.valid()) link(p, h);
  if (q.valid()) link(q, back);
  vertices_[from.vertex.index()].lone = {};
  vertices_[to.vertex.index()].lone = {};
  return h;
}

bool Model::has(const Corner& c) const {
  if (c.before.valid()) return has(c.before) && origin(c.before) == c.vertex;
  return c.vertex.index() < vertices_.size() && vertices_[c.vertex.index()].live &&
         vertices_[c.vertex.index()].lone.valid();
}

LoopId Model::loop(const Corner& c) const {
  return c.before.valid() ? loop(c.before) : vertices_[c.vertex.index()].lone;
}

void Model::note(Done done) {
#ifndef NDEBUG
  const Counts& c = counts_;
  DOBRA_CHECK(static_cast<long>(c.vertices + c.faces) - static_cast<long>(c.edges) ==
              2 * (static_cast<long>(c.shells) - c.handles) + static_cast<long>(c.rings));
#endif
  if (!undoing_) log_.push_back(done);
}

// ---- operators -----------------------------------------------------------------------------------------------------

FaceId Model::mvsf(geom::Point3 p) {
  const ShellId s = take(shells_, spare_shells_);
  shells_[s.index()] = 1;
  ++counts_.shells;
  const VertexId v = take(vertices_, spare_vertices_);
  vertices_[v.index()] = {p, {}, true};
  ++counts_.vertices;
  const FaceId f = take_face(s);
  settle(take_loop(f), v);
  note({Kind::Mvsf, f.index(), 0, {}, {}, {}});
  return f;
}

base::Result<void> Model::kvsf(FaceId f) {
  if (!has(f)) return missing("face");
  if (loops(f).size() != 1 || !lone_vertex(loops(f)[0]).valid())
    return refused("the face is more than an isolated vertex");
  const VertexId v = lone_vertex(loops(f)[0]);
  const geom::Point3 p = point(v);
  const ShellId s = shell(f);
  free_loop(loops(f)[0]);
  free_face(f);
  vertices_[v.index()] = {};
  spare_vertices_.push_back(v);
  shells_[s.index()] = 0;
  spare_shells_.push_back(s);
  --counts_.vertices;
  --counts_.shells;
  note({Kind::Kvsf, 0, 0, {}, {}, p});
  return {};
}

base::Result<HalfEdgeId> Model::mev(Corner from, geom::Point3 p) {
  if (!has(from)) return missing("corner");
  const LoopId l = loop(from);
  const VertexId v = take(vertices_, spare_vertices_);
  vertices_[v.index()] = {p, {}, true};
  ++counts_.vertices;
  const HalfEdgeId h = join(from, {v, {}});
  settle(l, h);
  note({Kind::Mev, h.index(), 0, {}, {}, {}});
  return h;
}

base::Result<void> Model::kev(HalfEdgeId h) {
  if (!has(h)) return missing("half-edge");
  if (next(h) != twin(h)) return refused("the end of the edge has other edges");
  const VertexId v = target(h);
  const VertexId from = origin(h);
  const LoopId l = loop(h);
  const geom::Point3 p = point(v);
  const HalfEdgeId after = next(twin(h));
  if (after == h) {
    settle(l, from);
  } else {
    link(previous(h), after);
    settle(l, after);
  }
  free_edge(h);
  vertices_[v.index()] = {};
  spare_vertices_.push_back(v);
  --counts_.vertices;
  note({Kind::Kev, 0, 0, {from, after == h ? HalfEdgeId() : after}, {}, p});
  return {};
}

base::Result<HalfEdgeId> Model::mef(Corner from, Corner to) {
  if (!has(from) || !has(to)) return missing("corner");
  if (loop(from) != loop(to)) return refused("the corners are not of one loop");
  const LoopId l = loop(from);
  const HalfEdgeId h = join(from, to);
  settle(l, h);
  settle(take_loop(take_face(shell(face(l)))), twin(h));
  note({Kind::Mef, h.index(), 0, {}, {}, {}});
  return h;
}

base::Result<void> Model::kef(HalfEdgeId h) {
  if (!has(h)) return missing("half-edge");
  const HalfEdgeId back = twin(h);
  const FaceId gone = face(back);
  if (gone == face(h)) return refused("both sides of the edge are one face");
  if (loops(gone).size() != 1) return refused("the face beyond the edge has rings");
  const LoopId l = loop(h);
  const LoopId beyond = loop(back);
  const HalfEdgeId to_before = next(h) == h ? HalfEdgeId() : next(h);
  const HalfEdgeId from_before = next(back) == back ? to_before : next(back);
  const Corner from{origin(h), from_before};
  const Corner to{target(h), to_before};
  const HalfEdgeId p = previous(h);
  const HalfEdgeId q = previous(back);
  const bool h_alone = p == h;
  const bool back_alone = q == back;
  if (h_alone && !back_alone) return refused("the edge is all of its loop: take it out from its other side");
  if (h_alone && back_alone) {
    settle(l, from.vertex);
  } else if (back_alone) {
    link(p, next(h));
    settle(l, next(h));
  } else {
    link(p, next(back));
    link(q, next(h));
    settle(l, next(h));
  }
  free_edge(h);
  free_loop(beyond);
  free_face(gone);
  note({Kind::Kef, 0, 0, from, to, {}});
  return {};
}

base::Result<LoopId> Model::kemr(HalfEdgeId h) {
  if (!has(h)) return missing("half-edge");
  const HalfEdgeId back = twin(h);
  if (loop(back) != loop(h)) return refused("the sides of the edge are of two loops");
  const LoopId l = loop(h);
  const VertexId v = origin(h);
  const VertexId w = target(h);
  const HalfEdgeId at_v = next(back) == h ? HalfEdgeId() : next(back);
  const HalfEdgeId at_w = next(h) == back ? HalfEdgeId() : next(h);
  const HalfEdgeId p = previous(h);
  const HalfEdgeId q = previous(back);
  const LoopId ring = take_loop(face(l));
  ++counts_.rings;
  free_edge(h);
  if (at_v.valid()) {
    link(p, at_v);
    settle(l, at_v);
  } else {
    settle(l, v);
  }
  if (at_w.valid()) {
    link(q, at_w);
    settle(ring, at_w);
  } else {
    settle(ring, w);
  }
  note({Kind::Kemr, 0, 0, {v, at_v}, {w, at_w}, {}});
  return ring;
}

base::Result<HalfEdgeId> Model::mekr(Corner from, Corner to_ring) {
  if (!has(from) || !has(to_ring)) return missing("corner");
  const LoopId l = loop(from);
  const LoopId ring = loop(to_ring);
  if (l == ring || face(l) != face(ring)) return refused("the corners are not of two loops of one face");
  if (!is_ring(ring)) return refused("the second corner is on the loop that bounds the face");
  const HalfEdgeId h = join(from, to_ring);
  free_loop(ring);
  --counts_.rings;
  settle(l, h);
  note({Kind::Mekr, h.index(), 0, {}, {}, {}});
  return h;
}

/// The loop of `killed` becomes a ring of `into`.
LoopId Model::move_loop(FaceId into, FaceId killed) {
  const LoopId l = loops(killed)[0];
  faces_[killed.index()].loops.clear();
  free_face(killed);
  loops_[l.index()].face = into;
  faces_[into.index()].loops.push_back(l);
  ++counts_.rings;
  return l;
}

base::Result<LoopId> Model::kfmrh(FaceId into, FaceId killed) {
  if (!has(into) || !has(killed)) return missing("face");
  if (into == killed || shell(into) != shell(killed)) return refused("the faces are not two of one shell");
  if (loops(killed).size() != 1) return refused("the face that is to go has rings");
  const LoopId l = move_loop(into, killed);
  ++counts_.handles;
  note({Kind::Kfmrh, l.index(), 0, {}, {}, {}});
  return l;
}

base::Result<LoopId> Model::ksfmr(FaceId into, FaceId killed) {
  if (!has(into) || !has(killed)) return missing("face");
  const ShellId stays = shell(into);
  const ShellId goes = shell(killed);
  if (stays == goes) return refused("the faces are of one shell");
  if (loops(killed).size() != 1) return refused("the face that is to go has rings");
  const LoopId l = move_loop(into, killed);
  for (Face& f : faces_) {
    if (f.live && f.shell == goes) f.shell = stays;
  }
  shells_[goes.index()] = 0;
  spare_shells_.push_back(goes);
  --counts_.shells;
  note({Kind::Ksfmr, l.index(), 0, {}, {}, {}});
  return l;
}

/// The faces that hang on a ring when it is no part of its face, and whether that face is one of them.
std::vector<FaceId> Model::reached(LoopId ring, bool& comes_back) const {
  std::vector<char> seen(faces_.size(), 0);
  std::vector<FaceId> found;
  std::vector<LoopId> queue{ring};
  comes_back = false;
  while (!queue.empty() && !comes_back) {
    const LoopId l = queue.back();
    queue.pop_back();
    for (const HalfEdgeId h : half_edges(l)) {
      const LoopId beyond = loop(twin(h));
      const FaceId f = face(beyond);
      if (beyond == ring || seen[f.index()] != 0) continue;
      if (f == face(ring)) comes_back = true;
      seen[f.index()] = 1;
      found.push_back(f);
      queue.insert(queue.end(), loops(f).begin(), loops(f).end());
    }
  }
  return found;
}

base::Result<FaceId> Model::mfkrh(LoopId ring) {
  if (!has(ring)) return missing("loop");
  if (!is_ring(ring)) return refused("the loop bounds its face");
  bool comes_back = false;
  static_cast<void>(reached(ring, comes_back));
  if (!comes_back) return refused("the shell would fall into two: msfkr does that");
  const FaceId old = face(ring);
  detach(ring);
  const FaceId f = take_face(shell(old));
  faces_[f.index()].loops.push_back(ring);
  loops_[ring.index()].face = f;
  --counts_.rings;
  --counts_.handles;
  note({Kind::Mfkrh, f.index(), old.index(), {}, {}, {}});
  return f;
}

base::Result<FaceId> Model::msfkr(LoopId ring) {
  if (!has(ring)) return missing("loop");
  if (!is_ring(ring)) return refused("the loop bounds its face");
  bool comes_back = false;
  const std::vector<FaceId> parts = reached(ring, comes_back);
  if (comes_back) return refused("the shell would stay one: mfkrh does that");
  const FaceId old = face(ring);
  detach(ring);
  const ShellId s = take(shells_, spare_shells_);
  shells_[s.index()] = 1;
  ++counts_.shells;
  const FaceId f = take_face(s);
  faces_[f.index()].loops.push_back(ring);
  loops_[ring.index()].face = f;
  for (const FaceId part : parts) faces_[part.index()].shell = s;
  --counts_.rings;
  note({Kind::Msfkr, f.index(), old.index(), {}, {}, {}});
  return f;
}

void Model::undo() {
  DOBRA_CHECK(!log_.empty());
  const Done done = log_.back();
  log_.pop_back();
  undoing_ = true;
  const auto sure = [](auto&& result) { DOBRA_CHECK(result.ok()); };
  switch (done.kind) {
    case Kind::Mvsf:
      sure(kvsf(FaceId(done.id)));
      break;
    case Kind::Kvsf:
      mvsf(done.point);
      break;
    case Kind::Mev:
      sure(kev(HalfEdgeId(done.id)));
      break;
    case Kind::Kev:
      sure(mev(done.from, done.point));
      break;
    case Kind::Mef:
      sure(kef(HalfEdgeId(done.id)));
      break;
    case Kind::Kef:
      sure(mef(done.from, done.to));
      break;
    case Kind::Kemr:
      sure(mekr(done.from, done.to));
      break;
    case Kind::Mekr:
      sure(kemr(HalfEdgeId(done.id)));
      break;
    case Kind::Kfmrh:
      sure(mfkrh(LoopId(done.id)));
      break;
    case Kind::Mfkrh:
      sure(kfmrh(FaceId(done.other), FaceId(done.id)));
      break;
    case Kind::Ksfmr:
      sure(msfkr(LoopId(done.id)));
      break;
    case Kind::Msfkr:
      sure(ksfmr(FaceId(done.other), FaceId(done.id)));
      break;
  }
  undoing_ = false;
}

// ---- reading -------------------------------------------------------------------------------------------------------

std::vector<HalfEdgeId> Model::half_edges(LoopId l) const {
  std::vector<HalfEdgeId> found;
  const HalfEdgeId start = first(l);
  if (!start.valid()) return found;
  HalfEdgeId h = start;
  do {
    found.push_back(h);
    h = next(h);
  } while (h != start);
  return found;
}

std::vector<FaceId> Model::faces() const {
  std::vector<FaceId> found;
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    if (faces_[f].live) found.emplace_back(f);
  }
  return found;
}

std::vector<HalfEdgeId> Model::edges() const {
  std::vector<HalfEdgeId> found;
  for (std::size_t h = 0; h < half_edges_.size(); h += 2) {
    if (half_edges_[h].live) found.emplace_back(h);
  }
  return found;
}

std::string Model::dump() const {
  std::string text;
  const auto id = [](auto value) { return value.valid() ? std::to_string(value.index()) : std::string("-"); };
  for (std::size_t v = 0; v < vertices_.size(); ++v) {
    if (!vertices_[v].live) continue;
    const geom::Point3 p = vertices_[v].point;
    text += fmt::format("v{} {} {} {} lone {}\n", v, p.x, p.y, p.z, id(vertices_[v].lone));
  }
  for (std::size_t h = 0; h < half_edges_.size(); ++h) {
    if (!half_edges_[h].live) continue;
    const HalfEdge& e = half_edges_[h];
    text += fmt::format("h{} from {} next {} previous {} loop {}\n", h, id(e.origin), id(e.next), id(e.previous),
                        id(e.loop));
  }
  for (const FaceId f : faces()) {
    std::vector<LoopId> sorted = loops(f);
    std::sort(sorted.begin() + 1, sorted.end());
    text += fmt::format("f{} shell {} loops", f.index(), id(shell(f)));
    for (const LoopId l : sorted) text += fmt::format(" {} (lone {})", id(l), id(lone_vertex(l)));
    text += '\n';
  }
  return text;
}

base::Result<Solid> to_solid(const Model& model) {
  FaceLoops out;
  std::vector<std::uint32_t> numbers;
  const auto number = [&](VertexId v) {
    if (numbers.size() <= v.index()) numbers.resize(v.index() + 1, none);
    if (numbers[v.index()] == none) {
      numbers[v.index()] = static_cast<std::uint32_t>(out.points.size());
      out.points.push_back(model.point(v));
    }
    return numbers[v.index()];
  };
  for (const FaceId f : model.faces()) {
    auto& face = out.faces.emplace_back();
    for (const LoopId l : model.loops(f)) {
      auto& loop = face.emplace_back();
      for (const HalfEdgeId h : model.half_edges(l)) loop.push_back(number(model.origin(h)));
      if (loop.size() < 3) {
        return base::Error{base::ErrorCode::NotClosed,
                           fmt::format("a loop of face {} has less than three corners: it bounds nothing", f.index())};
      }
    }
  }
  return from_loops(out);
}

}  // namespace dobra::solid
