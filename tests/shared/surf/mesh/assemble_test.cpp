#include "shared/surf/mesh/assemble.h"

#include <algorithm>
#include <map>

#include "tests/shared/surf/mesh/faces.h"

namespace dobra::surf::mesh {
namespace {

using geom::Point;
using geom::Point3;
using test::divided;
using test::flat;
using test::meshed;
using test::pi;
using test::polygon;
using test::straight;
using trim::ChartLine;
using trim::TrimmedSurface;

DivisionOptions of_size(double largest) {
  DivisionOptions options;
  options.sizes.largest = largest;
  return options;
}

SurfaceMesh mesh_of(std::span<const TrimmedSurface> surfaces, double largest, int inside) {
  Division division = divided(surfaces, of_size(largest));
  auto mesh = meshed(surfaces, division, inside);
  if (!mesh) {
    ADD_FAILURE() << base::to_string(mesh.error());
    return {};
  }
  EXPECT_TRUE(check(*mesh).ok());
  return *std::move(mesh);
}

/// Two triangles of a unit square.
SurfaceMesh square() {
  SurfaceMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    mesh.triangles.push_back({NodeId(a), NodeId(b), NodeId(c)});
    mesh.places.push_back({});
    mesh.faces.push_back(0);
    mesh.regions.push_back(0);
  };
  add(0, 1, 2);
  add(0, 2, 3);
  return mesh;
}

// ---- what is wrong

TEST(Assemble, CheckFindsATriangleThatIsTurned) {
  SurfaceMesh mesh = square();
  ASSERT_TRUE(check(mesh).ok());
  std::swap(mesh.triangles[1][0], mesh.triangles[1][1]);
  const auto result = check(mesh);
  ASSERT_FALSE(result.ok());
  EXPECT_NE(result.error().message.find("turned against"), std::string::npos);
  EXPECT_TRUE(result.error().place->z.has_value());
}

TEST(Assemble, CheckFindsThreeTrianglesOnASide) {
  SurfaceMesh mesh = square();
  mesh.points.push_back({0.5, 0.5, 1});
  mesh.triangles.push_back({NodeId(2), NodeId(0), NodeId(4)});
  mesh.places.push_back({});
  mesh.faces.push_back(0);
  mesh.regions.push_back(0);
  const auto result = check(mesh);
  ASSERT_FALSE(result.ok());
  EXPECT_NE(result.error().message.find("three triangles"), std::string::npos);
}

TEST(Assemble, CheckFindsTrianglesThatAreThereTwice) {
  // A square and its back, of another face: every side has two triangles, which run along it in opposite ways.
  SurfaceMesh mesh = square();
  for (const Corners& c : std::vector(mesh.triangles)) {
    mesh.triangles.push_back({c[0], c[2], c[1]});
    mesh.places.push_back({});
    mesh.faces.push_back(1);
    mesh.regions.push_back(0);
  }
  for (const std::size_t kept : {4U, 2U}) {
    SurfaceMesh bag = mesh;
    if (kept == 2U) {
      bag.triangles = {mesh.triangles[0], mesh.triangles[2]};
      bag.places.resize(2), bag.regions.resize(2), bag.faces = {0, 1};
    }
    const auto result = check(bag);
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, base::ErrorCode::CannotMesh);
    EXPECT_NE(result.error().message.find("same three nodes"), std::string::npos) << result.error().message;
    EXPECT_TRUE(result.error().place->z.has_value());
  }
}

TEST(Assemble, CheckFindsWhatHasNoAreaIsNotFiniteOrDoesNotExist) {
  SurfaceMesh flat_one = square();
  flat_one.points[3] = {0.5, 0.5, 0};
  EXPECT_FALSE(check(flat_one).ok());
  SurfaceMesh infinite = square();
  infinite.points[1].z = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(check(infinite).error().code, base::ErrorCode::NotFinite);
  SurfaceMesh wild = square();
  wild.triangles[0][1] = NodeId(17);
  EXPECT_FALSE(check(wild).ok());
  SurfaceMesh short_array = square();
  short_array.regions.pop_back();
  EXPECT_FALSE(check(short_array).ok());
  SurfaceMesh set_of_nothing = square();
  set_of_nothing.boundary_sets["rim"] = {{NodeId(1), NodeId(3)}};
  EXPECT_FALSE(check(set_of_nothing).ok());
}

TEST(Assemble, RefusesAMeshThatIsNotOfItsInput) {
  const TrimmedSurface face{.surface = flat(2, 1)};
  const Division division = divided({&face, 1}, of_size(1));
  FaceMesh made = test::delaunay_face(division.faces[0]);
  made.chart.points[0].x += 0.1;
  const auto result = assemble({&face, 1}, division, {&made, 1});
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, base::ErrorCode::CannotMesh);
}

// ---- topology and areas

