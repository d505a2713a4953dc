#pragma once
// First half of the general engine: candidate pieces, those of the raw outline on the right side that may be on the
// curve. One pass with a stack. A piece, or a part of one, is removed only on proof that it lies in U (witness.h). All
// proofs keep a margin well above rounding, so nothing valid or merely touching is removed. What is left although it is
// not valid is found by the second half (sections.h). Where line follows line there is nothing to prove. A piece that
// cuts the one before it is likely to be free and is not asked for; every other piece is.

#include <vector>

#include "shared/base/progress.h"
#include "shared/offset/general/witness.h"

namespace dobra::offset::general {

/// A piece of the raw outline, or what is left of it. Only its site and its trims are kept; natural ends are had from
/// the site.
class Piece {
 public:
  static constexpr std::uint32_t none = 0xffffffffU;
  explicit Piece(Site s) : code_(packed(s) * 4) {}
  static Piece linked_to(Site s) {
    Piece made(s);
    made.link(true);
    return made;
  }

  std::uint32_t trim_a = none;  ///< Index of the trim at the start; none for the natural start.
  std::uint32_t trim_b = none;
  [[nodiscard]] Site site() const { return unpacked(code_ / 4); }
  [[nodiscard]] std::uint32_t step() const { return code_ / 16; }
  [[nodiscard]] bool is_line() const { return (code_ / 4) % 4 == 0 || (code_ / 4) % 4 == 3; }
  /// Starts where the piece before it ends (the very first: where the last one ends).
  [[nodiscard]] bool linked() const { return code_ % 2 != 0; }
  void link(bool on) { code_ = (code_ & ~1U) | (on ? 1U : 0U); }

 private:
  std::uint32_t code_;
};

/// The first of the pieces k .. last - 1 that does not start where the one before it ends; `last` if there is none.
inline std::size_t next_gap(const Piece* pieces, std::size_t k, std::size_t last) {
  constexpr std::size_t many = 8;
  for (bool linked = true; linked && k + many <= last;) {
    for (std::size_t i = 0; i < many; ++i) linked &= pieces[k + i].linked();
    if (linked) k += many;
  }
  while (k < last && pieces[k].linked()) ++k;
  return k;
}

/// Where a piece is cut, and by the site of which other.
struct Trim {
  Flat at;
  std::uint32_t other;  ///< Packed.
};

/// Pieces in the order of the walk.
struct Candidates {
  std::vector<Piece> pieces;
  std::vector<Trim> trims;
  /// @param ends  the outline, or Outline::Ends.
  template <class Ends>
  [[nodiscard]] Flat start(Ends& ends, const Piece& p) const {
    return p.trim_a != Piece::none ? trims[p.trim_a].at : ends.start_of(p.site());
  }
  template <class Ends>
  [[nodiscard]] Flat end(Ends& ends, const Piece& p) const {
    return p.trim_b != Piece::none ? trims[p.trim_b].at : ends.end_of(p.site());
  }
};

/// @param witnesses  of the same outline; remembers.
/// @param known      what need not be looked at again.
/// @param found      gets what is found to lie in U; may be null.
/// @return           nothing if progress was cancelled.
/// @cost             O(n) on smooth bases, some 15 ns a segment; a clearance query and 0.1 to 1 us on rough ones.
Candidates candidates(const Outline& outline, const Clearance& clearance, WitnessSearch& witnesses, const Buried& known,
                      Buried* found, const base::Progress& progress);

/// Removes a line that is cut from both sides beyond its middle: every point of it is nearer than D to one neighbour or
/// the other.
/// @param size  what is left of it.
bool is_overcut(const Outline& outline, std::uint32_t step, double size, double margin);

}  // namespace dobra::offset::general
