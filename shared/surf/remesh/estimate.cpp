#include "shared/surf/remesh/estimate.h"

#include <algorithm>
#include <cmath>

namespace dobra::surf::remesh {

using param::HalfEdge;
using param::no_half_edge;
using param::Sheet;

namespace {

constexpr double equilateral = 0.433;  // area of one of side 1

double to_two_digits(double value, double (*round)(double)) {
  if (!(value > 0.0) || !std::isfinite(value)) return value;
  const double step = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  return round(value / step) * step;
}

}  // namespace

double rounded_up(double value) {
  return to_two_digits(value, [](double x) { return std::ceil(x); });
}
double rounded_down(double value) {
  return to_two_digits(value, [](double x) { return std::floor(x); });
}

void Demand::add(const Sheet& sheet, double crease) {
  double longest = unit_;
  for (HalfEdge h = 0; h < sheet.twins.size(); ++h)
    longest = std::max(longest, geom::distance(sheet.points[sheet.start(h)], sheet.points[sheet.end(h)]));
  if (!(longest > 0.0)) return;
  const double ratio = unit_ / longest;
  area_ *= ratio * ratio, length_ *= ratio, unit_ = longest;
  const auto side = [&](std::uint32_t from, std::uint32_t to) {
    return (sheet.points[to] - sheet.points[from]) / longest;
  };
  for (const auto& [a, b, c] : sheet.triangles) area_ += 0.5 * geom::length(cross(side(a, b), side(a, c)));
  std::vector<bool> creased(sheet.twins.size(), false);
  if (crease < 180.0) creased = param::creases_of(sheet, crease);
  for (HalfEdge h = 0; h < sheet.twins.size(); ++h) {
    if (creased[h] || sheet.twins[h] == no_half_edge) length_ += geom::length(side(sheet.start(h), sheet.end(h)));
  }
}

double Demand::triangles(double size) const {
  const double sides = unit_ / size;
  return area_ / equilateral * sides * sides + length_ * sides;
}

double Demand::size_for(double triangles) const {
  // The greater root of triangles x^2 - length x - area / equilateral, in units.
  const double root = std::sqrt(length_ * length_ + 4.0 * triangles * area_ / equilateral);
  return rounded_up(unit_ * (length_ + root) / (2.0 * triangles));
}

double expected_triangles(const Sheet& sheet, const std::vector<double>& sizes) {
  double sum = 0.0;
  for (const auto& [a, b, c] : sheet.triangles) {
    const double size = (sizes[a] + sizes[b] + sizes[c]) / 3.0;
    const auto side = [&, a = a](std::uint32_t to) { return (sheet.points[to] - sheet.points[a]) / size; };
    sum += 0.5 * geom::length(cross(side(b), side(c))) / equilateral;
  }
  return sum;
}

}  // namespace dobra::surf::remesh
