// quebra over MPI against quebra by itself.

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

namespace {

namespace fs = std::filesystem;

/// OpenMPI keeps memory to the end, and refuses to start as root or with more processes than cores unless told.
const std::string two =
    "ASAN_OPTIONS=detect_leaks=0 OMPI_MCA_btl_vader_single_copy_mechanism=none mpirun --allow-run-as-root "
    "--oversubscribe -n 2 ";

struct Outcome {
  int code = -1;
  std::string out;
};

Outcome call(const std::string& command) {
  const fs::path file = fs::temp_directory_path() / ("dobra_mpi_" + std::to_string(getpid()));
  const int status = std::system((command + " > '" + file.string() + "' 2> '" + file.string() + ".err'").c_str());
  std::ifstream in(file), err(file.string() + ".err");
  Outcome outcome{WIFEXITED(status) ? WEXITSTATUS(status) : -1, {std::istreambuf_iterator<char>(in), {}}};
  if (outcome.code != 0) outcome.out += std::string(std::istreambuf_iterator<char>(err), {});
  fs::remove(file);
  fs::remove(file.string() + ".err");
  return outcome;
}

TEST(Mpi, TwoProcessesFindWhatOneFinds) {
  const std::string arguments = " crack " DOBRA_SOURCE_DIR "/resources/examples/quebra/edge_crack.toml --json --quiet";
  const Outcome alone = call(DOBRA_BIN_DIR "/quebra" + arguments);
  const Outcome together = call(two + DOBRA_BIN_DIR "/mpi/quebra" + arguments);
  ASSERT_EQ(alone.code, 0) << alone.out;
  ASSERT_EQ(together.code, 0) << together.out;
  const auto one = nlohmann::json::parse(alone.out).at("quantities");
  const auto both = nlohmann::json::parse(together.out).at("quantities");
  ASSERT_EQ(one.size(), both.size());
  ASSERT_GT(one.size(), 20U);
  for (const auto& [name, quantity] : one.items()) {
    const double a = quantity.at("value"), b = both.at(name).at("value");
    EXPECT_NEAR(a, b, 1e-9 * std::max(1.0, std::abs(a))) << name;
  }
}

TEST(Mpi, ManyFactorisationsAndErrorsEndTheGroup) {
  // An adaptive loop factorises once a cycle; a scenario without supports fails in the first process only.
  const Outcome loop =
      call(two + DOBRA_BIN_DIR "/mpi/quebra adapt " DOBRA_SOURCE_DIR
                               "/resources/examples/quebra/edge_crack.toml --target 3% --max-cycles 8 --json --quiet");
  EXPECT_EQ(loop.code, 0) << loop.out;
  const Outcome missing = call(two + DOBRA_BIN_DIR "/mpi/quebra solve none.toml");
  EXPECT_EQ(missing.code, 3) << missing.out;
}

TEST(Mpi, TheProgramWithoutMpiRefusesToBeStartedSeveralTimes) {
  const Outcome twice = call("OMPI_COMM_WORLD_SIZE=2 " DOBRA_BIN_DIR "/quebra solve none.toml");
  EXPECT_EQ(twice.code, 2);
  EXPECT_NE(twice.out.find("built without MPI"), std::string::npos) << twice.out;
}

}  // namespace
