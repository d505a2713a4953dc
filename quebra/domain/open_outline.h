#pragma once
// An outline that does not close bounds nothing, and must not be taken for a stray line: what lies in it would be the
// domain then. Page: docs/algorithms/domain_repair.md.

#include <optional>
#include <string>
#include <vector>

#include "quebra/domain/domain.h"

namespace quebra::domain {

/// What to do about a gap that is left: its width against the limit, and which options close it.
/// @param size  the drawing's diagonal, m
std::string gap_advice(double gap, double size, const std::optional<sketch::RepairOptions>& repaired);

/// Chains of internal lines outside the material whose free ends nearly meet, or that hold a loop of the domain once
/// the ends that are nearest to each other are joined.
/// @param places  one a curve.
/// @param inside  of the domain that the loops make.
/// @return BadDomain with both ends of the widest gap of the first such chain, its width, the limit and what to change.
/// @cost O(n log n + pairs of free ends near in x)
std::optional<dobra::base::Error> open_outline(const std::vector<sketch::Curve>& curves,
                                               const std::vector<dobra::base::Place>& places, const Inside& inside,
                                               const std::optional<sketch::RepairOptions>& repaired);

}  // namespace quebra::domain
