#include "shared/mesh/front/triangulate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "shared/mesh/delaunay/delaunay.h"
#include "shared/mesh/lips.h"
#include "shared/mesh/mesh_check.h"
#include "shared/mesh/quality.h"
#include "tests/shared/mesh/mesh_shapes.h"

namespace dobra::mesh::front {
namespace {

using base::ErrorCode;
using geom::Point;

void report(const std::string& name, const MeshQuality& q) {
  testing::Test::RecordProperty(name + " elements", std::to_string(q.triangles));
  testing::Test::RecordProperty(name + " alpha mean", std::to_string(q.alpha_mean));
  testing::Test::RecordProperty(name + " alpha 90", std::to_string(q.alpha_90));
  testing::Test::RecordProperty(name + " alpha min", std::to_string(q.alpha_min));
  testing::Test::RecordProperty(name + " gradation p95", std::to_string(q.gradation_p95));
}

/// Every input edge is an edge of the mesh in the set of its name, and the boundary is nothing but the boundary sets.
void expect_edges_as_given(const delaunay::MeshInput& input, const TriangleMesh& mesh) {
  std::set<std::array<Point, 2>> sides;
  std::size_t in_sets = 0;
  for (const auto* sets : {&mesh.boundary_sets, &mesh.constraint_sets}) {
    for (const auto& [name, edges] : *sets) {
      for (const Edge& edge : edges)
        sides.insert(
            {std::min(mesh.point(edge[0]), mesh.point(edge[1])), std::max(mesh.point(edge[0]), mesh.point(edge[1]))});
    }
  }
  for (const auto& [name, edges] : mesh.boundary_sets) in_sets += edges.size();
  for (const delaunay::InputEdge& edge : input.edges) {
    const Point a = input.points[edge.nodes[0].index()];
    const Point b = input.points[edge.nodes[1].index()];
    EXPECT_EQ(sides.count({std::min(a, b), std::max(a, b)}), 1U) << a << " - " << b;
  }
  EXPECT_EQ(boundary_edges(mesh).size(), in_sets);
}

TEST(Triangulate, QUE_d_QuarterPlateWithoutConstraintsIsAValidMesh) {
  const delaunay::MeshInput input = test::que_d();
  const TriangleMesh mesh = triangulate(input).value();
  ASSERT_TRUE(check(mesh));
  expect_edges_as_given(input, mesh);
  EXPECT_NEAR(area(mesh), test::quarter_plate_area(24), 1e-12);
  const MeshQuality quality = quality_of(mesh);
  report("QUE-d", quality);
  EXPECT_GE(quality.alpha_mean, 0.90);
  EXPECT_GT(quality.alpha_min, 0.2);
}

TEST(Triangulate, QUE_e_SixConstraintsAreObeyedAndTheGradationIsGentler) {
  const delaunay::MeshInput input = test::que_e();
  const TriangleMesh mesh = triangulate(input).value();
  ASSERT_TRUE(check(mesh));
  expect_edges_as_given(input, mesh);
  EXPECT_NEAR(area(mesh), test::quarter_plate_area(24), 1e-12);
  const MeshQuality quality = quality_of(mesh);
  const MeshQuality without = quality_of(triangulate(test::que_d()).value());
  report("QUE-e", quality);
  EXPECT_GT(quality.triangles, without.triangles);
  EXPECT_LT(quality.gradation_p95, without.gradation_p95);
  EXPECT_LE(quality.gradation_p95, 3.0);
  EXPECT_GE(quality.alpha_mean, 0.93);
  EXPECT_GE(quality.alpha_min, 0.6);
}

TEST(Triangulate, AUniformSquareComesOutNearlyEquilateral) {
  const MeshQuality quality = quality_of(triangulate(test::square(1.0, 40)).value());
  EXPECT_GE(quality.alpha_mean, 0.97);
  EXPECT_GE(quality.alpha_90, 0.95);
  // Equilateral triangles of side 1/40 fill the square with 4 / sqrt(3) * 1600.
  EXPECT_NEAR(static_cast<double>(quality.triangles), 3695.0, 500.0);
}

TEST(Triangulate, GradedBySixtyStaysAboveTheFloorOfQuality) {
  const MeshQuality quality =
      quality_of(triangulate(test::quarter_plate(test::graded(1.0, 5.0, 44, 1.1), 157, 8, {})).value());
  EXPECT_GE(quality.alpha_mean, 0.95);
  EXPECT_GE(quality.alpha_min, 0.6);
}

TEST(Triangulate, LargePlatesUniformAndGradedAThousandTimesKeepTheirFloorsOfQuality) {
  const MeshQuality uniform = quality_of(triangulate(test::uniform_plate(30'000)).value());
  report("uniform plate", uniform);
  EXPECT_GE(uniform.alpha_mean, 0.985);
  EXPECT_GE(uniform.alpha_90, 0.98);
  EXPECT_GE(uniform.alpha_min, 0.60);
  EXPECT_NEAR(static_cast<double>(uniform.triangles), 30'000.0, 3'000.0);
  const auto plate = test::graded_plate(30'000);
  MeshOptions options;
  options.sizes.growth = plate.growth;
  const MeshQuality graded = quality_of(triangulate(plate.input, options).value());
  report("graded plate", graded);
  EXPECT_GE(graded.alpha_mean, 0.96);
  EXPECT_GE(graded.alpha_90, 0.93);
  EXPECT_GE(graded.alpha_min, 0.55);
  EXPECT_NEAR(static_cast<double>(graded.triangles), 30'000.0, 6'000.0);
}

TEST(Triangulate, ARequestedSizeIsReachedWithinThirtyPercent) {
  delaunay::MeshInput input = test::square(10.0, 10);
  input.sizes.push_back({{5, 5}, 0.1});
  const TriangleMesh mesh = triangulate(input).value();
  double sum = 0.0;
  int count = 0;
  for (const Edge& edge : all_edges(mesh)) {
    if (geom::distance(geom::midpoint(mesh.point(edge[0]), mesh.point(edge[1])), {5, 5}) > 0.12) continue;
    sum += geom::distance(mesh.point(edge[0]), mesh.point(edge[1]));
    ++count;
  }
  ASSERT_GT(count, 0);
  EXPECT_NEAR(sum / count, 0.1, 0.03);
}

TEST(Triangulate, FreePointsStayAndAreFoundInTheirSet) {
  delaunay::MeshInput input = test::square(1.0, 8);
  input.node_sets["probe"] = {NodeId(input.points.size())};
  input.points.push_back({0.412, 0.377});
  const TriangleMesh mesh = triangulate(input).value();
  EXPECT_EQ(mesh.point(mesh.node_sets.at("probe").front()), (Point{0.412, 0.377}));
  EXPECT_NE(std::find(mesh.points.begin(), mesh.points.end(), Point{0.412, 0.377}), mesh.points.end());
}

TEST(Triangulate, SUR_k_TheSameInputGivesTheSameMesh) {
  EXPECT_EQ(triangulate(test::que_e()).value(), triangulate(test::que_e()).value());
}

TEST(Triangulate, AConstraintThatTouchesTheBoundaryAtAVertexIsJoinedToIt) {
  delaunay::MeshInput input = test::square(1.0, 4);
  add_chain(input, {{0.5, 0.0}, {0.5, 0.25}, {0.5, 0.5}}, delaunay::Closure::Open,
            {"crack", delaunay::EdgeKind::Constraint});
  // This one ends inside a boundary edge, exactly on it: the edge is cut there.
  add_chain(input, {{0.125, 0.0}, {0.25, 0.25}}, delaunay::Closure::Open, {"branch", delaunay::EdgeKind::Constraint});
  const TriangleMesh mesh = triangulate(input).value();
  EXPECT_TRUE(check(mesh));
  EXPECT_EQ(mesh.boundary_sets.at("outer").size(), 17U);
  EXPECT_DOUBLE_EQ(area(mesh), 1.0);
}

/// A crack of three sides, and a constraint beside it, in the widest triangle of the domain.
void add_crack_and_constraint(delaunay::MeshInput& input) {
  const TriangleMesh plain = constrained_delaunay(input, delaunay::Outside::Remove).value().mesh;
  double radius = 0.0;
  Point centre;
  for (const auto& corners : plain.triangles) {
    const Point a = plain.point(corners[0]);
    const Point b = plain.point(corners[1]);
    const Point c = plain.point(corners[2]);
    const double la = geom::distance(b, c);
    const double lb = geom::distance(c, a);
    const double lc = geom::distance(a, b);
    const double around = la + lb + lc;
    const double inner = geom::cross(b - a, c - a) / around;
    if (inner <= radius) continue;
    radius = inner;
    centre = {(la * a.x + lb * b.x + lc * c.x) / around, (la * a.y + lb * b.y + lc * c.y) / around};
  }
  const auto at = [&](double x, double y) { return Point{centre.x + x * radius, centre.y + y * radius}; };
  add_chain(input, {at(-0.5, 0.0), at(-0.2, 0.0), at(0.1, 0.1), at(0.4, 0.1)}, delaunay::Closure::Open,
            {"crack", delaunay::EdgeKind::Constraint});
  add_chain(input, {at(-0.5, 0.4), at(0.5, 0.5)}, delaunay::Closure::Open, {"band", delaunay::EdgeKind::Constraint});
}

/// The crack of a mesh opens into two lips whose nodes lie on each other and are distinct but at the tips.
void expect_lips_open(const TriangleMesh& mesh) {
  const std::vector<std::string> cracks{"crack"};
  const auto open = open_lips(element_mesh_of(mesh), cracks);
  ASSERT_TRUE(open) << to_string(open.error());
  const auto& left = open->side_sets.at("crack_left");
  const auto& right = open->side_sets.at("crack_right");
  ASSERT_EQ(left.size(), mesh.constraint_sets.at("crack").size());
  ASSERT_EQ(right.size(), left.size());
  for (std::size_t i = 0; i < left.size(); ++i) {
    const auto a = side_nodes(*open, left[i]);
    const auto b = side_nodes(*open, right[i]);
    EXPECT_EQ(open->point(a[0]), open->point(b[1]));
    EXPECT_EQ(open->point(a[1]), open->point(b[0]));
    EXPECT_EQ(a[0] == b[1], i == 0);
    EXPECT_EQ(a[1] == b[0], i + 1 == left.size());
  }
}

class TriangulateContours : public testing::TestWithParam<Engine> {};

TEST_P(TriangulateContours, EveryContourWithACrackAndAConstraintMeshesAtThreeSizes) {
  if (test::contours_folder().empty()) GTEST_SKIP() << dobra::test::no_data;
  std::size_t files = 0;
  for (const auto& file : std::filesystem::directory_iterator(test::contours_folder())) {
    if (file.path().extension() != ".txt" && file.path().extension() != ".dat") continue;
    ++files;
    delaunay::MeshInput outline = test::read_contour(file.path());
    add_crack_and_constraint(outline);
    const double extent = geom::box_of(outline.points).diagonal();
    std::size_t before = 0;
    for (const double size : {0.1 * extent, 0.03 * extent, 0.01 * extent}) {
      SCOPED_TRACE(file.path().filename().string() + " size " + std::to_string(size));
      const delaunay::MeshInput input = test::divided(outline, size);
      MeshOptions options;
      options.engine = GetParam();
      options.sizes.max_size = size;
      const auto result = triangulate(input, options);
      ASSERT_TRUE(result) << to_string(result.error());
      const auto valid = check(*result);
      EXPECT_TRUE(valid) << to_string(valid.error());
      const double wanted = test::boundary_area(*result);
      EXPECT_NEAR(area(*result), wanted, 1e-10 * wanted);
      EXPECT_TRUE(topology_of(*result).euler_holds());
      EXPECT_EQ(topology_of(*result).unused_nodes, 0U);
      expect_edges_as_given(input, *result);
      expect_lips_open(*result);
      EXPECT_GT(result->triangles.size(), before);
      before = result->triangles.size();
    }
  }
  EXPECT_GE(files, 6U);
}

INSTANTIATE_TEST_SUITE_P(Engines, TriangulateContours, testing::Values(Engine::Front, Engine::Delaunay),
                         [](const auto& test) { return test.param == Engine::Front ? "Front" : "Delaunay"; });

TEST(Triangulate, BothEnginesObeyTheSizesAndKeepTheirFloorsOfQuality) {
  const delaunay::MeshInput steep = test::quarter_plate(test::graded(1.0, 5.0, 44, 1.15), 785, 10, {});
  delaunay::MeshInput request = test::square(10.0, 10);
  request.sizes.push_back({{5, 5}, 0.1});
  for (const Engine engine : {Engine::Front, Engine::Delaunay}) {
    SCOPED_TRACE(engine == Engine::Front ? "front" : "delaunay");
    for (const delaunay::MeshInput& input : {test::square(1.0, 40), test::que_e(), steep, request}) {
      const TriangleMesh mesh = triangulate(input, {.engine = engine}).value();
      EXPECT_TRUE(check(mesh));
      expect_edges_as_given(input, mesh);
      const MeshQuality quality = quality_of(mesh);
      EXPECT_GE(quality.alpha_mean, 0.93);
      EXPECT_GE(quality.alpha_min, 0.55);
      const sizing::SizeField field = size_field_of(input).value();
      double sum = 0.0;
      const auto edges = all_edges(mesh);
      for (const Edge& edge : edges) {
        const Point a = mesh.point(edge[0]);
        const Point b = mesh.point(edge[1]);
        sum += std::log(geom::distance(a, b) / field.size_at(geom::midpoint(a, b)));
      }
      EXPECT_NEAR(sum / static_cast<double>(edges.size()), 0.0, 0.12) << "edges as long as the field asks";
    }
  }
}

/// `corners` cut into pieces no longer than `size`; a closed loop or an open line.
std::vector<Point> pieces(const std::vector<Point>& corners, delaunay::Closure closure, double size) {
  std::vector<Point> points;
  for (std::size_t i = 0; i + (closure == delaunay::Closure::Open ? 1 : 0) < corners.size(); ++i) {
    const Point a = corners[i];
    const Point b = corners[(i + 1) % corners.size()];
    const int count = static_cast<int>(std::ceil(geom::distance(a, b) / size - 1e-9));
    for (int k = 0; k < count; ++k) points.push_back(geom::interpolate(a, b, static_cast<double>(k) / count));
  }
  if (closure == delaunay::Closure::Open) points.push_back(corners.back());
  return points;
}

std::vector<Point> circle(Point centre, double radius, double size, double degrees) {
  const int count = static_cast<int>(std::ceil(std::max(360.0 / degrees, 2.0 * std::numbers::pi * radius / size)));
  std::vector<Point> points;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / count;
    points.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
  }
  return points;
}

TEST(Triangulate, SUR_f_PlanarExamplesOfDocument001AreBeatenInAllThreeFigures) {
  struct Example {
    const char* name;
    double size;                ///< Greatest side, L.
    double degrees;             ///< Greatest turn, A.
    double mean, share, least;  ///< Alpha of table 2.
  };
  for (const Example& example :
       {Example{"8a", 0.5, 15, 0.944, 0.842, 0.433}, Example{"8b", 0.25, 15, 0.974, 0.956, 0.558},
        Example{"8c", 0.25, 10, 0.963, 0.921, 0.229}}) {
    const bool five = example.name[1] == 'b';
    delaunay::MeshInput input;
    add_chain(input, pieces({{0, 0}, {10, 0}, {10, 10}, {0, 10}}, delaunay::Closure::Closed, example.size),
              delaunay::Closure::Closed, {"outline", delaunay::EdgeKind::Boundary});
    add_chain(input, circle({5, 5}, five ? 1.0 : 2.0, example.size, example.degrees), delaunay::Closure::Closed,
              {"hole", delaunay::EdgeKind::Boundary});
    if (five) {
      for (const Point centre : {Point{2, 2}, Point{8, 2}, Point{8, 8}, Point{2, 8}}) {
        add_chain(input, circle(centre, 1.0, example.size, example.degrees), delaunay::Closure::Closed,
                  {"hole", delaunay::EdgeKind::Boundary});
      }
    }
    if (example.name[1] == 'c') {
      add_chain(input, pieces({{1, 1}, {2, 8}, {9, 9}}, delaunay::Closure::Open, example.size), delaunay::Closure::Open,
                {"line", delaunay::EdgeKind::Constraint});
    }
    for (const Engine engine : {Engine::Front, Engine::Delaunay}) {
      SCOPED_TRACE(example.name);
      MeshOptions options;
      options.engine = engine;
      options.sizes.max_size = example.size;
      const TriangleMesh mesh = triangulate(input, options).value();
      EXPECT_TRUE(check(mesh));
      expect_edges_as_given(input, mesh);
      const MeshQuality quality = quality_of(mesh);
      report(example.name, quality);
      EXPECT_GT(quality.alpha_mean, example.mean);
      EXPECT_GT(quality.alpha_90, example.share);
      EXPECT_GT(quality.alpha_min, example.least);
    }
  }
}

TEST(Triangulate, SteepGradationIsAsGoodAsOnePointAtATime) {
  // 1:600 along the axes, growing by a third an element.
  const delaunay::MeshInput steep = test::quarter_plate(test::graded(1.0, 5.0, 88, 1.075), 1570, 10, {});
  for (const Engine engine : {Engine::Front, Engine::Delaunay}) {
    const MeshQuality quality = quality_of(triangulate(steep, {.engine = engine}).value());
    report(engine == Engine::Front ? "steep front" : "steep delaunay", quality);
    EXPECT_GE(quality.alpha_mean, engine == Engine::Front ? 0.96 : 0.955);
    EXPECT_GE(quality.alpha_90, 0.93);
    EXPECT_GE(quality.alpha_min, 0.6);
  }
}

TEST(Triangulate, AMesherCanBeWatchedAndStoppedAtAnyStepAndEndsWithTheSameMesh) {
  const delaunay::MeshInput input = test::uniform_plate(4000);
  for (const Engine engine : {Engine::Front, Engine::Delaunay}) {
    const MeshOptions options{.engine = engine};
    Mesher mesher = Mesher::start(input, options).value();
    const double whole = test::boundary_area(constrained_delaunay(input, delaunay::Outside::Remove).value().mesh);
    std::size_t views = 0;
    std::size_t sides = 0;
    for (double before = 0.0; !mesher.done(); ++views) {
      const Mesher::View view = mesher.view();
      const double covered = area(view.triangles);
      EXPECT_LE(covered, whole * (1.0 + 1e-12));
      if (engine == Engine::Delaunay) {
        EXPECT_NEAR(covered, whole, 1e-9 * whole);
      }
      EXPECT_GE(covered, before);
      sides += view.front.size();
      before = engine == Engine::Front ? covered : 0.0;
      ASSERT_TRUE(mesher.step(100));
    }
    EXPECT_GT(views, 20U);
    EXPECT_GT(sides, 50 * views);
    EXPECT_TRUE(mesher.view().front.empty());
    EXPECT_NEAR(area(mesher.view().triangles), whole, 1e-9 * whole);
    EXPECT_EQ(mesher.mesh(), triangulate(input, options).value());
  }
}

TEST(Triangulate, ErrorsAreNamedAndPlaced) {
  delaunay::MeshInput bow_tie;
  add_chain(bow_tie, {{0, 0}, {2, 2}, {2, 0}, {0, 2}}, delaunay::Closure::Closed,
            {"outer", delaunay::EdgeKind::Boundary});
  const auto crossing = triangulate(bow_tie);
  ASSERT_FALSE(crossing);
  EXPECT_EQ(crossing.error().code, ErrorCode::SelfIntersection);
  EXPECT_EQ(crossing.error().place->x, 1.0);
  EXPECT_EQ(crossing.error().place->item, "edge set 'outer'");

  MeshOptions few;
  few.points.max_triangles = 100;
  EXPECT_EQ(triangulate(test::square(1.0, 40), few).error().code, ErrorCode::TooManyElements);
  MeshOptions wrong;
  wrong.smoothing.phi = 1.5;
  EXPECT_EQ(triangulate(test::square(1.0, 4), wrong).error().code, ErrorCode::InvalidOption);
  EXPECT_EQ(triangulate({}).error().code, ErrorCode::CannotMesh);
  base::CancelToken token;
  token.cancel();
  EXPECT_EQ(triangulate(test::square(1.0, 4), {}, base::Progress(token, nullptr)).error().code, ErrorCode::Cancelled);
}

/// A mesh that passes every check (true), or an error with a message; anything else is a failure.
bool expect_mesh_or_error(const delaunay::MeshInput& input) {
  MeshOptions options;
  options.points.max_triangles = 12'000;
  const auto result = triangulate(input, options);
  if (!result) {
    EXPECT_FALSE(result.error().message.empty());
    return false;
  }
  const auto valid = check(*result);
  EXPECT_TRUE(valid) << to_string(valid.error());
  const double wanted = test::boundary_area(*result);
  EXPECT_NEAR(area(*result), wanted, 1e-10 * wanted);
  return true;
}

TEST(Triangulate, HardDomainsGiveAMeshOrANamedError) {
  // Corner of 0.1 degree.
  const double slope = std::tan(0.1 * std::numbers::pi / 180.0);
  delaunay::MeshInput wedge;
  add_chain(wedge, {{0, 0}, {1, 0}, {2, 0}, {2, 2 * slope}, {1, slope}}, delaunay::Closure::Closed,
            {"wedge", delaunay::EdgeKind::Boundary});
  EXPECT_TRUE(expect_mesh_or_error(wedge));
  // Two plates joined by a neck of 1e-9.
  delaunay::MeshInput neck;
  add_chain(neck,
            {{0, 0},
             {1, 0},
             {1, 0.5},
             {2, 0.5},
             {2, 0},
             {3, 0},
             {3, 1},
             {2, 1},
             {2, 0.5 + 1e-9},
             {1, 0.5 + 1e-9},
             {1, 1},
             {0, 1}},
            delaunay::Closure::Closed, {"neck", delaunay::EdgeKind::Boundary});
  EXPECT_TRUE(expect_mesh_or_error(neck));
  // Two nodes of the boundary 1e-12 apart.
  delaunay::MeshInput near;
  add_chain(near, {{0, 0}, {0.5, 0}, {0.5 + 1e-12, 0}, {1, 0}, {1, 1}, {0, 1}}, delaunay::Closure::Closed,
            {"near", delaunay::EdgeKind::Boundary});
  EXPECT_TRUE(expect_mesh_or_error(near));
}

TEST(Triangulate, SixtyRandomDomainsGiveAMeshOrANamedError) {
  std::size_t meshed = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    // A star-shaped outline with spikes, near-duplicate points and a few random inner chains and points.
    std::vector<Point> loop;
    const int count = 5 + static_cast<int>(random() % 40);
    for (int i = 0; i < count; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / count;
      const double radius = unit(random) < 0.1 ? 1e-3 + 0.1 * unit(random) : 0.3 + unit(random);
      loop.push_back({radius * std::cos(angle), radius * std::sin(angle)});
      if (unit(random) < 0.1) loop.push_back({loop.back().x + 1e-10 * unit(random), loop.back().y});
    }
    delaunay::MeshInput input;
    add_chain(input, loop, delaunay::Closure::Closed, {"outline", delaunay::EdgeKind::Boundary});
    for (int k = 0; k < static_cast<int>(random() % 4); ++k) {
      const Point a{0.2 * unit(random), 0.2 * unit(random)};
      add_chain(input, {a, {a.x + 0.05 * unit(random), a.y + 1e-6 * unit(random)}}, delaunay::Closure::Open,
                {"inner", delaunay::EdgeKind::Constraint});
    }
    meshed += expect_mesh_or_error(input) ? 1U : 0U;
  }
  EXPECT_GT(meshed, 15U);
}

}  // namespace
}  // namespace dobra::mesh::front
