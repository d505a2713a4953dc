#pragma once
// Judges offset curves by brute force: plain distances and exact crossings, no code shared with the engine.

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "shared/geom/intersect.h"
#include "shared/geom/polyline.h"
#include "shared/geom/predicates.h"
#include "shared/offset/offset.h"

namespace dobra::support {

/// Distance of two segments that do not cross; 0 if they do.
inline double segment_distance(const geom::Segment& a, const geom::Segment& b) {
  if (geom::intersect(a, b).kind != geom::IntersectionKind::None) return 0.0;
  return std::min(
      {geom::distance(a, b.from), geom::distance(a, b.to), geom::distance(b, a.from), geom::distance(b, a.to)});
}

/// Least distance of any point of `curve` (vertices and edges) from `base`.
inline double least_distance(const geom::Polyline& curve, const geom::Polyline& base) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < curve.segment_count(); ++i) {
    const geom::Segment s = curve.segment(i);
    const geom::Box box = s.box();
    for (std::size_t j = 0; j < base.segment_count(); ++j) {
      const geom::Segment t = base.segment(j);
      if (!box.grown(least).overlaps(t.box())) continue;
      least = std::min(least, segment_distance(s, t));
    }
  }
  return least;
}

/// A curve may touch itself where the input makes distances equal exactly (integer grids).
enum class Touching { Counted, Allowed };

/// Pairs of segments that meet other than neighbours do at their common point.
inline std::size_t crossings(const geom::Polyline& curve, Touching touching = Touching::Counted) {
  std::size_t found = 0;
  const std::size_t count = curve.segment_count();
  for (std::size_t i = 0; i < count; ++i) {
    const geom::Segment s = curve.segment(i);
    const geom::Box box = s.box();
    for (std::size_t j = i + 1; j < count; ++j) {
      const geom::Segment t = curve.segment(j);
      if (!box.overlaps(t.box())) continue;
      const geom::Intersection meet = geom::intersect(s, t);
      if (meet.kind == geom::IntersectionKind::None) continue;
      if (touching == Touching::Allowed && meet.kind == geom::IntersectionKind::Point && !meet.start.proper()) continue;
      const bool neighbours = j == i + 1 || (curve.closed && i == 0 && j + 1 == count);
      if (!neighbours || meet.kind == geom::IntersectionKind::Overlap) ++found;
    }
  }
  return found;
}

inline double distance_to_any(const std::vector<geom::Polyline>& curves, geom::Point p) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& curve : curves) least = std::min(least, geom::distance(curve, p));
  return least;
}

/// Points at distance D on the right side of the base, off its segments, from which no part of the base is nearer: each
/// of them lies on the true offset curve.
inline std::vector<geom::Point> true_points(const geom::Polyline& base, double distance, int per_segment) {
  std::vector<geom::Point> points;
  for (std::size_t i = 0; i < base.segment_count(); ++i) {
    const geom::Segment s = base.segment(i);
    if (s.from == s.to) continue;
    const geom::Vector out = distance * geom::normalised(geom::right_of(s.vector()));
    for (int k = 0; k < per_segment; ++k) {
      const geom::Point p = geom::interpolate(s.from, s.to, (k + 0.5) / per_segment) + out;
      if (geom::distance(base, p) >= distance * (1.0 - 1e-10)) points.push_back(p);
    }
  }
  return points;
}

/// Closed contours of the file formats in data/contours: "n m", points, edges (.txt) or points only (.dat).
inline std::vector<geom::Polyline> read_contours(const std::string& path) {
  std::ifstream in(path);
  std::vector<geom::Polyline> contours;
  if (path.ends_with(".dat")) {
    geom::Polyline contour{{}, true};
    geom::Point p;
    while (in >> p.x >> p.y) contour.points.push_back(p);
    contours.push_back(geom::without_repeated_points(contour));
    return contours;
  }
  std::size_t points = 0;
  std::size_t edges = 0;
  in >> points >> edges;
  std::vector<geom::Point> at(points);
  for (auto& p : at) in >> p.x >> p.y;
  geom::Polyline contour{{}, true};
  std::size_t first = 0;
  std::size_t last = 0;
  for (std::size_t k = 0; k < edges; ++k) {
    std::size_t a = 0;
    std::size_t b = 0;
    in >> a >> b;
    if (contour.points.empty()) first = a;
    if (!contour.points.empty() && a != last) {
      contour = {{}, true};
      first = a;
    }
    contour.points.push_back(at[a]);
    last = b;
    if (b == first) {
      contours.push_back(contour);
      contour.points.clear();
    }
  }
  return contours;
}

}  // namespace dobra::support
