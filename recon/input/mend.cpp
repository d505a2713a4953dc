#include "recon/input/mend.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "recon/input/items.h"
#include "recon/section/file_rounding.h"
#include "recon/section/rejoin.h"
#include "shared/geom/place.h"
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

/// The lines of a section that end on each other: horizons, faults, topographies, the border.
class EndingLines {
 public:
  explicit EndingLines(section::Section& section) {
    for (section::Horizon& horizon : section.horizons) add("horizon", whole_name(horizon), horizon.line);
    for (section::SectionLine& line : section.lines) {
      if (line.kind == section::LineKind::Fault) add("fault", line.name, line.line);
      if (line.kind == section::LineKind::Topography) add("topography", line.name, line.line);
    }
    if (section.border) add("border", "border", *section.border);
  }
  std::vector<io::lines::Feature> features;  ///< Called as their wholes.
  void take() {
    for (std::size_t i = 0; i < lines_.size(); ++i) *lines_[i] = features[i].parts.front();
  }

 private:
  void add(const char* kind, const std::string& name, geom::Polyline& line) {
    features.push_back(feature_of(io::lines::FeatureType::Lines, kind, name, line));
    lines_.push_back(&line);
  }
  std::vector<geom::Polyline*> lines_;
};

void remark(std::string text, geom::Point at, const std::string& item, ReadSection& read) {
  read.places[text] = geom::place_at(at, item);
  read.remarks.push_back(std::move(text));
}

/// "horizon 'top (2)'", of the line that ends there.
std::string line_ending_at(geom::Point at, const std::string& whole, const section::Section& section) {
  const auto ends = [&](const geom::Polyline& line) { return line.points.front() == at || line.points.back() == at; };
  for (const section::Horizon& horizon : section.horizons) {
    if (ends(horizon.line) && whole == fmt::format("horizon '{}'", whole_name(horizon)))
      return fmt::format("horizon '{}'", horizon.name);
  }
  return whole;
}

const io::formats::Repair& farthest(const std::vector<io::formats::Repair>& repairs) {
  return *std::max_element(repairs.begin(), repairs.end(),
                           [](const auto& a, const auto& b) { return a.moved < b.moved; });
}

/// What rounding has been joined, and over which points that lie off the grid.
void tell_joined(const std::vector<io::formats::Repair>& repairs, const section::FileGrid& grid, ReadSection& read) {
  const io::formats::Repair& far = farthest(repairs);
  const std::string item = line_ending_at(far.at, far.item, read.section);
  remark(repairs.size() == 1
             ? fmt::format("1 end of a line lay beside the line that it ends on, no farther than the coordinates are "
                           "rounded, to {:g} m, and is joined to it: moved {:.3g} m, at {}, {}; snap_to_faults = 0 "
                           "leaves it apart",
                           grid.step, far.moved, far.at, item)
             : fmt::format("{} ends of lines lay beside the lines that they end on, no farther than the coordinates "
                           "are rounded, to {:g} m, and are joined to them: moved up to {:.3g} m, the farthest at {}, "
                           "{}; snap_to_faults = 0 leaves them apart",
                           repairs.size(), grid.step, far.moved, far.at, item),
         far.at, item, read);
  if (grid.odd == 0) return;
  remark(grid.odd == 1 ? fmt::format("1 of {} points is no multiple of {:g} m, as the others are, at {}, {}",
                                     grid.points, grid.step, grid.odd_place, grid.odd_line)
                       : fmt::format("{} of {} points are no multiples of {:g} m, as the others are, the first at {}, "
                                     "{}",
                                     grid.odd, grid.points, grid.step, grid.odd_place, grid.odd_line),
         grid.odd_place, grid.odd_line, read);
}

