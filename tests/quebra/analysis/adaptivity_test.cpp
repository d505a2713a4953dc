// The adaptive loop where its error is known: exactly (the field of a crack tip), or from a mesh far finer than the one
// that is judged, on specimens that none of its constants was chosen on.

#include "quebra/analysis/adaptivity.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <string>
#include <vector>

#include "shared/fem/error/exact_fields.h"
#include "tests/support/quebra_scenarios.h"

namespace quebra::analysis {
namespace {

using namespace dobra;
using namespace test;
using testing::HasSubstr;

std::string long_adapt_step(double target, const std::string& more = "") {
  return "[[step]]\noperation = \"adapt\"\ntarget = " + std::to_string(target) + "\nmax_cycles = 16\n" + more;
}

/// Crack from the left edge to the middle of a square, loaded by the tractions of K_I = 1 alone.
const std::string tip_plate = R"toml([[input.curve]]
name = "rim"
points = [[-1, 0], [-1, -1], [1, -1], [1, 1], [-1, 1], [-1, 0]]
[[input.crack]]
name = "crack"
points = [[-1, 0], [0, 0]]
[[input.point]]
name = "anchor"
point = [1, -1]
[[input.point]]
name = "guide"
point = [1, 1]
[[step]]
operation = "problem"
state = "strain"
[[step.material]]
young = 1.0
poisson = 0.3
[[step.support]]
where = "anchor"
x = 0.0
y = 0.0
[[step.support]]
where = "guide"
x = 0.0
[[step.load]]
where = "rim"
kind = "stress"
stress_xx = "cos(atan2(y,x)/2) * (1 - sin(atan2(y,x)/2) * sin(1.5*atan2(y,x))) / sqrt(2*pi*hypot(x,y))"
stress_yy = "cos(atan2(y,x)/2) * (1 + sin(atan2(y,x)/2) * sin(1.5*atan2(y,x))) / sqrt(2*pi*hypot(x,y))"
stress_xy = "cos(atan2(y,x)/2) * sin(atan2(y,x)/2) * cos(1.5*atan2(y,x)) / sqrt(2*pi*hypot(x,y))"
)toml";

/// Half the work of the tractions along the rim, by the midpoint rule.
double tip_plate_energy() {
  const fem::Material material{.young = 1.0, .poisson = 0.3, .state = fem::PlaneState::Strain};
  const std::vector<geom::Point> rim{{-1, -0.0}, {-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, 0}};
  constexpr int steps = 20000;
  double work = 0.0;
  for (std::size_t i = 0; i + 1 < rim.size(); ++i) {
    const geom::Vector side = rim[i + 1] - rim[i];
    const geom::Vector normal = -1.0 * left_of(normalised(side));
    for (int k = 0; k < steps; ++k) {
      const geom::Point p = interpolate(rim[i], rim[i + 1], (k + 0.5) / steps);
      const fem::Voigt s = fem::error::tip_field(p, fem::error::TipLoad::Opening, material).stress;
      const geom::Vector traction{s[0] * normal.x + s[2] * normal.y, s[2] * normal.x + s[1] * normal.y};
      work +=
          dot(traction, fem::error::tip_displacement(p, fem::error::TipLoad::Opening, material)) * length(side) / steps;
    }
  }
  return 0.5 * work;
}

TEST(Adaptivity, WithRosettesTheLoopReachesTheErrorAskedForAndJudgesItWithinATenth) {
  const double energy = tip_plate_energy();
  double before = 0.0;
  for (const double target : {5.0, 2.0, 1.0, 0.5, 0.2}) {
    if (target < 0.5 && std::getenv("DOBRA_LONG_TESTS") == nullptr) continue;
    const scenario::Run done =
        run(tip_plate + long_adapt_step(target, "rosettes = \"yes\"\n") + "[[step]]\noperation = \"crack\"\n");
    const auto values = figures(done);
    const Analysis& analysis = *last(done).analyses.back();
    EXPECT_LE(values.at("eta"), target);
    const double exact = fem::error::true_error(energy, values.at("case.load.energy"));
    const double effectivity = values.at("case.load.error") / exact;
    EXPECT_NEAR(effectivity, 1.0, 0.1) << target;
    EXPECT_NEAR(values.at("tip.load.crack_end.K_I"), 1.0, 1e-3) << target;
    // Twice the unknowns, half the error: the rate of an order of two, which no fixed rosette could have.
    if (before > 0.0) {
      EXPECT_LT(unknowns_of(analysis), 4.0 * before) << target;
    }
    before = unknowns_of(analysis);
    printf(
        "[ figures  ] tip with rosettes to %g %%: cycles %g, unknowns %g, eta %.3f %%, effectivity %.3f, K_I %.5f, "
        "spread %.2f %%\n",
        target, values.at("cycles"), unknowns_of(analysis), values.at("eta"), effectivity,
        values.at("tip.load.crack_end.K_I"), values.at("tip.load.crack_end.spread"));
  }
}

/// Long ones run where the environment has DOBRA_LONG_TESTS.
enum class Runs { Always, Long };

struct Specimen {
  const char* name;
  Runs in;
  std::string text;
};

std::string point(const char* name, double x, double y) {
  return "[[input.point]]\nname = \"" + std::string(name) + "\"\npoint = [" + std::to_string(x) + ", " +
         std::to_string(y) + "]\n";
}
const std::string beam_problem = "[[step]]\noperation = \"problem\"\n[[step.material]]\nyoung = 1.0\npoisson = 0.3\n";
std::string support(const char* where, const char* what) {
  return "[[step.support]]\nwhere = \"" + std::string(where) + "\"\n" + what + "\n";
}
std::string load(const char* where, const char* what) {
  return "[[step.load]]\nwhere = \"" + std::string(where) + "\"\n" + what + "\n";
}

/// Neither Kirsch's plate nor the L-shapes, on which the constants were chosen.
std::vector<Specimen> unseen_specimens() {
  const std::string held = support("anchor", "x = 0.0\ny = 0.0") + support("guide", "x = 0.0");
  const std::string pulled = load("top", "y = 1.0") + load("bottom", "y = -1.0");
  const std::string lips =
      load("crack_left", "kind = \"pressure\"\nvalue = 1.0") + load("crack_right", "kind = \"pressure\"\nvalue = 1.0");
  const std::string quarter =
      support("bottom", "normal = 0.0") + support("left", "normal = 0.0") + load("right", "x = 1.0");
  return {
      {"Cook's membrane", Runs::Always,
       "[input]\nspecimen = \"cook\"\n" + beam_problem + support("left", "x = 0.0\ny = 0.0") +
           load("right", "y = 0.0625")},
      {"hole, d/W 0.3", Runs::Always,
       "[input]\nspecimen = \"quarter_plate\"\nwidth = 4.0\nheight = 1.0\nradius = 0.3\n" + beam_problem + quarter},
      {"hole, d/W 0.7", Runs::Long,
       "[input]\nspecimen = \"quarter_plate\"\nwidth = 4.0\nheight = 1.0\nradius = 0.7\n" + beam_problem + quarter},
      {"edge crack", Runs::Long,
       "[input]\nspecimen = \"single_edge_notch\"\n" + point("anchor", 1, 0) + point("guide", 1, -1.5) + beam_problem +
           held + pulled},
      {"two edge cracks", Runs::Long,
       "[input]\nspecimen = \"double_edge_notch\"\n" + point("anchor", 1, -1.5) + point("guide", 1, 1.5) +
           beam_problem + held + pulled},
      {"compact tension", Runs::Long,
       "[input]\nspecimen = \"compact_tension\"\nwidth = 1.0\n" + point("anchor", 1, 0) + point("guide", 1, 0.6) +
           beam_problem + held + load("pin_upper", "y = 1.0") + load("pin_lower", "y = -1.0")},
      {"inclined crack in a disc", Runs::Long,
       "[input]\nspecimen = \"brazilian_disc\"\nangle = 30.0\n" + beam_problem + support("load_upper", "x = 0.0") +
           support("load_lower", "x = 0.0\ny = 0.0") + lips},
      {"double cantilever", Runs::Long,
       "[input]\nspecimen = \"double_cantilever\"\n" + point("anchor", 100, -10) + point("guide", 100, 10) +
           beam_problem + held + lips},
  };
}

TEST(Adaptivity, OnSpecimensThatNoConstantWasChosenOnTheErrorIsJudgedWell) {
  double least = 1e300, most = 0.0;
  for (const Specimen& specimen : unseen_specimens()) {
    if (specimen.in == Runs::Long && std::getenv("DOBRA_LONG_TESTS") == nullptr) continue;
    const bool crack =
        specimen.text.find("quarter_plate") == std::string::npos && specimen.text.find("cook") == std::string::npos;
    const scenario::Run fine = run(specimen.text + long_adapt_step(0.3, "peaks = \"no\"\n"));
    const Analysis& finest = *last(fine).analyses.back();
    // What little the fine mesh lacks is what it estimates itself.
    const double energy = finest.solution.cases[0].energy + 0.5 * std::pow(finest.fields[0].estimate.error, 2);
    for (const char* const kind : {"order = \"1\"\n", "order = \"2\"\n", "rosettes = \"yes\"\n"}) {
      const std::string more = kind;
      if (more.starts_with("rosettes") && !crack) continue;
      for (const double target : {5.0, 1.0}) {
        if (target == 1.0 && more.starts_with("order = \"1")) continue;
        const auto values = figures(run(specimen.text + long_adapt_step(target, more)));
        const double effectivity =
            values.at("case.load.error") / fem::error::true_error(energy, values.at("case.load.energy"));
        EXPECT_LE(values.at("eta"), target) << specimen.name << ' ' << kind;
        EXPECT_GT(effectivity, target == 5.0 ? 0.7 : 0.85)
            << specimen.name << ' ' << kind << target;  // a few dozen elements, a few hundred
        EXPECT_LT(effectivity, 1.2) << specimen.name << ' ' << kind << target;
        least = std::min(least, effectivity);
        most = std::max(most, effectivity);
        printf("[ figures  ] %s, %s, %g %%: cycles %g, unknowns %g, eta %.2f %%, effectivity %.3f\n", specimen.name,
               more.starts_with("rosettes")      ? "T6 and rosettes"
               : more.starts_with("order = \"1") ? "T3"
                                                 : "T6",
               target, values.at("cycles"), values.at("unknowns"), values.at("eta"), effectivity);
      }
    }
  }
  printf("[ figures  ] effectivity from %.3f to %.3f\n", least, most);
}

TEST(Adaptivity, OneCycleAtATimeIsTheSameLoopAndEveryCycleCanBeDrawn) {
  const std::string plate = "[input]\nspecimen = \"quarter_plate\"\nwidth = 4.0\nheight = 1.0\nradius = 0.3\n" +
                            beam_problem + support("bottom", "normal = 0.0") + support("left", "normal = 0.0") +
                            load("right", "x = 1.0");
  const scenario::Run whole = run(plate + long_adapt_step(1.0));
  const std::size_t cycles = last(whole).analyses.size();
  ASSERT_GT(cycles, 2U);
  const std::string one = "[[step]]\noperation = \"adapt\"\ntarget = 1.0\nmax_cycles = 1\n";
  std::string steps = plate + one;
  for (std::size_t i = 1; i < cycles + 1; ++i) steps += one + "from = \"last\"\n";  // one more: nothing left to do
  const scenario::Run stepped = run(steps + "[[step]]\noperation = \"view\"\ncycle = 1\n");
  ASSERT_TRUE(stepped.complete()) << to_string(*stepped.error);
  ASSERT_EQ(last(stepped).analyses.size(), cycles);
  for (std::size_t i = 0; i < cycles; ++i) {
    EXPECT_EQ(last(stepped).analyses[i]->cycle, static_cast<int>(i) + 1);
    EXPECT_EQ(last(stepped).analyses[i]->eta, last(whole).analyses[i]->eta);
  }
  EXPECT_THAT(trouble(plate + one + "from = \"last\"\n"), HasSubstr("there is no cycle to go on from"));
  EXPECT_THAT(trouble(plate + one + "[[step]]\noperation = \"view\"\ncycle = 7\n"),
              HasSubstr("there is no cycle 7: the last is 1"));
}

TEST(Adaptivity, APeakIsAskedForTheSameErrorAsTheWholeUnlessTheUserSaysNo) {
  // A small hole holds little of the energy.
  const std::string plate = "[input]\nspecimen = \"quarter_plate\"\nwidth = 4.0\nheight = 1.0\nradius = 0.1\n" +
                            beam_problem + support("bottom", "normal = 0.0") + support("left", "normal = 0.0") +
                            load("right", "x = 1.0");
  const auto with = figures(run(plate + long_adapt_step(2.0)));
  const auto without = figures(run(plate + long_adapt_step(2.0, "peaks = \"no\"\n")));
  EXPECT_LE(with.at("peak_eta"), 2.0);
  EXPECT_GT(without.at("peak_eta"), 2.0);
  EXPECT_NEAR(with.at("case.load.max_principal"), 3.035, 0.02 * 3.035);
  printf(
      "[ figures  ] hole, d/W 0.1, 2 %%: stress %.3f minding peaks, unknowns %g; %.3f, unknowns %g without; reference "
      "3.035\n",
      with.at("case.load.max_principal"), with.at("unknowns"), without.at("case.load.max_principal"),
      without.at("unknowns"));
}

TEST(Adaptivity, AnInfiniteStressThatNoRuleFindsDoesNotKeepTheLoopGoing) {
  // Where two materials meet at a free edge the stress is infinite, and no rule of corners knows it.
  const std::string plate = R"([input]
[[input.curve]]
name = "bottom"
points = [[0, 0], [2, 0]]
[[input.curve]]
name = "right"
points = [[2, 0], [2, 1]]
[[input.curve]]
name = "top"
points = [[2, 1], [0, 1]]
[[input.curve]]
name = "left"
points = [[0, 1], [0, 0]]
[[input.curve]]
name = "joint"
role = "internal"
points = [[1, 0], [1, 1]]
[[input.region]]
name = "soft"
point = [0.5, 0.5]
[[input.region]]
name = "hard"
point = [1.5, 0.5]
[[step]]
operation = "problem"
[[step.material]]
region = "soft"
young = 1.0
poisson = 0.45
[[step.material]]
region = "hard"
young = 100.0
poisson = 0.1
[[step.support]]
where = "left"
normal = 0.0
[[step.support]]
where = "bottom"
normal = 0.0
[[step.load]]
where = "right"
x = 1.0
)";
  const scenario::Run done = run(plate + long_adapt_step(1.0));
  const auto values = figures(done);
  EXPECT_LE(values.at("eta"), 1.0);
  EXPECT_LE(values.at("cycles"), 6.0);
  EXPECT_THAT(last(done).remarks, testing::Contains(HasSubstr("the stress at (1, 1) does not settle")));
  // Cycle by cycle it is not minded either, and told once.
  const std::string one = "[[step]]\noperation = \"adapt\"\ntarget = 1.0\nmax_cycles = 1\n";
  const std::size_t cycles = last(done).analyses.size();
  std::string steps = plate + one;
  for (std::size_t i = 1; i < cycles + 1; ++i) steps += one + "from = \"last\"\n";
  const scenario::Run stepped = run(steps);
  ASSERT_TRUE(stepped.complete()) << to_string(*stepped.error);
  ASSERT_EQ(last(stepped).analyses.size(), cycles);
  EXPECT_EQ(last(stepped).analyses.back()->eta, last(done).analyses.back()->eta);
  const auto& remarks = last(stepped).remarks;
  EXPECT_EQ(std::count_if(remarks.begin(), remarks.end(),
                          [](const std::string& text) { return text.find("does not settle") != std::string::npos; }),
            1);
}

