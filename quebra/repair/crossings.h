#pragma once
// Boundaries that cross themselves or each other, rebuilt on the planar subdivision: outlines are united, holes are cut
// out. Part of repair.h.  Page: docs/algorithms/domain_repair.md.

#include <set>
#include <string>
#include <vector>

#include "quebra/sketch/finding.h"
#include "quebra/sketch/sketch.h"
#include "shared/base/result.h"

namespace quebra::repair {

/// Whether boundary curves follow each other back to their start anywhere.
bool any_loop_closes(const sketch::Sketch& sketch);

/// Rebuilds loops that cross. Of those whose file tells no roles, a small one that reaches across an outline from
/// within is a hole and bites a notch out of it.
/// @param without_role  names of the curves whose file tells no roles.
/// @param same_point    m; what is nearer is one point.
/// @return what crossed, what each loop was taken for, and the area of the material before and after.
/// @error those of topo::insert
dobra::base::Result<std::vector<sketch::Finding>> rebuild_crossings(sketch::Sketch& sketch,
                                                                    const std::set<std::string>& without_role,
                                                                    double same_point);

}  // namespace quebra::repair
