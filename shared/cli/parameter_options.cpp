#include "shared/cli/parameter_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "shared/base/text.h"
#include "shared/io/formats/line_files.h"
#include "shared/scenario/list_text.h"
#include "shared/scenario/toml_text.h"

namespace dobra::cli {
namespace {

using scenario::Field;
using scenario::Kind;

std::string option_of(const std::string& key) {
  std::string name = "--" + key;
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

const char* type_name(const Field& field) {
  switch (field.kind) {
    case Kind::Integer:
      return "N";
    case Kind::Number:
      return "X";
    case Kind::Degrees:
      return "DEG";
    case Kind::File:
      return "FILE";
    case Kind::Point:
      return "X Y";
    case Kind::Numbers:
    case Kind::Texts:
      return "LIST";
    default:
      return "NAME";
  }
}

bool is_switch(const Field& field) {
  return field.kind == Kind::Flag ||
         (field.kind == Kind::Choice && field.choices == std::vector<std::string>{"no", "yes"});
}

std::string help_of(const Field& field) {
  std::string text = field.options.title;
  if (*field.options.help != '\0') text += fmt::format(". {}", field.options.help);
  if (text.ends_with('.')) text.pop_back();
  if (is_switch(field)) return text;
  return fmt::format("{} ({})", text, scenario::field_summary(field));
}

bool is_list(const Field& field) { return field.kind == Kind::Numbers || field.kind == Kind::Texts; }

/// What the user typed as scenario::parse_value reads it.
std::string text_of(const Field& field, const std::vector<std::string>& words) {
  if (field.kind == Kind::File) return std::filesystem::absolute(words.front()).string();
  if (field.kind == Kind::Number && field.options.unit == "%" && words.front().ends_with('%'))
    return words.front().substr(0, words.front().size() - 1);
  if (field.kind != Kind::Texts) return fmt::format("{}", fmt::join(words, ","));
  std::vector<std::string> quoted;
  for (const std::string& word : words) {
    for (const std::string& part : scenario::parts_of(word)) quoted.push_back(scenario::value_toml(part));
  }
  return fmt::format("{}", fmt::join(quoted, ","));
}

/// The words of a text that must be numbers.
std::vector<std::string> number_words(const Field& field, const std::string& text) {
  if (field.kind != Kind::Number && field.kind != Kind::Degrees && field.kind != Kind::Numbers) return {};
  std::vector<std::string> words{text};
  if (field.kind == Kind::Numbers && !text.empty()) words = io::formats::words_between_commas(text);
  for (std::string& word : words) {
    word.erase(0, std::min(word.find_first_not_of(' '), word.size()));
    word.erase(word.find_last_not_of(' ') + 1);
  }
  return words;
}

/// Whether what is typed are numbers of the field's kind, so that only their range can be wrong.
bool only_range_can_be_wrong(const Field& field, const std::string& text) {
  if (field.kind != Kind::Integer) return !number_words(field, text).empty();
  const std::optional<double> value = base::parse_number(text);
  return value && *value == std::trunc(*value);
}

const Field* find(const std::vector<Field>& fields, const std::string& key) {
  const auto found = std::find_if(fields.begin(), fields.end(), [&](const Field& field) { return field.key == key; });
  return found == fields.end() ? nullptr : &*found;
}

}  // namespace

void ParameterOptions::add(CLI::App& app, const std::vector<Field>& fields, const std::vector<OptionOf>& wanted) {
  std::vector<OptionOf> all = wanted;
  if (all.empty()) {
    for (const Field& field : fields) all.emplace_back(field.key.c_str());
  }
  for (const OptionOf& one : all) {
    const Field& field = *find(fields, one.key);
    const std::string name = one.name.empty() ? option_of(one.key) : one.name;
    Given& given = *given_.emplace_back(std::make_unique<Given>(Given{one.key, name, {}, false}));
    if (is_switch(field)) {
      app.add_flag(name, given.flag, help_of(field));
      continue;
    }
    CLI::Option* option = app.add_option(name, given.words, help_of(field))->type_name(type_name(field));
    if (field.kind == Kind::Point) {
      option->expected(1, 2);  // "x y" or "x,y"
    } else if (is_list(field)) {
      option->allow_extra_args(false);  // given again for each further one, or "a,b"
    } else {
      option->expected(1);
    }
  }
}

base::Result<scenario::Value> ParameterOptions::value_of(const Field& field, const Given& given) const {
  const auto refuse = [&](base::ErrorCode code, const std::string& what) {
    return base::Error{code, fmt::format("{}: {}", given.option, what)};
  };
  std::string text = text_of(field, given.words);
  std::vector<std::string> numbers;
  for (const std::string& word : number_words(field, text)) {
    const auto number = base::parse_number(word);
    if (!number) return refuse(base::ErrorCode::BadUsage, fmt::format("'{}' is not a number", word));
    numbers.push_back(base::number_text(*number));  // "0.5" of ".5", as scenarios have it
  }
  if (field.kind == Kind::Numbers) text = fmt::format("{}", fmt::join(numbers, ","));
  const bool range = only_range_can_be_wrong(field, text);
  const auto code =
      range && out_of_range_ == OutOfRange::BadValue ? base::ErrorCode::BadValue : base::ErrorCode::BadUsage;
  if (field.kind == Kind::Number && !std::isfinite(*base::parse_number(text))) {
    const std::string rule = scenario::rule_of(field);
    return refuse(code, fmt::format("'{}' is not a finite number{}", text, rule.empty() ? "" : "; it " + rule));
  }
  auto value = scenario::parse_value(field, text);
  if (!value) return refuse(code, value.error().message);
  return value;
}

base::Result<void> ParameterOptions::set(const std::vector<Field>& fields, scenario::Table& params) const {
  for (const auto& given : given_) {
    const Field& field = *find(fields, given->key);
    if (given->flag) {
      params.set(given->key, field.kind == Kind::Flag ? scenario::Value(true) : scenario::Value(std::string("yes")));
    }
    if (given->words.empty()) continue;
    DOBRA_TRY(scenario::Value value, value_of(field, *given));
    params.set(given->key, std::move(value));
  }
  return {};
}

bool ParameterOptions::any() const {
  return std::any_of(given_.begin(), given_.end(),
                     [](const auto& given) { return given->flag || !given->words.empty(); });
}

}  // namespace dobra::cli
