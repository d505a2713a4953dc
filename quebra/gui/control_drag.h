#pragma once
// Control points of curves and surfaces dragged in space. Page: docs/user/space_view.md.

#include "shared/gui/window_part.h"

namespace quebra::gui {

/// While a drag lasts, the document with the point elsewhere is run and looked at; its end is one edit.
using ControlDrag = std::function<void(const dobra::gui::Desk& desk, dobra::gui::stage::MarkerDrag phase,
                                       const dobra::gui::stage::ItemAt& marker, const dobra::geom::Point3& to)>;
ControlDrag make_control_drag();

}  // namespace quebra::gui
