#pragma once
// The sub-commands `invert`, kinematics from the shapes of beds, and `predict`, what a section does not show.

#include "shared/cli/cli.h"

namespace recon::cli {

/// invert FILE [--method trishear|shear] ...: values, limits of confidence and misfits as a table or --json; the
/// picture to --out.
dobra::cli::Command invert_command();

/// predict FILE --what fault|rollover|fault_bend_fold|fault_propagation_fold ...: likewise.
dobra::cli::Command predict_command();

}  // namespace recon::cli
