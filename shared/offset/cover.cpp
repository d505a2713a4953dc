#include "shared/offset/cover.h"

#include <algorithm>

namespace dobra::offset {

Buried::Buried(const BaseCurve& base, const Clearance& clearance)
    : base_(&base),
      corners_(&clearance.corners()),
      n_(static_cast<std::uint32_t>(base.segment_count())),
      words_((n_ + 15) / 16),
      bits_(2 * words_, 0) {
  if (clearance.has_mitres()) hints_.assign(n_, none);
  for (std::size_t i = 0; i < words_; ++i) bits_[i] = clearance.blocks()[i].absent;
}

bool Buried::for_ever(Site s) const {
  if (s.role == Role::Bevel) return false;
  if (s.role != Role::Line || s.step >= n_) return true;
  const auto long_end = [&](std::size_t at) { return (*corners_)[at] == Corner::Mitre || (*corners_)[at] == Corner::Tangent; };
  return !(base_->has_before(s.step) && long_end(s.step)) && !(base_->has_after(s.step) && long_end(base_->end_index(s.step)));
}

void Buried::add(Site s, std::uint32_t killer) {
  ++count_;
  if (for_ever(s)) {
    bits_[place(s)] |= std::uint64_t{1} << shift(s);
  } else if (s.role == Role::Line) {
    hints_[s.step] = killer;
  }
}

void Buried::set_reach(Site s, double d) {
  if (!has_reach(s)) return;
  if (reaches_.empty()) reaches_.assign(2 * std::size_t{n_}, 0);
  reaches_[reach_place(s)] = static_cast<std::uint16_t>(std::bit_cast<std::uint32_t>(static_cast<float>(d)) >> 16);
}

/// The disc that touches the base there shrinks until it holds nothing else.
double Cover::free_until(Site s) const {
  const bool line = s.role == Role::Line || s.role == Role::Bevel;
  const Flat n = line ? right_of(outline_.along<double>(s.step)) : (1 / d_) * (free_ - outline_.centre(s));
  const Flat foot = free_ - d_ * n;
  double r = 4 * d_;
  for (int k = 0; k < 8 && r > d_; ++k) {
    const Flat c = foot + r * n;
    const std::uint32_t step = clearance_.find_nearer(c, 0.97 * r);
    if (step == Clearance::none) return 0.97 * r;
    const Flat u = outline_.along<double>(step);
    const Flat from = outline_.from<double>(step);
    const Flat x = from + std::clamp(dot(c - from, u), 0.0, outline_.span(step)) * u - foot;
    r = std::min(0.97 * r, dot(x, x) / (2 * dot(x, n)));
  }
  return r;
}

void Cover::remember(std::uint32_t step) {
  std::uint32_t moved = step;
  for (std::uint32_t& r : recent_) {
    std::swap(r, moved);
    if (moved == step) return;
  }
}

bool Cover::by_recent(Site s, Flat a, Flat b) {
  for (const std::uint32_t step : recent_) {
    if (step == Clearance::none) return false;
    if (!in_set(s, a, b, step)) continue;
    remember(step);
    return true;
  }
  return false;
}

/// A step whose set holds p deep inside; none if there is none.
std::uint32_t Cover::find(Flat p) {
  const double r = d_ - 4 * margin_;
  std::uint32_t found = clearance_.find_nearer(p, r);
  if (found == Clearance::none) found = clearance_.find_mitre(p, outline_, r);
  if (found == Clearance::none) free_ = p;
  return found;
}

Flat Cover::middle(Site s, Flat a, Flat b) const {
  const Flat half = 0.5 * (a + b);
  if (s.role == Role::Line || s.role == Role::Bevel) return half;
  const Flat c = outline_.centre(s);
  return c + (d_ / length(half - c)) * (half - c);
}

bool Cover::covers(Site s, Flat a, Flat b) {
  if (by_recent(s, a, b)) return true;
  const Flat m = middle(s, a, b);
  for (const Flat p : {m, a, b}) {
    const std::uint32_t step = find(p);
    if (step == Clearance::none) return false;
    if (!in_set(s, a, b, step)) continue;
    remember(step);
    return true;
  }
  return halves(s, a, m, b, 5);
}

bool Cover::halves(Site s, Flat a, Flat m, Flat b, int depth) {
  const auto half = [&](Flat p, Flat q) {
    if (by_recent(s, p, q)) return true;
    const Flat k = middle(s, p, q);
    const std::uint32_t step = find(k);
    if (step == Clearance::none) return false;
    if (in_set(s, p, q, step)) {
      remember(step);
      return true;
    }
    return depth > 0 && halves(s, p, k, q, depth - 1);
  };
  return half(a, m) && half(m, b);
}

}  // namespace dobra::offset
