#include "shared/offset/general/witness.h"

#include <algorithm>
#include <cmath>

namespace dobra::offset::general {

Buried::Buried(const BaseCurve& base, const Clearance& clearance, double greatest)
    : base_(&base), clearance_(&clearance), greatest_(greatest) {
  for (const Block& block : clearance.blocks()) bits_.push_back(block.absent);
  bits_.resize(2 * bits_.size(), 0);
}

bool Buried::for_ever(Site s) const {
  if (s.kind == SiteKind::Bevel) return false;
  if (s.kind != SiteKind::Line || s.step >= base_->segment_count()) return true;
  return !(base_->has_before(s.step) && clearance_->is_mitre(s.step)) &&
         !(base_->has_after(s.step) && clearance_->is_mitre(base_->end_index(s.step)));
}

WitnessSearch::WitnessSearch(const Outline& outline, const Clearance& clearance)
    : outline_(outline),
      clearance_(clearance),
      d_(outline.distance()),
      margin_(clearance.margin(outline.distance())),
      cells_per_length_(8 / d_) {}

/// A step's set is an intersection of half-planes m . (x - c) < D: a tip c' + D w that lies in it at two distances does
/// so at all between, and where |w| = 1, as at the foot of the tip, at all greater ones.
bool WitnessSearch::tips_stay(std::uint32_t step, double d) const {
  const BaseCurve& base = outline_.base();
  const Outline last(base, clearance_.corners(), outline_.sides(), d);
  const double margin = clearance_.margin(d);
  const Flat u = outline_.along<double>(step);
  const Flat n = right_of(u);
  const auto stays = [&](std::size_t at, Flat out) {
    if (clearance_.corners()[at] != CornerKind::Mitre) return clearance_.corners()[at] != CornerKind::Tangent;
    const double t = base.half_tans[at];
    if (t > 16) return false;  // a rounded direction misses
    const Flat c = flat(base.points[at]);
    const Flat w = n + t * out;
    return last.deep_inside(c + d * w, witness_, margin) && deep(c + d_ * w, witness_) && deep(c + d_ * n, witness_);
  };
  return d >= d_ && witness_ != Clearance::none && (!base.has_before(step) || stays(step, -u)) &&
         (!base.has_after(step) || stays(base.end_index(step), u));
}

std::size_t WitnessSearch::cell_of(Flat p) const {
  const auto index = [&](double x) {
    const double cell = std::floor(x * cells_per_length_);
    return std::abs(cell) < 1e15 ? static_cast<std::size_t>(static_cast<std::int64_t>(cell)) % cells_across : 0;
  };
  return index(p.x) * cells_across + index(p.y);
}

/// A step noted for a place's cell whose set holds it deep inside; none if there is none.
std::uint32_t WitnessSearch::noted(Flat p) const {
  if (cells_.empty()) return Clearance::none;
  for (const std::uint32_t step : cells_[cell_of(p)]) {
    if (step != Clearance::none && deep(p, step)) return step;
  }
  return Clearance::none;
}

void WitnessSearch::note(Flat p, std::uint32_t step) {
  if (cells_.empty()) cells_.assign(cells_across * cells_across, Cell{Clearance::none, Clearance::none});
  Cell& cell = cells_[cell_of(p)];
  cell = {step, cell[0]};
}

/// The same for any step.
std::uint32_t WitnessSearch::find(Flat p) {
  if (const std::uint32_t step = noted(p); step != Clearance::none) return step;
  const double r = d_ - 4 * margin_;
  std::uint32_t found = clearance_.find_nearer(p, r);
  if (found == Clearance::none) found = clearance_.find_mitre(p, outline_, r);
  if (found != Clearance::none) note(p, found);
  return found;
}

Flat WitnessSearch::middle(Site s, Flat a, Flat b) const {
  const Flat half = 0.5 * (a + b);
  if (s.kind == SiteKind::Line || s.kind == SiteKind::Bevel) return half;
  const Flat c = outline_.centre(s);
  return c + (d_ / length(half - c)) * (half - c);
}

bool WitnessSearch::covers(Site s, Flat a, Flat b) {
  if (witness_ != Clearance::none && in_set(s, a, b, witness_)) return true;
  const std::array<Flat, 3> places{middle(s, a, b), a, b};
  std::array<std::uint32_t, 3> held{};
  for (std::size_t k = 0; k < places.size(); ++k) {
    held[k] = find(places[k]);
    if (held[k] == Clearance::none) return false;
    if (!in_set(s, a, b, held[k])) continue;
    remember(held[k]);
    return true;
  }
  constexpr int depth = 10;
  return between(s, a, held[1], places[0], held[0], depth) && between(s, places[0], held[0], b, held[2], depth);
}

/// The part from a to b, each of which is held by a step's set.
bool WitnessSearch::between(Site s, Flat a, std::uint32_t holds_a, Flat b, std::uint32_t holds_b, int depth) {
  for (const std::uint32_t step : {holds_a, holds_b}) {
    if (!in_set(s, a, b, step)) continue;
    remember(step);
    return true;
  }
  if (depth == 0) return false;
  const Flat m = middle(s, a, b);
  if (in_set(s, a, m, holds_a)) return between(s, m, holds_a, b, holds_b, depth - 1);
  if (in_set(s, m, b, holds_b)) return between(s, a, holds_a, m, holds_b, depth - 1);
  const std::uint32_t step = find(m);
  return step != Clearance::none && between(s, a, holds_a, m, step, depth - 1) &&
         between(s, m, step, b, holds_b, depth - 1);
}

bool WitnessSearch::shorten(Flat& a, Flat& b) { return advance(a, b) && advance(b, a); }

/// From set to set, each of which is left before the next one is asked for.
bool WitnessSearch::advance(Flat& from, Flat to) {
  constexpr int most_sets = 8;
  constexpr int halvings = 6;
  std::uint32_t step = noted(from);
  for (int k = 0; k < most_sets; ++k) {
    if (step == Clearance::none || !deep(from, step)) return true;
    if (deep(to, step)) return false;
    Flat out = to;
    for (int h = 0; h < halvings; ++h) {
      const Flat m = 0.5 * (from + out);
      (deep(m, step) ? from : out) = m;
    }
    step = noted(out);
  }
  return true;
}

}  // namespace dobra::offset::general