TEST(Adaptivity, EveryTipHasARosetteOfItsOwn) {
  // A long crack and one of a tenth: what the short one needs is not asked of the long one.
  const std::string plate =
      "[input]\nspecimen = \"single_edge_notch\"\n[[input.crack]]\nname = \"short\"\npoints = [[0, 1], [0.05, 1]]\n" +
      point("anchor", 1, 0) + point("guide", 1, -1.5) + beam_problem + support("anchor", "x = 0.0\ny = 0.0") +
      support("guide", "x = 0.0") + load("top", "y = 1.0") + load("bottom", "y = -1.0");
  const scenario::Run done =
      run(plate + long_adapt_step(0.3, "rosettes = \"yes\"\ntip_radius = 0.008\npeaks = \"no\"\n"));
  EXPECT_LE(figures(done).at("eta"), 0.3);
  const auto& mesh = last(done).analyses.back()->meshed->mesh;
  std::vector<double> radii;
  for (const mesh::CrackTip& tip : mesh.tips) {
    double radius = 0.0;
    for (std::size_t e = 0; e < mesh.element_count(); ++e) {
      const auto corners = mesh.nodes_of(mesh::ElementId(e)).first(3);
      if (std::find(corners.begin(), corners.end(), tip.node) == corners.end()) continue;
      for (const mesh::NodeId node : corners)
        radius = std::max(radius, distance(mesh.point(node), mesh.point(tip.node)));
    }
    radii.push_back(radius);
    printf("[ figures  ] %s: tip elements of %.3g\n", tip.name.c_str(), radius);
  }
  ASSERT_EQ(radii.size(), 2U);
  EXPECT_GT(std::max(radii[0], radii[1]), 2.0 * std::min(radii[0], radii[1]));
}

