#pragma once
// Proofs that a piece of the raw outline lies in U. The stadium of a segment and the mitres at its ends make a convex
// set: a line lies in it if both its ends do, an arc if the crossing of its end tangents does too. A segment that hides
// one piece most likely hides the next, so the last one and those noted for the place's cell are tried before the tree
// is asked. All proofs keep a margin above rounding. A piece that lies in U is called buried.

#include <array>
#include <vector>

#include "shared/offset/general/clearance.h"

namespace dobra::offset::general {

/// Pieces that lie in U at some distance, and so at all greater ones: the place p + D n is nearer than D to q where
/// n . (q - p) > |q - p|^2 / 2D. The far ends of mitres are an exception: they count only if the segment that hides
/// them does so at the greatest distance too.
class Buried {
 public:
  /// @param greatest  of the distances to come.
  Buried(const BaseCurve& base, const Clearance& clearance, double greatest = 0);
  [[nodiscard]] double greatest() const { return greatest_; }

  /// All four kinds of sites of 16 steps of the right side; those that no piece has count as buried.
  [[nodiscard]] std::uint64_t word(std::size_t block) const { return bits_[block]; }
  [[nodiscard]] bool holds(Site s) const { return (bits_[bit(s) / 64] >> bit(s) % 64 & 1) != 0; }
  /// What lies in U at one distance does so at all greater ones, whatever it is hidden by.
  [[nodiscard]] bool for_ever(Site s) const;
  /// Once a piece is known to lie in U; remembered only if it does so at all greater distances.
  /// @param tips_stay  see WitnessSearch::tips_stay.
  void add(Site s, bool tips_stay = false) {
    if (tips_stay || for_ever(s)) bits_[bit(s) / 64] |= std::uint64_t{1} << bit(s) % 64;
  }

 private:
  /// Four bits a step; those of the left side begin with a new word.
  [[nodiscard]] std::size_t bit(Site s) const {
    const std::size_t n = base_->segment_count();
    const std::size_t place = s.step < n ? s.step : s.step - n + 8 * bits_.size();
    return 4 * place + static_cast<std::size_t>(s.kind);
  }

  const BaseCurve* base_;
  const Clearance* clearance_;
  double greatest_;
  std::vector<std::uint64_t> bits_;
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
  void remember(std::uint32_t step) { witness_ = step; }
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
  bool between(Site s, Flat a, std::uint32_t holds_a, Flat b, std::uint32_t holds_b, int depth);
  bool advance(Flat& from, Flat to);
  [[nodiscard]] Flat middle(Site s, Flat a, Flat b) const;

  const Outline& outline_;
  const Clearance& clearance_;
  double d_, margin_;
  std::uint32_t witness_ = Clearance::none;  // the last step whose set hid a piece
  double cells_per_length_;
  std::vector<Cell> cells_;  // of a square that repeats itself over the plane; empty until something is noted
};

}  // namespace dobra::offset::general
