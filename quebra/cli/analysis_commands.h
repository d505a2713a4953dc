#pragma once
// quebra solve | adapt | crack FILE: a scenario whose last step is the one named, with its figures on standard output;
// quebra validate: the validation book.

#include <vector>

#include "shared/cli/cli.h"

namespace quebra::cli {

std::vector<dobra::cli::Command> analysis_commands();

}  // namespace quebra::cli
