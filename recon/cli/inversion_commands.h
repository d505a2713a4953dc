#pragma once
// The sub-command `invert`: kinematics from the shapes of beds.

#include "shared/cli/cli.h"

namespace recon::cli {

dobra::cli::Command invert_command();

}  // namespace recon::cli
