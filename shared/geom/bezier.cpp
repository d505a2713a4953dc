#include "shared/geom/bezier.h"

#include <fmt/format.h>

#include <algorithm>

#include "shared/base/check.h"
#include "shared/geom/arc_length.h"

namespace dobra::geom {

using base::Error;
using base::ErrorCode;
using base::Result;

namespace {

Result<void> check_vertices(std::span<const Point> vertices) {
  if (vertices.size() < 2) {
    return Error{ErrorCode::DegenerateCurve,
                 fmt::format("a Bezier curve has {} vertices; give at least two", vertices.size())};
  }
  for (const Point p : vertices) {
    if (!is_finite(p)) return Error{ErrorCode::NotFinite, "a vertex of a Bezier curve is not finite; correct it"};
  }
  return {};
}

/// Homogeneous coordinates (w x, w y, w); weight 1 for plain curves.
struct Weighted {
  double x, y, w;
  friend Weighted operator-(Weighted a, Weighted b) { return {a.x - b.x, a.y - b.y, a.w - b.w}; }
  friend Weighted operator*(double f, Weighted a) { return {f * a.x, f * a.y, f * a.w}; }
};
Weighted between(Weighted a, Weighted b, double t) {
  return {(1 - t) * a.x + t * b.x, (1 - t) * a.y + t * b.y, (1 - t) * a.w + t * b.w};
}
Point between(Point a, Point b, double t) { return interpolate(a, b, t); }

/// De Casteljau's scheme down to `left` vertices; on_level sees the first and the last vertex of every level.
template <class V, class OnLevel>
void de_casteljau(std::vector<V>& vertices, double t, std::size_t left, const OnLevel& on_level) {
  on_level(vertices.front(), vertices.back());
  while (vertices.size() > left) {
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i) vertices[i] = between(vertices[i], vertices[i + 1], t);
    vertices.pop_back();
    on_level(vertices.front(), vertices.back());
  }
}

template <class V>
std::vector<V> reduced(std::vector<V> vertices, double t, std::size_t left) {
  de_casteljau(vertices, t, left, [](const V&, const V&) {});
  return vertices;
}

template <class V>
std::pair<std::vector<V>, std::vector<V>> halves(std::vector<V> vertices, double t) {
  std::vector<V> before;
  std::vector<V> after;
  de_casteljau(vertices, t, 1, [&](const V& first, const V& last) {
    before.push_back(first);
    after.push_back(last);
  });
  std::reverse(after.begin(), after.end());
  return {std::move(before), std::move(after)};
}

std::vector<Weighted> homogeneous(std::span<const Point> vertices, std::span<const double> weights) {
  std::vector<Weighted> all;
  all.reserve(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    all.push_back({weights[i] * vertices[i].x, weights[i] * vertices[i].y, weights[i]});
  }
  return all;
}

}  // namespace

Result<Bezier> Bezier::make(std::vector<Point> vertices) {
  DOBRA_TRY_VOID(check_vertices(vertices));
  return Bezier(std::move(vertices));
}

Point Bezier::point(double t) const { return reduced(vertices_, t, 1).front(); }

Vector Bezier::tangent(double t) const {
  const std::vector<Point> last = reduced(vertices_, t, 2);
  return static_cast<double>(degree()) * (last[1] - last[0]);
}

double Bezier::length(double t0, double t1) const {
  return arc_length([this](double t) { return geom::length(tangent(t)); }, t0, t1);
}

std::pair<Bezier, Bezier> Bezier::split(double t) const {
  auto [before, after] = halves(vertices_, t);
  return {Bezier(std::move(before)), Bezier(std::move(after))};
}

Point smooth_continuation(const Bezier& before, std::size_t degree) {
  const auto vertices = before.vertices();
  const Point joint = vertices.back();
  const double ratio = static_cast<double>(before.degree()) / static_cast<double>(degree);
  return joint + ratio * (joint - vertices[vertices.size() - 2]);
}

Bezier bezier_of(const HermiteCubic& cubic) {
  return Bezier({cubic.from, cubic.from + cubic.from_tangent / 3.0, cubic.to - cubic.to_tangent / 3.0, cubic.to});
}

HermiteCubic hermite_of(const Bezier& cubic) {
  DOBRA_CHECK(cubic.degree() == 3);
  const auto v = cubic.vertices();
  return {v[0], v[3], 3.0 * (v[1] - v[0]), 3.0 * (v[3] - v[2])};
}

Result<RationalBezier> RationalBezier::make(std::vector<Point> vertices, std::vector<double> weights) {
  DOBRA_TRY_VOID(check_vertices(vertices));
  if (weights.size() != vertices.size()) {
    return Error{ErrorCode::InvalidOption,
                 fmt::format("a rational Bezier curve has {} vertices and {} weights; give one weight a vertex",
                             vertices.size(), weights.size())};
  }
  for (const double w : weights) {
    if (!(w > 0.0) || !std::isfinite(w)) {
      return Error{ErrorCode::InvalidOption,
                   fmt::format("a weight of a rational Bezier curve is {}; it must be above 0", w)};
    }
  }
  return RationalBezier(std::move(vertices), std::move(weights));
}

Point RationalBezier::point(double t) const {
  const Weighted p = reduced(homogeneous(vertices_, weights_), t, 1).front();
  return {p.x / p.w, p.y / p.w};
}

Vector RationalBezier::tangent(double t) const {
  const std::vector<Weighted> last = reduced(homogeneous(vertices_, weights_), t, 2);
  const Weighted p = between(last[0], last[1], t);
  const Weighted slope = static_cast<double>(vertices_.size() - 1) * (last[1] - last[0]);
  // (x / w)' = (x' - (x / w) w') / w
  return {(slope.x - p.x / p.w * slope.w) / p.w, (slope.y - p.y / p.w * slope.w) / p.w};
}

double RationalBezier::length(double t0, double t1) const {
  return arc_length([this](double t) { return geom::length(tangent(t)); }, t0, t1);
}

std::pair<RationalBezier, RationalBezier> RationalBezier::split(double t) const {
  const auto plain = [](const std::vector<Weighted>& all) {
    std::vector<Point> vertices;
    std::vector<double> weights;
    for (const Weighted& v : all) {
      vertices.push_back({v.x / v.w, v.y / v.w});
      weights.push_back(v.w);
    }
    return RationalBezier(std::move(vertices), std::move(weights));
  };
  const auto [before, after] = halves(homogeneous(vertices_, weights_), t);
  return {plain(before), plain(after)};
}

}  // namespace dobra::geom
