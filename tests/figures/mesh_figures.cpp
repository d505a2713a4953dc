// Figures of delaunay.md, quadtree.md and size_field.md.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shared/mesh/delaunay/delaunay.h"
#include "shared/mesh/front/triangulate.h"
#include "shared/mesh/sizing/size_field.h"
#include "shared/scene/color_map.h"
#include "tests/figures/figures.h"
#include "tests/shared/mesh/mesh_shapes.h"

namespace dobra::figures {
namespace {

using geom::Point;

std::vector<geom::Polyline> segments_of(const mesh::delaunay::MeshInput& input) {
  std::vector<geom::Polyline> all;
  for (const mesh::delaunay::InputEdge& edge : input.edges) {
    all.push_back(chain({input.points[edge.nodes[0].index()], input.points[edge.nodes[1].index()]}));
  }
  return all;
}

geom::Polyline circle_through(Point a, Point b, Point c) {
  const geom::Vector ab = b - a;
  const geom::Vector ac = c - a;
  const double twice = 2.0 * geom::cross(ab, ac);
  const Point centre = a + (1.0 / twice) * geom::Vector{ac.y * geom::dot(ab, ab) - ab.y * geom::dot(ac, ac),
                                                        ab.x * geom::dot(ac, ac) - ac.x * geom::dot(ab, ab)};
  geom::Polyline circle{{}, true};
  for (int i = 0; i < 48; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 48.0;
    circle.points.push_back(centre + geom::distance(centre, a) * geom::Vector{std::cos(angle), std::sin(angle)});
  }
  return circle;
}

/// Circles of every fifth triangle, those of the flat ones at the hull left out.
std::vector<geom::Polyline> some_circles(const mesh::TriangleMesh& mesh) {
  std::vector<geom::Polyline> circles;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 5) {
    const auto& [a, b, c] = mesh.triangles[t];
    geom::Polyline circle = circle_through(mesh.point(a), mesh.point(b), mesh.point(c));
    if (circle.box().width() < 0.4) circles.push_back(std::move(circle));
  }
  return circles;
}

base::Result<scene::Picture> delaunay() {
  const std::vector<Point> points = mesh::test::random_points(50, 11);
  DOBRA_TRY(const mesh::delaunay::ExtractedMesh free, mesh::delaunay::delaunay(points));
  mesh::delaunay::MeshInput input;
  input.points = points;
  mesh::delaunay::add_chain(input, {{0.12, 0.67}, {0.5, 0.55}, {0.92, 0.8}}, mesh::delaunay::Closure::Open,
                            {"a", mesh::delaunay::EdgeKind::Constraint});
  mesh::delaunay::add_chain(input, {{0.12, 0.175}, {0.92, 0.185}}, mesh::delaunay::Closure::Open,
                            {"b", mesh::delaunay::EdgeKind::Constraint});
  DOBRA_TRY(const mesh::delaunay::ExtractedMesh bound,
            mesh::delaunay::constrained_delaunay(input, mesh::delaunay::Outside::KeepHull));
  scene::Panel left = panel("Delaunay, some of its circles",
                            {lines("circle of a triangle", stroke(orange, 0.8), some_circles(free.mesh)),
                             wires(free.mesh, ink, 0.8), markers("points", dots(ink, 4.0), points)},
                            0.0);
  scene::Panel right = panel("With three edges given",
                             {wires(bound.mesh, ink, 0.8), lines("given edges", stroke(red, 2.4), segments_of(input)),
                              markers("points", dots(ink, 4.0), bound.mesh.points)},
                             0.0);
  left.extent = right.extent = geom::Box{{-0.04, -0.04}, {1.04, 1.04}};
  return scene::Picture{{}, {std::move(left), std::move(right)}};
}

/// The quarter plate: the hole in fine edges, the sides in coarse ones.
std::vector<mesh::sizing::SizedEdge> sized_edges(const mesh::delaunay::MeshInput& input) {
  std::vector<mesh::sizing::SizedEdge> edges;
  for (const geom::Polyline& line : segments_of(input)) edges.push_back({{line.points[0], line.points[1]}});
  return edges;
}

std::vector<geom::Polyline> leaves_of(const mesh::sizing::Quadtree& tree) {
  std::vector<geom::Polyline> leaves;
  for (const mesh::sizing::QuadCellId leaf : tree.leaves()) leaves.push_back(outline(tree.box(leaf)));
  return leaves;
}

/// Two triangles a leaf, with its side as the value.
scene::Mesh leaf_sizes(const mesh::sizing::Quadtree& tree, const scene::Scale& scale) {
  scene::Mesh made{.values_at = scene::ValuesAt::Triangles, .scale = scale};
  for (const mesh::sizing::QuadCellId leaf : tree.leaves()) {
    const auto first = static_cast<std::uint32_t>(made.points.size());
    for (const Point p : outline(tree.box(leaf)).points) made.points.push_back(p);
    made.triangles.push_back({first, first + 1, first + 2});
    made.triangles.push_back({first, first + 2, first + 3});
    made.values.push_back(tree.side(leaf));
    made.values.push_back(tree.side(leaf));
  }
  return made;
}

base::Result<scene::Picture> quadtree() {
  const mesh::delaunay::MeshInput input = mesh::test::que_d();
  DOBRA_TRY(const mesh::sizing::Quadtree tree, mesh::sizing::Quadtree::build(sized_edges(input)));
  DOBRA_TRY(const mesh::sizing::Quadtree finer,
            mesh::sizing::Quadtree::build(sized_edges(input), {.refinement_factor = 2.0}));
  scene::Picture picture;
  for (const auto& [title, made] : {std::pair{"f = 1", &tree}, std::pair{"f = 2", &finer}}) {
    picture.panels.push_back(panel(fmt::format("{}: {} leaves", title, made->leaves().size()),
                                   {lines("leaves", stroke(blue, 0.7), leaves_of(*made)),
                                    lines("input edges", stroke(red, 1.8), segments_of(input))},
                                   0.15));
  }
  return picture;
}

/// The domain in 16 bands of size, each a row of rectangles at a time.
std::vector<scene::Layer> size_bands(const mesh::sizing::SizeField& field, const scene::Scale& scale,
                                     const geom::Box& box) {
  constexpr int rows = 72;
  constexpr int bands = 16;
  const double step = box.width() / rows;
  const auto band_at = [&](int i, int j) {
    const double size = field.size_at({box.low.x + (i + 0.5) * step, box.low.y + (j + 0.5) * step});
    return std::clamp(static_cast<int>(bands * (size - scale.low) / (scale.high - scale.low)), 0, bands - 1);
  };
  std::vector<scene::Region> made(bands);
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < rows; ++i) {
      const int band = band_at(i, j);
      const int first = i;
      while (i + 1 < rows && band_at(i + 1, j) == band) ++i;
      made[static_cast<std::size_t>(band)].contours.push_back(
          outline({{box.low.x + first * step, box.low.y + j * step},
                   {box.low.x + (i + 1) * step, box.low.y + (j + 1) * step}}));
    }
  }
  std::vector<scene::Layer> layers;
  for (int band = 0; band < bands; ++band) {
    const double middle = scale.low + (band + 0.5) / bands * (scale.high - scale.low);
    scene::Style style = filled(scene::color_of(scale, middle));
    style.line_width = 0.2;  // closes the hairlines between rows
    style.line = *style.fill;
    layers.push_back(regions({}, style, {made[static_cast<std::size_t>(band)]}));
  }
  return layers;
}

