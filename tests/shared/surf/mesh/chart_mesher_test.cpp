#include "shared/surf/mesh/chart_mesher.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "shared/mesh/mesh_check.h"
#include "shared/surf/mesh/surface_elements.h"
#include "tests/shared/surf/mesh/faces.h"
#include "tests/support/in_size.h"
#include "tests/support/surface_stand_ins.h"

namespace dobra::surf::mesh {
namespace {

using base::ErrorCode;
using surf::test::StandIn;

SizeOptions sizes_of(const StandIn& each) {
  SizeOptions sizes;
  sizes.largest = each.largest;
  sizes.turn = each.turn;
  return sizes;
}

StandIn stand_in(const std::string& name) {
  for (StandIn& each : surf::test::stand_ins()) {
    if (each.name == name) return each;
  }
  throw std::out_of_range(name);
}

/// A face with its division, its mesh and its mesh in space.
struct Meshed {
  Division division;
  FaceMesh face;
  SurfaceMesh mesh;
  SurfaceQuality quality;
  double in_size = 0.0;  ///< Part of the edges that are 0.7 to 1.4 times as long as the size in their middle.
};

Meshed meshed(const trim::TrimmedSurface& face, const SizeOptions& sizes, ChartMeshOptions options = {}) {
  options.sizes = sizes;
  Meshed made;
  auto division = divide({&face, 1}, {.sizes = sizes});
  EXPECT_TRUE(division) << division.error().message;
  made.division = std::move(*division);
  auto mesher = ChartMesher::start(made.division.faces[0], options);
  EXPECT_TRUE(mesher) << mesher.error().message;
  while (!mesher->done()) {
    const auto stepped = mesher->step(1000);
    EXPECT_TRUE(stepped) << stepped.error().message;
    if (!stepped) return made;
  }
  made.face = mesher->mesh();
  made.in_size = support::part_in_size(*mesher, made.face);
  auto assembled = assemble({&face, 1}, made.division, {&made.face, 1});
  EXPECT_TRUE(assembled) << assembled.error().message;
  made.mesh = std::move(*assembled);
  const auto checked = check(made.mesh);
  EXPECT_TRUE(checked) << checked.error().message;
  made.quality = quality_of(made.mesh);
  return made;
}

/// Greatest distance, over places of the triangles, from the plane of the triangle to the surface below the place of
/// the chart.
double worst_gap(const Surface& surface, const FaceMesh& face) {
  double worst = 0.0;
  for (const auto& corners : face.chart.triangles) {
    const auto at = [&](int i) { return face.at[corners[static_cast<std::size_t>(i)].index()]; };
    const auto uv = [&](int i) { return face.chart.points[corners[static_cast<std::size_t>(i)].index()]; };
    const geom::Vector3 normal = geom::normalised(cross(at(1) - at(0), at(2) - at(0)));
    constexpr int n = 10;
    for (int i = 0; i <= n; ++i) {
      for (int j = 0; i + j <= n; ++j) {
        const double s = static_cast<double>(i) / n, t = static_cast<double>(j) / n;
        const geom::Point p = uv(0) + (s * (uv(1) - uv(0)) + t * (uv(2) - uv(0)));
        worst = std::max(worst, std::abs(dot(surface.at(p) - at(0), normal)));
      }
    }
  }
  return worst;
}

trim::TrimmedSurface whole(const Surface& surface) {
  return {surface, {surf::test::stand_in::rectangle(surface.chart())}};
}

class ChartMesherOnStandIns : public testing::TestWithParam<const char*> {};

TEST_P(ChartMesherOnStandIns, SUR_f_MeshesAreAsGoodAsAsked) {
  const StandIn each = stand_in(GetParam());
  const Meshed made = meshed(each.face, sizes_of(each));
  EXPECT_GE(made.quality.alpha_mean, 0.985);
  EXPECT_GE(made.quality.alpha_90, 0.98);
  EXPECT_GE(made.quality.alpha_min, 0.70);
  EXPECT_GE(made.in_size, 0.99);
  EXPECT_LT(made.quality.gauss_bonnet, 1e-9);
  const auto flat = dobra::mesh::check(made.face.chart);  // no triangle is turned in the chart
  EXPECT_TRUE(flat) << flat.error().message;
}
INSTANTIATE_TEST_SUITE_P(Each, ChartMesherOnStandIns,
                         testing::Values("6a", "6b", "7a", "7b", "7c", "8a", "8b", "8c", "8d", "8e", "8f"),
                         [](const auto& each) { return std::string("Figure") + each.param; });

TEST(ChartMesher, SUR_f_EdgesOfMeshesTwiceAsCoarseAreAsLongAsAskedToo) {
  for (const char* name : {"6a", "6b", "7a", "7b", "7c", "8a", "8b", "8c", "8d", "8e", "8f"}) {
    const StandIn each = stand_in(name);
    SizeOptions sizes = sizes_of(each);
    sizes.largest *= 2.0;
    sizes.turn *= 2.0;
    EXPECT_GE(meshed(each.face, sizes).in_size, 0.99) << name;
  }
}

TEST(ChartMesher, SUR_f_MeshesOfManyTrianglesAreAsGoodAsAsked) {
  if (std::getenv("DOBRA_SURFACES_LARGE") == nullptr) GTEST_SKIP() << "DOBRA_SURFACES_LARGE=1 asks for them";
  for (const char* name : {"6c", "7d", "7e", "7f"}) {
    const StandIn each = stand_in(name);
    const Meshed made = meshed(each.face, sizes_of(each));
    EXPECT_GE(made.quality.alpha_mean, 0.985) << name;
    EXPECT_GE(made.quality.alpha_90, 0.98) << name;
    EXPECT_GE(made.quality.alpha_min, 0.70) << name;
    EXPECT_GE(made.in_size, 0.99) << name;
    EXPECT_LT(made.quality.gauss_bonnet, 1e-9) << name;
  }
}

/// A mesh counts as large from 100 triangles on here, so that small ones are smoothed as large ones are.
TEST(ChartMesher, SUR_f_LargeMeshesAreAsGoodAsAskedWithOneRound) {
  for (const char* name : {"7c", "8c", "7a", "6b"}) {
    const StandIn each = stand_in(name);
    const Meshed small = meshed(each.face, sizes_of(each));
    const Meshed large = meshed(each.face, sizes_of(each), {.large = 100});
    EXPECT_NE(large.face.at, small.face.at) << name;
    EXPECT_GE(large.quality.alpha_mean, 0.985) << name;
    EXPECT_GE(large.quality.alpha_90, 0.98) << name;
    EXPECT_GE(large.quality.alpha_min, 0.70) << name;
    EXPECT_GE(large.in_size, 0.99) << name;
    EXPECT_LT(large.quality.gauss_bonnet, 1e-9) << name;
    const auto flat = dobra::mesh::check(large.face.chart);
    EXPECT_TRUE(flat) << flat.error().message;
  }
}

TEST(ChartMesher, SUR_g_GivenPointsComeFirstAndGivenSidesAreThere) {
  const StandIn each = stand_in("8c");
  const Meshed made = meshed(each.face, sizes_of(each));
  const ChartInput& input = made.division.faces[0];
  ASSERT_GT(made.face.at.size(), input.at.size());
  for (std::size_t i = 0; i < input.at.size(); ++i) {
    EXPECT_EQ(made.face.chart.points[i], input.chart.points[i]);
    EXPECT_EQ(made.face.at[i], input.at[i]);
  }
  std::map<std::pair<std::size_t, std::size_t>, int> sides;
  for (const auto& edge : dobra::mesh::all_edges(made.face.chart)) ++sides[{edge[0].index(), edge[1].index()}];
  for (const auto& edge : input.chart.edges) {
    const auto a = edge.nodes[0].index(), b = edge.nodes[1].index();
    EXPECT_EQ(sides.count({std::min(a, b), std::max(a, b)}), 1U);
  }
  const auto n = static_cast<double>(made.face.chart.boundary_sets.at("hole").size());
  EXPECT_NEAR(made.quality.area, 100.0 - 0.5 * n * 2.25 * std::sin(2.0 * std::numbers::pi / n), 1e-9);
  EXPECT_GT(made.face.chart.constraint_sets.at("line").size(), 20U);
}

TEST(ChartMesher, SUR_h_AreasOfRoundSurfacesComeNear) {
  const double turn = 10.0;
  const Meshed sphere = meshed(stand_in("7c").face, {.largest = 2.0, .turn = turn});
  EXPECT_NEAR(sphere.quality.area, 136.034952, 1.4);
  const Meshed cylinder = meshed(stand_in("7a").face, {.largest = 2.0, .turn = turn});
  EXPECT_NEAR(cylinder.quality.area, 78.539816, 0.8);
}

/// Area of triangles of six nodes: the three-point rule by three on the square that folds into the triangle.
double area_of_second_order(const SurfaceElements& elements) {
  const double far = std::sqrt(0.6);
  const std::array<double, 3> at{0.5 * (1.0 - far), 0.5, 0.5 * (1.0 + far)}, weight{5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
  double area = 0.0;
  for (std::size_t e = 0; e < elements.mesh.element_count(); ++e) {
    const auto nodes = elements.mesh.nodes_of(dobra::mesh::ElementId(e));
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        const double r = at[i], s = at[j] * (1.0 - r), t = 1.0 - r - s;
        const std::array<double, 6> by_r{1.0 - 4.0 * t, 4.0 * r - 1.0, 0.0, 4.0 * (t - r), 4.0 * s, -4.0 * s};
        const std::array<double, 6> by_s{1.0 - 4.0 * t, 0.0, 4.0 * s - 1.0, -4.0 * r, 4.0 * r, 4.0 * (t - s)};
        geom::Vector3 along{}, across{};
        for (std::size_t k = 0; k < 6; ++k) {
          const geom::Vector3 p = elements.point(nodes[k]) - geom::Point3{};
          along = along + by_r[k] * p;
          across = across + by_s[k] * p;
        }
        area += weight[i] * weight[j] * (1.0 - r) * geom::length(cross(along, across));
      }
    }
  }
  return area;
}

/// A part of a sphere and a part of a torus, their areas by the formulas of Guldin.
TEST(ChartMesher, SUR_h_AreasComeNearAtTheSecondAndTheFourthOrder) {
  constexpr double pi = std::numbers::pi;
  const std::vector<std::pair<Surface, double>> round{
      {*Surface::sphere({}, 2.0, {{0, -0.25 * pi}, {0.6 * pi, 0.25 * pi}}), 4.0 * 0.6 * pi * std::sqrt(2.0)},
      {*Surface::torus({}, 3.0, 1.0, {{0, 0}, {0.5 * pi, 0.5 * pi}}), 0.5 * pi * (3.0 * 0.5 * pi + 1.0)}};
  for (const auto& [surface, area] : round) {
    const trim::TrimmedSurface face = whole(surface);
    std::vector<double> elements, linear, quadratic;
    for (const double size : {0.4, 0.2, 0.1}) {
      const Meshed made = meshed(face, {.largest = size, .turn = 60.0});
      elements.push_back(static_cast<double>(made.mesh.triangles.size()));
      linear.push_back(area - made.quality.area);
      EXPECT_LT(made.quality.gauss_bonnet, 1e-9);
      const auto second = to_second_order(elements_of(made.mesh), {&face, 1}, made.division.middles);
      quadratic.push_back(area - area_of_second_order(second));
    }
    const auto order = [&](const std::vector<double>& errors) {
      return std::log(std::abs(errors[0] / errors[2])) / std::log(std::sqrt(elements[2] / elements[0]));
    };
    EXPECT_NEAR(order(linear), 2.0, 0.15);
    EXPECT_NEAR(order(quadratic), 4.0, 0.4);
    EXPECT_LT(std::abs(linear[2]), 2e-3 * area);
    EXPECT_LT(std::abs(quadratic[2]), 1e-6 * area);
  }
}

TEST(ChartMesher, StaysWithinTheChordErrorAskedEverywhere) {
  for (const double chord : {0.05, 0.01}) {
    for (const char* name : {"7c", "7b", "6a"}) {
      const trim::TrimmedSurface face = stand_in(name).face;
      const Meshed made = meshed(face, {.largest = 5.0, .turn = 90.0, .chord = chord});
      EXPECT_LE(worst_gap(face.surface, made.face), chord) << name;
      // It is not much finer than asked either.
      EXPECT_GE(worst_gap(face.surface, made.face), 0.2 * chord) << name;
    }
  }
}

TEST(ChartMesher, StaysWithinTheChordErrorAskedOnEveryStandIn) {
  if (std::getenv("DOBRA_SURFACES_LARGE") == nullptr) GTEST_SKIP() << "DOBRA_SURFACES_LARGE=1 asks for them";
  for (const StandIn& each : surf::test::stand_ins()) {
    for (const double chord : {0.03, 0.006}) {
      const Meshed made = meshed(each.face, {.largest = 2.0, .turn = 90.0, .chord = chord});
      EXPECT_LE(worst_gap(each.face.surface, made.face), chord) << each.name;
      EXPECT_LT(made.quality.gauss_bonnet, 1e-9) << each.name;
    }
  }
}

TEST(ChartMesher, SUR_k_GivesTheSameBytesEachTimeAndInAnySteps) {
  const StandIn each = stand_in("8f");
  const auto division = divide({&each.face, 1}, {.sizes = sizes_of(each)});
  ASSERT_TRUE(division);
  const auto once = mesh_chart(division->faces[0], {.sizes = sizes_of(each)});
  const auto again = mesh_chart(division->faces[0], {.sizes = sizes_of(each)});
  ASSERT_TRUE(once && again);
  EXPECT_EQ(once->chart, again->chart);
  EXPECT_EQ(once->at, again->at);
  auto mesher = ChartMesher::start(division->faces[0], {.sizes = sizes_of(each)});
  ASSERT_TRUE(mesher);
  std::size_t most = 0;
  while (!mesher->done()) {
    ASSERT_TRUE(mesher->step(37));
    most = std::max(most, mesher->view().front.size());
  }
  EXPECT_GT(most, 0U);
  EXPECT_EQ(mesher->mesh().chart, once->chart);
}

/// The same patch as a spline over other charts.
TEST(ChartMesher, QualityDoesNotHangOnTheParameters) {
  const SizeOptions sizes{.largest = 0.8, .turn = 15.0};
  // A saddle as a bicubic patch by its control points; u is stretched, then the knots are given again a degree higher.
  const auto patch = [](double u_range, double v_range, double skew) {
    std::vector<geom::Point3> points;
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        const double x = 10.0 * i / 3.0 + skew * j, y = 8.0 * j / 3.0;
        points.push_back({x, y, ((i == 1 || i == 2) ? 2.0 : 0.0) - ((j == 1 || j == 2) ? 2.0 : 0.0)});
      }
    }
    const auto knots = [](double range) { return std::vector<double>{0, 0, 0, 0, range, range, range, range}; };
    return *Surface::nurbs(3, knots(u_range), 3, knots(v_range), points);
  };
  const Meshed plain = meshed(whole(patch(1, 1, 0)), sizes);
  for (const auto& [u, v] : {std::pair{1000.0, 1.0}, std::pair{1.0, 1000.0}, std::pair{1e-3, 3.0}}) {
    const Meshed other = meshed(whole(patch(u, v, 0)), sizes);
    EXPECT_NEAR(other.quality.alpha_mean, plain.quality.alpha_mean, 0.003);
    EXPECT_NEAR(other.quality.area, plain.quality.area, 1e-3 * plain.quality.area);
    EXPECT_GE(other.quality.alpha_min, 0.7);
  }
  // A plane under a slanted chart, at 22 degrees, and cut straight.
  const Surface slanted = *Surface::plane({{}, {1, 0, 0}, {2.5, 1, 0}, {}}, {{-40, -1}, {40, 11}});
  const auto at = [](double x, double y) { return geom::Point{x - 2.5 * y, y}; };
  const trim::TrimmedSurface square{slanted, {test::polygon({at(0, 0), at(10, 0), at(10, 10), at(0, 10)})}};
  const trim::TrimmedSurface straight{*Surface::plane({}, {{0, 0}, {10, 10}}),
                                      {test::polygon({{0, 0}, {10, 0}, {10, 10}, {0, 10}})}};
  const Meshed one = meshed(square, sizes), two = meshed(straight, sizes);
  EXPECT_NEAR(one.quality.alpha_mean, two.quality.alpha_mean, 0.003);
  EXPECT_GE(one.quality.alpha_min, 0.7);
  EXPECT_NEAR(one.quality.area, 100.0, 1e-9);
}

