#include "recon/balance/face_ledger.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "recon/maps/area_change.h"
#include "shared/base/parallel.h"
#include "shared/geom/place.h"

namespace recon::balance {

std::vector<section::RockUnit> units_by_faces(const section::Section& section) {
  std::vector<section::RockUnit> units;
  if (!section.faces || !section.units.empty()) return units;
  std::copy_if(section.faces->units.begin(), section.faces->units.end(), std::back_inserter(units),
               [](const section::RockUnit& unit) { return !unit.whole; });
  return units;
}

section::BedRole role_of(const section::Section& section, std::optional<std::size_t> one,
                         std::optional<std::size_t> other) {
  for (const auto& horizon : {one, other}) {
    if (horizon && section.horizons[*horizon].role == section::BedRole::Growth) return section::BedRole::Growth;
  }
  return section::BedRole::Judged;
}

section::BedRole role_of(const section::Section& section, const section::RockUnit& unit) {
  const bool has_surface =
      std::any_of(section.lines.begin(), section.lines.end(),
                  [](const section::SectionLine& line) { return line.kind == section::LineKind::Topography; });
  const bool is_closed = section.border || (unit.base && (unit.top || has_surface));
  return is_closed ? role_of(section, unit.top, unit.base) : section::BedRole::Outside;
}

std::vector<geom::Polyline> images_of(std::span<const geom::Polyline> contours, const maps::SectionMap& map) {
  return base::parallel_map<geom::Polyline>(contours.size(),
                                            [&](std::size_t i) { return map.forward(contours[i]).after; });
}

double area_of(std::span<const geom::Polyline> contours) {
  double area = 0.0;
  for (const geom::Polyline& contour : contours) area += geom::signed_area(contour);
  return std::abs(area);
}

void measure_faces(const section::Section& section, const maps::SectionMap& map, Ledger& ledger) {
  for (const section::RockUnit& unit : units_by_faces(section)) {
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

std::vector<RestoredBed> restored_beds(const section::Section& section, const std::vector<LedgerUnit>& units,
                                       const std::vector<UnitRow>& rows) {
  std::vector<RestoredBed> beds;
  for (std::size_t i = 0; i < units.size(); ++i) {
    const UnitRow& row = rows[i];
    if (!row.thickness_after || !units[i].upper) continue;
    const RestoredBed one{fmt::format("{} - {}", whole_name(section.horizons[*units[i].upper]),
                                      whole_name(section.horizons[*units[i].lower])),
                          *units[i].upper, row.area_before, row.thickness_after->mean};
    const auto same = [&](const RestoredBed& bed) { return bed.name == one.name; };
    const auto bed = std::find_if(beds.begin(), beds.end(), same);
    if (bed == beds.end()) {
      beds.push_back(one);
      continue;
    }
    const double area = bed->area + one.area;
    if (area > 0.0) bed->thickness = (bed->thickness * bed->area + one.thickness * one.area) / area;
    bed->area = area;
  }
  return beds;
}

std::optional<std::string> missing_area(const section::Section& section, const Ledger& ledger) {
  if (!section.faces || !section.units.empty()) return std::nullopt;
  constexpr double rounding = 1e-8;
  double all = 0.0;
  double in_rows = 0.0;
  std::vector<std::string> missing;
  for (const UnitRow& row : ledger.units) in_rows += row.area_before;
  for (const section::RockUnit& unit : section.faces->units) {
    all += unit.area;
    const bool found = std::any_of(ledger.units.begin(), ledger.units.end(), [&](const UnitRow& row) {
      return row.name == unit.name && std::abs(row.area_before - unit.area) <= rounding * unit.area;
    });
    if (found || unit.contours.empty()) continue;
    const geom::Point at = unit.contours.front().points.front();
    missing.push_back(fmt::format("'{}' of {:.6g} m2 at {}", unit.name, unit.area, at));
  }
  if (std::abs(all - in_rows) <= rounding * all) return std::nullopt;
  return fmt::format(
      "the rows of the units have {:.6g} m2, but the units of the section {:.6g} m2: the verdict on areas leaves out "
      "{}",
      in_rows, all, missing.empty() ? "none of them, and has some twice" : fmt::format("{}", fmt::join(missing, ", ")));
}

}  // namespace recon::balance
