#pragma once
// The area of a trimmed surface. Page: docs/algorithms/import_of_faces.md.

#include "shared/surf/measure.h"
#include "shared/surf/trim/trimmed_surface.h"

namespace dobra::surf::trim {

/// Area within the loops, m2, positive where outer loops run anticlockwise; holes take theirs off. By Green's theorem:
/// along each loop the integral over v of the area element summed along u, rule of Gauss and Kronrod (7, 15) in both
/// ways. Pieces of loops are cut where the surface or the curve has a break, and halved, the worst first, until the sum
/// of the errors that halving lowers is within the tolerance; those of the sums along u are told with it.
/// @param tolerance  part of the area, or of that of the loops' box where the area is less than a thousandth of it.
/// Surfaces of very many pieces have (3, 7), or 3 places alone on each.
/// A whole chart of a graph that bends closely is summed by cells (measure.h).
/// Where the places are spent and the error is above 1e-5, a hundred times the tolerance is asked for, up to 1e-3.
/// @return the error beside the value; greater where 20000 pieces, 6 million places or the sums along u do not do.
/// @cost about 400 evaluations of the surface a smooth piece of a loop, times its pieces along u
Measured area(const TrimmedSurface& face, double tolerance = 1e-8);

}  // namespace dobra::surf::trim