/// u runs as its fifth power: the chart's metric changes by thousands.
TEST(ChartMesher, CopesWithMetricsThatChangeStrongly) {
  std::vector<geom::Point3> points;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 2; ++j) points.push_back({i == 5 ? 10.0 : i == 4 ? 1.0 : 0.05 * i, 10.0 * j, 0.0});
  }
  const Surface surface = *Surface::nurbs(5, {0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1}, 1, {0, 0, 1, 1}, points);
  const Meshed made = meshed(whole(surface), {.largest = 0.6});
  EXPECT_GE(made.quality.alpha_mean, 0.97);
  EXPECT_GE(made.quality.alpha_min, 0.6);
  EXPECT_NEAR(made.quality.area, 100.0, 1e-9);
}

TEST(ChartMesher, NeedsNoNormalOnASideThatIsOnePoint) {
  // Nobody has opened the poles: a mesh or a refusal, and no crash.
  const trim::TrimmedSurface face = whole(*Surface::sphere({}, 1.0, {{0, 0}, {1.5, 0.5 * std::numbers::pi}}));
  ChartInput input{face.surface, {}, {}, {}};
  std::vector<geom::Point> loop;
  for (int i = 0; i < 10; ++i) loop.push_back({0.15 * i, 0.0});
  for (int i = 0; i < 10; ++i) loop.push_back({1.5, 0.05 * std::numbers::pi * i});
  for (int i = 0; i < 10; ++i) loop.push_back({1.5 - 0.15 * i, 0.5 * std::numbers::pi});
  for (int i = 0; i < 10; ++i) loop.push_back({0.0, 0.5 * std::numbers::pi - 0.05 * std::numbers::pi * i});
  add_chain(input.chart, loop, dobra::mesh::delaunay::Closure::Closed, {"border", {}});
  for (const geom::Point p : loop) input.at.push_back(face.surface.at(p));
  const auto mesh = mesh_chart(input, {.sizes = {.largest = 0.2}});
  if (mesh) {
    EXPECT_TRUE(dobra::mesh::check(mesh->chart));
  } else {
    EXPECT_FALSE(mesh.error().message.empty());
  }
}

