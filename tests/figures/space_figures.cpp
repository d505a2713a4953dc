// Figure of projection.md.
#include <algorithm>
#include <cmath>
#include <utility>

#include "shared/render/space_file.h"
#include "shared/surf/surface.h"
#include "tests/figures/figures.h"

namespace dobra::figures {
namespace {

using scene::space::StandardView;

/// The chart of a surface in n x n cells.
scene::space::Surface cells_of(const surf::Surface& surface, std::uint32_t n) {
  std::vector<geom::Point3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  const geom::Box& chart = surface.chart();
  for (std::uint32_t j = 0; j <= n; ++j) {
    for (std::uint32_t i = 0; i <= n; ++i) {
      points.push_back(surface.at(
          {std::lerp(chart.low.x, chart.high.x, 1.0 * i / n), std::lerp(chart.low.y, chart.high.y, 1.0 * j / n)}));
    }
  }
  for (std::uint32_t j = 0; j < n; ++j) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t at = j * (n + 1) + i;
      triangles.push_back({at, at + 1, at + n + 2});
      triangles.push_back({at, at + n + 2, at + n + 1});
    }
  }
  scene::space::Surface made;
  made.points = std::move(points);
  made.triangles = std::move(triangles);
  return made;
}

}  // namespace

base::Result<void> write_projection(const std::filesystem::path& path) {
  DOBRA_TRY(const surf::Surface hill, surf::Surface::graph("3*exp(-((x-6)^2+(y-3)^2)/5) + 0.15*x", {{0, 0}, {10, 6}}));
  scene::space::Layer layer;
  layer.key = layer.title = "hill";
  layer.style.line = {60, 70, 80};
  layer.style.line_width = 0.3;
  layer.style.fill = scene::Color{150, 190, 215};
  layer.content = cells_of(hill, 20);
  scene::space::SpacePicture picture;
  picture.layers = {layer};
  std::vector<render::NamedView> views;
  for (const auto& [title, view] :
       {std::pair{"front", StandardView::Front}, std::pair{"top", StandardView::Top},
        std::pair{"right", StandardView::Right}, std::pair{"isometric", StandardView::Isometric},
        std::pair{"dimetric", StandardView::Dimetric}, std::pair{"cavalier", StandardView::Cavalier},
        std::pair{"cabinet", StandardView::Cabinet}, std::pair{"perspective", StandardView::Perspective}})
    views.push_back({title, scene::space::camera_of(view)});
  return render::write_views(picture, views, 3, path);
}

}  // namespace dobra::figures