TEST(Adaptivity, APeakThatComesUpOrMovesIsNoStall) {
  const std::string disc =
      "[input]\nspecimen = \"brazilian_disc\"\nangle = 20.0\n[[step]]\noperation = "
      "\"problem\"\n[[step.material]]\nyoung = 1000.0\npoisson = 0.3\n"
      "[[step.support]]\nwhere = \"load_lower\"\nx = 0.0\ny = 0.0\n[[step.support]]\nwhere = \"load_upper\"\nx = "
      "0.0\n[[step.load]]\nwhere = \"load_upper\"\nkind = \"force\"\ny = -1.0\n";
  const std::string plate =
      "[input]\nspecimen = \"quarter_plate\"\nwidth = 4.0\nradius = 1.0\n[[step]]\noperation = \"problem\"\nstate = "
      "\"stress\"\n[[step.material]]\nyoung = 1000.0\npoisson = 0.3\n"
      "[[step.support]]\nwhere = \"left\"\nnormal = 0.0\n[[step.support]]\nwhere = \"bottom\"\nnormal = 0.0\n"
      "[[step.load]]\nwhere = \"right\"\nkind = \"kirsch\"\nvalue = 1.0\nradius = 1.0\n[[step.load]]\nwhere = "
      "\"top\"\nkind = \"kirsch\"\nvalue = 1.0\nradius = 1.0\n";
  for (const double target : {7.0, 6.0, 5.0})
    EXPECT_FALSE(last(run(disc + long_adapt_step(target))).short_of_target) << target;
  for (const double target : {10.0, 8.0, 5.0}) {
    for (const char* const rule : {"rule = \"equal\"\n", "rule = \"optimal\"\n"})
      EXPECT_FALSE(last(run(plate + long_adapt_step(target, std::string("order = \"1\"\n") + rule))).short_of_target)
          << target << ' ' << rule;
  }
}

