#include "shared/offset/envelope.h"

#include <algorithm>

#include "shared/geom/predicates.h"
#include "shared/offset/piece_writer.h"

namespace dobra::offset {

using geom::Point;
using geom::Vector;

std::optional<Vector> monotone_direction(const BaseCurve& base) {
  if (base.closed) return std::nullopt;
  // The segments with the rightmost and the leftmost direction so far; they span less than half a turn.
  std::size_t right = 0;
  std::size_t left = 0;
  const auto cross = [&](std::size_t i, std::size_t j) {
    return geom::cross_sign(base.start(i), base.end(i), base.start(j), base.end(j));
  };
  for (std::size_t i = 1; i < base.segment_count(); ++i) {
    const bool beyond_right = cross(right, i) == geom::Sign::Negative;
    const bool beyond_left = cross(left, i) == geom::Sign::Positive;
    if (!beyond_right && !beyond_left) {
      // Within, or exactly opposite to both.
      if (geom::dot(base.headings[i], base.headings[right] + base.headings[left]) <= 0) return std::nullopt;
      continue;
    }
    if (beyond_right && beyond_left) return std::nullopt;
    if (beyond_right) right = i;
    if (beyond_left) left = i;
    const geom::Sign width = cross(right, left);
    if (width == geom::Sign::Negative || (width == geom::Sign::Zero && right != left)) return std::nullopt;
  }
  const Vector sum = base.headings[right] + base.headings[left];
  const double size = geom::length(sum);
  if (!(size > 1e-6)) return std::nullopt;  // hardly less than half a turn: rounding could tell otherwise
  return sum / size;
}

namespace {

class Envelope {
 public:
  Envelope(const BaseCurve& base, double distance) : base_(base), d_(distance) {}

  void run(Vector forward);
  [[nodiscard]] OffsetPiece write(const OffsetOptions& options) const;

 private:
  /// A part of the envelope from `start` to the next one's start: the line of segment site / 2, or the arc about its end.
  struct Part {
    Point start;
    std::uint32_t site;
    [[nodiscard]] bool is_arc() const { return site % 2 != 0; }
  };
  static constexpr std::uint32_t cap = 0xffffffffU;  // odd: the arc about the first point

  [[nodiscard]] Point centre(const Part& part) const { return part.site == cap ? base_.points[0] : base_.end(part.site / 2); }
  void add_segment(std::size_t i);
  void add_under_tail(std::size_t i);
  void push(Point start, std::size_t site) { parts_.push_back({start, static_cast<std::uint32_t>(site)}); }
  [[nodiscard]] Point entry(const Part& part, Point end, Point disc) const;

