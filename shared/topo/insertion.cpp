#include "shared/topo/insertion.h"

#include <algorithm>

#include "shared/base/check.h"
#include "shared/geom/intersect.h"
#include "shared/geom/predicates.h"
#include "shared/topo/locate.h"

namespace dobra::topo {

using geom::IntersectionKind;
using geom::Point;
using geom::Segment;
using geom::Sign;

namespace {

bool in_closed_triangle(Point a, Point b, Point c, Point p) {
  const Sign turn = geom::orient2d(a, b, c);
  if (turn == Sign::Zero) return false;
  if (turn == Sign::Negative) std::swap(b, c);
  return geom::orient2d(a, b, p) != Sign::Negative && geom::orient2d(b, c, p) != Sign::Negative &&
         geom::orient2d(c, a, p) != Sign::Negative;
}

/// True if both ways from the ends to p are shorter than the segment: so nothing is ever replaced by anything longer.
bool between_ends(const Segment& s, Point p) {
  if (p == s.from || p == s.to) return false;
  return s.box().contains(p) || geom::dot_sign(p, s.from, p, s.to) == Sign::Negative;
}

}  // namespace

VertexId Insertion::vertex(Point p) {
  const Location at = locate(sub_, p);
  if (at.where == Where::Vertex) return at.vertex;
  if (at.where == Where::Edge) return split(at.edge, p);
  return sub_.mvsf(at.face, p);
}

VertexId Insertion::advance(VertexId from, Point to) {
  if (quick(from, to)) return from;
  const VertexId end = vertex(to);
  add(from, end);
  return end;
}

void Insertion::add(VertexId from, VertexId to) {
  detours_ = 0;
  roots_.push_back(make_piece(from, to));
  stack_.push_back(roots_.back());
  while (!stack_.empty()) {
    const std::uint32_t next = stack_.back();
    stack_.pop_back();
    process(next);
  }
}

Inserted Insertion::finish() {
  owners_.settle();
  Inserted inserted;
  inserted.path = path(0, roots_.size());
  inserted.edges.reserve(pieces_.size());
  for (const Piece& piece : pieces_) {
    if (piece.fresh && piece.half_edge.valid()) inserted.edges.push_back(Subdivision::edge(piece.half_edge));
  }
  if (!std::is_sorted(inserted.edges.begin(), inserted.edges.end()))
    std::sort(inserted.edges.begin(), inserted.edges.end());
  std::set<FaceId> seen;
  for (const FaceId f : faces_) {
    if (sub_.contains(f) && seen.insert(f).second) inserted.faces.push_back(f);
  }
  return inserted;
}

std::vector<HalfEdgeId> Insertion::path(std::size_t first, std::size_t last) const {
  std::vector<HalfEdgeId> path;
  path.reserve(last - first);
  for (std::size_t i = first; i < last; ++i) expand(roots_[i], path);
  return path;
}

std::uint32_t Insertion::make_piece(VertexId from, VertexId to) {
  pieces_.push_back({});
  pieces_.back().from = from;
  pieces_.back().to = to;
  return static_cast<std::uint32_t>(pieces_.size() - 1);
}

/// From now on the piece is the edge of h.
void Insertion::own(std::uint32_t piece, HalfEdgeId h) {
  pieces_[piece].half_edge = h;
  sub_.mark(Subdivision::edge(h)) = piece;
}

/// The piece that stands for an existing edge. A mark counts only if the piece that it names knows of the edge.
std::uint32_t Insertion::piece_for(EdgeId e) {
  const std::uint32_t mark = sub_.mark(e);
  if (mark < pieces_.size() && pieces_[mark].half_edge.valid() && Subdivision::edge(pieces_[mark].half_edge) == e) {
    return mark;
  }
  const HalfEdgeId h = Subdivision::half_edge(e);
  const std::uint32_t piece = make_piece(sub_.origin(h), sub_.target(h));
  own(piece, h);
  return piece;
}

VertexId Insertion::split(EdgeId e, Point p, Room room) {
  const std::uint32_t whole = piece_for(e);
  const VertexId middle = sub_.split(e, p, room);
  const HalfEdgeId first = Subdivision::half_edge(e);
  const HalfEdgeId second = sub_.next(first);
  owners_.split(first, second);
  const bool turned = pieces_[whole].half_edge != first;
  pieces_[whole].half_edge = {};
  pieces_[whole].first_part = static_cast<std::uint32_t>(parts_.size());
  pieces_[whole].part_count = 2;
  for (const HalfEdgeId h : {turned ? second : first, turned ? first : second}) {
    const std::uint32_t part = piece_for(Subdivision::edge(h));
    pieces_[part].fresh = pieces_[whole].fresh;
    parts_.push_back({part, turned});
  }
  return middle;
}

/// Cuts a piece at vertices given in order and puts the parts to work.
void Insertion::cut(std::uint32_t piece, const std::vector<VertexId>& through) {
  VertexId last = pieces_[piece].from;
  const VertexId end = pieces_[piece].to;
  pieces_[piece].first_part = static_cast<std::uint32_t>(parts_.size());
  const auto part = [&](VertexId to) {
    if (to == last) return;
    const std::uint32_t made = make_piece(last, to);
    pieces_[made].attribute = pieces_[piece].attribute;
    pieces_[made].sides = pieces_[piece].sides;
    parts_.push_back({made, false});
    stack_.push_back(made);
    last = to;
  };
  for (const VertexId v : through) part(v);
  part(end);
  pieces_[piece].part_count = static_cast<std::uint32_t>(parts_.size()) - pieces_[piece].first_part;
}

void Insertion::process(std::uint32_t index) {
  const VertexId from = pieces_[index].from;
  const VertexId to = pieces_[index].to;
  if (const HalfEdgeId there = sub_.between(from, to); there.valid()) {
    const std::uint32_t piece = piece_for(Subdivision::edge(there));
    owners_.coincides(there, pieces_[index].sides);
    pieces_[index].first_part = static_cast<std::uint32_t>(parts_.size());
    pieces_[index].part_count = 1;
    parts_.push_back({piece, pieces_[piece].half_edge != there});
    return;
  }
  const Segment segment{sub_.point(from), sub_.point(to)};
  std::vector<Point> touched;
  std::vector<Crossing> crossings;
  find(segment, touched, crossings);
  std::vector<VertexId> through;
  const bool only_crosses = touched.empty() && !crossings.empty();
  if (const VertexId near = only_crosses ? nearest(segment, segment) : VertexId(); near.valid()) {
    cut(index, {near});
  } else if (!touched.empty()) {
    geom::sort_along(segment, touched);
    for (const Point p : touched) through.push_back(*sub_.vertex_at(p));
    cut(index, through);
  } else if (!crossings.empty()) {
    std::sort(crossings.begin(), crossings.end(), [&](const Crossing& a, const Crossing& b) {
      if (a.point != b.point) return geom::before_along(segment, a.point, b.point);
      return a.edge < b.edge;
    });
    for (const Crossing& c : crossings) {
      if (!still_there(c, segment)) continue;
      const VertexId v = bend(c);
      if (between_ends(segment, sub_.point(v))) through.push_back(v);
    }
    cut(index, through);
  } else {
    connect(index);
  }
}

void Insertion::find(const Segment& segment, std::vector<Point>& touched, std::vector<Crossing>& crossings) const {
  sub_.lone_tree().visit(segment, 0.0, [&](std::uint32_t, const Segment& s) {
    const Point p = s.from;
    if (p != segment.from && p != segment.to && geom::point_on_segment(p, segment)) touched.push_back(p);
  });
  sub_.edge_tree().visit(segment, 0.0, [&](std::uint32_t item, const Segment& other) {
    const geom::Intersection meet = geom::intersect(segment, other);
    if (meet.kind == IntersectionKind::None) return;
    if (meet.kind == IntersectionKind::Point && meet.start.proper()) {
      crossings.push_back({EdgeId(item), meet.start.point});
      return;
    }
    if (meet.start.on_first == geom::At::Interior) touched.push_back(meet.start.point);
    if (meet.kind == IntersectionKind::Overlap && meet.end.on_first == geom::At::Interior) {
      touched.push_back(meet.end.point);
    }
  });
}

/// The vertex nearest to `place`, of those that it draws and `segment` can be led through.
VertexId Insertion::nearest(const Segment& place, const Segment& segment) const {
  VertexId best;
  const double snap = this->snap(place.from);
  double least = snap;
  const auto offer = [&](VertexId v, Point p) {
    const double away = geom::distance(place, p);
    if (away > least || (away == least && best.valid() && best <= v) || !between_ends(segment, p)) return;
    least = away;
    best = v;
  };
  sub_.lone_tree().visit(place, snap, [&](std::uint32_t v, const Segment& s) { offer(VertexId(v), s.from); });
  sub_.edge_tree().visit(place, snap, [&](std::uint32_t e, const Segment& s) {
    offer(sub_.origin(HalfEdgeId(2 * e)), s.from);
    offer(sub_.origin(HalfEdgeId(2 * e + 1)), s.to);
  });
  return best;
}

/// The vertex to lead edge e through where it is crossed at p, if there is one at p or near it.
std::optional<VertexId> Insertion::vertex_near(EdgeId e, Point p) const {
  const auto there = sub_.vertex_at(p);
  if (there) return there;
  const VertexId near = nearest({p, p}, sub_.segment(e));
  return near.valid() ? std::optional(near) : std::nullopt;
}

/// False if work on an earlier crossing has split or moved the edge; the parts of the piece will find what crosses
/// them.
bool Insertion::still_there(const Crossing& c, const Segment& segment) const {
  if (!sub_.contains(c.edge)) return false;
  const geom::Intersection meet = geom::intersect(segment, sub_.segment(c.edge));
  return meet.kind == IntersectionKind::Point && meet.start.proper() && meet.start.point == c.point;
}

/// Leads the crossed edge through the rounded crossing and returns the vertex there.
VertexId Insertion::bend(const Crossing& c) {
  const std::uint32_t piece = piece_for(c.edge);
  const VertexId from = pieces_[piece].from;
  const VertexId to = pieces_[piece].to;
  const auto there = vertex_near(c.edge, c.point);
  if (there && (*there == from || *there == to)) return *there;
  if (!there && sweeps_nothing(c.edge, c.point)) return split(c.edge, c.point);
  // Another edge or vertex is within rounding: the parts have to find their way as any new segment does.
  ++detours_;
  const HalfEdgeId h = pieces_[piece].half_edge;
  const FaceId left = sub_.face(h);
  const FaceId right = sub_.face(Subdivision::twin(h));
  pieces_[piece].sides = owners_.open(h);
  pieces_[piece].half_edge = {};
  if (std::as_const(sub_).attribute(c.edge).has_value()) {
    pieces_[piece].attribute = static_cast<std::uint32_t>(attributes_.size());
    attributes_.push_back(std::as_const(sub_).attribute(c.edge));
  }
  const base::Result<void> removed = remove(sub_, c.edge, Bare::Keep);
  DOBRA_CHECK(removed.ok());
  owners_.merged(left, right);
  const VertexId middle = there ? *there : vertex(c.point);
  cut(piece, {middle});
  return middle;
}

/// How near a vertex draws pieces to itself: a few units in the last place of the greatest coordinate, and more where
/// bent edges keep crossing each other.
double Insertion::snap(Point p) const {
  const double margin = sub_.margin(p);
  const double step = std::isfinite(margin) ? 0x1p-8 * margin : 0x1p-51 * std::max(std::abs(p.x), std::abs(p.y));
  return std::ldexp(step, static_cast<int>(std::min<std::size_t>(detours_ / patience, 1000)));
}

/// True if nothing but edge e lies in the triangle between it and its two parts through p.
bool Insertion::sweeps_nothing(EdgeId e, Point p) {
  const Segment old = sub_.segment(e);
  const Segment parts[2] = {{old.from, p}, {p, old.to}};
  if (geom::orient2d(old.from, old.to, p) == Sign::Zero) return true;
  const double margin = sub_.margin(p);
  bool clear = true;  // nothing is in the triangle
  bool wide = true;   // nothing is near
  const auto is_in = [&](Point q) {
    if (q == old.from || q == old.to) return false;
    if (!(geom::distance(old, q) > 1.5 * margin)) wide = false;
    return in_closed_triangle(old.from, p, old.to, q);
  };
  sub_.lone_tree().visit(old, 2.0 * margin, [&](std::uint32_t, const Segment& s) {
    const Point q = s.from;
    if (is_in(q) || geom::point_on_segment(q, parts[0]) || geom::point_on_segment(q, parts[1])) clear = false;
  });
  sub_.edge_tree().visit(old, 2.0 * margin, [&](std::uint32_t item, const Segment& other) {
    if (!clear || EdgeId(item) == e) return;
    if (is_in(other.from) || is_in(other.to)) clear = false;
    for (const Segment& part : parts) {
      const geom::Intersection meet = geom::intersect(part, other);
      // A crossing may be rounded to an end without being there.
      const bool at_old_end = !meet.start.proper() && (meet.start.point == old.from || meet.start.point == old.to);
      if (meet.kind == IntersectionKind::None || (meet.kind == IntersectionKind::Point && at_old_end)) continue;
      clear = false;
    }
  });
  if (clear && wide) sub_.set_clear(e);
  return clear;
}

void Insertion::connect(std::uint32_t index) {
  const VertexId from = pieces_[index].from;
  const VertexId to = pieces_[index].to;
  const Corner corner = sub_.corner(from, sub_.point(to));
  const FaceId in = sub_.face(corner);
  const HalfEdgeId h = sub_.connect(corner, sub_.corner(to, sub_.point(from)));
  const std::uint32_t attribute = pieces_[index].attribute;
  if (attribute != none) sub_.attribute(Subdivision::edge(h)) = attributes_[attribute];
  own(index, h);
  pieces_[index].fresh = true;
  joined(h, in);
  owners_.placed(h, pieces_[index].sides);
}

/// Takes note of the face that h, new in face `in`, may have closed.
void Insertion::joined(HalfEdgeId h, FaceId in) {
  for (const FaceId f : {sub_.face(h), sub_.face(Subdivision::twin(h))}) {
    if (f == in) continue;
    faces_.push_back(f);
    owners_.divided(in, f);
  }
}

void Insertion::expand(std::uint32_t root, std::vector<HalfEdgeId>& path) const {
  if (pieces_[root].half_edge.valid()) {
    path.push_back(pieces_[root].half_edge);
    return;
  }
  std::vector<Part> open{{root, false}};
  while (!open.empty()) {
    const Part part = open.back();
    open.pop_back();
    const Piece& piece = pieces_[part.piece];
    if (piece.half_edge.valid()) {
      path.push_back(part.reversed ? Subdivision::twin(piece.half_edge) : piece.half_edge);
      continue;
    }
    for (std::uint32_t i = 0; i < piece.part_count; ++i) {
      const Part& p = parts_[piece.first_part + (part.reversed ? i : piece.part_count - 1 - i)];
      open.push_back({p.piece, p.reversed != part.reversed});
    }
  }
}

}  // namespace dobra::topo
