#include "quebra/domain/domain.h"

#include <gtest/gtest.h>

#include <numbers>
#include <string>

namespace quebra::domain {
namespace {

using dobra::base::ErrorCode;
using dobra::geom::Arc;
using dobra::geom::Orientation;
using dobra::geom::Point;
using dobra::geom::Polyline;

sketch::Curve polygon(const std::string& name, std::vector<Point> points, sketch::Role role = sketch::Role::Boundary) {
  return {name, role, Polyline{std::move(points), true}, {}};
}
sketch::Curve line(const std::string& name, std::vector<Point> points, sketch::Role role = sketch::Role::Boundary) {
  return {name, role, Polyline{std::move(points), false}, {}};
}
sketch::Curve circle(const std::string& name, Point centre, double radius, sketch::Role role = sketch::Role::Boundary) {
  return {name, role, Arc::circle(centre, radius).value(), {}};
}
sketch::Curve square(const std::string& name, double low, double high) {
  return polygon(name, {{low, low}, {high, low}, {high, high}, {low, high}});
}

dobra::base::Result<Domain> make(const std::vector<sketch::Curve>& curves) {
  std::vector<dobra::base::Place> places(curves.size());
  for (std::size_t i = 0; i < places.size(); ++i) places[i].line = i + 1;
  return make_domain({curves, places, {}, {}, {}});
}

TEST(Domain, OneTooSmallForProductsOfLengthsIsRefused) {
  for (const double size : {1e-110, 1e-200, 1e-300}) {
    const auto domain = make({square("rim", 0.0, size)});
    ASSERT_FALSE(domain.ok()) << size;
    EXPECT_NE(domain.error().message.find("use smaller units"), std::string::npos) << to_string(domain.error());
  }
  EXPECT_TRUE(make({square("rim", 0.0, 1e-90)}).ok());
}

TEST(Domain, CurvesInAnyOrderAndDirectionBecomeOneLoop) {
  const auto domain = make({line("a", {{0, 0}, {1, 0}}), line("c", {{0, 1}, {1, 1}}), line("d", {{0, 1}, {0, 0}}),
                            line("b", {{1, 0}, {1, 1}})});
  ASSERT_TRUE(domain.ok()) << to_string(domain.error());
  ASSERT_EQ(domain->loops.size(), 1U);
  EXPECT_EQ(domain->loops[0].sides.size(), 4U);
  EXPECT_DOUBLE_EQ(std::abs(signed_area(contour(*domain, domain->loops[0]))), 1.0);
}

TEST(Domain, LoopsInsideLoopsAlternate) {
  const auto domain = make({square("outer", 0, 10), square("hole", 2, 8), square("island", 4, 6)});
  ASSERT_TRUE(domain.ok());
  EXPECT_EQ(domain->loops[0].depth, 0);
  EXPECT_EQ(domain->loops[1].depth, 1);
  EXPECT_EQ(domain->loops[2].depth, 2);
  const Inside inside(*domain);
  EXPECT_TRUE(inside({1, 1}));
  EXPECT_FALSE(inside({3, 3}));
  EXPECT_TRUE(inside({5, 5}));
  EXPECT_FALSE(inside({11, 5}));
  EXPECT_FALSE(inside({0, 5})) << "the boundary is not inside";
}

TEST(Domain, ThousandsOfHolesAndIslandsInThemKeepTheirDepth) {
  constexpr int n = 50;
  std::vector<sketch::Curve> curves{polygon("rim", {{0, 0}, {n + 1.0, 0}, {n + 1.0, n + 1.0}, {0, n + 1.0}})};
  for (int i = 0; i < n * n; ++i) {
    const double x = 1 + i % n, y = 1 + i / n;
    const auto diamond = [&](double r) { return std::vector<Point>{{x + r, y}, {x, y + r}, {x - r, y}, {x, y - r}}; };
    curves.push_back(polygon("hole" + std::to_string(i), diamond(0.4)));
    if (i % 3 == 0) curves.push_back(polygon("island" + std::to_string(i), diamond(0.2)));
  }
  const auto domain = make(curves);
  ASSERT_TRUE(domain.ok()) << to_string(domain.error());
  ASSERT_EQ(domain->loops.size(), curves.size());
  const Inside inside(*domain);
  double area = 0.0;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    ASSERT_EQ(domain->loops[i].sides.size(), 1U);
    EXPECT_EQ(domain->loops[i].sides[0].curve, i);
    const int depth = curves[i].name == "rim" ? 0 : curves[i].name.starts_with("hole") ? 1 : 2;
    ASSERT_EQ(domain->loops[i].depth, depth) << curves[i].name;
    if (depth == 0) continue;
    const auto& p = std::get<Polyline>(curves[i].shape).points;
    const Point centre = midpoint(p[0], p[2]);
    const bool island = depth == 2 || (i + 1 < curves.size() && curves[i + 1].name.starts_with("island"));
    ASSERT_EQ(inside(centre), island) << curves[i].name;
    const std::size_t hole = depth == 1 ? i : i - 1;
    std::vector<std::size_t> around{0, hole};
    if (island) around.push_back(hole + 1);
    ASSERT_EQ(inside.loops_around(centre), around);
    ASSERT_FALSE(inside(p[0])) << "the boundary is not inside";
  }
  for (const Face& face : domain->faces) {
    EXPECT_TRUE(inside(face.inside));
    area += face.area;
  }
  constexpr int islands = (n * n + 2) / 3;
  EXPECT_EQ(domain->faces.size(), 1U + islands);
  EXPECT_NEAR(area, (n + 1.0) * (n + 1.0) - n * n * 0.32 + islands * 0.08, 1e-9);
}

TEST(Domain, EndsWithinTheToleranceAreOnePoint) {
  const auto arc =
      Arc::from_angles({0, 0}, 1.0, dobra::base::Angle::from_degrees(0), dobra::base::Angle::from_degrees(180)).value();
  const auto domain = make({{"arc", sketch::Role::Boundary, arc, {}}, line("chord", {{-1, 0}, {1, 0}})});
  ASSERT_TRUE(domain.ok()) << to_string(domain.error());
  EXPECT_EQ(point(domain->curves[0], length(domain->curves[0])), point(domain->curves[1], 0.0));
}

TEST(Domain, AnOpenLoopIsNamedWithItsEnd) {
  const auto domain = make({line("bottom", {{0, 0}, {1, 0}}), line("right", {{1, 0}, {1, 1}})});
  ASSERT_FALSE(domain.ok());
  EXPECT_EQ(domain.error().code, ErrorCode::BadDomain);
  EXPECT_NE(domain.error().message.find("'bottom'"), std::string::npos);
  EXPECT_EQ(domain.error().place->x, 0.0);
}

TEST(Domain, ASelfCrossingBoundaryIsNamedWithThePoint) {
  const auto domain = make({polygon("bow", {{0, 0}, {2, 2}, {2, 0}, {0, 2}})});
  ASSERT_FALSE(domain.ok());
  EXPECT_EQ(domain.error().code, ErrorCode::SelfIntersection);
  EXPECT_EQ(domain.error().place->x, 1.0);
  EXPECT_EQ(domain.error().place->y, 1.0);
  EXPECT_EQ(domain.error().place->line, 1U);
}

TEST(Domain, TwoLoopsThatCrossAreBothNamed) {
  const auto domain = make({square("plate", 0, 4), circle("hole", {4, 2}, 1)});
  ASSERT_FALSE(domain.ok());
  EXPECT_EQ(domain.error().code, ErrorCode::SelfIntersection);
  EXPECT_NE(domain.error().message.find("'plate'"), std::string::npos);
  EXPECT_NE(domain.error().message.find("'hole'"), std::string::npos);
}

TEST(Domain, AHoleOutsideIsNamed) {
  const auto domain = make({square("plate", 0, 4), circle("hole", {9, 2}, 1, sketch::Role::Hole)});
  ASSERT_FALSE(domain.ok());
  EXPECT_EQ(domain.error().code, ErrorCode::OutsideDomain);
  EXPECT_NE(domain.error().message.find("'hole'"), std::string::npos);
}

TEST(Domain, AnInternalLineOutsideIsNamed) {
  const auto domain = make({square("plate", 0, 4), line("crack", {{5, 5}, {6, 6}}, sketch::Role::Internal)});
  ASSERT_FALSE(domain.ok());
  EXPECT_EQ(domain.error().code, ErrorCode::OutsideDomain);
}

TEST(Divide, GivesJustTheSegmentsAskedFor) {
  sketch::Curve side = line("side", {{0, 0}, {5, 0}});
  side.division.segments = 5;
  const std::vector<double> expected{0, 1, 2, 3, 4, 5};
  const auto nodes = divide(side, {}, {.size = 10}).value();
  ASSERT_EQ(nodes.size(), expected.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) EXPECT_NEAR(nodes[i], expected[i], 1e-14);
}

TEST(Divide, RatioIsLastToFirst) {
  sketch::Curve side = line("side", {{0, 0}, {7, 0}});
  side.division = {.segments = 3, .size = 0.0, .ratio = 4.0};
  const auto nodes = divide(side, {}, {.size = 10}).value();
  ASSERT_EQ(nodes.size(), 4U);
  EXPECT_NEAR(nodes[1], 1.0, 1e-12);
  EXPECT_NEAR(nodes[2], 3.0, 1e-12);
}

TEST(Divide, ArcsTurnByNoMoreThanAsked) {
  const sketch::Curve hole = circle("hole", {0, 0}, 1);
  const auto nodes = divide(hole, {}, {.size = 100, .turn = dobra::base::Angle::from_degrees(15)}).value();
  EXPECT_EQ(nodes.size(), 25U);
  EXPECT_DOUBLE_EQ(nodes.back(), 2 * std::numbers::pi);
}

TEST(Divide, StopsAreNodesAndSizesGrowAwayFromThem) {
  const sketch::Curve side = line("side", {{0, 0}, {4, 0}});
  const auto nodes = divide(side, {{1.0, 0.1}}, {.size = 1.0, .growth = 1.3}).value();
  EXPECT_TRUE(std::find(nodes.begin(), nodes.end(), 1.0) != nodes.end());
  double before = 0.0;
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    const double piece = nodes[i] - nodes[i - 1];
    EXPECT_LE(piece, 1.0 + 1e-9);
    if (before > 0.0) {
      EXPECT_LE(std::max(piece / before, before / piece), 1.6);
    }
    if (nodes[i] == 1.0) {
      EXPECT_LE(piece, 0.15);
    }
    before = piece;
  }
}

}  // namespace
}  // namespace quebra::domain
