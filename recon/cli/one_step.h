#pragma once
// Sub-commands that do one step on a section and print what it found.

#include <string>

#include "recon/model/model.h"
#include "shared/cli/cli.h"
#include "shared/scenario/field.h"

namespace recon::cli {

using Print = std::string (*)(const model::Model& model);

/// @param name  of the sub-command and of the operation, whose fields are its options.
/// @param json, table  what is printed with --json and without.
dobra::cli::Command one_step_command(const char* name, const char* help, std::vector<dobra::scenario::Field> fields,
                                     Print json, Print table);

}  // namespace recon::cli
