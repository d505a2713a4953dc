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
#include "shared/cli/pictures.h"
#include "shared/cli/staging.h"
#include "shared/io/line_files.h"

namespace recon::cli {

namespace {

namespace base = dobra::base;
namespace io = dobra::io;
namespace scenario = dobra::scenario;
using base::Result;
using dobra::cli::Job;
using dobra::cli::Session;

struct RestoreOptions {
  SectionFile section;
  std::string top;
  std::string method = "constant";
  std::string target = "flat";
  std::optional<double> pin;
  std::optional<double> elevation;
  std::vector<double> target_pin;
  std::optional<double> angle;
  std::string base;
  std::optional<double> thickness;
  std::optional<double> percent;
  std::optional<double> tolerance;
  std::optional<double> simplify;
  std::string outside;
  std::string crossings;
  std::string uncovered;
  std::string beds;
  std::optional<std::int64_t> draws;
  std::optional<double> pick_error;
  std::optional<double> pin_error;
  std::optional<double> angle_error;
  std::optional<std::int64_t> seed;
  bool geometry = false;
  std::optional<std::filesystem::path> out;
  std::string colors;
  std::string orientation;
};

struct BalanceOptions {
  SectionFile section;
  std::string crossings;
  std::optional<double> tolerance;
  std::optional<double> confidence;
  std::vector<double> thickness;
  std::vector<double> thickness_error;
  std::vector<double> width_points;
  std::optional<double> width;
};

void add_section_options(CLI::App& app, SectionFile& options) {
  app.add_option("file", options.file,
                 "The section: a scenario (.toml), or lines (.geojson .shp .gpkg .dxf .asc .pl .wkt .csv .txt ...)")
      ->required()
      ->type_name("FILE");
  dobra::cli::add_line_options(app, options.lines);
  app.add_flag("--horizons-from-units", options.horizons_from_units,
               "Edges that polygons share become horizons, named by the unit below");
}

template <class T>
void set(scenario::Table& table, const char* key, const std::optional<T>& value) {
  if (value) table.set(key, *value);
}
void set(scenario::Table& table, const char* key, const std::string& value) {
  if (!value.empty()) table.set(key, value);
}
void set(scenario::Table& table, const char* key, const std::vector<double>& value) {
  if (!value.empty()) table.set(key, value);
}

/// A file name as the scenario will look for it, whose names start from the folder of the section's file.
std::string as_seen_from(const scenario::Document& document, const std::string& file) {
  if (document.folder().empty()) return file;
  std::error_code ignored;
  const auto relative = std::filesystem::proximate(file, document.folder(), ignored);
  return ignored ? file : relative.string();
}

scenario::Step step(const char* operation, scenario::Table params) {
  return {operation, "", std::move(params), "", {}};
}

Result<scenario::Document> restore_document(Session& session, const RestoreOptions& options) {
  DOBRA_TRY(scenario::Document document, section_document(session, options.section));
  if (!options.colors.empty()) document.input.set("colours", as_seen_from(document, options.colors));
  set(document.input, "orientation", options.orientation);
  scenario::Table grid;
  set(grid, "top", options.top);
  set(grid, "simplify", options.simplify);
  set(grid, "uncovered", options.uncovered);
  scenario::Table target;
  if (options.target != "flat") {
    target.set("shape", std::string("line"));
    if (document.file.empty()) {
      DOBRA_TRY(std::vector<dobra::geom::Point> line, only_line(options.target, options.section.lines));
      target.set("points", std::move(line));
    } else {
      target.set("file", as_seen_from(document, options.target));
    }
  }
  set(target, "pin", options.pin);
  set(target, "elevation", options.elevation);
  if (options.target_pin.size() == 2)
    target.set("target_pin", dobra::geom::Point{options.target_pin[0], options.target_pin[1]});
  scenario::Table restore;
  restore.set("method", options.method);
  set(restore, "angle", options.angle);
  set(restore, "base", options.base);
  set(restore, "thickness", options.thickness);
  set(restore, "percent", options.percent);
  set(restore, "outside", options.outside);
  set(restore, "crossings", options.crossings);
  set(restore, "beds", options.beds);
  set(restore, "tolerance", options.tolerance);
  document.steps = {step("grid", std::move(grid)), step("target", std::move(target)),
                    step("restore", std::move(restore))};
  if (options.draws || options.pick_error || options.pin_error || options.angle_error) {
    scenario::Table errors;
    set(errors, "draws", options.draws);
    set(errors, "seed", options.seed);
    set(errors, "pick_error", options.pick_error);
    set(errors, "pin_error", options.pin_error);
    set(errors, "angle_error", options.angle_error);
    document.steps.push_back(step("monte_carlo", std::move(errors)));
  }
  return document;
}

/// What --out is, by its ending.
enum class OutKind { Scenario, Picture, Lines };

Result<OutKind> out_kind(const std::filesystem::path& out) {
  if (out.extension() == ".toml") return OutKind::Scenario;
  if (dobra::cli::check_ending(out, dobra::cli::Drawer::Cairo)) return OutKind::Picture;
  if (io::line_format_of(out.string())) return OutKind::Lines;
  return base::Error{base::ErrorCode::BadUsage,
                     fmt::format("--out {}: give a picture (.svg .pdf .png), a scenario (.toml), or a file of the "
                                 "restored lines ({})",
                                 out.string(), fmt::join(io::line_endings(), " "))};
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
    io::LineWork work;
    work.features = core::restored_features(scenario::model_of<core::Model>(state).restoration->section);
    written = io::write_any_lines(path.string(), work, {}, losses);
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
  const bool by_area = !options.thickness.empty();
  SectionFile section = options.section;
  // Further columns are the errors of the vertices, which the step itself reads.
  if (by_area && section.lines.columns.empty()) section.lines.columns = "1,2";
  DOBRA_TRY(scenario::Document document, section_document(session, section));
  scenario::Table params;
  if (by_area) {
    params.set("file", as_seen_from(document, options.section.file));
    set(params, "unit", options.section.lines.unit);
    set(params, "thickness", options.thickness);
    set(params, "thickness_error", options.thickness_error);
    set(params, "width_points", options.width_points);
    set(params, "width", options.width);
    document.steps = {step("area_balance", std::move(params))};
  } else {
    set(params, "tolerance", options.tolerance);
    set(params, "confidence", options.confidence);
    set(params, "crossings", options.crossings);
    document.steps = {step("balance", std::move(params))};
  }
  DOBRA_TRY_VOID(scenario::check(document, session.program));
  DOBRA_TRY(const scenario::Run run, dobra::cli::run_steps(session, document));
  const auto& model = scenario::model_of<core::Model>(run.states.back());
  const bool as_json = session.options.format == dobra::cli::OutputFormat::Json;
  DOBRA_TRY_VOID(dobra::cli::print(as_json ? balance_json(model) : balance_table(model)));
  return 0;
}

void add_crossings_option(CLI::App& app, std::string& crossings) {
  app.add_option("--crossings", crossings, "Horizons that cross each other: refuse (default) or allow")
      ->check(CLI::IsMember({"refuse", "allow"}))
      ->type_name("NAME");
}

void add_method_options(CLI::App& app, RestoreOptions& options) {
  app.add_option("--method", options.method,
                 "constant (default), variable, proportional, flexural, shear or line_length")
      ->check(CLI::IsMember({"constant", "variable", "proportional", "flexural", "shear", "line_length"}))
      ->type_name("NAME");
  app.add_option("--angle", options.angle, "Direction of shear from the vertical, degrees; 0 by default")
      ->type_name("A");
  app.add_option("--base", options.base, "Base horizon of proportional thickness; the farthest by default")
      ->type_name("NAME");
  app.add_option("--thickness", options.thickness, "Restored thickness of proportional thickness, m")->type_name("T");
  app.add_option("--percent", options.percent, "State on the way: 0 deformed, 100 (default) restored")->type_name("P");
  app.add_option("--outside", options.outside,
                 "Where the map is not single-valued: limited (default), nearest (without limits) or refuse")
      ->check(CLI::IsMember({"limited", "nearest", "refuse"}))
      ->type_name("NAME");
  app.add_option("--uncovered", options.uncovered,
                 "Where the section reaches beyond the ends of the top: refuse (default), or continue straight")
      ->check(CLI::IsMember({"refuse", "continue"}))
      ->type_name("NAME");
  add_crossings_option(app, options.crossings);
  app.add_option("--beds", options.beds,
                 "Flexural slip along the horizons (default: each keeps its length), or parallel to the top")
      ->check(CLI::IsMember({"horizons", "parallel"}))
      ->type_name("NAME");
  app.add_option("--tolerance", options.tolerance, "Of the verdict, percent; 2 by default")->type_name("P");
}

void add_error_options(CLI::App& app, RestoreOptions& options) {
  app.add_option("--draws", options.draws, "Error bars from so many draws")->type_name("N");
  app.add_option("--pick-error", options.pick_error, "Standard deviation of picks, m")->type_name("S");
  app.add_option("--pin-error", options.pin_error, "Standard deviation of the pin, m")->type_name("S");
  app.add_option("--angle-error", options.angle_error, "Standard deviation of the direction of shear, degrees")
      ->type_name("S");
  app.add_option("--seed", options.seed, "Seed of the draws; 1 by default")->type_name("N");
}

}  // namespace

dobra::cli::Command restore_command() {
  return {
      "restore", "Restore a section and draw up its balance ledger", [](CLI::App& app) -> Job {
        const auto options = std::make_shared<RestoreOptions>();
        add_section_options(app, options->section);
        app.add_option("--top", options->top, "Horizon that the grid stands on; the first by default")
            ->type_name("NAME");
        add_method_options(app, *options);
        app.add_option("--target", options->target, "flat (default), or a file with the line to restore to")
            ->type_name("flat|FILE");
        app.add_option("--pin", options->pin, "x of the pin, m; the left end of the top by default")->type_name("X");
        app.add_option("--elevation", options->elevation, "Of a flat target, m; by default that of the top at the pin")
            ->type_name("Z");
        app.add_option("--target-pin", options->target_pin, "Point of the target to which the pin goes")
            ->expected(2)
            ->type_name("X Z");
        app.add_option("--simplify", options->simplify, "Take the top with fewer points, within so many metres")
            ->type_name("D");
        add_error_options(app, *options);
        app.add_flag("--geometry", options->geometry, "With --json: the restored lines too");
        app.add_option("--colours", options->colors,
                       "A table (.csv .toml) of name, colour, pattern, age and lithology of units and lines")
            ->type_name("FILE");
        app.add_option("--orientation", options->orientation,
                       "Compass points over the ends, such as \"W - E\"; told by the plane of lines in space")
            ->type_name("ENDS");
        app.add_option("--out", options->out,
                       "Picture (.svg .pdf .png), restored lines (.geojson .dxf .csv ...) or scenario (.toml) to write")
            ->type_name("FILE");
        return [options](Session& session) { return restore_job(session, *options); };
      }};
}

dobra::cli::Command balance_command() {
  return {
      "balance", "Bed lengths, excess areas and detachment of a section; or its shortening by area",
      [](CLI::App& app) -> Job {
        const auto options = std::make_shared<BalanceOptions>();
        add_section_options(app, options->section);
        app.add_option("--tolerance", options->tolerance, "Of the verdict, percent; 2 by default")->type_name("P");
        app.add_option("--confidence", options->confidence, "Of the fit's intervals, percent; 95 by default")
            ->type_name("P");
        add_crossings_option(app, options->crossings);
        app.add_option("--thickness", options->thickness,
                       "By area: FILE is a polygon (x y [dx dy]), and this its thickness before shortening, one or two")
            ->delimiter(',')
            ->type_name("T,T");
        app.add_option("--thickness-error", options->thickness_error, "Their errors")->delimiter(',')->type_name("E,E");
        app.add_option("--width-points", options->width_points, "Vertices that bound the present width, from 1 on")
            ->delimiter(',')
            ->type_name("I,J");
        app.add_option("--width", options->width, "The present width itself")->type_name("W");
        return [options](Session& session) { return balance_job(session, *options); };
      }};
}

}  // namespace recon::cli
