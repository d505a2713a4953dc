#pragma once
// Lists as a user types them in one line.

#include <string>
#include <vector>

namespace dobra::scenario {

/// "a, b" in its parts. Commas in double quotes belong to their part: '"a, upper", b'.
std::vector<std::string> parts_of(const std::string& list);

}  // namespace dobra::scenario
