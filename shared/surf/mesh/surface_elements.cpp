#include "shared/surf/mesh/surface_elements.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "shared/mesh/element_quality.h"
#include "shared/mesh/order2.h"
#include "shared/surf/closest.h"

namespace dobra::surf::mesh {

using base::Error;
using base::ErrorCode;
using base::Result;
using dobra::mesh::ElementId;
using dobra::mesh::ElementMesh;
using dobra::mesh::ElementSide;
using dobra::mesh::ElementType;
using geom::Point;
using geom::Point3;
using geom::Vector3;

SurfaceElements elements_of(const SurfaceMesh& mesh) {
  dobra::mesh::TriangleMesh view;
  SurfaceElements result;
  for (const Point3 p : mesh.points) {
    view.points.push_back({p.x, p.y});
    result.heights.push_back(p.z);
  }
  view.triangles = mesh.triangles;
  view.regions = mesh.regions;
  view.boundary_sets = mesh.boundary_sets;
  view.constraint_sets = mesh.constraint_sets;
  view.node_sets = mesh.node_sets;
  result.mesh = dobra::mesh::element_mesh_of(view);
  result.mesh.region_names = mesh.region_names;
  for (const auto& places : mesh.places) result.places.insert(result.places.end(), places.begin(), places.end());
  result.faces = mesh.faces;
  return result;
}

namespace {

/// A place near `near` that is on both surfaces, from one that is on the first: feet by turns.
Point3 on_both(const Surface& first, Point first_near, const Surface& second, Point second_near, Point3 at) {
  constexpr int most = 20;
  const double enough = 1e-13 * std::max(first.size(), second.size());
  for (int turn = 0; turn < most; ++turn) {
    const Foot there = closest(second, at, second_near);
    const Foot back = closest(first, there.at, first_near);
    const bool still = geom::distance(back.at, at) <= enough;
    at = back.at;
    first_near = back.uv;
    second_near = there.uv;
    if (still) break;
  }
  return at;
}

}  // namespace

SurfaceElements to_second_order(const SurfaceElements& linear, std::span<const trim::TrimmedSurface> surfaces,
                                const Middles& middles) {
  SurfaceElements result;
  result.mesh = dobra::mesh::to_second_order(linear.mesh).mesh;
  result.faces = linear.faces;
  result.heights = linear.heights;
  result.heights.resize(result.mesh.points.size());
  struct Placed {
    std::uint32_t face;
    Point near;
    bool given;
  };
  std::vector<std::optional<Placed>> placed(result.mesh.points.size());
  const auto put = [&](NodeId node, Point3 at) {
    result.mesh.points[node.index()] = {at.x, at.y};
    result.heights[node.index()] = at.z;
  };
  for (std::size_t e = 0; e < linear.mesh.element_count(); ++e) {
    const std::size_t corners = dobra::mesh::corner_count(linear.mesh.types[e]);
    const auto nodes = result.mesh.nodes_of(ElementId(e));
    const Surface& surface = surfaces[linear.faces[e]].surface;
    const Point* const place = linear.places.data() + linear.mesh.first[e];
    for (std::size_t i = 0; i < corners; ++i) {
      const NodeId middle = nodes[corners + i];
      const Point near = geom::midpoint(place[i], place[(i + 1) % corners]);
      const Point3 p = linear.point(nodes[i]), q = linear.point(nodes[(i + 1) % corners]);
      auto& done = placed[middle.index()];
      if (!done) {
        const auto given = middles.find(SideEnds(p, q));
        done = Placed{linear.faces[e], near, given != middles.end()};
        put(middle, done->given ? given->second : closest(surface, p + 0.5 * (q - p), near).at);
      } else if (!done->given && done->face != linear.faces[e]) {
        put(middle, on_both(surfaces[done->face].surface, done->near, surface, near, result.point(middle)));
      }
    }
  }
  for (std::size_t e = 0; e < linear.mesh.element_count(); ++e) {
    const std::size_t corners = dobra::mesh::corner_count(linear.mesh.types[e]);
    const auto nodes = result.mesh.nodes_of(ElementId(e));
    const Point* const place = linear.places.data() + linear.mesh.first[e];
    result.places.insert(result.places.end(), place, place + corners);
    for (std::size_t i = 0; i < corners; ++i) {
      const Point near = geom::midpoint(place[i], place[(i + 1) % corners]);
      result.places.push_back(closest(surfaces[linear.faces[e]].surface, result.point(nodes[corners + i]), near).uv);
    }
  }
  return result;
}

namespace {

/// The quality of a quadrilateral at a right angle to its mean plane, less what it is twisted.
double quality_in_space(const std::array<Point3, 4>& p) {
  const Vector3 normal = cross(p[2] - p[0], p[3] - p[1]);
  const double size = geom::length(normal);
  if (!(size > 0.0)) return 0.0;
  const Vector3 z = normal / size;
  const Vector3 along = p[1] - p[0] - dot(p[1] - p[0], z) * z;
  if (!(geom::length(along) > 0.0)) return 0.0;
  const Vector3 x = geom::normalised(along);
  const Vector3 y = cross(z, x);
  std::array<Point, 4> flat;
  for (std::size_t i = 0; i < 4; ++i) flat[i] = {dot(p[i] - p[0], x), dot(p[i] - p[0], y)};
  return dobra::mesh::quad_quality(flat[0], flat[1], flat[2], flat[3]);
}

}  // namespace

SurfaceElements recombine(const SurfaceElements& elements, const dobra::mesh::RecombineOptions& options) {
  const auto place_of = [&](ElementId e, NodeId node) {
    const auto nodes = elements.mesh.nodes_of(e);
    const auto at = std::find(nodes.begin(), nodes.end(), node);
    return at == nodes.end()
               ? std::optional<Point>{}
               : elements.places[elements.mesh.first[e.index()] + static_cast<std::size_t>(at - nodes.begin())];
  };
  // Corners 0 and 2 are of both triangles: across a seam their places differ.
  const auto quality = [&](ElementId first, ElementId second, const std::array<NodeId, 4>& c) -> std::optional<double> {
    if (elements.faces[first.index()] != elements.faces[second.index()]) return std::nullopt;
    for (const std::size_t i : {std::size_t{0}, std::size_t{2}}) {
      if (place_of(first, c[i]) != place_of(second, c[i])) return std::nullopt;
    }
    return quality_in_space({elements.point(c[0]), elements.point(c[1]), elements.point(c[2]), elements.point(c[3])});
  };
  auto made = dobra::mesh::recombine(elements.mesh, options, quality);
  SurfaceElements result;
  result.mesh = std::move(made.mesh);
  result.heights = elements.heights;
  for (std::size_t e = 0; e < made.made_of.size(); ++e) {
    const auto [first, second] = made.made_of[e];
    result.faces.push_back(elements.faces[first.index()]);
    for (const NodeId node : result.mesh.nodes_of(ElementId(e))) {
      const auto place = place_of(first, node);
      result.places.push_back(place ? *place : place_of(second, node).value_or(Point{}));
    }
  }
  return result;
}

ElementMesh flattened(const SurfaceElements& elements, ElementId element) {
  const auto nodes = elements.mesh.nodes_of(element);
  const ElementType type = elements.mesh.types[element.index()];
  const std::size_t corners = dobra::mesh::corner_count(type);
  const auto p = [&](std::size_t i) { return elements.point(nodes[i]); };
  const Vector3 normal = corners == 3 ? cross(p(1) - p(0), p(2) - p(0)) : cross(p(2) - p(0), p(3) - p(1));
  const double size = geom::length(normal);
  const Vector3 z = size > 0.0 ? normal / size : Vector3{0, 0, 1};
  Vector3 x = p(1) - p(0) - dot(p(1) - p(0), z) * z;
  const double width = geom::length(x);
  x = width > 0.0 ? x / width : Vector3{1, 0, 0};
  const Vector3 y = cross(z, x);
  ElementMesh flat;
  flat.first.push_back(0);
  std::vector<NodeId> own;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    flat.points.push_back({dot(p(i) - p(0), x), dot(p(i) - p(0), y)});
    own.emplace_back(i);
  }
  dobra::mesh::add_element(flat, type, own, 0);
  return flat;
}

