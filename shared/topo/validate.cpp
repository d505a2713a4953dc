#include "shared/topo/validate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "shared/geom/predicates.h"

namespace dobra::topo {

using geom::orient2d;
using geom::Point;
using geom::Sign;

namespace {

/// Wide enough that products of doubles are exact and areas of slivers keep their sign.
__extension__ using Wide = __float128;

int sign(Point a, Point b, Point c) { return static_cast<int>(orient2d(a, b, c)); }

class Check {
 public:
  explicit Check(const Subdivision& s) : s_(s) {}

  std::vector<std::string> run() {
    links();
    if (!wrong_.empty()) return wrong_;  // walks may not end
    labels();
    euler();
    rotation();
    crossings();
    nesting();
    return wrong_;
  }

 private:
  template <class... Args>
  void fail(fmt::format_string<Args...> text, Args&&... args) {
    if (wrong_.size() < 20) wrong_.push_back(fmt::format(text, std::forward<Args>(args)...));
  }

  void links() {
    for (const EdgeId e : s_.edges()) {
      for (const std::size_t side : {2 * e.index(), 2 * e.index() + 1}) {
        const HalfEdgeId h(side);
        if (Subdivision::twin(Subdivision::twin(h)) != h) fail("h{}: twin of twin is another", side);
        if (s_.next(s_.previous(h)) != h || s_.previous(s_.next(h)) != h) fail("h{}: next and previous disagree", side);
        if (s_.origin(s_.next(h)) != s_.target(h)) fail("h{}: the next one does not start where it ends", side);
        if (s_.loop(s_.next(h)) != s_.loop(h)) fail("h{}: loop label changes on the way", side);
        if (!s_.contains(s_.origin(h)) || !s_.contains(s_.face(h))) fail("h{}: dead vertex or face", side);
        if (s_.point(s_.origin(h)) == s_.point(s_.target(h))) fail("e{}: zero length", e.index());
      }
    }
  }

  void labels() {
    std::size_t walked = 0;
    std::size_t in_faces = 0;
    for (const FaceId f : s_.faces()) {
      for (const LoopId l : s_.loops(f)) {
        ++in_faces;
        if (s_.face(l) != f) fail("l{}: not labelled with its face", l.index());
        const auto around = s_.half_edges(l);
        walked += around.size();
        for (const HalfEdgeId h : around) {
          if (s_.loop(h) != l) fail("h{}: not labelled with its loop", h.index());
        }
        if (around.empty() && (!s_.contains(s_.lone_vertex(l)) || s_.lone_loop(s_.lone_vertex(l)) != l)) {
          fail("l{}: neither edges nor an isolated vertex", l.index());
        }
      }
      const LoopId outer = s_.outer_loop(f);
      if (outer.valid() == (f == Subdivision::unbounded())) fail("f{}: outer loop missing or too many", f.index());
      if (outer.valid() && s_.face(outer) != f) fail("f{}: outer loop belongs to another", f.index());
    }
    if (walked != 2 * s_.edge_count()) fail("{} half-edges in loops, {} edges", walked, s_.edge_count());
    if (in_faces != s_.loop_count()) fail("{} loops in faces, {} loops", in_faces, s_.loop_count());
    for (const VertexId v : s_.vertices()) {
      const HalfEdgeId h = s_.leaving(v);
      if (h.valid() == s_.lone_loop(v).valid()) fail("v{}: both isolated and not, or neither", v.index());
      if (h.valid() && s_.origin(h) != v) fail("v{}: its half-edge starts elsewhere", v.index());
      if (s_.vertex_at(s_.point(v)) != v) fail("v{}: not found at its place", v.index());
    }
  }

