// 1. The minimum spanning tree is part of the Delaunay triangulation: its edges by length, joined while they join two
//    trees.
// 2. The longest path runs between the two nodes that are farthest apart in the tree (two walks find them).
// 3. Nodes beside the path go where they lengthen it least.

#include "shared/io/formats/point_order.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "shared/base/disjoint_sets.h"
#include "shared/mesh/delaunay/delaunay.h"

namespace dobra::io::formats {

using base::Error;
using base::ErrorCode;
using base::Result;
using geom::Point;

namespace {

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

struct Link {
  double length;
  std::size_t a;
  std::size_t b;
  friend auto operator<=>(const Link&, const Link&) = default;
};

using Tree = std::vector<std::vector<std::size_t>>;

std::vector<Link> candidate_links(const mesh::TriangleMesh& mesh) {
  std::vector<Link> links;
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t a = triangle[i].index();
      const std::size_t b = triangle[(i + 1) % 3].index();
      links.push_back({geom::distance(mesh.points[a], mesh.points[b]), std::min(a, b), std::max(a, b)});
    }
  }
  std::sort(links.begin(), links.end());
  links.erase(std::unique(links.begin(), links.end()), links.end());
  return links;
}

Tree spanning_tree(const mesh::TriangleMesh& mesh) {
  const std::size_t count = mesh.points.size();
  base::DisjointSets parts(count);
  Tree tree(count);
  for (const Link& link : candidate_links(mesh)) {
    if (parts.root(link.a) == parts.root(link.b)) continue;
    parts.join(link.a, link.b);
    tree[link.a].push_back(link.b);
    tree[link.b].push_back(link.a);
  }
  return tree;
}

struct Walk {
  std::vector<std::size_t> before;  // the node that each was reached from
  std::size_t farthest = 0;
};

Walk walk_from(std::size_t start, const Tree& tree, const std::vector<Point>& points) {
  Walk walk{std::vector<std::size_t>(tree.size(), none), start};
  std::vector<double> way(tree.size(), 0.0);
  std::vector<std::size_t> open{start};
  walk.before[start] = start;
  while (!open.empty()) {
    const std::size_t at = open.back();
    open.pop_back();
    if (way[at] > way[walk.farthest]) walk.farthest = at;
    for (const std::size_t next : tree[at]) {
      if (walk.before[next] != none) continue;
      walk.before[next] = at;
      way[next] = way[at] + geom::distance(points[at], points[next]);
      open.push_back(next);
    }
  }
  return walk;
}

std::vector<std::size_t> longest_path(const Tree& tree, const std::vector<Point>& points) {
  const std::size_t end = walk_from(0, tree, points).farthest;
  const Walk back = walk_from(end, tree, points);
  std::vector<std::size_t> path{back.farthest};
  while (path.back() != end) path.push_back(back.before[path.back()]);
  return path;
}

// Where `p` lengthens the path least: before which of its nodes (the path's size: behind its end).
std::size_t cheapest_place(Point p, const std::vector<std::size_t>& path, const std::vector<Point>& points) {
  std::size_t best = 0;
  double least = geom::distance(p, points[path.front()]);
  for (std::size_t i = 0; i < path.size(); ++i) {
    const bool end = i + 1 == path.size();
    const Point a = points[path[i]];
    const double longer =
        end ? geom::distance(a, p)
            : geom::distance(a, p) + geom::distance(p, points[path[i + 1]]) - geom::distance(a, points[path[i + 1]]);
    if (longer < least) least = longer, best = i + 1;
  }
  return best;
}

// Points on one straight line have no triangulation.
PointOrderFound straight_order(const std::vector<Point>& points) {
  PointOrderFound found;
  found.order.resize(points.size());
  std::iota(found.order.begin(), found.order.end(), std::size_t{0});
  std::stable_sort(found.order.begin(), found.order.end(), [&](auto a, auto b) { return points[a] < points[b]; });
  const auto same = [&](std::size_t a, std::size_t b) { return points[a] == points[b]; };
  found.order.erase(std::unique(found.order.begin(), found.order.end(), same), found.order.end());
  return found;
}

}  // namespace

Result<PointOrderFound> order_along_curve(const std::vector<Point>& points) {
  const auto triangulated = mesh::delaunay::delaunay(points);
  if (!triangulated && triangulated.error().code == ErrorCode::CannotMesh) return straight_order(points);
  if (!triangulated) return triangulated.error();
  const mesh::TriangleMesh& mesh = triangulated->mesh;
  const Tree tree = spanning_tree(mesh);
  std::vector<std::size_t> path = longest_path(tree, mesh.points);
  if (mesh.points[path.back()] < mesh.points[path.front()]) std::reverse(path.begin(), path.end());

  std::vector<bool> on_path(mesh.points.size(), false);
  for (const std::size_t node : path) on_path[node] = true;
  const std::size_t beside = mesh.points.size() - path.size();
  for (std::size_t node = 0; node < mesh.points.size(); ++node) {
    if (on_path[node]) continue;
    const Point p = mesh.points[node];
    if (10 * beside > mesh.points.size()) {
      return Error{
          ErrorCode::BadFormat,
          fmt::format("the points do not lie along one curve: {} of {} stand beside it; split them by name, or "
                      "put them in order in the file",
                      beside, mesh.points.size()),
          base::Place{.x = p.x, .y = p.y}};
    }
    const std::size_t place = cheapest_place(p, path, mesh.points);
    path.insert(path.begin() + static_cast<std::ptrdiff_t>(place), node);
  }

  std::vector<std::size_t> point_of(mesh.points.size(), none);
  for (std::size_t i = points.size(); i-- > 0;) point_of[triangulated->node_of_point[i].index()] = i;
  PointOrderFound found{{}, beside};
  for (const std::size_t node : path) found.order.push_back(point_of[node]);
  return found;
}

}  // namespace dobra::io::formats
