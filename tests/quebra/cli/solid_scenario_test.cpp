// `quebra solid` with scenarios and with --cut: what is refused, with its line; planes that miss and touch; then trees
// and sections whose figures are known otherwise.

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "quebra/cli/mesh_command.h"
#include "quebra/cli/solid_command.h"
#include "quebra/core/operations.h"
#include "quebra/solids/steps.h"
#include "tests/support/command_line.h"

namespace quebra::cli {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string solids_head = "dobra = 1\nprogram = \"quebra\"\n[input]\nsolids = true\n";

std::string step(const std::string& operation, const std::string& part, const std::string& rest) {
  return fmt::format("[[step]]\noperation = \"{}\"\npart = \"{}\"\n{}\n", operation, part, rest);
}
std::string block(const std::string& part, const std::string& at, const std::string& size) {
  return step("block", part, fmt::format("at = {}\nsize = {}", at, size));
}

class SolidScenario : public dobra::test::CommandLine {
 protected:
  SolidScenario() : CommandLine(core::program(), {solid_command(), mesh_command()}) {}

  [[nodiscard]] json told(std::vector<std::string> args, int code = 0) const {
    args.insert(args.begin(), "solid");
    args.emplace_back("--json");
    const auto outcome = call(args);
    EXPECT_EQ(outcome.code, code) << outcome.err;
    return json::parse(outcome.out, nullptr, false);
  }
  [[nodiscard]] json refused(const std::string& text) const {
    const json all = told({put("bad.toml", text)}, 3);
    EXPECT_EQ(all["findings"].size(), 1U) << all;
    return all["findings"].empty() ? json() : all["findings"][0];
  }
};

TEST_F(SolidScenario, RecursionIsRefusedWithItsLine) {
  const json own = refused(solids_head + block("a", "[0,0,0]", "[1,1,1]") + step("unite", "b", "of = [\"a\", \"b\"]"));
  EXPECT_THAT(own["message"].get<std::string>(), HasSubstr("recursion: part 'b' is made of itself"));
  EXPECT_EQ(own["place"]["line"], 13);
  const json three = refused(solids_head + step("unite", "a", "of = [\"c\"]") + step("unite", "b", "of = [\"a\"]") +
                             step("unite", "c", "of = [\"b\"]"));
  EXPECT_THAT(three["message"].get<std::string>(), HasSubstr("'a' of 'c' of 'b' of 'a'"));
  EXPECT_EQ(three["place"]["line"], 8);
}

TEST_F(SolidScenario, NamesThatAreUnknownTwiceOrLaterAreRefusedWithTheirLine) {
  const json later = refused(solids_head + step("unite", "b", "of = [\"a\"]") + block("a", "[0,0,0]", "[1,1,1]"));
  EXPECT_THAT(later["message"].get<std::string>(), HasSubstr("made only by step 2"));
  EXPECT_EQ(later["place"]["line"], 8);
  const json unknown =
      refused(solids_head + block("rock", "[0,0,0]", "[1,1,1]") + step("unite", "b", "of = [\"rok\"]"));
  EXPECT_THAT(unknown["message"].get<std::string>(), HasSubstr("did you mean 'rock'"));
  EXPECT_EQ(unknown["place"]["line"], 10);
  const json twice = refused(solids_head + block("a", "[0,0,0]", "[1,1,1]") + block("a", "[0,0,0]", "[1,1,1]"));
  EXPECT_THAT(twice["message"].get<std::string>(), HasSubstr("two parts are called 'a'"));
}

TEST_F(SolidScenario, BadShapesAndInputsAreRefused) {
  EXPECT_THAT(refused(solids_head + block("a", "[0,0,0]", "[1,-1,1]"))["message"].get<std::string>(),
              HasSubstr("second number of size"));
  EXPECT_THAT(refused(solids_head)["message"].get<std::string>(), HasSubstr("makes no parts"));
  EXPECT_THAT(
      refused("dobra = 1\nprogram = \"quebra\"\n" + block("a", "[0,0,0]", "[1,1,1]"))["message"].get<std::string>(),
      HasSubstr("solids = true"));
  EXPECT_THAT(
      refused(solids_head + step("place", "b", "of = [\"a\"]\nmatrix = [1, 0, 0, 0]"))["message"].get<std::string>(),
      HasSubstr("no step before"));
  EXPECT_THAT(refused(solids_head + step("sweep", "s",
                                         "points = [[-1,-1],[1,-1],[1,1],[-1,1]]\n"
                                         "path = [[0,0,0],[9,0,0],[9,1,0],[0,1,0]]"))["message"]
                  .get<std::string>(),
              HasSubstr("folds at its point 3"));
  const std::string good = put("good.toml", solids_head + block("a", "[0,0,0]", "[1,1,1]"));
  EXPECT_THAT(told({good, "--part", "b"}, 3)["findings"][0]["message"].get<std::string>(), HasSubstr("no part 'b'"));
  // A domain is needed by what works on one.
  const auto outcome = call({"mesh", good});
  EXPECT_NE(outcome.code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("put a step `cut` before it"));
}

TEST_F(SolidScenario, PlanesThatAreNoneAreRefused) {
  const std::string file = put("a.toml", solids_head + block("a", "[0,0,0]", "[1,1,1]"));
  EXPECT_EQ(told({file, "--cut", "0,0,1"}, 2)["findings"][0]["code"], "bad_usage");
  EXPECT_EQ(told({file, "--cut", "0,0,x,1"}, 2)["findings"][0]["code"], "bad_usage");
  EXPECT_EQ(told({file, "--cut", "0,0,0,1"}, 2)["findings"][0]["code"], "bad_usage");
  EXPECT_EQ(call({"solid", file, "--cut", "0,0,1,0", "--out", path("x.obj")}).code, 2);
}

TEST_F(SolidScenario, APlaneThatMissesOrTouchesGivesNothingAndSaysSo) {
  const std::string file = put("a.toml", solids_head + block("a", "[0,0,0]", "[1,1,1]"));
  const std::string out = path("none.toml");
  for (const auto& [plane, code] : std::vector<std::pair<std::string, std::string>>{{"0,0,1,-3", "cut_misses"},
                                                                                    {"1,1,1,-3", "cut_touches_vertex"},
                                                                                    {"1,1,0,-2", "cut_touches_edge"},
                                                                                    {"0,0,1,0", "cut_touches_face"}}) {
    const json all = told({file, "--cut", plane, "--out", out});
    ASSERT_EQ(all["findings"].size(), 1U) << all;
    EXPECT_EQ(all["findings"][0]["code"], code);
    EXPECT_EQ(all["cut"]["area"], 0.0);
    EXPECT_FALSE(std::filesystem::exists(out));
  }
  EXPECT_EQ(told({file, "--cut", "0,0,1,-1"})["findings"][0]["code"], "cut_in_face");
}

TEST_F(SolidScenario, AFaceInThePlaneIsToldByTheOptionAndByTheStep) {
  const std::string stairs = solids_head + block("low", "[0,0,0]", "[1,1,1]") + block("high", "[1,0,0]", "[1,1,2]") +
                             step("unite", "all", "of = [\"low\", \"high\"]");
  const std::string file = put("stairs.toml", stairs);
  EXPECT_EQ(told({file, "--cut", "0,0,1,-1"})["findings"][0]["code"], "cut_in_face");
  EXPECT_EQ(told({file, "--cut", "0,0,1,-1.5"})["findings"].size(), 0U);
  for (const auto& [plane, in_face] : std::vector<std::pair<std::string, bool>>{{"-1", true}, {"-1.5", false}}) {
    const std::string cut = put("cut.toml", stairs + "[[step]]\noperation = \"cut\"\nplane = [0, 0, 1, " + plane +
                                                "]\n[[step]]\noperation = \"mesh\"\nsize = 0.5\n");
    const auto outcome = call({"mesh", cut});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err.find("the plane lies in a face") != std::string::npos, in_face) << outcome.err;
  }
}

