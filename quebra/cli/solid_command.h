#pragma once
// The sub-command `solid` of quebra: its files may be scenarios of solids, and --cut makes plane domains of them. See
// docs/user/solids.md.

#include "shared/cli/cli.h"

namespace quebra::cli {

/// As dobra::cli::solid_command() says.
dobra::cli::Command solid_command();

}  // namespace quebra::cli
