#include "shared/surf/closest.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>

#include "shared/surf/cells.h"

namespace dobra::surf {

using geom::Box;
using geom::Point;
using geom::Point3;
using geom::Vector3;

namespace {

Foot foot_at(const Surface& surface, Point3 point, Point uv) {
  const Point3 at = surface.at(uv);
  return {uv, at, geom::distance(at, point)};
}

Point clamped(Point uv, const Box& box) {
  return {std::clamp(uv.x, box.low.x, box.high.x), std::clamp(uv.y, box.low.y, box.high.y)};
}

/// Half the square of the distance, by u and v.
struct Slope {
  double u, v, uu, uv, vv;
};
Slope slope_of(const Jet& jet, Point3 point) {
  const Vector3 r = jet.at - point;
  return {dot(r, jet.u), dot(r, jet.v), dot(jet.u, jet.u) + dot(r, jet.uu), dot(jet.u, jet.v) + dot(r, jet.uv),
          dot(jet.v, jet.v) + dot(r, jet.vv)};
}

/// A step downhill; by Newton's rule where the distance bends upwards, else down the bend or the slope. `free` says
/// which parameters may change.
Point step_of(const Jet& jet, const Slope& s, bool free_u, bool free_v) {
  const double e = dot(jet.u, jet.u), g = dot(jet.v, jet.v);
  if (!free_u && !free_v) return {};
  if (!free_v) return {s.uu > 1e-3 * e ? -s.u / s.uu : e > 0.0 ? -s.u / e : 0.0, 0.0};
  if (!free_u) return {0.0, s.vv > 1e-3 * g ? -s.v / s.vv : g > 0.0 ? -s.v / g : 0.0};
  // In units in which both tangents have length one; more is added until the form is safely positive.
  const double eu = e > 0.0 ? std::sqrt(e) : 1.0, ev = g > 0.0 ? std::sqrt(g) : 1.0;
  const double a = s.uu / (eu * eu), b = s.uv / (eu * ev), c = s.vv / (ev * ev);
  const double least = 0.5 * (a + c) - std::hypot(0.5 * (a - c), b);
  const double more = least > 1e-3 ? 0.0 : 1e-3 - least + 0.1 * std::abs(least);
  const double p = a + more, q = c + more, d = p * q - b * b;
  const double x = s.u / eu, y = s.v / ev;
  return {-(q * x - b * y) / (d * eu), -(p * y - b * x) / (d * ev)};
}

struct Walk {
  Foot foot;
  bool arrived = false;
  Box seen;  ///< Where it went.
};

/// The distance says where it is least to half of the digits only; its slope says the rest.
void polish(const Surface& surface, Point3 point, const Box& box, Foot& foot) {
  const auto steepness = [&](const Jet& jet, const Slope& s, bool free_u, bool free_v) {
    const double e = geom::length(jet.u), g = geom::length(jet.v);
    return std::hypot(free_u && e > 0.0 ? s.u / e : 0.0, free_v && g > 0.0 ? s.v / g : 0.0);
  };
  for (int round = 0; round < 6; ++round) {
    const Point uv = foot.uv;
    const Jet jet = surface.jet(uv);
    const Slope s = slope_of(jet, point);
    const bool free_u = uv.x > box.low.x && uv.x<box.high.x, free_v = uv.y> box.low.y && uv.y < box.high.y;
    const Point step = step_of(jet, s, free_u, free_v);
    const Point next = clamped({uv.x + step.x, uv.y + step.y}, box);
    const Jet there = surface.jet(next);
    if (geom::distance(there.at, jet.at) > 1e-6 * surface.size() ||
        !(steepness(there, slope_of(there, point), free_u, free_v) < 0.5 * steepness(jet, s, free_u, free_v)))
      break;
    foot = {next, there.at, geom::distance(there.at, point)};
  }
}

/// Parts of the size, but no less than what places as far from the origin as the point can tell apart.
double told_apart(const Surface& surface, Point3 point, double part) {
  constexpr double doubles = 8.0 * std::numeric_limits<double>::epsilon();
  return std::max(part * surface.size(), doubles * std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)}));
}

