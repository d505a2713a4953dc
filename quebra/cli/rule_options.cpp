#include "quebra/cli/rule_options.h"

#include <CLI/CLI.hpp>

namespace quebra::cli {

void add_rule_options(CLI::App& app, RuleOptions& options, const std::vector<dobra::scenario::Field>& fields) {
  options.parameters.add(app, fields,
                         {"size", "size_formula", "background", "background_field", "division", "growth", "turn",
                          "narrow", "smoothing", "max_elements", "engine", "order"});
  app.add_flag("--rosettes", options.rosettes, "Quarter-point elements round each crack tip; needs order 2");
}

dobra::base::Result<void> set_rules(const RuleOptions& options, const std::vector<dobra::scenario::Field>& fields,
                                    dobra::scenario::Table& params) {
  if (options.rosettes) params.set("rosettes", std::string("yes"));
  return options.parameters.set(fields, params);
}

}  // namespace quebra::cli
