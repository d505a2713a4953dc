#pragma once
// Lines of a drawing that reach too far: sides that cross instead of meeting in a corner, and what lies outside the
// domain. Part of repair.h.  Page: docs/algorithms/domain_repair.md.

#include <set>
#include <string>
#include <vector>

#include "quebra/domain/domain.h"

namespace quebra::repair {

/// Cuts open straight lines without a role where they cross each other or themselves, so that what closes between the
/// crossings can bound the domain. Stretches that run along each other stay once. The pieces of 'a' are 'a', 'a_2' ...
/// @param same_point  m; lines nearer than this run along each other.
/// @error those of topo::insert.  @cost O((n + crossings) log n)
dobra::base::Result<void> cut_at_crossings(sketch::Sketch& sketch, double same_point);

/// Leaves out what lies outside the domain of internal lines: all of a line, or of a straight one the parts that do.
/// @param lines  names of those whose file gave them no role; others are meant.
/// @return one finding a line. Nothing is changed where the boundary makes no domain.
/// @error BadDomain where the lines are an outline that stays open (open_outline.h).
dobra::base::Result<std::vector<sketch::Finding>> drop_outside(sketch::Sketch& sketch,
                                                               const std::set<std::string>& lines,
                                                               const domain::DomainOptions& options);

}  // namespace quebra::repair
