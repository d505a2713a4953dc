#pragma once
// The operations of documents of solids.

#include <vector>

#include "quebra/model/model.h"
#include "quebra/solids/parts.h"
#include "shared/scenario/program.h"

namespace quebra::core {

/// Whether there are solids and no section of them yet.
inline bool only_solids(const model::Model& model) { return model.solids && model.domain.curves.empty(); }

/// In the order of menus: what makes parts, what combines them, what cuts them.
std::vector<dobra::scenario::Operation> solid_operations();

}  // namespace quebra::core
