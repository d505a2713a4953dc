#include "shared/surf/paper/paper_front.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shared/surf/measure.h"

namespace dobra::surf::paper {

using geom::Box;
using geom::Point;
using geom::Point3;
using geom::Sign;
using geom::Vector;
using geom::Vector3;

namespace {

std::uint64_t key_of(std::uint32_t from, std::uint32_t to) { return (std::uint64_t{from} << 32U) | to; }

void erase(std::vector<std::uint32_t>& list, std::uint32_t value) {
  list.erase(std::find(list.begin(), list.end(), value));
}

/// In the closed triangle a, b, c, which runs anticlockwise.
bool holds(Point a, Point b, Point c, Point p) {
  return orient2d(a, b, p) != Sign::Negative && orient2d(b, c, p) != Sign::Negative &&
         orient2d(c, a, p) != Sign::Negative;
}

/// Closed segments have a point in common.
bool meet(Point a, Point b, Point c, Point d) {
  const Sign c_side = orient2d(a, b, c), d_side = orient2d(a, b, d);
  const Sign a_side = orient2d(c, d, a), b_side = orient2d(c, d, b);
  if (c_side == Sign::Zero && d_side == Sign::Zero) {
    Box one, two;
    one.add(a);
    one.add(b);
    two.add(c);
    two.add(d);
    return one.overlaps(two);
  }
  return c_side * d_side != Sign::Positive && a_side * b_side != Sign::Positive;
}

double from_chord(Point3 p, Point3 a, Point3 b) {
  const Vector3 way = b - a;
  const double square = dot(way, way);
  const double t = square > 0.0 ? std::clamp(dot(p - a, way) / square, 0.0, 1.0) : 0.0;
  return geom::distance(p, a + t * way);
}

}  // namespace

Vector reach_of(const Surface& surface, Point uv, double length) {
  const Metric m = metric(surface.jet(uv));
  const double area = m.area();
  const Box& chart = surface.chart();
  if (!(area > 0.0)) return {chart.width(), chart.height()};
  return {std::min(chart.width(), length * std::sqrt(m.g) / area),
          std::min(chart.height(), length * std::sqrt(m.e) / area)};
}

std::uint32_t PaperFront::add_node(Point uv, Point3 at, bool loose) {
  const auto node = static_cast<std::uint32_t>(places_.size());
  places_.push_back(uv);
  points_.push_back(at);
  loose_.push_back(loose ? 1 : 0);
  from_.emplace_back();
  to_.emplace_back();
  if (loose) buckets_[tree_->leaf_at(uv)].loose.push_back(node);
  return node;
}

Box PaperFront::box_of(SegmentIndex segment) const {
  Box box;
  box.add(places_[segments_[segment].from]);
  box.add(places_[segments_[segment].to]);
  return box;
}

PaperFront::SegmentIndex PaperFront::add_segment(std::uint32_t from, std::uint32_t to, std::int32_t region,
                                                 std::uint32_t level) {
  const auto segment = static_cast<SegmentIndex>(segments_.size());
  segments_.push_back(
      {.from = from, .to = to, .region = region, .level = level, .length = geom::distance(points_[from], points_[to])});
  seen_.push_back(0);
  by_ends_[key_of(from, to)] = segment;
  from_[from].push_back(segment);
  to_[to].push_back(segment);
  for (const std::uint32_t node : {from, to}) {
    if (!loose_[node]) continue;
    loose_[node] = 0;
    erase(buckets_[tree_->leaf_at(places_[node])].loose, node);
  }
  tree_->for_leaves(box_of(segment), [&](ChartQuadtree::CellIndex c) { buckets_[c].segments.push_back(segment); });
  ++alive_;
  return segment;
}

void PaperFront::remove_segment(SegmentIndex segment) {
  Segment& s = segments_[segment];
  s.alive = s.active = false;
  by_ends_.erase(key_of(s.from, s.to));
  erase(from_[s.from], segment);
  erase(to_[s.to], segment);
  tree_->for_leaves(box_of(segment), [&](ChartQuadtree::CellIndex c) { erase(buckets_[c].segments, segment); });
  --alive_;
}

PaperFront::SegmentIndex PaperFront::find(std::uint32_t from, std::uint32_t to) const {
  const auto found = by_ends_.find(key_of(from, to));
  return found == by_ends_.end() ? none : found->second;
}

std::vector<std::uint32_t> PaperFront::nodes() const {
  std::vector<std::uint32_t> found;
  for (std::uint32_t n = 0; n < places_.size(); ++n) {
    if (on_front(n)) found.push_back(n);
  }
  return found;
}

/// From one direction anticlockwise to another, above 0, as the scaled chart shows it.
double PaperFront::chart_angle(std::uint32_t at, std::uint32_t from, std::uint32_t to) const {
  const Vector scale = tree_->scale();
  const auto scaled = [&](std::uint32_t node) {
    const Vector v = places_[node] - places_[at];
    return Vector{scale.x * v.x, scale.y * v.y};
  };
  if (from == to) return 2.0 * std::numbers::pi;
  const Vector a = scaled(from), b = scaled(to);
  const double angle = std::atan2(geom::cross(a, b), geom::dot(a, b));
  return angle > 0.0 ? angle : angle + 2.0 * std::numbers::pi;
}

/// The same in space; whether it is above pi is for the chart to say.
double PaperFront::space_angle(std::uint32_t at, std::uint32_t from, std::uint32_t to) const {
  const Vector3 a = points_[from] - points_[at], b = points_[to] - points_[at];
  const double angle = std::atan2(geom::length(cross(a, b)), dot(a, b));
  const bool left = orient2d(places_[at], places_[from], places_[to]) == Sign::Positive;
  return left ? angle : 2.0 * std::numbers::pi - angle;
}

PaperFront::Neighbour PaperFront::before(SegmentIndex segment) const {
  const Segment& s = segments_[segment];
  Neighbour found;
  double least = 7.0;
  for (const SegmentIndex other : to_[s.from]) {
    const double angle = chart_angle(s.from, s.to, segments_[other].from);
    if (angle < least) found.segment = other, least = angle;
  }
  if (found.segment != none) found.angle = space_angle(s.from, s.to, segments_[found.segment].from);
  return found;
}

PaperFront::Neighbour PaperFront::after(SegmentIndex segment) const {
  const Segment& s = segments_[segment];
  Neighbour found;
  double least = 7.0;
  for (const SegmentIndex other : from_[s.to]) {
    const double angle = chart_angle(s.to, segments_[other].to, s.from);
    if (angle < least) found.segment = other, least = angle;
  }
  if (found.segment != none) found.angle = space_angle(s.to, segments_[found.segment].to, s.from);
  return found;
}

template <class Visitor>
void PaperFront::for_segments(const Box& box, Visitor&& visit) {
  ++look_;
  tree_->for_leaves(box, [&](ChartQuadtree::CellIndex c) {
    for (const SegmentIndex s : buckets_[c].segments) {
      if (seen_[s] == look_) continue;
      seen_[s] = look_;
      visit(s);
    }
  });
}

bool PaperFront::crosses(Point p, std::uint32_t p_node, const Corner& c, const Segment& segment) const {
  if (segment.from == p_node || segment.to == p_node || segment.from == c.node || segment.to == c.node) return false;
  return meet(p, c.uv, places_[segment.from], places_[segment.to]);
}

bool PaperFront::valid(std::uint32_t a, std::uint32_t b, const Corner& c, double least_distance) {
  const Point p = places_[a], q = places_[b];
  if (orient2d(p, q, c.uv) != Sign::Positive) return false;
  Box box;
  box.add(p);
  box.add(q);
  box.add(c.uv);
  bool good = true;
  for_segments(box, [&](SegmentIndex s) {
    if (!good) return;
    const Segment& segment = segments_[s];
    for (const std::uint32_t node : {segment.from, segment.to}) {
      if (node != a && node != b && node != c.node && holds(p, q, c.uv, places_[node])) good = false;
    }
    if (good && (crosses(p, a, c, segment) || crosses(q, b, c, segment))) good = false;
  });
  if (!good) return false;
  tree_->for_leaves(box, [&](ChartQuadtree::CellIndex cell) {
    for (const std::uint32_t node : buckets_[cell].loose) {
      if (node != c.node && holds(p, q, c.uv, places_[node])) good = false;
    }
  });
  if (!good || c.node != none || !(least_distance > 0.0)) return good;
  // As far in the chart as the sides of the triangle show, twice over for the bend of the metric.
  const double height = std::min(geom::distance(c.at, points_[a]), geom::distance(c.at, points_[b]));
  const double wide = 2.0 * least_distance / std::max(height, least_distance);
  return keeps_distance(a, b, c, least_distance, {wide * box.width(), wide * box.height()});
}

bool PaperFront::keeps_distance(std::uint32_t a, std::uint32_t b, const Corner& c, double least, Vector reach) {
  bool good = true;
  const Box box{{c.uv.x - reach.x, c.uv.y - reach.y}, {c.uv.x + reach.x, c.uv.y + reach.y}};
  for_segments(box, [&](SegmentIndex s) {
    const Segment& segment = segments_[s];
    if (!good || (segment.from == a && segment.to == b)) return;
    good = from_chord(c.at, points_[segment.from], points_[segment.to]) >= least;
  });
  tree_->for_leaves(box, [&](ChartQuadtree::CellIndex cell) {
    for (const std::uint32_t node : buckets_[cell].loose) {
      if (geom::distance(points_[node], c.at) < least) good = false;
    }
  });
  return good;
}

void PaperFront::near(Point uv, Point3 at, double radius, Vector reach, std::vector<std::uint32_t>& found) {
  found.clear();
  const Box box{{uv.x - reach.x, uv.y - reach.y}, {uv.x + reach.x, uv.y + reach.y}};
  const auto add = [&](std::uint32_t node) {
    if (geom::distance(points_[node], at) <= radius) found.push_back(node);
  };
  for_segments(box, [&](SegmentIndex s) {
    add(segments_[s].from);
    add(segments_[s].to);
  });
  tree_->for_leaves(box, [&](ChartQuadtree::CellIndex cell) {
    for (const std::uint32_t node : buckets_[cell].loose) add(node);
  });
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
}

}  // namespace dobra::surf::paper
