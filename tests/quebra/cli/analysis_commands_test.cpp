#include "quebra/cli/analysis_commands.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "quebra/core/operations.h"
#include "shared/io/file.h"
#include "tests/support/command_line.h"
#include "tests/support/quebra_scenarios.h"

namespace quebra::cli {
namespace {

using Json = nlohmann::json;

class AnalysisCommands : public dobra::test::CommandLine {
 protected:
  AnalysisCommands() : CommandLine(core::program(), analysis_commands()) {}
  [[nodiscard]] std::string l_shape() const {
    return put("l.toml", "dobra = 1\nprogram = \"quebra\"\n" + test::sheared_l);
  }
  [[nodiscard]] bool exists(const std::string& name) const { return std::filesystem::exists(path(name)); }
};

TEST_F(AnalysisCommands, ALoopThatMissesItsTargetEndsWithOne) {
  const auto missed = call({"adapt", l_shape(), "--target", "1%", "--max-cycles", "1", "--json"});
  EXPECT_EQ(missed.code, 1) << missed.err;
  EXPECT_EQ(Json::parse(missed.out)["reached"], false);
  EXPECT_FALSE(Json::parse(missed.out)["remarks"].empty());
  const auto met = call({"adapt", l_shape(), "--target", "20%", "--json"});
  EXPECT_EQ(met.code, 0) << met.err;
  EXPECT_EQ(Json::parse(met.out)["reached"], true);
}

TEST_F(AnalysisCommands, AProbeThatMissesTheMaterialIsCalledByItsOption) {
  for (const char* const command : {"solve", "adapt"})
    refuses({command, l_shape(), "--probe", "1e3,-1e3"}, 3,
            {"--probe 1e3,-1e3: the point does not lie in the material"});
  refuses({"solve", l_shape(), "--probe", "1,x"}, 2, {"--probe 1,x"});
}

TEST_F(AnalysisCommands, OptionsOfMeshesAreThoseOfTheLoopToo) {
  const auto elements = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words{"adapt", l_shape(), "--target", "60%", "--json"};
    words.insert(words.end(), more.begin(), more.end());
    const auto done = call(words);
    EXPECT_EQ(done.code, 0) << done.err;
    return Json::parse(done.out)["quantities"]["elements"]["value"].get<double>();
  };
  const double few = elements({});
  EXPECT_GT(elements({"--size", "8"}), 2.0 * few);
  EXPECT_GT(elements({"--size-formula", "4 + 0.1 * x"}), 2.0 * few);
  refuses({"adapt", l_shape(), "--size-formula", "x - 50"}, 3, {"size_formula", "greater than 0"});
  refuses({"adapt", l_shape(), "--engine", "magic"}, 2, {"--engine"});
  refuses({"adapt", l_shape(), "--size", "0"}, 3, {"--size", "greater than 0"});
}

TEST_F(AnalysisCommands, ALoopWithoutAStepOfItsOwnObeysTheMeshStep) {
  const std::string example = DOBRA_SOURCE_DIR "/resources/examples/quebra/edge_crack.toml";
  const auto met = call({"adapt", example, "--target", "2%", "--json"});
  ASSERT_EQ(met.code, 0) << met.err;
  EXPECT_EQ(Json::parse(met.out)["quantities"]["cycles"]["value"], 1);  // five without rosettes
  EXPECT_NE(met.err.find("the loop takes size, order, rosettes of step 2 (mesh)"), std::string::npos) << met.err;
  // Options win.
  const auto coarse = call({"adapt", example, "--target", "50%", "--size", "0.5", "--json"});
  const auto fine = call({"adapt", example, "--target", "50%", "--json"});
  const auto elements = [](const auto& done) {
    return Json::parse(done.out)["quantities"]["elements"]["value"].template get<double>();
  };
  EXPECT_LT(elements(coarse), elements(fine));
  // A step of the loop's own says all.
  const std::string own = put(
      "own.toml", "dobra = 1\nprogram = \"quebra\"\n" + test::sheared_l +
                      "[[step]]\noperation = \"mesh\"\nsize = 2.0\n[[step]]\noperation = \"adapt\"\ntarget = 60.0\n");
  const auto done = call({"adapt", own, "--json"});
  EXPECT_EQ(done.err.find("the loop takes"), std::string::npos) << done.err;
  EXPECT_LT(elements(done), 500.0);
}

TEST_F(AnalysisCommands, ATipWithoutKEndsWithOneAndLeavesTheOthersTheirs) {
  const std::string plate = put("plate.toml", R"(dobra = 1
program = "quebra"
[input]
[[input.curve]]
name = "bottom"
points = [[0.0, 0.0], [4.0, 0.0]]
[[input.curve]]
name = "rest"
points = [[4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [0.0, 0.0]]
[[input.curve]]
name = "seam"
role = "internal"
points = [[2.5, 0.0], [2.5, 4.0]]
[[input.crack]]
name = "edge"
points = [[0.0, 2.5], [1.0, 2.5]]
[[input.crack]]
name = "other"
points = [[4.0, 1.5], [2.5, 1.5]]
[[input.region]]
name = "strip"
point = [3.9, 0.1]
[[step]]
operation = "problem"
[[step.material]]
young = 1.0
[[step.material]]
region = "strip"
young = 2.0
[[step.support]]
where = "bottom"
x = 0.0
y = 0.0
[[step.load]]
where = "edge_left"
kind = "pressure"
value = 1.0
[[step.load]]
where = "edge_right"
kind = "pressure"
value = 1.0
)");
  const std::string crack = "[[step]]\noperation = \"crack\"\n";
  const std::string whole =
      put("whole.toml",
          text("plate.toml") +
              "[[step]]\noperation = \"mesh\"\norder = \"2\"\nrosettes = \"yes\"\n[[step]]\noperation = \"analyse\"\n" +
              crack);
  const std::string loop = put(
      "loop.toml", text("plate.toml") + "[[step]]\noperation = \"adapt\"\nrosettes = \"yes\"\ntarget = 50.0\n" + crack);
  for (const std::string& file : {plate, loop}) {
    const auto done = call({"crack", file, "--json"});
    EXPECT_EQ(done.code, 1) << done.err;
    const Json json = Json::parse(done.out);
    EXPECT_EQ(json["reached"], false);
    EXPECT_GT(json["quantities"]["tip.load.edge_end.K_I"]["value"], 0.0);
    ASSERT_EQ(json["tips"].size(), 2u);
    EXPECT_GT(json["tips"][0]["K_I [Pa sqrt(m)]"], 0.0);
    EXPECT_FALSE(json["tips"][0].contains("reason"));
    const Json& refused = json["tips"][1];
    EXPECT_EQ(refused["tip"], "other_end");
    EXPECT_EQ(refused["x [m]"], 2.5);
    EXPECT_NE(refused["reason"].get<std::string>().find("two materials meet at the tip"), std::string::npos);
    EXPECT_EQ(refused.size(), 5u) << refused;  // case, tip, x, y, reason
    EXPECT_NE(done.err.find("crack tip 'other_end' at (2.5, 1.5) has no K: two materials meet"), std::string::npos)
        << done.err;
  }
  const auto ran = call({"run", whole, "--out", path("out"), "--pictures", "none", "--json"});
  EXPECT_EQ(ran.code, 1) << ran.err;
  EXPECT_EQ(Json::parse(ran.out)["reached"], false);
  EXPECT_NE(text("out/tips.csv").find("two materials meet at the tip"), std::string::npos);
  EXPECT_EQ(call({"adapt", loop, "--json"}).code, 0);  // no K asked for
}

TEST_F(AnalysisCommands, RunAndSolveEndWithOneTooIfALoopMissesItsTarget) {
  const auto scenario = [&](double target) {
    return put("loop.toml", "dobra = 1\nprogram = \"quebra\"\n" + test::sheared_l +
                                "[[step]]\noperation = \"adapt\"\nmax_cycles = 1\ntarget = " + std::to_string(target) +
                                "\n");
  };
  for (const std::string command : {"run", "solve"}) {
    const auto words = [&](const std::string& file) {
      return command == "run"
                 ? std::vector<std::string>{"run", file, "--out", path("out"), "--pictures", "none", "--json"}
                 : std::vector<std::string>{"solve", file, "--json"};
    };
    const auto missed = call(words(scenario(1.0)));
    EXPECT_EQ(missed.code, 1) << missed.err;
    EXPECT_EQ(Json::parse(missed.out)["reached"], false);
    const auto met = call(words(scenario(50.0)));
    EXPECT_EQ(met.code, 0) << met.err;
    EXPECT_EQ(Json::parse(met.out)["reached"], true);
  }
}

TEST_F(AnalysisCommands, ALoopThatMissesIsNotForgivenByAnEasierOneButByGoingOn) {
  const auto ends_with = [&](const std::string& second) {
    const std::string loop = "[[step]]\noperation = \"adapt\"\n";
    return call({"run",
                 put("twice.toml", "dobra = 1\nprogram = \"quebra\"\n" + test::sheared_l + loop +
                                       "max_cycles = 1\ntarget = 5.0\n" + loop + second),
                 "--out", path("out"), "--pictures", "none", "--json"});
  };
  EXPECT_EQ(ends_with("target = 50.0\n").code, 1);
  for (const char* const target : {"5.0", "50.0"}) {  // with more cycles, and without
    const auto on = ends_with(std::string("target = ") + target + "\nfrom = \"last\"\n");
    EXPECT_EQ(on.code, 0) << target;
    EXPECT_EQ(Json::parse(on.out)["remarks"].dump().find("above the 5 % asked for"), std::string::npos) << target;
  }
}

TEST_F(AnalysisCommands, AKnownEnergyTellsTheEffectivityOfEveryCycle) {
  const auto told = call({"adapt", l_shape(), "--target", "5%", "--exact-energy", "60.619", "--json"});
  ASSERT_EQ(told.code, 0) << told.err;
  const Json json = Json::parse(told.out);
  ASSERT_GT(json["analyses"].size(), 1u);
  for (const Json& row : json["analyses"]) {
    const double error = std::sqrt(2.0 * (60.619 - row["energy [J]"].get<double>()));
    EXPECT_NEAR(row["true error [J^0.5]"].get<double>(), error, 1e-9);
    EXPECT_NEAR(row["effectivity"].get<double>(), 1.0, 0.25);
  }
  EXPECT_EQ(json["quantities"]["case.load.effectivity"]["value"], json["analyses"].back()["effectivity"]);
  const auto plain = call({"adapt", l_shape(), "--target", "5%", "--exact-energy", "60.619"});
  EXPECT_NE(plain.out.find("effectivity"), std::string::npos);
  const auto wrong = call({"adapt", l_shape(), "--target", "5%", "--exact-energy", "6.0619", "--json"});
  EXPECT_NE(Json::parse(wrong.out)["remarks"].dump().find("is above the exact one given"), std::string::npos);
  refuses({"adapt", l_shape(), "--exact-energy", "1", "--exact-energy", "2"}, 3, {"2 values for 1 load cases"});
  refuses({"adapt", l_shape(), "--line", "10,60,40,60"}, 2, {"--line", "--out FILE.csv, or --json"});
}

TEST_F(AnalysisCommands, EveryLoadCaseHasItsRowsInTheTableOfCycles) {
  const std::string two = put("two.toml", "dobra = 1\nprogram = \"quebra\"\n" + test::sheared_l +
                                              "[[step.load]]\nwhere = \"right\"\ny = 20.0\ncase = \"twice\"\n");
  const auto loop = [&](const std::vector<std::string>& energies) {
    std::vector<std::string> words{"adapt", two, "--target", "5%", "--json"};
    for (const std::string& energy : energies) words.insert(words.end(), {"--exact-energy", energy});
    return call(words);
  };
  const auto told = loop({"60.619", "242.476"});
  ASSERT_EQ(told.code, 0) << told.err;
  const Json rows = Json::parse(told.out)["analyses"];
  ASSERT_GT(rows.size(), 2u);
  ASSERT_EQ(rows.size() % 2, 0u);
  for (std::size_t i = 0; i < rows.size(); i += 2) {  // the same problem, loaded twice as much
    const Json &once = rows[i], &twice = rows[i + 1];
    EXPECT_EQ(once["case"], "load");
    EXPECT_EQ(twice["case"], "twice");
    EXPECT_EQ(once["cycle"], twice["cycle"]);
    const auto number = [](const Json& row, const char* key) { return row[key].get<double>(); };
    EXPECT_NEAR(number(twice, "energy [J]") / number(once, "energy [J]"), 4.0, 1e-9);
    EXPECT_NEAR(number(once, "true error [J^0.5]"), std::sqrt(2.0 * (60.619 - number(once, "energy [J]"))), 1e-9);
    EXPECT_NEAR(number(twice, "true error [J^0.5]") / number(once, "true error [J^0.5]"), 2.0, 1e-6);
    EXPECT_NEAR(number(twice, "effectivity") / number(once, "effectivity"), 1.0, 1e-6);
    EXPECT_NEAR(number(twice, "eta [%]") / number(once, "eta [%]"), 1.0, 1e-9);
  }
  const auto one = loop({"0", "242.476"});
  ASSERT_EQ(one.code, 0) << one.err;
  const Json some = Json::parse(one.out);
  EXPECT_FALSE(some["analyses"][0].contains("effectivity"));
  EXPECT_EQ(some["analyses"][1]["effectivity"], rows[1]["effectivity"]);
  EXPECT_NE(some["remarks"].dump().find("load case 'load': its exact energy is not given"), std::string::npos)
      << some["remarks"];
  EXPECT_EQ(some["remarks"].dump().find("load case 'twice'"), std::string::npos);
  refuses({"adapt", two, "--exact-energy", "1"}, 3,
          {"1 values for 2 load cases", "load, twice", "0 where it is not known"});
  refuses({"adapt", two, "--exact-energy", "0", "--exact-energy", "0"}, 3, {"for every load case"});
  refuses({"adapt", two, "--exact-energy", "1", "--exact-energy=-1"}, 3, {"load case 'twice'", "less than 0"});
}

TEST_F(AnalysisCommands, TheCurveAndAnyCycleAreDrawn) {
  const auto drawn = call({"adapt", l_shape(), "--target", "10%", "--curve", path("curve.svg"), "--picture",
                           path("first.svg"), "--cycle", "1"});
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_NE(text("curve.svg").find("</svg>"), std::string::npos);
  EXPECT_NE(text("first.svg").find("</svg>"), std::string::npos);
  refuses({"adapt", l_shape(), "--cycle", "1"}, 2, {"--cycle", "give --picture FILE"});
  refuses({"adapt", l_shape(), "--curve", path("curve.xyz")}, 2, {"curve.xyz", ".svg, .pdf or .png"});
  refuses({"adapt", l_shape(), "--target", "20%", "--picture", path("none.svg"), "--cycle", "9"}, 3,
          {"there is no cycle 9"});
  EXPECT_FALSE(exists("none.svg"));
}

TEST_F(AnalysisCommands, ALineAndAProbeAreRead) {
  const std::string scenario = l_shape();
  const auto read = call({"adapt", scenario, "--target", "20%", "--line", "10,60,40,60", "--samples", "4", "--out",
                          path("line.csv"), "--probe", "10,60", "--json"});
  ASSERT_EQ(read.code, 0) << read.err;
  const Json json = Json::parse(read.out);
  ASSERT_EQ(json["line_command"].size(), 4u);
  EXPECT_EQ(json["line_command"][0]["u_x [m]"], json["quantities"]["probe.1.load.u_x"]["value"]);
  const std::string lines = text("line.csv");
  EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 5);
  const auto partly =
      call({"adapt", scenario, "--target", "20%", "--line", "-30,60,10,60", "--samples", "5", "--json"});
  ASSERT_EQ(partly.code, 0) << partly.err;
  const Json some = Json::parse(partly.out);
  const std::string remark = "line 'command': points outside the material are left out: 3 of 5";
  EXPECT_EQ(some["line_command"].size(), 2u);
  EXPECT_NE(some["remarks"].dump().find(remark), std::string::npos);
  EXPECT_NE(partly.err.find(remark), std::string::npos) << partly.err;
  EXPECT_EQ(json["remarks"].dump().find("outside the material"), std::string::npos);
  refuses({"adapt", scenario, "--out", path("line2.csv")}, 2, {"--line"});
  refuses({"adapt", scenario, "--probe", "10"}, 2, {"--probe 10", "x,y"});
}

/// A plate under tension with an edge crack, without any step behind its problem.
const std::string cracked = R"(dobra = 1
program = "quebra"
[input]
specimen = "single_edge_notch"
width = 1.0
height = 3.0
crack_length = 0.5
[[input.point]]
name = "anchor"
point = [1.0, 0.0]
[[input.point]]
name = "guide"
point = [1.0, -1.5]
[[step]]
operation = "problem"
[[step.material]]
young = 1.0
[[step.support]]
where = "anchor"
x = 0.0
y = 0.0
[[step.support]]
where = "guide"
x = 0.0
[[step.load]]
where = "top"
y = 1.0
[[step.load]]
where = "bottom"
y = -1.0
)";
std::string step(const std::string& operation, const std::string& params = "") {
  return "[[step]]\noperation = \"" + operation + "\"\n" + params;
}

