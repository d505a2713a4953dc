// recon: the window without a sub-command, or with a file alone; the command line with a sub-command.

#include <CLI/CLI.hpp>

#include "recon/cli/section_commands.h"
#include "recon/core/operations.h"
#include "shared/cli/cli.h"
#include "shared/cli/convert_command.h"
#include "shared/cli/offset_command.h"
#include "shared/cli/session.h"
#ifdef DOBRA_WITH_GUI
#include "recon/gui/window.h"
#endif

int main(int argc, char** argv) {
  const dobra::cli::Interruption interruption;
  dobra::cli::Window window;
#ifdef DOBRA_WITH_GUI
  std::string script;
  dobra::gui::WindowOptions options;
  window.add_options = [&](CLI::App& app) {
    app.add_option("--script", script, "File of commands to execute in the window")->type_name("FILE");
    app.add_option("--language", options.language, "Language of the window, such as pt_BR")->type_name("NAME");
  };
  window.open = [&](const std::optional<std::filesystem::path>& file) {
    if (!script.empty()) options.script = script;
    return recon::gui::run_window(file, options);
  };
#endif
  return dobra::cli::run_program(recon::core::program(), argc, argv, window,
                                 {dobra::cli::offset_command(), recon::cli::restore_command(),
                                  recon::cli::balance_command(), dobra::cli::convert_command()});
}
