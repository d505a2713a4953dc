#pragma once
// The options of `mesh` and `adapt` that are rules of every mesh: core::MeshRules, and the size.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "shared/scenario/value.h"

namespace CLI {
class App;
}

namespace quebra::cli {

struct RuleOptions {
  std::optional<double> size, growth, turn, narrow;
  std::optional<std::int64_t> smoothing, max_elements;
  std::optional<std::filesystem::path> background;
  bool rosettes = false;
  std::string order, engine, size_formula, background_field, division;
};

/// @param size what --size is of this command. The options refer to `options`.
void add_rule_options(CLI::App& app, RuleOptions& options, const std::string& size);

/// Those that were given, as parameters of the step.
void set_rules(const RuleOptions& options, dobra::scenario::Table& params);

}  // namespace quebra::cli
