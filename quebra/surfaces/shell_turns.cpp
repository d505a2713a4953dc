#include "quebra/surfaces/shell_turns.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "shared/fem/element.h"

namespace quebra::surfaces {

using namespace dobra;
using geom::Vector3;
using surf::mesh::SurfaceElements;

namespace {

/// The normal of an element at one of its nodes.
Vector3 normal_at(const SurfaceElements& elements, mesh::ElementId element, std::size_t at) {
  const auto nodes = elements.mesh.nodes_of(element);
  const auto type = elements.mesh.types[element.index()];
  const std::array<double, 2> place = fem::reference_node(type, at);
  const fem::Shape shape = fem::shape_at(type, place[0], place[1]);
  Vector3 xi{}, eta{};
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Vector3 p = elements.point(nodes[i]) - geom::Point3{};
    xi = xi + shape.d_xi[i] * p;
    eta = eta + shape.d_eta[i] * p;
  }
  return geom::normalised(cross(xi, eta));
}

/// The mean normal of each node that is asked for; nothing at a kink.
using Normals = std::map<std::size_t, std::optional<Vector3>>;
Normals normals_of(const SurfaceElements& elements, const std::map<std::size_t, std::array<bool, 3>>& asked,
                   double kink) {
  std::map<std::size_t, std::vector<Vector3>> all;
  for (std::size_t e = 0; e < elements.mesh.element_count(); ++e) {
    const auto nodes = elements.mesh.nodes_of(mesh::ElementId(e));
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (asked.contains(nodes[i].index())) all[nodes[i].index()].push_back(normal_at(elements, mesh::ElementId(e), i));
    }
  }
  Normals normals;
  for (const auto& [node, own] : all) {
    Vector3 sum{};
    for (const Vector3& normal : own) sum = sum + normal;
    const Vector3 mean = geom::normalised(sum);
    const bool smooth = std::all_of(own.begin(), own.end(), [&](const Vector3& normal) {
      return dot(normal, mean) > 0.0 && length(cross(normal, mean)) <= kink;
    });
    normals[node] = smooth ? std::optional(mean) : std::nullopt;
  }
  return normals;
}

/// Of the axes held, the one to leave out; 3 for none.
std::size_t left_out(const std::array<bool, 3>& held, const std::array<double, 3>& along, double flat) {
  const auto count = std::count(held.begin(), held.end(), true);
  std::size_t nearest = 3;
  double plane = 0.0;  // of the normal, out of the plane of the axes held
  for (std::size_t i = 0; i < 3; ++i) {
    if (!held[i]) {
      plane = std::max(plane, along[i]);
    } else if (nearest == 3 || along[i] > along[nearest]) {
      nearest = i;
    }
  }
  if (count == 3) return nearest;
  if (count == 2) return plane <= flat ? nearest : 3;
  return count == 1 && along[nearest] >= std::sqrt(1.0 - flat * flat) ? nearest : 3;
}

}  // namespace

std::map<std::size_t, std::array<bool, 3>> turns_to_hold(const SurfaceElements& elements, const Shell& shell,
                                                         const TurnOptions& options) {
  std::map<std::size_t, std::array<bool, 3>> turns;
  for (const auto& [node, values] : shell.held) {
    const std::array<bool, 3> held{values[3].has_value(), values[4].has_value(), values[5].has_value()};
    if (held[0] || held[1] || held[2]) turns[node] = held;
  }
  const Normals normals = normals_of(elements, turns, options.kink);
  for (auto& [node, held] : turns) {
    const auto& values = shell.held.at(node);
    const bool zero =
        std::all_of(values.begin() + 3, values.end(), [](const auto& v) { return v.value_or(0.0) == 0.0; });
    const auto normal = normals.find(node);
    if (!zero || normal == normals.end() || !normal->second) continue;
    const Vector3 n = *normal->second;
    // A normal in the plane of two axes leaves one rotation of the two; the first to go is the one about the normal.
    const std::array<double, 3> along{std::abs(n.x), std::abs(n.y), std::abs(n.z)};
    const std::size_t out = left_out(held, along, options.flat);
    if (out < 3) held[out] = false;
  }
  return turns;
}

}  // namespace quebra::surfaces
