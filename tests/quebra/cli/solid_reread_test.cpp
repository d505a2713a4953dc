// What `quebra solid` writes it reads: results of curved solids at odd angles in every format; bodies that overlap, in
// every operation that takes them; faces that are not plane. Usage that is wrong has its finding too.

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "quebra/cli/solid_command.h"
#include "quebra/core/operations.h"
#include "tests/support/command_line.h"

namespace quebra::cli {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

class SolidReread : public dobra::test::CommandLine {
 protected:
  SolidReread() : CommandLine(core::program(), {solid_command()}) {}

  [[nodiscard]] json told(std::vector<std::string> args, int code = 0) const {
    args.insert(args.begin(), "solid");
    args.emplace_back("--json");
    const auto outcome = call(args);
    EXPECT_EQ(outcome.code, code) << outcome.err;
    return json::parse(outcome.out, nullptr, false);
  }
  [[nodiscard]] static std::vector<json> findings(const json& told, const std::string& code) {
    std::vector<json> found;
    for (const json& finding : told["findings"]) {
      if (finding["code"] == code) found.push_back(finding);
    }
    return found;
  }
};

const std::string reread_head = "dobra = 1\nprogram = \"quebra\"\n[input]\nsolids = true\n";

std::string part_step(const std::string& operation, const std::string& part, const std::string& rest) {
  return fmt::format("[[step]]\noperation = \"{}\"\npart = \"{}\"\n{}\n", operation, part, rest);
}
std::string box_step(const std::string& part, const std::string& at, const std::string& size) {
  return part_step("block", part, fmt::format("at = {}\nsize = {}", at, size));
}

/// A gear with a bore, seven teeth.
std::string gear_step(const std::string& part, const std::string& axis) {
  std::string points;
  for (int i = 0; i < 28; ++i) {
    const double radius = i % 4 < 2 ? 1.2 : 0.8;
    points += fmt::format("[{}, {}], ", radius * std::cos(0.2244 * i), radius * std::sin(0.2244 * i));
  }
  return part_step("extrude", part,
                   fmt::format("points = [{}]\nby = [0, 0, 0.6]\naxis = {}\nat = [0.1, 0.2, -0.3]\n", points, axis) +
                       "[[step.hole]]\npoints = [[0.3, 0], [0, 0.3], [-0.3, 0], [0, -0.3]]");
}

TEST_F(SolidReread, CurvedSolidsAtOddAnglesInEveryFormat) {
  const std::string torus = "radius = 1\nminor_radius = 0.35\nsegments = 20\nrows = 10\n";
  const std::string sphere = "radius = 0.9\nsegments = 16\nrows = 9\n";
  const std::vector<std::string> axes{"[0.31, -0.42, 0.77]", "[-0.13, 0.88, 0.21]", "[0.5, 0.35, -0.61]"};
  int files = 0;
  int mended = 0;
  for (const std::string& axis : axes) {
    const std::string text = reread_head + part_step("torus", "t", torus) + gear_step("g", axis) +
                             part_step("sphere", "s", sphere + "at = [0.7, 0.1, 0.2]\naxis = " + axis) +
                             part_step("unite", "tg", "of = [\"t\", \"g\"]") +
                             part_step("subtract", "t_g", "of = [\"t\", \"g\"]") +
                             part_step("intersect", "common", "of = [\"tg\", \"s\"]");
    const std::string file = put("odd.toml", text);
    for (const char* const part : {"tg", "t_g", "common"}) {
      for (const char* const ending : {"obj", "ply", "off", "stl"}) {
        SCOPED_TRACE(fmt::format("{} {} {}", axis, part, ending));
        const std::string out = path(fmt::format("odd.{}", ending));
        const json made = told({file, "--part", part, "--out", out});
        EXPECT_TRUE(findings(made, "written_flawed").empty()) << made["findings"];
        const json read = told({out});
        ASSERT_TRUE(read.contains("volume")) << read;
        ++files;
        EXPECT_NEAR(read["volume"].get<double>(), made["volume"].get<double>(), 1e-9 * made["area"].get<double>());
        EXPECT_EQ(read["shells"], made["shells"]);
        EXPECT_EQ(read["genus"], made["genus"]);
        const auto rounded = findings(made, "written_rounded");
        ASSERT_EQ(rounded.size(), 1U);
        if (!rounded[0]["place"].contains("point")) continue;
        ++mended;
        EXPECT_THAT(rounded[0]["message"].get<std::string>(), HasSubstr("became one with another"));
      }
    }
  }
  EXPECT_EQ(files, 36);
  EXPECT_GT(mended, 3);
}

TEST_F(SolidReread, OverlappingPartsOfAGroupAreToldInEveryOperation) {
  const std::string text = reread_head + box_step("rock", "[0, 0, 0]", "[4, 4, 4]") +
                           box_step("ore", "[1, 1, 1]", "[2, 2, 2]") +
                           part_step("group", "both", "of = [\"rock\", \"ore\"]");
  const std::string file = put("both.toml", text);
  const json measured = told({file});
  EXPECT_EQ(measured["volume"], 64.0);
  auto overlap = findings(measured, "overlap");
  ASSERT_EQ(overlap.size(), 1U) << measured["findings"];
  EXPECT_THAT(overlap[0]["message"].get<std::string>(),
              AllOf(HasSubstr("'rock' and 'ore' overlap"), HasSubstr("8 m3")));
  EXPECT_EQ(overlap[0]["place"]["point"], (json{2.0, 2.0, 2.0}));
  const auto remark = findings(measured, "part_remark");
  ASSERT_EQ(remark.size(), 1U);
  EXPECT_THAT(remark[0]["message"].get<std::string>(), HasSubstr("part 'both': 'rock' and 'ore' overlap"));

  const json written = told({file, "--out", path("both.obj")});
  EXPECT_EQ(findings(written, "overlap").size(), 1U);

  const json cut = told({file, "--cut", "0,0,1,-2", "--out", path("section.toml")});
  const auto lost = findings(cut, "cut_overlap");
  ASSERT_EQ(lost.size(), 1U) << cut["findings"];
  EXPECT_THAT(lost[0]["message"].get<std::string>(),
              AllOf(HasSubstr("it shows 'rock' there"), HasSubstr("'ore' is lost")));
  EXPECT_EQ(lost[0]["place"]["point"][2], 2.0);
  // Where the plane misses what is in both, the section has lost nothing.
  EXPECT_TRUE(findings(told({file, "--cut", "0,0,1,-0.5"}), "cut_overlap").empty());
  // As the other file of an operation it is told as well.
  const std::string block = put("block.toml", reread_head + box_step("b", "[0, 0, 0]", "[9, 9, 9]"));
  EXPECT_EQ(findings(told({block, "--subtract", file}), "overlap").size(), 1U);
  // The right way: the ore is taken out of the rock first.
  const std::string right = put("right.toml", reread_head + box_step("rock", "[0, 0, 0]", "[4, 4, 4]") +
                                                  box_step("ore", "[1, 1, 1]", "[2, 2, 2]") +
                                                  part_step("subtract", "rest", "of = [\"rock\", \"ore\"]") +
                                                  part_step("group", "both", "of = [\"rest\", \"ore\"]"));
  EXPECT_TRUE(told({right, "--cut", "0,0,1,-2"})["findings"].empty());
}

TEST_F(SolidReread, FacesThatAreNotPlaneAreToldAndMeasuredAlike) {
  const std::string corners =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1.25\n"
      "f 1 3 4 2\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
  for (const char* const top : {"f 5 6 8 7\n", "f 6 8 7 5\n", "f 8 7 5 6\n", "f 7 5 6 8\n"}) {
    const json told = this->told({put("warped.obj", corners + top)});
    EXPECT_DOUBLE_EQ(told["volume"].get<double>(), 1.0 + 0.25 / 6.0) << top;
    const auto found = findings(told, "not_plane");
    ASSERT_EQ(found.size(), 1U);
    EXPECT_THAT(found[0]["message"].get<std::string>(),
                AllOf(HasSubstr("triangles: 1; face 5"), HasSubstr("0.0417 m3 at most")));
    EXPECT_EQ(found[0]["place"]["point"].size(), 3U);
  }
}

TEST_F(SolidReread, WrongUsageHasItsFindingInJson) {
  const std::string a = put("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
  const std::string same = "1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1";
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{a, "--octree", "13"}, "--octree"},
      {{a, "--octree", "x"}, "--octree"},
      {{a, "--repair", "-1"}, "--repair"},
      {{a, "--unite", a, "--place", same, "--place", same}, "--place"},
      {{a, "--unnite"}, "did you mean '--unite'"},
      {{a, "--unnite", a}, "unexpected argument"},
      {{}, "file is required"},
      {{a, "--cut", "1,2"}, "--cut: give the 4 numbers"}};
  for (const auto& [args, words] : cases) {
    const json told = this->told(args, 2);
    ASSERT_TRUE(told.is_object() && told["findings"].size() == 1) << words;
    EXPECT_EQ(told["findings"][0]["code"], "bad_usage");
    EXPECT_THAT(told["findings"][0]["message"].get<std::string>(), HasSubstr(words));
  }
}

