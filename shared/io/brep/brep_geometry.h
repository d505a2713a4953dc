#pragma once
// The tables of curves and surfaces of a .brep file.

#include "shared/io/brep/brep.h"
#include "shared/io/brep/tokens.h"

namespace dobra::io::brep {

enum class Room { Chart, Space };

/// A table with its keyword and count.
base::Result<std::vector<CurvePtr>> read_curves(Tokens& tokens, Room room);
base::Result<std::vector<SurfacePtr>> read_surfaces(Tokens& tokens);
base::Result<std::vector<Placement>> read_locations(Tokens& tokens);

}  // namespace dobra::io::brep
