#pragma once
// What a planar subdivision consists of and how it hangs together, for reading: subdivision -> face -> loop ->
// half-edge -> edge -> vertex. subdivision.h changes it.
//
// A face lies to the left of its half-edges: outer loops run anticlockwise, loops round holes clockwise; an isolated
// vertex is a loop without half-edges. Records lie in arrays; freed slots are kept in lists and used again, the last
// freed first. Source: [mantyla1988solid], [cavalcante1991hed].

#include <optional>
#include <vector>

#include "shared/geom/segment.h"
#include "shared/topo/ids.h"
#include "shared/topo/point_table.h"

namespace dobra::topo {

/// A place between two edges at a vertex: just before half-edge `before` in its loop, in the face to its left.
/// `before` is none at an isolated vertex.
struct Corner {
  VertexId vertex;
  HalfEdgeId before;
  friend bool operator==(const Corner&, const Corner&) = default;
};

class Structure {
 public:
  // ---- what there is -------------------------------------------------------------------------------------------
  [[nodiscard]] std::size_t vertex_count() const { return vertices_.size() - free_vertices_.size(); }
  [[nodiscard]] std::size_t edge_count() const { return edge_live_.size() - free_edges_.size(); }
  [[nodiscard]] std::size_t loop_count() const { return loops_.size() - free_loops_.size(); }
  /// The unbounded face counts.
  [[nodiscard]] std::size_t face_count() const { return faces_.size() - free_faces_.size(); }
  /// Connected components of the vertices and edges.
  [[nodiscard]] std::size_t component_count() const { return components_; }
  /// All of one kind, in ascending order.
  [[nodiscard]] std::vector<VertexId> vertices() const;
  [[nodiscard]] std::vector<EdgeId> edges() const;
  [[nodiscard]] std::vector<LoopId> loops() const;
  [[nodiscard]] std::vector<FaceId> faces() const;
  [[nodiscard]] bool contains(EdgeId e) const { return e.index() < edge_live_.size() && edge_live_[e.index()]; }
  [[nodiscard]] bool contains(VertexId v) const { return v.index() < vertices_.size() && vertices_[v.index()].live; }
  [[nodiscard]] bool contains(FaceId f) const { return f.index() < faces_.size() && faces_[f.index()].live; }

  // ---- traversal, O(1) unless it returns a vector --------------------------------------------------------------
  static HalfEdgeId twin(HalfEdgeId h) { return HalfEdgeId(h.index() ^ 1U); }
  static EdgeId edge(HalfEdgeId h) { return EdgeId(h.index() / 2); }
  /// The half-edge in which the edge was made; its twin is the other one.
  static HalfEdgeId half_edge(EdgeId e) { return HalfEdgeId(2 * e.index()); }
  static FaceId unbounded() { return FaceId(0); }
  [[nodiscard]] HalfEdgeId next(HalfEdgeId h) const { return half_edges_[h.index()].next; }
  [[nodiscard]] HalfEdgeId previous(HalfEdgeId h) const { return half_edges_[h.index()].previous; }
  [[nodiscard]] VertexId origin(HalfEdgeId h) const { return half_edges_[h.index()].origin; }
  [[nodiscard]] VertexId target(HalfEdgeId h) const { return origin(twin(h)); }
  [[nodiscard]] LoopId loop(HalfEdgeId h) const { return half_edges_[h.index()].loop; }
  [[nodiscard]] FaceId face(LoopId l) const { return loops_[l.index()].face; }
  [[nodiscard]] FaceId face(HalfEdgeId h) const { return face(loop(h)); }
  [[nodiscard]] FaceId face(const Corner& c) const { return face(loop(c)); }
  [[nodiscard]] LoopId loop(const Corner& c) const { return c.before.valid() ? loop(c.before) : lone_loop(c.vertex); }
  [[nodiscard]] geom::Point point(VertexId v) const { return vertices_[v.index()].point; }
  [[nodiscard]] geom::Segment segment(HalfEdgeId h) const { return {point(origin(h)), point(target(h))}; }
  [[nodiscard]] geom::Segment segment(EdgeId e) const { return segment(half_edge(e)); }
  /// A half-edge that starts at v; none if v is isolated.
  [[nodiscard]] HalfEdgeId leaving(VertexId v) const { return vertices_[v.index()].leaving; }
  /// The loop that an isolated vertex is; none for any other vertex.
  [[nodiscard]] LoopId lone_loop(VertexId v) const { return vertices_[v.index()].lone_loop; }
  /// The next half-edge leaving the same vertex, anticlockwise.
  [[nodiscard]] HalfEdgeId turned(HalfEdgeId h) const { return twin(previous(h)); }
  /// The half-edges that leave v, anticlockwise from leaving(v).
  [[nodiscard]] std::vector<HalfEdgeId> round(VertexId v) const;
  /// A half-edge of the loop; none if the loop is an isolated vertex.
  [[nodiscard]] HalfEdgeId first(LoopId l) const { return loops_[l.index()].first; }
  [[nodiscard]] VertexId lone_vertex(LoopId l) const { return loops_[l.index()].lone_vertex; }
  [[nodiscard]] std::vector<HalfEdgeId> half_edges(LoopId l) const;
  /// The loop that bounds f from outside; none for the unbounded face.
  [[nodiscard]] LoopId outer_loop(FaceId f) const { return faces_[f.index()].outer; }
  [[nodiscard]] std::vector<LoopId> loops(FaceId f) const;
  [[nodiscard]] std::size_t degree(VertexId v) const { return round(v).size(); }
  /// The vertex exactly at p, if any. O(1).
  [[nodiscard]] std::optional<VertexId> vertex_at(geom::Point p) const;
  /// The half-edge from a to b, if they are joined. O(degree of a).
  [[nodiscard]] HalfEdgeId between(VertexId a, VertexId b) const;
  /// The corner of v that looks towards p. @pre no edge at v runs exactly that way. Exact. O(degree).
  [[nodiscard]] Corner corner(VertexId v, geom::Point p) const;

 protected:
  struct Vertex {
    geom::Point point;
    HalfEdgeId leaving;
    LoopId lone_loop;
    bool live = false;
  };
  struct HalfEdge {
    HalfEdgeId next, previous;
    VertexId origin;
    LoopId loop;
  };
  struct Loop {
    HalfEdgeId first;
    VertexId lone_vertex;
    FaceId face;
    LoopId next, previous;  ///< Circular list of the loops of a face.
    bool live = false;
  };
  struct Face {
    LoopId outer, first;
    bool live = false;
  };

  [[nodiscard]] auto place_of() const {
    return [this](std::uint32_t i) { return vertices_[i].point; };
  }

  std::vector<Vertex> vertices_;
  std::vector<HalfEdge> half_edges_;
  std::vector<char> edge_live_;
  std::vector<Loop> loops_;
  std::vector<Face> faces_;
  std::vector<VertexId> free_vertices_;
  std::vector<EdgeId> free_edges_;
  std::vector<LoopId> free_loops_;
  std::vector<FaceId> free_faces_;
  std::size_t components_ = 0;
  PointTable at_;
};

/// True if the way from v to r lies strictly between v->p and v->q, anticlockwise from p to q. Exact.
bool within(geom::Point v, geom::Point p, geom::Point q, geom::Point r);

}  // namespace dobra::topo
