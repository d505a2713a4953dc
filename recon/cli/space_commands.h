#pragma once
// The sub-commands `surface` and `cut`: surfaces through the sections of a document, and new sections out of them.
// Page: docs/user/space.md.

#include "shared/cli/cli.h"

namespace recon::cli {

/// surface FILE [--out horizons.ts] [--mistie-tolerance D] ... [--json]
dobra::cli::Command surface_command();
/// cut FILE --trace x0,y0,x1,y1 [--out section.toml] [--json]. What is cut goes by what FILE holds:
/// surfaces through [[input.section]], or the block of one section (block_commands.h).
dobra::cli::Command cut_command();

}  // namespace recon::cli
