#include "quebra/repair/crack_flaws.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/quebra_scenarios.h"

namespace quebra::repair {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string cracked_square =
    "[[input.curve]]\nname = \"rim\"\nkind = \"polygon\"\npoints = [[0, 0], [4, 0], [4, 4], [0, 4]]\n";
std::string crack_along(const std::string& points) {
  return "[[input.crack]]\nname = \"crack\"\npoints = " + points + "\n";
}

std::vector<std::string> remarks_of(const std::string& input) {
  const auto run = test::run(input);
  EXPECT_TRUE(run.complete()) << (run.error ? to_string(*run.error) : "");
  return run.complete() ? test::last(run).remarks : std::vector<std::string>{};
}

TEST(CrackFlaws, AnEndThatOnlyNearlyTouchesIsToldWithItsPlaceAndDistance) {
  const auto remarks = remarks_of(cracked_square + crack_along("[[2, 1e-8], [2, 2]]"));
  ASSERT_EQ(remarks.size(), 1U);
  EXPECT_THAT(remarks[0], HasSubstr("crack nearly touching at (2, 1e-08) of crack, rim"));
  EXPECT_THAT(remarks[0], HasSubstr("ends 1e-08 m from 'rim'"));
}

TEST(CrackFlaws, AnEndThatIsMovedToAnotherEndIsToldToo) {
  const auto remarks = remarks_of(cracked_square + crack_along("[[1, 2], [2, 2]]") +
                                  "[[input.crack]]\nname = \"branch\"\npoints = [[2.0000001, 2], [3, 3]]\n");
  ASSERT_FALSE(remarks.empty());
  EXPECT_THAT(remarks[0], HasSubstr("branch"));
  EXPECT_THAT(remarks[0], HasSubstr("ends 1e-07 m from 'crack'"));
}

TEST(CrackFlaws, EndsThatTouchOrStayInsideAreNone) {
  EXPECT_THAT(remarks_of(cracked_square + crack_along("[[2, 0], [2, 2]]")), ElementsAre());
  EXPECT_THAT(remarks_of(cracked_square + crack_along("[[1, 2], [3, 2]]")), ElementsAre());
  const std::string hole =
      "[[input.curve]]\nname = \"hole\"\nkind = \"polygon\"\nrole = \"hole\"\npoints = [[1, 1], [3, 1], [3, 3], [1, "
      "3]]\n";
  EXPECT_THAT(remarks_of(cracked_square + hole + crack_along("[[2, 0], [2, 1]]")), ElementsAre())
      << "from the rim to a hole parts nothing";
}

TEST(CrackFlaws, ACrackThatCutsTheMaterialThroughTellsThePartsAndTheirRegions) {
  const auto remarks = remarks_of(cracked_square + crack_along("[[0, 1], [4, 1]]"));
  ASSERT_EQ(remarks.size(), 1U);
  EXPECT_THAT(remarks[0], HasSubstr("material cut through at (2, 1) of crack"));
  EXPECT_THAT(remarks[0], HasSubstr("2 parts"));
  EXPECT_THAT(remarks[0], HasSubstr("4 m2 of region 1"));
  EXPECT_THAT(remarks[0], HasSubstr("12 m2 of region 1"));
}

TEST(CrackFlaws, TwoCracksAndAHoleCutToo) {
  const std::string hole =
      "[[input.curve]]\nname = \"hole\"\nkind = \"polygon\"\nrole = \"hole\"\npoints = [[1, 1], [3, 1], [3, 3], [1, "
      "3]]\n";
  const std::string lines =
      "[[input.curve]]\nname = \"joint\"\nkind = \"line\"\nrole = \"internal\"\npoints = [[0, 3.5], [4, "
      "3.5]]\n[[input.region]]\nname = \"top\"\npoint = [2, 3.7]\n";
  const auto remarks = remarks_of(cracked_square + hole + lines + crack_along("[[0, 2], [1, 2]]") +
                                  "[[input.crack]]\nname = \"other\"\npoints = [[3, 2], [4, 2]]\n");
  ASSERT_EQ(remarks.size(), 1U);
  EXPECT_THAT(remarks[0], HasSubstr("of crack, other"));
  EXPECT_THAT(remarks[0], HasSubstr("6 m2 of region 2"));
  EXPECT_THAT(remarks[0], HasSubstr("6 m2 of region 'top' and region 2"));
}

TEST(CrackFlaws, ACutFromTheVertexWhereTheRimClosesIsToldToo) {
  for (const char* const points : {"[[0, 0], [4, 4]]", "[[4, 4], [0, 0]]", "[[0, 0], [4, 2]]"})
    EXPECT_THAT(remarks_of(cracked_square + crack_along(points)), ElementsAre(HasSubstr("2 parts")));
}

TEST(CrackFlaws, PartsWhereTwoCracksMeetHaveTheirRegion) {
  const auto remarks = remarks_of(cracked_square + crack_along("[[0, 2], [2, 2]]") +
                                  "[[input.crack]]\nname = \"other\"\npoints = [[2, 2], [4, 2]]\n");
  EXPECT_THAT(remarks, ElementsAre(HasSubstr("8 m2 of region 1; 8 m2 of region 1")));
}

}  // namespace
}  // namespace quebra::repair
