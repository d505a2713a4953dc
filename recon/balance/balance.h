#pragma once
// What restoration tells about beds: lengths before and after, shortening, depth to the top, and whether they balance.
// Shortening is a matter of the section as it is: shortening.h.
// Page: docs/algorithms/ledger.md

#include <string>
#include <vector>

#include "recon/balance/shortening.h"
#include "recon/maps/trace.h"
#include "recon/section/section.h"

namespace recon::balance {

/// One horizon. Lengths in metres; widths along the regional, from end to end.
struct LineLength {
  section::HorizonId horizon;
  std::string name;
  double length_before = 0.0;   ///< Of the bed as it is.
  double length_after = 0.0;    ///< Of its restored line, jumps across tears included.
  double change_percent = 0.0;  ///< (after - before) / before: what the method did not keep.
  double width_before = 0.0;
  double width_after = 0.0;
  double shortening = 0.0;          ///< length_before - width_before: BedLength::shortening.
  double shortening_percent = 0.0;  ///< Of length_before.
  double torn = 0.0;                ///< Sum of the jumps.
  double depth_min = 0.0;           ///< To the top, along its normal, negative above it.
  double depth_mean = 0.0;          ///< Weighted by length.
  double depth_max = 0.0;
  std::string piece_of = {};                         ///< See Horizon.
  section::BedRole role = section::BedRole::Judged;  ///< Likewise.
  BedLength before;                                  ///< What length_before and width_before are of.
  BedLength after;
};

LineLength line_length(const section::Horizon& horizon, const maps::MappedLine& mapped);
/// Of a horizon that has no depth to a top; `after` are the pieces that became of it.
LineLength line_length(const section::Horizon& horizon, const std::vector<geom::Polyline>& after);

/// Horizons as wholes: the rows of pieces summed up where the first of them stands (the id is that one's), others as
/// they are.
std::vector<LineLength> whole_beds(const std::vector<LineLength>& rows);
/// Those of them that are in pieces.
std::vector<LineLength> totals_of(const std::vector<LineLength>& rows);

/// The criteria of balance, each in percent, and the verdict: all of them within the tolerance. Growth is not judged.
struct Balance {
  BalanceVerdict verdict = BalanceVerdict::NotJudged;
  double greatest_change_percent = 0.0;       ///< The largest |change_percent| of a bed's length.
  std::string worst;                          ///< The horizon that has it.
  double greatest_area_change_percent = 0.0;  ///< Likewise of a unit's area.
  std::string worst_unit;
  Consistency consistency;  ///< Of the shortening of the beds, as `balance` has it too.
};

}  // namespace recon::balance
