#include "recon/cli/section_commands.h"

#include <CLI/CLI.hpp>
#include <memory>

#include "recon/balance/area_balance.h"
#include "recon/balance/area_depth.h"
#include "recon/cli/blockwise_json.h"
#include "recon/cli/ledger_json.h"
#include "recon/cli/section_document.h"
#include "recon/cli/section_options.h"
#include "recon/jigsaw/blockwise_params.h"
#include "recon/model/model.h"
#include "recon/unfold/monte_carlo.h"
#include "shared/cli/commands.h"

namespace recon::cli {

namespace {

namespace base = dobra::base;
namespace scenario = dobra::scenario;
using base::Result;
using dobra::cli::Job;
using dobra::cli::ParameterOptions;
using dobra::cli::Session;

/// What restore has for itself.
struct RestoreParams {
  std::string target = "flat";
  bool geometry = false;
  template <class D>
  static void describe(D& d) {
    d.field("target", &RestoreParams::target,
            {.title = "Target", .help = "flat, or a file with the line to restore to."});
    d.field("geometry", &RestoreParams::geometry,
            {.title = "Geometry", .help = "With --json: the restored lines too."});
  }
};

struct RestoreOptions {
  SectionOptions section;
  ParameterOptions grid, target, restore, blocks, errors;
  dobra::cli::OptionsOf<RestoreParams> own;
  std::optional<std::filesystem::path> out;
};

struct BalanceOptions {
  SectionOptions section;
  ParameterOptions by_length, by_area;
};

/// One step, to which grid and target lend their options.
Result<scenario::Step> blockwise_step(Session& session, const RestoreOptions& options, const scenario::Table& lines,
                                      const std::string& target_line) {
  DOBRA_TRY(scenario::Step restore, step_of(session, "restore", options.restore));
  DOBRA_TRY(const scenario::Step blocks, step_of(session, "restore", options.blocks));
  for (const auto& entry : blocks.params.entries()) restore.params.set(entry.key, entry.value);
  const auto refuse = [](const std::string& option) {
    return base::Error{base::ErrorCode::BadUsage, option + " does not go with --block and --jigsaw"};
  };
  DOBRA_TRY(const scenario::Step grid, step_of(session, "grid", options.grid));
  DOBRA_TRY(const scenario::Step target, step_of(session, "target", options.target));
  for (const scenario::Step* step : {&grid, &target}) {
    for (const auto& entry : step->params.entries()) {
      if (entry.key == "uncovered") return refuse("--uncovered");
      restore.params.set(entry.key, entry.value);
    }
  }
  if (target_line != "flat") {
    DOBRA_TRY(std::vector<dobra::geom::Point> line, only_line(target_line, lines));
    restore.params.set("target", std::move(line));
  }
  if (options.errors.any()) {
    return base::Error{
        base::ErrorCode::BadUsage,
        "error bars (--draws and what belongs to it) are drawn of a section as a whole, not with --block "
        "or --jigsaw"};
  }
  return restore;
}

Result<scenario::Document> restore_document(Session& session, const RestoreOptions& options,
                                            const std::string& target_line) {
  DOBRA_TRY(const scenario::Table lines, options.section.lines.table());
  DOBRA_TRY(scenario::Document document, document_of(session, options.section, lines));
  if (options.blocks.any()) {
    DOBRA_TRY(scenario::Step restore, blockwise_step(session, options, lines, target_line));
    document.steps = {std::move(restore)};
    return document;
  }
  DOBRA_TRY(scenario::Step grid, step_of(session, "grid", options.grid));
  DOBRA_TRY(scenario::Step target, step_of(session, "target", options.target));
  DOBRA_TRY(scenario::Step restore, step_of(session, "restore", options.restore));
  if (target_line != "flat") {
    target.params.set("shape", std::string("line"));
    if (document.file.empty()) {
      DOBRA_TRY(std::vector<dobra::geom::Point> line, only_line(target_line, lines));
      target.params.set("points", std::move(line));
    } else {
      target.params.set("file", as_seen_from(document, target_line));
    }
  }
  document.steps = {std::move(grid), std::move(target), std::move(restore)};
  if (options.errors.any()) {
    DOBRA_TRY(scenario::Step errors, step_of(session, "monte_carlo", options.errors));
    document.steps.push_back(std::move(errors));
  }
  return document;
}

Result<int> restore_job(Session& session, const RestoreOptions& options) {
  DOBRA_TRY_VOID(check_out(options.out));
  DOBRA_TRY(const RestoreParams own, options.own.read());
  DOBRA_TRY(const scenario::Document document, restore_document(session, options, own.target));
  DOBRA_TRY_VOID(scenario::check(document, session.program));
  DOBRA_TRY(const scenario::Run run, dobra::cli::run_steps(session, document));
  const auto& model = scenario::model_of<model::Model>(run.states.back());
  DOBRA_TRY_VOID(write_out(session, options.out, document, run.states.back(), current_section(model)));
  const bool as_json = session.options.format == dobra::cli::OutputFormat::Json;
  const Geometry geometry = own.geometry ? Geometry::Include : Geometry::Leave;
  const std::string text = model.blockwise ? (as_json ? blockwise_json(model, geometry) : blockwise_table(model))
                           : as_json       ? restoration_json(model, geometry)
                                           : restoration_table(model);
  DOBRA_TRY_VOID(dobra::cli::print(text));
  return 0;
}

Result<int> balance_job(Session& session, const BalanceOptions& options) {
  const bool by_area = options.by_area.any();
  DOBRA_TRY(scenario::Table lines, options.section.lines.table());
  // Further columns are the errors of the vertices, which the step itself reads.
  if (by_area && lines.find("columns") == nullptr) lines.set("columns", std::string("1,2"));
  DOBRA_TRY(scenario::Document document, document_of(session, options.section, lines));
  DOBRA_TRY(scenario::Step step, by_area ? step_of(session, "area_balance", options.by_area)
                                         : step_of(session, "balance", options.by_length));
  if (by_area) {
    step.params.set("file", as_seen_from(document, options.section.file));
    const scenario::Value* unit = lines.find("unit");
    if (unit != nullptr && *unit != scenario::Value(std::string("file"))) step.params.set("unit", *unit);
  }
  document.steps = {std::move(step)};
  DOBRA_TRY_VOID(scenario::check(document, session.program));
  DOBRA_TRY(const scenario::Run run, dobra::cli::run_steps(session, document));
  const auto& model = scenario::model_of<model::Model>(run.states.back());
  const bool as_json = session.options.format == dobra::cli::OutputFormat::Json;
  DOBRA_TRY_VOID(dobra::cli::print(as_json ? balance_json(model) : balance_table(model)));
  return 0;
}

}  // namespace

dobra::cli::Command restore_command() {
  return {"restore", "Restore a section and draw up its balance ledger", [](CLI::App& app) -> Job {
            const auto options = std::make_shared<RestoreOptions>();
            options->section.add(app, section_keys());
            options->grid.add(app, scenario::fields_of<unfold::GridParams>(), {"top", "simplify", "uncovered"});
            options->restore.add(app, scenario::fields_of<unfold::RestoreParams>());
            options->blocks.add(app, scenario::fields_of<jigsaw::BlockwiseParams>(),
                                {"block", "jigsaw", "constraint", "fit", "cutoff_tolerance"});
            options->target.add(app, scenario::fields_of<unfold::TargetParams>(), {"pin", "elevation", "target_pin"});
            options->errors.add(app, scenario::fields_of<unfold::MonteCarloParams>(),
                                {"draws", "pick_error", "pin_error", "angle_error", "seed"});
            options->own.add(app);
            add_out(app, options->out, "restored lines");
            return [options](Session& session) { return restore_job(session, *options); };
          }};
}

dobra::cli::Command balance_command() {
  return {"balance", "Bed lengths, excess areas and detachment of a section; or its shortening by area",
          [](CLI::App& app) -> Job {
            const auto options = std::make_shared<BalanceOptions>();
            options->section.add(app, {"horizons_from_units", "self_crossings"});
            options->by_length.add(app, scenario::fields_of<balance::BalanceParams>());
            options->by_area.add(app, scenario::fields_of<balance::AreaBalanceParams>(),
                                 {"thickness", "thickness_error", "width_points", "width"});
            return [options](Session& session) { return balance_job(session, *options); };
          }};
}

}  // namespace recon::cli
