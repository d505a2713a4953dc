#pragma once
// A block between several sections: its units lofted from each section to the next. Page:
// docs/algorithms/section_block.md. Source: [fuchs1977surface] (bands between contours).

#include <span>
#include <string>

#include "recon/block/block.h"

namespace recon::block {

struct LoftedSection {
  std::string name;
  section::Section section;
  dobra::io::lines::Trace trace;  ///< Straight; x of the section is measured along it from its origin.
};

/// Sections in any order, and drawn from either end; the block is in the coordinates of the one from which all others
/// lie along strike, and `length` is how far the farthest place of them is. Areas are those of that section. Its faces
/// are triangles but for "start" and "end"; it has no sheets, as it is cut by the surfaces through its sections.
/// @error InvalidOption: fewer than two sections, sections that cross or touch each other, that have not the same units
///        with the same neighbours, or whose units would cross between them; BadSection and others of unit_map(); each
///        with the sections and the place on the map.
/// @cost  O(n log n) for n points of the sections
base::Result<Block> loft(std::span<const LoftedSection> sections);

}  // namespace recon::block
