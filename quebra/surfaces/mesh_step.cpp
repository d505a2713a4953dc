#include "quebra/surfaces/mesh_step.h"

#include <fmt/format.h>

#include "quebra/surfaces/finding_text.h"
#include "quebra/surfaces/mesh_surfaces.h"

namespace quebra::surfaces {

using namespace dobra;
using base::Error;
using base::ErrorCode;
using base::Result;
using meshing::MeshParams;

namespace {

Result<void> check(const MeshParams& params) {
  const auto refused = [](const char* what) { return Error{ErrorCode::NotSupported, what}; };
  if (params.engine == meshing::EngineChoice::Delaunay)
    return Error{ErrorCode::NotSupported,
                 "engine = \"delaunay\" meshes plane domains only: on surfaces give \"front\" or \"paper\""};
  if (!params.background.empty()) return refused("a background mesh is of plane domains, not of surfaces");
  if (params.rosettes == meshing::UseRosettes::Yes) return refused("rosettes are of plane domains, not of surfaces");
  if (params.division == sketch::DivisionRule::Halving && params.engine != meshing::EngineChoice::Paper)
    return refused("`division` = \"halving\" is of plane domains and of the engine paper: leave it out on surfaces");
  if (params.stop_after > 0) return refused("`stop_after` is of plane domains, not of surfaces");
  return {};
}

/// What is asked for and the engine paper does not look at: it goes by size and turn alone.
std::vector<surf::mesh::Finding> unused_options(const MeshParams& params) {
  if (params.engine != meshing::EngineChoice::Paper) return {};
  std::vector<surf::mesh::Finding> findings;
  const auto tell = [&](bool asked, const char* key) {
    if (!asked) return;
    findings.push_back(
        {"option_unused",
         fmt::format("the engine paper does not look at `{}`: it goes by size and turn; leave it out, or "
                     "mesh with the engine front",
                     key),
         {}});
  };
  tell(params.chord > 0.0, "chord");
  tell(params.growth.has_value(), "growth");
  tell(params.narrow != meshing::MeshRules{}.narrow, "narrow");
  tell(!params.size_formula.empty(), "size_formula");
  return findings;
}

}  // namespace

Result<model::Model> add_surface_mesh(const model::Model& model, const MeshParams& params, const scenario::Context&,
                                      const base::Progress& progress) {
  DOBRA_TRY_VOID(check(params));
  SurfaceMeshOptions options;
  options.sizes = {.largest = params.size,
                   .turn = params.turn.degrees(),
                   .chord = params.chord,
                   .growth = params.growth.value_or(surf::mesh::SizeOptions{}.growth),
                   .narrow = params.narrow};
  options.engine = params.engine == meshing::EngineChoice::Paper ? SurfaceEngine::Paper : SurfaceEngine::Front;
  options.size_formula = params.size_formula;
  options.smoothing = params.smoothing;
  options.quadrilaterals = params.quadrilaterals == meshing::Quadrilaterals::Yes;
  options.second_order = params.order == meshing::Order::Second;
  options.most_triangles = static_cast<std::size_t>(params.max_elements);
  DOBRA_TRY(model::SurfaceMeshed meshed, mesh_surfaces(*model.surfaces, options, progress));
  const auto unused = unused_options(params);
  meshed.findings.insert(meshed.findings.begin(), unused.begin(), unused.end());
  model::Model result = model;
  result.work.reset();
  meshed.name = !params.label.empty() ? params.label : fmt::format("Mesh {}", model.surface_meshes.size() + 1);
  for (const surf::mesh::Finding& finding : meshed.findings) result.remarks.push_back(line_of(finding, false));
  result.surface_meshes.push_back(std::make_shared<const model::SurfaceMeshed>(std::move(meshed)));
  return result;
}

}  // namespace quebra::surfaces
