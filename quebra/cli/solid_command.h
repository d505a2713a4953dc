#pragma once
// The sub-command `solid` of quebra: solids of mesh files united, intersected and subtracted exactly, and measured.
// See docs/user/solids.md.

#include "shared/cli/cli.h"

namespace quebra::cli {

/// solid FILE [--unite|--intersect|--subtract B [--place M]]...: applied from left to right; --out writes the result,
/// --json prints its figures, and the findings of a refusal too.
dobra::cli::Command solid_command();

}  // namespace quebra::cli
