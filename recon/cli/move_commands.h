#pragma once
// The sub-command `move`.

#include "shared/cli/cli.h"

namespace recon::cli {

/// move FILE --fault NAME --method ... --slip S: blocks moved along a fault, what is left between its walls as a table
/// or
/// --json on standard output, the section after it to --out.
dobra::cli::Command move_command();

}  // namespace recon::cli
