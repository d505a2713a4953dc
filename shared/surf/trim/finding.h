#pragma once
// What was mended, and where: findings and errors with a place in space and in the chart.

#include <string>

#include "shared/base/error.h"
#include "shared/surf/surface.h"

namespace dobra::surf::trim {

/// What was mended, or what an answer leaves open; it stands beside an answer, never instead of one.
struct Finding {
  std::string code;     ///< Stable, for scripts: "gap_closed", "loop_turned".
  std::string message;  ///< One line.
  base::Place place;    ///< x, y, z and u, v.
};

inline base::Place place_of(const Surface& surface, geom::Point uv) {
  const geom::Point3 p = surface.at(uv);
  return {.x = p.x, .y = p.y, .z = p.z, .u = uv.x, .v = uv.y};
}

}  // namespace dobra::surf::trim
