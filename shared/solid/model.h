#pragma once
// A boundary model that is made and changed by Euler operators alone: shell -> face -> loop -> half-edge -> edge ->
// vertex. Each operator has its inverse, and undo() applies it: every link and every id is as before. So
// v - e + f = 2 (s - h) + r always holds. Sources: [mantyla1988solid], [weiler1985edge].
//
// A face lies to the left of its half-edges, seen from outside. Its first loop bounds it, further ones are rings; an
// isolated vertex is a loop without half-edges. Operators trust their caller with the geometry: places are notes.

#include <string>
#include <vector>

#include "shared/base/result.h"
#include "shared/geom/point3.h"
#include "shared/solid/solid.h"

namespace dobra::solid {

struct LoopTag {
  static constexpr const char* prefix = "l";
};
using LoopId = base::Id<LoopTag>;

/// A place between two edges at a vertex: just before half-edge `before` in its loop. `before` is none at an isolated
/// vertex.
struct Corner {
  VertexId vertex;
  HalfEdgeId before;
  friend bool operator==(const Corner&, const Corner&) = default;
};

class Model {
 public:
  // ---- operators (m make, k kill, v vertex, e edge, f face, s shell, r ring, h handle) ---------------------------
  // @error NotInSubdivision where the model has no such thing, InvalidOption where the precondition fails: what is said
  // of the arguments. A refused operator changes nothing.

  /// A shell of one face that is an isolated vertex. v+1 f+1 s+1.
  FaceId mvsf(geom::Point3 p);
  /// Inverse; f is all of its shell and an isolated vertex.
  base::Result<void> kvsf(FaceId f);
  /// An edge from a corner to a new vertex; the half-edge that leaves the corner. v+1 e+1.
  base::Result<HalfEdgeId> mev(Corner from, geom::Point3 p);
  /// Inverse; target(h) has no other edge.
  base::Result<void> kev(HalfEdgeId h);
  /// An edge between corners of one loop; the new face is to the left of its twin, rings stay. e+1 f+1.
  base::Result<HalfEdgeId> mef(Corner from, Corner to);
  /// Inverse; the face beyond h is another one and has no rings. It goes. An edge that is all of its loop is taken out
  /// from its other side.
  base::Result<void> kef(HalfEdgeId h);
  /// Takes out an edge with one loop on both sides; what hangs on target(h) becomes a ring. e-1 r+1.
  base::Result<LoopId> kemr(HalfEdgeId h);
  /// Inverse: an edge from a corner to one of a ring of the same face, which goes.
  base::Result<HalfEdgeId> mekr(Corner from, Corner to_ring);
  /// The one loop of a face becomes a ring of another face of the same shell. f-1 r+1 h+1.
  base::Result<LoopId> kfmrh(FaceId into, FaceId killed);
  /// Inverse; the shell hangs together without the ring's place in its face.
  base::Result<FaceId> mfkrh(LoopId ring);
  /// The one loop of a face becomes a ring of a face of another shell; the shells become one. f-1 s-1 r+1.
  base::Result<LoopId> ksfmr(FaceId into, FaceId killed);
  /// Inverse; without the ring's place in its face the shell falls into two.
  base::Result<FaceId> msfkr(LoopId ring);

  /// How many operators there were since the beginning, those undone left out.
  [[nodiscard]] std::size_t operator_count() const { return log_.size(); }
  /// Applies the inverse of the last operator.  @pre operator_count() > 0
  void undo();

