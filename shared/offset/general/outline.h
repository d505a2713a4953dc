#pragma once
// The raw outline at distance D: lines and arcs to the right of the base, and to the right of the base travelled
// backwards (its left side), which only serve to cut. Everything is symbolic. A piece knows the site (segment or
// corner) that it is parallel to. An end is natural or a crossing with another site, so its place can be computed in
// doubles or in Real.

#include <limits>
#include <type_traits>
#include <vector>

#include "shared/offset/kernel/base_curve.h"
#include "shared/offset/kernel/site.h"

namespace dobra::offset::general {

/// On the right side, at each base point, whatever the distance: inner ones are Meet.
std::vector<CornerKind> right_corners(const BaseCurve& base, const OffsetOptions& options);

/// The base as a closed walk (or two).
class Outline {
 public:
  enum class Sides {
    Right,  ///< The right side only: closed bases that do not cross themselves.
    Both,   ///< Open: right side, cap, left side, cap. Closed: two walks.
  };
  /// @param corners  see right_corners; must outlive this.
  Outline(const BaseCurve& base, const std::vector<CornerKind>& corners, Sides sides, double distance)
      : base_(base),
        corners_(corners),
        sides_(sides),
        d_(distance),
        n_(static_cast<std::uint32_t>(base.segment_count())) {}

  [[nodiscard]] double distance() const { return d_; }
  [[nodiscard]] const BaseCurve& base() const { return base_; }
  [[nodiscard]] Sides sides() const { return sides_; }
  [[nodiscard]] std::uint32_t step_count() const { return sides_ == Sides::Both ? 2 * n_ : n_; }
  [[nodiscard]] std::uint32_t segment(std::uint32_t step) const { return step < n_ ? step : 2 * n_ - 1 - step; }
  [[nodiscard]] bool two_walks() const { return base_.closed && sides_ == Sides::Both; }
  /// True if an end of the base follows the step.
  [[nodiscard]] bool is_cap(std::uint32_t step) const {
    return !base_.closed && (step == n_ - 1 || step == 2 * n_ - 1);
  }
  [[nodiscard]] std::uint32_t after(std::uint32_t step) const {
    if (two_walks()) return step == n_ - 1 ? 0 : step == 2 * n_ - 1 ? n_ : step + 1;
    return step + 1 == 2 * n_ || step + 1 == step_count() ? 0 : step + 1;
  }
  [[nodiscard]] std::uint32_t before(std::uint32_t step) const {
    if (two_walks()) return step == 0 ? n_ - 1 : step == n_ ? 2 * n_ - 1 : step - 1;
    return step == 0 ? (base_.closed ? n_ - 1 : 2 * n_ - 1) : step - 1;
  }
  /// Index of the base point at the end of the step.
  [[nodiscard]] std::size_t corner_point(std::uint32_t step) const {
    return step < n_ ? base_.end_index(step) : segment(step);
  }
  [[nodiscard]] double half_tan(std::uint32_t step) const {
    return is_cap(step) ? std::numeric_limits<double>::infinity() : base_.half_tans[corner_point(step)];
  }
  [[nodiscard]] double span(std::uint32_t step) const { return base_.spans[segment(step)]; }
  /// What happens at the end of a step. Decided in doubles once, so that all agree.
  [[nodiscard]] CornerKind corner(std::uint32_t step) const;

  // Places, in doubles or in Real.
  template <class T>
  [[nodiscard]] VecOf<T> from(std::uint32_t step) const {
    const geom::Point p = step < n_ ? base_.start(step) : base_.end(segment(step));
    return {p.x, p.y};
  }
  template <class T>
  [[nodiscard]] VecOf<T> to(std::uint32_t step) const {
    const geom::Point p = base_.points[corner_point(step)];
    return {p.x, p.y};
  }
  template <class T>
  [[nodiscard]] VecOf<T> along(std::uint32_t step) const {
    if constexpr (std::is_same_v<T, double>) {
      const Flat u = flat(base_.headings[segment(step)]);
      return step < n_ ? u : -u;
    } else {
      return unit(to<T>(step) - from<T>(step));
    }
  }
  template <class T>
  [[nodiscard]] VecOf<T> normal(std::uint32_t step) const {
    return right_of(along<T>(step));
  }
  template <class T>
  [[nodiscard]] T half_tan_as(std::uint32_t step) const;
  /// How far, over D, the line of a step goes on beyond the normal at its end, given the corner there.
  template <class T>
  [[nodiscard]] T overshoot(std::uint32_t step, CornerKind kind) const;
  /// Where the line of `step` ends, and where that of the next one begins.
  template <class T>
  [[nodiscard]] VecOf<T> line_end(std::uint32_t step) const;
  template <class T>
  [[nodiscard]] VecOf<T> line_start(std::uint32_t step) const;
  template <class T>
  [[nodiscard]] VecOf<T> natural_start(Site s) const;
  template <class T>
  [[nodiscard]] VecOf<T> natural_end(Site s) const;
  template <class T>
  [[nodiscard]] VecOf<T> middle_of_turn(std::uint32_t step) const;
  [[nodiscard]] bool splits_arc(std::uint32_t step) const { return half_tan(step) > 1; }

