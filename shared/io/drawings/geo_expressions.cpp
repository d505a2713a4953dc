#include "shared/io/drawings/geo_expressions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shared/base/text.h"
#include "shared/io/scan.h"

namespace dobra::io::drawings {

using base::Error;
using base::ErrorCode;
using base::Result;

namespace {

constexpr double most_steps = 1e7;

const std::map<std::string, double (*)(double)>& functions() {
  static const std::map<std::string, double (*)(double)> table = {
      {"Sin", std::sin},     {"Cos", std::cos},     {"Tan", std::tan},    {"Asin", std::asin}, {"Acos", std::acos},
      {"Atan", std::atan},   {"Sinh", std::sinh},   {"Cosh", std::cosh},  {"Tanh", std::tanh}, {"Exp", std::exp},
      {"Log", std::log},     {"Log10", std::log10}, {"Sqrt", std::sqrt},  {"Fabs", std::fabs}, {"Abs", std::fabs},
      {"Floor", std::floor}, {"Ceil", std::ceil},   {"Round", std::round}};
  return table;
}

struct Operator {
  std::string_view sign;
  int level;
  double (*value)(double, double);
};

const std::vector<Operator>& operators() {
  static const std::vector<Operator> table = {
      {"||", 0, [](double a, double b) { return a != 0.0 || b != 0.0 ? 1.0 : 0.0; }},
      {"&&", 1, [](double a, double b) { return a != 0.0 && b != 0.0 ? 1.0 : 0.0; }},
      {"==", 2, [](double a, double b) { return a == b ? 1.0 : 0.0; }},
      {"!=", 2, [](double a, double b) { return a != b ? 1.0 : 0.0; }},
      {"<=", 3, [](double a, double b) { return a <= b ? 1.0 : 0.0; }},
      {">=", 3, [](double a, double b) { return a >= b ? 1.0 : 0.0; }},
      {"<", 3, [](double a, double b) { return a < b ? 1.0 : 0.0; }},
      {">", 3, [](double a, double b) { return a > b ? 1.0 : 0.0; }},
      {"+", 4, [](double a, double b) { return a + b; }},
      {"-", 4, [](double a, double b) { return a - b; }},
      {"*", 5, [](double a, double b) { return a * b; }},
      {"/", 5, [](double a, double b) { return a / b; }},
      {"%", 5, [](double a, double b) { return std::fmod(a, b); }}};
  return table;
}

}  // namespace

base::Place GeoExpressions::place(const GeoToken& token) const {
  base::Place place;
  place.file = file_;
  place.line = token.line;
  place.column = token.column;
  return place;
}

Error GeoExpressions::error_at(const GeoToken& token, std::string message) const {
  return {ErrorCode::BadFormat, std::move(message), place(token)};
}

std::string GeoExpressions::found() const {
  return token().kind == Kind::End ? "the end of the file" : shown(token().text);
}

Result<void> GeoExpressions::expect(std::string_view text) {
  if (take(text)) return {};
  return error(fmt::format("'{}' is due here, not {}", text, found()));
}

Result<double> GeoExpressions::expression() {
  if (++depth_ > deepest) return error("the expression is nested too deeply");
  auto value = conditional();
  --depth_;
  if (value && !std::isfinite(*value)) return error("the expression has no finite value");
  return value;
}

Result<double> GeoExpressions::conditional() {
  DOBRA_TRY(const double condition, binary(0));
  if (!take("?")) return condition;
  DOBRA_TRY(const double yes, expression());
  DOBRA_TRY_VOID(expect(":"));
  DOBRA_TRY(const double no, expression());
  return condition != 0.0 ? yes : no;
}

Result<double> GeoExpressions::binary(int level) {
  if (level > 5) return unary();
  DOBRA_TRY(double value, binary(level + 1));
  while (token().kind == Kind::Sign) {
    const auto& all = operators();
    const auto op = std::find_if(all.begin(), all.end(),
                                 [&](const Operator& o) { return o.level == level && o.sign == token().text; });
    if (op == all.end()) break;
    ++at_;
    DOBRA_TRY(const double right, binary(level + 1));
    value = op->value(value, right);
  }
  return value;
}

Result<double> GeoExpressions::unary() {
  if (++depth_ > deepest) return error("the expression is nested too deeply");
  auto value = signed_power();
  --depth_;
  return value;
}

Result<double> GeoExpressions::signed_power() {
  if (take("+")) return unary();
  if (take("-")) {
    DOBRA_TRY(const double value, unary());
    return -value;
  }
  if (take("!")) {
    DOBRA_TRY(const double value, unary());
    return value == 0.0 ? 1.0 : 0.0;
  }
  DOBRA_TRY(const double base, primary());
  if (!take("^")) return base;
  DOBRA_TRY(const double exponent, unary());
  return std::pow(base, exponent);
}

Result<double> GeoExpressions::primary() {
  if (token().kind == Kind::Number) return tokens_[at_++].value;
  if (take("(")) {
    DOBRA_TRY(const double value, expression());
    DOBRA_TRY_VOID(expect(")"));
    return value;
  }
  if (take("#")) {
    const GeoToken name = token();
    ++at_;
    if (!take("[")) DOBRA_TRY_VOID(expect("("));
    if (!take("]")) DOBRA_TRY_VOID(expect(")"));
    const auto list = lists_.find(name.text);
    if (list == lists_.end()) return error_at(name, fmt::format("there is no list {}", shown(name.text)));
    return static_cast<double>(list->second.size());
  }
  if (token().kind != Kind::Word) return error(fmt::format("a number or a name is due here, not {}", found()));
  return named();
}

Result<double> GeoExpressions::named() {
  const GeoToken name = token();
  ++at_;
  if (name.text == "Pi") return std::numbers::pi;
  if (name.text == "newp") return next_tag(geo_.points);
  if (name.text == "newl" || name.text == "newc") return next_tag(geo_.curves);
  if (name.text == "newll" || name.text == "newcl") return next_tag(loop_curves_);
  if (name.text == "news") return next_tag(geo_.surfaces);
  if (name.text == "newreg") {
    return std::max(
        {next_tag(geo_.curves), next_tag(loop_curves_), next_tag(geo_.surfaces), static_cast<double>(last_group_ + 1)});
  }
  if (is("(") || is("[")) {
    const auto function = functions().find(name.text);
    const std::string closing = is("(") ? ")" : "]";
    ++at_;
    DOBRA_TRY(const double first, expression());
    if (take(",")) {
      DOBRA_TRY(const double second, expression());
      DOBRA_TRY_VOID(expect(closing));
      if (name.text == "Atan2") return std::atan2(first, second);
      if (name.text == "Hypot") return std::hypot(first, second);
      if (name.text == "Fmod" || name.text == "Modulo") return std::fmod(first, second);
      if (name.text == "Min") return std::min(first, second);
      if (name.text == "Max") return std::max(first, second);
      return error_at(name, fmt::format("there is no function {} of two numbers", shown(name.text)));
    }
    DOBRA_TRY_VOID(expect(closing));
    if (function != functions().end()) return function->second(first);
    const auto list = lists_.find(name.text);
    if (list == lists_.end()) return error_at(name, unknown("function or list", name.text));
    if (!(first >= 0.0) || first >= static_cast<double>(list->second.size())) {
      return error_at(name, fmt::format("the list {} has no element {}", shown(name.text), first));
    }
    return list->second[static_cast<std::size_t>(first)];
  }
  const auto variable = variables_.find(name.text);
  if (variable == variables_.end()) return error_at(name, unknown("variable", name.text));
  return variable->second;
}

std::string GeoExpressions::unknown(const char* what, const std::string& name) const {
  std::vector<std::string> names;
  for (const auto& [known, value] : variables_) names.push_back(known);
  for (const auto& [known, value] : functions()) names.push_back(known);
  return fmt::format("there is no {} {}{}", what, shown(name), base::did_you_mean(name, names));
}

Result<std::vector<double>> GeoExpressions::list() {
  List values;
  if (!take("{")) {
    DOBRA_TRY_VOID(list_item(values));
    return values;
  }
  while (!take("}")) {
    DOBRA_TRY_VOID(list_item(values));
    if (!is("}")) DOBRA_TRY_VOID(expect(","));
  }
  return values;
}

Result<void> GeoExpressions::spend(double count) {
  steps_ += count;
  if (steps_ > most_steps) return error("the loops and lists of this file are too long");
  return {};
}

Result<void> GeoExpressions::list_item(List& values) {
  const bool minus = is("-") && token(1).kind == Kind::Word && lists_.contains(token(1).text);
  const std::size_t name = minus ? 1 : 0;
  const bool whole = token(name).kind == Kind::Word && lists_.contains(token(name).text) &&
                     ((is("[", name + 1) && is("]", name + 2)) || (is("(", name + 1) && is(")", name + 2)));
  if (whole) {
    const List& list = lists_.at(token(name).text);
    DOBRA_TRY_VOID(spend(static_cast<double>(list.size())));
    for (const double value : list) values.push_back(minus ? -value : value);
    at_ += name + 3;
    return {};
  }
  DOBRA_TRY(const double first, expression());
  if (!take(":")) {
    values.push_back(first);
    return {};
  }
  DOBRA_TRY(const double last, expression());
  double step = last >= first ? 1.0 : -1.0;
  if (take(":")) {
    DOBRA_TRY(step, expression());
  }
  const double count = std::floor((last - first) / step + 1e-9);
  if (!(count >= 0.0) || count > 1e6) return error("this range is empty or too long");
  DOBRA_TRY_VOID(spend(count));
  for (double i = 0.0; i <= count; ++i) values.push_back(first + i * step);
  return {};
}

Result<std::int64_t> GeoExpressions::tag_of(double value) const {
  if (value != std::floor(value) || std::abs(value) > 1e15 || value == 0.0)
    return error(fmt::format("{} is not a tag: tags are whole numbers, not 0", value));
  return static_cast<std::int64_t>(value);
}

Result<std::vector<std::int64_t>> GeoExpressions::tags() {
  DOBRA_TRY(const List values, list());
  std::vector<std::int64_t> result;
  for (const double value : values) {
    DOBRA_TRY(const std::int64_t tag, tag_of(value));
    result.push_back(tag);
  }
  return result;
}

Result<std::int64_t> GeoExpressions::own_tag() {
  DOBRA_TRY_VOID(expect("("));
  DOBRA_TRY(const double value, expression());
  DOBRA_TRY_VOID(expect(")"));
  return tag_of(value);
}

}  // namespace dobra::io::drawings
