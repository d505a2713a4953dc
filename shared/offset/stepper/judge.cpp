#include "shared/offset/stepper/judge.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace dobra::offset::stepper {

using geom::Box;
using geom::Point;
using geom::Segment;

namespace {

constexpr std::size_t leaf = 8;

double distance(const Box& box, Point q) {
  const double dx = std::max({box.low.x - q.x, 0.0, q.x - box.high.x});
  const double dy = std::max({box.low.y - q.y, 0.0, q.y - box.high.y});
  return std::hypot(dx, dy);
}

/// Boxes of runs of `leaf` things in a row and of pairs of those, and so on; the root is 1.
template <class BoxOf>
std::vector<Box> heap_of(std::size_t count, std::size_t& leaves, const BoxOf& box_of) {
  leaves = std::bit_ceil(std::max<std::size_t>(1, (count + leaf - 1) / leaf));
  std::vector<Box> boxes(2 * leaves);
  for (std::size_t i = 0; i < count; ++i) boxes[leaves + i / leaf].add(box_of(i));
  for (std::size_t i = leaves - 1; i > 0; --i) {
    boxes[i] = boxes[2 * i];
    boxes[i].add(boxes[2 * i + 1]);
  }
  return boxes;
}

}  // namespace

Point stepper_point(const BaseCurve& base, Vec p) {
  const Point user = base.user(p);
  return {user.x, base.mirrored ? -user.y : user.y};
}

StepperJudge::StepperJudge(const BaseCurve& base, double distance, const OffsetOptions& options) : distance_(distance) {
  double size = 0.0;
  for (std::size_t i = 0; i < base.points.size(); ++i) {
    base_.points.push_back(stepper_point(base, base.point(i)));
    size = std::max({size, std::abs(base_.points.back().x), std::abs(base_.points.back().y)});
  }
  base_.closed = base.closed;
  near_ = distance * (1.0 - 1e-9) - 0x1p-48 * size;
  boxes_ = heap_of(base_.segment_count(), leaves_, [&](std::size_t i) { return base_.segment(i).box(); });
  add_spikes(base, options);
}

void StepperJudge::add_spikes(const BaseCurve& base, const OffsetOptions& options) {
  for (std::size_t i = 0; i < base.segment_count(); ++i) {
    const std::size_t at = base.end_index(i);
    if (!base.has_after(i) || base.turn[at] != Turn::Outer) continue;
    const CornerKind fill = outer_corner(base, at, options);
    if (fill == CornerKind::Arc) continue;
    const std::size_t next = base.after(i);
    const Real t = base.half_tan_as<Real>(at);
    const Vec first = base.point(at) + Real(distance_) * base.normal(i);
    const Vec second = base.point(at) + Real(distance_) * base.normal(next);
    std::vector<Vec> corner{base.point(at), first};
    if (fill == CornerKind::Mitre) {
      corner.push_back(first + (Real(distance_) * t) * base.along(i));
    } else {
      const Real q = Real(distance_) * quarter_tan(t);
      corner.push_back(first + q * base.along(i));
      corner.push_back(second - q * base.along(next));
    }
    corner.push_back(second);
    Spike spike;
    for (const Vec p : corner) {
      spike.points.push_back(stepper_point(base, p));
      spike.box.add(spike.points.back());
    }
    spikes_.push_back(std::move(spike));
  }
  spike_boxes_ = heap_of(spikes_.size(), spike_leaves_, [&](std::size_t i) { return spikes_[i].box; });
}

StepperJudge::Nearest StepperJudge::nearest(Point q) const {
  Nearest best{0, std::numeric_limits<double>::infinity()};
  std::vector<std::size_t> open{1};
  while (!open.empty()) {
    const std::size_t at = open.back();
    open.pop_back();
    if (!(distance(boxes_[at], q) < best.distance)) continue;
    if (at < leaves_) {
      const bool left_first = distance(boxes_[2 * at], q) < distance(boxes_[2 * at + 1], q);
      open.push_back(2 * at + (left_first ? 1 : 0));
      open.push_back(2 * at + (left_first ? 0 : 1));
      continue;
    }
    const std::size_t first = (at - leaves_) * leaf;
    for (std::size_t i = first; i < std::min(first + leaf, base_.segment_count()); ++i) {
      const double away = geom::distance(base_.segment(i), q);
      if (away < best.distance) best = {i, away};
    }
  }
  return best;
}

