#pragma once
// Chooses which parts of surfaces are meshed, by clicks in their charts and in space. Page: docs/user/space_view.md.

#include <memory>

#include "shared/gui/window_part.h"

class QPainter;

namespace quebra::gui {

/// A click in a part takes it out of what is meshed, or into it again. The part under the cursor is outlined in its
/// chart.
std::unique_ptr<dobra::canvas::Tool> make_part_tool(const dobra::gui::Desk& desk);

/// The same with a click in space, while this tool is in hand; else nothing. The plane tells the tool itself.
void choose_part(const dobra::gui::Desk& desk, const dobra::gui::stage::ItemAt& item);

/// A plate of two parts, one of them filled.
void draw_part(QPainter& painter);

}  // namespace quebra::gui
