#pragma once
// The contours of faces of an arrangement. Page: docs/algorithms/units.md

#include <set>
#include <vector>

#include "recon/section/arrangement.h"

namespace recon::section {

/// The boundary of the faces, for which and no others `within` holds, without edges that have them on both sides: loops
/// of half-edges, the faces on their left.
template <class Within>
std::vector<std::vector<topo::HalfEdgeId>> loops_round(const Arrangement& arrangement,
                                                       const std::vector<topo::FaceId>& faces, Within&& within) {
  const topo::Subdivision& sub = arrangement.subdivision();
  const auto bounds = [&](topo::HalfEdgeId h) {
    return within(sub.face(h)) && !within(sub.face(topo::Structure::twin(h)));
  };
  std::vector<std::vector<topo::HalfEdgeId>> loops;
  std::set<topo::HalfEdgeId> used;
  for (const topo::FaceId f : faces) {
    for (const topo::LoopId loop : sub.loops(f)) {
      for (const topo::HalfEdgeId start : sub.half_edges(loop)) {
        if (!bounds(start) || used.contains(start)) continue;
        std::vector<topo::HalfEdgeId>& round = loops.emplace_back();
        topo::HalfEdgeId h = start;
        do {
          used.insert(h);
          round.push_back(h);
          h = sub.next(h);
          while (!bounds(h)) h = sub.next(topo::Structure::twin(h));
        } while (h != start);
      }
    }
  }
  return loops;
}

/// Their courses: anticlockwise, holes clockwise.
template <class Within>
std::vector<geom::Polyline> contours_round(const Arrangement& arrangement, const std::vector<topo::FaceId>& faces,
                                           Within&& within) {
  std::vector<geom::Polyline> contours;
  for (const auto& loop : loops_round(arrangement, faces, within)) {
    geom::Polyline& contour = contours.emplace_back(geom::Polyline{{}, true});
    for (const topo::HalfEdgeId h : loop) arrangement.append(h, contour.points);
  }
  return contours;
}

/// Of one face.
inline std::vector<geom::Polyline> contours_of(const Arrangement& arrangement, topo::FaceId face) {
  return contours_round(arrangement, {face}, [face](topo::FaceId other) { return other == face; });
}

}  // namespace recon::section
