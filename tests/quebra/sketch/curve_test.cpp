#include "quebra/sketch/curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "shared/geom/discretise.h"
#include "shared/mesh/sizing/size_field.h"
#include "tests/support/quebra_scenarios.h"

namespace quebra::sketch {
namespace {

using namespace dobra;
using base::Angle;
using geom::Point;
using geom::Polyline;

const std::string square =
    "[[input.curve]]\nname = \"p\"\nkind = \"polygon\"\npoints = [[0, 0], [1, 0], [1, 1], [0, 1]]\n";

std::vector<double> pieces(const std::vector<double>& nodes) {
  std::vector<double> result;
  for (std::size_t i = 1; i < nodes.size(); ++i) result.push_back(nodes[i] - nodes[i - 1]);
  return result;
}

TEST(Curve, ArcsAreTracedThroughThePointsOfDiscretise) {
  for (const double degrees :
       {0.01, 1.0, 2.0, 2.0 + 1e-6, 4.0, -45.0, 64.0, 90.0, -128.0, 179.0, 256.0, 359.9, 360.0, -360.0}) {
    for (const Point centre : {Point{0, 0}, Point{5e5, 6e6}}) {
      for (const double radius : {1e-3, 0.3, 1e4}) {
        const auto arc =
            geom::Arc::from_angles(centre, radius, Angle::from_degrees(17), Angle::from_degrees(degrees)).value();
        const auto pieces = geom::discretise(arc, {.max_angle = trace_turn}).value();
        const Trace traced = trace({"arc", Role::Boundary, arc, {}});
        EXPECT_EQ(traced.line.closed, pieces.polyline().closed) << degrees;
        ASSERT_EQ(traced.line.points, pieces.polyline().points) << degrees << " of radius " << radius;
        ASSERT_EQ(traced.s.size(), pieces.parameters.size());
        for (std::size_t i = 0; i < traced.s.size(); ++i) EXPECT_EQ(traced.s[i], pieces.parameters[i] * arc.length());
      }
    }
  }
}

TEST(Curve, SUR_b_TheMesherDividesAQuarterCircleByHalvesAsRequired) {
  const auto sides = [](const std::string& division, double size, double turn) {
    const auto done =
        test::run(fmt::format("[input]\nspecimen = \"quarter_plate\"\nwidth = 5\nradius = 1\n[[step]]\noperation = "
                              "\"mesh\"\nsize = {}\nturn = {}\ndivision = \"{}\"\n",
                              size, turn, division));
    EXPECT_TRUE(done.complete());
    return test::last(done).meshes.back()->mesh.side_sets.at("hole").size();
  };
  EXPECT_EQ(sides("halving", 10, 10), 16U);
  EXPECT_EQ(sides("halving", 10, 15), 8U);
  EXPECT_EQ(sides("halving", 0.3, 10), 12U);
  EXPECT_EQ(sides("halving", 0.3, 20), 6U);
  EXPECT_EQ(sides("halving", 0.1, 45), 16U);
  // Evenly: the least number that meets both limits.
  EXPECT_EQ(sides("even", 10, 10), 9U);
  EXPECT_EQ(sides("even", 10, 15), 6U);
  EXPECT_EQ(sides("even", 0.3, 20), 6U);
  EXPECT_EQ(sides("even", 0.1, 45), 16U);
}

TEST(Curve, HalvesDifferByTwoAtMostAlongACurveAndFollowTheSizeWanted) {
  const Curve line{"line", Role::Boundary, Polyline{{{0, 0}, {10, 0}}, false}, {}};
  DivideOptions options{
      .size = 1.0, .limit = [](Point p) { return p.x < 3.3 ? 0.011 : 5.0; }, .rule = DivisionRule::Halving};
  const auto lengths = pieces(divide(line, {}, options).value());
  double at = 0.0;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    if (i > 0) {
      EXPECT_LE(std::max(lengths[i] / lengths[i - 1], lengths[i - 1] / lengths[i]), 2.0 + 1e-9);
    }
    if (at < 3.3) {
      EXPECT_LE(lengths[i], 1.05 * 0.011 + 1e-12);
    }
    at += lengths[i];
  }
  EXPECT_NEAR(*std::max_element(lengths.begin(), lengths.end()), 1.0, 1e-12);
}

TEST(Curve, NoSideOfABoundaryIsLongerThanTheSizeAndInsideFewAreByMuch) {
  for (const double size : {0.8, 0.45, 0.1, 0.03}) {
    const auto done = test::run(square + fmt::format("[[step]]\noperation = \"mesh\"\nsize = {}\n", size));
    ASSERT_TRUE(done.complete());
    const mesh::ElementMesh& mesh = test::last(done).meshes.back()->mesh;
    for (const auto& side : mesh.side_sets.at("p")) {
      const auto nodes = side_nodes(mesh, side);
      EXPECT_LE(distance(mesh.point(nodes[0]), mesh.point(nodes[1])), size * (1.0 + 1e-9));
    }
    std::size_t all = 0, longer = 0;
    for (std::size_t e = 0; e < mesh.element_count(); ++e) {
      const auto nodes = mesh.nodes_of(mesh::ElementId(e));
      for (std::size_t i = 0; i < 3; ++i, ++all) {
        const double side = distance(mesh.point(nodes[i]), mesh.point(nodes[(i + 1) % 3]));
        EXPECT_LE(side, 1.6 * size);
        if (side > 1.34 * size) ++longer;
      }
    }
    EXPECT_LE(static_cast<double>(longer), 0.04 * static_cast<double>(all)) << size;
  }
}

TEST(Curve, ALongSideLeadsFromTheFineSidesOfItsNeighbour) {
  for (const double length : {3.0, 12.0, 14.0, 40.0}) {
    const std::string l = std::to_string(length);
    const auto values =
        test::figures(test::run("[input]\n[[input.curve]]\nname = \"left\"\nsize = 0.00625\npoints = [[0, 1], [0, "
                                "0]]\n[[input.curve]]\nname = \"rest\"\npoints = [[0, 0], [" +
                                l + ", 0], [" + l + ", 1], [0, 1]]\n[[step]]\noperation = \"mesh\"\nsize = 0.1\n"));
    EXPECT_GT(values.at("alpha_min"), 0.7) << length;
  }
}

TEST(Curve, SegmentsAndRatioAreObeyedOverCornersOrRefused) {
  const Curve chain{"chain",
                    Role::Boundary,
                    Polyline{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, false},
                    {.segments = 30, .size = 0.0, .ratio = 3.0}};
  const auto nodes = divide(chain, {}, {.size = 0.1}).value();
  ASSERT_EQ(nodes.size(), 31U);
  for (const double corner : {1.0, 2.0}) EXPECT_TRUE(std::find(nodes.begin(), nodes.end(), corner) != nodes.end());
  const auto lengths = pieces(nodes);
  EXPECT_NEAR(lengths.back() / lengths.front(), 3.0, 0.15);
  for (std::size_t i = 1; i < lengths.size(); ++i) EXPECT_NEAR(lengths[i] / lengths[i - 1], 1.0, 0.2);
  Curve three = chain;
  three.division = {.segments = 3};
  EXPECT_EQ(divide(three, {}, {.size = 0.1}).value(), (std::vector<double>{0, 1, 2, 3}));
  three.division = {.segments = 1, .size = 0.0, .ratio = 10.0};
  const auto refused = divide(three, {}, {.size = 0.1});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, base::ErrorCode::BadValue);
  EXPECT_NE(refused.error().message.find("'chain' has 3 pieces"), std::string::npos) << refused.error().message;
}

