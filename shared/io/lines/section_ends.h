#pragma once
// What stands over the two ends of a section.

#include <string>
#include <utility>

#include "shared/base/result.h"

namespace dobra::io::lines {

/// "W" and "E" of "W - E".
/// @error BadValue with an example: an end is missing.
base::Result<std::pair<std::string, std::string>> ends_of_text(const std::string& text);

}  // namespace dobra::io::lines