TEST_F(AnalysisCommands, StepsThatACommandStandsOnAreAddedAndTold) {
  const std::string mesh = step("mesh", "size = 0.3\n"), analyse = step("analyse");
  struct Case {
    std::string command, steps, told;
  };
  for (const Case& own : std::vector<Case>{{"crack", mesh + step("crack"), "added: analyse"},
                                           {"crack", step("crack"), "added: analyse"},
                                           {"crack", mesh, "added: analyse, crack"},
                                           {"solve", "", "added: mesh, of the second order, analyse"},
                                           {"solve", mesh + step("crack"), "step 3 (crack) left out; added: analyse"},
                                           {"solve", analyse, "added: mesh, of the second order"}}) {
    const std::string file = put("plate.toml", cracked + own.steps);
    const auto done = call({own.command, file, "--json"});
    EXPECT_EQ(done.code, 0) << own.command << own.steps << done.err;
    EXPECT_NE(done.err.find("of the steps of " + file + ": " + own.told), std::string::npos) << done.err;
    if (done.code == 0 && own.command == "crack") {
      EXPECT_NEAR(Json::parse(done.out)["quantities"]["tip.load.crack_end.K_I"]["value"].get<double>(), 3.5425, 0.02);
    }
  }
  // A file that has them all is run as it stands.
  const auto whole = call({"solve", put("whole.toml", cracked + mesh + analyse), "--json"});
  EXPECT_EQ(whole.code, 0);
  EXPECT_EQ(whole.err.find("of the steps"), std::string::npos) << whole.err;
  // Materials and loads cannot be guessed.
  const std::string none = put("none.toml", "dobra = 1\nprogram = \"quebra\"\n[input]\nspecimen = \"l_shape\"\n");
  for (const std::string command : {"solve", "crack", "adapt"})
    refuses({command, none}, 3, {"none.toml", "no step 'problem'"});
}

