#include "quebra/core/drawn_chart.h"

#include <fmt/format.h>

#include "shared/surf/measure.h"

namespace quebra::core {

using namespace dobra;

std::string chart_key(std::size_t face) { return fmt::format("chart_{}", face + 1); }

std::optional<std::size_t> face_of_chart(const std::string& panel) {
  for (std::size_t face = 0; face < most_charts; ++face) {
    if (chart_key(face) == panel) return face;
  }
  return std::nullopt;
}

DrawnChart::DrawnChart(const surf::Surface& surface) : low_(surface.chart().low) {
  const geom::Box& box = surface.chart();
  const geom::Point middle{0.5 * (box.low.x + box.high.x), 0.5 * (box.low.y + box.high.y)};
  u_ = surf::length(surface, {box.low.x, middle.y}, {box.high.x, middle.y}) / box.width();
  v_ = surf::length(surface, {middle.x, box.low.y}, {middle.x, box.high.y}) / box.height();
}

}  // namespace quebra::core
