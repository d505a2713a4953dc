#include "quebra/sketch/ends.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

namespace quebra::sketch {

using dobra::geom::Arc;
using dobra::geom::Point;
using dobra::geom::Polyline;

namespace {

/// By how much the ends of an arc may differ in their distance to its centre, as a fraction, once they are joined.
constexpr double arc_tolerance = 1e-6;

}  // namespace

std::vector<End> open_ends(const std::vector<Curve>& curves) {
  std::vector<End> ends;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (closed(curves[i])) continue;
    ends.push_back({i, false, point(curves[i], 0.0)});
    ends.push_back({i, true, point(curves[i], length(curves[i]))});
  }
  return ends;
}

std::vector<NearEnds> near_ends(const std::vector<End>& ends, double tolerance) {
  std::vector<std::size_t> by_x(ends.size());
  std::iota(by_x.begin(), by_x.end(), std::size_t{0});
  std::sort(by_x.begin(), by_x.end(), [&](std::size_t a, std::size_t b) { return ends[a].at.x < ends[b].at.x; });
  std::vector<NearEnds> pairs;
  for (std::size_t i = 0; i < by_x.size(); ++i) {
    for (std::size_t j = i + 1; j < by_x.size() && ends[by_x[j]].at.x - ends[by_x[i]].at.x <= tolerance; ++j) {
      const double gap = distance(ends[by_x[i]].at, ends[by_x[j]].at);
      if (gap <= tolerance) pairs.push_back({gap, std::min(by_x[i], by_x[j]), std::max(by_x[i], by_x[j])});
    }
  }
  std::sort(pairs.begin(), pairs.end(),
            [](const NearEnds& x, const NearEnds& y) { return std::tie(x.gap, x.a, x.b) < std::tie(y.gap, y.a, y.b); });
  return pairs;
}

std::string gap_text(const std::vector<Curve>& curves, const End& a, const End& b) {
  const auto text = [&](const End& end) {
    return fmt::format("({:.6g}, {:.6g}) of '{}'", end.at.x, end.at.y, curves[end.curve].name);
  };
  return fmt::format("a gap of {:.3g} m between {} and {}", distance(a.at, b.at), text(a), text(b));
}

bool move_end(Curve& curve, bool last, Point to) {
  if (auto* arc = std::get_if<Arc>(&curve.shape)) {
    const auto orientation =
        arc->sweep().radians() > 0.0 ? dobra::geom::Orientation::Anticlockwise : dobra::geom::Orientation::Clockwise;
    const Point start = last ? point(curve, 0.0) : to;
    const Point end = last ? to : point(curve, length(curve));
    auto moved = Arc::from_ends(arc->centre(), start, end, orientation, arc_tolerance);
    if (moved) *arc = *moved;
    return moved.ok();
  }
  if (auto* smooth = std::get_if<Smooth>(&curve.shape)) {
    std::vector<dobra::geom::HermiteCubic> cubics(smooth->path().cubics().begin(), smooth->path().cubics().end());
    (last ? cubics.back().to : cubics.front().from) = to;
    auto moved = Smooth::make({std::move(cubics), {smooth->path().knots().begin(), smooth->path().knots().end()}});
    const bool can = moved.ok();
    if (can) *smooth = *std::move(moved);
    return can;
  }
  auto& points = std::get<Polyline>(curve.shape).points;
  (last ? points.back() : points.front()) = to;
  return true;
}

void join_ends(std::vector<Curve>& curves, double tolerance) {
  const std::vector<End> ends = open_ends(curves);
  std::vector<std::size_t> same_as(ends.size());
  std::iota(same_as.begin(), same_as.end(), std::size_t{0});
  const auto root = [&](std::size_t i) {
    while (same_as[i] != i) i = same_as[i] = same_as[same_as[i]];
    return i;
  };
  for (const NearEnds& pair : near_ends(ends, tolerance)) {
    const std::size_t a = root(pair.a);
    const std::size_t b = root(pair.b);
    same_as[std::max(a, b)] = std::min(a, b);
  }
  // Lines move to arcs rather than arcs to lines: an arc keeps its centre, and can follow but a little.
  std::map<std::size_t, Point> target;
  for (const bool arcs : {true, false}) {
    for (std::size_t i = 0; i < ends.size(); ++i) {
      if (std::holds_alternative<Arc>(curves[ends[i].curve].shape) == arcs) target.try_emplace(root(i), ends[i].at);
    }
  }
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const Point to = target.at(root(i));
    if (to != ends[i].at) move_end(curves[ends[i].curve], ends[i].last, to);
  }
}

}  // namespace quebra::sketch
