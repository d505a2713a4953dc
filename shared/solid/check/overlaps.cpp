#include "shared/solid/check/overlaps.h"

#include <algorithm>
#include <array>

#include "shared/solid/boolean.h"
#include "shared/solid/box_tree.h"
#include "shared/solid/measure.h"

namespace dobra::solid::check {
namespace {

geom::Point3 point_of(const Solid& solid, const Measures& measures) {
  const bool in = PointLocator(solid).locate(measures.centre) == Location::Inside;
  return in ? measures.centre : solid.point(HalfEdgeId(0));
}

}  // namespace

base::Result<std::vector<Overlap>> overlaps(std::span<const Solid> solids) {
  std::vector<Overlap> found;
  std::vector<Box3> boxes;
  for (const Solid& solid : solids) {
    Box3& box = boxes.emplace_back();
    for (const PointId corner : solid.boundary().soup.corners) box.include(solid.space(), corner);
  }
  for (std::size_t i = 0; i < solids.size(); ++i) {
    for (std::size_t j = i + 1; j < solids.size(); ++j) {
      if (solids[i].empty() || solids[j].empty() || !boxes[i].overlaps(boxes[j])) continue;
      DOBRA_TRY(const Combined both, combine(std::array{solids[i], solids[j]}, Operation::Intersection));
      if (both.solid.empty()) continue;
      const Measures measures = measure(both.solid);
      if (!(measures.volume > 1e-12 * std::min(volume(solids[i]), volume(solids[j])))) continue;
      found.push_back({i, j, measures.volume, point_of(both.solid, measures)});
    }
  }
  return found;
}

}  // namespace dobra::solid::check
