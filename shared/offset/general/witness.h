#pragma once
// Proofs that a piece of the raw outline lies in U. The stadium of a segment and the mitres at its ends make a convex
// set: a line lies in it if both its ends do, an arc if the crossing of its end tangents does too. A segment that hides
// one piece most likely hides the next, so the last few and those noted for the place's cell are tried before the tree
// is asked. All proofs keep a margin above rounding. A piece that lies in U is called buried.

#include <array>
#include <vector>

#include "shared/offset/general/clearance.h"

namespace dobra::offset::general {

/// Pieces that lie in U at some distance, and so at all greater ones: the place p + D n is nearer than D to q where
/// n . (q - p) > |q - p|^2 / 2D. The far ends of mitres are an exception: they count only if the segment that hides
/// them does so at the greatest distance too; else that segment is remembered, to be tried first.
class Buried {
 public:
  static constexpr std::uint32_t none = 0xffffffffU;
  /// @param greatest  of the distances to come.
  Buried(const BaseCurve& base, const Clearance& clearance, double greatest = 0);
  [[nodiscard]] double greatest() const { return greatest_; }

  /// All four kinds of sites of 16 steps of the right side; those that no piece has count as buried.
  [[nodiscard]] std::uint64_t word(std::size_t block) const { return bits_[block]; }
  [[nodiscard]] bool holds(Site s) const { return (bits_[place(s)] >> shift(s)) & 1U; }
  /// What lies in U at one distance does so at all greater ones, whatever it is hidden by.
  [[nodiscard]] bool for_ever(Site s) const;
  /// Once a piece is known to lie in U. @param tips_stay  see WitnessSearch::tips_stay.
  void add(Site s, std::uint32_t witness, bool tips_stay = false);
  /// The same where nobody knows by what: remembered only if it holds for all greater distances.
  void add(Site s) {
    if (!holds(s) && for_ever(s)) add(s, none);
  }
  [[nodiscard]] std::uint32_t hint(std::uint32_t step) const { return hints_.empty() ? none : hints_[step]; }
  /// All that the left side has about a block but caps.
  [[nodiscard]] bool holds_left_of(std::size_t block) const { return left_of_[block] != 0; }
  void add_left_of(std::size_t block) { left_of_[block] = 1; }

 private:
  [[nodiscard]] std::size_t place(Site s) const { return s.step < n_ ? s.step / 16 : words_ + (s.step - n_) / 16; }
  [[nodiscard]] std::uint32_t shift(Site s) const {
    return 4 * ((s.step < n_ ? s.step : s.step - n_) % 16) + static_cast<std::uint32_t>(s.kind);
  }

  const BaseCurve* base_;
  const std::vector<CornerKind>* corners_;
  std::uint32_t n_;
  std::size_t words_;
  double greatest_;
  std::vector<std::uint64_t> bits_;
  std::vector<char> left_of_;  // of blocks
  std::vector<std::uint32_t> hints_;
};

class WitnessSearch {
 public:
  WitnessSearch(const Outline& outline, const Clearance& clearance);
  [[nodiscard]] double margin() const { return margin_; }
  [[nodiscard]] bool deep(Flat p, std::uint32_t step) const {
    return margin_ < d_ && outline_.deep_inside(p, step, margin_);
  }
  /// The part of a piece from a to b lies in the set of one step.
  [[nodiscard]] bool in_set(Site s, Flat a, Flat b, std::uint32_t step) const {
    if (!deep(a, step) || !deep(b, step)) return false;
    return s.kind == SiteKind::Line || s.kind == SiteKind::Bevel || deep(tangent_corner(s, a, b), step);
  }
  /// The same for any number of steps.
  bool covers(Site s, Flat a, Flat b);
  /// Takes off both ends of a line what is easily seen to lie in U. False if nothing is left.
  bool shorten(Flat& a, Flat& b);
  /// For a line that lies in U: its extensions to the tips of mitres lie in the set of the segment that hides it (the
  /// witness) up to distance d.
  [[nodiscard]] bool tips_stay(std::uint32_t step, double d) const;
  void remember(std::uint32_t step);
  /// The last one.
  [[nodiscard]] std::uint32_t witness() const { return recent_[0]; }
  /// Where the tangents at the ends of an arc, of at most a right angle, cross.
  [[nodiscard]] Flat tangent_corner(Site s, Flat a, Flat b) const {
    const Flat c = outline_.centre(s);
    const Flat sum = (a - c) + (b - c);
    return c + (2 * d_ * d_ / dot(sum, sum)) * sum;
  }

 private:
  static constexpr std::size_t cells_across = 64;
  /// Steps whose sets held places in a part of the plane, the last one first.
  using Cell = std::array<std::uint32_t, 2>;
  [[nodiscard]] std::size_t cell_of(Flat p) const;
  [[nodiscard]] std::uint32_t noted(Flat p) const;
  void note(Flat p, std::uint32_t step);
  [[nodiscard]] std::uint32_t find(Flat p);
  /// See in_set, for one of the last steps that buried something.
  bool by_recent(Site s, Flat a, Flat b);
  bool between(Site s, Flat a, std::uint32_t holds_a, Flat b, std::uint32_t holds_b, int depth);
  bool advance(Flat& from, Flat to);
  [[nodiscard]] Flat middle(Site s, Flat a, Flat b) const;

  const Outline& outline_;
  const Clearance& clearance_;
  double d_, margin_;
  std::array<std::uint32_t, 4> recent_;
  double cells_per_length_;
  std::vector<Cell> cells_;  // of a square that repeats itself over the plane; empty until something is noted
};

}  // namespace dobra::offset::general
