// What the commands write holds numbers only (tests/recon/cli/finite_results_test.cpp has the same of RECON).

#include "quebra/core/operations.h"
#include "tests/support/command_line.h"
#include "tests/support/numbers.h"

namespace quebra::cli {
namespace {

class FiniteResults : public dobra::test::CommandLine {
 protected:
  FiniteResults() : CommandLine(core::program(), {}) {}
};

TEST_F(FiniteResults, OfEveryExample) {
  int count = 0;
  const std::filesystem::path examples = std::filesystem::path(DOBRA_SOURCE_DIR) / "resources/examples";
  std::vector<std::filesystem::directory_entry> files;
  for (const char* const folder : {"quebra", "solids"}) {
    for (const auto& file : std::filesystem::directory_iterator(examples / folder)) files.push_back(file);
  }
  for (const auto& file : files) {
    if (file.path().extension() != ".toml") continue;
    const std::string folder = path("out" + std::to_string(++count));
    const auto run = call({"run", file.path().string(), "--out", folder, "--pictures", "none", "--json"});
    EXPECT_EQ(run.code, 0) << run.err;
    dobra::test::expect_numbers(run.out, file.path().string());
    dobra::test::expect_numbers_in(folder);
  }
  EXPECT_GT(count, 1);
}

}  // namespace
}  // namespace quebra::cli
