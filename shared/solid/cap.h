#pragma once
// The section of solids by a plane as lines and regions: what a plane domain or a geological section is made of. A line
// runs between two places where the names of the faces that were cut, or what lies on its sides, change. Page:
// docs/algorithms/cap.md. Source: [mantyla1988solid] for the operation; the way is ours.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "shared/geom/polyline.h"
#include "shared/geom/segment.h"
#include "shared/solid/section.h"

namespace dobra::solid {

/// Which solid is on a side of a line; `outside` for none.
constexpr std::uint32_t outside = 0xffffffffU;

struct CapLine {
  geom::Polyline line;             ///< Closed where nothing ends on it; the solid `left` is on its left-hand side.
  std::vector<std::string> names;  ///< Of the faces that were cut there, sorted, each once.
  std::uint32_t left = outside;    ///< Always a solid; of two the one with the lower number.
  std::uint32_t right = outside;
};

/// A connected part of the plane that one solid fills.
struct CapRegion {
  std::uint32_t solid = 0;
  double area = 0.0;                 ///< m2.
  std::size_t holes = 0;             ///< Loops beyond the outer one; islands of other solids count.
  std::vector<geom::Segment> sides;  ///< Its loops, the region on their left.
};

struct Cap {
  SectionFrame frame;
  std::vector<CapLine> lines;
  std::vector<CapRegion> regions;
  [[nodiscard]] bool empty() const { return regions.empty(); }
};

struct CapOptions {
  /// A corner that is this fraction of the section's diagonal or less off the line between its neighbours is left out:
  /// what diagonals of a face leave behind when corners are rounded.
  double straight = 1e-12;
};

/// @cost O(n log n)
Cap cap_of(const Section& section, const CapOptions& options = {});

/// What solids have in common with a plane.
struct PlaneContact {
  Contact most = Contact::Nothing;  ///< Of any shell; Volume where it has solid on both sides.
  bool in_face = false;             ///< A face of some solid lies in the plane: just above, the section is another one.
};

/// @error InvalidOption as frame_of() says.  @cost O(n)
base::Result<PlaneContact> contact_with(std::span<const Solid> solids, const CutPlane& plane);

}  // namespace dobra::solid
