#include "quebra/cli/mesh_command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>

#include "quebra/cli/input_file.h"
#include "quebra/cli/rule_options.h"
#include "quebra/core/input.h"
#include "quebra/core/layers.h"
#include "quebra/core/surface_layers.h"
#include "quebra/core/surface_start.h"
#include "quebra/meshing/meshing.h"
#include "quebra/model/mesh_files.h"
#include "quebra/model/model.h"
#include "shared/base/text.h"
#include "shared/cli/findings.h"
#include "shared/cli/pictures.h"
#include "shared/cli/remarks.h"
#include "shared/cli/staging.h"
#include "shared/io/faces/import.h"
#include "shared/io/file.h"
#include "shared/io/formats/mesh_file.h"
#include "shared/scenario/runner.h"

// 1. The document: the scenario, or one made of the file; options become steps and parameters of it.
// 2. It is run as `quebra run` would. 3. The last mesh is written, and its figures are printed.

namespace quebra::cli {
namespace {

using namespace dobra;
using base::Error;
using base::ErrorCode;
using base::Result;
using dobra::cli::Command;
using dobra::cli::Job;
using dobra::cli::Session;

struct MeshOptions {
  InputFile input;
  dobra::cli::ParameterOptions rules, step;
  std::vector<std::string> bands, zones;
  std::optional<std::filesystem::path> out, histogram, picture, size_field;
};

/// The parts of "a:b:c".
std::vector<std::string> parts_of(const std::string& text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

Result<double> number_in(const std::string& option, const std::string& word) {
  if (const auto value = base::parse_number(word)) return *value;
  return Error{ErrorCode::BadUsage, fmt::format("{}: '{}' is not a number", option, word)};
}

/// A whole number from 1 on that steps can hold.
Result<std::int64_t> count_in(const std::string& option, const std::string& word) {
  DOBRA_TRY(const double value, number_in(option, word));
  constexpr double most = 1e6;
  if (value >= 1.0 && value <= most && value == std::floor(value)) return static_cast<std::int64_t>(value);
  return Error{ErrorCode::BadUsage, fmt::format("{}: '{}' is not a whole number from 1 to {:.0f}", option, word, most)};
}

/// CURVES:COUNT:DISTANCE[:FACTOR]
Result<scenario::Step> band_step(const std::string& text) {
  const auto parts = parts_of(text, ':');
  if (parts.size() < 3 || parts.size() > 4)
    return Error{ErrorCode::BadUsage, fmt::format("--bands {}: give CURVES:COUNT:DISTANCE[:FACTOR]", text)};
  scenario::Step step = step_of("constraints");
  step.params.set("curves", parts_of(parts[0], '+'));
  DOBRA_TRY(const std::int64_t count, count_in("--bands", parts[1]));
  step.params.set("count", count);
  DOBRA_TRY(const double distance, number_in("--bands", parts[2]));
  step.params.set("distance", distance);
  if (parts.size() > 3) {
    DOBRA_TRY(const double factor, number_in("--bands", parts[3]));
    step.params.set("factor", factor);
  }
  return step;
}

/// CURVES:SIZE:WIDTH
Result<scenario::Step> zone_step(const std::string& text) {
  const auto parts = parts_of(text, ':');
  if (parts.size() != 3) return Error{ErrorCode::BadUsage, fmt::format("--zone {}: give CURVES:SIZE:WIDTH", text)};
  scenario::Step step = step_of("zone");
  step.params.set("curves", parts_of(parts[0], '+'));
  DOBRA_TRY(const double size, number_in("--zone", parts[1]));
  step.params.set("size", size);
  DOBRA_TRY(const double width, number_in("--zone", parts[2]));
  step.params.set("width", width);
  return step;
}

/// The turn where none is asked for the faces of a file. What cannot be read is refused by the run.
void set_usual_turn(Session& session, const std::string& file, scenario::Table& params) {
  const auto imported = io::faces::faces_of_file(file);
  if (!imported) return;
  const scenario::Value* const size = params.find("size");
  const auto* const number = size == nullptr ? nullptr : std::get_if<double>(size);
  const double turn = core::usual_turn(imported->faces, number == nullptr ? 0.0 : *number);
  params.set("turn", turn);
  if (turn > core::usual_turn({}, 0.0))
    session.note(
        fmt::format("sides turn by up to {} degrees: by {} a face would have some hundred thousand "
                    "triangles; --turn asks for less",
                    turn, core::usual_turn({}, 0.0)));
}

/// Its last step is the mesh that is asked for; what stands behind says nothing about it.
Result<scenario::Document> mesh_document_of(Session& session, const MeshOptions& options) {
  DOBRA_TRY(scenario::Document document, document_of(session, options.input));
  StepChanges changes;
  const auto last = std::find_if(document.steps.rbegin(), document.steps.rend(),
                                 [](const auto& step) { return step.operation == "mesh"; });
  if (last == document.steps.rend()) {
    if (!document.file.empty()) changes.added.push_back("mesh, with the options given and else its defaults");
    document.steps.push_back(step_of("mesh"));
  } else {
    leave_out_from(document, static_cast<std::size_t>(document.steps.rend() - last), {}, changes);
  }
  scenario::Table& params = document.steps.back().params;
  const auto fields = scenario::fields_in(session.program.find_operation("mesh")->fields, document.units);
  DOBRA_TRY_VOID(set_rules(options.rules, fields, params));
  DOBRA_TRY_VOID(options.step.set(fields, params));
  if (core::is_brep(options.input.scenario.file.string()) && params.find("turn") == nullptr)
    set_usual_turn(session, options.input.scenario.file.string(), params);
  for (const std::string& text : options.bands) {
    DOBRA_TRY(scenario::Step step, band_step(text));
    document.steps.insert(document.steps.end() - 1, std::move(step));
  }
  for (const std::string& text : options.zones) {
    DOBRA_TRY(scenario::Step step, zone_step(text));
    document.steps.insert(document.steps.end() - 1, std::move(step));
  }
  if (const std::string told = text_of(changes, document); !told.empty()) session.note(told);
  DOBRA_TRY_VOID(scenario::check(document, session.program));
  return document;
}

struct Figures {
  std::vector<scenario::Quantity> values;
  std::vector<model::PhaseTime> seconds;
  std::size_t peak_memory = 0;  ///< Bytes.
};

constexpr std::array counts{"work.steps",     "work.triangles", "work.front", "elements",
                            "quadrilaterals", "nodes",          "tips"};
constexpr std::array measures{"area",         "area_surface",    "alpha_mean",    "alpha_90",
                              "alpha_min",    "min_angle",       "max_angle",     "gradation_p95",
                              "jacobian_min", "quad_shape_mean", "quad_shape_min"};

bool is_one(std::span<const char* const> names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

Figures figures_of(const scenario::Program& program, const scenario::State& state) {
  Figures figures;
  const bool at_work = scenario::model_of<model::Model>(state).work != nullptr;
  for (const scenario::Quantity& quantity : program.quantities_of(state)) {
    if (at_work != quantity.name.starts_with("work.")) continue;
    if (is_one(counts, quantity.name) || is_one(measures, quantity.name)) figures.values.push_back(quantity);
  }
  return figures;
}

nlohmann::ordered_json json_of(const Figures& figures, const std::vector<std::string>& remarks,
                               const model::Model& model) {
  nlohmann::ordered_json json;
  for (const auto& [name, value, unit] : figures.values) {
    if (is_one(counts, name)) {
      json[name] = static_cast<std::int64_t>(value);
    } else {
      json[name] = value;
    }
  }
  double total = 0.0;
  for (const auto& [phase, seconds] : figures.seconds) {
    json["seconds"][phase] = seconds;
    total += seconds;
  }
  json["seconds"]["total"] = total;
  json["peak_memory"] = figures.peak_memory;
  if (model.surfaces) json["findings"] = dobra::cli::findings_json(core::findings_of(model), model.units);
  json["remarks"] = remarks;
  return json;
}

std::string table_text(const Figures& figures) {
  std::string text;
  for (const auto& quantity : figures.values)
    text += fmt::format("{:<15} {:.6g} {}\n", quantity.name, quantity.value, quantity.unit);
  for (const auto& [phase, seconds] : figures.seconds) text += fmt::format("{:<15} {:.3f} s\n", phase, seconds);
  return text + fmt::format("{:<15} {:.1f} MB\n", "peak memory", static_cast<double>(figures.peak_memory) / 1e6);
}

/// The mesh of the domain, or that of the surfaces.
Result<void> write_last(const std::string& path, const model::Model& model) {
  if (model.surfaces) return model::write_mesh(path, model.surface_meshes.back()->elements, model.units);
  return model::write_mesh(path, model.meshes.back()->mesh, core::inp_element_of(model), model.units);
}

Result<void> write_out(Session& session, const std::filesystem::path& out, const model::Model& model) {
  return dobra::cli::write_whole(session, out,
                                 [&](const std::filesystem::path& path) { return write_last(path.string(), model); });
}

/// Whether the document is about surfaces in space.
bool of_surfaces(const scenario::Document& document) {
  if (document.input.find("surface") != nullptr) return true;
  const scenario::Value* const file = document.input.find("file");
  const auto* const name = file == nullptr ? nullptr : std::get_if<std::string>(file);
  return name != nullptr && core::is_brep(*name);
}

Result<void> check_files(const MeshOptions& options, const scenario::Document& document) {
  if (!of_surfaces(document)) return {};
  if (options.out)
    DOBRA_TRY_VOID(io::formats::check_mesh_ending(options.out->string(), io::formats::Use::WriteSpaceMesh));
  if (!options.histogram && !options.size_field) return {};
  return Error{ErrorCode::BadUsage, "--histogram and --size-field draw plane meshes; a mesh of surfaces has none"};
}

/// In space, where the state has such a picture.
Result<void> draw_last(const scenario::Program& program, const scenario::State& state,
                       const std::filesystem::path& file) {
  if (const auto space = program.space_of(state)) return dobra::cli::draw(*space, file, dobra::cli::Drawer::Cairo);
  return dobra::cli::draw(program.picture_of(state), file, dobra::cli::Drawer::Cairo);
}

Result<int> mesh_job(Session& session, const MeshOptions& options) {
  if (options.out) DOBRA_TRY_VOID(io::formats::check_mesh_ending(options.out->string()));
  for (const auto& file : {options.histogram, options.picture, options.size_field}) {
    if (file) DOBRA_TRY_VOID(dobra::cli::check_ending(*file, dobra::cli::Drawer::Cairo));
  }
  for (const auto& file : {options.out, options.histogram, options.picture, options.size_field}) {
    if (file) DOBRA_TRY_VOID(dobra::cli::check_writable(*file));
  }
  DOBRA_TRY(const scenario::Document document, mesh_document_of(session, options));
  DOBRA_TRY_VOID(check_files(options, document));
  const auto start = std::chrono::steady_clock::now();
  const auto since = [](auto from) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count();
  };
  DOBRA_TRY(const scenario::Run run, dobra::cli::run_steps(session, document));
  const double all = since(start);
  const scenario::State& state = run.states.back();
  const model::Model& model = scenario::model_of<model::Model>(state);
  if (model.work && (options.out || options.histogram)) {
    return Error{ErrorCode::CannotMesh,
                 "the mesh is not done, so there is none to write: raise --stop-after, or leave it out; --picture "
                 "draws the work"};
  }
  const model::Meshed stopped;
  const model::Meshed& meshed = model.work || model.surfaces ? stopped : *model.meshes.back();
  const mesh::ElementMesh& elements = model.surfaces ? model.surface_meshes.back()->elements.mesh : meshed.mesh;
  const auto& seconds = model.surfaces ? model.surface_meshes.back()->seconds : meshed.seconds;

  Figures figures = figures_of(session.program, state);
  double known = 0.0;
  for (const auto& phase : seconds) known += phase.seconds;
  figures.seconds.push_back({"input and steps before", all - known});
  figures.seconds.insert(figures.seconds.end(), seconds.begin(), seconds.end());
  if (options.out) {
    const auto begin = std::chrono::steady_clock::now();
    DOBRA_TRY_VOID(write_out(session, *options.out, model));
    figures.seconds.push_back({"write", since(begin)});
  }
  std::vector<std::string> remarks = session.program.remarks_of(state);
  if (options.out) {
    const std::vector<std::string> losses = io::formats::losses(options.out->string(), elements);
    const bool every = session.options.verbosity == dobra::cli::Verbosity::Verbose;
    for (const std::string& loss :
         every ? losses : dobra::cli::shortened(losses, "--verbose prints them; --json has all"))
      session.note(loss);
    remarks.insert(remarks.end(), losses.begin(), losses.end());
  }
  if (options.histogram)
    DOBRA_TRY_VOID(dobra::cli::draw(core::histogram_picture(meshed), *options.histogram, dobra::cli::Drawer::Cairo));
  if (options.picture) DOBRA_TRY_VOID(draw_last(session.program, state, *options.picture));
  if (options.size_field)
    DOBRA_TRY_VOID(dobra::cli::draw(in_units(core::size_field_picture(model, meshed), model.units), *options.size_field,
                                    dobra::cli::Drawer::Cairo));
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  figures.peak_memory = static_cast<std::size_t>(usage.ru_maxrss) * 1024;
  if (session.options.format == dobra::cli::OutputFormat::Json) {
    DOBRA_TRY_VOID(dobra::cli::print_json(json_of(figures, remarks, model)));
  } else if (session.options.verbosity != dobra::cli::Verbosity::Quiet) {
    DOBRA_TRY_VOID(dobra::cli::print(table_text(figures)));
  }
  return 0;
}

/// A refusal of bad surfaces, or of what cannot be meshed of them, as JSON too.
Result<void> tell_mesh_refusal(Session& session, const MeshOptions& options, const Error& error) {
  const int code = base::exit_code(error.code);
  if (session.options.format != dobra::cli::OutputFormat::Json || (code != 3 && code != 4)) return {};
  const std::filesystem::path& file = options.input.scenario.file;
  std::vector<surf::mesh::Finding> findings;
  const bool brep = core::is_brep(file.string());
  const auto text = brep ? Result<std::string>(std::string()) : io::read_text(file);
  if (!brep && (!text || text->find("[[input.surface]]") == std::string::npos)) return {};
  if (brep) {
    if (auto faces = io::faces::faces_of_file(file.string())) findings = std::move(faces->findings);
  }
  const bool told = std::any_of(findings.begin(), findings.end(),
                                [&](const auto& finding) { return finding.message == error.message; });
  if (!told) findings.push_back(dobra::cli::finding_of(error));
  nlohmann::ordered_json json;
  json["findings"] = dobra::cli::findings_json(findings, {});
  return dobra::cli::print_json(json);
}

}  // namespace

Command mesh_command() {
  return {"mesh", "Mesh a scenario or a file of geometry", [](CLI::App& app) -> Job {
            const auto options = std::make_shared<MeshOptions>();
            app.add_option("file", options->input.scenario.file,
                           fmt::format("Scenario (.toml), geometry ({} {}), faces of a boundary model (.brep) or a "
                                       "mesh whose boundary is meant ({})",
                                       fmt::join(io::formats::endings_for(io::formats::Use::ReadDrawing), " "),
                                       fmt::join(io::formats::endings_for(io::formats::Use::ReadLines), " "),
                                       fmt::join(io::formats::endings_for(io::formats::Use::ReadMesh), " ")))
                ->required()
                ->type_name("FILE");
            add_input_options(app, options->input);
            add_rule_options(app, options->rules, scenario::fields_of<meshing::MeshParams>());
            options->step.add(app, scenario::fields_of<meshing::MeshParams>(), {"quads", "stop_after"});
            app.add_option("--bands", options->bands,
                           "Offset curves as constraints: CURVE[+CURVE]:COUNT:DISTANCE[:FACTOR]; may be repeated")
                ->allow_extra_args(false)
                ->type_name("BANDS");
            app.add_option("--zone", options->zones,
                           "Small elements near curves: CURVE[+CURVE]:SIZE:WIDTH; may be repeated")
                ->allow_extra_args(false)
                ->type_name("ZONE");
            app.add_option("--out", options->out,
                           fmt::format("File to write: {}",
                                       fmt::join(io::formats::endings_for(io::formats::Use::WriteMesh), " ")))
                ->type_name("FILE");
            app.add_option("--picture", options->picture,
                           "Draw the mesh; with --stop-after the triangles made so far and the front")
                ->type_name("FILE.svg|pdf|png");
            app.add_option("--histogram", options->histogram, "Draw how many elements have which quality alpha")
                ->type_name("FILE.svg|pdf|png");
            app.add_option("--size-field", options->size_field,
                           "Draw the sizes that the mesh was to have, and the quadtree that carries them")
                ->type_name("FILE.svg|pdf|png");
            return [options](Session& session) -> Result<int> {
              auto done = mesh_job(session, *options);
              if (!done) DOBRA_TRY_VOID(tell_mesh_refusal(session, *options, done.error()));
              return done;
            };
          }};
}

}  // namespace quebra::cli
