#pragma once
// One piece of a mesh, meshed anew. Internal to remesh.h.

#include "shared/surf/param/sheet.h"
#include "shared/surf/remesh/remesh.h"

namespace dobra::surf::remesh {

/// Whether a refusal names a size that works, which is found by trial.
enum class Advice : std::uint8_t { None, Size };

/// @param size  m, > 0
/// @error those of remesh; InvalidOption: a size too large. So is one whose answer has an area that is far off, and one
///        above the mean side of the mesh, or for a mesh of few triangles, whose answer folds where a smaller one does
///        not.
base::Result<Remeshed> remesh_sheet(const param::SheetMade& made, const RemeshOptions& options, double size,
                                    Advice advice, const base::Progress& progress);

/// The same as it comes, told and not judged; a refusal names no size.
base::Result<Remeshed> remesh_once(param::SheetMade made, const RemeshOptions& options, double size,
                                   const base::Progress& progress);

}  // namespace dobra::surf::remesh
