#pragma once
// The raw outline at distance D: lines and arcs that lie to the right of the base, and to the right of the base travelled
// backwards (its left side), which only serve to cut. Everything is symbolic: a piece knows the site (segment or corner) it is
// parallel to, and an end knows whether it is the natural one or a crossing with another site, so that its place can be had
// in doubles or in Real.

#include <limits>
#include <type_traits>

#include "shared/offset/base_curve.h"

namespace dobra::offset {

enum class Role : std::uint32_t {
  Line,
  Arc,        ///< About the end of the segment; its first half if the turn is more than a right angle.
  SecondArc,  ///< The other half.
  Bevel,      ///< The line that cuts a mitre across at distance D.
};

/// A step is a segment travelled forwards (0 .. n-1) or, after those, backwards from the last one (n .. 2n-1).
struct Site {
  std::uint32_t step;
  Role role;
  friend bool operator==(Site, Site) = default;
};
inline constexpr Site no_site{std::numeric_limits<std::uint32_t>::max(), Role::Line};

struct Piece {
  Flat a, b;
  Site site = no_site;
  std::uint32_t cut_a = none;  ///< Piece site that the start was cut by, packed; none for the natural start.
  std::uint32_t cut_b = none;
  bool linked = false;         ///< Starts where the piece before it ends (the very first: where the last of its walk ends).
  static constexpr std::uint32_t none = 0xffffffffU;
  [[nodiscard]] bool is_line() const { return site.role == Role::Line || site.role == Role::Bevel; }
};
inline std::uint32_t packed(Site s) { return s.step * 4 + static_cast<std::uint32_t>(s.role); }
inline Site unpacked(std::uint32_t s) { return {s / 4, static_cast<Role>(s % 4)}; }

/// The base as a closed walk (or two).
class Outline {
 public:
  enum class Sides {
    Right,         ///< The right side only: closed bases that do not cross themselves.
    RightAndCaps,  ///< Open monotone bases.
    Both,          ///< Open: right side, cap, left side, cap. Closed: two walks.
  };
  enum class Corner { Straight, Meet, Apart, Mitre, Tangent, Arc };

  Outline(const BaseCurve& base, Sides sides, double distance, const OffsetOptions& options)
      : base_(base), sides_(sides), d_(distance), options_(options), n_(static_cast<std::uint32_t>(base.segment_count())) {}

  [[nodiscard]] double distance() const { return d_; }
  [[nodiscard]] const BaseCurve& base() const { return base_; }
  [[nodiscard]] std::uint32_t step_count() const { return sides_ == Sides::Both ? 2 * n_ : n_; }
  [[nodiscard]] bool wanted(Site s) const { return s.step < n_ && !(is_cap(s.step) && s.role != Role::Line); }
  [[nodiscard]] std::uint32_t segment(std::uint32_t step) const { return step < n_ ? step : 2 * n_ - 1 - step; }
  [[nodiscard]] bool two_walks() const { return base_.closed && sides_ == Sides::Both; }
  /// True if a corner follows the step: only Sides::RightAndCaps has an end, and that has its cap.
  [[nodiscard]] bool is_cap(std::uint32_t step) const { return !base_.closed && (step == n_ - 1 || step == 2 * n_ - 1); }
  [[nodiscard]] std::uint32_t after(std::uint32_t step) const {
    if (two_walks()) return step == n_ - 1 ? 0 : step == 2 * n_ - 1 ? n_ : step + 1;
    if (sides_ == Sides::RightAndCaps && step == n_ - 1) return n_;  // the last segment backwards, for the cap only
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
  /// What happens at the end of a step. Decided in doubles once; any answer near a limit is a right one.
  [[nodiscard]] Corner corner(std::uint32_t step) const;

  // Places, in doubles or in Real.
  template <class T> [[nodiscard]] VecOf<T> from(std::uint32_t step) const {
    const std::size_t s = segment(step);
    const geom::Point p = step < n_ ? base_.start(s) : base_.end(s);
    return {p.x, p.y};
  }
  template <class T> [[nodiscard]] VecOf<T> to(std::uint32_t step) const {
    const std::size_t s = segment(step);
    const geom::Point p = step < n_ ? base_.end(s) : base_.start(s);
    return {p.x, p.y};
  }
  template <class T> [[nodiscard]] VecOf<T> along(std::uint32_t step) const {
    if constexpr (std::is_same_v<T, double>) {
      const Flat u = flat(base_.headings[segment(step)]);
      return step < n_ ? u : -u;
    } else {
      return unit(to<T>(step) - from<T>(step));
    }
  }
  template <class T> [[nodiscard]] VecOf<T> normal(std::uint32_t step) const { return right_of(along<T>(step)); }
  template <class T> [[nodiscard]] T half_tan_as(std::uint32_t step) const;
  /// Where the line of `step` ends, and where that of the next one begins.
  template <class T> [[nodiscard]] VecOf<T> line_end(std::uint32_t step) const;
  template <class T> [[nodiscard]] VecOf<T> line_start(std::uint32_t step) const;
  template <class T> [[nodiscard]] VecOf<T> natural_start(Site s) const;
  template <class T> [[nodiscard]] VecOf<T> natural_end(Site s) const;
  template <class T> [[nodiscard]] VecOf<T> middle_of_turn(std::uint32_t step) const;
  [[nodiscard]] bool splits_arc(std::uint32_t step) const { return half_tan(step) > 1; }

  /// The end of a step in doubles: what happens there, where its line ends and where the next one begins.
  struct Junction {
    Corner kind;
    Flat end, start;
  };
  [[nodiscard]] Junction junction(std::uint32_t step) const;

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

  const BaseCurve& base_;
  Sides sides_;
  double d_;
  const OffsetOptions& options_;
  std::uint32_t n_;
};

}  // namespace dobra::offset
