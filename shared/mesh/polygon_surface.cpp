#include "shared/mesh/polygon_surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <span>

#include "shared/mesh/polygon_repair.h"
#include "shared/mesh/quality.h"

namespace dobra::mesh {
namespace {

using geom::Point3;
using geom::Vector3;
using Index = std::uint32_t;

Point3 middle(std::span<const Point3> corners) {
  Vector3 sum{};
  for (const Point3 p : corners) sum = sum + (p - corners[0]);
  return corners[0] + sum / static_cast<double>(corners.size());
}

double longest_side(std::span<const Point3> corners) {
  double longest = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    longest = std::max(longest, distance(corners[i], corners[(i + 1) % corners.size()]));
  return longest;
}

/// The mesh without faces of bad corners, each with its number in the mesh as it was given.
struct Usable {
  PolygonMesh mesh;
  std::vector<Index> number;
};

Usable usable_faces(const PolygonMesh& given) {
  Usable usable{{given.points, {}}, {}};
  for (Index f = 0; f < given.faces.size(); ++f) {
    const auto& face = given.faces[f];
    const bool good = face.size() >= 3 && std::all_of(face.begin(), face.end(), [&](Index corner) {
                        return corner < given.points.size() && is_finite(given.points[corner]);
                      });
    if (!good) continue;
    usable.mesh.faces.push_back(face);
    usable.number.push_back(f);
  }
  return usable;
}

void measure(const Usable& usable, double thin, PolygonSurface& told) {
  std::vector<Point3> corners;
  for (std::size_t f = 0; f < usable.mesh.faces.size(); ++f) {
    corners.clear();
    for (const Index corner : usable.mesh.faces[f]) corners.push_back(usable.mesh.points[corner]);
    const double area = length(newell_area(corners) - Point3{}), side = longest_side(corners);
    told.area += area;
    if (area <= thin * side * side)
      told.faults.push_back({fmt::format("face {} has no area", usable.number[f]), middle(corners)});
    if (corners.size() != 3) continue;
    const double alpha = alpha_in_space(corners[0], corners[1], corners[2]);
    if (told.triangles++ == 0 || alpha < told.alpha_min) told.alpha_min = alpha, told.worst = middle(corners);
  }
}

/// Faces whose corners an earlier one has too, by their places: those at one place may be several points.
void find_repeats(const Usable& usable, const std::vector<Index>& first_at, PolygonSurface& told) {
  std::map<std::vector<Index>, Index> seen;
  for (std::size_t f = 0; f < usable.mesh.faces.size(); ++f) {
    std::vector<Index> key;
    std::vector<Point3> corners;
    for (const Index corner : usable.mesh.faces[f]) {
      key.push_back(first_at[corner]);
      corners.push_back(usable.mesh.points[corner]);
    }
    std::sort(key.begin(), key.end());
    const auto [before, fresh] = seen.try_emplace(std::move(key), usable.number[f]);
    if (fresh) continue;
    told.faults.push_back(
        {fmt::format("face {} has the corners of face {}: it is given twice", usable.number[f], before->second),
         middle(corners)});
  }
}

/// Of each point the first one at its place.
std::vector<Index> first_at_place(const PolygonMesh& mesh, PolygonSurface& told) {
  std::map<std::array<double, 3>, Index> at;
  std::vector<Index> first(mesh.points.size());
  for (Index p = 0; p < mesh.points.size(); ++p) {
    const Point3 q = mesh.points[p];
    first[p] = p;
    if (!is_finite(q)) continue;
    // Adding nought makes -0 the same place as 0.
    first[p] = at.try_emplace({q.x + 0.0, q.y + 0.0, q.z + 0.0}, p).first->second;
    if (first[p] != p) ++told.shared_places;
  }
  return first;
}

void count_borders(const PolygonMesh& mesh, PolygonSurface& told) {
  std::vector<Index> root(mesh.points.size());
  std::iota(root.begin(), root.end(), 0U);
  const auto find = [&](Index i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  std::vector<Index> on_border;
  for (const PolygonEdge& edge : edges_of(mesh)) {
    if (edge.faces.size() != 1) continue;
    ++told.open_edges;
    root[find(edge.a)] = find(edge.b);
    on_border.push_back(edge.a), on_border.push_back(edge.b);
  }
  std::sort(on_border.begin(), on_border.end());
  on_border.erase(std::unique(on_border.begin(), on_border.end()), on_border.end());
  told.borders = static_cast<std::size_t>(
      std::count_if(on_border.begin(), on_border.end(), [&](Index p) { return find(p) == p; }));
}

}  // namespace

PolygonSurface surface_of(const PolygonMesh& mesh, Closedness closedness, double thin) {
  PolygonSurface told;
  const PolygonReport found = report(mesh, closedness);
  told.parts = found.parts;
  for (std::size_t i = 0; i < found.findings.size(); ++i)
    told.faults.push_back({found.findings[i].message, found.places[i]});
  const Usable usable = usable_faces(mesh);
  const std::vector<Index> first_at = first_at_place(mesh, told);
  measure(usable, thin, told);
  find_repeats(usable, first_at, told);
  count_borders(usable.mesh, told);
  return told;
}

}  // namespace dobra::mesh
