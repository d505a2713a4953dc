#pragma once
// The pin of a target, dragged along the top while the restoration follows. Page: docs/user/canvas.md

#include <memory>

#include "shared/gui/window_part.h"

namespace recon::gui {

/// Where the mouse is pressed and dragged to is the `pin` of the step 'target' whose section the panel shows: the last
/// such step. Beyond an end of the top it stays at that end. A gesture is one edit; Escape leaves the document as it
/// was.
std::unique_ptr<dobra::canvas::Tool> make_pin_tool(const dobra::gui::Desk& desk);

/// A pin through two beds.
void draw_pin(QPainter& painter);

}  // namespace recon::gui
