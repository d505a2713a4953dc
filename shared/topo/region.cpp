// 1. All rings go into a subdivision; the path of each tells by how much the winding number differs across its edges.
// 2. From the unbounded face, which has 0, every face gets its number.
// 3. Edges between an inside face and another one are walked round, keeping to the same area; walks are parted where
//    they pass a vertex twice. Faces that share an edge are one area, with one contour.

#include "shared/topo/region.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <unordered_map>

#include "shared/topo/insert.h"

namespace dobra::topo {

using base::Result;
using geom::Polyline;

namespace {

class Tracer {
 public:
  /// Stops early once `progress` is cancelled.
  Tracer(const Subdivision& sub, std::span<const std::vector<HalfEdgeId>> paths, Inside inside,
         const base::Progress& progress)
      : sub_(sub), inside_(inside), progress_(progress) {
    for (const auto& path : paths) {
      for (const HalfEdgeId h : path) step_[Subdivision::edge(h).index()] += forward(h) ? 1 : -1;
    }
    number_faces();
    find_areas();
  }

  Result<std::vector<Polyline>> rings() {
    for (const EdgeId e : sub_.edges()) {
      DOBRA_TRY_VOID(progress_.check());
      for (const HalfEdgeId h : {Subdivision::half_edge(e), Subdivision::twin(Subdivision::half_edge(e))}) {
        if (is_border(h) && !walked_[h.index()]) walk(h);
      }
    }
    std::vector<Polyline> rings;
    for (std::size_t i = 0; i < contours_.size(); ++i) {
      if (contours_[i].points.empty()) continue;
      rings.push_back(std::move(contours_[i]));
      std::move(holes_[i].begin(), holes_[i].end(), std::back_inserter(rings));
    }
    return rings;
  }

 private:
  static bool forward(HalfEdgeId h) { return Subdivision::half_edge(Subdivision::edge(h)) == h; }

  [[nodiscard]] bool is_inside(FaceId f) const {
    const int winding = winding_.at(f.index());
    return inside_ == Inside::Odd ? winding % 2 != 0 : winding > 0;
  }
  [[nodiscard]] bool is_border(HalfEdgeId h) const {
    return is_inside(sub_.face(h)) && !is_inside(sub_.face(Subdivision::twin(h)));
  }

  /// Calls visit(half-edge of f) for all of its loops.
  template <class Visit>
  void round(FaceId f, const Visit& visit) const {
    for (const LoopId loop : sub_.loops(f)) {
      for (const HalfEdgeId h : sub_.half_edges(loop)) visit(h);
    }
  }

  void number_faces() {
    winding_[Subdivision::unbounded().index()] = 0;
    std::vector<FaceId> open{Subdivision::unbounded()};
    while (!open.empty() && !progress_.cancelled()) {
      const FaceId f = open.back();
      open.pop_back();
      round(f, [&](HalfEdgeId h) {
        const FaceId other = sub_.face(Subdivision::twin(h));
        const auto found = step_.find(Subdivision::edge(h).index());
        const int rise = found == step_.end() ? 0 : forward(h) ? found->second : -found->second;  // left over right
        if (winding_.emplace(other.index(), winding_.at(f.index()) - rise).second) open.push_back(other);
      });
    }
  }

  void find_areas() {
    for (const FaceId start : sub_.faces()) {
      if (progress_.cancelled()) return;  // faces may have no number
      if (!is_inside(start) || area_.contains(start.index())) continue;
      const std::size_t number = contours_.size();
      contours_.emplace_back();
      holes_.emplace_back();
      area_[start.index()] = number;
      std::vector<FaceId> open{start};
      while (!open.empty()) {
        const FaceId f = open.back();
        open.pop_back();
        round(f, [&](HalfEdgeId h) {
          const FaceId other = sub_.face(Subdivision::twin(h));
          if (is_inside(other) && area_.emplace(other.index(), number).second) open.push_back(other);
        });
      }
    }
  }

  void walk(HalfEdgeId start) {
    const std::size_t area = area_.at(sub_.face(start).index());
    std::vector<VertexId> way;
    std::unordered_map<std::size_t, std::size_t> passed;  // vertex -> its place on the way
    HalfEdgeId h = start;
    do {
      walked_[h.index()] = true;
      const VertexId v = sub_.origin(h);
      if (const auto found = passed.find(v.index()); found != passed.end()) {
        add_ring(area, {way.begin() + static_cast<std::ptrdiff_t>(found->second), way.end()});
        for (std::size_t k = found->second + 1; k < way.size(); ++k) passed.erase(way[k].index());
        way.resize(found->second);
      }
      passed[v.index()] = way.size();
      way.push_back(v);
      h = sub_.next(h);
      while (!is_border(h)) h = sub_.next(Subdivision::twin(h));
    } while (h != start);
    add_ring(area, way);
  }

  void add_ring(std::size_t area, std::vector<VertexId> way) {
    Polyline ring{{}, true};
    double reach = 0.0;
    for (const VertexId v : way) {
      const geom::Point p = sub_.point(v);
      ring.points.push_back(p);
      reach = std::max({reach, std::abs(p.x), std::abs(p.y)});
    }
    if (ring.points.size() < 3) return;
    const double enclosed = geom::signed_area(ring);
    if (!(std::abs(enclosed) > 0x1p-48 * reach * geom::length(ring))) return;
    if (enclosed > 0.0) {
      contours_[area] = std::move(ring);
    } else {
      holes_[area].push_back(std::move(ring));
    }
  }

  const Subdivision& sub_;
  Inside inside_;
  const base::Progress& progress_;
  std::unordered_map<std::size_t, int> step_;     ///< By edge: left of its first half-edge less right of it.
  std::unordered_map<std::size_t, int> winding_;  ///< By face.
  std::unordered_map<std::size_t, std::size_t> area_;
  std::unordered_map<std::size_t, bool> walked_;
  std::vector<Polyline> contours_;
  std::vector<std::vector<Polyline>> holes_;
};

}  // namespace

Result<std::vector<Polyline>> region(std::span<const Polyline> rings, Inside inside, const base::Progress& progress) {
  Subdivision sub;
  DOBRA_TRY(const auto paths, insert(sub, rings, progress));
  return Tracer(sub, paths, inside, progress).rings();
}

}  // namespace dobra::topo