const Specimen& specimen(const std::vector<Specimen>& all, const std::string& name) {
  return *std::find_if(all.begin(), all.end(), [&](const Specimen& own) { return own.name == name; });
}

TEST(Adaptivity, NoCycleHasManyMoreUnknownsThanTheLast) {
  // Where the stress is infinite the error falls slowly at first; that is no ground to refine all the rest.
  const auto all = unseen_specimens();
  const bool long_ones = std::getenv("DOBRA_LONG_TESTS") != nullptr;
  for (const char* const name : {"edge crack", "inclined crack in a disc", "Cook's membrane", "hole, d/W 0.3"}) {
    for (const char* const more : {"", "rosettes = \"yes\"\n"}) {
      if (*more != 0 && std::string(name).find("crack") == std::string::npos) continue;
      for (const double target : {5.0, 1.0, 0.1}) {
        if (target < 1.0 && !long_ones) continue;
        const scenario::Run done = run(specimen(all, name).text + long_adapt_step(target, more));
        const auto& analyses = last(done).analyses;
        double most = 0.0;
        for (const auto& analysis : analyses) most = std::max(most, unknowns_of(*analysis));
        EXPECT_FALSE(last(done).short_of_target) << name << ' ' << more << target;
        EXPECT_LE(most, 1.5 * unknowns_of(*analyses.back())) << name << ' ' << more << target;
        EXPECT_LE(analyses.size(), 8U) << name << ' ' << more << target;
        printf("[ figures  ] %s%s to %g %%: cycles %zu, unknowns %g, at most %g, eta %.3f %%\n", name,
               *more != 0 ? ", rosettes" : "", target, analyses.size(), unknowns_of(*analyses.back()), most,
               100.0 * analyses.back()->eta);
      }
    }
  }
}

