#include "recon/cli/section_commands.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "recon/cli/ledger_json.h"
#include "recon/cli/section_document.h"
#include "recon/core/model.h"
#include "recon/core/report.h"
#include "shared/base/text.h"
#include "shared/cli/commands.h"
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

struct RestoreOptions {
  SectionFile section;
  ParameterOptions grid, target, restore, errors;
  std::string target_file = "flat";
  bool geometry = false;
  std::optional<std::filesystem::path> out;
  std::string colors;
  std::string orientation;
};

struct BalanceOptions {
  SectionFile section;
  ParameterOptions by_length, by_area;
};

void add_section_options(CLI::App& app, SectionFile& options) {
  app.add_option("file", options.file,
                 fmt::format("The section: a scenario (.toml), or lines ({})",
                             fmt::join(io::formats::endings_for(io::formats::Use::ReadLines), " ")))
      ->required()
      ->type_name("FILE");
  dobra::cli::add_line_options(app, options.lines);
  app.add_flag("--horizons-from-units", options.horizons_from_units,
               "Edges that polygons share become horizons, named by the unit below");
}

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

Result<scenario::Document> restore_document(Session& session, const RestoreOptions& options) {
  DOBRA_TRY(scenario::Document document, section_document(session, options.section));
  if (!options.colors.empty()) document.input.set("colours", as_seen_from(document, options.colors));
  if (!options.orientation.empty()) document.input.set("orientation", options.orientation);
  DOBRA_TRY(scenario::Step grid, step_of(session, "grid", options.grid));
  DOBRA_TRY(scenario::Step target, step_of(session, "target", options.target));
  DOBRA_TRY(scenario::Step restore, step_of(session, "restore", options.restore));
  if (options.target_file != "flat") {
    target.params.set("shape", std::string("line"));
    if (document.file.empty()) {
      DOBRA_TRY(std::vector<dobra::geom::Point> line, only_line(options.target_file, options.section.lines));
      target.params.set("points", std::move(line));
    } else {
      target.params.set("file", as_seen_from(document, options.target_file));
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
                     fmt::format("--out {}: give a picture (.svg .pdf .png), a scenario (.toml), or a file of the "
                                 "restored lines ({})",
                                 out.string(), fmt::join(io::formats::endings_for(io::formats::Use::WriteLines), " "))};
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
  DOBRA_TRY(const scenario::Document document, restore_document(session, options));
  DOBRA_TRY_VOID(scenario::check(document, session.program));
  DOBRA_TRY(const scenario::Run run, dobra::cli::run_steps(session, document));
  const auto& model = scenario::model_of<core::Model>(run.states.back());
  if (options.out) DOBRA_TRY_VOID(write_out(session, *options.out, document, run.states.back()));
  const bool as_json = session.options.format == dobra::cli::OutputFormat::Json;
  DOBRA_TRY_VOID(dobra::cli::print(as_json
                                       ? restoration_json(model, options.geometry ? Geometry::Include : Geometry::Leave)
                                       : restoration_table(model)));
  return 0;
}

Result<int> balance_job(Session& session, const BalanceOptions& options) {
  const bool by_area = options.by_area.any();
  SectionFile section = options.section;
  // Further columns are the errors of the vertices, which the step itself reads.
  if (by_area && section.lines.columns.empty()) section.lines.columns = "1,2";
  DOBRA_TRY(scenario::Document document, section_document(session, section));
  DOBRA_TRY(scenario::Step step, by_area ? step_of(session, "area_balance", options.by_area)
                                         : step_of(session, "balance", options.by_length));
  if (by_area) {
    step.params.set("file", as_seen_from(document, section.file));
    if (!section.lines.unit.empty()) step.params.set("unit", section.lines.unit);
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
            add_section_options(app, options->section);
            options->grid.add(app, scenario::fields_of<core::GridParams>(), {"top", "simplify", "uncovered"});
            options->restore.add(app, scenario::fields_of<core::RestoreParams>());
            app.add_option("--target", options->target_file, "flat (default), or a file with the line to restore to")
                ->type_name("flat|FILE");
            options->target.add(app, scenario::fields_of<core::TargetParams>(), {"pin", "elevation", "target_pin"});
            options->errors.add(app, scenario::fields_of<core::MonteCarloParams>(),
                                {"draws", "pick_error", "pin_error", "angle_error", "seed"});
            app.add_flag("--geometry", options->geometry, "With --json: the restored lines too");
            app.add_option("--colours", options->colors,
                           "A table (.csv .toml) of name, colour, pattern, age and lithology of units and lines")
                ->type_name("FILE");
            app.add_option("--orientation", options->orientation,
                           "Compass points over the ends, such as \"W - E\"; told by the plane of lines in space")
                ->type_name("ENDS");
            app.add_option("--out", options->out,
                           fmt::format("Picture (.svg .pdf .png), restored lines ({}) or scenario (.toml) to write",
                                       fmt::join(io::formats::endings_for(io::formats::Use::WriteLines), " ")))
                ->type_name("FILE");
            return [options](Session& session) { return restore_job(session, *options); };
          }};
}

dobra::cli::Command balance_command() {
  return {"balance", "Bed lengths, excess areas and detachment of a section; or its shortening by area",
          [](CLI::App& app) -> Job {
            const auto options = std::make_shared<BalanceOptions>();
            add_section_options(app, options->section);
            options->by_length.add(app, scenario::fields_of<core::BalanceParams>());
            options->by_area.add(app, scenario::fields_of<core::AreaBalanceParams>(),
                                 {"thickness", "thickness_error", "width_points", "width"});
            return [options](Session& session) { return balance_job(session, *options); };
          }};
}

}  // namespace recon::cli