  const BaseCurve& base_;
  const double d_;
  std::vector<Part> parts_;
  Point tip_;              // where the envelope so far enters the disc about the last point
  bool on_foot_ = true;    // tip_ is the end of the last segment's own line
};

void Envelope::run(Vector forward) {
  const std::size_t count = base_.segment_count();
  parts_.reserve(count + count / 2 + 2);
  parts_.push_back({base_.points[0] - d_ * forward, cap});
  for (std::size_t i = 0; i < count; ++i) add_segment(i);
}

inline void Envelope::add_segment(std::size_t i) {
  const Vector u = base_.headings[i];
  const Vector out = d_ * geom::right_of(u);
  const Point p = base_.points[i];
  if (i > 0) {
    const Turn turn = base_.turn[i];
    if (turn == Turn::Outer && (on_foot_ || geom::dot(tip_ - p, u) <= 0)) {
      push(tip_, 2 * i - 1);
    } else if (turn == Turn::Inner && on_foot_) {
      // The two lines meet on the bisector, if it is within both.
      const double back = d_ * base_.half_tans[i];
      const Vector before = base_.headings[i - 1];
      const Point meet = tip_ - back * before;
      if (back > base_.spans[i] || geom::dot(meet - parts_.back().start, before) <= 0) return add_under_tail(i);
      push(meet, 2 * i);
      tip_ = base_.points[i + 1] + out;
      return;
    } else if (!(turn == Turn::Straight && on_foot_)) {
      return add_under_tail(i);
    }
  }
  push(p + out, 2 * i);
  tip_ = base_.points[i + 1] + out;
  on_foot_ = true;
}

/// The new segment's own start is hidden: its pill appears at the first place where the tail enters it.
void Envelope::add_under_tail(std::size_t i) {
  const Vector u = base_.headings[i];
  const Vector n = geom::right_of(u);
  const Point p = base_.points[i];
  const Point q = base_.points[i + 1];
  const double span = base_.spans[i];
  const auto beyond = [&](Point at) { return geom::dot(at - p, n) - d_; };
  // The tail is outside the disc about p, so only line and far disc of the pill count.
  const auto inside = [&](Point at) {
    const double s = geom::dot(at - p, u);
    if (s > span) return geom::length_squared(at - q) < d_ * d_;
    return s > 0 && beyond(at) < 0;
  };
  Point end = tip_;
  while (parts_.size() > 1 && inside(parts_.back().start)) {
    end = parts_.back().start;
    parts_.pop_back();
  }
  const Part tail = parts_.back();
  const auto cut_at = [&](Point cut) {
    push(cut, 2 * i);
    tip_ = q + d_ * n;
    on_foot_ = true;
  };
  if (tail.is_arc()) {
    // Circle and pill cross twice at most; of the two places on the line this is where an anticlockwise arc enters.
    const Vector to = centre(tail) - p;
    const double gap = d_ - geom::dot(to, n);
    if (gap <= d_) {
      const double s = geom::dot(to, u) + std::sqrt((d_ - gap) * (d_ + gap));
      if (s <= span) return cut_at(p + std::max(0.0, s) * u + d_ * n);
    }
  } else if (const double start_beyond = beyond(tail.start); start_beyond >= 0) {
    const double end_beyond = std::min(0.0, beyond(end));
    const double t = start_beyond > 0 ? start_beyond / (start_beyond - end_beyond) : 0.0;
    const Point cut = tail.start + t * (end - tail.start);
    if (geom::dot(cut - p, u) <= span) return cut_at(cut);
  }
  tip_ = entry(tail, end, q);
  on_foot_ = false;
}

/// Where `part`, which ends inside the disc of radius D about `disc`, enters it.
Point Envelope::entry(const Part& part, Point end, Point disc) const {
  if (part.is_arc()) {
    const Point c = centre(part);
    const Vector to = disc - c;
    const double gap = std::sqrt(geom::length_squared(to));
    const double height = std::sqrt(std::max(0.0, (d_ - 0.5 * gap) * (d_ + 0.5 * gap)));
    return c + 0.5 * to + (height / gap) * geom::right_of(to);
  }
  const Vector along = base_.headings[part.site / 2];
  const Vector to = disc - part.start;
  const double across = geom::cross(along, to);
  const double foot = geom::dot(along, to);
  const double t = foot - std::sqrt(std::max(0.0, (d_ - across) * (d_ + across)));
  return part.start + std::clamp(t, 0.0, std::max(0.0, geom::dot(end - part.start, along))) * along;
}

OffsetPiece Envelope::write(const OffsetOptions& options) const {
  if (parts_.size() < 2) return {};
  PieceWriter writer(base_, options.join);
  writer.reserve(parts_.size());
  for (std::size_t k = 1; k < parts_.size(); ++k) {
    const Part& part = parts_[k];
    if (part.is_arc()) {
      writer.add_arc(part.start, part.site / 2);
    } else {
      writer.add_line(part.start, part.site / 2);
    }
  }
  return writer.finish_open(tip_);
}

}  // namespace

OffsetPiece monotone_offset(const BaseCurve& base, Vector forward, double distance, const OffsetOptions& options) {
  Envelope envelope(base, distance);
  envelope.run(forward);
  return envelope.write(options);
}

}  // namespace dobra::offset
