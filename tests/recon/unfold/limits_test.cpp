#include "recon/unfold/limits.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "recon/core/grid_step.h"
#include "recon/core/restore_step.h"
#include "recon/core/target_step.h"
#include "tests/recon/shapes.h"

namespace recon::unfold {
namespace {

using std::numbers::pi;

geom::Polyline moved(geom::Polyline line, double down) {
  for (geom::Point& p : line.points) p.y -= down;
  return line;
}

/// Limbs of 600 m that dip by `limb` degrees from a round hinge, which is open upwards (sign -1) or downwards (+1).
geom::Polyline hinge(double radius, double limb, double sign) {
  const double half = limb * pi / 180.0;
  geom::Polyline line;
  const geom::Vector down{std::cos(half), -std::sin(half)};
  const geom::Point end{radius * std::sin(half), radius * std::cos(half)};
  line.points.push_back({-end.x - 600.0 * down.x, end.y + 600.0 * down.y});
  for (int i = 0; i <= 40; ++i) {
    const double a = half * (i / 20.0 - 1.0);
    line.points.push_back({radius * std::sin(a), radius * std::cos(a)});
  }
  line.points.push_back(end + 600.0 * down);
  for (geom::Point& p : line.points) p.y *= sign;
  return line;
}

base::Result<model::Model> run(const std::vector<geom::Polyline>& lines, const RestoreParams& params) {
  model::Model model;
  model.section = test::section_of(lines);
  GridParams grid;
  grid.uncovered = Uncovered::Continue;
  DOBRA_TRY(model, core::run_grid(model, grid, {}, {}));
  DOBRA_TRY(model, core::run_target(model, TargetParams{}, {}, {}));
  return core::run_restore(model, params, {}, {});
}

RestoreParams variable(Doubt outside = Doubt::Limited) {
  RestoreParams params;
  params.method = RestoreMethod::Variable;
  params.outside = outside;
  return params;
}

std::vector<geom::Polyline> unsteady() {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-3.0, 3.0);
  geom::Polyline top, base;
  for (int i = 0; i <= 200; ++i) {
    const double z = 150.0 * std::sin(pi * i / 100.0);
    top.points.push_back({10.0 * i, z + uniform(random)});
    base.points.push_back({10.0 * i, z - 600.0});
  }
  return {top, base};
}

std::vector<std::vector<geom::Polyline>> beyond() {
  const geom::Polyline synform = hinge(30.0, 60.0, -1.0);
  const geom::Polyline kinks{{{0, 0}, {400, 0}, {420, 5}, {800, 400}, {805, 401}, {810, 400}, {1200, 0}, {1600, 0}},
                             false};
  const geom::Polyline notch{{{0, 0}, {500, 0}, {502, -4}, {504, 0}, {1000, 0}}, false};
  return {unsteady(), {synform, moved(synform, 200.0)}, {kinks, moved(kinks, 250.0)}, {notch, moved(notch, 150.0)}};
}

TEST(Limits, VariableThicknessBeyondThemIsRefusedWithThePlaceAndAMethodThatWorks) {
  for (const auto& lines : beyond()) {
    const auto refused = run(lines, variable());
    ASSERT_FALSE(refused);
    const base::Error& error = refused.error();
    EXPECT_EQ(error.code, base::ErrorCode::CannotRestore);
    ASSERT_TRUE(error.place && error.place->x && error.place->y) << error.message;
    geom::Box box = lines[0].box();
    box.add(lines[1].box());
    EXPECT_TRUE(*error.place->x >= box.low.x - 1e-6 && *error.place->x <= box.high.x + 1e-6) << *error.place->x;
    EXPECT_TRUE(*error.place->y >= box.low.y - 1e-6 && *error.place->y <= box.high.y + 1e-6) << *error.place->y;
    EXPECT_NE(error.message.find("--outside nearest"), std::string::npos) << error.message;
    // What it recommends does restore this section, without a doubt.
    RestoreParams other;
    other.outside = Doubt::Refuse;
    if (error.message.find("--method flexural") != std::string::npos) {
      other.method = RestoreMethod::Flexural;
      if (error.message.find("--beds parallel") != std::string::npos) other.beds = SlipBeds::Parallel;
    } else if (error.message.find("--method line_length") != std::string::npos) {
      other.method = RestoreMethod::LineLength;
    } else {
      ASSERT_NE(error.message.find("--method shear"), std::string::npos) << error.message;
      other.method = RestoreMethod::Shear;
    }
    EXPECT_TRUE(run(lines, other)) << error.message;
  }
}

TEST(Limits, TheUserMayGoOnAllTheSame) {
  for (const auto& lines : beyond()) {
    const auto made = run(lines, variable(Doubt::Nearest));
    ASSERT_TRUE(made) << to_string(made.error());
    double least = 0.0, greatest = 0.0, change = 0.0;
    for (const balance::UnitRow& row : made->restoration->ledger.units) {
      least = std::min(least, row.dilatation->least);
      greatest = std::max(greatest, row.dilatation->greatest);
    }
    for (const balance::LineLength& row : made->restoration->lengths) change = std::max(change, row.change_percent);
    EXPECT_TRUE(least < -0.5 || greatest > 1.0 || change > 100.0);  // it was refused for a reason
  }
}

TEST(Limits, SoundSectionsAreNotRefused) {
  geom::Polyline gentle, concentric, base;
  for (int i = 0; i <= 200; ++i) {
    const double a = (0.4 * i - 40.0) * pi / 180.0;
    gentle.points.push_back({10.0 * i, 30.0 * std::sin(pi * i / 50.0)});
    concentric.points.push_back({1000.0 * std::sin(a), 1000.0 * std::cos(a)});
    base.points.push_back({700.0 * std::sin(a), 700.0 * std::cos(a)});
  }
  const geom::Polyline chevron{{{0, 0}, {300, 0}, {500, 100}, {700, 0}, {1000, 0}}, false};
  const std::vector<std::vector<geom::Polyline>> sound{{gentle, moved(gentle, 300.0)},
                                                       {concentric, base},
                                                       {chevron, moved(chevron, 100.0)},
                                                       {test::arc(), test::parallel(test::arc(), 2.0)}};
  for (const auto& lines : sound) {
    const auto made = run(lines, variable());
    EXPECT_TRUE(made) << to_string(made.error());
  }
}

TEST(Limits, OtherMethodsAreNotJudgedByTheLimitsOfVariableThickness) {
  const auto lines = beyond().front();
  for (const RestoreMethod method : {RestoreMethod::Constant, RestoreMethod::Flexural, RestoreMethod::LineLength}) {
    RestoreParams params;
    params.method = method;
    const auto made = run(lines, params);
    EXPECT_TRUE(made) << to_string(made.error());
  }
}

TEST(Limits, ATornHingeOpensAndDoesNotFoldOverItself) {
  // The base lies below the centre of the hinge: it is torn there, and passes, but is not balanced.
  for (const double limb : {15.0, 30.0, 45.0}) {
    const geom::Polyline top = hinge(30.0, limb, 1.0);
    const double tangent = std::tan(limb * pi / 180.0);
    const double crest = -60.0;  // of a chevron whose limbs are parallel to those of the top
    const double reach = top.points.back().x;
    const geom::Polyline base{{{-reach, crest - tangent * reach}, {0, crest}, {reach, crest - tangent * reach}}, false};
    const auto made = run({top, base}, variable());
    ASSERT_TRUE(made) << to_string(made.error());
    const Restoration& restoration = *made->restoration;
    EXPECT_EQ(restoration.lines[1].tears.size(), 1u);
    const std::vector<geom::Point>& image = restoration.lines[1].after.points;
    for (std::size_t i = 1; i < image.size(); ++i) EXPECT_GT(image[i].x, image[i - 1].x - 1e-6) << limb;
    EXPECT_GT(restoration.ledger.units[0].dilatation->least, -0.5);
    EXPECT_LT(restoration.ledger.units[0].dilatation->mean, restoration.ledger.units[0].dilatation->greatest);
  }
}

}  // namespace
}  // namespace recon::unfold
