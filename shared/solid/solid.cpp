#include "shared/solid/solid.h"

#include "shared/base/check.h"

namespace dobra::solid {

Solid::Solid() : Solid(Boundary{}) {}

Solid::Solid(Boundary boundary) : boundary_(std::make_shared<const Boundary>(std::move(boundary))) {
  const Soup& soup = boundary_->soup;
  Links links;
  links.next.resize(soup.corners.size());
  links.face.resize(soup.corners.size());
  for (std::uint32_t f = 0; f < soup.facets.size(); ++f) {
    soup.visit_edges(soup.facets[f], [&](std::uint32_t i, std::uint32_t j) {
      links.next[i] = j;
      links.face[i] = f;
    });
  }
  links_ = std::make_shared<const Links>(std::move(links));
}

Counts Solid::counts() const {
  Counts counts;
  counts.vertices = vertex_count();
  counts.edges = edge_count();
  counts.faces = face_count();
  counts.rings = boundary_->soup.loop_starts.size() - face_count();
  counts.shells = shell_count();
  const auto twice = static_cast<long>(counts.vertices + counts.faces) - static_cast<long>(counts.edges + counts.rings);
  DOBRA_CHECK(twice % 2 == 0);
  counts.handles = static_cast<long>(counts.shells) - twice / 2;
  return counts;
}

std::vector<HalfEdgeId> Solid::loops(FaceId f) const {
  const Facet& facet = boundary_->soup.facets[f.index()];
  std::vector<HalfEdgeId> first;
  for (std::uint32_t l = facet.first_loop; l < facet.loop_end; ++l) first.emplace_back(boundary_->soup.loop_starts[l]);
  return first;
}

}  // namespace dobra::solid
