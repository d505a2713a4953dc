#include "shared/base/formula.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>
#include <string_view>

#include "shared/base/text.h"

namespace dobra::base {
namespace {

using Step = Formula::Step;
using Kind = Step::Kind;

constexpr int deepest = 64;  ///< Brackets within brackets; also the height of the stack of values.

struct One {
  const char* name;
  double (*value)(double);
};
constexpr std::array ones{
    One{"-", [](double a) { return -a; }},
    One{"sin", [](double a) { return std::sin(a); }},
    One{"cos", [](double a) { return std::cos(a); }},
    One{"tan", [](double a) { return std::tan(a); }},
    One{"asin", [](double a) { return std::asin(a); }},
    One{"acos", [](double a) { return std::acos(a); }},
    One{"atan", [](double a) { return std::atan(a); }},
    One{"sinh", [](double a) { return std::sinh(a); }},
    One{"cosh", [](double a) { return std::cosh(a); }},
    One{"tanh", [](double a) { return std::tanh(a); }},
    One{"exp", [](double a) { return std::exp(a); }},
    One{"log", [](double a) { return std::log(a); }},
    One{"log10", [](double a) { return std::log10(a); }},
    One{"sqrt", [](double a) { return std::sqrt(a); }},
    One{"cbrt", [](double a) { return std::cbrt(a); }},
    One{"abs", [](double a) { return std::abs(a); }},
    One{"sign", [](double a) { return a > 0.0 ? 1.0 : a < 0.0 ? -1.0 : 0.0; }},
    One{"floor", [](double a) { return std::floor(a); }},
};

struct Two {
  const char* name;
  double (*value)(double, double);
};
constexpr std::array twos{
    Two{"+", [](double a, double b) { return a + b; }},
    Two{"-", [](double a, double b) { return a - b; }},
    Two{"*", [](double a, double b) { return a * b; }},
    Two{"/", [](double a, double b) { return a / b; }},
    Two{"^", [](double a, double b) { return std::pow(a, b); }},
    Two{"<=", [](double a, double b) { return a <= b ? 1.0 : 0.0; }},
    Two{">=", [](double a, double b) { return a >= b ? 1.0 : 0.0; }},
    Two{"<", [](double a, double b) { return a < b ? 1.0 : 0.0; }},
    Two{">", [](double a, double b) { return a > b ? 1.0 : 0.0; }},
    Two{"atan2", [](double a, double b) { return std::atan2(a, b); }},
    Two{"hypot", [](double a, double b) { return std::hypot(a, b); }},
    Two{"pow", [](double a, double b) { return std::pow(a, b); }},
    Two{"min", [](double a, double b) { return std::min(a, b); }},
    Two{"max", [](double a, double b) { return std::max(a, b); }},
};

template <class Table>
std::size_t find_in(const Table& table, std::string_view name) {
  const auto at = std::find_if(table.begin(), table.end(), [&](const auto& entry) { return name == entry.name; });
  return static_cast<std::size_t>(at - table.begin());
}

/// Recursive descent: choice -> comparison -> sum -> product -> sign -> power -> operand.
class Reader {
 public:
  Reader(const std::string& text, std::span<const std::string> names) : text_(text), names_(names) {}

  Result<std::vector<Step>> read() {
    DOBRA_TRY_VOID(choice());
    if (at_ < text_.size()) return wrong(fmt::format("'{}' is not expected here", text_.substr(at_, 1)));
    return std::move(steps_);
  }

 private:
  [[nodiscard]] Error wrong(const std::string& what) const {
    return {ErrorCode::BadValue, fmt::format("formula '{}', character {}: {}", text_, at_ + 1, what)};
  }
  void skip_blanks() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
  }
  bool take(std::string_view word) {
    skip_blanks();
    if (std::string_view(text_).substr(at_, word.size()) != word) return false;
    at_ += word.size();
    skip_blanks();
    return true;
  }
  void put(Kind kind, std::size_t target) { steps_.push_back({kind, 0.0, target}); }

