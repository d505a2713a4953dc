// What is told of trims that do not do what they may have been meant for.

#include "quebra/surfaces/trim_doubts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/surface_scenarios.h"

namespace quebra::surfaces::trim_doubts_test {
namespace {

using namespace dobra;
using test::plate;
using testing::HasSubstr;

std::string circle(const char* name, const char* role, const char* centre, const char* radius) {
  return std::string("[[input.trim]]\nname = \"") + name + "\"\nkind = \"circle\"\nrole = \"" + role +
         "\"\ncentre = " + centre + "\nradius = " + radius + "\n";
}
std::vector<surf::mesh::Finding> told(const std::string& text) {
  const auto made = test::surfaces_of(text);
  EXPECT_TRUE(made.ok()) << (made ? "" : to_string(made.error()));
  return made ? made->findings : std::vector<surf::mesh::Finding>{};
}

TEST(TrimDoubts, AHoleOutsideTheOutlineIsTold) {
  const auto findings = told(plate + circle("o", "outline", "[3, 5]", "2") + circle("h", "hole", "[8, 5]", "0.5"));
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].code, "loop_bounds_nothing");
  EXPECT_THAT(findings[0].message, HasSubstr("'h' has no effect and its set is empty: it lies outside the outlines"));
  EXPECT_NEAR(*findings[0].place.x, 8.5, 1e-9);
}

TEST(TrimDoubts, AHoleInAHoleOrOnItIsTold) {
  for (const char* const radius : {"0.5", "1"}) {
    const auto findings = told(plate + circle("h", "hole", "[3, 5]", "1") + circle("k", "hole", "[3, 5]", radius));
    ASSERT_EQ(findings.size(), 1U) << radius;
    EXPECT_EQ(findings[0].code, "loop_bounds_nothing");
    EXPECT_THAT(findings[0].message, HasSubstr("'k' has no effect and its set is empty: it lies in 'h'"));
  }
}

TEST(TrimDoubts, ALoopSmallerThanAPointIsRefusedAsSuch) {
  const auto made = test::surfaces_of(plate + circle("h", "hole", "[5, 5]", "1e-7"));
  ASSERT_FALSE(made.ok());
  EXPECT_THAT(made.error().message, HasSubstr("smaller than what counts as one point"));
}

TEST(TrimDoubts, HolesThatTakeSomethingAwayAreNotTold) {
  EXPECT_TRUE(told(plate + circle("h", "hole", "[3, 5]", "1") + circle("k", "hole", "[7, 5]", "1")).empty());
  EXPECT_TRUE(told(plate + circle("o", "outline", "[5, 5]", "4") + circle("k", "hole", "[5, 5]", "1")).empty());
}

TEST(TrimDoubts, AHoleOverTheSeamCrossesNothing) {
  const std::string pipe =
      "[[input.surface]]\nname = \"c\"\nkind = \"cylinder\"\nradius = 2\nu = [0, 360]\nv = [0, 10]\n";
  for (const char* const centre : {"[0, 5]", "[360, 5]", "[355, 5]", "[180, 5]"}) {
    const auto hole = std::string("[[input.trim]]\nname = \"h\"\nkind = \"ellipse\"\nrole = \"hole\"\ncentre = ") +
                      centre + "\nradii = [30, 1]\n";
    EXPECT_TRUE(told(pipe + hole).empty()) << centre;
    EXPECT_TRUE(told(pipe + hole +
                     "[[input.trim]]\nname = \"k\"\nkind = \"ellipse\"\nrole = \"hole\"\ncentre = [90, 5]\n"
                     "radii = [30, 1]\n")
                    .empty())
        << centre;
  }
}

}  // namespace
}  // namespace quebra::surfaces::trim_doubts_test
