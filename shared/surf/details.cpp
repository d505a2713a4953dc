#include "shared/surf/details.h"

#include <cmath>
#include <deque>

namespace dobra::surf {

using geom::Box;

std::array<Box, 2> halves_by_bend(const Surface& surface, const Box& part) {
  const Bend bend = surface.bend(part);
  const double w = part.width(), h = part.height();
  double along_u = (bend.uu * w + bend.uv * h) * w, along_v = (bend.uv * w + bend.vv * h) * h;
  if (!std::isfinite(along_u + along_v) || along_u == along_v)
    along_u = w / surface.chart().width(), along_v = h / surface.chart().height();
  Box first = part, second = part;
  const geom::Point m = part.centre();
  if (along_u >= along_v) {
    first.high.x = second.low.x = m.x;
  } else {
    first.high.y = second.low.y = m.y;
  }
  return {first, second};
}

Details details_of(const Surface& surface, const Box& part, const DetailOptions& options) {
  const double width = surface.chart().width(), height = surface.chart().height();
  Details found;
  std::deque<Box> next{part};  // the coarsest first
  std::size_t looked = 0;
  while (!next.empty()) {
    const Box box = next.front();
    next.pop_front();
    ++looked;
    if (surface.seen(box)) {
      if (box.width() < options.look * width || box.height() < options.look * height) found.parts.push_back(box);
      continue;
    }
    const bool fine = box.width() <= options.finest * width && box.height() <= options.finest * height;
    if (fine || looked + next.size() >= options.most) {
      found.unseen.push_back(box);
      continue;
    }
    for (const Box& half : halves_by_bend(surface, box)) next.push_back(half);
  }
  return found;
}

}  // namespace dobra::surf
