#pragma once
// Element meshes as what formats without elements hold: polygons of a surface, or the lines of a planar graph, and
// back.

#include "shared/base/result.h"
#include "shared/io/meshes/heights.h"
#include "shared/io/meshes/poly.h"
#include "shared/mesh/element_mesh.h"
#include "shared/mesh/polygon_mesh.h"

namespace dobra::io::meshes {

/// The corners as polygons, triangles and quadrilaterals; nodes that are no corners are left out.
mesh::PolygonMesh polygons_of(const mesh::ElementMesh& mesh, Heights heights = {});

/// T3 and Q4 of one region, by x and y; points that no face names are left out.
/// @error BadFormat for faces of other than three or four corners and for points that lie in no plane z = constant;
/// those of check.
base::Result<mesh::ElementMesh> elements_of(const mesh::PolygonMesh& mesh, const std::string& file);

/// Boundary, internal lines and cracks (their lips as one line) as segments between corners, marked 1, 2 ... by the
/// side sets in the order of their names (0: none); a point in each hole and in an element of each region.  @cost O(n
/// log n)
PolyFile poly_of(const mesh::ElementMesh& mesh);

}  // namespace dobra::io::meshes
