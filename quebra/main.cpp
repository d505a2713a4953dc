// quebra: the window without a sub-command, or with a file alone; the command line with a sub-command.

#include "quebra/cli/analysis_commands.h"
#include "quebra/cli/check_command.h"
#include "quebra/cli/mesh_command.h"
#include "quebra/cli/sheet_commands.h"
#include "quebra/cli/solid_command.h"
#include "quebra/core/operations.h"
#include "shared/cli/cli.h"
#include "shared/cli/convert_command.h"
#include "shared/cli/offset_command.h"
#include "shared/cli/session.h"
#include "shared/cli/window_options.h"
#include "shared/fem/process_group.h"
#ifdef DOBRA_WITH_GUI
#include "quebra/gui/window.h"
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
    return quebra::gui::run_window(file, ours);
  };
#endif
  auto commands = quebra::cli::analysis_commands();
  commands.insert(commands.begin(),
                  {dobra::cli::offset_command(), quebra::cli::mesh_command(), quebra::cli::check_command(),
                   quebra::cli::solid_command(), quebra::cli::parametrise_command(), quebra::cli::remesh_command(),
                   dobra::cli::convert_command()});
  return dobra::fem::run_in_group(
      argc, argv, [&] { return dobra::cli::run_program(quebra::core::program(), argc, argv, window, commands); });
}
