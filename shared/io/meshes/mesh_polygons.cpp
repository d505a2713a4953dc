#include "shared/io/meshes/mesh_polygons.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "shared/geom/polyline.h"

namespace dobra::io::meshes {

using base::Error;
using base::ErrorCode;
using base::Result;
using geom::Point;
using mesh::ElementId;
using mesh::ElementMesh;
using mesh::ElementSide;
using mesh::ElementType;
using mesh::NodeId;
using mesh::PolygonMesh;

PolygonMesh polygons_of(const ElementMesh& mesh, Heights heights) {
  constexpr auto none = static_cast<std::uint32_t>(-1);
  std::vector<std::uint32_t> number(mesh.points.size(), none);
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    for (const NodeId node : mesh.nodes_of(ElementId(e)).first(corner_count(mesh.types[e]))) number[node.index()] = 0;
  }
  PolygonMesh polygons;
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (number[i] == none) continue;
    number[i] = static_cast<std::uint32_t>(polygons.points.size());
    polygons.points.push_back({mesh.points[i].x, mesh.points[i].y, height(heights, i)});
  }
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    auto& face = polygons.faces.emplace_back();
    for (const NodeId node : mesh.nodes_of(ElementId(e)).first(corner_count(mesh.types[e])))
      face.push_back(number[node.index()]);
  }
  return polygons;
}

Result<ElementMesh> elements_of(const PolygonMesh& polygons, const std::string& file) {
  const auto wrong = [&](std::string message) {
    return Error{ErrorCode::BadFormat, std::move(message), base::Place{.file = file}};
  };
  std::vector<std::optional<NodeId>> number(polygons.points.size());
  ElementMesh mesh;
  mesh.first.push_back(0);
  for (std::size_t f = 0; f < polygons.faces.size(); ++f) {
    const auto& face = polygons.faces[f];
    if (face.size() != 3 && face.size() != 4) {
      return wrong(fmt::format("face {} has {} corners; elements are triangles and quadrilaterals", f, face.size()));
    }
    std::vector<NodeId> nodes;
    for (const std::uint32_t corner : face) {
      const geom::Point3& p = polygons.points[corner];
      if (p.z != polygons.points[polygons.faces[0][0]].z)
        return wrong(fmt::format("point {} lies outside the plane of the first; a mesh of elements is plane", corner));
      if (!number[corner]) {
        number[corner] = NodeId(mesh.points.size());
        mesh.points.push_back({p.x, p.y});
      }
      nodes.push_back(*number[corner]);
    }
    add_element(mesh, face.size() == 3 ? ElementType::T3 : ElementType::Q4, nodes, 1);
  }
  if (auto good = check(mesh); !good) return base::located(good.error(), {.file = file});
  return mesh;
}

namespace {

using Link = std::array<std::uint32_t, 2>;

/// A point strictly inside a simple contour: beside its lowest left corner.
Point point_inside(const geom::Polyline& contour) {
  const auto& points = contour.points;
  const std::size_t n = points.size();
  const auto corner = static_cast<std::size_t>(std::min_element(points.begin(), points.end()) - points.begin());
  const Point v = points[corner], a = points[(corner + n - 1) % n], b = points[(corner + 1) % n];
  const double turn = cross(b - a, v - a);
  const auto in_triangle = [&](Point p) {
    const auto side = [&](Point from, Point to) { return cross(to - from, p - from) * turn; };
    return side(a, b) > 0.0 && side(b, v) >= 0.0 && side(v, a) >= 0.0;
  };
  // The corner inside the triangle that is farthest from its base is seen from v.
  Point best = midpoint(a, b);
  double far = 0.0;
  for (const Point p : points) {
    if (p == a || p == b || p == v || !in_triangle(p)) continue;
    const double height = std::abs(cross(b - a, p - a));
    if (height > far) {
      far = height;
      best = p;
    }
  }
  return midpoint(v, best);
}

/// Builds the graph; nodes at one place, as those of two lips, are one.
class Graph {
 public:
  explicit Graph(const ElementMesh& mesh) : mesh_(mesh) {}

