#include "shared/base/formula.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <muParser.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <mutex>
#include <numbers>
#include <string_view>
#include <utility>

#include "shared/base/check.h"
#include "shared/base/text.h"

namespace dobra::base {
namespace {

constexpr std::array<std::pair<const char*, double (*)(double)>, 17> of_one{{
    {"sin", [](double a) { return std::sin(a); }},
    {"cos", [](double a) { return std::cos(a); }},
    {"tan", [](double a) { return std::tan(a); }},
    {"asin", [](double a) { return std::asin(a); }},
    {"acos", [](double a) { return std::acos(a); }},
    {"atan", [](double a) { return std::atan(a); }},
    {"sinh", [](double a) { return std::sinh(a); }},
    {"cosh", [](double a) { return std::cosh(a); }},
    {"tanh", [](double a) { return std::tanh(a); }},
    {"exp", [](double a) { return std::exp(a); }},
    {"log", [](double a) { return std::log(a); }},
    {"log10", [](double a) { return std::log10(a); }},
    {"sqrt", [](double a) { return std::sqrt(a); }},
    {"cbrt", [](double a) { return std::cbrt(a); }},
    {"abs", [](double a) { return std::abs(a); }},
    {"sign", [](double a) { return a > 0.0   ? 1.0
                                   : a < 0.0 ? -1.0
                                             : 0.0; }},
    {"floor", [](double a) { return std::floor(a); }},
}};
constexpr std::array<std::pair<const char*, double (*)(double, double)>, 5> of_two{{
    {"atan2", [](double a, double b) { return std::atan2(a, b); }},
    {"hypot", [](double a, double b) { return std::hypot(a, b); }},
    {"pow", [](double a, double b) { return std::pow(a, b); }},
    {"min", [](double a, double b) { return std::min(a, b); }},
    {"max", [](double a, double b) { return std::max(a, b); }},
}};

/// A parser and the values that its names are bound to: for one thread at a time.
struct Evaluator {
  Evaluator(const std::string& text, std::span<const std::string> names) : values(names.size(), 0.0) {
    parser.ClearFun();
    parser.ClearConst();
    for (const auto& [name, function] : of_one) parser.DefineFun(name, function);
    for (const auto& [name, function] : of_two) parser.DefineFun(name, function);
    parser.DefineConst("pi", std::numbers::pi);
    parser.DefineConst("e", std::numbers::e);
    parser.DefineInfixOprt("+", [](double a) { return a; });
    for (std::size_t i = 0; i < names.size(); ++i) parser.DefineVar(names[i], &values[i]);
    parser.SetExpr(text);
  }
  Evaluator(const Evaluator&) = delete;
  Evaluator& operator=(const Evaluator&) = delete;

