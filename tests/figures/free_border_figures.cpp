// Figure of free_borders.md.
#include <numbers>

#include "shared/mesh/quality.h"
#include "shared/surf/mesh/chart_mesher.h"
#include "shared/surf/mesh/free_borders.h"
#include "shared/surf/trim/open.h"
#include "tests/figures/figures.h"
#include "tests/support/surface_stand_ins.h"

namespace dobra::figures {
namespace {

using geom::Point;
using surf::mesh::SurfaceMesh;

/// The half that is turned to the viewer, who looks along y; the sides of the set in red.
scene::Panel from_front(std::string title, const SurfaceMesh& mesh) {
  scene::Mesh drawn{.values_at = scene::ValuesAt::Triangles};
  std::vector<Point> points;
  std::vector<std::array<std::uint32_t, 3>> corners;
  std::vector<double> values;
  for (const geom::Point3 p : mesh.points) points.push_back({p.x, p.z});
  for (const auto& c : mesh.triangles) {
    const geom::Point3 p = mesh.point(c[0]), q = mesh.point(c[1]), r = mesh.point(c[2]);
    if (cross(q - p, r - p).y >= 0.0) continue;
    const auto index = [&](std::size_t i) { return static_cast<std::uint32_t>(c[i].index()); };
    corners.push_back({index(0), index(1), index(2)});
    values.push_back(mesh::alpha_in_space(p, q, r));
  }
  std::vector<geom::Polyline> cut;
  const auto sides = mesh.constraint_sets.find(surf::trim::artificial_border);
  if (sides != mesh.constraint_sets.end()) {
    for (const auto& side : sides->second) {
      const geom::Point3 p = mesh.point(side[0]), q = mesh.point(side[1]);
      if (p.y + q.y < 0.0) cut.push_back(chain({{p.x, p.z}, {q.x, q.z}}));
    }
  }
  drawn.points = std::move(points);
  drawn.triangles = std::move(corners);
  drawn.values = std::move(values);
  drawn.scale = {"alpha", scene::ColorMapName::Quality, 0.0, 1.0};
  const scene::Layer triangles{{}, {}, stroke({55, 71, 79, 120}, 0.3), std::move(drawn), true, InLegend::No};
  return panel(std::move(title), {triangles, lines({}, stroke(red, 1.5), std::move(cut))}, 0.1,
               {"", "", scene::AxisScale::None});
}

base::Result<scene::Picture> free_borders() {
  namespace shapes = surf::test::stand_in;
  using std::numbers::pi;
  DOBRA_TRY(const surf::Surface sphere, surf::Surface::sphere({}, 5.0, {{0.0, -0.5 * pi}, {2.0 * pi, 0.5 * pi}}));
  surf::trim::SharedNumbers numbers;
  // A hole that the equator passes near its edge, so that the cut leaves narrow corners beside it.
  const surf::trim::ChartLoop hole = shapes::ellipse_hole({1.5 * pi, 0.21}, 0.45, 0.25);
  DOBRA_TRY(const auto opened, surf::trim::open({sphere, {shapes::rectangle(sphere.chart()), hole}}, numbers));
  std::vector<surf::trim::TrimmedSurface> charts;
  for (const auto& part : opened) charts.push_back(part.face);
  const surf::mesh::SizeOptions sizes{.largest = 1.1, .turn = 20.0};
  DOBRA_TRY(const surf::mesh::Division division, surf::mesh::divide(charts, {.sizes = sizes}));
  std::vector<surf::mesh::FaceMesh> faces;
  for (const auto& input : division.faces) {
    DOBRA_TRY(surf::mesh::FaceMesh face, surf::mesh::mesh_chart(input, {.sizes = sizes}));
    faces.push_back(std::move(face));
  }
  DOBRA_TRY(SurfaceMesh mesh, surf::mesh::assemble(charts, division, faces));
  scene::Picture picture;
  picture.panels.push_back(from_front("joined", mesh));
  const std::vector<std::size_t> owner(charts.size(), 0);
  surf::mesh::free_borders(mesh, charts, owner, surf::trim::artificial_border);
  picture.panels.push_back(from_front("freed", mesh));
  return picture;
}

}  // namespace

std::vector<Figure> free_border_figures() { return {{"free_borders", free_borders}}; }

}  // namespace dobra::figures
