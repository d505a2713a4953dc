// Expectations: claims of a scenario about quantities of its states.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "shared/base/text.h"
#include "shared/scenario/runner.h"

namespace dobra::scenario {
namespace {

/// What is expected, in words: "12 +- 0.1", "at least 3".
std::string claim(const Expect& expect, double tolerance) {
  std::vector<std::string> parts;
  if (expect.value) parts.push_back(fmt::format("{} +- {}", *expect.value, tolerance));
  if (expect.at_least) parts.push_back(fmt::format("at least {}", *expect.at_least));
  if (expect.at_most) parts.push_back(fmt::format("at most {}", *expect.at_most));
  return fmt::format("{}", fmt::join(parts, " and "));
}

Verdict judge_one(const Expect& expect, const std::vector<Quantity>& quantities) {
  Verdict verdict;
  verdict.expect = expect;
  const auto quantity =
      std::find_if(quantities.begin(), quantities.end(), [&](const Quantity& q) { return q.name == expect.quantity; });
  if (quantity == quantities.end()) {
    std::vector<std::string> names;
    for (const Quantity& known : quantities) names.push_back(known.name);
    verdict.message =
        fmt::format("there is no quantity '{}'{}", expect.quantity, base::did_you_mean(expect.quantity, names));
    return verdict;
  }
  const double found = quantity->value;
  verdict.found = found;
  const double tolerance = std::max(expect.tolerance, expect.relative_tolerance * std::abs(expect.value.value_or(0.0)));
  // Every comparison is false for a quantity that is not a number.
  verdict.met = (!expect.value || std::abs(found - *expect.value) <= tolerance) &&
                (!expect.at_least || found >= *expect.at_least) && (!expect.at_most || found <= *expect.at_most);
  const std::string unit = quantity->unit.empty() ? "" : " " + quantity->unit;
  verdict.message = fmt::format("{} is {}{}, expected {}", expect.quantity, found, unit, claim(expect, tolerance));
  return verdict;
}

}  // namespace

std::vector<Verdict> judge(const Document& document, const Program& program, const Run& run) {
  std::vector<Verdict> verdicts;
  for (const Expect& expect : document.expects) {
    const auto step = expect.step ? find_step(document, *expect.step) : std::optional(document.steps.size());
    if (!step || *step >= run.states.size()) {
      Verdict verdict;
      verdict.expect = expect;
      verdict.message = fmt::format("there is no state after step '{}'", expect.step.value_or("last"));
      verdicts.push_back(std::move(verdict));
      continue;
    }
    verdicts.push_back(judge_one(expect, program.quantities_of(run.states[*step])));
  }
  return verdicts;
}

}  // namespace dobra::scenario
