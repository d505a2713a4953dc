#pragma once
// The options of a program's window, beside FILE.

#include <string>

namespace CLI {
class App;
}

namespace dobra::cli {

struct WindowOptions {
  std::string script, language;
};
/// @pre `options` stays where it is while the app is in use.
void add_window_options(CLI::App& app, WindowOptions& options);

}  // namespace dobra::cli
