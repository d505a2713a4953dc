#pragma once
// What helps to see a surface, beside its mesh: lines of constant u and v, normals, the points that it is given by, its
// parts as areas. Page: docs/user/space_view.md.

#include <cstdint>
#include <vector>

#include "quebra/core/drawn_chart.h"
#include "quebra/model/surface_meshed.h"
#include "shared/scene/space/picture.h"

namespace quebra::core {

/// Lines of constant u or v where they run over triangles of the mesh. Items are lines of all faces, numbered alike in
/// space and in charts.
struct Isocurve {
  std::size_t face = 0;
  std::uint32_t item = 0;
  std::vector<dobra::geom::Point3> line;
  std::vector<dobra::geom::Point> chart;
};
/// So many lines each way divide the range of each chart in equal parts. @cost O(triangles)
std::vector<Isocurve> isocurves(const dobra::surf::mesh::SurfaceMesh& mesh,
                                const std::vector<dobra::surf::trim::TrimmedSurface>& faces, int each_way = 9);

/// From the middles of at most `most` triangles, evenly through their list, as long as the mean of the sides; away from
/// where the triangles are anticlockwise.
std::vector<std::vector<dobra::geom::Point3>> normals(const dobra::surf::mesh::SurfaceMesh& mesh,
                                                      std::size_t most = 500);

/// What loops enclose in a chart, as triangles on the surface: to be looked at and clicked, not to compute with. Empty
/// where the loops do not close in the chart, as all round a cylinder.
dobra::scene::space::Surface area_of(const dobra::surf::Surface& surface,
                                     const std::vector<dobra::surf::trim::ChartLoop>& loops, std::uint32_t item);
/// The same of parts by a grid over the chart, whatever their loops are; of all the chart where there are no parts.
/// @cost that of Recognised::pick for each cell
dobra::scene::space::Surface area_of_parts(const dobra::surf::Surface& surface, const model::SurfaceParts* parts,
                                           std::uint32_t item);
/// The same as an area of the drawn chart.
dobra::scene::Region region_of(const std::vector<dobra::surf::trim::ChartLoop>& loops, const DrawnChart& chart);

/// The points by which curves and surfaces are given, and the lines between them; for the user to switch on.
void add_controls(const model::SurfaceSet& set, std::vector<dobra::scene::space::Layer>& layers);

inline constexpr const char* controls_layer = "controls";
inline constexpr const char* isocurves_layer = "isocurves";
inline constexpr const char* normals_layer = "normals";
inline constexpr const char* left_out_layer = "left_out";
inline constexpr const char* faces_layer = "faces";  ///< Before there is a mesh.

}  // namespace quebra::core
