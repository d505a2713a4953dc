#pragma once
// Faces and their meshes for the tests of this folder.

#include <gtest/gtest.h>

#include <numbers>

#include "shared/mesh/delaunay/delaunay.h"
#include "shared/surf/mesh/assemble.h"
#include "shared/surf/mesh/division.h"
#include "shared/surf/surface.h"

namespace dobra::surf::mesh::test {

constexpr double pi = std::numbers::pi;

inline Curve segment(geom::Point a, geom::Point b) { return *Curve::line({a.x, a.y, 0}, {b.x, b.y, 0}); }
inline trim::ChartEdge straight(geom::Point a, geom::Point b, std::string name = {}) {
  return {.curve = segment(a, b), .from = 0.0, .to = 1.0, .name = std::move(name)};
}
inline trim::ChartLoop polygon(const std::vector<geom::Point>& corners, const std::string& name = {}) {
  trim::ChartLoop loop;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    loop.edges.push_back(straight(corners[i], corners[(i + 1) % corners.size()], name));
  }
  return loop;
}
/// Anticlockwise from the angle 0; a hole runs backwards.
inline trim::ChartEdge circle(geom::Point centre, double radius, const std::string& name = {}) {
  return {.curve = *Curve::arc({centre.x, centre.y, 0}, {radius, 0, 0}, {0, radius, 0}, 0.0, 2.0 * pi),
          .from = 0.0,
          .to = 2.0 * pi,
          .name = name};
}
inline trim::ChartEdge backwards(trim::ChartEdge edge) {
  std::swap(edge.from, edge.to);
  return edge;
}
inline Surface flat(double width, double height) { return *Surface::plane({}, {{0, 0}, {width, height}}); }

inline Division divided(std::span<const trim::TrimmedSurface> surfaces, const DivisionOptions& options) {
  auto result = divide(surfaces, options);
  if (!result) {
    ADD_FAILURE() << base::to_string(result.error());
    return {};
  }
  return *std::move(result);
}

/// The input of one face, its border divided by halving.
inline ChartInput halved(const trim::TrimmedSurface& face, double largest, double turn) {
  DivisionOptions options;
  options.kind = DivisionKind::Halving;
  options.sizes.largest = largest;
  options.sizes.turn = turn;
  return divided({&face, 1}, options).faces[0];
}

/// The sides of a set of a chart.
inline std::size_t count_of(const ChartInput& input, const std::string& name) {
  std::size_t count = 0;
  for (const auto& edge : input.chart.edges) count += input.chart.sets[edge.set].name == name ? 1U : 0U;
  return count;
}
inline double side_in_space(const ChartInput& input, const dobra::mesh::delaunay::InputEdge& edge) {
  return geom::distance(input.at[edge.nodes[0].index()], input.at[edge.nodes[1].index()]);
}

/// Delaunay's triangles of the points in the chart: no good ones, but true ones.
inline FaceMesh delaunay_face(const ChartInput& input) {
  using namespace dobra::mesh::delaunay;
  auto chart = constrained_delaunay(input.chart, Outside::Remove);
  if (!chart) {
    ADD_FAILURE() << base::to_string(chart.error());
    return {};
  }
  FaceMesh face{std::move(chart->mesh), input.at};
  for (std::size_t i = input.at.size(); i < face.chart.points.size(); ++i) {
    face.at.push_back(input.surface.at(face.chart.points[i]));
  }
  return face;
}

/// With so many points inside each way across the chart.
inline base::Result<SurfaceMesh> meshed(std::span<const trim::TrimmedSurface> surfaces, Division& division,
                                        int inside = 0) {
  std::vector<FaceMesh> faces;
  for (ChartInput& input : division.faces) {
    ChartInput filled = input;
    const geom::Box box = geom::box_of(input.chart.points);
    for (int i = 1; i <= inside; ++i) {
      for (int j = 1; j <= inside; ++j) {
        filled.chart.points.push_back({box.low.x + box.width() * (i + 0.01 * j) / (inside + 1.2),
                                       box.low.y + box.height() * (j + 0.013 * i) / (inside + 1.2)});
      }
    }
    faces.push_back(delaunay_face(filled));
  }
  return assemble(surfaces, division, faces);
}

}  // namespace dobra::surf::mesh::test
