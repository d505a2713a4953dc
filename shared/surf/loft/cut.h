#pragma once
// Where surfaces meet a vertical plane: a new section; and where they have one height: contours. Vertices of the lines
// are on the surfaces themselves, one for each side of the lattice that is passed; a side in the plane is a part of the
// line as it is, so that a section's own plane gives its own lines. Page: docs/algorithms/loft.md.

#include <string>
#include <vector>

#include "shared/surf/loft/patch.h"

namespace dobra::surf::loft {

/// One connected line in a section, by (s, z).
struct CutLine {
  std::string name;
  LineKind kind = LineKind::Horizon;
  geom::Polyline line;
  std::string first_fault, last_fault;  ///< At which its ends lie; empty: none.
};

struct SectionCut {
  std::vector<CutLine> lines;  ///< By surface, then from the left; each runs from the left to the right, or upwards.
  std::vector<Finding> findings;
};

/// The lines of surfaces over a trace, from its first corner to its last. Surfaces that lie in the plane of the section
/// over an area are told.
/// @param size  of all that the surfaces came from, m: vertices nearer to the plane than 1e-10 of it are in it.
SectionCut cut_along(const std::vector<NamedSurface>& surfaces, const PlanTrace& trace, double size);

/// Lines of one height.
struct Contour {
  double level = 0.0;
  std::vector<std::vector<geom::Point3>> lines;  ///< A closed one repeats its first point.
};
/// At all multiples of `interval`. @pre interval > 0  @error TooManyElements: more than 10 000 levels
base::Result<std::vector<Contour>> contours(const NamedSurface& surface, double interval);

}  // namespace dobra::surf::loft
