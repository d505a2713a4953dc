#pragma once
// Points and vectors of the plane: x to the right, y (z in sections) up, metres.

#include <cmath>
#include <compare>
#include <ostream>

namespace dobra::geom {

/// A displacement.
struct Vector {
  double x = 0.0;
  double y = 0.0;

  friend constexpr bool operator==(const Vector&, const Vector&) = default;
  friend constexpr Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr Vector operator-(Vector a) { return {-a.x, -a.y}; }
  friend constexpr Vector operator*(double f, Vector a) { return {f * a.x, f * a.y}; }
  friend constexpr Vector operator/(Vector a, double f) { return {a.x / f, a.y / f}; }
  friend std::ostream& operator<<(std::ostream& out, Vector a) { return out << '<' << a.x << ", " << a.y << '>'; }
};

/// A position.
struct Point {
  double x = 0.0;
  double y = 0.0;

  friend constexpr auto operator<=>(const Point&, const Point&) = default;
  friend constexpr Point operator+(Point p, Vector v) { return {p.x + v.x, p.y + v.y}; }
  friend constexpr Point operator-(Point p, Vector v) { return {p.x - v.x, p.y - v.y}; }
  friend constexpr Vector operator-(Point p, Point q) { return {p.x - q.x, p.y - q.y}; }
  friend std::ostream& operator<<(std::ostream& out, Point p) { return out << '(' << p.x << ", " << p.y << ')'; }
};

constexpr double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y; }
/// Positive when b is anticlockwise of a.
constexpr double cross(Vector a, Vector b) { return a.x * b.y - a.y * b.x; }
inline double length(Vector a) { return std::hypot(a.x, a.y); }
constexpr double length_squared(Vector a) { return dot(a, a); }
inline double distance(Point p, Point q) { return length(p - q); }
/// Turned by +90 degrees (to the left of travel).
constexpr Vector left_of(Vector a) { return {-a.y, a.x}; }
/// Turned by -90 degrees (to the right of travel).
constexpr Vector right_of(Vector a) { return {a.y, -a.x}; }
/// @pre a is not the zero vector.
inline Vector normalised(Vector a) { return a / length(a); }
/// The point at fraction t from p to q; exact at t = 0 and t = 1.
constexpr Point interpolate(Point p, Point q, double t) {
  return {(1.0 - t) * p.x + t * q.x, (1.0 - t) * p.y + t * q.y};
}
constexpr Point midpoint(Point p, Point q) { return {0.5 * (p.x + q.x), 0.5 * (p.y + q.y)}; }
inline bool is_finite(Point p) { return std::isfinite(p.x) && std::isfinite(p.y); }

}  // namespace dobra::geom
