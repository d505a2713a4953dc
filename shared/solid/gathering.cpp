#include "shared/solid/gathering.h"

#include <array>

namespace dobra::solid {

Gathering::Gathering(std::span<const Solid> operands) {
  std::array<std::size_t, 5> room{};
  for (const Solid& operand : operands) {
    const Soup& own = operand.boundary().soup;
    const std::array<std::size_t, 5> needed{own.space.point_count(), own.space.plane_count(), own.facets.size(),
                                            own.corners.size(), own.loop_starts.size()};
    for (std::size_t i = 0; i < room.size(); ++i) room[i] += needed[i];
  }
  soup.space.reserve(room[0], room[1]);
  soup.reserve(room[2], room[3], room[4]);
  for (std::uint32_t o = 0; o < operands.size(); ++o) add(operands[o].boundary(), o);
}

void Gathering::add(const Boundary& boundary, std::uint32_t operand) {
  const Soup& own = boundary.soup;
  std::vector<PointId> points(own.space.point_count());
  for (std::size_t p = 0; p < points.size(); ++p) points[p] = soup.space.add(own.space, PointId(p));
  std::vector<PlaneId> planes(own.space.plane_count());
  for (std::size_t q = 0; q < planes.size(); ++q) planes[q] = soup.space.add(own.space.plane(PlaneId(q)));
  const auto first = static_cast<std::uint32_t>(soup.facets.size());
  for (const Facet& facet : own.facets) {
    soup.begin(planes[facet.plane.index()], operand, name_number(boundary.names[facet.name]));
    for (std::uint32_t l = facet.first_loop; l < facet.loop_end; ++l) {
      soup.begin_loop();
      for (std::uint32_t i = own.loop_starts[l]; i < own.loop_end(facet, l); ++i) {
        const PlaneId across = own.across[i];
        soup.add_corner(points[own.corners[i].index()], across.valid() ? planes[across.index()] : PlaneId());
      }
    }
  }
  soup.inner.push_back(own.inner.empty() ? Inner::Trusted : own.inner[0]);
  trees.emplace_back(soup, first, static_cast<std::uint32_t>(soup.facets.size()));
}

std::uint32_t Gathering::name_number(const std::string& name) {
  const auto [at, fresh] = numbers_.try_emplace(name, static_cast<std::uint32_t>(names.size()));
  if (fresh) names.push_back(name);
  return at->second;
}

}  // namespace dobra::solid
