#pragma once
// The options of `mesh` and `adapt` that are rules of every mesh: meshing::MeshRules, and the size.

#include "shared/cli/parameter_options.h"

namespace quebra::cli {

/// @param fields of the step that obeys the rules. The options refer to `options`.
void add_rule_options(CLI::App& app, dobra::cli::ParameterOptions& options,
                      const std::vector<dobra::scenario::Field>& fields);

/// Those that were given, as parameters of the step. @error those of ParameterOptions::set; BadValue: a size of 0
dobra::base::Result<void> set_rules(const dobra::cli::ParameterOptions& options,
                                    const std::vector<dobra::scenario::Field>& fields, dobra::scenario::Table& params);

}  // namespace quebra::cli
