#pragma once
// Pieces of the raw outline by name: the site (segment or corner) that each is parallel to, and what cuts its ends.

#include "shared/offset/kernel/site.h"

namespace dobra::offset::general {

/// A piece of the raw outline, or what is left of it. Only its site and its trims are kept; natural ends are had from
/// the site.
class Piece {
 public:
  static constexpr std::uint32_t none = 0xffffffffU;
  explicit Piece(Site s) : code_(packed(s) * 4) {}
  static Piece linked_to(Site s) {
    Piece made(s);
    made.code_ |= 1U;
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

}  // namespace dobra::offset::general
