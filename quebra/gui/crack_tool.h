#pragma once
// Draws cracks: an edge crack begins exactly on the border. Page: docs/user/canvas.md

#include <memory>

#include "shared/gui/window_part.h"

namespace quebra::gui {

/// Clicks are the points of a crack; Enter or a double click ends it, and it stands in the document under the next free
/// name. Near the border its ends go onto the curve itself, an arc or a spline too. The length and, of an edge crack,
/// the angle between its beginning and the border are told meanwhile.
std::unique_ptr<dobra::canvas::Tool> make_crack_tool(const dobra::gui::Desk& desk);

/// A border with a crack.
void draw_crack(QPainter& painter);

}  // namespace quebra::gui