  /// The end of a step in doubles: what happens there, where its line ends and where the next one begins.
  struct Junction {
    CornerKind kind;
    Flat end, start;
  };
  [[nodiscard]] Junction junction(std::uint32_t step) const;
  /// What inner corners at both ends leave of the line of a step of the right side, if the corner at its end is a plain
  /// one: none, an inner one that leaves a length of both lines, a mitre, or an arc of at most a right angle; else 0.
  [[nodiscard]] double plain_length(std::uint32_t step) const;
  /// Natural ends in doubles.
  [[nodiscard]] Flat start_of(Site s) const;
  [[nodiscard]] Flat end_of(Site s) const;
  [[nodiscard]] Flat centre(Site s) const { return to<double>(s.step); }
  class Starts;
  class Ends;

  /// True if p lies nearer than D - margin to the segment, or as deep in a mitre at one of its ends.
  [[nodiscard]] bool deep_inside(Flat p, std::uint32_t step, double margin) const {
    const Flat u = along<double>(step);
    const Flat to_p = p - from<double>(step);
    const double limit = d_ - margin;
    const double h = dot(to_p, right_of(u));
    if (!(h < limit)) return false;
    const double s = dot(to_p, u);
    if (s >= 0 && s <= span(step)) return h > -limit;
    const Flat q = s > 0 ? p - to<double>(step) : to_p;
    if (dot(q, q) < limit * limit) return true;
    return step < n_ && h > 0 && deep_in_mitre(q, step, s > 0, margin);
  }

 private:
  [[nodiscard]] bool deep_in_mitre(Flat q, std::uint32_t step, bool at_end, double margin) const;
  /// At an inner corner: beyond the bisector each line is nearer than D to the other segment, provided that this
  /// reaches so far. Where it only just does, the answer no is the safe one: it leaves it to the cuts.
  static bool meets(double d, double half_tan, double span, double next) {
    const double reach = d * half_tan * (1 + 1e-12);
    return reach < span && reach < next;
  }

  const BaseCurve& base_;
  const std::vector<CornerKind>& corners_;
  Sides sides_;
  double d_;
  std::uint32_t n_;
};

inline CornerKind Outline::corner(std::uint32_t step) const {
  if (is_cap(step)) return CornerKind::Arc;
  const std::size_t at = corner_point(step);
  CornerKind kind = corners_[at];
  if (kind == CornerKind::Straight) return kind;
  const double t = base_.half_tans[at];
  if (step >= n_) kind = kind == CornerKind::Meet || std::isinf(t) ? CornerKind::Arc : CornerKind::Meet;
  if (kind != CornerKind::Meet) return kind;
  return meets(d_, t, span(step), span(after(step))) ? CornerKind::Meet : CornerKind::Apart;
}

inline double Outline::plain_length(std::uint32_t step) const {
  const std::size_t at = step + 1;
  if (step == 0 || at >= n_) return 0;
  const CornerKind kind = corners_[at];
  const double t = base_.half_tans[at];
  const double span = base_.spans[step];
  if (kind == CornerKind::Tangent || (kind == CornerKind::Arc && !(t <= 1))) return 0;
  if (kind == CornerKind::Meet && !meets(d_, t, span, base_.spans[at])) return 0;
  const double before = corners_[step] == CornerKind::Meet ? base_.half_tans[step] : 0;
  return span - d_ * (before + (kind == CornerKind::Meet ? t : 0));
}

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
    for (std::uint32_t i = first; i < first + BaseCurve::block_size; ++i, arcs >>= 4) {
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

/// Natural ends in doubles. Pieces are asked for in the order of the walk, in which neighbours share a junction.
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

}  // namespace dobra::offset::general
