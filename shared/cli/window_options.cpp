#include "shared/cli/window_options.h"

#include <CLI/CLI.hpp>

namespace dobra::cli {

void add_window_options(CLI::App& app, WindowOptions& options) {
  app.add_option("--script", options.script, "File of commands to execute in the window")->type_name("FILE");
  app.add_option("--language", options.language, "Language of the window, such as pt_BR")->type_name("NAME");
}

}  // namespace dobra::cli
