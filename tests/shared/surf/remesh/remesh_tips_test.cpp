// Sharp points that no line at which the mesh folds meets: tips of cones.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "shared/surf/remesh/remesh.h"
#include "tests/support/sheets.h"

namespace dobra::surf::remesh {
namespace {

using geom::Point3;
using test::PolygonMesh;

enum class Base { Open, Closed };

/// A cone of `sides` sides round the z axis, its base of radius 1 at z = 0; without points between.
PolygonMesh cone(std::uint32_t sides, double height, Base base, double turn = 1.0) {
  PolygonMesh mesh;
  for (std::uint32_t i = 0; i < sides; ++i) {
    const double a = turn * 2.0 * std::numbers::pi * i / sides;
    mesh.points.push_back({std::cos(a), std::sin(a), 0.0});
  }
  mesh.points.push_back({0, 0, height});
  for (std::uint32_t i = 0; i + (turn < 1.0 ? 1 : 0) < sides; ++i) mesh.faces.push_back({i, (i + 1) % sides, sides});
  if (base == Base::Open) return mesh;
  mesh.points.push_back({0, 0, 0});
  for (std::uint32_t i = 0; i < sides; ++i) mesh.faces.push_back({(i + 1) % sides, i, sides + 1});
  return mesh;
}

/// A node of a triangle stands exactly there.
bool has_node(const Remeshed& made, Point3 p) {
  return std::ranges::any_of(made.mesh.triangles, [&](const auto& corners) {
    return std::ranges::any_of(corners, [&](const auto node) { return made.mesh.point(node) == p; });
  });
}

bool is_told(const Remeshed& made, const std::string& code) {
  return std::ranges::any_of(made.findings, [&](const auto& f) { return f.code == code; });
}

double cone_area(std::uint32_t sides, double height, Base base) {
  const double edge = 2.0 * std::sin(std::numbers::pi / sides), middle = std::cos(std::numbers::pi / sides);
  const double side = 0.5 * edge * std::hypot(height, middle), flat = 0.5 * edge * middle;
  return sides * (side + (base == Base::Closed ? flat : 0.0));
}

TEST(RemeshTips, TheTipOfAConeIsANodeWhateverItsSides) {
  for (const Base base : {Base::Open, Base::Closed}) {
    for (const std::uint32_t sides : {6U, 12U, 40U, 200U}) {
      for (const double height : {0.9, 3.0}) {
        SCOPED_TRACE(testing::Message() << sides << " sides, height " << height
                                        << (base == Base::Closed ? ", closed" : ", open"));
        const auto made = remesh(cone(sides, height, base), {.size = 0.2});
        ASSERT_TRUE(made.ok()) << made.error().message;
        EXPECT_TRUE(has_node(*made, {0, 0, height}));
        EXPECT_LT(made->deviation, 0.1);  // half a side
        EXPECT_FALSE(is_told(*made, "deviation_above"));
        EXPECT_EQ(made->flipped, 0U);
        EXPECT_EQ(made->folded, 0U);
        EXPECT_EQ(made->quality.euler, base == Base::Closed ? 2 : 1);
        EXPECT_NEAR(made->quality.area, cone_area(sides, height, base), 0.015 * made->area_before);
        EXPECT_GT(made->quality.alpha_min, 0.3);
      }
    }
  }
}

TEST(RemeshTips, TheTipOfAScannedConeIsANode) {
  // Rings of points round the tip, as a scanner gives them.
  for (const double height : {0.7, 2.0}) {
    const PolygonMesh scan = test::disk_mesh(15, [height](double r, double a) {
      return Point3{r * std::cos(a), r * std::sin(a), height * (1.0 - r)};
    });
    const auto made = remesh(scan, {.size = 0.2});
    ASSERT_TRUE(made.ok()) << made.error().message;
    EXPECT_TRUE(has_node(*made, {0, 0, height}));
    EXPECT_EQ(made->tips, 1U);
    EXPECT_LT(made->deviation, 0.1);  // half a side
    EXPECT_EQ(made->quality.euler, 1);
    EXPECT_EQ(made->folded, 0U);
    // Without creases no sharp point is kept either.
    const auto none = remesh(scan, {.size = 0.2, .crease = 180.0});
    ASSERT_TRUE(none.ok()) << none.error().message;
    EXPECT_EQ(none->tips, 0U);
  }
}

TEST(RemeshTips, BothTipsOfADoubleConeAreNodes) {
  PolygonMesh both = cone(60, 1.5, Base::Open);
  both.points.push_back({0, 0, -1});
  for (std::uint32_t i = 0; i < 60; ++i) both.faces.push_back({(i + 1) % 60, i, 61});
  const auto made = remesh(both, {.size = 0.2});
  ASSERT_TRUE(made.ok()) << made.error().message;
  EXPECT_TRUE(has_node(*made, {0, 0, 1.5}));
  EXPECT_TRUE(has_node(*made, {0, 0, -1}));
  EXPECT_EQ(made->quality.euler, 2);
  EXPECT_LT(made->deviation, 0.1);  // half a side
}

TEST(RemeshTips, TheTipOfAPyramidStaysTheEndOfItsEdges) {
  const auto made = remesh(cone(4, 1.0, Base::Closed), {.size = 0.2});
  ASSERT_TRUE(made.ok()) << made.error().message;
  EXPECT_TRUE(has_node(*made, {0, 0, 1}));
  EXPECT_EQ(made->creases, 8U);
  EXPECT_EQ(made->tips, 0U);  // it is an end of lines
  EXPECT_LT(made->deviation, 1e-12);
}

TEST(RemeshTips, ATipOnTheBorderIsANode) {
  // Half of a cone; its border runs over the tip at 64 degrees. And a hood over a straight border.
  const auto half = remesh(cone(41, 1.6, Base::Open, 0.5 * 41.0 / 40.0), {.size = 0.2});
  ASSERT_TRUE(half.ok()) << half.error().message;
  EXPECT_TRUE(has_node(*half, {0, 0, 1.6}));
  PolygonMesh hood{{{0, 0, 0}}, {}};
  for (std::uint32_t i = 0; i <= 40; ++i) {
    const double a = std::numbers::pi * i / 40.0;
    hood.points.push_back({std::cos(a), std::sin(a), std::pow(std::sin(2.0 * a), 2)});
    if (i > 0) hood.faces.push_back({0, i, i + 1});
  }
  for (const double size : {0.13, 0.17, 0.2}) {
    const auto made = remesh(hood, {.size = size});
    ASSERT_TRUE(made.ok()) << made.error().message;
    EXPECT_TRUE(has_node(*made, {0, 0, 0})) << size;
  }
}

/// A plane with hills like cones, whose tips are corners of its cells; flat between.
PolygonMesh hills(std::uint32_t cells, const std::vector<std::array<double, 2>>& tips, double radius, double height) {
  return test::grid_mesh(cells, cells, [&](double u, double v) {
    double z = 0.0;
    for (const auto& [x, y] : tips) z = std::max(z, height * (1.0 - std::hypot(u - x, v - y) / radius));
    return Point3{u, v, z};
  });
}

TEST(RemeshTips, TipsWithinASizeOfEachOtherAreBothKept) {
  const auto made = remesh(hills(80, {{0.45, 0.5}, {0.525, 0.5}}, 0.3, 0.25), {.size = 0.1});
  ASSERT_TRUE(made.ok()) << made.error().message;
  EXPECT_TRUE(has_node(*made, {0.45, 0.5, 0.25}));
  EXPECT_TRUE(has_node(*made, {0.525, 0.5, 0.25}));
  EXPECT_EQ(made->folded, 0U);
  EXPECT_GT(made->quality.alpha_min, 0.2);
}

/// A cone of 45 degrees round its tip at {x, 0, 0}, downwards, as far as the plane x = 0; for x < 0 mirrored.
void add_cone_beside_plane(PolygonMesh& mesh, double x) {
  constexpr std::uint32_t sides = 200;
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.push_back({x, 0, 0});
  for (std::uint32_t i = 0; i < sides; ++i) {
    const double a = 2.0 * std::numbers::pi * i / sides, c = std::cos(a), s = std::sin(a);
    const double far = c * std::abs(x) < 0.0 && -std::abs(x) / c < 1.0 ? -std::abs(x) / c : 1.0;
    const bool on_plane = far < 1.0;
    const double sign = x < 0.0 ? -1.0 : 1.0;
    mesh.points.push_back({on_plane ? 0.0 : x + sign * far * c, far * s, -far});
    const std::uint32_t here = first + 1 + i, next = first + 1 + (i + 1) % sides;
    mesh.faces.push_back(x < 0.0 ? std::vector{first, next, here} : std::vector{first, here, next});
  }
}

TEST(RemeshTips, ATipBesideTheBorderIsKeptUnlessItIsMuchNearerThanASide) {
  for (const double x : {0.15, 0.06, 0.03}) {
    PolygonMesh mesh;
    add_cone_beside_plane(mesh, x);
    const auto made = remesh(mesh, {.size = 0.2});
    ASSERT_TRUE(made.ok()) << made.error().message;
    const bool kept = x * std::numbers::sqrt2 > 0.25 * 0.2;  // the way to the border, a quarter of a side
    EXPECT_EQ(has_node(*made, {x, 0, 0}), kept) << x;
    EXPECT_EQ(made->tips, kept ? 1U : 0U) << x;
    EXPECT_EQ(is_told(*made, "tip_left_out"), !kept) << x;
    EXPECT_EQ(made->folded, 0U) << x;
    if (!kept) {
      const auto told = std::ranges::find(made->findings, "tip_left_out", &mesh::Finding::code);
      EXPECT_EQ(told->place.x, x);
      EXPECT_EQ(told->place.z, 0.0);
    }
  }
}

TEST(RemeshTips, OneOfTwoMuchNearerThanASideIsLeftOutAndTold) {
  for (const double x : {0.06, 0.02}) {
    PolygonMesh mesh;
    add_cone_beside_plane(mesh, x);
    add_cone_beside_plane(mesh, -x);
    const auto made = remesh(mesh, {.size = 0.2});
    ASSERT_TRUE(made.ok()) << made.error().message;
    const bool both = 2.0 * x > 0.25 * 0.2;
    EXPECT_TRUE(has_node(*made, {x, 0, 0}) || has_node(*made, {-x, 0, 0})) << x;
    EXPECT_EQ(has_node(*made, {x, 0, 0}) && has_node(*made, {-x, 0, 0}), both) << x;
    EXPECT_EQ(is_told(*made, "tip_left_out"), !both) << x;
    EXPECT_EQ(made->folded, 0U) << x;
  }
}

TEST(RemeshTips, NoiseAndSmoothMeshesHaveNone) {
  std::mt19937_64 random(11);
  const auto noise = [&random] { return static_cast<double>(random() >> 11) * 0x1p-53 - 0.5; };
  for (const double by : {0.0, 0.1, 0.3, 0.6, 1.0}) {  // of a cell
    const PolygonMesh scan = test::shaken_grid(50, 50, 0.5, 12, [&](double u, double v) {
      return Point3{u, v, 0.1 * std::sin(5 * u * v) + by / 50 * noise()};
    });
    const auto made = remesh(scan, {.size = 0.06});
    ASSERT_TRUE(made.ok()) << made.error().message;
    EXPECT_EQ(made->tips, 0U) << by;
    EXPECT_FALSE(is_told(*made, "tip_left_out")) << by;
  }
  // One point off, as by a fault of the scanner.
  const auto spike = remesh(test::grid_mesh(40, 40,
                                            [](double u, double v) {
                                              return Point3{u, v, u == 0.5 && v == 0.5 ? 0.025 : 0.0};
                                            }),
                            {.size = 0.05});
  ASSERT_TRUE(spike.ok()) << spike.error().message;
  EXPECT_EQ(spike->tips, 0U);
  for (const PolygonMesh& smooth : {test::sphere_mesh(2), test::sphere_mesh(6), test::half_sphere(4)}) {
    const auto made = remesh(smooth, {.size = 0.4});
    ASSERT_TRUE(made.ok()) << made.error().message;
    EXPECT_EQ(made->tips, 0U);
  }
}

}  // namespace
}  // namespace dobra::surf::remesh
