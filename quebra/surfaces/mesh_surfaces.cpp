#include "quebra/surfaces/mesh_surfaces.h"

#include <fmt/format.h>

#include <chrono>
#include <utility>

#include "quebra/surfaces/face_engine.h"
#include "shared/surf/mesh/assemble.h"
#include "shared/surf/trim/area.h"

namespace quebra::surfaces {

using namespace dobra;
using base::Result;
using surf::mesh::Division;
using surf::mesh::FaceMesh;

namespace {

/// Seconds since the last call.
class Stopwatch {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    return std::chrono::duration<double>(now - std::exchange(start_, now)).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// The place in the chart as the user writes it.
base::Error in_written(base::Error error, const model::SurfaceSet& set, std::size_t face) {
  if (!error.place) error.place = base::Place{};
  const geom::Vector units = set.chart_units[face];
  if (error.place->u && units.x != 0.0) *error.place->u /= units.x;
  if (error.place->v && units.y != 0.0) *error.place->v /= units.y;
  base::Place where = set.faces[face].place;
  if (where.item.empty() && !set.faces[face].name.empty())
    where.item = fmt::format("surface '{}'", set.faces[face].name);
  return base::located(std::move(error), where);
}

}  // namespace

Result<model::SurfaceMeshed> mesh_surfaces(const model::SurfaceSet& set, const SurfaceMeshOptions& options,
                                           const base::Progress& progress) {
  Stopwatch watch;
  model::SurfaceMeshed meshed;
  const auto done = [&](const char* phase) { meshed.seconds.push_back({phase, watch.lap()}); };
  for (const auto& face : set.faces) meshed.area_surface += surf::trim::area(face).value;
  done("area");
  surf::mesh::DivisionOptions divide{.sizes = options.sizes};
  if (options.engine == SurfaceEngine::Paper) divide.kind = surf::mesh::DivisionKind::Halving;
  DOBRA_TRY(const Division division, surf::mesh::divide(set.faces, divide, progress.part(0.0, 0.1)));
  meshed.findings = division.findings;
  done("divide");
  std::vector<FaceMesh> faces;
  for (std::size_t f = 0; f < division.faces.size(); ++f) {
    const double from = 0.1 + 0.8 * static_cast<double>(f) / static_cast<double>(division.faces.size());
    auto face = mesh_face(division.faces[f], options,
                          progress.part(from, from + 0.8 / static_cast<double>(division.faces.size())));
    if (!face) return in_written(face.error(), set, f);
    faces.push_back(std::move(face->mesh));
    meshed.findings.insert(meshed.findings.end(), face->findings.begin(), face->findings.end());
  }
  done("fill");
  DOBRA_TRY(meshed.mesh, surf::mesh::assemble(set.faces, division, faces));
  DOBRA_TRY_VOID(surf::mesh::check(meshed.mesh));
  done("assemble");
  meshed.quality = surf::mesh::quality_of(meshed.mesh);
  meshed.elements = surf::mesh::elements_of(meshed.mesh);
  if (options.quadrilaterals) meshed.elements = surf::mesh::recombine(meshed.elements);
  if (options.second_order) meshed.elements = surf::mesh::to_second_order(meshed.elements, set.faces, division.middles);
  DOBRA_TRY_VOID(surf::mesh::check(meshed.elements));
  done("elements");
  return meshed;
}

}  // namespace quebra::surfaces
