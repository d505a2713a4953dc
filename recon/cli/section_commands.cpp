#include "recon/cli/section_commands.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "recon/balance/area_balance.h"
#include "recon/balance/area_depth.h"
#include "recon/cli/ledger_json.h"
#include "recon/cli/section_document.h"
#include "recon/core/model.h"
#include "recon/core/report.h"
#include "recon/input/section_input.h"
#include "recon/unfold/monte_carlo.h"
#include "shared/base/text.h"
#include "shared/cli/commands.h"
#include "shared/cli/line_options.h"
#include "shared/cli/parameter_options.h"
#include "shared/cli/pictures.h"
#include "shared/cli/staging.h"
#include "shared/io/formats/line_files.h"

namespace recon::cli {

namespace {

namespace base = dobra::base;
namespace io = dobra::io;
namespace scenario = dobra::scenario;
using base::Result;
using dobra::cli::Job;
using dobra::cli::ParameterOptions;
using dobra::cli::Session;

/// The file, how its lines are read, and what else [input] says of the section.
struct SectionOptions {
  std::string file;
  dobra::cli::LineOptions lines;
  ParameterOptions input;

  void add(CLI::App& app, const std::vector<dobra::cli::OptionOf>& input_keys) {
    app.add_option("file", file,
                   fmt::format("The section: a scenario (.toml), or lines ({})",
                               fmt::join(io::formats::endings_for(io::formats::Use::ReadLines), " ")))
        ->required()
        ->type_name("FILE");
    lines.add(app, dobra::cli::LineOptions::Repairs::Offered);
    input.add(app, scenario::fields_of<input::SectionInput>(), input_keys);
  }
};

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
  ParameterOptions grid, target, restore, errors;
  dobra::cli::OptionsOf<RestoreParams> own;
  std::optional<std::filesystem::path> out;
};

struct BalanceOptions {
  SectionOptions section;
  ParameterOptions by_length, by_area;
};

/// A file name as the scenario will look for it, whose names start from the folder of the section's file.
std::string as_seen_from(const scenario::Document& document, const std::string& file) {
  if (document.folder().empty()) return file;
  std::error_code ignored;
  const auto relative = std::filesystem::proximate(file, document.folder(), ignored);
  return ignored ? file : relative.string();
}

/// A step of the operation with what the options say.
Result<scenario::Step> step_of(const Session& session, const char* operation, const ParameterOptions& options) {
  scenario::Step step{operation, "", {}, "", {}};
  DOBRA_TRY_VOID(options.set(session.program.find_operation(operation)->fields, step.params));
  return step;
}

/// @param lines  as the options of the section say.
Result<scenario::Document> document_of(Session& session, const SectionOptions& options, const scenario::Table& lines) {
  scenario::Table input;
  DOBRA_TRY_VOID(options.input.set(session.program.input_fields, input));
  DOBRA_TRY(scenario::Document document, section_document(session, {options.file, lines}));
  for (const auto& entry : input.entries()) {
    const auto* name = std::get_if<std::string>(&entry.value);
    document.input.set(entry.key,
                       entry.key == "colours" ? scenario::Value(as_seen_from(document, *name)) : entry.value);
  }
  return document;
}

Result<scenario::Document> restore_document(Session& session, const RestoreOptions& options,
                                            const std::string& target_line) {
  DOBRA_TRY(const scenario::Table lines, options.section.lines.table());
  DOBRA_TRY(scenario::Document document, document_of(session, options.section, lines));
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

/// What --out is, by its ending.
enum class OutKind { Scenario, Picture, Lines };

Result<OutKind> out_kind(const std::filesystem::path& out) {
  if (out.extension() == ".toml") return OutKind::Scenario;
  if (dobra::cli::check_ending(out, dobra::cli::Drawer::Cairo)) return OutKind::Picture;
  if (io::formats::line_format_of(out.string())) return OutKind::Lines;
  return base::Error{base::ErrorCode::BadUsage,
                     fmt::format("--out {}: give a picture ({}), a scenario (.toml), or a file of the "
                                 "restored lines ({})",
                                 out.string(), dobra::cli::picture_endings(),
                                 fmt::join(io::formats::endings_for(io::formats::Use::WriteLines), " "))};
}

/// A picture, the scenario itself to go on with, or the restored lines.
Result<void> write_out(Session& session, const std::filesystem::path& out, scenario::Document document,
                       const scenario::State& state) {
  DOBRA_TRY(const OutKind kind, out_kind(out));
  DOBRA_TRY(dobra::cli::Staging staging,
            dobra::cli::Staging::open(out.parent_path(), dobra::cli::TargetFolder::MustExist));
  const auto path = staging.path(out.filename().string());
  std::vector<std::string> losses;
  Result<void> written;
  if (kind == OutKind::Scenario) {
    written = scenario::write_document(document, path);
  } else if (kind == OutKind::Picture) {
    written =
        dobra::cli::draw(dobra::cli::picture_of(session.program, document, state), path, dobra::cli::Drawer::Cairo);
  } else {
    io::formats::LineWork work;
    work.features = core::restored_features(scenario::model_of<core::Model>(state).restoration->section);
    written = io::formats::write_any_lines(path.string(), work, {}, losses);
  }
  if (!written) return staging.for_user(written.error());
  for (const std::string& loss : losses) session.note(loss);
  DOBRA_TRY_VOID(session.check());
  DOBRA_TRY_VOID(staging.commit());
  return {};
}

Result<int> restore_job(Session& session, const RestoreOptions& options) {
  if (options.out) {
    DOBRA_TRY_VOID(out_kind(*options.out));
    DOBRA_TRY_VOID(dobra::cli::check_writable(*options.out));
  }
  DOBRA_TRY(const RestoreParams own, options.own.read());
  DOBRA_TRY(const scenario::Document document, restore_document(session, options, own.target));
  DOBRA_TRY_VOID(scenario::check(document, session.program));
  DOBRA_TRY(const scenario::Run run, dobra::cli::run_steps(session, document));
  const auto& model = scenario::model_of<core::Model>(run.states.back());
  if (options.out) DOBRA_TRY_VOID(write_out(session, *options.out, document, run.states.back()));
  const bool as_json = session.options.format == dobra::cli::OutputFormat::Json;
  DOBRA_TRY_VOID(dobra::cli::print(as_json ? restoration_json(model, own.geometry ? Geometry::Include : Geometry::Leave)
                                           : restoration_table(model)));
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
  const auto& model = scenario::model_of<core::Model>(run.states.back());
  const bool as_json = session.options.format == dobra::cli::OutputFormat::Json;
  DOBRA_TRY_VOID(dobra::cli::print(as_json ? balance_json(model) : balance_table(model)));
  return 0;
}

}  // namespace

dobra::cli::Command restore_command() {
  return {"restore", "Restore a section and draw up its balance ledger", [](CLI::App& app) -> Job {
            const auto options = std::make_shared<RestoreOptions>();
            options->section.add(app, {"horizons_from_units", "colours", "orientation"});
            options->grid.add(app, scenario::fields_of<unfold::GridParams>(), {"top", "simplify", "uncovered"});
            options->restore.add(app, scenario::fields_of<unfold::RestoreParams>());
            options->target.add(app, scenario::fields_of<unfold::TargetParams>(), {"pin", "elevation", "target_pin"});
            options->errors.add(app, scenario::fields_of<unfold::MonteCarloParams>(),
                                {"draws", "pick_error", "pin_error", "angle_error", "seed"});
            options->own.add(app);
            app.add_option("--out", options->out,
                           fmt::format("Picture ({}), restored lines ({}) or scenario (.toml) to write",
                                       dobra::cli::picture_endings(),
                                       fmt::join(io::formats::endings_for(io::formats::Use::WriteLines), " ")))
                ->type_name("FILE");
            return [options](Session& session) { return restore_job(session, *options); };
          }};
}

dobra::cli::Command balance_command() {
  return {"balance", "Bed lengths, excess areas and detachment of a section; or its shortening by area",
          [](CLI::App& app) -> Job {
            const auto options = std::make_shared<BalanceOptions>();
            options->section.add(app, {"horizons_from_units"});
            options->by_length.add(app, scenario::fields_of<balance::BalanceParams>());
            options->by_area.add(app, scenario::fields_of<balance::AreaBalanceParams>(),
                                 {"thickness", "thickness_error", "width_points", "width"});
            return [options](Session& session) { return balance_job(session, *options); };
          }};
}

}  // namespace recon::cli
