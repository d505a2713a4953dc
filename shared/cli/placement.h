#pragma once
// A mesh placed by a matrix, and a plane as it is typed, for --place and --cut of `solid`.

#include <string>

#include "shared/base/result.h"
#include "shared/mesh/polygon_mesh.h"
#include "shared/solid/placement.h"
#include "shared/solid/section.h"

namespace dobra::cli {

/// 16 numbers with commas between them, row by row.
/// @error BadValue: not 16 numbers, and what check_matrix() says.
base::Result<solid::Matrix> parse_matrix(const std::string& text);

/// Four numbers with commas between them. @error BadValue: not that, or no plane.
base::Result<solid::CutPlane> parse_plane(const std::string& text);

struct Placed {
  mesh::PolygonMesh mesh;
  std::size_t rounded = 0;  ///< Points that had to be rounded; each coordinate is the nearest double.
};

/// Faces are turned over where the matrix mirrors, so that outside stays outside.
/// @error NotFinite if a coordinate grows too large.  @cost O(n)
base::Result<Placed> place(const mesh::PolygonMesh& mesh, const solid::Matrix& matrix);

}  // namespace dobra::cli