  void euler() {
    std::map<VertexId, VertexId> parent;
    for (const VertexId v : s_.vertices()) parent[v] = v;
    const auto root = [&](VertexId v) {
      while (parent[v] != v) v = parent[v] = parent[parent[v]];
      return v;
    };
    std::size_t components = s_.vertex_count();
    for (const EdgeId e : s_.edges()) {
      const VertexId a = root(s_.origin(HalfEdgeId(2 * e.index())));
      const VertexId b = root(s_.origin(HalfEdgeId(2 * e.index() + 1)));
      if (a != b) --components;
      parent[a] = b;
    }
    if (components != s_.component_count()) fail("{} components, {} counted", components, s_.component_count());
    if (s_.vertex_count() + s_.face_count() != s_.edge_count() + 1 + components) {
      fail("Euler: V {} - E {} + F {} != 1 + C {}", s_.vertex_count(), s_.edge_count(), s_.face_count(), components);
    }
  }

  /// Round each vertex the directions must turn exactly once.
  void rotation() {
    for (const VertexId v : s_.vertices()) {
      const auto around = s_.round(v);
      std::size_t wraps = 0;
      const Point o = s_.point(v);
      const auto upper = [&](Point p) { return p.y > o.y || (p.y == o.y && p.x > o.x); };
      const auto less = [&](Point p, Point q) {
        if (upper(p) != upper(q)) return upper(p);
        return sign(o, p, q) > 0;
      };
      for (std::size_t i = 0; i < around.size(); ++i) {
        const Point p = s_.point(s_.target(around[i]));
        const Point q = s_.point(s_.target(around[(i + 1) % around.size()]));
        if (!less(p, q)) ++wraps;
      }
      if (!around.empty() && wraps != 1) fail("v{}: edges not in angular order", v.index());
    }
  }

  /// Edges may have only vertices in common: compared as closed segments, exactly.
  void crossings() {
    struct Bar {
      Point a, b;
      std::size_t id;
    };
    std::vector<Bar> bars;
    for (const EdgeId e : s_.edges()) {
      const auto g = s_.segment(e);
      bars.push_back({std::min(g.from, g.to), std::max(g.from, g.to), e.index()});
    }
    for (const VertexId v : s_.vertices()) {
      if (s_.lone_loop(v).valid()) bars.push_back({s_.point(v), s_.point(v), 1000000000 + v.index()});
    }
    std::sort(bars.begin(), bars.end(), [](const Bar& p, const Bar& q) { return p.a < q.a; });
    for (std::size_t i = 0; i < bars.size(); ++i) {
      for (std::size_t j = i + 1; j < bars.size() && bars[j].a.x <= bars[i].b.x; ++j) {
        const Bar& p = bars[i];
        const Bar& q = bars[j];
        if (std::max(p.a.y, p.b.y) < std::min(q.a.y, q.b.y) || std::max(q.a.y, q.b.y) < std::min(p.a.y, p.b.y))
          continue;
        if (meet_wrongly(p.a, p.b, q.a, q.b)) fail("e{} and e{} meet outside a common vertex", p.id, q.id);
      }
    }
  }

  static bool inside(Point a, Point b, Point p) { return sign(a, b, p) == 0 && a < p && p < b; }
  static bool meet_wrongly(Point a, Point b, Point c, Point d) {
    if (inside(a, b, c) || inside(a, b, d) || inside(c, d, a) || inside(c, d, b)) return true;
    if (a == c && b == d) return true;
    return sign(a, b, c) * sign(a, b, d) < 0 && sign(c, d, a) * sign(c, d, b) < 0;
  }

  /// Outer loops have positive area; every other loop lies in its face and in no smaller one.
  void nesting() {
    Wide all_areas = 0;
    for (const FaceId f : s_.faces()) {
      for (const LoopId l : s_.loops(f)) {
        Wide doubt = 0;
        const Wide area = twice_area(l, doubt);
        slack_ += doubt;
        const bool anticlockwise = area > doubt || (area >= -doubt && turns_left(l));
        if (l == s_.outer_loop(f) && !anticlockwise) fail("l{}: outer loop with area {}", l.index(), double(area));
        if (l != s_.outer_loop(f) && anticlockwise) fail("l{}: hole with area {}", l.index(), double(area));
        all_areas += area;  // the holes of the unbounded face run clockwise: the sum over all loops vanishes
        if (l != s_.outer_loop(f)) holes(f, l);
      }
    }
    if (all_areas > slack_ || -all_areas > slack_)
      fail("areas of faces add up to {} beyond the outline", double(all_areas));
  }

