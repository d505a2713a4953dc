#pragma once
// The entities of a DXF drawing as true curves: LINE, ARC, CIRCLE, ELLIPSE, LWPOLYLINE and POLYLINE with bulges, and
// SPLINE up to the third degree without weights, cut into the cubic Bezier curves that it is made of. What read_dxf
// gives as chords stays what it was drawn as. Source: [farin2002curves], blossoms.

#include <optional>
#include <string_view>
#include <vector>

#include "shared/io/drawings/svg.h"

namespace dobra::io::drawings {

/// The paths of a drawing in drawing units, x right and y up, named as read_dxf names its features, without
/// what is not displayed; nothing where that
/// reader must do it all: no bent entity, or one beside those above (INSERT, HATCH, a spline of weights or of fit
/// points ...), heights, paper space, an inclined plane.
/// @pre read_dxf reads the text
std::optional<std::vector<SvgPath>> dxf_paths(std::string_view text, const std::string& file);

}  // namespace dobra::io::drawings
