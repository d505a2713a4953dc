#include "shared/cli/cli.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <new>

#include "shared/base/parallel.h"
#include "shared/base/text.h"
#include "shared/cli/commands.h"
#include "shared/cli/findings.h"

namespace dobra::cli {
namespace {

using base::Error;
using base::ErrorCode;

/// Flags as CLI11 fills them.
struct Flags {
  bool json = false;
  bool quiet = false;
  bool verbose = false;
  std::size_t threads = 0;

  [[nodiscard]] CommonOptions options() const {
    return {quiet     ? Verbosity::Quiet
            : verbose ? Verbosity::Verbose
                      : Verbosity::Normal,
            json ? OutputFormat::Json : OutputFormat::Text, threads};
  }
};

constexpr const char* exit_codes =
    "Exit codes: 0 done, 1 an expectation failed, 2 wrong usage, 3 bad input, 4 could not be done or written, 130 "
    "interrupted.";

std::string version_text(const scenario::Program& program) { return fmt::format("{} {}", program.name, DOBRA_VERSION); }

void add_common(CLI::App& app, Flags& flags, const scenario::Program& program) {
  app.add_flag("--json", flags.json, "Machine-readable results on standard output");
  CLI::Option* quiet = app.add_flag("--quiet,-q", flags.quiet, "Errors only");
  app.add_flag("--verbose,-v", flags.verbose, "More messages")->excludes(quiet);
  app.add_option("--threads", flags.threads, "Threads to use; all cores by default")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
  app.set_version_flag("--version", version_text(program), "Print the version and exit");
  app.set_help_flag("--help,-h", "Print this help and exit");
  app.footer(exit_codes);
}

/// Long names of the options of `app`.
std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

class CommandLine {
 public:
  CommandLine(const scenario::Program& program, const Window& window, const std::vector<Command>& commands)
      : program_(program), window_(window), app_(program.title, program.name) {
    add_common(app_, flags_, program);
    app_.add_option("file", file_, "Scenario to open in the window")->type_name("FILE");
    app_.require_subcommand(0, 1);
    if (window.add_options) window.add_options(app_);
    std::vector<Command> all = {run_command(), render_command(), operations_command()};
    all.insert(all.end(), commands.begin(), commands.end());
    for (const Command& command : all) {
      CLI::App* sub = app_.add_subcommand(command.name, command.help);
      add_common(*sub, flags_, program);
      jobs_.emplace_back(sub, command.setup(*sub));
    }
  }

  int run(int argc, char** argv) {
    words_.assign(argv, argv + argc);
    if (const auto word = misspelt_command(argc, argv)) {
      return usage_error("", fmt::format("there is no sub-command and no file '{}'{}", *word,
                                         base::did_you_mean(*word, command_names())));
    }
    try {
      app_.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
      return printed(app_.help());
    } catch (const CLI::CallForVersion&) {
      return printed(version_text(program_) + '\n');
    } catch (const CLI::ExtrasError& error) {
      return usage_error(command_name(), unexpected(error.what()));
    } catch (const CLI::ParseError& error) {
      return usage_error(command_name(), error.what());
    }
    for (const auto& [sub, job] : jobs_) {
      if (sub->parsed()) return work(job);
    }
    return open_window();
  }

 private:
  /// One line: what is wrong, and where to look; with --json, which may not have been read yet, the finding as well.
  [[nodiscard]] int usage_error(const std::string& command, std::string message) const {
    std::replace(message.begin(), message.end(), '\n', ' ');
    while (!message.empty() && (message.back() == ' ' || message.back() == '.')) message.pop_back();
    const std::string full = command.empty() ? program_.name : program_.name + ' ' + command;
    fmt::print(stderr, "{}: {}; see '{} --help'\n", program_.name, message, full);
    const Error error{ErrorCode::BadUsage, message};
    if (std::find(words_.begin(), words_.end(), "--json") != words_.end()) {
      CommonOptions options;
      options.format = OutputFormat::Json;
      Session session(program_, options, {});
      if (const auto told = tell_refusal(session, error); !told) return exit_code_of(session, told.error());
    }
    return base::exit_code(error.code);
  }

