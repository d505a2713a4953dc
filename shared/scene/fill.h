#pragma once
// Areas as the drawers need them: regions as triangles, meshes as areas of one colour each. For the eye only: computed
// in plain floating point, never used for geometry.

#include <array>
#include <span>
#include <vector>

#include "shared/scene/layer.h"

namespace dobra::scene {

/// Triangles that cover a region under the even-odd rule, self-crossing contours included.
/// @return  corners, three a triangle, anticlockwise. They are trapezoids beside each other, cut across the longer side
/// of
///          the region: where two of them meet, both end on one line, so no gap shows.
/// @cost    O((n + k) log n), k = places where contours cross. At most 2 (n + k) triangles.
std::vector<geom::Point> triangles_of(const Region& region);

/// Closed loops of one colour; filled under the non-zero rule.
struct ColoredArea {
  Color color{};
  std::vector<std::vector<geom::Point>> loops;
};

/// The triangles of a mesh joined into areas of equal colour: style.fill, or the scale's colours in `levels` equal
/// steps. Values at points give bands that cross the triangles. Triangles outside `window` are left out. In rising
/// order of value.
/// @cost  O(t log t), t triangles (bands: times the bands a triangle crosses).
std::vector<ColoredArea> areas_of(const Mesh& mesh, const std::optional<Color>& fill, const geom::Box& window,
                                  int levels = 64);

/// The edges of a mesh, each once, joined into long chains. @cost O(t log t).
std::vector<std::vector<std::uint32_t>> edge_chains(const Mesh& mesh);
std::vector<std::vector<std::uint32_t>> edge_chains(std::span<const std::array<std::uint32_t, 3>> triangles,
                                                    std::size_t points);

/// Mean length of the edges, m; 0 without triangles. @cost O(t).
double mean_edge_length(const Mesh& mesh);

/// Width to draw the edges of a mesh with, points: less than style.line_width where triangles are so small on the page
/// that their colour would drown in lines; 0 where they could not be told apart at all.
double edge_width(double mean_edge, const Style& style, double points_per_world);

/// Colours as written when a mesh is drawn in `levels` equal steps: the middle of the step.
Color stepped_color(const Scale& scale, double value, int levels = 64);

}  // namespace dobra::scene
