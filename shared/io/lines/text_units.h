#pragma once
// Units that a text states in its header or in a row below it. Internal to io. Page: docs/user/import.md.

#include <string>
#include <string_view>
#include <vector>

#include "shared/io/scan.h"

namespace dobra::io::lines {

/// Of one column: "x_ft", "Prof. (m)", "TWT [ms]", "longitude". Nothing: the header states no unit, or one that is not
/// known.
struct HeaderUnit {
  enum class Of { Nothing, Length, Time, Angle };
  Of of = Of::Nothing;
  double metres = 1.0;  ///< Of a length.
  std::string word;     ///< "ft", or what else says so: "twt".
};
HeaderUnit unit_of(std::string_view header);

/// A row of units below the header: "m;m;-", "(km) (km)".
bool is_units_row(const std::vector<Word>& fields);

}  // namespace dobra::io::lines
