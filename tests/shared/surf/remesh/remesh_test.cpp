#include "shared/surf/remesh/remesh.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <map>
#include <set>

#include "tests/support/sheets.h"

namespace dobra::surf::remesh {
namespace {

using geom::Point3;
using test::grid_mesh;
using test::PolygonMesh;

constexpr double pi = std::numbers::pi;

struct Case {
  std::string name;
  PolygonMesh mesh;
  double size = 0.0, chord = 0.0;
};

std::vector<Case> ten() {
  std::mt19937_64 random(4);
  const auto noise = [&random] { return static_cast<double>(random() >> 11) * 0x1p-53 - 0.5; };
  std::vector<Case> cases;
  cases.push_back({"bumps",
                   test::shaken_grid(40, 40, 0.5, 1,
                                     [](double u, double v) {
                                       return Point3{u, v, 0.08 * std::sin(7 * u) * std::cos(6 * v)};
                                     }),
                   0.05, 0.004});
  cases.push_back({"saddle",
                   test::shaken_grid(30, 30, 0.6, 2,
                                     [](double u, double v) {
                                       const double x = 2 * u - 1, y = 2 * v - 1;
                                       return Point3{x, y, 0.6 * (x * x - y * y)};
                                     }),
                   0.12, 0.008});
  cases.push_back({"half sphere", test::half_sphere(20), 0.12, 0.006});
  cases.push_back({"folded",
                   grid_mesh(40, 20,
                             [](double u, double v) {
                               const double x = 4 * u, k = std::floor(x), part = x - k;
                               return Point3{x, 2 * v, static_cast<int>(k) % 2 == 0 ? part : 1 - part};
                             }),
                   0.2, 0.01});
  cases.push_back({"L",
                   grid_mesh(
                       30, 30,
                       [](double u, double v) {
                         return Point3{2 * u, 2 * v, 0.2 * std::sin(3 * u + v)};
                       },
                       [](std::uint32_t i, std::uint32_t j) { return i >= 12 && j >= 14; }),
                   0.1, 0.006});
  cases.push_back({"strip",
                   test::shaken_grid(120, 6, 0.5, 3,
                                     [](double u, double v) {
                                       return Point3{20 * u, v, std::sin(12 * u)};
                                     }),
                   0.2, 0.01});
  cases.push_back({"scan",
                   test::shaken_grid(60, 60, 0.8, 5,
                                     [&](double u, double v) {
                                       return Point3{u, v, 0.1 * std::sin(5 * u * v) + 0.001 * noise()};
                                     }),
                   0.05, 0.004});
  cases.push_back({"holes",
                   grid_mesh(
                       30, 30,
                       [](double u, double v) {
                         return Point3{3 * u, 3 * v, 0.3 * std::cos(2 * u + 2 * v)};
                       },
                       [](std::uint32_t i, std::uint32_t j) {
                         return (i >= 6 && i < 10 && j >= 8 && j < 13) || (i >= 18 && i < 24 && j >= 16 && j < 20);
                       }),
                   0.15, 0.008});
  cases.push_back({"tube",
                   test::tube(30, 20, false,
                              [](double u, double v) {
                                const double r = 1 + 0.2 * std::sin(4 * v);
                                return Point3{r * std::cos(2 * pi * u), r * std::sin(2 * pi * u), 3 * v};
                              }),
                   0.25, 0.02});
  cases.push_back({"roll",
                   test::shaken_grid(60, 15, 0.5, 6,
                                     [](double u, double v) {
                                       const double a = 1.6 * pi * u;
                                       return Point3{std::cos(a), std::sin(a), 1.5 * v};
                                     }),
                   0.15, 0.008});
  return cases;
}

bool told(const Remeshed& made, const std::string& code) {
  return std::ranges::any_of(made.findings, [&](const auto& f) { return f.code == code; });
}

TEST(Remesh, TenMeshesKeepTheirShapeWithoutAFlipAndWithGoodTriangles) {
  for (const Case& each : ten()) {
    SCOPED_TRACE(each.name);
    const auto made = remesh(each.mesh, {.size = each.size, .chord = each.chord});
    ASSERT_TRUE(made.ok()) << made.error().message;
    std::printf("%-12s %6zu triangles  mean %.4f  least %.3f  deviation %.5f of %.5f  rounds %d  creases %zu\n",
                each.name.c_str(), made->quality.triangles, made->quality.alpha_mean, made->quality.alpha_min,
                made->deviation, each.chord, made->rounds, made->creases);
    EXPECT_EQ(made->flipped, 0U);
    EXPECT_LE(made->deviation, each.chord);
    EXPECT_GE(made->quality.alpha_mean, 0.97);
    EXPECT_GT(made->quality.alpha_min, 0.3);
    EXPECT_EQ(told(*made, "cut"), each.name == "holes" || each.name == "tube");
    EXPECT_FALSE(told(*made, "deviation_above"));
    // What it is stays: pieces, borders, Euler's number, and about its area.
    const auto before = param::sheet_of(each.mesh)->sheet;
    EXPECT_EQ(made->quality.euler, before.euler());
    EXPECT_EQ(made->quality.loops, before.loops.size());
    EXPECT_LT(made->quality.gauss_bonnet, 1e-9);
    double area = 0.0;
    for (const auto& [a, b, c] : before.triangles)
      area += 0.5 * geom::length(cross(before.points[b] - before.points[a], before.points[c] - before.points[a]));
    EXPECT_NEAR(made->quality.area, area, 0.02 * area);
  }
}

TEST(Remesh, AChordThatTheSizeDoesNotKeepMakesSidesSmallerWhereItMust) {
  // Flat but for one bump.
  const PolygonMesh bump = test::shaken_grid(60, 60, 0.5, 7, [](double u, double v) {
    const double r2 = (u - 0.3) * (u - 0.3) + (v - 0.3) * (v - 0.3);
    return Point3{u, v, 0.1 * std::exp(-r2 / 0.01)};
  });
  const auto coarse = remesh(bump, {.size = 0.1}), fine = remesh(bump, {.size = 0.1, .chord = 0.004});
  ASSERT_TRUE(coarse.ok() && fine.ok());
  EXPECT_GT(coarse->deviation, 0.008);
  EXPECT_EQ(coarse->rounds, 1);
  EXPECT_LE(fine->deviation, 0.004);
  EXPECT_GT(fine->rounds, 1);
  EXPECT_GT(fine->quality.triangles, coarse->quality.triangles);
  EXPECT_LT(fine->quality.triangles, 10 * coarse->quality.triangles);
  EXPECT_GE(fine->quality.alpha_mean, 0.95);
}

TEST(Remesh, AChordBelowTheRoughnessOfTheMeshIsToldWithThePlace) {
  const auto scan = ten()[6];
  const auto made = remesh(scan.mesh, {.size = 0.2, .chord = 1e-7, .rounds = 1});
  ASSERT_TRUE(made.ok());
  EXPECT_TRUE(told(*made, "deviation_above"));
  EXPECT_GT(made->deviation, 1e-7);
  EXPECT_TRUE(made->findings.back().place.x.has_value());
}

TEST(Remesh, AFoldStaysALineAndWithoutItTheMeshCutsItsEdge) {
  const auto folded = ten()[3];
  const auto kept = remesh(folded.mesh, {.size = 0.15});
  const auto lost = remesh(folded.mesh, {.size = 0.15, .crease = 180.0});
  ASSERT_TRUE(kept.ok() && lost.ok());
  EXPECT_EQ(kept->creases, 3U);
  EXPECT_LT(kept->deviation, 1e-12);
  EXPECT_GT(lost->deviation, 0.01);
}

/// Outward, two triangles a side; diagonals of opposite sides cross.
PolygonMesh cube(double side) {
  PolygonMesh mesh{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
                   {{0, 2, 1},
                    {0, 3, 2},
                    {4, 5, 6},
                    {4, 6, 7},
                    {0, 1, 5},
                    {0, 5, 4},
                    {1, 2, 6},
                    {1, 6, 5},
                    {2, 3, 7},
                    {2, 7, 6},
                    {3, 0, 4},
                    {3, 4, 7}}};
  for (Point3& p : mesh.points) p = Point3{} + side * (p - Point3{});
  return mesh;
}

/// How much of the twelve edges of such a cube the sides of a mesh cover.
double length_on_edges(const Remeshed& made, double side) {
  const auto on_edge = [&](Point3 p, Point3 q) {
    int same = 0;
    for (const auto& [a, b] : {std::pair{p.x, q.x}, std::pair{p.y, q.y}, std::pair{p.z, q.z}})
      same += a == b && (a == 0.0 || a == side) ? 1 : 0;
    return same == 2;
  };
  double sum = 0.0;
  for (const auto& corners : made.mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Point3 p = made.mesh.point(corners[i]), q = made.mesh.point(corners[(i + 1) % 3]);
      if (on_edge(p, q)) sum += 0.5 * geom::distance(p, q);  // Of two triangles.
    }
  }
  return sum;
}

TEST(Remesh, ACubeKeepsItsTwelveEdgesWhateverSizeDividesThem) {
  for (const double size : {0.4, 0.7, 0.8, 1.0}) {
    const auto made = remesh(cube(2.0), {.size = size});
    ASSERT_TRUE(made.ok()) << made.error().message;
    EXPECT_EQ(made->creases, 12U) << size;
    EXPECT_NEAR(length_on_edges(*made, 2.0), 24.0, 1e-9) << size;
    EXPECT_NEAR(made->quality.area, 24.0, 1e-9) << size;
    EXPECT_EQ(made->quality.euler, 2) << size;
    EXPECT_GT(made->quality.alpha_min, 0.6) << size;
    EXPECT_LT(made->deviation, 1e-12) << size;
    EXPECT_FALSE(told(*made, "area_off")) << size;
  }
}

TEST(Remesh, ACubeWithASmallBoxOnItKeepsTheEdgesOfBoth) {
  // The box stands on the middle of the ceiling: its corners alone are no good ends of a cut.
  PolygonMesh mesh = cube(2.0);
  mesh.faces.erase(mesh.faces.begin() + 2, mesh.faces.begin() + 4);
  for (const double z : {2.0, 2.3}) {
    for (const auto& [x, y] : {std::pair{0.8, 0.8}, std::pair{1.2, 0.8}, std::pair{1.2, 1.2}, std::pair{0.8, 1.2}})
      mesh.points.push_back({x, y, z});
  }
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t k = (i + 1) % 4;
    mesh.faces.push_back({4 + i, 4 + k, 8 + k, 8 + i});
    mesh.faces.push_back({8 + i, 8 + k, 12 + k, 12 + i});
  }
  mesh.faces.push_back({12, 13, 14, 15});
  const auto made = remesh(mesh, {.size = 0.2});
  ASSERT_TRUE(made.ok()) << made.error().message;
  EXPECT_EQ(made->creases, 24U);
  EXPECT_NEAR(made->quality.area, 24.0 + 4 * 0.4 * 0.3, 1e-9);
  EXPECT_LT(made->deviation, 1e-12);
  EXPECT_GT(made->quality.alpha_min, 0.4);
}