TEST(ChartMesher, SizesThatAreAsGoodAsNoughtAreRefusedWithAPlace) {
  const trim::TrimmedSurface face = whole(*Surface::plane({}, {{0, 0}, {4, 2}}));
  const auto division = divide({&face, 1}, {.sizes = {.largest = 0.5}});
  ASSERT_TRUE(division);
  ChartMeshOptions options{.sizes = {.largest = 0.5}};
  options.sizes.wanted = [](geom::Point, geom::Point3) { return 1e-200; };
  const auto made = mesh_chart(division->faces[0], options);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, ErrorCode::TooManyElements);
  ASSERT_TRUE(made.error().place && made.error().place->u);
}

TEST(ChartMesher, SizesFarBelowTheLeastCellOfTheTreeAreRefusedWithAPlace) {
  trim::TrimmedSurface face = whole(*Surface::plane({}, {{0, 0}, {4, 2}}));
  face.points.push_back({.at = {1.2, 0.7}, .name = "fine"});
  const auto meshed_with = [&](double size) {
    face.points[0].size = size;
    const auto division = divide({&face, 1}, {.sizes = {.largest = 0.5}});
    return mesh_chart(division->faces[0], {.sizes = {.largest = 0.5}});
  };
  EXPECT_TRUE(meshed_with(1e-8));
  const auto made = meshed_with(1e-11);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, ErrorCode::TooManyElements);
  ASSERT_TRUE(made.error().place && made.error().place->u && made.error().place->v);
  EXPECT_NEAR(*made.error().place->u, 1.2, 1e-6);
  EXPECT_NEAR(*made.error().place->v, 0.7, 1e-6);
}

