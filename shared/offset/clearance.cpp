#include "shared/offset/clearance.h"

#include <algorithm>

namespace dobra::offset {

Clearance::Clearance(const BaseCurve& base, const OffsetOptions& options) : base_(base) {
  const std::size_t count = base.segment_count();
  while (leaves_ * leaf_size < count) leaves_ *= 2;
  boxes_.resize(2 * leaves_);
  for (std::size_t i = 0; i < count; ++i) {
    boxes_[leaves_ + i / leaf_size].add(base.start(i));
    boxes_[leaves_ + i / leaf_size].add(base.end(i));
  }
  for (std::size_t i = leaves_ - 1; i > 0; --i) {
    boxes_[i].add(boxes_[2 * i]);
    boxes_[i].add(boxes_[2 * i + 1]);
  }
  for (std::size_t at = 0; at < base.points.size(); ++at) {
    if (base.turn[at] != Turn::Outer) continue;
    const Fill fill = fill_of(base, at, options);
    const double t = fill == Fill::Tangent ? static_cast<double>(quarter_tan(base.half_tans[at])) : base.half_tans[at];
    if (fill != Fill::Arc) mitre_reach_ = std::max(mitre_reach_, std::sqrt(1 + t * t));
  }
}

bool Clearance::nearer(std::size_t i, Vec q, Real squared) const {
  const Vec to = q - base_.from(i);
  const Vec along = base_.along(i);
  const Real t = dot(to, along);
  if (t <= 0) return dot(to, to) < squared;
  if (t >= base_.span(i)) {
    const Vec back = q - base_.to(i);
    return dot(back, back) < squared;
  }
  const Real across = cross(to, along);
  return across * across < squared;
}

bool Clearance::nearer_in_leaf(std::size_t leaf, Vec q, Real r) const {
  const std::size_t end = std::min((leaf + 1) * leaf_size, base_.segment_count());
  const Flat p = flat(q);
  const double margin = 1e-14 * (base_.size + static_cast<double>(r));
  const double low = std::max(0.0, static_cast<double>(r) - margin);
  const double high = static_cast<double>(r) + margin;
  for (std::size_t i = leaf * leaf_size; i < end; ++i) {
    const Flat u = flat(base_.headings[i]);
    const Flat to = p - flat(base_.start(i));
    const double s = dot(to, u);
    const double t = std::clamp(s, 0.0, base_.spans[i]);
    const double across = cross(to, u);
    const double squared = across * across + (s - t) * (s - t);
    if (squared > high * high) continue;
    if (squared < low * low || nearer(i, q, r * r)) return true;
  }
  return false;
}

template <class Visit>
bool Clearance::any_leaf(Vec q, double reach, Visit&& visit) const {
  const geom::Point p = rounded(q);
  const double limit = reach * reach;
  const auto squared_gap = [&](const geom::Box& box) {
    const double x = std::max({box.low.x - p.x, 0.0, p.x - box.high.x});
    const double y = std::max({box.low.y - p.y, 0.0, p.y - box.high.y});
    return x * x + y * y;
  };
  struct Open {
    std::size_t node;
    double gap;
  };
  Open open[128];
  std::size_t count = 0;
  const auto push = [&](std::size_t node, double gap) {
    if (gap <= limit) open[count++] = {node, gap};
  };
  push(1, squared_gap(boxes_[1]));
  while (count > 0) {
    const std::size_t node = open[--count].node;
    if (node >= leaves_) {
      if (visit(node - leaves_)) return true;
      continue;
    }
    // The nearer child first: if there is something near, it is found soon.
    const double left = squared_gap(boxes_[2 * node]);
    const double right = squared_gap(boxes_[2 * node + 1]);
    if (left <= right) {
      push(2 * node + 1, right);
      push(2 * node, left);
    } else {
      push(2 * node, left);
      push(2 * node + 1, right);
    }
  }
  return false;
}

bool Clearance::nearer_than(Vec q, Real r) const {
  if (!(r > 0)) return false;
  const double reach = static_cast<double>(r) * (1.0 + 1e-12) + 1e-14 * (base_.size + static_cast<double>(r));
  return any_leaf(q, reach, [&](std::size_t leaf) { return nearer_in_leaf(leaf, q, r); });
}

bool Clearance::in_mitre_at(std::uint32_t step, Vec q, const Outline& outline, Real r) const {
  if (outline.is_cap(step)) return false;
  const Outline::Corner kind = outline.corner(step);
  if (kind != Outline::Corner::Mitre && kind != Outline::Corner::Tangent) return false;
  const double margin = 1e-13 * (base_.size + outline.distance());
  const Flat near = flat(q) - outline.to<double>(step);
  const Flat u = outline.along<double>(step);
  const Flat v = outline.along<double>(outline.after(step));
  const double limit = static_cast<double>(r) + margin;
  if (dot(near, u) < -margin || dot(near, v) > margin || dot(near, right_of(u)) > limit || dot(near, right_of(v)) > limit) {
    return false;
  }
  const Vec to = q - outline.to<Real>(step);
  const Vec n = outline.normal<Real>(step);
  const Vec m = outline.normal<Real>(outline.after(step));
  if (cross(n, to) < 0 || cross(to, m) < 0) return false;
  Real outermost = std::max(dot(n, to), dot(m, to));
  if (kind == Outline::Corner::Tangent) outermost = std::max(outermost, dot(outline.middle_of_turn<Real>(step), to));
  return outermost < r;
}

bool Clearance::in_mitre(Vec q, const Outline& outline, Real r) const {
  if (mitre_reach_ == 0) return false;
  const double reach = mitre_reach_ * outline.distance() * (1 + 1e-12);
  const Flat p = flat(q);
  return any_leaf(q, reach, [&](std::size_t leaf) {
    const std::size_t end = std::min((leaf + 1) * leaf_size, base_.segment_count());
    for (std::size_t i = leaf * leaf_size; i < end; ++i) {
      if (base_.turn[base_.end_index(i)] != Turn::Outer) continue;
      const Flat to = p - flat(base_.end(i));
      if (dot(to, to) <= reach * reach && in_mitre_at(static_cast<std::uint32_t>(i), q, outline, r)) return true;
    }
    return false;
  });
}

}  // namespace dobra::offset
