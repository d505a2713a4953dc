#include "recon/cli/inversion_commands.h"

#include <CLI/CLI.hpp>
#include <memory>

#include "recon/cli/inversion_json.h"
#include "recon/cli/section_options.h"
#include "recon/inversion/invert_params.h"
#include "recon/inversion/predict_params.h"
#include "shared/cli/commands.h"

namespace recon::cli {

namespace {

namespace scenario = dobra::scenario;
using dobra::cli::Session;

/// Of a command that adds one step to a section and prints what was found.
struct FindingOptions {
  SectionOptions section;
  dobra::cli::ParameterOptions step;
  std::optional<std::filesystem::path> out;
};

using Print = std::string (*)(const core::Model& model);

base::Result<int> finding_job(Session& session, const FindingOptions& options, const char* operation, Print json,
                              Print table) {
  DOBRA_TRY_VOID(check_out(options.out));
  DOBRA_TRY(const scenario::Table lines, options.section.lines.table());
  DOBRA_TRY(scenario::Document document, document_of(session, options.section, lines));
  DOBRA_TRY(scenario::Step step, step_of(session, operation, options.step));
  document.steps = {std::move(step)};
  DOBRA_TRY_VOID(scenario::check(document, session.program));
  DOBRA_TRY(const scenario::Run run, dobra::cli::run_steps(session, document));
  const auto& model = scenario::model_of<core::Model>(run.states.back());
  DOBRA_TRY_VOID(write_out(session, options.out, document, run.states.back(), current_section(model)));
  const bool as_json = session.options.format == dobra::cli::OutputFormat::Json;
  DOBRA_TRY_VOID(dobra::cli::print(as_json ? json(model) : table(model)));
  return 0;
}

template <class Params>
dobra::cli::Command finding_command(const char* name, const char* help, Print json, Print table) {
  return {name, help, [=](CLI::App& app) -> dobra::cli::Job {
            const auto options = std::make_shared<FindingOptions>();
            options->section.add(app, {"horizons_from_units", "colours", "orientation"});
            options->step.add(app, scenario::fields_of<Params>());
            add_out(app, options->out, "the section's lines");
            return [=](Session& session) { return finding_job(session, *options, name, json, table); };
          }};
}

}  // namespace

dobra::cli::Command invert_command() {
  return finding_command<inversion::InvertParams>("invert", "Find the kinematics of a fold from the shapes of its beds",
                                                  inversion_json, inversion_table);
}

dobra::cli::Command predict_command() {
  return finding_command<inversion::PredictParams>(
      "predict", "Predict a fault from a rollover, a rollover over a fault, or the angles of a fold", prediction_json,
      prediction_table);
}

}  // namespace recon::cli
