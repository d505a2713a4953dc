#include "shared/cli/cli.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "shared/io/file.h"
#include "tests/support/fake_program.h"

namespace dobra::cli {
namespace {

namespace fs = std::filesystem;

struct Outcome {
  int code = 0;
  std::string out;
  std::string err;
};

struct Setting {
  Window window;
  std::vector<Command> commands;
};

/// run_program in this process, as "fake ARGS".
Outcome call(std::vector<std::string> args, const Setting& setting = {}) {
  args.insert(args.begin(), "fake");
  std::vector<char*> argv;
  for (std::string& arg : args) argv.push_back(arg.data());
  argv.push_back(nullptr);
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  Outcome outcome;
  outcome.code =
      run_program(fake::program(), static_cast<int>(args.size()), argv.data(), setting.window, setting.commands);
  outcome.out = ::testing::internal::GetCapturedStdout();
  outcome.err = ::testing::internal::GetCapturedStderr();
  return outcome;
}

class Cli : public ::testing::Test {
 protected:
  void SetUp() override {
    root = fs::temp_directory_path() / ("dobra_cli_test_" + std::to_string(::getpid()));
    fs::remove_all(root);
    fs::create_directories(root);
    good = put("good.toml", two_steps);
  }
  void TearDown() override { fs::remove_all(root); }

  std::string put(const std::string& name, const std::string& body) const {
    std::ofstream(root / name, std::ios::binary) << "dobra = 1\nprogram = \"fake\"\n" << body;
    return (root / name).string();
  }
  std::string raw(const std::string& name, const std::string& bytes) const {
    std::ofstream(root / name, std::ios::binary) << bytes;
    return (root / name).string();
  }
  [[nodiscard]] std::string out() const { return (root / "out").string(); }
  [[nodiscard]] std::vector<std::string> files(const fs::path& folder) const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
  }
  /// Code and message of a run that must fail and leave no folder behind.
  void expect_failure(const std::string& scenario, int code, const std::string& message) const {
    const Outcome outcome = call({"run", scenario, "--out", out()});
    EXPECT_EQ(outcome.code, code) << outcome.err;
    EXPECT_EQ(outcome.err, "fake: " + message + '\n');
    EXPECT_EQ(outcome.out, "");
    EXPECT_FALSE(fs::exists(out()));
  }

