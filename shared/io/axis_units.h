#pragma once
// The units of a GOCAD file's axes, for all readers of its objects. Source: [gocad].

#include <string>
#include <string_view>
#include <vector>

namespace dobra::io {

/// What an AXIS_UNIT says, one entry an axis.
struct AxisUnits {
  std::vector<double> metres = {};  ///< Of those that are m, km or ft, in their order.
  std::string unknown = {};         ///< The last one that is none of them; empty: there is none.
};
/// @param text  what follows the key: three units, with or without quotes, with blanks inside them or not.
AxisUnits axis_units(std::string_view text);
/// "m", "km" or "ft". @pre one of those in AxisUnits::metres
std::string_view name_of_unit(double metres);

}  // namespace dobra::io
