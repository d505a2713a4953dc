#pragma once
// The picture as marks of a page: projected, cut to the plot, and in painter's order, the farthest first. Vector files
// draw it. Triangles are ordered by the depth of their middle, lines by that of pieces a few points long: triangles
// that cross each other, and large ones beside small ones, may hide what is before them. VTK's depth buffer has no such
// limit. Page: docs/algorithms/projection.md. Source: [foley1990graphics].

#include <vector>

#include "shared/scene/marks.h"
#include "shared/scene/space/picture.h"

namespace dobra::scene::space {

struct DisplayOptions {
  double piece = 6.0;  ///< Longest piece of a line that has one depth, points.
  double seam = 0.3;   ///< TriangleMark::seam, points.
  int levels = 64;     ///< Colours of a scale.
};

/// Lines, triangles and markers of the visible layers; labels are the layout's (layout.h).
/// @cost O(n log n), n triangles, bands of colour in them and pieces of lines
std::vector<Mark> marks_of(const SpacePicture& picture, const Sheet& sheet, const DisplayOptions& options = {});

/// The part of a line that is in front of the eye and within the plot, page coordinates with depth at both ends;
/// nothing if none is.
struct SeenLine {
  Projected from;
  Projected to;
};
std::optional<SeenLine> seen_line(const Sheet& sheet, geom::Point3 from, geom::Point3 to);

}  // namespace dobra::scene::space
