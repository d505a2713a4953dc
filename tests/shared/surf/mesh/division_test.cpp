#include "shared/surf/mesh/division.h"

#include <algorithm>
#include <set>

#include "tests/shared/surf/mesh/faces.h"

namespace dobra::surf::mesh {
namespace {

using geom::Point;
using geom::Point3;
using test::backwards;
using test::circle;
using test::count_of;
using test::divided;
using test::flat;
using test::pi;
using test::polygon;
using test::straight;
using trim::ChartEdge;
using trim::ChartLine;
using trim::TrimmedSurface;

DivisionOptions with(double largest, double turn, DivisionKind kind = DivisionKind::Even) {
  DivisionOptions options;
  options.kind = kind;
  options.sizes.largest = largest;
  options.sizes.turn = turn;
  return options;
}

// ---- what is wrong

TEST(Division, RefusesALoopThatDoesNotCloseWithThePlace) {
  TrimmedSurface face{.surface = flat(10, 5), .loops = {polygon({{0, 0}, {10, 0}, {10, 5}, {0, 5}})}};
  face.loops[0].edges[1] = straight({10, 0.5}, {10, 5});
  const auto result = divide({&face, 1}, with(1, 15));
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, base::ErrorCode::CannotMesh);
  ASSERT_TRUE(result.error().place && result.error().place->x && result.error().place->z && result.error().place->u);
  EXPECT_DOUBLE_EQ(*result.error().place->u, 10.0);
  EXPECT_DOUBLE_EQ(*result.error().place->v, 0.0);
}

TEST(Division, ClosesAGapWithinTheToleranceOfTheEdgeAndSaysSo) {
  TrimmedSurface face{.surface = flat(10, 5), .loops = {polygon({{0, 0}, {10, 0}, {10, 5}, {0, 5}})}};
  face.loops[0].edges[1] = straight({10, 1e-4}, {10, 5});
  face.loops[0].edges[1].tolerance = 1e-3;
  const Division division = divided({&face, 1}, with(1, 15));
  ASSERT_EQ(division.findings.size(), 1u);
  EXPECT_EQ(division.findings[0].code, "gap_closed");
  EXPECT_DOUBLE_EQ(division.findings[0].place.x.value_or(0), 10.0);
  EXPECT_EQ(division.nodes, 30u);
}

TEST(Division, RefusesSizesThatMeanNothing) {
  const TrimmedSurface face{.surface = flat(1, 1)};
  for (const auto spoil : {+[](SizeOptions& s) { s.largest = -1; }, +[](SizeOptions& s) { s.turn = 0; },
                           +[](SizeOptions& s) { s.growth = 1; }, +[](SizeOptions& s) { s.chord = std::nan(""); },
                           +[](SizeOptions& s) { s.narrow = -1; }, +[](SizeOptions& s) { s.least = -1; }}) {
    DivisionOptions options;
    spoil(options.sizes);
    const auto result = divide({&face, 1}, options);
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, base::ErrorCode::InvalidOption);
  }
}

TEST(Division, RefusesSizesThatWouldNeverEnd) {
  const TrimmedSurface face{.surface = *Surface::cylinder({}, 1.0, {{0, 0}, {1, 1}})};
  for (const DivisionKind kind : {DivisionKind::Even, DivisionKind::Halving}) {
    const auto result = divide({&face, 1}, with(1e-8, 15, kind));
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, base::ErrorCode::TooManyElements);
    EXPECT_TRUE(result.error().place->u.has_value());
  }
  EXPECT_EQ(divide({&face, 1}, with(1, 1e-7)).error().code, base::ErrorCode::TooManyElements);
}

TEST(Division, RefusesEdgesThatAreSaidToBeOneCurveAndAreNot) {
  TrimmedSurface a{.surface = flat(10, 5), .loops = {polygon({{0, 0}, {10, 0}, {10, 5}, {0, 5}})}};
  TrimmedSurface b = a;
  a.loops[0].edges[1].shared = 1;
  b.loops[0].edges[0].shared = 1;
  const std::vector<TrimmedSurface> both{a, b};
  const auto result = divide(both, with(1, 15));
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, base::ErrorCode::CannotMesh);
  EXPECT_TRUE(result.error().place->v.has_value());
}

// ---- division of one curve

