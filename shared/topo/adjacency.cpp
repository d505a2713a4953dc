#include "shared/topo/adjacency.h"

#include <unordered_set>

namespace dobra::topo {

namespace {

/// Appends what is not there yet.
template <class Id>
class Once {
 public:
  void add(Id id) {
    if (seen_.insert(id).second) all_.push_back(id);
  }
  [[nodiscard]] std::vector<Id> take() { return std::move(all_); }

 private:
  std::vector<Id> all_;
  std::unordered_set<Id> seen_;
};

}  // namespace

std::vector<VertexId> vertices_of_vertex(const Subdivision& s, VertexId v) {
  std::vector<VertexId> all;
  for (const HalfEdgeId h : s.round(v)) all.push_back(s.target(h));
  return all;
}

std::vector<EdgeId> edges_of_vertex(const Subdivision& s, VertexId v) {
  std::vector<EdgeId> all;
  for (const HalfEdgeId h : s.round(v)) all.push_back(Subdivision::edge(h));
  return all;
}

std::vector<FaceId> faces_of_vertex(const Subdivision& s, VertexId v) {
  if (s.lone_loop(v).valid()) return {s.face(s.lone_loop(v))};
  Once<FaceId> all;
  for (const HalfEdgeId h : s.round(v)) all.add(s.face(h));
  return all.take();
}

std::vector<VertexId> vertices_of_edge(const Subdivision& s, EdgeId e) {
  const HalfEdgeId h = Subdivision::half_edge(e);
  return {s.origin(h), s.target(h)};
}

std::vector<EdgeId> edges_of_edge(const Subdivision& s, EdgeId e) {
  std::vector<EdgeId> all;
  for (const VertexId v : vertices_of_edge(s, e)) {
    for (const HalfEdgeId h : s.round(v)) {
      if (Subdivision::edge(h) != e) all.push_back(Subdivision::edge(h));
    }
  }
  return all;
}

std::vector<FaceId> faces_of_edge(const Subdivision& s, EdgeId e) {
  Once<FaceId> all;
  all.add(s.face(Subdivision::half_edge(e)));
  all.add(s.face(Subdivision::twin(Subdivision::half_edge(e))));
  return all.take();
}

std::vector<VertexId> vertices_of_face(const Subdivision& s, FaceId f) {
  Once<VertexId> all;
  for (const LoopId l : s.loops(f)) {
    if (s.lone_vertex(l).valid()) all.add(s.lone_vertex(l));
    for (const HalfEdgeId h : s.half_edges(l)) all.add(s.origin(h));
  }
  return all.take();
}

std::vector<EdgeId> edges_of_face(const Subdivision& s, FaceId f) {
  Once<EdgeId> all;
  for (const LoopId l : s.loops(f)) {
    for (const HalfEdgeId h : s.half_edges(l)) all.add(Subdivision::edge(h));
  }
  return all.take();
}

std::vector<FaceId> faces_of_face(const Subdivision& s, FaceId f) {
  Once<FaceId> all;
  for (const LoopId l : s.loops(f)) {
    for (const HalfEdgeId h : s.half_edges(l)) {
      const FaceId other = s.face(Subdivision::twin(h));
      if (other != f) all.add(other);
    }
  }
  return all.take();
}

double signed_area(const Subdivision& s, LoopId l) {
  geom::Polyline contour{{}, true};
  for (const HalfEdgeId h : s.half_edges(l)) contour.points.push_back(s.point(s.origin(h)));
  return geom::signed_area(contour);
}

double area(const Subdivision& s, FaceId f) {
  double sum = 0.0;
  for (const LoopId l : s.loops(f)) sum += signed_area(s, l);
  return sum;
}

}  // namespace dobra::topo
