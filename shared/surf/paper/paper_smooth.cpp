#include "shared/surf/paper/paper_smooth.h"

#include <algorithm>
#include <cmath>

#include "shared/geom/predicates.h"
#include "shared/mesh/quality.h"

namespace dobra::surf::paper {

using dobra::mesh::NodeId;
using geom::Point;
using geom::Point3;
using geom::Vector;

namespace {

struct Shapes {
  double sum = 0.0, least = 2.0;
  bool folded = false;
};

/// Of the triangles round a node, were it at a place.
Shapes shapes_round(const mesh::FaceMesh& face, const dobra::mesh::NodeStars& stars, std::size_t node, Point uv,
                    Point3 at) {
  Shapes shapes;
  for (std::uint32_t i = stars.first[node]; i < stars.first[node + 1]; ++i) {
    const dobra::mesh::Corners& c = face.chart.corners(stars.triangles[i]);
    const auto place = [&](NodeId n) { return n.index() == node ? uv : face.chart.point(n); };
    const auto point = [&](NodeId n) { return n.index() == node ? at : face.at[n.index()]; };
    if (geom::orient2d(place(c[0]), place(c[1]), place(c[2])) != geom::Sign::Positive) shapes.folded = true;
    const double alpha = dobra::mesh::alpha_in_space(point(c[0]), point(c[1]), point(c[2]));
    shapes.sum += alpha;
    shapes.least = std::min(shapes.least, alpha);
  }
  return shapes;
}

/// Equation 18 without phi: the way to the weighted mean of the neighbours.
Vector way_of(const mesh::FaceMesh& face, const dobra::mesh::NodeStars& stars, std::size_t node, Vector scale) {
  const Point uv = face.chart.points[node];
  Vector sum;
  double weights = 0.0;
  // Each neighbour inside is a corner of two triangles of the star, so counted twice.
  for (std::uint32_t i = stars.first[node]; i < stars.first[node + 1]; ++i) {
    for (const NodeId n : face.chart.corners(stars.triangles[i])) {
      if (n.index() == node) continue;
      const Vector way = face.chart.point(n) - uv;
      const double in_chart = geom::length(Vector{scale.x * way.x, scale.y * way.y});
      const double weight = geom::distance(face.at[n.index()], face.at[node]) / in_chart;
      sum = sum + weight * way;
      weights += weight;
    }
  }
  return weights > 0.0 ? sum / weights : Vector{};
}

}  // namespace

std::size_t smooth_pass(const Surface& surface, mesh::FaceMesh& face, const std::vector<std::uint8_t>& fixed,
                        double phi, Vector scale) {
  const dobra::mesh::NodeStars stars = dobra::mesh::stars_of(face.chart);
  std::size_t moved = 0;
  for (std::size_t node = 0; node < face.at.size(); ++node) {
    if (fixed[node] != 0 || stars.first[node] == stars.first[node + 1]) continue;
    const Point here = face.chart.points[node];
    const Shapes now = shapes_round(face, stars, node, here, face.at[node]);
    Vector step = phi * way_of(face, stars, node, scale);
    constexpr int halvings = 2;
    for (int i = 0; i <= halvings; ++i, step = 0.5 * step) {
      const Point to = here + step;
      if (to == here) break;
      const Point3 at = surface.at(to);
      const Shapes then = shapes_round(face, stars, node, to, at);
      if (then.folded || then.sum < now.sum || then.least < now.least) continue;
      face.chart.points[node] = to;
      face.at[node] = at;
      ++moved;
      break;
    }
  }
  return moved;
}

}  // namespace dobra::surf::paper
