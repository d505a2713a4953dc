#include "recon/cli/section_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
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
  /// @param piece_of  the horizon that it is a piece of, if it is one.
  /// @param role  "growth", or nothing.
  void add(const std::string& key, std::string name, std::vector<Point> points, const std::string& piece_of,
           const std::string& role) {
    // Names must differ within a kind; a file may repeat them.
    const std::string wanted = name;
    for (int copy = 2; !names_.insert(key + '\n' + name).second; ++copy) name = fmt::format("{} ({})", wanted, copy);
    scenario::Table row;
    row.set("name", name);
    row.set("points", std::move(points));
    if (!piece_of.empty()) row.set("piece_of", piece_of);
    if (!role.empty()) row.set("role", role);
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

std::string name_of(const io::Feature& feature, std::size_t index) {
  return feature.name.empty() ? fmt::format("feature {}", index + 1) : feature.name;
}

struct Place {
  double from_left = 0.0;
  std::size_t feature = 0;
  std::size_t part = 0;
};

/// Where the pieces of each horizon stand, from the left: lines of one name, and the parts of one line.
std::map<std::string, std::vector<Place>> pieces_of(const std::vector<io::Feature>& features) {
  std::map<std::string, std::vector<Place>> pieces;
  for (std::size_t i = 0; i < features.size(); ++i) {
    if (key_of(features[i]) != "horizon") continue;
    for (std::size_t part = 0; part < features[i].parts.size(); ++part)
      pieces[name_of(features[i], i)].push_back({features[i].parts[part].box().centre().x, i, part});
  }
  for (auto& [name, places] : pieces) {
    std::stable_sort(places.begin(), places.end(),
                     [](const Place& a, const Place& b) { return a.from_left < b.from_left; });
  }
  return pieces;
}

InputTables tables_of(const std::vector<io::Feature>& features, dobra::cli::Session& session) {
  const auto pieces = pieces_of(features);
  InputTables tables;
  std::set<std::string> told;
  for (std::size_t i = 0; i < features.size(); ++i) {
    const std::string whole = name_of(features[i], i);
    const std::string role = features[i].kind == "growth" ? "growth" : "";
    for (std::size_t part = 0; part < features[i].parts.size(); ++part) {
      std::vector<Point> points = features[i].parts[part].points;
      if (features[i].parts[part].closed) points.push_back(points.front());  // it says that it closes
      const auto found = pieces.find(whole);
      if (key_of(features[i]) != "horizon" || found->second.size() == 1) {
        tables.add(key_of(features[i]), whole, std::move(points), {}, role);
        continue;
      }
      const auto at = std::find_if(found->second.begin(), found->second.end(),
                                   [&](const Place& p) { return p.feature == i && p.part == part; });
      tables.add("horizon", fmt::format("{} ({})", whole, at - found->second.begin() + 1), std::move(points), whole, role);
      if (told.insert(whole).second) {
        session.note(fmt::format("horizon '{0}' is in {1} pieces, numbered from the left: '{0} (1)' to '{0} ({1})'",
                                 whole, found->second.size()));
      }
    }
  }
  return tables;
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
  scenario::Document document;
  document.program = "recon";
  document.title = section.file;
  tables_of(work.features, session).write(document.input);
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
