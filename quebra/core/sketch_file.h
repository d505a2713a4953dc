#pragma once
// Files that hold the geometry of a domain: .poly of Triangle, .geo of gmsh, outlines of .svg, curves in the exchange formats, and meshes whose
// boundary is meant.

#include <string>

#include "quebra/core/domain.h"

namespace quebra::core {

/// By the ending of the name: .poly, .geo, .svg, .msh, .inp, .vtu, .bdf .nas, .nf, .ele, or a format of io::read_curves. Of curves
/// without roles, closed ones and chains that close bound the domain, the others are internal lines.
/// @error UnknownFormat naming what is read; those of the readers; OutsideDomain for a hole point outside.
dobra::base::Result<Sketch> read_sketch(const std::string& path);

}  // namespace quebra::core
