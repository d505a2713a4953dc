// `offset` of the real programs: both give the same bytes, and bad input ends with the exit codes of
// docs/conventions.md.

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <thread>

namespace {

namespace fs = std::filesystem;

struct OffsetOutcome {
  int code = -1;
  std::string out;
  std::string said;  ///< Standard error.
};

class OffsetPrograms : public testing::Test {
 protected:
  OffsetPrograms() {
    std::string name = (fs::temp_directory_path() / "dobra_offset_programs_XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~OffsetPrograms() override { fs::remove_all(folder_); }

  [[nodiscard]] std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return (folder_ / name).string();
  }
  [[nodiscard]] OffsetOutcome call(const std::string& arguments) const {
    const std::string command = "env -u DISPLAY " DOBRA_BIN_DIR "/" + arguments + " > " + (folder_ / "out").string() +
                                " 2> " + (folder_ / "said").string();
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read(folder_ / "out"), read(folder_ / "said")};
  }

 private:
  [[nodiscard]] static std::string read(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  fs::path folder_;
};

TEST_F(OffsetPrograms, OFF_a_BothProgramsPrintTheSegmentBelowAndRefuseBadInput) {
  const std::string good = write("segment.csv", "0,0\n10,0\n");
  const std::string bad = write("bad.csv", "0,0\n10,ten\n");
  for (const std::string program : {"recon", "quebra"}) {
    const OffsetOutcome done = call(program + " offset " + good + " --distance 1 --json");
    EXPECT_EQ(done.code, 0) << done.said;
    EXPECT_EQ(done.said, "");
    EXPECT_EQ(done.out,
              "{\"curves\":[{\"distance\":1.0,\"length\":10.0,\"dropped\":0,\"dropped_length\":0.0,\"pieces\":"
              "[{\"closed\":false,\"points\":[[0.0,-1.0],[10.0,-1.0]]}]}],\"dropped\":0}\n");
    const OffsetOutcome refused = call(program + " offset " + bad + " --distance 1");
    EXPECT_EQ(refused.code, 3);
    EXPECT_NE(refused.said.find("bad.csv:2"), std::string::npos) << refused.said;
    EXPECT_EQ(std::count(refused.said.begin(), refused.said.end(), '\n'), 1) << refused.said;
    EXPECT_EQ(call(program + " offset " + good + " --distance 0").code, 2);
    EXPECT_EQ(call(program + " offset " + good + " --distance 1 --distances 1,2").code, 2);
    EXPECT_EQ(call(program + " offset " + good + " --distance 1 --out /nowhere/at/all.svg").code, 4);
  }
}

/// The coordinates of a file of GeoJSON, as they stand there.
std::string coordinates_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  std::string found;
  for (std::size_t at = text.find("\"coordinates\""); at != std::string::npos;
       at = text.find("\"coordinates\"", at + 1))
    found += text.substr(at, text.find('}', at) - at);
  return found;
}

TEST_F(OffsetPrograms, AStepOfAScenarioGivesTheCurvesOfTheCommandInBothPrograms) {
  const std::string base = write("base.csv", "0,0\n4,0\n4,-3\n5,-3\n5,0\n9,0\n");
  const std::string step =
      "[[step]]\noperation = \"offset\"\nfile = \"base.csv\"\ndistances = [0.75, 1.0]\n"
      "side = \"left\"\njoin = \"round\"\n";
  const std::string head = "dobra = 1\nprogram = ";
  const std::string recon = write("r.toml", head +
                                                "\"recon\"\n[[input.horizon]]\nname = \"top\"\n"
                                                "points = [[0, 0], [9, 0]]\n" +
                                                step);
  const std::string quebra = write("q.toml", head + "\"quebra\"\n[input]\nspecimen = \"plate_with_hole\"\n" + step);
  const fs::path folder = fs::path(base).parent_path();
  for (const std::string& program : {std::string("recon"), std::string("quebra")}) {
    const std::string scenario = program == "recon" ? recon : quebra;
    const std::string curves = (folder / "curves.geojson").string();
    EXPECT_EQ(call(program + " offset " + base + " --distances 0.75,1 --side left --join round --out " + curves).code,
              0);
    const std::string out = (folder / "results").string();
    const OffsetOutcome ran = call(program + " run " + scenario + " --out " + out + " --pictures svg");
    ASSERT_EQ(ran.code, 0) << ran.said;
    EXPECT_EQ(coordinates_of(fs::path(out) / "offset_1.geojson"), coordinates_of(curves));
    EXPECT_NE(coordinates_of(curves), "");
    const OffsetOutcome drawn =
        call(program + " render " + scenario + " --set steps.1.stop_after=3 --out " + out + "/work.svg");
    EXPECT_EQ(drawn.code, 0) << drawn.said;
    EXPECT_NE(drawn.said.find("stands after 3 steps"), std::string::npos) << drawn.said;
    EXPECT_EQ(call(program + " run " + scenario + " --set steps.1.distances=0 --out " + out + "2").code, 3);
  }
}

/// A closed walk that crosses itself everywhere.
std::string tangle(std::size_t count) {
  std::mt19937 random(3);
  const auto step = [&] { return static_cast<double>(random()) / 2147483648.0 - 1.0; };
  std::string text;
  double x = 0.0;
  double y = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    x += step();
    y += step();
    text += std::to_string(x) + ',' + std::to_string(y) + '\n';
  }
  return text;
}

