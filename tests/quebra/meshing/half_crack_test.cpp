// Symmetric halves of cracked plates against the whole ones, through the table of operations.

#include "quebra/meshing/half_crack.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/quebra_scenarios.h"

namespace quebra::meshing {
namespace {

using namespace dobra;
using namespace test;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

std::string half_line(const std::string& name, const std::string& points) {
  return "[[input.curve]]\nname = \"" + name + "\"\npoints = " + points + "\n";
}

/// Half of a strip 1 wide and 3 high with an edge crack of 0.4: above (sign 1) or below the line of symmetry. The
/// curves are drawn in either direction.
std::string half_strip(int sign, bool backwards) {
  const std::string far = sign > 0 ? "1.5" : "-1.5";
  return half_line("lip", backwards ? "[[0.4, 0], [0, 0]]" : "[[0, 0], [0.4, 0]]") +
         half_line("ahead", "[[0.4, 0], [1, 0]]") + half_line("right", "[[1, 0], [1, " + far + "]]") +
         half_line("far", "[[1, " + far + "], [0, " + far + "]]") + half_line("left", "[[0, " + far + "], [0, 0]]") +
         "[[input.point]]\nname = \"corner\"\npoint = [1, 0]\n";
}
const std::string material = "[[step.material]]\nyoung = 1.0\nthickness = 0.7\n";
const std::string held =
    "[[step.support]]\nwhere = \"ahead\"\nnormal = 0.0\n[[step.support]]\nwhere = \"corner\"\nx = 0.0\n";
const std::string half = "[[step]]\noperation = \"half_crack\"\nlip = \"lip\"\n";
const std::string half_problem = "[[step]]\noperation = \"problem\"\n" + material;
std::string cracked_half(const std::string& mesh) {
  return "[[step]]\noperation = \"mesh\"\nsize = 0.08\norder = \"2\"\n" + mesh +
         "[[step]]\noperation = \"analyse\"\n[[step]]\noperation = \"crack\"\n";
}

TEST(HalfCrack, OneLipGivesTheIntensitiesOfTheWholeCrackByAllMethods) {
  const std::string whole =
      "[input]\nspecimen = \"single_edge_notch\"\nwidth = 1.0\nheight = 3.0\ncrack_length = 0.4\n[[input.point]]\nname "
      "= \"anchor\"\npoint = [1, 0]\n[[input.point]]\nname = \"guide\"\npoint = [1, -1.5]\n" +
      half_problem +
      "[[step.support]]\nwhere = \"anchor\"\nx = 0.0\ny = 0.0\n[[step.support]]\nwhere = \"guide\"\nx = "
      "0.0\n[[step.load]]\nwhere = \"top\"\ny = 1.0\n[[step.load]]\nwhere = \"bottom\"\ny = -1.0\n" +
      cracked_half("rosettes = \"yes\"\n");
  const auto reference = figures(run(whole));
  const double k = reference.at("tip.load.crack_end.K_I");
  EXPECT_NEAR(k / std::sqrt(0.4 * M_PI), 2.110, 2e-3 * 2.110);
  for (const int sign : {1, -1}) {
    for (const bool backwards : {false, true}) {
      const std::string pull = "[[step.load]]\nwhere = \"far\"\ny = " + std::to_string(sign) + "\n";
      const auto values = figures(
          run(half_strip(sign, backwards) + half + half_problem + held + pull + cracked_half("rosettes = \"yes\"\n")));
      const std::string tip = std::string("tip.load.lip_") + (backwards ? "start." : "end.");
      EXPECT_NEAR(values.at(tip + "K_I"), k, 1e-3 * k) << sign << backwards;
      EXPECT_EQ(values.at(tip + "K_II"), 0.0);
      EXPECT_NEAR(values.at(tip + "J"), reference.at("tip.load.crack_end.J"), 2e-3 * k * k) << sign << backwards;
      EXPECT_NEAR(values.at(tip + "T"), reference.at("tip.load.crack_end.T"), 3e-3) << sign << backwards;
      EXPECT_NEAR(values.at(tip + "closure.K_I"), reference.at("tip.load.crack_end.closure.K_I"), 2e-3 * k)
          << sign << backwards;
      EXPECT_NEAR(values.at(tip + "correlation.K_I"), reference.at("tip.load.crack_end.correlation.K_I"), 2e-3 * k)
          << sign << backwards;
      EXPECT_LT(values.at(tip + "spread"), 1.2) << sign << backwards;
      EXPECT_EQ(values.at(tip + "kink.sigma_theta"), 0.0);
      // Half the elements hold half the energy.
      EXPECT_NEAR(2.0 * values.at("case.load.energy"), reference.at("case.load.energy"),
                  1e-4 * reference.at("case.load.energy"));
    }
  }
}

TEST(HalfCrack, PressureOnTheOnlyLipIsAsGoodAsTensionFarAway) {
  const auto far = figures(run(half_strip(1, false) + half + half_problem + held +
                               "[[step.load]]\nwhere = \"far\"\ny = 1.0\n" + cracked_half("rosettes = \"yes\"\n")));
  const auto near = figures(run(half_strip(1, false) + half + half_problem + held +
                                "[[step.load]]\nwhere = \"lip\"\nkind = \"pressure\"\nvalue = 1.0\n" +
                                cracked_half("rosettes = \"yes\"\n")));
  for (const char* const name : {"K_I", "closure.K_I", "correlation.K_I", "T", "J"}) {
    const std::string quantity = std::string("tip.load.lip_end.") + name;
    EXPECT_NEAR(near.at(quantity), far.at(quantity), 1e-3 * std::max(1.0, std::abs(far.at(quantity)))) << name;
  }
}

TEST(HalfCrack, WithoutRosettesAndInTheAdaptiveLoopTheTipIsOneToo) {
  const std::string pull = "[[step.load]]\nwhere = \"far\"\ny = 1.0\n";
  const auto plain = figures(run(half_strip(1, false) + half + half_problem + held + pull + cracked_half("")));
  EXPECT_NEAR(plain.at("tip.load.lip_end.K_I"), 2.110 * std::sqrt(0.4 * M_PI), 0.05 * 2.365);
  const auto adapted = figures(
      run(half_strip(1, false) + half + half_problem + held + pull +
          "[[step]]\noperation = \"adapt\"\ntarget = 5.0\nrosettes = \"yes\"\n[[step]]\noperation = \"crack\"\n"));
  EXPECT_LE(adapted.at("eta"), 5.0);
  EXPECT_NEAR(adapted.at("tip.load.lip_end.K_I"), 2.110 * std::sqrt(0.4 * M_PI), 1e-2 * 2.365);
}

TEST(HalfCrack, BothEndsOfALipInsideTheLineAreTips) {
  const std::string input = half_line("before", "[[-1, 0], [-0.2, 0]]") + half_line("lip", "[[-0.2, 0], [0.2, 0]]") +
                            half_line("after", "[[0.2, 0], [1, 0]]") +
                            half_line("rest", "[[1, 0], [1, 3], [-1, 3], [-1, 0]]") +
                            "[[input.curve]]\nname = \"mark\"\nrole = \"internal\"\npoints = [[-1, 2], [1, "
                            "2]]\n[[input.point]]\nname = \"corner\"\npoint = [1, 0]\n";
  const std::string loads =
      "[[step.support]]\nwhere = \"before\"\nnormal = 0.0\n[[step.support]]\nwhere = \"after\"\nnormal = "
      "0.0\n[[step.support]]\nwhere = \"corner\"\nx = 0.0\n[[step.load]]\nwhere = \"lip\"\nkind = \"pressure\"\nvalue "
      "= 1.0\n";
  const auto values = figures(run(input + half + half_problem + loads + cracked_half("rosettes = \"yes\"\n")));
  // Tada: centre crack, a/W = 0.2, under pressure as under tension.
  for (const char* const tip : {"tip.load.lip_start.", "tip.load.lip_end."})
    EXPECT_NEAR(values.at(std::string(tip) + "K_I") / std::sqrt(0.2 * M_PI), 1.02448, 2e-3) << tip;
}

TEST(HalfCrack, FaultsAreNamed) {
  const std::string input = half_strip(1, false);
  EXPECT_THAT(trouble(input + "[[step]]\noperation = \"half_crack\"\nlip = \"lib\"\n"),
              HasSubstr("there is no curve 'lib' on the boundary; did you mean 'lip'?"));
  EXPECT_THAT(trouble(input + "[[step]]\noperation = \"half_crack\"\nlip = \"right\"\n"),
              HasSubstr("curve 'right': the boundary goes straight on at neither end"));
  EXPECT_THAT(
      trouble(input + half + "[[step]]\noperation = \"mesh\"\norder = \"2\"\nrosettes = \"yes\"\ntip_radius = 0.2\n"),
      HasSubstr("the rosette of radius 0.6 m does not fit"));
  const std::string loose =
      "[[step.support]]\nwhere = \"far\"\nx = 0.0\ny = 0.0\n[[step.load]]\nwhere = \"lip\"\nkind = \"pressure\"\nvalue "
      "= 1.0\n";
  EXPECT_THAT(trouble(input + half + half_problem + loose + cracked_half("rosettes = \"yes\"\n")),
              HasSubstr("crack tip 'lip_end': the line of symmetry ahead of the lip is not held across"));
}

TEST(HalfCrack, TheSurroundingsOfAForceOnTheLipEndBeforeTheTip) {
  // Half of a crack of half length 1 with wedge forces at 0.5, in a plate 40 times as wide.
  const auto pushed = [](const std::string& judged) {
    return run(
        half_line("lip", "[[-1, 0], [1, 0]]") + half_line("ahead", "[[1, 0], [40, 0]]") +
        half_line("rim", "[[40, 0], [40, 40], [-40, 40], [-40, 0]]") + half_line("behind", "[[-40, 0], [-1, 0]]") +
        "[[input.point]]\nname = \"p\"\npoint = [0.98, 0]\n[[input.point]]\nname = \"corner\"\npoint = [40, 0]\n" +
        half + "[[step]]\noperation = \"problem\"\n[[step.material]]\nyoung = 100.0\n" +
        "[[step.support]]\nwhere = \"ahead\"\nnormal = 0.0\n[[step.support]]\nwhere = \"behind\"\nnormal = "
        "0.0\n[[step.support]]\nwhere = \"corner\"\nx = 0.0\n" +
        "[[step.load]]\nkind = \"force\"\nwhere = \"p\"\ny = 1.0\n[[step]]\noperation = \"mesh\"\nsize = 8.0\norder = "
        "\"2\"\nrosettes = \"yes\"\n[[step]]\noperation = \"analyse\"\n" +
        judged + "[[step]]\noperation = \"crack\"\n");
  };
  const scenario::Run done = pushed("");
  const auto& loaded = last(done).analyses.back()->fields.front().loaded;
  ASSERT_EQ(loaded.size(), 1u);
  EXPECT_NEAR(loaded.front().radius, 0.02 / 20.0, 1e-9);
  EXPECT_THAT(last(done).remarks, Not(Contains(HasSubstr("hold the crack tip"))));
  for (const auto& [tip, sign] : {std::pair{"lip_end", 1.0}, {"lip_start", -1.0}}) {
    const double exact = std::sqrt((1.0 + sign * 0.98) / (1.0 - sign * 0.98) / M_PI);
    EXPECT_NEAR(figures(done).at(std::string("tip.load.") + tip + ".K_I"), exact, 0.005 * exact) << tip;
    EXPECT_NEAR(figures(done).at(std::string("tip.load.") + tip + ".J"), exact * exact / 100.0,
                0.01 * exact * exact / 100.0)
        << tip;
  }
  EXPECT_THAT(
      last(pushed("point_radius = 0.05\n")).remarks,
      Contains(AllOf(HasSubstr("the surroundings of 'p', of radius 0.05 m, hold the crack tip 'lip_end' at (1, 0)"),
                     HasSubstr("below 0.02 m"))));
}

}  // namespace
}  // namespace quebra::meshing
