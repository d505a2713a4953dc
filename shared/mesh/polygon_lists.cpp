#include "shared/mesh/polygon_lists.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "shared/base/check.h"

namespace dobra::mesh {
namespace {

using base::Error;
using base::ErrorCode;
using geom::Point3;
using Index = std::uint32_t;

/// Numbers of the points from their least x to their greatest.
std::vector<Index> along_x(const std::vector<Point3>& points) {
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    const Point3& p = points[a];
    const Point3& q = points[b];
    if (p.x != q.x) return p.x < q.x;
    if (p.y != q.y) return p.y < q.y;
    if (p.z != q.z) return p.z < q.z;
    return a < b;
  });
  return order;
}

class Groups {
 public:
  explicit Groups(std::size_t n) : root_(n) { std::iota(root_.begin(), root_.end(), 0U); }
  Index find(Index i) {
    while (root_[i] != i) i = root_[i] = root_[root_[i]];
    return i;
  }
  void join(Index a, Index b) {
    a = find(a);
    b = find(b);
    root_[std::max(a, b)] = std::min(a, b);  // the root is the first of all
  }

 private:
  std::vector<Index> root_;
};

Error bad(std::size_t face, const std::string& what) {
  return {ErrorCode::BadFormat, fmt::format("face {}: {}", face, what)};
}

}  // namespace

std::vector<Index> merged_points(const std::vector<Point3>& points, double tolerance) {
  DOBRA_CHECK(tolerance >= 0.0);
  Groups groups(points.size());
  const std::vector<Index> order = along_x(points);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Point3& p = points[order[i]];
    for (std::size_t j = i + 1; j < order.size() && points[order[j]].x - p.x <= tolerance; ++j) {
      const Point3& q = points[order[j]];
      if (tolerance == 0.0 && q.y != p.y) break;  // sorted: equal places stand together
      if (p == q || distance(p, q) <= tolerance) groups.join(order[i], order[j]);
      if (tolerance == 0.0 && p != q) break;
    }
  }
  std::vector<Index> first(points.size());
  for (Index i = 0; i < first.size(); ++i) first[i] = groups.find(i);
  return first;
}

ExplicitPolygons explicit_polygons(const PolygonMesh& mesh) {
  ExplicitPolygons polygons;
  polygons.reserve(mesh.faces.size());
  for (const auto& face : mesh.faces) {
    auto& polygon = polygons.emplace_back();
    for (const Index corner : face) polygon.push_back(mesh.points[corner]);
  }
  return polygons;
}

PolygonMesh with_points(const ExplicitPolygons& polygons, double tolerance) {
  std::vector<Point3> all;
  for (const auto& polygon : polygons) all.insert(all.end(), polygon.begin(), polygon.end());
  const std::vector<Index> first = merged_points(all, tolerance);
  PolygonMesh mesh;
  std::vector<Index> number(all.size());
  Index at = 0;
  for (const auto& polygon : polygons) {
    auto& face = mesh.faces.emplace_back();
    for (std::size_t i = 0; i < polygon.size(); ++i, ++at) {
      if (first[at] == at) {
        number[at] = static_cast<Index>(mesh.points.size());
        mesh.points.push_back(all[at]);
      }
      face.push_back(number[first[at]]);
    }
  }
  return mesh;
}

EdgeListMesh with_edges(const PolygonMesh& mesh) {
  EdgeListMesh list{mesh.points, edges_of(mesh), {}};
  const auto less = [](const PolygonEdge& e, const PolygonEdge& f) {
    return std::pair(e.a, e.b) < std::pair(f.a, f.b);
  };
  for (const auto& face : mesh.faces) {
    auto& uses = list.faces.emplace_back();
    for (std::size_t i = 0; i < face.size(); ++i) {
      const auto [a, b] = std::minmax(face[i], face[(i + 1) % face.size()]);
      const auto edge = std::lower_bound(list.edges.begin(), list.edges.end(), PolygonEdge{a, b, {}}, less);
      uses.push_back({static_cast<Index>(edge - list.edges.begin()), face[i] != a});
    }
  }
  return list;
}

base::Result<PolygonMesh> with_points(const EdgeListMesh& list) {
  PolygonMesh mesh{list.points, {}};
  for (std::size_t f = 0; f < list.faces.size(); ++f) {
    const auto& uses = list.faces[f];
    auto& face = mesh.faces.emplace_back();
    for (const EdgeUse& use : uses) {
      if (use.edge >= list.edges.size())
        return bad(f, fmt::format("edge {} does not exist ({} edges)", use.edge, list.edges.size()));
      const PolygonEdge& edge = list.edges[use.edge];
      if (edge.a >= list.points.size() || edge.b >= list.points.size())
        return bad(f, fmt::format("edge {} ends at a point that does not exist", use.edge));
      if (std::find(edge.faces.begin(), edge.faces.end(), f) == edge.faces.end())
        return bad(f, fmt::format("it passes edge {}, which does not name it", use.edge));
      face.push_back(use.backwards ? edge.b : edge.a);
    }
    for (std::size_t i = 0; i < uses.size(); ++i) {
      const PolygonEdge& edge = list.edges[uses[i].edge];
      const Index target = uses[i].backwards ? edge.a : edge.b;
      if (target == face[(i + 1) % face.size()]) continue;
      return bad(f, fmt::format("edge {} ends at point {}, and the edge after it, {}, begins at point {}", uses[i].edge,
                                target, uses[(i + 1) % uses.size()].edge, face[(i + 1) % face.size()]));
    }
  }
  for (std::size_t e = 0; e < list.edges.size(); ++e) {
    for (const Index f : list.edges[e].faces) {
      const bool passed = f < list.faces.size() && std::any_of(list.faces[f].begin(), list.faces[f].end(),
                                                               [&](const EdgeUse& use) { return use.edge == e; });
      if (!passed) return bad(f, fmt::format("edge {} names it, and it does not pass that edge", e));
    }
  }
  return mesh;
}

}  // namespace dobra::mesh
