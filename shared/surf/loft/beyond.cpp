#include "shared/surf/loft/beyond.h"

#include <cmath>

namespace dobra::surf::loft {

using geom::Point3;

Beyond beyond_ends(const std::vector<std::vector<Point3>>& lines, geom::Vector way, bool high) {
  const auto along = [&](Point3 p) { return p.x * way.x + p.y * way.y; };
  const auto across = [&](Point3 p) { return p.y * way.x - p.x * way.y; };
  const auto end_of = [&](std::size_t k) { return high ? lines[k].back() : lines[k].front(); };
  const auto height_at = [&](const std::vector<Point3>& line, double at) {
    for (std::size_t i = 1; i < line.size(); ++i) {
      const double from = along(line[i - 1]), to = along(line[i]);
      if ((from - at) * (to - at) > 0.0 || from == to) continue;
      return std::lerp(line[i - 1].z, line[i].z, (at - from) / (to - from));
    }
    return std::abs(along(line.front()) - at) < std::abs(along(line.back()) - at) ? line.front().z : line.back().z;
  };
  Beyond worst;
  for (std::size_t k = 1; k < lines.size(); ++k) {
    const bool goes_on = along(end_of(k)) > along(end_of(k - 1));
    const std::size_t shorter = goes_on ? k - 1 : k, longer = goes_on ? k : k - 1;
    const Point3 end = end_of(shorter), far = end_of(longer);
    worst.area += 0.5 * (along(far) - along(end)) * std::abs(across(far) - across(end));
    const double beside = height_at(lines[longer], along(end));
    for (const Point3 p : lines[longer]) {
      if (along(p) <= along(end)) continue;
      for (const double part : {0.25, 0.5, 0.75}) {  // of the way from the longer line to the end
        // The surface has lerp(p.z, end.z, part) there. The shape that goes on has the longer line's height beside that
        // place, and as much more or less as the ends are apart in height, by parts.
        const double shape = height_at(lines[longer], std::lerp(along(p), along(end), part));
        const double off = std::abs(shape - p.z + part * (p.z - beside));
        if (off <= worst.off) continue;
        worst.off = off;
        worst.at = p + part * (end - p);
        worst.shorter = shorter;
        worst.longer = longer;
        worst.ahead = along(far) - along(end);
      }
    }
  }
  return worst;
}

}  // namespace dobra::surf::loft
