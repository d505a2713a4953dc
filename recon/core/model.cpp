#include "recon/core/model.h"

namespace recon::core {

const section::Section& input_section(const Model& model) {
  return model.earlier.empty() ? model.section : model.earlier.front()->section;
}

std::vector<const Stage*> restored_stages(const Model& model) {
  std::vector<const Stage*> stages;
  for (const auto& stage : model.earlier) stages.push_back(stage.get());
  if (model.restoration) stages.push_back(&model);
  return stages;
}

}  // namespace recon::core
