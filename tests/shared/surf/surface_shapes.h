#pragma once
// Surfaces of every kind for the tests.

#include <cmath>
#include <numbers>
#include <random>

#include "shared/surf/surface.h"

namespace dobra::surf::test {

constexpr double pi = std::numbers::pi;

struct Chance {
  std::mt19937 random;
  double number(double low, double high) {
    return std::lerp(low, high, static_cast<double>(random() % 1000003) / 1000002.0);
  }
  double operator()(double low, double high) { return number(low, high); }
  geom::Point of(const geom::Box& box) { return {number(box.low.x, box.high.x), number(box.low.y, box.high.y)}; }
};

/// Not at the origin, not along the axes.
inline Frame tilted() {
  const geom::Vector3 z = geom::normalised(geom::Vector3{1.0, -2.0, 3.0});
  const geom::Vector3 x = geom::normalised(cross(geom::Vector3{0.0, 1.0, 0.2}, z));
  return {{10.0, -20.0, 5.0}, x, cross(z, x), z};
}

inline Curve cubic(double z1, double z2, bool along_x, double at) {
  const auto point = [&](double t, double z) {
    return along_x ? geom::Point3{10.0 * t, at, z} : geom::Point3{at, 10.0 * t, z};
  };
  return *Curve::bezier({point(0, 0), point(1.0 / 3.0, z1), point(2.0 / 3.0, z2), point(1, 0)});
}
/// Four cubics over a square of ten by ten.
inline Surface coons_of_cubics() {
  return *Surface::coons(cubic(4, 4, true, 0), cubic(-3, 5, true, 10), cubic(3, -3, false, 0), cubic(-2, 4, false, 10));
}

/// A quarter circle as a rational curve of degree 2, in the plane of x and z.
inline Curve quarter(double radius) {
  return *Curve::bezier({{radius, 0, 0}, {radius, 0, radius}, {0, 0, radius}}, {1.0, std::sqrt(0.5), 1.0});
}

struct Named {
  const char* name;
  Surface surface;
};
inline std::vector<Named> all_kinds() {
  std::vector<geom::Point3> wild;
  std::mt19937 random(3);
  const auto number = [&] { return static_cast<double>(random() % 1000) / 500.0 - 1.0; };
  std::vector<double> weights;
  for (int i = 0; i < 7; ++i) {
    for (int j = 0; j < 6; ++j) {
      wild.push_back({i + 0.3 * number(), j + 0.3 * number(), 1.5 * number()});
      weights.push_back(1.3 + number());
    }
  }
  std::vector<geom::Point3> grid;
  for (int i = 0; i < 9; ++i) {
    for (int j = 0; j < 12; ++j) grid.push_back({1.0 * i, 2.0 * j + 0.1 * i, std::sin(0.7 * i) * std::cos(0.4 * j)});
  }
  const Frame frame = tilted();
  return {
      {"plane", *Surface::plane({{1, 2, 3}, {2, 0, 0}, {1, 1, 0}, {}}, {{0, 0}, {3, 2}})},
      {"cylinder", *Surface::cylinder(frame, 5.0, {{0, 0}, {0.5 * pi, 10.0}})},
      {"cone", *Surface::cone(frame, 2.0, 0.4, {{-1, -3}, {2, 4}})},
      {"sphere", *Surface::sphere(frame, 5.0, {{0, -pi / 3.0}, {pi, pi / 3.0}})},
      {"torus", *Surface::torus(frame, 6.0, 2.0, {{0, -pi}, {1.5 * pi, pi}})},
      {"ruled", *Surface::ruled(quarter(4.0), *Curve::line({4, 8, 0}, {1, 9, 4}))},
      {"extruded", *Surface::extruded(quarter(3.0), {1.0, 7.0, 0.5})},
      {"revolved", *Surface::revolved(cubic(2, -1, true, 3.0), {0, 0, -5}, {1, 0.2, 0}, 0.3, 4.0)},
      {"coons", coons_of_cubics()},
      {"graph", *Surface::graph("4 * exp(-(x^2 + y^2) / 8) + sin(x) * y / 5", {{-4, -4}, {4, 5}})},
      {"nurbs",
       *Surface::nurbs(3, {0, 0, 0, 0, 1, 1.5, 2.5, 4, 4, 4, 4}, 2, {0, 0, 0, 1, 1, 2, 3, 3, 3}, wild, weights)},
      {"through", *Surface::through(grid, 9, 12)},
  };
}

}  // namespace dobra::surf::test
