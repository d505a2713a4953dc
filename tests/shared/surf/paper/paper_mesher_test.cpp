#include "shared/surf/paper/paper_mesher.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "shared/mesh/mesh_check.h"
#include "shared/mesh/quality.h"
#include "shared/surf/measure.h"
#include "shared/surf/paper/paper_front.h"
#include "tests/shared/surf/mesh/faces.h"
#include "tests/support/surface_stand_ins.h"

namespace dobra::surf::paper {
namespace {

using dobra::mesh::alpha_in_space;
using dobra::mesh::NodeId;
using geom::Point;
using geom::Point3;
using mesh::ChartInput;
using mesh::FaceMesh;
using mesh::test::circle;
using mesh::test::flat;
using mesh::test::halved;
using mesh::test::pi;
using mesh::test::polygon;
using mesh::test::straight;
using test::StandIn;
using trim::ChartLine;
using trim::TrimmedSurface;

FaceMesh face_of(const ChartInput& input, const PaperOptions& options) {
  auto made = paper_mesh(input, options);
  if (!made) {
    ADD_FAILURE() << base::to_string(made.error());
    return {};
  }
  // Every triangle of the chart anticlockwise, exactly; every side of two triangles at most; Euler.
  const auto right = dobra::mesh::check(made->chart);
  EXPECT_TRUE(right.ok()) << (right ? "" : base::to_string(right.error()));
  return *std::move(made);
}

PaperSurface surface_of(std::span<const TrimmedSurface> faces, const PaperOptions& options) {
  auto made = paper_mesh(faces, options);
  if (!made) {
    ADD_FAILURE() << base::to_string(made.error());
    return {};
  }
  return *std::move(made);
}

bool has_side(const FaceMesh& face, NodeId a, NodeId b) {
  for (const auto& c : face.chart.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      if ((c[i] == a && c[(i + 1) % 3] == b) || (c[i] == b && c[(i + 1) % 3] == a)) return true;
    }
  }
  return false;
}
void expect_given_points_and_sides(const ChartInput& input, const FaceMesh& face) {
  std::vector<std::uint8_t> used(face.at.size(), 0);
  for (const auto& c : face.chart.triangles) {
    for (const NodeId n : c) used[n.index()] = 1;
  }
  for (std::size_t i = 0; i < input.at.size(); ++i) {
    EXPECT_EQ(face.chart.points[i], input.chart.points[i]);
    EXPECT_EQ(face.at[i], input.at[i]);
    EXPECT_EQ(used[i], 1) << i;
  }
  for (const auto& edge : input.chart.edges) EXPECT_TRUE(has_side(face, edge.nodes[0], edge.nodes[1]));
}

TEST(PaperMesher, SUR_a_AlphaInSpaceTakesThePublishedValues) {
  const auto alpha = [](Point a, Point b, Point c) {
    const geom::Vector3 x = geom::normalised(geom::Vector3{1, 2, -1}), y = geom::normalised(cross({0, 1, 1}, x));
    const auto at = [&](Point p) { return Point3{3, -2, 7} + p.x * x + p.y * y; };
    return alpha_in_space(at(a), at(b), at(c));
  };
  EXPECT_NEAR(alpha({0, 0}, {1, 0}, {0.5, 0.5 * std::sqrt(3.0)}), 1.0, 1e-12);
  EXPECT_NEAR(alpha({0, 0}, {1, 0}, {0, 1}), 0.866025, 1e-6);
  EXPECT_NEAR(alpha({0, 0}, {3, 0}, {0, 4}), 0.831384, 1e-6);
  const auto isosceles = [&](double ratio) { return alpha({0, 0}, {1, 0}, {0.5, ratio}); };
  EXPECT_NEAR(isosceles(0.5), 0.866025, 1e-6);
  EXPECT_NEAR(isosceles(1.0), 0.989743, 1e-6);
  EXPECT_NEAR(isosceles(2.0), 0.729285, 1e-6);
  EXPECT_GE(isosceles(0.543), 0.9);
  EXPECT_LT(isosceles(0.5427), 0.9);
  EXPECT_GE(isosceles(1.381), 0.9);
  EXPECT_LT(isosceles(1.3818), 0.9);
}

// ---- what is wrong

TEST(PaperMesher, RefusesABorderThatCrossesItselfWithThePlaceInSpace) {
  TrimmedSurface face{.surface = *Surface::cylinder({}, 5.0, {{0, 0}, {2, 10}})};
  face.loops = {polygon({{0, 0}, {2, 0}, {0, 10}, {2, 10}})};
  const auto made = paper_mesh({&face, 1}, {.largest = 1.0});
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.error().code, base::ErrorCode::SelfIntersection);
  ASSERT_TRUE(made.error().place && made.error().place->z && made.error().place->v);
  EXPECT_NEAR(*made.error().place->v, 5.0, 0.6);
  EXPECT_NEAR(std::hypot(*made.error().place->x, *made.error().place->y), 5.0, 1e-6);
}

