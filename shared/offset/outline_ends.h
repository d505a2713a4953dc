#pragma once
// What is asked of nearly every piece, inline: natural ends in doubles, for pieces in the order of the walk, of which
// neighbours share a junction; and whether line simply follows line.

#include "shared/offset/outline.h"

namespace dobra::offset {

class Outline::Ends {
 public:
  explicit Ends(const Outline& outline) : outline_(outline) {}
  [[nodiscard]] Flat start_of(Site s);
  [[nodiscard]] Flat end_of(Site s);

 private:
  [[nodiscard]] Flat other_start_of(Site s);
  const Junction& at(std::uint32_t step) {
    if (step != step_) junction_ = outline_.junction(step);
    step_ = step;
    return junction_;
  }
  const Outline& outline_;
  std::uint32_t step_ = std::numeric_limits<std::uint32_t>::max();
  Junction junction_{};
};

inline Flat Outline::Ends::start_of(Site s) {
  if (s.step == 0 || s.step >= outline_.n_) return other_start_of(s);
  // Mostly so: the right side, without the detours.
  const BaseCurve& base = outline_.base_;
  const double d = outline_.d_;
  if (s.role == Role::Arc) return flat(base.end(s.step)) + d * right_of(flat(base.headings[s.step]));
  const Corner kind = outline_.corners_[s.step];
  if (s.role != Role::Line || kind == Corner::Tangent) return other_start_of(s);
  const Flat p = flat(base.points[s.step]);
  const double t = base.half_tans[s.step];
  const bool mitre = kind == Corner::Mitre;
  if (mitre && t > 16) return other_start_of(s);
  if (mitre || (kind == Corner::Meet && outline_.meets(t, base.spans[s.step - 1], base.spans[s.step]))) {
    const Flat u = flat(base.headings[s.step - 1]);
    return p + d * right_of(u) + (mitre ? d * t : -(d * t)) * u;
  }
  return p + d * right_of(flat(base.headings[s.step]));
}

/// The line of a step and the corner at its end, where that is a plain one: none, an inner one that leaves a length of
/// both lines, a mitre, or an arc of at most a right angle.
struct Outline::Lead {
  bool plain;
  Corner kind;
  double length;  ///< What inner corners at both ends leave of the line.
};
inline Outline::Lead Outline::lead(std::uint32_t step) const {
  const std::size_t at = step + 1;
  if (step == 0 || at >= n_) return {false, Corner::Straight, 0};
  const Corner kind = corners_[at];
  const double t = base_.half_tans[at];
  const double span = base_.spans[step];
  const bool plain = kind == Corner::Meet  ? meets(t, span, base_.spans[at])
                     : kind == Corner::Arc ? t <= 1
                                           : kind == Corner::Straight || kind == Corner::Mitre;
  if (!plain) return {false, kind, 0};
  const double before = corners_[step] == Corner::Meet ? base_.half_tans[step] : 0;
  const double after = kind == Corner::Meet ? t : 0;
  return {true, kind, span - d_ * (before + after)};
}

}  // namespace dobra::offset