TEST(Remesh, AnAreaThatIsAHundredthOffIsToldAndASmallerOneIsNot) {
  const PolygonMesh ring = test::torus_mesh(60, 30);
  const auto coarse = remesh(ring, {.size = 0.5});
  ASSERT_TRUE(coarse.ok()) << coarse.error().message;
  EXPECT_LT(coarse->quality.area, 0.99 * coarse->area_before);
  EXPECT_TRUE(told(*coarse, "area_off"));
  const auto fine = remesh(ring, {.size = 0.15});
  ASSERT_TRUE(fine.ok()) << fine.error().message;
  EXPECT_GT(fine->quality.area, 0.99 * fine->area_before);
  EXPECT_FALSE(told(*fine, "area_off"));
}

TEST(Remesh, ASizeTooLargeForTheMeshIsRefusedWithOneThatMayDo) {
  const PolygonMesh tetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
  for (const double size : {3.0, 100.0}) {
    const auto made = remesh(tetrahedron, {.size = size});
    ASSERT_FALSE(made.ok());
    EXPECT_EQ(made.error().code, base::ErrorCode::InvalidOption) << size;
    EXPECT_NE(made.error().message.find("is too large for this mesh"), std::string::npos) << made.error().message;
  }
  EXPECT_TRUE(remesh(tetrahedron, {.size = 0.5}).ok());
}