TEST(PaperMesher, RefusesOptionsThatMeanNothing) {
  const ChartInput input = halved({.surface = flat(4, 2)}, 1, 15);
  for (const auto spoil :
       {+[](PaperOptions& o) { o.phi = 1.5; }, +[](PaperOptions& o) { o.largest = -1; },
        +[](PaperOptions& o) { o.least_distance = std::nan(""); }, +[](PaperOptions& o) { o.height = 0; },
        +[](PaperOptions& o) { o.sphere = -1; }, +[](PaperOptions& o) { o.turn = 0; }}) {
    PaperOptions options;
    spoil(options);
    const auto made = paper_mesh(input, options);
    ASSERT_FALSE(made.ok());
    EXPECT_EQ(made.error().code, base::ErrorCode::InvalidOption);
  }
}

TEST(PaperMesher, StopsAtTheNumberOfTrianglesAllowedAndWhenCancelled) {
  const ChartInput input = halved({.surface = flat(10, 10)}, 0.5, 15);
  EXPECT_EQ(paper_mesh(input, {.largest = 0.5, .most_triangles = 100}).error().code, base::ErrorCode::TooManyElements);
  const base::CancelToken token;
  token.cancel();
  EXPECT_EQ(paper_mesh(input, {.largest = 0.5}, base::Progress(token, {})).error().code, base::ErrorCode::Cancelled);
}

TEST(PaperFront, VerifyRefusesWhatThePaperRefuses) {
  const ChartInput input = halved({.surface = flat(10, 10)}, 1, 15);
  auto tree = ChartQuadtree::build(input, {.largest = 1.0});
  ASSERT_TRUE(tree.ok());
  PaperFront front(*tree);
  const auto node = [&](double x, double y, bool loose = false) { return front.add_node({x, y}, {x, y, 0}, loose); };
  const auto a = node(4, 4), b = node(5, 4), c = node(5, 5), d = node(4, 6);
  front.add_segment(a, b, 0, 0);
  front.add_segment(b, c, 0, 0);
  front.add_segment(c, d, 0, 0);
  const auto fresh = [](double x, double y) { return PaperFront::Corner{{x, y}, {x, y, 0}, PaperFront::none}; };
  EXPECT_TRUE(front.valid(a, b, front.corner(c), 0.0));
  EXPECT_TRUE(front.valid(a, b, fresh(4.5, 4.8), 0.3));
  EXPECT_FALSE(front.valid(a, b, fresh(4.5, 3.5), 0.0));  // on the wrong side
  EXPECT_FALSE(front.valid(a, b, fresh(4.5, 4.0), 0.0));  // no area
  EXPECT_FALSE(front.valid(a, b, fresh(6.0, 4.5), 0.0));  // across a segment
  EXPECT_FALSE(front.valid(a, b, fresh(5.0, 4.5), 0.0));  // on one
  EXPECT_FALSE(front.valid(a, b, fresh(4.9, 4.5), 0.3));  // too near to one
  EXPECT_TRUE(front.valid(a, b, fresh(4.9, 4.5), 0.0));
  node(4.5, 4.3, true);
  EXPECT_FALSE(front.valid(a, b, fresh(4.5, 4.8), 0.0));  // a node inside
  EXPECT_FALSE(front.valid(a, b, front.corner(d), 0.0));
}

// ---- the tables

