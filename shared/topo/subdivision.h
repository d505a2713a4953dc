#pragma once
// A planar subdivision as half-edges (structure.h says of what it consists). Every edge is a straight segment between
// two vertices and no two edges meet except at common vertices. Dangling edges, isolated vertices and faces with
// several loops are allowed; exactly one face is unbounded. Changed only by Euler operators, each with its inverse, so
// that V - E + F = 1 + C always holds. To add curves use topo/insert.h, which finds the crossings. Source:
// [mantyla1988solid], [cavalcante1991hed]. Page: docs/algorithms/subdivision.md.
//
// Attributes. Split: both parts carry a copy. Merge: the survivor keeps its own.

#include <any>

#include "shared/topo/attributes.h"
#include "shared/topo/item_tree.h"
#include "shared/topo/structure.h"

namespace dobra::topo {

/// What the caller of an operator knows about the new vertex or edge.
enum class Room {
  Unknown,  ///< Nothing; what is near is looked up.
  Clear,    ///< No vertex and edge that are not joined are within margin() of each other because of it.
};

class Subdivision : public Structure {
 public:
  Subdivision();

  // ---- Euler operators (m make, k kill, v vertex, e edge, f face, r ring = a further loop of a face) -----------
  // All of them trust the caller that the segment crosses nothing.

  /// The first is the operator mvsf of the literature; further ones put an isolated vertex into `face`. V+1 C+1.
  VertexId mvsf(FaceId face, geom::Point p);
  void kvsf(VertexId isolated);
  /// An edge from the corner to a new vertex. V+1 E+1. Returns the half-edge that leaves the corner.
  HalfEdgeId mev(const Corner& from, geom::Point p, Room room = Room::Unknown);
  /// Removes the edge of h with target(h), which has no other edge.
  void kev(HalfEdgeId h);
  /// An edge between two corners of one loop. E+1 F+1. The new face is bounded; loops that lie in it move to it.
  HalfEdgeId mef(const Corner& from, const Corner& to, Room room = Room::Unknown);
  /// Removes the edge of h; face(twin(h)) is merged into face(h) (the unbounded face survives whichever side it is).
  FaceId kef(HalfEdgeId h);
  /// An edge between corners in two loops of one face, which become one. E+1 C-1.
  HalfEdgeId mekr(const Corner& from, const Corner& to, Room room = Room::Unknown);
  /// Removes an edge with the same loop on both sides, which falls into two.
  void kemr(HalfEdgeId h);
  /// A vertex p on edge e. V+1 E+1. The half-edge 2e keeps its origin; returns the vertex. Inverse: join.
  VertexId split(EdgeId e, geom::Point p, Room room = Room::Unknown);
  /// Removes a vertex of degree two. Of its two edges `kept` stays, or the one with the lower id; returned.
  EdgeId join(VertexId v, EdgeId kept = {});
  /// mef or mekr, whichever applies.
  HalfEdgeId connect(const Corner& from, const Corner& to, Room room = Room::Unknown);
  /// The same between the corners of a and b that look at each other.
  HalfEdgeId connect(VertexId a, VertexId b) { return connect(corner(a, point(b)), corner(b, point(a))); }

  // ---- attributes ----------------------------------------------------------------------------------------------
  std::any& attribute() { return attribute_; }
  std::any& attribute(VertexId v) { return vertex_attribute_.at(v.index(), vertices_.size()); }
  std::any& attribute(EdgeId e) { return edge_attribute_.at(e.index(), edge_live_.size()); }
  std::any& attribute(FaceId f) { return face_attribute_.at(f.index(), faces_.size()); }
  [[nodiscard]] const std::any& attribute() const { return attribute_; }
  [[nodiscard]] const std::any& attribute(VertexId v) const { return vertex_attribute_.at(v.index()); }
  [[nodiscard]] const std::any& attribute(EdgeId e) const { return edge_attribute_.at(e.index()); }
  [[nodiscard]] const std::any& attribute(FaceId f) const { return face_attribute_.at(f.index()); }
  /// True if a face ever had an attribute.
  [[nodiscard]] bool has_face_attributes() const { return face_attribute_.used(); }

  // ---- for insertion -------------------------------------------------------------------------------------------
  /// Where edges are (item: number of the edge) and isolated vertices (number of the vertex).
  [[nodiscard]] const ItemTree& edge_tree() const { return edge_tree_; }
  [[nodiscard]] const ItemTree& lone_tree() const { return lone_tree_; }
  /// What is farther apart than this can be bent through rounded points without meeting: 2^-43 of the greatest
  /// coordinate so far (`with` counted in). Infinite where numbers are so large or small that doubles cannot tell.
  [[nodiscard]] double margin(geom::Point with) const;
  /// How often e may still be bent by half an ulp before a vertex could lie in its way; 0: not known.
  [[nodiscard]] int room(EdgeId e) const { return room_[e.index()]; }
  /// @pre no vertex except its ends is within margin() of e.
  void set_clear(EdgeId e) { room_[e.index()] = full_room; }
  /// A number that the caller may keep with an edge; not kept up by any operator.
  std::uint32_t& mark(EdgeId e) { return mark_[e.index()]; }

 private:
  static constexpr std::uint8_t full_room = 250;

  void tighten(geom::Point p, EdgeId except);
  VertexId new_vertex(geom::Point p);
  EdgeId new_edge(VertexId from, VertexId to, Room room);
  LoopId new_loop(FaceId f);
  FaceId new_face();
  void free_vertex(VertexId v);
  void free_edge(EdgeId e);
  void free_loop(LoopId l);
  void free_face(FaceId f);
  void attach(LoopId l, FaceId f);
  void detach(LoopId l);
  void link(HalfEdgeId a, HalfEdgeId b);
  HalfEdgeId link_edge(const Corner& from, const Corner& to, Room room);
  void unlink_edge(HalfEdgeId h);
  void move_edge(EdgeId e);
  void set_lone(VertexId v, LoopId l);
  void end_lone(VertexId v);
  void label(HalfEdgeId start, LoopId l);
  [[nodiscard]] HalfEdgeId shorter(HalfEdgeId a, HalfEdgeId b) const;
  [[nodiscard]] bool runs_round_hole(LoopId l) const;
  [[nodiscard]] bool encloses(LoopId l, geom::Point p) const;
  void move_enclosed_loops(FaceId from, FaceId to, LoopId by, LoopId rest);

  AttributeColumn vertex_attribute_, edge_attribute_, face_attribute_;
  std::any attribute_;
  std::vector<std::uint8_t> room_;
  std::vector<std::uint32_t> mark_;
  ItemTree edge_tree_, lone_tree_;
  double reach_ = 0.0;  ///< Greatest coordinate so far.
};

}  // namespace dobra::topo
