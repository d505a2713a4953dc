#pragma once
// The advancing front: fills a domain with triangles from its marked sides inwards, row after row, small sizes first.
// Only what is plainly good is done: a corner of the front that is narrow enough is closed, over a side with nothing
// near a node is put where the triangle has the size wanted. Where fronts meet or the input is crowded the sides are
// left standing: fill_gaps (front_gaps.h) fills what is between them. No cell is removed or flipped, so that a node
// costs a look at the buckets around it and a triangle one orientation. Page: docs/algorithms/advancing_front.md.
// Sources: [miranda1999mesh] (smallest first, generations), [lohner1988] (points near an ideal one).

#include <cstdint>
#include <vector>

#include "shared/base/progress.h"
#include "shared/mesh/delaunay_kernel.h"
#include "shared/mesh/frontal_points.h"
#include "shared/mesh/size_field.h"

namespace dobra::mesh {

/// A directed side of the front, the part without triangles on its left.
struct FrontSide {
  static constexpr std::uint32_t free = 0xffffffffU;  ///< `from` of a slot that is not in use.

  DelaunayKernel::Vertex from = free;
  std::uint32_t next = 0;  ///< The side that starts where this one ends.
  std::uint32_t previous = 0;
  std::uint32_t stamp = 0;        ///< Grows whenever the slot gets another side.
  DelaunayKernel::Half back = 0;  ///< What lies on its right: a half-edge, or, if `paired`, another side of the front.
  std::int32_t region = 0;
  DelaunayKernel::Mark mark = 0;
  bool paired = false;
};

struct Front {
  std::vector<FrontSide> sides;
  std::vector<DelaunayKernel::Vertex> loose;  ///< Nodes of the domain that lie on no marked side.

  [[nodiscard]] DelaunayKernel::Vertex to(const FrontSide& side) const { return sides[side.next].from; }
  /// The half-edge `half` of a new triangle takes the place of the side `s`.
  void attach(DelaunayKernel& kernel, std::uint32_t s, DelaunayKernel::Half half) {
    const FrontSide& side = sides[s];
    if (side.paired) {
      sides[side.back].back = half;
      sides[side.back].paired = false;
    } else {
      kernel.link(half, side.back, side.mark);
    }
  }
};

/// Whether a front is joined to itself where it meets itself, or left standing. Nearly all of the domain is covered
/// with Join; a crowded input may make it cross itself, which LeaveOpen hardly ever does.
enum class Meetings : std::uint8_t { Join, LeaveOpen };

/// What advance_front and fill_gaps say when sides of the front cross, or run out of the domain.
base::Error front_crossed();

/// Region of the cells of the domain that the front replaces: to be removed when all is filled.
inline constexpr std::int32_t replaced_region = -1000;

/// Replaces the cells with region >= 0 of `kernel` by triangles of the front.
/// @return the sides that are left: they bound the gaps.
/// @error  SelfIntersection if the front runs out of the domain; TooManyElements with advice; Cancelled. `kernel` is
/// then
///         spoilt.
/// @cost   O(n) for n triangles.
base::Result<Front> advance_front(DelaunayKernel& kernel, const SizeField& field, const FrontalOptions& options,
                                  Meetings meetings, const base::Progress& progress);

}  // namespace dobra::mesh
