#pragma once
// Edits of a document as pure functions: each takes a document and gives another. Part 0 is the input, part k is step
// k.

#include <filesystem>

#include "shared/scenario/program.h"

namespace dobra::gui::documents {

/// The parameters of part 0 (input) or of step `part`. @pre part <= document.steps.size()
const scenario::Table& table_of(const scenario::Document& document, std::size_t part);

/// The fields of the same; empty for an operation that the program does not have.
std::vector<scenario::Field> fields_of(const scenario::Document& document, const scenario::Program& program,
                                       std::size_t part);

/// With other parameters in one part.
scenario::Document with_table(scenario::Document document, std::size_t part, scenario::Table table);

/// With a new step of the operation behind part `after`, all its parameters left at their defaults.
scenario::Document with_step(scenario::Document document, std::size_t after, const std::string& operation);

/// @pre 1 <= step <= document.steps.size()
scenario::Document without_step(scenario::Document document, std::size_t step);

/// With steps `step` and `step` + 1 exchanged. @pre 1 <= step < document.steps.size()
scenario::Document with_step_lowered(scenario::Document document, std::size_t step);

/// The document as it must read to mean the same at another place: relative file names start at the new folder, and a
/// file of lines is called after the new one.
scenario::Document at_file(scenario::Document document, const scenario::Program& program,
                           const std::filesystem::path& file);

/// With its lines saved in a file beside it, under a name that is free, or in the document itself. A file that was
/// beside it stays where it is.
scenario::Document with_lines_beside(scenario::Document document, bool beside);

/// The files that the input of `before` names and that of `after` does not, as they are written.
std::vector<std::string> files_left(const scenario::Document& before, const scenario::Document& after,
                                    const scenario::Program& program);

/// Nothing to run yet, and nothing wrong either. Steps may wait for an input.
bool is_blank(const scenario::Document& document, const scenario::Program& program);

/// A document of the program with nothing in it.
scenario::Document empty_document(const scenario::Program& program);

}  // namespace dobra::gui::documents
