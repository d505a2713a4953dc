#include "recon/unfold/restore.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "recon/balance/face_ledger.h"
#include "recon/balance/percent.h"
#include "recon/unfold/bed_order.h"
#include "recon/unfold/limits.h"
#include "shared/base/parallel.h"
#include "shared/geom/place.h"
#include "shared/geom/simplify.h"

namespace recon::unfold {

namespace {

std::string at_text(geom::Point p) { return fmt::format("{}", p); }

/// What a map is made of, in words.
struct MapWords {
  std::string torn;     ///< Where a line jumps.
  std::string beyond;   ///< Beyond the ends.
  std::string nowhere;  ///< A point that no cell holds.
  std::string cell;     ///< Of the target.
};

MapWords words_of(const maps::SectionMap& map, RestoreMethod method) {
  if (map.columns() != nullptr) {
    return {
        "crosses the medial axis of the top (places: {}), where the grid is not single-valued",
        "the top does not cover the section: points ({}) of horizon '{}' lie beyond its ends, the first at {}; there "
        "the grid was continued straight",
        "column of the grid and went with the nearest segment of the top", "column of the target grid"};
  }
  if (method == RestoreMethod::Shear) {
    return {
        "is torn by the shear (places: {})",
        "the top does not cover the section along the direction of shear: points ({}) of horizon '{}' lie beyond its "
        "ends, the first at {}; there the top was continued straight",
        "strip of the shear", "strip of the shear"};
  }
  return {
      "passes places ({}) where rulings between the horizons cross, so that the map is not single-valued",
      "the horizons that are joined by rulings do not cover the section: points ({}) of horizon '{}' lie beyond their "
      "ends, the first at {}; there the last ruling was moved along",
      "strip between rulings and went with the nearest one", "strip between the restored rulings"};
}

std::string tears_text(const std::vector<maps::Tear>& tears, const MapWords& words) {
  double torn = 0.0;
  const maps::Tear* widest = &tears.front();
  for (const maps::Tear& tear : tears) {
    torn += tear.gap;
    if (tear.gap > widest->gap) widest = &tear;
  }
  return fmt::format("{}: its restored line jumps there by {:.4g} m in all, most at {} by {:.4g} m",
                     fmt::format(fmt::runtime(words.torn), tears.size()), torn, at_text(widest->place), widest->gap);
}

void remark_on(const std::string& name, const maps::MappedLine& mapped, const MapWords& words, EndsOfTop ends,
               std::vector<std::string>& remarks) {
  if (!mapped.tears.empty()) remarks.push_back(fmt::format("horizon '{}' {}", name, tears_text(mapped.tears, words)));
  if (mapped.beyond_ends > 0 && ends == EndsOfTop::Open) {
    remarks.push_back(fmt::format(fmt::runtime(words.beyond), mapped.beyond_ends, name, at_text(*mapped.beyond_at)));
  }
  if (mapped.without_column > 0)
    remarks.push_back(
        fmt::format("horizon '{}': points ({}) lie in no {}", name, mapped.without_column, words.nowhere));
  if (mapped.not_reversible > 0) {
    remarks.push_back(
        fmt::format("horizon '{}': restored points ({}) belong to another {}: restoring back would not bring them home",
                    name, mapped.not_reversible, words.cell));
  }
}

/// Where a line passes a corner within rounding, its image has two points that no reader can tell apart.
geom::Polyline without_doubled_points(geom::Polyline line, const maps::SectionMap& map) {
  return geom::without_near_points(std::move(line), map.tolerances().side);
}

/// Everything but horizons and unit polygons, which the ledger maps. Datums stay; what is eroded is not restored.
void carry_the_rest(const maps::SectionMap& map, section::Section& section) {
  base::parallel_for(section.lines.size(), [&](std::size_t i) {
    section::SectionLine& line = section.lines[i];
    if (line.kind != section::LineKind::Datum) line.line = without_doubled_points(map.forward(line.line).after, map);
  });
  std::erase_if(section.lines, [](const section::SectionLine& line) { return line.kind == section::LineKind::Eroded; });
  section.backdrops.clear();
  section.border.reset();
  section.faces.reset();
  for (section::Marker& marker : section.markers) {
    for (geom::Point& p : marker.points) p = map.forward(p).at;
  }
}

/// The first place where the map of a horizon is not single-valued.
base::Result<void> refuse_doubt(const section::Section& section, const std::vector<maps::MappedLine>& lines) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!lines[i].doubtful) continue;
    return base::Error{
        base::ErrorCode::CannotRestore,
        "the grid is not single-valued here (beyond the medial axis of the top); simplify the top, choose "
        "another method, or set outside = \"nearest\"",
        place_at(*lines[i].doubtful, fmt::format("horizon '{}'", section.horizons[i].name))};
  }
  return {};
}

balance::Balance judge(const section::Section& section, const Restoration& restoration) {
  balance::Balance balance;
  for (const balance::LineLength& row : restoration.lengths) {
    if (row.role == section::BedRole::Growth) continue;
    if (!balance.worst.empty() && std::abs(row.change_percent) <= balance.greatest_change_percent) continue;
    balance.greatest_change_percent = std::abs(row.change_percent);
    balance.worst = row.name;
  }
  for (const balance::UnitRow& row : restoration.ledger.units) {
    if (row.role != section::BedRole::Judged) continue;
    if (!balance.worst_unit.empty() && std::abs(row.change_percent) <= balance.greatest_area_change_percent) continue;
    balance.greatest_area_change_percent = std::abs(row.change_percent);
    balance.worst_unit = row.name;
  }
  balance.consistency = balance::consistency_of(section.horizons);
  // Methods that keep the length of every bed cannot fail by that; beds that do not agree balance by none.
  balance.verdict = verdict_of(balance.consistency,
                               std::max({balance.greatest_change_percent, balance.greatest_area_change_percent,
                                         balance.consistency.worst.percent}),
                               restoration.params.tolerance);
  return balance;
}