TEST_F(AnalysisCommands, AMeshThatIsAddedHoldsWhatElementsOfTheFirstOrderDoNot) {
  for (const std::string poisson : {"0.3", "0.49", "0.4999999"}) {
    const std::string file =
        put("bar.toml", "dobra = 1\nprogram = \"quebra\"\n[input]\nspecimen = \"l_shape\"\n" +
                            step("problem", "state = \"strain\"\n[[step.material]]\nyoung = 1.0\npoisson = " + poisson +
                                                "\n[[step.support]]\nwhere = \"bottom\"\nx = 0.0\ny = "
                                                "0.0\n[[step.load]]\nwhere = \"right\"\ny = 1.0\n"));
    const auto done = call({"solve", file, "--json"});
    EXPECT_EQ(done.code, 0) << poisson << done.err;
    EXPECT_EQ(done.out.find("analysis.inp"), std::string::npos) << poisson;  // that no file of this command
    // Who asks for the first order is refused as before.
    const auto first =
        call({"solve", put("first.toml", *dobra::io::read_text(file) + step("mesh", "size = 20.0\norder = \"1\"\n"))});
    EXPECT_EQ(first.code == 0, poisson == "0.3") << poisson << first.err;
  }
}

TEST_F(AnalysisCommands, ProbesAndLinesOfTheFileArePrinted) {
  const std::string mesh = step("mesh", "size = 0.3\n"), analyse = step("analyse");
  const std::string probe = step("probe", "label = \"mine\"\nat = [0.75, 0.0]\n") +
                            step("line", "label = \"ahead\"\nfrom = [0.5, 0.0]\nto = [1.0, 0.0]\ncount = 3\n");
  for (const std::string& steps : {mesh + analyse + probe, mesh + probe, probe, mesh + analyse + step("view") + probe,
                                   mesh + analyse + probe + step("crack")}) {
    const std::string file = put("plate.toml", cracked + steps);
    for (const std::string command : {"solve", "crack"}) {
      const auto done = call({command, file, "--json", "--probe", "0.75,0"});
      ASSERT_EQ(done.code, 0) << done.err << steps;
      const Json json = Json::parse(done.out);
      EXPECT_EQ(json["quantities"]["probe.mine.load.u_y"], json["quantities"]["probe.1.load.u_y"]) << steps;
      EXPECT_EQ(json["line_ahead"].size(), 3u) << steps;
    }
  }
}

TEST_F(AnalysisCommands, ABookOfOnesOwnIsJudgedAndAWrongExpectationEndsWithOne) {
  std::filesystem::create_directory(path("book"));
  const auto book = [&](const std::string& value) {
    const std::string file = put("book/a.toml", "dobra = 1\nprogram = \"quebra\"\n" + test::sheared_l +
                                                    "[[expect]]\nname = 'curves of \"L\"'\nsource = \"counted\"\n"
                                                    "quantity = \"curves\"\nvalue = " +
                                                    value + "\n");
    return call({"validate", std::filesystem::path(file).parent_path().string(), "--json"});
  };
  const auto right = book("6");
  EXPECT_EQ(right.code, 0) << right.err;
  EXPECT_EQ(Json::parse(right.out)[0]["case"], "curves of \"L\"");
  const auto wrong = book("7");
  EXPECT_EQ(wrong.code, 1) << wrong.err;
  EXPECT_EQ(Json::parse(wrong.out)[0]["met"], false);
  EXPECT_EQ(Json::parse(wrong.out)[0]["value"], 6.0);
  refuses({"validate", path("no_book")}, 3, {"no_book", "No such file"});
}

}  // namespace
}  // namespace quebra::cli
