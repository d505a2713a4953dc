#include "shared/surf/measure.h"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

#include "shared/geom/arc_length.h"
#include "shared/surf/details.h"

namespace dobra::surf {

using geom::Box;
using geom::Point;
using geom::Vector3;

std::optional<Vector3> normal(const Jet& jet) {
  const Vector3 across = cross(jet.u, jet.v);
  const double size = geom::length(across);
  const double longest = std::max(dot(jet.u, jet.u), dot(jet.v, jet.v));
  if (!(size > 1e-14 * longest)) return std::nullopt;  // what is left of them is rounding
  return across / size;
}

std::optional<Vector3> normal(const Surface& surface, Point uv) {
  const Jet jet = surface.jet(uv);
  const Box& chart = surface.chart();
  // A step into the chart turns Su (Sv) from nought by Suv: what Su x Sv comes to, but for its length.
  const auto limit = [](Vector3 u, Vector3 v) -> std::optional<Vector3> {
    const Vector3 across = cross(u, v);
    const double size = geom::length(across);
    if (!(size > 1e-14 * geom::length(u) * geom::length(v))) return std::nullopt;
    return across / size;
  };
  if (uv.y == chart.low.y && surface.collapsed(Side::Bottom)) return limit(jet.uv, jet.v);
  if (uv.y == chart.high.y && surface.collapsed(Side::Top)) return limit(-jet.uv, jet.v);
  if (uv.x == chart.low.x && surface.collapsed(Side::Left)) return limit(jet.u, jet.uv);
  if (uv.x == chart.high.x && surface.collapsed(Side::Right)) return limit(jet.u, -jet.uv);
  return normal(jet);
}

std::optional<Curvature> curvature(const Jet& jet) {
  const std::optional<Vector3> n = normal(jet);
  if (!n) return std::nullopt;
  const Metric first = metric(jet);
  const double l = dot(jet.uu, *n), m = dot(jet.uv, *n), k = dot(jet.vv, *n);
  // In the plane's own right-angled axes, along Su and across it, where equal curvatures stay equal.
  const double lean = first.f / first.e, across = first.g - first.f * lean;
  const double h11 = l / first.e;
  const double h12 = (m - lean * l) / std::sqrt(first.e * across);
  const double h22 = (k - lean * (2.0 * m - lean * l)) / across;
  const double mean = 0.5 * (h11 + h22), spread = std::hypot(0.5 * (h11 - h22), h12);
  return Curvature{mean - spread, mean + spread};
}

namespace {

using Rule = boost::math::quadrature::gauss<double, 8>;

/// Places and weights of the rule on -1 .. 1.
struct GaussPoints {
  std::array<double, 8> at{}, weight{};
  GaussPoints() {
    for (std::size_t i = 0; i < 4; ++i) {
      at[i] = -Rule::abscissa()[i], at[7 - i] = Rule::abscissa()[i];
      weight[i] = weight[7 - i] = Rule::weights()[i];
    }
  }
};

double area_of_cell(const Surface& surface, const Box& cell) {
  static const GaussPoints rule;
  std::array<Point, 64> uv{};
  std::array<Jet, 64> jets{};
  const Point middle = geom::midpoint(cell.low, cell.high);
  const double half_u = 0.5 * (cell.high.x - cell.low.x), half_v = 0.5 * (cell.high.y - cell.low.y);
  for (std::size_t i = 0; i < 64; ++i) uv[i] = {middle.x + half_u * rule.at[i / 8], middle.y + half_v * rule.at[i % 8]};
  surface.jets(uv, jets);
  double sum = 0.0;
  for (std::size_t i = 0; i < 64; ++i)
    sum += rule.weight[i / 8] * rule.weight[i % 8] * geom::length(cross(jets[i].u, jets[i].v));
  return sum * half_u * half_v;
}

struct Cell {
  Box box;
  double area = 0.0;   ///< By its quarters.
  double error = 0.0;  ///< How far the cell alone is from that.
  std::array<double, 4> quarters{};
  int depth = 0;
  bool operator<(const Cell& other) const { return error < other.error; }
};

std::array<Box, 4> quarters_of(const Box& box) {
  const Point m = geom::midpoint(box.low, box.high);
  return {Box{box.low, m}, Box{{m.x, box.low.y}, {box.high.x, m.y}}, Box{{box.low.x, m.y}, {m.x, box.high.y}},
          Box{m, box.high}};
}

Cell judged(const Surface& surface, const Box& box, double alone, int depth) {
  Cell cell{box, 0.0, 0.0, {}, depth};
  const std::array<Box, 4> parts = quarters_of(box);
  for (std::size_t i = 0; i < 4; ++i) cell.area += cell.quarters[i] = area_of_cell(surface, parts[i]);
  cell.error = std::abs(cell.area - alone);
  return cell;
}

/// The breaks inside a range, with its ends.
std::vector<double> within(const std::vector<double>& breaks, double low, double high) {
  std::vector<double> inside{low};
  for (const double at : breaks) {
    if (at > low && at < high) inside.push_back(at);
  }
  inside.push_back(high);
  return inside;
}

/// Parts of a part in which a rule misses no narrow peak.
std::vector<Box> parts_seen(const Surface& surface, const Box& part) {
  Details found = details_of(surface, part, {.look = std::numeric_limits<double>::infinity()});
  found.parts.insert(found.parts.end(), found.unseen.begin(), found.unseen.end());
  return std::move(found.parts);
}

}  // namespace

Measured area(const Surface& surface, const Box& part, double tolerance) {
  std::priority_queue<Cell> cells;
  Measured sum;
  const auto add = [&](const Box& box, double alone, int depth) {
    const Cell cell = judged(surface, box, alone, depth);
    sum.value += cell.area;
    sum.error += cell.error;
    cells.push(cell);
  };
  const std::vector<double> us = within(surface.breaks().u, part.low.x, part.high.x);
  const std::vector<double> vs = within(surface.breaks().v, part.low.y, part.high.y);
  for (std::size_t i = 1; i < us.size(); ++i) {
    for (std::size_t j = 1; j < vs.size(); ++j) {
      for (const Box& box : parts_seen(surface, {{us[i - 1], vs[j - 1]}, {us[i], vs[j]}}))
        add(box, area_of_cell(surface, box), 0);
    }
  }
  constexpr int deepest = 20;
  constexpr std::size_t most = 1u << 17u;
  while (!cells.empty() && cells.size() < most && sum.error > tolerance * sum.value) {
    const Cell worst = cells.top();
    cells.pop();
    if (worst.depth == deepest) continue;  // its error stays in the sum
    sum.value -= worst.area;
    sum.error -= worst.error;
    const std::array<Box, 4> parts = quarters_of(worst.box);
    for (std::size_t i = 0; i < 4; ++i) add(parts[i], worst.quarters[i], worst.depth + 1);
  }
  return sum;
}

double length(const Surface& surface, Point from, Point to) {
  const geom::Vector way = to - from;
  const auto speed = [&](double t) {
    const Jet jet = surface.jet(geom::interpolate(from, to, t));
    return geom::length(way.x * jet.u + way.y * jet.v);
  };
  // Cut where the line passes a break.
  std::vector<double> cuts{0.0, 1.0};
  for (const double at : surface.breaks().u) {
    if (way.x != 0.0) cuts.push_back((at - from.x) / way.x);
  }
  for (const double at : surface.breaks().v) {
    if (way.y != 0.0) cuts.push_back((at - from.y) / way.y);
  }
  std::erase_if(cuts, [](double t) { return t < 0.0 || t > 1.0; });
  std::sort(cuts.begin(), cuts.end());
  cuts = seen_along(
      surface, [&](double t) { return geom::interpolate(from, to, t); }, cuts);
  double sum = 0.0;
  for (std::size_t i = 1; i < cuts.size(); ++i) sum += geom::arc_length(speed, cuts[i - 1], cuts[i]);
  return sum;
}

}  // namespace dobra::surf
