#pragma once
// From the arrangement to a solid: the cells between inside and outside, neighbours of one plane and name joined to
// faces, vertices within straight edges taken out.

#include <functional>

#include "shared/solid/solid.h"
#include "shared/solid/windings.h"

namespace dobra::solid {

/// @param inside  of each kind of Sides::kinds, whether it is inside the result.
/// @param names   what Facet::name stands for.
/// @cost  O(n log n)
Boundary assemble(const Soup& soup, const Contacts& contacts, const Cells& cells, const Fans& fans, const Sides& sides,
                  const std::vector<char>& inside, std::vector<std::string> names);

}  // namespace dobra::solid