TEST(Remesh, ANeedleTooSharpForTheSizeIsRefusedAtItsTip) {
  const auto needle = [](double height) {
    return grid_mesh(20, 20, [height](double u, double v) {
      return Point3{u, v, u == 0.5 && v == 0.5 ? height : 0.0};
    });
  };
  const auto blunt = remesh(needle(0.2), {.size = 0.05});
  ASSERT_TRUE(blunt.ok()) << blunt.error().message;
  EXPECT_EQ(blunt->flipped, 0U);
  if (std::getenv("DOBRA_LONG_REMESH") == nullptr) return;  // Half a minute with sanitizers.
  const auto sharp = remesh(needle(3.0), {.size = 0.05});
  ASSERT_FALSE(sharp.ok());
  EXPECT_EQ(sharp.error().code, base::ErrorCode::CannotMesh);
  ASSERT_TRUE(sharp.error().place && sharp.error().place->z) << sharp.error().message;
  EXPECT_NEAR(*sharp.error().place->x, 0.5, 0.1);
  EXPECT_NEAR(*sharp.error().place->y, 0.5, 0.1);
}

TEST(Remesh, FacesOfMoreCornersAreCutWithoutFlatTriangles) {
  // A square with a corner in the middle of a side, and one with a notch: a fan from their first corners would fail.
  const PolygonMesh extra{{{1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 0}}, {{0, 1, 2, 3, 4}}};
  const PolygonMesh notched{{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 0.5, 0}, {0, 2, 0}}, {{0, 1, 2, 3, 4}}};
  for (const auto& [mesh, area] : {std::pair{extra, 4.0}, std::pair{notched, 2.5}}) {
    const auto made = remesh(mesh, {.size = 0.3});
    ASSERT_TRUE(made.ok()) << made.error().message;
    EXPECT_NEAR(made->quality.area, area, 1e-9);
    EXPECT_FALSE(told(*made, "mended"));
  }
}

