#pragma once
// What a model of QUEBRA looks like, measures and writes.

#include "quebra/core/model.h"
#include "shared/scenario/program.h"

namespace quebra::core {

dobra::scene::Picture picture_of(const Model& model);
std::vector<dobra::scenario::Quantity> quantities_of(const Model& model);
std::vector<dobra::scenario::DataTable> tables_of(const Model& model);
std::vector<dobra::scenario::Output> outputs_of(const std::shared_ptr<const Model>& model);

}  // namespace quebra::core
