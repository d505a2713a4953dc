#include "shared/canvas/snap.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "shared/base/text.h"
#include "shared/geom/intersect.h"

namespace dobra::canvas {

namespace {

using geom::Point;
using geom::Vector;

constexpr std::uint32_t run_length = 16;
constexpr std::size_t most_crossed = 48;  ///< Nearest segments whose crossings are looked for.
/// A way starts on a line if it is no farther from it than this part of the reach.
constexpr double touching = 1e-6;

/// Distances as they look on the page, in world units of x.
struct Page {
  double exaggeration = 1.0;
  [[nodiscard]] double distance(Point p, Point q) const { return std::hypot(p.x - q.x, exaggeration * (p.y - q.y)); }
  /// The point of a segment that looks nearest to p.
  [[nodiscard]] Point nearest(const geom::Segment& s, Point p) const {
    const Vector along{s.to.x - s.from.x, exaggeration * (s.to.y - s.from.y)};
    const Vector d{p.x - s.from.x, exaggeration * (p.y - s.from.y)};
    const double squared = length_squared(along);
    return geom::interpolate(s.from, s.to, squared > 0.0 ? std::clamp(dot(d, along) / squared, 0.0, 1.0) : 0.0);
  }
};

/// The foot of the perpendicular from p, where the segment has one.
std::optional<Point> foot(const geom::Segment& s, Point p) {
  const Vector along = s.to - s.from;
  const double squared = length_squared(along);
  const double t = squared > 0.0 ? dot(p - s.from, along) / squared : -1.0;
  if (t < 0.0 || t > 1.0) return std::nullopt;
  return geom::interpolate(s.from, s.to, t);
}

/// The cursor on the line through `from` along `way`.
Point onto(Point from, Vector way, Point cursor) { return from + dot(cursor - from, way) / length_squared(way) * way; }

void take_nearest(std::optional<Snap>& best, double& least, Snap candidate, double distance) {
  if (distance > least || (best && distance == least)) return;
  least = distance;
  best = std::move(candidate);
}

double nearest_multiple(double value, double step) {
  const double steps = std::round(value / step);
  // Divided by a whole number, 3 * 0.1 is the 0.3 that a user means.
  const double a_unit = 1.0 / step;
  const bool whole = step < 1.0 && std::abs(a_unit - std::round(a_unit)) < 1e-9 * a_unit;
  return (whole ? steps / std::round(a_unit) : steps * step) + 0.0;  // + 0.0 turns -0 into 0
}

std::optional<Snap> on_grid(Point cursor, const SnapWish& wish) {
  if (!(wish.grid > 0.0)) return std::nullopt;
  const geom::Vector from = cursor - wish.grid_origin;
  const double across = wish.grid_y > 0.0 ? wish.grid_y : wish.grid;
  const Point node =
      wish.grid_origin + geom::Vector{nearest_multiple(from.x, wish.grid), nearest_multiple(from.y, across)};
  if (Page{wish.exaggeration}.distance(cursor, node) > wish.reach) return std::nullopt;
  return Snap{SnapKind::Grid, node};
}

std::optional<Snap> at_angle(Point cursor, const SnapWish& wish) {
  if (!wish.from || *wish.from == cursor || !(wish.angle_step > 0.0)) return std::nullopt;
  const Vector d = cursor - *wish.from;
  const double step = wish.angle_step * std::numbers::pi / 180.0;
  const double turn = std::round(std::atan2(d.y, d.x) / step) * step;
  Vector way{std::cos(turn), std::sin(turn)};
  // A right angle is one: cos(pi/2) is 6e-17.
  if (std::abs(way.x) < 1e-12) way.x = 0.0;
  if (std::abs(way.y) < 1e-12) way.y = 0.0;
  return Snap{SnapKind::Angle, onto(*wish.from, way, cursor)};
}

}  // namespace

std::string snap_name(SnapKind kind) {
  switch (kind) {
    case SnapKind::Vertex:
      return base::translated("vertex");
    case SnapKind::Intersection:
      return base::translated("intersection");
    case SnapKind::OnLine:
      return base::translated("on line");
    case SnapKind::Perpendicular:
      return base::translated("perpendicular");
    case SnapKind::Grid:
      return base::translated("grid");
    case SnapKind::Angle:
      break;
  }
  return base::translated("angle");
}

/// A segment, or a marker (both ends the same), within reach.
struct SnapIndex::Near {
  const Run* run = nullptr;
  std::uint32_t segment = 0;
  geom::Segment line;
  double distance = 0.0;
};

SnapIndex::SnapIndex(std::shared_ptr<const scene::Picture> picture, std::size_t panel,
                     const std::set<std::string>& hidden)
    : picture_(std::move(picture)), panel_(panel) {
  std::vector<geom::Box> boxes;
  const std::vector<scene::Layer>& layers = picture_->panels[panel].layers;
  for (std::uint32_t l = 0; l < layers.size(); ++l) {
    if (!layers[l].visible || hidden.contains(layers[l].key)) continue;
    if (const auto* markers = std::get_if<scene::Markers>(&layers[l].content)) {
      for (std::uint32_t i = 0; i < markers->points.size(); ++i) {
        runs_.push_back({l, i, i, 0});
        boxes.push_back({markers->points[i], markers->points[i]});
      }
    }
    const auto* lines = std::get_if<scene::Lines>(&layers[l].content);
    for (std::uint32_t i = 0; lines != nullptr && i < lines->lines.size(); ++i) {
      const geom::Polyline& line = lines->lines[i];
      const auto count = static_cast<std::uint32_t>(line.segment_count());
      for (std::uint32_t first = 0; first < count; first += run_length) {
        runs_.push_back({l, i, first, std::min(run_length, count - first)});
        geom::Box& box = boxes.emplace_back();
        for (std::uint32_t k = 0; k < runs_.back().count; ++k) {
          box.add(line.segment(first + k).from);
          box.add(line.segment(first + k).to);
        }
      }
    }
  }
  index_ = geom::SpatialIndex(boxes);
}

const geom::Polyline& SnapIndex::line(const Run& run) const {
  return std::get<scene::Lines>(picture_->panels[panel_].layers[run.layer].content).lines[run.item];
}

scene::Pick SnapIndex::pick_of(const Run& run) const {
  const scene::Layer& layer = picture_->panels[panel_].layers[run.layer];
  const std::vector<std::uint32_t>* ids = nullptr;
  if (const auto* lines = std::get_if<scene::Lines>(&layer.content)) ids = &lines->ids;
  if (const auto* markers = std::get_if<scene::Markers>(&layer.content)) ids = &markers->ids;
  return {layer.key, ids == nullptr || ids->empty() ? run.item : (*ids)[run.item]};
}

std::vector<SnapIndex::Near> SnapIndex::near(Point cursor, const SnapWish& wish, double reach) const {
  const Page page{wish.exaggeration};
  const Vector margin{reach, reach / wish.exaggeration};
  std::vector<Near> found;
  const auto add = [&](const Run& run, std::uint32_t number, const geom::Segment& segment) {
    const double distance = page.distance(cursor, page.nearest(segment, cursor));
    if (distance <= reach) found.push_back({&run, number, segment, distance});
  };
  index_.for_each_overlapping({cursor - margin, cursor + margin}, [&](std::size_t i) {
    const Run& run = runs_[i];
    if (!wish.without.empty() && wish.without.contains(pick_of(run))) return;
    if (wish.only != nullptr && !wish.only->contains(pick_of(run))) return;
    if (run.count == 0) {
      const auto& content = picture_->panels[panel_].layers[run.layer].content;
      const Point at = std::get<scene::Markers>(content).points[run.first];
      add(run, run.first, {at, at});
    }
    for (std::uint32_t k = 0; k < run.count; ++k) add(run, run.first + k, line(run).segment(run.first + k));
  });
  std::sort(found.begin(), found.end(), [](const Near& a, const Near& b) {
    return std::tuple{a.distance, a.run, a.segment} < std::tuple{b.distance, b.run, b.segment};
  });
  return found;
}

std::optional<Snap> SnapIndex::on_lines(Point cursor, const SnapWish& wish) const {
  const Page page{wish.exaggeration};
  const std::vector<Near> found = near(cursor, wish, wish.reach);
  const auto end_of = [&](const Near& at, bool last) -> std::size_t {
    const std::size_t next = at.segment + 1;
    if (!last || at.run->count == 0) return at.segment;
    return next == line(*at.run).points.size() ? 0 : next;
  };
  std::optional<Snap> best;
  double least = wish.reach;
  if (wish.kinds.contains(SnapKind::Vertex)) {
    for (const Near& at : found) {
      for (const bool last : {false, true}) {
        const Point p = last ? at.line.to : at.line.from;
        take_nearest(best, least, {SnapKind::Vertex, p, pick_of(*at.run), end_of(at, last)}, page.distance(cursor, p));
      }
    }
  }
  const std::size_t crossed = std::min(found.size(), most_crossed);
  if (best) return best;
  for (std::size_t i = 0; wish.kinds.contains(SnapKind::Intersection) && i < crossed; ++i) {
    for (std::size_t j = i + 1; j < crossed; ++j) {
      const geom::Intersection meeting = geom::intersect(found[i].line, found[j].line);
      if (meeting.kind != geom::IntersectionKind::Point) continue;
      // Neighbours meet in their common vertex: that is no crossing.
      if (meeting.start.on_first != geom::At::Interior && meeting.start.on_second != geom::At::Interior) continue;
      const Point p = meeting.start.point;
      take_nearest(best, least, {SnapKind::Intersection, p, pick_of(*found[i].run), found[i].segment},
                   page.distance(cursor, p));
    }
  }
  if (best) return best;
  if (wish.from && wish.kinds.contains(SnapKind::Perpendicular)) {
    least = 0.5 * wish.reach;
    for (const Near& at : found) {
      const std::optional<Point> p = foot(at.line, *wish.from);
      if (p && page.distance(*p, *wish.from) > touching * wish.reach)
        take_nearest(best, least, {SnapKind::Perpendicular, *p, pick_of(*at.run), at.segment},
                     page.distance(cursor, *p));
    }
    if (best) return best;
  }
  if (found.empty() || !wish.kinds.contains(SnapKind::OnLine)) return std::nullopt;
  const Near& nearest = found.front();
  return Snap{SnapKind::OnLine, page.nearest(nearest.line, cursor), pick_of(*nearest.run), nearest.segment};
}

std::optional<Snap> SnapIndex::at_right_angle(Point cursor, const SnapWish& wish) const {
  if (!wish.from || !wish.kinds.contains(SnapKind::Perpendicular)) return std::nullopt;
  std::optional<Snap> best;
  double least = wish.reach;
  for (const Near& at : near(*wish.from, wish, touching * wish.reach)) {
    const Vector way = geom::left_of(at.line.to - at.line.from);
    if (length_squared(way) == 0.0) continue;
    const Point there = onto(*wish.from, way, cursor);
    take_nearest(best, least, {SnapKind::Perpendicular, there}, Page{wish.exaggeration}.distance(cursor, there));
  }
  return best;
}

std::optional<Snap> SnapIndex::at(Point cursor, const SnapWish& wish) const {
  if (const auto found = on_lines(cursor, wish)) return found;
  if (const auto found = at_right_angle(cursor, wish)) return found;
  if (wish.kinds.contains(SnapKind::Grid)) {
    if (const auto found = on_grid(cursor, wish)) return found;
  }
  return wish.kinds.contains(SnapKind::Angle) ? at_angle(cursor, wish) : std::nullopt;
}

}  // namespace dobra::canvas
