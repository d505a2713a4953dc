#include "shared/scene/space/picture.h"

#include <utility>

namespace dobra::scene::space {

namespace {

using geom::Box3;
using geom::Point3;

struct Extent {
  Box3 box;
  void operator()(const Lines& content) {
    for (const std::vector<Point3>& line : content.lines) add(line);
  }
  void operator()(const Markers& content) { add(content.points); }
  void operator()(const Surface& content) { add(content.points); }
  void operator()(const Labels& content) {
    for (const Label& label : content.labels) add({label.at});
  }
  void operator()(const Curtain&) {}
  void add(const std::vector<Point3>& points) {
    for (const Point3& p : points) {
      if (geom::is_finite(p)) box.add(p);
    }
  }
};

/// One item stands for all.
struct Described {
  bool something = false;
  scene::Layer layer{};

  void operator()(const Lines& content) {
    something = !content.lines.empty();
    layer.content = scene::Lines{{geom::Polyline{{{0.0, 0.0}, {0.0, 0.0}}, false}}, {}};
  }
  void operator()(const Markers& content) {
    something = !content.points.empty();
    layer.content = scene::Markers{{{0.0, 0.0}}, {}};
  }
  void operator()(const Surface& content) {
    something = !content.triangles.empty();
    Mesh mesh;
    mesh.points = {{0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}};
    mesh.triangles = {{0, 1, 2}};
    mesh.values_at = content.values_at;
    if (content.values_at != ValuesAt::None) mesh.values = {0.0, 0.0, 0.0};
    mesh.scale = content.scale;
    layer.content = std::move(mesh);
    if (content.values_at == ValuesAt::None && !content.colors.empty()) layer.style.fill = content.colors.front();
  }
  void operator()(const Labels& content) {
    something = !content.labels.empty();
    layer.content = scene::Labels{};
  }
  void operator()(const Curtain&) {}
};

}  // namespace

Box3 extent(const Layer& layer) {
  Extent extent;
  for (const Layer& plain : unrolled(layer)) std::visit(extent, plain.content);
  return extent.box;
}

Box3 extent(const SpacePicture& picture) {
  if (picture.extent) return *picture.extent;
  Box3 visible;
  Box3 counted;
  Box3 all;
  for (const Layer& layer : picture.layers) {
    const Box3 box = extent(layer);
    all.add(box);
    if (layer.in_extent == InExtent::No) continue;
    counted.add(box);
    if (layer.visible) visible.add(box);
  }
  if (!visible.empty()) return visible;
  if (!counted.empty()) return counted;
  return all.empty() ? Box3{{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}} : all;
}

Box3 reach(const SpacePicture& picture) {
  Box3 box = extent(picture);
  for (const Layer& layer : picture.layers) {
    if (layer.visible) box.add(extent(layer));
  }
  return box;
}

std::vector<Layer> unrolled(const SpacePicture& picture) {
  std::vector<Layer> all;
  for (const Layer& layer : picture.layers) {
    for (Layer& plain : unrolled(layer)) all.push_back(std::move(plain));
  }
  return all;
}

Picture described(const SpacePicture& picture) {
  Picture made;
  made.title = picture.title;
  made.tables = picture.tables;
  made.notes = picture.notes;
  Panel panel;
  panel.key = panel_key;
  panel.axes = {"", "", AxisScale::None, 1.0};
  for (const Layer& layer : unrolled(picture)) {
    Described described;
    described.layer.style = layer.style;
    std::visit(described, layer.content);
    if (!described.something || layer.key != known_key(layer.key)) continue;
    described.layer.key = layer.key;
    described.layer.title = layer.title;
    described.layer.visible = layer.visible;
    described.layer.in_legend = layer.in_legend;
    described.layer.legend = layer.legend;
    panel.layers.push_back(std::move(described.layer));
  }
  made.panels.push_back(std::move(panel));
  return made;
}

}  // namespace dobra::scene::space
