#pragma once
// The sub-commands that both programs have, and the parts of them that a program's own sub-commands need too.

#include <filesystem>
#include <string>
#include <vector>

#include "shared/cli/cli.h"
#include "shared/scenario/runner.h"

namespace dobra::cli {

/// run FILE --out DIR: runs a scenario and writes report.json, tables, exchange files and pictures.
Command run_command();
/// render FILE --out PICTURE: runs a scenario and draws its last state.
Command render_command();
/// operations [NAME]: what a scenario can do, and with which parameters.
Command operations_command();

/// FILE and --set, as `run` has them.
struct ScenarioOptions {
  std::filesystem::path file;
  bool si = false;  ///< Results in SI.
  std::vector<std::string> assignments;
};
void add_scenario_options(CLI::App& app, ScenarioOptions& options);
/// --set alone.
void add_assignment_option(CLI::App& app, ScenarioOptions& options);

/// Reads the document, applies the assignments and judges all of it.
base::Result<scenario::Document> load(Session& session, const ScenarioOptions& options);

/// Runs the steps, with progress, up to the one that fails; notes the remarks of the last state of a run that came to
/// its end.
scenario::Run run_as_far_as_it_goes(Session& session, const scenario::Document& document);

/// The same, where nothing less than all steps will do.  @error that of the step which failed.
base::Result<scenario::Run> run_steps(Session& session, const scenario::Document& document);

/// Notes the remarks of a state; its quantities as details.
void tell(Session& session, const scenario::State& state);

}  // namespace dobra::cli