  PolyFile run() {
    std::map<ElementSide, std::int64_t> marker;
    std::int64_t set = 0;
    for (const auto& [name, sides] : mesh_.side_sets) {
      ++set;
      for (const ElementSide& side : sides) marker.emplace(side, set);
    }
    std::vector<Link> rim;
    for (const ElementSide& side : boundary_sides(mesh_)) {
      const auto known = marker.find(side);
      rim.push_back(add(side, known == marker.end() ? 0 : known->second));
    }
    for (const auto& [side, number] : marker) add(side, number);
    add_holes(rim);
    add_regions();
    return std::move(poly_);
  }

 private:
  std::uint32_t node(NodeId id) {
    const auto [at, is_new] =
        number_.try_emplace(mesh_.point(id), static_cast<std::uint32_t>(poly_.nodes.points.size()));
    if (is_new) poly_.nodes.points.push_back(mesh_.point(id));
    return at->second;
  }
  Link add(const ElementSide& side, std::int64_t marker) {
    const auto nodes = side_nodes(mesh_, side);
    const Link link{node(nodes[0]), node(nodes[1])};
    if (known_.insert(std::minmax(link[0], link[1])).second) {
      poly_.segments.push_back(link);
      poly_.segment_markers.push_back(marker);
    }
    return link;
  }

  /// Loops of the rim with the material outside; where loops touch, the way on is the one most to the right, round the
  /// hole.
  void add_holes(const std::vector<Link>& rim) {
    std::set<Link> open;
    std::set<Link> both(rim.begin(), rim.end());
    for (const Link& link : rim) {
      if (!both.contains({link[1], link[0]})) open.insert(link);
    }
    while (!open.empty()) {
      geom::Polyline loop{{}, true};
      const Link start = *open.begin();
      // It stays open until the walk is back: where loops touch, the way on may be the one that it began with.
      std::optional<Link> at = start;
      do {
        if (*at != start) open.erase(*at);
        loop.points.push_back(poly_.nodes.points[(*at)[0]]);
        at = next(*at, open);
      } while (at && *at != start);
      open.erase(start);
      if (signed_area(loop) < 0.0) poly_.holes.push_back(point_inside(loop));
    }
  }
  [[nodiscard]] std::optional<Link> next(const Link& link, const std::set<Link>& open) const {
    const auto& points = poly_.nodes.points;
    const geom::Vector along = points[link[1]] - points[link[0]];
    std::optional<Link> best;
    double most_right = 0.0;
    for (auto other = open.lower_bound({link[1], 0}); other != open.end() && (*other)[0] == link[1]; ++other) {
      const geom::Vector on = points[(*other)[1]] - points[(*other)[0]];
      const double turn = std::atan2(cross(along, on), dot(along, on));
      if (best && turn >= most_right) continue;
      best = *other;
      most_right = turn;
    }
    return best;
  }

  void add_regions() {
    std::set<std::int32_t> said;
    for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
      if (!said.insert(mesh_.regions[e]).second) continue;
      const auto nodes = mesh_.nodes_of(ElementId(e));
      const Point a = mesh_.point(nodes[0]), b = mesh_.point(nodes[1]), c = mesh_.point(nodes[2]);
      poly_.regions.push_back(
          {{(a.x + b.x + c.x) / 3.0, (a.y + b.y + c.y) / 3.0}, static_cast<double>(mesh_.regions[e]), -1.0});
    }
  }

  const ElementMesh& mesh_;
  PolyFile poly_;
  std::map<Point, std::uint32_t> number_;
  std::set<std::pair<std::uint32_t, std::uint32_t>> known_;
};

}  // namespace

PolyFile poly_of(const ElementMesh& mesh) { return Graph(mesh).run(); }

}  // namespace dobra::io::meshes
