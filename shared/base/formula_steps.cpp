#include "shared/base/formula_steps.h"

#include <fmt/format.h>

#include <cctype>
#include <numbers>
#include <optional>
#include <utility>

#include "shared/base/formula.h"
#include "shared/base/text.h"

namespace dobra::base::formula_jets {

namespace {

constexpr std::array<std::pair<std::string_view, Operation>, 17> of_one{{{"sin", Sin},
                                                                         {"cos", Cos},
                                                                         {"tan", Tan},
                                                                         {"asin", Asin},
                                                                         {"acos", Acos},
                                                                         {"atan", Atan},
                                                                         {"sinh", Sinh},
                                                                         {"cosh", Cosh},
                                                                         {"tanh", Tanh},
                                                                         {"exp", Exp},
                                                                         {"log", Log},
                                                                         {"log10", Log10},
                                                                         {"sqrt", Sqrt},
                                                                         {"cbrt", Cbrt},
                                                                         {"abs", Abs},
                                                                         {"sign", Sign},
                                                                         {"floor", Floor}}};
constexpr std::array<std::pair<std::string_view, Operation>, 5> of_two{
    {{"atan2", Atan2}, {"hypot", Hypot}, {"pow", Power}, {"min", Min}, {"max", Max}}};

/// By descent, one function a level of binding; the choice binds least.
class Reader {
 public:
  Reader(std::string_view text, const std::array<std::string, 2>& names) : text_(text), names_(names) {}

  bool run() { return choice() && (skip(), at_ == text_.size()); }
  [[nodiscard]] std::vector<FormulaJet::Step> take() { return std::move(steps_); }
  [[nodiscard]] std::size_t stopped_at() const { return at_; }

 private:
  void skip() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
  }
  bool next_is(std::string_view token) {
    skip();
    if (text_.substr(at_, token.size()) != token) return false;
    at_ += token.size();
    return true;
  }
  bool put(Operation operation, double number = 0.0) {
    steps_.push_back({operation, number});
    return true;
  }

  bool choice() {
    constexpr int deepest = 200;
    if (++nested_ > deepest) return false;
    if (!disjunction()) return false;
    if (next_is("?")) {
      if (!choice() || !next_is(":") || !choice()) return false;
      put(Choose);
    }
    --nested_;
    return true;
  }
  bool disjunction() {
    if (!conjunction()) return false;
    while (next_is("||")) {
      if (!conjunction()) return false;
      put(Or);
    }
    return true;
  }
  bool conjunction() {
    if (!comparison()) return false;
    while (next_is("&&")) {
      if (!comparison()) return false;
      put(And);
    }
    return true;
  }
  std::optional<Operation> comparing() {
    constexpr std::array<std::pair<std::string_view, Operation>, 6> all{
        {{"<=", LessEqual}, {">=", GreaterEqual}, {"==", Equal}, {"!=", Unequal}, {"<", Less}, {">", Greater}}};
    for (const auto& [token, operation] : all) {
      if (next_is(token)) return operation;
    }
    return std::nullopt;
  }
  bool comparison() {
    if (!sum()) return false;
    while (const auto operation = comparing()) {
      if (!sum()) return false;
      put(*operation);
    }
    return true;
  }
  bool sum() {
    if (!product()) return false;
    while (true) {
      const bool plus = next_is("+");
      if (!plus && !next_is("-")) return true;
      if (!product()) return false;
      put(plus ? Add : Subtract);
    }
  }
  bool product() {
    if (!signed_power()) return false;
    while (true) {
      const bool times = next_is("*");
      if (!times && !next_is("/")) return true;
      if (!signed_power()) return false;
      put(times ? Multiply : Divide);
    }
  }
  /// -x^2 is -(x^2), and 2^-x^2 is 2^(-(x^2)).
  bool signed_power() {
    bool negative = false;
    while (true) {
      if (next_is("-")) {
        negative = !negative;
      } else if (!next_is("+")) {
        break;
      }
    }
    if (!atom()) return false;
    if (next_is("^")) {
      if (!signed_power()) return false;
      put(Power);
    }
    return !negative || put(Negate);
  }
  bool arguments(std::size_t count) {
    if (!next_is("(")) return false;
    for (std::size_t i = 0; i < count; ++i) {
      if ((i > 0 && !next_is(",")) || !choice()) return false;
    }
    return next_is(")");
  }
  bool atom() {
    if (next_is("(")) return choice() && next_is(")");
    skip();
    if (at_ == text_.size()) return false;
    const auto letter = [&](std::size_t i) {
      const auto c = static_cast<unsigned char>(text_[i]);
      return std::isalnum(c) != 0 || c == '_';
    };
    if (std::isdigit(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == '.') return number();
    const std::size_t begin = at_;
    while (at_ < text_.size() && letter(at_)) ++at_;
    const std::string_view word = text_.substr(begin, at_ - begin);
    if (word == names_[0]) return put(X);
    if (word == names_[1]) return put(Y);
    if (word == "pi") return put(Number, std::numbers::pi);
    if (word == "e") return put(Number, std::numbers::e);
    for (const auto& [name, operation] : of_one) {
      if (word == name) return arguments(1) && put(operation);
    }
    for (const auto& [name, operation] : of_two) {
      if (word == name) return arguments(2) && put(operation);
    }
    at_ = begin;
    return false;
  }
  bool number() {
    std::size_t end = at_;
    const auto digits = [&] {
      while (end < text_.size() && std::isdigit(static_cast<unsigned char>(text_[end])) != 0) ++end;
    };
    digits();
    if (end < text_.size() && text_[end] == '.') ++end, digits();
    if (end < text_.size() && (text_[end] == 'e' || text_[end] == 'E')) {
      const std::size_t mantissa = end++;
      if (end < text_.size() && (text_[end] == '+' || text_[end] == '-')) ++end;
      const std::size_t first = end;
      digits();
      if (end == first) end = mantissa;
    }
    std::string word(text_.substr(at_, end - at_));
    if (word.front() == '.') word.insert(word.begin(), '0');
    if (word.back() == '.') word.pop_back();
    const auto value = parse_number(word);
    if (!value) return false;
    at_ = end;
    return put(Number, *value);
  }

  std::string_view text_;
  const std::array<std::string, 2>& names_;
  std::size_t at_ = 0;
  int nested_ = 0;
  std::vector<FormulaJet::Step> steps_;
};

}  // namespace

std::size_t taken_by(std::uint8_t operation) {
  if (operation <= Y) return 0;
  if (operation == Negate) return 1;
  if (operation < Choose || operation >= Atan2) return 2;
  return operation == Choose ? 3 : 1;
}

Result<std::vector<FormulaJet::Step>> steps_of(const std::string& text, const std::array<std::string, 2>& names) {
  Reader reader(text, names);
  if (!reader.run())
    return Error{ErrorCode::BadValue, fmt::format("the formula '{}' cannot be read from character {} on", text,
                                                  character_number(text, reader.stopped_at()))};
  return reader.take();
}

}  // namespace dobra::base::formula_jets