/// Ends that rounding may have parted from their fault, but that are too far from it for the size of the section.
/// @param lines  as they were read.
base::Result<void> tell_too_far(std::vector<io::lines::Feature> lines, const section::FileGrid& grid, double reach,
                                ReadSection& read) {
  if (grid.cell <= reach) return {};
  io::formats::RepairOptions options;  // as if snap_to_faults were said
  options.snap = grid.cell;
  DOBRA_TRY(std::vector<io::formats::Repair> repairs, io::formats::repair(lines, options));
  std::erase_if(repairs, [&](const io::formats::Repair& repair) { return repair.moved < reach; });
  if (repairs.empty()) return {};
  const io::formats::Repair& far = farthest(repairs);
  const double snap = section::tolerance_above(far.moved);
  remark(
      repairs.size() == 1
          ? fmt::format("1 end of a horizon lies farther beside its fault than a ten-thousandth of the section, {:.3g} "
                        "m, though no farther than the coordinates are rounded, to {:g} m, and is not joined to it: "
                        "{:.3g} m, at {}, {}; snap_to_faults of {:g} m (--snap) joins it",
                        reach, grid.step, far.moved, far.at, far.item, snap)
          : fmt::format("{} ends of horizons lie farther beside their faults than a ten-thousandth of the section, "
                        "{:.3g} m, though no farther than the coordinates are rounded, to {:g} m, and are not "
                        "joined to them: up to {:.3g} m, the farthest at {}, {}; snap_to_faults of {:g} m (--snap) "
                        "joins them",
                        repairs.size(), reach, grid.step, far.moved, far.at, far.item, snap),
      far.at, far.item, read);
  return {};
}

/// Ends that no more than the rounding of the coordinates has parted from the line that they end on. Faults part what
/// ends on them, whatever else is near; so they come first. Where polygons say what the units are, nothing is moved.
base::Result<void> join_rounded_ends(ReadSection& read) {
  section::Section& section = read.section;
  const double diagonal = box_of(section).diagonal();
  constexpr double joined = 1e-9;  // of the diagonal: what is nearer is joined where faces are made
  const std::optional<section::FileGrid> grid = grid_of_files(section);
  io::formats::RepairOptions options;
  options.snap = rounding_of_coordinates(section);
  options.on_line = joined * diagonal;
  options.first_crossing = true;
  if (!grid || *options.snap <= options.on_line || !section.units.empty()) return {};
  using io::lines::Feature;
  const auto is_fault = [](const Feature& line) { return line.kind == "fault"; };
  const auto ends_at_side = [](const Feature& line) { return line.kind == "horizon" || line.kind == "fault"; };
  EndingLines lines(section);
  const std::vector<Feature> as_read = lines.features;
  std::vector<io::formats::Repair> repairs;
  using MaySnap = std::function<bool(const Feature&, const Feature&)>;
  const MaySnap faults_on_faults = [&](const Feature& line, const Feature& onto) {
    return is_fault(line) && is_fault(onto);
  };
  const MaySnap horizons_on_faults = [&](const Feature& line, const Feature& onto) {
    return line.kind == "horizon" && is_fault(onto);
  };
  const MaySnap on_others = [&](const Feature& line, const Feature& onto) {
    return ends_at_side(line) && !is_fault(onto) && (line.kind != onto.kind || line.name != onto.name);
  };
  // A branch that may not pass the end of a bed moves once that end lies on it, and takes it along.
  for (const MaySnap& may : {faults_on_faults, horizons_on_faults, faults_on_faults, horizons_on_faults, on_others}) {
    options.may_snap = may;
    DOBRA_TRY(const std::vector<io::formats::Repair> done, io::formats::repair(lines.features, options));
    repairs.insert(repairs.end(), done.begin(), done.end());
  }
  if (!repairs.empty()) {
    lines.take();
    tell_joined(repairs, *grid, read);
  }
  return tell_too_far(as_read, *grid, *options.snap, read);
}

}  // namespace

base::Result<void> mend(const SectionInput& input, ReadSection& read) {
  if (!input.snap_to_faults) DOBRA_TRY_VOID(join_rounded_ends(read));
  io::formats::RepairOptions options;
  if (input.snap_to_faults.value_or(0.0) > 0.0) options.snap = input.snap_to_faults;
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
