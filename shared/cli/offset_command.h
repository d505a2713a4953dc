#pragma once
// The sub-command `offset` of both programs: curves parallel to the curves of a file. See docs/user/offset_command.md.

#include "shared/cli/cli.h"

namespace dobra::cli {

/// offset FILE: distances as --distance with --count and --factor, or as --distances; results as a table or --json on
/// standard output, or to --out as exchange file or picture.
Command offset_command();

}  // namespace dobra::cli
