#include "recon/block/strip.h"

#include <algorithm>
#include <cmath>

// One bound after the other. A loop that crosses a bound falls into chains that begin and end on it; along the bound
// the first end is joined to the second, the third to the fourth, for between these is what the loops bound.

namespace recon::block {
namespace {

using geom::Point;
using geom::Polyline;

/// One bound: within is x >= at, or x <= at.
struct Bound {
  double at;
  bool above;

  [[nodiscard]] bool holds(Point p) const { return above ? p.x >= at : p.x <= at; }
  /// Where the way between two points on different sides meets it; the same from either end.
  [[nodiscard]] Point meet(Point a, Point b) const {
    if (a.x == at) return a;
    if (b.x == at) return b;
    if (b.x < a.x) std::swap(a, b);
    const double part = std::clamp((at - a.x) / (b.x - a.x), 0.0, 1.0);
    return {at, a.y == b.y ? a.y : a.y + part * (b.y - a.y)};
  }
};

/// The chains of a line on this side; of a closed line those that go through its first point are one.
std::vector<Polyline> chains_of(const Polyline& line, const Bound& bound) {
  std::vector<Polyline> chains;
  bool on = false;
  const std::size_t count = line.points.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Point p = line.points[i];
    const bool last = i + 1 == count;
    if (bound.holds(p)) {
      if (!on) chains.push_back({});
      on = true;
      chains.back().points.push_back(p);
    }
    if (last && !line.closed) break;
    const Point q = line.points[last ? 0 : i + 1];
    if (bound.holds(p) == bound.holds(q)) continue;
    if (!on) chains.push_back({});
    chains.back().points.push_back(bound.meet(p, q));
    on = !on;
  }
  if (line.closed && on && chains.size() > 1) {  // the last goes on as the first
    chains.back().points.insert(chains.back().points.end(), chains.front().points.begin(), chains.front().points.end());
    chains.front() = std::move(chains.back());
    chains.pop_back();
  }
  return chains;
}

bool crosses(const Polyline& loop, const Bound& bound) {
  const auto holds = [&](Point p) { return bound.holds(p); };
  return !std::all_of(loop.points.begin(), loop.points.end(), holds) &&
         std::any_of(loop.points.begin(), loop.points.end(), holds);
}

/// Chains that begin and end on the bound, joined along it.
std::vector<Polyline> joined(const std::vector<Polyline>& chains) {
  std::vector<std::size_t> ends(2 * chains.size());  // 2 * chain, and 1 more for its last point
  for (std::size_t i = 0; i < ends.size(); ++i) ends[i] = i;
  const auto height = [&](std::size_t end) {
    const std::vector<Point>& points = chains[end / 2].points;
    return (end % 2 == 0 ? points.front() : points.back()).y;
  };
  std::stable_sort(ends.begin(), ends.end(), [&](std::size_t a, std::size_t b) { return height(a) < height(b); });
  std::vector<std::size_t> partner(ends.size());
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
    partner[ends[i]] = ends[i + 1];
    partner[ends[i + 1]] = ends[i];
  }
  std::vector<Polyline> loops;
  std::vector<char> used(chains.size(), 0);
  for (std::size_t first = 0; first < chains.size(); ++first) {
    if (used[first] != 0) continue;
    Polyline loop{{}, true};
    for (std::size_t entered = 2 * first; used[entered / 2] == 0;) {
      std::vector<Point> points = chains[entered / 2].points;
      if (entered % 2 == 1) std::reverse(points.begin(), points.end());
      loop.points.insert(loop.points.end(), points.begin(), points.end());
      used[entered / 2] = 1;
      entered = partner[entered ^ 1U];
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

std::vector<Polyline> loops_at(const std::vector<Polyline>& loops, const Bound& bound) {
  std::vector<Polyline> kept, chains;
  for (const Polyline& loop : loops) {
    if (!crosses(loop, bound)) {
      if (!loop.points.empty() && bound.holds(loop.points.front())) kept.push_back(loop);
      continue;
    }
    for (Polyline& chain : chains_of(loop, bound)) chains.push_back(std::move(chain));
  }
  for (Polyline& loop : joined(chains)) {
    loop = geom::without_repeated_points(std::move(loop));
    if (loop.points.size() > 2 && geom::signed_area(loop) != 0.0) kept.push_back(std::move(loop));
  }
  return kept;
}

std::vector<Bound> bounds_of(const Strip& strip) {
  std::vector<Bound> bounds;
  if (std::isfinite(strip.from)) bounds.push_back({strip.from, true});
  if (std::isfinite(strip.to)) bounds.push_back({strip.to, false});
  return bounds;
}

}  // namespace

std::vector<Polyline> within(const Polyline& line, const Strip& strip) {
  std::vector<Polyline> pieces{line};
  for (const Bound& bound : bounds_of(strip)) {
    std::vector<Polyline> kept;
    for (const Polyline& piece : pieces) {
      for (Polyline& chain : chains_of(piece, bound)) {
        chain = geom::without_repeated_points(std::move(chain));
        if (chain.points.size() > 1) kept.push_back(std::move(chain));
      }
    }
    pieces = std::move(kept);
  }
  return pieces;
}

std::vector<Polyline> loops_within(std::vector<Polyline> loops, const Strip& strip) {
  for (const Bound& bound : bounds_of(strip)) loops = loops_at(loops, bound);
  return loops;
}

}  // namespace recon::block
