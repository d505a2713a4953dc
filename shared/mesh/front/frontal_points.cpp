#include "shared/mesh/front/frontal_points.h"

#include "shared/mesh/front/in_plane.h"
#include "shared/mesh/front/point_placer.h"

namespace dobra::mesh::front {

std::unique_ptr<FillEngine> frontal_points(delaunay::DelaunayKernel& kernel, const sizing::SizeField& field,
                                           const FrontalOptions& options) {
  return std::make_unique<InPlane<PointPlacer<Plane>>>(kernel, field, options);
}

}  // namespace dobra::mesh::front