  mu::Parser parser;
  std::vector<double> values;
};

/// What stands in the way where a word is none of the names.
std::string unknown(const std::string& word, std::span<const std::string> names) {
  std::vector<std::string> candidates(names.begin(), names.end());
  for (const auto& entry : of_one) candidates.emplace_back(entry.first);
  for (const auto& entry : of_two) candidates.emplace_back(entry.first);
  if (std::find(candidates.begin(), candidates.end(), word) != candidates.end())
    return fmt::format("the arguments of '{}' are missing", word);
  if (const auto value = parse_number(word); value || (std::isdigit(static_cast<unsigned char>(word.front())) != 0))
    return fmt::format("'{}' is no finite number", word);
  if (word == "\u2264" || word == "\u2265")
    return fmt::format("'{}' is not known here; write '{}='", word, word == "\u2264" ? '<' : '>');
  candidates.emplace_back("pi");
  const std::string meant = did_you_mean(word, candidates);
  return fmt::format(
      "'{}' is not known here{}", word,
      meant.empty() ? fmt::format("; there is {}, pi, e and functions such as sin(x)", fmt::join(names, ", ")) : meant);
}

std::string explained(const mu::ParserError& error, std::span<const std::string> names) {
  switch (error.GetCode()) {
    case mu::ecUNASSIGNABLE_TOKEN: {
      const std::string word = error.GetToken().substr(0, error.GetToken().find(' '));
      return unknown(word, names);
    }
    case mu::ecUNEXPECTED_EOF:
    case mu::ecEMPTY_EXPRESSION:
      return "a number, a name or a bracket is missing at the end";
    case mu::ecMISSING_PARENS:
      return "a ')' is missing";
    case mu::ecTOO_FEW_PARAMS:
      return fmt::format("'{}' lacks an argument", error.GetToken());
    case mu::ecTOO_MANY_PARAMS:
      return fmt::format("'{}' has an argument too many", error.GetToken());
    case mu::ecEXPRESSION_TOO_LONG:
      return "the formula is too long";
    case mu::ecMISSING_ELSE_CLAUSE:
      return "the choice lacks its ':'";
    default:
      return fmt::format("'{}' is not expected here", error.GetToken());
  }
}

/// Position of an '=' that is no comparison: it would assign.
std::size_t assignment_in(std::string_view text) {
  for (std::size_t i = text.find('='); i != std::string_view::npos; i = text.find('=', i + 1)) {
    const char before = i > 0 ? text[i - 1] : ' ';
    if (i + 1 < text.size() && text[i + 1] == '=') {
      ++i;
    } else if (before != '<' && before != '>' && before != '!') {
      return i;
    }
  }
  return std::string_view::npos;
}

}  // namespace

/// Evaluators that no thread is using.
class Formula::Evaluators {
 public:
  Evaluators(std::string text, std::span<const std::string> names)
      : text_(std::move(text)), names_(names.begin(), names.end()) {}

  std::unique_ptr<Evaluator> take() {
    {
      const std::lock_guard lock(mutex_);
      if (!idle_.empty()) {
        std::unique_ptr<Evaluator> last = std::move(idle_.back());
        idle_.pop_back();
        return last;
      }
    }
    return std::make_unique<Evaluator>(text_, names_);
  }
  void give_back(std::unique_ptr<Evaluator> evaluator) {
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(evaluator));
  }

 private:
  std::string text_;
  std::vector<std::string> names_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Evaluator>> idle_;
};

std::size_t character_number(std::string_view text, std::size_t at) {
  const std::string_view before = text.substr(0, at);
  return 1 + static_cast<std::size_t>(std::count_if(before.begin(), before.end(), [](char c) {
           return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
         }));
}

Result<Formula> Formula::make(const std::string& text, std::span<const std::string> names, const FormulaPlace& within) {
  const std::string& whole = within.whole.empty() ? text : within.whole;
  const std::string shown = whole.size() > 100 ? whole.substr(0, 97) + "..." : whole;
  const auto wrong = [&](std::size_t at, const std::string& what) {
    return Error{ErrorCode::BadValue,
                 fmt::format("{} '{}', character {}: {}", within.called, shown,
                             character_number(whole, within.begin + std::min(at, text.size())), what)};
  };
  if (const std::size_t at = assignment_in(text); at != std::string_view::npos)
    return wrong(at, "'=' is not expected here; a comparison is '=='");
  Formula formula;
  formula.evaluators_ = std::make_shared<Evaluators>(text, names);
  try {
    auto evaluator = formula.evaluators_->take();
    int results = 0;
    evaluator->parser.Eval(results);
    if (results != 1) return wrong(text.find(','), "',' is not expected here");
    formula.evaluators_->give_back(std::move(evaluator));
  } catch (const mu::ParserError& error) {
    return wrong(error.GetPos() < 0 ? text.size() : static_cast<std::size_t>(error.GetPos()), explained(error, names));
  }
  return formula;
}

double Formula::at(std::span<const double> values) const {
  auto evaluator = evaluators_->take();
  DOBRA_CHECK(values.size() == evaluator->values.size());
  std::copy(values.begin(), values.end(), evaluator->values.begin());
  const double value = evaluator->parser.Eval();  // What could throw has been read by `make`.
  evaluators_->give_back(std::move(evaluator));
  return value;
}

}  // namespace dobra::base
