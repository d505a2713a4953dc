#pragma once
// What cracks do that a drawing may not mean: open into a curve that they only nearly touch, and cut the material
// through. Page: docs/algorithms/domain_repair.md.

#include <array>
#include <map>
#include <string>
#include <vector>

#include "quebra/domain/domain.h"

namespace quebra::repair {

/// Start and end of each crack by its name, as they are drawn: a domain moves those that nearly meet other ends.
using CrackEnds = std::map<std::string, std::array<dobra::geom::Point, 2>>;
CrackEnds crack_ends(const sketch::Sketch& sketch);

/// Each with its place and what to do; nothing is changed.
/// @cost O(cracks * curves), and that of find_faces if two ends of cracks or more touch something.
std::vector<sketch::Finding> crack_flaws(const domain::Domain& domain, const CrackEnds& drawn);

}  // namespace quebra::repair
