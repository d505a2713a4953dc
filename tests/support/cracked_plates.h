#pragma once
// Plates with straight cracks, meshed by the mesher with a rosette at each tip: T6, quarter points, open lips.

#include <iostream>
#include <string>
#include <vector>

#include "shared/fem/fracture/rosette.h"
#include "shared/mesh/front/triangulate.h"
#include "shared/mesh/lips.h"
#include "shared/mesh/order2.h"

namespace dobra::fem::test {

/// A straight crack; an end that is no tip lies on a corner of the outline.
struct StraightCrack {
  geom::Point start;
  geom::Point end;
  bool tip_at_start = false;
  bool tip_at_end = true;
};

struct CrackedPlate {
  std::vector<geom::Point>
      outline;  ///< Anticlockwise; side i of it is the side set "side i"; corners may lie on straight lines.
  std::vector<StraightCrack> cracks;
  double size = 0.1;  ///< Of the elements far away.
  fracture::RosetteOptions rosette = {.sectors = 16, .radius = 0.01, .rings = 3};
  double growth = 1.25;
  bool quarter = true;
};

namespace detail {

/// Distances from the rim of a rosette outwards up to `length`: steps grow from `step` to `size`.
inline std::vector<double> growing(double from, double length, double step, double size, double growth) {
  std::vector<double> distances{from};
  while (distances.back() < length) {
    step = std::min(step * growth, size);
    distances.push_back(distances.back() + step);
  }
  const double factor = (length - from) / (distances.back() - from);
  for (double& d : distances) d = from + (d - from) * factor;
  distances.back() = length;
  return distances;
}

}  // namespace detail

namespace detail {

template <class T>
T must(base::Result<T> result) {
  if (!result) std::cerr << to_string(result.error()) << '\n';
  return std::move(result).value();
}

}  // namespace detail

/// Cracks "crack 0", ...: lips "crack 0_left" and "crack 0_right", tips "crack 0_start" and "crack 0_end".
inline mesh::ElementMesh cracked_plate(const CrackedPlate& plate) {
  using geom::Point;
  using mesh::delaunay::Closure;
  using mesh::delaunay::EdgeKind;
  mesh::delaunay::MeshInput input;
  for (std::size_t i = 0; i < plate.outline.size(); ++i) {
    const Point a = plate.outline[i];
    const Point b = plate.outline[(i + 1) % plate.outline.size()];
    const int pieces = std::max(1, static_cast<int>(std::ceil(distance(a, b) / plate.size)));
    std::vector<Point> chain;
    for (int k = 0; k <= pieces; ++k) chain.push_back(geom::interpolate(a, b, static_cast<double>(k) / pieces));
    add_chain(input, chain, Closure::Open, {"side " + std::to_string(i), EdgeKind::Boundary});
  }
  struct Placed {
    fracture::Rosette rosette;
    std::string crack;
    fracture::CrackEnd end;
  };
  std::vector<Placed> rosettes;
  std::vector<std::string> names;
  for (std::size_t c = 0; c < plate.cracks.size(); ++c) {
    const auto& [start, end, tip_at_start, tip_at_end] = plate.cracks[c];
    const std::string name = names.emplace_back("crack " + std::to_string(c));
    const geom::Vector along = normalised(end - start);
    std::vector<Point> chain;
    const double length = distance(start, end);
    const double step = plate.rosette.radius;
    // From an end with a tip to the middle, or all the way to an end without.
    const auto half = [&](Point tip, geom::Vector ahead, double reach, fracture::CrackEnd which) {
      fracture::Rosette rosette = make_rosette(tip, ahead, plate.rosette).value();
      std::vector<Point> points{rosette.rings.back().front()};
      const auto distances = detail::growing(rosette.outer_radius(), reach, step, plate.size, plate.growth);
      for (std::size_t i = 1; i < distances.size(); ++i) points.push_back(tip - distances[i] * ahead);
      rosettes.push_back({std::move(rosette), name, which});
      return points;
    };
    if (tip_at_end) {
      chain = half(end, along, tip_at_start ? 0.5 * length : length, fracture::CrackEnd::End);
      if (!tip_at_start) chain.back() = start;
      std::reverse(chain.begin(), chain.end());
    }
    if (tip_at_start) {
      auto points = half(start, -along, tip_at_end ? 0.5 * length : length, fracture::CrackEnd::Start);
      if (!tip_at_end) points.back() = end;
      if (tip_at_end) chain.front() = points.back();
      points.insert(points.end(), chain.begin() + (tip_at_end ? 1 : 0), chain.end());
      chain = points;
    }
    add_chain(input, chain, Closure::Open, {name, EdgeKind::Interface});
  }
  for (const Placed& placed : rosettes) {
    const auto& ring = placed.rosette.rings.back();
    add_chain(input, {ring.begin(), ring.end() - 1}, Closure::Closed, {"ring of " + placed.crack, EdgeKind::Boundary});
  }
  mesh::front::MeshOptions options;
  options.sizes.growth = plate.growth;
  mesh::ElementMesh mesh = element_mesh_of(detail::must(triangulate(input, options)));
  for (const Placed& placed : rosettes) {
    mesh.side_sets.erase("ring of " + placed.crack);
    DOBRA_CHECK(fill_rosette(mesh, placed.rosette, placed.crack, placed.end, 0).ok());
  }
  mesh = mesh::to_second_order(detail::must(open_lips(std::move(mesh), names))).mesh;
  if (plate.quarter) DOBRA_CHECK(fracture::set_quarter_points(mesh).ok());
  return mesh;
}

}  // namespace dobra::fem::test