TEST_F(SolidScenario, FacesOfAFileThatCoverEachOtherAreToldOnce) {
  // A tetrahedron, and one on the other side of its face in the plane x = 0; a place moves both.
  (void)put("both.obj",
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv -1 0 0\n"
            "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\nf 1 3 4\nf 1 5 3\nf 1 4 5\nf 3 5 4\n");
  const json both = told({put("both.toml", solids_head + step("solid_file", "both", "file = \"both.obj\"") +
                                               step("place", "moved", "of = [\"both\"]\nby = [2, 0, 0]"))});
  EXPECT_NEAR(both["volume"], 1.0 / 3.0, 1e-15);
  ASSERT_EQ(both["findings"].size(), 1U) << both;
  EXPECT_EQ(both["findings"][0]["code"], "part_remark");
  EXPECT_THAT(
      both["findings"][0]["message"].get<std::string>(),
      testing::AllOf(testing::HasSubstr("part 'both': faces 3 and 4 cover each other"), testing::HasSubstr("at (0, ")));
}

TEST_F(SolidScenario, ASectionIsADomainThatIsMeshed) {
  // Two arms, one of which a bore passes, in two materials.
  const std::string text =
      solids_head + block("base", "[0,0,0]", "[10,4,2]") + block("arm", "[0,0,2]", "[3,4,4]") +
      step("place", "far", "of = [\"arm\"]\nby = [7, 0, 0]") +
      step("cylinder", "bore", "at = [1.5, -1, 4]\naxis = [0, 1, 0]\nradius = 0.5\nheight = 6\nsegments = 24") +
      step("group", "all", "of = [\"base\", \"arm\", \"far\"]") + step("subtract", "frame", "of = [\"all\", \"bore\"]");
  const std::string file = put("frame.toml", text);
  const json across = told({file, "--cut", "0,-1,0,2", "--out", path("domain.toml")});
  ASSERT_EQ(across["findings"].size(), 1U) << across;  // the corners of the bore were rounded
  EXPECT_EQ(across["findings"][0]["code"], "part_remark");
  const double bore = 12 * 0.25 * std::sin(2 * M_PI / 24);
  EXPECT_NEAR(across["cut"]["area"], 20 + 24 - bore, 1e-12);
  EXPECT_EQ(across["cut"]["pieces"], 3);
  EXPECT_EQ(across["cut"]["holes"], 1);
  EXPECT_EQ(across["cut"]["regions"], json({"arm", "base"}));
  EXPECT_NEAR(across["volume"], 4 * (20 + 24 - bore), 1e-12);
  const auto meshed = call({"mesh", path("domain.toml"), "--size", "0.5", "--json"});
  ASSERT_EQ(meshed.code, 0) << meshed.err;
  EXPECT_NEAR(json::parse(meshed.out)["area"], 20 + 24 - bore, 1e-9);
  const std::string domain = this->text("domain.toml");
  for (const char* const name :
       {"\"bore_side", "\"base_bottom\"", "\"base_right\"", "\"arm_left", "role = \"internal\""})
    EXPECT_THAT(domain, HasSubstr(name));
  // Level through both arms: two pieces apart.
  const json level = told({file, "--cut", "0,0,1,-5", "--out", path("level.toml")});
  EXPECT_EQ(level["cut"]["pieces"], 2);
  EXPECT_EQ(level["cut"]["area"], 24.0);
  EXPECT_EQ(call({"mesh", path("level.toml"), "--size", "0.5"}).code, 0);
}