TEST(Assemble, APlateHasItsAreaAndItsSets) {
  TrimmedSurface face{.surface = flat(10, 5), .loops = {polygon({{0, 0}, {10, 0}, {10, 5}, {0, 5}})}};
  face.loops[0].edges[1].name = "right";
  face.name = "plate";
  const SurfaceMesh mesh = mesh_of({&face, 1}, 1, 5);
  const SurfaceQuality quality = quality_of(mesh);
  EXPECT_NEAR(quality.area, 50.0, 1e-12);
  EXPECT_EQ(quality.euler, 1);
  EXPECT_EQ(quality.boundary_edges, 30u);
  EXPECT_EQ(mesh.boundary_sets.at("right").size(), 5u);
  EXPECT_EQ(mesh.boundary_sets.size(), 1u);
  EXPECT_EQ(mesh.region_names.at(mesh.regions[0]), "plate");
  EXPECT_LE(quality.gauss_bonnet, 1e-9);
  EXPECT_NEAR(quality.deficit, 0.0, 1e-9);
}

TEST(Assemble, ATubeIsClosedAtItsSeam) {
  const TrimmedSurface face{.surface = *Surface::cylinder({}, 1.0, {{0, 0}, {2 * pi, 2.0}})};
  const SurfaceMesh mesh = mesh_of({&face, 1}, 0.3, 12);
  const SurfaceQuality quality = quality_of(mesh);
  EXPECT_EQ(quality.euler, 0);
  EXPECT_EQ(quality.loops, 2u);
  EXPECT_EQ(quality.components, 1u);
  EXPECT_LE(quality.gauss_bonnet, 1e-9);
  EXPECT_NEAR(quality.area, 4 * pi, 0.1 * 4 * pi);
  EXPECT_EQ(mesh.constraint_sets.at("left").size() + mesh.constraint_sets.at("right").size(),
            2 * mesh.constraint_sets.at("left").size());
}

TEST(Assemble, ATorusHasNoBorderAndASphereTwoPoles) {
  const TrimmedSurface torus{.surface = *Surface::torus({}, 3.0, 1.0, {{0, 0}, {2 * pi, 2 * pi}})};
  const SurfaceQuality ring = quality_of(mesh_of({&torus, 1}, 1.0, 20));
  EXPECT_EQ(ring.boundary_edges, 0u);
  EXPECT_EQ(ring.euler, 0);
  EXPECT_NEAR(ring.deficit, 0.0, 1e-9);

  const TrimmedSurface sphere{.surface = *Surface::sphere({}, 1.0, {{-pi, -0.5 * pi}, {pi, 0.5 * pi}})};
  const SurfaceQuality ball = quality_of(mesh_of({&sphere, 1}, 0.3, 16));
  EXPECT_EQ(ball.boundary_edges, 0u);
  EXPECT_EQ(ball.euler, 2);
  EXPECT_NEAR(ball.deficit, 4 * pi, 1e-9);
  EXPECT_LE(ball.gauss_bonnet, 1e-9);
}

TEST(Assemble, FacesAreOneMeshAlongTheCurvesThatTheyShare) {
  // A box without a lid out of five faces would do; three that meet in a corner have one node there.
  const auto square_face = [](Frame frame) {
    return TrimmedSurface{.surface = *Surface::plane(frame, {{0, 0}, {1, 1}}),
                          .loops = {polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}})}};
  };
  std::vector<TrimmedSurface> faces{square_face({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}),
                                    square_face({{0, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}}),
                                    square_face({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}})};
  // Bottom of one (along its first axis) is the left side of the one before, which runs towards the corner.
  for (std::size_t i = 0; i < 3; ++i) {
    faces[i].loops[0].edges[0].shared = static_cast<trim::SharedCurveId>(i);
    faces[(i + 2) % 3].loops[0].edges[3].shared = static_cast<trim::SharedCurveId>(i);
    faces[(i + 2) % 3].loops[0].edges[3].against = true;
    faces[i].loops[0].edges[0].name = faces[(i + 2) % 3].loops[0].edges[3].name = "axis_" + std::to_string(i);
  }
  const SurfaceMesh mesh = mesh_of(faces, 0.25, 3);
  const SurfaceQuality quality = quality_of(mesh);
  EXPECT_NEAR(quality.area, 3.0, 1e-12);
  EXPECT_EQ(quality.euler, 1);
  EXPECT_EQ(quality.boundary_edges, 24u);
  EXPECT_NEAR(quality.deficit, 0.5 * pi, 1e-9);  // the corner of a cube
  EXPECT_EQ(mesh.constraint_sets.at("axis_1").size(), 4u);
  EXPECT_FALSE(mesh.boundary_sets.contains("axis_1"));
  EXPECT_TRUE(to_openmesh(mesh).ok());
  EXPECT_EQ(dobra::mesh::check(to_polygon_mesh(mesh), dobra::mesh::Closedness::Sheet).size(), 0u);
}

