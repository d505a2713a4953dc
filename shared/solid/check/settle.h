#pragma once
// The boundary of a solid in doubles, so that it bounds a solid again when it is read. Corners are rounded; where faces
// cross by that, corners and edges that are nearly one become one, what still crosses is cut where it does, and the
// whole is looked at again. Page: docs/algorithms/boolean.md. Source: [zhou2016arrangements] for the way round and
// round; what is made one before is ours.

#include <optional>

#include "shared/solid/mesh_solid.h"

namespace dobra::solid::check {

struct SettleOptions {
  FacesAs as = FacesAs::Polygons;  ///< Where something is to be mended, all faces become triangles.
  double unit = 1.0;               ///< The mesh has coordinates in this many metres.
  double most = 1e-9;              ///< What is mended moves by this fraction of the diagonal at most,
  double least_places = 256.0;     ///< or by so many units in the last place of the largest coordinate.
};

struct SettledMesh {
  mesh::PolygonMesh mesh;
  std::vector<std::string> names;  ///< Of each face.
  double displacement = 0.0;       ///< The farthest that the boundary moved at most, in units of the mesh; 0: nowhere.
  std::size_t merged = 0;          ///< Corners that became one with another, or were led onto an edge.
  std::optional<geom::Point3> at;  ///< Where one was moved farthest.
  Counts counts;                   ///< Of the solid that the mesh bounds.
  /// What the rounded mesh is not, where it could not be mended: the message of from_mesh() about it.
  std::optional<base::Error> flaw;
};

/// @error CannotMesh if a face cannot be cut into triangles.
/// @cost  that of from_mesh(), twice or more times where something is to be mended.
base::Result<SettledMesh> settle(const Solid& solid, const SettleOptions& options = {});

}  // namespace dobra::solid::check
