#pragma once
// The sub-command `solid` of recon: as dobra::cli::solid_command() says, with sections that go on along strike as
// blocks. See docs/user/blocks.md.

#include "shared/cli/cli.h"

namespace recon::cli {

dobra::cli::Command solid_command();

}  // namespace recon::cli
