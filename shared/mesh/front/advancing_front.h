#pragma once
// The advancing front: fills a domain with triangles from its marked sides inwards, row after row, small sizes first.
// Only what is plainly good is done: a narrow corner of the front is closed; over a side with nothing near, a node is
// put where the triangle has the size wanted. Where fronts meet or the input is crowded the sides are left standing,
// and front_gaps.h fills what is between them. No cell is removed or flipped. So a node costs a look at the buckets
// around it, and a triangle one orientation. Page: docs/algorithms/advancing_front.md.
// Sources: [miranda1999mesh] (smallest first, generations), [lohner1988] (points near an ideal one).

#include <cstdint>
#include <vector>

#include "shared/mesh/front/fill_engine.h"

namespace dobra::mesh::front {

/// A directed side of the front, the part without triangles on its left.
struct FrontSide {
  static constexpr std::uint32_t free = 0xffffffffU;  ///< `from` of a slot that is not in use.

  delaunay::DelaunayKernel::Vertex from = free;
  std::uint32_t next = 0;  ///< The side that starts where this one ends.
  std::uint32_t previous = 0;
  std::uint32_t stamp = 0;  ///< Grows whenever the slot gets another side.
  delaunay::DelaunayKernel::Half back =
      0;  ///< What lies on its right: a half-edge, or, if `paired`, another side of the front.
  std::int32_t region = 0;
  delaunay::DelaunayKernel::Mark mark = 0;
  bool paired = false;
  std::uint16_t generation = 0;  ///< 0 for marked sides; else one more than that of the side whose turn made this one.
};

struct Front {
  std::vector<FrontSide> sides;
  std::vector<delaunay::DelaunayKernel::Vertex> loose;  ///< Nodes of the domain that lie on no marked side.
  std::uint16_t generation = 0;                         ///< Of the side whose turn was the last.

  [[nodiscard]] delaunay::DelaunayKernel::Vertex to(const FrontSide& side) const { return sides[side.next].from; }
};

/// What is said when sides of the front cross, or run out of the domain.
base::Error front_crossed();

/// Region of the cells of the domain that the front replaces: to be removed when all is filled.
inline constexpr std::int32_t replaced_region = -1000;

/// Replaces the cells with region >= 0 of `kernel` by triangles of the front. When done, the sides of `front` bound
/// what is left to be filled; its triangles are the cells with region >= 0.
/// @error SelfIntersection if the front runs out of the domain, which shows by its many triangles.
/// @cost  O(n) for n triangles.
std::unique_ptr<FillEngine> advancing_front(delaunay::DelaunayKernel& kernel, const sizing::SizeField& field,
                                            const FrontalOptions& options, Front& front);

}  // namespace dobra::mesh::front
