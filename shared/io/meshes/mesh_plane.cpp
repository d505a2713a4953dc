#include "shared/io/meshes/mesh_plane.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "shared/geom/box.h"

namespace dobra::io::meshes {

using base::Result;

Result<void> check_plane(std::span<const geom::Point> points, std::span<const double> heights,
                         const std::string& file) {
  constexpr double tolerance = 1e-6;
  geom::Box box;
  for (const geom::Point p : points) box.add(p);
  const double most = tolerance * std::max(box.width(), box.height());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::abs(heights[i] - heights[0]) <= most) continue;
    return base::Error{
        base::ErrorCode::BadFormat,
        fmt::format("a node lies at z = {}, others at z = {}; a mesh of elements is plane: write it in x and y, all "
                    "nodes at one z",
                    heights[i], heights[0]),
        base::Place{.file = file, .x = points[i].x, .y = points[i].y}};
  }
  return {};
}

Result<void> check_plane(const mesh::ElementMesh& mesh, std::span<const double> heights, const std::string& file) {
  std::vector<geom::Point> points;
  std::vector<double> own;
  for (const mesh::NodeId node : mesh.nodes) {
    points.push_back(mesh.points[node.index()]);
    own.push_back(heights[node.index()]);
  }
  return check_plane(points, own, file);
}

Result<bool> lies_in_space(const mesh::ElementMesh& mesh, std::span<const double> heights, const std::string& file,
                           Flatness flatness) {
  auto plane = check_plane(mesh, heights, file);
  if (plane.ok()) return false;
  if (flatness == Flatness::Any) return true;
  return plane.error();
}

}  // namespace dobra::io::meshes
