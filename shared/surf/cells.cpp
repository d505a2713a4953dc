#include "shared/surf/cells.h"

#include <algorithm>
#include <cmath>

namespace dobra::surf {

using geom::Box;
using geom::Point;

Hull hull_of(const Surface& surface, const Box& cell) {
  const Jet jet = surface.jet(cell.centre());
  const Bend bend = surface.bend(cell);
  const double a = 0.5 * cell.width(), b = 0.5 * cell.height();
  const double uu = bend.uu * a * a, uv = bend.uv * a * b, vv = bend.vv * b * b;
  // A hair for the rounding of the bounds themselves.
  return {jet.at,  a * jet.u, b * jet.v, 0.5 * (uu + vv) + uv + 1e-15 * (surface.size() + geom::distance(jet.at, {})),
          uu + uv, uv + vv};
}

std::vector<Box> smooth_parts(const Surface& surface) {
  const std::vector<double>&us = surface.kinks().u, &vs = surface.kinks().v;
  const auto end = [](const std::vector<double>& list, std::size_t i) {
    return i + 1 == list.size() ? list[i] : std::nextafter(list[i], list.front());
  };
  std::vector<Box> parts;
  for (std::size_t i = 1; i < us.size(); ++i) {
    for (std::size_t j = 1; j < vs.size(); ++j) parts.push_back({{us[i - 1], vs[j - 1]}, {end(us, i), end(vs, j)}});
  }
  return parts;
}

Cells::Cells(const Surface& surface) : surface_(surface), parts_(smooth_parts(surface)) {
  for (std::size_t i = 0; i < parts_.size(); ++i) cells_.push_back({parts_[i], hull_of(surface_, parts_[i]), i, 0});
}

std::array<std::size_t, 2> Cells::halves(std::size_t cell) {
  if (cells_[cell].child == 0) {
    const Cell whole = cells_[cell];
    const Point m = whole.box.centre();
    // By the ways and by what is not straight: a cell with a pole has no width in its middle's tangent alone.
    const bool across_u =
        geom::length(whole.hull.along_u) + whole.hull.turn_u > geom::length(whole.hull.along_v) + whole.hull.turn_v;
    Box first = whole.box, second = whole.box;
    (across_u ? first.high.x : first.high.y) = across_u ? m.x : m.y;
    (across_u ? second.low.x : second.low.y) = across_u ? m.x : m.y;
    cells_[cell].child = cells_.size();
    for (const Box& half : {first, second}) cells_.push_back({half, hull_of(surface_, half), whole.part, 0});
  }
  return {cells_[cell].child, cells_[cell].child + 1};
}

}  // namespace dobra::surf