TEST(Curve, TheMeshHasJustTheSegmentsThatAChainAsksFor) {
  const auto done = test::run(
      "[[input.curve]]\nname = \"p\"\npoints = [[0, 0], [1, 0]]\nsize = 0.1\nratio = 5\n"
      "[[input.curve]]\nname = \"q\"\npoints = [[1, 0], [1, 1], [0, 1], [0, 0]]\nsegments = 30\nratio = "
      "3\n[[step]]\noperation = \"mesh\"\nsize = 0.1\n");
  ASSERT_TRUE(done.complete());
  const mesh::ElementMesh& mesh = test::last(done).meshes.back()->mesh;
  EXPECT_EQ(mesh.side_sets.at("q").size(), 30U);
  double least = 1.0, greatest = 0.0;
  for (const auto& side : mesh.side_sets.at("p")) {
    const auto nodes = side_nodes(mesh, side);
    const double length = distance(mesh.point(nodes[0]), mesh.point(nodes[1]));
    least = std::min(least, length);
    greatest = std::max(greatest, length);
  }
  EXPECT_NEAR(greatest / least, 5.0, 1e-6);
  EXPECT_LE(greatest, 0.1 + 1e-12);
  EXPECT_GE(greatest, 0.09);
}

TEST(Curve, ASizeThatIsMuchTooSmallIsRefusedBeforeAnyWork) {
  const Curve line{"edge", Role::Boundary, Polyline{{{0, 0}, {44, 0}}, false}, {}};
  for (const auto rule : {DivisionRule::Even, DivisionRule::Halving}) {
    const auto refused = divide(line, {}, {.size = 1e-9, .rule = rule});
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, base::ErrorCode::TooManyElements);
    EXPECT_NE(refused.error().message.find("'edge'"), std::string::npos);
  }
  const std::string cook = "[input]\nspecimen = \"cook\"\n[[step]]\noperation = \"mesh\"\n";
  EXPECT_NE(test::trouble(cook + "size = 1e-6\n").find("a size of 1e-06 m over"), std::string::npos);
  EXPECT_NE(test::trouble(square + "[[step]]\noperation = \"mesh\"\nsize = 1e-5\nmax_elements = 100000\n")
                .find("more than the 100000 allowed"),
            std::string::npos);
  EXPECT_NE(test::trouble(square + "[[input.curve]]\nname = \"seam\"\nrole = \"internal\"\npoints = [[0.2, 0.2], [0.8, "
                                   "0.8]]\nsize = 1e-9\n[[step]]\noperation = \"mesh\"\n")
                .find("curve 'seam'"),
            std::string::npos);
}