std::string verdict_text(const Restoration& restoration) {
  const balance::Balance& balance = restoration.balance;
  std::string text = verdict_words(balance.verdict);
  if (!balance.worst.empty()) {
    text += fmt::format(": the greatest change of a bed's length is {} % (horizon '{}')",
                        balance::percent_text(balance.greatest_change_percent), balance.worst);
  }
  if (!balance.worst_unit.empty()) {
    text += fmt::format(", of a unit's area {} % ('{}')", balance::percent_text(balance.greatest_area_change_percent),
                        balance.worst_unit);
  }
  return text + fmt::format("; {}; the tolerance is {:.4g} %", consistency_text(balance.consistency),
                            restoration.params.tolerance);
}

/// As horizons_in_order, from the names that are known by now.
std::vector<section::HorizonId> order_of(const section::Section& section, section::HorizonId top,
                                         const std::vector<maps::MappedLine>& lines, const maps::Columns& columns) {
  std::vector<NamedBed> beds(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    beds[i].id = section.horizons[i].id;
    if (beds[i].id == top) continue;
    for (const std::size_t k : lines[i].given) beds[i].names.push_back(lines[i].names[k]);
  }
  return in_order(beds, columns);
}

/// tan of the lean of the line through the ends of the top and the farthest bed, outwards positive.
void measure_lean(const section::Section& section, Restoration& restoration) {
  const std::vector<section::HorizonId>& order = restoration.order;
  if (order.size() < 2) return;
  const auto line_of = [&](section::HorizonId id) -> const geom::Polyline& {
    for (std::size_t i = 0; i < section.horizons.size(); ++i) {
      if (section.horizons[i].id == id) return restoration.lines[i].after;
    }
    return restoration.lines.front().after;
  };
  const geom::Polyline& top = line_of(order.front());
  const geom::Polyline& base = line_of(order.back());
  const auto lean = [](geom::Point from, geom::Point to, geom::Point inner) {
    const geom::Vector outwards = geom::normalised(from - inner);
    const geom::Vector down = to - from;
    const double depth = std::abs(geom::cross(outwards, down));
    return depth > 0.0 ? geom::dot(down, outwards) / depth : 0.0;
  };
  restoration.lean_left = lean(top.points.front(), base.points.front(), top.points[1]);
  restoration.lean_right = lean(top.points.back(), base.points.back(), top.points[top.points.size() - 2]);
}

}  // namespace

MethodParams method_params(const RestoreParams& params) {
  return {params.method, params.angle, params.base, params.thickness, params.percent, params.outside, params.beds};
}

base::Result<Restoration> restore(const section::Section& section, const SourceGrid& source, const Target& target,
                                  const RestoreParams& params, const base::Progress& progress) {
  DOBRA_TRY_VOID(progress.check());
  DOBRA_TRY(MethodMap made, make_method_map(section, source, target, method_params(params)));
  Restoration restoration;
  restoration.params = params;
  restoration.remarks = std::move(made.remarks);
  restoration.lines = map_horizons(made, section, target.map, progress);
  restoration.map = std::move(made.map);
  const maps::SectionMap& map = restoration.map;
  DOBRA_TRY_VOID(progress.check());
  progress.report(0.6, "lines restored");
  if (params.outside == Doubt::Refuse) DOBRA_TRY_VOID(refuse_doubt(section, restoration.lines));
  restoration.section = section;
  restoration.lengths = base::parallel_map<balance::LineLength>(section.horizons.size(), [&](std::size_t i) {
    restoration.section.horizons[i].line = without_doubled_points(restoration.lines[i].after, map);
    return balance::line_length(section.horizons[i], restoration.lines[i]);
  });
  const MapWords words = words_of(map, params.method);
  for (std::size_t i = 0; i < section.horizons.size(); ++i)
    remark_on(section.horizons[i].name, restoration.lines[i], words, source.ends, restoration.remarks);
  carry_the_rest(map, restoration.section);
  restoration.order = order_of(section, source.top, restoration.lines, target.map.source());
  const std::vector<balance::LedgerUnit> units = balance::ledger_units(section, restoration.order, source.side);
  DOBRA_TRY(restoration.ledger,
            draw_up(section, units, restoration.lines, map, made.ends ? *made.ends : map, {}, progress));
  for (const balance::UnitRow& row : restoration.ledger.units) {
    if (!row.tears.empty())
      restoration.remarks.push_back(fmt::format("unit '{}' {}", row.name, tears_text(row.tears, words)));
  }
  measure_faces(section, map, restoration.ledger);
  if (auto missing = missing_area(section, restoration.ledger)) restoration.remarks.push_back(std::move(*missing));
  DOBRA_TRY_VOID(refuse_not_finite(section, restoration));
  if (params.outside == Doubt::Limited) DOBRA_TRY_VOID(refuse_beyond_limits(section, source, target, restoration));
  for (std::size_t i = 0; i < section.units.size(); ++i)
    restoration.section.units[i].contour = without_doubled_points(restoration.ledger.units[i].contour_after, map);
  measure_lean(section, restoration);
  restoration.balance = judge(section, restoration);
  restoration.remarks.push_back(what_it_keeps(params.method));
  restoration.remarks.push_back(verdict_text(restoration));
  progress.report(1.0, "restored");
  return restoration;
}

}  // namespace recon::unfold
