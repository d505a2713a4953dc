#include "recon/cli/section_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>

#include "recon/cli/section_document.h"
#include "recon/core/report.h"
#include "recon/input/section_input.h"
#include "shared/cli/pictures.h"
#include "shared/cli/staging.h"
#include "shared/io/formats/line_files.h"

namespace recon::cli {

namespace io = dobra::io;
namespace scenario = dobra::scenario;
using base::Result;
using dobra::cli::ParameterOptions;
using dobra::cli::Session;

namespace {

/// What --out is, by its ending.
enum class OutKind { Scenario, Picture, Lines };

Result<OutKind> out_kind(const std::filesystem::path& out) {
  if (out.extension() == ".toml") return OutKind::Scenario;
  if (dobra::cli::check_ending(out, dobra::cli::Drawer::Cairo)) return OutKind::Picture;
  if (io::formats::line_format_of(out.string())) return OutKind::Lines;
  return base::Error{base::ErrorCode::BadUsage,
                     fmt::format("--out {}: give a picture ({}), a scenario (.toml), or a file of "
                                 "lines ({})",
                                 out.string(), dobra::cli::picture_endings(),
                                 fmt::join(io::formats::endings_for(io::formats::Use::WriteLines), " "))};
}

/// For formats that keep names and nothing else: pieces are called as their whole, by which they are found again. Where
/// names may not come twice, they keep theirs, such as "A (1)" and "A (2)".
void call_by_wholes(const section::Section& section, std::vector<io::lines::Feature>& features) {
  for (io::lines::Feature& feature : features) {
    for (const section::Horizon& horizon : section.horizons) {
      if (feature.kind != "fault" && feature.name == horizon.name) feature.name = whole_name(horizon);
    }
    for (const section::SectionLine& line : section.lines) {
      if (feature.kind == "fault" && feature.name == line.name) feature.name = whole_name(line);
    }
  }
}

}  // namespace

void add_file(CLI::App& app, std::string& file, const std::string& help) {
  app.add_option("file", file, help)->required()->type_name("FILE");
}

void add_out_file(CLI::App& app, std::optional<std::filesystem::path>& out, const std::string& what) {
  app.add_option("--out", out, what + " to write")->type_name("FILE");
}

void SectionOptions::add(CLI::App& app, const std::vector<dobra::cli::OptionOf>& input_keys) {
  add_file(app, file,
           fmt::format("The section: a scenario (.toml), or lines ({})",
                       fmt::join(io::formats::endings_for(io::formats::Use::ReadLines), " ")));
  lines.add(app, dobra::cli::LineOptions::Repairs::Offered);
  input.add(app, scenario::fields_of<input::SectionInput>(), input_keys);
}

std::vector<dobra::cli::OptionOf> section_keys() {
  return {"horizons_from_units", "self_crossings", "colours", "orientation"};
}

/// A file name as the scenario will look for it, whose names start from the folder of the section's file.
std::string as_seen_from(const scenario::Document& document, const std::string& file) {
  if (document.folder().empty()) return file;
  std::error_code ignored;
  const auto relative = std::filesystem::proximate(file, document.folder(), ignored);
  return ignored ? file : relative.string();
}

/// A step of the operation with what the options say.
base::Result<scenario::Step> step_of(const Session& session, const char* operation, const ParameterOptions& options) {
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

void add_out(CLI::App& app, std::optional<std::filesystem::path>& out, const char* what) {
  add_out_file(app, out,
               fmt::format("Picture ({}), {} ({}) or scenario (.toml)", dobra::cli::picture_endings(), what,
                           fmt::join(io::formats::endings_for(io::formats::Use::WriteLines), " ")));
}

Result<void> check_out(const std::optional<std::filesystem::path>& out) {
  if (!out) return {};
  DOBRA_TRY_VOID(out_kind(*out));
  return dobra::cli::check_writable(*out);
}

Result<void> write_out(Session& session, const std::optional<std::filesystem::path>& out,
                       const scenario::Document& document, const scenario::State& state,
                       const section::Section& section) {
  if (!out) return {};
  DOBRA_TRY(const OutKind kind, out_kind(*out));
  DOBRA_TRY(dobra::cli::Staging staging,
            dobra::cli::Staging::open(out->parent_path(), dobra::cli::TargetFolder::MustExist));
  const auto path = staging.path(out->filename().string());
  std::vector<std::string> losses;
  Result<void> written;
  if (kind == OutKind::Scenario) {
    written = scenario::write_document(document, path);
  } else if (kind == OutKind::Picture) {
    written =
        dobra::cli::draw(dobra::cli::picture_of(session.program, document, state), path, dobra::cli::Drawer::Cairo);
  } else {
    io::formats::LineWork work;
    work.features = core::restored_features(section);
    const io::formats::LineRow& row = *(*io::formats::line_format_of(out->string()))->lines;
    if (!row.keeps_properties && row.repeats_names) call_by_wholes(section, work.features);
    written = io::formats::write_any_lines(path.string(), work, {}, losses);
  }
  if (!written) return staging.for_user(written.error());
  for (const std::string& loss : losses) session.note(loss);
  DOBRA_TRY_VOID(session.check());
  DOBRA_TRY_VOID(staging.commit());
  return {};
}

}  // namespace recon::cli
