#pragma once
// The canonical TOML text of values and tables: one way of writing each, so that saving what was read changes no byte.

#include <string>

#include "shared/scenario/value.h"

namespace dobra::scenario {

/// The text of a value on one line; tables become inline tables.
std::string value_toml(const Value& value);

/// `key = value` lines in the written order with their comments, then nested [[path.key]] tables. Lists that do not fit
/// 120 columns are wrapped, several items a line.
/// @param path  of the table itself, such as "input"; starts the names of nested tables.
std::string table_toml(const Table& table, const std::string& path);

/// One `key = value` line (or several for a long list), newline included.
std::string entry_toml(const std::string& key, const Value& value);

/// "# " before each line, newline after each; nothing for an empty comment.
std::string comment_toml(const std::string& comment);

}  // namespace dobra::scenario
