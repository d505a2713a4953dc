#include "shared/surf/param/discrete_chart.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "shared/geom/predicates.h"
#include "shared/geom/segment.h"

namespace dobra::surf::param {

using geom::Box;
using geom::Point;
using geom::Vector;
using geom::Vector3;

namespace {

geom::SpatialIndex index_of(const Sheet& sheet, const std::vector<Point>& uv) {
  std::vector<Box> boxes(sheet.triangles.size());
  for (std::size_t t = 0; t < boxes.size(); ++t) {
    for (const std::uint32_t v : sheet.triangles[t]) boxes[t].add(uv[v]);
  }
  return geom::SpatialIndex(boxes);
}

struct PiecesShape : Surface::Shape {
  std::shared_ptr<const DiscreteChart> chart;
  explicit PiecesShape(std::shared_ptr<const DiscreteChart> of) : chart(std::move(of)) {}

  struct Tangents {
    Vector3 u, v;
  };
  [[nodiscard]] Tangents tangents(std::uint32_t triangle) const {
    const auto slopes = chart->slopes(triangle);
    const auto& t = chart->sheet().triangles[triangle];
    Tangents made;
    for (std::size_t i = 1; i < 3; ++i) {
      const Vector3 side = chart->sheet().points[t[i]] - chart->sheet().points[t[0]];
      made.u = made.u + slopes[i].x * side;
      made.v = made.v + slopes[i].y * side;
    }
    return made;
  }
  void jets(std::span<const Point> uv, std::span<Jet> jets) const override {
    std::optional<std::uint32_t> hint;
    for (std::size_t i = 0; i < uv.size(); ++i) {
      const Located place = chart->locate(uv[i], hint);
      hint = place.triangle;
      const auto& t = chart->sheet().triangles[place.triangle];
      const auto& points = chart->sheet().points;
      const Tangents by = tangents(place.triangle);
      jets[i] = {points[t[0]] + place.at[1] * (points[t[1]] - points[t[0]]) +
                     place.at[2] * (points[t[2]] - points[t[0]]) + place.beyond.x * by.u + place.beyond.y * by.v,
                 by.u,
                 by.v,
                 {},
                 {},
                 {}};
    }
  }
  [[nodiscard]] Bend bend(const Box& part) const override {
    double u = 0.0, v = 0.0;
    chart->for_each_in(part, [&](std::uint32_t t) {
      const Tangents here = tangents(t);
      for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
        const HalfEdge twin = chart->sheet().twins[h];
        if (twin == no_half_edge) continue;
        const Tangents there = tangents(twin / 3);
        u = std::max(u, geom::length(there.u - here.u));
        v = std::max(v, geom::length(there.v - here.v));
      }
    });
    const double wide = std::max(part.width(), 1e-300), high = std::max(part.height(), 1e-300);
    return {2.0 * u / wide, 2.0 * std::max(u / high, v / wide), 2.0 * v / high};
  }
};

}  // namespace

DiscreteChart::DiscreteChart(Sheet sheet, std::vector<Point> uv)
    : sheet_(std::move(sheet)), uv_(std::move(uv)), index_(index_of(sheet_, uv_)) {
  std::vector<Box> boxes;
  for (HalfEdge h = 0; h < sheet_.twins.size(); ++h) {
    if (sheet_.twins[h] != no_half_edge) continue;
    border_.push_back(h);
    boxes.emplace_back();
    boxes.back().add(uv_[sheet_.start(h)]);
    boxes.back().add(uv_[sheet_.end(h)]);
  }
  border_index_ = geom::SpatialIndex(boxes);
}

std::array<double, 3> DiscreteChart::coordinates(std::uint32_t triangle, Point p) const {
  const auto& t = sheet_.triangles[triangle];
  const Point a = uv_[t[0]], b = uv_[t[1]], c = uv_[t[2]];
  const double all = cross(b - a, c - a), of_b = cross(p - a, c - a) / all, of_c = cross(b - a, p - a) / all;
  return {1.0 - of_b - of_c, of_b, of_c};
}

std::array<Vector, 3> DiscreteChart::slopes(std::uint32_t triangle) const {
  const auto& t = sheet_.triangles[triangle];
  const Vector b = uv_[t[1]] - uv_[t[0]], c = uv_[t[2]] - uv_[t[0]];
  const double all = cross(b, c);
  const Vector of_b{c.y / all, -c.x / all}, of_c{-b.y / all, b.x / all};
  return {-(of_b + of_c), of_b, of_c};
}

/// From triangle to triangle towards the place; nothing where that does not end soon well inside of one.
std::optional<Located> DiscreteChart::walk(Point p, std::uint32_t from) const {
  constexpr int steps = 24;
  constexpr double well_inside = 1e-9;
  for (int step = 0; step < steps; ++step) {
    const auto at = coordinates(from, p);
    const auto least = static_cast<HalfEdge>(std::min_element(at.begin(), at.end()) - at.begin());
    if (at[least] > well_inside) return Located{from, at, true};
    if (at[least] > -well_inside || !std::isfinite(at[least])) return std::nullopt;
    const HalfEdge twin = sheet_.twins[3 * from + (least + 1) % 3];  // the side opposite to that corner
    if (twin == no_half_edge) return std::nullopt;
    from = twin / 3;
  }
  return std::nullopt;
}

Located DiscreteChart::locate(Point p, std::optional<std::uint32_t> hint) const {
  if (hint) {
    if (const auto found = walk(p, *hint)) return *found;
  }
  std::optional<std::uint32_t> lowest;
  index_.for_each_overlapping({p, p}, [&](std::size_t item) {
    const auto t = static_cast<std::uint32_t>(item);
    if (lowest && *lowest < t) return;
    const auto& [a, b, c] = sheet_.triangles[t];
    const auto outside = [&](std::uint32_t from, std::uint32_t to) {
      return geom::orient2d(uv_[from], uv_[to], p) == geom::Sign::Negative;
    };
    if (!outside(a, b) && !outside(b, c) && !outside(c, a)) lowest = t;
  });
  if (lowest) return {*lowest, coordinates(*lowest, p), true};
  const auto nearest = border_index_.nearest(p, [&](std::size_t item) {
    const geom::Segment side{uv_[sheet_.start(border_[item])], uv_[sheet_.end(border_[item])]};
    return distance(p, geom::interpolate(side.from, side.to, nearest_fraction(side, p)));
  });
  const HalfEdge h = nearest ? border_[nearest->item] : 0;
  const geom::Segment side{uv_[sheet_.start(h)], uv_[sheet_.end(h)]};
  const double part = nearest_fraction(side, p);
  Located found{h / 3, {}, false, p - geom::interpolate(side.from, side.to, part)};
  found.at[h % 3] = 1.0 - part;
  found.at[next(h) % 3] = part;
  return found;
}

base::Result<Surface> plane_pieces(std::shared_ptr<const DiscreteChart> chart) {
  const Box box = chart->box();
  return Surface::of(std::make_shared<const PiecesShape>(std::move(chart)), box);
}

}  // namespace dobra::surf::param
