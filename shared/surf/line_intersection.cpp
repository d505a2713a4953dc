#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "shared/surf/cells.h"
#include "shared/surf/intersect.h"

namespace dobra::surf {

using base::Error;
using base::ErrorCode;
using geom::Box;
using geom::Point;
using geom::Point3;
using geom::Vector3;

namespace {

/// The line, with two unit axes across it: a point of the surface is on it where both its coordinates along them are
/// nought.
struct Line {
  Point3 from;
  Vector3 way, across, up;
  [[nodiscard]] Point off(Point3 p) const { return {dot(p - from, across), dot(p - from, up)}; }
  [[nodiscard]] Point off(Vector3 v) const { return {dot(v, across), dot(v, up)}; }
};

/// Solves [a b] x = r for columns a and b; nothing if they are parallel.
std::optional<Point> solved(Point a, Point b, Point r) {
  const double d = a.x * b.y - a.y * b.x;
  if (!(std::abs(d) > 1e-15 * std::hypot(a.x, a.y) * std::hypot(b.x, b.y))) return std::nullopt;
  return Point{(r.x * b.y - r.y * b.x) / d, (a.x * r.y - a.y * r.x) / d};
}

Point into(Point uv, const Box& box) {
  return {std::clamp(uv.x, box.low.x, box.high.x), std::clamp(uv.y, box.low.y, box.high.y)};
}

class LineSearch {
 public:
  LineSearch(const Surface& surface, const Line& line) : surface_(surface), line_(line), cells_(surface) {}

  /// @error InvalidOption
  base::Result<void> run() {
    std::vector<std::size_t> level;
    for (std::size_t i = 0; i < cells_.parts(); ++i) level.push_back(i);
    constexpr std::size_t most = 4000;
    for (int depth = 0; depth < 90 && !level.empty(); ++depth) {
      std::vector<std::size_t> next;
      for (const std::size_t cell : level) {
        if (is_settled(cell)) continue;
        for (const std::size_t half : cells_.halves(cell)) next.push_back(half);
      }
      level = std::move(next);
      if (level.size() > most) {
        const Point3 p = cells_[level.front()].hull.centre;
        return Error{
            ErrorCode::InvalidOption,
            fmt::format("the line lies in the surface, or touches it along a curve, at ({:.6g}, {:.6g}, {:.6g})", p.x,
                        p.y, p.z),
            base::Place{.item = "line", .x = p.x, .y = p.y}};
      }
    }
    return {};
  }
  std::vector<LineHit> hits;

 private:
  /// True if no halving is needed any more: no root in the cell, or the only one is known.
  bool is_settled(std::size_t number) {
    const Cells::Cell cell = cells_[number];
    const Hull& hull = cell.hull;
    const Point f = line_.off(hull.centre), u = line_.off(hull.along_u), v = line_.off(hull.along_v);
    if (std::abs(f.x) > std::abs(u.x) + std::abs(v.x) + hull.rest ||
        std::abs(f.y) > std::abs(u.y) + std::abs(v.y) + hull.rest)
      return true;
    const std::optional<Point> root = solved(u, v, {-f.x, -f.y});
    const double det = std::abs(u.x * v.y - u.y * v.x);
    if (root) {
      // What `rest` of any direction comes to in parts of the half cell.
      const double in_u = hull.rest * std::hypot(v.x, v.y) / det, in_v = hull.rest * std::hypot(u.x, u.y) / det;
      if (std::abs(root->x) > 1.0 + in_u || std::abs(root->y) > 1.0 + in_v) return true;
      // Kantorovich: over twice the cell the derivative stays so near that of the middle that one root is the most.
      const double turn = 2.0 * (hull.turn_u * std::hypot(v.x, v.y) + hull.turn_v * std::hypot(u.x, u.y)) / det;
      if (turn < 0.5) return newton(cell, *root);
    }
    // A small cell in which the tangent plane holds the line somewhere may be all about a touching.
    if (hull.radius() < 3e-2 * surface_.size()) {
      if (is_about_a_known_touch(cell)) return true;
      touch(cell);
      if (is_about_a_known_touch(cell)) return true;
    }
    if (hull.radius() <= 1e-11 * surface_.size()) {  // a pole, an apex
      if (std::hypot(f.x, f.y) <= 1e-11 * surface_.size()) add(into(cell.box.centre(), surface_.chart()), false);
      return true;
    }
    return false;
  }

  /// Finds the root of a cell that can have one only. False if Newton's rule goes astray.
  bool newton(const Cells::Cell& cell, Point start) {
    const double a = 0.5 * cell.box.width(), b = 0.5 * cell.box.height();
    const Point m = cell.box.centre();
    const Box& part = cells_.part(cell.part);
    Point uv = into({m.x + std::clamp(start.x, -1.0, 1.0) * a, m.y + std::clamp(start.y, -1.0, 1.0) * b}, part);
    const double enough = 1e-14 * (surface_.size() + geom::distance(cell.hull.centre, {}));
    double last = 1e300;
    for (int round = 0; round < 40; ++round) {
      const Jet jet = surface_.jet(uv);
      const Point f = line_.off(jet.at);
      const double off = std::hypot(f.x, f.y);
      const std::optional<Point> step = solved(line_.off(jet.u), line_.off(jet.v), {-f.x, -f.y});
      if (!step) return false;
      // Where it wants to go beyond the cell there is no root of this cell.
      const Point wanted{uv.x + step->x, uv.y + step->y};
      const double out_u = std::max(cell.box.low.x - wanted.x, wanted.x - cell.box.high.x) / a;
      const double out_v = std::max(cell.box.low.y - wanted.y, wanted.y - cell.box.high.y) / b;
      if (off <= enough || (round > 4 && off >= last)) {
        if (off > 1e3 * enough) return false;
        if (out_u > 1e-7 || out_v > 1e-7) return true;  // the neighbour's
        add(onto_border(uv), false);
        return true;
      }
      last = off;
      const Point next = into(wanted, part);
      if (next == uv) return std::max(out_u, out_v) > 1e-9;
      if (std::max(out_u, out_v) > 2.0 && round > 6) return true;
      uv = next;
    }
    return false;
  }

