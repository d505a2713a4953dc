#pragma once
// Pictures that look like what the programs draw; looked at by people and read by tests of both drawers.

#include <cmath>
#include <numbers>
#include <string>

#include "shared/scene/layer.h"

namespace dobra::test {

inline geom::Polyline folded_line(double depth, double amplitude) {
  geom::Polyline line;
  for (int i = 0; i <= 120; ++i) {
    const double x = 1000.0 * i / 120.0;
    line.points.push_back({x, amplitude * std::sin(2.0 * std::numbers::pi * x / 1000.0) - depth});
  }
  return line;
}

/// A panel of four horizons with coloured beds between them and a grid; amplitude 0 is the restored one.
inline scene::Panel section_panel(const std::string& key, const std::string& title, double amplitude) {
  using namespace scene;
  const Color bed_colors[] = {{244, 222, 170}, {206, 221, 182}, {170, 196, 206}};
  const char* bed_names[] = {"sandstone", "shale", "limestone"};
  Panel panel{key, title, {"x [m]", "z [m]"}, {}, 1.0, std::nullopt};
  for (int bed = 0; bed < 3; ++bed) {
    geom::Polyline contour = geom::reversed(folded_line(100.0 * bed, amplitude));
    const geom::Polyline below = folded_line(100.0 * (bed + 1), amplitude);
    contour.points.insert(contour.points.begin(), below.points.begin(), below.points.end());
    contour.closed = true;
    panel.layers.push_back({"bed_" + std::to_string(bed), bed_names[bed],
                            Style{{90, 90, 90}, 0.0, Dash::Solid, bed_colors[bed]}, Regions{{Region{{contour}}}, {}}});
  }
  Lines grid;
  for (int i = 0; i <= 24; ++i) {
    const double x = 1000.0 * i / 24.0;
    const double z = amplitude * std::sin(2.0 * std::numbers::pi * x / 1000.0);
    grid.lines.push_back({{{x, z}, {x, z - 300.0}}, false});
  }
  for (int k = 1; k < 6; ++k) grid.lines.push_back(folded_line(50.0 * k, amplitude));
  panel.layers.push_back(
      {"grid", amplitude == 0.0 ? "target grid" : "source grid", Style{{120, 130, 140}, 0.5, Dash::Solid}, grid});
  Lines horizons;
  for (int k = 0; k < 4; ++k) horizons.lines.push_back(folded_line(100.0 * k, amplitude));
  panel.layers.push_back({"horizons", "horizons", Style{{30, 60, 110}, 1.6, Dash::Solid}, horizons});
  panel.layers.push_back(
      {"datum", "datum", Style{{190, 30, 45}, 1.2, Dash::Dashed}, Lines{{{{{0.0, 0.0}, {1000.0, 0.0}}, false}}, {}}});
  panel.layers.push_back({"pin", "pin point", Style{{190, 30, 45}, 1.0, Dash::Solid, std::nullopt, 7.0},
                          Markers{{folded_line(0.0, amplitude).points[30]}, {}}});
  panel.layers.push_back({"names", "names", Style{{30, 60, 110}},
                          Labels{{{folded_line(0.0, amplitude).points[100], "top", Anchor::Above},
                                  {folded_line(300.0, amplitude).points[100], "base", Anchor::Below}}}});
  return panel;
}

/// Before and after, side by side or one above the other.
inline scene::Picture example_section(scene::Arrangement arrangement = scene::Arrangement::Column) {
  scene::Picture picture{"Restored section", {}, arrangement};
  picture.panels.push_back(section_panel("before", "Deformed", 120.0));
  picture.panels.push_back(section_panel("after", "Restored", 0.0));
  return picture;
}

/// A quarter plate with a hole, 2 * n * n triangles, values at points or triangles between 0 and 1.
inline scene::Mesh plate_mesh(int n, scene::ValuesAt at) {
  scene::Mesh mesh;
  for (int i = 0; i <= n; ++i) {
    const double angle = 0.5 * std::numbers::pi * i / n;
    const geom::Point hole{std::cos(angle), std::sin(angle)};
    const double reach = 4.0 / std::max(hole.x, hole.y);
    for (int k = 0; k <= n; ++k) {
      const double t = std::pow(static_cast<double>(k) / n, 1.4);
      const double radius = 1.0 + t * (reach - 1.0);
      mesh.points.push_back({radius * hole.x, radius * hole.y});
      if (at == scene::ValuesAt::Points) {
        mesh.values.push_back(0.5 + 0.5 * std::cos(2.0 * angle) / (radius * radius));
      }
    }
  }
  const auto index = [n](int i, int k) { return static_cast<std::uint32_t>(i * (n + 1) + k); };
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) {
      mesh.triangles.push_back({index(i, k), index(i, k + 1), index(i + 1, k + 1)});
      mesh.triangles.push_back({index(i, k), index(i + 1, k + 1), index(i + 1, k)});
    }
  }
  if (at == scene::ValuesAt::Triangles) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      mesh.values.push_back(0.5 + 0.5 * std::sin(0.37 * static_cast<double>(i)));
    }
  }
  mesh.values_at = at;
  mesh.scale = at == scene::ValuesAt::Points
                   ? scene::Scale{"\u03c3 / \u03c3\u2080", scene::ColorMapName::Viridis, 0.0, 1.0}
                   : scene::Scale{"quality \u03b1", scene::ColorMapName::Quality, 0.0, 1.0};
  return mesh;
}

/// Two coloured meshes side by side, one with values at triangles, one at points.
inline scene::Picture example_mesh(int n = 16) {
  using namespace scene;
  Picture picture{"Quarter plate with a hole", {}, Arrangement::Row};
  Panel quality{"mesh", "Mesh", {}, {}, 1.0, std::nullopt};
  const Style style{{50, 50, 60}, 0.5};
  quality.layers.push_back({"mesh", "mesh, coloured by quality", style, plate_mesh(n, ValuesAt::Triangles)});
  Panel stress{"stress", "Stress", {}, {}, 1.0, std::nullopt};
  stress.layers.push_back({"stress", "stress", style, plate_mesh(n, ValuesAt::Points)});
  Lines arc;
  geom::Polyline line;
  for (int i = 0; i <= 60; ++i) {
    const double a = 0.5 * std::numbers::pi * i / 60;
    line.points.push_back({std::cos(a), std::sin(a)});
  }
  arc.lines.push_back(line);
  for (Panel* panel : {&quality, &stress}) {
    panel->layers.push_back({"hole", "boundary of the hole", Style{{190, 30, 45}, 2.0}, arc});
  }
  picture.panels = {quality, stress};
  return picture;
}

}  // namespace dobra::test
