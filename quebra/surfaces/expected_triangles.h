#pragma once
// How many triangles sizes ask of a face, told before anything is meshed. Page: docs/user/surfaces.md.

#include <cstddef>

#include "shared/base/result.h"
#include "shared/surf/mesh/chart_input.h"
#include "shared/surf/trim/trimmed_surface.h"

namespace quebra::surfaces {

/// The sum of 4 dA / (sqrt(3) h^2) over places of a net of lines in the chart; the few greatest parts are left out, so
/// that a point where the surface is bent without bound does not count. Sizes grow from place to place, which is left
/// out too: it is less than there will be.
struct ExpectedTriangles {
  double count = 0.0;
  dobra::geom::Point finest;  ///< Where the size is least, in the chart.
};
ExpectedTriangles expected_triangles(const dobra::surf::trim::TrimmedSurface& face,
                                     const dobra::surf::mesh::SizeOptions& sizes, int lines);

/// @error TooManyElements with the place, where more than twice as many are expected as are allowed: over the chart, or
/// in the parts in which a graph bends closely (surf/details.h), which such places miss.
/// @cost 1,000 places of the surface; 16,000 where more than a hundredth of what is allowed is expected; those of
/// details_of for a graph that bends closely.
dobra::base::Result<void> not_too_many(const dobra::surf::trim::TrimmedSurface& face,
                                       const dobra::surf::mesh::SizeOptions& sizes, std::size_t most);

}  // namespace quebra::surfaces
