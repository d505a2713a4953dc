#pragma once
// Which unit every face of a section's subdivision belongs to, and what its edges are called: the plan that blocks are
// extruded by. Units are the polygons of the section, or where it has none, what horizons, faults and border make.
// Pages: docs/algorithms/units.md, docs/algorithms/section_block.md.

#include <limits>
#include <string>
#include <vector>

#include "recon/section/arrangement.h"
#include "recon/section/section.h"
#include "shared/base/finding.h"

namespace recon::block {

struct UnitMap {
  static constexpr std::size_t nobody = std::numeric_limits<std::size_t>::max();

  section::Arrangement arrangement;
  /// "A - B", "A", "above A" by whole horizons, "without a horizon", or the name of a polygon; each once.
  std::vector<std::string> units;
  std::vector<std::vector<topo::FaceId>> faces;  ///< Of each unit.
  std::vector<std::size_t> unit_of;              ///< By face; nobody: no rock.
  /// By edge: "horizon A", "fault F", "topography T", "border", "side" (drawn by the program), "contact" (of polygons).
  std::vector<std::string> edge_names;
  std::vector<base::Finding> findings;
};

/// Of names of lines along one edge; lower counts more.
int rank_of(const std::string& name);

/// Whether the findings of a map tell an end, a gap or an overlap at a place of the section, so that what reading
/// remarks there need not be said again.
bool is_told(const base::Place& place, const std::vector<base::Finding>& findings);

/// @error BadSection if nothing bounds a unit; those of faces_of() and UnitOwners::make.  @cost those of them
base::Result<UnitMap> unit_map(const section::Section& section);

/// A connected part of a unit: its outer contour anticlockwise, then its holes clockwise, as half-edges. A contour
/// that comes to a vertex twice is two.
using PartLoops = std::vector<std::vector<topo::HalfEdgeId>>;
std::vector<PartLoops> parts_of(const UnitMap& map, std::size_t unit);
/// Of all rock together.
std::vector<PartLoops> parts_of_all(const UnitMap& map);

}  // namespace recon::block
