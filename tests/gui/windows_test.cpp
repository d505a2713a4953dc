// Both programs in their real windows: a script does what a user does, the command line repeats it.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

namespace {

class Windows : public testing::TestWithParam<const char*> {
 protected:
  Windows() {
    std::string name = (std::filesystem::temp_directory_path() / "dobra_windows_XXXXXX").string();
    folder = mkdtemp(name.data());
  }
  ~Windows() override { std::filesystem::remove_all(folder); }

  /// Leaks of Qt and of the drivers are judged in dobra_gui_test, which knows them; here they would only hide exit
  /// codes.
  static int run(const std::string& command) {
    const int status = std::system(("ASAN_OPTIONS=detect_leaks=0 " + command).c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  static std::string program(const std::string& name) { return std::string(DOBRA_BIN_DIR) + "/" + name; }
  static std::filesystem::path example(const std::string& name) {
    const auto folder = std::filesystem::path(DOBRA_SOURCE_DIR) / "resources/examples" / name;
    return name == "recon" ? folder / "fold.toml" : folder / "plate_with_hole.toml";
  }
  std::string path(const std::string& name) const { return (folder / name).string(); }
  std::string read(const std::string& name) const {
    std::ifstream in(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }

  std::filesystem::path folder;
};

TEST_P(Windows, GUI_a_OpensAScenarioAndRendersIt) {
  const std::string name = GetParam();
  const std::string script = write(
      "script.txt", "wait\nscreenshot " + path("shot.png") + "\nsave-picture " + path("picture.png") + "\nquit\n");
  ASSERT_EQ(run("xvfb-run -a " + program(name) + " " + example(name).string() + " --script " + script), 0);
  for (const char* png : {"shot.png", "picture.png"}) {
    const std::string bytes = read(png);
    EXPECT_EQ(bytes.substr(1, 3), "PNG") << png;
    EXPECT_GT(bytes.size(), 10000u) << png;  // a blank one of that size takes a fifth; `screenshot` refuses one
  }
}

/// Each names its item, in the window and in batch, and nothing is left behind.
TEST_P(Windows, GUI_c_BadValuesAreNamedInTheWindowAndInBatch) {
  const std::string name = GetParam();
  const std::string head = "dobra = 1\nprogram = \"" + name + "\"\n[input]\n";
  const std::string section = "[[input.horizon]]\nname = \"top\"\npoints = [[0, 0], [50, 5], [100, 0]]\n";
  const std::string crossing = "[[input.horizon]]\nname = \"knot\"\npoints = [[0, 0], [100, 50], [100, 0], [0, 50]]\n";
  const std::string plate =
      "[[input.curve]]\nname = \"plate\"\nkind = \"polygon\"\npoints = [[0, 0], [4, 0], [4, 4], [0, 4]]\n";
  const std::string bow =
      "[[input.curve]]\nname = \"knot\"\nkind = \"polygon\"\npoints = [[0, 0], [4, 4], [4, 0], [0, 4]]\n";
  const std::string step = name == "recon" ? "[[step]]\noperation = \"grid\"\ntop = \"top\"\n"
                                           : "[[step]]\noperation = \"constraints\"\ncurves = [\"plate\"]\n";
  struct Bad {
    std::string text;
    const char* named;     ///< In batch, by its key.
    const char* in_words;  ///< In the window, as its form calls it.
  };
  const std::string whole = head + (name == "recon" ? section : plate) + step;
  const Bad all[] = {{head + (name == "recon" ? crossing : bow), "knot", "knot"},
                     {whole + "distance = -5.0\n", "distance", "istance"},
                     {whole + "count = 0\n", "count", "umber"},
                     {whole + "factor = 0.0\n", "factor", "actor"},
                     {whole + "factor = -1.0\n", "factor", "actor"}};
  for (const Bad& bad : all) {
    const std::string document = write("bad.toml", bad.text);
    const int code = run("env -u DISPLAY " + program(name) + " run " + document + " --out " + path("out") +
                         " > /dev/null 2> " + path("said"));
    EXPECT_GE(code, 1) << bad.text;
    EXPECT_LT(code, 100) << bad.text;  // not a signal
    EXPECT_NE(read("said").find(bad.named), std::string::npos) << read("said") << "\n" << bad.text;
    const std::string script = write("script.txt", std::string("wait\nexpect-error ") + bad.in_words + "\nquit\n");
    EXPECT_EQ(run("xvfb-run -a " + program(name) + " " + document + " --script " + script + " 2> " + path("said")), 0)
        << read("said") << "\n"
        << bad.text;
  }
}

/// A horizon, or a crack, drawn with the mouse in the true window and saved is what the command line runs; undone, it
/// is as if it had never been.
TEST_P(Windows, GUI_b_WhatIsDrawnWithTheMouseTheCommandLineRuns) {
  const std::string name = GetParam();
  const bool recon = name == "recon";
  std::filesystem::copy(example(name).parent_path(), path("example"));
  const std::string document = path("example/" + std::string(recon ? "fold.toml" : "cracked_plate.toml"));
  const std::string draw =
      recon ? "tool line\nclick 0 300\nclick 3000 100\nclick 6000 200\nkeys Enter\nkeys Drawn\nkeys Enter\n"
            : "look input\nwait\ntool crack\nclick 8 1.5\nclick 7 1.5\nkeys Enter\n";
  const std::string script = write("script.txt", "wait\nreport " + path("before.json") + "\n" + draw + "wait\nreport " +
                                                     path("drawn.json") + "\nsave " + path("example/saved.toml") +
                                                     "\nundo\nwait\nreport " + path("undone.json") + "\nquit\n");
  ASSERT_EQ(run("xvfb-run -a -s '-screen 0 1280x800x24' " + program(name) + " " + document + " --script " + script), 0);
  EXPECT_EQ(read("before.json"), read("undone.json"));
  EXPECT_NE(read("before.json"), read("drawn.json"));
  EXPECT_NE(read("example/saved.toml").find(recon ? "name = \"Drawn\"" : "name = \"crack\""), std::string::npos);
  const int code =
      run("env -u DISPLAY " + program(name) + " run " + path("example/saved.toml") + " --quiet --out " + path("out"));
  EXPECT_TRUE(code == 0 || code == 1) << code;
  EXPECT_EQ(read("out/report.json"), read("drawn.json"));
}

TEST_P(Windows, GUI_b_WhatWasDoneInTheWindowTheCommandLineRepeatsToTheByte) {
  const std::string name = GetParam();
  std::filesystem::copy(example(name).parent_path(), path("example"));
  const std::string document = path("example/" + example(name).filename().string());
  const std::string script =
      write("script.txt", "wait\nreport " + path("first.json") + "\nselect " + (name == "recon" ? "1" : "2") +
                              "\nset factor 1.1\nwait\nundo\nwait\nreport " + path("undone.json") +
                              "\nredo\nwait\nreport " + path("window.json") + "\nsave " + path("example/saved.toml") +
                              "\nscreenshot " + path("shot.png") + "\nquit\n");
  ASSERT_EQ(run("xvfb-run -a " + program(name) + " " + document + " --script " + script), 0);
  EXPECT_EQ(read("undone.json"), read("first.json"));
  EXPECT_NE(read("window.json"), read("first.json"));
  EXPECT_GT(read("shot.png").size(), 10000u);
  // An expectation about the unchanged example may fail now (exit code 1); the report is written all the same.
  const int code =
      run("env -u DISPLAY " + program(name) + " run " + path("example/saved.toml") + " --quiet --out " + path("out"));
  EXPECT_TRUE(code == 0 || code == 1) << code;
  EXPECT_EQ(read("out/report.json"), read("window.json"));
}

/// What the window found and what the command line finds, compared byte by byte: every example and three large
/// sections or meshes.
class Reports : public Windows {
 protected:
  /// In `folder`, with its files beside it.
  void compare(const std::string& document) {
    const std::string name = GetParam();
    const std::string script =
        write("script.txt", "wait\nreport " + path("window.json") + "\nscreenshot " + path("shot.png") + "\nquit\n");
    std::filesystem::remove(path("window.json"));
    std::filesystem::remove_all(path("out"));
    ASSERT_EQ(run("xvfb-run -a " + program(name) + " " + document + " --script " + script), 0) << document;
    const int code = run("env -u DISPLAY " + program(name) + " run " + document + " --quiet --out " + path("out"));
    ASSERT_EQ(code, 0) << document;
    EXPECT_GT(read("window.json").size(), 500u) << document;
    EXPECT_EQ(read("window.json"), read("out/report.json")) << document;
    EXPECT_GT(read("shot.png").size(), 10000u) << document;
  }
  /// Horizons over 10 km that fold and ripple, each as a list of points.
  static std::string section(int horizons, int points) {
    std::string text = "dobra = 1\nprogram = \"recon\"\n[input]\n";
    for (int k = 0; k < horizons; ++k) {
      text += "[[input.horizon]]\nname = \"h" + std::to_string(k) + "\"\npoints = [";
      for (int i = 0; i < points; ++i) {
        const double x = 10000.0 * i / (points - 1);
        const double z = 200.0 * std::sin(x / 900.0) + 3.0 * std::sin(0.4 * i + k) - 2000.0 * k / horizons;
        text += (i == 0 ? "[" : ", [") + std::to_string(x) + ", " + std::to_string(z) + "]";
      }
      text += "]\n";
    }
    return text;
  }
  static std::string restored(const std::string& method) {
    return "[[step]]\noperation = \"grid\"\ntop = \"h0\"\n[[step]]\noperation = \"target\"\npin = 0.0\n[[step]]\n"
           "operation = \"restore\"\nmethod = \"" +
           method + "\"\n";
  }
  static std::string plate(const std::string& more) {
    return "dobra = 1\nprogram = \"quebra\"\n[input]\n[[input.curve]]\nname = \"plate\"\nkind = \"polygon\"\n"
           "points = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]]\n" +
           more;
  }
  static std::string holes(int along) {
    std::string text;
    for (int i = 0; i < along * along; ++i) {
      const double step = 10.0 / along;
      text += "[[input.curve]]\nname = \"hole" + std::to_string(i) + "\"\nkind = \"circle\"\ncentre = [" +
              std::to_string(step * (0.5 + i % along)) + ", " + std::to_string(step * (0.5 + i / along)) +
              "]\nradius = " + std::to_string(0.25 * step) + "\n";
    }
    return text;
  }
  static std::string cracks(int count) {
    std::string text;
    for (int i = 0; i < count; ++i) {
      const double y = 10.0 * (i + 0.5) / count;
      text += "[[input.crack]]\nname = \"crack" + std::to_string(i) + "\"\npoints = [[" + (i % 2 == 0 ? "0.0" : "2.0") +
              ", " + std::to_string(y) + "], [" + std::to_string(4.0 + 0.1 * i) + ", " + std::to_string(y + 0.1) +
              "]]\n";
    }
    return text;
  }
};

TEST_P(Reports, GUI_b_OfEveryExampleAreTheSameInWindowAndCommandLine) {
  const std::string name = GetParam();
  std::filesystem::copy(example(name).parent_path(), path("example"));
  int examples = 0;
  for (const auto& entry : std::filesystem::directory_iterator(path("example"))) {
    if (entry.path().extension() != ".toml") continue;
    ++examples;
    compare(entry.path().string());
  }
  EXPECT_GE(examples, 3);
}

TEST_P(Reports, GUI_b_OfLargeInputsAreTheSameInWindowAndCommandLine) {
  const bool recon = GetParam() == std::string("recon");
  const std::vector<std::string> inputs =
      recon ? std::vector<std::string>{section(10, 1000) + restored("shear"), section(60, 300) + restored("constant"),
                                       section(5, 800) + restored("proportional") + restored("constant")}
            : std::vector<std::string>{
                  plate(holes(12)) + "[[step]]\noperation = \"mesh\"\nsize = 0.1\n",
                  plate(cracks(20)) + "[[step]]\noperation = \"mesh\"\nsize = 0.15\norder = \"2\"\n",
                  plate("[[input.region]]\nname = \"steel\"\npoint = [5.0, 5.0]\n") +
                      "[[step]]\noperation = \"problem\"\n[[step.material]]\nyoung = 1.0\npoisson = 0.3\n"
                      "[[step.support]]\nwhere = \"plate\"\nx = 0.0\ny = 0.0\n[[step.load]]\nkind = \"body\"\nwhere = "
                      "\"steel\"\ny = -1.0\n[[step]]\noperation = \"mesh\"\nsize = 0.08\n[[step]]\noperation = "
                      "\"analyse\"\n"};
  int number = 0;
  for (const std::string& input : inputs) compare(write("large" + std::to_string(++number) + ".toml", input));
}

INSTANTIATE_TEST_SUITE_P(Programs, Reports, testing::Values("recon", "quebra"));

TEST_P(Windows, GUI_d_SavedAndSavedAgainIsTheSame) {
  const std::string name = GetParam();
  std::filesystem::copy(example(name).parent_path(), path("example"));
  const std::string once = write("once.txt", "wait\nsave " + path("example/a.toml") + "\nquit\n");
  const std::string again = write("again.txt", "wait\nsave " + path("example/b.toml") + "\nquit\n");
  ASSERT_EQ(run("xvfb-run -a " + program(name) + " " + path("example/" + example(name).filename().string()) +
                " --script " + once),
            0);
  ASSERT_EQ(run("xvfb-run -a " + program(name) + " " + path("example/a.toml") + " --script " + again), 0);
  EXPECT_FALSE(read("example/a.toml").empty());
  EXPECT_EQ(read("example/a.toml"), read("example/b.toml"));
}

TEST_P(Windows, GUI_c_MissingFileWithAScriptEndsWithThree) {
  const std::string script = write("script.txt", "wait\nquit\n");
  EXPECT_EQ(run("xvfb-run -a " + program(GetParam()) + " " + path("missing.toml") + " --script " + script + " 2> " +
                path("said")),
            3);
  EXPECT_NE(read("said").find("missing.toml"), std::string::npos) << read("said");
}

TEST(WindowOfQuebra, TheMesherIsWatchedStepByStepAndTheDocumentStaysAsItIs) {
  std::string name = (std::filesystem::temp_directory_path() / "dobra_watch_XXXXXX").string();
  const std::filesystem::path folder = mkdtemp(name.data());
  const auto path = [&](const char* file) { return (folder / file).string(); };
  const auto read = [&](const char* file) {
    std::ifstream in(path(file), std::ios::binary);
    return std::string{std::istreambuf_iterator<char>(in), {}};
  };
  std::ofstream(path("plate.toml")) << "dobra = 1\nprogram = \"quebra\"\n\n[input]\nspecimen = "
                                       "\"plate_with_hole\"\n\n[[step]]\noperation = \"mesh\"\nsize = 0.5\n"
                                       "[[expect]]\nquantity = \"work.front\"\nvalue = -1.0\n";
  std::ofstream(path("script.txt")) << "wait\nreport " << path("first.json") << "\nwatch step 100\nwait\nreport "
                                    << path("work.json") << "\nscreenshot " << path("work.png")
                                    << "\nwatch step 20\nwait\nwatch stop\nwait\nreport " << path("last.json")
                                    << "\nsave " << path("saved.toml") << "\nquit\n";
  const std::string command = "ASAN_OPTIONS=detect_leaks=0 xvfb-run -a " + std::string(DOBRA_BIN_DIR) + "/quebra " +
                              path("plate.toml") + " --script " + path("script.txt");
  EXPECT_EQ(std::system(command.c_str()), 0);
  EXPECT_NE(read("work.json").find("work.front"), std::string::npos);
  // What is expected of the mesh is not asked of the mesher at work.
  EXPECT_NE(read("last.json").find("\"met\""), std::string::npos);
  EXPECT_EQ(read("work.json").find("\"met\""), std::string::npos);
  EXPECT_GT(read("work.png").size(), 10000u);
  EXPECT_EQ(read("last.json"), read("first.json"));
  EXPECT_EQ(read("saved.toml").find("stop_after"), std::string::npos);
  std::filesystem::remove_all(folder);
}

/// An outline that crosses itself is refused, and drawn all the same: Show has something to show.
TEST_P(Windows, GUI_c_WhatIsRefusedIsDrawn) {
  const std::string name = GetParam();
  const std::string points = "points = [[0, 0], [4, 4], [4, 0], [0, 4]]\n";
  const std::string recon = "[[input.horizon]]\nname = \"bow\"\n" + points;
  const std::string quebra = "[[input.curve]]\nname = \"bow\"\nkind = \"polygon\"\n" + points;
  const std::string document =
      write("bow.toml", "dobra = 1\nprogram = \"" + name + "\"\n[input]\n" + (name == "recon" ? recon : quebra));
  const std::string script = write("script.txt", "wait\nexpect-error cross\ngo-to-error\nsave-picture " +
                                                     path("bow.svg") + "\nscreenshot " + path("bow.png") + "\nquit\n");
  EXPECT_EQ(run("xvfb-run -a " + program(name) + " " + document + " --script " + script), 0);
  EXPECT_NE(read("bow.svg").find("bow"), std::string::npos);
}

/// At 200 % a screen of 1280 x 800 has room for 640 x 400 of the window's units.
TEST_P(Windows, FitsASmallScreenAtTwiceTheScale) {
  const std::string name = GetParam();
  const std::string script = write("script.txt", "wait\nscreenshot " + path("small.png") + "\nquit\n");
  ASSERT_EQ(run("QT_SCALE_FACTOR=2 xvfb-run -a -s '-screen 0 1280x800x24' " + program(name) + " " +
                example(name).string() + " --script " + script),
            0);
  const std::string png = read("small.png");
  ASSERT_GT(png.size(), 24U);
  const auto number = [&](std::size_t at) {  // big-endian, of the header
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = 256U * value + static_cast<unsigned char>(png[at + i]);
    return value;
  };
  EXPECT_LE(number(16), 1280U);
  EXPECT_LE(number(20), 800U);
}

/// A window that is killed leaves its changes, and the next one takes them up.
TEST_P(Windows, AKilledWindowLosesNothing) {
  const std::string name = GetParam();
  std::filesystem::copy(example(name).parent_path(), path("example"));
  const std::string document = path("example/" + example(name).filename().string());
  const std::string edit = write("edit.txt", std::string("wait\nselect ") + (name == "recon" ? "1" : "2") +
                                                 "\nset factor 1.1\nwait\n");  // and stays open
  const std::string recover =
      write("recover.txt", "wait\nrecover\nwait\nsave " + path("example/saved.toml") + "\nquit\n");
  EXPECT_EQ(run("xvfb-run -a sh -c '" + program(name) + " " + document + " --script " + edit +
                " & for i in $(seq 200); do test -s " + document + ".unsaved && break; sleep 0.1; done; kill -9 $!'"),
            0);
  ASSERT_EQ(run("xvfb-run -a " + program(name) + " " + document + " --script " + recover), 0);
  EXPECT_NE(read("example/saved.toml").find("factor = 1.1"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(document + ".unsaved"));
}

/// Killed at moments that chance gives, amid edits and savings: no more than the last edit is lost, and no file is left
/// half written. DOBRA_KILLS=100 asks it a hundred times.
TEST_P(Windows, KilledAtAnyMomentNoMoreThanTheLastEditIsLost) {
  const std::string name = GetParam();
  const char* asked = std::getenv("DOBRA_KILLS");
  const int kills = asked == nullptr ? 2 : std::atoi(asked);
  std::filesystem::copy(example(name).parent_path(), path("example"));
  const std::string document = path("example/" + example(name).filename().string());
  std::string edits = "wait\nselect " + std::string(name == "recon" ? "1" : "2") + "\n";
  for (int i = 1; i <= 400; ++i) {
    edits += "set factor 1.1" + std::to_string(1000 + i) + "\nlongest-gap " + path("marks/" + std::to_string(i)) + "\n";
    if (i % 7 == 0) edits += "save\n";
  }
  std::string commands = "cp " + document + " " + path("original") + "\n";
  std::mt19937 random(29);
  for (int i = 0; i < kills; ++i) {
    const std::string result = path("result." + std::to_string(i));
    commands += "rm -rf " + path("marks") + " " + document + ".unsaved; mkdir " + path("marks") + "; cp " +
                path("original") + " " + document + "\n" + program(name) + " " + document + " --script " +
                write("edits.txt", edits) + " & pid=$!\nfor i in $(seq 600); do test -e " + path("marks/1") +
                " && break; sleep 0.1; done\nsleep " + std::to_string(static_cast<double>(random() % 2000) / 1000.0) +
                "\nkill -9 $pid\nwait $pid\nls " + path("marks") + " | sort -n | tail -1 > " + result + ".last\n" +
                "cp " + document + " " + result + "\ntest -e " + document + ".unsaved && cp " + document + ".unsaved " +
                result + "\n";
  }
  commands += "true\n";
  ASSERT_EQ(run("xvfb-run -a sh " + write("kills.sh", commands) + " 2> " + path("said")), 0) << read("said");
  for (int i = 0; i < kills; ++i) {
    const std::string left = read("result." + std::to_string(i));
    const int last = std::stoi(read("result." + std::to_string(i) + ".last"));
    const std::size_t at = left.find("factor = 1.1");
    ASSERT_NE(at, std::string::npos) << i << ", last " << last << ": " << left;
    const long kept = std::lround(1e5 * std::stod(left.substr(at + 9))) - 111000;  // "factor = 1.11007"
    EXPECT_GE(kept, last - 1) << i;
    EXPECT_LE(kept, last + 1) << i;
    std::ofstream(path("example/left.toml")) << left;
    const int code = run("env -u DISPLAY " + program(name) + " run " + path("example/left.toml") + " --quiet --out " +
                         path("out") + " > /dev/null 2>&1");
    EXPECT_TRUE(code == 0 || code == 1) << code << ": " << left;  // an expectation may fail now
  }
}

TEST_P(Windows, WithoutADisplayTheMessageSaysWhatToDo) {
  EXPECT_EQ(run("env -u DISPLAY -u WAYLAND_DISPLAY " + program(GetParam()) + " " + example(GetParam()).string() +
                " 2> " + path("said")),
            4);
  EXPECT_NE(read("said").find("DISPLAY"), std::string::npos) << read("said");
}

INSTANTIATE_TEST_SUITE_P(Programs, Windows, testing::Values("recon", "quebra"));

}  // namespace