  Result<void> choice() {
    if (++depth_ > deepest) return wrong("brackets within brackets, too many");
    DOBRA_TRY_VOID(comparison());
    if (take("?")) {
      const std::size_t condition = steps_.size();
      put(Kind::SkipUnless, 0);
      DOBRA_TRY_VOID(choice());
      if (!take(":")) return wrong("the choice lacks its ':'");
      const std::size_t end = steps_.size();
      put(Kind::Skip, 0);
      steps_[condition].target = steps_.size();
      DOBRA_TRY_VOID(choice());
      steps_[end].target = steps_.size();
    }
    --depth_;
    return {};
  }
  Result<void> comparison() {
    DOBRA_TRY_VOID(sum());
    for (const char* const word : {"<=", ">=", "<", ">"}) {
      if (!take(word)) continue;
      DOBRA_TRY_VOID(sum());
      put(Kind::Two, find_in(twos, word));
      break;
    }
    return {};
  }
  Result<void> sum() {
    DOBRA_TRY_VOID(product());
    for (;;) {
      const char* const word = take("+") ? "+" : take("-") ? "-" : nullptr;
      if (word == nullptr) return {};
      DOBRA_TRY_VOID(product());
      put(Kind::Two, find_in(twos, word));
    }
  }
  Result<void> product() {
    DOBRA_TRY_VOID(sign());
    for (;;) {
      const char* const word = take("*") ? "*" : take("/") ? "/" : nullptr;
      if (word == nullptr) return {};
      DOBRA_TRY_VOID(sign());
      put(Kind::Two, find_in(twos, word));
    }
  }
  Result<void> sign() {
    bool negative = false;
    for (;;) {
      if (take("-")) {
        negative = !negative;
      } else if (!take("+")) {
        break;
      }
    }
    DOBRA_TRY_VOID(power());
    if (negative) put(Kind::One, find_in(ones, "-"));
    return {};
  }
  Result<void> power() {
    DOBRA_TRY_VOID(operand());
    if (!take("^")) return {};
    if (++depth_ > deepest) return wrong("powers of powers, too many");
    DOBRA_TRY_VOID(sign());
    --depth_;
    put(Kind::Two, find_in(twos, "^"));
    return {};
  }
  Result<void> operand() {
    skip_blanks();
    if (at_ == text_.size()) return wrong("a number, a name or a bracket is missing at the end");
    if (take("(")) {
      DOBRA_TRY_VOID(choice());
      if (!take(")")) return wrong("a ')' is missing");
      return {};
    }
    const char first = text_[at_];
    if (std::isdigit(static_cast<unsigned char>(first)) != 0 || first == '.') return number();
    if (std::isalpha(static_cast<unsigned char>(first)) != 0) return name();
    return wrong("a number, a name or a bracket is missing");
  }
  Result<void> number() {
    double value = 0.0;
    const auto [end, code] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (code != std::errc{}) return wrong("this is not a number");
    at_ = static_cast<std::size_t>(end - text_.data());
    steps_.push_back({Kind::Number, value, 0});
    skip_blanks();
    return {};
  }
  Result<void> name() {
    const std::size_t begin = at_;
    std::size_t end = at_;
    while (end < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[end])) != 0 || text_[end] == '_')) ++end;
    const std::string word = text_.substr(begin, end - begin);
    if (const auto known = std::find(names_.begin(), names_.end(), word); known != names_.end()) {
      put(Kind::Name, static_cast<std::size_t>(known - names_.begin()));
    } else if (word == "pi" || word == "e") {
      steps_.push_back({Kind::Number, word == "pi" ? std::numbers::pi : std::numbers::e, 0});
    } else if (find_in(ones, word) < ones.size() || find_in(twos, word) < twos.size()) {
      at_ = end;
      return call(word);
    } else {
      std::vector<std::string> candidates(names_.begin(), names_.end());
      for (const auto& entry : ones) candidates.emplace_back(entry.name);
      for (const auto& entry : twos) candidates.emplace_back(entry.name);
      candidates.emplace_back("pi");
      return wrong(fmt::format("'{}' is not known here{}", word, did_you_mean(word, candidates)));
    }
    at_ = end;
    skip_blanks();
    return {};
  }
  Result<void> call(const std::string& function) {
    if (!take("(")) return wrong(fmt::format("the arguments of '{}' are missing", function));
    DOBRA_TRY_VOID(choice());
    const std::size_t one = find_in(ones, function);
    if (one == ones.size()) {
      if (!take(",")) return wrong(fmt::format("'{}' takes two arguments", function));
      DOBRA_TRY_VOID(choice());
    }
    if (!take(")")) return wrong(fmt::format("a ')' is missing after the arguments of '{}'", function));
    put(one < ones.size() ? Kind::One : Kind::Two, one < ones.size() ? one : find_in(twos, function));
    return {};
  }

  const std::string& text_;
  std::span<const std::string> names_;
  std::size_t at_ = 0;
  int depth_ = 0;
  std::vector<Step> steps_;
};

}  // namespace

Result<Formula> Formula::make(const std::string& text, std::span<const std::string> names) {
  Formula formula;
  DOBRA_TRY(formula.steps_, Reader(text, names).read());
  return formula;
}

double Formula::at(std::span<const double> values) const {
  // A level of brackets leaves at most five operands waiting: of a comparison, a sum, a product, a power and a call.
  std::array<double, 5 * deepest + 8> stack{};
  std::size_t top = 0;
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const Step& step = steps_[i];
    switch (step.kind) {
      case Kind::Number: stack[top++] = step.number; break;
      case Kind::Name: stack[top++] = values[step.target]; break;
      case Kind::One: stack[top - 1] = ones[step.target].value(stack[top - 1]); break;
      case Kind::Two:
        --top;
        stack[top - 1] = twos[step.target].value(stack[top - 1], stack[top]);
        break;
      case Kind::SkipUnless:
        if (stack[--top] == 0.0) i = step.target - 1;
        break;
      case Kind::Skip: i = step.target - 1; break;
    }
  }
  return stack[0];
}

}  // namespace dobra::base
