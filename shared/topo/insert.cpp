#include "shared/topo/insert.h"

#include <algorithm>
#include <cmath>

#include "shared/topo/insertion.h"

namespace dobra::topo {

using base::Error;
using base::ErrorCode;
using base::Result;
using geom::Point;
using geom::Segment;

namespace {

/// Beyond this, lengths could overflow.
constexpr double greatest_coordinate = 0x1p500;

base::Place place_of(Point p) {
  base::Place place;
  place.x = p.x;
  place.y = p.y;
  return place;
}

Result<void> check_finite(Point p) {
  if (!geom::is_finite(p)) {
    return Error{ErrorCode::NotFinite, "a coordinate is not a finite number; remove or correct the point"};
  }
  if (std::max(std::abs(p.x), std::abs(p.y)) > greatest_coordinate) {
    return Error{ErrorCode::NotFinite, "a coordinate is beyond 3e150; use larger units", place_of(p)};
  }
  return {};
}

}  // namespace

Result<VertexId> insert(Subdivision& sub, Point p) {
  DOBRA_TRY_VOID(check_finite(p));
  return Insertion(sub).vertex(p);
}

Result<Inserted> insert(Subdivision& sub, const Segment& segment) {
  return insert(sub, geom::Polyline{{segment.from, segment.to}, false});
}

namespace {

Result<void> check(const geom::Polyline& curve) {
  for (const Point p : curve.points) DOBRA_TRY_VOID(check_finite(p));
  const bool moves =
      std::any_of(curve.points.begin(), curve.points.end(), [&](Point p) { return p != curve.points[0]; });
  if (moves) return {};
  Error error{ErrorCode::DegenerateCurve, "a curve of zero length cannot be inserted; give it two distinct points"};
  if (!curve.points.empty()) error.place = place_of(curve.points.front());
  return error;
}

Result<void> lead(Subdivision& sub, Insertion& insertion, const geom::Polyline& curve, const base::Progress& progress) {
  VertexId at = insertion.vertex(curve.points.front());
  for (std::size_t i = 1; i < curve.points.size() + (curve.closed ? 1 : 0); ++i) {
    DOBRA_TRY_VOID(progress.check());
    const Point to = curve.points[i % curve.points.size()];
    if (to != sub.point(at)) at = insertion.advance(at, to);
  }
  return {};
}

}  // namespace

Result<Inserted> insert(Subdivision& sub, const geom::Polyline& curve) {
  DOBRA_TRY_VOID(check(curve));
  Insertion insertion(sub);
  DOBRA_TRY_VOID(lead(sub, insertion, curve, {}));
  return insertion.finish();
}

Result<std::vector<std::vector<HalfEdgeId>>> insert(Subdivision& sub, std::span<const geom::Polyline> curves,
                                                    const base::Progress& progress) {
  for (const geom::Polyline& curve : curves) DOBRA_TRY_VOID(check(curve));
  Insertion insertion(sub);
  std::vector<std::size_t> begins;
  for (const geom::Polyline& curve : curves) {
    begins.push_back(insertion.root_count());
    DOBRA_TRY_VOID(lead(sub, insertion, curve, progress));
  }
  begins.push_back(insertion.root_count());
  static_cast<void>(insertion.finish());
  std::vector<std::vector<HalfEdgeId>> paths;
  for (std::size_t i = 0; i < curves.size(); ++i) paths.push_back(insertion.path(begins[i], begins[i + 1]));
  return paths;
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
