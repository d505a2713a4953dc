// 1 A segment becomes a piece of work between two vertices; pieces wait on a stack.
// 2 A piece that passes vertices is cut there (exact; nothing moves).
// 3 A piece that crosses edges is cut at the rounded crossings. Each crossed edge is bent through its crossing: in place
//   if the triangle so swept holds nothing else, otherwise it is removed and its two parts become work.
// 4 A piece that meets nothing is connected by an Euler operator.
// Every piece remembers what became of it, so that the path of the curve can be read off in the end.

#include "shared/topo/insert.h"

#include <algorithm>
#include <unordered_map>

#include "shared/geom/intersect.h"
#include "shared/geom/predicates.h"
#include "shared/topo/locate.h"

namespace dobra::topo {

using base::Error;
using base::ErrorCode;
using base::Result;
using geom::IntersectionKind;
using geom::Meeting;
using geom::Point;
using geom::Segment;
using geom::Sign;

namespace {

base::Place place_of(Point p) {
  base::Place place;
  place.x = p.x;
  place.y = p.y;
  return place;
}

/// The vertex at p, made if need be. @pre finite.
VertexId vertex_for(Subdivision& sub, Point p) {
  const Location at = locate(sub, p);
  if (at.where == Where::Vertex) return at.vertex;
  if (at.where == Where::Edge) return sub.split(at.edge, p);
  return sub.mvsf(at.face, p);
}

bool in_closed_triangle(Point a, Point b, Point c, Point p) {
  const Sign turn = geom::orient2d(a, b, c);
  if (turn == Sign::Zero) return false;
  if (turn == Sign::Negative) std::swap(b, c);
  return geom::orient2d(a, b, p) != Sign::Negative && geom::orient2d(b, c, p) != Sign::Negative &&
         geom::orient2d(c, a, p) != Sign::Negative;
}

class Insertion {
 public:
  explicit Insertion(Subdivision& sub) : sub_(sub) {}

  Result<void> add(VertexId from, VertexId to) {
    roots_.push_back(make_piece(from, to));
    stack_.push_back(roots_.back());
    while (!stack_.empty()) {
      const std::uint32_t next = stack_.back();
      stack_.pop_back();
      process(next);
      if (detours_ > 1000 + 4 * sub_.edge_count()) {
        return Error{ErrorCode::CannotInsert, "rounding of crossings does not come to rest; move the curve a little",
                     place_of(sub_.point(from))};
      }
    }
    return {};
  }

  Inserted result() {
    Inserted inserted;
    for (const std::uint32_t root : roots_) expand(root, inserted.path);
    for (const auto& [edge, piece] : piece_of_) {
      if (sub_.contains(edge) && pieces_[piece].fresh) inserted.edges.push_back(edge);
    }
    std::sort(inserted.edges.begin(), inserted.edges.end());
    for (const FaceId f : faces_) {
      if (sub_.contains(f) && std::count(inserted.faces.begin(), inserted.faces.end(), f) == 0) inserted.faces.push_back(f);
    }
    return inserted;
  }

  VertexId vertex(Point p) {
    const Location at = locate(sub_, p);
    return at.where == Where::Edge ? split(at.edge, p) : vertex_for(sub_, p);
  }

 private:
  struct Part {
    std::uint32_t piece;
    bool reversed;
  };
  struct Piece {
    VertexId from, to;
    HalfEdgeId half_edge;     // if it is an edge now
    std::vector<Part> parts;  // otherwise what it fell into, in order
    bool fresh = false;
    std::any attribute;
  };
  struct Crossing {
    EdgeId edge;
    Point point;
  };

  std::uint32_t make_piece(VertexId from, VertexId to) {
    pieces_.push_back({from, to, {}, {}, false, {}});
    return static_cast<std::uint32_t>(pieces_.size() - 1);
  }

  /// The piece that stands for an existing edge, in the direction of its first half-edge.
  std::uint32_t piece_for(EdgeId e) {
    const auto found = piece_of_.find(e);
    if (found != piece_of_.end()) return found->second;
    const HalfEdgeId h = Subdivision::half_edge(e);
    const std::uint32_t piece = make_piece(sub_.origin(h), sub_.target(h));
    pieces_[piece].half_edge = h;
    piece_of_.emplace(e, piece);
    return piece;
  }

  VertexId split(EdgeId e, Point p) {
    const std::uint32_t whole = piece_for(e);
    const VertexId middle = sub_.split(e, p);
    const HalfEdgeId first = Subdivision::half_edge(e);
    const HalfEdgeId second = sub_.origin(sub_.next(first)) == middle ? sub_.next(first) : HalfEdgeId();
    piece_of_.erase(e);
    for (const HalfEdgeId h : {first, second}) {
      const std::uint32_t part = piece_for(Subdivision::edge(h));
      pieces_[part].fresh = pieces_[whole].fresh;
      pieces_[whole].parts.push_back({part, Subdivision::half_edge(Subdivision::edge(h)) != h});
    }
    pieces_[whole].half_edge = {};
    return middle;
  }

