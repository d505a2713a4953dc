#pragma once
// A mesh placed by a matrix, for --place of `quebra solid`.

#include <array>
#include <string>

#include "shared/base/result.h"
#include "shared/mesh/polygon_mesh.h"

namespace quebra::cli {

/// Row by row; applied to columns (x, y, z, 1).
using Matrix = std::array<double, 16>;

/// 16 numbers with commas between them.
/// @error BadValue: not 16 numbers, not finite, a last row other than 0, 0, 0, 1, or a matrix that makes volumes flat.
dobra::base::Result<Matrix> parse_matrix(const std::string& text);

struct Placed {
  dobra::mesh::PolygonMesh mesh;
  std::size_t rounded = 0;  ///< Points that had to be rounded; each coordinate is the nearest double.
};

/// Faces are turned over where the matrix mirrors, so that outside stays outside.
/// @error NotFinite if a coordinate grows too large.  @cost O(n)
dobra::base::Result<Placed> place(const dobra::mesh::PolygonMesh& mesh, const Matrix& matrix);

}  // namespace quebra::cli