  // ---- what there is ---------------------------------------------------------------------------------------------
  [[nodiscard]] Counts counts() const { return counts_; }
  static HalfEdgeId twin(HalfEdgeId h) { return HalfEdgeId(h.index() ^ 1U); }
  [[nodiscard]] HalfEdgeId next(HalfEdgeId h) const { return half_edges_[h.index()].next; }
  [[nodiscard]] HalfEdgeId previous(HalfEdgeId h) const { return half_edges_[h.index()].previous; }
  [[nodiscard]] VertexId origin(HalfEdgeId h) const { return half_edges_[h.index()].origin; }
  [[nodiscard]] VertexId target(HalfEdgeId h) const { return origin(twin(h)); }
  [[nodiscard]] LoopId loop(HalfEdgeId h) const { return half_edges_[h.index()].loop; }
  [[nodiscard]] FaceId face(LoopId l) const { return loops_[l.index()].face; }
  [[nodiscard]] FaceId face(HalfEdgeId h) const { return face(loop(h)); }
  [[nodiscard]] ShellId shell(FaceId f) const { return faces_[f.index()].shell; }
  [[nodiscard]] geom::Point3 point(VertexId v) const { return vertices_[v.index()].point; }
  /// The first bounds the face.
  [[nodiscard]] const std::vector<LoopId>& loops(FaceId f) const { return faces_[f.index()].loops; }
  /// A half-edge of the loop; none if it is an isolated vertex.
  [[nodiscard]] HalfEdgeId first(LoopId l) const { return loops_[l.index()].first; }
  [[nodiscard]] VertexId lone_vertex(LoopId l) const { return loops_[l.index()].lone; }
  [[nodiscard]] std::vector<HalfEdgeId> half_edges(LoopId l) const;
  [[nodiscard]] std::vector<FaceId> faces() const;
  /// One half-edge of each edge.
  [[nodiscard]] std::vector<HalfEdgeId> edges() const;
  /// Where h begins in its loop.
  [[nodiscard]] Corner corner(HalfEdgeId h) const { return {origin(h), h}; }
  /// Everything with its ids, in a form that does not depend on where loops begin.
  [[nodiscard]] std::string dump() const;

 private:
  struct Vertex {
    geom::Point3 point;
    LoopId lone;  // the loop that it is, if isolated
    bool live = false;
  };
  struct HalfEdge {
    HalfEdgeId next, previous;
    VertexId origin;
    LoopId loop;
    bool live = false;
  };
  struct Loop {
    HalfEdgeId first;
    VertexId lone;
    FaceId face;
    bool live = false;
  };
  struct Face {
    std::vector<LoopId> loops;
    ShellId shell;
    bool live = false;
  };
  enum class Kind : std::uint8_t { Mvsf, Kvsf, Mev, Kev, Mef, Kef, Kemr, Mekr, Kfmrh, Mfkrh, Ksfmr, Msfkr };
  /// An operator that was applied, and what its inverse needs.
  struct Done {
    Kind kind;
    std::size_t id = 0, other = 0;
    Corner from, to;
    geom::Point3 point;
  };

  template <class Records, class Id>
  static Id take(Records& records, std::vector<Id>& spare);
  HalfEdgeId take_edge(VertexId from, VertexId to);
  void free_edge(HalfEdgeId h);
  LoopId take_loop(FaceId f);
  void free_loop(LoopId l);
  FaceId take_face(ShellId s);
  void free_face(FaceId f);
  void link(HalfEdgeId a, HalfEdgeId b);
  void settle(LoopId l, HalfEdgeId from);
  void settle(LoopId l, VertexId lone);
  HalfEdgeId join(Corner from, Corner to);
  [[nodiscard]] bool has(HalfEdgeId h) const { return h.index() < half_edges_.size() && half_edges_[h.index()].live; }
  [[nodiscard]] bool has(FaceId f) const { return f.index() < faces_.size() && faces_[f.index()].live; }
  [[nodiscard]] bool has(LoopId l) const { return l.index() < loops_.size() && loops_[l.index()].live; }
  [[nodiscard]] bool has(const Corner& c) const;
  [[nodiscard]] LoopId loop(const Corner& c) const;
  [[nodiscard]] bool is_ring(LoopId l) const { return loops(face(l)).front() != l; }
  [[nodiscard]] std::vector<FaceId> reached(LoopId ring, bool& comes_back) const;
  void detach(LoopId l);
  LoopId move_loop(FaceId into, FaceId killed);
  void note(Done done);

  std::vector<Vertex> vertices_;
  std::vector<HalfEdge> half_edges_;
  std::vector<Loop> loops_;
  std::vector<Face> faces_;
  std::vector<char> shells_;
  std::vector<VertexId> spare_vertices_;
  std::vector<HalfEdgeId> spare_edges_;
  std::vector<LoopId> spare_loops_;
  std::vector<FaceId> spare_faces_;
  std::vector<ShellId> spare_shells_;
  Counts counts_;
  std::vector<Done> log_;
  bool undoing_ = false;
};

/// The solid that the model's boundary with its places bounds; faces that are not plane are cut into triangles.
/// @error as from_mesh() says; NotClosed for faces of less than three corners.
base::Result<Solid> to_solid(const Model& model);

}  // namespace dobra::solid