  /// Cuts a piece at vertices given in order and puts the parts to work.
  void cut(std::uint32_t piece, const std::vector<VertexId>& through) {
    VertexId last = pieces_[piece].from;
    const VertexId end = pieces_[piece].to;
    const auto part = [&](VertexId to) {
      if (to == last) return;
      const std::uint32_t made = make_piece(last, to);
      pieces_[made].attribute = pieces_[piece].attribute;
      pieces_[made].fresh = pieces_[piece].fresh;
      pieces_[piece].parts.push_back({made, false});
      stack_.push_back(made);
      last = to;
    };
    for (const VertexId v : through) part(v);
    part(end);
  }

  void process(std::uint32_t index) {
    const VertexId from = pieces_[index].from;
    const VertexId to = pieces_[index].to;
    if (const HalfEdgeId there = sub_.between(from, to); there.valid()) {
      const std::uint32_t piece = piece_for(Subdivision::edge(there));
      pieces_[index].parts.push_back({piece, Subdivision::half_edge(Subdivision::edge(there)) != there});
      return;
    }
    const Segment segment{sub_.point(from), sub_.point(to)};
    std::vector<Point> touched;
    std::vector<Crossing> crossings;
    find(segment, touched, crossings);
    if (!touched.empty()) {
      geom::sort_along(segment, touched);
      std::vector<VertexId> through;
      for (const Point p : touched) through.push_back(*sub_.vertex_at(p));
      cut(index, through);
    } else if (!crossings.empty()) {
      std::sort(crossings.begin(), crossings.end(), [&](const Crossing& a, const Crossing& b) {
        if (a.point != b.point) return geom::before_along(segment, a.point, b.point);
        return a.edge < b.edge;
      });
      std::vector<VertexId> through;
      for (const Crossing& c : crossings) {
        if (sub_.contains(c.edge)) through.push_back(bend(c));
      }
      cut(index, through);
    } else {
      connect(index, from, to);
    }
  }

  void find(const Segment& segment, std::vector<Point>& touched, std::vector<Crossing>& crossings) const {
    sub_.tree().visit(segment, [&](std::uint32_t item) {
      if (item % 2 == 1) {
        const Point p = sub_.point(VertexId(item / 2));
        if (p != segment.from && p != segment.to && geom::point_on_segment(p, segment)) touched.push_back(p);
        return;
      }
      const EdgeId e(item / 2);
      const geom::Intersection meet = geom::intersect(segment, sub_.segment(e));
      if (meet.kind == IntersectionKind::None) return;
      if (meet.kind == IntersectionKind::Point && meet.start.proper()) {
        crossings.push_back({e, meet.start.point});
        return;
      }
      if (meet.start.on_first == geom::At::Interior) touched.push_back(meet.start.point);
      if (meet.kind == IntersectionKind::Overlap && meet.end.on_first == geom::At::Interior) {
        touched.push_back(meet.end.point);
      }
    });
  }

  /// Leads the crossed edge through the rounded crossing and returns the vertex there.
  VertexId bend(const Crossing& c) {
    const HalfEdgeId h = Subdivision::half_edge(c.edge);
    const VertexId from = sub_.origin(h);
    const VertexId to = sub_.target(h);
    const auto there = sub_.vertex_at(c.point);
    if (there && (*there == from || *there == to)) return *there;
    if (!there && sweeps_nothing(c.edge, c.point)) return split(c.edge, c.point);
    // Another edge or vertex is within rounding: the parts have to find their way as any new segment does.
    ++detours_;
    const std::uint32_t piece = piece_for(c.edge);
    pieces_[piece].attribute = sub_.attribute(c.edge);
    pieces_[piece].half_edge = {};
    piece_of_.erase(c.edge);
    const Result<void> removed = remove(sub_, c.edge, Bare::Keep);
    DOBRA_CHECK(removed.ok());
    const VertexId middle = there ? *there : vertex(c.point);
    cut(piece, {middle});
    return middle;
  }

