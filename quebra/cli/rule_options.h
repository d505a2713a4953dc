#pragma once
// The options of `mesh` and `adapt` that are rules of every mesh: core::MeshRules, and the size.

#include "shared/cli/parameter_options.h"

namespace quebra::cli {

struct RuleOptions {
  dobra::cli::ParameterOptions parameters;
  bool rosettes = false;
};

/// @param fields of the step that obeys the rules. The options refer to `options`.
void add_rule_options(CLI::App& app, RuleOptions& options, const std::vector<dobra::scenario::Field>& fields);

/// Those that were given, as parameters of the step. @error those of ParameterOptions::set
dobra::base::Result<void> set_rules(const RuleOptions& options, const std::vector<dobra::scenario::Field>& fields,
                                    dobra::scenario::Table& params);

}  // namespace quebra::cli
