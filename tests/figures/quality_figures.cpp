// Figures of quality.md, smooth.md and triangulate.md.
#include <fmt/format.h>

#include <cmath>

#include "shared/mesh/delaunay/delaunay.h"
#include "shared/mesh/front/smooth.h"
#include "shared/mesh/front/triangulate.h"
#include "shared/mesh/quality.h"
#include "tests/figures/figures.h"
#include "tests/shared/mesh/mesh_shapes.h"

namespace dobra::figures {
namespace {

using geom::Point;

/// Triangles side by side, by the height over a base of 1 m; each with its measure.
scene::Panel sample_triangles() {
  struct Sample {
    const char* name;
    std::array<Point, 3> corners;
  };
  const double equilateral = 0.5 * std::sqrt(3.0);
  const std::vector<Sample> samples{{"equilateral", {{{0, 0}, {1, 0}, {0.5, equilateral}}}},
                                    {"right isosceles", {{{0, 0}, {1, 0}, {0, 1}}}},
                                    {"3 : 4 : 5", {{{0, 0}, {1, 0}, {0, 0.75}}}},
                                    {"height 2", {{{0, 0}, {1, 0}, {0.5, 2.0}}}},
                                    {"height 1/2", {{{0, 0}, {1, 0}, {0.5, 0.5}}}},
                                    {"height 1/5", {{{0, 0}, {1, 0}, {0.5, 0.2}}}}};
  mesh::TriangleMesh row;
  std::vector<scene::Label> texts;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const geom::Vector to{1.55 * static_cast<double>(i), 0.0};
    const auto& [a, b, c] = samples[i].corners;
    const std::size_t first = row.points.size();
    for (const Point p : samples[i].corners) row.points.push_back(p + to);
    row.triangles.push_back({mesh::NodeId(first), mesh::NodeId(first + 1), mesh::NodeId(first + 2)});
    texts.push_back({Point{0.5, -0.18} + to, samples[i].name});
    texts.push_back({Point{0.5, -0.42} + to, fmt::format("{:.3f}", mesh::alpha(a, b, c))});
  }
  scene::Layer triangles = quality_layer(row);
  std::get<scene::Mesh>(triangles.content).scale.low = 0.0;
  triangles.style = stroke(ink, 1.0);
  scene::Panel made = panel("", {std::move(triangles), labels(ink, std::move(texts))}, 0.0);
  made.extent->add(geom::Box{{-0.3, -0.6}, {9.05, 2.1}});
  return made;
}

base::Result<scene::Picture> quality() { return scene::Picture{{}, {sample_triangles()}}; }

scene::Panel quality_panel(const std::string& name, const mesh::TriangleMesh& mesh) {
  const mesh::MeshQuality measured = mesh::quality_of(mesh);
  return panel(fmt::format("{}: alpha mean {:.3f}, least {:.2f}", name, measured.alpha_mean, measured.alpha_min),
               {quality_layer(mesh)}, 0.03);
}

/// Random points in a square: the mesh, the mesh smoothed, and smoothed again after flips.
base::Result<scene::Picture> smooth() {
  mesh::delaunay::MeshInput input = mesh::test::square(1.0, 9);
  for (const Point p : mesh::test::random_points(90, 5)) {
    input.points.push_back({0.06 + 0.88 * p.x, 0.06 + 0.88 * p.y});
  }
  DOBRA_TRY(mesh::delaunay::ExtractedMesh made,
            mesh::delaunay::constrained_delaunay(input, mesh::delaunay::Outside::Remove));
  mesh::TriangleMesh& mesh = made.mesh;
  scene::Picture picture{{}, {quality_panel("Before", mesh)}};
  mesh::front::smooth(mesh);
  picture.panels.push_back(quality_panel("3 passes", mesh));
  for (int round = 0; round < 3; ++round) {
    mesh::front::flip_to_delaunay(mesh);
    mesh::front::smooth(mesh);
  }
  picture.panels.push_back(quality_panel("Flips too", mesh));
  return picture;
}

scene::Panel plate(const std::string& name, const mesh::TriangleMesh& mesh) {
  std::vector<geom::Polyline> constraints;
  for (const auto& [set, edges] : mesh.constraint_sets) {
    for (const auto& [a, b] : edges) constraints.push_back(chain({mesh.point(a), mesh.point(b)}));
  }
  std::vector<scene::Layer> layers{quality_layer(mesh)};
  if (!constraints.empty()) layers.push_back(lines("constraints", stroke(blue, 1.3), std::move(constraints)));
  const mesh::MeshQuality measured = mesh::quality_of(mesh);
  return panel(fmt::format("{}: {} triangles, alpha mean {:.3f}", name, measured.triangles, measured.alpha_mean),
               std::move(layers), 0.1);
}

base::Result<scene::Picture> triangulate() {
  DOBRA_TRY(const mesh::TriangleMesh without, mesh::front::triangulate(mesh::test::que_d()));
  DOBRA_TRY(const mesh::TriangleMesh with, mesh::front::triangulate(mesh::test::que_e()));
  return scene::Picture{{}, {plate("Free", without), plate("Constrained", with)}};
}

}  // namespace

std::vector<Figure> quality_figures() {
  return {{"quality", quality}, {"smooth", smooth, 900.0}, {"triangulate", triangulate}};
}

}  // namespace dobra::figures
