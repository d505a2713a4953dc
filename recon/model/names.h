#pragma once
// The names in a section that steps may refer to.

#include <string>
#include <vector>

#include "recon/model/model.h"

namespace recon::model {

/// Of the section as it is now, each once, in its order. Pieces are called by their whole.
/// @param what  "horizon", "fault", "block" (with their groups, from the left).
std::vector<std::string> names_of(const Model& model, const std::string& what);

}  // namespace recon::model
