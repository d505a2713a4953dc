#include "recon/cli/section_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "shared/io/curves.h"
#include "shared/io/geojson.h"

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
  if (feature.type == io::FeatureType::Polygons) return "polygon";
  for (const char* kind : {"fault", "pin", "loose"}) {
    if (feature.kind == kind) return kind;
  }
  return "horizon";
}

base::Result<void> add_geojson(const std::string& file, InputTables& tables) {
  DOBRA_TRY(const io::Features read, io::read_geojson(file));
  std::size_t number = 0;
  for (const io::Feature& feature : read.features) {
    ++number;
    for (const dobra::geom::Polyline& part : feature.parts) {
      const std::string name = feature.name.empty() ? fmt::format("feature {}", number) : feature.name;
      tables.add(key_of(feature), name, part.points);
    }
  }
  return {};
}

bool ends_with_any(std::string name, std::initializer_list<const char*> endings) {
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
  return std::any_of(endings.begin(), endings.end(), [&](const char* ending) { return name.ends_with(ending); });
}

}  // namespace

base::Result<scenario::Document> section_document(const std::string& file, const FileConvention& convention) {
  if (ends_with_any(file, {".toml"})) {
    if (!convention.unit.empty() || !convention.y_axis.empty()) {
      return base::Error{base::ErrorCode::BadUsage,
                         "--unit and --y-axis are for files of lines; a scenario says it in its [input]"};
    }
    DOBRA_TRY(scenario::Document document, scenario::read_document(file));
    document.steps.clear();
    document.expects.clear();
    return document;
  }
  InputTables tables;
  if (ends_with_any(file, {".geojson", ".json"})) {
    DOBRA_TRY_VOID(add_geojson(file, tables));
  } else {
    DOBRA_TRY(const io::Curves read, io::read_curves(file));
    for (const io::NamedCurve& curve : read.curves)
      tables.add(curve.line.closed ? "polygon" : "horizon", curve.name, curve.line.points);
  }
  scenario::Document document;
  document.program = "recon";
  document.title = file;
  if (!convention.unit.empty()) document.input.set("unit", convention.unit);
  if (!convention.y_axis.empty()) {
    document.input.set("y_axis", convention.y_axis);
    document.input.set("reference", convention.reference);
  }
  tables.write(document.input);
  return document;
}

}  // namespace recon::cli
