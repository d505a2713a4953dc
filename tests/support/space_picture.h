#pragma once
// Pictures in space for tests.

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "shared/scene/space/picture.h"

namespace dobra::test {

/// A square of 2 m about the origin that faces the viewer of the front view.
inline scene::space::Layer colored_square(const scene::Color& color) {
  scene::space::Surface surface;
  surface.points = {{-1.0, 0.0, -1.0}, {1.0, 0.0, -1.0}, {1.0, 0.0, 1.0}, {-1.0, 0.0, 1.0}};
  surface.triangles = {{0, 1, 2}, {0, 2, 3}};
  scene::space::Layer layer;
  layer.key = layer.title = "square";
  layer.style.fill = color;
  layer.style.line_width = 0.0;
  layer.content = surface;
  return layer;
}

/// z(x, y) over 4 km x 3 km in n x n cells, with the heights as values and its place in a unit square.
inline scene::space::Surface hills(std::size_t n) {
  std::vector<geom::Point3> points;
  std::vector<geom::Point> chart;
  std::vector<double> values;
  for (std::size_t j = 0; j <= n; ++j) {
    for (std::size_t i = 0; i <= n; ++i) {
      const double u = static_cast<double>(i) / static_cast<double>(n);
      const double v = static_cast<double>(j) / static_cast<double>(n);
      const double z = 300.0 * std::sin(5.0 * u) * std::cos(4.0 * v) + 200.0 * u;
      points.push_back({4000.0 * u, 3000.0 * v, z});
      chart.push_back({u, v});
      values.push_back(z);
    }
  }
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = 0; i < n; ++i) {
      const auto at = static_cast<std::uint32_t>(j * (n + 1) + i);
      const auto up = static_cast<std::uint32_t>(at + n + 1);
      triangles.push_back({at, at + 1, up + 1});
      triangles.push_back({at, up + 1, up});
    }
  }
  scene::space::Surface surface;
  surface.points = std::move(points);
  surface.chart = std::move(chart);
  surface.triangles = std::move(triangles);
  surface.values = std::move(values);
  surface.values_at = scene::ValuesAt::Points;
  surface.scale.title = "z [m]";
  surface.scale.low = -300.0;
  surface.scale.high = 500.0;
  return surface;
}

/// Hills, a well with a name, wells as markers, and a section on a curtain.
inline scene::space::SpacePicture space_picture(std::size_t n) {
  using namespace scene::space;
  Layer top;
  top.key = "top";
  top.title = "Top of the sand";
  top.style.line = {40, 40, 40};
  top.style.line_width = 0.4;
  top.content = hills(n);
  Layer well;
  well.key = "well";
  well.title = "Well";
  well.style.line = {180, 20, 20};
  well.style.line_width = 2.0;
  well.content = Lines{{{{3000.0, 800.0, 900.0}, {3000.0, 800.0, -600.0}}}, {}};
  Layer heads;
  heads.key = "heads";
  heads.title = "Well heads";
  heads.style.line = {20, 60, 160};
  heads.style.marker_size = 7.0;
  heads.content = Markers{{{3000.0, 800.0, 900.0}, {500.0, 500.0, 700.0}}, {4, 5}};
  Layer names;
  names.key = "names";
  names.content = Labels{{{{3000.0, 800.0, 900.0}, "W-1", scene::Anchor::Above}}};
  Layer section;
  section.key = "section";
  section.title = "Section";
  Curtain curtain{{{0.0, 2500.0}, {2500.0, 3400.0}, {4000.0, 3400.0}}, 0.0, {}};
  scene::Layer unit;
  unit.key = "unit";
  unit.title = "Shale";
  unit.style.fill = scene::Color{150, 170, 120};
  unit.content = scene::Regions{
      {{{{{{0.0, -900.0}, {4100.0, -900.0}, {4100.0, -500.0}, {2000.0, -300.0}, {0.0, -600.0}}, true}}}}, {}};
  scene::Layer fault;
  fault.key = "fault";
  fault.title = "Fault";
  fault.style.line_width = 1.5;
  fault.style.dash = scene::Dash::Dashed;
  fault.content = scene::Lines{{{{{1000.0, -900.0}, {3600.0, 300.0}}, false}}, {}};
  curtain.section.layers = {unit, fault};
  section.content = curtain;
  SpacePicture picture;
  picture.title = "Hills over a section";
  picture.layers = {top, well, heads, names, section};
  picture.vertical_exaggeration = 1.5;
  picture.notes = {"Made up for tests."};
  picture.camera = camera_of(StandardView::Isometric);
  return picture;
}

}  // namespace dobra::test
