#pragma once
// What every sub-command has at hand: the program, the common options, messages, progress, and the wish of the user to
// stop.

#include <string>

#include "shared/base/progress.h"
#include "shared/base/result.h"
#include "shared/scenario/program.h"

namespace dobra::cli {

enum class Verbosity { Quiet, Normal, Verbose };
enum class OutputFormat { Text, Json };

/// Options that every sub-command takes.
struct CommonOptions {
  Verbosity verbosity = Verbosity::Normal;
  OutputFormat format = OutputFormat::Text;
  std::size_t threads = 0;  ///< 0: all cores.
};

/// Messages go to standard error, results to standard output.
class Session {
 public:
  Session(const scenario::Program& session_program, CommonOptions session_options, base::CancelToken session_cancel);

  const scenario::Program& program;
  const CommonOptions options;
  const base::CancelToken cancel;

  /// Draws a line that is written over itself on standard error if that is a terminal, and writes lines to keep
  /// (kept_line.h) to it in any case, unless quiet.
  [[nodiscard]] base::Progress progress();
  /// "recon: ..." on one line of standard error, whatever the verbosity.
  void error_line(const std::string& text);
  /// The same, unless quiet.
  void note(const std::string& text);
  /// The same, only if verbose.
  void detail(const std::string& text);
  /// Cancelled once the user asked to stop.
  [[nodiscard]] base::Result<void> check() const;

 private:
  void clear_progress();
  bool progress_shown_ = false;
};

/// Writes results to standard output and flushes it.
/// @error CannotWrite if it is closed or full.
base::Result<void> print(const std::string& text);

/// While it lives, SIGINT and SIGTERM cancel its token; a second one ends the program at once. Where work has not ended
/// five seconds after the first, the program ends with 130. Programs make one first of all, so that a signal finds it
/// from the start; a further one shares its token.
class Interruption {
 public:
  Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;
  ~Interruption();

  [[nodiscard]] const base::CancelToken& token() const { return token_; }
  /// From now on a signal ends the program at once, as where nobody listens: for windows.
  static void let_go();

 private:
  base::CancelToken token_;
  bool first_ = false;
};

}  // namespace dobra::cli
