#pragma once
// The surface through lines that lie side by side: straight from vertex to vertex along the lines, a cubic spline
// across them. Across the lines it misses a smooth surface by the fourth power of their spacing. Solids between whole
// sections are solid/shape/loft.h. Page: docs/algorithms/loft.md. Source: [piegl1997] 9.2.1 (interpolation), 10.3
// (skinning).

#include <array>
#include <optional>
#include <vector>

#include "shared/surf/surface.h"

namespace dobra::surf::loft {

struct Loft {
  Surface surface;              ///< u along the lines, v across them, both from 0 to 1.
  std::vector<double> lines_v;  ///< v of each line. At that v the surface is the line, with all its vertices.
};

/// Where each vertex of each line is along u, from 0 to 1, rising. Before its first vertex and behind its last a line
/// stays at its end, so that what another has beside nothing runs together there.
using LineParts = std::vector<std::vector<double>>;

/// u is the part of a line's length, or what `parts` say; v goes by the mean chord from line to line. Through four
/// lines and more the third derivative is continuous at the second and the last but one; three give a parabola, two
/// straight ways.
/// @param lines  in their order, each run the same way, with two points at least.
/// @error InvalidOption: fewer than two lines; DegenerateCurve: a line without length, a point twice in turn, or two
///        lines at one place, with the place.
/// @cost  O(vertices times lines)
base::Result<Loft> loft(const std::vector<std::vector<geom::Point3>>& lines, const LineParts& parts = {});

/// The parts at which any of the lines has a vertex. Vertices of different lines that are nearer to each other than
/// 2e-5, as rounding of files parts them, are at one break, each where it is; so are ends that are so near to 0 or 1.
/// Ends that others reach beyond have breaks of their own. Of two vertices of one line that are nearer than 1e-10 one
/// counts.
struct CommonBreaks {
  std::vector<double> u;
  std::vector<std::vector<geom::Point3>> points;  ///< [line][break]
  std::vector<std::vector<double>> parts;         ///< [line][break]: where that point is along its own line.
  std::vector<std::array<std::size_t, 2>> reach;  ///< The first and the last break that a line has of its own.
};
/// @error as loft
base::Result<CommonBreaks> common_breaks(const std::vector<std::vector<geom::Point3>>& lines,
                                         const LineParts& parts = {});

/// The parts by the place along a direction of the map, from the least to the greatest of all lines; an end that is
/// `held` (at a fault) is at 0 or at 1 wherever it is. Nothing where a line turns back along the direction.
/// @param held  the low ends, the high ends.
std::optional<LineParts> parts_by_place(const std::vector<std::vector<geom::Point3>>& lines, geom::Vector way,
                                        std::array<bool, 2> held);

}  // namespace dobra::surf::loft
