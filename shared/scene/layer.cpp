#include "shared/scene/layer.h"

#include <algorithm>

namespace dobra::scene {
namespace {

struct ExtentOf {
  geom::Box operator()(const Lines& content) const {
    geom::Box box;
    for (const geom::Polyline& line : content.lines) box.add(line.box());
    return box;
  }
  geom::Box operator()(const Markers& content) const { return geom::box_of(content.points); }
  geom::Box operator()(const Regions& content) const {
    geom::Box box;
    for (const Region& region : content.regions) {
      for (const geom::Polyline& contour : region.contours) box.add(contour.box());
    }
    return box;
  }
  geom::Box operator()(const Mesh& content) const { return geom::box_of(content.points); }
  geom::Box operator()(const Labels& content) const {
    geom::Box box;
    for (const Label& label : content.labels) box.add(label.at);
    return box;
  }
  geom::Box operator()(const Image& content) const { return content.box; }
};

struct IsEmpty {
  bool operator()(const Lines& content) const {
    return std::ranges::all_of(content.lines, [](const geom::Polyline& line) { return line.points.empty(); });
  }
  bool operator()(const Markers& content) const { return content.points.empty(); }
  bool operator()(const Regions& content) const {
    return std::ranges::all_of(content.regions, [](const Region& region) {
      return std::ranges::all_of(region.contours, [](const geom::Polyline& line) { return line.points.empty(); });
    });
  }
  bool operator()(const Mesh& content) const { return content.points.empty(); }
  bool operator()(const Labels& content) const { return content.labels.empty(); }
  bool operator()(const Image& content) const { return content.box.empty(); }
};

}  // namespace

bool is_empty(const Layer& layer) { return std::visit(IsEmpty{}, layer.content); }

geom::Box extent(const Layer& layer) { return std::visit(ExtentOf{}, layer.content); }

geom::Box extent(const Panel& panel) {
  if (panel.extent) return *panel.extent;
  geom::Box box;
  for (const Layer& layer : panel.layers) {
    if (layer.visible) box.add(extent(layer));
  }
  return box;
}

}  // namespace dobra::scene
