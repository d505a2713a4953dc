#include "shared/offset/monotone/lower_envelope.h"

#include <algorithm>
#include <limits>

namespace dobra::offset::monotone {

namespace {

class Merger {
 public:
  Merger(std::vector<Span>& out, double touching) : out_(out), touching_(touching) {}

  void merge(const Span* a, const Span* a_end, const Span* b, const Span* b_end) {
    double x = -std::numeric_limits<double>::infinity();
    while (a != a_end && b != b_end) {
      const double xa = std::max(a->x0, x);
      const double xb = std::max(b->x0, x);
      if (xa < xb) {
        x = std::min(a->x1, xb);
        emit(*a, xa, x);
      } else if (xb < xa) {
        x = std::min(b->x1, xa);
        emit(*b, xb, x);
      } else {
        x = std::min(a->x1, b->x1);
        emit_lower(*a, *b, xa, x);
      }
      if (a->x1 <= x) ++a;
      if (b->x1 <= x) ++b;
    }
    for (; a != a_end; ++a) emit(*a, std::max(a->x0, x), a->x1);
    for (; b != b_end; ++b) emit(*b, std::max(b->x0, x), b->x1);
  }

 private:
  void emit(const Span& s, double x0, double x1) {
    if (!(x1 > x0)) return;
    if (!out_.empty() && out_.back().site == s.site && out_.back().x1 == x0) {
      out_.back().x1 = x1;
    } else {
      out_.push_back({x0, x1, s.x, s.y, s.slope, s.site});
    }
  }
  void emit_lower(const Span& a, const Span& b, double x0, double x1) {
    const double before = a.at(x0) - b.at(x0);
    const double after = a.at(x1) - b.at(x1);
    if (before <= touching_ && after <= touching_) return emit(a, x0, x1);
    if (before >= -touching_ && after >= -touching_) return emit(b, x0, x1);
    const double x = std::clamp(x0 + (x1 - x0) * (before / (before - after)), x0, x1);
    emit(before < 0 ? a : b, x0, x);
    emit(before < 0 ? b : a, x, x1);
  }

  std::vector<Span>& out_;
  double touching_;
};

}  // namespace

std::vector<Span> LowerEnvelope::finish() {
  while (levels_.size() > 1) merge_last_two();
  return std::move(spans_);
}

void LowerEnvelope::merge_last_two() {
  const auto a = spans_.begin() + static_cast<std::ptrdiff_t>(levels_[levels_.size() - 2].first);
  const auto b = spans_.begin() + static_cast<std::ptrdiff_t>(levels_.back().first);
  levels_.pop_back();
  ++levels_.back().order;
  if (a == b || b == spans_.end()) return;
  // Graphs in order overlap with the end of the ones before and the start of the ones after.
  const double low = b->x0;
  const double high = (b - 1)->x1;
  auto from = b;
  while (from != a && (from - 1)->x1 > low) --from;
  auto to = b;
  while (to != spans_.end() && to->x0 < high) ++to;
  if (from == b || to == b) return;
  merged_.clear();
  Merger(merged_, touching_).merge(&*from, &*b, &*b, &*b + (to - b));
  const std::ptrdiff_t room = to - from;
  const auto size = static_cast<std::ptrdiff_t>(merged_.size());
  if (size <= room) {
    spans_.erase(std::copy(merged_.begin(), merged_.end(), from), to);
  } else {
    std::copy(merged_.begin(), merged_.begin() + room, from);
    spans_.insert(to, merged_.begin() + room, merged_.end());
  }
}

}  // namespace dobra::offset::monotone
