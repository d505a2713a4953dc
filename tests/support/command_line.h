#pragma once
// A fixture that calls a program's command line in this process, with a folder of its own for files.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "shared/cli/cli.h"
#include "shared/io/file.h"

namespace dobra::test {

struct Outcome {
  int code = 0;
  std::string out;
  std::string err;
};

class CommandLine : public testing::Test {
 protected:
  /// The first words come before those of each call.
  CommandLine(const scenario::Program& program, std::vector<cli::Command> commands,
              std::vector<std::string> first_words = {})
      : program_(program), commands_(std::move(commands)), first_words_(std::move(first_words)) {
    std::string pattern = (std::filesystem::temp_directory_path() / "dobra_command_XXXXXX").string();
    root_ = mkdtemp(pattern.data());
  }
  ~CommandLine() override { std::filesystem::remove_all(root_); }

  [[nodiscard]] std::string path(const std::string& name) const { return (root_ / name).string(); }
  /// Writes a file and returns its path.
  [[nodiscard]] std::string put(const std::string& name, const std::string& text) const {
    std::ofstream(root_ / name, std::ios::binary) << text;
    return path(name);
  }
  [[nodiscard]] std::string text(const std::string& name) const { return io::read_text(path(name)).value(); }

  [[nodiscard]] Outcome call(std::vector<std::string> args) const {
    args.insert(args.begin(), first_words_.begin(), first_words_.end());
    args.insert(args.begin(), program_.name);
    std::vector<char*> argv;
    for (std::string& arg : args) argv.push_back(arg.data());
    argv.push_back(nullptr);
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    Outcome outcome;
    outcome.code = cli::run_program(program_, static_cast<int>(args.size()), argv.data(), {}, commands_);
    outcome.out = testing::internal::GetCapturedStdout();
    outcome.err = testing::internal::GetCapturedStderr();
    return outcome;
  }

  /// Lines but those that come before a refusal: which steps were added, and cycles as they end.
  static int refusals_in(const std::string& text) {
    std::istringstream lines(text);
    int count = 0;
    for (std::string line; std::getline(lines, line);)
      count += !line.starts_with("quebra: of the steps of ") && !line.starts_with("quebra: cycle ") ? 1 : 0;
    return count;
  }

  /// A refusal: one line that holds all of `wanted`, nothing on standard output, nothing written.
  void refuses(const std::vector<std::string>& args, int code, const std::vector<std::string>& wanted) const {
    const auto count = [&] {
      return std::distance(std::filesystem::directory_iterator(root_), std::filesystem::directory_iterator());
    };
    const auto before = count();
    const Outcome outcome = call(args);
    EXPECT_EQ(outcome.code, code) << outcome.err;
    for (const std::string& part : wanted) {
      EXPECT_NE(outcome.err.find(part), std::string::npos) << part << "\n" << outcome.err;
    }
    EXPECT_EQ(refusals_in(outcome.err), 1) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(count(), before);
  }

 private:
  const scenario::Program& program_;
  std::vector<cli::Command> commands_;
  std::vector<std::string> first_words_;
  std::filesystem::path root_;
};

}  // namespace dobra::test
