#pragma once
// Loops of a face as rings of points, for where a tenth of a percent does. Of use inside this folder.

#include "shared/surf/trim/trimmed_surface.h"

namespace dobra::surf::trim {

using Ring = std::vector<geom::Point>;

/// Points along an edge, its last one left out.
void add_points(const ChartEdge& edge, Ring& points);
std::vector<Ring> rings_of(const TrimmedSurface& face);

/// Positive if anticlockwise.
double area_of(const Ring& ring);

/// Where a line of constant v meets rings, by u: inside from the first to the second, and so on.
std::vector<double> meets(const std::vector<Ring>& rings, double v);

/// A point well inside: the middle of the longest way through it of many.
geom::Point inner_point(const TrimmedSurface& face);

}  // namespace dobra::surf::trim
