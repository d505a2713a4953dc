#pragma once
// A planar subdivision as half-edges: subdivision -> face -> loop -> half-edge -> edge -> vertex. Every edge is a straight
// segment between two vertices and no two edges meet except at common vertices. Dangling edges, isolated vertices and
// faces with several loops are allowed; exactly one face is unbounded. Changed only by Euler operators, each with
// its inverse, so that V - E + F = 1 + C always holds. To add curves use topo/insert.h, which finds the crossings.
// Source: [mantyla1988solid], [cavalcante1991hed].
//
// A face lies to the left of its half-edges: outer loops run anticlockwise, loops round holes clockwise; an isolated
// vertex is a loop without half-edges.
// Attributes. Split: both parts carry a copy. Merge: the survivor keeps its own.

#include <any>
#include <optional>
#include <unordered_map>
#include <vector>

#include "shared/geom/point.h"
#include "shared/geom/segment.h"
#include "shared/topo/ids.h"
#include "shared/topo/item_tree.h"

namespace dobra::topo {

/// A place between two edges at a vertex: just before half-edge `before` in its loop, in the face to its left.
/// `before` is none at an isolated vertex.
struct Corner {
  VertexId vertex;
  HalfEdgeId before;
  friend bool operator==(const Corner&, const Corner&) = default;
};

class Subdivision {
 public:
  Subdivision();

  // ---- what there is -------------------------------------------------------------------------------------------
  [[nodiscard]] std::size_t vertex_count() const { return point_.size() - free_vertices_.size(); }
  [[nodiscard]] std::size_t edge_count() const { return edge_live_.size() - free_edges_.size(); }
  [[nodiscard]] std::size_t loop_count() const { return loop_face_.size() - free_loops_.size(); }
  /// The unbounded face counts.
  [[nodiscard]] std::size_t face_count() const { return first_loop_.size() - free_faces_.size(); }
  /// Connected components of the vertices and edges.
  [[nodiscard]] std::size_t component_count() const { return components_; }
  /// All of one kind, in ascending order.
  [[nodiscard]] std::vector<VertexId> vertices() const;
  [[nodiscard]] std::vector<EdgeId> edges() const;
  [[nodiscard]] std::vector<LoopId> loops() const;
  [[nodiscard]] std::vector<FaceId> faces() const;
  [[nodiscard]] bool contains(EdgeId e) const { return e.index() < edge_live_.size() && edge_live_[e.index()]; }
  [[nodiscard]] bool contains(VertexId v) const { return v.index() < point_.size() && vertex_live_[v.index()]; }
  [[nodiscard]] bool contains(FaceId f) const { return f.index() < first_loop_.size() && face_live_[f.index()]; }

  // ---- traversal, O(1) unless it returns a vector --------------------------------------------------------------
  static HalfEdgeId twin(HalfEdgeId h) { return HalfEdgeId(h.index() ^ 1U); }
  static EdgeId edge(HalfEdgeId h) { return EdgeId(h.index() / 2); }
  /// The half-edge in which the edge was made; its twin is the other one.
  static HalfEdgeId half_edge(EdgeId e) { return HalfEdgeId(2 * e.index()); }
  static FaceId unbounded() { return FaceId(0); }
  [[nodiscard]] HalfEdgeId next(HalfEdgeId h) const { return next_[h.index()]; }
  [[nodiscard]] HalfEdgeId previous(HalfEdgeId h) const { return previous_[h.index()]; }
  [[nodiscard]] VertexId origin(HalfEdgeId h) const { return origin_[h.index()]; }
  [[nodiscard]] VertexId target(HalfEdgeId h) const { return origin(twin(h)); }
  [[nodiscard]] LoopId loop(HalfEdgeId h) const { return loop_[h.index()]; }
  [[nodiscard]] FaceId face(LoopId l) const { return loop_face_[l.index()]; }
  [[nodiscard]] FaceId face(HalfEdgeId h) const { return face(loop(h)); }
  [[nodiscard]] geom::Point point(VertexId v) const { return point_[v.index()]; }
  [[nodiscard]] geom::Segment segment(HalfEdgeId h) const { return {point(origin(h)), point(target(h))}; }
  [[nodiscard]] geom::Segment segment(EdgeId e) const { return segment(half_edge(e)); }
  /// A half-edge that starts at v; none if v is isolated.
  [[nodiscard]] HalfEdgeId leaving(VertexId v) const { return leaving_[v.index()]; }
  /// The loop that an isolated vertex is; none for any other vertex.
  [[nodiscard]] LoopId lone_loop(VertexId v) const { return lone_loop_[v.index()]; }
  /// The next half-edge leaving the same vertex, anticlockwise.
  [[nodiscard]] HalfEdgeId turned(HalfEdgeId h) const { return twin(previous(h)); }
  /// The half-edges that leave v, anticlockwise from leaving(v).
  [[nodiscard]] std::vector<HalfEdgeId> round(VertexId v) const;
  /// A half-edge of the loop; none if the loop is an isolated vertex.
  [[nodiscard]] HalfEdgeId first(LoopId l) const { return first_[l.index()]; }
  [[nodiscard]] VertexId lone_vertex(LoopId l) const { return lone_vertex_[l.index()]; }
  [[nodiscard]] std::vector<HalfEdgeId> half_edges(LoopId l) const;
  /// The loop that bounds f from outside; none for the unbounded face.
  [[nodiscard]] LoopId outer_loop(FaceId f) const { return outer_[f.index()]; }
  [[nodiscard]] std::vector<LoopId> loops(FaceId f) const;
  [[nodiscard]] std::size_t degree(VertexId v) const { return round(v).size(); }
  /// The vertex exactly at p, if any. O(1).
  [[nodiscard]] std::optional<VertexId> vertex_at(geom::Point p) const;
  /// The half-edge from a to b, if they are joined. O(degree of a).
  [[nodiscard]] HalfEdgeId between(VertexId a, VertexId b) const;
  /// The corner of v that looks towards p. @pre no edge at v runs exactly that way. Exact. O(degree).
  [[nodiscard]] Corner corner(VertexId v, geom::Point p) const;
  [[nodiscard]] FaceId face(const Corner& c) const;

