// Bad input of `quebra solid`, a table: with --json one finding with its code, the place and what to change; in lines
// the same message; exit code 3, nothing written. Places are worked out by hand.

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "quebra/cli/solid_command.h"
#include "quebra/core/operations.h"
#include "tests/support/command_line.h"

namespace quebra::cli {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using Coordinates = std::array<double, 3>;

/// The faces of a box, corners counted from 0: below, above, front, back, left, right.
using Loops = std::vector<std::vector<int>>;
const Loops box_faces{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};

struct Piece {
  Coordinates low, high;
  Loops faces = box_faces;
};

/// A file of boxes; faces are numbered on.
std::string obj(const std::vector<Piece>& pieces) {
  std::string points;
  std::string faces;
  int first = 1;
  for (const Piece& piece : pieces) {
    for (unsigned i = 0; i < 8; ++i)
      points += fmt::format("v {} {} {}\n", ((i & 1U) != 0 ? piece.high : piece.low)[0],
                            ((i & 2U) != 0 ? piece.high : piece.low)[1], ((i & 4U) != 0 ? piece.high : piece.low)[2]);
    for (const auto& face : piece.faces) {
      faces += 'f';
      for (const int corner : face) faces += fmt::format(" {}", corner + first);
      faces += '\n';
    }
    first += 8;
  }
  return points + faces;
}

Loops with_face(std::size_t number, const std::vector<int>& face) {
  Loops faces = box_faces;
  faces[number] = face;
  return faces;
}
Loops turned_over() {
  Loops faces = box_faces;
  for (auto& face : faces) std::reverse(face.begin(), face.end());
  return faces;
}

struct BadInput {
  const char* what;
  std::string text;  ///< Of the file.
  const char* code;
  std::vector<const char*> words;  ///< Of the message.
  std::optional<Coordinates> point = std::nullopt;
  std::optional<int> line = std::nullopt;
};

class SolidRefusals : public dobra::test::CommandLine {
 protected:
  SolidRefusals() : CommandLine(core::program(), {solid_command()}) {}

