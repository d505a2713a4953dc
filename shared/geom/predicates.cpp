#include "shared/geom/predicates.h"

#include <array>
#include <utility>

#include "shared/geom/expansion.h"
#include "shared/geom/product_sum.h"

// Every predicate goes through the same stages, each tried only if the one before could not tell:
//   1. the determinant in doubles against its error bound; for two products, their signs;
//   2. the determinant of the rounded differences, exactly, against the error of that rounding;
//   2' (incircle) the same plus what the errors of the differences add to first order, against the terms left out;
//   3. the determinant of the exact differences, exactly;
//   3' in place of 2 and 3 where numbers are so large or small that an expansion might overflow or underflow:
//   ProductSum.
// Bounds A and B are those of [shewchuk1997predicates] for the same order of operations; C is a little wider than
// there.

namespace dobra::geom {
namespace {

constexpr double half_ulp = 0x1p-53;
constexpr double cross_bound_a = (3.0 + 16.0 * half_ulp) * half_ulp;
constexpr double cross_bound_b = (2.0 + 12.0 * half_ulp) * half_ulp;
constexpr double circle_bound_a = (10.0 + 96.0 * half_ulp) * half_ulp;
constexpr double circle_bound_b = (4.0 + 48.0 * half_ulp) * half_ulp;
constexpr double circle_bound_c = 64.0 * half_ulp * half_ulp;
/// Of the sum that stage 2' compares.
constexpr double result_bound = 4.0 * half_ulp;
/// Above this size of a sum of two products, what underflow takes from the products is far below the bounds.
constexpr double safe_sum = 0x1p-900;

/// from -> to along one axis.
struct Step {
  double from;
  double to;

  [[nodiscard]] double rounded() const { return to - from; }
  [[nodiscard]] Expansion<2> exact() const { return difference(to, from); }
  [[nodiscard]] bool in_range() const { return in_expansion_range(from) && in_expansion_range(to); }
};

void add_product(ProductSum& sum, Sign sign, Step u, Step v) {
  sum.add(sign, {u.to, v.to});
  sum.add(-sign, {u.to, v.from});
  sum.add(-sign, {u.from, v.to});
  sum.add(sign, {u.from, v.from});
}

/// Stages 2 and 3 for u * v - w * z.
Sign exact_determinant_sign(Step u, Step v, Step w, Step z, double sum) {
  if (!(u.in_range() && v.in_range() && w.in_range() && z.in_range())) {
    ProductSum total;
    add_product(total, Sign::Positive, u, v);
    add_product(total, Sign::Negative, w, z);
    return total.sign();
  }
  const Expansion<4> of_rounded =
      Expansion<2>(two_product(u.rounded(), v.rounded())) - Expansion<2>(two_product(w.rounded(), z.rounded()));
  if (std::abs(of_rounded.estimate()) > cross_bound_b * sum) return of_rounded.sign();
  return (u.exact() * v.exact() - w.exact() * z.exact()).sign();
}

/// Sign of u * v - w * z.
Sign determinant_sign(Step u, Step v, Step w, Step z) {
  const double left = u.rounded() * v.rounded();
  const double right = w.rounded() * z.rounded();
  const double sum = std::abs(left) + std::abs(right);
  // An overflow makes `sum` infinite, and then the comparison is false.
  if (sum > safe_sum && std::abs(left - right) > cross_bound_a * sum) return sign_of(left - right);
  // A rounded difference has the sign of the exact one, so the signs of both products are known for certain.
  const Sign left_sign = sign_of(u.rounded()) * sign_of(v.rounded());
  const Sign right_sign = sign_of(w.rounded()) * sign_of(z.rounded());
  if (left_sign != right_sign) return left_sign > right_sign ? Sign::Positive : Sign::Negative;
  if (left_sign == Sign::Zero) return Sign::Zero;
  return exact_determinant_sign(u, v, w, z, sum);
}

/// The six differences of incircle, as one or two terms each.
template <std::size_t N>
struct CircleTerms {
  Expansion<N> ax, ay, bx, by, cx, cy;
};

template <std::size_t N>
auto circle_determinant(const CircleTerms<N>& t) {
  const auto lifted = [](const Expansion<N>& x, const Expansion<N>& y) { return x * x + y * y; };
  return lifted(t.ax, t.ay) * (t.bx * t.cy - t.cx * t.by) + lifted(t.bx, t.by) * (t.cx * t.ay - t.ax * t.cy) +
         lifted(t.cx, t.cy) * (t.ax * t.by - t.bx * t.ay);
}

/// What errors of the differences u, v, w add to circle_determinant, to first order.
double first_order(Vector u, Vector v, Vector w, Vector u_error, Vector v_error, Vector w_error) {
  const auto part = [](Vector p, Vector q, Vector r, Vector p_error, Vector q_error, Vector r_error) {
    return length_squared(p) * (cross(q_error, r) + cross(q, r_error)) + 2.0 * dot(p, p_error) * cross(q, r);
  };
  return part(u, v, w, u_error, v_error, w_error) + part(v, w, u, v_error, w_error, u_error) +
         part(w, u, v, w_error, u_error, v_error);
}

/// Stage 3' of incircle: the 4 x 4 determinant with rows (x, y, x^2 + y^2, 1), written out over all permutations.
Sign circle_sign_any_range(const std::array<Point, 4>& p) {
  ProductSum total;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t k = 0; k < 4; ++k) {
        if (i == j || i == k || j == k) continue;
        const std::size_t l = 6 - i - j - k;
        const int inversions = (i > j) + (i > k) + (i > l) + (j > k) + (j > l) + (k > l);
        const Sign sign = inversions % 2 == 0 ? Sign::Positive : Sign::Negative;
        total.add(sign, {p[i].x, p[j].y, p[k].x, p[k].x});
        total.add(sign, {p[i].x, p[j].y, p[k].y, p[k].y});
      }
    }
  }
  return total.sign();
}

}  // namespace

