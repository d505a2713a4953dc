#pragma once
// The arrangement of all facets: cells, each a part of a plane that no other facet crosses, with the facets that cover
// it. Cells meet in whole edges and in vertices alone.

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "shared/solid/contacts.h"
#include "shared/solid/soup.h"

namespace dobra::solid {

struct CellTag {
  static constexpr const char* prefix = "c";
};
using CellId = base::Id<CellTag>;

/// A side of an edge: the cell is to its left, seen from above the cell's plane.
struct CellHalf {
  PointId origin;
  std::uint32_t next;
  CellId cell;
};

/// A facet on a cell; its upper side is the cell's or the other.
struct Cover {
  std::uint32_t facet;
  bool turned;
};

struct Cell {
  std::uint32_t facet;  ///< One that covers it; the cell has its plane and that plane's upper side.
  std::uint32_t first_half, half_end;
  std::uint32_t first_cover, cover_end;
};

struct Cells {
  std::vector<Cell> cells;
  std::vector<CellHalf> halves;  ///< Loop after loop, cell after cell.
  std::vector<Cover> covers;

  [[nodiscard]] PointId target(std::uint32_t half) const { return halves[halves[half].next].origin; }
  [[nodiscard]] std::span<const Cover> covers_of(const Cell& cell) const {
    return {covers.data() + cell.first_cover, cell.cover_end - cell.first_cover};
  }
};

/// Facets that meet nothing are cells as they are; of the others, those that lie in one plane and may overlap are
/// overlaid together.
/// @cost O(n) for facets that meet nothing; a plane's overlay O(m log m + pairs of its segments whose boxes overlap).
Cells arrange(Soup& soup, const Contacts& contacts);

/// Cuts facets of one plane by each other's edges and by the cuts, and adds the cells that facets cover.
void overlay(Soup& soup, std::span<const std::uint32_t> facets, std::span<const Cut> cuts, Cells& cells);

}  // namespace dobra::solid
