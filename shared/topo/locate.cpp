#include "shared/topo/locate.h"

#include <limits>

#include "shared/geom/intersect.h"
#include "shared/geom/predicates.h"
#include "shared/topo/subdivision.h"

namespace dobra::topo {

using geom::Point;
using geom::Segment;
using geom::Sign;

namespace {

/// From left to right. @pre not vertical.
Segment rightwards(const Segment& s) { return s.from.x < s.to.x ? s : Segment{s.to, s.from}; }

/// Of two segments that span a common vertical strip and do not cross: is a below b?
bool below(const Segment& a, const Segment& b) {
  if (a.from.x >= b.from.x) {
    const Sign from = geom::orient2d(b.from, b.to, a.from);
    if (from != Sign::Zero) return from == Sign::Negative;
    return geom::orient2d(b.from, b.to, a.to) == Sign::Negative;
  }
  return !below(b, a);
}

/// A height not below that of the segment at x; used only to leave out what lies higher.
double ceiling(const Segment& s, double x) {
  const double t = (x - s.from.x) / (s.to.x - s.from.x);
  const double slack = 1e-10 * (std::abs(s.from.y) + std::abs(s.to.y)) + 0x1p-1060;
  return std::min(std::max(s.from.y, s.to.y), geom::interpolate(s.from, s.to, t).y + slack);
}

}  // namespace

Location locate(const Subdivision& sub, Point p) {
  if (const auto v = sub.vertex_at(p)) return {Where::Vertex, *v, {}, {}};
  EdgeId on;
  sub.edge_tree().visit(geom::Box{p, p}, [&](std::uint32_t item, const Segment& s) {
    if (geom::point_on_segment(p, s)) on = EdgeId(item);
  });
  if (on.valid()) return {Where::Edge, {}, on, {}};

  // The ray goes up just right of p, so that it meets no vertex; vertical edges do not count.
  EdgeId best;
  Segment best_segment;
  double limit = std::numeric_limits<double>::infinity();
  sub.edge_tree().visit_above(p, limit, [&](std::uint32_t item, const Segment& edge) {
    if (edge.from.x == edge.to.x) return limit;
    const Segment s = rightwards(edge);
    if (!(s.from.x <= p.x && p.x < s.to.x) || geom::orient2d(s.from, s.to, p) != Sign::Negative) return limit;
    if (!best.valid() || below(s, best_segment)) {
      best = EdgeId(item);
      best_segment = s;
      limit = ceiling(s, p.x);
    }
    return limit;
  });
  if (!best.valid()) return {Where::Face, {}, {}, Subdivision::unbounded()};
  const HalfEdgeId h = Subdivision::half_edge(best);
  // The side that runs leftwards has what is below it to its left.
  const bool leftwards = sub.point(sub.origin(h)).x > sub.point(sub.target(h)).x;
  return {Where::Face, {}, {}, sub.face(leftwards ? h : Subdivision::twin(h))};
}

}  // namespace dobra::topo