TEST_F(SolidReread, BlanksBesideCommasDoNotCount) {
  const std::string a = put("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
  EXPECT_EQ(told({a, "--unite", a, "--place", "1, 0, 0, 3, 0, 1 ,0,0, 0,0,1,0, 0,0,0,1"})["volume"], 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(told({a, "--cut", " 0, 0 , 1, -0.5"})["cut"]["area"].get<double>(), 0.125);
  (void)told({a, "--cut", "0, 0, 1 1, -0.5"}, 2);
  (void)told({a, "--cut", "0,, 1, -0.5"}, 2);
}

TEST_F(SolidReread, FilesThatWereCutShortSayWhatIsMissingAndWhere) {
  const std::string off = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3";
  const json last = told({put("t.off", off)}, 3)["findings"][0];
  EXPECT_THAT(last["message"].get<std::string>(), HasSubstr("face 4 of 4 has 3 corners, and the line ends after 0"));
  EXPECT_EQ(last["place"]["line"], 10);
  EXPECT_THAT(told({put("u.off", off.substr(0, off.size() - 2))}, 3)["findings"][0]["message"].get<std::string>(),
              HasSubstr("ends before face 4 of 4"));
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\n"
      "element face 4\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 "
      "3\n"
      "3 1 2 3\n3 0";
  const json short_face = told({put("t.ply", ply)}, 3)["findings"][0];
  EXPECT_THAT(short_face["message"].get<std::string>(),
              HasSubstr("face 4 of 4 has 3 corners, and the line ends after 1"));
  EXPECT_EQ(short_face["place"]["line"], 17);
}

}  // namespace
}  // namespace quebra::cli
