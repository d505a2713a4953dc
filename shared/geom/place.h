#pragma once
// A point as the place of an error, for the user to zoom to.

#include <string>
#include <utility>

#include "shared/base/error.h"
#include "shared/geom/point.h"

namespace dobra::geom {

inline base::Place place_at(Point p, std::string item = {}) { return {.item = std::move(item), .x = p.x, .y = p.y}; }

}  // namespace dobra::geom
