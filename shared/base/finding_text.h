#pragma once
// A finding as one line of text.

#include <string>

#include "shared/base/finding.h"

namespace dobra::base {

/// Its message and, where it is known, the point: "message (at x, y, z)".
std::string line_of(const Finding& finding);

}  // namespace dobra::base
