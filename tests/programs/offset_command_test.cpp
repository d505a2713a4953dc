// `offset` of the real programs: both give the same bytes, and bad input ends with the exit codes of
// docs/conventions.md.

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace {

namespace fs = std::filesystem;

struct Outcome {
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
  [[nodiscard]] Outcome call(const std::string& arguments) const {
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
    const Outcome done = call(program + " offset " + good + " --distance 1 --json");
    EXPECT_EQ(done.code, 0) << done.said;
    EXPECT_EQ(done.said, "");
    EXPECT_EQ(done.out,
              "{\"curves\":[{\"distance\":1.0,\"length\":10.0,\"area\":null,\"dropped\":0,\"dropped_length\":0.0,\"pieces\":"
              "[{\"closed\":false,\"points\":[[0.0,-1.0],[10.0,-1.0]]}]}],\"dropped\":0}\n");
    const Outcome refused = call(program + " offset " + bad + " --distance 1");
    EXPECT_EQ(refused.code, 3);
    EXPECT_NE(refused.said.find("bad.csv:2"), std::string::npos) << refused.said;
    EXPECT_EQ(std::count(refused.said.begin(), refused.said.end(), '\n'), 1) << refused.said;
    EXPECT_EQ(call(program + " offset " + good + " --distance 0").code, 2);
    EXPECT_EQ(call(program + " offset " + good + " --distance 1 --distances 1,2").code, 2);
    EXPECT_EQ(call(program + " offset " + good + " --distance 1 --out /nowhere/at/all.svg").code, 4);
  }
}

}  // namespace
