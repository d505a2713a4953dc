#pragma once
// A finding as a line on the terminal and in the window: its message and its place.

#include <string>

#include "shared/surf/mesh/surface_mesh.h"

namespace quebra::surfaces {

/// "message; at (u 50.2, v 10)" with the place in the chart where `in_chart`, else "message; at (x, y, z)" [m]; the
/// message alone where neither is known. What it is of stands before it: "face 3: message".
std::string line_of(const dobra::surf::mesh::Finding& finding, bool in_chart);

}  // namespace quebra::surfaces