struct Floor {
  double mean, good, least;
};
void expect_table(const StandIn& s, std::size_t holes, const Floor& floor) {
  SCOPED_TRACE(s.name);
  const PaperSurface made = surface_of({&s.face, 1}, {.largest = s.largest, .turn = s.turn});
  EXPECT_TRUE(mesh::check(made.mesh).ok());
  const mesh::SurfaceQuality q = mesh::quality_of(made.mesh);
  EXPECT_GE(q.alpha_mean, floor.mean);
  EXPECT_GE(q.alpha_90, floor.good);
  EXPECT_GE(q.alpha_min, floor.least);
  EXPECT_EQ(q.triangles, 2 * q.nodes - q.boundary_edges - 2 + 2 * holes);
  EXPECT_EQ(q.euler, 1 - static_cast<std::int64_t>(holes));
  EXPECT_LE(q.gauss_bonnet, 1e-9);
  if (std::getenv("DOBRA_PAPER_TABLE") != nullptr) {
    std::printf("%s | %g | %g | %zu | %zu | %.3f | %.1f | %.3f | %.4f\n", s.name.c_str(), s.largest, s.turn,
                q.triangles, q.nodes, q.alpha_mean, 100.0 * q.alpha_90, q.alpha_min, q.area);
  }
}
constexpr Floor floors{0.90, 0.75, 0.15};

void expect_tables(const std::string& first_letter) {
  for (const StandIn& s : test::stand_ins()) {
    if (!s.name.starts_with(first_letter)) continue;
    const bool ring = s.name == "7d";  // its seam is one curve: a ring has two contours
    expect_table(s, s.face.loops.size() - 1 + (ring ? 1 : 0), floors);
  }
}
TEST(PaperMesher, SUR_f_CoonsSurfaceReachesTheFloors) { expect_tables("6"); }
TEST(PaperMesher, SUR_f_SixKindsOfCurvatureReachTheFloors) { expect_tables("7"); }
TEST(PaperMesher, SUR_f_TrimmedSurfacesReachTheFloors) { expect_tables("8"); }

TEST(PaperMesher, SUR_f_WavesByTheirFormulaReachTheFloors) {
  StandIn s = test::stand_ins()[0];
  s.name = "7f by its formula";
  s.face = TrimmedSurface{*Surface::graph("1.5 * sin(x) * cos(y)", {{0, 0}, {10, 10}})};
  s.largest = 0.5;
  s.turn = 5.0;
  expect_table(s, 0, floors);
}

TEST(PaperMesher, SUR_f_FinerSizesAndAnglesMakeMoreTriangles) {
  const StandIn s = test::stand_ins()[0];
  std::size_t last = 0;
  for (const auto& [largest, turn] : {std::pair{2.0, 20.0}, {2.0, 10.0}, {1.0, 10.0}, {0.5, 10.0}, {0.5, 5.0}}) {
    const std::size_t count = surface_of({&s.face, 1}, {.largest = largest, .turn = turn}).mesh.triangles.size();
    EXPECT_GT(count, last);
    last = count;
  }
}

TEST(PaperMesher, SUR_f_TheCriticalCaseIsRuledByTheAngle) {
  StandIn s = test::stand_ins()[0];
  s.name = "6 critical";
  s.largest = 3.0;
  s.turn = 3.0;
  expect_table(s, 0, floors);
}

// ---- trimming

double shoelace(const ChartInput& input) {
  double area = 0.0;
  for (const auto& edge : input.chart.edges) {
    if (input.chart.sets[edge.set].kind != dobra::mesh::delaunay::EdgeKind::Boundary) continue;
    const Point a = input.chart.points[edge.nodes[0].index()], b = input.chart.points[edge.nodes[1].index()];
    area += 0.5 * (a.x * b.y - b.x * a.y);
  }
  return area;
}

TEST(PaperMesher, SUR_g_HolesContoursAndLinesAreKept) {
  for (const StandIn& s : test::stand_ins()) {
    if (s.name != "8a" && s.name != "8c" && s.name != "8e") continue;
    SCOPED_TRACE(s.name);
    const ChartInput input = halved(s.face, s.largest, s.turn);
    const FaceMesh face = face_of(input, {.largest = s.largest, .turn = s.turn});
    expect_given_points_and_sides(input, face);
    // The chart's area is that of the polygons of its border: so no node is outside of it.
    EXPECT_NEAR(dobra::mesh::area(face.chart), shoelace(input), 1e-12 * shoelace(input));
    for (std::size_t n = 0; n < face.at.size(); ++n) {
      EXPECT_LE(distance(input.surface.at(face.chart.points[n]), face.at[n]), 1e-9);
    }
  }
}

