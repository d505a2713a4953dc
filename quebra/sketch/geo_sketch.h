#pragma once
// A gmsh geometry as a sketch: curves of one plane surface bound it, those between two divide it; physical groups
// become sets and region names, sizes of points become sizes.

#include "quebra/sketch/sketch.h"
#include "shared/base/result.h"
#include "shared/io/drawings/geo.h"

namespace quebra::sketch {

/// Curves are named "curve_TAG", groups by their name or "physical_TAG". Surfaces without a group have no name.
/// @param unit  metres in one unit of the file.
/// @error DegenerateCurve for an arc whose points do not lie on one.
dobra::base::Result<Sketch> sketch_of(dobra::io::drawings::GeoFile file, double unit);

}  // namespace quebra::sketch