/// Downhill within a box in which the surface is smooth.
Walk walk(const Surface& surface, Point3 point, Point from, const Box& box) {
  Walk walk{foot_at(surface, point, clamped(from, box)), false, {}};
  const double enough = told_apart(surface, point, 1e-15);
  const double nearer = told_apart(surface, point, 1e-12);
  for (int round = 0; round < 200; ++round) {
    Point& uv = walk.foot.uv;
    walk.seen.add(uv);
    const Jet jet = surface.jet(uv);
    const Slope s = slope_of(jet, point);
    const bool free_u = !((uv.x == box.low.x && s.u >= 0.0) || (uv.x == box.high.x && s.u <= 0.0));
    const bool free_v = !((uv.y == box.low.y && s.v >= 0.0) || (uv.y == box.high.y && s.v <= 0.0));
    const Point step = step_of(jet, s, free_u, free_v);
    bool moved = false;
    double part = 1.0;
    for (int halving = 0; halving < 60; ++halving, part *= 0.5) {
      const Point next = clamped({uv.x + part * step.x, uv.y + part * step.y}, box);
      const geom::Vector by = next - uv;
      if (geom::length(by.x * jet.u + by.y * jet.v) <= enough) break;
      const Foot there = foot_at(surface, point, next);
      // As much as the slope promises, in part: over a seam the same place is no progress.
      const double promised = s.u * by.x + s.v * by.y;
      if (there.distance < walk.foot.distance &&
          0.5 * (walk.foot.distance - there.distance) * (walk.foot.distance + there.distance) >= -1e-4 * promised) {
        walk.foot = there;
        moved = true;
        break;
      }
    }
    if (moved) continue;
    // A level place that is no valley: off along the way on which it bends down most, and some others.
    const double eu = std::max(geom::length(jet.u), 1e-300), ev = std::max(geom::length(jet.v), 1e-300);
    const double turn = 0.5 * std::atan2(2.0 * s.uv / (eu * ev), s.uu / (eu * eu) - s.vv / (ev * ev));
    bool left = false;
    for (const double hop : {3e-2, 1e-3, 3e-5}) {
      for (int k = 0; k < 16 && !left; ++k) {
        const double angle = turn + std::numbers::pi / 8.0 * (k + 4);
        const double by = hop * surface.size();
        const Point off{std::clamp(by / eu * std::cos(angle), -0.1 * box.width(), 0.1 * box.width()),
                        std::clamp(by / ev * std::sin(angle), -0.1 * box.height(), 0.1 * box.height())};
        const Foot there = foot_at(surface, point, clamped({uv.x + off.x, uv.y + off.y}, box));
        if (there.distance < walk.foot.distance - nearer) walk.foot = there, left = true;
      }
      if (left) break;
    }
    if (!left) {
      walk.arrived = true;
      break;
    }
  }
  if (walk.arrived) polish(surface, point, box, walk.foot);
  return walk;
}

/// The nearest of all in a part of the chart, if it is nearer than `best` by more than the tolerance.
void search(Cells& cells, Point3 point, const Box& part, double tolerance, Foot& best) {
  struct Candidate {
    double least;
    std::size_t cell;
    bool operator<(const Candidate& other) const { return least > other.least; }
  };
  const Surface& surface = cells.surface();
  std::priority_queue<Candidate> queue;
  const auto add = [&](std::size_t number) {
    const Cells::Cell& cell = cells[number];
    if (!cell.box.overlaps(part)) return;
    const Vector3 to = point - cell.hull.centre;
    const double away = geom::length(to);
    // Along the way to the point, and by the ball.
    const double least = away > 0.0 ? away - cell.hull.reach(to / away) : 0.0;
    if (least >= best.distance - tolerance) return;
    const Point middle = clamped(cell.box.centre(), part);
    if (geom::distance(surface.at(middle), point) < best.distance) {
      const Foot found = walk(surface, point, middle, cells.part(cell.part)).foot;
      if (part.contains(found.uv) && found.distance < best.distance) best = found;
    }
    queue.push({least, number});
  };
  for (std::size_t i = 0; i < cells.parts(); ++i) add(i);
  while (!queue.empty()) {
    const Candidate next = queue.top();
    queue.pop();
    if (next.least >= best.distance - tolerance) break;
    for (const std::size_t half : cells.halves(next.cell)) add(half);
  }
}

}  // namespace

