#pragma once
// FILE as the sub-commands take it, a scenario or geometry, and which steps of a scenario a sub-command runs.

#include <string>
#include <vector>

#include "shared/cli/commands.h"
#include "shared/cli/line_options.h"

namespace quebra::cli {

struct InputFile {
  dobra::cli::ScenarioOptions scenario;
  dobra::cli::LineOptions lines;
  dobra::cli::ParameterOptions input;  ///< What else [input] says: closed, repair, gap.
};

/// The options of the input; the sub-command adds FILE.
void add_input_options(CLI::App& app, InputFile& file);

/// The scenario with its steps, or a document without steps whose input is the file.
/// @error those of cli::load, ParameterOptions::set and cli::line_options
dobra::base::Result<dobra::scenario::Document> document_of(dobra::cli::Session& session, const InputFile& file);

/// What a sub-command makes of the steps of a scenario, told in one note.
struct StepChanges {
  std::vector<std::string> left_out;  ///< "step 4 (view)"
  std::vector<std::string> added;     ///< "mesh, with its defaults"
};
/// "of FILE: step 4 (view) is left out; added: analyse"; empty if nothing changed.
std::string text_of(const StepChanges& changes, const dobra::scenario::Document& document);

/// Leaves out the steps from number `first` (0-based) on, but those of the operations to keep.
void leave_out_from(dobra::scenario::Document& document, std::size_t first, const std::vector<std::string>& keep,
                    StepChanges& changes);

/// A step with the defaults of its operation.
dobra::scenario::Step step_of(const std::string& operation);

}  // namespace quebra::cli
