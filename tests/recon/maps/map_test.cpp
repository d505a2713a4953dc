#include "recon/maps/map.h"

#include <gtest/gtest.h>

#include <random>

#include "shared/geom/transform.h"
#include "tests/recon/shapes.h"

namespace recon::maps {
namespace {

using dobra::base::Angle;
using geom::Transform;
using test::given_images;
using test::greatest_distance;

/// A target without stretch or bend: as long as the line, at z = 0.
geom::Polyline flat(const geom::Polyline& line) { return {{{0, 0}, {geom::length(line), 0}}, false}; }

/// A line that wanders through the layers of `top`, as digitised by an unsteady hand.
geom::Polyline wandering(const geom::Polyline& top, double mean_depth, unsigned seed) {
  const Columns columns = Columns::along(top).value();
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> spread(-0.1, 0.1);
  geom::Polyline line;
  for (std::size_t i = 1; i <= columns.inner_count(); i += 2) {
    line.points.push_back(columns.point({ColumnId(i), 0.5 + spread(random), mean_depth * (1.0 + spread(random))}));
  }
  return line;
}

TEST(Map, REC_a_TheTopItselfAsTargetLeavesEveryPointInPlace) {
  const geom::Polyline top = test::cosine();
  const auto map = match_by_length(top, 3.0, top, 3.0);
  ASSERT_TRUE(map);
  for (const double depth : {-0.3, 0.2, 0.6, 1.5, 2.6}) {
    const geom::Polyline line = wandering(top, depth, 7);
    const MappedLine mapped = map->map(line);
    EXPECT_LT(greatest_distance(mapped.after.points, mapped.before.points), 1e-9) << depth;
    EXPECT_TRUE(mapped.tears.empty()) << depth;
  }
}

TEST(Map, REC_b_ARotatedAndTranslatedTopAsTargetMovesEveryPointByThatMotion) {
  const geom::Polyline top = test::cosine();
  const Transform motion =
      Transform::translation({3.5, -7.25}) * Transform::rotation(Angle::from_degrees(37.0), {1, 2});
  const auto map = match_by_length(top, 1.0, motion(top), 1.0);
  ASSERT_TRUE(map);
  for (const double depth : {0.0, 0.4, 2.6}) {
    const MappedLine mapped = map->map(wandering(top, depth, 3));
    EXPECT_LT(greatest_distance(mapped.after.points, motion(mapped.before).points), 1e-9) << depth;
  }
  for (const geom::Point p : {geom::Point{-5, -3}, geom::Point{20, 1}, geom::Point{6, 3}}) {
    EXPECT_LT(geom::distance(map->map(p), motion(p)), 1e-9);
  }
}

TEST(Map, REC_c_EveryPointKeepsItsDepthToTheTop) {
  const geom::Polyline top = test::cosine();
  const auto map = match_by_length(top, 0.0, flat(top), 0.0);
  ASSERT_TRUE(map);
  for (const double depth : {0.0, 0.3, 0.7}) {
    const MappedLine mapped = map->map(wandering(top, depth, 11));
    for (std::size_t i = 0; i < mapped.names.size(); ++i) {
      EXPECT_NEAR(-mapped.after.points[i].y, mapped.names[i].depth, 1e-9);
      const std::size_t segment = mapped.names[i].column.index() - 1;
      EXPECT_NEAR(
          geom::cross(mapped.before.points[i] - top.points[segment], geom::normalised(top.segment(segment).vector())),
          -mapped.after.points[i].y, 1e-9);
    }
  }
}

TEST(Map, REC_g_RestoredLinesGoBackWhereTheyWere) {
  const geom::Polyline top = test::cosine();
  const geom::Polyline bent{{{0, 0.6}, {5, 0}, {9, 0.1}, {30, 2}}, false};  // open towards the layers
  for (const geom::Polyline& target : {flat(top), bent}) {
    const auto map = match_by_length(top, 2.0, target, 2.0);
    ASSERT_TRUE(map);
    const ColumnMap back = map->swapped();
    // Not above the top: there the corners of a bent target are its medial axis.
    for (const double depth : {0.0, 0.5, 0.9}) {
      const MappedLine mapped = map->map(wandering(top, depth, 5));
      ASSERT_EQ(mapped.not_reversible, 0u);
      for (std::size_t i = 0; i < mapped.after.points.size(); ++i) {
        EXPECT_LT(geom::distance(back.map(mapped.after.points[i]), mapped.before.points[i]), 1e-9);
      }
    }
  }
}

TEST(Map, ResultsFollowAMotionAndAScalingOfTheInput) {
  const geom::Polyline top = test::cosine();
  const geom::Polyline line = wandering(top, 0.8, 23);
  const geom::Polyline target{{{0, 0}, {6, 1}, {20, 0}}, false};
  const std::vector<geom::Point> images = given_images(match_by_length(top, 1.0, target, 2.0)->map(line));
  for (const double factor : {1.0, 1e-3, 1e4}) {
    const Transform change = Transform::translation({200.0 * factor, 500.0 * factor}) *
                             Transform::rotation(Angle::from_degrees(-71.0)) * Transform::scale(factor, factor);
    const auto map = match_by_length(change(top), factor, change(target), 2.0 * factor);
    ASSERT_TRUE(map);
    std::vector<geom::Point> expected;
    for (const geom::Point p : images) expected.push_back(change(p));
    EXPECT_LT(greatest_distance(given_images(map->map(change(line))), expected), 1e-9 * factor) << factor;
  }
}

TEST(Map, TheImageOfAStraightPieceIsExactBetweenItsVertices) {
  const geom::Polyline top = test::cosine();
  const auto map = match_by_length(top, 0.0, flat(top), 0.0);
  ASSERT_TRUE(map);
  const MappedLine mapped = map->map({{{1.0, -1.4}, {11.5, -1.6}}, false});
  EXPECT_EQ(mapped.given.size(), 2u);
  EXPECT_GT(mapped.before.points.size(), 90u);
  double greatest = 0.0;
  for (std::size_t i = 0; i + 1 < mapped.before.points.size(); ++i) {
    for (const double t : {0.25, 0.5, 0.75}) {
      const geom::Point p = map->map(geom::interpolate(mapped.before.points[i], mapped.before.points[i + 1], t));
      greatest = std::max(greatest, geom::distance(mapped.after.segment(i), p));
    }
  }
  EXPECT_LT(greatest, 5e-5);  // 1e-6 of the box, with some room: the chord is tested at the middle
}

TEST(Map, ALineAcrossTheMedialAxisIsTornWhereTheLimbsMeet) {
  // A roof of 45 degrees; inside it the bisector x = 0 is the medial axis, and the rung of the ridge lies on it: no
  // tear.
  const geom::Polyline roof{{{-10, -10}, {0, 0}, {10, -10}}, false};
  const auto map = match_by_length(roof, 0.0, flat(roof), 0.0);
  ASSERT_TRUE(map);
  EXPECT_TRUE(map->map({{{-3, -6}, {3, -6}}, false}).tears.empty());

  // With a flat ridge of length 2 the ridge's column ends at depth 1 / tan(22.5 deg) = 2.414; below it the limbs meet
  // at x = 0.
  const geom::Polyline flattened{{{-11, -10}, {-1, 0}, {1, 0}, {11, -10}}, false};
  const auto second = match_by_length(flattened, 0.0, flat(flattened), 0.0);
  ASSERT_TRUE(second);
  EXPECT_TRUE(second->map({{{-3, -2.3}, {3, -2.3}}, false}).tears.empty());
  const MappedLine torn = second->map({{{-3, -6}, {3, -6}}, false});
  ASSERT_EQ(torn.tears.size(), 1u);
  EXPECT_NEAR(torn.tears[0].place.x, 0.0, 1e-9);
  EXPECT_NEAR(torn.tears[0].place.y, -6.0, 1e-12);
  // By hand: on the left limb, from (-11,-10) along (1,1)/sqrt 2, the point (0,-6) is (11 + 4)/sqrt 2 along and (11 -
  // 4)/sqrt 2 deep; the offset edge at that depth runs from 0 to 10 sqrt 2 - depth tan(22.5 deg). The right limb is its
  // mirror image.
  const double depth = 7.0 / std::sqrt(2.0);
  const double edge = 10.0 * std::sqrt(2.0) - depth * std::tan(std::numbers::pi / 8.0);
  const double image = 15.0 / std::sqrt(2.0) / edge * 10.0 * std::sqrt(2.0);
  EXPECT_NEAR(torn.tears[0].gap, 2.0 * (10.0 * std::sqrt(2.0) + 1.0 - image), 1e-7);
  EXPECT_EQ(torn.before.points[torn.tears[0].index], torn.before.points[torn.tears[0].index + 1]);
}

TEST(Map, ALineAlongARungIsNotCutToPieces) {
  const geom::Polyline top = test::cosine();
  const auto map = match_by_length(top, 0.0, flat(top), 0.0);
  ASSERT_TRUE(map);
  const Columns& columns = map->source();
  const MappedLine mapped = map->map({{columns.foot(40), columns.foot(40) + 0.6 * columns.rung_vector(40)}, false});
  EXPECT_LE(mapped.before.points.size(), 100u);
  EXPECT_NEAR(mapped.after.points.front().x, mapped.after.points.back().x, 1e-9);
}

TEST(Map, PointsBeyondTheEndsGoOnStraight) {
  const geom::Polyline top{{{0, 0}, {10, 0}}, false};
  const auto map = match_by_length(top, 0.0, {{{0, 0}, {6, 8}}, false}, 0.0);
  ASSERT_TRUE(map);
  const MappedLine mapped = map->map({{{-5, -5}, {15, -5}}, false});
  EXPECT_EQ(mapped.beyond_ends, 2u);
  EXPECT_LT(geom::distance(mapped.after.points.front(), geom::Point{-3 + 4, -4 - 3}), 1e-12);
  EXPECT_LT(geom::distance(mapped.after.points.back(), geom::Point{9 + 4, 12 - 3}), 1e-12);
}

TEST(Map, ATargetThatIsTooShortGoesOnStraightAndALongOneIsCut) {
  const geom::Polyline top{{{0, 0}, {10, 0}}, false};
  const auto shorter = match_by_length(top, 5.0, {{{0, 3}, {2, 3}}, false}, 1.0);
  ASSERT_TRUE(shorter);
  EXPECT_EQ(shorter->target().foot(0), (geom::Point{-4, 3}));
  EXPECT_EQ(shorter->target().inner_count(), 3u);
  EXPECT_LT(geom::distance(shorter->map({10, -1}), geom::Point{6, 2}), 1e-12);
  const auto longer = match_by_length(top, 0.0, {{{0, 3}, {4, 3}, {50, 3}}, false}, 2.0);
  ASSERT_TRUE(longer);
  EXPECT_EQ(longer->target().foot(0), (geom::Point{2, 3}));
  EXPECT_EQ(longer->target().inner_count(), 2u);
  EXPECT_LT(geom::distance(longer->map({10, 0}), geom::Point{12, 3}), 1e-12);
}

TEST(Map, ImagesThatBelongToAnotherColumnOfTheTargetAreCounted) {
  // Flat to a narrow trench: points deep on the concave side of the target cross its axis.
  const geom::Polyline top{{{0, 0}, {20, 0}}, false};
  const auto map = match_by_length(top, 0.0, {{{0, -9}, {9, 0}, {11, 0}, {20, -9}}, false}, 0.0);
  ASSERT_TRUE(map);
  const MappedLine deep = map->map({{{1, -8}, {13.7, -8}, {19, -8}}, false});
  EXPECT_GT(deep.not_reversible, 0u);
  EXPECT_EQ(map->map({{{1, -0.5}, {13.7, -0.5}, {19, -0.5}}, false}).not_reversible, 0u);
}

}  // namespace
}  // namespace recon::maps
