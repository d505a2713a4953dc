// check and quality_of of assemble.h.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "shared/base/disjoint_sets.h"
#include "shared/mesh/quality.h"
#include "shared/surf/mesh/assemble.h"

namespace dobra::surf::mesh {

using base::Error;
using base::ErrorCode;
using base::Result;
using geom::Point3;

namespace {

Error broken(const SurfaceMesh& mesh, std::string message, std::size_t triangle) {
  const Point3 at = mesh.point(mesh.triangles[triangle][0]);
  const geom::Point place = mesh.places[triangle][0];
  return {
      ErrorCode::CannotMesh, std::move(message),
      base::Place{
          .item = fmt::format("triangle {}", triangle), .x = at.x, .y = at.y, .z = at.z, .u = place.x, .v = place.y}};
}

/// A side of a triangle with its ends in order.
struct SideOf {
  Edge ends;
  std::uint32_t triangle;
  std::uint8_t side;
  bool forward;
};
std::vector<SideOf> sides_of(const SurfaceMesh& mesh) {
  std::vector<SideOf> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Corners& c = mesh.triangles[t];
    for (std::uint8_t i = 0; i < 3; ++i) {
      const NodeId a = c[i], b = c[(i + 1U) % 3];
      sides.push_back({a < b ? Edge{a, b} : Edge{b, a}, static_cast<std::uint32_t>(t), i, a < b});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const SideOf& a, const SideOf& b) {
    return std::pair{a.ends, a.triangle} < std::pair{b.ends, b.triangle};
  });
  return sides;
}

/// The end of the sides from `i` on that have its ends.
std::size_t end_of_run(const std::vector<SideOf>& sides, std::size_t i) {
  std::size_t end = i + 1;
  while (end < sides.size() && sides[end].ends == sides[i].ends) ++end;
  return end;
}

Result<void> check_triangles(const SurfaceMesh& mesh) {
  const std::size_t count = mesh.triangles.size();
  if (mesh.places.size() != count || mesh.faces.size() != count || mesh.regions.size() != count) {
    return Error{ErrorCode::CannotMesh, "the arrays of places, faces and regions of the mesh do not fit together"};
  }
  for (std::size_t t = 0; t < count; ++t) {
    for (const NodeId node : mesh.triangles[t]) {
      if (!node.valid() || node.index() >= mesh.points.size()) {
        return Error{ErrorCode::CannotMesh, fmt::format("triangle {} refers to a node that does not exist", t)};
      }
      if (!geom::is_finite(mesh.point(node))) {
        return Error{ErrorCode::NotFinite, fmt::format("node {} has a coordinate that is not finite", node.index())};
      }
    }
    const Corners& c = mesh.triangles[t];
    constexpr double flat = 1e-12;  // of an equilateral triangle
    if (!(dobra::mesh::alpha_in_space(mesh.point(c[0]), mesh.point(c[1]), mesh.point(c[2])) > flat)) {
      return broken(mesh, "the triangle has no area", t);
    }
  }
  return {};
}

/// The triangles at one side: no two on the same three nodes; of one face two at most, which run along it in opposite
/// ways; so do two of two faces.
Result<void> check_run(const SurfaceMesh& mesh, std::span<const SideOf> run) {
  const bool sheet = run.size() == 2;
  const auto across = [&](const SideOf& side) { return mesh.triangles[side.triangle][(side.side + 2U) % 3]; };
  for (std::size_t i = 0; i < run.size(); ++i) {
    for (std::size_t j = i + 1; j < run.size(); ++j) {
      if (across(run[i]) == across(run[j])) {
        return broken(
            mesh, fmt::format("it has the same three nodes as triangle {}: ask for a smaller size", run[i].triangle),
            run[j].triangle);
      }
      const bool one_face = mesh.faces[run[i].triangle] == mesh.faces[run[j].triangle];
      if ((!sheet && !one_face) || run[i].forward != run[j].forward) continue;
      if (!sheet) return broken(mesh, "three triangles of one face share a side", run[j].triangle);
      return broken(mesh, fmt::format("it is turned against triangle {}, with which it shares a side", run[i].triangle),
                    run[j].triangle);
    }
  }
  return {};
}

}  // namespace

Result<void> check(const SurfaceMesh& mesh) {
  DOBRA_TRY_VOID(check_triangles(mesh));
  const std::vector<SideOf> sides = sides_of(mesh);
  for (std::size_t i = 0; i < sides.size();) {
    const std::size_t end = end_of_run(sides, i);
    DOBRA_TRY_VOID(check_run(mesh, std::span(sides).subspan(i, end - i)));
    i = end;
  }
  const auto is_side = [&](const Edge& edge) {
    const Edge ends = edge[0] < edge[1] ? edge : Edge{edge[1], edge[0]};
    const auto at = std::lower_bound(sides.begin(), sides.end(), ends,
                                     [](const SideOf& side, const Edge& wanted) { return side.ends < wanted; });
    return at != sides.end() && at->ends == ends;
  };
  for (const auto* sets : {&mesh.boundary_sets, &mesh.constraint_sets}) {
    for (const auto& [name, edges] : *sets) {
      for (const Edge& edge : edges) {
        if (is_side(edge)) continue;
        const bool known = edge[0].valid() && edge[0].index() < mesh.points.size();
        const Point3 at = known ? mesh.point(edge[0]) : Point3{};
        return Error{ErrorCode::CannotMesh, fmt::format("set '{}' has a side that no triangle has", name),
                     base::Place{.x = at.x, .y = at.y, .z = at.z}};
      }
    }
  }
  return {};
}