TEST(PaperMesher, SUR_g_ContoursInsideHolesClosedLinesAndPointsAreKept) {
  TrimmedSurface face{.surface = flat(10, 10), .loops = {polygon({{0, 0}, {10, 0}, {10, 10}, {0, 10}})}};
  face.loops.push_back({{mesh::test::backwards(circle({3, 3}, 2.0))}});
  face.loops.push_back({{circle({3, 3}, 1.0)}});  // an island in the hole
  face.lines.push_back({{circle({7, 7}, 1.5, "ring")}, ChartLine::Kind::Interface});
  face.points = {{.at = {7, 2}, .name = "well"}, {.at = {7.05, 7.1}}};
  face.regions = {{{7, 7}, 2, "core"}, {{1, 9}, 1, "rest"}, {{3, 3}, 4, "island"}};
  const ChartInput input = halved(face, 0.8, 15);
  const FaceMesh made = face_of(input, {.largest = 0.8, .turn = 15});
  expect_given_points_and_sides(input, made);
  std::map<std::int32_t, double> areas;
  for (std::size_t t = 0; t < made.chart.triangles.size(); ++t) {
    areas[made.chart.regions[t]] += dobra::mesh::area(made.chart, dobra::mesh::TriangleId(t));
  }
  EXPECT_EQ(areas.size(), 3u);
  EXPECT_NEAR(areas.at(2), pi * 1.5 * 1.5, 0.15);
  EXPECT_NEAR(areas.at(4), pi, 0.1);
  EXPECT_EQ(made.chart.node_sets.at("well").size(), 1u);
  EXPECT_EQ(made.chart.constraint_sets.at("ring").size(), mesh::test::count_of(input, "ring"));
}

TEST(PaperMesher, SUR_h_AreasAreWithinOnePerCent) {
  const TrimmedSurface cylinder{.surface = *Surface::cylinder({}, 5.0, {{0, 0}, {pi, 10}})};
  const TrimmedSurface sphere{.surface = *Surface::sphere({}, 5.0, {{0, -pi / 3}, {pi, pi / 3}})};
  const TrimmedSurface torus{.surface = *Surface::torus({}, 6.0, 2.0, {{0, 0}, {1.5 * pi, 2 * pi}})};
  for (const auto& [face, exact] :
       {std::pair{cylinder, 50 * pi}, {sphere, 25 * pi * std::sqrt(3.0)}, {torus, 1.5 * pi * 2 * pi * 12}}) {
    const double area = mesh::quality_of(surface_of({&face, 1}, {.largest = 1.0, .turn = 10}).mesh).area;
    EXPECT_NEAR(area, exact, 0.01 * exact);
    EXPECT_LT(area, exact);
  }
}

// ---- smoothing

TEST(PaperMesher, SUR_i_SmoothingNeverMakesTheMeanWorseAndKeepsTheBorder) {
  const StandIn s = test::stand_ins()[14];
  const ChartInput input = halved(s.face, s.largest, s.turn);
  const auto mean = [](const FaceMesh& face) {
    double sum = 0.0;
    for (const auto& c : face.chart.triangles) {
      sum += alpha_in_space(face.at[c[0].index()], face.at[c[1].index()], face.at[c[2].index()]);
    }
    return sum / static_cast<double>(face.chart.triangles.size());
  };
  std::vector<FaceMesh> faces;
  for (const int passes : {0, 3, 5}) {
    faces.push_back(face_of(input, {.largest = s.largest, .turn = s.turn, .passes = passes}));
  }
  EXPECT_GT(mean(faces[1]), mean(faces[0]) + 0.01);
  EXPECT_GE(mean(faces[2]), mean(faces[1]));
  for (std::size_t i = 0; i < input.at.size(); ++i) EXPECT_EQ(faces[2].at[i], input.at[i]);
  const FaceMesh still = face_of(input, {.largest = s.largest, .turn = s.turn, .passes = 5, .phi = 0.0});
  EXPECT_EQ(still.chart, faces[0].chart);
}

// ---- the order of things

