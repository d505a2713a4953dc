// Points in space in scenario files: read, judged, turned into SI, saved.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shared/scenario/document.h"
#include "shared/scenario/field.h"
#include "shared/scenario/units.h"

namespace dobra::scenario {
namespace {

using geom::Point3;
using testing::HasSubstr;

struct SpaceParams {
  std::vector<Point3> points;
  std::optional<Point3> axis;
  template <class D>
  static void describe(D& d) {
    d.field("points", &SpaceParams::points, {.title = "Points", .unit = "m"});
    d.field("axis", &SpaceParams::axis, {.title = "Axis"});
  }
};

Document document(const std::string& input) {
  auto parsed = parse_document("dobra = 1\nprogram = \"quebra\"\n[input]\n" + input, "test.toml");
  EXPECT_TRUE(parsed.ok()) << (parsed ? "" : to_string(parsed.error()));
  return *parsed;
}
std::string wrong(const std::string& input) {
  const auto parsed = parse_document("dobra = 1\nprogram = \"quebra\"\n[input]\n" + input, "test.toml");
  if (!parsed) return to_string(parsed.error());
  const auto judged = check(parsed->input, fields_of<SpaceParams>(), "");
  return judged ? "" : to_string(judged.error());
}

TEST(PointsInSpace, AreReadAndSaved) {
  const Document read = document("points = [[0, 0, 1], [2.5, 0, 1e3]]\naxis = [0, 0, 1]\n");
  ASSERT_TRUE(check(read.input, fields_of<SpaceParams>(), "").ok());
  const auto params = from_table<SpaceParams>(read.input);
  EXPECT_EQ(params.points, (std::vector<Point3>{{0, 0, 1}, {2.5, 0, 1000}}));
  EXPECT_EQ(*params.axis, (Point3{0, 0, 1}));
  EXPECT_THAT(value_text(*read.input.find("points")), testing::StartsWith("[[0.0, 0.0, 1.0], [2.5, 0.0, 1000"));
  const Field field = fields_of<SpaceParams>()[0];
  EXPECT_EQ(*parse_value(field, value_text(*read.input.find("points"))), *read.input.find("points"));
}

TEST(PointsInSpace, AreTurnedIntoSi) {
  const Document read = document("points = [[1000, 0, 5]]\naxis = [0, 0, 2]\n");
  const auto si = from_table<SpaceParams>(in_si(read.input, fields_of<SpaceParams>(), *UnitSystem::make("mm, N, MPa")));
  EXPECT_EQ(si.points[0], (Point3{1, 0, 0.005}));
  EXPECT_EQ(*si.axis, (Point3{0, 0, 2}));  // a direction has no unit
}

TEST(PointsInSpace, OfOtherLengthsAreNamed) {
  EXPECT_THAT(wrong("points = [[0, 0, 1], [2, 3]]\n"), HasSubstr("point 2 of 'points' is not a triple"));
  EXPECT_THAT(wrong("points = [[0, 1], [2, 3]]\n"), HasSubstr("must be a list of points in space"));
  EXPECT_THAT(wrong("axis = [0, 1]\n"), HasSubstr("must be a point or direction in space"));
  EXPECT_THAT(wrong("points = [[0, 0, nan]]\n"), HasSubstr("finite"));
}

}  // namespace
}  // namespace dobra::scenario
