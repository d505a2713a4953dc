#include "recon/unfold/grid.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/recon/shapes.h"

namespace recon::unfold {
namespace {

GridParams params_of(int count, double distance, double factor = 1.0) {
  GridParams params;
  params.top = "top";
  params.count = count;
  params.distance = distance;
  params.factor = factor;
  return params;
}

TEST(Grid, REC_f_ThirteenCurvesAndARungForEveryCornerOfTheTop) {
  const auto source = make_source_grid(test::section_of({test::cosine()}), params_of(13, 0.2), {});
  ASSERT_TRUE(source) << to_string(source.error());
  ASSERT_EQ(source->grid.curves.size(), 13u);
  for (std::size_t k = 0; k < 13; ++k) {
    EXPECT_NEAR(source->grid.curves[k].distance, 0.2 * static_cast<double>(k + 1), 1e-12);
    EXPECT_EQ(source->grid.curves[k].pieces.size(), 1u);
  }
  EXPECT_EQ(source->grid.rungs.size(), 129u);
  EXPECT_EQ(source->side, section::LayerSide::Below);
}

TEST(Grid, REC_f_TreatedRungsEndAtTheMedialAxisAndDoNotCross) {
  const auto source = make_source_grid(test::section_of({test::cosine()}), params_of(13, 0.2), {});
  ASSERT_TRUE(source) << to_string(source.error());
  const auto& rungs = source->grid.rungs;
  for (std::size_t i = 0; i + 1 < rungs.size(); ++i) {
    // Neighbouring rungs and what joins their ends: positive area, the layers being on the right of travel.
    const geom::Polyline cell{{rungs[i].points[0], rungs[i].points[1], rungs[i + 1].points[1], rungs[i + 1].points[0]},
                              true};
    EXPECT_GT(geom::signed_area(cell), 0.0) << i;
  }
  // Under the crests at pi and 3 pi, radius of curvature 1, the rungs of the limbs stop before depth 2.6.
  EXPECT_LT(geom::length(rungs[28]), 2.6);
  const geom::Vector in_trough = maps::Columns::along(test::cosine())->rung_vector(64);  // at 2 pi they reach it
  EXPECT_NEAR(geom::length(rungs[64]), 2.6 * geom::length(in_trough), 1e-12);
}

TEST(Grid, TheLayersDecideTheSideUnlessTheUserDoes) {
  const geom::Polyline line{{{0, 0}, {5, 1}, {10, 0}}, false};
  const geom::Polyline above{{{1, 3}, {9, 3}}, false};
  const auto automatic = make_source_grid(test::section_of({line, above}), params_of(2, 0.5), {});
  ASSERT_TRUE(automatic);
  EXPECT_EQ(automatic->side, section::LayerSide::Above);
  EXPECT_EQ(automatic->base, geom::reversed(line));
  EXPECT_GT(automatic->deepest, 2.0);
  EXPECT_GT(automatic->grid.rungs[1].points[1].y, 1.0);
  GridParams below = params_of(2, 0.5);
  below.side = section::LayerSide::Below;
  const auto forced = make_source_grid(test::section_of({line, above}), below, {});
  ASSERT_TRUE(forced);
  EXPECT_EQ(forced->base, line);
  EXPECT_EQ(forced->deepest, 0.0);
}

TEST(Grid, ToTheBaseTakesAsManyCurvesAsReachTheDeepestPoint) {
  const section::Section section = test::section_of({{{{0, 0}, {10, 0}}, false}, {{{0, -3}, {10, -4.2}}, false}});
  GridParams params = params_of(1, 0.5);
  params.extent = GridExtent::Base;
  const auto equal = make_source_grid(section, params, {});
  ASSERT_TRUE(equal);
  EXPECT_EQ(equal->options.distances.size(), 9u);
  EXPECT_NEAR(equal->deepest, 4.2, 1e-12);
  params.factor = 2.0;  // 0.5 1.5 3.5 7.5
  const auto growing = make_source_grid(section, params, {});
  ASSERT_TRUE(growing);
  EXPECT_EQ(growing->options.distances.size(), 4u);
  params.factor = 0.5;  // never beyond 1
  const auto never = make_source_grid(section, params, {});
  ASSERT_FALSE(never);
  EXPECT_EQ(never.error().code, base::ErrorCode::InvalidOption);
}

TEST(Grid, WithoutADistanceTheCurvesShareTheDepth) {
  const section::Section section = test::section_of({{{{0, 0}, {10, 0}}, false}, {{{0, -3}, {10, -7}}, false}});
  GridParams params;
  params.count = 3;
  params.factor = 2.0;  // gaps 1, 2, 4
  const auto source = make_source_grid(section, params, {});
  ASSERT_TRUE(source);
  ASSERT_EQ(source->options.distances.size(), 3u);
  EXPECT_NEAR(source->options.distances[0], 1.0, 1e-12);
  EXPECT_NEAR(source->options.distances[2], 7.0, 1e-12);
}

TEST(Grid, AloneATopHasAGridOfATenthOfItsExtent) {
  GridParams params;
  params.count = 3;
  params.factor = 2.0;
  const auto alone = make_source_grid(test::section_of({{{{0, 0}, {70, 0}}, false}}), params, {});
  ASSERT_TRUE(alone) << to_string(alone.error());
  EXPECT_NEAR(alone->options.distances[0], 1.0, 1e-12);
  EXPECT_NEAR(alone->options.distances[2], 7.0, 1e-12);
  EXPECT_EQ(alone->deepest, 0.0);
  ASSERT_EQ(alone->remarks.size(), 1u);
  params.extent = GridExtent::Base;
  params.distance = 1.0;  // to a depth that is not there
  EXPECT_FALSE(make_source_grid(test::section_of({{{{0, 0}, {70, 0}}, false}}), params, {}));
}

TEST(Grid, AUnitBelowOrAboveTheTopIsReachedAndTellsTheSide) {
  GridParams params;
  params.count = 3;
  params.factor = 2.0;
  for (const double sign : {-1.0, 1.0}) {
    section::Section section = test::section_of({{{{0, 0}, {10, 0}}, false}});
    geom::Polyline contour{{{2, sign * 3}, {8, sign * 3}, {8, sign * 7}, {2, sign * 7}}, true};
    if (sign < 0.0) contour = geom::reversed(std::move(contour));
    section.units.push_back({section::UnitId(0), "U", contour, {}});
    const auto source = make_source_grid(section, params, {});
    ASSERT_TRUE(source) << to_string(source.error());
    EXPECT_EQ(source->side, sign < 0.0 ? section::LayerSide::Below : section::LayerSide::Above);
    EXPECT_NEAR(source->deepest, 7.0, 1e-12);
    EXPECT_NEAR(source->options.distances[2], 7.0, 1e-12);
    EXPECT_TRUE(source->remarks.empty());
  }
}

TEST(Grid, AnUnknownTopIsRefusedWithASuggestion) {
  GridParams params = params_of(2, 0.5);
  params.top = "tip";
  const auto source = make_source_grid(test::section_of({test::cosine()}), params, {});
  ASSERT_FALSE(source);
  EXPECT_EQ(source.error().code, base::ErrorCode::BadSection);
  EXPECT_NE(source.error().message.find("did you mean 'top'?"), std::string::npos);
}

TEST(Grid, ASimplifiedTopHasFewerRungsAndStaysWithinItsTolerance) {
  GridParams params = params_of(2, 0.1);
  params.simplify = 0.02;
  const auto source = make_source_grid(test::section_of({test::cosine()}), params, {});
  ASSERT_TRUE(source) << to_string(source.error());
  EXPECT_LT(source->grid.rungs.size(), 60u);
  EXPECT_EQ(source->remarks.size(), 1u);
  for (const geom::Point p : test::cosine().points) EXPECT_LE(geom::distance(source->base, p), 0.02 + 1e-12);
}

TEST(Grid, UntreatedRungsHaveTheirFullLength) {
  GridParams params = params_of(13, 0.2);
  params.treatment = Treatment::Untreated;
  const auto source = make_source_grid(test::section_of({test::cosine()}), params, {});
  ASSERT_TRUE(source);
  for (const geom::Polyline& rung : source->grid.rungs) EXPECT_GE(geom::length(rung), 2.6 - 1e-12);
}

TEST(Grid, WhatLiesBeyondTheTopIsMeasuredFromTheNormalOfItsEnd) {
  // Limbs of 30 degrees, a bed 300 m below: its end on the normal of the top's end lies 150 m beside that.
  const double dip = std::numbers::pi / 6.0;
  const geom::Vector along{std::cos(dip), std::sin(dip)};
  const geom::Vector down{std::sin(dip), -std::cos(dip)};
  const geom::Point corner{1000, 0};
  const geom::Point end = corner + 1000.0 * along;
  for (const double beyond : {0.0, -1e-9, 1e-9, 50.0, 100.0}) {
    const geom::Point far = end + 300.0 * down + beyond * along;
    for (const bool mirrored : {false, true}) {
      std::vector<geom::Polyline> lines{{{{0, 0}, corner, end}, false}, {{{0, -300}, {1080.38, -300}, far}, false}};
      if (mirrored) {
        for (geom::Polyline& line : lines) {
          for (geom::Point& p : line.points) p.x = -p.x;
          line = geom::reversed(line);
        }
      }
      // 5 % of the top's width of 1866 m are 93.3 m along the bed.
      const auto source = make_source_grid(test::section_of(lines), params_of(1, 100), {});
      EXPECT_EQ(source.ok(), beyond < 93.0) << beyond << mirrored;
    }
  }
}

}  // namespace
}  // namespace recon::unfold
