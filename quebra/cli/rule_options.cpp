#include "quebra/cli/rule_options.h"

namespace quebra::cli {

void add_rule_options(CLI::App& app, dobra::cli::ParameterOptions& options,
                      const std::vector<dobra::scenario::Field>& fields) {
  options.add(app, fields,
              {"size", "size_formula", "background", "background_field", "division", "growth", "turn", "chord",
               "narrow", "smoothing", "max_elements", "engine", "order", "rosettes"});
}

dobra::base::Result<void> set_rules(const dobra::cli::ParameterOptions& options,
                                    const std::vector<dobra::scenario::Field>& fields, dobra::scenario::Table& params) {
  dobra::scenario::Table given;
  DOBRA_TRY_VOID(options.set(fields, given));
  for (const auto& entry : given.entries()) {
    // A scenario says so that it leaves the size out; who types one means a size.
    const auto* number = std::get_if<double>(&entry.value);
    if (entry.key == "size" && number != nullptr && *number == 0.0)
      return dobra::base::Error{dobra::base::ErrorCode::BadValue,
                                "--size: must be greater than 0; leave it out for a size that goes by the domain"};
    params.set(entry.key, entry.value);
  }
  return {};
}

}  // namespace quebra::cli
