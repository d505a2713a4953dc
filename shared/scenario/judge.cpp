// Expectations: claims of a scenario about quantities of its states.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "shared/base/result.h"
#include "shared/base/text.h"
#include "shared/scenario/runner.h"

namespace dobra::scenario {
namespace {

constexpr int usual_digits = 6;
constexpr int all_digits = 17;

/// With no more than so many significant digits, and all of those before the point.
std::string shown(double value, int digits) {
  std::string text = fmt::format("{}", value);
  const auto counted = std::count_if(text.begin(), std::find(text.begin(), text.end(), 'e'),
                                     [](char c) { return c >= '0' && c <= '9'; });
  if (counted <= digits || !std::isfinite(value)) return text;
  const double size = std::abs(value);
  if (size < 1e-4 || size >= 1e15) return fmt::format("{:.{}g}", value, digits);
  const int decimals = std::max(digits - 1 - static_cast<int>(std::floor(std::log10(size))), 0);
  text = fmt::format("{:.{}f}", value, decimals);
  if (text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

/// What is expected, in words: "12 +- 0.1", "at least 3".
std::string claim(const Expect& expect, double tolerance, int digits) {
  std::vector<std::string> parts;
  if (expect.value) parts.push_back(fmt::format("{} +- {}", shown(*expect.value, digits), shown(tolerance, digits)));
  if (expect.at_least) parts.push_back(fmt::format("at least {}", shown(*expect.at_least, digits)));
  if (expect.at_most) parts.push_back(fmt::format("at most {}", shown(*expect.at_most, digits)));
  return fmt::format("{}", fmt::join(parts, " and "));
}

/// Every comparison is false for a quantity that is not a number.
bool is_met(const Expect& expect, double tolerance, double found) {
  return (!expect.value || std::abs(found - *expect.value) <= tolerance) &&
         (!expect.at_least || found >= *expect.at_least) && (!expect.at_most || found <= *expect.at_most);
}

/// Six, or more where six would tell another verdict.
int digits_that_tell(const Expect& expect, double tolerance, double found) {
  const auto rounded = [](double value, int digits) {
    return base::parse_number(shown(value, digits)).value_or(value);
  };
  for (int digits = usual_digits; digits < all_digits; ++digits) {
    Expect read = expect;
    for (std::optional<double>* value : {&read.value, &read.at_least, &read.at_most}) {
      if (*value) *value = rounded(**value, digits);
    }
    if (is_met(read, tolerance, rounded(found, digits)) == is_met(expect, tolerance, found)) return digits;
  }
  return all_digits;
}

using Quantities = std::vector<Quantity>;

const Quantity* find(const Quantities& quantities, const std::string& name) {
  const auto found = std::find_if(quantities.begin(), quantities.end(), [&](const auto& q) { return q.name == name; });
  return found == quantities.end() ? nullptr : &*found;
}

std::string unknown(const std::string& name, const Quantities& quantities) {
  std::vector<std::string> names;
  for (const Quantity& known : quantities) names.push_back(known.name);
  return fmt::format("there is no quantity '{}'{}", name, base::did_you_mean(name, names));
}

/// The order at which a quantity falls from one state to another with the size of the elements, 1 / sqrt(unknowns).
base::Result<double> rate_of(const std::string& name, const Quantities& first, const Quantities& last) {
  for (const Quantities* const quantities : {&first, &last}) {
    for (const std::string& wanted : {name, std::string("unknowns")}) {
      if (find(*quantities, wanted) == nullptr)
        return base::Error{base::ErrorCode::UnknownQuantity, unknown(wanted, *quantities)};
    }
  }
  const auto ratio = [](const Quantities& above, const Quantities& below, const std::string& quantity) {
    return find(above, quantity)->value / find(below, quantity)->value;
  };
  return 2.0 * std::log(ratio(first, last, name)) / std::log(ratio(last, first, "unknowns"));
}

/// @param first  of the state that a rate begins at.
Verdict judge_one(const Expect& expect, const Quantities& last, const Quantities& first) {
  Verdict verdict;
  verdict.expect = expect;
  const Quantity* const quantity = find(last, expect.quantity);
  if (quantity == nullptr) {
    verdict.message = unknown(expect.quantity, last);
    return verdict;
  }
  double found = quantity->value;
  std::string what = expect.quantity;
  std::string unit = quantity->unit.empty() ? "" : " " + quantity->unit;
  if (expect.rate_from) {
    const auto rate = rate_of(expect.quantity, first, last);
    if (!rate) {
      verdict.message = rate.error().message;
      return verdict;
    }
    found = *rate;
    what = "the rate of " + what;
    unit.clear();
  }
  if (expect.factor != 1.0) {
    found *= expect.factor;
    what = fmt::format("{} * {}", expect.factor, what);
  }
  verdict.found = found;
  const double tolerance = std::max(expect.tolerance, expect.relative_tolerance * std::abs(expect.value.value_or(0.0)));
  verdict.met = is_met(expect, tolerance, found);
  const int digits = digits_that_tell(expect, tolerance, found);
  verdict.message =
      fmt::format("{} is {}{}, expected {}", what, shown(found, digits), unit, claim(expect, tolerance, digits));
  return verdict;
}

/// An expectation, which is in the units of the document, in those of the results; a rate has none.
Expect in_result_units(Expect expect, const Quantities& quantities, const Document& document) {
  const Quantity* const quantity = find(quantities, expect.quantity);
  if (!document.result_units || quantity == nullptr || expect.rate_from) return expect;
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
  const auto quantities_after = [&](const std::optional<std::string>& step) -> std::optional<Quantities> {
    const auto number = step ? find_step(document, *step) : std::optional(document.steps.size());
    if (!number || *number >= run.states.size()) return std::nullopt;
    return program.quantities_of(run.states[*number]);
  };
  for (const Expect& expect : document.expects) {
    const auto last = quantities_after(expect.step);
    const auto first = expect.rate_from ? quantities_after(expect.rate_from) : last;
    if (last && first) {
      verdicts.push_back(judge_one(in_result_units(expect, *last, document), *last, *first));
      continue;
    }
    Verdict verdict;
    verdict.expect = expect;
    verdict.message =
        fmt::format("there is no state after step '{}'", (last ? expect.rate_from : expect.step).value_or("last"));
    verdicts.push_back(std::move(verdict));
  }
  return verdicts;
}

}  // namespace dobra::scenario
