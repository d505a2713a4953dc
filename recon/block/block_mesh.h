#pragma once
// A block as polygons for files: its units one after the other, with the names of unit and side at every face.

#include <string>
#include <vector>

#include "recon/block/block.h"
#include "shared/mesh/polygon_mesh.h"

namespace recon::block {

/// The faces of a unit on the map. Where the section does not run along the x axis, points are rounded to a grid on
/// which the way along strike is one exactly, so that faces along strike stay plane and neighbours keep theirs.
dobra::solid::shape::Shape shape_on_map(const Block& block, const BlockUnit& unit);

struct BlockMesh {
  dobra::mesh::PolygonMesh mesh;  ///< On the map; what two units share stands there once for each, with common points.
  /// Of each face: unit and side, blanks in them as underscores, with a blank between.
  std::vector<std::string> groups;
};

/// @param most_corners  of a face; those with more, and those with holes, are cut into triangles without new points.
/// @error CannotMesh if one cannot be.  @cost O(n log n), O(m^2) at worst for a face of m corners that is cut
base::Result<BlockMesh> mesh_of(const Block& block, std::size_t most_corners);

}  // namespace recon::block
