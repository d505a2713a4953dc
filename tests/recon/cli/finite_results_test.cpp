// What the commands write holds numbers only: a run either ends with an error, or no value of it is missing or
// infinite.

#include <cmath>
#include <random>

#include "recon/cli/fault_commands.h"
#include "recon/cli/section_commands.h"
#include "recon/core/operations.h"
#include "shared/io/file.h"
#include "tests/support/command_line.h"
#include "tests/support/numbers.h"

namespace recon::cli {
namespace {

using dobra::test::expect_numbers;
using dobra::test::expect_numbers_in;

class FiniteResults : public dobra::test::CommandLine {
 protected:
  FiniteResults() : CommandLine(core::program(), {restore_command(), balance_command(), faults_command()}) {}
};

TEST_F(FiniteResults, OfEveryExample) {
  const std::filesystem::path examples = std::filesystem::path(DOBRA_SOURCE_DIR) / "resources/examples/recon";
  int count = 0;
  for (const auto& file : std::filesystem::directory_iterator(examples)) {
    if (file.path().extension() != ".toml") continue;
    const std::string folder = "out" + std::to_string(++count);
    const auto run = call({"run", file.path().string(), "--out", path(folder), "--pictures", "none", "--json"});
    EXPECT_EQ(run.code, 0) << run.err;
    expect_numbers(run.out, file.path().string());
    expect_numbers_in(path(folder));
    // Without a top across the whole section, which faults part, it is not restored as one.
    const std::string text = dobra::io::read_text(file.path().string()).value();
    const bool faulted = text.find("operation = \"move\"") != std::string::npos;
    // Of several sections in space the one that is cut is restored.
    const bool in_space = text.find("[[input.section]]") != std::string::npos;
    const std::string section = in_space ? path(folder + "/section.toml") : file.path().string();
    for (const char* command : {faulted ? "faults" : "restore", "balance"}) {
      const auto told = call({command, section, "--json"});
      EXPECT_EQ(told.code, 0) << told.err;
      expect_numbers(told.out, command);
    }
  }
  EXPECT_GT(count, 1);
}

/// Two beds over a wave that may be overturned, whose second may pinch out.
std::string random_section(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const double height = 20.0 + 400.0 * unit(random);
  const double wave = 300.0 + 900.0 * unit(random);
  const double lean = unit(random) < 0.3 ? 120.0 : 0.0;  // overturned
  const double thickness = unit(random) < 0.2 ? 0.0 : 300.0 * unit(random);
  const bool alone = unit(random) < 0.15;
  std::string text = "x,z,name\n";
  for (int i = 0; i <= 60; ++i) {
    const double z = height * std::sin(20.0 * i / wave * 6.28);
    text += std::to_string(20.0 * i + lean * z / height) + ',' + std::to_string(z) + ",top\n";
  }
  for (int i = 0; i <= 60 && !alone; ++i) {
    const double z = height * std::sin(20.0 * i / wave * 6.28) - thickness * i / 60.0 - 0.01;
    text += std::to_string(20.0 * i + lean * z / height) + ',' + std::to_string(z) + ",base\n";
  }
  return text;
}

TEST_F(FiniteResults, OfRandomRunsThatDoNotEndWithAnError) {
  std::mt19937 random(18);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const std::vector<std::string> methods{"constant", "variable", "proportional", "flexural", "shear", "line_length"};
  int done = 0, refused = 0;
  for (int i = 0; i < 60; ++i) {
    const std::string file = put("section.csv", random_section(random));
    std::vector<std::string> words{
        "restore",  file,          "--json", "--geometry", "--uncovered",
        "continue", "--crossings", "allow",  "--method",   methods[static_cast<std::size_t>(i) % 6]};
    if (i % 4 == 0) words.insert(words.end(), {"--outside", "nearest"});
    if (i % 3 == 0) words.insert(words.end(), {"--pin", std::to_string(1200.0 * unit(random))});
    if (i % 5 == 0) words.insert(words.end(), {"--percent", std::to_string(100.0 * unit(random))});
    if (i % 7 == 0) words.insert(words.end(), {"--draws", "3", "--pick-error", "20"});
    if (words[9] == "shear") words.insert(words.end(), {"--angle", std::to_string(178.0 * unit(random) - 89.0)});
    const auto made = call(words);
    const auto judged = call({"balance", file, "--json", "--crossings", "allow"});
    if (judged.code == 0) expect_numbers(judged.out, file);
    if (made.code != 0) {
      ++refused;
      EXPECT_TRUE(made.code == 3 || made.code == 4) << made.err;
      EXPECT_EQ(made.out, "");
      continue;
    }
    ++done;
    expect_numbers(made.out, methods[static_cast<std::size_t>(i) % 6] + " run " + std::to_string(i));
    expect_numbers(made.err, "remarks");
    if (i % 6 != 1) continue;
    words.insert(words.end(), {"--out", path("again.toml")});
    const std::string folder = "out" + std::to_string(i);
    ASSERT_EQ(call(words).code, 0);
    ASSERT_EQ(call({"run", path("again.toml"), "--out", path(folder), "--pictures", "none"}).code, 0);
    expect_numbers_in(path(folder));
  }
  EXPECT_GT(done, 15);
  EXPECT_GT(refused, 5);
}

}  // namespace
}  // namespace recon::cli
