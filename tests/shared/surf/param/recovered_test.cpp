#include "shared/surf/param/recovered.h"

#include <gtest/gtest.h>

#include <set>

#include "shared/surf/param/parametrise.h"
#include "tests/support/sheets.h"

namespace dobra::surf::param {
namespace {

using geom::Point;
using geom::Point3;
using geom::Vector3;
using test::grid_mesh;
using test::PolygonMesh;

std::shared_ptr<const DiscreteChart> chart_of(const PolygonMesh& mesh) {
  const Sheet sheet = sheet_of(mesh)->sheet;
  auto made = parametrise(sheet);
  EXPECT_TRUE(made.ok() && made->flipped.empty());
  return std::make_shared<const DiscreteChart>(sheet, std::move(made->uv));
}

/// A mesh whose chart is its plan, not one that was found.
std::shared_ptr<const DiscreteChart> chart_in_plan(const PolygonMesh& mesh) {
  const Sheet sheet = sheet_of(mesh)->sheet;
  std::vector<Point> uv;
  for (const Point3 p : sheet.points) uv.push_back({p.x, p.y});
  return std::make_shared<const DiscreteChart>(sheet, std::move(uv));
}

PolygonMesh height_mesh(std::uint32_t n, unsigned seed, const std::function<double(double, double)>& height) {
  return test::shaken_grid(n, n, 0.8, seed, [&](double u, double v) { return Point3{u, v, height(u, v)}; });
}

double quadratic(double u, double v) { return 1 + 2 * u - v + 3 * u * u - u * v + 0.5 * v * v; }

TEST(Recovered, TRI_e_ALinearFieldIsExactInValueAndDerivative) {
  const auto chart = chart_in_plan(height_mesh(9, 1, [](double u, double v) { return 3 - 2 * u + 5 * v; }));
  const Surface surface = *plane_pieces(chart);
  std::mt19937_64 random(2);
  for (int i = 0; i < 300; ++i) {
    const Point p{static_cast<double>(random() >> 11) * 0x1p-53, static_cast<double>(random() >> 11) * 0x1p-53};
    const Jet jet = surface.jet(p);
    EXPECT_NEAR(jet.at.x, p.x, 1e-14);
    EXPECT_NEAR(jet.at.z, 3 - 2 * p.x + 5 * p.y, 1e-13);
    EXPECT_NEAR(jet.u.z, -2.0, 1e-10);
    EXPECT_NEAR(jet.v.z, 5.0, 1e-10);
  }
  std::vector<double> field;
  for (const Point3 p : chart->sheet().points) field.push_back(7 - p.x);
  EXPECT_NEAR(barycentric(*chart, field, chart->locate({0.3, 0.6})), 6.7, 1e-13);
}

TEST(Recovered, TRI_e_PlacesOnVerticesOnSidesAndOutsideAreFound) {
  const auto chart = chart_in_plan(height_mesh(6, 3, quadratic));
  const Sheet& sheet = chart->sheet();
  for (std::uint32_t v = 0; v < sheet.points.size(); ++v) {
    const Located place = chart->locate(chart->uv()[v]);
    EXPECT_TRUE(place.inside);
    std::uint32_t lowest = 0;
    const auto has = [&](std::uint32_t t) { return std::ranges::count(sheet.triangles[t], v) > 0; };
    while (!has(lowest)) ++lowest;
    EXPECT_EQ(place.triangle, lowest);
  }
  const Located side = chart->locate({0.5 / 6, 0.0});
  EXPECT_TRUE(side.inside);
  EXPECT_NEAR(*std::ranges::min_element(side.at), 0.0, 1e-15);
  const Located out = chart->locate({1.5, 0.5});
  EXPECT_FALSE(out.inside);
  const auto& near = sheet.triangles[out.triangle];
  EXPECT_EQ(std::ranges::count_if(near, [&](std::uint32_t v) { return sheet.points[v].x == 1.0; }), 2);
  EXPECT_NEAR(out.beyond.x, 0.5, 1e-15);
  EXPECT_NEAR(out.beyond.y, 0.0, 1e-15);
  const Jet jet = plane_pieces(chart)->jet({1.5, 0.5});
  EXPECT_NEAR(jet.at.x, 1.5, 1e-12);
  EXPECT_NEAR(jet.at.y, 0.5, 1e-12);
}

TEST(Recovered, TRI_f_AQuadraticIsExactInValueAndDerivatives) {
  const auto chart = chart_in_plan(height_mesh(10, 4, quadratic));
  for (const auto weights : {RecoverOptions::SampleWeights::Equal, RecoverOptions::SampleWeights::InverseDistance}) {
    const Recovered recovered(chart, {.meets = Meets::Nothing, .weights = weights});
    EXPECT_EQ(recovered.patches().degraded, 0U);
    std::mt19937_64 random(2);
    for (int i = 0; i < 300; ++i) {
      const Point p{static_cast<double>(random() >> 11) * 0x1p-53, static_cast<double>(random() >> 11) * 0x1p-53};
      for (const Jet& jet : {recovered.jet(p), recovered.recovered(chart->locate(p))}) {
        EXPECT_NEAR(jet.at.x, p.x, 1e-8);
        EXPECT_NEAR(jet.at.z, quadratic(p.x, p.y), 1e-8);
        EXPECT_NEAR(jet.u.z, 2 + 6 * p.x - p.y, 1e-8);
        EXPECT_NEAR(jet.v.z, -1 - p.x + p.y, 1e-8);
      }
    }
  }
}

TEST(Recovered, TRI_f_APlaneIsExactOnEveryMesh) {
  // Two triangles determine no quadratic polynomial.
  for (const std::uint32_t n : {1U, 2U, 5U}) {
    const auto chart = chart_in_plan(height_mesh(n, 5, [](double u, double v) { return 1 - u + 4 * v; }));
    const Recovered recovered(chart, {.meets = Meets::Nothing});
    const Jet jet = recovered.jet(Point{0.21, 0.67});
    EXPECT_NEAR(jet.at.z, 1 - 0.21 + 4 * 0.67, 1e-12);
    EXPECT_NEAR(jet.u.z, -1.0, 1e-11);
    EXPECT_NEAR(jet.v.z, 4.0, 1e-11);
  }
}

void expect_patches(const DiscreteChart& chart, const Recovered& recovered) {
  const PatchReport& report = recovered.patches();
  ASSERT_EQ(report.patch_of.size(), chart.sheet().triangles.size());
  std::vector<std::set<std::uint32_t>> vertices(report.patches);
  for (std::size_t t = 0; t < report.patch_of.size(); ++t) {
    ASSERT_LT(report.patch_of[t], report.patches);
    vertices[report.patch_of[t]].insert(chart.sheet().triangles[t].begin(), chart.sheet().triangles[t].end());
  }
  for (const auto& each : vertices) EXPECT_GE(each.size(), report.degraded > 0 ? 3U : 6U);
}

TEST(Recovered, TRI_g_PatchesAreDisjointCoverAllTrianglesAndDetermineAQuadratic) {
  for (const PolygonMesh& mesh : {test::octant_mesh(8), height_mesh(7, 6, quadratic), test::half_sphere(6),
                                  grid_mesh(20, 2, [](double u, double v) {
                                    return Point3{5 * u, v, u * v};
                                  })}) {
    const auto chart = chart_of(mesh);
    const Recovered recovered(chart);
    expect_patches(*chart, recovered);
    EXPECT_EQ(recovered.patches().degraded, 0U);
  }
}

TEST(Recovered, TRI_g_PatchesThatDetermineNoQuadraticAreReported) {
  const auto strip = chart_in_plan(grid_mesh(2, 1, [](double u, double v) { return Point3{u, v, 0}; }));
  const Recovered degraded(strip);
  EXPECT_EQ(degraded.patches().patches, 1U);
  EXPECT_EQ(degraded.patches().degraded, 1U);  // six points on two lines
  // Vertices of four triangles have five points: their stars are no seeds, and what is left must merge.
  PolygonMesh crosses;
  for (int j = 0; j <= 4; ++j) {
    for (int i = 0; i <= 4; ++i) crosses.points.push_back({0.25 * i, 0.25 * j, 0.1 * i * j});
  }
  for (std::uint32_t j = 0; j < 4; ++j) {
    for (std::uint32_t i = 0; i < 4; ++i) {
      const auto m = static_cast<std::uint32_t>(crosses.points.size());
      crosses.points.push_back({0.25 * i + 0.125, 0.25 * j + 0.125, 0.0});
      const std::uint32_t a = 5 * j + i;
      crosses.faces.insert(crosses.faces.end(), {{a, a + 1, m}, {a + 1, a + 6, m}, {a + 6, a + 5, m}, {a + 5, a, m}});
    }
  }
  const auto chart = chart_in_plan(crosses);
  const Recovered recovered(chart);
  expect_patches(*chart, recovered);
  EXPECT_EQ(recovered.patches().degraded, 0U);
}

TEST(Recovered, TRI_h_ValuesAndRecoveredDerivativesAreContinuous) {
  const auto chart = chart_of(test::octant_mesh(8));
  for (const Meets meets : {Meets::Nothing, Meets::Border, Meets::Points}) {
    const Continuity jumps = Recovered(chart, {.meets = meets}).continuity();
    EXPECT_LE(jumps.value, 1e-10);
    EXPECT_LE(jumps.recovered, 1e-10);
  }
  // Of the plane pieces the value is continuous, and the derivative is not.
  const Surface pieces = *plane_pieces(chart);
  const Sheet& sheet = chart->sheet();
  double value = 0.0, slope = 0.0;
  for (HalfEdge h = 0; h < sheet.twins.size(); ++h) {
    if (sheet.twins[h] == no_half_edge) continue;
    const Point middle = geom::midpoint(chart->uv()[sheet.start(h)], chart->uv()[sheet.end(h)]);
    const auto of = [&](HalfEdge side) { return chart->uv()[sheet.end(next(side))]; };
    const double little = 1e-9;
    const Jet a = pieces.jet(geom::interpolate(middle, of(h), little));
    const Jet b = pieces.jet(geom::interpolate(middle, of(sheet.twins[h]), little));
    value = std::max(value, geom::distance(a.at, b.at) - 2 * little);
    slope = std::max(slope, geom::length(a.u - b.u));
  }
  EXPECT_LT(value, 1e-8);
  EXPECT_GT(slope, 0.05);
}

TEST(Recovered, TRI_i_TheBorderGapIsReportedAndFallsWithTheMesh) {
  std::array<double, 2> gap{};
  for (const std::uint32_t n : {8U, 16U}) {
    const auto chart = chart_of(test::octant_mesh(n));
    const Sheet& sheet = chart->sheet();
    BorderPieces arcs(sheet.twins.size());
    for (HalfEdge h = 0; h < arcs.size(); ++h) {
      if (sheet.twins[h] != no_half_edge) continue;
      const Vector3 a = sheet.points[sheet.start(h)] - Point3{}, b = sheet.points[sheet.end(h)] - Point3{};
      const double angle = std::acos(dot(a, b));
      const Vector3 across = (b - std::cos(angle) * a) / std::sin(angle);
      arcs[h] = BorderPiece{*Curve::arc({}, a, across, 0.0, angle), 0.0, angle};
    }
    const Recovered paper(chart, {.meets = Meets::Nothing}, arcs), treated(chart, {.meets = Meets::Border}, arcs);
    gap[n == 8 ? 0 : 1] = paper.border_gap();
    EXPECT_GT(paper.border_gap(), 1e-6);
    EXPECT_LT(treated.border_gap(), 1e-12);
    // Places of the border are on the unit sphere then, and in a plane of coordinates.
    const Surface surface = *treated.surface();
    const Point on = geom::interpolate(chart->uv()[sheet.loops[0][0]], chart->uv()[sheet.loops[0][1]], 0.37);
    EXPECT_NEAR(geom::distance(surface.at(on), {}), 1.0, 1e-9);
  }
  EXPECT_LT(gap[1], 0.5 * gap[0]);
}

TEST(Recovered, DerivativesAreThoseOfDifferencesBesideTheBorderToo) {
  const auto chart = chart_of(test::octant_mesh(6));
  const Recovered recovered(chart);
  const Sheet& sheet = chart->sheet();
  for (std::uint32_t t = 0; t < sheet.triangles.size(); ++t) {
    Located place{t, {0.3, 0.25, 0.45}, true};
    const auto& uv = chart->uv();
    const auto& [a, b, c] = sheet.triangles[t];
    const Point p = uv[a] + 0.25 * (uv[b] - uv[a]) + 0.45 * (uv[c] - uv[a]);
    const Jet jet = recovered.jet(place);
    const double h = 1e-4;
    const auto at = [&](double du, double dv) { return recovered.jet(Point{p.x + du * h, p.y + dv * h}); };
    EXPECT_LT(geom::length((at(1, 0).at - at(-1, 0).at) / (2 * h) - jet.u), 1e-6);
    EXPECT_LT(geom::length((at(0, 1).at - at(0, -1).at) / (2 * h) - jet.v), 1e-6);
    EXPECT_LT(geom::length((at(1, 0).u - at(-1, 0).u) / (2 * h) - jet.uu), 1e-4);
    EXPECT_LT(geom::length((at(0, 1).u - at(0, -1).u) / (2 * h) - jet.uv), 1e-4);
    EXPECT_LT(geom::length((at(0, 1).v - at(0, -1).v) / (2 * h) - jet.vv), 1e-4);
  }
}

TEST(Recovered, ASmoothSurfaceIsNearerThanItsMesh) {
  const auto height = [](double u, double v) { return 0.3 * std::sin(4 * u) * std::cos(3 * v); };
  const auto chart = chart_in_plan(height_mesh(24, 8, height));
  const Surface smooth = *Recovered(chart, {.meets = Meets::Points}).surface(), pieces = *plane_pieces(chart);
  double off_smooth = 0.0, off_pieces = 0.0;
  for (int i = 1; i < 60; ++i) {
    for (int j = 1; j < 60; ++j) {
      const Point p{i / 60.0, j / 60.0};
      const double z = height(p.x, p.y);
      off_smooth = std::max(off_smooth, std::abs(smooth.at(p).z - z));
      off_pieces = std::max(off_pieces, std::abs(pieces.at(p).z - z));
    }
  }
  EXPECT_LT(off_smooth, 0.5 * off_pieces);
}

}  // namespace
}  // namespace dobra::surf::param
