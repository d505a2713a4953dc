#pragma once
// Which fields of a table matter: the small language of FieldOptions::when. A condition is made of requirements of
// other fields of the same table, "method = shear", "kind in arc, circle", "outside != refuse", "file is set", joined
// by "and", and these by "or", which binds less. Flags are true or false. Units that go by a choice ("Pa, N if kind =
// force") name their fields in the same way.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shared/scenario/field.h"

namespace dobra::scenario {

/// What a condition asks of one field.
struct Requirement {
  std::string key;
  enum class Is { OneOf, NoneOf, Set } is = Is::OneOf;
  std::vector<std::string> words;  ///< OneOf and NoneOf: choices, or true and false.
  bool operator==(const Requirement&) const = default;
};

/// Any of these, each with all of its requirements; empty: always.
using Condition = std::vector<std::vector<Requirement>>;

/// Reads a condition. What cannot be read becomes a requirement of a field of that name, which condition_faults tells.
Condition condition_of(std::string_view text);

/// The first requirement of `field` that the table does not meet; nothing if the field matters. A field that does not
/// matter itself meets nothing.
std::optional<Requirement> unmet(const Field& field, const Table& table, const std::vector<Field>& fields);

/// The value of `key` in the table, or its default, as a condition writes it; nothing if there is neither.
std::optional<std::string> word_of(const std::string& key, const Table& table, const std::vector<Field>& fields);

/// What is set and has no effect, those in tables of tables too: "'angle' has no effect with method = constant".
std::vector<std::string> without_effect(const Table& table, const std::vector<Field>& fields);

/// What is wrong with the conditions of fields, and with their units that go by a choice: fields and choices that there
/// are not. For tests of descriptions; empty if all is well.
std::vector<std::string> condition_faults(const std::vector<Field>& fields);

}  // namespace dobra::scenario
