#include "shared/offset/general/clearance.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "shared/geom/box.h"
#include "shared/offset/kernel/chain_tree.h"

namespace dobra::offset::general {

namespace {

void add(FloatBox& box, Flat p) { box.add(FloatBox(p, p, 0)); }

/// Rounded to a FloatBox once, which gives the same.
struct Hull : geom::Box {
  void add(Flat p) { Box::add(geom::Point{p.x, p.y}); }
  [[nodiscard]] FloatBox box() const { return {flat(low), flat(high), 0}; }
};

}  // namespace

Clearance::Clearance(const BaseCurve& base, const OffsetOptions& options)
    : base_(base), corners_(right_corners(base, options)) {
  const std::size_t count = base.segment_count();
  std::vector<FloatBox> boxes;
  boxes.reserve(count / leaf_size + 1);
  for (std::size_t first = 0; first < count; first += leaf_size) {
    Hull hull;
    hull.add(flat(base.start(first)));
    for (std::size_t i = first; i < std::min(count, first + leaf_size); ++i) hull.add(flat(base.end(i)));
    boxes.push_back(hull.box());
  }
  tree_ = BoxTree(boxes);
  add_mitres(options);
  blocks_.reserve((count + Block::size - 1) / Block::size);
  left_.reserve((count + leaf_size - 1) / leaf_size);
  for (std::size_t i = 0; i < count; i += Block::size) add_block(i, std::min<std::size_t>(count, i + Block::size));
  bends_.reserve(blocks_.size());
  const auto bends_little = [&](std::size_t b, std::size_t many) {  // finer, where the directions do not tell
    if (b + many > blocks_.size() ||
        ChainTree::fits_half_plane(blocks_[b].directions | blocks_[b + many - 1].directions))
      return false;
    return within_half_turn(b * Block::size, std::min<std::size_t>(count, (b + many) * Block::size));
  };
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    bends_.push_back(static_cast<std::uint8_t>((bends_little(b, 1) ? 1 : 0) + (bends_little(b, 2) ? 2 : 0)));
  }
}

/// Segments, and the ones before and after them. No proof is sought where it is near to half a turn.
bool Clearance::within_half_turn(std::size_t first, std::size_t last) const {
  const std::size_t start = first > 0 ? first - 1 : 0;
  const std::size_t end = std::min(base_.segment_count(), last + 1);
  if (base_.closed && (first == 0 || last == base_.segment_count())) return false;
  Flat right = flat(base_.headings[start]);
  Flat left = right;
  for (std::size_t i = start + 1; i < end; ++i) {
    const Flat u = flat(base_.headings[i]);
    if (cross(right, u) < 0) right = u;
    if (cross(left, u) > 0) left = u;
  }
  const Flat middle = right + left;
  const double least = 1e-3 * (std::abs(middle.x) + std::abs(middle.y));
  for (std::size_t i = start; i < end; ++i) {
    if (!(dot(flat(base_.headings[i]), middle) > least)) return false;
  }
  return true;
}

void Clearance::add_block(std::size_t first, std::size_t last) {
  Block block{};
  Hull points, right, left;
  const auto both = [&](Flat n) {
    right.add(n);
    left.add(-n);
  };
  // The corner between segments i and j: all that the raw outline has there.
  const auto corner = [&](std::size_t i, std::size_t j, std::size_t at) {
    const Flat u = flat(base_.headings[i]);
    const Flat v = flat(base_.headings[j]);
    const double t = base_.half_tans[at];
    const CornerKind kind = corners_[at];
    if (kind == CornerKind::Straight) return;
    if (kind == CornerKind::Arc || kind == CornerKind::Mitre || kind == CornerKind::Tangent) {
      block.directions |= std::isinf(t) ? ~std::uint64_t{0} : ChainTree::directions_of(u, v);
    }
    const bool outer = kind != CornerKind::Meet;
    Hull& side = outer ? right : left;
    if (t <= 1) {  // the crossing of its tangents holds the arc
      side.add((outer ? right_of(u) : left_of(u)) + t * u);
    } else if (t < 1e6) {  // its extreme points
      const Flat n = outer ? right_of(u) : right_of(v);
      const Flat m = outer ? right_of(v) : right_of(u);
      for (const Flat e : {Flat{1, 0}, Flat{0, 1}, Flat{-1, 0}, Flat{0, -1}}) {
        if (cross(n, e) >= 0 && cross(e, m) >= 0) side.add(outer ? e : -e);
      }
    } else {
      for (const Flat n : {Flat{-1, -1}, Flat{1, 1}}) {
        right.add(n);
        left.add(n);
      }
    }
    if (kind == CornerKind::Mitre) right.add(right_of(u) + t * u);
    if (kind == CornerKind::Tangent) {
      right.add(right_of(u) + quarter_tan(t) * u);
      right.add(right_of(v) - quarter_tan(t) * v);
    }
  };
  // On the left side a segment's arc is the one at its start.
  for (std::size_t i = first; i < last; ++i) {
    const Flat u = flat(base_.headings[i]);
    if (base_.has_before(i)) {
      both(right_of(flat(base_.headings[base_.before(i)])));
      corner(base_.before(i), i, i);
    }
    points.add(flat(base_.start(i)));
    points.add(flat(base_.end(i)));
    both(right_of(u));
    block.directions |= ChainTree::directions_of(u, u);
    if ((i + 1) % leaf_size != 0 && i + 1 != last) continue;
    left_.push_back(left.box());
    block.left.add(left_.back());
    left = {};
  }
  if (base_.has_after(last - 1)) {
    both(right_of(flat(base_.headings[base_.after(last - 1)])));
    corner(last - 1, base_.after(last - 1), base_.end_index(last - 1));
  }
  block.absent = absent_pieces(first, last);
  block.piece_count = 64 - static_cast<std::uint32_t>(std::popcount(block.absent));
  block.plain_below = plain_below(first, last);
  block.points = points.box();
  block.right = right.box();
  blocks_.push_back(block);
}