TEST(PaperMesher, SUR_j_AllSegmentsOfALevelAreUsedBeforeAnyOfTheNext) {
  const ChartInput input = halved({.surface = flat(10, 10)}, 0.7, 15);
  auto mesher = PaperMesher::start(input, {.largest = 0.7});
  ASSERT_TRUE(mesher.ok());
  std::set<std::array<std::uint32_t, 2>> border;
  for (const auto& side : mesher->view().front) border.insert(side.nodes);
  while (!mesher->done()) ASSERT_TRUE(mesher->step(10).ok());
  std::uint32_t last = 0;
  std::map<std::uint32_t, double> shortest;
  for (const Made& made : mesher->log()) {
    EXPECT_GE(made.level, last);
    EXPECT_LE(made.created, made.level);
    last = made.level;
    EXPECT_EQ(made.created == 0, border.contains({made.triangle[0], made.triangle[1]}));
  }
  EXPECT_GE(last, 5u);
  // The first row is of the border alone, and as long.
  const auto in_row = static_cast<std::size_t>(
      std::count_if(mesher->log().begin(), mesher->log().end(), [](const Made& made) { return made.level == 0; }));
  EXPECT_LE(in_row, border.size());
  EXPECT_GE(in_row, border.size() / 2);
}

TEST(PaperMesher, TheShortestSegmentGoesFirst) {
  TrimmedSurface face{.surface = flat(10, 10), .loops = {polygon({{0, 0}, {10, 0}, {10, 10}, {0, 10}})}};
  face.loops.push_back({{mesh::test::backwards(circle({5, 5}, 0.5))}});
  const ChartInput input = halved(face, 1, 15);
  auto mesher = PaperMesher::start(input, {.largest = 1.0});
  ASSERT_TRUE(mesher.ok());
  const auto next = mesher->next();
  ASSERT_TRUE(next.segment.has_value());
  const double length = distance(input.at[(*next.segment)[0]], input.at[(*next.segment)[1]]);
  for (const auto& edge : input.chart.edges) {
    EXPECT_LE(length, distance(input.at[edge.nodes[0].index()], input.at[edge.nodes[1].index()]));
  }
  ASSERT_TRUE(mesher->step(1).ok());
  ASSERT_EQ(mesher->log().size(), 1u);
  EXPECT_EQ(mesher->log()[0].triangle[0], (*next.segment)[0]);
}

TEST(PaperMesher, SUR_k_TheSameInputGivesTheSameMeshWhateverTheSteps) {
  const StandIn s = test::stand_ins()[5];
  const ChartInput input = halved(s.face, s.largest, s.turn);
  const FaceMesh once = face_of(input, {.largest = s.largest, .turn = s.turn});
  auto mesher = PaperMesher::start(input, {.largest = s.largest, .turn = s.turn});
  ASSERT_TRUE(mesher.ok());
  std::size_t count = 1;
  while (!mesher->done()) ASSERT_TRUE(mesher->step(count++).ok());
  EXPECT_EQ(mesher->mesh().chart, once.chart);
  EXPECT_EQ(mesher->mesh().at, once.at);
}

// ---- it always ends

TEST(PaperMesher, ClosesAFrontThatNoRuleGoesOnWith) {
  TrimmedSurface face{.surface = flat(10, 10), .loops = {polygon({{0, 0}, {10, 0}, {10, 10}, {0, 10}})}};
  face.loops.push_back({{mesh::test::backwards(circle({5, 5}, 2.0))}});
  face.points = {{.at = {1.7, 8.1}}};
  const ChartInput input = halved(face, 1, 15);
  // No new node is ever far enough from the front, nor may a corner be closed.
  PaperOptions options{.largest = 1.0, .least_distance = 100.0, .corner = 0.0, .passes = 0};
  options.sphere = 1e-9;
  auto mesher = PaperMesher::start(input, options);
  ASSERT_TRUE(mesher.ok());
  while (!mesher->done()) ASSERT_TRUE(mesher->step(100).ok());
  expect_given_points_and_sides(input, mesher->mesh());
  EXPECT_NEAR(dobra::mesh::area(mesher->mesh().chart), shoelace(input), 1e-9);
  EXPECT_GT(std::count_if(mesher->log().begin(), mesher->log().end(),
                          [](const Made& made) { return made.rule == Rule::Closing; }),
            0);
}

