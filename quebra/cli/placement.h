#pragma once
// A mesh placed by a matrix, for --place of `quebra solid`.

#include <string>

#include "shared/base/result.h"
#include "shared/mesh/polygon_mesh.h"
#include "shared/solid/placement.h"

namespace quebra::cli {

/// 16 numbers with commas between them, row by row.
/// @error BadValue: not 16 numbers, and what check_matrix() says.
dobra::base::Result<dobra::solid::Matrix> parse_matrix(const std::string& text);

struct Placed {
  dobra::mesh::PolygonMesh mesh;
  std::size_t rounded = 0;  ///< Points that had to be rounded; each coordinate is the nearest double.
};

/// Faces are turned over where the matrix mirrors, so that outside stays outside.
/// @error NotFinite if a coordinate grows too large.  @cost O(n)
dobra::base::Result<Placed> place(const dobra::mesh::PolygonMesh& mesh, const dobra::solid::Matrix& matrix);

}  // namespace quebra::cli
