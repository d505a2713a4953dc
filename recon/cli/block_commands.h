#pragma once
// The sub-commands of RECON for blocks: `block` extrudes a section along strike, `cut` makes a section of a plane
// through it. See docs/user/blocks.md.

#include "shared/cli/cli.h"

namespace recon::cli {

/// block FILE --along-strike L: volumes of the units as a table or --json; --out writes their faces.
dobra::cli::Command block_command();

/// cut FILE --trace x0,y0,x1,y1: the section over the trace; --out writes it as a scenario.
dobra::cli::Command cut_command();

}  // namespace recon::cli
