#include "shared/mesh/front/advancing_front.h"

#include "shared/mesh/front/advancer.h"
#include "shared/mesh/front/in_plane.h"

namespace dobra::mesh::front {

base::Error front_crossed() { return {base::ErrorCode::SelfIntersection, "sides of the advancing front cross", {}}; }

std::unique_ptr<FillEngine> advancing_front(delaunay::DelaunayKernel& kernel, const sizing::SizeField& field,
                                            const FrontalOptions& options, Front& front) {
  return std::make_unique<InPlane<Advancer<Plane>>>(kernel, field, options, front);
}

}  // namespace dobra::mesh::front