  const std::string two_steps =
      "[input]\nnumbers = [1, 2, 4]\n[[step]]\noperation = \"scale\"\nfactor = 3\n[[step]]\noperation = "
      "\"scale\"\nname = \"last\"\nfactor = 0.5\n"
      "path = [[0, 0], [10, 5], [20, -5]]\n";
  fs::path root;
  std::string good;
};

TEST_F(Cli, RunWritesReportTablesOutputsAndPictures) {
  const Outcome outcome = call({"run", good, "--out", out()});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const auto written = files(out());
  for (const char* name : {"numbers.csv", "numbers.txt", "picture.pdf", "picture.png", "picture.svg", "report.json"}) {
    EXPECT_EQ(std::count(written.begin(), written.end(), name), 1) << name;
    EXPECT_NE(outcome.out.find((fs::path(out()) / name).string()), std::string::npos) << name;
  }
  // VTK's picture, or a word about why it is missing.
  EXPECT_EQ(std::count(written.begin(), written.end(), "picture_vtk.png") == 1, outcome.err.empty()) << outcome.err;
  EXPECT_EQ(written.size(), outcome.err.empty() ? 7U : 6U);
  EXPECT_EQ(*io::read_bytes(root / "out" / "numbers.txt"), "1.5\n3.0\n6.0\n");
  EXPECT_EQ(*io::read_bytes(root / "out" / "numbers.csv"),
            "name,value [m]\n\"a, \"\"b\"\"\",1.5\n\"a, \"\"b\"\"\",3.0\n\"a, \"\"b\"\"\",6.0\n");
  EXPECT_EQ(io::read_bytes(root / "out" / "picture.png")->substr(1, 3), "PNG");
  EXPECT_EQ(io::read_bytes(root / "out" / "picture.pdf")->substr(0, 4), "%PDF");
}

TEST_F(Cli, TwoRunsGiveTheSameBytes) {
  ASSERT_EQ(call({"run", good, "--out", out(), "--pictures", "svg,pdf,png"}).code, 0);
  ASSERT_EQ(call({"run", good, "--out", out() + "2", "--pictures", "svg,pdf,png", "--threads", "1"}).code, 0);
  for (const std::string& name : files(out())) {
    EXPECT_EQ(*io::read_bytes(fs::path(out()) / name), *io::read_bytes(fs::path(out() + "2") / name)) << name;
  }
}

TEST_F(Cli, PicturesAreChosen) {
  EXPECT_EQ(call({"run", good, "--out", out(), "--pictures", "none"}).code, 0);
  EXPECT_EQ(files(out()), (std::vector<std::string>{"numbers.csv", "numbers.txt", "report.json"}));
  EXPECT_EQ(call({"run", good, "--out", out(), "--pictures", "svg"}).code, 0);
  EXPECT_EQ(files(out()).size(), 4U);
  const Outcome wrong = call({"run", good, "--out", out(), "--pictures", "svg,pngg"});
  EXPECT_EQ(wrong.code, 2);
  EXPECT_EQ(wrong.err, "fake: --pictures: unknown kind 'pngg'; did you mean 'png'?\n");
}

TEST_F(Cli, JsonPrintsTheReportAndQuietPrintsNothing) {
  const Outcome json = call({"run", good, "--out", out(), "--pictures", "none", "--json"});
  EXPECT_EQ(json.code, 0);
  EXPECT_EQ(json.out, *io::read_bytes(root / "out" / "report.json"));
  EXPECT_EQ(nlohmann::json::parse(json.out)["steps"][1]["quantities"]["sum"]["value"], 10.5);
  const Outcome quiet = call({"run", good, "--out", out(), "--pictures", "none", "--quiet"});
  EXPECT_EQ(quiet.code, 0);
  EXPECT_EQ(quiet.out + quiet.err, "");
  const Outcome verbose = call({"run", good, "--out", out(), "--pictures", "none", "--verbose"});
  EXPECT_NE(verbose.err.find("fake: sum = 10.5 m\n"), std::string::npos);
}

TEST_F(Cli, SetChangesValues) {
  const Outcome json = call({"run", "--set", "steps.last.factor=2", good, "--set", "steps.1.times=2", "--out", out(),
                             "--pictures", "none", "--json"});
  ASSERT_EQ(json.code, 0) << json.err;
  EXPECT_EQ(nlohmann::json::parse(json.out)["steps"][1]["quantities"]["sum"]["value"], 126.0);
  const Outcome wrong = call({"run", good, "--out", out(), "--set", "steps.last.facto=2"});
  EXPECT_EQ(wrong.code, 2);
  EXPECT_EQ(wrong.err, "fake: --set steps.last.facto=2: unknown key 'facto'; did you mean 'factor'?\n");
  EXPECT_EQ(call({"run", good, "--out", out(), "--set", "steps.last.factor=-2"}).code, 3);
}

TEST_F(Cli, WrongUsageIsOneLineWithAHintAndExitCode2) {
  const auto expect_usage = [](const std::vector<std::string>& args, const std::string& message) {
    const Outcome outcome = call(args);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.err, "fake: " + message + '\n');
    if (std::find(args.begin(), args.end(), "--json") == args.end()) {
      EXPECT_EQ(outcome.out, "");
      return;
    }
    const auto findings = nlohmann::json::parse(outcome.out)["findings"];
    ASSERT_EQ(findings.size(), 1U);
    EXPECT_EQ(findings[0]["code"], "bad_usage");
    EXPECT_EQ(message.find(findings[0]["message"].get<std::string>()), 0U);
  };
  expect_usage({"run", good}, "--out is required; see 'fake run --help'");
  expect_usage({"run", "--out", out()}, "file is required; see 'fake run --help'");
  expect_usage({"run", good, "--ouut", out()}, "--out is required; see 'fake run --help'");
  expect_usage({"run", good, "--out", out(), "--quite"},
               "unexpected argument '--quite'; did you mean '--quiet'?; see 'fake run --help'");
  expect_usage({"run", good, "--out", out(), "--json", "p.png"},
               "unexpected argument 'p.png': --json before it takes no value; see 'fake run --help'");
  expect_usage({"run", good, "--out", out(), "-q", "p.png"},
               "unexpected argument 'p.png': -q before it takes no value; see 'fake run --help'");
  expect_usage({"run", good, "--out", out(), "p.png"}, "unexpected argument 'p.png'; see 'fake run --help'");
  expect_usage({"rnu", good}, "there is no sub-command and no file 'rnu'; did you mean 'run'?; see 'fake --help'");
  expect_usage({}, "this build has no window; give a sub-command; see 'fake --help'");
  EXPECT_EQ(call({"run", good, "--out", out(), "--threads", "0"}).code, 2);
  EXPECT_EQ(call({"run", good, "--out", out(), "--quiet", "--verbose"}).code, 2);
  EXPECT_FALSE(fs::exists(out()));
}