TEST(Remesh, ClosedMeshesAreCutAndStayClosed) {
  const PolygonMesh torus = test::torus_mesh(60, 30);
  const auto made = remesh(torus, {.size = 0.25});
  ASSERT_TRUE(made.ok()) << made.error().message;
  EXPECT_TRUE(told(*made, "cut"));
  EXPECT_EQ(made->flipped, 0U);
  EXPECT_EQ(made->quality.euler, 0);
  EXPECT_EQ(made->quality.boundary_edges, 0U);
  EXPECT_GE(made->quality.alpha_mean, 0.95);
  const auto ball = remesh(test::sphere_mesh(16), {.size = 0.15});
  ASSERT_TRUE(ball.ok()) << ball.error().message;
  EXPECT_EQ(ball->quality.euler, 2);
  EXPECT_EQ(ball->quality.boundary_edges, 0U);
  EXPECT_EQ(ball->flipped, 0U);
}

/// Closed, without a fold, and near the mesh given; what a user would call done.
void expect_whole(const Remeshed& made, std::int64_t euler, double area) {
  EXPECT_EQ(made.quality.euler, euler);
  EXPECT_EQ(made.quality.boundary_edges, 0U);
  EXPECT_EQ(made.flipped, 0U);
  EXPECT_FALSE(told(made, "folded"));
  EXPECT_NEAR(made.quality.area, area, 0.01 * area);
  EXPECT_GE(made.quality.alpha_mean, 0.97);
}

