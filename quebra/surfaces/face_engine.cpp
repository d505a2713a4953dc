#include "quebra/surfaces/face_engine.h"

#include "shared/surf/mesh/chart_mesher.h"
#include "shared/surf/paper/paper_mesher.h"

namespace quebra::surfaces {

using namespace dobra;
using base::Result;

namespace {

/// To the end, looking now and then whether it should stop.
template <class Mesher>
Result<void> finish(Mesher& mesher, const base::Progress& progress) {
  constexpr std::size_t between_checks = 8192;
  while (!mesher.done()) DOBRA_TRY_VOID(mesher.step(between_checks, progress));
  return {};
}

}  // namespace

Result<FilledFace> mesh_face(const surf::mesh::ChartInput& input, const SurfaceMeshOptions& options,
                             const base::Progress& progress) {
  if (options.engine == SurfaceEngine::Paper) {
    surf::paper::PaperOptions paper{
        .largest = options.sizes.largest, .turn = options.sizes.turn, .passes = options.smoothing};
    paper.most_triangles = options.most_triangles;
    DOBRA_TRY(auto mesher, surf::paper::PaperMesher::start(input, paper, progress));
    DOBRA_TRY_VOID(finish(mesher, progress));
    return FilledFace{mesher.mesh(), mesher.findings()};
  }
  surf::mesh::ChartMeshOptions front{.sizes = options.sizes};
  front.points.max_triangles = options.most_triangles;
  front.smoothing.passes = options.smoothing;
  DOBRA_TRY(auto mesher, surf::mesh::ChartMesher::start(input, front, progress));
  DOBRA_TRY_VOID(finish(mesher, progress));
  return FilledFace{mesher.mesh(), {}};
}

}  // namespace quebra::surfaces
