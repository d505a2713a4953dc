#include "quebra/surfaces/face_engine.h"

#include "shared/mesh/front/triangulate.h"
#include "shared/surf/measure.h"

namespace quebra::surfaces {

using namespace dobra;
using base::Result;

Result<surf::mesh::FaceMesh> mesh_face(const surf::mesh::ChartInput& input, const SurfaceMeshOptions& options,
                                       const base::Progress& progress) {
  const geom::Box& box = input.surface.chart();
  const geom::Point middle{0.5 * (box.low.x + box.high.x), 0.5 * (box.low.y + box.high.y)};
  const double u = surf::length(input.surface, {box.low.x, middle.y}, {box.high.x, middle.y}) / box.width();
  const double v = surf::length(input.surface, {middle.x, box.low.y}, {middle.x, box.high.y}) / box.height();
  mesh::delaunay::MeshInput scaled = input.chart;
  for (geom::Point& p : scaled.points) p = {u * p.x, v * p.y};
  for (auto& p : scaled.regions) p.at = {u * p.at.x, v * p.at.y};
  for (auto& p : scaled.holes) p = {u * p.x, v * p.y};
  for (auto& p : scaled.sizes) p.at = {u * p.at.x, v * p.at.y};
  mesh::front::MeshOptions plane;
  plane.sizes.growth = options.sizes.growth;
  plane.sizes.max_size = options.sizes.largest;
  DOBRA_TRY(auto made, mesh::front::triangulate(scaled, plane, progress));
  surf::mesh::FaceMesh face;
  for (geom::Point& p : made.points) p = {p.x / u, p.y / v};
  for (std::size_t i = 0; i < input.chart.points.size(); ++i) made.points[i] = input.chart.points[i];
  for (std::size_t i = 0; i < made.points.size(); ++i)
    face.at.push_back(i < input.at.size() ? input.at[i] : input.surface.at(made.points[i]));
  face.chart = std::move(made);
  return face;
}

}  // namespace quebra::surfaces
