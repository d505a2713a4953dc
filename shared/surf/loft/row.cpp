#include <algorithm>
#include <array>
#include <cmath>

#include "shared/surf/loft/through.h"

namespace dobra::surf::loft {

using geom::Point;
using geom::Vector;

namespace {

Vector way_of(const Section& section) { return section.trace.corners().back() - section.trace.corners().front(); }

/// Whether a trace lies before another in the middle of what both have beside each other along a direction; no where
/// they have nothing.
bool lies_before(const PlanTrace& trace, const PlanTrace& other, Vector along, Vector before) {
  const auto reach = [&](const PlanTrace& of) {
    std::array<double, 2> low_high{INFINITY, -INFINITY};
    for (const Point p : of.corners()) {
      const double at = geom::dot(p - Point{}, along);
      low_high = {std::min(low_high[0], at), std::max(low_high[1], at)};
    }
    return low_high;
  };
  const auto a = reach(trace), b = reach(other);
  const double low = std::max(a[0], b[0]), high = std::min(a[1], b[1]);
  if (!(low < high)) return false;
  const double middle = 0.5 * (low + high);
  const auto across = [&](const PlanTrace& of) {
    for (std::size_t i = 1; i < of.corners().size(); ++i) {
      const Point p = of.corners()[i - 1], q = of.corners()[i];
      const double from = geom::dot(p - Point{}, along), to = geom::dot(q - Point{}, along);
      if ((from <= middle) == (to <= middle)) continue;
      return geom::dot(geom::interpolate(p, q, (middle - from) / (to - from)) - Point{}, before);
    }
    return geom::dot(of.corners().front() - Point{}, before);
  };
  return across(trace) < across(other);
}

}  // namespace

Row row_of(const std::vector<Section>& sections, const std::vector<std::size_t>& which) {
  std::vector<Point> middles;
  Vector mean{};
  for (const std::size_t s : which) {
    const auto& trace = sections[s].trace;
    middles.push_back(trace.on_map(0.5 * trace.length()));
    mean = mean + (middles.back() - middles.front()) / static_cast<double>(which.size());
  }
  const Point centre = middles.front() + mean;
  double xx = 0.0, xy = 0.0, yy = 0.0;
  for (const Point p : middles) {
    const Vector d = p - centre;
    xx += d.x * d.x, xy += d.x * d.y, yy += d.y * d.y;
  }
  const double turn = 0.5 * std::atan2(2.0 * xy, xx - yy);
  const Vector axis{std::cos(turn), std::sin(turn)};
  Row row;
  row.order = which;
  const auto along = [&](std::size_t s) {
    const auto& trace = sections[s].trace;
    return geom::dot(trace.on_map(0.5 * trace.length()) - centre, axis);
  };
  std::stable_sort(row.order.begin(), row.order.end(),
                   [&](std::size_t a, std::size_t b) { return along(a) < along(b); });
  // Side by side, what lies before the other counts, not where its middle is.
  Vector common{};
  for (const std::size_t s : row.order) {
    const Vector way = geom::normalised(way_of(sections[s]));
    common = common + (geom::dot(way, common) < 0.0 ? -1.0 * way : way);
  }
  if (geom::length(common) > 0.0) {
    common = geom::normalised(common);
    Vector before{-common.y, common.x};
    if (geom::dot(before, axis) < 0.0) before = -1.0 * before;
    for (std::size_t pass = 1; pass < row.order.size(); ++pass) {
      for (std::size_t k = pass; k > 0; --k) {
        if (!lies_before(sections[row.order[k]].trace, sections[row.order[k - 1]].trace, common, before)) break;
        std::swap(row.order[k], row.order[k - 1]);
      }
    }
  }
  // The first that the document names stays in front.
  if (along(which.front()) > 0.0) std::reverse(row.order.begin(), row.order.end());
  for (std::size_t k = 0; k < row.order.size(); ++k) {
    const Vector way = geom::normalised(way_of(sections[row.order[k]]));
    const bool turned = k > 0 && geom::dot(way, way_of(sections[row.order[k - 1]])) < 0.0;
    row.against.push_back(k > 0 && (turned != row.against[k - 1]));
  }
  bool all_along = true;
  for (const std::size_t s : row.order)
    all_along = all_along && std::abs(geom::dot(geom::normalised(way_of(sections[s])), axis)) > 0.98;
  row.end_to_end = all_along;
  return row;
}

}  // namespace dobra::surf::loft