  /// Where the line lies in the tangent plane: n . way = 0 and nought along the only direction that both tangents still
  /// have across the line. If the surface is on the line there, it touches.
  void touch(const Cells::Cell& cell) {
    Point uv = cell.box.centre();
    for (int round = 0; round < 30; ++round) {
      const Jet jet = surface_.jet(uv);
      const Vector3 n = cross(jet.u, jet.v);
      const Point u = line_.off(jet.u), v = line_.off(jet.v), f = line_.off(jet.at);
      const bool by_u = std::hypot(u.x, u.y) * cell.box.width() > std::hypot(v.x, v.y) * cell.box.height();
      const Point along = by_u ? u : v;
      const double size = std::hypot(along.x, along.y);
      if (!(size > 0.0)) return;
      const Point t{along.x / size, along.y / size};
      const double g1 = dot(n, line_.way), g2 = f.x * t.x + f.y * t.y;
      const double g1_u = dot(cross(jet.uu, jet.v) + cross(jet.u, jet.uv), line_.way);
      const double g1_v = dot(cross(jet.uv, jet.v) + cross(jet.u, jet.vv), line_.way);
      const std::optional<Point> step =
          solved({g1_u, u.x * t.x + u.y * t.y}, {g1_v, v.x * t.x + v.y * t.y}, {-g1, -g2});
      if (!step) return;
      const Point next = into({uv.x + step->x, uv.y + step->y}, cells_.part(cell.part));
      if (std::abs(next.x - cell.box.centre().x) > 4.0 * cell.box.width() ||
          std::abs(next.y - cell.box.centre().y) > 4.0 * cell.box.height())
        return;
      const double moved = geom::length((next.x - uv.x) * jet.u + (next.y - uv.y) * jet.v);
      uv = next;
      if (moved <= 1e-14 * surface_.size()) break;
    }
    const Jet jet = surface_.jet(uv);
    const Point f = line_.off(jet.at);
    const double steep = std::abs(dot(cross(jet.u, jet.v), line_.way));
    if (std::hypot(f.x, f.y) > 1e-12 * surface_.size()) return;
    if (steep > 1e-6 * geom::length(cross(jet.u, jet.v))) return;
    add(onto_border(uv), true);
  }

  bool is_about_a_known_touch(const Cells::Cell& cell) const {
    return std::any_of(hits.begin(), hits.end(), [&](const LineHit& hit) {
      return hit.tangent && std::abs(hit.uv.x - cell.box.centre().x) <= 4.0 * cell.box.width() &&
             std::abs(hit.uv.y - cell.box.centre().y) <= 4.0 * cell.box.height();
    });
  }

  /// A place a hair from a border of the chart is on it.
  [[nodiscard]] Point onto_border(Point uv) const {
    const Box& chart = surface_.chart();
    const auto snap = [](double at, double low, double high) {
      const double hair = 1e-12 * (high - low);
      return at - low <= hair ? low : high - at <= hair ? high : at;
    };
    return {snap(uv.x, chart.low.x, chart.high.x), snap(uv.y, chart.low.y, chart.high.y)};
  }

  void add(Point uv, bool tangent) {
    const Point3 at = surface_.at(uv);
    for (const LineHit& hit : hits) {
      if (geom::distance(hit.at, at) <= 1e-10 * surface_.size()) return;
    }
    hits.push_back({dot(at - line_.from, line_.way), uv, at, tangent});
  }

  const Surface& surface_;
  const Line& line_;
  Cells cells_;
};

}  // namespace

base::Result<std::vector<LineHit>> intersect_line(const Surface& surface, Point3 from, Vector3 way, double from_t,
                                                  double to_t) {
  if (!geom::is_finite(from) || !geom::is_finite(way))
    return Error{ErrorCode::NotFinite, "the line has a number that is not finite"};
  const double length = geom::length(way);
  if (!(length > 0.0)) return Error{ErrorCode::DegenerateCurve, "the line has no direction"};
  const Vector3 unit = way / length;
  // The axis that is farthest from the line gives the first one across.
  const Vector3 axis = std::abs(unit.x) <= std::abs(unit.y) && std::abs(unit.x) <= std::abs(unit.z) ? Vector3{1, 0, 0}
                       : std::abs(unit.y) <= std::abs(unit.z)                                       ? Vector3{0, 1, 0}
                                                                                                    : Vector3{0, 0, 1};
  const Vector3 across = geom::normalised(cross(unit, axis));
  const Line line{from, unit, across, cross(unit, across)};
  LineSearch search(surface, line);
  DOBRA_TRY_VOID(search.run());
  std::vector<LineHit> hits;
  for (LineHit hit : search.hits) {
    hit.t /= length;
    if (hit.t >= from_t && hit.t <= to_t) hits.push_back(hit);
  }
  std::sort(hits.begin(), hits.end(), [](const LineHit& a, const LineHit& b) { return a.t < b.t; });
  return hits;
}

}  // namespace dobra::surf
