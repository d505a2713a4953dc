#include "shared/mesh/delaunay/delaunay.h"

namespace dobra::mesh::delaunay {

base::Result<ExtractedMesh> constrained_delaunay(const MeshInput& input, Outside outside,
                                                 const base::Progress& progress) {
  DOBRA_TRY(const PlanarDomain domain, build_domain(input, outside, progress));
  return extract(domain, input);
}

base::Result<ExtractedMesh> delaunay(std::span<const geom::Point> points, const base::Progress& progress) {
  MeshInput input;
  input.points.assign(points.begin(), points.end());
  return constrained_delaunay(input, Outside::KeepHull, progress);
}

}  // namespace dobra::mesh::delaunay
