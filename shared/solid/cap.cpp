#include "shared/solid/cap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "shared/topo/adjacency.h"

namespace dobra::solid {
namespace {

using geom::Sign;
using topo::Subdivision;

class CapMaker {
 public:
  CapMaker(const Section& section, const CapOptions& options) : plane_(section.plane), options_(options) {
    cap_.frame = section.frame;
    find_sides();
  }

  Cap make() {
    if (plane_.edge_count() == 0) return std::move(cap_);
    make_lines();
    make_regions();
    return std::move(cap_);
  }

 private:
  [[nodiscard]] std::uint32_t solid(topo::HalfEdgeId h) const { return solids_[plane_.face(h).index()]; }
  [[nodiscard]] bool bounds(topo::HalfEdgeId h) const { return solid(h) != solid(Subdivision::twin(h)); }
  [[nodiscard]] const std::vector<std::string>& names(topo::HalfEdgeId h) const {
    static const std::vector<std::string> no_names;
    const std::any& attribute = plane_.attribute(Subdivision::edge(h));
    return attribute.has_value() ? std::any_cast<const SectionLine&>(attribute).names : no_names;
  }
  /// The half-edge of an edge that has the lower number of a solid on its left.
  [[nodiscard]] topo::HalfEdgeId directed(topo::EdgeId e) const {
    const topo::HalfEdgeId h = Subdivision::half_edge(e);
    return solid(h) < solid(Subdivision::twin(h)) ? h : Subdivision::twin(h);
  }

  void find_sides() {
    for (const topo::FaceId f : plane_.faces()) {
      if (f.index() >= solids_.size()) solids_.resize(f.index() + 1, outside);
      const std::any& attribute = plane_.attribute(f);
      if (attribute.has_value()) solids_[f.index()] = std::any_cast<const SectionArea&>(attribute).solid;
    }
    geom::Box box;
    for (const topo::VertexId v : plane_.vertices()) box.add(plane_.point(v));
    tolerance_ = plane_.edge_count() == 0 ? 0.0 : options_.straight * box.diagonal();
  }

  /// The line goes on through the end of h, and how; none where it ends.
  [[nodiscard]] topo::HalfEdgeId onwards(topo::HalfEdgeId h) const {
    topo::HalfEdgeId other;
    std::size_t count = 0;
    for (const topo::HalfEdgeId leaving : plane_.round(plane_.target(h))) {
      if (!bounds(leaving)) continue;
      ++count;
      if (leaving != Subdivision::twin(h)) other = leaving;
    }
    if (count != 2) return {};
    const bool same = solid(other) == solid(h) && solid(Subdivision::twin(other)) == solid(Subdivision::twin(h)) &&
                      names(other) == names(h);
    return same ? other : topo::HalfEdgeId();
  }
  [[nodiscard]] topo::HalfEdgeId backwards(topo::HalfEdgeId h) const {
    const topo::HalfEdgeId back = onwards(Subdivision::twin(h));
    return back.valid() ? Subdivision::twin(back) : back;
  }

  void make_lines() {
    std::vector<char> used;
    for (const topo::EdgeId e : plane_.edges()) {
      if (e.index() >= used.size()) used.resize(e.index() + 1, 0);
    }
    for (const topo::EdgeId e : plane_.edges()) {
      if (used[e.index()] != 0 || !bounds(Subdivision::half_edge(e))) continue;
      topo::HalfEdgeId first = directed(e);
      for (topo::HalfEdgeId back = backwards(first); back.valid() && back != directed(e); back = backwards(back))
        first = back;
      CapLine line{{}, names(first), solid(first), solid(Subdivision::twin(first))};
      topo::HalfEdgeId h = first;
      do {
        used[Subdivision::edge(h).index()] = 1;
        line.line.points.push_back(plane_.point(plane_.origin(h)));
        const topo::HalfEdgeId next = onwards(h);
        if (!next.valid()) line.line.points.push_back(plane_.point(plane_.target(h)));
        h = next;
      } while (h.valid() && h != first);
      line.line.closed = h.valid();
      straighten(line.line);
      cap_.lines.push_back(std::move(line));
    }
  }

  /// Leaves out what lies on the way from the corner that stays before it to the next one.
  void straighten(geom::Polyline& line) const {
    std::vector<geom::Point>& points = line.points;
    const std::size_t least = line.closed ? 3 : 2;
    if (line.closed) {
      // It begins at a corner that stays: the lowest of those farthest to the left.
      const auto corner = std::min_element(points.begin(), points.end(), [](geom::Point a, geom::Point b) {
        return a.x != b.x ? a.x < b.x : a.y < b.y;
      });
      std::rotate(points.begin(), corner, points.end());
    }
    std::vector<geom::Point> kept{points.front()};
    for (std::size_t i = 1; i < points.size(); ++i) {
      const bool last = i + 1 == points.size();
      if (last && !line.closed) {
        kept.push_back(points[i]);
        break;
      }
      const geom::Point next = last ? points.front() : points[i + 1];
      const bool ahead = dot(points[i] - kept.back(), next - points[i]) > 0.0;
      if (!ahead || distance(geom::Segment{kept.back(), next}, points[i]) > tolerance_) kept.push_back(points[i]);
    }
    if (kept.size() >= least) points = std::move(kept);
  }

