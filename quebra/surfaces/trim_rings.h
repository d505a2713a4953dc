#pragma once
// The rings of trims that other surfaces and planes cut: what a hole or an outline goes round. Pieces of a cut follow
// each other over the seams of a closed surface; what goes from place to place of one side of the chart is closed along
// that side. What goes round the surface, or across it, has no inside, and is refused. Page: docs/user/surfaces.md.

#include <span>
#include <string>
#include <vector>

#include "quebra/surfaces/trim_params.h"
#include "shared/base/result.h"
#include "shared/surf/trim/trimmed_surface.h"

namespace quebra::surfaces {

struct TrimRing {
  TrimRole role = TrimRole::Hole;
  std::string name;
  std::vector<dobra::geom::Point> places;  ///< Closed; over a seam it goes on beyond the chart.
  std::vector<std::size_t> lines = {};     ///< Of which it consists.
};

/// @param pieces  ways in the chart, each followed in the direction of the cut
/// @return closed ways, with the numbers of their pieces
/// @error BadDomain with u and v of the chart: a way that goes round the surface, or from one side to another one.
/// @cost O(n^2) in the pieces
dobra::base::Result<std::vector<TrimRing>> rings_of_cut(const dobra::surf::Surface& surface, const TrimParams& trim,
                                                        std::span<const std::vector<dobra::geom::Point>> pieces);

}  // namespace quebra::surfaces