namespace {

Error broken(const SurfaceElements& elements, std::string message, std::size_t element) {
  const Point3 at = elements.point(elements.mesh.nodes_of(ElementId(element))[0]);
  const Point place = elements.places[elements.mesh.first[element]];
  return {ErrorCode::CannotMesh, std::move(message),
          base::Place{
              .item = fmt::format("element {}", element), .x = at.x, .y = at.y, .z = at.z, .u = place.x, .v = place.y}};
}

Result<void> check_arrays(const SurfaceElements& elements) {
  const ElementMesh& mesh = elements.mesh;
  const std::size_t count = mesh.element_count();
  if (mesh.first.size() != count + 1 || mesh.first.back() != mesh.nodes.size() || mesh.regions.size() != count ||
      elements.faces.size() != count || elements.places.size() != mesh.nodes.size() ||
      elements.heights.size() != mesh.points.size()) {
    return Error{ErrorCode::CannotMesh, "the arrays of the mesh do not fit together"};
  }
  for (const NodeId node : mesh.nodes) {
    if (!node.valid() || node.index() >= mesh.points.size()) {
      return Error{ErrorCode::CannotMesh, "an element refers to a node that does not exist"};
    }
    if (!geom::is_finite(elements.point(node))) {
      return Error{ErrorCode::NotFinite, fmt::format("node {} has a coordinate that is not finite", node.index())};
    }
  }
  return {};
}

}  // namespace

Result<void> check(const SurfaceElements& elements) {
  DOBRA_TRY_VOID(check_arrays(elements));
  struct Ends {
    Edge edge;
    std::size_t element;
  };
  std::vector<Ends> sides;
  for (std::size_t e = 0; e < elements.mesh.element_count(); ++e) {
    const ElementMesh flat = flattened(elements, ElementId(e));
    if (!dobra::mesh::check(flat).ok() || !(dobra::mesh::scaled_jacobian_bound(flat, ElementId(0)) > 0.0)) {
      return broken(elements, "the element is flat, re-entrant or folded", e);
    }
    for (std::uint32_t i = 0; i < dobra::mesh::corner_count(elements.mesh.types[e]); ++i) {
      const auto nodes = dobra::mesh::side_nodes(elements.mesh, {ElementId(e), i});
      sides.push_back({{nodes[0], nodes[1]}, e});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Ends& a, const Ends& b) {
    return std::pair{a.edge, a.element} < std::pair{b.edge, b.element};
  });
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    if (sides[i].edge != sides[i + 1].edge) continue;
    // Where three faces meet, two of them follow it in one way.
    const Edge back{sides[i].edge[1], sides[i].edge[0]};
    const bool third = (i + 2 < sides.size() && sides[i + 2].edge == sides[i].edge) ||
                       std::binary_search(sides.begin(), sides.end(), Ends{back, 0},
                                          [](const Ends& a, const Ends& b) { return a.edge < b.edge; });
    if (third && elements.faces[sides[i].element] != elements.faces[sides[i + 1].element]) continue;
    return broken(elements, "two elements lie on the same side of one edge", sides[i + 1].element);
  }
  return {};
}

}  // namespace dobra::surf::mesh