TEST(PaperMesher, RandomStarsOfAnyShapeAreFilled) {
  for (unsigned seed = 1; seed <= 25; ++seed) {
    SCOPED_TRACE(seed);
    std::uint64_t state = 0x9E3779B97F4A7C15ULL * seed;
    const auto chance = [&] {
      state = state * 6364136223846793005ULL + 1442695040888963407ULL;
      return static_cast<double>(state >> 40U) / 16777216.0;
    };
    std::vector<Point> corners;
    const int count = 5 + static_cast<int>(10 * chance());
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * pi * (i + 0.6 * chance()) / count, radius = 0.02 + 0.46 * chance();
      corners.push_back({0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle)});
    }
    TrimmedSurface face{.surface = test::stand_in::coons(), .loops = {polygon(corners)}};
    const ChartInput input = halved(face, 0.7, 12);
    const FaceMesh made = face_of(input, {.largest = 0.7, .turn = 12});
    expect_given_points_and_sides(input, made);
    EXPECT_NEAR(dobra::mesh::area(made.chart), shoelace(input), 1e-12);
  }
}

TEST(PaperMesher, ClosedSurfacesAndPolesAreMeshed) {
  const TrimmedSurface sphere{.surface = *Surface::sphere({}, 1.0, {{-pi, -0.5 * pi}, {pi, 0.5 * pi}})};
  const PaperSurface ball = surface_of({&sphere, 1}, {.largest = 0.3, .turn = 15});
  const mesh::SurfaceQuality round = mesh::quality_of(ball.mesh);
  EXPECT_EQ(round.euler, 2);
  EXPECT_EQ(round.boundary_edges, 0u);
  EXPECT_NEAR(round.area, 4 * pi, 0.04 * 4 * pi);
  const TrimmedSurface torus{.surface = *Surface::torus({}, 3.0, 1.0, {{0, 0}, {2 * pi, 2 * pi}})};
  const mesh::SurfaceQuality ring = mesh::quality_of(surface_of({&torus, 1}, {.largest = 0.5, .turn = 15}).mesh);
  EXPECT_EQ(ring.euler, 0);
  EXPECT_EQ(ring.boundary_edges, 0u);
  EXPECT_GE(ring.alpha_mean, 0.9);
}

TEST(PaperMesher, FacesThatShareACurveAreOneMeshAndACrackIsOpened) {
  TrimmedSurface roof{
      .surface = *Surface::cylinder({{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}}, 5.0, {{0, -4}, {0.5 * pi, 0}}),
      .loops = {polygon({{0, -4}, {0.5 * pi, -4}, {0.5 * pi, 0}, {0, 0}})}};
  TrimmedSurface floor{.surface = *Surface::plane({.origin = {5, 0, 0}}, {{0, 0}, {3, 4}}),
                       .loops = {polygon({{0, 0}, {3, 0}, {3, 4}, {0, 4}})}};
  roof.loops[0].edges[3].shared = floor.loops[0].edges[3].shared = 1;
  floor.loops[0].edges[3].against = true;
  roof.lines.push_back({{straight({0.4, -3}, {1.1, -1}, "c")}, ChartLine::Kind::Crack});
  const std::vector<TrimmedSurface> both{roof, floor};
  const PaperSurface made = surface_of(both, {.largest = 0.5, .turn = 10});
  EXPECT_TRUE(mesh::check(made.mesh).ok());
  const mesh::SurfaceQuality quality = mesh::quality_of(made.mesh);
  EXPECT_EQ(quality.components, 1u);
  EXPECT_EQ(quality.euler, 0);
  EXPECT_EQ(quality.loops, 2u);
  EXPECT_GE(quality.alpha_mean, 0.93);
  EXPECT_EQ(made.mesh.boundary_sets.at("c_left").size(), made.mesh.boundary_sets.at("c_right").size());
  EXPECT_NEAR(quality.area, 12 + 4 * 2.5 * pi, 0.01 * 43);
}

TEST(PaperMesher, WithTheSizesAsPrintedTheMeshIsRightThoughItsTrianglesAreWorse) {
  const StandIn s = test::stand_ins()[0];
  const ChartInput input = halved(s.face, s.largest, s.turn);
  const FaceMesh made = face_of(input, as_printed({.largest = s.largest, .turn = s.turn}));
  expect_given_points_and_sides(input, made);
}

}  // namespace
}  // namespace dobra::surf::paper
