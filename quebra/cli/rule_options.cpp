#include "quebra/cli/rule_options.h"

#include <CLI/CLI.hpp>

namespace quebra::cli {

void add_rule_options(CLI::App& app, RuleOptions& options, const std::string& size) {
  app.add_option("--size", options.size, size)->type_name("H");
  app.add_option("--size-formula", options.size_formula,
                 "Target length as a formula of x and y, such as \"0.1 + 0.05 * hypot(x, y)\"")
      ->type_name("F");
  app.add_option("--background", options.background, "Mesh whose element sizes are wanted, or a field of it")
      ->type_name("FILE");
  app.add_option("--background-field", options.background_field,
                 "Field at the points of the background mesh (.vtu) that holds the sizes")
      ->type_name("NAME");
  app.add_option("--division", options.division,
                 "Of curves: even (default), as few sides as meet size and turn, or halving, 2:1 along a curve")
      ->check(CLI::IsMember({"even", "halving"}))
      ->type_name("even|halving");
  app.add_option("--growth", options.growth, "Most by which sizes grow from one element to the next; 1.3 by default")
      ->type_name("G");
  app.add_option("--turn", options.turn, "Degrees that one side may turn along an arc; 15 by default, 30 in a loop")
      ->type_name("DEG");
  app.add_option(
         "--narrow", options.narrow,
         "Elements across places where curves, tips or points come near each other; 1 by default, 0: as elsewhere")
      ->type_name("N");
  app.add_option("--smoothing", options.smoothing, "Passes of smoothing; 3 by default")->type_name("N");
  app.add_option("--max-elements", options.max_elements, "Stop with advice beyond this number")->type_name("N");
  app.add_option("--engine", options.engine, "What places the nodes inside: front (default) or delaunay")
      ->check(CLI::IsMember({"front", "delaunay"}))
      ->type_name("front|delaunay");
  app.add_option("--order", options.order, "Order of the elements: 1 (default of a mesh) or 2 (of a loop)")
      ->check(CLI::IsMember({"1", "2"}))
      ->type_name("1|2");
  app.add_flag("--rosettes", options.rosettes, "Quarter-point elements round each crack tip; needs order 2");
}

void set_rules(const RuleOptions& options, dobra::scenario::Table& params) {
  const auto set = [&](const char* key, const auto& value) {
    if (value) params.set(key, *value);
  };
  set("size", options.size);
  set("growth", options.growth);
  set("turn", options.turn);
  set("narrow", options.narrow);
  set("smoothing", options.smoothing);
  set("max_elements", options.max_elements);
  const auto set_text = [&](const char* key, const std::string& text) {
    if (!text.empty()) params.set(key, text);
  };
  if (options.rosettes) params.set("rosettes", std::string("yes"));
  set_text("engine", options.engine);
  set_text("order", options.order);
  set_text("size_formula", options.size_formula);
  set_text("background_field", options.background_field);
  set_text("division", options.division);
  // Named from where the user stands, not from the scenario's folder.
  if (options.background) params.set("background", std::filesystem::absolute(*options.background).string());
}

}  // namespace quebra::cli
