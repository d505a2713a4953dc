#pragma once
// What directed sides enclose on their left.

#include <span>

#include "shared/geom/segment.h"

namespace quebra::sketch {

/// m2.
double area_of(std::span<const dobra::geom::Segment> sides);

/// A point well inside. @pre some side
dobra::geom::Point inner_point(std::span<const dobra::geom::Segment> sides);

}  // namespace quebra::sketch
