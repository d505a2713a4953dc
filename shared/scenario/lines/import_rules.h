#pragma once
// What all programs do alike when a file is brought into a document: kinds by patterns of names, the first rows of a
// text, the path that is written. Page: docs/user/import.md.

#include <string>
#include <vector>

#include "shared/io/formats/line_files.h"
#include "shared/scenario/importing.h"

namespace dobra::scenario::lines {

/// The choices that the rules and the look give: of a line that no rule fits, what it seems to be. A rule whose kind is
/// not for the shape of a line does not count for it. What cannot be taken is not.
std::vector<ImportChoice> choices_by(const std::vector<ImportRule>& rules, const ImportLook& look,
                                     const std::vector<Importing::Kind>& kinds);

/// "NAME=KIND": the rules that give every line the kind of its choice, as few as it takes. First exact names, for what
/// the others do not give; then those of the user that still give something; last one for lines without a name.
std::vector<std::string> rules_for(const ImportLook& look, const ImportFile& file);

/// A kind that words of the name speak of: "Falha F3", "main_thrust", "Topo 2"; nothing where none does.
std::optional<std::string> kind_by_words(const std::string& name);

/// The first rows of a text, as the reading takes them; nothing of a file that is no text.
std::optional<ImportTable> table_of(const std::string& path, const ImportReading& reading);

/// The path as the document writes it: relative to its folder, where it has one.
std::string import_path(const Document& document, const std::filesystem::path& file);

/// The name of the file without folder and ending.
std::string stem_of(const std::filesystem::path& file);

/// Of a text: the columns that are told, or the default ones where a name column alone is told; empty: none.
std::vector<std::string> columns_by(const ImportReading& reading);

}  // namespace dobra::scenario::lines
