// What all figures share: styles, layers and panels in a word each.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "shared/mesh/quality.h"
#include "tests/figures/figures.h"

namespace dobra::figures {
namespace {

template <class Content>
scene::Layer layer(std::string title, const scene::Style& style, Content content) {
  const InLegend in_legend = title.empty() ? InLegend::No : InLegend::Yes;
  return {{}, std::move(title), style, std::move(content), true, in_legend};
}

}  // namespace

scene::Style stroke(scene::Color color, double width, scene::Dash dash) {
  return {.line = color, .line_width = width, .dash = dash};
}
scene::Style filled(scene::Color color) { return {.line = color, .line_width = 0.0, .fill = color}; }
scene::Style dots(scene::Color color, double diameter) { return {.line = color, .marker_size = diameter}; }

scene::Layer lines(std::string title, const scene::Style& style, std::vector<geom::Polyline> all) {
  return layer(std::move(title), style, scene::Lines{std::move(all), {}});
}
scene::Layer markers(std::string title, const scene::Style& style, std::vector<geom::Point> points) {
  return layer(std::move(title), style, scene::Markers{std::move(points), {}});
}
scene::Layer regions(std::string title, const scene::Style& style, std::vector<scene::Region> all) {
  return layer(std::move(title), style, scene::Regions{std::move(all), {}});
}
scene::Layer labels(scene::Color color, std::vector<scene::Label> all, double size) {
  return layer({}, scene::Style{.line = color, .text_size = size}, scene::Labels{std::move(all)});
}

scene::Panel panel(std::string title, std::vector<scene::Layer> layers, double margin, const scene::Axes& axes) {
  scene::Panel made{.key = title, .title = std::move(title), .axes = axes, .layers = std::move(layers)};
  for (std::size_t i = 0; i < made.layers.size(); ++i) made.layers[i].key = "layer_" + std::to_string(i);
  made.extent = scene::extent(made).grown(margin);
  return made;
}

geom::Polyline chain(std::vector<geom::Point> points) { return {std::move(points), false}; }
geom::Polyline contour(std::vector<geom::Point> points) { return {std::move(points), true}; }
geom::Polyline outline(const geom::Box& box) {
  return contour({box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}});
}

std::vector<std::array<std::uint32_t, 3>> corners_of(const mesh::TriangleMesh& mesh) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const auto& [a, b, c] : mesh.triangles) {
    triangles.push_back({static_cast<std::uint32_t>(a.index()), static_cast<std::uint32_t>(b.index()),
                         static_cast<std::uint32_t>(c.index())});
  }
  return triangles;
}

scene::Layer quality_layer(const mesh::TriangleMesh& mesh) {
  scene::Mesh content{.points = mesh.points, .triangles = corners_of(mesh), .values_at = scene::ValuesAt::Triangles};
  for (const auto& [a, b, c] : mesh.triangles) {
    content.values.push_back(mesh::alpha(mesh.point(a), mesh.point(b), mesh.point(c)));
  }
  content.scale = {"quality alpha", scene::ColorMapName::Quality, 0.5, 1.0};
  return layer({}, stroke({55, 71, 79, 150}, 0.4), std::move(content));
}

scene::Layer wires(const mesh::TriangleMesh& mesh, scene::Color line, double width) {
  std::vector<geom::Polyline> edges;
  for (const auto& [a, b] : mesh::all_edges(mesh)) edges.push_back(chain({mesh.point(a), mesh.point(b)}));
  return lines({}, stroke(line, width), std::move(edges));
}

geom::Polyline cosine() {
  geom::Polyline line;
  for (int i = 0; i <= 128; ++i) {
    const double x = 4.0 * std::numbers::pi * i / 128.0;
    line.points.push_back({x, -std::cos(x)});
  }
  return line;
}

}  // namespace dobra::figures
