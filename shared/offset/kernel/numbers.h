#pragma once
// Vectors of the offset engine in three kinds of numbers: doubles where a margin makes a decision safe; mantissas of 64
// bits or more (11 bits more than the input has) with a bound of their error where topology is decided; and High
// (high.h) for what they leave in doubt.

#include <cmath>
#include <limits>
#include <type_traits>

#include "shared/geom/point.h"
#include "shared/offset/kernel/double_double.h"

namespace dobra::offset {
inline namespace kernel {

/// Error bounds (high.h) suppose 64 bits. Compilers that make long double a double (and builds with the CMake option
/// DOBRA_DOUBLE_DOUBLE, to try that) take two doubles instead.
#ifdef DOBRA_DOUBLE_DOUBLE
using Real = DoubleDouble;
#else
using Real = std::conditional_t<(std::numeric_limits<long double>::digits >= 64), long double, DoubleDouble>;
#endif
static_assert(std::numeric_limits<Real>::digits >= 64);

template <class T>
T root(const T& x) {
  using std::sqrt;
  return sqrt(x);
}

template <class T>
struct VecOf {
  T x = 0;
  T y = 0;
  friend VecOf operator+(VecOf a, VecOf b) { return {a.x + b.x, a.y + b.y}; }
  friend VecOf operator-(VecOf a, VecOf b) { return {a.x - b.x, a.y - b.y}; }
  friend VecOf operator-(VecOf a) { return {-a.x, -a.y}; }
  friend VecOf operator*(T f, VecOf a) { return {f * a.x, f * a.y}; }
  friend T dot(VecOf a, VecOf b) { return a.x * b.x + a.y * b.y; }
  friend T cross(VecOf a, VecOf b) { return a.x * b.y - a.y * b.x; }
  friend T length(VecOf a) { return root<T>(a.x * a.x + a.y * a.y); }
  friend VecOf right_of(VecOf a) { return {a.y, -a.x}; }
  friend VecOf left_of(VecOf a) { return {-a.y, a.x}; }
  friend VecOf unit(VecOf a) { return T(T(1) / length(a)) * a; }
};
using Vec = VecOf<Real>;
using Flat = VecOf<double>;

inline geom::Point rounded(Vec a) { return {static_cast<double>(a.x), static_cast<double>(a.y)}; }
inline Flat flat(geom::Point p) { return {p.x, p.y}; }
inline Flat flat(geom::Vector v) { return {v.x, v.y}; }
inline Flat flat(Vec a) { return {static_cast<double>(a.x), static_cast<double>(a.y)}; }
inline Vec exact(Flat a) { return {a.x, a.y}; }

}  // namespace kernel
}  // namespace dobra::offset
