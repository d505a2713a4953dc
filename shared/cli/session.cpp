#include "shared/cli/session.h"

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdio>

#include "shared/base/kept_line.h"
#include "shared/io/file.h"

namespace dobra::cli {
namespace {

std::atomic<const base::CancelToken*> interrupted_token{nullptr};

constexpr unsigned patience = 5;  ///< Seconds in which work may end by itself.

extern "C" void on_interrupt(int) {
  if (const base::CancelToken* token = interrupted_token.load()) token->cancel();
  alarm(patience);
}
/// Work that did not listen ends with the code and the word of an interruption.
extern "C" void on_alarm(int) {
  constexpr char said[] = "interrupted\n";
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, said, sizeof said - 1);
  _exit(base::exit_code(base::ErrorCode::Cancelled));
}

void set_handler(void (*handler)(int), int flags) {
  struct sigaction action {};
  action.sa_handler = handler;
  sigemptyset(&action.sa_mask);
  action.sa_flags = flags;
  for (const int number : {SIGINT, SIGTERM}) sigaction(number, &action, nullptr);
}

std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

}  // namespace

Session::Session(const scenario::Program& session_program, CommonOptions session_options,
                 base::CancelToken session_cancel)
    : program(session_program), options(session_options), cancel(std::move(session_cancel)) {}

base::Progress Session::progress() {
  if (options.verbosity == Verbosity::Quiet) return base::Progress(cancel, {});
  using Clock = std::chrono::steady_clock;
  const bool terminal = ::isatty(STDERR_FILENO) != 0;
  const auto listen = [this, terminal, last = Clock::time_point{}](double fraction, const std::string& what) mutable {
    if (base::is_kept_line(what)) return error_line(what.substr(0, what.size() - 1));
    if (!terminal) return;
    const auto now = Clock::now();
    if (now - last < std::chrono::milliseconds(50)) return;
    last = now;
    progress_shown_ = true;
    fmt::print(stderr, "\r\033[K{:3.0f}% {:.60}", 100.0 * fraction, one_line(what));
    std::fflush(stderr);
  };
  return base::Progress(cancel, listen);
}

void Session::clear_progress() {
  if (progress_shown_) fmt::print(stderr, "\r\033[K");
  progress_shown_ = false;
}

void Session::error_line(const std::string& text) {
  clear_progress();
  fmt::print(stderr, "{}: {}\n", program.name, one_line(text));
}

void Session::note(const std::string& text) {
  if (options.verbosity != Verbosity::Quiet) error_line(text);
}

void Session::detail(const std::string& text) {
  if (options.verbosity == Verbosity::Verbose) error_line(text);
}

base::Result<void> Session::check() const { return base::Progress(cancel, {}).check(); }

base::Result<void> print(const std::string& text) {
  errno = 0;
  const std::size_t written = std::fwrite(text.data(), 1, text.size(), stdout);
  if (written != text.size() || std::fflush(stdout) != 0) return io::cannot_write("standard output", errno);
  return {};
}

Interruption::Interruption() {
  if (const base::CancelToken* token = interrupted_token.load()) {
    token_ = *token;
    return;
  }
  first_ = true;
  interrupted_token = &token_;
  // Restarting keeps interrupted writes of libraries whole; resetting lets a second Ctrl-C end work that does not
  // listen.
  set_handler(on_interrupt, static_cast<int>(SA_RESTART | SA_RESETHAND));
  signal(SIGALRM, on_alarm);
}

void Interruption::let_go() {
  alarm(0);
  set_handler(SIG_DFL, 0);
}

Interruption::~Interruption() {
  if (!first_) return;
  let_go();
  interrupted_token = nullptr;
}

}  // namespace dobra::cli
