#pragma once
// From imported faces to one mesh, as the program does it: opened at poles, divided, filled, joined and checked.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "shared/surf/mesh/assemble.h"
#include "shared/surf/mesh/chart_mesher.h"
#include "shared/surf/mesh/division.h"
#include "shared/surf/trim/open.h"

namespace dobra::support {

struct MeshedFaces {
  std::optional<base::Error> refused;  ///< Why there is no mesh; u and v of its place are those of the face.
  surf::mesh::SurfaceQuality quality;
  double turned = 0.0;  ///< Greatest angle between a triangle's normal and its surface's, degrees.
};

/// The greatest angle between the normal of a triangle and that of its surface at its middle.
inline double turned_by(const surf::mesh::SurfaceMesh& whole, const std::vector<surf::trim::TrimmedSurface>& parts) {
  double turned = 0.0;
  for (std::size_t i = 0; i < whole.triangles.size(); ++i) {
    const auto& places = whole.places[i];
    const geom::Point middle{(places[0].x + places[1].x + places[2].x) / 3.0,
                             (places[0].y + places[1].y + places[2].y) / 3.0};
    const auto normal = surf::normal(parts[whole.faces[i]].surface, middle);
    const auto& corners = whole.triangles[i];
    geom::Vector3 own =
        cross(whole.point(corners[1]) - whole.point(corners[0]), whole.point(corners[2]) - whole.point(corners[0]));
    if (parts[whole.faces[i]].reversed) own = -own;
    if (!normal || !(geom::length(own) > 0.0)) continue;
    const double cosine = std::clamp(dot(*normal, own) / geom::length(own), -1.0, 1.0);
    turned = std::max(turned, std::acos(cosine) * 180.0 / std::numbers::pi);
  }
  return turned;
}

/// An error of a part, with its place in the chart of the face that the part is of.
inline base::Error in_chart_of_face(base::Error error, const surf::trim::Opened& part) {
  if (!part.polar || !error.place || !error.place->u || !error.place->v) return error;
  const geom::Point uv = part.back({*error.place->u, *error.place->v});
  error.place->u = uv.x;
  error.place->v = uv.y;
  return error;
}

inline MeshedFaces mesh_faces(const std::vector<surf::trim::TrimmedSurface>& faces, double size, double turn = 10.0) {
  namespace sm = surf::mesh;
  std::vector<surf::trim::TrimmedSurface> parts;
  std::vector<surf::trim::Opened> all_opened;
  surf::trim::SharedNumbers numbers;
  for (const surf::trim::TrimmedSurface& face : faces) {
    const auto opened = surf::trim::open(face, numbers);
    if (!opened) return {opened.error(), {}};
    for (const surf::trim::Opened& part : *opened) {
      parts.push_back(part.face);
      all_opened.push_back(part);
    }
  }
  sm::SizeOptions sizes;
  sizes.largest = size;
  sizes.turn = turn;
  const auto division = sm::divide(parts, {.sizes = sizes});
  if (!division) return {division.error(), {}};
  std::vector<sm::FaceMesh> meshes;
  for (const sm::ChartInput& input : division->faces) {
    auto mesh = sm::mesh_chart(input, {.sizes = sizes});
    if (!mesh) return {in_chart_of_face(mesh.error(), all_opened[meshes.size()]), {}};
    meshes.push_back(*std::move(mesh));
  }
  const auto whole = sm::assemble(parts, *division, meshes);
  if (!whole) return {whole.error(), {}};
  if (const auto fine = sm::check(*whole); !fine) return {fine.error(), {}};
  return {std::nullopt, sm::quality_of(*whole), turned_by(*whole, parts)};
}

}  // namespace dobra::support
