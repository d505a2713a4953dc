#pragma once
// What drawn trims may have been meant for and do not do: cuts that divide nothing, cracks that open nothing, ends that
// stop just before a border, loops that cross. None is refused; each is told with its place. Page:
// docs/user/surfaces.md.

#include <span>
#include <string>
#include <vector>

#include "quebra/surfaces/trim_params.h"
#include "shared/surf/mesh/surface_mesh.h"
#include "shared/surf/trim/recognise.h"
#include "shared/surf/trim/trimmed_surface.h"

namespace quebra::surfaces {

/// A trim as it was drawn.
struct DrawnTrim {
  TrimRole role = TrimRole::Cut;
  std::string name;
  bool closed = false;
  std::vector<dobra::geom::Point> places;  ///< Along it, in the chart; ends first and last.
};

struct DoubtOptions {
  double same = 1e-6;  ///< Places nearer are one, by parts of the chart's ranges.
  double shy = 5e-3;   ///< An end so near to a border that it does not meet is told, part of the surface's size.
};

/// @param parts  all faces that the trims make of the chart
/// @param left   what is left of it
/// @param on_cracks  what cracks that are left have in common with other lines
/// @return codes cut_divides_nothing, crack_opens_nothing, line_left_out, line_on_crack, line_short,
///         loop_bounds_nothing, trims_cross; places in the chart
/// @cost O(n^2) in the edges of all parts
std::vector<dobra::surf::mesh::Finding> trim_doubts(const dobra::surf::Surface& surface,
                                                    std::span<const DrawnTrim> drawn,
                                                    std::span<const dobra::surf::trim::TrimmedSurface> parts,
                                                    const dobra::surf::trim::TrimmedSurface& left,
                                                    std::span<const dobra::surf::trim::OnCrack> on_cracks,
                                                    const DoubtOptions& options = {});

}  // namespace quebra::surfaces
