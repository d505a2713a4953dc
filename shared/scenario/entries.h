#pragma once
// Named tables of a document, such as [[input.horizon]], as edits in a window change them.

#include <string>
#include <vector>

#include "shared/base/error.h"
#include "shared/geom/point.h"
#include "shared/scenario/value.h"

namespace dobra::scenario {

using Entries = std::vector<Table>;

/// The tables under a key; none if there are none.
Entries entries_of(const Table& input, const std::string& key);
/// Puts them there; none: the key goes.
void set_entries(Table& input, const std::string& key, Entries entries);
/// The first whose key `name` says so, or the end.
Entries::iterator entry_named(Entries& entries, const std::string& name);
/// "A (2)", or the next number that no entry has.
std::string free_name(Entries& entries, const std::string& whole);
/// The text, or the points, of a key; empty where there are none.
std::string text_in(const Table& entry, std::string_view key);
std::vector<geom::Point> points_in(const Table& entry);

/// BadValue about the entry `name`, whose message is translated.
base::Error edit_refused(const std::string& name, const char* why);

}  // namespace dobra::scenario
