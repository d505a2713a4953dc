#pragma once
// The command line that both programs share: sub-commands, common options, exit codes. See docs/scenario_format.md and
// docs/architecture.md, "Two names to remember".
//
// Exit codes: 0 done, 1 an expectation failed, 2 wrong usage, 3 bad input, 4 could not be done or written, 130
// interrupted.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "shared/cli/session.h"

namespace CLI {
class App;
}

namespace dobra::cli {

/// Does the work of a sub-command and returns the exit code; an error's exit code follows from its own code.
using Job = std::function<base::Result<int>(Session&)>;

/// A sub-command. --help, --version, --json, --quiet, --verbose and --threads are added to each.
struct Command {
  std::string name;
  std::string help;
  std::function<Job(CLI::App&)> setup;  ///< Adds options to the sub-command and returns what is to be done with them.
};

/// What happens without a sub-command, or with a file alone.
struct Window {
  std::function<int(const std::optional<std::filesystem::path>& file)> open;  ///< Empty: this build has no window.
  std::function<void(CLI::App&)> add_options = {};                            ///< Options beside FILE; may be empty.
  /// Whether it says by itself that FILE is not there; empty: it does not.
  std::function<bool()> tells_missing_files = {};
};

/// The whole of main(): parses, runs, prints, and returns the exit code. Catches what memory exhaustion throws.
/// @param commands  sub-commands beside run, render and operations.
int run_program(const scenario::Program& program, int argc, char** argv, const Window& window = {},
                const std::vector<Command>& commands = {});

}  // namespace dobra::cli
