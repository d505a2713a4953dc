#pragma once
// What restoration tells about balance: bed lengths before and after, shortening, depth to the top. Source:
// restoration.md 2.11.

#include <string>
#include <vector>

#include "recon/core/map.h"
#include "recon/core/section.h"

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
};

LineLength line_length(const Horizon& horizon, const MappedLine& mapped);

/// Beds that a section was restored with must come out as long as they are, within `tolerance_percent`.
struct Balance {
  bool balanced = false;
  double greatest_change_percent = 0.0;  ///< The largest |change_percent|.
  std::string worst;                     ///< The horizon that has it.
};
Balance judge_balance(const std::vector<LineLength>& lengths, double tolerance_percent);

}  // namespace recon::core
