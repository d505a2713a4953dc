#include "recon/cli/space_commands.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "recon/cli/block_commands.h"
#include "recon/cli/section_options.h"
#include "recon/cli/space_json.h"
#include "recon/core/space_steps.h"
#include "recon/space/placed.h"
#include "recon/space/surface_file.h"
#include "shared/cli/commands.h"
#include "shared/cli/findings.h"
#include "shared/cli/staging.h"

namespace recon::cli {

namespace {

namespace scenario = dobra::scenario;
using base::Result;
using dobra::cli::Job;
using dobra::cli::Session;

/// What the cut of several sections goes through.
enum class CutThrough : std::uint8_t { Surfaces, Block };
struct ThroughParams {
  CutThrough through = CutThrough::Surfaces;
  template <class D>
  static void describe(D& d) {
    d.choice("through", &ThroughParams::through, {"surfaces", "block"},
             {.title = "Cut through",
              .help = "Of several sections: smooth surfaces through equally named lines, or the block of their units, "
                      "straight from section to section."});
  }
};

struct SpaceOptions {
  std::string file;
  dobra::cli::ParameterOptions surface{dobra::cli::OutOfRange::BadUsage};
  dobra::cli::ParameterOptions cut{dobra::cli::OutOfRange::BadUsage}, block{dobra::cli::OutOfRange::BadUsage};
  dobra::cli::OptionsOf<ThroughParams> through{dobra::cli::OutOfRange::BadUsage};
  std::optional<std::filesystem::path> out;
};

void add_space(CLI::App& app, SpaceOptions& options) {
  add_file(app, options.file,
           "A scenario (.toml): sections in space, [[input.section]]; or, to be cut, one section that is extruded to a "
           "block");
  options.surface.add(app, scenario::fields_of<space::SurfaceParams>());
}

bool as_json(const Session& session) { return session.options.format == dobra::cli::OutputFormat::Json; }

/// With JSON a refusal is printed as a finding too.
Result<int> with_refusal(Session& session, Result<int> done) {
  if (!done) DOBRA_TRY_VOID(dobra::cli::tell_refusal(session, done.error()));
  return done;
}

/// The document with nothing but a step surface: its own with what the options say, or a new one.
Result<scenario::Document> with_surface_step(const Session& session, const SpaceOptions& options) {
  DOBRA_TRY(scenario::Document document, scenario::read_document(options.file));
  document.expects.clear();
  const auto own = std::find_if(document.steps.begin(), document.steps.end(),
                                [](const scenario::Step& step) { return step.operation == "surface"; });
  scenario::Step step{"surface", "", {}, "", {}};
  if (own != document.steps.end()) step = *own;
  DOBRA_TRY_VOID(options.surface.set(session.program.find_operation("surface")->fields, step.params));
  document.steps = {std::move(step)};
  return document;
}

Result<int> surface_job(Session& session, const SpaceOptions& options) {
  if (options.out) {
    DOBRA_TRY_VOID(space::check_surface_ending(options.out->string()));
    DOBRA_TRY_VOID(dobra::cli::check_writable(*options.out));
  }
  DOBRA_TRY(const scenario::Document document, with_surface_step(session, options));
  DOBRA_TRY_VOID(scenario::check(document, session.program));
  DOBRA_TRY(const scenario::Run run, dobra::cli::run_steps(session, document));
  const auto& model = scenario::model_of<model::Model>(run.states.back());
  if (options.out) {
    DOBRA_TRY_VOID(dobra::cli::write_whole(session, *options.out, [&](const std::filesystem::path& path) {
      return space::write_surfaces(path.string(), *model.findings.get<space::MadeSurfaces>());
    }));
  }
  DOBRA_TRY_VOID(as_json(session) ? dobra::cli::print_json(surfaces_json(model))
                                  : dobra::cli::print(surfaces_table(model)));
  return 0;
}

/// A document of several sections in space: surfaces through them, cut over the trace.
Result<int> cut_surfaces(Session& session, const SpaceOptions& options) {
  DOBRA_TRY_VOID(check_out(options.out));
  DOBRA_TRY(scenario::Document document, with_surface_step(session, options));
  DOBRA_TRY(scenario::Step step, step_of(session, "cut", options.cut));
  const scenario::Value* const trace = step.params.find("trace");
  if (trace == nullptr)
    return base::Error{base::ErrorCode::BadUsage, "give --trace x0,y0,x1,y1: where the cut runs on the map"};
  if (const auto good = space::plan_trace(std::get<std::vector<double>>(*trace), "--trace"); !good)
    return base::Error{base::ErrorCode::BadUsage, good.error().message, good.error().place};
  document.steps.push_back(std::move(step));
  DOBRA_TRY_VOID(scenario::check(document, session.program));
  DOBRA_TRY(const scenario::Run run, dobra::cli::run_steps(session, document));
  const auto& model = scenario::model_of<model::Model>(run.states.back());
  const auto& cut = *model.findings.get<space::CutSection>();
  const std::string from =
      document.title.empty() ? std::filesystem::path(options.file).stem().string() : document.title;
  const scenario::Document section = core::document_of(cut, fmt::format("{}, cut", from));
  DOBRA_TRY_VOID(write_out(session, options.out, section, run.states.back(), cut.section));
  DOBRA_TRY_VOID(as_json(session) ? dobra::cli::print_json(cut_json(model)) : dobra::cli::print(cut_table(model)));
  return 0;
}

/// The block of a document: one section that is extruded, or several that are lofted.
Result<int> cut_whole_block(Session& session, const SpaceOptions& options) {
  scenario::Table cut;
  DOBRA_TRY_VOID(options.cut.set(scenario::fields_of<space::CutParams>(), cut));
  if (options.surface.any() || cut.find("simplify") != nullptr)
    return base::Error{base::ErrorCode::BadUsage,
                       "options of surfaces are for documents with [[input.section]] that are cut through them, and "
                       "this one is cut as a block"};
  BlockCutOptions block{options.file, {}, options.out};
  DOBRA_TRY_VOID(options.block.set(session.program.input_fields, block.input));
  if (const scenario::Value* trace = cut.find("trace")) block.input.set("cut", *trace);
  return cut_block(session, block);
}

/// What is cut goes by what the document holds.
Result<int> cut_job(Session& session, const SpaceOptions& options) {
  if (std::filesystem::path(options.file).extension() != ".toml") return cut_whole_block(session, options);
  DOBRA_TRY(const scenario::Document document, scenario::read_document(options.file));
  if (document.input.find("section") == nullptr) return cut_whole_block(session, options);
  if (options.block.any())
    return base::Error{base::ErrorCode::BadUsage,
                       "--along-strike is for a document of one section; this one has several in space"};
  DOBRA_TRY(const ThroughParams cut, options.through.read());
  if (cut.through == CutThrough::Block) return cut_whole_block(session, options);
  return cut_surfaces(session, options);
}

}  // namespace

dobra::cli::Command surface_command() {
  return {"surface", "Lay surfaces through equally named lines of several sections", [](CLI::App& app) -> Job {
            const auto options = std::make_shared<SpaceOptions>();
            add_space(app, *options);
            add_out_file(app, options->out, fmt::format("Surfaces ({})", fmt::join(space::surface_endings(), " ")));
            return [options](Session& session) { return with_refusal(session, surface_job(session, *options)); };
          }};
}

dobra::cli::Command cut_command() {
  return {"cut", "Cut a new section out of surfaces through sections, or out of a block", [](CLI::App& app) -> Job {
            const auto options = std::make_shared<SpaceOptions>();
            add_space(app, *options);
            options->cut.add(app, scenario::fields_of<space::CutParams>());
            options->block.add(app, scenario::fields_of<input::SectionInput>(), {"along_strike"});
            options->through.add(app);
            add_out(app, options->out, "lines of the new section");
            app.footer(
                "A block is cut over two places, --trace x0,y0,x1,y1 without further corners, and --out is a scenario "
                "(.toml); pictures, lines and corners are for sections that are cut through surfaces.\n\n" +
                app.get_footer());
            return [options](Session& session) { return with_refusal(session, cut_job(session, *options)); };
          }};
}

}  // namespace recon::cli
