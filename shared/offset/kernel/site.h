#pragma once
// Pieces of the raw outline by what they are parallel to.

#include <cstdint>

namespace dobra::offset {
inline namespace kernel {

/// What a piece of the raw outline is parallel to: the line of a segment, or the corner at its end.
enum class SiteKind : std::uint32_t {
  Line,
  Arc,        ///< About the end of the segment; its first half if the turn is more than a right angle.
  SecondArc,  ///< The other half.
  Bevel,      ///< The line that cuts a mitre across at distance D.
};

/// A step is a segment travelled forwards (0 .. n-1) or, after those, backwards from the last one (n .. 2n-1).
struct Site {
  std::uint32_t step;
  SiteKind kind;
  friend bool operator==(Site, Site) = default;
};

inline std::uint32_t packed(Site s) { return s.step * 4 + static_cast<std::uint32_t>(s.kind); }
inline Site unpacked(std::uint32_t s) { return {s / 4, static_cast<SiteKind>(s % 4)}; }

}  // namespace kernel
}  // namespace dobra::offset