/// The sides that start at the corner itself are inside the stadia.
bool StepperJudge::holds(const Spike& spike, Point q, double margin) const {
  const auto& corner = spike.points;
  for (std::size_t k = 0; k < corner.size(); ++k) {
    const Point a = corner[k];
    const geom::Vector along = corner[(k + 1) % corner.size()] - a;
    const double least = k == 0 || k + 1 == corner.size() ? -(distance_ - near_) : margin;
    if (!(geom::cross(along, q - a) > least * geom::length(along))) return false;
  }
  return true;
}

const StepperJudge::Spike* StepperJudge::spike_at(Point q) const {
  if (spikes_.empty()) return nullptr;
  std::vector<std::size_t> open{1};
  while (!open.empty()) {
    const std::size_t at = open.back();
    open.pop_back();
    if (!spike_boxes_[at].contains(q)) continue;
    if (at < spike_leaves_) {
      open.push_back(2 * at);
      open.push_back(2 * at + 1);
      continue;
    }
    const std::size_t first = (at - spike_leaves_) * leaf;
    for (std::size_t i = first; i < std::min(first + leaf, spikes_.size()); ++i) {
      if (holds(spikes_[i], q, distance_ - near_)) return &spikes_[i];
    }
  }
  return nullptr;
}

bool StepperJudge::near(Point q) const { return nearest(q).distance < near_ || spike_at(q) != nullptr; }

/// The corner whose chord the edge is, if it is one: such an edge is judged by the arc in whose place it stands.
std::optional<Point> StepperJudge::bevelled_corner(const Segment& edge, std::uint32_t base_segment) const {
  const geom::Vector along = base_.segment(base_segment).vector();
  const geom::Vector v = edge.vector();
  if (std::abs(geom::cross(along, v)) <= 1e-7 * geom::length(along) * geom::length(v)) return std::nullopt;
  const std::size_t next = base_segment + 1 == base_.segment_count() ? 0 : base_segment + 1;
  if (geom::cross(along, base_.segment(next).vector()) < 0.0) return std::nullopt;  // an inner corner has no arc
  return base_.segment(base_segment).to;
}

Point StepperJudge::lifted(Point q, const Point* corner) const {
  if (corner == nullptr) return q;
  const double away = geom::distance(*corner, q);
  return away > 0.0 && away < distance_ ? *corner + (distance_ / away) * (q - *corner) : q;
}

bool StepperJudge::middle_is_near(const Segment& edge, std::uint32_t base_segment) const {
  const auto corner = bevelled_corner(edge, base_segment);
  return near(lifted(geom::midpoint(edge.from, edge.to), corner ? &*corner : nullptr));
}

bool StepperJudge::buried(const Segment& edge, std::uint32_t base_segment) const {
  const auto corner = bevelled_corner(edge, base_segment);
  int budget = 400;
  return middle_is_near(edge, base_segment) && buried(edge, corner ? &*corner : nullptr, 0, budget);
}

/// What lies within the distance of a single segment is a convex set, as is a spike: both ends in it, all in it.
bool StepperJudge::buried(const Segment& edge, const Point* corner, int depth, int& budget) const {
  if (--budget < 0) return false;
  if (edge.length() < 1e-6 * distance_) return true;  // next to the end of what is buried
  const Point middle = geom::midpoint(edge.from, edge.to);
  const Nearest here = nearest(lifted(middle, corner));
  if (!(here.distance < near_)) {
    const Spike* const spike = spike_at(lifted(middle, corner));
    if (spike == nullptr) return false;
    const double touch = near_ - distance_;
    if (corner == nullptr && holds(*spike, edge.from, touch) && holds(*spike, edge.to, touch)) return true;
  } else if (corner == nullptr) {
    const Segment stadium = base_.segment(here.segment);
    if (std::max(geom::distance(stadium, edge.from), geom::distance(stadium, edge.to)) <= distance_) return true;
  }
  return depth < 24 && buried({edge.from, middle}, corner, depth + 1, budget) &&
         buried({middle, edge.to}, corner, depth + 1, budget);
}

}  // namespace dobra::offset::stepper
