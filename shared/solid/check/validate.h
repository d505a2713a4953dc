#pragma once
// An oracle for solids: links, places and numbers by brute force, and the geometry by an arrangement of all faces.

#include <string>
#include <vector>

#include "shared/solid/solid.h"

namespace dobra::solid::check {

/// All that is wrong, one line each; nothing if the boundary is closed, oriented, without faces that cross or cover
/// each other, and every corner lies in its faces' planes exactly.
/// @cost O(n log n + pairs of faces whose boxes overlap)
std::vector<std::string> violations(const Solid& solid);

}  // namespace dobra::solid::check
