#pragma once
// What a screen reader hears, where Qt says less than it could.

namespace dobra::gui::heard {

/// Combo boxes are called by their accessible name and hold what is chosen; on Linux Qt calls them by what is chosen,
/// so that a field is heard as "1". Once is enough.
void name_boxes();

}  // namespace dobra::gui::heard
