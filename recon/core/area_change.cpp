#include "recon/core/area_change.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace recon::core {

namespace {

/// Walks along lines and keeps the extremes of what it meets on one side of them.
class Search {
 public:
  explicit Search(const SectionMap& map) : map_(map) {}

  /// @param side  +1: the cells on the left of the line, -1: on the right.
  void follow(const geom::Polyline& line, double side) {
    // The line itself may be a side of cells: it is traced a little beside itself, each segment alone.
    geom::Polyline beside;
    std::vector<geom::Vector> steps;
    for (std::size_t i = 0; i < line.segment_count(); ++i) {
      const geom::Segment segment = line.segment(i);
      const geom::Vector along = segment.vector();
      const double part = std::min(1e-3, map_.tolerances().chord / std::hypot(along.x, along.y));
      steps.push_back(side * part * geom::Vector{-along.y, along.x});
      beside.points.push_back(segment.from + steps.back());
      beside.points.push_back(segment.to + steps.back());
    }
    const MappedLine traced = map_.through_cells(beside);
    for (std::size_t i = 0; i < steps.size(); ++i) {
      for (std::size_t k = traced.given[2 * i]; k < traced.given[2 * i + 1]; ++k) {
        const geom::Segment part{traced.before.points[k], traced.before.points[k + 1]};
        if (!line.closed || !is_cut_off(line, i, part)) piece(part, -steps[i]);
      }
    }
  }

  [[nodiscard]] const std::optional<AreaChange>& found() const { return found_; }

 private:
  /// Whether a piece beside segment i of a contour lies outside of it, at a corner where the contour turns inwards.
  static bool is_cut_off(const geom::Polyline& contour, std::size_t i, const geom::Segment& piece) {
    const std::size_t count = contour.segment_count();
    const geom::Vector along = contour.segment(i).vector();
    const geom::Segment before = contour.segment((i + count - 1) % count);
    const geom::Segment after = contour.segment((i + 1) % count);
    const geom::Point p = geom::midpoint(piece.from, piece.to);
    const auto right_of = [&](const geom::Segment& s) { return geom::cross(s.vector(), p - s.from) <= 0.0; };
    return (geom::cross(before.vector(), along) > 0.0 && right_of(before)) ||
           (geom::cross(along, after.vector()) > 0.0 && right_of(after));
  }

  /// A piece that lies in one cell, and as much beside the line.
  void piece(const geom::Segment& segment, geom::Vector to_line) {
    if (segment.length() <= map_.tolerances().tear) return;  // where the line is torn; a cell of rounding
    const geom::Point in = geom::midpoint(segment.from, segment.to);
    const auto point = [&](double t) { return geom::interpolate(segment.from, segment.to, t) + to_line; };
    const std::array<geom::Point, 5> points{point(0.0), point(0.25), point(0.5), point(0.75), point(1.0)};
    std::array<double, 5> values{};
    if (!map_.determinants(in, points, values, hint_)) return;
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (std::isfinite(values[k])) include(found_, values[k] - 1.0, points[k]);
    }
    for (std::size_t k = 1; k + 1 < points.size(); ++k) {
      const double before = values[k] - values[k - 1];
      const double after = values[k + 1] - values[k];
      const double rounding = 1e-9 * std::abs(values[k]);
      if (!(before * after < 0.0) || std::min(std::abs(before), std::abs(after)) < rounding) continue;
      const double sign = before > 0.0 ? 1.0 : -1.0;
      polish(in, points[k - 1], points[k + 1], sign);
    }
  }

  /// The one extreme between two places (sign > 0: the greatest), by golden sections.
  void polish(geom::Point in, geom::Point from, geom::Point to, double sign) {
    constexpr double part = 1.0 / std::numbers::phi;
    const auto value = [&](double t) {
      const geom::Point p = geom::interpolate(from, to, t);
      double found = 0.0;
      map_.determinants(in, {&p, 1}, {&found, 1}, hint_);
      if (!std::isfinite(found)) return -std::numeric_limits<double>::infinity();
      include(found_, found - 1.0, p);
      return sign * found;
    };
    double low = 0.0;
    double high = 1.0;
    double left = high - part * (high - low);
    double right = low + part * (high - low);
    double at_left = value(left);
    double at_right = value(right);
    while (high - low > 1e-8) {
      if (at_left > at_right) {
        high = std::exchange(right, left);
        left = high - part * (high - low);
        at_right = std::exchange(at_left, value(left));
      } else {
        low = std::exchange(left, right);
        right = low + part * (high - low);
        at_left = std::exchange(at_right, value(right));
      }
    }
  }

  const SectionMap& map_;
  Cell hint_;
  std::optional<AreaChange> found_;
};

/// Two vertices that differ by rounding have no direction between them.
geom::Polyline without_tiny_pieces(const geom::Polyline& contour, double least) {
  geom::Polyline kept;
  kept.closed = true;
  for (const geom::Point p : contour.points) {
    if (kept.points.empty() || geom::distance(kept.points.back(), p) > least) kept.points.push_back(p);
  }
  while (kept.points.size() > 1 && geom::distance(kept.points.back(), kept.points.front()) <= least)
    kept.points.pop_back();
  return kept;
}

}  // namespace

void include(std::optional<AreaChange>& change, double value, geom::Point at) {
  if (!change) change = AreaChange{value, value, at, at};
  if (value < change->least) {
    change->least = value;
    change->least_at = at;
  }
  if (value > change->greatest) {
    change->greatest = value;
    change->greatest_at = at;
  }
}

std::optional<AreaChange> area_change_in(std::span<const geom::Polyline> contours, const SectionMap& map,
                                         std::span<const geom::Polyline> lines) {
  Search search(map);
  if (contours.empty()) return std::nullopt;
  if (map.keeps_areas()) return AreaChange{0.0, 0.0, contours.front().points.front(), contours.front().points.front()};
  for (const geom::Polyline& contour : contours)
    search.follow(without_tiny_pieces(contour, map.tolerances().tear), 1.0);
  const auto inside = [&](geom::Point p) {
    const auto winds = [&](const geom::Polyline& c) { return geom::locate(c, p) == geom::Side::Inside; };
    return std::count_if(contours.begin(), contours.end(), winds) % 2 == 1;
  };
  for (const geom::Polyline& line : lines) {
    for (std::size_t i = 0; i < line.segment_count(); ++i) {
      const geom::Segment piece = line.segment(i);
      if (!inside(geom::midpoint(piece.from, piece.to))) continue;
      for (const double side : {1.0, -1.0}) search.follow({{piece.from, piece.to}, false}, side);
    }
  }
  return search.found();
}

}  // namespace recon::core