TEST(Assemble, AReversedFaceTurnsItsTrianglesAndItsBorder) {
  TrimmedSurface face{.surface = flat(2, 1), .loops = {polygon({{0, 0}, {2, 0}, {2, 1}, {0, 1}}, "rim")}};
  face.reversed = true;
  const SurfaceMesh mesh = mesh_of({&face, 1}, 0.5, 2);
  for (const Corners& c : mesh.triangles) {
    EXPECT_LT(cross(mesh.point(c[1]) - mesh.point(c[0]), mesh.point(c[2]) - mesh.point(c[0])).z, 0.0);
  }
  std::map<Edge, int> sides;
  for (const Corners& c : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) ++sides[{c[i], c[(i + 1) % 3]}];
  }
  for (const Edge& edge : mesh.boundary_sets.at("rim")) EXPECT_TRUE(sides.contains(edge));
}

TEST(Assemble, ACrackIsOpenedIntoTwoLipsThatShareItsTips) {
  TrimmedSurface face{.surface = *Surface::cylinder({}, 5.0, {{0, 0}, {1.5, 10}})};
  face.lines.push_back({{straight({0.4, 3}, {1.1, 7}, "c")}, ChartLine::Kind::Crack});
  const SurfaceMesh closed = mesh_of(std::vector{TrimmedSurface{.surface = face.surface}}, 1, 8);
  const SurfaceMesh mesh = mesh_of({&face, 1}, 1, 8);
  ASSERT_TRUE(mesh.boundary_sets.contains("c_left"));
  const auto& left = mesh.boundary_sets.at("c_left");
  const auto& right = mesh.boundary_sets.at("c_right");
  EXPECT_EQ(left.size(), 6u);  // (0.7 * 5)^2 + 4^2 = 5.3^2
  ASSERT_EQ(left.size(), right.size());
  std::size_t common = 0;
  for (std::size_t i = 0; i < left.size(); ++i) {
    EXPECT_EQ(mesh.point(left[i][0]), mesh.point(right[i][1]));
    common += left[i][0] == right[i][1] ? 1 : 0;
    common += left[i][1] == right[i][0] ? 1 : 0;
  }
  EXPECT_EQ(common, 2u);
  EXPECT_EQ(mesh.node_sets.at("c_start").size(), 1u);
  EXPECT_EQ(mesh.node_sets.at("c_end").size(), 1u);
  const SurfaceQuality quality = quality_of(mesh);
  EXPECT_EQ(quality.euler, 0);
  EXPECT_EQ(quality.loops, 2u);
  EXPECT_EQ(quality_of(closed).euler, 1);
  EXPECT_LE(quality.gauss_bonnet, 1e-9);
}

TEST(Assemble, RegionsAndInterfacesAreKept) {
  TrimmedSurface face{.surface = flat(10, 5), .loops = {polygon({{0, 0}, {10, 0}, {10, 5}, {0, 5}})}};
  face.lines.push_back({{straight({4, 0}, {4, 5}, "fault")}, ChartLine::Kind::Interface});
  face.regions = {{{1, 1}, 3, "sand"}, {{9, 1}, 7, "clay"}};
  const SurfaceMesh mesh = mesh_of({&face, 1}, 1, 6);
  std::map<std::int32_t, double> areas;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Corners& c = mesh.triangles[t];
    areas[mesh.regions[t]] +=
        0.5 * geom::length(cross(mesh.point(c[1]) - mesh.point(c[0]), mesh.point(c[2]) - mesh.point(c[0])));
  }
  EXPECT_NEAR(areas.at(3), 20.0, 1e-12);
  EXPECT_NEAR(areas.at(7), 30.0, 1e-12);
  EXPECT_EQ(mesh.region_names.at(7), "clay");
  EXPECT_EQ(mesh.constraint_sets.at("fault").size(), 5u);
}

TEST(SurfaceQuality, KnowsTheShapesOfKnownTriangles) {
  SurfaceMesh mesh = square();
  mesh.points[3] = {0.5 - 0.5 * std::sqrt(3.0), 0.5 + 0.5 * std::sqrt(3.0), 0};  // equilateral on the diagonal
  const SurfaceQuality quality = quality_of(mesh);
  EXPECT_NEAR(quality.alpha_min, 0.5 * std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(quality.alpha_mean, 0.5 * (1.0 + 0.5 * std::sqrt(3.0)), 1e-12);
  EXPECT_DOUBLE_EQ(quality.alpha_90, 0.5);
  EXPECT_EQ(quality.worst, TriangleId(0));
  EXPECT_NEAR(quality.angle_min.degrees(), 45.0, 1e-9);
  EXPECT_NEAR(quality.angle_max.degrees(), 90.0, 1e-9);
  EXPECT_NEAR(quality.side_max, std::sqrt(2.0), 1e-12);
}

}  // namespace
}  // namespace dobra::surf::mesh
