#include "recon/cli/one_step.h"

#include <CLI/CLI.hpp>
#include <memory>

#include "recon/cli/section_options.h"
#include "shared/cli/commands.h"

namespace recon::cli {

namespace {

namespace scenario = dobra::scenario;
using dobra::cli::Session;

struct OneStepOptions {
  SectionOptions section;
  dobra::cli::ParameterOptions step;
  std::optional<std::filesystem::path> out;
};

base::Result<int> one_step_job(Session& session, const OneStepOptions& options, const char* operation, Print json,
                               Print table) {
  DOBRA_TRY_VOID(check_out(options.out));
  DOBRA_TRY(const scenario::Table lines, options.section.lines.table());
  DOBRA_TRY(scenario::Document document, document_of(session, options.section, lines));
  DOBRA_TRY(scenario::Step step, step_of(session, operation, options.step));
  document.steps = {std::move(step)};
  DOBRA_TRY_VOID(scenario::check(document, session.program));
  DOBRA_TRY(const scenario::Run run, dobra::cli::run_steps(session, document));
  const auto& model = scenario::model_of<model::Model>(run.states.back());
  DOBRA_TRY_VOID(write_out(session, options.out, document, run.states.back(), current_section(model)));
  const bool as_json = session.options.format == dobra::cli::OutputFormat::Json;
  DOBRA_TRY_VOID(dobra::cli::print(as_json ? json(model) : table(model)));
  return 0;
}

}  // namespace

dobra::cli::Command one_step_command(const char* name, const char* help, std::vector<scenario::Field> fields,
                                     Print json, Print table) {
  return {name, help, [=](CLI::App& app) -> dobra::cli::Job {
            const auto options = std::make_shared<OneStepOptions>();
            options->section.add(app, section_keys());
            options->step.add(app, fields);
            add_out(app, options->out, "the section's lines");
            return [=](Session& session) { return one_step_job(session, *options, name, json, table); };
          }};
}

}  // namespace recon::cli
