#pragma once
// Arithmetic of the offset engine: 64-bit mantissas (11 bits more than the input has), so that exact coincidences of the input,
// which come out to within 1e-18, are told from near ones of input coordinates, which differ by 1e-16 or more.

#include <cmath>

#include "shared/geom/point.h"

namespace dobra::offset {

using Real = long double;

struct Vec {
  Real x = 0;
  Real y = 0;
  friend Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y}; }
  friend Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y}; }
  friend Vec operator-(Vec a) { return {-a.x, -a.y}; }
  friend Vec operator*(Real f, Vec a) { return {f * a.x, f * a.y}; }
};

inline Real dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y; }
inline Real cross(Vec a, Vec b) { return a.x * b.y - a.y * b.x; }
inline Real length(Vec a) { return std::sqrt(a.x * a.x + a.y * a.y); }
inline Vec right_of(Vec a) { return {a.y, -a.x}; }
inline Vec left_of(Vec a) { return {-a.y, a.x}; }
inline Vec unit(Vec a) { return (1 / length(a)) * a; }
inline geom::Point rounded(Vec a) { return {static_cast<double>(a.x), static_cast<double>(a.y)}; }

}  // namespace dobra::offset
