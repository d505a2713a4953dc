#include "shared/surf/trim/rings.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace dobra::surf::trim {

using geom::Box;
using geom::Point;

/// Points along an edge, its last one left out.
void add_points(const ChartEdge& edge, Ring& points) {
  std::vector<double> at{edge.from};
  for (const double t : edge.curve.breaks()) {
    if (t > std::min(edge.from, edge.to) && t < std::max(edge.from, edge.to)) at.push_back(t);
  }
  at.push_back(edge.to);
  if (edge.from < edge.to) {
    std::sort(at.begin(), at.end());
  } else {
    std::sort(at.begin(), at.end(), std::greater<>());
  }
  constexpr int count = 24;
  for (std::size_t k = 0; k + 1 < at.size(); ++k) {
    for (int i = 0; i < count; ++i) points.push_back(edge.at(std::lerp(at[k], at[k + 1], 1.0 * i / count)));
  }
}

std::vector<Ring> rings_of(const TrimmedSurface& face) {
  std::vector<Ring> rings;
  for (const ChartLoop& loop : face.loops) {
    rings.emplace_back();
    for (const ChartEdge& edge : loop.edges) add_points(edge, rings.back());
  }
  return rings;
}

double area_of(const Ring& ring) {
  double twice = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i)
    twice += cross(ring[i] - ring.front(), ring[(i + 1) % ring.size()] - ring.front());
  return 0.5 * twice;
}

/// Where a line of constant v meets rings, by u.
std::vector<double> meets(const std::vector<Ring>& rings, double v) {
  std::vector<double> at;
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point p = ring[i], q = ring[(i + 1) % ring.size()];
      if ((p.y <= v) != (q.y <= v)) at.push_back(p.x + (v - p.y) / (q.y - p.y) * (q.x - p.x));
    }
  }
  std::sort(at.begin(), at.end());
  return at;
}

/// A point well inside: the middle of the longest way through it of many.
Point inner_point(const TrimmedSurface& face) {
  const std::vector<Ring> rings = rings_of(face);
  Box box;
  for (const Ring& ring : rings) box.add(geom::box_of(ring));
  Point best = box.centre();
  double longest = -1.0;
  constexpr int lines = 31;
  for (int i = 0; i < lines; ++i) {
    const double v = std::lerp(box.low.y, box.high.y, (i + 0.4871) / lines);
    const std::vector<double> at = meets(rings, v);
    for (std::size_t k = 0; k + 1 < at.size(); k += 2) {
      const double way = at[k + 1] - at[k];
      if (way > longest) longest = way, best = {std::midpoint(at[k], at[k + 1]), v};
    }
  }
  return best;
}

}  // namespace dobra::surf::trim
