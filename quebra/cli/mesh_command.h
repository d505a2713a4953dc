#pragma once
// The sub-command `mesh` of quebra: a mesh of a scenario or of a file of geometry. See docs/user/mesh_command.md.

#include "shared/cli/cli.h"

namespace quebra::cli {

/// mesh FILE: options become the parameters of the operations `constraints`, `zone` and `mesh`; the mesh goes to --out
/// in the format of its ending, its figures as a table or --json to standard output.
dobra::cli::Command mesh_command();

}  // namespace quebra::cli
