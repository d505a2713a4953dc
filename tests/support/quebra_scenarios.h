#pragma once
// Scenario texts run through QUEBRA's table of operations, as `quebra run` does.

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "quebra/analysis/analysis.h"
#include "quebra/core/operations.h"
#include "shared/scenario/runner.h"

namespace quebra::test {

inline dobra::scenario::Run run(const std::string& text) {
  using namespace dobra;
  const auto document = scenario::parse_document("dobra = 1\nprogram = \"quebra\"\n" + text, "test.toml");
  EXPECT_TRUE(document.ok()) << (document ? "" : to_string(document.error()));
  const auto checked = scenario::check(*document, core::program());
  EXPECT_TRUE(checked.ok()) << (checked ? "" : to_string(checked.error()));
  scenario::Runner runner(core::program());
  return runner.run(*document);
}

inline const model::Model& last(const dobra::scenario::Run& run) {
  return dobra::scenario::model_of<model::Model>(run.states.back());
}

/// The engineering L of the reference list: clamped below, sheared on the right; energy 60.619 J.
inline const std::string sheared_l = R"([input]
specimen = "l_shape"
[[step]]
operation = "problem"
[[step.material]]
young = 100000.0
[[step.support]]
where = "bottom"
x = 0.0
y = 0.0
[[step.load]]
where = "right"
y = 10.0
)";

/// The quantities of the last state by name.
inline std::map<std::string, double> figures(const dobra::scenario::Run& run) {
  EXPECT_TRUE(run.complete()) << to_string(*run.error);
  std::map<std::string, double> values;
  for (const auto& quantity : core::program().quantities_of(run.states.back())) values[quantity.name] = quantity.value;
  return values;
}

inline double unknowns_of(const analysis::Analysis& analysis) {
  return static_cast<double>(analysis.solution.statistics.unknowns);
}

/// The message of the error of a document, be it of its form or of a step; it must have one.
inline std::string trouble(const std::string& text) {
  using namespace dobra;
  const auto document = scenario::parse_document("dobra = 1\nprogram = \"quebra\"\n" + text, "test.toml");
  if (!document) return to_string(document.error());
  if (const auto checked = scenario::check(*document, core::program()); !checked) return to_string(checked.error());
  scenario::Runner runner(core::program());
  const scenario::Run done = runner.run(*document);
  EXPECT_TRUE(done.error.has_value()) << "no error";
  return done.error ? to_string(*done.error) : "";
}

}  // namespace quebra::test
