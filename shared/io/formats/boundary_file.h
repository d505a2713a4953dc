#pragma once
// Boundaries of solids to and from the formats of polygon meshes, by the ending of the file's name.

#include <span>
#include <string>
#include <vector>

#include "shared/base/result.h"
#include "shared/mesh/polygon_mesh.h"

namespace dobra::io::formats {

/// All endings that the two functions below take.
std::vector<std::string> boundary_endings();

/// The most corners that a face may have in the format of that ending: three in an STL, 255 in a PLY.
std::size_t most_corners(const std::string& path);

/// Faces in space as they stand; of an STL, text or binary, equal corners are one point.
/// @error UnknownFormat naming the endings; those of the readers; BadFormat if there is no face.
base::Result<mesh::PolygonMesh> read_boundary(const std::string& path);

/// With every digit.
/// @param groups  of each face, as meshes::polygons_text() has them; where the format holds them.
/// @pre   no face has more than most_corners()
/// @error BadUsage naming the endings; CannotWrite.
base::Result<void> write_boundary(const std::string& path, const mesh::PolygonMesh& mesh,
                                  std::span<const std::string> groups = {});
/// The same question before long work.
base::Result<void> check_boundary_ending(const std::string& path);

}  // namespace dobra::io::formats