struct Known {
  const char* name;
  std::string text;
  double energy = 0.0;  ///< Exact, J.
};

/// Problems with an energy in closed form.
std::vector<Known> known_energies() {
  const std::string kirsch =
      "[input]\nspecimen = \"quarter_plate\"\nwidth = 4.0\nradius = 1.0\n[[step]]\noperation = \"problem\"\nstate = "
      "\"strain\"\n[[step.material]]\nyoung = 1000.0\npoisson = 0.3\n" +
      support("left", "normal = 0.0") + support("bottom", "normal = 0.0") +
      load("right", "kind = \"kirsch\"\nvalue = 1.0\nradius = 1.0") +
      load("top", "kind = \"kirsch\"\nvalue = 1.0\nradius = 1.0");
  const std::string corner =
      "[[input.curve]]\nname = \"face_1\"\npoints = [[0, 0], [1, 0]]\n[[input.curve]]\nname = \"loaded\"\npoints = "
      "[[1, 0], [1, 1], [-1, 1], [-1, -1], [0, -1]]\n"
      "[[input.curve]]\nname = \"face_2\"\npoints = [[0, -1], [0, 0]]\n" +
      point("origin", 0, 0) + point("far", 0, 1) +
      "[[step]]\noperation = \"problem\"\nstate = \"strain\"\n[[step.material]]\nyoung = 1.0\n" +
      support("origin", "x = 0.0\ny = 0.0") + support("far", "x = 0.0") + load("loaded", "kind = \"l_shape\"");
  return {{"plate with a hole", kirsch, 0.00769365372642},
          {"corner of 270 degrees", corner, 4.15454423},
          {"crack tip", tip_plate, tip_plate_energy()}};
}

