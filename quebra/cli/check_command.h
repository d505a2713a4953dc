#pragma once
// The sub-command `check` of quebra: what is wrong with a mesh file. See docs/user/mesh_command.md.

#include "shared/cli/cli.h"

namespace quebra::cli {

/// check FILE: every fault of a polygon mesh (.obj .off), or the first broken rule of a finite-element mesh, with
/// indices; counts otherwise. Exit code 1 if there is a fault.
dobra::cli::Command check_command();

}  // namespace quebra::cli
