#pragma once
// What a person points at in the picture in space or in the plane beside it, and markers that are dragged there.

#include <optional>
#include <string>

#include "shared/geom/point3.h"
#include "shared/scene/pick.h"

namespace dobra::gui::stage {

/// An item that was pointed at, with its place in whichever has one: in space, in the parameter plane of its surface.
struct ItemAt {
  scene::Pick pick;
  std::optional<geom::Point3> place = std::nullopt;
  std::optional<geom::Point> chart = std::nullopt;
  std::string panel = {};  ///< Of the plane; empty: it was pointed at in space.
};

/// A marker on its way. Escape takes it back: it ends where it was.
enum class MarkerDrag { Begins, Moves, Ends, IsTakenBack };

}  // namespace dobra::gui::stage