TEST_F(Cli, HelpAndVersionWorkOnEverySubCommand) {
  for (const std::string command : {"run", "render", "operations"}) {
    const Outcome help = call({command, "--help"});
    EXPECT_EQ(help.code, 0);
    EXPECT_EQ(help.err, "");
    for (const char* option : {"--json", "--quiet", "--verbose", "--version", "--help", "--threads"}) {
      EXPECT_NE(help.out.find(option), std::string::npos) << command << ' ' << option;
    }
    EXPECT_EQ(call({command, "--version"}).out, "fake " DOBRA_VERSION "\n");
  }
  EXPECT_EQ(call({"--version"}).out, "fake " DOBRA_VERSION "\n");
  EXPECT_NE(call({"--help"}).out.find("operations"), std::string::npos);
  EXPECT_NE(call({"run", "--help"}).out.find("--set"), std::string::npos);
}

TEST_F(Cli, BadInputIsExitCode3WithFileLineAndWhatToChange) {
  expect_failure((root / "missing.toml").string(), 3, (root / "missing.toml").string() + ": there is no such file");
  expect_failure(root.string(), 3, root.string() + ": is a folder; give a file");
  const std::string empty = raw("empty.toml", "");
  expect_failure(empty, 3, empty + ": is empty");
  const std::string binary = raw("binary.toml", std::string("PK\x03\x04\0\0", 6));
  expect_failure(binary, 3, binary + ":1: is not a text file (it holds NUL bytes); give a text file in UTF-8");
  const std::string words = raw("words.toml", "these are words\n");
  EXPECT_EQ(call({"run", words, "--out", out()}).code, 3);
  const std::string key = put("key.toml", two_steps + "facto = 1\n");
  expect_failure(key, 3, key + ":13:1: step 2 (scale): unknown key 'facto'; did you mean 'factor'?");
  const std::string operation = put("operation.toml", "[[step]]\noperation = \"sacle\"\n");
  expect_failure(operation, 3, operation + ":3:1: step 1: unknown operation 'sacle'; did you mean 'scale'?");
  const std::string nan = put("nan.toml", "[input]\nnumbers = [1, nan]\n");
  expect_failure(nan, 3, nan + ":4:1: input: number 2 of 'numbers' must be a finite number, found nan");
  const std::string inf = put("inf.toml", "[[step]]\noperation = \"scale\"\nfactor = inf\n");
  expect_failure(inf, 3, inf + ":5:1: step 1 (scale): 'factor' must be a finite number, found inf");
  const std::string zero = put("zero.toml", "[[step]]\noperation = \"scale\"\ntimes = 0\n");
  expect_failure(zero, 3, zero + ":5:1: step 1 (scale): 'times' must be at least 1 and at most 1000, found 0");
  const std::string other = raw("other.toml", "dobra = 1\nprogram = \"quebra\"\n");
  expect_failure(other, 3, other + ": this scenario is for 'quebra', not for 'fake'; run it with quebra");
}

TEST_F(Cli, BadInputFilesOfAScenarioAreNamed) {
  const std::string missing = put("missing.toml", "[input]\nfile = \"none.txt\"\n");
  expect_failure(missing, 3, (root / "none.txt").string() + ": input: there is no such file");
  raw("words.txt", "1\ntwo\n");
  const std::string words = put("words.toml", "[[step]]\noperation = \"import\"\nfile = \"words.txt\"\n");
  expect_failure(words, 3, (root / "words.txt").string() + ":2: step 1 (import): is not a number");
}

TEST_F(Cli, WhatCannotBeComputedIsExitCode4WithThePlace) {
  const std::string fails = put("fails.toml", "[input]\nnumbers = [1]\n[[step]]\noperation = \"fail\"\n");
  expect_failure(fails, 4, fails + ":5:1: step 1 (fail): the curve crosses itself; move the point (at 3, 4)");
}

