#include "recon/cli/block_commands.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>

#include "recon/block/block_mesh.h"
#include "recon/block/cut.h"
#include "recon/block/cut_input.h"
#include "recon/cli/block_document.h"
#include "recon/cli/section_document.h"
#include "recon/cli/section_options.h"
#include "recon/input/section_input.h"
#include "shared/base/finding_text.h"
#include "shared/cli/findings.h"
#include "shared/cli/staging.h"
#include "shared/io/formats/boundary_file.h"

namespace recon::cli {
namespace {

namespace scenario = dobra::scenario;
using base::Error;
using base::ErrorCode;
using base::Finding;
using base::Result;
using dobra::cli::Job;
using dobra::cli::Session;
using nlohmann::ordered_json;

struct BlockOptions {
  SectionOptions section{dobra::cli::OutOfRange::BadUsage};
  std::optional<std::filesystem::path> out;
};

bool as_json(const Session& session) { return session.options.format == dobra::cli::OutputFormat::Json; }

/// A refusal as JSON too.
Result<int> with_findings(Session& session, Result<int> done) {
  if (!done) DOBRA_TRY_VOID(dobra::cli::tell_refusal(session, done.error()));
  return done;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

ordered_json json_of(const block::BlockUnit& unit) {
  const dobra::solid::Counts counts = unit.solid.counts();
  return {{"name", unit.name},           {"volume", unit.volume},   {"area", unit.area},
          {"parts", unit.parts},         {"shells", counts.shells}, {"genus", counts.handles},
          {"vertices", counts.vertices}, {"edges", counts.edges},   {"faces", counts.faces}};
}

ordered_json json_of(const block::Block& block) {
  ordered_json json;
  json["along_strike"] = block.length;
  json["area"] = block.area;
  json["volume"] = block.volume;
  json["vertices"] = block.counts.vertices;
  json["edges"] = block.counts.edges;
  json["faces"] = block.counts.faces;
  json["units"] = ordered_json::array();
  for (const block::BlockUnit& unit : block.units) json["units"].push_back(json_of(unit));
  return json;
}

Result<void> write_block(Session& session, const block::Block& block, const std::filesystem::path& out) {
  DOBRA_TRY(const block::BlockMesh mesh, mesh_of(block, dobra::io::formats::most_corners(out.string())));
  return dobra::cli::write_whole(session, out, [&](const std::filesystem::path& path) {
    return dobra::io::formats::write_boundary(path.string(), mesh.mesh, mesh.groups);
  });
}

std::string table_of(const block::Block& block) {
  std::string text = fmt::format("{:>16} {:>16}  unit\n", "volume [m3]", "area [m2]");
  for (const block::BlockUnit& unit : block.units)
    text += fmt::format("{:>16.8g} {:>16.8g}  {}\n", unit.volume, unit.area, unit.name);
  return text + fmt::format("{:>16.8g} {:>16.8g}  all; {} vertices, {} edges, {} faces\n", block.volume, block.area,
                            block.counts.vertices, block.counts.edges, block.counts.faces);
}

Result<int> block_job(Session& session, const BlockOptions& options) {
  if (options.out) {
    DOBRA_TRY_VOID(dobra::io::formats::check_boundary_ending(options.out->string()));
    DOBRA_TRY_VOID(dobra::cli::check_writable(*options.out));
  }
  const auto start = std::chrono::steady_clock::now();
  DOBRA_TRY(const scenario::Table lines, options.section.lines.table());
  DOBRA_TRY(scenario::Document document, document_of(session, options.section, lines));
  DOBRA_TRY(const block::Block block, block_of(session, std::move(document), LengthSaidBy::Option));
  const double made = seconds_since(start);
  if (options.out) DOBRA_TRY_VOID(write_block(session, block, *options.out));
  if (as_json(session)) {
    ordered_json json = json_of(block);
    json["seconds"] = {{"block", made}, {"write", seconds_since(start) - made}};
    json["findings"] = dobra::cli::findings_json(block.findings, {});
    DOBRA_TRY_VOID(dobra::cli::print_json(json));
    return 0;
  }
  for (const Finding& finding : block.findings) session.note(base::line_of(finding));
  DOBRA_TRY_VOID(dobra::cli::print(table_of(block)));
  return 0;
}

/// Names of the lines of a kind.
std::vector<std::string> faults_of(const section::Section& section) {
  std::vector<std::string> names;
  for (const section::SectionLine& line : section.lines) {
    if (line.kind == section::LineKind::Fault) names.push_back(line.name);
  }
  return names;
}

ordered_json json_of(const block::BlockCut& cut) {
  ordered_json json;
  json["area"] = cut.area;
  json["units"] = ordered_json::array();
  for (const block::CutUnit& unit : cut.units)
    json["units"].push_back({{"name", unit.name}, {"area", unit.area}, {"parts", unit.parts}});
  json["horizons"] = horizon_names(cut.section);
  json["faults"] = faults_of(cut.section);
  json["contact"] = dobra::solid::name(cut.contact);
  return json;
}

Result<void> check_cut_out(const BlockCutOptions& options) {
  if (!options.out) return {};
  if (options.out->extension() != ".toml") {
    return Error{ErrorCode::BadUsage, fmt::format("--out {}: the section is a scenario; give a name that ends in .toml",
                                                  options.out->string())};
  }
  return dobra::cli::check_writable(*options.out);
}

Result<int> cut_job(Session& session, const BlockCutOptions& options) {
  DOBRA_TRY_VOID(check_cut_out(options));
  if (std::filesystem::path(options.file).extension() != ".toml")
    return Error{ErrorCode::BadUsage, "FILE: give a scenario (.toml) that says how far its section goes on"};
  DOBRA_TRY(scenario::Document document, section_document(session, {options.file, {}}));
  for (const auto& entry : options.input.entries()) document.input.set(entry.key, entry.value);
  const scenario::Table original = document.input;
  DOBRA_TRY(const std::vector<double> trace, trace_of_cut(document));
  document.input.erase("cut");
  const std::filesystem::path folder = document.folder();
  DOBRA_TRY(const block::Block block, block_of(session, std::move(document), LengthSaidBy::Option));
  const auto frame = cut_over(block, {trace[0], trace[1]}, {trace[2], trace[3]});
  if (!frame) return Error{ErrorCode::BadValue, "--trace: " + frame.error().message};
  DOBRA_TRY(block::BlockCut made, cut(block, *frame));
  if (made.empty()) {
    made.findings.back().message += "; no file is written";
  } else {
    scenario::Document section = document_of_cut(made, original, trace);
    if (block.placed) section.input.erase("orientation");  // the trace tells it
    if (options.out) take_colours(original, folder, options.out->parent_path(), section);
    if (auto flaw = flaw_of(session, section, options.out.value_or(""))) {
      if (options.out) {
        return Error{ErrorCode::CannotWrite, flaw->message + "; no file is written, move the trace", flaw->place};
      }
      made.findings.push_back(std::move(*flaw));
    }
    if (options.out) {
      DOBRA_TRY_VOID(dobra::cli::write_whole(session, *options.out, [&](const std::filesystem::path& path) {
        return scenario::write_document(section, path);
      }));
    }
  }
  std::vector<Finding> findings = block.findings;
  findings.insert(findings.end(), made.findings.begin(), made.findings.end());
  if (as_json(session)) {
    ordered_json json = json_of(made);
    json["trace"] = trace;
    json["findings"] = dobra::cli::findings_json(findings, {});
    DOBRA_TRY_VOID(dobra::cli::print_json(json));
    return 0;
  }
  for (const Finding& finding : findings) session.note(base::line_of(finding));
  std::string text = fmt::format("{:>16}  unit\n", "area [m2]");
  for (const block::CutUnit& unit : made.units) text += fmt::format("{:>16.8g}  {}\n", unit.area, unit.name);
  DOBRA_TRY_VOID(dobra::cli::print(text + fmt::format("{:>16.8g}  all\n", made.area)));
  return 0;
}

}  // namespace

dobra::cli::Command block_command() {
  return {"block", "Make a section, extruded along strike, or several, lofted, a block of solids, one a unit",
          [](CLI::App& app) -> Job {
            const auto options = std::make_shared<BlockOptions>();
            std::vector<dobra::cli::OptionOf> keys = section_keys();
            keys.emplace_back("along_strike");
            options->section.add(app, keys);
            add_out_file(app, options->out, fmt::format("{}", fmt::join(dobra::io::formats::boundary_endings(), " ")));
            return [options](Session& session) { return with_findings(session, block_job(session, *options)); };
          }};
}

Result<int> cut_block(Session& session, const BlockCutOptions& options) { return cut_job(session, options); }

}  // namespace recon::cli
