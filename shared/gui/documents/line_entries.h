#pragma once
// The names and kinds of the lines that a document holds, as pure functions of the document.

#include <optional>
#include <string>

#include "shared/scenario/program.h"

namespace dobra::gui::documents {

/// The table of a kind that the program draws ("horizon") in which exactly one line is called so; nothing if none is.
std::optional<std::string> table_of_line(const scenario::Document& document, const scenario::Program& program,
                                         const std::string& name);

/// The line with another name, also where steps and other lines name it.
/// @error BadValue: no such line, an empty name, or one that another line of the table has.
base::Result<scenario::Document> with_line_renamed(scenario::Document document, const scenario::Program& program,
                                                   const std::string& table, const std::string& name,
                                                   const std::string& to);

/// The line in another table, behind its lines. What lines of that kind have no key for is left out.
/// @error BadValue: no such line, or its name is taken there.
base::Result<scenario::Document> with_line_of_kind(scenario::Document document, const scenario::Program& program,
                                                   const std::string& table, const std::string& name,
                                                   const std::string& to);

}  // namespace dobra::gui::documents