Sign cross_sign(Point a, Point b, Point c, Point d) {
  return determinant_sign({a.x, b.x}, {c.y, d.y}, {a.y, b.y}, {c.x, d.x});
}

Sign dot_sign(Point a, Point b, Point c, Point d) {
  return determinant_sign({a.x, b.x}, {c.x, d.x}, {b.y, a.y}, {c.y, d.y});
}

Sign orient2d(Point a, Point b, Point c) { return cross_sign(c, a, c, b); }

Sign incircle(Point a, Point b, Point c, Point d) {
  for (const Point p : {a, b, c, d}) {
    if (!in_expansion_range(p.x) || !in_expansion_range(p.y)) return circle_sign_any_range({a, b, c, d});
  }
  const Vector ad = a - d;
  const Vector bd = b - d;
  const Vector cd = c - d;
  const double determinant = length_squared(ad) * (bd.x * cd.y - cd.x * bd.y) +
                             length_squared(bd) * (cd.x * ad.y - ad.x * cd.y) +
                             length_squared(cd) * (ad.x * bd.y - bd.x * ad.y);
  const double permanent = length_squared(ad) * (std::abs(bd.x * cd.y) + std::abs(cd.x * bd.y)) +
                           length_squared(bd) * (std::abs(cd.x * ad.y) + std::abs(ad.x * cd.y)) +
                           length_squared(cd) * (std::abs(ad.x * bd.y) + std::abs(bd.x * ad.y));
  if (std::abs(determinant) > circle_bound_a * permanent) return sign_of(determinant);

  const auto one = [](double value) { return Expansion<1>(value); };
  const auto of_rounded =
      circle_determinant(CircleTerms<1>{one(ad.x), one(ad.y), one(bd.x), one(bd.y), one(cd.x), one(cd.y)});
  const double rounded = of_rounded.estimate();
  if (std::abs(rounded) > circle_bound_b * permanent) return of_rounded.sign();

  const auto error = [&](Point p) { return Vector{two_sum(p.x, -d.x).low, two_sum(p.y, -d.y).low}; };
  const double corrected = rounded + first_order(ad, bd, cd, error(a), error(b), error(c));
  if (std::abs(corrected) > circle_bound_c * permanent + result_bound * std::abs(rounded)) return sign_of(corrected);

  const CircleTerms<2> exact{difference(a.x, d.x), difference(a.y, d.y), difference(b.x, d.x),
                             difference(b.y, d.y), difference(c.x, d.x), difference(c.y, d.y)};
  return circle_determinant(exact).sign();
}

}  // namespace dobra::geom
