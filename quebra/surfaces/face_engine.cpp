#include "quebra/surfaces/face_engine.h"

#include "shared/surf/mesh/chart_mesher.h"
#include "shared/surf/paper/paper_mesher.h"

namespace quebra::surfaces {

using namespace dobra;
using base::Result;
using surf::mesh::FaceMesh;

Result<FilledFace> mesh_face(const surf::mesh::ChartInput& input, const SurfaceMeshOptions& options,
                             const base::Progress& progress) {
  if (options.engine == SurfaceEngine::Paper) {
    surf::paper::PaperOptions paper{
        .largest = options.sizes.largest, .turn = options.sizes.turn, .passes = options.smoothing};
    paper.most_triangles = options.most_triangles;
    DOBRA_TRY(auto mesher, surf::paper::PaperMesher::start(input, paper, progress));
    constexpr std::size_t between_checks = 8192;
    while (!mesher.done()) DOBRA_TRY_VOID(mesher.step(between_checks, progress));
    return FilledFace{mesher.mesh(), mesher.findings()};
  }
  surf::mesh::ChartMeshOptions front{.sizes = options.sizes};
  front.points.max_triangles = options.most_triangles;
  front.smoothing.passes = options.smoothing;
  DOBRA_TRY(FaceMesh made, surf::mesh::mesh_chart(input, front, progress));
  return FilledFace{std::move(made), {}};
}

}  // namespace quebra::surfaces
