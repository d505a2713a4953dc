// What bad input gets: each fault is given to the real programs, which must answer with the exit code of
// docs/conventions.md and one line that names the place, and leave nothing behind.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

namespace {

namespace fs = std::filesystem;

struct Outcome {
  int code = -1;
  std::string said;  ///< Standard error.
};

class Programs : public testing::Test {
 protected:
  Programs() {
    std::string name = (fs::temp_directory_path() / "dobra_programs_XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~Programs() override { fs::remove_all(folder_); }

  [[nodiscard]] fs::path path(const std::string& name) const { return folder_ / name; }
  fs::path write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }
  [[nodiscard]] static std::string read(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  [[nodiscard]] Outcome call(const std::string& arguments) const {
    const std::string command =
        "env -u DISPLAY " DOBRA_BIN_DIR "/" + arguments + " > /dev/null 2> " + path("said").string();
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read(path("said"))};
  }
  /// Runs a scenario text and expects one line that holds all of `wanted`, and no result.
  void refuses(const std::string& program, const std::string& text, int code,
               const std::vector<std::string>& wanted) const {
    says(program, text, code, wanted);
    EXPECT_TRUE(!fs::exists(path("out")) || fs::is_empty(path("out")));
  }
  void says(const std::string& program, const std::string& text, int code,
            const std::vector<std::string>& wanted) const {
    const auto file = write("scenario.toml", text);
    const Outcome outcome = call(program + " run " + file.string() + " --quiet --out " + path("out").string());
    EXPECT_EQ(outcome.code, code) << outcome.said;
    EXPECT_EQ(std::count(outcome.said.begin(), outcome.said.end(), '\n'), 1) << outcome.said;
    for (const std::string& part : wanted)
      EXPECT_NE(outcome.said.find(part), std::string::npos) << part << "\n" << outcome.said;
  }
  void recon_refuses(const std::string& horizon, const std::string& steps, int code,
                     const std::vector<std::string>& wanted) const {
    refuses("recon", "dobra = 1\nprogram = \"recon\"\n[[input.horizon]]\nname = \"top\"\n" + horizon + "\n" + steps,
            code, wanted);
  }
  static std::string plate_with(const std::string& more) {
    return "dobra = 1\nprogram = \"quebra\"\n[[input.curve]]\nname = \"plate\"\nkind = \"polygon\"\n"
           "points = [[0, 0], [4, 0], [4, 4], [0, 4]]\n" +
           more;
  }
  void quebra_refuses(const std::string& more, int code, const std::vector<std::string>& wanted) const {
    refuses("quebra", plate_with(more), code, wanted);
  }

 private:
  fs::path folder_;
};

const std::string good_points = "points = [[0.0, 0.0], [10.0, 1.0], [20.0, 0.0]]\n";

TEST_F(Programs, GUI_c_AMissingFileIsNamed) {
  const Outcome outcome = call("recon run " + path("none.toml").string() + " --out " + path("out").string());
  EXPECT_EQ(outcome.code, 3);
  EXPECT_NE(outcome.said.find("none.toml"), std::string::npos) << outcome.said;
}

TEST_F(Programs, AMissingHorizonFileIsNamed) { recon_refuses("file = \"none.csv\"", "", 3, {"none.csv"}); }

TEST_F(Programs, ADirectoryIsNoFile) {
  fs::create_directory(path("folder.csv"));
  recon_refuses("file = \"folder.csv\"", "", 3, {"folder.csv", "folder"});
  EXPECT_EQ(call("quebra run " + path("folder.csv").string() + " --out " + path("out").string()).code, 3);
}

TEST_F(Programs, AnEmptyFileIsNamed) {
  write("empty.csv", "");
  recon_refuses("file = \"empty.csv\"", "", 3, {"empty.csv", "empty"});
  EXPECT_EQ(call("quebra run " + write("empty.toml", "").string() + " --out " + path("out").string()).code, 3);
}

TEST_F(Programs, ABinaryFileIsRefused) {
  write("binary.csv", std::string("\x7f"
                                  "ELF\0\1\2\3\xff\xfe",
                                  10));
  recon_refuses("file = \"binary.csv\"", "", 3, {"binary.csv"});
}

TEST_F(Programs, NonNumericTextIsShownWithItsLine) {
  write("text.csv", "0 0\n1 one\n2 0\n");
  recon_refuses("file = \"text.csv\"", "", 3, {"text.csv:2", "one"});
}

TEST_F(Programs, NotANumberAndInfinityAreRefused) {
  write("nan.csv", "0 0\n1 nan\n2 0\n");
  recon_refuses("file = \"nan.csv\"", "", 3, {"nan.csv:2"});
  recon_refuses("points = [[0.0, 0.0], [inf, 1.0]]", "", 3, {"scenario.toml:5"});
  quebra_refuses("[[step]]\noperation = \"mesh\"\nsize = nan\n", 3, {"scenario.toml:9", "size"});
}

TEST_F(Programs, FewerThanTwoDistinctPointsAreRefused) {
  write("one.csv", "3 4\n3 4\n3 4\n");
  recon_refuses("file = \"one.csv\"", "", 3, {"one.csv"});
  recon_refuses("points = [[1.0, 1.0]]", "", 3, {"top"});
}

TEST_F(Programs, RepeatedPointsAreDroppedWithARemark) {
  write("repeated.csv", "0 0\n0 0\n10 1\n10 1\n20 0\n");
  const auto file = write(
      "scenario.toml", "dobra = 1\nprogram = \"recon\"\n[[input.horizon]]\nname = \"top\"\nfile = \"repeated.csv\"\n");
  const Outcome outcome = call("recon run " + file.string() + " --out " + path("out").string());
  EXPECT_EQ(outcome.code, 0) << outcome.said;
  EXPECT_NE(read(path("out/report.json")).find("repeated"), std::string::npos);
}

TEST_F(Programs, ASelfCrossingHorizonIsRefusedWithThePlace) {
  recon_refuses("points = [[0.0, 0.0], [10.0, 10.0], [10.0, 0.0], [0.0, 10.0]]", "", 3, {"top", "5"});
}

TEST_F(Programs, ASelfCrossingBoundaryIsRefusedWithThePlace) {
  refuses("quebra",
          "dobra = 1\nprogram = \"quebra\"\n[[input.curve]]\nname = \"bow\"\nkind = \"polygon\"\npoints = [[0, 0], [2, "
          "2], [2, 0], [0, 2]]\n",
          3, {"scenario.toml:3", "bow", "1, 1"});
}

TEST_F(Programs, AHoleOutsideIsNamed) {
  quebra_refuses("[[input.curve]]\nname = \"hole\"\nkind = \"circle\"\ncentre = [9, 2]\nradius = 1\nrole = \"hole\"\n",
                 3, {"scenario.toml:7", "hole", "outside"});
}

TEST_F(Programs, PM_a_AMeshWithAFaultExitsWithOne) {
  const std::string tetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\n";
  const auto good = write("good.obj", tetrahedron + "f 3 1 4\n"),
             turned = write("turned.obj", tetrahedron + "f 1 3 4\n"), open = write("open.obj", tetrahedron);
  EXPECT_EQ(call("quebra check --closed " + good.string()).code, 0);
  EXPECT_EQ(call("quebra check " + turned.string()).code, 1);
  EXPECT_EQ(call("quebra check " + open.string()).code, 0);
  EXPECT_EQ(call("quebra check --closed " + open.string()).code, 1);
  EXPECT_EQ(call("quebra check " + write("bad.obj", "v 0 0\n").string()).code, 3);
}

TEST_F(Programs, NoCurvesIsRefused) {
  recon_refuses(good_points, "[[step]]\noperation = \"grid\"\ntop = \"top\"\ncount = 0\n", 3,
                {"scenario.toml:10", "count"});
  quebra_refuses("[[step]]\noperation = \"constraints\"\ncurves = [\"plate\"]\ncount = 0\n", 3,
                 {"scenario.toml:10", "count"});
}

TEST_F(Programs, ADistanceThatIsNotPositiveIsRefused) {
  recon_refuses(good_points, "[[step]]\noperation = \"grid\"\ntop = \"top\"\ndistance = 0.0\n", 3,
                {"scenario.toml:10", "distance"});
  quebra_refuses("[[step]]\noperation = \"constraints\"\ncurves = [\"plate\"]\ndistance = -1\n", 3, {"distance"});
}

TEST_F(Programs, AFactorThatIsNotPositiveIsRefused) {
  recon_refuses(good_points, "[[step]]\noperation = \"grid\"\ntop = \"top\"\nfactor = -0.5\n", 3, {"factor"});
  quebra_refuses("[[step]]\noperation = \"constraints\"\ncurves = [\"plate\"]\nfactor = 0\n", 3, {"factor"});
}

TEST_F(Programs, AnUnknownKeyGetsASuggestion) {
  recon_refuses(good_points, "[[step]]\noperation = \"grid\"\ntop = \"top\"\ndistanse = 1.0\n", 3,
                {"scenario.toml:10", "distanse", "did you mean 'distance'"});
}

TEST_F(Programs, AnUnknownOperationGetsASuggestion) {
  quebra_refuses("[[step]]\noperation = \"mash\"\n", 3, {"scenario.toml:7", "mash", "did you mean 'mesh'"});
}

TEST_F(Programs, AnUnknownCurveGetsASuggestion) {
  quebra_refuses("[[step]]\noperation = \"constraints\"\ncurves = [\"plaet\"]\n", 3, {"plaet", "did you mean 'plate'"});
}

// The analysis: each fault with its line or its place. The plate's text has six lines.
const std::string problem = "[[step]]\noperation = \"problem\"\n";
const std::string steel = "[[step.material]]\nyoung = 1.0\n";
const std::string solve =
    "[[step]]\noperation = \"mesh\"\nsize = 1.0\norder = \"2\"\n[[step]]\noperation = \"analyse\"\n";

TEST_F(Programs, APlateWithoutSupportsIsNamedWithHowItCanMove) {
  says("quebra", plate_with(problem + steel + "[[step.load]]\nwhere = \"plate\"\nx = 1.0\n" + solve), 3,
       {"supports", "is not held", "along x, along y and turn", "support it"});
  // The mesh of the steps before is there, and the report says that the run did not come to its end.
  EXPECT_TRUE(fs::exists(path("out") / "mesh.vtu"));
  EXPECT_NE(read(path("out") / "report.json").find("\"error\""), std::string::npos);
}

TEST_F(Programs, AMissingMaterialIsNamedWithItsRegionAndPlace) {
  quebra_refuses(
      "[[input.curve]]\nname = \"seam\"\nrole = \"internal\"\npoints = [[0, 2], [4, 2]]\n[[input.region]]\nname = "
      "\"soft\"\npoint = [2, 1]\n[[input.region]]\nname = \"hard\"\npoint = [2, 3]\n" +
          problem + "[[step.material]]\nregion = \"hard\"\nyoung = 1.0\n" + solve,
      3, {"scenario.toml", "region 'soft' has no material", "(at "});
}

TEST_F(Programs, ANegativeThicknessIsNamedWithItsLine) {
  quebra_refuses(problem + "[[step.material]]\nyoung = 1.0\nthickness = -0.1\n" + solve, 3,
                 {"scenario.toml:11", "thickness", "-0.1"});
}

TEST_F(Programs, APoissonRatioOfAHalfOrMoreIsNamedWithItsLine) {
  quebra_refuses(problem + "[[step.material]]\nyoung = 1.0\npoisson = 0.6\n" + solve, 3,
                 {"scenario.toml:11", "poisson", "0.6"});
  quebra_refuses(problem + "state = \"strain\"\n[[step.material]]\nyoung = 1.0\npoisson = 0.5\n" + solve, 3,
                 {"scenario.toml:10", "material 1", "0.5"});
}

TEST_F(Programs, ALoadOnAMissingCurveGetsASuggestionAndItsLine) {
  quebra_refuses(problem + steel + "[[step.load]]\nwhere = \"plaet\"\nx = 1.0\n" + solve, 3,
                 {"scenario.toml:11", "load 1", "'plaet'", "did you mean 'plate'"});
}

TEST_F(Programs, ACrackOutsideIsNamedWithItsPlace) {
  quebra_refuses("[[input.crack]]\nname = \"flaw\"\npoints = [[5, 5], [6, 6]]\n[[step]]\noperation = \"mesh\"\n", 3,
                 {"flaw", "outside", "5"});
}

TEST_F(Programs, TipsCloserThanTheirRosettesAreNamedWithTheirPlace) {
  quebra_refuses(
      "[[input.crack]]\nname = \"one\"\npoints = [[0.5, 2], [1.9, 2]]\n[[input.crack]]\nname = \"two\"\npoints = "
      "[[2.0, 2], [3.5, 2]]\n"
      "[[step]]\noperation = \"mesh\"\norder = \"2\"\nrosettes = \"yes\"\ntip_radius = 0.03\n",
      3,
      {"crack tip 'two_start'", "overlaps that of 'one_end'", "the tips are 0.1 m apart", "up to 0.0166 m",
       "(at 2, 2)"});
}

TEST_F(Programs, SolveWritesLinesAndPicturesAndRefusesHalfAnOrder) {
  const std::string example = "quebra solve " DOBRA_SOURCE_DIR "/resources/examples/quebra/edge_crack.toml --quiet";
  EXPECT_EQ(call(example + " --line 0,0.5,1,0.5 --samples 11 --out " + path("line.csv").string() + " --picture " +
                 path("s.svg").string() + " --field s_yy")
                .code,
            0);
  const std::string line = read(path("line.csv"));
  EXPECT_EQ(std::count(line.begin(), line.end(), '\n'), 12);
  EXPECT_EQ(line.rfind("case,s [m],x [m],y [m],u_x [m],", 0), 0U) << line;
  EXPECT_NE(read(path("s.svg")).find("<svg"), std::string::npos);
  for (const char* const wrong :
       {" --line 0,0,1", " --out x.csv", " --field s_xx", " --samples 3", " --probe 1", " --picture x.abc"})
    EXPECT_EQ(call(example + wrong).code, 2) << wrong;
  EXPECT_EQ(call(example + " --probe 9,9").code, 3);
}

TEST_F(Programs, WrongUsageEndsWithTwo) {
  EXPECT_EQ(call("recon run").code, 2);
  EXPECT_EQ(call("quebra run a.toml --no-such-option").code, 2);
}

TEST_F(Programs, AFullDiskIsNamedAndNothingIsLeft) {
  const auto file =
      write("scenario.toml", "dobra = 1\nprogram = \"recon\"\n[[input.horizon]]\nname = \"top\"\n" + good_points);
  const Outcome outcome = call("recon render " + file.string() + " --out /dev/full");
  EXPECT_EQ(outcome.code == 2 || outcome.code == 4, true) << outcome.said;
  fs::create_symlink("/dev/full", path("picture.svg"));
  const Outcome full = call("recon render " + file.string() + " --out " + path("picture.svg").string());
  EXPECT_EQ(full.code, 4) << full.said;
  EXPECT_NE(full.said.find("picture.svg"), std::string::npos) << full.said;
}

TEST_F(Programs, AnOutputFolderThatCannotBeMadeIsNamed) {
  write("file", "x");
  const auto file =
      write("scenario.toml", "dobra = 1\nprogram = \"recon\"\n[[input.horizon]]\nname = \"top\"\n" + good_points);
  const Outcome outcome = call("recon run " + file.string() + " --out " + path("file/out").string());
  EXPECT_EQ(outcome.code, 4) << outcome.said;
}

TEST_F(Programs, AnInterruptedRunEndsWith130AndLeavesNothing) {
  const auto file = write("scenario.toml",
                          "dobra = 1\nprogram = \"quebra\"\n[[input.curve]]\nname = \"plate\"\nkind = \"polygon\"\n"
                          "points = [[0, 0], [4, 0], [4, 4], [0, 4]]\n[[step]]\noperation = \"mesh\"\nsize = 0.003\n");
  const std::string program = DOBRA_BIN_DIR "/quebra";
  const std::string out = path("out").string();
  const pid_t child = fork();
  if (child == 0) {
    unsetenv("DISPLAY");
    execl(program.c_str(), "quebra", "run", file.c_str(), "--quiet", "--out", out.c_str(), nullptr);
    _exit(99);
  }
  std::this_thread::sleep_for(std::chrono::seconds(2));
  kill(child, SIGINT);
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 130);
  EXPECT_TRUE(!fs::exists(out) || fs::is_empty(out));
}

TEST_F(Programs, ASignalBeforeTheWorkBeginsEndsWith130Too) {
  // The scenario is a pipe: the program waits in opening it, long before its first step.
  for (const std::string name : {"quebra", "recon"}) {
    const fs::path file = path(name + ".toml");
    ASSERT_EQ(mkfifo(file.c_str(), 0600), 0);
    const std::string program = DOBRA_BIN_DIR "/" + name;
    const std::string out = path("out " + name).string();
    const pid_t child = fork();
    if (child == 0) {
      execl(program.c_str(), name.c_str(), "run", file.c_str(), "--quiet", "--out", out.c_str(), nullptr);
      _exit(99);
    }
    int writer = -1;  // once the program reads
    for (int i = 0; i < 10000 && (writer = ::open(file.c_str(), O_WRONLY | O_NONBLOCK)) < 0; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    ASSERT_GE(writer, 0) << name;
    kill(child, SIGINT);
    const std::string text = "dobra = 1\nprogram = \"" + name + "\"\n";
    EXPECT_EQ(::write(writer, text.data(), text.size()), static_cast<ssize_t>(text.size()));
    close(writer);
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFEXITED(status)) << name;
    EXPECT_EQ(WEXITSTATUS(status), 130) << name;
    EXPECT_FALSE(fs::exists(out));
  }
}

TEST_F(Programs, AnInterruptedLoopEndsWith130AndPrintsItsCycles) {
  const std::string program = DOBRA_BIN_DIR "/quebra";
  const std::string example = std::string(DOBRA_SOURCE_DIR) + "/resources/examples/quebra/edge_crack.toml";
  const fs::path said = path("said"), printed = path("printed");
  const pid_t child = fork();
  if (child == 0) {
    unsetenv("DISPLAY");
    if (freopen(said.c_str(), "w", stderr) == nullptr || freopen(printed.c_str(), "w", stdout) == nullptr) _exit(98);
    execl(program.c_str(), "quebra", "adapt", example.c_str(), "--target", "0.001%", "--max-cycles", "50", "--json",
          nullptr);
    _exit(99);
  }
  for (int i = 0; i < 600 && read(said).find("cycle 2: ") == std::string::npos; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  kill(child, SIGINT);
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 130);
  const std::string json = read(printed);
  EXPECT_NE(json.find("\"Cycle 2\""), std::string::npos) << read(said);
  EXPECT_NE(json.find("\"reached\": false"), std::string::npos);
  EXPECT_NE(read(said).find("could not be finished: interrupted"), std::string::npos) << read(said);
}

TEST_F(Programs, SameInputSameBytesAtAnyNumberOfThreads) {
  for (const std::string program : {"recon", "quebra"}) {
    const std::string example = std::string(DOBRA_SOURCE_DIR) + "/resources/examples/" +
                                (program == "recon" ? "recon/fold.toml" : "quebra/plate_with_hole.toml");
    for (const std::string threads : {"1", "4"}) {
      const Outcome outcome = call(program + " run " + example + " --quiet --threads " + threads + " --out " +
                                   path(program + threads).string());
      ASSERT_EQ(outcome.code, 0) << outcome.said;
    }
    for (const auto& entry : fs::directory_iterator(path(program + "1"))) {
      if (entry.path().filename() == "picture_vtk.png") continue;  // drawn by the OpenGL driver
      EXPECT_EQ(read(entry.path()), read(path(program + "4") / entry.path().filename())) << entry.path();
    }
  }
}

TEST_F(Programs, MeshWritesFilesAndEndsWithTheCodesOfItsErrors) {
  const auto geo =
      write("a.geo",
            "Point(1)={0,0,0,0.5};Point(2)={2,0,0,0.5};Point(3)={2,2,0,0.5};Point(4)={0,2,0,0.5};\n"
            "Line(1)={1,2};Line(2)={2,3};Line(3)={3,4};Line(4)={4,1};Curve Loop(1)={1:4};Plane Surface(1)={1};\n");
  const auto mesh = [&](const std::string& arguments) { return call("quebra mesh " + arguments); };
  for (const char* const name : {"m.vtu", "m.msh", "m.inp", "m.bdf", "m.nf", "m.node"}) {
    EXPECT_EQ(mesh(geo.string() + " --size 0.3 --bands curve_1:2:0.2 --json --out " + path(name).string()).code, 0)
        << name;
    EXPECT_TRUE(fs::exists(path(name))) << name;
  }
  EXPECT_TRUE(fs::exists(path("m.ele"))) << "written beside m.node";
  EXPECT_EQ(mesh(path("m.msh").string() + " --order 2 --quads").code, 0) << "the boundary of a mesh is a domain";
  EXPECT_EQ(mesh(geo.string() + " --out " + path("m.xyz").string()).code, 2);
  EXPECT_EQ(mesh(geo.string() + " --bands curve_1:2").code, 2);
  EXPECT_EQ(mesh(geo.string() + " --order 3").code, 2);
  EXPECT_EQ(mesh(geo.string() + " --size -1").code, 3);
  EXPECT_EQ(mesh(path("none.geo").string()).code, 3);
  EXPECT_EQ(mesh(geo.string() + " --size 0.001 --max-elements 100").code, 4);
  const Outcome bad = mesh(write("bad.geo", "Point(1) = {0, 0, 0};\nLine(1) = {1, 2};\n").string());
  EXPECT_EQ(bad.code, 3);
  EXPECT_NE(bad.said.find("bad.geo:2:1"), std::string::npos) << bad.said;
}

}  // namespace
