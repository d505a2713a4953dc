#pragma once
// The sub-commands of RECON beside the ones that both programs have: `restore` and `balance`. Each makes the document
// of a scenario from its options and runs it, so that what it prints is what the scenario gives. See
// docs/user/restore.md.

#include "shared/cli/cli.h"

namespace recon::cli {

/// restore FILE --top NAME --method ... --target flat|FILE --pin X: one restoration, its ledger as a table or --json on
/// standard output, pictures and files to --out.
dobra::cli::Command restore_command();

/// balance FILE: bed lengths, excess areas and detachment of the section as it is; with --polygon the shortening from
/// an area with errors.
dobra::cli::Command balance_command();

}  // namespace recon::cli