double area_of(const PolygonMesh& mesh) {
  const auto sheet = param::sheet_of(mesh)->sheet;
  double area = 0.0;
  for (const auto& [a, b, c] : sheet.triangles)
    area += 0.5 * geom::length(cross(sheet.points[b] - sheet.points[a], sheet.points[c] - sheet.points[a]));
  return area;
}

TEST(Remesh, ALongClosedBodyIsMeshedInMomentsWithItsSeamUnseen) {
  for (const auto& [longer, size] : {std::pair{1.0, 0.15}, {5.0, 0.15}, {20.0, 0.3}}) {
    PolygonMesh body = test::sphere_mesh(12);
    for (Point3& p : body.points) p.z *= longer;
    const auto made = remesh(body, {.size = size});
    ASSERT_TRUE(made.ok()) << made.error().message;
    expect_whole(*made, 2, area_of(body));
    EXPECT_GT(made->quality.alpha_min, 0.5) << longer;
  }
}

/// Boxes on a lattice: cells of 0.5 that are full, as squares of two triangles between full and empty ones.
PolygonMesh lattice(const std::set<std::array<int, 3>>& full) {
  PolygonMesh mesh;
  std::map<std::array<int, 3>, std::uint32_t> number;
  const auto corner = [&](std::array<int, 3> at) {
    const auto [found, fresh] = number.try_emplace(at, static_cast<std::uint32_t>(mesh.points.size()));
    if (fresh) mesh.points.push_back({0.5 * at[0], 0.5 * at[1], 0.5 * at[2]});
    return found->second;
  };
  for (const auto& cell : full) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const int side : {0, 1}) {
        auto next = cell;
        next[static_cast<std::size_t>(axis)] += side == 0 ? -1 : 1;
        if (full.contains(next)) continue;
        const auto u = static_cast<std::size_t>((axis + 1) % 3), v = static_cast<std::size_t>((axis + 2) % 3);
        std::vector<std::uint32_t> face;
        for (const auto& [i, j] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
          auto at = cell;
          at[static_cast<std::size_t>(axis)] += side;
          at[u] += i, at[v] += j;
          face.push_back(corner(at));
        }
        if (side == 0) std::reverse(face.begin(), face.end());
        mesh.faces.push_back(face);
      }
    }
  }
  return mesh;
}

TEST(Remesh, BodiesWithHandlesAndArmsKeepAllTheirEdges) {
  // A frame of three windows, and a block with arms to all sides.
  std::set<std::array<int, 3>> frame, arms;
  for (int x = 0; x < 14; ++x) {
    for (int y = 0; y < 6; ++y) {
      if (y < 2 || y > 3 || x % 4 < 2) frame.insert({x, y, 0}), frame.insert({x, y, 1});
    }
  }
  for (int i = -12; i <= 12; ++i) arms.insert({i, 0, 0}), arms.insert({0, i, 0}), arms.insert({0, 0, i});
  for (const auto& [mesh, euler] : {std::pair{lattice(frame), -4}, std::pair{lattice(arms), 2}}) {
    const double area = area_of(mesh);
    const auto made = remesh(mesh, {.size = 0.2});
    ASSERT_TRUE(made.ok()) << made.error().message;
    expect_whole(*made, euler, area);
    EXPECT_NEAR(made->quality.area, area, 1e-9 * area);  // every edge is a line of the new mesh
    EXPECT_LT(made->deviation, 1e-12);
  }
}

