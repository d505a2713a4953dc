#pragma once
// The contours of faces of an arrangement. Page: docs/algorithms/units.md

#include <set>
#include <vector>

#include "recon/section/arrangement.h"

namespace recon::section {

/// The boundary of the faces, for which and no others `within` holds, without edges that have them on both sides:
/// anticlockwise, holes clockwise.
template <class Within>
std::vector<geom::Polyline> contours_round(const Arrangement& arrangement, const std::vector<topo::FaceId>& faces,
                                           Within&& within) {
  const topo::Subdivision& sub = arrangement.subdivision();
  const auto bounds = [&](topo::HalfEdgeId h) {
    return within(sub.face(h)) && !within(sub.face(topo::Structure::twin(h)));
  };
  std::vector<geom::Polyline> contours;
  std::set<topo::HalfEdgeId> used;
  for (const topo::FaceId f : faces) {
    for (const topo::LoopId loop : sub.loops(f)) {
      for (const topo::HalfEdgeId start : sub.half_edges(loop)) {
        if (!bounds(start) || used.contains(start)) continue;
        geom::Polyline contour{{}, true};
        topo::HalfEdgeId h = start;
        do {
          used.insert(h);
          arrangement.append(h, contour.points);
          h = sub.next(h);
          while (!bounds(h)) h = sub.next(topo::Structure::twin(h));
        } while (h != start);
        contours.push_back(std::move(contour));
      }
    }
  }
  return contours;
}

/// Of one face.
inline std::vector<geom::Polyline> contours_of(const Arrangement& arrangement, topo::FaceId face) {
  return contours_round(arrangement, {face}, [face](topo::FaceId other) { return other == face; });
}

}  // namespace recon::section