  void refused(const BadInput& input, const std::string& file) const {
    SCOPED_TRACE(input.what);
    const std::string name = put(file, input.text);
    const std::string out = path("out.obj");
    const auto told = call({"solid", name, "--out", out, "--json"});
    EXPECT_EQ(told.code, 3) << told.out << told.err;
    const json all = json::parse(told.out, nullptr, false);
    ASSERT_TRUE(all.is_object() && all.contains("findings")) << told.out;
    ASSERT_EQ(all["findings"].size(), 1U) << all;
    const json& finding = all["findings"][0];
    EXPECT_EQ(finding["code"], input.code) << finding;
    const std::string message = finding["message"];
    for (const char* const word : input.words) EXPECT_THAT(message, HasSubstr(word));
    const json& place = finding["place"];
    ASSERT_TRUE(place.is_object()) << finding;
    EXPECT_EQ(place["file"], name);
    if (input.line) {
      EXPECT_EQ(place["line"], *input.line) << finding;
    }
    EXPECT_EQ(place.contains("point"), input.point.has_value()) << finding;
    if (input.point && place.contains("point")) {
      for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(place["point"][i].get<double>(), (*input.point)[i], 1e-9) << finding;
    }
    const auto lines = call({"solid", name, "--out", out});
    EXPECT_EQ(lines.code, 3);
    EXPECT_THAT(lines.err, HasSubstr(message));
    EXPECT_THAT(lines.err, HasSubstr(file));
    EXPECT_EQ(lines.err.find("(at ") != std::string::npos, input.point.has_value()) << lines.err;
    EXPECT_EQ(lines.out, "");
    EXPECT_FALSE(std::filesystem::exists(out));
  }
};

TEST_F(SolidRefusals, BoundariesThatAreNone) {
  const Piece unit{{0, 0, 0}, {1, 1, 1}};
  const Piece two{{0, 0, 0}, {2, 2, 2}};
  Loops open = box_faces;
  open.pop_back();
  Loops twice = box_faces;
  twice.push_back(box_faces[5]);
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const std::vector<BadInput> inputs{
      {"a face is missing", obj({{{0, 0, 0}, {1, 1, 1}, open}}), "not_closed", {"a face is missing"}, {{1, 0.5, 0}}},
      {"a triangle alone", triangle + "f 1 2 3\n", "not_closed", {"face 0"}, {{0.5, 0, 0}}},
      {"a triangle and its back",
       triangle + "f 1 2 3\nf 1 3 2\n",
       "not_closed",
       {"faces 0 and 1 cover each other", "nothing"},
       {{0, 0, 0}}},
      {"a face is turned over",
       obj({{{0, 0, 0}, {1, 1, 1}, with_face(5, {5, 7, 3, 1})}}),
       "not_closed",
       {"face 5", "turn it over"},
       {{1, 0.5, 0.5}}},
      {"inside out", obj({{{0, 0, 0}, {1, 1, 1}, turned_over()}}), "inside_out", {"turn its faces over"}, {{1, 0, 0}}},
      {"one part of two is inside out",
       obj({unit, {{3, 0, 0}, {4, 1, 1}, turned_over()}}),
       "inside_out",
       {"face 6"},
       {{4, 0, 0}}},
      {"a part within another",
       obj({{{0, 0, 0}, {9, 9, 9}}, {{3, 3, 3}, {4, 4, 4}}}),
       "self_intersection",
       {"face 6", "unite them"},
       {{3, 3, 3}}},
      {"two parts cross",
       obj({two, {{1, 1, 1}, {3, 3, 3}}}),
       "self_intersection",
       {"faces 1 and 8 cross"},
       {{1, 1, 2}}},
      {"two parts on each other", obj({unit, unit}), "self_intersection", {"faces 0 and 6", "take one"}, {{0, 0, 0}}},
      {"a face twice", obj({{{0, 0, 0}, {1, 1, 1}, twice}}), "self_intersection", {"faces 5 and 6"}, {{1, 0, 0}}},
      // The diagonals of the square below meet in its middle.
      {"a face that crosses itself",
       obj({{{0, 0, 0}, {1, 1, 1}, with_face(0, {0, 3, 2, 1})}}),
       "self_intersection",
       {"face 0 crosses or touches itself"},
       {{0.5, 0.5, 0}}},
      {"a face that comes back to a corner",
       "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 2 0\nv 0 4 0\nv 2 2 9\nf 1 2 4 3 5 4\nf 1 6 2\n",
       "self_intersection",
       {"face 0"},
       {{2, 2, 0}}},
      {"no number", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n", "not_finite", {"nan"}, std::nullopt, 2},
      {"too large",
       triangle + "v 0 0 1e80\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n",
       "not_finite",
       {"1e75"},
       {{0, 0, 1e80}}},
      {"no such point", triangle + "f 1 2 99\n", "bad_format", {"99"}, std::nullopt, 4}};
  for (const BadInput& input : inputs) refused(input, "bad.obj");
}

const std::string bad_head = "dobra = 1\nprogram = \"quebra\"\n[input]\nsolids = true\n";

std::string one_step(const std::string& operation, const std::string& rest, const std::string& part = "p") {
  return fmt::format("[[step]]\noperation = \"{}\"\npart = \"{}\"\n{}\n", operation, part, rest);
}
std::string outline(const std::string& points) {
  return bad_head + one_step("extrude", "points = " + points + "\nby = [0, 0, 1]\nat = [100, 0, 7]");
}
std::string with_holes(const std::vector<std::string>& holes) {
  std::string text = outline("[[0, 0], [6, 0], [6, 6], [0, 6]]");
  for (const std::string& hole : holes) text += "[[step.hole]]\npoints = " + hole + "\n";
  return text;
}
std::string extruded_by(const std::string& by) {
  return bad_head + one_step("extrude", "points = [[0, 0], [6, 0], [6, 6], [0, 6]]\nby = " + by);
}
std::string swept(const std::string& path, const std::string& rest = "") {
  return bad_head + one_step("sweep", "points = [[-1, -1], [1, -1], [1, 1], [-1, 1]]\npath = " + path + "\n" + rest);
}
std::string revolved(const std::string& points, const std::string& rest = "angle = 360") {
  return bad_head + one_step("revolve", "points = " + points + "\n" + rest);
}

TEST_F(SolidRefusals, ProfilesThatBoundNothingOrCrossThemselves) {
  // All outlines lie at 100, 0, 7.
  const std::vector<BadInput> inputs{
      {"two points", outline("[[0, 0], [1, 0]]"), "degenerate_curve", {"has 2 points"}, std::nullopt, 5},
      {"no area", outline("[[0, 0], [1, 0], [2, 0]]"), "degenerate_curve", {"no area"}, std::nullopt, 5},
      {"a point twice",
       outline("[[0, 0], [1, 0], [1, 0], [0, 1]]"),
       "degenerate_curve",
       {"point 3", "leave it out"},
       {{101, 0, 7}},
       5},
      {"the first point again",
       outline("[[0, 0], [1, 0], [0, 1], [0, 0]]"),
       "degenerate_curve",
       {"point 1"},
       {{100, 0, 7}}},
      {"a bow tie whose halves cancel",
       outline("[[0, 0], [1, 1], [1, 0], [0, 1]]"),
       "self_intersection",
       {"outline of the profile", "sides 1 and 3"},
       {{100.5, 0.5, 7}},
       5},
      {"a bow tie",
       outline("[[0, 0], [2, 2], [2, 0], [0, 2], [-1, 1]]"),
       "self_intersection",
       {"sides 1 and 3"},
       {{101, 1, 7}}},
      {"a corner on a side",
       outline("[[0, 0], [2, 0], [2, 2], [1, 0], [0, 2]]"),
       "self_intersection",
       {"sides 1 and 3"},
       {{101, 0, 7}}},
      {"there and back",
       outline("[[0, 0], [4, 0], [2, 0], [2, 2], [0, 2]]"),
       "self_intersection",
       {"sides 1 and 2"},
       {{102, 0, 7}}},
      {"no finite number", outline("[[0, 0], [nan, 0], [2, 2]]"), "bad_value", {"point 2"}, std::nullopt, 8},
      {"a hole outside",
       with_holes({"[[7, 7], [8, 7], [8, 8]]"}),
       "self_intersection",
       {"hole 1", "outside"},
       {{107, 7, 7}}},
      {"a hole across the outline",
       with_holes({"[[1, 1], [2, 1], [2, 2]]", "[[5, 3], [7, 3], [7, 4]]"}),
       "self_intersection",
       {"hole 2", "outline"},
       {{106, 3, 7}}},
      {"a corner of a hole on the outline",
       with_holes({"[[0, 2], [2, 1], [2, 3]]"}),
       "self_intersection",
       {"hole 1", "outline"},
       {{100, 2, 7}}},
      {"holes that cross",
       with_holes({"[[1, 1], [3, 1], [3, 3], [1, 3]]", "[[2, 0.5], [4, 0.5], [4, 2], [2, 2]]"}),
       "self_intersection",
       {"holes 1 and 2"},
       {{102, 1, 7}}},
      {"a hole in a hole",
       with_holes({"[[1, 1], [5, 1], [5, 5], [1, 5]]", "[[2, 2], [3, 2], [3, 3]]"}),
       "self_intersection",
       {"hole 2", "within hole 1"},
       {{102, 2, 7}}},
      {"a hole that crosses itself",
       with_holes({"[[1, 1], [2, 2], [2, 1], [1, 2]]"}),
       "self_intersection",
       {"sides 1 and 3"},
       {{101.5, 1.5, 7}}}};
  for (const BadInput& input : inputs) refused(input, "bad.toml");
}

TEST_F(SolidRefusals, SweepsThatAreDegenerateAndPathsThatFold) {
  const std::vector<BadInput> inputs{
      {"a vector in the plane", extruded_by("[1, 0, 0]"), "invalid_option", {"third number"}, std::nullopt, 5},
      {"no vector", extruded_by("[0, 0, 0]"), "invalid_option", {"third number"}},
      {"no finite vector", extruded_by("[0, 0, inf]"), "bad_value", {"'by'"}, std::nullopt, 9},
      // 6 m are less than half of what the doubles near 1e20 differ by.
      {"a vector beside which the profile is nothing",
       extruded_by("[1e20, 0, 1]"),
       "invalid_option",
       {"points 1 and 2", "fall together"},
       {{1e20, 0, 1}}},
      {"a path of a point", swept("[[0, 0, 0]]"), "invalid_option", {"two points"}, std::nullopt, 5},
      {"a path of no length",
       swept("[[0, 0, 0], [0, 0, 0]]"),
       "invalid_option",
       {"point 2", "leave it out"},
       {{0, 0, 0}}},
      {"straight back",
       swept("[[0, 0, 0], [5, 0, 0], [2, 0, 0]]", "at = [100, 0, 0]"),
       "invalid_option",
       {"folds at its point 2", "straight back"},
       {{105, 0, 0}}},
      {"straight back, turned",
       swept("[[0, 0, 0], [5, 0, 0], [2, 0, 0]]", "axis = [0, 0, -1]\nat = [0, 3, 0]"),
       "invalid_option",
       {"folds at its point 2"},
       {{5, 3, 0}}},
      {"a leg too short",
       swept("[[0, 0, 0], [9, 0, 0], [9, 0.5, 0], [0, 0.5, 0]]"),
       "invalid_option",
       {"folds at its point 3", "too short"},
       {{9, 0.5, 0}}},
      {"a closed path",
       swept("[[0, 0, 0], [9, 0, 0], [9, 9, 0], [0, 0, 0]]"),
       "invalid_option",
       {"two parts"},
       {{0, 0, 0}}},
      {"a path that crosses itself",
       swept("[[0, 0, 0], [20, 0, 0], [20, 20, 0], [10, 20, 0], [10, -20, 0]]"),
       "self_intersection",
       {"faces 1 and 16 cross"},
       {{9, -1, -1}}},
      {"a path far away",
       swept("[[0, 0, 0], [1e20, 0, 0], [1e20, 1e20, 0]]"),
       "invalid_option",
       {"fall together"},
       {{1e20, 1e20, -1}}},
      {"a contour across the axis",
       revolved("[[-1, 0], [2, 0], [2, 3]]"),
       "invalid_option",
       {"point 1", "radius -1"},
       {{-1, 0, 0}}},
      {"a contour on the axis", revolved("[[0, 0], [0, 2], [0, 1]]"), "degenerate_curve", {"no area"}},
      {"a contour that crosses itself",
       revolved("[[1, 0], [2, 1], [2, 0], [1, 1]]"),
       "self_intersection",
       {"sides 1 and 3"},
       {{1.5, 0, 0.5}}},
      {"no angle", revolved("[[0, 0], [2, 0], [2, 3]]", "angle = 0"), "bad_value", {"'angle'"}, std::nullopt, 9},
      {"two steps round", revolved("[[0, 0], [2, 0], [2, 3]]", "segments = 2"), "invalid_option", {"too few"}},
      {"a loft whose profile crosses itself",
       bad_head + one_step("loft",
                           "[[step.profile]]\npoints = [[-2, -2], [2, -2], [2, 2], [-2, 2]]\n"
                           "[[step.profile]]\npoints = [[-2, -2], [2, 2], [2, -2], [-2, 2]]\nat = [0, 0, 3]"),
       "self_intersection",
       {"profile 2", "sides 1 and 3"},
       {{0, 0, 3}}},
      {"profiles behind each other",
       bad_head + one_step("loft",
                           "[[step.profile]]\npoints = [[-2, -2], [2, -2], [2, 2], [-2, 2]]\n"
                           "[[step.profile]]\npoints = [[-1, -1], [1, -1], [1, 1], [-1, 1]]\nat = [0, 0, -3]"),
       "invalid_option",
       {"not in front of profile 1"},
       {{-1, -1, -3}}}};
  for (const BadInput& input : inputs) refused(input, "bad.toml");
}

TEST_F(SolidRefusals, TreesThatRecurAndPlacesWhereNothingIsLeft) {
  const std::string block = one_step("block", "size = [1, 1, 1]", "a");
  const std::vector<BadInput> inputs{
      {"made of itself",
       bad_head + block + one_step("unite", "of = [\"a\", \"p\"]"),
       "bad_value",
       {"recursion", "'p' of 'p'"},
       std::nullopt,
       12},
      {"in a ring",
       bad_head + one_step("unite", "of = [\"b\"]", "a") + one_step("place", "of = [\"a\"]\nby = [1, 0, 0]", "b"),
       "bad_value",
       {"recursion", "'a' of 'b' of 'a'"},
       std::nullopt,
       8},
      {"of a later part",
       bad_head + one_step("unite", "of = [\"a\"]") + block,
       "bad_value",
       {"move that step"},
       std::nullopt,
       8},
      {"of nothing", bad_head + one_step("unite", "of = []"), "bad_value", {"1 or more"}, std::nullopt, 5},
      {"a size that is none",
       bad_head + one_step("block", "size = [1, 0, 1]"),
       "invalid_option",
       {"second number of size"}},
      {"a block placed where its corners are one",
       bad_head + one_step("block", "size = [1, 1, 1]\nat = [1e20, 0, 0]"),
       "invalid_option",
       {"nothing is left", "nearer"},
       std::nullopt,
       5},
      {"the same by a step",
       bad_head + block + one_step("place", "of = [\"a\"]\nby = [0, 1e20, 0]"),
       "invalid_option",
       {"nothing is left"},
       std::nullopt,
       9},
      {"a rounding that leaves nothing of a face",
       bad_head + block + one_step("round", "of = [\"a\"]\nradius = 0.6"),
       "invalid_option",
       {"too large", "a_bottom"},
       std::nullopt,
       9}};
  for (const BadInput& input : inputs) refused(input, "bad.toml");
}

// What looks like the above and is none of it.
TEST_F(SolidRefusals, GoodInputIsTaken) {
  // Holes that touch the outline and each other in corners; a contour that touches the axis and itself in a point.
  const std::vector<std::pair<std::string, double>> cases{
      {outline("[[0, 0], [4, 0], [4, 4], [0, 4]]"), 16.0},
      {with_holes({"[[0, 0], [2, 1], [1, 2]]", "[[2, 1], [3, 1], [3, 2]]"}), 36.0 - 1.5 - 0.5},
      {extruded_by("[1e3, 0, 1]"), 36.0},
      {swept("[[0, 0, 0], [20, 0, 0], [20, 20, 0], [10, 20, 0], [10, 1, 0]]"), 276.0},
      {revolved("[[0, 0], [2, 0], [0, 3]]", "segments = 4"), 8.0},
      {revolved("[[1, 0], [3, 0], [3, 3], [2, 0], [1, 3]]", "segments = 4"), 24.0}};
  for (const auto& [text, volume] : cases) {
    const auto told = call({"solid", put("good.toml", text), "--json"});
    ASSERT_EQ(told.code, 0) << text << told.err;
    EXPECT_NEAR(json::parse(told.out)["volume"].get<double>(), volume, 1e-9 * volume) << text;
  }
}

}  // namespace
}  // namespace quebra::cli
