#pragma once
// The window of RECON: shared/gui with RECON's program.

#include "shared/gui/app.h"

namespace recon::gui {

/// @return the exit code of the program; see dobra::gui::run_window.
int run_window(const std::optional<std::filesystem::path>& file, const dobra::gui::WindowOptions& options = {});

}  // namespace recon::gui
