#pragma once
// The names in a section that steps may refer to.

#include <optional>
#include <string>
#include <vector>

#include "recon/model/model.h"
#include "shared/scene/pick.h"

namespace recon::model {

/// Of the section as it is now, each once, in its order. Pieces are called by their whole.
/// @param what  "horizon", "fault", "block" (with their groups, from the left).
std::vector<std::string> names_of(const Model& model, const std::string& what);

/// The name of a `what` whose line was pointed at, or (block) that lies at the place; empty if there is none.
std::string name_at(const Model& model, const std::string& what, const std::optional<dobra::scene::Pick>& line,
                    geom::Point at);

}  // namespace recon::model