  /// True if nothing but edge e lies in the triangle between it and its two parts through p.
  [[nodiscard]] bool sweeps_nothing(EdgeId e, Point p) const {
    const Segment old = sub_.segment(e);
    geom::Box box = old.box();
    box.add(p);
    const Segment parts[2] = {{old.from, p}, {p, old.to}};
    bool clear = true;
    const auto is_in = [&](Point q) {
      return q != old.from && q != old.to && in_closed_triangle(old.from, p, old.to, q);
    };
    sub_.tree().visit(box, [&](std::uint32_t item) {
      if (!clear || item == 2 * e.index()) return;
      if (item % 2 == 1) {
        const Point q = sub_.point(VertexId(item / 2));
        clear = !is_in(q) && !geom::point_on_segment(q, parts[0]) && !geom::point_on_segment(q, parts[1]);
        return;
      }
      const Segment other = sub_.segment(EdgeId(item / 2));
      if (is_in(other.from) || is_in(other.to)) clear = false;
      for (const Segment& part : parts) {
        const geom::Intersection meet = geom::intersect(part, other);
        const bool at_old_end = meet.start.point == old.from || meet.start.point == old.to;
        if (meet.kind == IntersectionKind::None || (meet.kind == IntersectionKind::Point && at_old_end)) continue;
        clear = false;
      }
    });
    return clear;
  }

  void connect(std::uint32_t index, VertexId from, VertexId to) {
    const FaceId in = sub_.face(sub_.corner(from, sub_.point(to)));
    const HalfEdgeId h = sub_.connect(from, to);
    for (const FaceId f : {sub_.face(h), sub_.face(Subdivision::twin(h))}) {
      if (f != in) faces_.push_back(f);
    }
    const EdgeId e = Subdivision::edge(h);
    sub_.attribute(e) = std::move(pieces_[index].attribute);
    pieces_[index].half_edge = h;
    pieces_[index].fresh = true;
    piece_of_[e] = index;
  }

  void expand(std::uint32_t root, std::vector<HalfEdgeId>& path) const {
    std::vector<Part> open{{root, false}};
    while (!open.empty()) {
      const Part part = open.back();
      open.pop_back();
      const Piece& piece = pieces_[part.piece];
      if (piece.half_edge.valid()) {
        path.push_back(part.reversed ? Subdivision::twin(piece.half_edge) : piece.half_edge);
        continue;
      }
      const std::size_t count = piece.parts.size();
      for (std::size_t i = 0; i < count; ++i) {
        const Part& p = piece.parts[part.reversed ? i : count - 1 - i];
        open.push_back({p.piece, p.reversed != part.reversed});
      }
    }
  }

  Subdivision& sub_;
  std::vector<Piece> pieces_;
  std::vector<std::uint32_t> stack_;
  std::vector<std::uint32_t> roots_;
  std::unordered_map<EdgeId, std::uint32_t> piece_of_;
  std::vector<FaceId> faces_;
  std::size_t detours_ = 0;
};

Result<void> check_finite(Point p) {
  if (geom::is_finite(p)) return {};
  return Error{ErrorCode::NotFinite, "a coordinate is not a finite number; remove or correct the point"};
}

}  // namespace

Result<VertexId> insert(Subdivision& sub, Point p) {
  DOBRA_TRY_VOID(check_finite(p));
  return vertex_for(sub, p);
}

Result<Inserted> insert(Subdivision& sub, const Segment& segment) {
  return insert(sub, geom::Polyline{{segment.from, segment.to}, false});
}

Result<Inserted> insert(Subdivision& sub, const geom::Polyline& curve) {
  for (const Point p : curve.points) DOBRA_TRY_VOID(check_finite(p));
  const bool moves = std::any_of(curve.points.begin(), curve.points.end(), [&](Point p) { return p != curve.points[0]; });
  if (!moves) {
    Error error{ErrorCode::DegenerateCurve, "a curve of zero length cannot be inserted; give it two distinct points"};
    if (!curve.points.empty()) error.place = place_of(curve.points.front());
    return error;
  }
  Insertion insertion(sub);
  for (std::size_t i = 0; i < curve.segment_count(); ++i) {
    const Segment segment = curve.segment(i);
    const VertexId from = insertion.vertex(segment.from);
    const VertexId to = insertion.vertex(segment.to);
    if (from != to) DOBRA_TRY_VOID(insertion.add(from, to));
  }
  return insertion.result();
}

Result<void> remove(Subdivision& sub, EdgeId e, Bare bare) {
  if (!sub.contains(e)) return Error{ErrorCode::NotInSubdivision, "the edge to remove is not in the subdivision"};
  const HalfEdgeId h = Subdivision::half_edge(e);
  const HalfEdgeId t = Subdivision::twin(h);
  const VertexId ends[2] = {sub.origin(h), sub.origin(t)};
  if (sub.loop(h) == sub.loop(t)) {
    sub.kemr(h);
  } else {
    sub.kef(sub.face(h) < sub.face(t) ? h : t);
  }
  for (const VertexId v : ends) {
    if (bare == Bare::Remove && sub.lone_loop(v).valid()) sub.kvsf(v);
  }
  return {};
}

}  // namespace dobra::topo
