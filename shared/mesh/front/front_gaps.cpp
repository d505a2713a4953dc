#include "shared/mesh/front/front_gaps.h"

#include "shared/mesh/front/gap_filler.h"
#include "shared/mesh/front/in_plane.h"

namespace dobra::mesh::front {

std::unique_ptr<FillEngine> gap_filler(delaunay::DelaunayKernel& kernel, Front& front, const sizing::SizeField& field,
                                       const FrontalOptions& options) {
  return std::make_unique<InPlane<GapFiller<Plane>>>(kernel, front, field, options);
}

}  // namespace dobra::mesh::front
