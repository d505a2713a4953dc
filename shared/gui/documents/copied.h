#pragma once
// Parts of a document as text that others can use: a step for another scenario, the command line that does the same.

#include <optional>
#include <string>

#include "shared/scenario/program.h"

namespace dobra::gui::documents {

/// Part 0 (the input) or step `part` as a scenario writes it, from its comment and table head on.
/// @pre part <= document.steps.size()
std::string part_text(const scenario::Document& document, std::size_t part);

/// With the steps of `text` behind part `after`; `text` is that of steps, or of a whole scenario.
/// @pre after <= document.steps.size()
/// @error BadSyntax and those of parse_document, with the line of the text; BadValue where it has no step, or numbers
/// in other units; UnknownOperation, and those of scenario::check, for what the program does not take
base::Result<scenario::Document> with_pasted(scenario::Document document, const scenario::Program& program,
                                             std::size_t after, const std::string& text);

/// "recon run FILE --out FILE_results", with --set for each value in which the document differs from what `file` holds.
/// Where that cannot say all of it a line before says that the document has to be saved first.
/// @param on_disk  what the document's file holds. @pre document.file is not empty
std::string command_of(const scenario::Document& document, const scenario::Program& program,
                       const std::optional<scenario::Document>& on_disk);

}  // namespace dobra::gui::documents
