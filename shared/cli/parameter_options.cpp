#include "shared/cli/parameter_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "shared/base/text.h"
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

std::string help_of(const Field& field) {
  std::string text = field.options.title;
  if (*field.options.help != '\0') text += fmt::format(". {}", field.options.help);
  if (text.ends_with('.')) text.pop_back();
  return fmt::format("{} ({})", text, scenario::field_summary(field));
}

/// What the user typed as scenario::parse_value reads it.
std::string text_of(const Field& field, const std::vector<std::string>& words) {
  if (field.kind == Kind::File) return std::filesystem::absolute(words.front()).string();
  if (field.kind != Kind::Texts) return fmt::format("{}", fmt::join(words, ","));
  std::vector<std::string> quoted;
  for (const std::string& word : words) quoted.push_back(scenario::value_toml(word));
  return fmt::format("{}", fmt::join(quoted, ","));
}

/// Whether the text is a number of the field's kind, so that only its range can be wrong.
bool is_number(const Field& field, const std::string& text) {
  if (field.kind != Kind::Integer && field.kind != Kind::Number && field.kind != Kind::Degrees) return false;
  const std::optional<double> value = base::parse_number(text);
  return value && (field.kind != Kind::Integer || *value == std::trunc(*value));
}

const Field* find(const std::vector<Field>& fields, const std::string& key) {
  const auto found = std::find_if(fields.begin(), fields.end(), [&](const Field& field) { return field.key == key; });
  return found == fields.end() ? nullptr : &*found;
}

}  // namespace

void ParameterOptions::add(CLI::App& app, const std::vector<Field>& fields, const std::vector<std::string>& keys) {
  std::vector<std::string> wanted = keys;
  if (wanted.empty()) {
    for (const Field& field : fields) wanted.push_back(field.key);
  }
  for (const std::string& key : wanted) {
    const Field& field = *find(fields, key);
    Given& given = *given_.emplace_back(std::make_unique<Given>(Given{key, {}, false}));
    if (field.kind == Kind::Flag) {
      app.add_flag(option_of(key), given.flag, help_of(field));
      continue;
    }
    CLI::Option* option = app.add_option(option_of(key), given.words, help_of(field))->type_name(type_name(field));
    if (field.kind == Kind::Point) {
      option->expected(1, 2);  // "x y" or "x,y"
    } else if (field.kind == Kind::Numbers || field.kind == Kind::Texts) {
      option->allow_extra_args(false);  // given again for each further one, or "a,b"
    } else {
      option->expected(1);
    }
  }
}

base::Result<void> ParameterOptions::set(const std::vector<Field>& fields, scenario::Table& params) const {
  for (const auto& given : given_) {
    if (given->flag) params.set(given->key, true);
    if (given->words.empty()) continue;
    const Field& field = *find(fields, given->key);
    const std::string text = text_of(field, given->words);
    auto value = scenario::parse_value(field, text);
    if (!value) {
      return base::Error{is_number(field, text) ? base::ErrorCode::BadValue : base::ErrorCode::BadUsage,
                         fmt::format("{}: {}", option_of(given->key), value.error().message)};
    }
    params.set(given->key, std::move(*value));
  }
  return {};
}

bool ParameterOptions::any() const {
  return std::any_of(given_.begin(), given_.end(),
                     [](const auto& given) { return given->flag || !given->words.empty(); });
}

}  // namespace dobra::cli