/// The true error, %.
double true_eta(const Analysis& analysis, double energy) {
  return 100.0 * fem::error::true_error(energy, analysis.solution.cases[0].energy) / std::sqrt(2.0 * energy);
}

TEST(Adaptivity, WhatIsReachedIsReachedInTruth) {
  for (const Known& known : known_energies()) {
    for (const char* const more : {"order = \"1\"\n", "", "rosettes = \"yes\"\n"}) {
      if (std::string(more).starts_with("rosettes") && known.text != tip_plate) continue;
      for (const double target : {10.0, 5.0, 2.0, 1.0, 0.5}) {
        if (std::string(more).starts_with("order") && target < 5.0) continue;
        const scenario::Run done = run(known.text + long_adapt_step(target, more));
        ASSERT_TRUE(done.complete()) << known.name;
        const Analysis& analysis = *last(done).analyses.back();
        EXPECT_FALSE(last(done).short_of_target) << known.name << ' ' << more << target;
        EXPECT_LE(true_eta(analysis, known.energy), target) << known.name << ' ' << more << target;
        printf("[ figures  ] %s, %sto %g %%: cycles %zu, unknowns %g, eta %.3f %%, true %.3f %%\n", known.name,
               *more == 'o'   ? "T3 "
               : *more == 'r' ? "rosettes "
                              : "",
               target, last(done).analyses.size(), unknowns_of(analysis), 100.0 * analysis.eta,
               true_eta(analysis, known.energy));
      }
    }
  }
}

/// A strip held between two platens, on a first mesh so coarse that the estimate sees half of the error at the clamped
/// corners. The energy is that of a mesh of size 0.05; CalculiX has it from the same deck.
TEST(Adaptivity, WhatIsReachedAtClampedCornersIsReachedInTruth) {
  const std::string text =
      "[[input.curve]]\nname = \"plate\"\nkind = \"polygon\"\npoints = [[0, 0], [10, 0], [10, 3], [0, 3]]\n"
      "[[step]]\noperation = \"problem\"\nstate = \"strain\"\n[[step.material]]\nyoung = 1000.0\n"
      "[[step.support]]\nwhere = \"y = 0\"\nx = 0.0\ny = 0.0\n"
      "[[step.support]]\nwhere = \"y = 3\"\nx = 0.0\ny = 0.01\n";
  const double energy = 0.210589;
  for (const double target : {10.0, 5.0, 4.0, 3.0, 2.0}) {
    const scenario::Run done = run(text + long_adapt_step(target, ""));
    ASSERT_TRUE(done.complete()) << target;
    const Analysis& analysis = *last(done).analyses.back();
    const double error = std::sqrt(std::abs(analysis.solution.cases[0].energy - energy) / energy);
    printf("[ figures  ] strip to %g %%: cycles %zu, unknowns %g, eta %.3f %%, true %.3f %%\n", target,
           last(done).analyses.size(), unknowns_of(analysis), 100.0 * analysis.eta, 100.0 * error);
    EXPECT_FALSE(last(done).short_of_target) << target;
    EXPECT_LE(100.0 * error, target) << target;
  }
}

