#pragma once
// A slanted trace has an irrational length: lines that are written to millimetres end a little before or behind the
// place where their traces cross. Such ends are led to it. Page: docs/algorithms/loft.md.

#include <vector>

#include "shared/surf/loft/ties.h"

namespace dobra::surf::loft {

/// The end of a line that is nearer to a crossing than 1e-4 of its section's length, or than one unit of its last
/// decimal up to 1e-3 of that length, is put there: on along its last straight piece, or back to where the line passes.
/// The other section must have a line of the name there, and no fault may lie as near. Ends that are moved by more than
/// 1e-6 of `size` are told (end_moved).
/// @param size  of all sections, m
/// @cost  O(crossings times vertices of their sections)
void lead_to_crossings(std::vector<Section>& sections, const std::vector<Crossing>& crossings, double size,
                       std::vector<Finding>& findings);

/// Lines of one name that do not meet at a crossing because one of them, or both, end up to `near` before it
/// (near_miss). An end is not told that has a fault beside it nearer than the crossing.
/// @param size  of all sections, m
/// @cost  as lead_to_crossings
std::vector<Finding> short_lines(const std::vector<Section>& sections, const std::vector<Crossing>& crossings,
                                 double near, double size);

}  // namespace dobra::surf::loft
