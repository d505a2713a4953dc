#pragma once
// The window of QUEBRA: shared/gui with QUEBRA's program, and what that adds.

#include "shared/gui/app.h"

namespace quebra::gui {

/// Its examples, the tool that draws cracks, the list of cracks.
dobra::gui::WindowPart window_part();

/// @return the exit code of the program; see dobra::gui::run_window.
int run_window(const std::optional<std::filesystem::path>& file, const dobra::gui::WindowOptions& options = {});

}  // namespace quebra::gui
