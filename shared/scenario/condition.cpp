#include "shared/scenario/condition.h"

#include <fmt/format.h>

#include <algorithm>

#include "shared/base/text.h"

namespace dobra::scenario {
namespace {

std::vector<std::string> split_at(std::string_view text, std::string_view between) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(between, begin), text.size());
    parts.emplace_back(base::trimmed(text.substr(begin, end - begin)));
    begin = end + between.size();
  }
  return parts;
}

Requirement requirement_of(const std::string& text) {
  if (text.ends_with(" is set")) return {text.substr(0, text.size() - 7), Requirement::Is::Set, {}};
  for (const auto& [sign, is] : {std::pair{" != ", Requirement::Is::NoneOf},
                                 {" not in ", Requirement::Is::NoneOf},
                                 {" = ", Requirement::Is::OneOf},
                                 {" in ", Requirement::Is::OneOf}}) {
    const std::size_t at = text.find(sign);
    if (at == std::string::npos) continue;
    return {text.substr(0, at), is, split_at(std::string_view(text).substr(at + std::string_view(sign).size()), ", ")};
  }
  return {text, Requirement::Is::OneOf, {}};
}

const Field* find_field(const std::string& key, const std::vector<Field>& fields) {
  const auto found = std::find_if(fields.begin(), fields.end(), [&](const Field& field) { return field.key == key; });
  return found == fields.end() ? nullptr : &*found;
}

struct WordOf {
  std::string operator()(bool flag) const { return flag ? "true" : "false"; }
  std::string operator()(const std::string& text) const { return text; }
  template <class T>
  std::string operator()(const T& value) const {
    return value_text(value);
  }
};

struct IsSaid {
  bool operator()(const std::string& text) const { return !text.empty(); }
  template <class T>
  bool operator()(const std::vector<T>& list) const {
    return !list.empty();
  }
  template <class T>
  bool operator()(const T&) const {
    return true;
  }
};

/// A field may hang on one that hangs on another; descriptions go no deeper.
constexpr int deepest = 8;

std::optional<Requirement> first_unmet(const Field& field, const Table& table, const std::vector<Field>& fields,
                                       int depth) {
  const auto met = [&](const Requirement& requirement) {
    const Field* other = find_field(requirement.key, fields);
    if (other == nullptr || depth == deepest || first_unmet(*other, table, fields, depth + 1)) return false;
    if (requirement.is == Requirement::Is::Set) {
      const Value* value = table.find(requirement.key);
      return value != nullptr && std::visit(IsSaid{}, *value);
    }
    const std::optional<std::string> word = word_of(requirement.key, table, fields);
    const bool listed =
        word && std::find(requirement.words.begin(), requirement.words.end(), *word) != requirement.words.end();
    return listed == (requirement.is == Requirement::Is::OneOf);
  };
  std::optional<Requirement> first;
  for (const std::vector<Requirement>& all : condition_of(field.options.when)) {
    const auto lacking = std::find_if_not(all.begin(), all.end(), met);
    if (lacking == all.end()) return std::nullopt;
    if (!first) first = *lacking;
  }
  return first;
}

void tell_faults(const Requirement& requirement, const Field& field, const std::vector<Field>& fields,
                 std::vector<std::string>& faults) {
  const Field* other = find_field(requirement.key, fields);
  const auto fault = [&](const std::string& what) { faults.push_back(fmt::format("'{}': {}", field.key, what)); };
  if (other == nullptr) return fault(fmt::format("there is no field '{}'", requirement.key));
  if (other == &field) return fault("it hangs on itself");
  if (requirement.is == Requirement::Is::Set) return;
  std::vector<std::string> choices = other->choices;
  if (other->kind == Kind::Flag) choices = {"true", "false"};
  if (requirement.words.empty()) fault(fmt::format("it says nothing of '{}'", requirement.key));
  for (const std::string& word : requirement.words) {
    if (std::find(choices.begin(), choices.end(), word) == choices.end())
      fault(fmt::format("'{}' is no choice of '{}'", word, requirement.key));
  }
}

}  // namespace

Condition condition_of(std::string_view text) {
  Condition condition;
  if (base::trimmed(text).empty()) return condition;
  for (const std::string& one : split_at(text, " or ")) {
    condition.emplace_back();
    for (const std::string& part : split_at(one, " and ")) condition.back().push_back(requirement_of(part));
  }
  return condition;
}

std::optional<Requirement> unmet(const Field& field, const Table& table, const std::vector<Field>& fields) {
  return first_unmet(field, table, fields, 0);
}

std::optional<std::string> word_of(const std::string& key, const Table& table, const std::vector<Field>& fields) {
  if (const Value* value = table.find(key)) return std::visit(WordOf{}, *value);
  const Field* field = find_field(key, fields);
  if (field == nullptr || !field->default_value) return std::nullopt;
  return std::visit(WordOf{}, *field->default_value);
}

std::vector<std::string> without_effect(const Table& table, const std::vector<Field>& fields) {
  std::vector<std::string> told;
  for (const Field& field : fields) {
    const Value* value = table.find(field.key);
    if (value == nullptr) continue;
    if (const auto* rows = std::get_if<std::vector<Table>>(value)) {
      for (std::size_t i = 0; i < rows->size(); ++i) {
        for (const std::string& inner : without_effect((*rows)[i], field.fields))
          told.push_back(fmt::format("{} {}: {}", field.key, i + 1, inner));
      }
    }
    const std::optional<Requirement> lacking = unmet(field, table, fields);
    if (!lacking) continue;
    const std::optional<std::string> word = word_of(lacking->key, table, fields);
    const bool without = lacking->is == Requirement::Is::Set || !word;
    told.push_back(without ? fmt::format("'{}' has no effect without {}", field.key, lacking->key)
                           : fmt::format("'{}' has no effect with {} = {}", field.key, lacking->key, *word));
  }
  return told;
}

std::vector<std::string> condition_faults(const std::vector<Field>& fields) {
  std::vector<std::string> faults;
  for (const Field& field : fields) {
    for (const std::vector<Requirement>& all : condition_of(field.options.when)) {
      for (const Requirement& one : all) tell_faults(one, field, fields, faults);
    }
    const std::vector<std::string> units = split_at(field.options.unit, ", ");
    for (std::size_t i = 1; i < units.size(); ++i) {
      const std::vector<std::string> parts = split_at(units[i], " if ");
      tell_faults(requirement_of(parts.back()), field, fields, faults);
    }
    for (const std::string& inner : condition_faults(field.fields))
      faults.push_back(fmt::format("{}, {}", field.key, inner));
  }
  return faults;
}

}  // namespace dobra::scenario
