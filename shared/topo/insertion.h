#pragma once
// The work behind insert.h: one curve on its way into a subdivision. Two ways lead there. `quick.cpp` takes a segment
// that has room (nothing else within margin() of it but what it crosses squarely) in a single look at the tree, in
// doubles. Everything else goes the careful way of `insertion.cpp`, by exact predicates:
//   1  A segment becomes a piece of work between two vertices; pieces wait on a stack.
//   2  A piece that passes vertices is cut there (exact; nothing moves).
//   3  A piece that crosses edges is cut at the rounded crossings. Each crossed edge is bent through its crossing: in
//      place if the triangle so swept holds nothing else; otherwise it is removed and its two parts become work.
//   4  A piece that meets nothing is connected by an Euler operator.
// Every piece remembers what became of it, so that the path of the curve can be read off in the end. It ends: a piece
// or an edge is only ever replaced by parts whose boxes lie within its own and are smaller (docs page).

#include <vector>

#include "shared/topo/insert.h"
#include "shared/topo/owners.h"

namespace dobra::topo {

class Insertion {
 public:
  explicit Insertion(Subdivision& sub) : sub_(sub), owners_(sub) {}

  /// The vertex at p, made if need be.
  VertexId vertex(geom::Point p);
  /// From a vertex to a point, which becomes one. @pre they differ
  VertexId advance(VertexId from, geom::Point to);
  Inserted finish();
  /// How many pieces of work came in so far.
  [[nodiscard]] std::size_t root_count() const { return roots_.size(); }
  /// What the pieces of work [first, last) are now.
  [[nodiscard]] std::vector<HalfEdgeId> path(std::size_t first, std::size_t last) const;

 private:
  static constexpr std::uint32_t none = 0xffffffffU;
  static constexpr std::size_t patience = 64;  // detours of a segment until snap() doubles
  struct Part {
    std::uint32_t piece;
    bool reversed;
  };
  struct Piece {
    VertexId from, to;
    HalfEdgeId half_edge;          // if it is an edge now
    std::uint32_t first_part = 0;  // otherwise what it fell into, in order
    std::uint32_t part_count = 0;
    std::uint32_t attribute = none;  // of an edge that is on its way in again
    Sides sides;
    bool fresh = false;
  };
  struct Crossing {
    EdgeId edge;
    geom::Point point;
  };
  /// A crossing on the quick way.
  struct Square {
    EdgeId edge;
    geom::Segment segment;
    double along;    // distance from the start
    double sine;     // of the angle at which it is crossed
    bool from_left;  // the segment comes from the left of the edge
  };
  struct View {
    double crowd_from = 1.0;  // least sine between the segment and an edge that leaves its start the same way
    double crowd_to = 1.0;    // and its end
  };

  // quick.cpp
  bool quick(VertexId& at, geom::Point to);
  bool look(const geom::Segment& s, double margin, View& view);
  bool judge(const geom::Segment& s, double length, double margin, EdgeId e, const geom::Segment& other, View& view);
  [[nodiscard]] bool apart(double length, double margin, const View& view) const;
  [[nodiscard]] bool may_bend(EdgeId e, geom::Point p);
  void joined(HalfEdgeId h, FaceId in);

  // insertion.cpp
  void add(VertexId from, VertexId to);
  std::uint32_t make_piece(VertexId from, VertexId to);
  std::uint32_t piece_for(EdgeId e);
  void own(std::uint32_t piece, HalfEdgeId h);
  VertexId split(EdgeId e, geom::Point p, Room room = Room::Unknown);
  void cut(std::uint32_t piece, const std::vector<VertexId>& through);
  void process(std::uint32_t index);
  void find(const geom::Segment& segment, std::vector<geom::Point>& touched, std::vector<Crossing>& crossings) const;
  [[nodiscard]] VertexId nearest(const geom::Segment& place, const geom::Segment& segment) const;
  [[nodiscard]] std::optional<VertexId> vertex_near(EdgeId e, geom::Point p) const;
  [[nodiscard]] double snap(geom::Point p) const;
  [[nodiscard]] bool still_there(const Crossing& c, const geom::Segment& segment) const;
  VertexId bend(const Crossing& c);
  bool sweeps_nothing(EdgeId e, geom::Point p);
  void connect(std::uint32_t index);
  void expand(std::uint32_t root, std::vector<HalfEdgeId>& path) const;

  Subdivision& sub_;
  Owners owners_;
  std::vector<Piece> pieces_;
  std::vector<Part> parts_;
  std::vector<std::uint32_t> stack_;
  std::vector<std::uint32_t> roots_;
  std::vector<std::any> attributes_;
  std::vector<FaceId> faces_;
  std::vector<Square> squares_;
  std::size_t detours_ = 0;  // of the segment at hand
};

}  // namespace dobra::topo
