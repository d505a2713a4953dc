#pragma once
// How often every operand surrounds the two sides of every cell. Round an edge the cells are sorted exactly; what two
// neighbours have between them is one region. Each connected part of the arrangement gets its first numbers by a line
// along x from the middle of an edge, moved by infinitely little so that it passes no edge or vertex.

#include <optional>
#include <vector>

#include "shared/solid/cells.h"
#include "shared/solid/line_along_x.h"

namespace dobra::solid {

/// Edges of the arrangement: the halves of cells at each of them, anticlockwise seen from the end with the greater
/// number towards that with the less.
struct Fans {
  std::vector<std::uint32_t> turned;  ///< For each half the next one round its edge.
  std::vector<std::uint32_t> first;   ///< One half of each edge.
};

struct Sides {
  std::vector<Windings> kinds;       ///< All that occur.
  std::vector<std::uint32_t> above;  ///< Of each cell, an index into `kinds`.
  std::vector<std::uint32_t> below;
};

/// @cost O(n log n)
Fans fans(const Soup& soup, const Cells& cells);

/// An edge about which an operand's facets do not close; none if all do.
std::optional<std::uint32_t> open_half(const Soup& soup, const Cells& cells, const Fans& fans);

/// @pre the facets of every operand close.  @cost O(n + parts log n)
Sides sides(const Soup& soup, const Cells& cells, const Fans& fans, const std::vector<BoxTree>& trees);

/// The half's cell lies anticlockwise before its upper side: going on round the edge one comes to the upper side.
[[nodiscard]] inline bool upper_side_follows(const Cells& cells, std::uint32_t half) {
  return cells.halves[half].origin < cells.target(half);
}

}  // namespace dobra::solid
