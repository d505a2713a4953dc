#include "shared/scene/space/shade.h"

#include <algorithm>
#include <cmath>

#include "shared/scene/fill.h"

namespace dobra::scene::space {

geom::Vector3 normal_to_viewer(const Frame& frame, const std::array<geom::Point3, 3>& corners) {
  const auto drawn = [&](geom::Point3 p) { return geom::Point3{p.x, p.y, frame.exaggeration * p.z}; };
  const geom::Point3 a = drawn(corners[0]);
  const geom::Vector3 n = geom::cross(drawn(corners[1]) - a, drawn(corners[2]) - a);
  const double size = geom::length(n);
  if (!(size > 0.0) || !std::isfinite(size)) return {0.0, 0.0, 1.0};
  const Camera& camera = frame.camera;
  const geom::Vector3 seen{geom::dot(n, camera.right), geom::dot(n, camera.up), geom::dot(n, towards_viewer(camera))};
  return (seen.z < 0.0 ? -1.0 / size : 1.0 / size) * seen;
}

Color shaded(const Color& color, geom::Vector3 normal, const Light& light) {
  const double part = light.ambient + (1.0 - light.ambient) * std::max(0.0, geom::dot(normal, light.from));
  const auto byte = [part](std::uint8_t c) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(part * c, 0.0, 255.0)));
  };
  return {byte(color.red), byte(color.green), byte(color.blue), color.alpha};
}

Color color_of(const Surface& surface, std::size_t triangle, const Style& style) {
  if (surface.values_at == ValuesAt::Triangles) return stepped_color(surface.scale, surface.values[triangle]);
  if (surface.values_at == ValuesAt::Points) {
    double sum = 0.0;
    for (const std::uint32_t point : surface.triangles[triangle]) sum += surface.values[point] / 3.0;
    return stepped_color(surface.scale, sum);
  }
  if (triangle < surface.colors.size()) return surface.colors[triangle];
  return style.fill.value_or(Color{200, 204, 210});
}

}  // namespace dobra::scene::space
