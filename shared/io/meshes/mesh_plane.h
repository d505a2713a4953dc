#pragma once
// Meshes of elements are plane in x and y: files with other heights are refused. Internal to io.

#include <span>
#include <string>

#include "shared/base/result.h"
#include "shared/geom/point.h"
#include "shared/io/meshes/heights.h"
#include "shared/mesh/element_mesh.h"

namespace dobra::io::meshes {

/// @param heights  the third coordinate of every point. Those that differ by no more than 1e-6 of the extent in x and y
///                 lie in one plane, wherever it stands.
/// @error BadFormat at the first point that lies off the plane of the first one.
base::Result<void> check_plane(std::span<const geom::Point> points, std::span<const double> heights,
                               const std::string& file);
/// The same for the nodes that elements use.
base::Result<void> check_plane(const mesh::ElementMesh& mesh, std::span<const double> heights, const std::string& file);

/// Whether the nodes that elements use lie in no plane z = constant. @error as check_plane, where `flatness` is Plane.
base::Result<bool> lies_in_space(const mesh::ElementMesh& mesh, std::span<const double> heights,
                                 const std::string& file, Flatness flatness);

}  // namespace dobra::io::meshes
