#include "recon/cli/section_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "shared/cli/session.h"
#include "shared/io/line_files.h"

namespace recon::cli {

namespace {

namespace base = dobra::base;
namespace io = dobra::io;
namespace scenario = dobra::scenario;
using dobra::geom::Point;

/// The tables of an input by their key, in the order of the file.
class InputTables {
 public:
  void add(const std::string& key, std::string name, std::vector<Point> points) {
    // Names must differ within a kind; a file may repeat them.
    const std::string wanted = name;
    for (int copy = 2; !names_.insert(key + '\n' + name).second; ++copy) name = fmt::format("{} ({})", wanted, copy);
    scenario::Table row;
    row.set("name", name);
    row.set("points", std::move(points));
    for (auto& [known, rows] : tables_) {
      if (known != key) continue;
      rows.push_back(std::move(row));
      return;
    }
    tables_.push_back({key, {std::move(row)}});
  }

  void write(scenario::Table& input) const {
    for (const auto& [key, rows] : tables_) input.set(key, rows);
  }

 private:
  std::vector<std::pair<std::string, std::vector<scenario::Table>>> tables_;
  std::set<std::string> names_;
};

std::string key_of(const io::Feature& feature) {
  if (feature.type == io::FeatureType::Points) return "marker";
  if (feature.type == io::FeatureType::Polygons) return feature.kind == "border" ? "border" : "polygon";
  for (const char* kind : {"fault", "pin", "loose", "border", "topography", "datum"}) {
    if (feature.kind == kind) return kind;
  }
  if (feature.kind == "unit") return "polygon";  // a line that is to close
  return "horizon";
}

}  // namespace

base::Result<scenario::Document> section_document(dobra::cli::Session& session, const SectionFile& section) {
  if (std::filesystem::path(section.file).extension() == ".toml") {
    if (section.lines != dobra::cli::LineOptionTexts{}) {
      return base::Error{base::ErrorCode::BadUsage,
                         "options such as --unit are for files of lines; a scenario says it in its [input]"};
    }
    DOBRA_TRY(scenario::Document document, scenario::read_document(section.file));
    document.steps.clear();
    document.expects.clear();
    return document;
  }
  DOBRA_TRY(const io::LineOptions options, dobra::cli::line_options(section.lines));
  DOBRA_TRY(const io::LineWork work, io::read_any_lines(section.file, options));
  for (const std::string& remark : work.remarks) session.note(remark);
  for (const io::Repair& repair : work.repairs) session.note(io::to_string(repair));
  InputTables tables;
  std::size_t number = 0;
  for (const io::Feature& feature : work.features) {
    ++number;
    const std::string name = feature.name.empty() ? fmt::format("feature {}", number) : feature.name;
    for (const dobra::geom::Polyline& part : feature.parts) {
      std::vector<Point> points = part.points;
      if (part.closed) points.push_back(points.front());  // it says that it closes
      tables.add(key_of(feature), name, std::move(points));
    }
  }
  scenario::Document document;
  document.program = "recon";
  document.title = section.file;
  tables.write(document.input);
  return document;
}

base::Result<std::vector<Point>> only_line(const std::string& file, const dobra::cli::LineOptionTexts& lines) {
  DOBRA_TRY(const io::LineOptions options, dobra::cli::line_options(lines));
  DOBRA_TRY(io::LineWork work, io::read_any_lines(file, options));
  std::vector<std::vector<Point>> found;
  for (io::Feature& feature : work.features) {
    if (feature.type != io::FeatureType::Lines) continue;
    for (dobra::geom::Polyline& part : feature.parts) found.push_back(std::move(part.points));
  }
  if (found.size() == 1) return std::move(found.front());
  return base::located({base::ErrorCode::BadFormat,
                        fmt::format("{} lines in the file; a target is one line, so keep just that one", found.size())},
                       {.file = file});
}

}  // namespace recon::cli
