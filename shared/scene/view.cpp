#include "shared/scene/view.h"

#include <algorithm>

namespace dobra::scene {

Transform transform_of(const View& view, const geom::Box& plot, double vertical_exaggeration) {
  const double points_per_x = 1.0 / view.world_per_point;
  return {view.centre, plot.centre(), points_per_x, points_per_x * vertical_exaggeration};
}

geom::Box comfortable(const geom::Box& extent) {
  if (extent.empty()) return {{0.0, 0.0}, {1.0, 1.0}};
  const double size = std::max(extent.width(), extent.height());
  // A single point gets a box that suits its coordinates, so that ticks still differ.
  const double floor = size > 0.0 ? 0.0 : std::max({1.0, 1e-3 * std::abs(extent.low.x), 1e-3 * std::abs(extent.low.y)});
  return extent.grown(0.05 * size + floor);
}

View fit(const geom::Box& box, double width, double height, double vertical_exaggeration) {
  return {box.centre(), std::max(box.width() / width, box.height() * vertical_exaggeration / height)};
}

View zoom_at(const View& view, geom::Point cursor_world, double factor) {
  return {cursor_world + (1.0 / factor) * (view.centre - cursor_world), view.world_per_point / factor};
}

View pan(const View& view, geom::Vector by, double vertical_exaggeration) {
  const geom::Vector moved{by.x * view.world_per_point, -by.y * view.world_per_point / vertical_exaggeration};
  return {view.centre - moved, view.world_per_point};
}

}  // namespace dobra::scene
