#pragma once
// A part of the mesher at work in the plane. Used by fill_engine.h only.

#include <vector>

#include "shared/mesh/front/fill_engine.h"
#include "shared/mesh/front/space.h"

namespace dobra::mesh::front {

template <class Part>
class InPlane final : public FillEngine {
 public:
  template <class... Arguments>
  explicit InPlane(delaunay::DelaunayKernel& kernel, Arguments&... arguments)
      : plane_(kernel), part_(kernel, plane_, arguments...) {}
  base::Result<void> step(std::size_t count, const base::Progress& progress) override {
    return part_.step(count, progress);
  }
  [[nodiscard]] bool done() const override { return part_.done(); }
  [[nodiscard]] std::vector<geom::Segment> front() const override { return part_.front(); }

 private:
  Plane plane_;
  Part part_;
};

}  // namespace dobra::mesh::front