base::Result<scene::Picture> size_field() {
  const mesh::delaunay::MeshInput input = mesh::test::que_d();
  DOBRA_TRY(const mesh::sizing::SizeField field, mesh::front::size_field_of(input));
  const scene::Scale scale{"size h [m]", scene::ColorMapName::Viridis, 0.0, 1.0};
  const mesh::sizing::Quadtree& tree = field.quadtree();
  const geom::Box box = geom::box_of(input.points);
  const scene::Layer edges = lines("input edges", stroke(red, 1.8), segments_of(input));
  const scene::Layer borders = lines({}, stroke({255, 255, 255, 140}, 0.4), leaves_of(tree));
  scene::Layer steps{{}, {}, filled({}), leaf_sizes(tree, scale), true, InLegend::No};
  scene::Panel left = panel("Sides of the quadtree's leaves", {std::move(steps), borders, edges}, 0.0);
  std::vector<scene::Layer> layers = size_bands(field, scale, box);
  layers.push_back(edges);
  scene::Panel right = panel("Size field, growth 1.3", std::move(layers), 0.0);
  left.extent = right.extent = box.grown(0.1);
  return scene::Picture{{}, {std::move(left), std::move(right)}};
}

}  // namespace

std::vector<Figure> mesh_figures() {
  return {{"delaunay", delaunay}, {"quadtree", quadtree}, {"size_field", size_field}};
}

}  // namespace dobra::figures