std::uint64_t Clearance::absent_pieces(std::size_t first, std::size_t last) const {
  std::uint64_t absent = ~std::uint64_t{0};
  for (std::size_t i = first; i < last; ++i) {
    std::uint64_t there = base_.has_after(i) ? 1 : 7;  // the cap
    if (base_.has_after(i)) {
      const std::size_t at = base_.end_index(i);
      if (corners_[at] == CornerKind::Tangent) there |= 8;
      if (corners_[at] == CornerKind::Arc) there |= base_.half_tans[at] > 1 ? 6 : 2;
    }
    absent &= ~(there << (4 * (i - first)));
  }
  return absent;
}

/// 0 if there is no such distance, as at the ends of the base.
double Clearance::plain_below(std::size_t first, std::size_t last) const {
  if (first == 0 || last >= base_.segment_count()) return 0;
  double least = std::numeric_limits<double>::infinity();
  const auto inner = [&](std::size_t at) { return corners_[at] == CornerKind::Meet ? base_.half_tans[at] : 0; };
  for (std::size_t i = first; i < last; ++i) {
    const CornerKind kind = corners_[i + 1];
    if (kind == CornerKind::Tangent || (kind == CornerKind::Arc && !(base_.half_tans[i + 1] <= 1))) return 0;
    // More than the margin of any D is to be left.
    const double left = base_.spans[i] - 1e-13 * base_.size;
    least = std::min(least, left / (inner(i) + inner(i + 1) + 1e-13 * (1 + greatest_mitre_)));
    least = std::min(least, base_.spans[i + 1] / (inner(i + 1) + 1e-300));
  }
  return least * (1 - 1e-9);
}

void Clearance::add_mitres(const OffsetOptions& options) {
  if (options.join == Join::Round || options.join == Join::Bevel) return;
  bool some = false;
  std::vector<FloatBox> boxes((base_.segment_count() + leaf_size - 1) / leaf_size);
  for (std::size_t i = 0; i < base_.segment_count(); ++i) {
    const std::size_t at = base_.end_index(i);
    if (!base_.has_after(i) || !is_mitre(at)) continue;
    some = true;
    FloatBox& box = boxes[i / leaf_size];
    const Flat u = flat(base_.headings[i]);
    const Flat v = flat(base_.headings[base_.after(i)]);
    const double t = base_.half_tans[at];
    has_long_mitres_ = has_long_mitres_ || is_long(at);
    if (corners_[at] == CornerKind::Mitre) greatest_mitre_ = std::max(greatest_mitre_, t);
    const double q = corners_[at] == CornerKind::Mitre ? t : quarter_tan(t);
    for (const Flat w : {right_of(u), right_of(v), right_of(u) + q * u, right_of(v) - q * v}) add(box, w);
  }
  if (some) mitres_ = BoxTree(boxes);
}

double Clearance::squared_distance(std::size_t i, Flat p) const {
  const Flat u = flat(base_.headings[i]);
  const Flat to = p - flat(base_.start(i));
  const double s = dot(to, u);
  const double t = std::clamp(s, 0.0, base_.spans[i]);
  const double across = cross(to, u);
  return across * across + (s - t) * (s - t);
}

std::uint32_t Clearance::find_nearer(Flat q, double r) const {
  if (!(r > 0)) return none;
  std::uint32_t found = none;
  double least = r * r;
  tree_.any_within(q, r, [&](std::size_t leaf) {
    any_of_leaf(leaf, [&](std::size_t i) {
      const double squared = squared_distance(i, q);
      if (squared >= least) return false;
      least = squared;
      found = static_cast<std::uint32_t>(i);
      return false;
    });
    return found != none;
  });
  return found;
}

std::uint32_t Clearance::find_mitre(Flat q, const Outline& outline, double r) const {
  std::uint32_t found = none;
  any_mitre(q, outline.distance(), [&](std::uint32_t step) {
    const Flat near = q - flat(base_.end(step));
    const Flat u = flat(base_.headings[step]);
    const Flat v = flat(base_.headings[base_.after(step)]);
    if (dot(near, u) < 0 || dot(near, v) > 0 || dot(near, right_of(u)) >= r || dot(near, right_of(v)) >= r)
      return false;
    if (!outline.deep_inside(q, step, outline.distance() - r)) return false;  // cut across, perhaps
    found = step;
    return true;
  });
  return found;
}

}  // namespace dobra::offset::general
