#pragma once
// A block cut by a plane: a section again, with units, horizons, faults and all other lines called as before. Page:
// docs/algorithms/section_block.md.

#include <string>
#include <vector>

#include "recon/block/block.h"
#include "recon/block/strip.h"
#include "shared/solid/boolean.h"

namespace recon::block {

/// A plane and its axes, in block coordinates: a point (x, y) of the section is origin + x along + y up.
struct CutFrame {
  dobra::solid::CutPlane plane;
  geom::Point3 origin;
  geom::Vector3 along, up;
  Strip strip;  ///< The section ends there; without bounds it goes as far as the block.
};

struct CutOptions {
  /// A trace whose ends lie this fraction of the block's extent or less off one of the block's ends lies in it, and one
  /// that ends as near to a side of the block goes to it: what places on the map lose when they are rounded.
  double snap = 1e-12;
};

/// The vertical plane over a trace on the map; x = 0 is its first point, y the height. The section ends where the trace
/// ends, or the block.
/// @error InvalidOption: both points are one, or not finite.
base::Result<CutFrame> cut_over(const Block& block, geom::Point from, geom::Point to, const CutOptions& options = {});
/// Any plane, in map coordinates, with the axes of solid::frame_of(), as far as the block.  @error as that
base::Result<CutFrame> cut_by(const Block& block, const dobra::solid::CutPlane& plane_on_map);

/// What of a unit lies in the plane.
struct CutUnit {
  std::string name;
  double area = 0.0;  ///< m2.
  std::size_t parts = 0;
};

struct BlockCut {
  CutFrame frame;
  section::Section section;    ///< With faces, if they can be made.
  std::vector<CutUnit> units;  ///< Those that are cut, by the solids, not by the lines of the section.
  double area = 0.0;           ///< Of all of them.
  dobra::solid::Contact contact = dobra::solid::Contact::Nothing;  ///< Of the plane with the block.
  /// cut_misses, cut_touches_...: the section is empty; cut_flawed: what RECON has against the section as it stands;
  /// cut_in_pieces, cut_border: what of its lines could not stay one; cut_left_out: lines that are not of the block.
  std::vector<base::Finding> findings;

  [[nodiscard]] bool empty() const { return units.empty(); }
};

/// cut_flawed: what RECON has against a section.
base::Finding flaw_finding(const base::Error& error);

/// Lines of a block between several sections are those of the faces that were cut, so what bounds no unit is not there
/// (cut_left_out); kinds, roles and orders are those of the section in front. A border goes round the section where the
/// sections have one, or where straight sides would not bound what the solids have in the plane.
/// A plane in one of the block's ends gives the section of that end. A line that the plane cuts several times becomes
/// pieces, "A (1)", "A (2)", ...; a hanging wall on the left is on the right where the cut is seen from behind.
/// @error those of solid::Sections::cut.
/// @cost  O(n) for n points of the lines, and that of solid::Sections::cut
base::Result<BlockCut> cut(const Block& block, const CutFrame& frame);

}  // namespace recon::block
