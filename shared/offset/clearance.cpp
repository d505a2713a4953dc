#include "shared/offset/clearance.h"

#include <algorithm>

namespace dobra::offset {

Clearance::Clearance(const BaseCurve& base) : base_(base) {
  const std::size_t count = base.segment_count();
  while (leaves_ * leaf_size < count) leaves_ *= 2;
  boxes_.resize(2 * leaves_);
  for (std::size_t i = 0; i < count; ++i) {
    boxes_[leaves_ + i / leaf_size].add(rounded(base.from(i)));
    boxes_[leaves_ + i / leaf_size].add(rounded(base.to(i)));
  }
  for (std::size_t i = leaves_ - 1; i > 0; --i) {
    boxes_[i].add(boxes_[2 * i]);
    boxes_[i].add(boxes_[2 * i + 1]);
  }
}

bool Clearance::nearer_in_leaf(std::size_t leaf, Vec q, Real squared) const {
  const std::size_t end = std::min((leaf + 1) * leaf_size, base_.segment_count());
  for (std::size_t i = leaf * leaf_size; i < end; ++i) {
    const Vec to = q - base_.from(i);
    const Real t = dot(to, base_.along[i]);
    if (t <= 0) {
      if (dot(to, to) < squared) return true;
    } else if (t >= base_.lengths[i]) {
      const Vec back = q - base_.to(i);
      if (dot(back, back) < squared) return true;
    } else {
      const Real across = cross(to, base_.along[i]);
      if (across * across < squared) return true;
    }
  }
  return false;
}

bool Clearance::nearer_than(Vec q, Real r) const {
  if (!(r > 0)) return false;
  const geom::Point p = rounded(q);
  const double reach = static_cast<double>(r) * (1.0 + 1e-12) + 1e-14 * static_cast<double>(base_.size + r);
  const double limit = reach * reach;
  const auto squared_gap = [&](const geom::Box& box) {
    const double x = std::max({box.low.x - p.x, 0.0, p.x - box.high.x});
    const double y = std::max({box.low.y - p.y, 0.0, p.y - box.high.y});
    return x * x + y * y;
  };
  std::size_t open[128];
  std::size_t count = 0;
  open[count++] = 1;
  while (count > 0) {
    const std::size_t node = open[--count];
    if (!(squared_gap(boxes_[node]) <= limit)) continue;
    if (node >= leaves_) {
      if (nearer_in_leaf(node - leaves_, q, r * r)) return true;
      continue;
    }
    // The nearer child first: if there is something near, it is found soon.
    const bool left_first = squared_gap(boxes_[2 * node]) <= squared_gap(boxes_[2 * node + 1]);
    open[count++] = 2 * node + (left_first ? 1 : 0);
    open[count++] = 2 * node + (left_first ? 0 : 1);
  }
  return false;
}

}  // namespace dobra::offset
