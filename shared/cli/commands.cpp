#include "shared/cli/commands.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>

#include "shared/base/text.h"
#include "shared/cli/parameter_options.h"
#include "shared/cli/pictures.h"
#include "shared/cli/remarks.h"
#include "shared/cli/staging.h"
#include "shared/io/file.h"
#include "shared/scenario/table_text.h"

namespace dobra::cli {
namespace {

using base::Error;
using base::ErrorCode;

/// What run has for itself.
struct RunParams {
  std::optional<std::string> pictures;
  template <class D>
  static void describe(D& d) {
    d.field("pictures", &RunParams::pictures,
            {.title = "Pictures", .help = "Any of svg,pdf,png,vtk, or none; all by default."});
  }
};

struct RunOptions {
  ScenarioOptions scenario;
  std::filesystem::path out;
  OptionsOf<RunParams> own;
};

/// What render has for itself.
struct RenderParams {
  Drawer drawer = Drawer::Cairo;
  std::optional<double> width;
  template <class D>
  static void describe(D& d) {
    d.choice("drawer", &RenderParams::drawer, {"cairo", "vtk"}, {.title = "Drawer", .help = "vtk: PNG only."});
    d.field("width", &RenderParams::width,
            {.title = "Width", .help = "Of the page in points (1/72 inch).", .at_least = 72, .at_most = 14400});
  }
};

struct RenderOptions {
  ScenarioOptions scenario;
  std::filesystem::path out;
  OptionsOf<RenderParams> own{OutOfRange::BadUsage};
};

/// Draws all pictures asked for. Without --pictures, VTK's is left out with a note where there is no EGL.
/// @param space  the same in space, if there is such a picture.
base::Result<void> write_pictures(Session& session, const RunParams& own, const scene::Picture& picture,
                                  const std::optional<scene::space::SpacePicture>& space, const Staging& staging) {
  DOBRA_TRY(const std::set<PictureKind> kinds, picture_kinds(own.pictures.value_or("svg,pdf,png,vtk")));
  for (const PictureKind kind : kinds) {
    DOBRA_TRY_VOID(session.check());
    const Drawer drawer = kind == PictureKind::Vtk ? Drawer::Vtk : Drawer::Cairo;
    auto drawn = draw(picture, staging.path(picture_file_name(kind)), drawer);
    if (drawn && space) drawn = draw(*space, staging.path(space_file_name(kind)), drawer);
    if (drawn) continue;
    if (kind != PictureKind::Vtk || own.pictures || drawn.error().code != ErrorCode::CannotDraw) return drawn.error();
    session.note(fmt::format("{} is left out: {}", picture_file_name(kind), drawn.error().message));
  }
  return {};
}

base::Result<void> write_results(Session& session, const RunParams& own, const scenario::Document& document,
                                 const scenario::State& state, const std::string& report, const Staging& staging) {
  const scenario::Program& program = session.program;
  DOBRA_TRY_VOID(io::write_file(staging.path("report.json"), report));
  for (const scenario::DataTable& table : program.tables_of(state))
    DOBRA_TRY_VOID(io::write_file(staging.path(fmt::format("{}.csv", table.name)), scenario::csv_text(table)));
  for (const scenario::Output& output : program.outputs_of(state)) {
    DOBRA_TRY_VOID(session.check());
    DOBRA_TRY_VOID(output.write(staging.path(output.file_name)));
    const bool all = session.options.verbosity == Verbosity::Verbose;
    for (const std::string& loss : all ? output.losses : shortened(output.losses, "--verbose prints them"))
      session.note(loss);
  }
  if (program.results.draw)
    DOBRA_TRY_VOID(
        write_pictures(session, own, picture_of(program, document, state), program.space_of(state), staging));
  return session.check();
}

int announce_failures(Session& session, const std::vector<scenario::Verdict>& verdicts) {
  int failures = 0;
  for (const scenario::Verdict& verdict : verdicts) {
    if (verdict.met) continue;
    ++failures;
    base::Place place = verdict.expect.place;
    place.item = "expectation failed";
    session.error_line(base::to_string({ErrorCode::UnknownQuantity, verdict.message, place}));
  }
  return failures;
}

std::string summary(const scenario::Document& document, const RunOptions& options,
                    const std::vector<std::string>& files, std::size_t expectations, int failures) {
  std::string text = fmt::format("{}: {} {} done", options.scenario.file.string(), document.steps.size(),
                                 document.steps.size() == 1 ? "step" : "steps");
  if (expectations > 0)
    text += fmt::format(", {} of {} expectations met", expectations - static_cast<std::size_t>(failures), expectations);
  text += '\n';
  for (const std::string& file : files) text += fmt::format("  {}\n", (options.out / file).string());
  return text;
}

/// What the finished steps gave, where a later one failed; the error is that of the step all the same.
base::Error write_finished(Session& session, const RunParams& own, const scenario::Document& document,
                           const scenario::Run& run, const RunOptions& options, Staging& staging) {
  if (run.failed_step < 2 || run.error->code == ErrorCode::Cancelled) return *run.error;
  const std::string report = scenario::report_json(document, session.program, run);
  auto written = write_results(session, own, document, run.states.back(), report, staging);
  if (written) {
    if (const auto files = staging.commit(); !files) written = files.error();
  }
  const std::string done = run.failed_step == 2 ? "step 1" : fmt::format("steps 1 to {}", run.failed_step - 1);
  session.note(written ? fmt::format("what {} gave is in {}", done, options.out.string())
                       : fmt::format("what {} gave cannot be written: {}", done, written.error().message));
  return *run.error;
}

base::Result<int> run_job(Session& session, const RunOptions& options) {
  DOBRA_TRY(const RunParams own, options.own.read());
  if (own.pictures) DOBRA_TRY_VOID(picture_kinds(*own.pictures));
  DOBRA_TRY(const scenario::Document document, load(session, options.scenario));
  // Opened before the work, so that a folder which cannot be written is known at once.
  DOBRA_TRY(Staging staging, Staging::open(options.out, TargetFolder::Create));
  const scenario::Run run = run_as_far_as_it_goes(session, document);
  if (run.error) return write_finished(session, own, document, run, options, staging);
  const std::string report = scenario::report_json(document, session.program, run);
  if (const auto written = write_results(session, own, document, run.states.back(), report, staging); !written) {
    return staging.for_user(written.error());
  }
  DOBRA_TRY(const std::vector<std::string> files, staging.commit());
  const auto verdicts = scenario::judge(document, session.program, run);
  const int failures = announce_failures(session, verdicts);
  if (session.options.format == OutputFormat::Json) {
    DOBRA_TRY_VOID(print(report));
  } else if (session.options.verbosity != Verbosity::Quiet) {
    DOBRA_TRY_VOID(print(summary(document, options, files, verdicts.size(), failures)));
  }
  return failures > 0 || session.program.reached(run.states.back()) == false ? 1 : 0;
}

base::Result<int> render_job(Session& session, const RenderOptions& options) {
  DOBRA_TRY(const RenderParams own, options.own.read());
  DOBRA_TRY_VOID(check_ending(options.out, own.drawer));
  DOBRA_TRY_VOID(check_writable(options.out));
  DOBRA_TRY(const scenario::Document document, load(session, options.scenario));
  DOBRA_TRY(Staging staging, Staging::open(options.out.parent_path(), TargetFolder::MustExist));
  DOBRA_TRY(const scenario::Run run, run_steps(session, document));
  const std::string name = options.out.filename().string();
  if (const auto drawn =
          draw(picture_of(session.program, document, run.states.back()), staging.path(name), own.drawer, own.width);
      !drawn) {
    return staging.for_user(drawn.error());
  }
  DOBRA_TRY_VOID(session.check());
  DOBRA_TRY_VOID(staging.commit());
  if (session.options.format == OutputFormat::Json) {
    DOBRA_TRY_VOID(print(scenario::report_json(document, session.program, run)));
  } else if (session.options.verbosity != Verbosity::Quiet) {
    DOBRA_TRY_VOID(print(options.out.string() + '\n'));
  }
  return 0;
}

}  // namespace

void add_scenario_options(CLI::App& app, ScenarioOptions& options) {
  app.add_option("file", options.file, "Scenario file (TOML)")->required()->type_name("FILE");
  add_assignment_option(app, options);
  app.add_flag("--si", options.si, "Results in m, N, Pa, whatever the units of the scenario");
}

void add_assignment_option(CLI::App& app, ScenarioOptions& options) {
  app.add_option("--set", options.assignments, "Change a value, such as steps.2.distance=0.4; may be repeated")
      ->allow_extra_args(false)
      ->type_name("PATH=VALUE");
}

base::Result<scenario::Document> load(Session& session, const ScenarioOptions& options) {
  DOBRA_TRY(scenario::Document document, scenario::read_document(options.file));
  DOBRA_TRY_VOID(scenario::check_program(document, session.program));
  if (options.si) document.result_units = scenario::UnitSystem();
  for (const std::string& assignment : options.assignments) {
    DOBRA_TRY(document, scenario::with_value(std::move(document), session.program, assignment));
  }
  DOBRA_TRY_VOID(scenario::check(document, session.program));
  return document;
}

scenario::Run run_as_far_as_it_goes(Session& session, const scenario::Document& document) {
  const auto start = std::chrono::steady_clock::now();
  scenario::Runner runner(session.program);
  scenario::Run run = runner.run(document, session.progress());
  if (run.error) return run;
  for (const std::string& line : scenario::without_effect(document, session.program)) session.note(line);
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  session.detail(fmt::format("{} steps in {:.2f} s", document.steps.size(), time.count()));
  tell(session, run.states.back());
  return run;
}

base::Result<scenario::Run> run_steps(Session& session, const scenario::Document& document) {
  scenario::Run run = run_as_far_as_it_goes(session, document);
  if (run.error) return *run.error;
  return run;
}

void tell(Session& session, const scenario::State& state) {
  for (const scenario::Quantity& quantity : session.program.quantities_of(state)) {
    session.detail(
        fmt::format("{} = {}{}{}", quantity.name, quantity.value, quantity.unit.empty() ? "" : " ", quantity.unit));
  }
  const std::vector<std::string> remarks = session.program.remarks_of(state);
  const bool all = session.options.verbosity == Verbosity::Verbose;
  for (const std::string& line : all ? remarks : shortened(remarks)) session.note(line);
}

Command run_command() {
  return {"run", "Run a scenario and write its results", [](CLI::App& app) -> Job {
            const auto options = std::make_shared<RunOptions>();
            add_scenario_options(app, options->scenario);
            app.add_option("--out", options->out, "Folder for the results; made if it is not there")
                ->required()
                ->type_name("DIR");
            options->own.add(app);
            return [options](Session& session) { return run_job(session, *options); };
          }};
}

Command render_command() {
  return {"render", "Run a scenario and draw its last state", [](CLI::App& app) -> Job {
            const auto options = std::make_shared<RenderOptions>();
            add_scenario_options(app, options->scenario);
            app.add_option("--out", options->out, "Picture to write: " + picture_endings())
                ->required()
                ->type_name("PICTURE");
            options->own.add(app);
            return [options](Session& session) { return render_job(session, *options); };
          }};
}

}  // namespace dobra::cli
