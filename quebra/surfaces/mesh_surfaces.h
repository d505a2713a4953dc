#pragma once
// Trimmed surfaces -> mesh in space: charts opened at seams and poles, borders divided once for all faces, each face
// filled by an engine, faces joined, the seams smoothed away, the whole checked. Page: docs/user/surfaces.md.

#include <functional>
#include <string>

#include "quebra/model/surface_meshed.h"
#include "shared/base/progress.h"
#include "shared/surf/mesh/division.h"

namespace quebra::surfaces {

enum class SurfaceEngine { Front, Paper };

struct SurfaceMeshOptions {
  dobra::surf::mesh::SizeOptions sizes = {};
  /// Size wanted, m, by x, y, z [m] and u, v as they are written; empty: none.
  std::string size_formula = {};
  SurfaceEngine engine = SurfaceEngine::Front;
  int smoothing = 3;
  bool quadrilaterals = false;
  bool second_order = false;
  std::size_t most_triangles = 20'000'000;
};

/// @error BadValue: a formula that cannot be read, u and v in it where several faces or poles leave open whose they
/// are;
///        those of divide, of the engines, of assemble; CannotMesh with the place where the mesh is not what was asked:
///        a triangle folded in its chart, a border that is not kept.
dobra::base::Result<model::SurfaceMeshed> mesh_surfaces(const model::SurfaceSet& set, const SurfaceMeshOptions& options,
                                                        const dobra::base::Progress& progress = {});

}  // namespace quebra::surfaces
