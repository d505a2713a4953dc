#pragma once
// To and from OpenMesh: for its file readers and its algorithms on surfaces. The only header that includes OpenMesh;
// beside this module only the format that OpenMesh reads and writes (shared/io/meshes/stl.h) knows of it.

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <span>

#include "shared/base/result.h"
#include "shared/geom/point3.h"
#include "shared/mesh/triangle_mesh.h"

namespace dobra::mesh {

/// Double precision, so that nothing is lost on the way.
struct OpenMeshTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using OpenMeshTriangles = OpenMesh::TriMesh_ArrayKernelT<OpenMeshTraits>;

/// Vertex i is node i (z = 0), face t is triangle t; the property "region" of the faces holds the region tags. Sets are
/// left behind.
/// @error CannotMesh with the place where the mesh is not manifold (a node where more than two boundary sides meet).
base::Result<OpenMeshTriangles> to_openmesh(const TriangleMesh& mesh);

/// The same of points in space. @param regions  one a triangle.
base::Result<OpenMeshTriangles> to_openmesh(std::span<const geom::Point3> points, std::span<const Corners> triangles,
                                            std::span<const std::int32_t> regions);

/// The reverse; z is dropped. Region tags come back if the property is there, else they are 0.
/// @error CannotMesh with the place if a face has no area or is clockwise.
base::Result<TriangleMesh> from_openmesh(const OpenMeshTriangles& triangles);

}  // namespace dobra::mesh
