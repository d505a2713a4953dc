#include "recon/cli/move_commands.h"

#include <CLI/CLI.hpp>
#include <memory>

#include "recon/cli/move_json.h"
#include "recon/cli/section_options.h"
#include "recon/model/model.h"
#include "recon/moving/move_params.h"
#include "shared/cli/commands.h"

namespace recon::cli {

namespace {

namespace scenario = dobra::scenario;
using base::Result;
using dobra::cli::Job;
using dobra::cli::ParameterOptions;
using dobra::cli::Session;

/// What move has for itself.
struct MoveOutput {
  bool geometry = false;
  template <class D>
  static void describe(D& d) {
    d.field("geometry", &MoveOutput::geometry,
            {.title = "Geometry", .help = "With --json: what moved, and the whole section after it."});
  }
};

struct MoveOptions {
  SectionOptions section;
  ParameterOptions move;
  dobra::cli::OptionsOf<MoveOutput> own;
  std::optional<std::filesystem::path> out;
};

Result<int> move_job(Session& session, const MoveOptions& options) {
  DOBRA_TRY_VOID(check_out(options.out));
  DOBRA_TRY(const MoveOutput own, options.own.read());
  DOBRA_TRY(const scenario::Table lines, options.section.lines.table());
  DOBRA_TRY(scenario::Document document, document_of(session, options.section, lines));
  DOBRA_TRY(scenario::Step step, step_of(session, "move", options.move));
  document.steps = {std::move(step)};
  DOBRA_TRY_VOID(scenario::check(document, session.program));
  DOBRA_TRY(const scenario::Run run, dobra::cli::run_steps(session, document));
  const auto& model = scenario::model_of<model::Model>(run.states.back());
  DOBRA_TRY_VOID(write_out(session, options.out, document, run.states.back(), current_section(model)));
  const bool as_json = session.options.format == dobra::cli::OutputFormat::Json;
  DOBRA_TRY_VOID(dobra::cli::print(as_json ? move_json(model, own.geometry ? Geometry::Include : Geometry::Leave)
                                           : move_table(model)));
  return 0;
}

}  // namespace

dobra::cli::Command move_command() {
  return {"move", "Move blocks of a section along a fault, back or forward", [](CLI::App& app) -> Job {
            const auto options = std::make_shared<MoveOptions>();
            options->section.add(app, section_keys());
            options->move.add(app, scenario::fields_of<moving::MoveParams>());
            options->own.add(app);
            add_out(app, options->out, "lines of the section after the move");
            return [options](Session& session) { return move_job(session, *options); };
          }};
}

}  // namespace recon::cli
