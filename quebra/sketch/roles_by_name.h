#pragma once
// What curves of a file are, by patterns of their names: for files that say nothing, or another thing.
// Page: docs/scenario_format.md.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "quebra/sketch/sketch.h"
#include "shared/base/result.h"

namespace quebra::sketch {

/// "outline", "hole", "internal", "crack"; nothing for another word.
std::optional<Role> role_named(std::string_view word);
std::string role_name(Role role);

/// Gives curves their roles by rules such as "C*=crack"; the first that fits a name counts. "none" takes the curve out,
/// "found" leaves its role to be found from the drawing. A rule that fits no name is told in a remark.
/// @error BadValue: a rule that is none; no curve is left.
dobra::base::Result<void> set_roles(Sketch& sketch, const std::vector<std::string>& rules);

}  // namespace quebra::sketch
