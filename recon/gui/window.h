#pragma once
// The window of RECON: shared/gui with RECON's program, and what that adds.

#include "shared/gui/app.h"

namespace recon::gui {

/// Its examples, the pin, the balance.
dobra::gui::WindowPart window_part();

/// @return the exit code of the program; see dobra::gui::run_window.
int run_window(const std::optional<std::filesystem::path>& file, const dobra::gui::WindowOptions& options = {});

}  // namespace recon::gui
