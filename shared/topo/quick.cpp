// The quick way of insertion. A single look at the tree finds what comes within margin() of the segment. If that is
// only edges that it crosses, far from all ends and from each other, then neither the rounding of the crossings nor the
// bending of the crossed edges can make anything meet (margin() is 2^10 times what rounding moves), and the signs of
// all determinants are known from doubles. In every other case the careful way takes over, from where this one came to.

#include <algorithm>

#include "shared/geom/intersect.h"
#include "shared/geom/predicates.h"
#include "shared/topo/insertion.h"

namespace dobra::topo {

using geom::Point;
using geom::Segment;
using geom::Sign;
using geom::Vector;

namespace {

double size(Vector v) { return std::sqrt(geom::length_squared(v)); }

}  // namespace

/// Adds the edge to squares_ if it is crossed. False if it is too near to say.
/// In the frame of s: along is the distance from its start, across the one to its left.
bool Insertion::judge(const Segment& s, double length, double margin, EdgeId e, const Segment& other, View& view) {
  const Vector u = (1.0 / length) * s.vector();
  const Vector p = other.from - s.from;
  const Vector q = other.to - s.from;
  const double p_across = geom::cross(u, p);
  const double q_across = geom::cross(u, q);
  if (std::min(p_across, q_across) > margin || std::max(p_across, q_across) < -margin) return true;
  const double p_along = geom::dot(u, p);
  const double q_along = geom::dot(u, q);
  if (std::max(p_along, q_along) < -margin || std::min(p_along, q_along) > length + margin) return true;
  const Vector v = other.vector();
  const double other_length = size(v);
  if (!(other_length > margin)) return false;  // 0 also where its square vanishes
  const bool leaves_start = other.from == s.from || other.to == s.from;
  const bool leaves_end = other.from == s.to || other.to == s.to;
  if (leaves_start || leaves_end) {
    if (leaves_start && leaves_end) return false;
    const bool outward = leaves_start ? other.from == s.from : other.from == s.to;
    const double across = std::abs(outward ? q_across : p_across);
    const double along = leaves_start ? (outward ? q_along : p_along) : length - (outward ? q_along : p_along);
    if (along <= 0.0) return along < -margin || across > margin;  // it leads away
    const double sine = across / other_length;
    double& crowd = leaves_start ? view.crowd_from : view.crowd_to;
    crowd = std::min(crowd, sine);
    return across > margin && sine * length > margin;
  }
  // Where the ends of s lie beside the other edge.
  const double from_across = geom::cross(v, s.from - other.from) / other_length;
  const double to_across = geom::cross(v, s.to - other.from) / other_length;
  if (std::min(from_across, to_across) > margin || std::max(from_across, to_across) < -margin) return true;
  const bool crosses = std::min(p_across, q_across) < -margin && std::max(p_across, q_across) > margin &&
                       std::min(from_across, to_across) < -margin && std::max(from_across, to_across) > margin;
  if (!crosses) return false;
  const double share = p_across / (p_across - q_across);
  squares_.push_back({e, other, p_along + share * (q_along - p_along), std::abs(p_across - q_across) / other_length,
                      from_across > 0.0});
  return true;
}

bool Insertion::look(const Segment& s, double margin, View& view) {
  const double length = size(s.vector());
  if (!(length > 8.0 * margin)) return false;
  squares_.clear();
  bool room = true;
  sub_.lone_tree().visit(s, margin, [&](std::uint32_t, const Segment& lone) {
    if (lone.from != s.from && lone.from != s.to) room = false;
  });
  sub_.edge_tree().visit(s, margin, [&](std::uint32_t item, const Segment& other) {
    if (room) room = judge(s, length, margin, EdgeId(item), other, view);
  });
  if (!room || squares_.empty()) return room;
  std::sort(squares_.begin(), squares_.end(), [](const Square& a, const Square& b) { return a.along < b.along; });
  return apart(length, margin, view);
}

/// True if no crossing is within 2 margin of another crossed edge, an end or an edge that leaves an end.
bool Insertion::apart(double length, double margin, const View& view) const {
  double last = 0.0;
  double sine = view.crowd_from;
  for (const Square& c : squares_) {
    if (!((c.along - last) * std::min(sine, c.sine) > 2.0 * margin)) return false;
    last = c.along;
    sine = c.sine;
  }
  return (length - last) * std::min(sine, view.crowd_to) > 2.0 * margin;
}

/// True if e can be led through p, which has room, in place.
bool Insertion::may_bend(EdgeId e, Point p) {
  const HalfEdgeId h = Subdivision::half_edge(e);
  const Segment s = sub_.segment(h);
  if (geom::orient2d(s.from, s.to, p) == Sign::Zero) return true;
  if (sub_.room(e) == 0) return sweeps_nothing(e, p);
  // Far edges are out of reach; those at the ends must stay on their side.
  for (const HalfEdgeId side : {h, Subdivision::twin(h)}) {
    const HalfEdgeId after = sub_.turned(side);
    if (after == side) continue;
    const HalfEdgeId before = sub_.next(Subdivision::twin(side));
    const Point at = sub_.point(sub_.origin(side));
    const Point left = sub_.point(sub_.target(after));
    const Point right = sub_.point(sub_.target(before));
    if (after == before ? geom::orient2d(at, left, p) != geom::orient2d(at, left, sub_.point(sub_.target(side)))
                        : !within(at, right, left, p)) {
      return false;
    }
  }
  return true;
}

bool Insertion::quick(VertexId& at, Point to) {
  const Segment s{sub_.point(at), to};
  const double margin = sub_.margin(to);
  View view;
  if (!look(s, margin, view)) return false;
  const auto end = sub_.vertex_at(to);
  Corner from;
  const auto record = [&](HalfEdgeId h, FaceId in) {
    const std::uint32_t piece = make_piece(sub_.origin(h), sub_.target(h));
    own(piece, h);
    pieces_[piece].fresh = true;
    roots_.push_back(piece);
    joined(h, in);
    owners_.placed(h, {});
    at = sub_.target(h);
  };
  for (std::size_t i = 0; i < squares_.size(); ++i) {
    const Square c = squares_[i];
    const Point p = geom::crossing(s, c.segment);
    if (!may_bend(c.edge, p)) return false;
    const VertexId middle = split(c.edge, p, Room::Clear);
    const HalfEdgeId first = Subdivision::half_edge(c.edge);  // ends in `middle`
    // The two corners at a vertex between two edges: left of the edge and right of it.
    const Corner left{middle, sub_.next(first)};
    const Corner right{middle, Subdivision::twin(first)};
    if (i == 0) from = sub_.corner(at, p);
    const FaceId in = sub_.face(from);
    const HalfEdgeId h = sub_.connect(from, c.from_left ? left : right, Room::Clear);
    record(h, in);
    from = c.from_left ? right : left;
  }
  if (squares_.empty()) from = sub_.corner(at, to);
  const FaceId in = sub_.face(from);
  record(end ? sub_.connect(from, sub_.corner(*end, sub_.point(at)), Room::Clear) : sub_.mev(from, to, Room::Clear),
         in);
  return true;
}

}  // namespace dobra::topo
