#include "recon/cli/section_document.h"

#include <fmt/format.h>

#include <algorithm>

#include "recon/input/import.h"
#include "recon/input/line_file.h"
#include "shared/cli/line_options.h"
#include "shared/io/formats/line_files.h"

namespace recon::cli {

namespace {

namespace base = dobra::base;
namespace io = dobra::io;
namespace scenario = dobra::scenario;
using dobra::geom::Point;

/// The lines of a file as the tables of an input, in the order of the file.
void write_tables(std::vector<input::ImportedLine> lines, double join_gaps, scenario::Table& input) {
  std::vector<std::pair<std::string, std::vector<scenario::Table>>> tables;
  for (input::ImportedLine& line : lines) {
    scenario::Table row;
    row.set("name", std::move(line.name));
    row.set("points", std::move(line.line.points));
    if (!line.piece_of.empty()) row.set("piece_of", std::move(line.piece_of));
    if (line.role == section::BedRole::Growth) row.set("role", std::string("growth"));
    if (line.table == "horizon" && join_gaps > 0.0) row.set("join_gaps", join_gaps);
    if (line.order > 0) row.set("order", static_cast<std::int64_t>(line.order));
    if (line.hanging_wall != section::HangingWall::Auto)
      row.set("hanging_wall", std::string(section::hanging_wall_name(line.hanging_wall)));
    auto table = std::find_if(tables.begin(), tables.end(), [&](const auto& t) { return t.first == line.table; });
    if (table == tables.end()) table = tables.insert(table, {line.table, {}});
    table->second.push_back(std::move(row));
  }
  for (auto& [key, rows] : tables) input.set(key, std::move(rows));
}

}  // namespace

base::Result<scenario::Document> section_document(dobra::cli::Session& session, const SectionFile& section) {
  if (std::filesystem::path(section.file).extension() == ".toml") {
    if (!section.lines.empty()) {
      return base::Error{base::ErrorCode::BadUsage,
                         "options such as --unit are for files of lines; a scenario says it in its [input]"};
    }
    DOBRA_TRY(scenario::Document document, scenario::read_document(section.file));
    document.steps.clear();
    document.expects.clear();
    return document;
  }
  DOBRA_TRY(io::formats::LineOptions options, dobra::cli::line_options(section.lines));
  input::leave_horizons_apart(options.repair);
  DOBRA_TRY(const io::formats::LineWork work, io::formats::read_any_lines(section.file, options));
  for (const std::string& remark : work.remarks) session.note(remark);
  for (const io::formats::Repair& repair : work.repairs) session.note(io::formats::to_string(repair));
  scenario::Document document;
  document.program = "recon";
  document.title = std::filesystem::path(section.file).stem().string();
  DOBRA_TRY(input::Import import, input::import_lines(work.features));
  for (const std::string& remark : import.remarks) session.note(remark);
  write_tables(std::move(import.lines), options.repair.gaps.value_or(0.0), document.input);
  // Ends have been moved here; the section must not take it that nothing was said of them.
  if (const scenario::Value* const snap = section.lines.find("snap_to_faults"))
    document.input.set("snap_to_faults", *snap);
  if (work.trace || options.fold_axis) {
    const auto [left, right] = io::lines::ends_of(options.fold_axis ? io::lines::azimuth_of(*options.fold_axis)
                                                                    : io::lines::azimuth_of(*work.trace));
    document.input.set("orientation", fmt::format("{} - {}", left, right));
  }
  return document;
}

base::Result<std::vector<Point>> only_line(const std::string& file, const scenario::Table& lines) {
  DOBRA_TRY(const io::formats::LineOptions options, dobra::cli::line_options(lines));
  DOBRA_TRY(io::formats::LineWork work, io::formats::read_any_lines(file, options));
  std::vector<std::vector<Point>> found;
  for (io::lines::Feature& feature : work.features) {
    if (feature.type != io::lines::FeatureType::Lines) continue;
    for (dobra::geom::Polyline& part : feature.parts) found.push_back(std::move(part.points));
  }
  if (found.size() == 1) return std::move(found.front());
  return base::located({base::ErrorCode::BadFormat,
                        fmt::format("{} lines in the file; a target is one line, so keep just that one", found.size())},
                       {.file = file});
}

}  // namespace recon::cli
