#include "shared/cli/line_picture.h"

#include <fmt/format.h>

#include <cmath>

#include "shared/base/text.h"
#include "shared/cli/pictures.h"

namespace dobra::cli {
namespace {

constexpr double points_per_metre = 72.0 / 0.0254;
constexpr double largest_page = 20.0;  ///< m; beyond, PDF readers and printers give up

scene::Style style_of(const io::Feature& feature) {
  scene::Style style;
  style.line = {40, 40, 48, 255};
  style.line_width = 1.2;
  if (feature.kind == "horizon") style.line = {28, 92, 135, 255};
  if (feature.kind == "fault") style.line = {176, 44, 36, 255};
  if (feature.type == io::FeatureType::Polygons) {
    style.fill = scene::Color{214, 196, 160, 120};
    style.line_width = 0.6;
  }
  return style;
}

scene::Layer layer_of(const io::Feature& feature, std::size_t number) {
  scene::Layer layer{.key = fmt::format("feature_{}", number),
                     .title = feature.name.empty() ? fmt::format("{}", number) : feature.name,
                     .style = style_of(feature),
                     .content = scene::Lines{feature.parts, {}}};
  if (feature.type == io::FeatureType::Points) layer.content = scene::Markers{feature.parts[0].points, {}};
  if (feature.type == io::FeatureType::Polygons) {
    scene::Regions regions;
    for (const auto& [first, last] : io::polygons_of(feature)) {
      const auto begin = feature.parts.begin();
      regions.regions.push_back(
          {{begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(last)}});
    }
    layer.content = std::move(regions);
  }
  return layer;
}

}  // namespace

scene::Picture line_picture(const io::LineWork& work) {
  scene::Panel panel;
  panel.key = "section";
  panel.axes = {base::translated("x [m]"), base::translated("z [m]")};
  // Areas lie beneath lines, lines beneath points.
  for (const auto type : {io::FeatureType::Polygons, io::FeatureType::Lines, io::FeatureType::Points}) {
    for (std::size_t i = 0; i < work.features.size(); ++i) {
      if (work.features[i].type == type) panel.layers.push_back(layer_of(work.features[i], i + 1));
    }
  }
  scene::Picture picture;
  picture.panels.push_back(std::move(panel));
  return picture;
}

base::Result<void> draw_lines(const io::LineWork& work, const std::filesystem::path& file,
                              std::optional<double> scale) {
  scene::Picture picture = line_picture(work);
  if (scale) {
    const geom::Box box = scene::extent(picture.panels[0]);
    const double metres = std::max(box.width(), box.height()) / *scale;
    if (metres > largest_page) {
      return base::Error{base::ErrorCode::CannotDraw,
                         fmt::format("at 1:{:g} the page would be {:.3g} m wide; give --scale 1:{:.0f} or smaller",
                                     *scale, metres, std::ceil(*scale * metres / largest_page))};
    }
    picture.points_per_unit = points_per_metre / *scale;
    picture.title = fmt::format("1:{:g}", *scale);
  }
  return draw(picture, file, Drawer::Cairo);
}

}  // namespace dobra::cli
