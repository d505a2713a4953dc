#include "shared/cli/offset_command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "shared/cli/offset_report.h"
#include "shared/cli/parameter_options.h"
#include "shared/cli/pictures.h"
#include "shared/cli/staging.h"
#include "shared/offset/offset.h"
#include "shared/operations/offset_step.h"

namespace dobra::cli {
namespace {

using base::Error;
using base::ErrorCode;
using base::Result;
using operations::Offsets;

struct OffsetOptions {
  std::string file;
  ParameterOptions parameters{OutOfRange::BadUsage};
  std::optional<std::filesystem::path> out;
};

/// The parameters of the step. Lengths are in the unit of the file, whatever that is.
std::vector<scenario::Field> fields() {
  auto all = scenario::fields_of<operations::OffsetParams>();
  std::erase_if(all, [](const scenario::Field& field) { return field.key == "file"; });
  for (scenario::Field& field : all) field.options.unit.clear();
  return all;
}

/// Curves are taken as they stand: a plane, whatever it is, and whatever its unit is.
Result<io::formats::LineWork> read_lines(Session& session, const std::string& file) {
  io::formats::LineOptions options;
  options.coordinates = io::formats::Coordinates::Section;
  options.y_direction = io::lines::YDirection::Up;
  options.unit_wanted = io::formats::UnitWanted::OfTheFile;
  options.faulty = io::lines::Faulty::Skip;
  DOBRA_TRY(io::formats::LineWork read, io::formats::read_any_lines(file, options));
  for (const std::string& remark : read.remarks) session.note(remark);
  if (read.system && read.system->degrees) {
    session.note(
        fmt::format("{}: its coordinates are in degrees ({}), and so are the distances", file, read.system->name));
  }
  if (read.stated_unit && *read.stated_unit != 1.0) {
    session.note(fmt::format("{}: its unit is {} m, and so is that of the distances", file, *read.stated_unit));
  }
  return read;
}

Result<void> write_out(Session& session, const std::filesystem::path& out, const Offsets& made) {
  DOBRA_TRY(const OffsetFile kind, offset_file(out));
  if (made.stage && kind == OffsetFile::Lines) {
    return Error{ErrorCode::BadUsage,
                 fmt::format("--out {}: the curves are not done, so there are none to write: raise --stop-after, or "
                             "leave it out; a picture shows the work",
                             out.string())};
  }
  DOBRA_TRY(Staging staging, Staging::open(out.parent_path(), TargetFolder::MustExist));
  const std::filesystem::path path = staging.path(out.filename().string());
  std::vector<std::string> remarks;
  const auto written = kind == OffsetFile::Picture
                           ? draw(offset_picture(made.families, made.stage), path, Drawer::Cairo)
                           : write_offset(made.families, made.origin, path, remarks);
  if (!written) return staging.for_user(written.error());
  for (const std::string& remark : remarks) session.note(fmt::format("{}: {}", out.string(), remark));
  DOBRA_TRY_VOID(session.check());
  DOBRA_TRY_VOID(staging.commit());
  return {};
}

/// Says what the verifier found, and what it was not asked about; the exit code.
int announce(Session& session, const Offsets& made, const operations::OffsetPlan& plan) {
  for (const std::string& finding : made.verdict.findings) session.error_line(finding);
  for (const std::string& line : verdict_text(made, plan)) session.note(line);
  return made.verdict.findings.empty() ? 0 : 1;
}

Result<int> offset_job(Session& session, const OffsetOptions& options) {
  const operations::OffsetCaller caller{.speaks = operations::OffsetCaller::Speaks::Options,
                                        .note = [&](const std::string& note) { session.note(note); },
                                        .progress = session.progress()};
  // Everything about the options first: a wrong one is told before a long file is read.
  scenario::Table table;
  DOBRA_TRY_VOID(options.parameters.set(fields(), table));
  DOBRA_TRY(const auto plan, offset_plan(scenario::from_table<operations::OffsetParams>(table), caller));
  if (options.out) {
    DOBRA_TRY_VOID(offset_file(*options.out));
    DOBRA_TRY_VOID(check_writable(*options.out));
  }
  DOBRA_TRY(io::formats::LineWork lines, read_lines(session, options.file));
  DOBRA_TRY(const Offsets made, offset_curves(caller, plan, std::move(lines), options.file));
  if (options.out) DOBRA_TRY_VOID(write_out(session, *options.out, made));
  if (session.options.format == OutputFormat::Json) {
    DOBRA_TRY_VOID(print(offset_json(made.families, made.stage)));
  } else if (!options.out) {
    DOBRA_TRY_VOID(print(offset_table(made.families)));
  } else if (session.options.verbosity != Verbosity::Quiet) {
    DOBRA_TRY_VOID(print(options.out->string() + '\n'));
  }
  return made.verified ? announce(session, made, plan) : 0;
}

}  // namespace

Command offset_command() {
  return {"offset", "Curves parallel to the curves of a file", [](CLI::App& app) -> Job {
            const auto options = std::make_shared<OffsetOptions>();
            app.add_option(
                   "file", options->file,
                   fmt::format("Curves: {}", fmt::join(io::formats::endings_for(io::formats::Use::ReadLines), " ")))
                ->required()
                ->type_name("FILE");
            options->parameters.add(app, fields());
            app.add_option("--out", options->out,
                           fmt::format("File to write: {}; or a picture: {}",
                                       fmt::join(io::formats::endings_for(io::formats::Use::WritePlaneLines), " "),
                                       picture_endings()))
                ->type_name("FILE");
            return [options](Session& session) { return offset_job(session, *options); };
          }};
}

}  // namespace dobra::cli
