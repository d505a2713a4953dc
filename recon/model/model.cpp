#include "recon/model/model.h"

namespace recon::model {

const section::Section& input_section(const Model& model) {
  return model.earlier.empty() ? model.section : model.earlier.front()->section;
}

std::vector<const Stage*> restored_stages(const Model& model) {
  std::vector<const Stage*> stages;
  for (const auto& stage : model.earlier) stages.push_back(stage.get());
  if (is_done(model)) stages.push_back(&model);
  return stages;
}

base::Result<Model> next_stage(const Model& model) {
  Model next;
  next.remarks = model.remarks;
  next.findings = model.findings;
  next.findings.begin_stage();
  next.earlier = model.earlier;
  if (!is_done(model)) {
    next.section = model.section;
    return next;
  }
  std::vector<std::string> remarks;
  DOBRA_TRY(next.section, section_after(model, remarks));
  for (const std::string& remark : remarks) {
    next.remarks.push_back(std::string("after ") + what_was_done(model) + ' ' +
                           std::to_string(model.earlier.size() + 1) + ": " + remark);
  }
  next.earlier.push_back(std::make_shared<const Stage>(model));
  return next;
}

const section::Section& current_section(const Model& model) {
  return is_done(model) ? section_made(model) : model.section;
}

}  // namespace recon::model
