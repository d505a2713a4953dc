#include "quebra/repair/rings.h"

#include <cstdint>
#include <map>
#include <utility>

namespace quebra::repair {

using dobra::geom::Point;
using dobra::geom::Polyline;

std::vector<Ring> find_rings(const std::vector<sketch::Curve>& curves) {
  std::map<Point, std::vector<domain::Domain::Side>> leaving;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    if (!bounds(curves[c]) || closed(curves[c])) continue;
    leaving[point(curves[c], 0.0)].push_back({c, false});
    leaving[point(curves[c], length(curves[c]))].push_back({c, true});
  }
  std::vector<Ring> rings;
  std::vector<std::uint8_t> used(curves.size(), 0);
  for (std::size_t c = 0; c < curves.size(); ++c) {
    if (!bounds(curves[c]) || used[c] != 0) continue;
    Ring ring{{{c, false}}, {}};
    used[c] = 1;
    bool whole = closed(curves[c]);
    const Point start = point(curves[c], 0.0);
    for (domain::Domain::Side side = ring.sides.front(); !whole;) {
      const Point at = point(curves[side.curve], side.backwards ? 0.0 : length(curves[side.curve]));
      whole = at == start;
      const auto& here = leaving.at(at);
      if (whole || here.size() != 2) break;
      side = here[here[0].curve == side.curve ? 1 : 0];
      if (used[side.curve] != 0) break;
      used[side.curve] = 1;
      ring.sides.push_back(side);
    }
    if (whole) rings.push_back(std::move(ring));
  }
  return rings;
}

Point centroid(const Polyline& contour) {
  const Point base = contour.points.front();
  double area = 0.0;
  dobra::geom::Vector moment;
  for (std::size_t i = 0; i < contour.segment_count(); ++i) {
    const auto a = contour.segment(i).from - base, b = contour.segment(i).to - base;
    const double twice = cross(a, b);
    area += twice;
    moment = moment + twice / 3.0 * (a + b);
  }
  return area == 0.0 ? base : base + 1.0 / area * moment;
}

}  // namespace quebra::repair
