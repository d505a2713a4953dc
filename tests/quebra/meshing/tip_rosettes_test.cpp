// The default size of rosettes, on the specimens where it matters.

#include "quebra/meshing/tip_rosettes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/quebra_scenarios.h"

namespace quebra::meshing {
namespace {

using namespace test;
using testing::HasSubstr;

const std::string steps = "[[step]]\noperation = \"analyse\"\n[[step]]\noperation = \"crack\"\n";
std::string mesh(const std::string& params = "") {
  return "[[step]]\noperation = \"mesh\"\norder = \"2\"\nrosettes = \"yes\"\n" + params;
}

/// A crack in a plate 40 wide that is pulled up and down.
std::string plate_with(const std::string& crack) {
  return "[input]\n[[input.curve]]\nname = \"plate\"\nkind = \"polygon\"\npoints = [[-20, -20], [20, -20], [20, 20], "
         "[-20, 20]]\n[[input.crack]]\nname = \"crack\"\n" +
         crack +
         "[[input.point]]\nname = \"a\"\npoint = [-20, -20]\n[[input.point]]\nname = \"b\"\npoint = [20, "
         "-20]\n[[step]]\noperation = \"problem\"\n[[step.material]]\nyoung = 1000.0\n"
         "[[step.support]]\nwhere = \"a\"\nx = 0.0\ny = 0.0\n[[step.support]]\nwhere = \"b\"\ny = "
         "0.0\n[[step.load]]\nwhere = \"plate\"\ny_formula = \"ny\"\n";
}

std::string strip(double a) {
  return "[input]\nspecimen = \"single_edge_notch\"\nwidth = 1.0\nheight = 3.0\ncrack_length = " + std::to_string(a) +
         "\n[[input.point]]\nname = \"anchor\"\npoint = [1, 0]\n[[input.point]]\nname = \"guide\"\npoint = [1, "
         "-1.5]\n[[step]]\noperation = \"problem\"\n[[step.material]]\nyoung = 1.0\n"
         "[[step.support]]\nwhere = \"anchor\"\nx = 0.0\ny = 0.0\n[[step.support]]\nwhere = \"guide\"\nx = "
         "0.0\n[[step.load]]\nwhere = \"top\"\ny = 1.0\n[[step.load]]\nwhere = \"bottom\"\ny = -1.0\n";
}

std::vector<TipRosette> rosettes_of(const std::string& text, double radius = 0.0) {
  const auto done = run(text);
  return tip_rosettes(last(done).domain, {}, {.radius = radius}).value();
}
double radius_of(const TipRosette& rosette) {
  return distance(rosette.rosette.tip, rosette.rosette.rings.front().front());
}

TEST(TipRosettes, TheDefaultRadiusIsAFractionOfTheRoomRoundTheTip) {
  EXPECT_NEAR(radius_of(rosettes_of(strip(0.3)).at(0)), 0.3 / 80, 1e-12);    // the crack
  EXPECT_NEAR(radius_of(rosettes_of(strip(0.95)).at(0)), 0.05 / 80, 1e-12);  // the ligament
  const auto kinked = rosettes_of(plate_with("points = [[-1, 0], [1, 0], [1.02, 0.01]]\n"));
  ASSERT_EQ(kinked.size(), 2U);
  EXPECT_NEAR(radius_of(kinked[1]), std::hypot(0.02, 0.01) / 80, 1e-12);  // the last straight segment
  EXPECT_NEAR(radius_of(kinked[0]), 0.5 * (2 + std::hypot(0.02, 0.01)) / 80, 1e-12);
  // Of two cracks in line, the gap between their tips.
  const auto two = rosettes_of(
      plate_with("points = [[-1, 0], [-0.1, 0]]\n[[input.crack]]\nname = \"other\"\npoints = [[0.1, 0], [1, 0]]\n"));
  EXPECT_NEAR(radius_of(two.at(1)), 0.2 / 80, 1e-12);
}

TEST(TipRosettes, ByDefaultTheThreeMethodsAgreeInShortLigaments) {
  for (const double a : {0.1, 0.7, 0.85, 0.95}) {
    const auto values = figures(run(strip(a) + mesh("size = 0.08\n") + steps));
    const double k = values.at("tip.load.crack_end.K_I");
    EXPECT_NEAR(values.at("tip.load.crack_end.closure.K_I"), k, 2e-3 * k) << a;
    EXPECT_NEAR(values.at("tip.load.crack_end.correlation.K_I"), k, 1e-2 * k) << a;
  }
}

TEST(TipRosettes, KinkedAndCurvedCracksFitByDefault) {
  // The arc of half angle 0.5 on a circle of radius 2 about (0, 0), under tension in every direction (Cotterell and
  // Rice 1980): K_I = sigma sqrt(pi R sin w) cos(w/2) / (1 + sin^2(w/2)), K_II the same with sin(w/2).
  const double w = 0.5, s = std::sin(w / 2), unit = std::sqrt(M_PI * 2 * std::sin(w)) / (1 + s * s);
  std::string arc = plate_with(
      "kind = \"arc\"\ncentre = [0, 0]\npoints = [[0.958851077208406, 1.7551651237807455], [-0.958851077208406, "
      "1.7551651237807455]]\n");
  const std::string along = "y_formula = \"ny\"\n";
  arc.replace(arc.find(along), along.size(), "x_formula = \"nx\"\n" + along);
  const auto values = figures(run(arc + mesh() + steps));
  for (const std::string tip : {"tip.load.crack_start.", "tip.load.crack_end."}) {
    EXPECT_NEAR(values.at(tip + "K_I"), unit * std::cos(w / 2), 5e-3 * unit) << tip;
    EXPECT_NEAR(std::abs(values.at(tip + "K_II")), unit * s, 5e-3 * unit) << tip;
    EXPECT_LT(values.at(tip + "spread"), 1.0) << tip;
  }
  for (const std::string crack :
       {"kind = \"spline\"\npoints = [[-1, 0], [0, 0.3], [1, 0]]\n", "points = [[-1, 0], [1, 0], [1.02, 0.01]]\n",
        "points = [[-1, 0], [1, 0], [1.1, 0.1]]\n"}) {
    const auto bent = figures(run(plate_with(crack) + mesh() + steps));
    for (const std::string tip : {"tip.load.crack_start.", "tip.load.crack_end."}) {
      EXPECT_GT(bent.at(tip + "K_I"), 1.0) << crack;
      EXPECT_LT(bent.at(tip + "spread"), 1.0) << crack;
    }
  }
}

TEST(TipRosettes, ARadiusThatDoesNotFitIsRefusedWithItsPlace) {
  EXPECT_THAT(trouble(strip(0.95) + mesh("tip_radius = 0.02\n") + steps),
              testing::AllOf(HasSubstr("reaches 'right'"), HasSubstr("0.95")));
  EXPECT_THAT(trouble(plate_with("points = [[-1, 0], [1, 0], [1.1, 0.1]]\n") + mesh("tip_radius = 0.1\n") + steps),
              HasSubstr("must be straight in it"));
}

TEST(TipRosettes, OverlappingOnesNameTheTipsTheirDistanceAndTheGreatestRadiusThatKeepsThemApart) {
  // Straight cracks of 0.9 with 0.2 between: rosettes of 0.6 reach beyond the half of each too, but that is not the
  // trouble.
  const auto two = [](const std::string& radius) {
    return plate_with(
               "points = [[-1, 0], [-0.1, 0]]\n[[input.crack]]\nname = \"next\"\npoints = [[0.1, 0], [1, 0]]\n") +
           mesh("tip_radius = " + radius + "\n") + steps;
  };
  EXPECT_THAT(
      trouble(two("0.2")),
      testing::AllOf(HasSubstr("crack tip 'next_start'"),
                     HasSubstr("radius 0.6 m overlaps that of 'crack_end', of radius 0.6 m: the tips are 0.2 m apart"),
                     HasSubstr("up to 0.0333 m")));
  EXPECT_TRUE(figures(run(two("0.0333"))).contains("tip.load.next_start.K_I"));
  EXPECT_THAT(trouble(two("0.0334")), HasSubstr("the tips are 0.2 m apart"));
  // The two ends of one crack.
  EXPECT_THAT(trouble(plate_with("points = [[-0.1, 0], [0.1, 0]]\n") + mesh("tip_radius = 0.05\n") + steps),
              testing::AllOf(HasSubstr("'crack_end'"), HasSubstr("that of 'crack_start'"), HasSubstr("0.2 m apart")));
}

TEST(TipRosettes, APointInOneIsRefusedAndOneAtTheTipKeepsItsName) {
  const auto with = [](double x) {
    return "[input]\nspecimen = \"single_edge_notch\"\n[[input.point]]\nname = \"gauge\"\npoint = [" +
           std::to_string(x) +
           ", 0]\n[[step]]\noperation = \"mesh\"\norder = \"2\"\nrosettes = \"yes\"\ntip_radius = 0.02\n";
  };
  for (const double x : {0.52, 0.48}) {
    const std::string error = trouble(with(x));
    EXPECT_NE(error.find(
                  "point 'gauge': lies within 0.078 m of the tip of 'crack', where the nodes are those of its rosette"),
              std::string::npos)
        << error;
  }
  const dobra::scenario::Run named = run(with(0.5));
  const auto& mesh = last(named).meshes.back()->mesh;
  ASSERT_EQ(mesh.node_sets.at("gauge").size(), 1U);
  EXPECT_EQ(mesh.point(mesh.node_sets.at("gauge").front()), (dobra::geom::Point{0.5, 0.0}));
  EXPECT_EQ(mesh.node_sets.at("gauge").front(), mesh.tips.front().node);
}

}  // namespace
}  // namespace quebra::meshing
