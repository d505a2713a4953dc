// Options come from descriptions of parameters (shared/cli/parameter_options.h). What is left by hand are files, and
// what every command has.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace {

namespace fs = std::filesystem;

/// How often a line of a file makes an option of the command line.
std::size_t options_in(const fs::path& file) {
  std::size_t count = 0;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    for (const std::string call : {"add_option(", "add_flag("}) {
      const std::size_t at = line.find(call);
      if (at != std::string::npos && at > 0 && (line[at - 1] == '.' || line[at - 1] == '>')) ++count;
    }
  }
  return count;
}

TEST(HandWrittenOptions, AreFew) {
  constexpr std::size_t reached = 42;
  const fs::path root = DOBRA_SOURCE_DIR;
  std::size_t count = 0;
  std::string where;
  for (const char* top : {"shared", "recon", "quebra"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
      if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
      if (entry.path().stem() == "parameter_options") continue;
      const std::size_t here = options_in(entry.path());
      count += here;
      if (here > 0) where += entry.path().filename().string() + ": " + std::to_string(here) + "\n";
    }
  }
  EXPECT_LE(count, reached) << "describe the parameter instead (shared/cli/parameter_options.h)\n" << where;
  EXPECT_GT(count, 10U) << "the count finds no options any more";
}

}  // namespace