  /// @param doubt  what rounding can have added to it.
  Wide twice_area(LoopId l, Wide& doubt) {
    Wide sum = 0;
    Wide size = 0;
    const auto around = s_.half_edges(l);
    if (around.empty()) return 0;
    const Point o = s_.point(s_.origin(around[0]));
    for (const HalfEdgeId h : around) {
      const Point a = s_.point(s_.origin(h));
      const Point b = s_.point(s_.target(h));
      const Wide left = (Wide(a.x) - o.x) * (Wide(b.y) - o.y);
      const Wide right = (Wide(a.y) - o.y) * (Wide(b.x) - o.x);
      sum += left - right;
      size += (left < 0 ? -left : left) + (right < 0 ? -right : right);
    }
    doubt = size * 0x1p-106;
    return sum;
  }

  /// Where the area drowns in rounding: at its least point a loop with its face inside never has the far west on its
  /// left.
  bool turns_left(LoopId l) {
    const auto around = s_.half_edges(l);
    if (around.empty()) return false;
    Point west = s_.point(s_.origin(around[0]));
    for (const HalfEdgeId h : around) west = std::min(west, s_.point(s_.origin(h)));
    for (std::size_t i = 0; i < around.size(); ++i) {
      if (s_.point(s_.origin(around[i])) != west) continue;
      const Point in = s_.point(s_.origin(around[(i + around.size() - 1) % around.size()]));
      if (sign(in, west, s_.point(s_.target(around[i]))) <= 0) return false;
    }
    return true;
  }

  bool smaller(LoopId a, LoopId b) {
    Wide doubt_a = 0;
    Wide doubt_b = 0;
    return twice_area(a, doubt_a) + doubt_a < twice_area(b, doubt_b) - doubt_b;
  }

  bool winds(LoopId l, Point p) {
    bool odd = false;
    for (const HalfEdgeId h : s_.half_edges(l)) {
      const auto g = s_.segment(h);
      const Point a = std::min(g.from, g.to);
      const Point b = std::max(g.from, g.to);
      if (a.x <= p.x && p.x < b.x && sign(a, b, p) < 0) odd = !odd;
    }
    return odd;
  }

  void holes(FaceId f, LoopId l) {
    const HalfEdgeId h = s_.first(l);
    const Point p = h.valid() ? s_.point(s_.origin(h)) : s_.point(s_.lone_vertex(l));
    std::set<VertexId> own;
    for (const HalfEdgeId g : s_.half_edges(l)) own.insert(s_.origin(g));
    if (f != Subdivision::unbounded() && !winds(s_.outer_loop(f), p)) fail("l{}: hole outside its face", l.index());
    for (const FaceId other : s_.faces()) {
      if (other == f || other == Subdivision::unbounded()) continue;
      const auto around = s_.half_edges(s_.outer_loop(other));
      const bool touches =
          std::any_of(around.begin(), around.end(), [&](HalfEdgeId g) { return own.contains(s_.origin(g)); });
      if (touches || !winds(s_.outer_loop(other), p)) continue;
      // `other` encloses the hole; it must then enclose f as well.
      if (f == Subdivision::unbounded() || smaller(s_.outer_loop(other), s_.outer_loop(f))) {
        bool in_hole_of_other = false;
        for (const LoopId m : s_.loops(other)) in_hole_of_other |= m != s_.outer_loop(other) && winds(m, p);
        if (!in_hole_of_other) fail("l{}: lies in f{}, a smaller face than its own", l.index(), other.index());
      }
    }
  }

  const Subdivision& s_;
  std::vector<std::string> wrong_;
  Wide slack_ = 0;  // what rounding can add to the sum of all areas
};

}  // namespace

std::vector<std::string> violations(const Subdivision& subdivision) { return Check(subdivision).run(); }

}  // namespace dobra::topo
