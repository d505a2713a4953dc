// Jigsaws to a target that is no level line.

#include <gtest/gtest.h>

#include "recon/jigsaw/target_line.h"
#include "tests/recon/jigsaw/stacks.h"

namespace recon::jigsaw {
namespace {

/// A straight line through a point that climbs to +x by a slope.
std::vector<geom::Point> sloping(geom::Point through, double slope) {
  return {through + geom::Vector{9000.0, 9000.0 * slope}, through - geom::Vector{9000.0, 9000.0 * slope}};
}

TEST(TargetJigsaw, OnASlopeItIsTheLevelOneTurned) {
  using unfold::RestoreMethod;
  for (const RestoreMethod method : {RestoreMethod::Constant, RestoreMethod::Flexural, RestoreMethod::LineLength}) {
    for (const Fit fit : {Fit::Walls, Fit::Top}) {
      SCOPED_TRACE(unfold::method_name(method));
      unfold::RestoreParams params;
      params.method = method;
      BlockwiseParams how = jigsaw_by(fit);
      how.elevation = 0.0;
      const Blockwise level = restored(graben(), how, params);
      how.elevation.reset();
      const geom::Point pin{level.blocks[0].pin.x, 120.0};
      const double slope = 0.2;
      how.target = sloping(pin, slope);
      const Blockwise made = restored(graben(), how, params);
      const geom::Vector along = geom::normalised(geom::Vector{1.0, slope});
      ASSERT_EQ(made.section.horizons.size(), level.section.horizons.size());
      for (std::size_t i = 0; i < made.section.horizons.size(); ++i) {
        const std::vector<geom::Point>& points = made.section.horizons[i].line.points;
        for (const bool first : {true, false}) {
          const geom::Point flat =
              first ? level.section.horizons[i].line.points.front() : level.section.horizons[i].line.points.back();
          const geom::Point turned = pin + (flat.x - pin.x) * along + flat.y * geom::Vector{-along.y, along.x};
          EXPECT_LT(geom::distance(first ? points.front() : points.back(), turned), 1e-5)
              << made.section.horizons[i].name;
        }
      }
      for (std::size_t b = 0; b < 3; ++b) EXPECT_NEAR(*made.rows[b].shift, *level.rows[b].shift, 1e-9);
      for (const RestoredFault& fault : made.faults) {
        EXPECT_TRUE(fault.measured);
        EXPECT_LT(fault.opening.gap + fault.opening.overlap, 1.0) << fault.name;
      }
      EXPECT_EQ(made.balance.verdict, balance::BalanceVerdict::Balanced) << made.remarks.back();
    }
  }
}

TEST(TargetJigsaw, OnTopographyTheTopsLieOnItEndToEnd) {
  const std::vector<geom::Point> ground{{-9000, 0}, {-4000, 0}, {-1000, 200}, {400, 50}, {3000, 150}, {9000, 0}};
  const auto made_target = TargetLine::make(ground, 1000.0);
  ASSERT_TRUE(made_target);
  for (const unfold::RestoreMethod method : {unfold::RestoreMethod::Flexural, unfold::RestoreMethod::Shear}) {
    SCOPED_TRACE(unfold::method_name(method));
    unfold::RestoreParams params;
    params.method = method;
    BlockwiseParams how = jigsaw_by(Fit::Top);
    how.target = ground;
    const Blockwise made = restored(graben(), how, params);
    std::vector<geom::Polyline> tops;
    for (const section::Horizon& horizon : made.section.horizons) {
      if (whole_name(horizon) != "A") continue;
      tops.push_back(horizon.line);
      for (const geom::Point p : horizon.line.points) EXPECT_LT(geom::distance(made_target->line(), p), 1e-6);
    }
    ASSERT_EQ(tops.size(), 3U);
    for (std::size_t k = 0; k + 1 < 3; ++k)
      EXPECT_LT(geom::distance(tops[k].points.back(), tops[k + 1].points.front()), 1e-5);
    // Flexural slip keeps the length of the top along the ground, vertical shear its width.
    double length = 0.0;
    for (const geom::Polyline& top : tops) length += geom::length(top);
    const bool shear = method == unfold::RestoreMethod::Shear;
    EXPECT_NEAR(shear ? made.widths.after : length, 10000.0, 1e-5);
  }
}

TEST(TargetJigsaw, ThePinGoesWhereItIsSaid) {
  BlockwiseParams how = jigsaw_by(Fit::Top);
  how.target = {{-9000, 100}, {9000, 100}};
  how.pin = -3000.0;
  how.target_pin = geom::Point{-2500.0, 100.0};
  const Blockwise made = restored(graben(), how);
  EXPECT_LT(geom::distance(made.forward(geom::Point{-3000.0, 0.0}), {-2500.0, 100.0}), 1e-6);
  EXPECT_NEAR(made.widths.after, 10000.0, 1e-5);
  // One block alone likewise.
  BlockwiseParams alone;
  alone.block = {"block 1"};
  alone.top = "A";
  alone.target = how.target;
  alone.pin = how.pin;
  alone.target_pin = how.target_pin;
  EXPECT_LT(geom::distance(restored(graben(), alone).forward(geom::Point{-3000.0, 0.0}), {-2500.0, 100.0}), 1e-6);
}

TEST(TargetJigsaw, TargetsThatAreNoneAreRefused) {
  const auto code = [](const auto& change) {
    BlockwiseParams how = jigsaw_by(Fit::Top);
    how.target = {{-9000, 0}, {9000, 0}};
    change(how);
    const auto made = restore_blockwise(graben(), how, {}, {});
    return made ? std::string() : to_string(made.error());
  };
  EXPECT_EQ(code([](BlockwiseParams&) {}), "");
  const auto folds = code([](BlockwiseParams& how) { how.target = {{-9000, 0}, {100, 0}, {50, 200}, {9000, 0}}; });
  EXPECT_NE(folds.find("turns back in x at (50, 200)"), std::string::npos) << folds;
  EXPECT_NE(code([](BlockwiseParams& how) { how.target.pop_back(); }).find("two points"), std::string::npos);
  EXPECT_NE(code([](BlockwiseParams& how) { how.elevation = 0.0; }).find("level datum"), std::string::npos);
  EXPECT_NE(code([](BlockwiseParams& how) { how.constraint = Constraint::Rotation; }).find("no datum"),
            std::string::npos);
  const auto pin = code([](BlockwiseParams& how) {
    how.target.clear();
    how.target_pin = geom::Point{0, 0};
  });
  EXPECT_NE(pin.find("target_pin"), std::string::npos) << pin;
}

}  // namespace
}  // namespace recon::jigsaw