TEST(Curve, CirclesWithNothingInTheirBoxesAreLone) {
  const auto circle = [](dobra::geom::Point centre, double radius) {
    return Curve{"c", Role::Hole, dobra::geom::Arc::circle(centre, radius).value(), {}};
  };
  const auto half = dobra::geom::Arc::from_angles({20, 0}, 1.0, dobra::base::Angle::from_degrees(0),
                                                  dobra::base::Angle::from_degrees(180))
                        .value();
  const std::vector<Curve> curves{
      circle({0, 0}, 1.0),  // lone
      circle({5, 0}, 1.0),  // 0.1 from the next
      circle({7.1, 0}, 1.0),
      circle({10, 0}, 1.0),  // holds a point
      circle({15, 0}, 2.0),  // holds the next one, which is alone in its box
      circle({15, 0}, 1.0),
      {"half", Role::Boundary, half, {}},
      circle({0, 0}, 100.0),  // round all
      {"rim", Role::Boundary, dobra::geom::Polyline{{{-200, -200}, {200, -200}, {200, 200}, {-200, 200}}, true}, {}}};
  const std::vector<dobra::geom::Point> points{{10.9, 0.9}};
  using Marks = std::vector<std::uint8_t>;
  EXPECT_EQ(lone_circles(curves, points, 0.01), (Marks{1, 1, 1, 0, 0, 1, 0, 0, 0}));
  EXPECT_EQ(lone_circles(curves, points, 0.11), (Marks{1, 0, 0, 0, 0, 1, 0, 0, 0}));
}

}  // namespace
}  // namespace quebra::sketch
