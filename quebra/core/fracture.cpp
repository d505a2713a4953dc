#include "quebra/core/fracture.h"

namespace quebra::core {

using dobra::base::Error;
using dobra::base::ErrorCode;

dobra::base::Result<Model> add_tips(const Model& model, const FractureParams& params, const dobra::scenario::Context&,
                                    const dobra::base::Progress& progress) {
  if (model.analyses.empty()) return Error{ErrorCode::BadValue, "there is no analysis: put a step 'analyse' or 'adapt' before"};
  Analysis analysis = *model.analyses.back();
  const auto& mesh = analysis.meshed->mesh;
  if (mesh.tips.empty()) return Error{ErrorCode::BadValue, "the mesh has no crack tips; give the input a crack that ends inside the material"};
  analysis.tips.clear();
  for (std::size_t c = 0; c < analysis.problem.cases.size(); ++c) {
    DOBRA_TRY_VOID(progress.check());
    DOBRA_TRY(auto tips, dobra::fem::crack_tips(mesh, analysis.problem, analysis.problem.cases[c], analysis.solution.cases[c].displacements, params.contour));
    analysis.tips.push_back(std::move(tips));
  }
  Model result = model;
  result.analyses.back() = std::make_shared<const Analysis>(std::move(analysis));
  return result;
}

}  // namespace quebra::core
