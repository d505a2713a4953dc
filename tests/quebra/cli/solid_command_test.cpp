// `quebra solid`: refusals with their findings first, then empty results, then figures that are known otherwise.

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <array>
#include <bit>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "quebra/cli/solid_command.h"
#include "quebra/core/operations.h"
#include "tests/support/command_line.h"

namespace quebra::cli {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using Corner = std::array<double, 3>;

/// The box between two corners as OBJ; its first faces below and above.
std::string box(const Corner& a, const Corner& b, std::size_t first = 1) {
  std::string text;
  for (std::size_t i = 0; i < 8; ++i) {
    text += fmt::format("v {} {} {}\n", (i & 1U) != 0 ? b[0] : a[0], (i & 2U) != 0 ? b[1] : a[1],
                        (i & 4U) != 0 ? b[2] : a[2]);
  }
  for (const auto& face : std::array<std::array<std::size_t, 4>, 6>{
           {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}})
    text += fmt::format("f {} {} {} {}\n", face[0] + first, face[1] + first, face[2] + first, face[3] + first);
  return text;
}

constexpr std::array<Corner, 4> corners{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
constexpr std::array<std::array<std::size_t, 3>, 4> facets{{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};

/// The tetrahedron between the axes: 1/6.
std::string tetrahedron_text() {
  std::string text = "solid corner of a cube\n";
  for (const auto& facet : facets) {
    text += "  FACET normal 0 0 0\n outer loop\n";
    for (const std::size_t c : facet)
      text += fmt::format("vertex {} {} {}\n", corners[c][0], corners[c][1], corners[c][2]);
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid corner of a cube\n";
}

std::string bytes_of(std::uint32_t value) {
  std::string bytes;
  for (unsigned i = 0; i < 4; ++i) bytes += static_cast<char>((value >> (8 * i)) & 0xffU);
  return bytes;
}

/// The same in binary, beginning with a word that text begins with.
std::string tetrahedron_binary() {
  std::string bytes = "solid by a program that says so in binary files too";
  bytes.resize(80, ' ');
  bytes += bytes_of(4);
  for (const auto& facet : facets) {
    bytes += std::string(12, '\0');
    for (const std::size_t c : facet) {
      for (const double x : corners[c]) bytes += bytes_of(std::bit_cast<std::uint32_t>(static_cast<float>(x)));
    }
    bytes += std::string(2, '\0');
  }
  return bytes;
}

class SolidCommand : public dobra::test::CommandLine {
 protected:
  SolidCommand() : CommandLine(core::program(), {solid_command()}) {}

  [[nodiscard]] json told(std::vector<std::string> args, int code = 0) const {
    args.insert(args.begin(), "solid");
    args.emplace_back("--json");
    const auto outcome = call(args);
    EXPECT_EQ(outcome.code, code) << outcome.err;
    return json::parse(outcome.out, nullptr, false);
  }
  /// The only finding of a call.
  [[nodiscard]] json finding(const std::vector<std::string>& args, int code) const {
    const json all = told(args, code);
    EXPECT_EQ(all["findings"].size(), 1U) << all;
    return all["findings"].empty() ? json() : all["findings"][0];
  }
  [[nodiscard]] static std::array<int, 5> counts(const json& told) {
    return {told["vertices"], told["edges"], told["faces"], told["shells"], told["genus"]};
  }
};

TEST_F(SolidCommand, OpenInvertedAndCrossingBoundariesAreRefusedWithTheirFaces) {
  const std::string good = put("good.obj", box({0, 0, 0}, {1, 1, 1}));
  std::string open = box({0, 0, 0}, {1, 1, 1});
  open.resize(open.rfind("f "));
  json told = finding({good, "--unite", put("open.obj", open)}, 3);
  EXPECT_EQ(told["code"], "not_closed");
  EXPECT_EQ(told["place"]["file"], path("open.obj"));
  EXPECT_EQ(told["place"]["point"].size(), 3U);

  told = finding({put("inverted.obj", box({1, 0, 0}, {0, 1, 1})), "--unite", good}, 3);
  EXPECT_THAT(told["message"].get<std::string>(), HasSubstr("inside out"));
  EXPECT_EQ(told["code"], "inside_out");

  const std::string two = box({0, 0, 0}, {2, 2, 2}) + box({1, 1, 1}, {3, 3, 3}, 9);
  told = finding({put("crossing.obj", two)}, 3);
  EXPECT_EQ(told["code"], "self_intersection");
  // One face of each box: 0 to 5 and 6 to 11.
  EXPECT_THAT(told["message"].get<std::string>(), testing::MatchesRegex("faces [0-5] and ([6-9]|1[01]) cross.*"));
}

TEST_F(SolidCommand, RepairTellsWhatItDidAndWhatItCannotMendIsRefused) {
  std::string open = box({0, 0, 0}, {1, 1, 1});
  open.resize(open.rfind("f "));
  const std::string file = put("open.obj", open);
  EXPECT_EQ(finding({file}, 3)["code"], "not_closed");
  const json mended = told({file, "--repair", "0"});
  EXPECT_EQ(mended["volume"], 1.0);
  ASSERT_EQ(mended["findings"].size(), 1U) << mended;
  EXPECT_EQ(mended["findings"][0]["code"], "repaired");
  EXPECT_EQ(mended["findings"][0]["place"]["point"], (std::vector<double>{1.0, 0.5, 0.5}));
  EXPECT_EQ(told({put("inside_out.obj", box({1, 0, 0}, {0, 1, 1})), "--repair", "0"})["volume"], 1.0);
  const std::string crossing = put("crossing.obj", box({0, 0, 0}, {2, 2, 2}) + box({1, 1, 1}, {3, 3, 3}, 9));
  EXPECT_EQ(finding({crossing, "--repair", "0"}, 3)["code"], "self_intersection");
  EXPECT_EQ(call({"solid", file, "--repair", "-1"}).code, 2);
}

TEST_F(SolidCommand, OctreesBoundTheVolume) {
  const std::string block = put("block.obj", box({0, 0, 0}, {1, 1, 1}));
  const std::string corner = put("corner.obj", box({0, 0, 0}, {0.5, 0.5, 0.3}));
  const json told = this->told({block, "--subtract", corner, "--octree", "3"});
  EXPECT_EQ(told["volume"], 1.0 - 0.075);
  const json& body = told["octree"]["bodies"][0];
  // Of eight layers of 16 cells under the corner two are gone, and one is between.
  EXPECT_EQ(body["volume"][0], 1.0 - 3 * 16 / 512.0);
  EXPECT_EQ(body["volume"][1], 1.0 - 2 * 16 / 512.0);
  EXPECT_EQ(body["partial"], 16);
  EXPECT_EQ(told["octree"]["clashes"].size(), 0U);
  EXPECT_EQ(call({"solid", block, "--octree", "13"}).code, 2);
  EXPECT_EQ(this->told({block, "--subtract", block, "--octree", "2"})["octree"]["bodies"].size(), 0U);
}

TEST_F(SolidCommand, CentroidAndInertiaAreThoseOfTheBox) {
  const json told = this->told({put("block.obj", box({1, 2, 3}, {2, 4, 7}))});
  EXPECT_EQ(told["centroid"], (std::vector<double>{1.5, 3.0, 5.0}));
  // m (b^2 + c^2) / 12 for the mass 8.
  const std::vector<double> inertia{8 * (4 + 16) / 12.0, 8 * (16 + 1) / 12.0, 8 * (1 + 4) / 12.0, 0, 0, 0};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(told["inertia"][i], inertia[i], 1e-14);
}

TEST_F(SolidCommand, FilesThatAreNoBoundariesAreRefused) {
  EXPECT_EQ(finding({path("missing.stl")}, 3)["code"], "file_not_found");
  EXPECT_EQ(finding({put("part.step", "ISO-10303-21;\n")}, 3)["code"], "unknown_format");
  EXPECT_EQ(finding({put("empty.off", "OFF\n0 0 0\n")}, 3)["code"], "bad_format");
  EXPECT_EQ(finding({put("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n")}, 3)["code"], "not_closed");
  const std::string whole = tetrahedron_binary();
  EXPECT_THAT(finding({put("short.stl", whole.substr(0, whole.size() - 1))}, 3)["message"].get<std::string>(),
              AllOf(HasSubstr("284 bytes"), HasSubstr("283")));
  const std::string text = tetrahedron_text();
  EXPECT_THAT(finding({put("cut.stl", text.substr(0, text.size() / 2))}, 3)["message"].get<std::string>(),
              HasSubstr("endsolid"));
  std::string infinite = whole;
  infinite.replace(84 + 12, 4, bytes_of(0x7f800000U));
  EXPECT_EQ(finding({put("infinite.stl", infinite)}, 3)["code"], "not_finite");
  std::string lost = text;
  lost.erase(lost.find("vertex"), 13);
  EXPECT_THAT(finding({put("lost.stl", lost)}, 3)["message"].get<std::string>(), HasSubstr("corners"));
}

TEST_F(SolidCommand, NoughtIsPrintedWithoutASign) {
  const json told = this->told({put("block.obj", box({-1, -1, -1}, {1, 1, 1}))});
  for (const char* key : {"centroid", "inertia"}) {
    for (const json& number : told[key]) EXPECT_FALSE(std::signbit(number.get<double>())) << told;
  }
  EXPECT_EQ(told["inertia"].dump().find('-'), std::string::npos);
}

TEST_F(SolidCommand, TheSectionIsToldInLinesToo) {
  const std::string block = put("block.obj", box({0, 0, 0}, {4, 4, 4}));
  const std::string bore = put("bore.obj", box({1, 1, -1}, {2, 3, 5}));
  const auto lines = call({"solid", block, "--subtract", bore, "--cut", "0,0,1,-2"});
  ASSERT_EQ(lines.code, 0) << lines.err;
  EXPECT_THAT(lines.out, testing::ContainsRegex("cut_area +14\\.0\n"));
  EXPECT_THAT(lines.out, testing::ContainsRegex("cut_pieces +1\n"));
  EXPECT_THAT(lines.out, testing::ContainsRegex("cut_holes +1\n"));
  EXPECT_THAT(lines.out, testing::ContainsRegex("cut_curves +2\n"));
  EXPECT_THAT(call({"solid", block}).out, testing::Not(HasSubstr("cut_area")));
}

TEST_F(SolidCommand, MatricesThatPlaceNothingAreRefused) {
  const std::string a = put("a.obj", box({0, 0, 0}, {1, 1, 1}));
  for (const std::string matrix : {"1,0,0,0,0,1,0,0,0,0,1,0,0,0,0", "1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1,0",
                                   "1,0,0,x,0,1,0,0,0,0,1,0,0,0,0,1", "nan,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1",
                                   "1,0,0,0,0,1,0,0,0,0,1,0,0,0,1,1", "1,2,0,0,2,4,0,0,0,0,1,0,0,0,0,1", ""}) {
    const json told = finding({a, "--unite", a, "--place", matrix}, 2);
    EXPECT_EQ(told["code"], "bad_usage") << matrix;
    EXPECT_THAT(told["message"].get<std::string>(), HasSubstr("--place"));
  }
  EXPECT_EQ(finding({a, "--unite", a, "--place", "1e308,1e308,0,0,0,1,0,0,0,0,1,0,0,0,0,1"}, 3)["code"], "not_finite");
  // A place must follow a file, once.
  const std::string same = "1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1";
  refuses({"solid", a, "--place", same, "--unite", a}, 2, {"--place"});
  refuses({"solid", a, "--unite", a, "--place", same, "--place", same}, 2, {"--place"});
  refuses({"solid", a, "--out", path("a.vtu")}, 2, {"a.vtu"});
}

TEST_F(SolidCommand, AnEmptyResultTellsTheContactAndWritesNoFile) {
  const std::string a = put("a.obj", box({0, 0, 0}, {1, 1, 1}));
  const std::vector<std::pair<Corner, std::string>> cases{{{5, 0, 0}, "contact_nothing"},
                                                          {{1, 1, 1}, "contact_vertex"},
                                                          {{1, 1, 0}, "contact_edge"},
                                                          {{1, 0.5, 0}, "contact_face"}};
  for (const auto& [corner, code] : cases) {
    const std::string b = put("b.obj", box(corner, {corner[0] + 1, corner[1] + 1, corner[2] + 1}));
    const json told = this->told({a, "--intersect", b, "--out", path("none.obj")});
    EXPECT_EQ(told["volume"], 0.0);
    EXPECT_EQ(counts(told), (std::array<int, 5>{0, 0, 0, 0, 0}));
    EXPECT_EQ(told["findings"][0]["code"], code);
    EXPECT_EQ(told["findings"][1]["code"], "empty");
    EXPECT_FALSE(std::filesystem::exists(path("none.obj")));
  }
  EXPECT_EQ(finding({a, "--subtract", a}, 0)["code"], "contact_volume");
  // Nothing is told of solids that overlap and leave something.
  const std::string c = put("c.obj", box({0.5, 0, 0}, {2, 1, 1}));
  EXPECT_TRUE(told({a, "--intersect", c})["findings"].empty());
}

TEST_F(SolidCommand, StlIsReadByItsLengthAndByWords) {
  for (const auto& [name, bytes] : {std::pair{"t.stl", tetrahedron_text()}, std::pair{"b.stl", tetrahedron_binary()}}) {
    const json told = this->told({put(name, bytes)});
    EXPECT_EQ(told["volume"], 1.0 / 6.0) << name;
    EXPECT_EQ(counts(told), (std::array<int, 5>{4, 6, 4, 1, 0})) << name;
  }
  // Corners that differ by the last digit are two, and the boundary is open; the two zeros are one.
  std::string text = tetrahedron_text();
  text.replace(text.find("vertex 0 0 0"), 12, "vertex -0 0 -0");
  EXPECT_EQ(counts(told({put("zero.stl", text)})), (std::array<int, 5>{4, 6, 4, 1, 0}));
  text.replace(text.find("vertex -0 0 -0"), 14, "vertex 1e-300 0 0");
  EXPECT_EQ(finding({put("near.stl", text)}, 3)["code"], "not_closed");
}

TEST_F(SolidCommand, StepsApplyFromLeftToRight) {
  const std::string a = put("a.obj", box({0, 0, 0}, {2, 1, 1}));
  const std::string b = put("b.obj", box({1, 0, 0}, {3, 1, 1}));
  const std::string c = put("c.obj", box({1.5, 0, 0}, {4, 1, 1}));
  EXPECT_EQ(told({a, "--unite", b, "--subtract", c})["volume"], 1.5);
  EXPECT_EQ(told({a, "--subtract", c, "--unite", b})["volume"], 3.0);
  EXPECT_EQ(told({a, "--subtract", c, "--intersect", b})["volume"], 0.5);
  EXPECT_EQ(told({a, "--subtract", b, "--subtract", c})["volume"], 1.0);
  EXPECT_EQ(told({"--subtract=" + b, a, "--unite", c})["volume"], 3.5);
}

TEST_F(SolidCommand, APlaceMovesTheFileBeforeItAndMirrorsKeepTheInside) {
  const std::string a = put("a.obj", box({0, 0, 0}, {1, 1, 1}));
  EXPECT_EQ(told({a, "--unite", a, "--place", "1,0,0,0.5,0,1,0,0,0,0,1,0,0,0,0,1"})["volume"], 1.5);
  EXPECT_EQ(told({a, "--unite", a, "--place", "-1,0,0,0.5,0,1,0,0,0,0,1,0,0,0,0,1"})["volume"], 1.5);
  EXPECT_EQ(told({a, "--unite", a, "--place", "1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1", "--unite", a, "--place",
                  "1,0,0,3,0,1,0,0,0,0,1,0,0,0,0,1"})["volume"],
            2.0);
  // A turn by sines and cosines: what is rounded is told, and there is no lost volume to speak of.
  const json turned =
      told({a, "--unite", a, "--place", "0.8,-0.6,0,3,0.6,0.8,0,0,0,0,1,0.1,0,0,0,1", "--out", path("turned.off")});
  EXPECT_NEAR(turned["volume"].get<double>(), 2.0, 1e-15);
  EXPECT_EQ(turned["findings"][0]["code"], "placed_rounded");
}

TEST_F(SolidCommand, FacesOfOneFileThatCoverEachOtherAreTold) {
  const std::string both = put("both.obj", box({0, 0, 0}, {1, 1, 1}) + box({1, 0, 0}, {2, 1, 1}, 9));
  const json joined = told({both});
  EXPECT_EQ(counts(joined), (std::array<int, 5>{8, 12, 6, 1, 0}));
  ASSERT_EQ(joined["findings"].size(), 1U);
  const json finding = joined["findings"][0];
  EXPECT_EQ(finding["code"], "opposite_faces");
  EXPECT_THAT(finding["message"].get<std::string>(), AllOf(HasSubstr("faces 5 and 10"), HasSubstr("left out")));
  EXPECT_THAT(finding["place"]["file"].get<std::string>(), HasSubstr("both.obj"));
  EXPECT_EQ(finding["place"]["point"][0], 1.0);
  // As the other file it is told as well, where it is placed; boxes apart, or in two files, are not spoken of.
  const std::string a = put("a.obj", box({0, 0, 0}, {1, 1, 1}));
  const json moved = told({a, "--unite", both, "--place", "1,0,0,0.5,0,1,0,0,0,0,1,0,0,0,0,1"});
  ASSERT_EQ(moved["findings"].size(), 1U);
  EXPECT_EQ(moved["findings"][0]["place"]["point"][0], 1.5);
  const std::string apart = put("apart.obj", box({0, 0, 0}, {1, 1, 1}) + box({1.5, 0, 0}, {2, 1, 1}, 9));
  EXPECT_EQ(told({apart})["findings"], json::array());
}

TEST_F(SolidCommand, CountsAreTakenAfterPlaneNeighboursAreMerged) {
  const std::string a = put("a.obj", box({0, 0, 0}, {1, 1, 1}));
  const std::string beside = put("beside.obj", box({1, 0, 0}, {2, 1, 1}));
  const json bar = told({a, "--unite", beside});
  EXPECT_EQ(counts(bar), (std::array<int, 5>{8, 12, 6, 1, 0}));
  EXPECT_EQ(bar["area"], 10.0);
  EXPECT_EQ(bar["findings"][0]["code"], "contact_face");
  // A bore goes through, a cavity is a shell of its own.
  const std::string block = put("block.obj", box({0, 0, 0}, {9, 9, 9}));
  const std::string bore = put("bore.obj", box({1, 1, -1}, {2, 2, 10}));
  const std::string cavity = put("cavity.obj", box({4, 4, 4}, {5, 5, 5}));
  const json bored = told({block, "--subtract", bore, "--subtract", cavity});
  EXPECT_EQ(counts(bored), (std::array<int, 5>{24, 36, 16, 2, 1}));
  EXPECT_EQ(bored["volume"], 729.0 - 9.0 - 1.0);
  EXPECT_EQ(bored["area"], 486.0 - 2.0 + 36.0 + 6.0);
  for (const char* const key : {"read", "boolean", "write"}) EXPECT_GE(bored["seconds"][key].get<double>(), 0.0);
}

TEST_F(SolidCommand, TheVolumeIsRoundedOnce) {
  // Products of doubles, rounded twice, are 0.006000000000000001.
  EXPECT_EQ(told({put("a.obj", box({0, 0, 0}, {0.1, 0.2, 0.3}))})["volume"], 0.006);
  EXPECT_NE(0.1 * 0.2 * 0.3, 0.006);
}

TEST_F(SolidCommand, EveryFormatGivesTheResultBack) {
  const std::string block = put("block.obj", box({0, 0, 0}, {3, 3, 0.1}));
  const std::string bore = put("bore.obj", box({1, 1, -1}, {2, 2, 1}));
  for (const std::string name : {"r.obj", "r.ply", "r.off", "r.stl"}) {
    const json made = told({block, "--subtract", bore, "--out", path(name)});
    EXPECT_TRUE(made["findings"].empty());
    const json back = told({path(name)});
    EXPECT_EQ(back["volume"], made["volume"]) << name;
    EXPECT_EQ(counts(back), (std::array<int, 5>{16, 24, 10, 1, 1})) << name;
  }
  EXPECT_THAT(text("r.stl"), HasSubstr("endsolid"));
}

TEST_F(SolidCommand, AFaceOfMoreCornersThanAPlyCountsIsCut) {
  constexpr int sides = 300;
  std::string text;
  std::string low = "f";
  std::string high = "f";
  for (int i = 0; i < sides; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / sides;
    text += fmt::format("v {0} {1} 0\nv {0} {1} 1\n", std::cos(angle), std::sin(angle));
    low += fmt::format(" {}", 2 * (sides - i) - 1);
    high += fmt::format(" {}", 2 * i + 2);
  }
  for (int i = 0; i < sides; ++i) {
    const int j = (i + 1) % sides;
    text += fmt::format("f {} {} {}\nf {} {} {}\n", 2 * i + 1, 2 * j + 1, 2 * j + 2, 2 * i + 1, 2 * j + 2, 2 * i + 2);
  }
  const std::string drum = put("drum.obj", text + low + "\n" + high + "\n");
  const json made = told({drum, "--out", path("drum.ply")});
  EXPECT_EQ(counts(made), (std::array<int, 5>{2 * sides, 3 * sides, sides + 2, 1, 0}));
  std::istringstream lines(this->text("drum.ply"));
  for (std::string line; std::getline(lines, line);) EXPECT_FALSE(line.starts_with("300 "));
  EXPECT_EQ(told({path("drum.ply")})["volume"], made["volume"]);
}

TEST_F(SolidCommand, StepsGoOnFromAnEmptyResult) {
  const std::string a = put("a.obj", box({0, 0, 0}, {1, 1, 1}));
  const std::string far = put("far.obj", box({5, 0, 0}, {6, 1, 2}));
  const json told = this->told({a, "--intersect", far, "--unite", far, "--subtract", a});
  EXPECT_EQ(told["volume"], 2.0);
  EXPECT_EQ(counts(told), (std::array<int, 5>{8, 12, 6, 1, 0}));
}

TEST_F(SolidCommand, WithoutJsonATableIsPrintedAndFindingsAreMessages) {
  const std::string a = put("a.obj", box({0, 0, 0}, {1, 1, 1}));
  const auto outcome = call({"solid", a, "--intersect", a, "--subtract", a});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out, HasSubstr("volume    0.0"));
  EXPECT_THAT(outcome.err, HasSubstr("nothing is left"));
}

}  // namespace
}  // namespace quebra::cli
