#pragma once
// The sub-commands of RECON for blocks: `block` extrudes a section along strike, `cut` makes a section of a plane
// through it (space_commands.h has the command). See docs/user/blocks.md.

#include <filesystem>
#include <optional>
#include <string>

#include "recon/section/section.h"
#include "shared/cli/cli.h"

namespace recon::cli {

/// block FILE --along-strike L: volumes of the units as a table or --json; --out writes their faces.
dobra::cli::Command block_command();

/// What `cut` is to do with a document of one section, which is extruded to a block.
struct BlockCutOptions {
  std::string file;
  dobra::scenario::Table input;  ///< `cut`, the trace, and `along_strike`, as far as the user gave them.
  std::optional<std::filesystem::path> out;
};
/// The section over the trace; --out writes it as a scenario.
base::Result<int> cut_block(dobra::cli::Session& session, const BlockCutOptions& options);

}  // namespace recon::cli
