#pragma once
// What is asked of nearly every piece, inline: its natural ends in doubles, and whether line simply follows line.
// Pieces are asked for in the order of the walk, in which neighbours share a junction.

#include "shared/offset/general/block.h"
#include "shared/offset/general/outline.h"

namespace dobra::offset::general {

/// Natural starts of lines and first arcs of the right side in doubles, for very many in a row: no detours, and all
/// that is asked of the base at hand.
class Outline::Starts {
 public:
  explicit Starts(const Outline& outline)
      : points_(outline.base_.points.data()),
        headings_(outline.base_.headings.data()),
        half_tans_(outline.base_.half_tans.data()),
        spans_(outline.base_.spans.data()),
        corners_(outline.corners_.data()),
        d_(outline.d_),
        inner_(outline.n_ < 2 ? 0 : outline.n_ - 2) {}
  /// False at the ends of the walk, and where the corner is not of a usual kind.
  bool find(Site s, geom::Point& start) const {
    const std::uint32_t i = s.step;
    if (i - 1 >= inner_ || s.kind > SiteKind::Arc) return false;
    if (s.kind == SiteKind::Arc) {
      start = points_[i + 1] + d_ * geom::right_of(headings_[i]);
      return true;
    }
    const CornerKind kind = corners_[i];
    const double t = half_tans_[i];
    if (kind == CornerKind::Tangent || (kind == CornerKind::Mitre && t > 16)) return false;
    if (kind == CornerKind::Mitre || (kind == CornerKind::Meet && meets(d_, t, spans_[i - 1], spans_[i]))) {
      const geom::Vector u = headings_[i - 1];
      const double reach = d_ * t;
      start = points_[i] + d_ * geom::right_of(u) + (kind == CornerKind::Mitre ? reach : -reach) * u;
    } else {
      start = points_[i] + d_ * geom::right_of(headings_[i]);
    }
    return true;
  }

  /// The same for the 16 steps of a block from `first` on, D being below its plain_below, and no mitre far: all starts
  /// in a row. What is at the start of the first step is not known to be plain.
  /// @param arcs  four bits a step: the first one where an arc is at its end.
  bool find_block(std::uint32_t first, std::uint64_t arcs, geom::Point* start) const {
    geom::Point* const first_start = start;
    static constexpr double sign[] = {0, -1, 0, 1, 0, 0};  // of a CornerKind
    static constexpr std::uint32_t back[] = {0, 1, 0, 1, 0, 0};
    for (std::uint32_t i = first; i < first + Block::size; ++i, arcs >>= 4) {
      const auto kind = static_cast<std::size_t>(corners_[i]);
      const geom::Vector u = headings_[i - back[kind]];
      *start++ = points_[i] + d_ * geom::right_of(u) + (sign[kind] * (d_ * half_tans_[i])) * u;
      if ((arcs & 1) != 0) *start++ = points_[i + 1] + d_ * geom::right_of(headings_[i]);
    }
    return find({first, SiteKind::Line}, *first_start);
  }

 private:
  const geom::Point* points_;
  const geom::Vector* headings_;
  const double* half_tans_;
  const double* spans_;
  const CornerKind* corners_;
  double d_;
  std::uint32_t inner_;  // from 1 on so many steps
};

class Outline::Ends {
 public:
  explicit Ends(const Outline& outline) : outline_(outline), starts_(outline) {}
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
  const Starts starts_;
  std::uint32_t step_ = std::numeric_limits<std::uint32_t>::max();
  Junction junction_{};
};

inline Flat Outline::Ends::start_of(Site s) {
  geom::Point start;
  return starts_.find(s, start) ? flat(start) : other_start_of(s);
}

/// The line of a step and the corner at its end, where that is a plain one: none, an inner one that leaves a length of
/// both lines, a mitre, or an arc of at most a right angle.
struct Outline::Lead {
  bool plain;
  CornerKind kind;
  double length;  ///< What inner corners at both ends leave of the line.
};
inline Outline::Lead Outline::lead(std::uint32_t step) const {
  const std::size_t at = step + 1;
  if (step == 0 || at >= n_) return {false, CornerKind::Straight, 0};
  const CornerKind kind = corners_[at];
  const double t = base_.half_tans[at];
  const double span = base_.spans[step];
  const bool plain = kind == CornerKind::Meet  ? meets(d_, t, span, base_.spans[at])
                     : kind == CornerKind::Arc ? t <= 1
                                               : kind == CornerKind::Straight || kind == CornerKind::Mitre;
  if (!plain) return {false, kind, 0};
  const double before = corners_[step] == CornerKind::Meet ? base_.half_tans[step] : 0;
  const double after = kind == CornerKind::Meet ? t : 0;
  return {true, kind, span - d_ * (before + after)};
}

}  // namespace dobra::offset::general
