#pragma once
// What restoration tells about beds: lengths before and after, shortening, depth to the top, and whether they balance.
// Source: restoration.md 2.11. Page: docs/algorithms/ledger.md

#include <string>
#include <vector>

#include "recon/core/section.h"
#include "recon/core/trace.h"

namespace recon::core {

/// One horizon. Lengths in metres; widths are distances along x between the two ends.
struct LineLength {
  HorizonId horizon;
  std::string name;
  double length_before = 0.0;   ///< Of the bed as it is.
  double length_after = 0.0;    ///< Of its restored line, jumps across tears included.
  double change_percent = 0.0;  ///< (after - before) / before: what the method did not keep.
  double width_before = 0.0;
  double width_after = 0.0;
  double shortening = 0.0;          ///< width_after - width_before; negative for extension.
  double shortening_percent = 0.0;  ///< Of width_after.
  double torn = 0.0;                ///< Sum of the jumps.
  double depth_min = 0.0;           ///< To the top, along its normal, negative above it.
  double depth_mean = 0.0;          ///< Weighted by length.
  double depth_max = 0.0;
  std::string piece_of = {};  ///< See Horizon.
};

LineLength line_length(const Horizon& horizon, const MappedLine& mapped);

/// Horizons as wholes: the rows of pieces summed up where the first of them stands (the id is that one's), others as
/// they are.
std::vector<LineLength> whole_beds(const std::vector<LineLength>& rows);
/// Those of them that are in pieces.
std::vector<LineLength> totals_of(const std::vector<LineLength>& rows);

/// The criteria of balance, each in percent, and the verdict: all of them within the tolerance.
struct Balance {
  bool balanced = false;
  double greatest_change_percent = 0.0;       ///< The largest |change_percent| of a bed's length.
  std::string worst;                          ///< The horizon that has it.
  double greatest_area_change_percent = 0.0;  ///< Likewise of a unit's area.
  std::string worst_unit;
  double inconsistency_percent =
      0.0;  ///< Difference of the greatest and the least shortening, of the longest restored bed.
};

/// How far the shortening of the beds differs, in percent of the longest restored bed. Beds that reach less far than
/// others do not count as shorter by that. Horizons in pieces count as wholes.
double inconsistency_percent(const std::vector<LineLength>& lengths);

}  // namespace recon::core
