#pragma once
// From TOML text to tables of values with places and comments. The only code that sees toml++.

#include <optional>
#include <string>
#include <vector>

#include "shared/base/result.h"
#include "shared/scenario/value.h"

namespace dobra::scenario {

/// The four parts of a scenario file, not yet judged.
struct ScenarioTables {
  Table top;                   ///< Plain keys before the first table.
  std::optional<Table> input;  ///< [input]
  std::vector<Table> steps;    ///< [[step]]
  std::vector<Table> expects;  ///< [[expect]]
  std::string end_comment;
};

/// @error BadSyntax; UnknownKey for other top-level keys; BadValue for what no parameter can be (dates, tables in
/// tables, mixed lists).
base::Result<ScenarioTables> read_scenario_tables(const std::string& text, const std::string& file);

/// The tables under [[key]] of a file that holds nothing else.
/// @error BadSyntax; UnknownKey for anything else at the top; BadValue as above.
base::Result<std::vector<Table>> read_rows(const std::string& text, const std::string& file, const std::string& key);

/// One value as it would stand behind "key = ".
/// @error BadSyntax, BadValue
base::Result<Value> read_value(const std::string& text);

/// Two comments, one under the other.
std::string joined_comments(const std::string& first, const std::string& second);

}  // namespace dobra::scenario
