#include "recon/maps/columns.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/recon/shapes.h"

namespace recon::maps {
namespace {

// An L: along x, then up. Right-hand side: below, then right of it; the rung of the corner runs along (1, -1).
const geom::Polyline corner{{{0, 0}, {4, 0}, {4, 4}}, false};

TEST(Columns, AnOpenLineHasOneColumnASegmentAndTwoOuterOnes) {
  const auto columns = Columns::along(corner);
  ASSERT_TRUE(columns);
  EXPECT_EQ(columns->inner_count(), 2u);
  EXPECT_EQ(columns->count(), 4u);
  EXPECT_TRUE(columns->is_outer(ColumnId(0)));
  EXPECT_FALSE(columns->is_outer(ColumnId(1)));
  EXPECT_TRUE(columns->is_outer(ColumnId(3)));
}

TEST(Columns, RungsAreMitreVectors) {
  const auto columns = Columns::along(corner);
  ASSERT_TRUE(columns);
  EXPECT_EQ(columns->rung_vector(0), (geom::Vector{0, -1}));
  EXPECT_NEAR(columns->rung_vector(1).x, 1.0, 1e-15);
  EXPECT_NEAR(columns->rung_vector(1).y, -1.0, 1e-15);
  EXPECT_EQ(columns->rung_vector(2), (geom::Vector{1, 0}));
}

TEST(Columns, NamesAreColumnFractionAndDepth) {
  const auto columns = Columns::along(corner);
  ASSERT_TRUE(columns);
  // At depth 1 the first offset edge runs from (0,-1) to (5,-1).
  const Located low = columns->locate({2.5, -1}, 1e-12);
  EXPECT_EQ(low.at.column, ColumnId(1));
  EXPECT_NEAR(low.at.along, 0.5, 1e-15);
  EXPECT_NEAR(low.at.depth, 1.0, 1e-15);
  EXPECT_NEAR(low.distance, 1.0, 1e-15);
  // In the corner's wedge, right of the bisector: the second column, edge from (6,-2) to (6,4) at depth 2.
  const Located wedge = columns->locate({6, -1}, 1e-12);
  EXPECT_EQ(wedge.at.column, ColumnId(2));
  EXPECT_NEAR(wedge.at.along, 1.0 / 6.0, 1e-15);
  EXPECT_NEAR(wedge.at.depth, 2.0, 1e-15);
  // On the left-hand side depths are negative and the edges shrink: at depth -1 from (0,1) to (3,1).
  const Located above = columns->locate({1.5, 1}, 1e-12);
  EXPECT_EQ(above.at.column, ColumnId(1));
  EXPECT_NEAR(above.at.along, 0.5, 1e-15);
  EXPECT_NEAR(above.at.depth, -1.0, 1e-15);
}

TEST(Columns, BeyondTheEndsMetresFromTheRungAreCounted) {
  const auto columns = Columns::along(corner);
  ASSERT_TRUE(columns);
  const Located before = columns->locate({-3, -2}, 1e-12);
  EXPECT_EQ(before.at.column, ColumnId(0));
  EXPECT_NEAR(before.at.along, -3.0, 1e-15);
  EXPECT_NEAR(before.at.depth, 2.0, 1e-15);
  const Located after = columns->locate({5, 6}, 1e-12);
  EXPECT_EQ(after.at.column, ColumnId(3));
  EXPECT_NEAR(after.at.along, 2.0, 1e-15);
  EXPECT_NEAR(after.at.depth, 1.0, 1e-15);
}

TEST(Columns, PointOfANameIsThePointThatWasNamed) {
  const auto columns = Columns::along(test::cosine());
  ASSERT_TRUE(columns);
  for (int i = 0; i < 500; ++i) {
    const geom::Point p{-2.0 + 0.033 * i, 1.5 - 0.009 * (i * 7 % 500)};
    const Located located = columns->locate(p, 1e-12);
    ASSERT_EQ(located.foot, Foot::InColumn) << p;
    EXPECT_LT(geom::distance(columns->point(located.at), p), 1e-12) << p;
  }
}

TEST(Columns, LocateAgreesWithTryingEveryColumn) {
  const geom::Polyline line = test::cosine();
  const auto columns = Columns::along(line);
  ASSERT_TRUE(columns);
  for (int i = 0; i < 400; ++i) {
    const geom::Point p{-1.0 + 0.037 * i, 2.0 - 0.013 * (i * 11 % 400)};
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t c = 0; c < columns->count(); ++c) {
      const Columns::Beyond out = columns->beyond(ColumnId(c), p);
      if (out.left > 1e-12 || out.right > 1e-12 || out.left + out.right >= 0.0) continue;
      least = std::min(least, columns->distance_to_base(ColumnId(c), p));
    }
    EXPECT_EQ(columns->locate(p, 1e-12).distance, least) << p;
  }
}

TEST(Columns, PlacesBeyondTheLineContinueItsEndSegments) {
  const std::vector<double> arcs{-2.0, 1.0, 4.0, 10.0};
  const auto columns = Columns::between(corner, arcs);
  ASSERT_TRUE(columns);
  EXPECT_EQ(columns->inner_count(), 3u);
  EXPECT_EQ(columns->foot(0), (geom::Point{-2, 0}));
  EXPECT_EQ(columns->foot(2), (geom::Point{4, 0}));
  EXPECT_NEAR(columns->foot(3).x, 4.0, 1e-15);
  EXPECT_NEAR(columns->foot(3).y, 6.0, 1e-15);
}

TEST(Columns, ALineThatTurnsBackOnItselfIsRefusedWithThePlace) {
  const auto columns = Columns::along({{{0, 0}, {4, 0}, {1, 0}}, false});
  ASSERT_FALSE(columns);
  EXPECT_EQ(columns.error().code, base::ErrorCode::DegenerateCurve);
  ASSERT_TRUE(columns.error().place && columns.error().place->x);
  EXPECT_EQ(*columns.error().place->x, 4.0);
}

/// By looking at every column: of those that hold p, the one whose base segment is nearest.
std::optional<ColumnId> nearest_holder(const Columns& columns, geom::Point p, double tolerance) {
  std::optional<ColumnId> best;
  double least = 0.0;
  for (std::size_t i = 1; i <= columns.inner_count(); ++i) {
    for (const std::size_t column : {i, i == 1 ? std::size_t{0} : i, i == columns.inner_count() ? i + 1 : i}) {
      const Columns::Beyond out = columns.beyond(ColumnId(column), p);
      if (out.left > tolerance || out.right > tolerance || out.left + out.right >= 0.0) continue;
      const double distance = columns.distance_to_base(ColumnId(column), p);
      if (best && distance >= least) continue;
      best = ColumnId(column);
      least = distance;
    }
  }
  return best;
}

TEST(Columns, ThePlaceOfAPointIsThatOfASearchThroughAllColumnsWhateverTheHint) {
  // A gentle line, whose columns are certain down to some depth; the cosine, whose columns close; a line that
  // overhangs.
  geom::Polyline gentle;
  geom::Polyline overhanging;
  for (int i = 0; i <= 150; ++i) {
    const double x = 0.1 * i;
    gentle.points.push_back({x, 0.3 * std::sin(x) + 0.02 * std::sin(17.0 * x)});
    overhanging.points.push_back({x + 1.6 * std::sin(1.5 * x), std::cos(1.5 * x)});
  }
  std::mt19937 random(3);
  for (const geom::Polyline& line : {gentle, test::cosine(), overhanging, corner}) {
    const Columns columns = Columns::along(line).value();
    const geom::Box box = line.box().grown(4.0);
    std::uniform_real_distribution<double> x(box.low.x, box.high.x);
    std::uniform_real_distribution<double> y(box.low.y, box.high.y);
    std::uniform_int_distribution<std::size_t> hint(0, columns.inner_count() + 1);
    std::vector<geom::Point> points = line.points;
    for (int i = 0; i < 400; ++i) points.push_back({x(random), y(random)});
    for (const geom::Point p : points) {
      const auto expected = nearest_holder(columns, p, 1e-12);
      const Columns::Found alone = columns.find(p, 1e-12);
      EXPECT_EQ(alone.foot == Foot::InColumn, expected.has_value()) << p;
      // Equally near columns (of a vertex of the line) may differ by rounding from the search above, not among
      // themselves.
      if (expected) {
        EXPECT_NEAR(columns.distance_to_base(alone.column, p), columns.distance_to_base(*expected, p), 1e-14) << p;
      }
      for (int i = 0; i < 4; ++i) EXPECT_EQ(columns.find(p, 1e-12, ColumnId(hint(random))).column, alone.column) << p;
    }
  }
}

}  // namespace
}  // namespace recon::maps
