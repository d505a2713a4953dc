#pragma once
// The balance ledger of a restoration: what became of the length of every bed, of the area and thickness of every unit,
// and of every piece of area (det F - 1), with a verdict.
// Page: docs/algorithms/ledger.md

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "recon/balance/balance.h"
#include "recon/maps/section_map.h"
#include "recon/maps/strain.h"
#include "recon/section/section.h"
#include "shared/base/progress.h"

namespace recon::balance {

/// Least, mean (by length or area) and greatest of something; nothing if nothing could be measured.
struct Range {
  double least = 0.0;
  double mean = 0.0;
  double greatest = 0.0;
};

/// A unit whose balance is drawn up: a polygon of the section, or what lies between two neighbouring horizons.
struct LedgerUnit {
  std::string name;
  std::optional<section::UnitId> unit;  ///< Of the section's polygon.
  std::optional<std::size_t> upper;     ///< Indices of the two horizons.
  std::optional<std::size_t> lower;
};

/// The polygons of the section, or, if it has none, one unit between each two neighbours, from the top down: where the
/// section has faces, every unit that is all that lies between two horizons; the others are units_by_faces.
/// @param order  of the horizons, from the base of the grid to the side on which the layers lie; none: polygons alone.
std::vector<LedgerUnit> ledger_units(const section::Section& section, std::vector<section::HorizonId> order,
                                     section::LayerSide side);

/// One unit. Areas in m2, thicknesses in metres, across the beds: from points of the upper horizon to the nearest point
/// of the lower one (not to its ends).
struct UnitRow {
  std::string name;
  std::size_t pieces = 1;  ///< So many polygons together.
  double area_before = 0.0;
  double area_after = 0.0;
  double change_percent = 0.0;                       ///< (after - before) / before.
  section::BedRole role = section::BedRole::Judged;  ///< Growth: one of its horizons is; see face_ledger.h too.
  std::optional<Range> thickness_before;             ///< Nothing for polygons.
  std::optional<Range> thickness_after;
  std::optional<Range> dilatation;  ///< det F - 1: its extremes, and its mean by area.
  geom::Point least_at;             ///< A place where it is least ...
  geom::Point greatest_at;          ///< ... and greatest.
  geom::Polyline contour_after;     ///< Of a polygon of the section: its image ...
  std::vector<maps::Tear> tears;    ///< ... and where that jumps.
  std::vector<geom::Polyline>
      faces_before;                         ///< Of a unit that is not all that lies between two horizons: its faces ...
  std::vector<geom::Polyline> faces_after;  ///< ... and their images.
};

/// det F - 1 on small triangles of the deformed section.
struct DilatationField {
  std::vector<geom::Point> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<double> values;  ///< One a triangle.
};

struct LedgerOptions {
  int places = 96;    ///< Samples along a unit ...
  int levels = 4;     ///< ... and across it.
  int ellipses = 12;  ///< Strain ellipses along a unit.
};

struct Ledger {
  std::vector<UnitRow> units;
  DilatationField field;
  std::vector<maps::Strain> strains;
};

/// @param lines  the mapped horizons, in the order of the section.
/// @param ends   how the ends of units go (MethodMap::map_of_ends).
/// @error Cancelled; errors of the mesher for a polygon.
base::Result<Ledger> draw_up(const section::Section& section, const std::vector<LedgerUnit>& units,
                             const std::vector<maps::MappedLine>& lines, const maps::SectionMap& map,
                             const maps::SectionMap& ends, const LedgerOptions& options,
                             const base::Progress& progress);

/// Thickness of what lies between two lines, m, across the beds: at `count` + 1 places evenly along the upper one.
std::optional<Range> thickness_between(const geom::Polyline& upper, const geom::Polyline& lower,
                                       int count = LedgerOptions{}.places);

struct UnitAreas {
  double before = 0.0;
  double after = 0.0;
};
/// Of what lies between two mapped lines, m2; their ends are joined straight before and by the image of that after,
/// shifted (each place by its part) so that it meets both lines where they are not the map's own images.
UnitAreas areas_between(const maps::MappedLine& upper, const maps::MappedLine& lower, const maps::SectionMap& ends);

}  // namespace recon::balance