TEST(Division, SUR_b_QuarterCircleIsHalvedIntoTheCountsOfTheMethod) {
  struct Case {
    double length, turn;
    std::size_t sides;
  };
  for (const Case& c : {Case{10, 10, 16}, {10, 15, 8}, {0.3, 10, 12}, {0.3, 20, 6}, {0.1, 45, 16}}) {
    TrimmedSurface face{.surface = flat(1, 1), .loops = {{}}};
    face.loops[0].edges = {straight({0, 0}, {1, 0}), circle({0, 0}, 1.0, "arc"), straight({0, 1}, {0, 0})};
    face.loops[0].edges[1].to = 0.5 * pi;
    const Division division = divided({&face, 1}, with(c.length, c.turn, DivisionKind::Halving));
    EXPECT_EQ(count_of(division.faces[0], "arc"), c.sides) << c.length << " " << c.turn;
  }
}

TEST(Division, HalvesByTheTurnInSpaceNotInTheChart) {
  // The sides of the chart are straight; in space they are quarter circles of radius 5 and lines of length 10.
  const TrimmedSurface face{.surface = *Surface::cylinder({}, 5.0, {{0, 0}, {0.5 * pi, 10}})};
  const Division division = divided({&face, 1}, with(100, 10, DivisionKind::Halving));
  EXPECT_EQ(count_of(division.faces[0], "bottom"), 16u);
  EXPECT_EQ(count_of(division.faces[0], "left"), 1u);
}

TEST(Division, EvenSidesAreTheFewestOfOneLength) {
  TrimmedSurface face{.surface = flat(10, 10), .loops = {{{circle({5, 5}, 2.0)}}}};
  const Division division = divided({&face, 1}, with(1.0, 25));
  const ChartInput& input = division.faces[0];
  EXPECT_EQ(input.chart.edges.size(), 15u);  // 360 / 25 = 14.4; 4 pi / 1 = 12.6
  for (const auto& edge : input.chart.edges) {
    EXPECT_NEAR(test::side_in_space(input, edge), 4.0 * std::sin(pi / 15), 1e-9);
  }
}

TEST(Division, EvenSidesTakeTheParameterOfTheCurveForNothing) {
  // The same straight side by a cubic that dwells at its ends.
  TrimmedSurface face{.surface = flat(10, 5), .loops = {polygon({{0, 0}, {10, 0}, {10, 5}, {0, 5}})}};
  face.loops[0].edges[0].curve = *Curve::bezier({{0, 0, 0}, {0, 0, 0}, {10, 0, 0}, {10, 0, 0}});
  face.loops[0].edges[0].name = "slow";
  const Division division = divided({&face, 1}, with(1.0, 15));
  EXPECT_EQ(count_of(division.faces[0], "slow"), 10u);
  for (const auto& edge : division.faces[0].chart.edges) {
    EXPECT_NEAR(test::side_in_space(division.faces[0], edge), 1.0, 1e-6);
  }
}

TEST(Division, TheBendOfTheSurfaceAcrossALineCounts) {
  // Straight lines of a cylinder of radius 1: 15 degrees of its turn are 0.262 m.
  const TrimmedSurface face{.surface = *Surface::cylinder({}, 1.0, {{0, 0}, {1.0, 2.0}})};
  const Division division = divided({&face, 1}, with(10, 15));
  EXPECT_EQ(count_of(division.faces[0], "left"), 8u);  // 2 / 0.2618 = 7.6
}

/// A cone with half a right angle to its axis is cut off so far from its apex. One point is 1e-6 of 11 m here, and 15
/// degrees of a circle are 0.26 of its radius.
TEST(Division, NoBendCountsAsSharperThanOnePoint) {
  const auto shortest_from = [](double low) {
    const TrimmedSurface face{.surface = *Surface::cone({}, 0.0, 0.25 * pi, {{0, low}, {1.5, 8}})};
    const Division division = divided({&face, 1}, with(1, 15));
    double shortest = 1.0;
    for (const auto& edge : division.faces[0].chart.edges) {
      if (division.faces[0].chart.sets[edge.set].name == "left")
        shortest = std::min(shortest, test::side_in_space(division.faces[0], edge));
    }
    return shortest;
  };
  EXPECT_GT(shortest_from(1e-8), 1e-6);
  EXPECT_LT(shortest_from(1e-8), 1e-5);
  EXPECT_LT(shortest_from(1e-3), 0.5e-3);
}

