#include "shared/surf/remesh/triangle_tree.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace dobra::surf::remesh {

using geom::Point3;
using geom::Vector3;

namespace {

constexpr std::uint32_t leaf = 4;

double beyond(double x, double low, double high) { return std::max({low - x, 0.0, x - high}); }

}  // namespace

Point3 nearest_on(Point3 p, Point3 a, Point3 b, Point3 c) {
  const Vector3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0.0 && d2 <= 0.0) return a;
  const Vector3 bp = p - b;
  const double d3 = dot(ab, bp), d4 = dot(ac, bp);
  if (d3 >= 0.0 && d4 <= d3) return b;
  const double of_c = d1 * d4 - d3 * d2;
  if (of_c <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return a + (d1 / (d1 - d3)) * ab;
  const Vector3 cp = p - c;
  const double d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d6 >= 0.0 && d5 <= d6) return c;
  const double of_b = d5 * d2 - d1 * d6;
  if (of_b <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return a + (d2 / (d2 - d6)) * ac;
  const double of_a = d3 * d6 - d5 * d4;
  if (of_a <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) return b + ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (c - b);
  const double sum = of_a + of_b + of_c;
  return a + (of_b / sum) * ab + (of_c / sum) * ac;
}

TriangleTree::TriangleTree(std::vector<Point3> points, std::vector<std::array<std::uint32_t, 3>> triangles)
    : points_(std::move(points)), triangles_(std::move(triangles)), order_(triangles_.size()) {
  std::iota(order_.begin(), order_.end(), 0U);
  nodes_.emplace_back();
  if (!order_.empty()) build(0, 0, static_cast<std::uint32_t>(order_.size()));
}

void TriangleTree::build(std::uint32_t node, std::uint32_t from, std::uint32_t to) {
  Point3 low = points_[triangles_[order_[from]][0]], high = low;
  for (std::uint32_t i = from; i < to; ++i) {
    for (const std::uint32_t v : triangles_[order_[i]]) {
      const Point3 p = points_[v];
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
  }
  nodes_[node] = {low, high, from, to - from};
  if (to - from <= leaf) return;
  const Vector3 size = high - low;
  const auto along = [&](std::uint32_t t) {
    double sum = 0.0;
    for (const std::uint32_t v : triangles_[t]) {
      const Point3 p = points_[v];
      sum += size.x >= size.y && size.x >= size.z ? p.x : size.y >= size.z ? p.y : p.z;
    }
    return sum;
  };
  const std::uint32_t middle = from + (to - from) / 2;
  std::nth_element(order_.begin() + from, order_.begin() + middle, order_.begin() + to,
                   [&](std::uint32_t a, std::uint32_t b) { return std::pair(along(a), a) < std::pair(along(b), b); });
  const auto child = static_cast<std::uint32_t>(nodes_.size());
  nodes_.resize(nodes_.size() + 2);
  nodes_[node].first = child;
  nodes_[node].count = 0;
  build(child, from, middle);
  build(child + 1, middle, to);
}

TriangleTree::Nearest TriangleTree::nearest(Point3 p) const {
  const auto bound = [&](std::uint32_t node) {
    const Node& n = nodes_[node];
    return geom::length(
        {beyond(p.x, n.low.x, n.high.x), beyond(p.y, n.low.y, n.high.y), beyond(p.z, n.low.z, n.high.z)});
  };
  Nearest best{0, std::numeric_limits<double>::infinity(), {}};
  std::array<std::pair<double, std::uint32_t>, 128> open{};
  std::size_t depth = 0;
  open[depth++] = {bound(0), 0};
  while (depth > 0) {
    const auto [least, number] = open[--depth];
    if (least >= best.distance) continue;
    const Node& node = nodes_[number];
    if (node.count == 0) {
      std::pair<double, std::uint32_t> near{bound(node.first), node.first}, far{bound(node.first + 1), node.first + 1};
      if (far.first < near.first) std::swap(near, far);
      open[depth++] = far;
      open[depth++] = near;
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const auto& [a, b, c] = triangles_[order_[i]];
      const Point3 at = nearest_on(p, points_[a], points_[b], points_[c]);
      const double distance = geom::distance(p, at);
      if (distance < best.distance) best = {order_[i], distance, at};
    }
  }
  return best;
}

}  // namespace dobra::surf::remesh
