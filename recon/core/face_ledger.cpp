#include "recon/core/face_ledger.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "recon/core/area_change.h"
#include "shared/base/parallel.h"

namespace recon::core {

namespace {

bool is_between(const RockUnit& unit, std::size_t one, std::size_t other) {
  return unit.whole && ((unit.top == one && unit.base == other) || (unit.top == other && unit.base == one));
}

}  // namespace

bool is_whole_unit(const Section& section, std::size_t one, std::size_t other) {
  if (!section.faces) return true;
  const std::vector<RockUnit>& units = section.faces->units;
  return std::any_of(units.begin(), units.end(), [&](const RockUnit& unit) { return is_between(unit, one, other); });
}

std::vector<RockUnit> units_by_faces(const Section& section) {
  std::vector<RockUnit> units;
  if (!section.faces || !section.units.empty()) return units;
  std::copy_if(section.faces->units.begin(), section.faces->units.end(), std::back_inserter(units),
               [](const RockUnit& unit) { return !unit.whole; });
  return units;
}

BedRole role_of(const Section& section, std::optional<std::size_t> one, std::optional<std::size_t> other) {
  for (const auto& horizon : {one, other}) {
    if (horizon && section.horizons[*horizon].role == BedRole::Growth) return BedRole::Growth;
  }
  return BedRole::Judged;
}

BedRole role_of(const Section& section, const RockUnit& unit) {
  const bool has_surface = std::any_of(section.lines.begin(), section.lines.end(),
                                       [](const SectionLine& line) { return line.kind == LineKind::Topography; });
  const bool is_closed = section.border || (unit.base && (unit.top || has_surface));
  return is_closed ? role_of(section, unit.top, unit.base) : BedRole::Outside;
}

std::vector<geom::Polyline> images_of(std::span<const geom::Polyline> contours, const SectionMap& map) {
  return base::parallel_map<geom::Polyline>(contours.size(),
                                            [&](std::size_t i) { return map.forward(contours[i]).after; });
}

double area_of(std::span<const geom::Polyline> contours) {
  double area = 0.0;
  for (const geom::Polyline& contour : contours) area += geom::signed_area(contour);
  return std::abs(area);
}

void measure_faces(const Section& section, const SectionMap& map, Ledger& ledger) {
  for (const RockUnit& unit : units_by_faces(section)) {
    UnitRow row;
    row.name = unit.name;
    row.role = role_of(section, unit);
    row.faces_before = unit.contours;
    row.faces_after = images_of(row.faces_before, map);
    row.area_before = unit.area;
    row.area_after = area_of(row.faces_after);
    row.change_percent = unit.area == 0.0 ? 0.0 : 100.0 * (row.area_after - row.area_before) / row.area_before;
    if (const auto change = area_change_in(row.faces_before, map)) {
      row.dilatation = Range{change->least, 0.01 * row.change_percent, change->greatest};
      row.least_at = change->least_at;
      row.greatest_at = change->greatest_at;
    }
    ledger.units.push_back(std::move(row));
  }
}

}  // namespace recon::core
