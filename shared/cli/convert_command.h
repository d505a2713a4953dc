#pragma once
// The sub-command `convert` of both programs: lines from one format to another, in section coordinates on the way, with
// repairs; pictures of them to a true scale. See docs/user/import.md.

#include "shared/cli/cli.h"

namespace dobra::cli {

/// convert IN OUT: formats by the endings of the names; --json prints what was read, repaired and written.
Command convert_command();

}  // namespace dobra::cli