/// A cantilever whose second mesh has 0.6 of the true error: what the loop cannot tell, it says.
TEST(Adaptivity, WhatMayNotBeReachedAtClampedCornersIsSaid) {
  const std::string text =
      "[[input.curve]]\nname = \"plate\"\nkind = \"polygon\"\npoints = [[0, 0], [10, 0], [10, 2], [0, 2]]\n"
      "[[step]]\noperation = \"problem\"\n[[step.material]]\nyoung = 1000.0\n"
      "[[step.support]]\nwhere = \"x = 0\"\nx = 0.0\ny = 0.0\n[[step.load]]\nwhere = \"x = 10\"\ny = 1.0\n";
  const double energy = 1.0275206;  // of a mesh of size 0.05, and of CalculiX
  for (const double target : {10.0, 5.0, 4.0, 3.0, 2.0, 1.0}) {
    const scenario::Run done = run(text + long_adapt_step(target, ""));
    ASSERT_TRUE(done.complete()) << target;
    const std::string last_remark = last(done).remarks.empty() ? "" : last(done).remarks.back();
    const bool said = last_remark.find("corners of infinite stress") != std::string::npos;
    EXPECT_TRUE(said || last(done).short_of_target || true_eta(*last(done).analyses.back(), energy) <= target)
        << target;
    if (target == 3.0 || target == 10.0) {
      EXPECT_EQ(said, target == 3.0);
    }
  }
}

TEST(Adaptivity, AnEstimateBelowTheTargetIsNotReachedWithoutItsMargin) {
  for (const Known& known : known_energies()) {
    const auto once = [&](double target) {
      return run(known.text + "[[step]]\noperation = \"adapt\"\nmax_cycles = 1\ntarget = " + std::to_string(target) +
                 "\n");
    };
    const double eta = figures(once(90.0)).at("eta");
    const scenario::Run near = once(1.05 * eta);
    EXPECT_TRUE(last(near).short_of_target) << known.name;
    EXPECT_THAT(last(near).remarks.back(), HasSubstr("for the estimate may be low")) << known.name;
  }
}

TEST(Adaptivity, WhatDoesNotFitIntoMemoryLeavesTheCyclesBeforeIt) {
  const std::string text = sheared_l;
  const scenario::Run done = run(text + long_adapt_step(0.05, "memory = 6e6\n"));
  const auto values = figures(done);
  EXPECT_TRUE(last(done).short_of_target);
  EXPECT_GT(last(done).analyses.size(), 1U);
  EXPECT_LT(values.at("eta"), 5.0);
  EXPECT_THAT(last(done).remarks.back(), HasSubstr("GB are allowed"));
  for (const auto& analysis : last(done).analyses) EXPECT_LE(analysis->solution.statistics.memory_estimate, 6e6);
}

TEST(Adaptivity, WhoStopsTheLoopKeepsItsCyclesAndTheyAreNotRemembered) {
  const auto document =
      scenario::parse_document("dobra = 1\nprogram = \"quebra\"\n" + sheared_l + long_adapt_step(0.5), "test.toml")
          .value();
  scenario::Runner runner(core::program());
  const base::CancelToken token;
  std::vector<std::string> told;
  const scenario::Run stopped = runner.run(document, base::Progress(token, [&](double, const std::string& what) {
                                             if (what.ends_with('\n')) told.push_back(what);
                                             if (told.size() == 2) token.cancel();
                                           }));
  ASSERT_EQ(last(stopped).analyses.size(), 2U);
  EXPECT_TRUE(last(stopped).short_of_target);
  EXPECT_THAT(last(stopped).remarks.back(), HasSubstr("cycle 3 could not be finished: interrupted"));
  EXPECT_THAT(told.front(), HasSubstr("cycle 1: "));
  const scenario::Run whole = runner.run(document);
  EXPECT_GT(last(whole).analyses.size(), 2U);
  EXPECT_FALSE(last(whole).short_of_target);
}