TEST(Remesh, SevenBordersStayAsTheyAre) {
  PolygonMesh ball = test::sphere_mesh(20);
  const auto hole = [&](Point3 at, double radius) {
    std::erase_if(ball.faces, [&](const auto& face) {
      return std::ranges::any_of(face, [&](std::uint32_t v) { return geom::distance(ball.points[v], at) < radius; });
    });
  };
  for (const Point3 at :
       {Point3{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}, {0.58, 0.58, 0.58}})
    hole(at, 0.25);
  const auto before = param::sheet_of(ball)->sheet;
  ASSERT_EQ(before.loops.size(), 7U);
  const auto made = remesh(ball, {.size = 0.06});
  ASSERT_TRUE(made.ok()) << made.error().message;
  EXPECT_EQ(made->quality.loops, 7U);
  EXPECT_EQ(made->quality.euler, before.euler());
  EXPECT_FALSE(told(*made, "folded"));
  EXPECT_GE(made->quality.alpha_mean, 0.97);
}

TEST(Remesh, AMeshThatIsStretchedTooMuchIsPartedAndItsPartsFitTogether) {
  // Of one sphere with spikes, whatever bound on the stretch there is: more parts, the same mesh to the user.
  PolygonMesh body = test::sphere_mesh(16);
  for (Point3& p : body.points) {
    const double r = 1.0 + 1.5 * std::pow(std::abs(p.x), 12) + 1.5 * std::pow(std::abs(p.y), 12);
    p = Point3{} + r * (p - Point3{});
  }
  bool parted = false;
  for (const double most : {15.0, 3.0, 1.6}) {
    const auto made = remesh(body, {.size = 0.1, .most_stretch = most});
    ASSERT_TRUE(made.ok()) << made.error().message;
    SCOPED_TRACE(most);
    expect_whole(*made, 2, area_of(body));
    parted = parted || told(*made, "parted");
    EXPECT_LT(made->deviation, 0.05);
  }
  EXPECT_TRUE(parted);
}

TEST(Remesh, AFoldBesideAnotherMuchNearerThanASideIsLeftOutAndTold) {
  // A chamfer of 0.01 along an edge: two folds of 45 degrees.
  const auto chamfered = [](double by) {
    return grid_mesh(3, 1, [by](double u, double v) {
      const std::array<Point3, 4> at{{{-1, v, 0}, {-by, v, 0}, {0, v, -by}, {0, v, -1}}};
      return at[static_cast<std::size_t>(std::lround(3 * u))];
    });
  };
  const auto near = remesh(chamfered(0.01), {.size = 0.2});
  ASSERT_TRUE(near.ok()) << near.error().message;
  EXPECT_EQ(near->creases, 1U);
  EXPECT_EQ(near->narrow_creases, 1U);
  EXPECT_TRUE(told(*near, "crease_left_out"));
  EXPECT_LT(near->deviation, 0.01);
  const auto far = remesh(chamfered(0.2), {.size = 0.2});
  ASSERT_TRUE(far.ok()) << far.error().message;
  EXPECT_EQ(far->creases, 2U);
  EXPECT_FALSE(told(*far, "crease_left_out"));
  EXPECT_LT(far->deviation, 1e-12);
}

