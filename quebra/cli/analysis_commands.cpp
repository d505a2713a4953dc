#include "quebra/cli/analysis_commands.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <type_traits>
#include <variant>

#include "quebra/analysis/adaptivity.h"
#include "quebra/analysis/analysis.h"
#include "quebra/analysis/convergence.h"
#include "quebra/analysis/fracture.h"
#include "quebra/analysis/results.h"
#include "quebra/cli/input_file.h"
#include "quebra/cli/rule_options.h"
#include "quebra/core/result_picture.h"
#include "quebra/validation/book.h"
#include "shared/base/text.h"
#include "shared/cli/commands.h"
#include "shared/cli/pictures.h"
#include "shared/cli/staging.h"
#include "shared/io/file.h"
#include "shared/io/formats/line_files.h"
#include "shared/scenario/runner.h"
#include "shared/scenario/table_text.h"
#include "shared/scenario/units.h"

// 1. The document: options become parameters of its last step of the command's operation, which is added if there is
// none (adapt: with the rules of the last mesh; crack: rosettes in the mesh), as is what that step stands on; probes
// and lines behind it stay. 2. It is run as `quebra run` would. 3. Quantities, tables and remarks are printed, the line
// and the picture written.

namespace quebra::cli {
namespace {

using namespace dobra;
using base::Error;
using base::ErrorCode;
using base::Result;

struct AnalysisOptions {
  dobra::cli::ScenarioOptions scenario;
  dobra::cli::ParameterOptions step, rules, view, samples;
  std::string line;
  std::vector<std::string> probes;
  std::optional<std::filesystem::path> out, picture, curve;
};

bool has_step(const scenario::Document& document, const std::string& operation) {
  return std::any_of(document.steps.begin(), document.steps.end(),
                     [&](const auto& step) { return step.operation == operation; });
}

/// "x0,y0,x1,y1" as points.
Result<std::vector<geom::Point>> points_in(const std::string& option, const std::string& text, std::size_t count) {
  std::vector<double> numbers;
  for (const std::string& word : dobra::io::formats::words_between_commas(text)) {
    const auto value = base::parse_number(base::trimmed(word));
    if (!value) break;
    numbers.push_back(*value);
  }
  std::vector<geom::Point> points;
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) points.push_back({numbers[i], numbers[i + 1]});
  if (numbers.size() != 2 * count ||
      static_cast<std::size_t>(std::count(text.begin(), text.end(), ',')) + 1 != numbers.size())
    return Error{ErrorCode::BadUsage, fmt::format("{} {}: give {} numbers with commas between, such as {}", option,
                                                  text, 2 * count, count == 1 ? "x,y" : "x0,y0,x1,y1")};
  return points;
}

/// Lines, probes and pictures that the options ask for, as steps.
Result<void> add_result_steps(const AnalysisOptions& options, dobra::cli::OutputFormat format,
                              scenario::Document& document) {
  if (options.out && options.line.empty())
    return Error{ErrorCode::BadUsage, "--out is the file of the line: give --line x0,y0,x1,y1"};
  if (!options.line.empty() && !options.out && format != dobra::cli::OutputFormat::Json)
    return Error{ErrorCode::BadUsage, "--line: say where it goes, --out FILE.csv, or --json"};
  if (options.samples.any() && options.line.empty())
    return Error{ErrorCode::BadUsage, "--samples is of a line: give --line x0,y0,x1,y1"};
  if (!options.picture && options.view.any())
    return Error{ErrorCode::BadUsage,
                 "--field, --range, --cycle and --deformation are of a picture: give --picture FILE"};
  if (!options.line.empty()) {
    DOBRA_TRY(const auto ends, points_in("--line", options.line, 2));
    scenario::Step step = step_of("line");
    step.params.set("label", std::string("command"));
    step.params.set("from", ends[0]);
    step.params.set("to", ends[1]);
    DOBRA_TRY_VOID(options.samples.set(scenario::fields_of<analysis::LineParams>(), step.params));
    document.steps.push_back(std::move(step));
  }
  for (std::size_t i = 0; i < options.probes.size(); ++i) {
    DOBRA_TRY(const auto at, points_in("--probe", options.probes[i], 1));
    scenario::Step step = step_of("probe");
    step.params.set("label", fmt::format("{}", i + 1));
    step.params.set("at", at[0]);
    document.steps.push_back(std::move(step));
  }
  if (options.picture) {
    scenario::Step step = step_of("view");
    DOBRA_TRY_VOID(options.view.set(scenario::fields_of<core::ViewParams>(), step.params));
    document.steps.push_back(std::move(step));
  }
  return {};
}

/// A loop that the scenario has no step of obeys what its last mesh step says, as far as a loop knows it. @return what
/// it takes, for the user.
std::string as_the_mesh(const dobra::cli::Session& session, const scenario::Document& document, scenario::Table& loop) {
  const auto mesh = std::find_if(document.steps.rbegin(), document.steps.rend(),
                                 [](const auto& step) { return step.operation == "mesh"; });
  if (mesh == document.steps.rend()) return {};
  const auto& known = session.program.find_operation("adapt")->fields;
  std::string taken;
  for (const auto& entry : mesh->params.entries()) {
    if (std::none_of(known.begin(), known.end(), [&](const scenario::Field& field) { return field.key == entry.key; }))
      continue;
    loop.set(entry.key, entry.value, entry.place);
    taken += (taken.empty() ? "" : ", ") + entry.key;
  }
  return taken.empty() ? taken
                       : fmt::format("the loop takes {} of step {} (mesh); options and a step 'adapt' say otherwise",
                                     taken, document.steps.rend() - mesh);
}

/// What the command's step stands on and the scenario has not: a mesh for `analyse`, an analysis for `crack`. Before
/// step `at`.
void add_missing(scenario::Document& document, const std::string& operation, std::size_t& at, StepChanges& changes) {
  const auto has_before = [&](std::initializer_list<const char*> operations) {
    return std::any_of(document.steps.begin(), document.steps.begin() + static_cast<std::ptrdiff_t>(at),
                       [&](const auto& step) {
                         return std::find(operations.begin(), operations.end(), step.operation) != operations.end();
                       });
  };
  const auto insert = [&](scenario::Step missing, const char* told) {
    document.steps.insert(document.steps.begin() + static_cast<std::ptrdiff_t>(at++), std::move(missing));
    changes.added.push_back(told);
  };
  if (operation == "crack" && !has_before({"analyse", "adapt"})) insert(step_of("analyse"), "analyse");
  // That of `crack` gets rosettes (ask_for_rosettes).
  if (operation != "analyse" || has_before({"mesh", "adapt"})) return;
  // Elements of the first order lock near nu = 0.5.
  scenario::Step mesh = step_of("mesh");
  mesh.params.set("order", std::string("2"));
  insert(std::move(mesh), "mesh, of the second order");
}

/// The scenario up to its last step of the operation, which is added if there is none, and the probes and lines behind
/// it.
/// @return the number of that step, 0-based.
Result<std::size_t> take_steps(dobra::cli::Session& session, const std::string& operation,
                               scenario::Document& document) {
  if (has_step(document, "shell") || document.input.find("surface") != nullptr)
    return Error{ErrorCode::NotSupported,
                 "surfaces are not analysed here: the step 'shell' writes decks for CalculiX and Nastran, `quebra run` "
                 "makes them",
                 base::Place{.file = document.file.string()}};
  if (!has_step(document, "problem"))
    return Error{ErrorCode::BadValue,
                 "the scenario has no step 'problem' with materials, supports and loads, so there is nothing to "
                 "analyse: add one",
                 base::Place{.file = document.file.string()}};
  StepChanges changes;
  auto& steps = document.steps;
  const auto last =
      std::find_if(steps.rbegin(), steps.rend(), [&](const auto& step) { return step.operation == operation; });
  std::size_t at = static_cast<std::size_t>(steps.rend() - last);  // behind it
  const bool is_there = at > 0;
  if (!is_there) {
    // Behind everything that it can stand on, before what reads results.
    constexpr std::array reading{"probe", "line", "view", "crack"};
    const auto before = std::find_if(steps.rbegin(), steps.rend(), [&](const auto& step) {
      return std::find(reading.begin(), reading.end(), step.operation) == reading.end();
    });
    at = static_cast<std::size_t>(steps.rend() - before);
  }
  leave_out_from(document, at, {"probe", "line"}, changes);
  if (is_there) {
    --at;
  } else {
    steps.insert(steps.begin() + static_cast<std::ptrdiff_t>(at), step_of(operation));
    if (operation == "adapt") {
      if (const std::string taken = as_the_mesh(session, document, steps[at].params); !taken.empty())
        session.note(taken);
    }
  }
  add_missing(document, operation, at, changes);
  if (!is_there) changes.added.push_back(operation);
  if (const std::string told = text_of(changes, document); !told.empty()) session.note(told);
  return at;
}

Result<scenario::Document> document_of(dobra::cli::Session& session, const std::string& operation,
                                       const AnalysisOptions& options) {
  DOBRA_TRY(scenario::Document document, dobra::cli::load(session, options.scenario));
  DOBRA_TRY(const std::size_t at, take_steps(session, operation, document));
  scenario::Table& params = document.steps[at].params;
  const auto fields = scenario::fields_in(session.program.find_operation(operation)->fields, document.units);
  DOBRA_TRY_VOID(options.step.set(fields, params));
  DOBRA_TRY_VOID(set_rules(options.rules, fields, params));
  if (operation == "crack") {
    if (const std::string done = analysis::ask_for_rosettes(document); !done.empty()) session.note(done);
  }
  DOBRA_TRY_VOID(add_result_steps(options, session.options.format, document));
  DOBRA_TRY_VOID(scenario::check(document, session.program));
  return document;
}

/// Figures of the mesh are `quebra mesh`'s business.
bool wanted(const std::string& quantity) {
  constexpr std::array names{"elements", "nodes", "unknowns", "cycles", "eta", "peak_eta"};
  return quantity.starts_with("case.") || quantity.starts_with("tip.") || quantity.starts_with("probe.") ||
         std::find(names.begin(), names.end(), quantity) != names.end();
}

std::string json_text(const scenario::Program& program, const scenario::State& state) {
  nlohmann::ordered_json json;
  for (const auto& quantity : program.quantities_of(state)) {
    if (wanted(quantity.name)) json["quantities"][quantity.name] = {{"value", quantity.value}, {"unit", quantity.unit}};
  }
  for (const auto& table : program.tables_of(state)) {
    if (table.name != "analyses" && table.name != "tips" && !table.name.starts_with("line_")) continue;
    auto rows = nlohmann::ordered_json::array();
    for (const auto& row : table.rows) {
      nlohmann::ordered_json one;
      const auto known = [](const auto& cell) { return cell != std::remove_cvref_t<decltype(cell)>(std::string()); };
      for (std::size_t i = 0; i < row.size(); ++i) {
        if (known(row[i])) std::visit([&](const auto& value) { one[table.columns[i]] = value; }, row[i]);
      }
      rows.push_back(std::move(one));
    }
    json[table.name] = std::move(rows);
  }
  if (const auto reached = program.reached(state)) json["reached"] = *reached;
  json["remarks"] = program.remarks_of(state);
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
}

/// A row a cycle and load case, of a loop of several.
std::string cycles_text(const scenario::Program& program, const scenario::State& state) {
  std::string text;
  for (const auto& table : program.tables_of(state)) {
    if (table.name != "analyses" || table.rows.size() < 2) continue;
    const auto cell = [](const auto& value) {
      if constexpr (std::is_same_v<std::decay_t<decltype(value)>, double>)
        return fmt::format("{:>20.7g}", value);
      else
        return fmt::format("{:>20}", value);
    };
    std::vector<std::size_t> known;  // columns with a value; the first is the name, which says the cycle again
    for (std::size_t i = 1; i < table.columns.size(); ++i) {
      if (std::any_of(table.rows.begin(), table.rows.end(),
                      [&](const auto& row) { return std::visit(cell, row[i]).back() != ' '; }))
        known.push_back(i);
    }
    for (const std::size_t i : known) text += fmt::format("{:>20}", table.columns[i]);
    text += '\n';
    for (const auto& row : table.rows) {
      for (const std::size_t i : known) text += std::visit(cell, row[i]);
      text += '\n';
    }
  }
  return text;
}

std::string plain_text(const scenario::Program& program, const scenario::State& state) {
  std::string text = cycles_text(program, state);
  for (const auto& quantity : program.quantities_of(state)) {
    if (wanted(quantity.name)) text += fmt::format("{:<43} {:.8g} {}\n", quantity.name, quantity.value, quantity.unit);
  }
  return text;
}

Result<void> write_results(const scenario::Program& program, const scenario::State& state,
                           const AnalysisOptions& options) {
  for (const auto& table : program.tables_of(state)) {
    if (!options.out || table.name != "line_command") continue;
    DOBRA_TRY_VOID(io::write_file(options.out->string(), scenario::csv_text(table)));
  }
  if (options.picture)
    DOBRA_TRY_VOID(dobra::cli::draw(program.picture_of(state), *options.picture, dobra::cli::Drawer::Cairo));
  if (options.curve) {
    const auto& model = scenario::model_of<model::Model>(state);
    if (std::none_of(model.analyses.begin(), model.analyses.end(), [](const auto& own) { return own->eta > 0.0; }))
      return Error{ErrorCode::BadValue, "--curve: there is no error to draw: that of every cycle is 0"};
    DOBRA_TRY_VOID(dobra::cli::draw(analysis::convergence_picture(model), *options.curve, dobra::cli::Drawer::Cairo));
  }
  return {};
}

/// An error about the probe of an option names the option, not the number that it has got.
Error of_option(Error error, const AnalysisOptions& options) {
  for (std::size_t i = 0; error.place && i < options.probes.size(); ++i) {
    if (error.place->item == fmt::format("'{}'", i + 1))
      error.place->item = fmt::format("--probe {}", options.probes[i]);
  }
  return error;
}

/// Runs the steps. A loop that the user stopped keeps its cycles: lines, probes and views behind it are of the last.
Result<scenario::Run> run_loop(dobra::cli::Session& session, const scenario::Document& document) {
  scenario::Runner runner(session.program);
  scenario::Run run = runner.run(document, session.progress());
  const bool stopped =
      session.cancel.cancelled() && !run.states.empty() && session.program.reached(run.states.back()) == false;
  if (run.error && !stopped) return *run.error;
  for (std::size_t k = run.states.size(); k <= document.steps.size(); ++k) {
    const scenario::Step& step = document.steps[k - 1];
    if (step.operation != "line" && step.operation != "probe" && step.operation != "view") return *run.error;
    DOBRA_TRY(
        scenario::State state,
        session.program.find_operation(step.operation)->run(run.states.back(), step.params, {document.folder()}, {}));
    run.states.push_back(std::move(state));
  }
  dobra::cli::tell(session, run.states.back());
  return run;
}

Result<int> job(dobra::cli::Session& session, const std::string& operation, const AnalysisOptions& options) {
  for (const auto& file : {options.picture, options.curve}) {
    if (file) DOBRA_TRY_VOID(dobra::cli::check_ending(*file, dobra::cli::Drawer::Cairo));
  }
  for (const auto& file : {options.out, options.picture, options.curve}) {
    if (file) DOBRA_TRY_VOID(dobra::cli::check_writable(*file));
  }
  DOBRA_TRY(const scenario::Document document, document_of(session, operation, options));
  const auto run = operation == "adapt" ? run_loop(session, document) : dobra::cli::run_steps(session, document);
  if (!run) return of_option(run.error(), options);
  const scenario::State& state = run->states.back();
  DOBRA_TRY_VOID(write_results(session.program, state, options));
  if (session.options.format == dobra::cli::OutputFormat::Json) {
    DOBRA_TRY_VOID(dobra::cli::print(json_text(session.program, state)));
  } else if (session.options.verbosity != dobra::cli::Verbosity::Quiet) {
    DOBRA_TRY_VOID(dobra::cli::print(plain_text(session.program, state)));
  }
  if (session.cancel.cancelled()) return base::exit_code(ErrorCode::Cancelled);
  // As an expectation that is not met; the remark that says why is told with the others.
  return session.program.reached(state) == false ? 1 : 0;
}

dobra::cli::Command command(const std::string& name, const std::string& operation, const std::string& help) {
  return {
      name, help, [operation](CLI::App& app) -> dobra::cli::Job {
        const auto options = std::make_shared<AnalysisOptions>();
        dobra::cli::add_scenario_options(app, options->scenario);
        if (operation == "adapt") {
          options->step.add(app, scenario::fields_of<analysis::AdaptParams>(),
                            {"target", "rule", "max_cycles", "exact_energy"});
          add_rule_options(app, options->rules, scenario::fields_of<analysis::AdaptParams>());
          options->view.add(app, scenario::fields_of<core::ViewParams>(), {"cycle"});
          app.add_option("--curve", options->curve, "Draw the error of each cycle against the unknowns")
              ->type_name("FILE.svg|pdf|png");
        } else if (operation == "analyse") {
          options->step.add(app, scenario::fields_of<analysis::AnalyseParams>(), {"exact_energy"});
        } else {
          options->step.add(app, scenario::fields_of<analysis::FractureParams>(), {"contour"});
        }
        app.add_option("--line", options->line, "Displacements and stresses along a line")->type_name("X0,Y0,X1,Y1");
        options->samples.add(app, scenario::fields_of<analysis::LineParams>(), {{"count", "--samples"}});
        app.add_option("--out", options->out, "Write the line as CSV")->type_name("FILE");
        app.add_option("--probe", options->probes, "The same at a point; may be given again")->type_name("X,Y");
        app.add_option("--picture", options->picture, "Draw a field on the deformed shape")
            ->type_name("FILE.svg|pdf|png");
        options->view.add(app, scenario::fields_of<core::ViewParams>(), {"field", "range", "deformation"});
        return [operation, options](dobra::cli::Session& session) { return job(session, operation, *options); };
      }};
}

struct ValidateOptions {
  std::optional<std::filesystem::path> book, out;
};

/// The book that comes with the program: of the sources or of an installation, in a folder above it.
Result<std::filesystem::path> bundled_book() {
  std::error_code error;
  for (auto folder = std::filesystem::read_symlink("/proc/self/exe", error); folder != folder.parent_path();) {
    folder = folder.parent_path();
    for (const char* const own : {"resources/validation", "share/dobra/validation"}) {
      if (std::filesystem::is_directory(folder / own, error)) return folder / own;
    }
  }
  return Error{ErrorCode::FileNotFound,
               "no folder above the program holds resources/validation or share/dobra/validation; give the folder of "
               "the book: quebra validate FOLDER"};
}

/// The validation book: a line for every case, files if asked for; exit code 1 if a value misses its tolerance.
Result<int> validate_job(dobra::cli::Session& session, const ValidateOptions& options) {
  std::optional<dobra::cli::Staging> staging;  // opened before the work, so that a bad folder is known at once
  if (options.out) {
    DOBRA_TRY(dobra::cli::Staging opened, dobra::cli::Staging::open(*options.out, dobra::cli::TargetFolder::Create));
    staging.emplace(std::move(opened));
  }
  DOBRA_TRY(const auto folder, options.book ? Result<std::filesystem::path>(*options.book) : bundled_book());
  DOBRA_TRY(const auto book, validation::read_book(folder));
  DOBRA_TRY(const auto rows, validation::validate(book, session.progress()));
  if (staging) {
    DOBRA_TRY_VOID(io::write_file(staging->path("validation.csv"), validation::csv(rows)));
    DOBRA_TRY_VOID(io::write_file(staging->path("validation.json"), validation::json(rows)));
    DOBRA_TRY_VOID(io::write_file(staging->path("validation.html"), validation::html(rows)));
    DOBRA_TRY_VOID(staging->commit());
  }
  if (session.options.verbosity != dobra::cli::Verbosity::Quiet) {
    const bool json = session.options.format == dobra::cli::OutputFormat::Json;
    DOBRA_TRY_VOID(dobra::cli::print(json ? validation::json(rows) : validation::csv(rows)));
  }
  return std::all_of(rows.begin(), rows.end(), [](const auto& row) { return row.met; }) ? 0 : 1;
}

dobra::cli::Command validate_command() {
  return {"validate", "Compute every value of the validation book and compare", [](CLI::App& app) -> dobra::cli::Job {
            const auto options = std::make_shared<ValidateOptions>();
            app.add_option("book", options->book,
                           "Folder of scenarios; the book that comes with the program by default")
                ->type_name("FOLDER");
            app.add_option("--out", options->out, "Folder for validation.csv, validation.json and validation.html")
                ->type_name("DIR");
            return [options](dobra::cli::Session& session) { return validate_job(session, *options); };
          }};
}

}  // namespace

std::vector<dobra::cli::Command> analysis_commands() {
  return {
      command("solve", "analyse", "Analyse the last mesh of a scenario"),
      command("adapt", "adapt", "Mesh and analyse a scenario until the error asked for is met"),
      command(
          "crack", "crack",
          "Stress intensity factors at the crack tips of a scenario, on a mesh with rosettes unless it says otherwise"),
      validate_command()};
}

}  // namespace quebra::cli