TEST_F(SolidScenario, FilesAreCutByTheirNames) {
  const std::string cube =
      "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 2 2 0\nv 0 0 2\nv 2 0 2\nv 0 2 2\nv 2 2 2\n"
      "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
  const std::string block = put("rock.obj", cube);
  const std::string bore = put("bore.obj", cube);
  const json cut = told({block, "--subtract", bore, "--place", "0.25,0,0,0.5,0,0.25,0,0.5,0,0,2,-1,0,0,0,1", "--cut",
                         "0,0,1,-1", "--out", path("cut.toml")});
  EXPECT_EQ(cut["cut"]["area"], 3.75);
  EXPECT_EQ(cut["cut"]["holes"], 1);
  EXPECT_THAT(text("cut.toml"), HasSubstr("name = \"bore\""));
  EXPECT_THAT(text("cut.toml"), HasSubstr("name = \"rock\""));
}

TEST_F(SolidScenario, LoftsAreRefusedWhereProfilesDoNotFollowEachOther) {
  const auto loft = [](const std::string& at) {
    return solids_head + step("loft", "f",
                              "[[step.profile]]\npoints = [[-2,-2],[2,-2],[2,2],[-2,2]]\n"
                              "[[step.profile]]\npoints = [[-1,-1],[1,-1],[1,1],[-1,1]]\nat = " +
                                  at);
  };
  EXPECT_THAT(refused(loft("[0, 0, 0]"))["message"].get<std::string>(), HasSubstr("not in front of profile 1"));
  EXPECT_THAT(refused(solids_head + step("loft", "f", "[[step.profile]]\npoints = [[0,0],[1,0],[0,1]]"))["message"]
                  .get<std::string>(),
              HasSubstr("two profiles or more"));
  const json frustum = told({put("loft.toml", loft("[0, 0, 3]"))});
  EXPECT_EQ(frustum["volume"], 28.0);
  EXPECT_EQ(frustum["faces"], 6);
}

