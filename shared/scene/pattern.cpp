#include "shared/scene/pattern.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "shared/scene/marks.h"

namespace dobra::scene {
namespace {

using geom::Point;
using geom::Segment;

constexpr double cell = 7.0;  ///< Points from sign to sign; rows stand `row` apart, every other one shifted by half.
constexpr double row = 4.0;
constexpr double dot = 0.9;
constexpr double reach = 1.2;  ///< Of small signs from their middle.
constexpr double band_height = 8.0;

/// One sign round the origin. Slanted lines come in pieces from row to row.
std::vector<Segment> sign_of(Pattern pattern) {
  switch (pattern) {
    case Pattern::None:
      break;
    case Pattern::Dots:
      return {{{-0.5 * dot, 0.0}, {0.5 * dot, 0.0}}};
    case Pattern::Bricks:
      return {{{0.0, 0.0}, {cell, 0.0}}, {{0.0, 0.0}, {0.0, row}}};
    case Pattern::Dashes:
      return {{{-2.0, 0.0}, {2.0, 0.0}}};
    case Pattern::Crosses:
      return {{{-reach, 0.0}, {reach, 0.0}}, {{0.0, -reach}, {0.0, reach}}};
    case Pattern::Vees:
      return {{{-reach, -reach}, {0.0, reach}}, {{0.0, reach}, {reach, -reach}}};
    case Pattern::Circles: {
      constexpr int sides = 12;
      const auto rim = [](int i) {
        const double angle = 2.0 * std::numbers::pi * i / sides;
        return Point{reach * std::cos(angle), reach * std::sin(angle)};
      };
      std::vector<Segment> circle;
      for (int i = 0; i < sides; ++i) circle.push_back({rim(i), rim(i + 1)});
      return circle;
    }
    case Pattern::Hatch:
      return {{{0.0, row}, {row, 0.0}}};
    case Pattern::BackHatch:
      return {{{0.0, 0.0}, {row, row}}};
    case Pattern::CrossHatch:
      return {{{0.0, row}, {row, 0.0}}, {{0.0, 0.0}, {row, row}}};
  }
  return {};
}

bool is_slanted(Pattern pattern) {
  return pattern == Pattern::Hatch || pattern == Pattern::BackHatch || pattern == Pattern::CrossHatch;
}

std::size_t band_of(double y, double low, std::size_t count) {
  const double band = std::floor((y - low) / band_height);
  return static_cast<std::size_t>(std::clamp(band, 0.0, static_cast<double>(count - 1)));
}

/// The edges of contours by the bands of height that they touch.
std::vector<std::vector<Segment>> edges_in_bands(const std::vector<geom::Polyline>& contours, double low,
                                                 std::size_t count) {
  const double high = low + band_height * static_cast<double>(count);
  std::vector<std::vector<Segment>> bands(count);
  for (const geom::Polyline& contour : contours) {
    const std::vector<Point>& p = contour.points;
    for (std::size_t i = 0, j = p.size() - 1; i < p.size(); j = i++) {
      const auto [least, most] = std::minmax(p[i].y, p[j].y);
      if (most < low || least > high) continue;
      for (std::size_t band = band_of(least, low, count); band <= band_of(most, low, count); ++band)
        bands[band].push_back({p[j], p[i]});
    }
  }
  return bands;
}

bool is_inside(Point p, std::span<const Segment> edges) {
  bool inside = false;
  for (const Segment& e : edges) {
    if ((e.from.y > p.y) == (e.to.y > p.y)) continue;
    if (e.from.x + (p.y - e.from.y) / (e.to.y - e.from.y) * (e.to.x - e.from.x) < p.x) inside = !inside;
  }
  return inside;
}

/// Adds the parts of a stroke that lies in one band.
void add_parts(const Segment& stroke, std::span<const Segment> edges, std::vector<Segment>& parts) {
  std::vector<double> cuts{0.0, 1.0};
  const geom::Vector along = stroke.vector();
  for (const Segment& edge : edges) {
    const double across = geom::cross(along, edge.vector());
    if (across == 0.0) continue;
    const double t = geom::cross(edge.from - stroke.from, edge.vector()) / across;
    const double on_edge = geom::cross(edge.from - stroke.from, along) / across;
    if (t > 0.0 && t < 1.0 && on_edge >= 0.0 && on_edge <= 1.0) cuts.push_back(t);
  }
  std::sort(cuts.begin(), cuts.end());
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    if (cuts[i] == cuts[i + 1]) continue;
    if (!is_inside(geom::interpolate(stroke.from, stroke.to, 0.5 * (cuts[i] + cuts[i + 1])), edges)) continue;
    parts.push_back(
        {geom::interpolate(stroke.from, stroke.to, cuts[i]), geom::interpolate(stroke.from, stroke.to, cuts[i + 1])});
  }
}

}  // namespace

double pattern_width(Pattern pattern) { return pattern == Pattern::Dots ? dot : 0.4; }

std::vector<Segment> pattern_strokes(Pattern pattern, const geom::Box& box) {
  std::vector<Segment> strokes;
  if (box.empty()) return strokes;
  const std::vector<Segment> sign = sign_of(pattern);
  const double step = is_slanted(pattern) ? row : cell;
  const auto last = static_cast<long>(std::floor(box.high.y / row)) + 1;
  for (long j = static_cast<long>(std::floor(box.low.y / row)) - 1; j <= last && !sign.empty(); ++j) {
    const double shift = j % 2 == 0 || is_slanted(pattern) ? 0.0 : 0.5 * cell;
    const double y = static_cast<double>(j) * row;
    for (double x = std::floor(box.low.x / step) * step - step + shift; x <= box.high.x + step; x += step) {
      for (const Segment& s : sign) strokes.push_back({{x + s.from.x, y + s.from.y}, {x + s.to.x, y + s.to.y}});
    }
  }
  return strokes;
}

std::vector<Segment> parts_inside(const std::vector<Segment>& strokes, const std::vector<geom::Polyline>& contours) {
  std::vector<Segment> parts;
  geom::Box box;
  for (const Segment& stroke : strokes) box.add(stroke.box());
  if (box.empty()) return parts;
  const auto count = static_cast<std::size_t>(std::floor(box.height() / band_height)) + 1;
  const auto bands = edges_in_bands(contours, box.low.y, count);
  for (const Segment& stroke : strokes) {
    const double low = std::min(stroke.from.y, stroke.to.y);
    const double high = std::max(stroke.from.y, stroke.to.y);
    for (std::size_t band = band_of(low, box.low.y, count); band <= band_of(high, box.low.y, count); ++band) {
      const double floor = box.low.y + static_cast<double>(band) * band_height;
      const geom::Box slab{{box.low.x - 1.0, floor}, {box.high.x + 1.0, floor + band_height}};
      double from = 0.0;
      double to = 1.0;
      if (!part_inside(stroke, slab, from, to)) continue;
      add_parts({geom::interpolate(stroke.from, stroke.to, from), geom::interpolate(stroke.from, stroke.to, to)},
                bands[band], parts);
    }
  }
  return parts;
}

}  // namespace dobra::scene
