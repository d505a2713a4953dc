#pragma once
// Homogeneous coordinates: 4x4 matrices that move, turn, shear and project points of space. They act on columns; what
// is done first stands on the right. Points have w = 1, directions (points at infinity) w = 0.
// Source: [foley1990graphics].

#include <array>
#include <cstddef>

#include "shared/geom/point3.h"

namespace dobra::scene::space {

using Column4 = std::array<double, 4>;

struct Matrix4 {
  std::array<Column4, 4> rows{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
  friend bool operator==(const Matrix4&, const Matrix4&) = default;
};

constexpr Column4 operator*(const Matrix4& m, const Column4& c) {
  Column4 out{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 4; ++k) out[i] += m.rows[i][k] * c[k];
  }
  return out;
}

constexpr Matrix4 operator*(const Matrix4& a, const Matrix4& b) {
  Matrix4 out;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      out.rows[i][j] = 0.0;
      for (std::size_t k = 0; k < 4; ++k) out.rows[i][j] += a.rows[i][k] * b.rows[k][j];
    }
  }
  return out;
}

constexpr Column4 column(geom::Point3 p) { return {p.x, p.y, p.z, 1.0}; }
constexpr Column4 column(geom::Vector3 v) { return {v.x, v.y, v.z, 0.0}; }

constexpr Matrix4 translation(geom::Vector3 by) {
  return {{{{1, 0, 0, by.x}, {0, 1, 0, by.y}, {0, 0, 1, by.z}, {0, 0, 0, 1}}}};
}

constexpr Matrix4 scaling(double x, double y, double z) {
  return {{{{x, 0, 0, 0}, {0, y, 0, 0}, {0, 0, z, 0}, {0, 0, 0, 1}}}};
}

/// To the coordinates along three axes.
constexpr Matrix4 along(geom::Vector3 a, geom::Vector3 b, geom::Vector3 c) {
  return {{{{a.x, a.y, a.z, 0}, {b.x, b.y, b.z, 0}, {c.x, c.y, c.z, 0}, {0, 0, 0, 1}}}};
}

/// x + z times `right`, y + z times `up`: oblique projection.
constexpr Matrix4 shear(double right, double up) {
  return {{{{1, 0, right, 0}, {0, 1, up, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}}};
}

/// Onto z = 0 from an eye at z = -distance: x / (1 + z / distance). z tends to `distance` far away.
constexpr Matrix4 perspective(double distance) {
  return {{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 1.0 / distance, 1}}}};
}

}  // namespace dobra::scene::space
