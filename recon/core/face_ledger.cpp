#include "recon/core/face_ledger.h"

#include <algorithm>
#include <cmath>

#include "recon/core/section_faces.h"
#include "shared/base/parallel.h"

namespace recon::core {

namespace {

double area_of(const std::vector<geom::Polyline>& contours) {
  double area = 0.0;
  for (const geom::Polyline& contour : contours) area += geom::signed_area(contour);
  return area;
}

bool is_between(const RockUnit& unit, std::size_t one, std::size_t other) {
  return unit.whole && ((unit.top == one && unit.base == other) || (unit.top == other && unit.base == one));
}

}  // namespace

bool is_whole_unit(const Section& section, std::size_t one, std::size_t other) {
  if (!section.faces) return true;
  const std::vector<RockUnit>& units = section.faces->units;
  return std::any_of(units.begin(), units.end(), [&](const RockUnit& unit) { return is_between(unit, one, other); });
}

void measure_faces(const Section& section, const SectionMap& map, Ledger& ledger) {
  if (!section.faces || !section.units.empty()) return;
  for (const RockUnit& unit : section.faces->units) {
    if (unit.whole) continue;
    UnitRow row;
    row.name = unit.name;
    row.faces_before = unit.contours;
    row.faces_after = base::parallel_map<geom::Polyline>(
        unit.contours.size(), [&](std::size_t i) { return map.forward(unit.contours[i]).after; });
    row.area_before = unit.area;
    row.area_after = std::abs(area_of(row.faces_after));
    row.change_percent = unit.area == 0.0 ? 0.0 : 100.0 * (row.area_after - row.area_before) / row.area_before;
    ledger.units.push_back(std::move(row));
  }
}

}  // namespace recon::core
