#include "shared/solid/shape/instance.h"

#include <fmt/format.h>

#include <cmath>
#include <initializer_list>

#include "shared/solid/placement.h"

namespace dobra::solid::shape {
namespace {

using base::Error;
using base::ErrorCode;
using base::Result;

struct Size {
  const char* name;
  double value;
};

Result<void> check_sizes(std::initializer_list<Size> sizes) {
  for (const Size& size : sizes) {
    if (std::isfinite(size.value) && size.value > 0.0) continue;
    return Error{ErrorCode::InvalidOption, fmt::format("{} is {}; it must be above 0", size.name, size.value)};
  }
  return {};
}

Result<void> check_count(const char* name, int count, int least) {
  if (count >= least) return {};
  return Error{ErrorCode::InvalidOption, fmt::format("{} is {}; it must be {} or more", name, count, least)};
}

geom::Polyline regular(int sides, double radius) {
  geom::Polyline polygon{{}, true};
  for (int i = 0; i < sides; ++i) {
    const auto [c, s] = circle_at(360.0 * i / sides);
    polygon.points.push_back({radius * c, radius * s});
  }
  return polygon;
}

}  // namespace

Result<Shape> block(geom::Vector3 size) {
  DOBRA_TRY_VOID(check_sizes({{"the first number of size", size.x},
                              {"the second number of size", size.y},
                              {"the third number of size", size.z}}));
  const geom::Polyline base{{{0, 0}, {size.x, 0}, {size.x, size.y}, {0, size.y}}, true};
  DOBRA_TRY(Shape shape, extrude({base, {}}, {0, 0, size.z}));
  shape.names = {"bottom", "top", "front", "right", "back", "left"};
  return shape;
}

Result<Shape> prism(int sides, double radius, double height) {
  DOBRA_TRY_VOID(check_count("sides", sides, 3));
  DOBRA_TRY_VOID(check_sizes({{"radius", radius}, {"height", height}}));
  return extrude({regular(sides, radius), {}}, {0, 0, height});
}

Result<Shape> pyramid(int sides, double radius, double height) {
  DOBRA_TRY_VOID(check_count("sides", sides, 3));
  DOBRA_TRY_VOID(check_sizes({{"radius", radius}, {"height", height}}));
  return draw_to_point({regular(sides, radius), {}}, {0, 0, height});
}

Result<Shape> cylinder(double radius, double height, const Roundness& roundness) {
  DOBRA_TRY_VOID(check_count("segments", roundness.segments, 3));
  DOBRA_TRY_VOID(check_sizes({{"radius", radius}, {"height", height}}));
  return extrude({regular(roundness.segments, radius), {}}, {0, 0, height}, SideNames::One);
}

Result<Shape> cone(double radius, double top_radius, double height, const Roundness& roundness) {
  DOBRA_TRY_VOID(check_count("segments", roundness.segments, 3));
  DOBRA_TRY_VOID(check_sizes({{"radius", radius}, {"height", height}}));
  if (top_radius == 0.0)
    return draw_to_point({regular(roundness.segments, radius), {}}, {0, 0, height}, SideNames::One);
  DOBRA_TRY_VOID(check_sizes({{"top_radius", top_radius}}));
  DOBRA_TRY(Shape shape, revolve({{{0, 0}, {radius, 0}, {top_radius, height}, {0, height}}, true},
                                 {.segments = roundness.segments}));
  for (std::string& name : shape.names) name = name == "side_1" ? "bottom" : name == "side_2" ? "side" : "top";
  return shape;
}

Result<Shape> sphere(double radius, const Roundness& roundness) {
  DOBRA_TRY_VOID(check_count("segments", roundness.segments, 3));
  DOBRA_TRY_VOID(check_count("rows", roundness.rows, 2));
  DOBRA_TRY_VOID(check_sizes({{"radius", radius}}));
  geom::Polyline half{{}, true};
  for (int i = 0; i <= roundness.rows; ++i) {
    const auto [c, s] = circle_at(180.0 * i / roundness.rows);
    half.points.push_back({i == 0 || i == roundness.rows ? 0.0 : radius * s, -radius * c});
  }
  return revolve(half, {.segments = roundness.segments}, SideNames::One);
}

Result<Shape> torus(double radius, double minor_radius, const Roundness& roundness) {
  DOBRA_TRY_VOID(check_count("segments", roundness.segments, 3));
  DOBRA_TRY_VOID(check_count("rows", roundness.rows, 3));
  DOBRA_TRY_VOID(check_sizes({{"radius", radius}, {"minor_radius", minor_radius}}));
  if (minor_radius >= radius) {
    return Error{ErrorCode::InvalidOption, fmt::format("minor_radius is {} and must be below radius, {}: the tube "
                                                       "would run into itself at the axis",
                                                       minor_radius, radius)};
  }
  geom::Polyline tube = regular(roundness.rows, minor_radius);
  for (geom::Point& p : tube.points) p.x += radius;
  return revolve(tube, {.segments = roundness.segments}, SideNames::One);
}

}  // namespace dobra::solid::shape
