#include "quebra/sketch/enclosed.h"

#include <algorithm>
#include <vector>

#include "shared/geom/box.h"
#include "shared/geom/spatial_index.h"

namespace quebra::sketch {

using dobra::geom::Box;
using dobra::geom::Point;
using dobra::geom::Segment;

double area_of(std::span<const Segment> sides) {
  double twice = 0.0;
  const Point origin = sides.front().from;
  for (const Segment& side : sides) twice += cross(side.from - origin, side.to - origin);
  return 0.5 * twice;
}

// Of the middles of what horizontal lines have inside, the farthest from all sides.
Point inner_point(std::span<const Segment> sides) {
  constexpr int lines = 15;
  std::vector<Box> boxes;
  for (const Segment& side : sides) boxes.push_back(side.box());
  const dobra::geom::SpatialIndex index(boxes);
  const Box box = index.box();
  Point best = sides.front().from;
  double clearance = -1.0;
  for (int k = 0; k < lines; ++k) {
    const double y = box.low.y + (box.high.y - box.low.y) * (k + 0.5) / lines;
    std::vector<double> crossings;
    for (const Segment& side : sides) {
      if ((side.from.y > y) == (side.to.y > y)) continue;
      crossings.push_back(side.from.x + (y - side.from.y) / (side.to.y - side.from.y) * (side.to.x - side.from.x));
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
      const Point p{0.5 * (crossings[i] + crossings[i + 1]), y};
      if (0.5 * (crossings[i + 1] - crossings[i]) <= clearance) continue;
      const double half_width = 0.5 * (crossings[i + 1] - crossings[i]);
      const auto nearest = index.nearest(
          p, [&](std::size_t side) { return distance(sides[side], p); }, half_width);
      const double least = nearest ? nearest->distance : half_width;
      if (least > clearance) {
        clearance = least;
        best = p;
      }
    }
  }
  return best;
}

}  // namespace quebra::sketch