namespace {

/// Nodes, umbrellas and parts, by joining corners and triangles across sides.
void add_topology(const SurfaceMesh& mesh, const std::vector<std::array<double, 3>>& angles, SurfaceQuality& quality) {
  const std::vector<SideOf> sides = sides_of(mesh);
  base::DisjointSets corners(3 * mesh.triangles.size()), parts(mesh.triangles.size());
  std::vector<std::uint8_t> open(3 * mesh.triangles.size(), 0);  // a corner at a side without a neighbour
  base::DisjointSets contours(mesh.points.size());
  std::vector<std::uint8_t> outer(mesh.points.size(), 0);
  std::size_t run = 0, last = 0;  // of sides of the same ends
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (i == last) run = end_of_run(sides, i) - i, last = i + run;
    const SideOf& a = sides[i];
    const std::size_t from = 3 * std::size_t{a.triangle} + a.side, to = 3 * std::size_t{a.triangle} + (a.side + 1U) % 3;
    ++quality.edges;
    if (run == 2) {
      const SideOf& b = sides[++i];
      corners.join(from, 3 * std::size_t{b.triangle} + (b.side + 1U) % 3);
      corners.join(to, 3 * std::size_t{b.triangle} + b.side);
      parts.join(a.triangle, b.triangle);
      continue;
    }
    ++quality.boundary_edges;
    open[from] = open[to] = 1;
    contours.join(a.ends[0].index(), a.ends[1].index());
    outer[a.ends[0].index()] = outer[a.ends[1].index()] = 1;
  }
  std::vector<double> sum(corners.size(), 0.0);
  std::vector<std::uint8_t> bounded(corners.size(), 0), used(mesh.points.size(), 0);
  for (std::size_t c = 0; c < corners.size(); ++c) {
    sum[corners.root(c)] += angles[c / 3][c % 3];
    bounded[corners.root(c)] |= open[c];
    used[mesh.triangles[c / 3][c % 3].index()] = 1;
  }
  std::int64_t umbrellas = 0;
  for (std::size_t c = 0; c < corners.size(); ++c) {
    if (corners.root(c) != c) continue;
    ++umbrellas;
    (bounded[c] != 0 ? quality.turning : quality.deficit) +=
        (bounded[c] != 0 ? std::numbers::pi : 2.0 * std::numbers::pi) - sum[c];
  }
  quality.nodes = static_cast<std::size_t>(std::count(used.begin(), used.end(), 1));
  quality.components = parts.set_count();
  for (std::size_t n = 0; n < outer.size(); ++n) quality.loops += outer[n] != 0 && contours.root(n) == n ? 1U : 0U;
  quality.euler = umbrellas - static_cast<std::int64_t>(quality.edges) + static_cast<std::int64_t>(quality.triangles);
  quality.gauss_bonnet =
      std::abs(quality.deficit + quality.turning - 2.0 * std::numbers::pi * static_cast<double>(quality.euler));
}

}  // namespace

SurfaceQuality quality_of(const SurfaceMesh& mesh) {
  SurfaceQuality quality;
  quality.triangles = mesh.triangles.size();
  if (mesh.triangles.empty()) return quality;
  std::vector<std::array<double, 3>> angles;
  double sum = 0.0, least = 2.0, smallest = std::numbers::pi, greatest = 0.0;
  std::size_t good = 0;
  quality.side_min = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Corners& c = mesh.triangles[t];
    const Point3 p = mesh.point(c[0]), q = mesh.point(c[1]), r = mesh.point(c[2]);
    const double shape = dobra::mesh::alpha_in_space(p, q, r);
    sum += shape;
    constexpr double good_shape = 0.90;
    good += shape >= good_shape ? 1U : 0U;
    if (shape < least) least = shape, quality.worst = TriangleId(t);
    ++quality.histogram[std::min<std::size_t>(19, static_cast<std::size_t>(20.0 * std::max(0.0, shape)))];
    angles.push_back(dobra::mesh::angles_in_space(p, q, r));
    for (const double angle : angles.back()) smallest = std::min(smallest, angle), greatest = std::max(greatest, angle);
    for (const double side : {geom::distance(p, q), geom::distance(q, r), geom::distance(r, p)}) {
      quality.side_min = std::min(quality.side_min, side);
      quality.side_max = std::max(quality.side_max, side);
    }
    quality.area += 0.5 * geom::length(cross(q - p, r - p));
  }
  const auto count = static_cast<double>(mesh.triangles.size());
  quality.alpha_mean = sum / count;
  quality.alpha_90 = static_cast<double>(good) / count;
  quality.alpha_min = least;
  quality.angle_min = base::Angle::from_radians(smallest);
  quality.angle_max = base::Angle::from_radians(greatest);
  add_topology(mesh, angles, quality);
  return quality;
}

}  // namespace dobra::surf::mesh
