#pragma once
// What can be said of lines, and selections made at once. Page: docs/user/canvas.md.

#include <string>
#include <vector>

#include "shared/canvas/line_text.h"
#include "shared/canvas/workspace.h"

namespace dobra::canvas {

/// Every line that can be edited.
Selection all_lines(const Workspace& work);
/// Those of all_lines that are not selected.
Selection other_lines(const Workspace& work);

/// "Top: 125.3 m, 12 vertices"; of several lines how many, and their sums. Empty where nothing is selected.
std::string selection_text(const Workspace& work);

/// The direction of a segment, whatever the exaggeration of the view: "dip 30.2°", "dip 30.2° (Top)", or "angle
/// -30.2°", from the first axis to the segment as a line without ends, above -90 up to 90.
std::string direction_text(const Workspace& work, const Snap& on);

/// Round the selected vertices, or where there are none the selected lines; empty where nothing is selected.
geom::Box selection_box(const Workspace& work);

/// The selected lines, each with the title of its layer.
std::vector<NamedLine> selected_lines(const Workspace& work);

}  // namespace dobra::canvas
