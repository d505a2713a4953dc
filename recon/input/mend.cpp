#include "recon/input/mend.h"

#include <fmt/format.h>

#include <algorithm>

#include "recon/input/items.h"
#include "shared/io/formats/repair.h"

namespace recon::input {

namespace io = dobra::io;

namespace {

io::lines::Feature feature_of(io::lines::FeatureType type, const char* kind, const std::string& name,
                              const geom::Polyline& line) {
  io::lines::Feature feature;
  feature.type = type;
  feature.kind = kind;
  feature.name = name;
  feature.parts = {line};
  return feature;
}

/// Polygons that slivers took away are gone; the others have their new contour.
base::Result<void> take_polygons(const std::vector<io::lines::Feature>& features, section::Section& section) {
  std::vector<section::Unit> kept;
  for (section::Unit& unit : section.units) {
    const auto found = std::find_if(features.begin(), features.end(), [&](const io::lines::Feature& f) {
      return f.type == io::lines::FeatureType::Polygons && f.name == unit.name;
    });
    if (found == features.end()) continue;
    auto contour = closed_contour(found->parts.front());
    if (!contour) return base::located(contour.error(), base::Place{.item = fmt::format("unit '{}'", unit.name)});
    unit.contour = std::move(*contour);
    unit.id = section::UnitId(kept.size());
    kept.push_back(std::move(unit));
  }
  section.units = std::move(kept);
  return {};
}

}  // namespace

base::Result<void> mend(const SectionInput& input, ReadSection& read) {
  io::formats::RepairOptions options;
  if (input.snap_to_faults > 0.0) options.snap = input.snap_to_faults;
  if (input.share_edges > 0.0) options.edges = input.share_edges;
  if (input.slivers > 0.0) options.slivers = input.slivers;
  if (!options.snap && !options.edges && !options.slivers) return {};
  section::Section& section = read.section;
  std::vector<io::lines::Feature> features;
  for (const section::Horizon& horizon : section.horizons)
    features.push_back(feature_of(io::lines::FeatureType::Lines, "horizon", horizon.name, horizon.line));
  std::vector<section::SectionLine*> faults;
  for (section::SectionLine& line : section.lines) {
    if (line.kind != section::LineKind::Fault) continue;
    faults.push_back(&line);
    features.push_back(feature_of(io::lines::FeatureType::Lines, "fault", line.name, line.line));
  }
  for (const section::Unit& unit : section.units)
    features.push_back(feature_of(io::lines::FeatureType::Polygons, "unit", unit.name, unit.contour));
  DOBRA_TRY(const std::vector<io::formats::Repair> repairs, io::formats::repair(features, options));
  for (const io::formats::Repair& repair : repairs) read.remarks.push_back(io::formats::to_string(repair));
  for (std::size_t i = 0; i < section.horizons.size(); ++i) section.horizons[i].line = features[i].parts.front();
  for (std::size_t i = 0; i < faults.size(); ++i) faults[i]->line = features[section.horizons.size() + i].parts.front();
  return take_polygons(features, section);
}

}  // namespace recon::input
