#include "recon/cli/fault_commands.h"

#include <CLI/CLI.hpp>
#include <memory>

#include "recon/cli/faults_json.h"
#include "recon/cli/section_options.h"
#include "recon/faults/report.h"
#include "shared/cli/commands.h"

namespace recon::cli {

namespace {

struct FaultsOptions {
  SectionOptions section;
  dobra::cli::ParameterOptions faults;
  std::optional<std::filesystem::path> out;
};

base::Result<int> faults_job(dobra::cli::Session& session, const FaultsOptions& options) {
  DOBRA_TRY_VOID(check_out(options.out));
  DOBRA_TRY(const dobra::scenario::Table lines, options.section.lines.table());
  DOBRA_TRY(dobra::scenario::Document document, document_of(session, options.section, lines));
  DOBRA_TRY(dobra::scenario::Step step, step_of(session, "faults", options.faults));
  document.steps = {std::move(step)};
  DOBRA_TRY_VOID(dobra::scenario::check(document, session.program));
  DOBRA_TRY(const dobra::scenario::Run run, dobra::cli::run_steps(session, document));
  const auto& model = dobra::scenario::model_of<core::Model>(run.states.back());
  DOBRA_TRY_VOID(write_out(session, options.out, document, run.states.back(), model.section));
  const bool as_json = session.options.format == dobra::cli::OutputFormat::Json;
  DOBRA_TRY_VOID(dobra::cli::print(as_json ? faults_json(model) : faults_table(model)));
  return 0;
}

}  // namespace

dobra::cli::Command faults_command() {
  return {"faults", "Cutoffs and displacement along the faults of a section, and its blocks",
          [](CLI::App& app) -> dobra::cli::Job {
            const auto options = std::make_shared<FaultsOptions>();
            options->section.add(app, {"horizons_from_units", "colours", "orientation"});
            options->faults.add(app, dobra::scenario::fields_of<faults::FaultsParams>());
            add_out(app, options->out, "the section's lines");
            return [options](dobra::cli::Session& session) { return faults_job(session, *options); };
          }};
}

}  // namespace recon::cli
