#pragma once
// The sub-commands `parametrise` and `remesh` of quebra: the parameter space of a triangle mesh, and the mesh anew. See
// docs/user/remesh.md.

#include "shared/cli/cli.h"

namespace quebra::cli {

/// parametrise MESH [--weights W] [--border B] [--out uv.vtu] [--json]
dobra::cli::Command parametrise_command();
/// remesh MESH [--size L] [--chord D] ... [--out FILE] [--json]
dobra::cli::Command remesh_command();

}  // namespace quebra::cli
