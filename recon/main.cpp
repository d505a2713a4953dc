// recon: the window without a sub-command, or with a file alone; the command line with a sub-command.

#include "recon/cli/block_commands.h"
#include "recon/cli/fault_commands.h"
#include "recon/cli/inversion_commands.h"
#include "recon/cli/move_commands.h"
#include "recon/cli/section_commands.h"
#include "recon/cli/solid_command.h"
#include "recon/cli/space_commands.h"
#include "recon/core/operations.h"
#include "shared/cli/cli.h"
#include "shared/cli/convert_command.h"
#include "shared/cli/offset_command.h"
#include "shared/cli/session.h"
#include "shared/cli/window_options.h"
#ifdef DOBRA_WITH_GUI
#include "recon/gui/window.h"
#endif

int main(int argc, char** argv) {
  const dobra::cli::Interruption interruption;
  dobra::cli::Window window;
#ifdef DOBRA_WITH_GUI
  dobra::cli::WindowOptions options;
  window.add_options = [&](CLI::App& app) { dobra::cli::add_window_options(app, options); };
  window.tells_missing_files = [&] { return options.script.empty() && dobra::gui::has_display(); };
  window.open = [&](const std::optional<std::filesystem::path>& file) {
    dobra::gui::WindowOptions ours;
    ours.language = options.language;
    if (!options.script.empty()) ours.script = options.script;
    return recon::gui::run_window(file, ours);
  };
#endif
  return dobra::cli::run_program(
      recon::core::program(), argc, argv, window,
      {dobra::cli::offset_command(), recon::cli::restore_command(), recon::cli::balance_command(),
       recon::cli::faults_command(), recon::cli::move_command(), recon::cli::invert_command(),
       recon::cli::predict_command(), recon::cli::block_command(), recon::cli::solid_command(),
       recon::cli::surface_command(), recon::cli::cut_command(), dobra::cli::convert_command()});
}