TEST(Division, TheChordCounts) {
  DivisionOptions options = with(10, 90);
  options.sizes.chord = 0.01;
  const TrimmedSurface face{.surface = *Surface::cylinder({}, 1.0, {{0, 0}, {1.0, 2.0}})};
  const Division division = divided({&face, 1}, options);
  EXPECT_EQ(count_of(division.faces[0], "left"), 9u);  // sqrt(6 * 0.01) = 0.245
}

TEST(Division, SizesGrowAlongTheBorderAndRoundCornersByNoMoreThanAllowed) {
  // A small arc between long sides.
  TrimmedSurface face{.surface = flat(100, 100), .loops = {{}}};
  ChartEdge corner = circle({99, 1}, 1.0);
  corner.curve = *Curve::arc({99, 1, 0}, {0, -1, 0}, {1, 0, 0}, 0.0, 0.5 * pi);
  corner.to = 0.5 * pi;
  face.loops[0].edges = {straight({0, 0}, {99, 0}), corner, straight({100, 1}, {100, 100}),
                         straight({100, 100}, {0, 100}), straight({0, 100}, {0, 0})};
  DivisionOptions options = with(10, 10);
  options.sizes.growth = 1.2;
  const Division division = divided({&face, 1}, options);
  const ChartInput& input = division.faces[0];
  double last = test::side_in_space(input, input.chart.edges.back());
  double greatest = 1.0;
  for (const auto& edge : input.chart.edges) {
    const double side = test::side_in_space(input, edge);
    greatest = std::max({greatest, side / last, last / side});
    last = side;
  }
  EXPECT_LE(greatest, 1.4);
  EXPECT_GE(greatest, 1.2);
}

TEST(Division, SidesOfANarrowPlaceAreAsShortAsItIsWide) {
  TrimmedSurface face{.surface = flat(20, 10), .loops = {polygon({{0, 0}, {20, 0}, {20, 10}, {0, 10}})}};
  trim::ChartLoop hole = polygon({{5, 0.5}, {5, 5}, {15, 5}, {15, 0.5}});  // clockwise
  face.loops.push_back(hole);
  const auto near = [](const ChartInput& input) {
    double longest = 0.0;
    for (const auto& edge : input.chart.edges) {
      const Point a = input.chart.points[edge.nodes[0].index()], b = input.chart.points[edge.nodes[1].index()];
      if (a.y < 0.6 && b.y < 0.6 && std::min(a.x, b.x) > 6 && std::max(a.x, b.x) < 14) {
        longest = std::max(longest, geom::distance(a, b));
      }
    }
    return longest;
  };
  DivisionOptions options = with(2.0, 15);
  options.sizes.narrow = 0.0;
  EXPECT_NEAR(near(divided({&face, 1}, options).faces[0]), 2.0, 1e-9);
  options.sizes.narrow = 1.0;
  EXPECT_LE(near(divided({&face, 1}, options).faces[0]), 0.5 + 1e-9);
  options.sizes.narrow = 2.0;
  EXPECT_LE(near(divided({&face, 1}, options).faces[0]), 0.25 + 1e-9);
}

/// Its ends are near along the border, for sizes longer than it is too; a corner is no narrow place.
TEST(Division, AStripHasAsManyElementsAcrossAsAsked) {
  const TrimmedSurface strip{.surface = flat(10, 0.1), .loops = {polygon({{0, 0}, {10, 0}, {10, 0.1}, {0, 0.1}})}};
  for (const double size : {0.5, 2.0, 40.0}) {
    for (const double elements : {1.0, 2.0, 3.0, 5.0}) {
      DivisionOptions options = with(size, 15);
      options.sizes.narrow = elements;
      double longest = 0.0;
      const ChartInput input = divided({&strip, 1}, options).faces[0];
      for (const auto& edge : input.chart.edges) {
        const Point a = input.chart.points[edge.nodes[0].index()], b = input.chart.points[edge.nodes[1].index()];
        if (std::min(a.x, b.x) > 3.0 && std::max(a.x, b.x) < 7.0) longest = std::max(longest, geom::distance(a, b));
      }
      const double least = std::max(0.1 / elements, 0.002 * size);
      EXPECT_LE(longest, least * (1.0 + 1e-9)) << size << ' ' << elements;
      EXPECT_GE(longest, 0.8 * least) << size << ' ' << elements;
    }
  }
  const TrimmedSurface wedge{.surface = flat(10, 2), .loops = {polygon({{0, 0}, {10, 0}, {10, 2}})}};
  DivisionOptions options = with(1.0, 15);
  EXPECT_LT(divided({&wedge, 1}, options).faces[0].chart.edges.size(), 40u);
}

