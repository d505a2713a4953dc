#include "shared/surf/mesh/unfold.h"

#include <algorithm>

namespace dobra::surf::mesh {

using Kernel = ChartSpace::Kernel;
using Vertex = Kernel::Vertex;
using Cell = Kernel::Cell;

namespace {

bool is_folded(const Kernel& kernel, const ChartSpace& space, Cell cell) {
  if (kernel.cell(cell).region < 0) return false;
  const auto [a, b, c] = kernel.cell(cell).vertex;
  const geom::Vector3 area = cross(space.at(b) - space.at(a), space.at(c) - space.at(a));
  // Of most triangles the normals of the nodes tell enough.
  const double little = 0.25 * geom::length(area);
  if (std::min({dot(area, space.frame(a)), dot(area, space.frame(b)), dot(area, space.frame(c))}) > little)
    return false;
  return dot(area, space.frame_in_middle(a, b, c)) < 0.0;
}

std::vector<Vertex> corners_of_folded(const Kernel& kernel, const ChartSpace& space) {
  std::vector<Vertex> corners;
  for (Cell c = 0; c < kernel.cell_count(); ++c) {
    if (is_folded(kernel, space, c))
      corners.insert(corners.end(), kernel.cell(c).vertex.begin(), kernel.cell(c).vertex.end());
  }
  return corners;
}

}  // namespace

base::Result<std::vector<Vertex>> unfold(Kernel& kernel, ChartSpace& space, int rounds,
                                         const base::Progress& progress) {
  std::vector<Vertex> changed;
  for (int round = 0; round < rounds; ++round) {
    DOBRA_TRY_VOID(progress.check());
    const std::vector<Vertex> corners = corners_of_folded(kernel, space);
    if (corners.empty()) break;
    space.favour_unfolded(true);
    const std::size_t flips = kernel.legalise_near(corners, changed);
    space.favour_unfolded(false);
    if (flips == 0) break;
  }
  std::sort(changed.begin(), changed.end());
  changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
  return changed;
}

}  // namespace dobra::surf::mesh