TEST_F(SolidScenario, REP_d_AreasOfSpecimensFollowTheirSizes) {
  constexpr double pi = std::numbers::pi;
  const std::vector<std::pair<std::string, double>> cases{
      {"plate_with_hole\"\nwidth = 8\nheight = 6\nradius = 1.5", 48.0 - 2.25 * pi},
      {"compact_tension\"\nwidth = 60\ncrack_length = 20", 1.25 * 1.2 * 60 * 60 - 2.0 * 7.5 * 7.5 * pi},
      {"three_point_bend\"\nwidth = 10\nheight = 2\ncrack_length = 0.5", 20.0},
      {"double_cantilever\"\nwidth = 50\nheight = 8\ncrack_length = 30", 400.0}};
  for (const auto& [specimen, area] : cases) {
    const auto meshed =
        call({"mesh", put("specimen.toml", "dobra = 1\nprogram = \"quebra\"\n[input]\nspecimen = \"" + specimen + "\n"),
              "--order", "2", "--json"});
    ASSERT_EQ(meshed.code, 0) << meshed.err;
    // Arcs are meshed with parabolic sides.
    EXPECT_NEAR(json::parse(meshed.out)["area"], area, 5e-5 * area) << specimen;
  }
}

TEST_F(SolidScenario, REP_d_AGroupOfGroupsMovesAsOne) {
  const std::string text = solids_head +
                           step("extrude", "plate",
                                "points = [[0,0],[6,0],[6,5],[0,5]]\nby = [0,0,2]\n"
                                "[[step.hole]]\npoints = [[1,1],[2,1],[2,2],[1,2]]") +
                           block("pin", "[1,1,-1]", "[1,1,4]") + step("group", "gauge", "of = [\"plate\", \"pin\"]") +
                           block("anvil", "[0,-1,0]", "[6,1,2]") + step("group", "rig", "of = [\"gauge\", \"anvil\"]") +
                           step("place", "moved", "of = [\"rig\"]\nturn = 90\nby = [100, 0, 0]");
  const std::string file = put("rig.toml", text);
  const double volume = 29.0 * 2 + 4.0 + 12.0;  // the plate without its hole, the pin in it, the anvil
  EXPECT_EQ(told({file, "--part", "rig"})["volume"], volume);
  EXPECT_EQ(told({file})["volume"], volume);
  // All bodies are where the matrix puts them: (x, y) to (100 - y, x).
  const json section = told({file, "--cut", "0,0,1,-0.5"});
  EXPECT_EQ(section["cut"]["area"], 30.0 + 6.0);
  EXPECT_EQ(section["cut"]["regions"].size(), 3U);
  const json where = told({file, "--intersect", put("box.toml", solids_head + block("b", "[95,0,0]", "[6,6,2]"))});
  EXPECT_EQ(where["volume"], volume - 2.0);  // of the pin, what stands out at both ends
}

TEST_F(SolidScenario, TheTreeGivesWhatItsStepsSay) {
  const std::string tree = solids_head + block("a", "[0,0,0]", "[4,4,4]") + block("b", "[1,1,-1]", "[1,1,6]") +
                           step("place", "c", "of = [\"b\"]\nturn = 90\nabout = [2, 2, 2]\nturn_axis = [1, 0, 0]") +
                           step("unite", "bars", "of = [\"b\", \"c\"]") +
                           step("subtract", "rest", "of = [\"a\", \"bars\"]") +
                           step("intersect", "inside", "of = [\"a\", \"bars\"]");
  const std::string file = put("tree.toml", tree);
  const double rest = told({file, "--part", "rest"})["volume"];
  const json inside = told({file});
  EXPECT_EQ(rest + inside["volume"].get<double>(), 64.0);
  // b is [1, 2] x [1, 2] x z, c the same along y at z in [1, 2]; both are in a for 4 of length, and meet in a cube.
  EXPECT_EQ(inside["volume"], 4.0 + 4.0 - 1.0);
  // As operands of options too, moved by a matrix.
  const json both = told({file, "--part", "a", "--unite", file, "--place", "1,0,0,100,0,1,0,0,0,0,1,0,0,0,0,1"});
  EXPECT_EQ(both["volume"], 64.0 + 7.0);
}

TEST_F(SolidScenario, AnEditComputesItsPathAlone) {
  const auto tree = [](const std::string& size) {
    return solids_head + block("edit_a", "[0,0,0]", size) + block("edit_b", "[1,1,1]", "[5,5,5]") +
           block("edit_c", "[2,2,2]", "[1,1,9]") + step("unite", "edit_bc", "of = [\"edit_b\", \"edit_c\"]") +
           step("subtract", "edit_all", "of = [\"edit_bc\", \"edit_a\"]");
  };
  ASSERT_EQ(call({"solid", put("edit.toml", tree("[2,2,2]"))}).code, 0);
  EXPECT_EQ(solids::computed_last(), 1U);  // the last operation
  ASSERT_EQ(call({"solid", put("edit.toml", tree("[2,2,2]"))}).code, 0);
  EXPECT_EQ(solids::computed_last(), 0U);
  const json edited = told({put("edit.toml", tree("[3,2,2]"))});
  EXPECT_EQ(edited["volume"], 125.0 + 5.0 - 2.0);
}

}  // namespace
}  // namespace quebra::cli