  [[nodiscard]] std::vector<std::string> command_names() const {
    std::vector<std::string> names;
    for (const auto& job : jobs_) names.push_back(job.first->get_name());
    return names;
  }

  [[nodiscard]] std::string command_name() const {
    const auto parsed = app_.get_subcommands();
    return parsed.empty() ? "" : parsed.front()->get_name();
  }

  /// A first word that is neither a sub-command nor looks like a file.
  [[nodiscard]] std::optional<std::string> misspelt_command(int argc, char** argv) const {
    if (argc < 2) return std::nullopt;
    const std::string word = argv[1];
    const auto names = command_names();
    std::error_code ignored;
    if (word.empty() || word.front() == '-' || word.find_first_of("./") != std::string::npos ||
        std::find(names.begin(), names.end(), word) != names.end() || std::filesystem::exists(word, ignored)) {
      return std::nullopt;
    }
    return word;
  }

  /// The flag that stands before a word of the command line, as if the word were its value; empty if none does.
  [[nodiscard]] std::string flag_before(const CLI::App& app, const std::string& word) const {
    const auto at = std::find(words_.begin(), words_.end(), word);
    if (at == words_.end() || at == words_.begin()) return {};
    const CLI::Option* option = app.get_option_no_throw(*(at - 1));
    return option != nullptr && option->get_items_expected_max() == 0 ? *(at - 1) : std::string();
  }

  /// CLI11's "not expected: --ouut x" with a suggestion for the first of them.
  [[nodiscard]] std::string unexpected(const std::string& message) const {
    const std::size_t colon = message.find(": ");
    if (colon == std::string::npos) return message;
    const std::string extras = message.substr(colon + 2);
    std::string word = extras.substr(0, extras.find(' '));
    word = word.substr(0, word.find('='));
    const auto parsed = app_.get_subcommands();
    const CLI::App& app = parsed.empty() ? app_ : *parsed.front();
    if (const std::string flag = flag_before(app, word); !flag.empty())
      return fmt::format("unexpected argument '{}': {} before it takes no value", word, flag);
    return fmt::format("unexpected argument '{}'{}", word, base::did_you_mean(word, option_names(app)));
  }

  static int exit_code_of(Session& session, const Error& error) {
    session.error_line(base::to_string(error));
    return base::exit_code(error.code);
  }

  int printed(const std::string& text) {
    Session session(program_, flags_.options(), {});
    const auto done = print(text);
    return done ? 0 : exit_code_of(session, done.error());
  }

  int work(const Job& job) {
    if (flags_.threads > 0) base::set_thread_count(flags_.threads);
    Session session(program_, flags_.options(), interruption_.token());
    if (const auto go_on = session.check(); !go_on) return exit_code_of(session, go_on.error());
    const base::Result<int> done = job(session);
    return done ? *done : exit_code_of(session, done.error());
  }

  int open_window() {
    if (!window_.open) return usage_error("", "this build has no window; give a sub-command");
    if (flags_.threads > 0) base::set_thread_count(flags_.threads);
    std::optional<std::filesystem::path> file;
    if (!file_.empty()) file = file_;
    std::error_code ignored;
    const bool told = window_.tells_missing_files && window_.tells_missing_files();
    if (file && !told && !std::filesystem::exists(*file, ignored)) {
      Session session(program_, flags_.options(), {});
      base::Place place;
      place.file = file->string();
      return exit_code_of(session, {ErrorCode::FileNotFound, "there is no such file", place});
    }
    Interruption::let_go();
    return window_.open(file);
  }

  const Interruption interruption_;
  const scenario::Program& program_;
  const Window& window_;
  Flags flags_;
  std::string file_;
  std::vector<std::string> words_;  ///< The command line.
  CLI::App app_;
  std::vector<std::pair<CLI::App*, Job>> jobs_;
};

}  // namespace

int run_program(const scenario::Program& program, int argc, char** argv, const Window& window,
                const std::vector<Command>& commands) {
  try {
    return CommandLine(program, window, commands).run(argc, argv);
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "%s: not enough memory; use a coarser model\n", program.name.c_str());
    return 4;
  }
}

}  // namespace dobra::cli
