#pragma once
// Points and vectors of space.

#include <cmath>

namespace dobra::geom {

/// A displacement, m.
struct Vector3 {
  double x = 0.0, y = 0.0, z = 0.0;
  friend constexpr bool operator==(const Vector3&, const Vector3&) = default;
  friend constexpr Vector3 operator+(Vector3 a, Vector3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend constexpr Vector3 operator-(Vector3 a, Vector3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend constexpr Vector3 operator-(Vector3 a) { return {-a.x, -a.y, -a.z}; }
  friend constexpr Vector3 operator*(double f, Vector3 a) { return {f * a.x, f * a.y, f * a.z}; }
  friend constexpr Vector3 operator/(Vector3 a, double f) { return {a.x / f, a.y / f, a.z / f}; }
};

/// Coordinates in m; x to the east, y to the north, z upwards.
struct Point3 {
  double x = 0.0, y = 0.0, z = 0.0;
  friend constexpr bool operator==(const Point3&, const Point3&) = default;
  friend constexpr Point3 operator+(Point3 p, Vector3 v) { return {p.x + v.x, p.y + v.y, p.z + v.z}; }
  friend constexpr Point3 operator-(Point3 p, Vector3 v) { return {p.x - v.x, p.y - v.y, p.z - v.z}; }
  friend constexpr Vector3 operator-(Point3 p, Point3 q) { return {p.x - q.x, p.y - q.y, p.z - q.z}; }
};

constexpr double dot(Vector3 a, Vector3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vector3 cross(Vector3 a, Vector3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(Vector3 a) { return std::hypot(a.x, a.y, a.z); }
inline double distance(Point3 p, Point3 q) { return length(p - q); }
constexpr Point3 midpoint(Point3 p, Point3 q) { return {0.5 * (p.x + q.x), 0.5 * (p.y + q.y), 0.5 * (p.z + q.z)}; }
/// @pre a is not the zero vector.
inline Vector3 normalised(Vector3 a) { return a / length(a); }
inline bool is_finite(Point3 p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }
inline bool is_finite(Vector3 a) { return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z); }

}  // namespace dobra::geom
