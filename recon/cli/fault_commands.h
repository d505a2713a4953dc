#pragma once
// The sub-command `faults`. See docs/user/faults.md.

#include "shared/cli/cli.h"

namespace recon::cli {

/// faults FILE: cutoffs, displacement and blocks of a section as a table or --json; its lines, the picture or the
/// scenario to --out.
dobra::cli::Command faults_command();

}  // namespace recon::cli