/// A closed contour round a centre that goes forth and back, and crosses itself thousands of times.
std::string rough_star(std::size_t count) {
  std::mt19937 random(2);
  const auto real = [&] { return static_cast<double>(random()) / 2147483648.0 - 1.0; };
  std::string text;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 6.283185307 * (static_cast<double>(i) + 6.0 * real()) / static_cast<double>(count);
    const double radius = 500.0 * (1.0 + 0.3 * real());
    text += std::to_string(radius * std::cos(angle)) + ',' + std::to_string(radius * std::sin(angle)) + '\n';
  }
  return text;
}

/// Of the programs that have ended, s: what others do on the machine does not count.
double processor_time_of_children() {
  rusage used{};
  getrusage(RUSAGE_CHILDREN, &used);
  return static_cast<double>(used.ru_utime.tv_sec) + 1e-6 * static_cast<double>(used.ru_utime.tv_usec);
}

TEST_F(OffsetPrograms, TheTimeOfAContourThatCrossesItselfThousandsOfTimesGrowsWithItsCrossings) {
  const double before = processor_time_of_children();
  const OffsetOutcome done =
      call("recon offset " + write("star.csv", rough_star(8192)) + " --closed --distance 1 --join bisector --quiet");
  EXPECT_EQ(done.code, 0) << done.said;
  // Some 2 s without sanitizers, and minutes where vertices draw pieces from ever farther.
  EXPECT_LT(processor_time_of_children() - before, 30.0);
}

TEST_F(OffsetPrograms, ASignalEndsEveryPhaseOfALongRunSoonWith130AndLeavesNoFile) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  constexpr double allowed = 10.0;  // s; the machine may be busy
#else
  constexpr double allowed = 2.0;
#endif
  const std::string file = write("tangle.csv", tangle(30000));
  std::size_t interrupted = 0;
  // Reading, mending, offsetting with verification, and joining come one after the other.
  for (const std::string program : {"recon", "quebra"}) {
    for (const int wait : {400, 1000, 2500}) {
      const std::string path = DOBRA_BIN_DIR "/" + program;
      const std::string out = file + ".geojson";
      const pid_t child = fork();
      if (child == 0) {
        unsetenv("DISPLAY");
        execl(path.c_str(), program.c_str(), "offset", file.c_str(), "--closed", "--distance", "1", "--join", "round",
              "--verify", "--dissolve", "--quiet", "--out", out.c_str(), nullptr);
        _exit(99);
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(wait));
      const auto asked = std::chrono::steady_clock::now();
      kill(child, SIGTERM);
      int status = 0;
      ASSERT_EQ(waitpid(child, &status, 0), child);
      const std::chrono::duration<double> after = std::chrono::steady_clock::now() - asked;
      EXPECT_FALSE(fs::exists(out) && WEXITSTATUS(status) != 0);
      if (WIFSIGNALED(status)) continue;    // on a busy machine it did not listen yet
      if (WEXITSTATUS(status) == 0) break;  // it was done before
      EXPECT_EQ(WEXITSTATUS(status), 130) << program << " " << wait;
      EXPECT_LT(after.count(), allowed) << program << " after " << wait << " ms";
      ++interrupted;
    }
  }
  EXPECT_GE(interrupted, 2U);
}

}  // namespace