  // ---- Euler operators (m make, k kill, v vertex, e edge, f face, r ring = a further loop of a face) -----------
  // All of them trust the caller that the segment crosses nothing.
  /// The first is the operator mvsf of the literature; further ones put an isolated vertex into `face`. V+1 C+1.
  VertexId mvsf(FaceId face, geom::Point p);
  void kvsf(VertexId isolated);
  /// An edge from the corner to a new vertex. V+1 E+1. Returns the half-edge that leaves the corner.
  HalfEdgeId mev(const Corner& from, geom::Point p);
  /// Removes the edge of h with target(h), which has no other edge.
  void kev(HalfEdgeId h);
  /// An edge between two corners of one loop. E+1 F+1. The new face is bounded; loops that lie in it move to it.
  HalfEdgeId mef(const Corner& from, const Corner& to);
  /// Removes the edge of h; face(twin(h)) is merged into face(h) (the unbounded face survives whichever side it is).
  FaceId kef(HalfEdgeId h);
  /// An edge between corners in two loops of one face, which become one. E+1 C-1.
  HalfEdgeId mekr(const Corner& from, const Corner& to);
  /// Removes an edge with the same loop on both sides, which falls into two.
  void kemr(HalfEdgeId h);
  /// A vertex p on edge e. V+1 E+1. The half-edge 2e keeps its origin; returns the vertex. Inverse: join.
  VertexId split(EdgeId e, geom::Point p);
  /// Removes a vertex of degree two; the later edge is merged into the earlier. Returns the edge that stays.
  EdgeId join(VertexId v);
  /// mef or mekr, whichever applies, between the corners of a and b that look at each other.
  HalfEdgeId connect(VertexId a, VertexId b);

  // ---- attributes ----------------------------------------------------------------------------------------------
  std::any& attribute() { return attribute_; }
  std::any& attribute(VertexId v) { return vertex_attribute_[v.index()]; }
  std::any& attribute(EdgeId e) { return edge_attribute_[e.index()]; }
  std::any& attribute(FaceId f) { return face_attribute_[f.index()]; }
  [[nodiscard]] const std::any& attribute() const { return attribute_; }
  [[nodiscard]] const std::any& attribute(VertexId v) const { return vertex_attribute_[v.index()]; }
  [[nodiscard]] const std::any& attribute(EdgeId e) const { return edge_attribute_[e.index()]; }
  [[nodiscard]] const std::any& attribute(FaceId f) const { return face_attribute_[f.index()]; }

  /// Where edges (item 2e) and isolated vertices (item 2v + 1) are.
  [[nodiscard]] const ItemTree& tree() const { return tree_; }

 private:
  struct PointHash { std::size_t operator()(const geom::Point& p) const noexcept; };

  VertexId new_vertex(geom::Point p);
  EdgeId new_edge(VertexId from, VertexId to);
  LoopId new_loop(FaceId f);
  FaceId new_face();
  void free_vertex(VertexId v);
  void free_edge(EdgeId e);
  void free_loop(LoopId l);
  void free_face(FaceId f);
  void attach(LoopId l, FaceId f);
  void detach(LoopId l);
  void link(HalfEdgeId a, HalfEdgeId b) { next_[a.index()] = b; previous_[b.index()] = a; }
  HalfEdgeId link_edge(const Corner& from, const Corner& to);
  void unlink_edge(HalfEdgeId h);
  void set_lone(VertexId v, LoopId l);
  void label(HalfEdgeId start, LoopId l);
  [[nodiscard]] HalfEdgeId shorter(HalfEdgeId a, HalfEdgeId b) const;
  [[nodiscard]] bool runs_round_hole(LoopId l) const;
  [[nodiscard]] bool encloses(LoopId l, geom::Point p) const;
  [[nodiscard]] LoopId loop_of(const Corner& c) const;
  void move_enclosed_loops(FaceId from, FaceId to, LoopId by, LoopId rest);

  // One slot an entity; freed slots are kept in lists and used again, the last freed first.
  std::vector<geom::Point> point_;
  std::vector<HalfEdgeId> leaving_;
  std::vector<LoopId> lone_loop_;
  std::vector<std::any> vertex_attribute_;
  std::vector<char> vertex_live_;
  std::vector<HalfEdgeId> next_, previous_;
  std::vector<VertexId> origin_;
  std::vector<LoopId> loop_;
  std::vector<std::any> edge_attribute_;
  std::vector<char> edge_live_;
  std::vector<HalfEdgeId> first_;
  std::vector<VertexId> lone_vertex_;
  std::vector<FaceId> loop_face_;
  std::vector<LoopId> loop_next_, loop_previous_;  // circular list of the loops of a face
  std::vector<char> loop_live_;
  std::vector<LoopId> outer_, first_loop_;
  std::vector<std::any> face_attribute_;
  std::vector<char> face_live_;
  std::vector<VertexId> free_vertices_;
  std::vector<EdgeId> free_edges_;
  std::vector<LoopId> free_loops_;
  std::vector<FaceId> free_faces_;
  std::any attribute_;
  std::size_t components_ = 0;
  std::unordered_map<geom::Point, VertexId, PointHash> at_;
  ItemTree tree_;
};

}  // namespace dobra::topo