// ---- common nodes

TEST(Division, FacesThatShareACurveHaveItsNodesWhateverTheirParameters) {
  // A quarter cylinder and a plane that touches it along its arc; the plane's arc runs the other way and is a rational
  // curve with another speed.
  TrimmedSurface cylinder{.surface = *Surface::cylinder({}, 1.0, {{0, 0}, {0.5 * pi, 2.0}}),
                          .loops = {polygon({{0, 0}, {0.5 * pi, 0}, {0.5 * pi, 2}, {0, 2}})}};
  TrimmedSurface plane{.surface = *Surface::plane({}, {{0, 0}, {1, 1}}), .loops = {{}}};
  const Curve arc = *Curve::bezier({{1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {1.0, std::sqrt(0.5), 1.0});
  plane.loops[0].edges = {
      straight({0, 0}, {1, 0}), {.curve = arc, .from = 0, .to = 1, .name = "rim"}, straight({0, 1}, {0, 0})};
  cylinder.loops[0].edges[0].shared = plane.loops[0].edges[1].shared = 7;
  const std::vector<TrimmedSurface> both{cylinder, plane};
  const Division division = divided(both, with(0.3, 10));
  const auto nodes_along = [](const ChartInput& input, std::uint32_t set) {
    std::vector<std::uint32_t> nodes;
    for (const auto& edge : input.chart.edges) {
      if (edge.set == set && nodes.empty()) nodes.push_back(input.node[edge.nodes[0].index()]);
      if (edge.set == set) nodes.push_back(input.node[edge.nodes[1].index()]);
    }
    return nodes;
  };
  std::vector<std::uint32_t> on_arc, on_cylinder;
  for (std::uint32_t k = 0; k < division.faces[1].chart.sets.size(); ++k) {
    if (division.faces[1].chart.sets[k].name == "rim") on_arc = nodes_along(division.faces[1], k);
  }
  ASSERT_EQ(on_arc.size(), 10u);  // 9 sides of 10 degrees
  for (const std::uint32_t node : on_arc) {
    const auto at = std::find(division.faces[0].node.begin(), division.faces[0].node.end(), node);
    ASSERT_NE(at, division.faces[0].node.end());
    const auto here = static_cast<std::size_t>(at - division.faces[0].node.begin());
    const auto there = static_cast<std::size_t>(
        std::find(division.faces[1].node.begin(), division.faces[1].node.end(), node) - division.faces[1].node.begin());
    EXPECT_EQ(division.faces[0].at[here], division.faces[1].at[there]);
    EXPECT_LE(geom::distance(division.faces[1].surface.at(division.faces[1].chart.points[there]),
                             division.faces[1].at[there]),
              1e-12);
  }
  EXPECT_TRUE(division.findings.empty());
}

TEST(Division, TheStricterFaceDecidesASharedCurve) {
  TrimmedSurface plane{.surface = flat(10, 10), .loops = {polygon({{0, 0}, {10, 0}, {10, 10}, {0, 10}})}};
  TrimmedSurface bent{
      .surface = *Surface::cylinder({{10, 0, 1}, {0, 0, -1}, {-1, 0, 0}, {0, 1, 0}}, 1.0, {{0, 0}, {1.0, 10.0}}),
      .loops = {polygon({{0, 0}, {1, 0}, {1, 10}, {0, 10}})}};
  plane.loops[0].edges[1].shared = bent.loops[0].edges[3].shared = 1;
  plane.loops[0].edges[1].name = bent.loops[0].edges[3].name = "common";
  bent.loops[0].edges[3].against = true;
  ASSERT_LE(geom::distance(plane.surface.at({10, 3}), bent.surface.at({0, 3})), 1e-12);
  const std::vector<TrimmedSurface> both{plane, bent};
  const Division division = divided(both, with(5, 15));
  EXPECT_EQ(count_of(division.faces[0], "common"), 39u);  // 10 / 0.2618 = 38.2
  EXPECT_EQ(count_of(division.faces[1], "common"), 39u);
}

TEST(Division, SaysHowFarFacesAreApartAlongAnEdgeTheyShare) {
  TrimmedSurface a{.surface = flat(10, 5), .loops = {polygon({{0, 0}, {10, 0}, {10, 5}, {0, 5}})}};
  TrimmedSurface b{.surface = *Surface::plane({.origin = {10.02, 0, 0}}, {{0, 0}, {10, 5}}),
                   .loops = {polygon({{0, 0}, {10, 0}, {10, 5}, {0, 5}})}};
  a.loops[0].edges[1].shared = b.loops[0].edges[3].shared = 1;
  b.loops[0].edges[3].against = true;
  std::vector<TrimmedSurface> both{a, b};
  const Division division = divided(both, with(1, 15));
  ASSERT_EQ(division.findings.size(), 1u);
  EXPECT_NE(division.findings[0].message.find("0.02"), std::string::npos) << division.findings[0].message;
  both[0].loops[0].edges[1].tolerance = 0.05;
  EXPECT_TRUE(divided(both, with(1, 15)).findings.empty());
}

TEST(Division, BothSidesOfASeamAreOneLineOfNodes) {
  const TrimmedSurface face{.surface = *Surface::cylinder({}, 1.0, {{0, 0}, {2 * pi, 2.0}})};
  const Division division = divided({&face, 1}, with(0.5, 15));
  const ChartInput& input = division.faces[0];
  std::map<double, std::set<std::uint32_t>> by_height;
  std::size_t on_seam = 0;
  for (std::size_t i = 0; i < input.node.size(); ++i) {
    const Point uv = input.chart.points[i];
    if (uv.x != 0.0 && uv.x != 2 * pi) continue;
    by_height[std::round(1e9 * uv.y)].insert(input.node[i]);
    ++on_seam;
  }
  EXPECT_EQ(by_height.size(), 9u);  // 2 / 0.2618 = 7.6
  EXPECT_EQ(on_seam, 18u);
  for (const auto& [height, nodes] : by_height) EXPECT_EQ(nodes.size(), 1u);
}

TEST(Division, ASideThatIsOnePointInSpaceIsOneNode) {
  const TrimmedSurface face{.surface = *Surface::sphere({}, 1.0, {{0, 0}, {0.5 * pi, 0.5 * pi}})};
  const Division division = divided({&face, 1}, with(0.3, 20));
  const ChartInput& input = division.faces[0];
  std::set<std::uint32_t> top;
  for (std::size_t i = 0; i < input.node.size(); ++i) {
    if (input.chart.points[i].y == 0.5 * pi) top.insert(input.node[i]);
  }
  EXPECT_EQ(top.size(), 1u);
  EXPECT_EQ(count_of(input, "top"), 1u);
}

// ---- lines and points inside

TEST(Division, ALineThatEndsOnALoopHasANodeThere) {
  TrimmedSurface face{.surface = flat(10, 5), .loops = {polygon({{0, 0}, {10, 0}, {10, 5}, {0, 5}})}};
  face.lines.push_back({{straight({3.7, 0}, {3.7, 5}, "fault")}, ChartLine::Kind::Interface});
  const Division division = divided({&face, 1}, with(1, 15));
  const ChartInput& input = division.faces[0];
  for (const Point end : {Point{3.7, 0}, Point{3.7, 5}}) {
    EXPECT_EQ(std::count_if(input.chart.points.begin(), input.chart.points.end(),
                            [&](Point p) { return geom::distance(p, end) < 1e-12; }),
              1);
  }
  EXPECT_EQ(count_of(input, "fault"), 5u);
  EXPECT_TRUE(test::delaunay_face(input).at.size() >= input.at.size());
}

/// Its end lies nearer to the loop than the tolerance, on the other side of which the line goes 1.4 times as far.
TEST(Division, ALineThatIsOnePointWithinTheToleranceGetsNoNodes) {
  TrimmedSurface face{.surface = flat(10, 10), .loops = {polygon({{0, 0}, {10, 0}, {10, 10}, {0, 10}})}};
  face.loops.push_back({{backwards(circle({5, 5}, 2.0, "hole"))}});
  const Division without = divided({&face, 1}, with(1, 25));
  constexpr double stub = 1.7e-5;
  const Point out = Point{5, 5} + 2.0 * geom::Vector{std::sqrt(0.5), std::sqrt(0.5)};
  const auto with_line_to = [&](Point end) {
    TrimmedSurface cut = face;
    cut.lines.push_back({{straight(out, end, "line")}, ChartLine::Kind::Constraint});
    return divided({&cut, 1}, with(1, 25));
  };
  const Division none = with_line_to(out + stub * geom::Vector{1, 0});
  EXPECT_EQ(count_of(none.faces[0], "line"), 0u);
  EXPECT_LE(none.nodes, without.nodes + 1);  // one where the line meets the hole
  EXPECT_TRUE(test::delaunay_face(none.faces[0]).at.size() >= none.faces[0].at.size());
  EXPECT_EQ(count_of(with_line_to(out + 10.0 * stub * geom::Vector{1, 0}).faces[0], "line"), 1u);
}

TEST(Division, LinesThatCrossHaveANodeThere) {
  TrimmedSurface face{.surface = flat(10, 5), .loops = {polygon({{0, 0}, {10, 0}, {10, 5}, {0, 5}})}};
  face.lines.push_back({{straight({1, 1}, {9, 4})}, ChartLine::Kind::Constraint});
  face.lines.push_back({{straight({1, 4}, {9, 1})}, ChartLine::Kind::Constraint});
  face.points.push_back({.at = {5, 2.5}, .name = "middle"});
  const Division division = divided({&face, 1}, with(0.7, 15));
  const ChartInput& input = division.faces[0];
  std::size_t found = 0;
  for (const Point p : input.chart.points) found += geom::distance(p, {5, 2.5}) < 1e-9 ? 1 : 0;
  EXPECT_EQ(found, 1u);
  ASSERT_EQ(input.chart.node_sets.at("middle").size(), 1u);
  EXPECT_TRUE(test::delaunay_face(input).at.size() >= input.at.size());
}

TEST(Division, AKinkOfTheSurfaceIsALineCutByTheLoops) {
  const Curve bent = *Curve::nurbs(1, {0, 0, 0.5, 1, 1}, {{0, 0, 0}, {5, 0, 3}, {10, 0, 0}});
  TrimmedSurface face{.surface = *Surface::extruded(bent, {0, 10, 0})};
  face.loops = {polygon({{0.1, 0.1}, {0.9, 0.1}, {0.9, 0.9}, {0.1, 0.9}})};
  face.loops.push_back({{backwards(circle({0.5, 0.5}, 0.2))}});
  const Division division = divided({&face, 1}, with(1, 15));
  const ChartInput& input = division.faces[0];
  double length = 0.0;
  for (const auto& edge : input.chart.edges) {
    if (input.chart.sets[edge.set].name != "kink") continue;
    EXPECT_EQ(input.chart.points[edge.nodes[0].index()].x, 0.5);
    length += test::side_in_space(input, edge);
  }
  EXPECT_NEAR(length, 10 * (0.8 - 0.4), 1e-9);
  EXPECT_EQ(std::count_if(division.findings.begin(), division.findings.end(),
                          [](const Finding& f) { return f.code == "kink"; }),
            2);
  EXPECT_TRUE(test::delaunay_face(input).at.size() >= input.at.size());
}

TEST(Division, NoTwoPointsOfAChartAreTheSame) {
  TrimmedSurface face{.surface = flat(10, 5), .loops = {polygon({{0, 0}, {10, 0}, {10, 5}, {0, 5}})}};
  face.loops.push_back(polygon({{5, 0}, {4, 2}, {6, 2}}));  // a hole that touches the border
  const Division division = divided({&face, 1}, with(1, 15));
  std::vector<Point> points = division.faces[0].chart.points;
  std::sort(points.begin(), points.end());
  EXPECT_EQ(std::adjacent_find(points.begin(), points.end()), points.end());
  const std::set<std::uint32_t> nodes(division.faces[0].node.begin(), division.faces[0].node.end());
  EXPECT_EQ(nodes.size(), division.nodes);
}

TEST(Division, SUR_k_TheSameInputGivesTheSameDivision) {
  TrimmedSurface face{.surface = *Surface::sphere({}, 5.0, {{0, -1}, {2, 1}})};
  face.lines.push_back({{straight({0.5, -0.5}, {1.5, 0.5})}, ChartLine::Kind::Constraint});
  const Division a = divided({&face, 1}, with(0.7, 10)), b = divided({&face, 1}, with(0.7, 10));
  EXPECT_EQ(a.faces[0].chart.points, b.faces[0].chart.points);
  EXPECT_EQ(a.faces[0].node, b.faces[0].node);
}

}  // namespace
}  // namespace dobra::surf::mesh
