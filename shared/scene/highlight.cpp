#include <algorithm>
#include <utility>

#include "shared/scene/pick.h"

namespace dobra::scene {

namespace {

const Color marked{0xd0, 0x10, 0x10};

std::uint32_t id_of(const std::vector<std::uint32_t>& ids, std::size_t item) {
  return item < ids.size() ? ids[item] : static_cast<std::uint32_t>(item);
}

/// The lines and points of an item.
struct Finder {
  std::uint32_t id;
  std::vector<geom::Polyline> lines;
  std::vector<geom::Point> points;

  void operator()(const Lines& content) {
    for (std::size_t i = 0; i < content.lines.size(); ++i) {
      if (id_of(content.ids, i) == id) lines.push_back(content.lines[i]);
    }
  }
  void operator()(const Markers& content) {
    for (std::size_t i = 0; i < content.points.size(); ++i) {
      if (id_of(content.ids, i) == id) points.push_back(content.points[i]);
    }
  }
  void operator()(const Regions& content) {
    for (std::size_t i = 0; i < content.regions.size(); ++i) {
      if (id_of(content.ids, i) != id) continue;
      for (const geom::Polyline& contour : content.regions[i].contours) lines.push_back({contour.points, true});
    }
  }
  void operator()(const Mesh& content) {
    if (id >= content.triangles.size()) return;
    geom::Polyline triangle{{}, true};
    for (const std::uint32_t point : content.triangles[id]) triangle.points.push_back(content.points[point]);
    lines.push_back(std::move(triangle));
  }
  void operator()(const Labels&) {}
  void operator()(const Image&) {}
};

}  // namespace

std::vector<Layer> highlight(const Panel& panel, const Pick& pick) {
  std::vector<Layer> layers;
  const auto add = [&](const char* key, auto content) {
    Layer layer;
    layer.key = key;
    layer.style.line = marked;
    layer.style.line_width = 2.5;
    layer.style.marker_size = 11.0;
    layer.in_legend = InLegend::No;
    layer.content = std::move(content);
    layers.push_back(std::move(layer));
  };
  for (const Layer& layer : panel.layers) {
    if (layer.key != pick.layer || !layer.visible) continue;
    Finder finder{pick.id, {}, {}};
    std::visit(finder, layer.content);
    if (!finder.lines.empty()) add("marked.lines", Lines{std::move(finder.lines), {}});
    if (!finder.points.empty()) add("marked.points", Markers{std::move(finder.points), {}});
  }
  return layers;
}

std::vector<std::array<std::uint32_t, 2>> rim_of(std::vector<std::array<std::uint32_t, 3>> triangles) {
  std::vector<std::array<std::uint32_t, 2>> edges;
  for (const auto& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k)
      edges.push_back({std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])});
  }
  std::sort(edges.begin(), edges.end());
  std::vector<std::array<std::uint32_t, 2>> rim;
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i;
    while (end < edges.size() && edges[end] == edges[i]) ++end;
    if ((end - i) % 2 == 1) rim.push_back(edges[i]);
    i = end;
  }
  return rim;
}

}  // namespace dobra::scene