TEST(Remesh, PiecesAreMeshedOneByOneAndOneTooSmallStaysAsItCame) {
  PolygonMesh all = cube(2.0);
  const auto add = [&](const PolygonMesh& more, geom::Vector3 by) {
    const auto first = static_cast<std::uint32_t>(all.points.size());
    for (const Point3 p : more.points) all.points.push_back(p + by);
    for (auto face : more.faces) {
      for (std::uint32_t& v : face) v += first;
      all.faces.push_back(face);
    }
  };
  add(test::sphere_mesh(8), {5, 0, 0});
  add({{{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}, {0, 0, 0.1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}}, {0, 5, 0});
  // A second cube that shares one corner with the first: no side joins them.
  add(cube(2.0), {2, 2, 2});
  const auto made = remesh(all, {.size = 0.2});
  ASSERT_TRUE(made.ok()) << made.error().message;
  EXPECT_TRUE(told(*made, "pieces"));
  EXPECT_TRUE(told(*made, "piece_kept"));
  EXPECT_EQ(made->quality.components, 4U);
  EXPECT_EQ(made->quality.euler, 8);
  EXPECT_EQ(made->quality.boundary_edges, 0U);
  EXPECT_EQ(made->creases, 24U);
  EXPECT_NEAR(made->quality.area, 48.0 + area_of(test::sphere_mesh(8)) + 0.015 + 0.005 * std::sqrt(3.0), 0.15);
}

TEST(Remesh, MeshesThatAreNoSheetAreRefusedWithTheirPlace) {
  const PolygonMesh fan{{{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, -1, 0}, {1, 0, 1}}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}};
  const auto made = remesh(fan, {.size = 0.5});
  ASSERT_FALSE(made.ok());
  EXPECT_TRUE(made.error().place && made.error().place->z);
  const PolygonMesh plane = grid_mesh(4, 4, [](double u, double v) { return Point3{u, v, 0}; });
  for (const double bad : {-1.0, std::nan("")}) {
    EXPECT_EQ(remesh(plane, {.size = bad}).error().code, base::ErrorCode::InvalidOption);
    EXPECT_EQ(remesh(plane, {.size = 0.5, .chord = bad}).error().code, base::ErrorCode::InvalidOption);
  }
}

TEST(Remesh, ATetrahedronKeepsItsFacesAtAnySizeThatDividesThem) {
  const PolygonMesh tetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
  for (const double size : {0.2, 1.0}) {
    const auto made = remesh(tetrahedron, {.size = size});
    ASSERT_TRUE(made.ok()) << made.error().message;
    EXPECT_EQ(made->quality.euler, 2);
    EXPECT_EQ(made->quality.boundary_edges, 0U);
    EXPECT_EQ(made->flipped, 0U);
    EXPECT_NEAR(made->quality.area, 1.5 + std::sqrt(3.0) / 2.0, 1e-12);
    EXPECT_LT(made->deviation, 1e-12);
  }
}

TEST(Remesh, OneTriangleAndASizeBeyondTheMeshAreMeshed) {
  const PolygonMesh one{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const auto fine = remesh(one, {.size = 0.2});
  ASSERT_TRUE(fine.ok()) << fine.error().message;
  EXPECT_NEAR(fine->quality.area, 0.5, 1e-12);
  const auto coarse = remesh(one, {.size = 50.0});
  ASSERT_TRUE(coarse.ok()) << coarse.error().message;
  EXPECT_NEAR(coarse->quality.area, 0.5, 1e-12);
}

TEST(Remesh, ItIsTheSameOnEveryCall) {
  const auto each = ten()[7];
  const auto once = remesh(each.mesh, {.size = 0.3}), again = remesh(each.mesh, {.size = 0.3});
  ASSERT_TRUE(once.ok() && again.ok());
  EXPECT_TRUE(once->mesh == again->mesh);
}

TEST(Remesh, TheDeviationOfParallelPlanesIsTheirDistance) {
  const auto at = [](double z) {
    return param::sheet_of(grid_mesh(3, 3, [z](double u, double v) { return Point3{u, v, z}; }))->sheet;
  };
  EXPECT_NEAR(deviation(at(0.0), at(0.25)), 0.25, 1e-15);
  // One way it is nought: the other sheet is a part of this one.
  const auto part = param::sheet_of(grid_mesh(3, 3, [](double u, double v) { return Point3{0.5 * u, v, 0.0}; }))->sheet;
  EXPECT_NEAR(deviation(part, at(0.0)), 0.5, 1e-15);
}

}  // namespace
}  // namespace dobra::surf::remesh
