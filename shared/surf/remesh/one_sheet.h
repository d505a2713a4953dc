#pragma once
// One piece of a mesh, meshed anew. Internal to remesh.h.

#include "shared/surf/param/sheet.h"
#include "shared/surf/remesh/remesh.h"

namespace dobra::surf::remesh {

/// @param size  m, > 0  @error those of remesh
base::Result<Remeshed> remesh_sheet(param::SheetMade made, const RemeshOptions& options, double size,
                                    const base::Progress& progress);

}  // namespace dobra::surf::remesh