TEST_F(Cli, AFailingRunLeavesEarlierResultsAsTheyWere) {
  ASSERT_EQ(call({"run", good, "--out", out(), "--pictures", "svg"}).code, 0);
  const auto before = files(out());
  const std::string report = *io::read_bytes(root / "out" / "report.json");
  const std::string fails = put("fails.toml", "[[step]]\noperation = \"fail\"\n");
  EXPECT_EQ(call({"run", fails, "--out", out()}).code, 4);
  EXPECT_EQ(files(out()), before);
  EXPECT_EQ(*io::read_bytes(root / "out" / "report.json"), report);
}

TEST_F(Cli, AFailedExpectationIsExitCode1AndResultsAreWritten) {
  const std::string scenario = put(
      "expect.toml",
      two_steps +
          "[[expect]]\nquantity = \"sum\"\nvalue = 10\ntolerance = 0.1\n[[expect]]\nquantity = \"sum\"\nvalue = 10.5\n"
          "[[expect]]\nquantity = \"summ\"\nvalue = 10.5\n");
  const Outcome outcome = call({"run", scenario, "--out", out(), "--pictures", "none"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(outcome.err, "fake: " + scenario + ":13:1: expectation failed: sum is 10.5 m, expected 10 +- 0.1\n" +
                             "fake: " + scenario +
                             ":20:1: expectation failed: there is no quantity 'summ'; did you mean 'sum'?\n");
  EXPECT_NE(outcome.out.find("1 of 3 expectations met"), std::string::npos);
  EXPECT_EQ(files(out()).size(), 3U);
}

TEST_F(Cli, TheFullDeviceAndFoldersThatCannotBeWrittenAreExitCode4) {
  const Outcome device = call({"run", good, "--out", "/dev/full"});
  EXPECT_EQ(device.code, 4);
  EXPECT_EQ(device.err, "fake: /dev/full: cannot be written: Not a directory\n");
  fs::create_directory(out());
  fs::create_symlink("/dev/full", root / "out" / "report.json");
  const Outcome full = call({"run", good, "--out", out(), "--pictures", "none"});
  EXPECT_EQ(full.code, 4);
  EXPECT_EQ(full.err,
            "fake: " + (root / "out" / "report.json").string() + ": cannot be written: No space left on device\n");
  EXPECT_EQ(files(out()), std::vector<std::string>{"report.json"});
  fs::create_symlink("/dev/full", root / "full.svg");
  const Outcome picture = call({"render", good, "--out", (root / "full.svg").string()});
  EXPECT_EQ(picture.code, 4);
  EXPECT_EQ(picture.err, "fake: " + (root / "full.svg").string() + ": cannot be written: No space left on device\n");
  const Outcome nowhere = call({"render", good, "--out", (root / "no" / "such.svg").string()});
  EXPECT_EQ(nowhere.code, 4);
  EXPECT_EQ(nowhere.err, "fake: " + (root / "no").string() + ": cannot be written: No such file or directory\n");
}

/// Runs "fake ARGS" in a child process after `prepare` there; returns the child.
template <class Prepare>
pid_t start(std::vector<std::string> args, Prepare&& prepare) {
  const pid_t child = ::fork();
  if (child != 0) return child;
  prepare();
  args.insert(args.begin(), "fake");
  std::vector<char*> argv;
  for (std::string& arg : args) argv.push_back(arg.data());
  argv.push_back(nullptr);
  const int code = run_program(fake::program(), static_cast<int>(args.size()), argv.data());
  std::fflush(nullptr);
  ::_exit(code);
}

int exit_code_of(pid_t child) {
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
}

void redirect(int descriptor, const fs::path& file) {
  const int opened = ::open(file.c_str(), O_WRONLY | O_CREAT, 0600);
  ::dup2(opened, descriptor);
}

TEST_F(Cli, ADiskThatFillsUpHalfWayLeavesNothing) {
  // A limit on the size of files stands for the disk that is full.
  const fs::path messages = root / "messages";
  const pid_t child = start({"run", good, "--out", out(), "--pictures", "none"}, [&] {
    redirect(STDERR_FILENO, messages);
    std::signal(SIGXFSZ, SIG_IGN);
    const struct rlimit small { 100, 100 };
    ::setrlimit(RLIMIT_FSIZE, &small);
  });
  EXPECT_EQ(exit_code_of(child), 4);
  EXPECT_FALSE(fs::exists(out()));
  const std::string text = *io::read_bytes(messages);
  EXPECT_EQ(
      text.substr(0, 100),
      ("fake: " + (root / "out" / "report.json").string() + ": cannot be written: File too large\n").substr(0, 100));
}

TEST_F(Cli, AFullStandardOutputIsExitCode4) {
  const fs::path messages = root / "messages";
  const pid_t child = start({"run", good, "--out", out(), "--pictures", "none", "--json"}, [&] {
    redirect(STDERR_FILENO, messages);
    redirect(STDOUT_FILENO, "/dev/full");
  });
  EXPECT_EQ(exit_code_of(child), 4);
  EXPECT_EQ(*io::read_bytes(messages), "fake: standard output: cannot be written: No space left on device\n");
}

TEST_F(Cli, ARunThatFailsAtALaterStepWritesWhatTheEarlierOnesGave) {
  const std::string steps =
      "[input]\nnumbers = [1, 2]\n[[step]]\noperation = \"scale\"\nfactor = 3\n[[step]]\noperation = \"fail\"\n"
      "[[step]]\noperation = \"scale\"\nfactor = 2\n[[expect]]\nquantity = \"sum\"\nvalue = 9\n";
  const std::string scenario = put("later.toml", steps);
  const Outcome outcome = call({"run", scenario, "--out", out(), "--pictures", "none"});
  EXPECT_EQ(outcome.code, 4) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_NE(outcome.err.find(scenario + ":8:1: step 2 (fail): the curve crosses itself; move the point (at 3, 4)"),
            std::string::npos)
      << outcome.err;
  EXPECT_NE(outcome.err.find("what step 1 gave is in " + out()), std::string::npos) << outcome.err;
  EXPECT_EQ(*io::read_bytes(fs::path(out()) / "numbers.txt"), "3.0\n6.0\n");
  const auto report = nlohmann::json::parse(*io::read_bytes(fs::path(out()) / "report.json"));
  EXPECT_EQ(report["complete"], false);
  EXPECT_EQ(report["steps"].size(), 1U);
  EXPECT_EQ(report["error"]["step"], 2);
  EXPECT_FALSE(report["error"]["message"].get<std::string>().empty());
  EXPECT_FALSE(report.contains("expectations"));
  EXPECT_EQ(report["tables"].size(), 1U);
}

TEST_F(Cli, AnInterruptedRunIsExitCode130AndLeavesNoFile) {
  for (const int number : {SIGINT, SIGTERM}) {
    const fs::path waiting = root / "waiting";
    const fs::path messages = root / "messages";
    fs::remove(waiting);
    fs::remove(messages);
    const std::string scenario =
        put("wait.toml", "[[step]]\noperation = \"wait\"\nsignal_file = \"" + waiting.string() + "\"\n");
    const pid_t child = start({"run", scenario, "--out", out()}, [&] { redirect(STDERR_FILENO, messages); });
    for (int i = 0; i < 10000 && !fs::exists(waiting); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    ASSERT_TRUE(fs::exists(waiting));
    EXPECT_TRUE(fs::exists(out()));
    ::kill(child, number);
    EXPECT_EQ(exit_code_of(child), 130);
    EXPECT_FALSE(fs::exists(out()));
    EXPECT_EQ(*io::read_bytes(messages), "fake: " + scenario + ":3:1: step 1 (wait): interrupted\n");
  }
}

TEST_F(Cli, WorkThatDoesNotHearASignalEndsAfterFiveSecondsAsAnInterruption) {
  const fs::path waiting = root / "waiting", messages = root / "messages";
  const std::string scenario =
      put("wait.toml",
          "[[step]]\noperation = \"wait\"\ndeaf = true\nseconds = 60\nsignal_file = \"" + waiting.string() + "\"\n");
  const pid_t child = start({"run", scenario, "--out", out()}, [&] { redirect(STDERR_FILENO, messages); });
  for (int i = 0; i < 10000 && !fs::exists(waiting); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  ASSERT_TRUE(fs::exists(waiting));
  ::kill(child, SIGINT);
  EXPECT_EQ(exit_code_of(child), 130);
  EXPECT_EQ(*io::read_bytes(messages), "interrupted\n");
}

TEST_F(Cli, RenderDrawsOnePicture) {
  for (const std::string name : {"a.svg", "a.pdf", "a.png"}) {
    const Outcome outcome = call({"render", good, "--out", (root / name).string(), "--width", "300"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, (root / name).string() + '\n');
    EXPECT_GT(fs::file_size(root / name), 500U);
  }
  EXPECT_NE(io::read_bytes(root / "a.svg")->find("300"), std::string::npos);
  const Outcome wrong = call({"render", good, "--out", (root / "a.gif").string()});
  EXPECT_EQ(wrong.code, 2);
  EXPECT_EQ(wrong.err, "fake: " + (root / "a.gif").string() + ": cairo writes files that end in .svg, .pdf or .png\n");
  EXPECT_EQ(call({"render", good, "--out", (root / "a.svg").string(), "--drawer", "vtk"}).code, 2);
  EXPECT_EQ(call({"render", good, "--out", (root / "a.svg").string(), "--drawer", "opengl"}).code, 2);
}

TEST_F(Cli, RenderWithVtkDrawsOrSaysWhyNot) {
  const fs::path file = root / "vtk.png";
  const Outcome outcome = call({"render", good, "--out", file.string(), "--drawer", "vtk"});
  if (outcome.code == 0) {
    EXPECT_EQ(io::read_bytes(file)->substr(1, 3), "PNG");
  } else {
    EXPECT_EQ(outcome.code, 4);
    EXPECT_FALSE(outcome.err.empty());
    EXPECT_FALSE(fs::exists(file));
  }
}

TEST_F(Cli, OperationsListsWhatAScenarioCanDo) {
  const Outcome all = call({"operations"});
  EXPECT_EQ(all.code, 0);
  EXPECT_NE(all.out.find("  scale   Scale numbers\n"), std::string::npos);
  EXPECT_NE(all.out.find("horizon"), std::string::npos);
  const Outcome one = call({"operations", "scale"});
  EXPECT_NE(one.out.find("  factor   number > 0 [m], default 2.0; Factor. Each number is multiplied by it.\n"),
            std::string::npos)
      << one.out;
  const auto json = nlohmann::json::parse(call({"operations", "scale", "--json"}).out);
  EXPECT_EQ(json["parameters"][0]["key"], "factor");
  EXPECT_EQ(json["parameters"][0]["above"], 0.0);
  EXPECT_EQ(nlohmann::json::parse(call({"operations", "--json"}).out)["operations"].size(), 4U);
  const Outcome unknown = call({"operations", "sacle"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_EQ(unknown.err, "fake: unknown operation 'sacle'; did you mean 'scale'?\n");
}

TEST_F(Cli, WithoutASubCommandTheWindowOpens) {
  std::optional<fs::path> opened = "nothing";
  Setting setting;
  std::string look;
  setting.window.open = [&](const std::optional<fs::path>& file) {
    opened = file;
    return 42;
  };
  setting.window.add_options = [&](CLI::App& app) { app.add_option("--look", look, "Style"); };
  EXPECT_EQ(call({}, setting).code, 42);
  EXPECT_FALSE(opened);
  EXPECT_EQ(call({good, "--look", "dark"}, setting).code, 42);
  EXPECT_EQ(opened, fs::path(good));
  EXPECT_EQ(look, "dark");
  const Outcome missing = call({(root / "missing.toml").string()}, setting);
  EXPECT_EQ(missing.code, 3);
  EXPECT_EQ(missing.err, "fake: " + (root / "missing.toml").string() + ": there is no such file\n");
  EXPECT_EQ(call({good, "another.toml"}, setting).code, 2);
  // A window that can be seen says it itself.
  setting.window.tells_missing_files = [] { return true; };
  EXPECT_EQ(call({(root / "missing.toml").string()}, setting).code, 42);
  EXPECT_EQ(opened, root / "missing.toml");
}

TEST_F(Cli, AProgramAddsItsOwnSubCommands) {
  Setting setting;
  double distance = 0.0;
  setting.commands = {{"offset", "Offset one curve", [&](CLI::App& app) -> Job {
                         app.add_option("--distance", distance, "m")->required();
                         return [&](Session& session) -> base::Result<int> {
                           if (distance <= 0.0)
                             return base::Error{base::ErrorCode::InvalidOption, "the distance must be greater than 0"};
                           session.note("offset by " + base::number_text(distance));
                           return 0;
                         };
                       }}};
  EXPECT_EQ(call({"offset", "--distance", "2.5"}, setting).err, "fake: offset by 2.5\n");
  EXPECT_EQ(call({"offset", "--distance", "2.5", "--quiet"}, setting).err, "");
  const Outcome bad = call({"offset", "--distance", "-1"}, setting);
  EXPECT_EQ(bad.code, 3);
  EXPECT_EQ(bad.err, "fake: the distance must be greater than 0\n");
  EXPECT_EQ(call({"offset"}, setting).code, 2);
}

}  // namespace
}  // namespace dobra::cli
