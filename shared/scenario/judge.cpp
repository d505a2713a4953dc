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

/// An expectation, which is in the units of the document, in those of the results.
Expect in_result_units(Expect expect, const std::vector<Quantity>& quantities, const Document& document) {
  const auto quantity =
      std::find_if(quantities.begin(), quantities.end(), [&](const Quantity& q) { return q.name == expect.quantity; });
  if (!document.result_units || quantity == quantities.end()) return expect;
  const std::string si = document.shown_units().si_of(quantity->unit);
  const auto turned = [&](double value) { return document.shown_units().from_si(document.units.to_si(value, si), si); };
  for (std::optional<double>* value : {&expect.value, &expect.at_least, &expect.at_most}) {
    if (*value) *value = turned(**value);
  }
  expect.tolerance = turned(expect.tolerance);
  return expect;
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
    const std::vector<Quantity> quantities = program.quantities_of(run.states[*step]);
    verdicts.push_back(judge_one(in_result_units(expect, quantities, document), quantities));
  }
  return verdicts;
}

}  // namespace dobra::scenario
