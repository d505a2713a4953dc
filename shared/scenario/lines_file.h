#pragma once
// The lines of a document in a file of their own beside it, which the document names (`lines_file`). That file is
// written like a scenario whose [input] has nothing but tables: [[input.horizon]], [[input.curve]] and so on.
// Page: docs/scenario_format.md.

#include "shared/scenario/document.h"

namespace dobra::scenario {

/// "fold.lines.toml" beside "fold.toml"; "lines.toml" for a document that has no file yet.
std::string lines_name(const std::filesystem::path& document);

/// With what the file of lines holds, behind the document's own tables. As it is where it names none.
/// @error those of read_document about that file; BadValue: it holds more than tables of the input, has other units,
/// belongs to another program, or is the document itself.
base::Result<Document> with_lines_read(Document document);

/// What is saved as the document, and as its file of lines. @pre of lines_text: the document names such a file
std::string own_text(const Document& document);
std::string lines_text(const Document& document);

}  // namespace dobra::scenario
