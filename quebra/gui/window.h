#pragma once
// The window of QUEBRA: shared/gui with QUEBRA's program.

#include "shared/gui/app.h"

namespace quebra::gui {

/// @return the exit code of the program; see dobra::gui::run_window.
int run_window(const std::optional<std::filesystem::path>& file, const dobra::gui::WindowOptions& options = {});

}  // namespace quebra::gui