  void make_regions() {
    // Faces with one solid on both sides of an edge are one region.
    std::vector<std::uint32_t> group(solids_.size(), none);
    std::vector<char> used;
    for (const topo::FaceId f : plane_.faces()) {
      if (solids_[f.index()] == outside || group[f.index()] != none) continue;
      const auto number = static_cast<std::uint32_t>(cap_.regions.size());
      cap_.regions.emplace_back().solid = solids_[f.index()];
      group[f.index()] = number;
      std::vector<topo::FaceId> open{f};
      while (!open.empty()) {
        const topo::FaceId at = open.back();
        open.pop_back();
        cap_.regions[number].area += topo::area(plane_, at);
        for (const topo::LoopId loop : plane_.loops(at)) {
          for (const topo::HalfEdgeId h : plane_.half_edges(loop)) {
            const topo::FaceId beyond = plane_.face(Subdivision::twin(h));
            if (bounds(h) || group[beyond.index()] != none) continue;
            group[beyond.index()] = number;
            open.push_back(beyond);
          }
        }
      }
    }
    std::vector<std::size_t> loops(cap_.regions.size(), 0);
    for (const topo::EdgeId e : plane_.edges()) {
      for (const topo::HalfEdgeId start : {Subdivision::half_edge(e), Subdivision::twin(Subdivision::half_edge(e))}) {
        const std::uint32_t of = group[plane_.face(start).index()];
        if (of == none || !bounds(start)) continue;
        if (start.index() < used.size() && used[start.index()] != 0) continue;
        ++loops[of];
        topo::HalfEdgeId h = start;
        do {
          if (h.index() >= used.size()) used.resize(h.index() + 1, 0);
          used[h.index()] = 1;
          cap_.regions[of].sides.push_back(plane_.segment(h));
          h = plane_.next(h);
          while (!bounds(h)) h = plane_.next(Subdivision::twin(h));
        } while (h != start);
      }
    }
    for (std::size_t i = 0; i < loops.size(); ++i) cap_.regions[i].holes = loops[i] - 1;
  }

  const Subdivision& plane_;
  CapOptions options_;
  std::vector<std::uint32_t> solids_;  // of each face
  double tolerance_ = 0.0;
  Cap cap_;
};

/// What the boundary of one shell has seen of the plane.
struct Seen {
  bool below = false, above = false;
  Contact most = Contact::Nothing;
};

}  // namespace

Cap cap_of(const Section& section, const CapOptions& options) { return CapMaker(section, options).make(); }

base::Result<PlaneContact> contact_with(std::span<const Solid> solids, const CutPlane& plane) {
  DOBRA_TRY_VOID(frame_of(plane));
  PlaneContact contact;
  for (const Solid& solid : solids) {
    const Soup& all = solid.boundary().soup;
    std::vector<Seen> shells(solid.shell_count());
    Space space;
    const PlaneId cut = space.add(Plane{{geom::Point3{plane.a, plane.b, plane.c}, {}, {}}, plane.d});
    std::vector<Sign> side(all.space.point_count(), Sign::Zero);
    for (std::size_t p = 0; p < side.size(); ++p) side[p] = space.side(cut, space.add(all.space, PointId(p)));
    for (std::size_t f = 0; f < all.facets.size(); ++f) {
      Seen& seen = shells[solid.shell(FaceId(f)).index()];
      bool whole = true;
      all.visit_edges(all.facets[f], [&](std::uint32_t i, std::uint32_t j) {
        const Sign here = side[all.corners[i].index()];
        seen.below = seen.below || here == Sign::Negative;
        seen.above = seen.above || here == Sign::Positive;
        whole = whole && here == Sign::Zero;
        if (here != Sign::Zero) return;
        seen.most = std::max(seen.most, side[all.corners[j].index()] == Sign::Zero ? Contact::Edge : Contact::Vertex);
      });
      if (!whole) continue;
      seen.most = Contact::Face;
      contact.in_face = true;
    }
    for (const Seen& seen : shells)
      contact.most = std::max(contact.most, seen.below && seen.above ? Contact::Volume : seen.most);
  }
  return contact;
}

}  // namespace dobra::solid
