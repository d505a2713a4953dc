#include "shared/topo/structure.h"

#include "shared/base/check.h"
#include "shared/geom/predicates.h"

namespace dobra::topo {

using geom::orient2d;
using geom::Point;
using geom::Sign;

namespace {

template <class Id, class IsLive>
std::vector<Id> live(std::size_t count, const IsLive& is_live) {
  std::vector<Id> ids;
  for (std::size_t i = 0; i < count; ++i) {
    if (is_live(i)) ids.push_back(Id(i));
  }
  return ids;
}

}  // namespace

bool within(Point v, Point p, Point q, Point r) {
  const Sign opening = orient2d(v, p, q);
  if (opening == Sign::Positive) return orient2d(v, p, r) == Sign::Positive && orient2d(v, r, q) == Sign::Positive;
  if (opening == Sign::Negative) return orient2d(v, p, r) == Sign::Positive || orient2d(v, r, q) == Sign::Positive;
  return orient2d(v, p, r) == Sign::Positive;  // p and q are opposite
}

std::vector<VertexId> Structure::vertices() const {
  return live<VertexId>(vertices_.size(), [&](std::size_t i) { return vertices_[i].live; });
}
std::vector<EdgeId> Structure::edges() const {
  return live<EdgeId>(edge_live_.size(), [&](std::size_t i) { return edge_live_[i] != 0; });
}
std::vector<LoopId> Structure::loops() const {
  return live<LoopId>(loops_.size(), [&](std::size_t i) { return loops_[i].live; });
}
std::vector<FaceId> Structure::faces() const {
  return live<FaceId>(faces_.size(), [&](std::size_t i) { return faces_[i].live; });
}

std::vector<HalfEdgeId> Structure::round(VertexId v) const {
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

std::vector<HalfEdgeId> Structure::half_edges(LoopId l) const {
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

std::vector<LoopId> Structure::loops(FaceId f) const {
  std::vector<LoopId> all;
  const LoopId start = faces_[f.index()].first;
  if (!start.valid()) return all;
  LoopId l = start;
  do {
    all.push_back(l);
    l = loops_[l.index()].next;
  } while (l != start);
  return all;
}

std::optional<VertexId> Structure::vertex_at(Point p) const {
  const std::uint32_t found = at_.find({p.x + 0.0, p.y + 0.0}, place_of());  // -0.0 and 0.0 are the same place
  if (found == PointTable::none) return std::nullopt;
  return VertexId(found);
}

HalfEdgeId Structure::between(VertexId a, VertexId b) const {
  const HalfEdgeId start = leaving(a);
  if (!start.valid()) return {};
  HalfEdgeId h = start;
  do {
    if (target(h) == b) return h;
    h = turned(h);
  } while (h != start);
  return {};
}

Corner Structure::corner(VertexId v, Point p) const {
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

}  // namespace dobra::topo