/// A plate with a hole in plane strain, pulled on two sides.
std::string holed(double width, double height, double radius) {
  const auto number = [](double value) { return std::to_string(value); };
  const std::string x = number(-0.5 * width), y = number(0.5 * height);
  return "[input]\nspecimen = \"plate_with_hole\"\nwidth = " + number(width) + "\nheight = " + number(height) +
         "\nradius = " + number(radius) + "\n[[input.point]]\nname = \"a\"\npoint = [" + x + ", -" + y +
         "]\n[[input.point]]\nname = \"b\"\npoint = [" + x + ", " + y +
         "]\n[[step]]\noperation = \"problem\"\nstate = \"strain\"\n[[step.material]]\nyoung = 210e9\npoisson = 0.3\n" +
         "[[step.support]]\nwhere = \"a\"\nx = 0.0\ny = 0.0\n[[step.support]]\nwhere = \"b\"\nx = "
         "0.0\n[[step.load]]\nwhere = \"right\"\nx = 1e6\n[[step.load]]\nwhere = \"left\"\nx = -1e6\n";
}

TEST(Adaptivity, APeakThatMissesTheTargetByALittleIsAimedAtLower) {
  for (const auto& [width, height, radius] :
       {std::tuple{6.0, 3.0, 0.3}, {8.0, 4.0, 0.2}, {12.0, 6.0, 0.6}, {10.0, 10.0, 0.5}}) {
    const scenario::Run done = run(holed(width, height, radius) + "[[step]]\noperation = \"adapt\"\ntarget = 1.0\n");
    EXPECT_FALSE(last(done).short_of_target) << width << (last(done).remarks.empty() ? "" : last(done).remarks.back());
    EXPECT_GT(figures(done).at("peak_eta"), 0.0) << width;  // the hole's peaks are minded
    EXPECT_LE(figures(done).at("peak_eta"), 1.0) << width;
  }
}

TEST(Adaptivity, TheSlopeToACrackTipHasNoPeaksAndAHoleBesideHas) {
  const std::string strip =
      "[input]\nspecimen = \"single_edge_notch\"\nwidth = 1.0\nheight = 3.0\ncrack_length = 0.5\n";
  const std::string hole = "[[input.curve]]\nkind = \"circle\"\nname = \"hole\"\ncentre = [0.5, 0.8]\nradius = 0.05\n";
  const std::string pulled =
      "[[input.point]]\nname = \"anchor\"\npoint = [1.0, 0.0]\n[[input.point]]\nname = \"guide\"\npoint = [1.0, "
      "-1.5]\n[[step]]\noperation = \"problem\"\n[[step.material]]\nyoung = 1.0\n" +
      std::string(
          "[[step.support]]\nwhere = \"anchor\"\nx = 0.0\ny = 0.0\n[[step.support]]\nwhere = \"guide\"\nx = "
          "0.0\n[[step.load]]\nwhere = \"top\"\ny = 1.0\n[[step.load]]\nwhere = \"bottom\"\ny = -1.0\n");
  for (const auto& [rules, target] :
       {std::pair{"order = \"1\"\n", "5.0"}, {"", "2.0"}, {"rosettes = \"yes\"\n", "1.0"}}) {
    const std::string adapt = std::string("[[step]]\noperation = \"adapt\"\ntarget = ") + target + "\n" + rules;
    const scenario::Run alone = run(strip + pulled + adapt);
    EXPECT_FALSE(last(alone).short_of_target) << rules;
    for (const auto& analysis : last(alone).analyses)
      EXPECT_TRUE(analysis->fields.front().peaks.empty()) << rules << analysis->cycle;
    const scenario::Run beside = run(strip + hole + pulled + adapt);
    const auto& peaks = last(beside).analyses.back()->fields.front().peaks;
    ASSERT_FALSE(peaks.empty()) << rules;
    const geom::Point at = last(beside).meshes.back()->mesh.point(peaks.front().node);
    EXPECT_NEAR(distance(at, {0.5, 0.8}), 0.05, 1e-3) << rules;
  }
}

}  // namespace
}  // namespace quebra::analysis
