#pragma once
// Facets of any number of operands in one space: what the arrangement is made of.

#include <cstdint>
#include <span>
#include <vector>

#include "shared/geom/point3.h"
#include "shared/solid/space.h"

namespace dobra::solid {

constexpr std::uint32_t none = 0xffffffffU;

/// Part of a plane. Loops run anticlockwise seen from above the plane, those round holes clockwise.
struct Facet {
  PlaneId plane;
  std::uint32_t operand = 0;
  std::uint32_t name = 0;
  std::uint32_t first_corner = 0, corner_end = 0;
  std::uint32_t first_loop = 0, loop_end = 0;
};

/// Which facets of an operand are looked at against each other.
enum class Inner : std::uint8_t {
  Trusted,  ///< None: they are known to meet in common edges and vertices alone.
  Searched  ///< All of them.
};

struct Soup {
  Space space;
  std::vector<Facet> facets;  ///< Sorted by operand.
  std::vector<PointId> corners;
  std::vector<PlaneId> across;             ///< For each corner another plane through the edge to the next; or none.
  std::vector<std::uint32_t> loop_starts;  ///< Corner with which a loop begins; the next loop's is its end.
  std::vector<Inner> inner;                ///< For each operand.

  /// Room for as many in all; not in the space.
  void reserve(std::size_t facet_count, std::size_t corner_count, std::size_t loop_count) {
    facets.reserve(facet_count);
    corners.reserve(corner_count);
    across.reserve(corner_count);
    loop_starts.reserve(loop_count);
  }
  /// Adds a loop of the facet that is being made; begin() starts one.
  void begin(PlaneId plane, std::uint32_t operand, std::uint32_t name) {
    const auto corner = static_cast<std::uint32_t>(corners.size());
    const auto loop = static_cast<std::uint32_t>(loop_starts.size());
    facets.push_back({plane, operand, name, corner, corner, loop, loop});
  }
  void begin_loop() {
    loop_starts.push_back(static_cast<std::uint32_t>(corners.size()));
    facets.back().loop_end = static_cast<std::uint32_t>(loop_starts.size());
  }
  void add_corner(PointId point, PlaneId beyond) {
    corners.push_back(point);
    across.push_back(beyond);
    facets.back().corner_end = static_cast<std::uint32_t>(corners.size());
  }
  [[nodiscard]] std::uint32_t loop_end(const Facet& facet, std::uint32_t loop) const {
    return loop + 1 < facet.loop_end ? loop_starts[loop + 1] : facet.corner_end;
  }
  /// Calls visit(corner, next corner) for every edge; both are positions in `corners`.
  template <class Visit>
  void visit_edges(const Facet& facet, Visit&& visit) const {
    for (std::uint32_t loop = facet.first_loop; loop < facet.loop_end; ++loop) {
      const std::uint32_t first = loop_starts[loop];
      const std::uint32_t end = loop_end(facet, loop);
      for (std::uint32_t i = first; i < end; ++i) visit(i, i + 1 < end ? i + 1 : first);
    }
  }
  [[nodiscard]] std::span<const PointId> corners_of(const Facet& facet) const {
    return {corners.data() + facet.first_corner, facet.corner_end - facet.first_corner};
  }
  [[nodiscard]] bool has_corner(const Facet& facet, PointId p) const {
    for (const PointId own : corners_of(facet)) {
      if (own == p) return true;
    }
    return false;
  }
  [[nodiscard]] bool has_edge(const Facet& facet, PointId p, PointId q) const {
    bool found = false;
    visit_edges(facet, [&](std::uint32_t i, std::uint32_t j) {
      found = found || (corners[i] == p && corners[j] == q) || (corners[i] == q && corners[j] == p);
    });
    return found;
  }
};

}  // namespace dobra::solid
