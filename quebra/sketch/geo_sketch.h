#pragma once
// A gmsh geometry as a sketch: curves of one plane surface bound it, those between two divide it; physical groups
// become sets and region names, sizes of points become sizes.

#include <string>

#include "quebra/sketch/sketch.h"
#include "shared/base/result.h"

namespace quebra::sketch {

/// Curves are named "curve_TAG", groups by their name or "physical_TAG". Surfaces without a group have no name.
/// @param unit  metres in one unit of the file.
/// @error those of io::drawings::read_geo; DegenerateCurve for an arc whose points do not lie on one.
dobra::base::Result<Sketch> read_geo_sketch(const std::string& path, double unit = 1.0);

}  // namespace quebra::sketch
