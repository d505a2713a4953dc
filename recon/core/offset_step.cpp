#include "recon/core/offset_step.h"

#include "recon/core/report.h"
#include "recon/model/model.h"
#include "shared/operations/offset_step.h"

namespace recon::core {

namespace {

namespace operations = dobra::operations;

struct Keeper {
  static std::vector<dobra::io::lines::Feature> lines_of(const model::Model& model) {
    return restored_features(model.section);
  }
  static std::size_t state_of(const model::Model& model) { return model.earlier.size(); }
  static operations::AllOffsets all(const model::Model& model) { return model.findings.all<operations::Offsets>(); }
  static void add(model::Model& model, operations::Offsets made) {
    const std::size_t state = made.state;
    model.findings.add(std::move(made), {.state = state});
  }
};

}  // namespace

dobra::scenario::Operation offset_step() { return operations::offset_operation<model::Model, Keeper>(); }

}  // namespace recon::core
