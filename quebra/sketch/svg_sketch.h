#pragma once
// Outlines of SVG pictures as a sketch: closed ones bound the domain, loops inside loops are holes; open ones have no
// role yet: those that close a chain bound it too, others are internal lines.

#include <vector>

#include "quebra/sketch/sketch.h"
#include "shared/base/result.h"
#include "shared/io/drawings/svg.h"

namespace quebra::sketch {

/// Straight pieces that follow each other are one curve; circular arcs stay arcs, other arcs and Bezier curves smooth
/// curves of their own. A path of several curves calls them NAME_1, NAME_2 ...
/// @param unit  metres in one unit of the file.
/// @error DegenerateCurve with the place of the element.
dobra::base::Result<Sketch> sketch_of(dobra::io::drawings::SvgFile file, double unit);

/// A piece whose coordinates are multiplied.
void scale(dobra::io::drawings::SvgPiece& piece, double x, double y);

/// The same of paths from another format, without remarks.
dobra::base::Result<Sketch> sketch_of_paths(const std::vector<dobra::io::drawings::SvgPath>& paths);

}  // namespace quebra::sketch
