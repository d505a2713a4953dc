#include "shared/geom/simplify.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace dobra::geom {
namespace {

struct Farthest {
  std::size_t index = 0;
  double distance = -1.0;
};

/// Of the points strictly between two positions of the chain; the first of equals.
Farthest farthest_between(const std::vector<Point>& chain, std::size_t from, std::size_t to) {
  Farthest farthest;
  const Segment segment{chain[from], chain[to]};
  for (std::size_t i = from + 1; i < to; ++i) {
    const double away = distance(segment, chain[i]);
    if (away > farthest.distance) farthest = {i, away};
  }
  return farthest;
}

/// Marks the points of chain[from..to] to keep, ends included.
void mark_kept(const std::vector<Point>& chain, std::size_t from, std::size_t to, double tolerance,
               std::vector<char>& kept) {
  std::vector<std::pair<std::size_t, std::size_t>> open{{from, to}};
  kept[from] = kept[to] = 1;
  while (!open.empty()) {
    const auto [begin, end] = open.back();
    open.pop_back();
    const Farthest farthest = farthest_between(chain, begin, end);
    if (farthest.distance <= tolerance) continue;
    kept[farthest.index] = 1;
    open.emplace_back(begin, farthest.index);
    open.emplace_back(farthest.index, end);
  }
}

Polyline simplified_contour(const Polyline& contour, double tolerance) {
  const std::size_t n = contour.points.size();
  const auto least = std::min_element(contour.points.begin(), contour.points.end());
  const auto shift = static_cast<std::size_t>(least - contour.points.begin());
  std::vector<Point> chain(n + 1);
  for (std::size_t i = 0; i <= n; ++i) chain[i] = contour.points[(i + shift) % n];
  const std::size_t opposite = farthest_between(chain, 0, n).index;
  std::vector<char> kept(n + 1, 0);
  mark_kept(chain, 0, opposite, tolerance, kept);
  mark_kept(chain, opposite, n, tolerance, kept);
  if (std::count(kept.begin(), kept.end() - 1, 1) < 3) {
    // A contour within tolerance of a line: keep the point farthest from that line too.
    const Farthest one = farthest_between(chain, 0, opposite);
    const Farthest other = farthest_between(chain, opposite, n);
    kept[one.distance >= other.distance ? one.index : other.index] = 1;
  }
  Polyline result;
  result.closed = true;
  for (std::size_t i = 0; i < n; ++i) {
    if (kept[(i + n - shift) % n] != 0) result.points.push_back(contour.points[i]);
  }
  return result;
}

}  // namespace

base::Result<Polyline> simplify(const Polyline& polyline, const SimplifyOptions& options) {
  if (!(options.tolerance >= 0.0)) {
    return base::Error{
        base::ErrorCode::InvalidOption,
        fmt::format("the tolerance of simplification must not be negative and is {}", options.tolerance)};
  }
  DOBRA_TRY_VOID(validate(polyline));
  const Polyline distinct = without_repeated_points(polyline);
  if (distinct.closed) return simplified_contour(distinct, options.tolerance);
  std::vector<char> kept(distinct.points.size(), 0);
  mark_kept(distinct.points, 0, distinct.points.size() - 1, options.tolerance, kept);
  Polyline result;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (kept[i] != 0) result.points.push_back(distinct.points[i]);
  }
  return result;
}

Polyline without_near_points(Polyline polyline, double least) {
  std::vector<Point> kept;
  for (const Point p : polyline.points) {
    if (kept.empty() || distance(kept.back(), p) > least) kept.push_back(p);
  }
  if (polyline.closed) {
    while (kept.size() > 1 && distance(kept.back(), kept.front()) <= least) kept.pop_back();
  } else if (!kept.empty() && kept.back() != polyline.points.back()) {
    while (kept.size() > 1 && distance(kept.back(), polyline.points.back()) <= least) kept.pop_back();
    kept.push_back(polyline.points.back());
  }
  polyline.points = std::move(kept);
  return polyline;
}

}  // namespace dobra::geom
