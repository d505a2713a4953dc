// Domains on which no constant of the mesher was chosen: their figures of quality, as a table, and the floors that must
// hold away from input angles under 40 degrees. The specimens of QUEBRA have the same test in specimen_test.cpp.
// dobra_mesh_test --gtest_filter='TriangulateUnseen.*' prints the table of docs/algorithms/triangulate.md.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "shared/mesh/front/triangulate.h"
#include "shared/mesh/mesh_check.h"
#include "shared/mesh/quality.h"
#include "tests/shared/mesh/mesh_shapes.h"

namespace dobra::mesh::front {
namespace {

using geom::Point;

/// Points in which two edges of the input meet at less than 40 degrees.
std::vector<Point> sharp_corners(const delaunay::MeshInput& input) {
  std::vector<std::vector<Point>> ends(input.points.size());
  for (const delaunay::InputEdge& edge : input.edges) {
    for (std::size_t i = 0; i < 2; ++i) {
      ends[edge.nodes[i].index()].push_back(input.points[edge.nodes[1 - i].index()]);
    }
  }
  std::vector<Point> corners;
  for (std::size_t p = 0; p < ends.size(); ++p) {
    for (std::size_t i = 0; i < ends[p].size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const geom::Vector u = geom::normalised(ends[p][i] - input.points[p]);
        const geom::Vector v = geom::normalised(ends[p][j] - input.points[p]);
        if (geom::dot(u, v) > std::cos(40.0 * std::numbers::pi / 180.0)) corners.push_back(input.points[p]);
      }
    }
  }
  return corners;
}

/// Least alpha of the triangles that are further than six of their longest sides from all `corners`.
double least_alpha_away_from(const std::vector<Point>& corners, const TriangleMesh& mesh) {
  double least = 1.0;
  for (const Corners& t : mesh.triangles) {
    const Point a = mesh.point(t[0]);
    const Point b = mesh.point(t[1]);
    const Point c = mesh.point(t[2]);
    const double reach = 6.0 * std::max({geom::distance(a, b), geom::distance(b, c), geom::distance(c, a)});
    const bool near =
        std::any_of(corners.begin(), corners.end(), [&](Point p) { return geom::distance(a, p) < reach; });
    if (!near) least = std::min(least, alpha(a, b, c));
  }
  return least;
}

/// The edges of `input` cut where the sizes that they ask for together call for shorter ones, as QUEBRA does.
delaunay::MeshInput cut_to_sizes(const delaunay::MeshInput& input, const sizing::SizeFieldOptions& options) {
  const sizing::SizeField field = size_field_of(input, options).value();
  delaunay::MeshInput result = input;
  result.edges.clear();
  for (const delaunay::InputEdge& edge : input.edges) {
    const Point a = input.points[edge.nodes[0].index()];
    const Point b = input.points[edge.nodes[1].index()];
    constexpr int samples = 64;
    std::array<double, samples + 1> sides{};  // Wanted from a to each sample.
    for (int i = 1; i <= samples; ++i) {
      const Point middle = geom::interpolate(a, b, (i - 0.5) / samples);
      sides[static_cast<std::size_t>(i)] =
          sides[static_cast<std::size_t>(i - 1)] + geom::distance(a, b) / samples / field.size_at(middle);
    }
    const int count = std::max(1, static_cast<int>(std::round(sides.back())));
    NodeId from = edge.nodes[0];
    for (int k = 1; k <= count; ++k) {
      const double wanted = sides.back() * k / count;
      const auto above = std::lower_bound(sides.begin() + 1, sides.end() - 1, wanted);
      const double part = (wanted - *(above - 1)) / (*above - *(above - 1));
      const double t = (static_cast<double>(above - sides.begin() - 1) + part) / samples;
      const NodeId to = k < count ? NodeId(result.points.size()) : edge.nodes[1];
      if (k < count) result.points.push_back(geom::interpolate(a, b, t));
      result.edges.push_back({{from, to}, edge.set});
      from = to;
    }
  }
  return result;
}

void expect_floor(const std::string& name, const delaunay::MeshInput& drawn, const MeshOptions& given, double floor) {
  const delaunay::MeshInput input = cut_to_sizes(drawn, given.sizes);
  for (const Engine engine : {Engine::Front, Engine::Delaunay}) {
    MeshOptions options = given;
    options.engine = engine;
    const auto mesh = triangulate(input, options);
    ASSERT_TRUE(mesh) << name << ": " << to_string(mesh.error());
    EXPECT_TRUE(check(*mesh)) << name;
    const MeshQuality q = quality_of(*mesh);
    const double away = least_alpha_away_from(sharp_corners(input), *mesh);
    std::printf("| %s | %s | %zu | %.4f | %.2f %% | %.3f | %.3f |\n", name.c_str(),
                engine == Engine::Front ? "front" : "delaunay", q.triangles, q.alpha_mean, 100.0 * q.alpha_90,
                q.alpha_min, away);
    EXPECT_GE(away, floor) << name;
  }
}

/// A plate of 10 x 10 with a hole at each place, radius r, whose sides are `fine` long; the outline has sides of
/// `coarse`.
delaunay::MeshInput holed_plate(const std::vector<std::pair<Point, double>>& holes, double fine, double coarse) {
  delaunay::MeshInput input;
  const int sides = static_cast<int>(std::ceil(10.0 / coarse));
  std::vector<Point> outline;
  const std::array<Point, 5> corners{Point{0, 0}, Point{10, 0}, Point{10, 10}, Point{0, 10}, Point{0, 0}};
  for (std::size_t k = 0; k < 4; ++k) {
    for (int i = 0; i < sides; ++i) {
      outline.push_back(geom::interpolate(corners[k], corners[k + 1], static_cast<double>(i) / sides));
    }
  }
  add_chain(input, outline, delaunay::Closure::Closed, {"outline", delaunay::EdgeKind::Boundary});
  for (const auto& [centre, radius] : holes) {
    const int count = std::max(8, static_cast<int>(2.0 * std::numbers::pi * radius / fine));
    std::vector<Point> ring;
    for (int i = 0; i < count; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / count;
      ring.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
    }
    add_chain(input, ring, delaunay::Closure::Closed, {"hole", delaunay::EdgeKind::Boundary});
  }
  return input;
}

TEST(TriangulateUnseen, PlatesWithHolesOfOtherGradingsKeepTheFloors) {
  const std::vector<std::pair<Point, double>> one{{{3.7, 6.1}, 1.3}};
  const std::vector<std::pair<Point, double>> four{
      {{2.2, 2.9}, 0.7}, {{7.1, 2.4}, 1.1}, {{6.4, 7.3}, 0.4}, {{2.8, 7.9}, 0.9}};
  MeshOptions options;
  expect_floor("one hole, uniform", holed_plate(one, 0.1, 0.1), options, 0.60);
  expect_floor("four holes, uniform", holed_plate(four, 0.08, 0.08), options, 0.60);
  for (const double growth : {1.1, 1.2, 1.3, 1.5}) {
    options.sizes.growth = growth;
    char text[64];
    std::snprintf(text, sizeof text, "four holes 1:20, growth %.1f", growth);
    expect_floor(text, holed_plate(four, 0.05, 1.0), options, 0.55);
    std::snprintf(text, sizeof text, "one hole 1:200, growth %.1f", growth);
    expect_floor(text, holed_plate(one, 0.005, 1.0), options, 0.55);
  }
}

TEST(TriangulateUnseen, ContoursOfTheCorpusKeepTheFloors) {
  if (test::contours_folder().empty()) GTEST_SKIP() << dobra::test::no_data;
  std::vector<std::filesystem::path> files;
  for (const auto& file : std::filesystem::directory_iterator(test::contours_folder())) {
    if (file.path().extension() == ".txt" || file.path().extension() == ".dat") files.push_back(file.path());
  }
  std::sort(files.begin(), files.end());
  EXPECT_GE(files.size(), 6U);
  for (const auto& file : files) {
    const delaunay::MeshInput outline = test::read_contour(file);
    const double extent = geom::box_of(outline.points).diagonal();
    MeshOptions options;
    options.sizes.max_size = 0.01 * extent;
    expect_floor(file.stem().string(), test::divided(outline, 0.01 * extent), options, 0.55);
  }
}

}  // namespace
}  // namespace dobra::mesh::front
