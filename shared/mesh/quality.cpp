#include "shared/mesh/quality.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dobra::mesh {

using base::Angle;
using geom::Point;

double alpha(Point a, Point b, Point c) {
  const geom::Vector ab = b - a;
  const geom::Vector ac = c - a;
  const double sides = geom::length_squared(ab) + geom::length_squared(ac) + geom::length_squared(c - b);
  return sides == 0.0 ? 0.0 : 2.0 * std::numbers::sqrt3 * geom::cross(ab, ac) / sides;
}

double alpha_in_space(geom::Point3 a, geom::Point3 b, geom::Point3 c) {
  const geom::Vector3 ab = b - a, ac = c - a, bc = c - b;
  const double sides = dot(ab, ab) + dot(ac, ac) + dot(bc, bc);
  return sides == 0.0 ? 0.0 : 2.0 * std::numbers::sqrt3 * geom::length(cross(ab, ac)) / sides;
}

std::array<double, 3> angles_in_space(geom::Point3 a, geom::Point3 b, geom::Point3 c) {
  const std::array<geom::Point3, 3> corner{a, b, c};
  std::array<double, 3> angles{};
  for (std::size_t i = 0; i < 3; ++i) {
    const geom::Vector3 u = corner[(i + 1) % 3] - corner[i], v = corner[(i + 2) % 3] - corner[i];
    angles[i] = std::atan2(geom::length(cross(u, v)), dot(u, v));
  }
  return angles;
}

AngleRange angles_of(Point a, Point b, Point c) {
  const std::array<Point, 3> corner{a, b, c};
  double least = std::numbers::pi;
  double greatest = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const geom::Vector u = corner[(i + 1) % 3] - corner[i];
    const geom::Vector v = corner[(i + 2) % 3] - corner[i];
    const double angle = std::atan2(std::abs(geom::cross(u, v)), geom::dot(u, v));
    least = std::min(least, angle);
    greatest = std::max(greatest, angle);
  }
  return {Angle::from_radians(least), Angle::from_radians(greatest)};
}

namespace {

void add_gradation(const TriangleMesh& mesh, MeshQuality& quality) {
  const auto neighbours = neighbours_of(mesh);
  std::vector<double> ratios;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const TriangleId other : neighbours[t]) {
      if (!other.valid() || other.index() < t) continue;
      const double mine = std::abs(area(mesh, TriangleId(t)));
      const double theirs = std::abs(area(mesh, other));
      ratios.push_back(std::max(mine, theirs) / std::min(mine, theirs));
    }
  }
  if (ratios.empty()) return;
  const auto rank = static_cast<std::ptrdiff_t>(std::ceil(0.95 * static_cast<double>(ratios.size()))) - 1;
  std::nth_element(ratios.begin(), ratios.begin() + rank, ratios.end());
  quality.gradation_p95 = ratios[static_cast<std::size_t>(rank)];
  quality.gradation_max = *std::max_element(ratios.begin(), ratios.end());
}

}  // namespace

MeshQuality quality_of(const TriangleMesh& mesh) {
  MeshQuality quality;
  quality.nodes = mesh.points.size();
  quality.triangles = mesh.triangles.size();
  if (mesh.triangles.empty()) return quality;
  quality.area = area(mesh);
  quality.alpha_min = 2.0;
  quality.angle_min = Angle::from_radians(std::numbers::pi);
  std::size_t good = 0;
  double sum = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Corners& corner = mesh.triangles[t];
    const Point a = mesh.point(corner[0]);
    const Point b = mesh.point(corner[1]);
    const Point c = mesh.point(corner[2]);
    const double value = alpha(a, b, c);
    const AngleRange angles = angles_of(a, b, c);
    sum += value;
    good += value >= 0.90 ? 1U : 0U;
    if (value < quality.alpha_min) {
      quality.alpha_min = value;
      quality.worst = TriangleId(t);
    }
    quality.angle_min = std::min(quality.angle_min, angles.least);
    quality.angle_max = std::max(quality.angle_max, angles.greatest);
    const auto bin = static_cast<std::size_t>(std::clamp(value * 20.0, 0.0, 19.0));
    ++quality.histogram[bin];
  }
  const auto count = static_cast<double>(mesh.triangles.size());
  quality.alpha_mean = sum / count;
  quality.alpha_90 = static_cast<double>(good) / count;
  add_gradation(mesh, quality);
  return quality;
}

}  // namespace dobra::mesh