TEST(ChartMesher, RefusesWhatItCannotDo) {
  const StandIn each = stand_in("7a");
  const auto division = divide({&each.face, 1}, {.sizes = sizes_of(each)});
  ASSERT_TRUE(division);
  const ChartInput& input = division->faces[0];
  ChartMeshOptions options{.sizes = sizes_of(each)};
  const auto code = [&](const ChartInput& given, const ChartMeshOptions& with) {
    const auto made = mesh_chart(given, with);
    return made ? ErrorCode{} : made.error().code;
  };
  ChartMeshOptions few = options;
  few.points.max_triangles = 100;
  EXPECT_EQ(code(input, few), ErrorCode::TooManyElements);
  ChartMeshOptions fine = options;
  fine.sizes.largest = 1e-5;
  EXPECT_EQ(code(input, fine), ErrorCode::TooManyElements);
  ChartMeshOptions shrinking = options;
  shrinking.sizes.growth = 1.0;
  EXPECT_EQ(code(input, shrinking), ErrorCode::InvalidOption);
  ChartInput open = input;
  open.chart.edges.pop_back();
  EXPECT_EQ(code(open, options), ErrorCode::CannotMesh);
  ChartInput nowhere = input;
  nowhere.at[3].z = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(code(nowhere, options), ErrorCode::NotFinite);
  ChartInput homeless = input;
  homeless.at.pop_back();
  EXPECT_EQ(code(homeless, options), ErrorCode::InvalidOption);
  ChartInput crossing = input;
  crossing.chart.sets.push_back({"cross", dobra::mesh::delaunay::EdgeKind::Constraint});
  const auto across = [&](std::size_t a, std::size_t b) {
    crossing.chart.edges.push_back(
        {{NodeId(a), NodeId(b)}, static_cast<std::uint32_t>(crossing.chart.sets.size() - 1)});
  };
  across(0, 36);
  across(16, 52);
  EXPECT_EQ(code(crossing, options), ErrorCode::SelfIntersection);
  const base::CancelToken token;
  token.cancel();
  EXPECT_EQ(mesh_chart(input, options, {token, nullptr}).error().code, ErrorCode::Cancelled);
}

}  // namespace
}  // namespace dobra::surf::mesh