Foot closest_of_all(const Surface& surface, Point3 point) {
  Cells cells(surface);
  Foot best = foot_at(surface, point, surface.chart().low);
  search(cells, point, surface.chart(), told_apart(surface, point, 1e-9), best);
  return best;
}

Foot closest(const Surface& surface, Point3 point, Point near) {
  const Box& chart = surface.chart();
  const std::vector<Box> parts = smooth_parts(surface);
  const double gain = told_apart(surface, point, 1e-13);
  Foot best = foot_at(surface, point, clamped(near, chart));
  const auto goes_on_from = [&](Point from) {
    bool better = false;
    for (const Box& part : parts) {
      // Parts end a double before the next begins.
      const Point at = clamped(from, part);
      const double off = std::max(std::abs(at.x - from.x) / chart.width(), std::abs(at.y - from.y) / chart.height());
      if (off > 1e-14) continue;
      Walk done = walk(surface, point, at, part);
      if (!done.arrived) {
        // Not seen to happen; then the place where it went is searched through.
        const double du = std::max(1e-3 * part.width(), done.seen.width()),
                     dv = std::max(1e-3 * part.height(), done.seen.height());
        const Box around{clamped({done.seen.low.x - du, done.seen.low.y - dv}, part),
                         clamped({done.seen.high.x + du, done.seen.high.y + dv}, part)};
        Cells cells(surface);
        search(cells, point, around, gain, done.foot);
      }
      if (done.foot.distance < best.distance - (better ? 0.0 : gain)) best = done.foot, better = true;
      if (done.foot.distance < best.distance) best = done.foot;
    }
    return better;
  };
  goes_on_from(best.uv);
  // A valley of one part may be a slope of the next, over a seam, or on another line that ends in the pole.
  for (int round = 0; round < 64; ++round) {
    const Point at = best.uv;
    std::vector<Point> doors{at};
    const double hair_u = 1e-6 * chart.width(), hair_v = 1e-6 * chart.height();
    const bool on_left = at.x <= chart.low.x + hair_u, on_right = at.x >= chart.high.x - hair_u;
    const bool on_bottom = at.y <= chart.low.y + hair_v, on_top = at.y >= chart.high.y - hair_v;
    if (surface.closed_u() && (on_left || on_right)) doors.push_back({on_left ? chart.high.x : chart.low.x, at.y});
    if (surface.closed_v() && (on_bottom || on_top)) doors.push_back({at.x, on_bottom ? chart.high.y : chart.low.y});
    constexpr int lines = 24;
    for (int k = 0; k <= lines; ++k) {
      const double part = static_cast<double>(k) / lines;
      if ((on_left && surface.collapsed(Side::Left)) || (on_right && surface.collapsed(Side::Right)))
        doors.push_back({on_left ? chart.low.x : chart.high.x, std::lerp(chart.low.y, chart.high.y, part)});
      if ((on_bottom && surface.collapsed(Side::Bottom)) || (on_top && surface.collapsed(Side::Top)))
        doors.push_back({std::lerp(chart.low.x, chart.high.x, part), on_bottom ? chart.low.y : chart.high.y});
    }
    bool better = false;
    for (const Point door : doors) better = goes_on_from(door) || better;
    if (!better) break;
  }
  return best;
}

}  // namespace dobra::surf
