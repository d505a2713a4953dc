#include "shared/offset/verifier/exact.h"

#include <cmath>
#include <numeric>
#include <vector>

namespace dobra::offset::verifier {

namespace {

/// An exact sum of doubles, by increasing size.
class Sum {
 public:
  Sum() = default;
  explicit Sum(double a) { add(a); }
  /// a - b.
  static Sum difference(double a, double b) {
    Sum sum(a);
    sum.add(-b);
    return sum;
  }
  void add(double a) {
    std::vector<double> grown;
    for (const double b : terms_) {
      const double sum = a + b;
      const double of_b = sum - a;
      const double rest = (a - (sum - of_b)) + (b - of_b);
      if (rest != 0) grown.push_back(rest);
      a = sum;
    }
    if (a != 0) grown.push_back(a);
    terms_ = std::move(grown);
  }
  friend Sum operator+(Sum a, const Sum& b) {
    for (const double term : b.terms_) a.add(term);
    return a;
  }
  friend Sum operator-(Sum a, const Sum& b) {
    for (const double term : b.terms_) a.add(-term);
    return a;
  }
  friend Sum operator*(const Sum& a, const Sum& b) {
    Sum product;
    for (const double s : a.terms_) {
      for (const double t : b.terms_) {
        const double high = s * t;
        product.add(std::fma(s, t, -high));
        product.add(high);
      }
    }
    return product;
  }
  [[nodiscard]] bool positive() const { return !terms_.empty() && terms_.back() > 0; }
  [[nodiscard]] bool zero() const { return terms_.empty(); }
  /// Rounded.
  [[nodiscard]] long double value() const { return std::accumulate(terms_.begin(), terms_.end(), 0.0L); }
  /// Neither so great nor so small that its fourth powers' last digits are lost.
  [[nodiscard]] bool safe() const {
    for (const double term : terms_) {
      if (!(std::abs(term) < 0x1p200 && std::abs(term) > 0x1p-200)) return false;
    }
    return true;
  }

 private:
  std::vector<double> terms_;
};

struct Step {
  Sum x, y;
  Step(geom::Point from, geom::Point to) : x(Sum::difference(to.x, from.x)), y(Sum::difference(to.y, from.y)) {}
  [[nodiscard]] bool safe() const { return x.safe() && y.safe(); }
};
Sum cross(const Step& a, const Step& b) { return a.x * b.y - a.y * b.x; }
Sum squared(const Step& a) { return a.x * a.x + a.y * a.y; }
Sum four_times_squared(double d) { return Sum(2 * d) * Sum(2 * d); }

}  // namespace

Room between_points(geom::Point p, geom::Point q, double d) {
  const Step step(p, q);
  if (!step.safe() || !Sum(d).safe()) return Room::Unknown;
  return (squared(step) - four_times_squared(d)).positive() ? Room::Some : Room::None;
}

Room beside_line(geom::Point a, geom::Point b, geom::Point p, double d) {
  const Step along(a, b);
  const Step aside(a, p);
  if (!along.safe() || !aside.safe() || !Sum(d).safe()) return Room::Unknown;
  const Sum area = cross(along, aside);
  return (area * area - four_times_squared(d) * squared(along)).positive() ? Room::Some : Room::None;
}

bool parallel(geom::Point a, geom::Point b, geom::Point p, geom::Point q) {
  const Step first(a, b);
  const Step second(p, q);
  return first.safe() && second.safe() && cross(first, second).zero();
}

long double cross_of(geom::Point a, geom::Point b, geom::Point p, geom::Point q) {
  return cross(Step(a, b), Step(p, q)).value();
}

}  // namespace dobra::offset::verifier
