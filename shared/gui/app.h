#pragma once
// Opens the window of a program and stays until it is closed.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "shared/scenario/program.h"

namespace dobra::gui {

struct WindowPart;  // window_part.h

struct WindowOptions {
  std::optional<std::filesystem::path> script;  ///< Commands to execute in the window: see script.h.
  std::string language;                         ///< Such as "pt_BR"; that of the locale if empty.
};

/// Opens the window of a program, with a document if `file` is given. A file that cannot be opened is reported in the
/// window; with a script, on standard error.
/// @return 0 when the window was closed; 1 if a command of the script failed; 2 or 3 for a script or a file that cannot
/// be
///         read; 4 without a display.
int run_window(const scenario::Program& program, const WindowPart& part,
               const std::optional<std::filesystem::path>& file, const WindowOptions& options = {});

/// What must be set before a QApplication is made: OpenGL 3.2 core with a depth buffer, shared contexts, xcb.
void prepare_application();

/// Whether a window can be opened at all: without a display QApplication would abort the program.
bool has_display();

}  // namespace dobra::gui
